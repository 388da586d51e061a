"""A sweep as one page: out/sweep/CASE/explore.html, with a slider for each varied option; results, histories and pictures
follow. Opens without a server; the pictures are those in the folders of the variants, the page is moved with them.

The text of the page is explore.html, what it does explore.js.
"""
import csv
import glob
import html
import json
import os
import sys

import numpy as np
from gather import read_summary, why
from grid import case_name, read_text
from overlay import chosen_columns, curve, histories, units

HERE = os.path.dirname(os.path.abspath(__file__))
POINTS = 200  # of a curve
DIGITS = 5


def rounded(value):
    """A number as short as the page needs it; None for one that is not finite."""
    return float(f"{value:.{DIGITS}g}") if value is not None and np.isfinite(value) else None


def results_of(folder):
    """[name, value, unit, expected value or None] of each result."""
    results = read_summary(folder).get("results") or {}
    return [[name.strip(), rounded(entry.get("value")), entry.get("unit", "").strip("-"), rounded(entry.get("expected"))]
            for name, entry in results.items()]


def pictures_of(folder, top):
    """{name: path from the page}"""
    return {os.path.basename(path)[:-4]: os.path.relpath(path, top).replace(os.sep, "/")
            for path in sorted(glob.glob(os.path.join(folder, "*.png")))}


def variant_of(variant, row, top):
    folder = variant["folder"]
    code = read_text(f"{folder}/exit.txt").strip() or "none"
    good = row["status"] == "finished"
    movie = os.path.join(folder, "movie.html")
    return {"values": variant["values"], "status": row["status"], "results": results_of(folder),
            "reason": "" if good else f"exit status {code}: {why(folder, read_summary(folder))}",
            "folder": os.path.relpath(folder, top).replace(os.sep, "/"), "pictures": pictures_of(folder, top),
            "movie": os.path.exists(movie), "t": [], "curves": {}}


def add_curves(variants, rows, folders):
    """Histories of the columns that tell the variants apart, thinned; returns [name, label] of them."""
    found = histories(range(len(rows)), folders)
    names = chosen_columns([run for _, run in found]) if len(found) > 1 else []
    for number, run in found:
        t = run.history["t"]
        kept = np.unique(np.linspace(0, len(t) - 1, min(POINTS, len(t))).astype(int))
        variants[number]["t"] = [rounded(v) for v in t[kept]]
        variants[number]["curves"] = {name: [rounded(v) for v in curve(run, name)[kept]] for name in names}
    columns = found[0][1].columns if found else {}
    return [[name, ("change of " if columns[name].kind in (units.LENGTH, units.ANGLE) else "") + plain_text(columns[name].axis())]
            for name in names]


def plain_text(label):
    """A label of matplotlib without its marks of a formula."""
    for mark in ("$", "{", "}", "\\"):
        label = label.replace(mark, "")
    return label.replace("10^", "1e")


def parameters_of(sweep):
    """The varied options with their values in order."""
    found = []
    for p in sweep["parameters"]:
        values = list(dict.fromkeys(v["values"][p["name"]] for v in sweep["variants"]))
        try:
            values.sort(key=float)
        except ValueError:
            pass  # words stay as they were listed
        found.append({**p, "unit": p["unit"].strip("-"), "values": values})
    return found


def write_page(sweep, rows, top):
    variants = [variant_of(v, row, top) for v, row in zip(sweep["variants"], rows)]
    columns = add_curves(variants, rows, [v["folder"] for v in sweep["variants"]])
    data = {"case": sweep["case"], "parameters": parameters_of(sweep), "variants": variants, "columns": columns}
    page = read_text(os.path.join(HERE, "explore.html")).replace("TITLE", html.escape(sweep["case"]))
    page = page.replace("SCRIPT", read_text(os.path.join(HERE, "explore.js")))
    page = page.replace("DATA", json.dumps(data, allow_nan=False).replace("</", "<\\/"))
    path, new = os.path.join(top, "explore.html"), os.path.join(top, ".new.explore.html")
    with open(new, "w", encoding="utf-8") as file:
        file.write(page)
    os.replace(new, path)
    return path


def main():
    top = f"out/sweep/{case_name()}"
    sweep = json.loads(read_text(f"{top}/sweep.json"))
    rows = list(csv.DictReader(read_text(f"{top}/sweep.csv").splitlines()))
    print(write_page(sweep, rows, top))
    return 0


if __name__ == "__main__":
    sys.exit(main())
