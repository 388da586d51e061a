"""Example 1 with the steps halved:  python3 rolling_halved.py FOLDER [--store]
Compares with the numbers of tests/regression/rolling-halved.json, ten times closer than these are used there; --store
replaces them (SCRATCH=out PYTHON=python3 BURNISH=build/burnish tests/long/rolling-halved.sh --store)."""
import json
import os
import sys
from run import Checks, Run

STORED = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "regression", "rolling-halved.json")
run = Run(sys.argv[1])
values = run.values()
if "--store" in sys.argv:
    about = "cases/rolling -steps 200 -width 40 at t = 1; depth m, theta rad, Q_phi N m/m, stress Pa, angles degrees"
    with open(STORED, "w") as f:
        json.dump({"about": about, "values": values}, f, indent=1)
        f.write("\n")
with open(STORED) as f:
    stored = json.load(f)["values"]
checks = Checks()
for key, tolerance in (("theta", 0.0002), ("Q_phi", 0.0005), ("depth", 0.001), ("plastic_strain_eq_max", 0.004)):
    checks.near(key, values[key], stored[key], tolerance)
worst = run.largest_imbalance(7.5e5, 2e3, 15e-3)
checks.that("resultants", worst <= 1.1e-4, f"largest imbalance over all steps {worst:.2e} of the load")
checks.done()
