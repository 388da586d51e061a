"""Pictures of the chart: work and precision with the Pareto front."""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 2, "cases"))
from matplotlib.lines import Line2D
from plotting.figure import new_figure, save
from plotting.labels import log_ticks, place_labels
from plotting.maps import WHITE_EDGE
from report import MEANING, front

COLORS = {"implicit": "#08519c", "implicit, default": "#00b8b8", "implicit, graded": "#8c2d04", "implicit, accuracy": "#e31a1c",
          "event": "#6baed6", "condensed": "#238b45", "condensed, graded": "#66c2a4", "penalty 1": "#fdbe85", "penalty 10": "#fd8d3c",
          "penalty 100": "#d9a400", "multiplier": "#6a3d9a", "augmented": "#c51b8a", "CalculiX": "#000000", "CalculiX, nodes": "#7f7f7f",
          "Ipopt": "#8c6d31"}
MARKERS = {"P1": "o", "P2": "s"}
MOST = 300  # [%] shown
WIDE = 8.2  # [inches] of a picture of one panel: read at half its size, its fonts are larger


def placed(path):
    """Folder and name without its ending."""
    folder, name = os.path.split(path)
    return folder, os.path.splitext(name)[0]


def curves(ax, rows, quantity):
    """A line for each method and element over its meshes; pale with fewer steps than its most."""
    lines, most = {}, {}
    for r in rows:
        lines.setdefault((r["method"], r["element"], r["dtsteps"]), []).append(r)
        most[r["method"]] = max(most.get(r["method"], 0), r["dtsteps"])
    for (method, element, steps), mine in lines.items():
        mine.sort(key=lambda r: r["n"])
        x, y = [r["seconds"] for r in mine], [100 * r[quantity] for r in mine]
        ax.errorbar(x, y, xerr=[r["spread"] * r["seconds"] for r in mine], fmt=MARKERS[element] + (":" if element == "P1" else "-"),
                    ms=5.5, lw=1.4, color=COLORS.get(method, "k"), mfc="w" if element == "P1" else None, capsize=2, elinewidth=0.7,
                    alpha=1 if steps == most[method] else 0.45)


def key(best):
    """The front in words, one line each."""
    return [f"{k}  {r['method']}, {r['element']}, {r['n']}{', ' + str(r['dtsteps']) if r['dtsteps'] else ''}" for k, r in enumerate(best, 1)]


def panel(ax, rows, quantity, size):
    """Returns the front and its labels; size: of the fonts."""
    curves(ax, rows, quantity)
    best = front(rows, quantity)
    ax.plot([r["seconds"] for r in best], [100 * r[quantity] for r in best], color="0.8", lw=8, zorder=0)
    ax.set_xscale("log")
    ax.set_yscale("log")
    low, high = min(100 * r[quantity] for r in rows), min(MOST, max(100 * r[quantity] for r in rows))
    ax.set_ylim(max(low, 1e-5 * high) / 1.6, 1.6 * high)
    for axis in (ax.xaxis, ax.yaxis):
        log_ticks(axis)
    ax.grid(True, which="major", color="0.92", lw=0.6)
    ax.tick_params(labelsize=size - 1)
    ax.set_title(MEANING.get(quantity, quantity), fontsize=size + 1)
    ax.set_ylabel("error [%]", fontsize=size)
    ax.set_xlabel("CPU time [s]", fontsize=size)
    return best, [(r["seconds"], 100 * r[quantity], str(k), "k") for k, r in enumerate(best, 1)]


def keys(rows):
    handles = [Line2D([], [], color=COLORS.get(m, "k"), lw=3, label=m) for m in COLORS if any(r["method"] == m for r in rows)]
    handles += [Line2D([], [], color="0.5", marker=MARKERS[e], ls=s, mfc="w" if e == "P1" else "0.5", label=e)
                for e, s in (("P1", ":"), ("P2", "-"))]
    if len({(r["method"], r["dtsteps"]) for r in rows}) > len({r["method"] for r in rows}):
        handles.append(Line2D([], [], color="k", alpha=0.45, label="pale: fewer steps"))
    return handles + [Line2D([], [], color="0.8", lw=8, label="Pareto front")]


def single(rows, quantity, path):
    """One panel; the front below it."""
    fig, ax = new_figure(WIDE, 0.9 * WIDE)
    best, labels = panel(ax, rows, quantity, 16)
    words = key(best)
    lines = (len(words) + 1) // 2
    steps = ", steps" if any(r["dtsteps"] for r in rows) else ""
    below = 0.3 * (lines + 1) / fig.get_figheight()
    fig.text(0.02, below - 0.01, f"front: method, element, n{steps}", fontsize=14, va="top")
    for column in (0, 1):
        fig.text(0.02 + 0.5 * column, below * lines / (lines + 1), "\n".join(words[column * lines:(column + 1) * lines]), fontsize=14, va="top")
    handles = keys(rows)
    above = 0.24 * ((len(handles) + 2) // 3) / fig.get_figheight()
    fig.legend(handles=handles, loc="upper center", ncol=3, fontsize=13, frameon=False, labelspacing=0.2)
    fig.tight_layout(rect=(0, below, 1, 1 - above - 0.02))
    place_labels(ax, labels, 17, mark=8, weight="bold", path_effects=WHITE_EDGE)
    save(fig, *placed(path))


def several(rows, quantities, path):
    """One panel for each quantity, the front beside it."""
    columns = 2
    lines = (len(quantities) + 1) // columns
    fig, axes = new_figure(13, 4.3 * lines + 0.7, nrows=lines, ncols=columns, squeeze=False)
    steps = ", steps" if any(r["dtsteps"] for r in rows) else ""
    found = []
    for ax, quantity in zip(axes.flat, quantities):
        best, labels = panel(ax, rows, quantity, 11)
        ax.text(1.02, 1, f"front: method,\nelement, n{steps}\n" + "\n".join(key(best)), transform=ax.transAxes, fontsize=10, va="top")
        found.append((ax, labels))
    for ax in list(axes.flat)[len(quantities):]:
        ax.axis("off")
    fig.legend(handles=keys(rows), loc="lower center", ncol=6, fontsize=11, frameon=False)
    fig.tight_layout(rect=(0, 1.1 / fig.get_figheight(), 1, 1))
    for ax, mine in found:
        place_labels(ax, mine, 11, mark=6, weight="bold", path_effects=WHITE_EDGE)
    save(fig, *placed(path))


def chart(rows, quantities, path):
    """The gray band is the Pareto front, in steps of 10 % and more."""
    if len(quantities) == 1:
        single(rows, quantities[0], path)
    else:
        several(rows, quantities, path)
