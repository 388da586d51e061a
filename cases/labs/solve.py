#!/usr/bin/python3
"""Writes the scripts of a lab without gaps, made of its scripts and its key; prints their names.

  solve.py LAB [-o FOLDER]     LAB: 2-friction, 2, or a folder; into out/labs/LAB unless FOLDER is given
lab.edp becomes solution.edp, another script such as crank.edp solution-crank.edp, broken1.edp mended/broken1.edp; plot.py goes with them.

The key has the values: "- Gap 2: `-F*t`" takes the place of rcGap(2, "...") and rcGapText(2, "...") in all scripts, under the heading
"## Gaps of crank.edp" in that one only. Under "## Broken scripts" a row "| 1 | `wrong` | `right` | ..." mends broken1.edp.
"""
import argparse
import re
import shutil
import sys
from pathlib import Path

LABS = Path(__file__).resolve().parent
GAP = re.compile(r'\brcGap(?:Text)?\((\d+),\s*"(?:[^"\\]|\\.)*"\)')
NUMBER = re.compile(r"\brcGap(?:Text)?\((\d+)")


class KeyFault(Exception):
    """The key does not fit the scripts."""


def keyed(folder):
    """({script, or "": {gap: value}}, {number of a broken script: (wrong, right)}) of a lab's key."""
    gaps, broken, heading = {}, {}, ""
    for line in (folder / "key.md").read_text().splitlines():
        if line.startswith("## "):
            heading = line[3:]
        if heading.startswith("Gaps") and (found := re.match(r"- Gap (\d+): `([^`]+)`", line)):
            script = re.match(r"Gaps of (\S+)", heading)
            values = gaps.setdefault(script[1] if script else "", {})
            if int(found[1]) in values:
                raise KeyFault(f"key.md has gap {found[1]} twice under \"{heading}\"")
            values[int(found[1])] = found[2]
        if heading == "Broken scripts" and (found := re.match(r"\| (\d+) \| `([^`]+)` \| `([^`]+)` \|", line)):
            broken[int(found[1])] = found[2], found[3]
    return gaps, broken


def name(script):
    """What a script is called without its gaps."""
    if script.startswith("broken"):
        return f"mended/{script}"
    return "solution.edp" if script == "lab.edp" else f"solution-{script}"


def solved(folder):
    """{name: text} of the scripts without gaps."""
    gaps, broken = keyed(folder)
    unused = {(script, n) for script, values in gaps.items() for n in values}
    texts = {}
    for script in sorted(folder.glob("*.edp")):
        text = script.read_text()

        def value(gap):
            n = int(gap[1])
            for where in (script.name, ""):
                if n in gaps.get(where, {}):
                    unused.discard((where, n))
                    return gaps[where][n]
            raise KeyFault(f"key.md has no value of gap {n} of {script.name}")
        if NUMBER.search(text):
            texts[name(script.name)] = text = GAP.sub(value, text)
            if left := NUMBER.search(text):
                raise KeyFault(f"gap {left[1]} of {script.name} has no text that says what is missing")
    for n, (wrong, right) in broken.items():
        text = (folder / f"broken{n}.edp").read_text()
        if text.count(wrong) != 1:
            raise KeyFault(f"broken{n}.edp has `{wrong}` {text.count(wrong)} times, expected once")
        texts[name(f"broken{n}.edp")] = text.replace(wrong, right)
    for script in folder.glob("broken*.edp"):
        if name(script.name) not in texts:
            raise KeyFault(f"key.md does not mend {script.name}")
    if unused:
        raise KeyFault(f"no script has the gaps {sorted(unused)} of key.md")
    return texts


def write(folder, out):
    """Writes them into out; their paths."""
    texts = solved(folder)
    for file, text in texts.items():
        (out / file).parent.mkdir(parents=True, exist_ok=True)
        (out / file).write_text(text)
    shutil.copy(folder / "plot.py", out)
    return [out / file for file in texts]


def main():
    options = argparse.ArgumentParser(usage=__doc__)
    options.add_argument("lab")
    options.add_argument("-o", type=Path)
    given = options.parse_args()
    folders = [Path(given.lab)] if Path(given.lab).is_dir() else [*LABS.glob(given.lab), *LABS.glob(given.lab + "-*")]
    if len(folders) != 1 or not (folders[0] / "key.md").is_file():
        return f"solve.py: no lab \"{given.lab}\" with a key.md"
    folder = folders[0].resolve()
    try:
        print(*write(folder, given.o or Path("out/labs") / folder.name), sep="\n")
    except KeyFault as fault:
        return f"solve.py: {fault}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
