"""The page of a run in space, movie.html: workpiece and tools that turn under the mouse, a slider for the time; no network."""
import base64
import html
import json

import numpy as np

from plotting.space import files
from plotting.space.page_script import SCRIPT
from plotting.space.scene import bands, values_of

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%(title)s</title>
<meta name="viewport" content="width=device-width">
<style>
body { font: 16px sans-serif; margin: 1em auto; max-width: 1100px; padding: 0 1em; color: #222 }
.view { position: relative; overflow: hidden } canvas { box-sizing: border-box; width: 100%%; aspect-ratio: 16/10; display: block; border: 1px solid #ccc; touch-action: none; cursor: grab }
.scale { position: absolute; right: 1em; top: 1em; background: #fffc; padding: .4em; font-size: 14px; display: flex; flex-direction: column }
.scale span::before { content: ""; display: inline-block; width: 1.6em; height: 1.2em; margin-right: .5em; vertical-align: bottom; background: var(--c) }
.axis { position: absolute; pointer-events: none; white-space: nowrap; font-size: 14px }
.bar { display: flex; gap: 1em; align-items: center; margin-top: .5em } .bar input[type=range] { flex: 1 }
output { min-width: 7em; font-variant-numeric: tabular-nums }
</style></head><body>
<h1>%(title)s</h1>
<div class="view"><canvas id="view" aria-label="workpiece and tools at the time of the slider"></canvas>
<div class="scale">%(scale)s</div></div>
<div class="bar"><button id="play" type="button">Play</button>
<input id="time" type="range" min="0" max="%(most)d" value="0" aria-label="time"><output id="t"></output>
<label><input id="tools" type="checkbox" checked> tools</label> <label><input id="edges" type="checkbox" checked> elements</label></div>
<p>Drag to turn, wheel to zoom, shift and drag to move, arrow keys at the slider by a frame.</p>
<noscript><p>Without JavaScript there is nothing to see here; movie.gif shows the way.</p></noscript>
<script id="data" type="application/json">%(data)s</script>
<script>%(script)s</script>
</body></html>
"""


def packed(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode()


def compact(cells):
    """Only the nodes that the cells name: (numbers of these nodes, cells with the new numbers)."""
    nodes, new = np.unique(cells, return_inverse=True)
    return nodes, new.reshape(cells.shape)


def scale_rows(scale, colors):
    """A row for each band, the highest first."""
    levels, rows = scale.levels, [html.escape(scale.label)]
    for k in range(len(levels) - 2, -1, -1):
        color = "#%02x%02x%02x" % tuple(int(255 * c) for c in colors[k - len(levels) + 1][:3])
        rows.append(f'<span style="--c:{color}">{levels[k] if k else 0:.4g} to {levels[k + 1]:.4g}</span>')
    return "".join(rows)


def nearest_corner(points, view):
    """Of the box, that below next to the viewer: the axes begin there."""
    ends = np.array([points.min(axis=0), points.max(axis=0)])
    return np.where(view.eye - 10 * view.up > 0, ends[1], ends[0])


def frame_data(frame, nodes, values, center):
    tools = files.tool_parts(frame.tools)
    return {"t": float(f"{frame.t:.4g}"), "points": packed(frame.body.points[nodes] - center, "<f4"),
            "values": packed(values[nodes], "<f4"),
            "tools": [{"points": packed(points - center, "<f4"), "cells": packed(cells, "<u4"),
                       "lines": packed(files.edges_of(cells), "<u4")} for _, points, cells, _ in tools]}


def page(name, frames, scale, view):
    """Text of the page. scale: scene.Scale; view: scene.View"""
    colors, limits = bands(scale)
    body = frames[0].body
    nodes, triangles = compact(files.triangles_of(body.faces))
    numbers = np.full(len(body.points), -1)
    numbers[nodes] = np.arange(len(nodes))
    center = 0.5 * (view.box[0] + view.box[1])
    data = {"cells": packed(triangles, "<u4"), "edges": packed(numbers[body.lines], "<u4"),
            "frames": [frame_data(frame, nodes, values_of(frame, scale), center) for frame in frames],
            "colors": [[round(c, 3) for c in color[:3]] for color in colors], "limits": [float(v) for v in limits],
            "eye": list(view.eye), "up": list(view.up), "size": float(np.linalg.norm(view.box[1] - view.box[0])),
            "corner": list(nearest_corner(body.points, view) - center), "axes": [f"{axis} [{view.length}]" for axis in "xyz"]}
    return PAGE % {"title": html.escape(name), "most": len(frames) - 1, "scale": scale_rows(scale, colors),
                   "data": json.dumps(data).replace("</", "<\\/"), "script": SCRIPT}
