"""The page of a study: out/sweep/NAME/index.html, one file that works offline. Results, fields in one scale (shared.py), main effects,
sensitivity and response surface (analysis.py), Pareto front, histories (curves.py). page.html is its text, page.js and page_plots.js what
it does; plots by plotly.js of the Debian package python3-plotly, packed into the page.
"""
import base64
import glob
import gzip
import html
import itertools
import json
import os
import sys

import numpy as np
from analysis import TRUSTED, elementary_effects, scaled, sobol, surface_of, value_at
from curves import curves_of
from gather import read_summary
from request import read_text

HERE = os.path.dirname(os.path.abspath(__file__))
PLOTLY = ("/usr/share/python3-plotly/plotly.js", *glob.glob("/usr/lib/python3*/**/plotly/package_data/plotly.min.js"))  # Debian's, else upstream's
DIGITS = 5
MOST_PICTURES = 60      # packed into the page; those of more variants are read from their folders
GRID = 21               # points of a surface each way
MOST_PAIRS = 10         # pairs of parameters whose surface is drawn


def rounded(value):
    """A number as short as the page needs it; None for what is no finite number."""
    return float(f"{value:.{DIGITS}g}") if isinstance(value, (int, float)) and np.isfinite(value) else None


def list_of(values):
    return [rounded(float(v)) for v in values]


def results_of(study):
    """[{name, unit, expected}] of the script's own results; of a script without, numbers of "final" that change."""
    found, final = {}, {}
    for name in study.variants:
        summary = read_summary(study.place_of(name))
        for result, entry in (summary.get("results") or {}).items():
            found[result] = {"name": result, "unit": entry.get("unit", "").strip("-"), "expected": rounded(entry.get("expected"))}
        for column, value in (summary.get("final") or {}).items():
            final.setdefault(column, set()).add(value)
    return list(found.values()) or [{"name": n, "unit": "", "expected": None} for n, v in final.items() if len(v) > 1]


def picture_of(folder, number):
    """Of the field, as an address: packed, or the file."""
    path = os.path.join(folder, "field.png")
    if not os.path.exists(path):
        return ""
    if number >= MOST_PICTURES:
        return os.path.basename(folder) + "/field.png"
    with open(path, "rb") as file:
        return "data:image/png;base64," + base64.b64encode(file.read()).decode()


def variant_of(study, number, name, row, results):
    folder = study.place_of(name)
    return {"folder": name, "values": study.variants[name], "status": row["status"], "reason": row.get("reason", ""), "again": row.get("again", ""),
            "results": {r["name"]: rounded(row.get(r["name"])) for r in results}, "steps": row.get("steps"),
            "seconds": rounded(row.get("cpu_seconds")), "picture": picture_of(folder, number),
            "files": [f for f in ("log.txt", "report.txt", "summary.json", "history.csv", "final.png", "movie.html") if os.path.exists(os.path.join(folder, f))]}


def surface_data(surface, names, ends, parameters):
    """Values of a surface against a parameter, or against each two of them, the others at the middles of their ranges."""
    spacing = {p["name"]: p["spacing"] for p in parameters}
    axis = np.linspace(0, 1, GRID)
    values = {n: list_of(value_at(e, axis, spacing[n])) for n, e in zip(names, ends)}
    pairs = []
    for i, j in itertools.islice(itertools.combinations(range(len(names)), 2), MOST_PAIRS):
        points = np.full((GRID, GRID, len(names)), 0.5)
        points[..., i], points[..., j] = axis[None, :], axis[:, None]
        pairs.append({"x": names[i], "y": names[j], "z": [list_of(row) for row in surface.predict(points.reshape(-1, len(names))).reshape(GRID, GRID)]})
    lines = {}
    for k, name in enumerate(names):
        points = np.full((GRID, len(names)), 0.5)
        points[:, k] = axis
        lines[name] = list_of(surface.predict(points))
    return {"kind": surface.kind, "error": rounded(surface.error), "share": rounded(surface.share), "axes": values, "pairs": pairs, "lines": lines}


def analysis_of(parameters, rows, result):
    """Surface, Sobol indices and elementary effects of a result, {} where there are none."""
    good = [r for r in rows if r["status"] == "finished" and isinstance(r.get(result), (int, float)) and np.isfinite(r[result])]
    found = scaled(parameters, good) if len(good) > 2 else None
    surface = surface_of(found[1], [r[result] for r in good]) if found else None
    if surface is None:
        return {}
    names, _, ends = found
    mean, deviation, number = zip(*elementary_effects(found[1], [r[result] for r in good]))
    made = {"surface": surface_data(surface, names, ends, parameters),
            "effects": {"names": names, "mean": list_of(mean), "deviation": list_of(deviation), "number": list(number)}}
    if surface.share >= TRUSTED:
        first, total = sobol(surface.predict, len(names))
        made["sobol"] = {"names": names, "first": list_of(np.clip(first, 0, 1)), "total": list_of(np.clip(total, 0, None))}
    return made


def plotly():
    """plotly.js, packed; empty without its package. Read by its place: plotly.offline takes a second to load."""
    for path in PLOTLY:
        if os.path.exists(path):
            return base64.b64encode(gzip.compress(read_text(path).encode(), 1)).decode()
    print("burnish sweep: plots of the page need the Debian package python3-plotly", file=sys.stderr)
    return ""


def fields_of(folders):
    """Draws the fields where there are some. @returns their scale, None without"""
    if not any(os.path.exists(os.path.join(folder, "final.vtu")) for folder in folders):
        return None
    from shared import draw_fields
    return draw_fields(folders)


def data_of(study, rows, answer):
    results = results_of(study)
    good = [study.place_of(n) for n, row in zip(study.variants, rows) if row["status"] == "finished"]
    scale = fields_of(good)
    variants = [variant_of(study, i, name, row, results) for i, (name, row) in enumerate(zip(study.variants, rows))]
    columns = curves_of(variants, [study.place_of(n) for n in study.variants])
    return {"name": study.name, "script": study.request.script, "varied": study.request.varied, "goals": study.request.goals,
            "parameters": [{**p, "values": ordered([v["values"][p["name"]] for v in variants])} for p in study.parameters],
            "results": results, "variants": variants, "columns": columns, "scale": scale, "answer": answer,
            "analysis": {r["name"]: analysis_of(study.parameters, rows, r["name"]) for r in results}}


def ordered(texts):
    """Each once, numbers in order."""
    found = list(dict.fromkeys(texts))
    try:
        return sorted(found, key=float)
    except ValueError:
        return found  # words stay as they were listed


def write_page(study, rows, answer):
    """@returns the path of the page"""
    data = json.dumps(data_of(study, rows, answer), allow_nan=False).replace("</", "<\\/")
    page = read_text(os.path.join(HERE, "page.html")).replace("TITLE", html.escape(study.name))
    code = "\n".join(read_text(os.path.join(HERE, name)) for name in ("page.js", "page_plots.js"))
    page = page.replace("SCRIPT", code).replace("PLOTLY", plotly()).replace("DATA", data)
    path = os.path.join(study.folder, "index.html")
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(page)
    os.replace(path + ".new", path)
    return path
