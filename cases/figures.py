"""Makes the pictures of the cases' READMEs again: make figures CASE=all OPTIONS="bending|cam"

figures.csv says for each picture which run, sweep or lab it is from. Every one is made once, in out/figures, two at a time unless JOBS
says otherwise; its picture takes the place of the one in the tree. Pictures of cost (cost.png) are of sweeps, whose times count: they
are made one after the other, after all others (OPTIONS=cost.png on a quiet machine). Those of tests/chart and tests/stability are those
of make chart and make stability. Exit status 1 if a run or a picture is missing.
"""
import concurrent.futures
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]
OUT = TOP / "out/figures"
BURNISH = os.environ.get("BURNISH", str(TOP / "build/burnish"))
ENDED = {0, 4}
PAGE = (1500, 3290)   # pixels of a page of a sweep that are seen, drawn at two thirds


def rows(pattern):
    """(picture of the tree, words of the run, picture of the run) whose first one fits the pattern."""
    for line in (TOP / "cases/figures.csv").read_text().splitlines():
        if line and not line.startswith("#"):
            picture, _, rest = line.partition(";")
            words, _, name = rest.rpartition(";")
            picture, name = picture.strip(), name.strip()
            if re.search(pattern, picture):
                yield picture, tuple(shlex.split(words)), name


def folder(words):
    if words[0] == "sweep":
        return TOP / "out/sweep" / dict(word.split("=", 1) for word in words[1:])["CASE"]
    return OUT / re.sub(r"[^\w.=-]+", "_", "_".join(words))


def made(words):
    """Makes a run and those that it names as -beside; returns what is wrong, or ""."""
    if words[0] in OTHER:
        return OTHER[words[0]](words)
    beside = words[words.index("-beside") + 1].split(",") if "-beside" in words else []
    for path in beside:       # out/figures/CASE-WORD: the run with -backstress WORD
        run((words[0], "-backstress", Path(path).name.split("-")[-1]), TOP / path)
    return run(words, folder(words))


def sweep(words):
    """sweep CASE=hertz "VARY=..." ...: as make sweep, one variant after the other."""
    given = {"OPTIONS": "", **dict(word.split("=", 1) for word in words[1:])}
    shutil.rmtree(folder(words), ignore_errors=True)
    case = given["CASE"]
    command = [BURNISH, "sweep", f"cases/{case}/{case}.edp", *shlex.split(given["VARY"]), "-study", case, "-jobs", "1", *shlex.split(given["OPTIONS"])]
    wrong = called(command, words, OUT / f"sweep-{case}", {})
    if not wrong and shutil.which("chromium"):
        look_at(folder(words) / "index.html")
    return wrong


def look_at(page):
    """page.png beside it, as Chromium shows the page."""
    from PIL import Image
    picture = page.with_name("page.png")
    with tempfile.TemporaryDirectory() as profile:
        subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--user-data-dir={profile}",
                        "--virtual-time-budget=15000", f"--window-size={PAGE[0]},{PAGE[1]}", f"--screenshot={picture}", page.resolve().as_uri()],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    image = Image.open(picture).convert("RGB").resize((2 * PAGE[0] // 3, 2 * PAGE[1] // 3), Image.Resampling.LANCZOS)
    image.quantize(256, dither=Image.Dither.NONE).save(picture)


def lab(words):
    """lab NAME: its solutions as make test-labs runs them, with its plot; what it says of answers is its test's."""
    called([sys.executable, "tests/labs/lab.py", words[1]], words, folder(words), {"SCRATCH": str(folder(words)), "PYTHON": sys.executable})
    return ""


def called(command, words, out, environment):
    out.mkdir(parents=True, exist_ok=True)
    with open(out / "log.txt", "w") as log:
        status = subprocess.run(command, cwd=TOP, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                env={**os.environ, "BURNISH": BURNISH, **environment}).returncode
    print(" ".join(words), "" if status == 0 else f"exit status {status}", flush=True)
    return "" if status in ENDED else f"{' '.join(words)}: exit status {status}, {out}/log.txt"


OTHER = {"sweep": sweep, "lab": lab}


def run(words, out):
    return called([BURNISH, f"cases/{words[0]}/{words[0]}.edp", *words[1:], "-pictures", "2", "-out", str(out)], words, out, {})


def main():
    chosen = list(rows(sys.argv[1] if len(sys.argv) > 1 else ""))
    if not chosen:
        return "figures.py: no picture of figures.csv fits"
    runs, bad = list(dict.fromkeys(words for _, words, _ in chosen)), {}
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", 2))) as pool:
        some = [words for words in runs if words[0] != "sweep"]
        bad.update(zip(some, pool.map(made, some)))
    for words in runs:
        if words[0] == "sweep":
            bad[words] = made(words)
    wrong = [text for text in bad.values() if text]
    for picture, words, name in chosen:
        source = folder(words) / name
        if not bad[words] and (name == "gallery.png" or words[0] == "lab" and source.stem in ("scene", "final", "work")):    # runs of labs draw only some
            subprocess.run([sys.executable, "cases/plotting/scene.py", str(source.parent), source.stem], cwd=TOP, stdout=subprocess.DEVNULL)
        if bad[words]:
            wrong.append(f"{picture}: left as it is, its run failed")
        elif source.is_file():
            shutil.copyfile(source, TOP / "cases" / picture)
        else:
            wrong.append(f"{picture}: {source} was not drawn")
    print(f"{len(runs)} runs, {len(chosen)} pictures", *wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
