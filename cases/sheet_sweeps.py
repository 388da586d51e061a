"""What cases/tables.py measures of sheets drawn at random: Latin hypercubes by cases/sweep, a part of them again on a mesh half as fine
in both directions. Tables "sweep" of cases/bending, u-channel, cup."""
import json
import os
import re
import statistics
import subprocess
import sys

from measured import Run, run, table

IMBALANCE = 1e-3
COMMON = "-pictures 0 -series 0 -check 0"
# varied mesh, its option's halved value, elements through the thickness of the half mesh, drawn options, samples, every how
# many that finished is repeated (or the places of those, for each mesh, so that the choice stays when others finish, too),
# the force that is compared
SWEEPS = {
    "bending": ("nx=64,96", lambda v: f"-nx {2 * int(v)}", 8, "thickness=.5:3:latin shoulder=1:6:latin nose=1:6:latin "
                "depth=6:12.5:latin mu=0:.2:latin", 50, 10, "largest force, both halves"),
    "cup": ("size=1,0.75", lambda v: f"-size {float(v) / 2:g}", 4, "blank=30:42:latin nose=3:8:latin shoulder=3:8:latin "
            "gap=1.1:1.6:latin mu=.02:.15:latin bhf=2000:15000:latin", 50, 25, "largest punch force"),
    "u-channel": ("edges=6,7,8", lambda v: f"-edges {2 * int(v)}", 6, "thickness=.5:2:latin shoulder=1:6:latin nose=1:6:latin "
                  "clearance=1.05:1.4:latin mu=0:.2:latin bhf=5:80:latin", 67, {"6": (0, 26, 52), "7": (0, 25, 52), "8": (0, 24, 50)},
                  "mean punch force of the last third"),
}


def variants(case, samples, vary, drawn):
    """Folders of the sweep, run unless they are to be kept: in the order of the samples."""
    top = os.path.join("out/sweep", case)
    if not Run.keep:
        command = [os.environ["BURNISH"], "sweep", f"cases/{case}/{case}.edp", vary, *drawn.split(), "-samples", str(samples), "-study", case]
        subprocess.run([*command, *COMMON.split()], check=True)
    values = vary.split("=")[1].split(",")
    found = sorted(f for f in os.listdir(top) if f.startswith(vary.split("=")[0] + "=") and f.split(",")[0].split("=")[1] in values)
    if len(found) != samples * len(values):
        sys.exit(f"tables.py: {len(found)} variants in {top}, expected {samples * len(values)}")
    return [os.path.join(top, f) for f in found]


def options_of(folder):
    return " ".join(f"-{w.replace('=', ' ')}" for w in os.path.basename(folder).split(","))


def outcome(folder):
    """Its summary, or the reason of its end, shortened: of a run that stopped, that is not to be trusted, whose forces do not balance."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with open(os.path.join(folder, "exit.txt"), encoding="utf-8") as file:
            code = file.read().strip()
    except FileNotFoundError:
        return None, "no result"
    if summary["status"] == "finished":
        unbalanced = summary["measured"]["balance"] >= IMBALANCE
        return summary, "out of balance" if unbalanced else "" if code == "0" else f"exit status {code}"
    with open(os.path.join(folder, "log.txt"), encoding="utf-8", errors="replace") as file:
        text = re.search(r"stopped early at t = (\S+).*", file.read())
    return summary, text.group(0) if text else summary["status"]


CAUSES = (("may slip from one to the next", "hangs on single nodes"), ("too little to balance", "slips from node to node"),
          ("wedges", "a node wedges"), ("nothing resists", "the holder hangs in the air"), ("states cycle", "states cycle"),
          ("exit status", "not to be trusted"), ("out of balance", "out of balance"))


def cause(reason):
    return next((name for text, name in CAUSES if text in reason), "no convergence")


def chosen(ends, value, every):
    """Of a mesh's samples those that are compared with a mesh half as fine: folder and summary of each."""
    picked = [ends[i] for i in every[value]] if isinstance(every, dict) else [e for e in ends if not e[2]][::every]
    return [(f, s) for f, s, reason in picked if not reason]


def sweep(case):
    vary, halved, through, drawn, samples, every, force = SWEEPS[case]
    rows, option = [], vary.split("=")[0]
    folders = variants(case, samples, vary, drawn)
    for value in vary.split("=")[1].split(","):
        ends = [(f, *outcome(f)) for f in folders if os.path.basename(f).startswith(f"{option}={value},")]
        done = [(f, s) for f, s, reason in ends if not reason]
        stopped = [cause(reason) for _, _, reason in ends if reason]
        errors = []
        for f, s in chosen(ends, value, every):
            half = run(case, f"-series 0 -check 0 {options_of(f)} {halved(value)} -ny {through}")
            if half.finished:
                errors.append((s["results"][force]["value"] / half.result(force) - 1, os.path.basename(f)))
        sizes = sorted(abs(e) for e, _ in errors)
        why = ", ".join(f"{stopped.count(name)} {name}" for name in sorted(set(stopped)))
        steps = [s["counts"]["steps"] for _, s in done]
        print(f"{case} {option}={value}: worst against the half mesh {max(errors, key=lambda e: abs(e[0]))}")
        rows.append([f"{option} {value}", f"{len(done)} of {len(ends)}", why, f"{statistics.median(steps):.0f} ({max(steps)})",
                     f"{statistics.median(s['cpu_seconds']['total'] for _, s in done):.1f}",
                     f"{len(sizes)}", f"{100 * statistics.median(sizes):.1f} %", f"{100 * sizes[-1]:.1f} %",
                     f"{sum(e > 0.03 for e in sizes)}"])
    return table(["mesh", "finish", "the others stop because", "steps, median (most)",
                  "CPU s", "compared", "off, median", "most", "above 3 %"], rows)


TABLES = {case: {"sweep": lambda case=case: sweep(case)} for case in SWEEPS}
