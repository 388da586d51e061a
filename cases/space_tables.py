"""What cases/tables.py measures of the cases in space: ball, ball-rolling, burnishing."""
from measured import brief, run, table


def off(r, name):
    """Error of a result in per cent, "" where the run has none."""
    found = r.summary["results"].get(name)
    if found is None:
        return ""
    return f"{brief(100 * abs(found['error']))} %"


def ball():
    """Errors of every load against what is known."""
    runs = [("-what pressed -n 4", ""), ("-what pressed", "n = 6"), ("-what yield", "n = 6"), ("-what dragged", "n = 4"),
            ("-what twisted -steps 8", "n = 3")]
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
    """The same tracks on three meshes."""
    names = ("depth of the middle track", "ridges over its bottom", "pile-up beside the last track", "residual stress along, surface",
             "residual stress across, surface", "lowest along", "lowest across")
    meshes = [run("burnishing", options) for options in ("-n 1", "-n 1.5", "", "-n 2.5")]
    rows = [[f"n = {n}", r.nodes, *(f"{r.result(name):.2f}" if k < 3 else f"{r.result(name):.0f}" for k, name in enumerate(names)),
             f"{r.final['plastic_strain_eq_p99']:.3f}", f"{r.steps} ({r.counts['rejected_steps']})", r.cpu, r.stopped()]
            for n, r in zip(("1", "1.5", "2 (default)", "2.5"), meshes)]
    return table(["mesh", "nodes", "depth um", "ridges um", "pile-up um", "along, surface MPa", "across, surface MPa", "lowest along MPa",
                  "lowest across MPa", "99 % of the plastic strain", "steps (rejected)", "CPU s", ""], rows)


TABLES = {"ball": {"known": ball}, "ball-rolling": {"known": ball_rolling}, "burnishing": {"meshes": burnishing}}
