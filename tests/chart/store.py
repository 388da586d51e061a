"""Rows of the chart in files, and what is stored: rows and pictures in this folder, tables in its README.md and in that of the project."""
import csv
import os
import re
import shutil
import sys

import report
from scene_files import HERE

TOP = os.path.dirname(os.path.dirname(HERE))
# of the project's README.md: scene, words for it, quantity, what n is, levels
USE = [("hertz", "Hertz, pressure inside 0.8 a", "pressure_inner", "elements in the half-width", report.LEVELS),
       ("ball", "Hertz in space, pressure inside 0.8 a", "pressure_inner", "edges on the radius", [0.05, 0.01]),
       ("rolling", "plastic: rolling, depth", "depth", "edges of 1/n of the arc", [0.01])]


def write(path, rows, digits=5):
    with open(path, "w", newline="") as f:
        table = csv.DictWriter(f, list(rows[0]), lineterminator="\n")
        table.writeheader()
        for row in rows:
            table.writerow({k: f"{v:.{digits}g}" if isinstance(v, float) else v for k, v in row.items()})


def read(path):
    """Rows as they were written: whole numbers, numbers and words."""
    def value(word):
        for kind in (int, float):
            try:
                return kind(word)
            except ValueError:
                pass
        return word == "True" if word in ("True", "False") else word

    with open(path) as f:
        return [{k: v if k in ("factor", "method") else value(v) for k, v in row.items()} for row in csv.DictReader(f)]


def put(path, tables):
    """Lines between <!-- chart NAME --> and <!-- end -->."""
    with open(path) as f:
        text = f.read()
    for name, lines in tables.items():
        mark = f"<!-- chart {name} -->"
        text, count = re.subn(re.escape(mark) + r"\n.*?<!-- end -->", lambda _: "\n".join([mark, *lines, "<!-- end -->"]), text,
                              flags=re.DOTALL)
        if count != 1:
            sys.exit(f"chart: {path} has {count} times {mark}, expected once")
    with open(path, "w") as f:
        f.write(text)


def store(scene, tables, folder):
    name = scene["name"]
    for picture in (f"{name}.png", f"{name}-all.png"):
        shutil.copy(os.path.join(folder, picture), os.path.join(HERE, picture))
    write(os.path.join(HERE, f"{name}.csv"), read(os.path.join(folder, f"{name}.csv")), 3)
    put(os.path.join(HERE, "README.md"), {f"{name} {part}": lines for part, lines in tables.items()})
    stored = {name: read(os.path.join(HERE, f"{name}.csv")) for name in {use[0] for use in USE}
              if os.path.exists(os.path.join(HERE, f"{name}.csv"))}
    put(os.path.join(TOP, "README.md"), {"use": report.use([(*use, stored[use[0]]) for use in USE if use[0] in stored])})
