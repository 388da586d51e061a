"""Tables of cases/planetary for tables.py."""
import math
import re

from measured import run, strain, table

REGIONS = ["roller 1, rolled side", "roller 1, opposite side", "roller 2, rolled side", "roller 2, opposite side",
           "thin end"]
STRAINS = ["ep roller 1 rolled", "opposite", "ep roller 2 rolled", "opposite", "thin end"]


def planetary(options=""):
    r = run("planetary", options)
    r.strains = [strain(r.result("ep, " + region)) for region in REGIONS]
    return r


def area(r, roller):
    """mm² above the initial yield stress on both sides, as the run prints it behind the strains of the regions."""
    lines = [line for line in r.log.splitlines() if line.strip().startswith(f"ep, roller {roller},")]
    x = sum(float(re.search(r"above the initial yield stress on (\S+) mm", line)[1]) for line in lines)
    return "0" if x == 0 else f"{x:.2f}" if x < 1 else f"{x:.1f}"


def power(x):
    digits = math.floor(math.log10(x))
    return f"{x / 10**digits:g}·10{'⁰¹²³⁴⁵⁶⁷⁸⁹'[digits]}"


def loads():
    rows = []
    for load in (2.36e3, 5e4, 8e4, 1e5, 1.2e5, 1.25e5, 1.3e5, 1.5e5):
        r = planetary(LOADED if load == 1.2e5 else f"{LOADED} -F0 {load:g}")
        rows.append([power(load) + (" (default)" if load == 1.2e5 else ""), *r.strains,
                     f"{area(r, 1)} / {area(r, 2)}", f"{r.result('advance of roller 2'):.0f}",
                     r.cpu, r.stopped()])
    return table(["F₀ N/m", *STRAINS, "area at roller 1 / 2, mm²", "advance µm", "CPU s", ""], rows)


LOADED = "-fine 160e-6"                                  # mesh of the table of loads
COARSER = "-fine 300e-6 -coarse 1e-3 -inner 80"


def equal(element, mm):
    """Elements of one size on both arcs."""
    return f"-element {element} -fine {mm:g}e-3 -coarse {mm:g}e-3 -inner {round(math.pi * 25 / mm)}"


def mesh():
    meshes = [("P1", f"{mm} mm", equal("P1", mm)) for mm in (1.2, 0.8, 0.7, 0.4, 0.2)]
    meshes += [("P1", "80 µm (0.5 mm elsewhere)", "-element P1"), ("P2", "1.6 mm", equal("P2", 1.6)), ("P2", "0.8 mm", equal("P2", 0.8)),
               ("P2", "300 µm (1 mm elsewhere, `-inner 80`)", COARSER), ("P2", "160 µm (0.5 mm elsewhere)", LOADED),
               ("P2", "80 µm (0.5 mm elsewhere; default)", "")]
    rows = []
    for element, size, options in meshes:
        r = planetary(options)
        rows.append([element, size, r.nodes, *r.strains, r.cpu, r.stopped()])
    return table(["element", "elements under the rollers", "nodes", *STRAINS, "CPU s", ""], rows)


def others():
    runs = [("160 µm", LOADED), ("half the steps: `-steps 200 -width 28`", LOADED + " -steps 200 -width 28"),
            ("printed moment: `-M0 6.3`", LOADED + " -M0 6.3"),
            ("300 µm", COARSER), ("event steps: `-scheme event`", COARSER + " -scheme event"),
            ("`-F0 1.5e5`", COARSER + " -F0 1.5e5"), ("the same by event steps", COARSER + " -F0 1.5e5 -scheme event"),
            ("thinner ring: `-Ri 26e-3`", COARSER + " -Ri 26e-3"), ("the same, `-F0 8e4`", COARSER + " -Ri 26e-3 -F0 8e4"),
            ("P1, 2.4 mm", equal("P1", 2.4)), ("the same, `-mu 0.25`", equal("P1", 2.4) + " -mu 0.25")]
    rows = []
    for name, options in runs:
        r = planetary(options)
        rows.append([name, r.nodes, r.steps, *r.strains, f"{r.result('advance of roller 2'):.1f}", r.cpu, r.stopped()])
    return table(["", "nodes", "steps", *STRAINS, "advance µm", "CPU s", ""], rows)


WHOLE = [("P1, 0.8 mm", equal("P1", 0.8), (0, 1, 2)), ("P2, 300 µm", COARSER, (0, 1, 2)),
         ("the same by event steps", COARSER + " -scheme event", (0, 1)), ("P2, 80 µm (default)", "", (0, 1))]


def whole():
    names = {0: "half", 1: "whole, geared", 2: "whole, no gear"}
    rows = []
    for size, options, ways in WHOLE:
        for way in ways:
            r = planetary(f"{options} -whole {way}" if way else options)
            apart = f"{r.result('largest difference of mirrored rollers'):.0e}" if way else ""
            gear = f"{abs(r.result('moment of the gear / M0')):.0e}" if way == 1 else ""
            rows.append([size, names[way], f"{r.steps} ({r.counts['rejected_steps']})", f"{r.result('advance of roller 2'):.2f}",
                         *(f"{r.result(f'turn of roller {i}'):.3f}" for i in (1, 2)),
                         f"{r.result('moment Q_phi of roller 1'):.1f}", f"{r.result('moment Q_beta of roller 2'):.1f}",
                         *r.strains, apart, gear, r.cpu, r.stopped()])
    return table(["mesh", "ring", "steps (rejected)", "advance µm", "turn of 1, deg", "of 2", "Q_φ of 1, N·m/m", "Q_β of 2", *STRAINS,
                  "mirrored rollers differ by", "gear / M₀", "CPU s", ""], rows)


TABLES = {"mesh": mesh, "loads": loads, "others": others, "whole": whole}
