"""Pictures of the manual, by the scripts that its pages show: runs.py FOLDER, from make docs.

A page says what it wants by a comment, which nothing but the site shows:
    <!-- picture of edp/manual/examples/block.edp -steps 20: final.png; What is seen. -->
Each run is carried out once, in a folder of its own; on the site the comment becomes the picture, what is seen, the seconds of the processor, the
results on the screen and the script to be downloaded. A script that ends with rcRun or rcRunLaw writes no files: a copy with rcCase or
rcCaseLaw in that place does, in mm and MPa. press.edp is what burnish new makes. A run that is younger than its script and
the plugin is not repeated. A page that runs a script and shows no picture is an error.
"""
import json
import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
BURNISH = os.environ.get("BURNISH", str(TOP / "build/burnish"))
MARK = re.compile(r"^<!-- picture of (\S+\.edp)((?: [^:\n]*)?): (\S+\.png); (.*?) -->$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\[([^\]]*)\]\([^)]*\)")
RUNS = re.compile(r"^build/burnish (?:-np \d+ )?\S+\.edp|^<!-- from \S+\.edp -->", re.MULTILINE)
AS_CASE = (("rcRun(C, M, u[], S, program, record)", "rcCase(C, M, u[], S, program, record)"),
           ("rcRunLaw(C, M, u[], S, program, record, law)", "rcCaseLaw(C, M, u[], S, program, record, law)"))
ENDED = (0, 4)


def folder_of(out, script, options):
    return Path(out) / re.sub(r"[^\w.=-]+", "_", Path(script).stem + options)


def copied(script, folder, draw):
    """The script itself, or a copy in folder that keeps files and draws as -pictures says: (path, whether it is a copy)."""
    if script == "press/press.edp":
        subprocess.run([BURNISH, "new", "press"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        return folder / script, False
    text = whole = (TOP / script).read_text()
    for run, case in AS_CASE:
        text = text.replace(run, case)
    if text == whole:
        return TOP / script, False
    for beside in (TOP / script).parent.iterdir():       # drawings that it reads
        if beside.suffix in (".geo", ".step"):
            (folder / beside.name).symlink_to(beside)
    (folder / Path(script).name).write_text(text + f"rcUnits(\"mm\", \"MPa\");\nrcDraw = {draw};\nrcCaseEnd(C, M, S);\n")
    return folder / Path(script).name, True


def results(screen):
    """What a run says of itself, up to what it was computed with."""
    lines = []
    for line in screen.splitlines():
        if line.startswith(("burnish: ", ": finished")) or re.match(r"  P[12], \d+ nodes", line):
            break
        lines.append(line.rstrip())
    return "\n".join(lines[-6:]).strip("\n")


def processor():
    """Seconds of the processor of all programs that have ended."""
    spent = os.times()
    return spent.children_user + spent.children_system


def run(out, script, options, pictures):
    """Carries out one run; what is wrong, or ""."""
    folder = folder_of(out, script, options)
    done, sources = folder / "run.json", [TOP / script, TOP / "build/plugins/burnish.so", Path(__file__), *(TOP / "cases/plotting").glob("*.py")]
    newest = max(path.stat().st_mtime for path in sources if path.exists())
    if done.is_file() and done.stat().st_mtime > newest and all((folder / name).exists() for name in pictures):
        return ""
    subprocess.run(["rm", "-rf", str(folder)], check=True)
    folder.mkdir(parents=True)
    draw = 1 if pictures == {"final.png"} else 2
    path, copy = copied(script, folder, draw)
    words = [BURNISH, str(path), *options.split()]
    if not copy:
        words += ["-out", str(folder / "out"), "-pictures", str(draw)]
    start = time.time()
    # a process of its own, whose children are those of this run alone
    said = subprocess.run([sys.executable, __file__, "--alone", *words], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    screen, _, spent = said.stdout.rpartition("\n")
    (folder / "screen.txt").write_text(screen)
    for name in pictures:
        if (folder / "out" / name).is_file():
            os.link(folder / "out" / name, folder / name)
    print(f"{time.time() - start:6.1f} s  {script}{options}", flush=True)
    missing = [name for name in pictures if not (folder / name).exists()]
    if said.returncode not in ENDED or missing:
        return f"{script}{options}: exit status {said.returncode}, missing {missing}: {screen[-600:]}"
    done.write_text(json.dumps({"seconds": float(spent), "results": results(screen)}))
    return ""


def alone(words):
    """Prints what a program says and then, in a line, the processor's seconds; its exit status."""
    said = subprocess.run(words, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(said.stdout.rstrip(), f"{processor():.1f}", sep="\n", end="")
    return said.returncode


def shown(text, out):
    """A page's text with its comments as figures."""
    def figure(mark):
        script, options, picture, words = mark.groups()
        folder = folder_of(out, script, options)
        run = json.loads((folder / "run.json").read_text())
        source = f"/{(folder / script).relative_to(TOP)}" if script == "press/press.edp" else f"/{script}"
        image = f"/{(folder / picture).relative_to(TOP)}"
        said = f"\n```text\n{run['results']}\n```\n" if run["results"] else ""
        spoken = LINK.sub(r"\1", words)
        return (f"```{{figure}} {image}\n:alt: {json.dumps(spoken)}\n\n{words} {run['seconds']:.1f} s of the processor: "
                f"{{download}}`{Path(script).name} <{source}>`{options}\n```\n{said}")
    return MARK.sub(figure, text)


def main(out):
    wanted, wrong = {}, []
    for page in sorted((TOP / "edp/manual").glob("*.md")):
        text = page.read_text()
        if RUNS.search(text) and not MARK.search(text) and "![" not in text:
            wrong.append(f"{page.name}: it runs a script and shows no picture")
        for script, options, picture, _ in MARK.findall(text):
            wanted.setdefault((script, options), set()).add(picture)
    out = TOP / out
    with ThreadPoolExecutor(int(os.environ.get("JOBS", 2))) as pool:
        wrong += [text for text in pool.map(lambda one: run(out, *one[0], one[1]), wanted.items()) if text]
    print(f"{len(wanted)} runs for the manual, {len(wrong)} wrong", *wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(alone(sys.argv[2:]) if sys.argv[1] == "--alone" else main(sys.argv[1]))
