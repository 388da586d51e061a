"""What cases/tables.py measures of the cases in space: ball, ball-rolling, burnishing, slab, block-upsetting, tilted-punch,
plate-rolling, ring-rolling."""
from measured import brief, off as apart, run, table


def off(r, name):
    """Error of a result in per cent, "" where the run has none."""
    found = r.summary["results"].get(name)
    if found is None:
        return ""
    return f"{brief(100 * abs(found['error']))} %"


def ball():
    """Errors of every load against what is known."""
    runs = [("-what pressed -n 4", ""), ("-what pressed", "n = 6"), ("-what yield", "n = 6"), ("-what dragged", "n = 4"),
            ("-what dragged -n 6", ""), ("-what twisted -steps 8", "n = 3"), ("-what twisted -steps 8 -n 4", ""), ("-what twisted -steps 8 -n 5", ""),
            ("-what twisted -steps 8 -n 6", "")]
    rows = []
    for options, n in runs:
        r = run("ball", f"{options} -series 0 -check 0")
        kind = "shift" if "dragged" in options else "turn"
        moved = ", ".join(x for x in (off(r, f"{kind} at {f} of the limit") for f in ("0.5", "0.75", "0.9")) if x)
        rows.append([f"`{options}`" + (f", {n}" if n else ""), r.nodes, off(r, "contact radius"), off(r, "largest pressure"),
                     off(r, "pressure inside 0.9 a, rms"), off(r, "p0 over yield stress at first yield"), moved,
                     off(r, "stick radius at 0.9"), f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["run", "nodes", "a off", "p0 off", "rms of p inside 0.9 a", "yield off", "shift or turn off at 0.5, 0.75, 0.9", "stick radius off",
                  "steps (rejected)", "CPU s", ""], rows)


def ball_rolling():
    """Creep and moment of every load against what is known."""
    rows = []
    for options in ("-n 2", "", "-n 4", "-share 0.75", "-what driven", "-what free"):
        r = run("ball-rolling", f"{options} -check 0".strip())
        found = r.summary["results"]
        dual = found.get("moment from the turn off, over mu P R")
        rows.append([f"`{options}`" if options else "default: braked, Q = 0.5 mu P, n = 3", r.nodes, f"{r.result('creep over 3 mu P/(2 G a^2)'):.4f}",
                     off(r, "creep over the last 2 a"), f"{r.result('center of the pressure ahead'):.4f} a",
                     f"{dual['value']:.1e}" if dual else "", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["run", "nodes", "creep over 3 mu P/(2 G a^2)", "off", "center of the pressure", "duality", "steps (rejected)", "CPU s", ""], rows)


def burnishing():
    """The same tracks on five meshes, how far the coarsest is from the one of cells half its size, and that from two finer ones; the finest takes an hour."""
    names = ("depth of the middle track", "residual stress along", "residual stress across", "lowest along", "lowest across",
             "ridges over its bottom", "pile-up beside the last track", "residual stress along, surface", "residual stress across, surface")
    meshes = [run("burnishing", options) for options in ("-n 1", "-n 1.5", "", "-n 3", "-n 4")]
    rows = [[f"n = {n}", r.nodes, *(f"{r.result(name):.2f}" if r.summary["results"][name]["unit"] == "um" else f"{r.result(name):.0f}" for name in names),
             f"{r.final['plastic_strain_eq_p99']:.3f}", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()]
            for n, r in zip(("1", "1.5", "2 (default)", "3", "4"), meshes)]
    for label, run_off, of in (("1 off 2", meshes[0], meshes[2]), ("2 off 3", meshes[2], meshes[3]), ("2 off 4", meshes[2], meshes[4])):
        rows.append([label, "", *(apart(run_off.result(name), of.result(name)) for name in names), "", "", "", ""])
    return table(["mesh", "nodes", "depth um", "along MPa", "across MPa", "lowest along MPa", "lowest across MPa", "ridges um", "pile-up um",
                  "along, surface MPa", "across, surface MPa", "99 % of the plastic strain", "steps (rejected)", "CPU s", ""], rows)


def share(x):
    return f"{100 * x:.2g} %"


def checked(r, names, digits=5):
    """Rows of results: computed, expected, off, allowed."""
    rows = []
    for name, label in names:
        found = r.summary["results"][name]
        unit = found["unit"].strip("-")
        relative = found["expected"] != 0
        rows.append([label, f"{found['value']:.{digits}g} {unit}".strip(), f"{found['expected']:.{digits}g} {unit}".strip() if relative else "0",
                     share(found["error"]) if relative else f"{found['error']:.1g}", share(found["tolerance"]) if relative else f"{found['tolerance']:.2g}"])
    return rows


SLAB = (("depth, rolled", "depth at the end of the way"), ("turn", "turn"), ("force along the way", "force on the axis along the way"),
        ("largest plastic strain", "largest plastic strain"), ("depth, pressed", "depth when pressed, before the way"))


def slab():
    """The default against the plane's own run."""
    return table(["", "Space", "Plane", "Off", "Allowed"], checked(run("slab", "-series 0"), SLAB))


def slab_meshes():
    """The same on other meshes: how far space is off the plane."""
    rows = []
    for options in ("-n 24 -layers 4 -steps 20", "-steps 20", "", "-n 48 -layers 8 -width 6 -force 400 -brake 600"):
        r = run("slab", f"{options} -series 0 -check 0".strip())
        rows.append([f"`{options}`" if options else "default", r.nodes, *(share(r.summary["results"][name]["error"]) for name, _ in SLAB),
                     f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["options", "nodes", *(label for _, label in SLAB), "steps (rejected)", "CPU s", ""], rows)


def block_upsetting():
    """Force and width against the closed forms, on P2 and P1."""
    rows = []
    runs = [run("block-upsetting", options) for options in ("-series 0", "-element P1 -series 0")]
    for shortened in ("0.95", "0.9", "0.8"):
        elastic, rigid = (runs[0].summary["results"][name] for name in (f"F/(Y A0), h/h0 = {shortened}", f"  the same at {shortened}"))
        rows.append([f"F/(Y A0) at h/h0 = {shortened}", *(f"{r.result(f'F/(Y A0), h/h0 = {shortened}'):.5f}" for r in runs),
                     f"{elastic['expected']:.5f} ({share(elastic['error'])} off)", f"{rigid['expected']:.5f} ({share(rigid['error'])})"])
    wide = runs[0].summary["results"]["half width along x"]
    rows.append(["half width at 0.8", *(f"{r.result('half width along x'):.5f} mm" for r in runs), f"{wide['expected']:.5f} mm ({share(wide['error'])})", ""])
    rows.append(["nodes, steps, CPU s", *(f"{r.nodes}, {r.steps}, {r.cpu}" for r in runs), "", ""])
    return table(["", "P2", "P1", "(2), elastic part; of P2", "(1), rigid-plastic; of P2"], rows)


PUNCH = (("depth", "depth"), ("tilt toward the force", "tilt toward the force"), ("tilt across, over that toward", "tilt across over that toward"),
         ("pressure inside 0.7 a, rms", "pressure inside 0.7 a, rms"))


def tilted_punch():
    r = run("tilted-punch", "-series 0")
    turned = (("depth, turned by -turn / as it was", "depth turned over depth"), ("tilt, turned / as it was", "the same of the tilt"),
              ("tilt across, difference over tilt", "tilt across, difference over the tilt"))
    return table(["", "Computed", "Expected", "Off", "Allowed"], checked(r, PUNCH, 4) + checked(r, turned, 4))


def tilted_punch_meshes():
    rows = []
    for edge, inner in ((0.4, 0.5), (0.25, 0.2)):
        options = "" if (edge, inner) == (0.25, 0.2) else f"-edge {edge} -inner {inner} -check 0"
        r = run("tilted-punch", f"{options} -series 0".strip())
        rows.append([f"{edge}, {inner}", r.nodes, *(share(r.summary["results"][name]["error"]) for name, _ in PUNCH[:2]),
                     share(r.result("pressure inside 0.7 a, rms")), f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["`-edge`, `-inner`", "nodes", "depth", "tilt", "pressure inside 0.7 a", "steps (rejected)", "CPU s, two runs", ""], rows)


MOOSE = "-apart 2 -L 4 -travel 5 -nx 20 -steps 100"


def plate_rolling():
    """Every drive, the gripped plate on three meshes, and the numbers of MOOSE's example."""
    rows = []
    for options in ("-nx 18 -ny 2 -nz 2", "", "-nx 42 -ny 4 -nz 4", "-drive torque", MOOSE, MOOSE + " -drive pushed"):
        r = run("plate-rolling", f"{options} -series 0".strip())
        found = r.summary["results"]
        pick = lambda name, digits: f"{found[name]['value']:.{digits}f}" if name in found else ""
        rows.append([f"`{options}`" if options else "default", r.nodes, pick("force of roll 1", 2), pick("force of roll 2", 2), pick("torque of roll 1", 2),
                     pick("torque of roll 2", 2), pick("push on the tail", 2), pick("speed of roll 2", 3), pick("speed of the nose", 3),
                     pick("thickness after both", 4), pick("half width after both", 3), off(r, "volume of what is rolled, over that before"),
                     f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()])
    return table(["run", "nodes", "force 1", "force 2", "torque 1", "torque 2", "push", "speed of roll 2", "of the nose", "thickness", "half width",
                  "volume off", "steps (rejected)", "CPU s", ""], rows)


RING = (("volume over that before", "volume over that before"), ("mean diameter", "mean diameter"),
        ("turn of the ring over that of the roll", "turn of the ring over that of the roll"),
        ("turn of the mandrel over that of the ring", "of the mandrel over that of the ring"),
        ("turn of the cone over that of the ring", "of a cone over that of the ring"),
        ("radius where the cone does not slip", "radius where the cones do not slip"))


def ring_rolling():
    """The default against what is known."""
    return table(["", "Computed", "Expected", "Off", "Allowed"], checked(run("ring-rolling", "-check 0"), RING))


def ring_rolling_read():
    """What is only read of the same run, and what it costs."""
    r = run("ring-rolling", "-check 0")
    pick = lambda name, digits: f"{r.result(name):.{digits}f}"
    row = [r.nodes, pick("turn of the ring", 3), pick("torque of the roll", 0), pick("force of the mandrel", 1), pick("force of the cone", 1), pick("wall", 3),
           pick("half height behind the roll", 3), pick("half height behind the cone", 3), f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()]
    return table(["nodes", "turns of the ring", "torque of the roll N mm", "force of the mandrel N", "of a cone N", "mean wall", "half height behind the roll",
                  "behind the cones", "steps (rejected)", "CPU s", ""], [row])


TABLES = {"ball": {"known": ball}, "ball-rolling": {"known": ball_rolling}, "burnishing": {"meshes": burnishing},
          "slab": {"plane": slab, "meshes": slab_meshes}, "block-upsetting": {"known": block_upsetting},
          "tilted-punch": {"known": tilted_punch, "meshes": tilted_punch_meshes},
          "plate-rolling": {"runs": plate_rolling},
          "ring-rolling": {"known": ring_rolling, "read": ring_rolling_read}}
