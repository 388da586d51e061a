"""Pictures of the chart: work and precision with the Pareto front, and the matrices."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

from report import MEANING, front

COLORS = {"implicit": "#08519c", "event": "#6baed6", "condensed": "#238b45", "penalty 1": "#fdbe85", "penalty 10": "#fd8d3c",
          "penalty 100": "#d94701", "multiplier": "#6a3d9a", "augmented": "#c51b8a", "CalculiX": "#000000", "Ipopt": "#8c6d31"}
APART = 3.2  # lines of text on the axis of condition numbers
MARKERS = {"P1": "o", "P2": "s"}


def panel(ax, rows, quantity):
    lines = {}
    for r in rows:
        lines.setdefault((r["method"], r["element"], r["dtsteps"]), []).append(r)
    most = max(r["dtsteps"] for r in rows)
    for (method, element, steps), mine in lines.items():
        mine.sort(key=lambda r: r["n"])
        x, y = [r["seconds"] for r in mine], [100 * r[quantity] for r in mine]
        ax.errorbar(x, y, xerr=[r["spread"] * r["seconds"] for r in mine], fmt=MARKERS[element] + (":" if element == "P1" else "-"),
                    ms=4.5, lw=1, color=COLORS.get(method, "k"), mfc="w" if element == "P1" else None, capsize=2, elinewidth=0.7,
                    alpha=1 if steps == most else 0.45)
    best = front(rows, quantity)
    ax.plot([r["seconds"] for r in best], [100 * r[quantity] for r in best], color="0.8", lw=6, zorder=0)
    for k, r in enumerate(best, 1):
        ax.annotate(str(k), (r["seconds"], 100 * r[quantity]), fontsize=10, xytext=(-4, -4), textcoords="offset points",
                    ha="right", va="top", weight="bold")
    names = "\n".join(f"{k}  {r['method']}, {r['element']}, {r['n']}{', ' + str(r['dtsteps']) if r['dtsteps'] else ''}" for k, r in enumerate(best, 1))
    ax.text(1.02, 1, "front: method,\nelement, n" + (", steps" if most else "") + "\n" + names, transform=ax.transAxes, fontsize=10, va="top")
    ax.set_xscale("log")
    ax.set_yscale("log")
    low, high = min(100 * r[quantity] for r in rows), max(100 * r[quantity] for r in rows)
    ax.set_ylim(max(low, 1e-5 * high) / 1.6, 1.6 * high)
    for axis, wide in ((ax.xaxis, False), (ax.yaxis, high > 300 * max(low, 1e-9))):
        axis.set_major_locator(LogLocator(subs=(1,) if wide else (1, 2, 5)))
        axis.set_major_formatter(FormatStrFormatter("%g"))
        axis.set_minor_formatter(NullFormatter())
    ax.grid(True, which="major", color="0.92", lw=0.6)
    ax.tick_params(labelsize=10)
    ax.set_title(MEANING.get(quantity, quantity), fontsize=12)
    ax.set_ylabel("error [%]", fontsize=11)
    ax.set_xlabel("CPU time [s]", fontsize=11)


def chart(rows, quantities, path):
    """One panel for each quantity; a line is a method and element over its meshes, the gray band the Pareto front."""
    columns = 2
    lines = (len(quantities) + 1) // columns
    fig, axes = plt.subplots(lines, columns, figsize=(13, 4.3 * lines + 0.7), squeeze=False)
    for ax, quantity in zip(axes.flat, quantities):
        panel(ax, rows, quantity)
    for ax in list(axes.flat)[len(quantities):]:
        ax.axis("off")
    handles = [plt.Line2D([], [], color=COLORS.get(m, "k"), lw=2, label=m) for m in dict.fromkeys(r["method"] for r in rows)]
    handles += [plt.Line2D([], [], color="0.5", marker=MARKERS[e], ls=s, mfc="w" if e == "P1" else "0.5", label=e)
                for e, s in (("P1", ":"), ("P2", "-"))]
    if len({r["dtsteps"] for r in rows}) > 1:
        handles.append(plt.Line2D([], [], color="k", alpha=0.45, label="pale: fewer steps"))
    handles.append(plt.Line2D([], [], color="0.8", lw=6, label="Pareto front, steps of 10 % and more"))
    fig.legend(handles=handles, loc="lower center", ncol=6, fontsize=11, frameon=False)
    fig.tight_layout(rect=(0, 1 / fig.get_figheight(), 1, 1))
    fig.savefig(path, dpi=120)
    plt.close(fig)


def condition_lines(ax, groups, along, title):
    """Full lines: as handed to the solver; dashed: after scaling."""
    said = []
    for name, rows in groups.items():
        rows = sorted(rows, key=lambda r: float(r[along]))
        x = [float(r[along]) for r in rows]
        color = COLORS.get(name.split(",")[0], "k")
        marker = "s" if "P2" in name else "o"
        ax.plot(x, [r["condition"] for r in rows], "-" + marker, color=color, ms=4, label=name)
        ax.plot(x, [r["condition_scaled"] for r in rows], "--" + marker, color=color, ms=4, mfc="w")
        if rows[-1]["element"] == "P1":
            said.append((rows[-1]["condition"], x[-1], f"{rows[-1]['zero_diagonal']} zeros, {rows[-1]['negative']} negative", color))
    height = 0
    for y, right, text, color in sorted(said):  # none on another
        height = max(1.3 * y, APART * height)
        ax.annotate(text, (right, height), fontsize=9.5, ha="right", color=color)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_title(title, fontsize=12)
    ax.tick_params(labelsize=10)
    ax.grid(True, color="0.9", lw=0.6)
    ax.set_ylabel("condition number [-]", fontsize=11)


def by(rows, name):
    groups = {}
    for r in rows:
        groups.setdefault(name(r), []).append(r)
    return groups


def matrices(rows, path):
    fig, (left, right) = plt.subplots(1, 2, figsize=(11, 5.2), sharey=True)
    condition_lines(left, by([r for r in rows if r["own"]], lambda r: f"{r['method']}, {r['element']}"), "n",
                    "against the mesh")
    meshes = sorted({r["n"] for r in rows})
    left.set_xticks(meshes, meshes)
    left.xaxis.set_minor_formatter(NullFormatter())
    left.set_xlabel("divisions of the half-width n [-]")
    swept = [r for r in rows if r["factor"] != "" and r["element"] == "P1"]
    n = max((r["n"] for r in swept), key=lambda k: sum(r["n"] == k for r in swept))
    condition_lines(right, by([r for r in swept if r["n"] == n], lambda r: f"{r['method']}, P1"), "factor",
                    f"against the penalty factor, P1, n = {n}")
    for method in dict.fromkeys(r["method"] for r in rows if r["factor"] == ""):
        same = [r for r in rows if (r["method"], r["element"], r["n"]) == (method, "P1", n)]
        for r in same:
            right.axhline(r["condition"], color=COLORS.get(method, "k"), lw=1, label=f"{method}, P1")
            right.axhline(r["condition_scaled"], color=COLORS.get(method, "k"), lw=1, ls="--")
    right.set_xlabel("penalty factor over the stiffness of the surface [-]")
    left.set_ylim(None, 1000 * max(r["condition"] for r in rows))
    left.legend(fontsize=9.5, frameon=False, loc="upper left", ncol=2)
    handles = [plt.Line2D([], [], color="k", ls="-", label="as handed to the solver"),
               plt.Line2D([], [], color="k", ls="--", label="after scaling")]
    right.legend(handles=handles, fontsize=9.5, frameon=False, loc="upper left")
    fig.tight_layout()
    fig.savefig(path, dpi=120)
    plt.close(fig)
