#!/usr/bin/python3
"""What `make run` prints last: example 1 by the script's law and forms through UMFPACK, beside that of the core.

twice.py FORMS CORE: folders of the two runs, with their summary.json."""
import json
import os
import sys

SHOWN = ("depth", "rotation", "moment Q_phi", "largest plastic strain")


def row(name, folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        run = json.load(file)
    results = [run["results"][key] for key in SHOWN]
    return [name, str(run["way"]["solver"]), *(f"{r['value']:.4g} {r['unit'].replace('-', '')}".strip() for r in results),
            f"{run['counts']['steps']}", f"{run['cpu_seconds']['total']:.1f} s"]


def main(forms, core):
    lines = [["example 1 of the article", "solver", *SHOWN, "steps", "CPU"], row("law and forms of the script, coarse mesh", forms),
             row("law and assembly of the core, default mesh", core)]
    widths = [max(len(line[k]) for line in lines) for k in range(len(lines[0]))]
    print()
    for line in lines:
        print("  " + "  ".join(cell.ljust(width) if k < 2 else cell.rjust(width) for k, (cell, width) in enumerate(zip(line, widths))))


if __name__ == "__main__":
    main(*sys.argv[1:])
