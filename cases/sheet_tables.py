"""What cases/tables.py measures of sheets: cases/u-channel/README.md, cases/cup/README.md."""
import csv
import os

from measured import run, table


def channel_mesh():
    runs = [("1 mm (default)", ""), ("1 mm, `-scheme event`", "-scheme event"),
            *((f"{size} mm", f"-size {size}") for size in (0.75, 0.6, 0.5))]
    rows = []
    for name, options in runs:
        r = run("u-channel", f"-check 0 {options}".strip())
        ended = r.t >= 2 - 1e-9
        angle = r.result("wall off the vertical, sprung back") if ended else None
        rows.append([name, f"{r.result('punch force against bending and friction'):.2f}" if ended else "",
                     f"{r.result('largest punch force, both halves'):.2f}" if ended else "", "" if angle is None else f"{angle:.3f} deg",
                     f"{r.result('thickness of the wall'):.4f}" if ended else "", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["elements", "punch force (half 0.7 to 1)", "largest, both halves", "wall, sprung back", "thickness of the wall",
                  "steps (rejected)", "CPU s", ""], rows)


def cup(options, name):
    """Its run, and cells of every table."""
    r = run("cup", f"-check 0 {options}".strip())
    force, torn = r.result("largest punch force") / 1e3, r.result("torn at the stroke")
    end = r.stopped() or (f"torn at {torn:.1f} mm" if torn else "")
    return r, [name, f"{force:.2f}", f"{r.result('height of the cup'):.2f}", f"{r.result('smallest thickness'):.3f}",
               f"{r.result('largest thickness'):.3f}"], [f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, end]


HEAD, TAIL = ["force kN", "height mm", "thinnest", "thickest mm"], ["steps (rejected)", "CPU s", ""]


def cup_mesh():
    rows = []
    for name, options in (("2 mm", "-size 2"), ("1 mm (default)", ""), ("1 mm, `-steps 400`", "-steps 400"), ("0.5 mm", "-size 0.5"),
                          ("0.5 mm, 3 through the thickness", "-size 0.5 -ny 3"), ("0.33 mm, 3", "-size 0.33 -ny 3")):
        r, cells, end = cup(options, name)
        rows.append([*cells, f"{100 * r.summary['results']['imbalance']['value']:.4f} %", *end])
    return table(["elements", *HEAD, "imbalance", *TAIL], rows)


def force_at(r, stroke):
    """Mean force of the punch within 1 mm of a stroke [kN]; nodes that pass the shoulder make peaks."""
    with open(os.path.join(r.summary["options"]["out"], "history.csv"), encoding="utf-8") as file:
        near = [float(row["punch_force"]) for row in csv.DictReader(file) if abs(float(row["stroke"]) - stroke) < 1]
    return sum(near) / len(near) / 1e3


def cup_gap():
    rows = []
    for name, options in (("1.4 mm", "-gap 1.4 -size 0.5"), ("1.2 mm", "-gap 1.2 -size 0.5"), ("1.0 mm", "-gap 1.0 -size 0.5"),
                          ("0.9 mm", "-gap 0.9 -size 0.5"), ("0.9 mm, elements of 1 mm", "-gap 0.9"), ("0.8 mm", "-gap 0.8 -size 0.5")):
        r, cells, end = cup(options, name)
        rows.append([*cells, f"{r.result('mean thickness of the wall'):.3f}", f"{force_at(r, 20):.1f}", *end])
    return table(["clearance", *HEAD, "wall, mean", "kN at 20 mm", *TAIL], rows)


def cup_ratio():
    rows = []
    for R0 in (34, 36, 38, 40, 42, 43, 44, 46):
        r, cells, end = cup("" if R0 == 38 else f"-blank {R0}", f"{R0} mm, {R0 / 20:g}")
        rows.append([*cells, f"{r.result('force by Siebel') / 1e3:.2f}", *end])
    return table(["blank, ratio", *HEAD, "Siebel kN", *TAIL], rows)


TABLES = {"u-channel": {"mesh": channel_mesh}, "cup": {"mesh": cup_mesh, "gap": cup_gap, "ratio": cup_ratio}}
