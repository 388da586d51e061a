"""Measures the tables of the READMEs of cases/rolling and, in planetary_tables.py, sheet_tables.py, sheet_sweeps.py and space_tables.py, planetary, bending, strip-rolling, u-channel, cup, leveller, roll-bending, ball, ball-rolling, burnishing, slab, block-upsetting, tilted-punch, plate-rolling, ring-rolling, of the manual's page thin-strips, and writes them there:

    make tables                          all of them, one run after the other: about half an hour
    make tables OPTIONS="rolling"        those of one README
    make tables OPTIONS="rolling:ways"    one table
    make tables OPTIONS="--keep"         takes runs of the same options that out/tables/ has already

A table stands between the lines <!-- table NAME --> and <!-- end -->; all between them is replaced. Runs are at the sizes
that the tables name, without pictures; CPU s is that of the FreeFEM process. A run that stops early is shown as such.
"""
import os
import re
import sys

import planetary_tables
import sheet_sweeps
import sheet_tables
import space_tables
from measured import Run, brief, off, run, table

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


# --- rolling ------------------------------------------------------------------------------------------------------
def rolling(options=""):
    r = run("rolling", options)
    r.depth, r.theta, r.moment = r.result("depth"), r.result("rotation"), r.result("moment Q_phi")
    return r


def numbers(r):
    signed = [f"{r.theta:.3f}", f"{r.moment:.1f}"]
    return [f"{r.depth:.2f}", *(x.replace("-", "−") for x in signed), f"{r.ep:.4f}"]


NUMBERS = ["depth µm", "θ deg", "Q_φ N·m/m", "ep"]


def rolling_steps():
    rows, runs = [], []
    for n in (50, 100, 200, 400):
        r = rolling("" if n == 100 else f"-steps {n} -width {n//5}")
        runs.append(r)
        rows.append([f"`-steps {n} -width {n//5}`" + (" (default)" if n == 100 else ""), r.steps, r.factorizations, *numbers(r), r.cpu])

    def against(a, b):
        return (f"depth {off(a.depth, b.depth)}, θ {off(a.theta, b.theta)}, Q_φ {off(a.moment, b.moment)}, "
                f"ep {off(a.ep, b.ep)}")
    return (table(["options", "steps", "factorizations", *NUMBERS, "CPU s"], rows) + "\n\n"
            f"The default against half its steps: {against(runs[1], runs[2])};\n"
            f"against the last row: {against(runs[1], runs[3])}.")


MESHES = [("P1", 10, 150, 20), ("P1", 20, 400, 40), ("P1", 40, 1200, 80), ("P2", 5, 75, 10), ("P2", 10, 150, 20),
          ("P2", 20, 300, 40)]


# sizes of the tables that compare schemes: seconds a run in place of minutes
MEDIUM = "-element P2 -inner 5 -outer 75 -sides 10"
COARSE = "-inner 4 -outer 40 -sides 8"


def on_mesh(element, inner, outer, sides):
    if (element, inner, outer, sides) == ("P2", 10, 150, 20):
        return rolling()
    return rolling(f"-element {element} -inner {inner} -outer {outer} -sides {sides}")


def rolling_mesh():
    rows = []
    for mesh in MESHES:
        r = on_mesh(*mesh)
        name = "{} {}/{}/{}".format(*mesh) + {MESHES[2]: " (the article's)", MESHES[4]: " (default)"}.get(mesh, "")
        rows.append([name, r.nodes, *numbers(r), r.factorizations, r.cpu])
    return table(["mesh inner/outer/sides", "nodes", *NUMBERS, "factorizations", "CPU s"], rows)


def rolling_integrator():
    rows = []
    for name, options in (("implicit, sub-stepped return (default)", ""),
                          ("implicit, single return, `-update single`", " -update single"),
                          ("the same, `-steps 800`", " -update single -steps 800"),
                          ("event, `-scheme event`", " -scheme event"),
                          ("implicit, `-tolerance 1e-8`", " -tolerance 1e-8")):
        r = rolling(MEDIUM + options)
        rows.append([name, r.steps, r.factorizations, *numbers(r), r.cpu])
    return table(["", "steps", "factorizations", *NUMBERS, "CPU s"], rows)


PHASES = ("assembly", "factorization", "solve", "condensation", "events", "checks", "output", "mesh")


def rolling_ways():
    single = f"{MEDIUM} -update single"
    own = rolling(single)
    rows = []
    for law, assembly, solver, options in (
            ("core", "core", "core", ""), ("core", "core", "UMFPACK", " -solver UMFPACK"), ("core", "core", "CHOLMOD", " -solver CHOLMOD"),
            ("script", "core", "core", " -forms 1 -assembly core"), ("script", "varf", "core", " -forms 1"),
            ("script", "varf", "UMFPACK", " -forms 1 -solver UMFPACK"), ("script", "varf", "CHOLMOD", " -forms 1 -solver CHOLMOD")):
        r = rolling(single + options)
        seconds = r.summary["cpu_seconds"]
        law_and_forms = seconds["total"] - sum(seconds[name] for name in PHASES)
        spent = [law_and_forms, seconds["assembly"], seconds["factorization"], seconds["solve"], seconds["condensation"],
                 seconds["events"] + seconds["checks"] + seconds["output"] + seconds["mesh"]]
        rows.append([law, assembly, solver, r.steps, r.counts["iterations"], r.factorizations, *numbers(r), r.cpu,
                     brief(seconds["total"]/own.summary["cpu_seconds"]["total"]), *(brief(s) for s in spent)])
    return table(["law", "assembly", "solver", "steps", "iterations", "factors", *NUMBERS, "CPU s", "times", "law, varfs, interpreter",
                  "assembly by the core", "factors", "solves", "condensing", "events, checks, files"], rows)


def outside(r):
    found = re.search(r"outside the yield surface by up to (\S+) %", r.log)
    return f"{float(found[1]):.0f} %" if found else "0"


def blind(r):
    found = re.search(r"factorizations, (\d+) changes of state without progress, (\d+) blind pieces", r.log)
    return f"{found[1]}, {found[2]}" if found else "-"


def pure_rates(runs, options, rules=False):
    """Runs of the article's scheme by name, side by side."""
    def line(name, give):
        return [name, *(give(r) for r in runs.values())]
    rows = [line("t reached", lambda r: f"{r.t:g}"),
            line("Q_θ reached (applied: 2000)", lambda r: f"{r.result('moment Q_theta'):.0f}"),
            line("−Q_r reached (applied: 750 000)", lambda r: f"{-1e3 * r.result('force Q_r'):.0f}"),
            line("−Q_φ", lambda r: f"{-r.moment:.0f}"),
            line("depth µm", lambda r: f"{r.depth:.1f}"),
            line("ep", lambda r: f"{r.ep:.3f}"),
            line("largest unbalanced force / load",
                 lambda r: "{:.1g}".format(r.summary["residual"]["last"] / r.summary["residual"]["load"])),
            line("stress outside the yield surface", outside),
            line("stick–slip events",
                 lambda r: r.counts["events"]["slip-to-stick"] + r.counts["events"]["stick-to-slip"]),
            line("factorizations", lambda r: r.factorizations),
            line("CPU s", lambda r: r.cpu)]
    if rules:
        rows.insert(-2, line("changes of state without progress, blind pieces", blind))
    rows.insert(0, ["options", *(f"`{o}`" if o else "" for o in options)])
    return table(["", *runs], rows)


def rolling_article():
    kinds = {"implicit": "", "article": "-scheme article", "complete terms": "-scheme article -terms complete",
             "no element events": "-scheme article -events none", "radial return": "-scheme article -update single"}
    return pure_rates({name: rolling(f"{COARSE} {options}".strip()) for name, options in kinds.items()},
                      [o.replace("-scheme article ", "") for o in kinds.values()])


def rolling_linear():
    """The article's elements."""
    runs, options = {}, []
    for inner, outer, sides in ((4, 40, 8), (5, 75, 10), (10, 150, 20)):
        mesh = f"-element P1 -inner {inner} -outer {outer} -sides {sides}"
        for name, option in (("implicit", ""), ("article", "-scheme article")):
            runs[f"{inner}/{outer}/{sides}: {name}"] = rolling(f"{mesh} {option}".strip())
            options.append(option)
    return pure_rates(runs, options, rules=True)


def rolling_rules():
    """The rule that leads a step out of a cycle of states, and its number."""
    base, numbers = f"-element P1 {COARSE} -scheme article", (1, 2, 4, 8, 20)
    runs = {f"{k} changes" + (" (default)" if k == 4 else ""): rolling(base + ("" if k == 4 else f" -retries {k}")) for k in numbers}
    runs["4, steps of half the length"] = rolling(base + " -steps 400")
    return pure_rates(runs, [*("" if k == 4 else f"-retries {k}" for k in numbers), "-steps 400"], rules=True)


def rolling_terms():
    runs = {"complete (default)": "", "none": " -terms none", "article": " -terms article"}
    rows = []
    for name, options in runs.items():
        r = rolling(COARSE + options)
        rows.append([name, r.steps, r.factorizations, *numbers(r), r.cpu])
    return table(["geometric terms, implicit steps", "steps", "factorizations", *NUMBERS, "CPU s"], rows)


def rolling_beside():
    default, article, fine = rolling(), on_mesh(*MESHES[2]), on_mesh(*MESHES[5])
    stress = 1e-8 * default.final["stress_eq_max"]
    rows = [["largest accumulated plastic strain", "≤ 0.25", f"{default.ep:.3f} (P2), {article.ep:.3f} (P1 40/1200/80)"],
            ["isolines of von Mises stress", "up to 3.5·10⁸ Pa, below the surface behind and under the contact",
             f"the same places; largest value at a point {stress:.1f}·10⁸ Pa"],
            ["agreement with ANSYS, quadratic triangles", "9–12 % in stress",
             f"P1 (the article's mesh) against P2 here: {off(article.depth, default.depth)} in depth, "
             f"{off(article.ep, default.ep)} in ep"],
            ["criterion of convergence", "10 % on halving the mesh",
             f"{off(default.depth, fine.depth)} in depth, {off(default.ep, fine.ep)} in ep (P2 10/150/20 to 20/300/40)"]]
    return table(["", "article", "here"], rows)


TABLES = {"rolling": {"steps": rolling_steps, "integrator": rolling_integrator, "ways": rolling_ways, "article": rolling_article,
                      "linear": rolling_linear, "rules": rolling_rules,
                      "terms": rolling_terms, "mesh": rolling_mesh, "beside": rolling_beside},
          "planetary": planetary_tables.TABLES,
          **{case: {**tables, **sheet_sweeps.TABLES.get(case, {})} for case, tables in sheet_tables.TABLES.items()},
          **space_tables.TABLES}


PAGES = {"thin-strips": "edp/manual/thin-strips.md"}  # tables of other texts than the case's README


def write(case, only):
    path = PAGES.get(case) or os.path.join("cases", case, "README.md")
    for name, measure in TABLES[case].items():
        if only and name != only:
            continue
        text = measure()
        with open(path, encoding="utf-8") as file:
            before = file.read()
        marked = re.compile(rf"(<!-- table {name} -->\n).*?(<!-- end -->)", re.S)
        if not marked.search(before):
            sys.exit(f"tables.py: {path} has no lines <!-- table {name} --> and <!-- end -->")
        with open(path, "w", encoding="utf-8") as file:
            file.write(marked.sub(lambda m: m[1] + text + "\n" + m[2], before))
        print(f"{path}: table {name}", flush=True)


def main(words):
    Run.keep = "--keep" in words
    cases = [w for w in words if w != "--keep"] or list(TABLES)
    for word in cases:
        case, _, name = word.partition(":")
        if case not in TABLES or name and name not in TABLES[case]:
            sys.exit(f"tables.py: no tables for \"{word}\", expected one of: {', '.join(TABLES)}, CASE:TABLE, --keep")
    os.chdir(TOP)
    for word in cases:
        case, _, name = word.partition(":")
        write(case, name)


if __name__ == "__main__":
    main(sys.argv[1:])
