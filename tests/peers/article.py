"""The article's comparison with ANSYS repeated with CalculiX: example 1, isolines of the von Mises stress, table of README.md.

article.py [-n N] [--store]     linear triangles on one mesh by both, quadratic ones by ours; n: divisions of the outer arc
An isoline of the article's figures 2 and 3 encloses some area, where the stress is higher. The level whose isoline encloses as much in
another result is what its figures 4 and 5 are compared by there: it says the levels differ by 9 to 12 %.
"""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "chart"))
from bench import store  # noqa: E402
from scene_files import areas, installed, methods, run, scenes  # noqa: E402

# 1e8 Pa, figures 2 to 5
ARTICLE, ANSYS = (0.43, 0.87, 1.3, 1.73, 2.2, 2.6, 3.0, 3.5), (0.4, 0.8, 1.2, 1.55, 2.5, 2.9, 3.3, 3.9)
DENSE, STEPS = "4", "100"
ROLL = ["-roll", "0.5"]  # of CalculiX: runs on this mesh, not on coarse ones
LONGEST = 3000  # [s] of a run
CLOSE, LEAST = 0.1, 0.1  # relative difference; over the largest stress


def same_area(level, stress, other, area):
    """Level of the other field that encloses as much area as this level of the first."""
    enclosed, reached = sum(a for q, a in zip(stress, area) if q > level), 0
    for q, a in sorted(zip(other, area), reverse=True):
        reached += a
        if reached >= enclosed:
            return q if enclosed > 0 else float("nan")
    return min(other)


def near(stress, other, area):
    """Share of the area where the fields differ by less than CLOSE, of that where the first is not small."""
    counted = [(abs(q - o) < CLOSE * q, a) for q, o, a in zip(stress, other, area) if q > LEAST * max(stress)]
    return sum(a for close, a in counted if close) / sum(a for _, a in counted)


def levels(base, others, area):
    head = ["Isoline, 10⁸ Pa: article", "ANSYS", "differs"] + [w for name in others for w in (name, "differs")]
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    for a, b in zip(ARTICLE, ANSYS):
        cells = [f"{a:g}", f"{b:g}", f"{100 * (b / a - 1):+.0f} %"]
        for found in others.values():
            q = same_area(1e8 * a, base["fields"]["stress"], found["fields"]["stress"], area) / 1e8
            cells += [f"{q:.2f}", f"{100 * (q / a - 1):+.1f} %"] if q == q else ["-", "none so high"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def numbers(runs, base, area):
    lines = ["|  | " + " | ".join(runs) + " |", "|---" * (len(runs) + 1) + "|"]

    def row(name, give):
        lines.append(f"| {name} | " + " | ".join(give(r) for r in runs.values()) + " |")
    row("outcome", lambda r: r["outcome"])
    row("depth µm", lambda r: f"{1e6 * r['depth_4']:.2f}")
    row("rotation rad", lambda r: f"{r['rotation_4']:.4f}")
    row("moment about the pivot N·m/m", lambda r: f"{r['torque_4']:.0f}")
    row("contact from, to mm", lambda r: f"{1e3 * r['end_1']:.2f}, {1e3 * r['end_2']:.2f}")
    row("plastic strain: 99 %, largest at a node", lambda r: f"{r['p99_4']:.4f}, {r['nodal_4']:.4f}")
    row("von Mises stress: 99 %, largest in the points, 10⁸ Pa",
        lambda r: f"{1e-8 * r['stress99_4']:.3f}, {1e-8 * max(r['fields']['stress']):.2f}")
    row("within 10 % of the first, share of the area",
        lambda r: f"{100 * near(base['fields']['stress'], r['fields']['stress'], area):.1f} %")
    row("steps, factorizations", lambda r: f"{r['steps']:.0f}, {r['factorizations']:.0f}")
    row("CPU s", lambda r: f"{r['seconds']:.1f}")
    return lines


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("-n", type=int, default=150)
    parser.add_argument("--store", action="store_true", help="tables into README.md")
    options = parser.parse_args()
    scene = next(s for s in scenes() if s["name"] == "rolling")
    known = {m["name"]: m for m in methods()}
    if not installed(known["CalculiX"]):
        sys.exit("article.py: CalculiX is not installed")
    given, runs = ["-n", str(options.n), "-steps", STEPS, "-dense", DENSE], {}
    for element, method in (("P1", "implicit"), ("P1", "CalculiX"), ("P2", "implicit")):
        name = f"{'Burnish' if method == 'implicit' else method}, {element}"
        extra = ROLL if known[method]["program"] else []
        runs[name] = run(scene, [*known[method]["options"], "-element", element, *given, *extra], known[method]["program"], LONGEST)
        print(f"{name}: {runs[name]['outcome']}, {runs[name]['seconds']:.1f} s", flush=True)
    base, area = next(iter(runs.values())), areas(scene, ["-dense", DENSE])
    others = {name: r for name, r in runs.items() if r is not base}
    lines = [f"Outer arc in {options.n} divisions:", "", *levels(base, others, area), "", *numbers(runs, base, area)]
    print("\n".join(lines))
    if options.store:
        store(lines, "article")


if __name__ == "__main__":
    main()
