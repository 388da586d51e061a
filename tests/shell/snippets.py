"""Runs the commands that the manual prints, page by page, in a copy of the tree.

Every block of shell commands says before it what a test does with it:
  <!-- run -->, <!-- run with: OPTIONS -->     as printed, or each script and case with these options besides (coarse meshes)
  <!-- run by make test-manual -->, <!-- run by make test-manual with: OPTIONS -->     the same, where it takes long
  <!-- not run: why -->
Options of a command of make go into its OPTIONS=. README.md has its marks in README, by the first line of a block.

snippets.py quick|all   quick: without those of make test-manual; PAGE... after it: these pages only. Prints each command with its
seconds; exit status 1 if one fails or a block has no mark
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
README = {"make run ": "not run: every test begins with it, and cases run below"}
LINKED = ("obj", "read", "tests")    # large, and not written where nothing is compiled
BLOCK = re.compile(r"(?:^<!-- ((?:not )?run.*?) -->\n)?^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
MARK = re.compile(r"(?P<no>not run: \S.*)|run(?P<long> by make test-manual)?(?: with: (?P<options>\S.*))?")


def pages():
    return [TOP / "README.md", TOP / "cases/README.md", *sorted((TOP / "edp/manual").glob("*.md"))]


def tree(folder):
    """A copy with the times of the files, so that nothing is compiled again, and its own products and results."""
    shutil.copytree(TOP, folder, ignore=lambda path, names: {"build", "out", ".git"} if Path(path) == TOP else set())
    (folder / "build").mkdir()
    for path in Path(os.environ["BUILD"]).iterdir():
        if path.name in LINKED:
            (folder / "build" / path.name).symlink_to(path)
        elif path.name not in ("results", "lock", "clean"):
            (shutil.copytree if path.is_dir() else shutil.copy2)(path, folder / "build" / path.name)


def with_options(words, options):
    """The command with options besides; those that ask for help or make a scene have none."""
    if words[0] == "make":
        given = [k for k, word in enumerate(words) if word.startswith("OPTIONS=")]
        if given:
            words[given[0]] += " " + options
        else:
            words.append("OPTIONS=" + options)
    elif "sweep" in words[1:2] or len(words) > 1 and words[1].endswith(".edp") and "-h" not in words:
        words += shlex.split(options)
    return words


def commands(text, options):
    for line in text.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if words:
            yield with_options(words, options) if options else words


def run(words, folder):
    """What is wrong with a command, or ""."""
    start = time.time()
    done = subprocess.run(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", env={**os.environ, "PACKAGES": "true", "BUILD": "build"})
    print(f"{time.time() - start:6.1f} s  {shlex.join(words)}", flush=True)
    return f"exit status {done.returncode}: {shlex.join(words)}\n{done.stdout[-800:]}" if done.returncode else ""


def check(page, which, folder):
    """Errors of the commands of a page."""
    for mark, text in BLOCK.findall(page.read_text()):
        first = text.splitlines()[0]
        if not mark and page == TOP / "README.md":
            mark = next((said for start, said in README.items() if first.startswith(start)), "")
        fits = MARK.fullmatch(mark)
        if not fits:
            yield f"no test is named for the block: {first}"
        elif not fits["no"] and (which == "all" or not fits["long"]):
            yield from filter(None, (run(words, folder) for words in commands(text, fits["options"])))


def main(which, chosen):
    folder = Path(os.environ["SCRATCH"]) / "tree"
    for name in ("BURNISH", "BURNISH_TOP", "FF_LOADPATH", "FF_INCLUDEPATH", "MAKEFLAGS", "MAKELEVEL"):
        os.environ.pop(name, None)
    tree(folder)
    wrong = [f"{page.name}: {text}" for page in chosen or pages() for text in check(page, which, folder)]
    print(*wrong, f"{len(wrong)} wrong", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], [Path(name) for name in sys.argv[2:]]))
