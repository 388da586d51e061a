"""Pictures of the chart: work and precision with the Pareto front."""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 2, "cases"))
from plotting.figure import plt, save
from plotting.labels import log_ticks, place_labels
from plotting.maps import WHITE_EDGE
from report import MEANING, front

COLORS = {"implicit": "#08519c", "event": "#6baed6", "condensed": "#238b45", "penalty 1": "#fdbe85", "penalty 10": "#fd8d3c",
          "penalty 100": "#d94701", "multiplier": "#6a3d9a", "augmented": "#c51b8a", "CalculiX": "#000000", "Ipopt": "#8c6d31"}
MARKERS = {"P1": "o", "P2": "s"}


def placed(path):
    """Folder and name without its ending."""
    folder, name = os.path.split(path)
    return folder, os.path.splitext(name)[0]


def panel(ax, rows, quantity):
    """Returns the labels of the front."""
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
    names = "\n".join(f"{k}  {r['method']}, {r['element']}, {r['n']}{', ' + str(r['dtsteps']) if r['dtsteps'] else ''}" for k, r in enumerate(best, 1))
    ax.text(1.02, 1, "front: method,\nelement, n" + (", steps" if most else "") + "\n" + names, transform=ax.transAxes, fontsize=10, va="top")
    ax.set_xscale("log")
    ax.set_yscale("log")
    low, high = min(100 * r[quantity] for r in rows), max(100 * r[quantity] for r in rows)
    ax.set_ylim(max(low, 1e-5 * high) / 1.6, 1.6 * high)
    for axis in (ax.xaxis, ax.yaxis):
        log_ticks(axis)
    ax.grid(True, which="major", color="0.92", lw=0.6)
    ax.tick_params(labelsize=10)
    ax.set_title(MEANING.get(quantity, quantity), fontsize=12)
    ax.set_ylabel("error [%]", fontsize=11)
    ax.set_xlabel("CPU time [s]", fontsize=11)
    return [(r["seconds"], 100 * r[quantity], str(k), "k") for k, r in enumerate(best, 1)]


def chart(rows, quantities, path):
    """One panel for each quantity; a line is a method and element over its meshes, the gray band the Pareto front."""
    columns = 2
    lines = (len(quantities) + 1) // columns
    fig, axes = plt.subplots(lines, columns, figsize=(13, 4.3 * lines + 0.7), squeeze=False)
    labels = [(ax, panel(ax, rows, quantity)) for ax, quantity in zip(axes.flat, quantities)]
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
    for ax, mine in labels:
        place_labels(ax, mine, 11, mark=6, weight="bold", path_effects=WHITE_EDGE)
    save(fig, *placed(path))
