"""Fills the gaps of a lab: the scripts of cases/labs/NAME with the values of its gaps.txt in their place.

    solve.py NAME [FOLDER]     writes FOLDER/solution.edp of lab.edp, FOLDER/solution-crank.edp of crank.edp, and so on;
                               FOLDER is out/labs/NAME unless given
gaps.txt has a line a gap, NUMBER: VALUE, or crank NUMBER: VALUE for crank.edp alone; the value is FreeFEM and takes the place of
rcGap(NUMBER, "...").
"""
import re
import sys
from pathlib import Path

LABS = Path(__file__).resolve().parent
GAP = re.compile(r'rcGap(?:Text)?\(\s*(\d+),\s*"[^"]*"\s*\)')


def values_of(lab, stem=""):
    """The gaps' values by their numbers, as text; those of one script before those of all."""
    lines = [line.split(":", 1) for line in (lab / "gaps.txt").read_text().splitlines()]
    values = {int(name): value.strip() for name, value in lines if name.isdigit()}
    own = {int(name.split()[1]): value.strip() for name, value in lines if name.split()[0] == stem}
    return {**values, **own}


def solved(script):
    """The text of a script without gaps."""
    values = values_of(script.parent, script.stem)
    return GAP.sub(lambda gap: values[int(gap[1])], script.read_text())


def solution_of(script):
    """The name of the solved script: lab.edp gives solution.edp, crank.edp solution-crank.edp."""
    return "solution.edp" if script.name == "lab.edp" else f"solution-{script.name}"


def solve(lab, folder):
    """Writes all solutions of a lab into the folder, links plot.py there; the paths of the solutions."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "plot.py").unlink(missing_ok=True)
    (folder / "plot.py").symlink_to(lab / "plot.py")
    written = []
    for script in sorted(lab.glob("*.edp")):
        if GAP.search(script.read_text()):
            written.append(folder / solution_of(script))
            written[-1].write_text(solved(script))
    return written


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or not (LABS / sys.argv[1] / "gaps.txt").is_file():
        sys.exit(f"{__doc__}\nlabs: {' '.join(sorted(one.parent.name for one in LABS.glob('*/gaps.txt')))}")
    for path in solve(LABS / sys.argv[1], Path(sys.argv[2] if len(sys.argv) > 2 else f"out/labs/{sys.argv[1]}")):
        print(path)
