"""Makes the pictures of the cases' READMEs again: make figures CASE=all OPTIONS="bending|cam"

figures.csv says for each picture which run it is from. Every run is made once, in out/figures, two at a time unless JOBS says
otherwise; its picture takes the place of the one in the tree. Pictures of cost (cost.png) are those of the sweeps in the READMEs, of
tests/chart and tests/stability those of make chart and make stability. Exit status 1 if a run or a picture is missing.
"""
import concurrent.futures
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[1]
OUT = TOP / "out/figures"
ENDED = {0, 4}


def rows(pattern):
    """(picture of the tree, words of the run, picture of the run) whose first one fits the pattern."""
    for line in (TOP / "cases/figures.csv").read_text().splitlines():
        if line and not line.startswith("#"):
            picture, words, name = (part.strip() for part in line.split(";"))
            if re.search(pattern, picture):
                yield picture, tuple(shlex.split(words)), name


def folder(words):
    return OUT / re.sub(r"[^\w.=-]+", "_", "_".join(words))


def made(words):
    """Makes a run and those that it names as -beside; returns what is wrong, or ""."""
    beside = words[words.index("-beside") + 1].split(",") if "-beside" in words else []
    for path in beside:       # out/figures/CASE-WORD: the run with -backstress WORD
        run((words[0], "-backstress", Path(path).name.split("-")[-1]), TOP / path)
    return run(words, folder(words))


def run(words, out):
    out.mkdir(parents=True, exist_ok=True)
    command = [os.environ.get("BURNISH", str(TOP / "build/burnish")), f"cases/{words[0]}/{words[0]}.edp", *words[1:], "-out", str(out)]
    with open(out / "log.txt", "w") as log:
        status = subprocess.run(command, cwd=TOP, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL).returncode
    print(" ".join(words), "" if status == 0 else f"exit status {status}", flush=True)
    return "" if status in ENDED else f"{' '.join(words)}: exit status {status}, {out}/log.txt"


def main():
    chosen = list(rows(sys.argv[1] if len(sys.argv) > 1 else ""))
    if not chosen:
        return "figures.py: no picture of figures.csv fits"
    runs = list(dict.fromkeys(words for _, words, _ in chosen))
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", 2))) as pool:
        wrong = [text for text in pool.map(made, runs) if text]
    for picture, words, name in chosen:
        source = folder(words) / name
        if source.is_file():
            shutil.copyfile(source, TOP / "cases" / picture)
        else:
            wrong.append(f"{picture}: {source} was not drawn")
    print(f"{len(runs)} runs, {len(chosen)} pictures", *wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
