"""Reads the folder of a rolling run. Used by the regression tests; run as  python3 run.py FOLDER  it prints the numbers."""
import collections
import csv
import json
import os
import sys

HEADER = ("t,r,phi,theta,Q_r,Q_phi,Q_theta,contact_begin_deg,contact_end_deg,sticking,sliding,"
          "stress_eq_max,plastic_strain_eq_max,factorizations,support_Fx,support_Fy,support_Mz,roller_Fx,roller_Fy,roller_Mz")


class Run:
    """Final numbers, history and events of one run."""

    def __init__(self, folder):
        with open(os.path.join(folder, "summary.json")) as f:
            self.summary = json.load(f)
        with open(os.path.join(folder, "history.csv")) as f:
            self.header = f.readline().strip()
            f.seek(0)
            self.history = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(f)]
        with open(os.path.join(folder, "events.csv")) as f:
            self.events = list(csv.DictReader(f))

    def values(self):
        final, last = self.summary["final"], self.history[-1]
        return {"depth": self.history[0]["r"] - last["r"], "theta": last["theta"], "Q_phi": last["Q_phi"],
                "plastic_strain_eq_max": final["plastic_strain_eq_max"], "stress_eq_max": final["stress_eq_max"],
                "contact_begin_deg": last["contact_begin_deg"], "contact_end_deg": last["contact_end_deg"]}

    def events_per_node(self):
        return collections.Counter(e["node"] for e in self.events)

    def largest_imbalance(self, F0, M0, R):
        """Largest |Q - program| over lever arm and end load, over all accepted steps."""
        worst = 0
        for row in self.history:
            worst = max(worst, abs(row["Q_r"] + F0 * row["t"]), abs(row["Q_theta"] - M0 * row["t"]) / R)
        return worst / F0


class Checks:
    """Collects comparisons; prints each, exits with 1 if one failed."""

    def __init__(self):
        self.failed = 0

    def that(self, name, ok, text):
        print(f"{'ok  ' if ok else 'FAIL'} {name}: {text}")
        self.failed += not ok

    def near(self, name, computed, expected, relative):
        error = abs(computed - expected) / abs(expected)
        self.that(name, error <= relative, f"computed {computed:.7g}, expected {expected:.7g}, error {100 * error:.3f} %, "
                                           f"allowed {100 * relative:g} %")

    def done(self):
        sys.exit(1 if self.failed else 0)


if __name__ == "__main__":
    print(json.dumps(Run(sys.argv[1]).values(), indent=1))
