#!/usr/bin/python3
"""Lab 1: pressures under cylinder and punch, and their errors. plot.py FOLDER [FILE], see labfigure.py."""
import os
import sys

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[os.pardir] * 3)
sys.path.insert(0, os.path.join(os.environ.get("BURNISH_TOP") or TOP, "cases"))
from labs.labfigure import main
from plotting.figure import BLUE, RED, new_figure
from plotting.inputs import read_whole_table

TOOLS = {"cylinder": BLUE, "punch": RED}


def profiles(axes, table):
    """Nodal pressures of the finest P2 mesh over the closed forms."""
    finest = (table["element"] == "P2") & (table["n"] == table["n"].max())
    for tool, color in TOOLS.items():
        chosen = finest & (table["tool"] == tool)
        x, p, expected = (table[name][chosen] for name in ("x", "pressure", "expected"))
        inside = expected > 0
        axes.plot(x[inside], expected[inside], color=color, label=f"{tool}, closed form")
        axes.plot(x, p, color=color, marker="o", markersize=4, linestyle="none", label=f"{tool}, P2")
    cylinder = finest & (table["tool"] == "cylinder")
    axes.set(xlabel="x from the middle [mm]", ylabel="pressure [MPa]", title="Pressure on the finest mesh",
             ylim=(-5, 2.7 * table["pressure"][cylinder].max()))
    axes.legend(loc="upper center")


def errors(axes, table):
    """Errors inside 0.8 a, and that of all of the cylinder's pressure, against the divisions."""
    for tool, color in TOOLS.items():
        for element, marker in (("P1", "s"), ("P2", "o")):
            chosen = (table["tool"] == tool) & (table["element"] == element)
            n = table["n"][chosen]
            axes.loglog(n, 100 * table["inner"][chosen], color=color, marker=marker, label=f"{tool} {element}, inside 0.8 a")
            if tool == "cylinder":
                axes.loglog(n, 100 * table["error"][chosen], color=color, marker=marker, linestyle="--", label=f"cylinder {element}, all")
    n = sorted(set(table["n"]))
    axes.set(xticks=n, xticklabels=[f"{k:g}" for k in n], ylim=(0.002, 40), xlabel="divisions n of the half-width a [-]",
             ylabel="error of the pressure, L2 [%]", title="Error against the mesh")
    axes.minorticks_off()
    axes.set_yticks([0.1, 1, 10], ["0.1", "1", "10"])
    axes.legend(loc="lower left", fontsize=10)


def draw(folder):
    figure, (left, right) = new_figure(10.5, 5.2, ncols=2)
    profiles(left, read_whole_table(os.path.join(folder, "pressure.csv"), ("tool", "element")))
    errors(right, read_whole_table(os.path.join(folder, "study.csv"), ("tool", "element")))
    return figure


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], draw))
