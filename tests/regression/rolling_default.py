"""Example 1 on the default mesh: python3 rolling_default.py FOLDER
rolling-halved.json: its numbers with the steps halved, made and compared by tests/long/rolling-halved.sh."""
import csv
import json
import os
import sys
from run import HEADER, Checks, Run

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "support"))
from picture import faults

default = Run(sys.argv[1])
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "rolling-halved.json")) as f:
    halved = json.load(f)["values"]
checks = Checks()
counts = default.summary["counts"]
checks.that("header", default.header == HEADER, default.header)
checks.that("factorizations", counts["factorizations"] <= 340, f"{counts['factorizations']}, allowed 340")
a = default.values()
for key, tolerance in (("theta", 0.002), ("Q_phi", 0.005), ("depth", 0.01), ("plastic_strain_eq_max", 0.04)):
    checks.near("halving the steps, " + key, a[key], halved[key], tolerance)
checks.that("plastic strain", a["plastic_strain_eq_max"] < 0.25, f"{a['plastic_strain_eq_max']:.4f}, article: at most 0.25")
checks.that("stress", a["stress_eq_max"] > 3.5e8, f"largest {a['stress_eq_max']:.4g} Pa, isolines at 3.5e8 Pa exist")
name, most = default.events_per_node().most_common(1)[0]
checks.that("no chatter", most <= 10, f"node {name} changes its state {most} times, allowed 10")
worst = default.largest_imbalance(7.5e5, 2e3, 15e-3)
checks.that("resultants", worst <= 1.1e-4, f"largest imbalance over all steps {worst:.2e} of the load")
def variation(column):
    """Total variation over twice the maximum: 1 for one rise and one fall."""
    with open(os.path.join(sys.argv[1], "surface.csv")) as file:
        values = [float(row[column]) for row in csv.DictReader(file)]
    return sum(abs(b - a) for a, b in zip(values, values[1:])) / (2 * max(values))


for column, most in (("pressure", 1.1), ("traction_tangential", 1.4)):
    found = variation(column)
    checks.that("total variation of " + column, found <= most, f"{found:.3f}, allowed {most}; of nodal forces over lengths 2.8 and 5.5")
for key in ("steps", "rejected_steps", "factorizations", "solves", "events"):
    checks.that("summary counts " + key, key in counts, str(counts.get(key)))
for phase in ("mesh", "assembly", "condensation", "factorization", "solve", "events", "stress update", "output", "total"):
    checks.that("summary seconds " + phase, phase in default.summary["cpu_seconds"], str(default.summary["cpu_seconds"].get(phase)))
for name in ("final.vtu", "fields.pvd", "surface.csv"):
    path = os.path.join(sys.argv[1], name)
    size = os.path.getsize(path) if os.path.exists(path) else 0
    checks.that("file " + name, size > 500, f"{size} bytes")
for name in ("final", "stress-below-yield", "stress-above-yield", "plastic-strain", "tool-histories", "pressure",
             "surface-profile", "events"):
    wrong = faults(os.path.join(sys.argv[1], name + ".png"))
    checks.that("picture " + name, not wrong, "; ".join(wrong) or "something is drawn")
checks.done()
