"""The contact surface: which nodes touch, marks of the contact arc, profile, chart of events."""
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from plotting.figure import (BLUE, GRAY, GREEN, MICRON, MM, ORANGE, PURPLE, RED, SKY, key_below, new_figure,
                             say_empty)
from plotting.maps import WHITE_EDGE

IN_CONTACT = ("touched", "sliding", "sticking")
# number in the files: name, color, marker; the same in maps, movies and curves
STATES = {3: ("sticking", GREEN, "^"), 2: ("sliding", RED, "o"), 1: ("touched", BLUE, "s")}

# event: color, marker, size
EVENT_MARKS = {"touch": (BLUE, "o", 1.0), "release": (ORANGE, "s", 1.0), "slip-to-stick": (GREEN, "^", 1.2),
               "stick-to-slip": (RED, "v", 1.2), "next-piece": (PURPLE, "D", 1.0), "jump": (RED, "*", 2.0), "yield": (GRAY, ".", 0.5),
               "unloading": (SKY, ".", 0.5)}


def polar_degrees(x, y):
    return np.degrees(np.arctan2(y, x))


def touching(surface):
    return np.isin(surface["state"], IN_CONTACT)


def runs(mask):
    """Slices of consecutive true entries."""
    ends = np.flatnonzero(np.diff(np.r_[0, mask.astype(int), 0]))
    return [slice(a, b) for a, b in zip(ends[::2], ends[1::2])]


def middle_of_contact(surface, tool=None):
    """Place midway between the outermost contact nodes [m], of one tool or of all, None without contact."""
    nodes = np.flatnonzero(touching(surface) & (True if tool is None else surface["tool"] == tool))
    if not len(nodes):
        return None
    return np.array([surface[c][nodes[[0, -1]]].mean() for c in "xy"])


def arcs(surface):
    """Length along the surface in the order of the nodes, and the number of each node's chain; neighbors that are far
    apart belong to different chains."""
    gaps = np.hypot(np.diff(surface["x"]), np.diff(surface["y"]))
    return np.r_[0, np.cumsum(gaps)], np.r_[0, np.cumsum(gaps > 8 * np.median(gaps))]


def contact_arcs(surface):
    """Slices of nodes in contact that follow one another on one chain and touch the same tool."""
    where, chain, parts = touching(surface), arcs(surface)[1], []
    tool = surface.get("tool", np.zeros(len(where)))
    for part in runs(where):
        cuts = np.flatnonzero((np.diff(chain[part]) != 0) | (tool[part][1:] != tool[part][:-1])) + part.start + 1
        parts += [slice(a, b) for a, b in zip([part.start, *cuts], [*cuts, part.stop])]
    return parts


def mark_contact(axes, surface, letters="EF", scale=MM):
    """Bold line along the contact arc with a letter at each end, the first one at the larger angle; scale: to mm."""
    where = touching(surface)
    if not where.any():
        return Line2D([], [], linestyle="none", label="no contact")
    x, y = scale * surface["x"], scale * surface["y"]
    single = [part.stop - part.start == 1 for part in contact_arcs(surface)]
    for part, alone in zip(contact_arcs(surface), single):
        dot = "o" if alone else None
        axes.plot(x[part], y[part], color="black", linewidth=4, solid_capstyle="butt", marker=dot, zorder=4)
    ends = np.flatnonzero(where)[[0, -1]]
    ends = ends[np.argsort(-polar_degrees(x[ends], y[ends]))]
    for end, letter, side in zip(ends, letters, (-7, 7)):
        axes.annotate(letter, (x[end], y[end]), xytext=(side, 9), textcoords="offset points", ha="center",
                      va="bottom", fontweight="bold", path_effects=WHITE_EDGE, zorder=6)
    return Line2D([], [], color="black", linewidth=0 if all(single) else 4, marker="o" if any(single) else None,
                  label=f"contact arc {letters}" if letters else "in contact")


def shade_sticking(axes, arc, surface):
    """Bands over the sticking nodes, up to halfway to their neighbors; true if there is any."""
    border = np.r_[arc[0], (arc[1:] + arc[:-1]) / 2, arc[-1]]
    parts = runs(surface["state"] == "sticking")
    for part in parts:
        axes.axvspan(border[part.start], border[part.stop], color=GREEN, alpha=0.2, linewidth=0, zorder=0)
    return bool(parts)


def profile_figure(surface, first_contact, title):
    """Radial displacement of the surface against the angle; first_contact: its polar angle [deg] or None."""
    figure, axes = new_figure(8.0, 4.6)
    angle = polar_degrees(surface["x"], surface["y"])
    shift = MICRON * (np.hypot(surface["x"], surface["y"]) - np.hypot(surface["X"], surface["Y"]))
    handles = [axes.plot(angle, shift, color=BLUE, marker="o" if len(angle) < 60 else None, markersize=3.5,
                         label="surface")[0]]
    axes.axhline(0, color="black", linewidth=0.8)
    if first_contact is not None:
        handles.append(axes.axvline(first_contact, color=GREEN, linestyle="--", label="first contact"))
    nodes = angle[touching(surface)]
    if len(nodes):
        axes.axvspan(nodes.min(), nodes.max(), color=ORANGE, alpha=0.35, linewidth=0, zorder=0)
        handles.append(Patch(color=ORANGE, alpha=0.35, label="contact at the end"))
    axes.set_xlim(angle.max(), angle.min())
    axes.set_xlabel("polar angle [deg]  (clockwise to the right)")
    axes.set_ylabel(r"radial displacement [$\mu$m]")
    axes.set_title(title)
    key_below(axes, handles, len(handles), 0.15)
    return figure


def event_panel(axes, events, history, kind, size):
    """Events of one kind over the band of contact; their number above."""
    axes.fill_between(history["t"], history["contact_begin_deg"], history["contact_end_deg"], color="#dddddd", linewidth=0)
    color, marker, scale = EVENT_MARKS.get(kind, (PURPLE, "x", 1.0))
    chosen = events["event"] == kind
    angle = polar_degrees(events["x"][chosen], events["y"][chosen])
    axes.plot(events["t"][chosen], angle, linestyle="none", marker=marker, color=color, markersize=size * scale, markeredgewidth=0.6)
    axes.set_title(f"{kind} ({chosen.sum()})", fontsize=11)


def events_figure(events, history, title):
    """Events by polar angle of their place against t, over the band of contact: a panel for each kind, none hides another."""
    kinds = sorted(set(events["event"]), key=lambda k: (list(EVENT_MARKS) + [k]).index(k))
    columns = min(3, max(1, len(kinds)))
    rows = max(1, -(-len(kinds) // columns))
    figure, panels = new_figure(3.4 * columns + 0.6, 2.7 * rows + 1.0, nrows=rows, ncols=columns, squeeze=False, sharex=True, sharey=True)
    if not kinds:
        say_empty(panels[0, 0], "no events")
    for axes, kind in zip(panels.flat, kinds):
        count = (events["event"] == kind).sum()
        event_panel(axes, events, history, kind, np.clip(5.0 * (150 / max(count, 1)) ** 0.4, 1.6, 5.0))
    for k, axes in enumerate(panels.flat):
        axes.set_visible(k < max(1, len(kinds)))
        if k + columns >= len(kinds):
            axes.tick_params(labelbottom=True)
            axes.set_xlabel("load parameter t [-]")
    for axes in panels[:, 0]:
        axes.set_ylabel("polar angle [deg]")
    figure.suptitle(f"{title}; gray: the nodes in contact")
    return figure
