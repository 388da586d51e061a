"""Pictures of the fields of all variants in one scale and one view, field.png in the folder of each, drawn in one process."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import numpy as np
from plotting import fields, final
from plotting.figure import apply_style, save
from plotting.inputs import InputError
from plotting.run import Run
from plotting.units import plain

MOST_LEVELS = 10


def runs_of(folders):
    """{folder: Run} of the variants whose field can be read."""
    found = {}
    for folder in folders:
        run = Run(folder)
        if run.has("final.vtu") and run.has("summary.json"):
            found[folder] = run
    return found


def legend(scale, words):
    """{label, unit, levels, colors, words} for the page; None without a field."""
    if scale.levels is None:
        return None
    from matplotlib.colors import to_hex
    colors = [to_hex(c) for c in fields.band_colors(scale.quantity, scale.levels).colors]
    return {"words": words, "label": scale.quantity.label, "unit": plain(scale.unit).replace("$", "").strip("-"), "largest": float(f"{scale.largest:.4g}"),
            "levels": [float(f"{v:.4g}") for v in scale.levels], "colors": colors}


def draw_plane(runs, scale):
    """One view for all: of where the values are large, where that is small in the workpiece."""
    shown = {}
    for folder, run in runs.items():
        run.units = next(iter(runs.values())).units
        shown[folder] = final.Shown(run, run.t, run.field, run.surface if run.has("surface.csv") else None, scale)
    view = final.common_view(list(shown.values()))
    for folder, one in shown.items():
        save(final.bare_figure(one, view), folder, "field")


def draw_space(runs, scale):
    from plotting.space import final as space_final
    for folder, run in runs.items():
        save(space_final.gallery_figure(run, scale), folder, "field")


def in_space(runs):
    """The same runs read as those in space, and their fields."""
    from plotting.space import case
    runs = {folder: case.space_run(run) for folder, run in runs.items()}
    return runs, [run.last.body for run in runs.values()]


def draw_fields(folders):
    """Draws field.png of these variants. @returns the legend of their scale, None where nothing could be drawn"""
    try:
        runs = runs_of(folders)
        if not runs:
            return None
        apply_style()
        space = next(iter(runs.values())).in_space
        runs, listed = in_space(runs) if space else (runs, [run.field for run in runs.values()])
        scale = final.scale_of(list(runs.values()), listed, MOST_LEVELS)
        (draw_space if space else draw_plane)(runs, scale)
        return legend(scale, "Gray: tools." if space else "Gray: tools; thick black: where they touch. One view for all.")
    except (InputError, ImportError, KeyError, ValueError) as error:
        print(f"burnish sweep: no pictures of fields: {type(error).__name__}: {error}", file=sys.stderr)
        return None
