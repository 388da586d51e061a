"""A few runs of the chart's scenes on coarse meshes: methods against our own on the same mesh, ours against the references.

Bounds are on relative errors, from what the runs give, times two to three; speeds are not looked at. Run by tests/regression/chart.sh."""
import sys

from scene_files import curve_error, field_error, methods, read_curves, read_fields, read_references, run, scenes

# scene, element, n, steps; bound of ours against the references: quantity, largest; of other methods against ours
RUNS = [
    ("partial-slip", "P1", 6, 2, "condensed", {"depth_2": 0.03, "depth_4": 0.03, "shift_4": 0.03, "pressure": 0.15, "traction": 0.35},
     {"multiplier": 1e-6, "augmented": 1e-4, "penalty 100": 1e-3}),
    ("ball", "P1", 4, 1, "implicit", {"depth": 0.1}, {"multiplier": 1e-6, "augmented": 1e-5, "penalty 100": 0.01}),
    ("ball", "P2", 4, 1, "implicit", {"depth": 0.01}, {"condensed": 1e-5, "penalty 100": 0.005, "multiplier": 0.005}),
    ("indentation", "P1", 10, 10, "implicit", {"depth_1": 0.1, "depth_2": 0.1, "depth_3": 0.1, "width": 0.1},
     {"multiplier": 0.002, "augmented": 0.002, "penalty 100": 0.002}),
    ("indentation", "P2", 20, 10, "implicit", {"depth_1": 0.01, "depth_2": 0.01, "depth_3": 0.015, "width": 0.01},
     {"condensed": 0.03, "implicit, graded": 0.015, "implicit, accuracy": 0.015}),
    ("rolling", "P1", 30, 40, "implicit", {"rotation_2": 0.05, "rotation_4": 0.05, "torque_4": 0.2}, {"multiplier": 0.002}),
    ("rolling", "P2", 24, 24, "implicit, graded", {"depth_1": 0.07, "depth_2": 0.02, "depth_3": 0.02, "depth_4": 0.04, "torque_4": 0.02},
     {"implicit, accuracy": 0.05, "condensed, graded": 0.05}),
]


def main():
    known, references = {m["name"]: m for m in methods()}, read_references()
    curves, fields = read_curves(), read_fields()
    failed = checked = 0

    def check(what, error, bound):
        nonlocal failed, checked
        checked += 1
        if not error <= bound:
            failed += 1
        print(f"{'ok    ' if error <= bound else 'FAILED'} {what}: off by {error:.2g}, allowed {bound:g}")

    for name, element, n, steps, own, bounds, rivals in RUNS:
        scene = next(s for s in scenes() if s["name"] == name)
        options = ["-element", element, "-n", str(n), "-steps", str(steps)]
        ours = run(scene, known[own]["options"] + options)
        check(f"{name}, {own}, finished", ours["outcome"] != "finished", 0)
        for quantity, bound in bounds.items():
            off = (field_error(ours["fields"][quantity], fields[name, quantity]) if quantity in ours["fields"]
                   else curve_error(ours["curves"][quantity], curves[name, quantity]) if quantity in ours["curves"]
                   else abs(ours[quantity] / references[name, quantity][0] - 1))
            check(f"{name}, {own}: {quantity}", off, bound)
        for rival, bound in rivals.items():
            found = run(scene, known[rival]["options"] + options)
            check(f"{name}, {rival}, finished", found["outcome"] != "finished", 0)
            for quantity in [q for q in bounds if q in ours]:
                check(f"{name}, {rival} against {own}: {quantity}", abs(found[quantity] / ours[quantity] - 1), bound)
    print(f"{checked} checks, {failed} failed")
    sys.exit(failed > 0 or checked < 70)


if __name__ == "__main__":
    main()
