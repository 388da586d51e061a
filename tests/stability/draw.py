"""Pictures of the map: one of all dangers and methods, and one of each danger."""
import os
import re
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 2, "cases"))
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle
from plotting.figure import new_figure, save

# from the best outcome to the worst
COLORS = {"right": "#3a9b5c", "detected": "#f2c14e", "slow": "#b0b0b0", "unnamed": "#e07b28", "silent": "#9b1c16", "failed": "#000000"}
MARKERS = {"right": "o", "detected": "X", "slow": "P", "unnamed": "D", "silent": "s", "failed": "v"}


LINE, WORDS = 0.36, 9  # height of a danger [inches], size of letters
LEFT, CELL, RIGHT = 2.0, 0.7, 4.5  # widths of names, of a method, of what stands behind [inches]


def label(method):
    return f"{method[0].replace('penalty', 'penalty' + chr(10))}\n{method[1]}"


def save_as(fig, path):
    folder, name = os.path.split(path)
    save(fig, folder, os.path.splitext(name)[0])


def say_below(fig, rows, ours, rivals):
    """What the colors mean and how often they are there, in inches from the lower edge."""
    mine = [r["outcome"] for r in rows if (r["scheme"], r["element"]) in ours]
    others = [r["outcome"] for r in rows if (r["scheme"], r["element"]) in rivals]
    height = fig.get_figheight()
    patches = [Patch(color=COLORS[n], label=f"{n}: ours {mine.count(n)}, rivals {others.count(n)}") for n in COLORS]
    fig.legend(handles=patches, loc="upper center", ncol=3, frameon=False, fontsize=10,
               bbox_to_anchor=(0.5, 1.35 / height))
    for k, text in enumerate(("right: within its tolerance, behind the line.  detected: refused, stopped or warned, and the cause of this "
                              "danger is named.  unnamed: refused, stopped or not trusted for another cause.",
                              "silent: wrong without a word.  slow: more than 15 s by the article's literal scheme or a rival; "
                              "what the article needs stands behind, ~ by the share done.",
                              "white: not asked.  In a cell from left to right: the values behind the line.")):
        fig.text(0.5, (0.6 - 0.2 * k) / height, text, ha="center", fontsize=10)


def tolerances(rows):
    """What the verdicts of these runs allow, in words."""
    said = dict.fromkeys(r["allowed"] for r in rows if r["allowed"])
    return max(said, key=len) if said else "there is no answer"


def needed(rows):
    """Seconds of the shortest and the longest run, ~: an estimate."""
    times = sorted((float(r["needs"]), r["outcome"] == "slow") for r in rows if r["needs"])
    words = [("~" if estimated else "") + (f"{seconds:.2g}" if seconds < 99.5 else f"{seconds:.0f}")
             for seconds, estimated in times[:1] + times[-1:]]
    if any(r["outcome"] == "slow" and not r["needs"] for r in rows):
        words = words[:1] + ["> 15"]  # of one nothing is known, not a step was accepted
    return " to ".join(dict.fromkeys(words)) + " s" if words else ""


def draw_cells(ax, place, danger, outcomes):
    """The values of a sweep from left to right; None: not asked."""
    width = 0.94 / len(outcomes)
    for k, outcome in enumerate(outcomes):
        if outcome:
            ax.add_patch(Rectangle((place + 0.03 + k * width, danger + 0.12), 0.92 * width, 0.76, color=COLORS[outcome], lw=0))


def draw_map(dangers, ours, rivals, rows, path):
    """Dangers down, methods across, ours first; a cell is divided into the values of its sweep, from left to right."""
    by = {(r["danger"], r["scheme"], r["element"], r["x"]): r["outcome"] for r in rows}
    methods = [*ours, *rivals]
    wide = LEFT + CELL * len(methods) + RIGHT
    fig, ax = new_figure(wide, 2.1 + LINE * len(dangers))
    for i, d in enumerate(dangers):
        for j, method in enumerate(methods):
            draw_cells(ax, j, i, [by.get((d["name"], *method, x)) for x in d["values"]])
        mine = [r for r in rows if r["danger"] == d["name"]]
        ax.text(len(methods) + 0.08, i + 0.3, f"{d['meaning']}: {', '.join(d['values'])}", va="center", fontsize=WORDS)
        ax.text(len(methods) + 0.08, i + 0.72, tolerances(mine), va="center", fontsize=WORDS - 1, color="0.35")
        ax.text(len(methods) + RIGHT / CELL - 0.1, i + 0.5, needed([r for r in mine if r["scheme"] == "article"]), va="center",
                ha="right", fontsize=WORDS)
    ax.text(len(methods) + 0.08, -0.15, "values, and what is allowed", va="bottom", fontsize=WORDS)
    ax.text(len(methods) + RIGHT / CELL - 0.1, -0.15, "the article needs", va="bottom", ha="right", fontsize=WORDS)
    ax.axvline(len(ours), color="0.4", lw=1)
    ax.set_xlim(0, len(methods))
    ax.set_ylim(len(dangers), 0)
    ax.set_xticks([j + 0.5 for j in range(len(methods))], [label(m) for m in methods], fontsize=WORDS - 1)
    ax.xaxis.tick_top()
    ax.set_yticks([i + 0.5 for i in range(len(dangers))], [d["name"] for d in dangers], fontsize=WORDS)
    ax.tick_params(length=0)
    for side in ax.spines.values():
        side.set_visible(False)
    say_below(fig, rows, ours, rivals)
    height = fig.get_figheight()
    fig.subplots_adjust(left=LEFT / wide, right=1 - RIGHT / wide, top=1 - 0.65 / height, bottom=1.4 / height)
    save_as(fig, path)


def draw_danger(danger, methods, rows, path):
    """Error over its tolerance against the danger; runs without a number stand on top."""
    fig, ax = new_figure(8.2, 4.6)
    values = danger["values"]
    top, bottom = 1e4, 1e-4
    for j, method in enumerate(methods):
        mine = [r for r in rows if r["danger"] == danger["name"] and (r["scheme"], r["element"]) == tuple(method)]
        if not mine:
            continue
        shift = 0.8 * ((j + 0.5) / len(methods) - 0.5)
        xs = [values.index(r["x"]) + shift for r in mine]
        # no number: above all
        ys = [3 * top if r["error_over_tolerance"] in ("", "inf") else
              min(max(float(r["error_over_tolerance"]), bottom), top) for r in mine]
        line, = ax.plot(xs, ys, "-", lw=0.8, label=label(method).replace("\n", " "))
        for x, y, r in zip(xs, ys, mine):
            ax.plot(x, y, MARKERS[r["outcome"]], color=COLORS[r["outcome"]], mec=line.get_color(), ms=7)
    ax.axhline(1, color="0.5", lw=0.8, ls="--")
    ax.axhspan(1.5 * top, 30 * top, color="0.93")
    ax.text(-0.45, 13 * top, "no number", va="center", fontsize=9, color="0.4")
    ax.set_yscale("log")
    ax.set_ylim(bottom / 2, 30 * top)
    ax.set_xlim(-0.5, len(values) - 0.5)
    ax.set_xticks(range(len(values)), values)
    ax.set_xlabel(danger["meaning"])
    ax.set_ylabel("error / allowed error [-]")
    ax.set_title(f"{danger['name']}\nallowed: {tolerances([r for r in rows if r['danger'] == danger['name']])}")
    marks = [Line2D([], [], ls="", marker=MARKERS[n], color=COLORS[n], label=n) for n in COLORS]
    handles = ax.get_legend_handles_labels()[0] + marks
    ax.legend(handles=handles, fontsize=10, loc="upper left", bbox_to_anchor=(1, 1), frameon=False)
    fig.tight_layout()
    save_as(fig, path)


def draw(dangers, ours, rivals, rows, folder):
    draw_map(dangers, ours, rivals, rows, os.path.join(folder, "map.png"))
    for d in dangers:
        draw_danger(d, [*ours, *rivals], rows, os.path.join(folder, re.sub(r"[^a-z0-9]+", "-", d["name"].lower()) + ".png"))
