"""What cases/tables.py measures of the cases in space: table "known" of cases/ball."""
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


TABLES = {"ball": {"known": ball}}
