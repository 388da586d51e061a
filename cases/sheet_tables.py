"""What cases/tables.py measures of sheets: cases/bending, strip-rolling, u-channel, cup, leveller, roll-bending, and the manual's page
thin-strips; those drawn at random: sheet_sweeps.py."""
import csv
import os
import subprocess

from measured import brief, run, table


def channel(name, options):
    r = run("u-channel", f"-check 0 {options}".strip())
    ended = r.t >= 2 - 1e-9
    shown = [(f, form) for f, form in (("mean punch force of the last third", "{:.1f}"), ("largest punch force, both halves", "{:.1f}"),
             ("thickness of the wall", "{:.4f}"), ("wall off the vertical, loaded", "{:.2f} deg"), ("wall off the vertical, sprung back", "{:.2f}"),
             ("flange off the horizontal, sprung back", "{:.2f}"), ("curvature of the wall, sprung back", "{:.4f}"))]
    return [name, *(form.format(r.result(f)) if ended else "" for f, form in shown),
            f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()]


CHANNEL = ["elements", "punch force N/mm", "largest", "wall mm", "wall, loaded", "sprung back", "flange deg", "curl 1/mm", "steps (rejected)",
           "CPU s", ""]


def channel_mesh():
    """Along the sheet, through the thickness, length of the steps, the other way through a step."""
    return table(CHANNEL, [channel(name, options) for name, options in (
        ("1 mm, 4 through (default)", ""), ("0.75 mm, 4", "-size 0.75"), ("0.5 mm, 4", "-size 0.5"), ("0.35 mm, 4", "-size 0.35"),
        ("1 mm, 2", "-ny 2"), ("0.5 mm, 2", "-size 0.5 -ny 2"), ("0.5 mm, 6", "-size 0.5 -ny 6"),
        ("0.5 mm, 4, `-steps 800`", "-size 0.5 -steps 800"), ("1 mm, 4, `-scheme event`", "-scheme event"),
        ("P1, 0.5 mm, 4", "-element P1 -size 0.5"), ("P1, 0.35 mm, 8", "-element P1 -size 0.35 -ny 8"))])


NUMISHEET = ("-width 25 -nose 5 -shoulder 5 -thickness 0.78 -clearance 1.282 -depth 70 -mu 0.144 -E 206000 -bite 20 -crown 5000 -length 175 "
             "-hardening '565.32*(0.007117+ep)^0.2589'")


def channel_numisheet():
    return table(["holder, both sides", *CHANNEL[1:]], [channel(name, f"{NUMISHEET} {options}") for name, options in (
        ("2.45 kN, 5 elements along a fillet", "-bhf 35 -edges 5"), ("2.45 kN, 8", "-bhf 35 -edges 8"),
        ("19.6 kN, 5", "-bhf 280 -edges 5"))])


SHOULDER = 5.47293
TIGHT = f"-thickness 1.06348 -shoulder {SHOULDER} -nose 3.47571 -clearance 1.05959 -mu 0.0406712 -bhf 47.1828"


def late(r, column):
    """Mean of a column of the history over the last third of the stroke, t = 0.7 to 1."""
    total, last = 0, 0.7
    with open(os.path.join(r.summary["options"]["out"], "history.csv"), encoding="utf-8") as file:
        for row in csv.DictReader(file):
            t = float(row["t"])
            if 0.7 < t < 1 + 1e-9:
                total, last = total + float(row[column])*(t - last), t
    return total/0.3


def channel_tight():
    """A channel of the sweep in little play, its edges by -size: force, what presses the die aside, the force without 4 mu times this."""
    rows, found = [], {}
    for edges, ny in ((20, 6), (16, 6), (14, 6), (12, 6), (10, 4), (8, 4), (7, 4)):
        r = run("u-channel", f"-series 0 -check 0 -size {SHOULDER/edges} {TIGHT}" + (f" -ny {ny}" if ny != 4 else ""))
        force, aside = r.result("mean punch force of the last third"), late(r, "die_force_x")
        found[edges] = (force, force - 4*r.summary["options"]["mu"]*aside)
        half = found.get(2*edges)
        cells = [f"{100*(a/b - 1):.1f} %" for a, b in zip(found[edges], half)] if half else ["", ""]
        rows.append([f"{edges}, {ny}", f"{force:.2f}", cells[0], f"{aside:.1f}", f"{found[edges][1]:.2f}", cells[1],
                     f"{r.steps} ({r.counts['rejected_steps']})", r.cpu])
    return table(["edges, through it", "punch force N/mm", "off its half mesh", "aside on the die N/mm", "without friction of this", "off", "steps (rejected)",
                  "CPU s"], rows[::-1])


def bent(name, options):
    r = run("bending", f"-check 0 {options}".strip())
    flanks = "springback without the die's flanks" in r.summary["results"]
    estimate = r.result("springback without the die's flanks") if flanks else r.summary["results"]["springback"]["expected"]
    back = r.result("springback")
    return [name, f"{r.result('largest force, both halves'):.1f}", f"{r.result('bend angle under load'):.2f} deg",
            f"{r.result('bend angle after springback'):.2f}", f"{back:.3f}", f"{estimate:.3f}" + (" without flanks" if flanks else ""),
            "" if flanks else f"{100 * (estimate / back - 1):.1f} %", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()]


BENT = ["force N/mm", "bend angle, load", "after", "springback", "pure bending", "off", "steps (rejected)", "CPU s", ""]


def bending_stroke():
    rows = [bent(f"{depth:g} mm" if depth != 12.5 else "12.5 mm (default)", "" if depth == 12.5 else f"-depth {depth:g}") for depth in (5, 8, 11, 12.5, 13)]
    rows.append(bent("13.9 mm, coined by a punch of 90 deg", "-punchangle 90 -depth 13.9"))
    rows.append(bent("14 mm, the same", "-punchangle 90 -depth 14"))
    rows.append(bent("12.5 mm, half the mesh", "-nx 128 -ny 8"))
    return table(["stroke", *BENT], rows)


def bending_thickness():
    return table(["thickness", *BENT], [bent(f"{t:g} mm", f"-thickness {t:g} -depth 11") for t in (0.5, 0.75, 1, 1.5, 2, 2.5, 3)])


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


def leveller_rolls():
    rows = []
    for name, options in (("5 idle (default)", ""), ("5 driven", "-drive driven"), ("5 idle, `-exit 0.2`", "-exit 0.2"), ("5 idle, half the mesh", "-size 0.75 -ny 6"),
                          ("3 idle", "-rolls 3"), ("3 driven", "-rolls 3 -drive driven"), ("3 idle, `-intermesh 0.5`", "-rolls 3 -intermesh 0.5"),
                          ("3 idle, half the mesh", "-rolls 3 -size 0.75 -ny 6")):
        r = run("leveller", f"-check 0 {options}".strip())
        after = [r.result(f"curvature after, {what}") for what in ("mean", "least", "most")]
        rows.append([name, f"{after[0]:.2f} ({after[1]:.2f} to {after[2]:.2f})", f"{r.result('mean press of the upper rolls'):.1f}",
                     f"{r.result('mean force of the leading lower roll'):.2f}", f"{r.result('mean pull along the strip'):.1f}",
                     f"{r.result('mean torque of the rolls'):.1f}", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["rolls", "curvature after, 1/m", "press N/mm", "leading roll N/mm", "pull N/mm", "torque N", "steps (rejected)", "CPU s", ""], rows)


def winding_mesh():
    rows = []
    for name, options in (("1.5 mm, 2 through", "-size 1.5 -ny 2"), ("1.5 mm, 4", "-size 1.5"), ("0.75 mm, 4 (default)", ""), ("0.4 mm, 4", "-size 0.4"),
                          ("0.75 mm, 8", "-ny 8"), ("default, `-press 40`", "-press 40"), ("default, `-play 0.05`", "-play 0.05"),
                          ("default, `-thickness 1`", "-thickness 1"), ("default, `-angle 160`", "-angle 160")):
        r = run("roll-bending", f"-check 0 {options}".strip())
        moment = r.summary["results"]["mean moment of winding"]
        rows.append([name, f"{moment['value']:.1f}", f"{moment['expected']:.1f}", f"{r.result('bend angle under load'):.2f} deg",
                     f"{r.result('largest angle of the form touched'):.1f}", f"{r.result('springback'):.2f}",
                     f"{r.result('springback of pure bending'):.2f}", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["elements", "moment N", "by the work", "bent, load", "form touched", "springback", "pure bending", "steps (rejected)", "CPU s", ""], rows)


STRIP = (("gripped (1) or refused (0)", "{:.0f}", "mu >= tan of the angle after the push"), ("pusher's force at the end", "{:.3f}", "0; kept"),
         ("pusher's force / roll force", "{:.5f}", "0.04785 (within 1 %)"), ("roll force at the end", "{:.1f}", ""),
         ("roll torque at the end", "{:.1f}", ""), ("released by the pusher after", "{:.4f}", ""), ("roll force", "{:.1f}", "slab 1561"),
         ("roll torque", "{:.1f}", "slab 3824"), ("thickness behind the rolls", "{:.4f}", "gap 3.2"),
         ("speed of nose / tail", "{:.4f}", "1.2490 (within 0.5 %)"), ("neutral angle / alpha", "{:.4f}", "slab 0.323"),
         ("forward slip", "{:.2f}", "slab 2.47, see below"))


def strip_bite():
    """Two rolls and one, above the angle of friction and below it."""
    runs = [run("strip-rolling", f"-check 0 -series 0 -rolls {rolls} -ratio {ratio}") for rolls in (2, 1) for ratio in (1.4, 0.7)]

    def cell(r, name, form):
        return form.format(r.result(name)) if name in r.summary["results"] else "-"

    def named(name):
        unit = next(r.summary["results"][name]["unit"] for r in runs if name in r.summary["results"])
        return name if unit in ("-", "") else f"{name}, {unit}"

    rows = [[named(name), *(cell(r, name, form) for r in runs), expected] for name, form, expected in STRIP]
    rows.append(["steps (rejected), CPU s", *(f"{r.steps} ({r.counts['rejected_steps']}), {r.cpu}" for r in runs), ""])
    return table(["Quantity", "two rolls, `-ratio 1.4`", "two rolls, `-ratio 0.7`", "half, 1.4", "half, 0.7", "Expected"], rows)


def strips_ubend():
    """A U-bend without a holder, which jumps from node to node."""
    rows = []
    for size, ny, steps in ((1, 3, 100), (1, 3, 400), (1, 3, 1600), (1, 2, 400), (1, 4, 400), (1, 4, 1600), (1, 6, 400), (0.75, 3, 800), (0.5, 4, 800)):
        command = [os.environ.get("BURNISH", "build/burnish"), "tests/support/forming/ubend.edp", "-size", str(size), "-ny", str(ny), "-steps", str(steps)]
        print(" ".join(command[1:]), flush=True)
        words = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
        told = {name: float(words[words.index(name, words.index("forming")) + 1]) for name in ("t", "work", "wall", "steps", "rejected", "cpu")}
        rows.append([f"{size:g} mm, {ny}", f"1/{steps}", f"{told['work']:.1f}", f"{told['wall']:.2f} deg", f"{told['steps']:.0f} ({told['rejected']:.0f})",
                     brief(told["cpu"]), "" if told["t"] == 1 else f"stops at t = {told['t']:.3f}"])
    return table(["edges along the sheet, through it", "`dtmax=`", "work, N mm/mm", "wall", "steps (rejected)", "CPU s", ""], rows)


TABLES = {"strip-rolling": {"bite": strip_bite}, "bending": {"stroke": bending_stroke, "thickness": bending_thickness},
          "u-channel": {"mesh": channel_mesh, "numisheet": channel_numisheet, "tight": channel_tight},
          "roll-bending": {"mesh": winding_mesh}, "leveller": {"rolls": leveller_rolls},
          "cup": {"mesh": cup_mesh, "gap": cup_gap, "ratio": cup_ratio}, "thin-strips": {"ubend": strips_ubend}}
