"""Pictures of the pages: every one that a page shows is there and is made by a command: by make figures (cases/figures.csv), or by
the target of its folder; every line of figures.csv is shown, and a sweep's is the command that its page prints.

figures.py [FOLDER]: the pages of FOLDER, all of the tree unless given; prints what is wrong, exit status 1
"""
import os
import re
import shlex
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cases"))
from figures import rows  # noqa: E402

TARGETS = {"tests/chart": "chart", "tests/stability": "stability"}   # folder of pictures: target that makes them
SHOWN = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")


def pages(folder):
    found = []
    for at, folders, files in os.walk(folder):
        folders[:] = sorted(set(folders) - {"build", "out"})
        found += [Path(at, name) for name in files if name.endswith(".md")]
    return sorted(found)


def wrong_picture(picture, made):
    """What is wrong with a picture that a page shows, or ""."""
    if not picture.is_file():
        return "is not there"
    if picture in made or picture.suffix == ".svg":
        return ""
    target = TARGETS.get(str(picture.parent.relative_to(TOP))) if picture.is_relative_to(TOP) else None
    if target and re.search(rf"^{target}:", (TOP / "Makefile").read_text(), re.MULTILINE):
        return ""
    return "is made by no line of cases/figures.csv and no target"


def wrong_sweeps(made, shown):
    for picture, words in made.items():
        if words[0] == "sweep":
            text = "\n".join(page.read_text() for page, name in shown if name == picture).replace("\\\n", " ")
            printed = [shlex.split(line) for line in text.splitlines() if line.startswith("make sweep")]
            if not any(set(words[1:]) == set(line[2:]) - {"JOBS=1"} for line in printed):
                yield f"{picture.relative_to(TOP)}: {shlex.join(words)} is not the command of its page"


def main(folder):
    made = {TOP / "cases" / picture: words for picture, words, _ in rows("")}
    shown = {(page, (page.parent / name).resolve()) for page in pages(folder) for name in SHOWN.findall(page.read_text())}
    wrong = [f"{page.name}: {picture.name} {text}" for page, picture in sorted(shown) if (text := wrong_picture(picture, made))]
    if folder == TOP:
        wrong += [f"{picture.relative_to(TOP)} is shown on no page" for picture in made if picture not in {p for _, p in shown}]
        wrong += wrong_sweeps(made, shown)
    print(*wrong, f"{len(shown)} pictures, {len(made)} lines of figures.csv, {len(wrong)} wrong", sep="\n")
    return 1 if wrong or not shown else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else TOP))
