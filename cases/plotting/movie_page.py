"""The page of a movie: frames within it, a slider for the time, a button to play; opens without a server."""
import html
import json

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%(title)s</title>
<meta name="viewport" content="width=device-width">
<style>
body { font: 16px sans-serif; margin: 1em auto; max-width: %(width)dpx; padding: 0 1em; color: #222 }
img { width: 100%%; height: auto; display: block }
.bar { display: flex; gap: 1em; align-items: center } .bar input { flex: 1 }
output { min-width: 7em; font-variant-numeric: tabular-nums }
</style></head><body>
<h1>%(title)s</h1>
<img id="frame" width="%(width)d" height="%(height)d" alt="stress, tools and contact at the time of the slider" src="%(first)s">
<div class="bar"><button id="play" type="button">Play</button>
<input id="time" type="range" min="0" max="%(most)d" value="0" aria-label="time"><output id="t"></output></div>
<noscript><p>Without JavaScript this is the start of the run; movie.gif shows the way.</p></noscript>
<p>Arrow keys move by a frame. Circles, triangles and squares are nodes in contact; the black lines mark the time in the curves.</p>
<script id="frames" type="application/json">%(data)s</script>
<script>
"use strict";
const data = JSON.parse(document.getElementById("frames").textContent);
const [image, slider, time, button] = ["frame", "time", "t", "play"].map(id => document.getElementById(id));
let timer = null;
function show() {
  const k = Number(slider.value);
  image.src = data.images[k];
  time.textContent = "t = " + data.t[k];
}
function stop() { clearInterval(timer); timer = null; button.textContent = "Play"; }
function step() {
  if (Number(slider.value) >= data.t.length - 1) { stop(); return; }
  slider.value = Number(slider.value) + 1;
  show();
}
button.onclick = () => {
  if (timer) { stop(); return; }
  if (Number(slider.value) >= data.t.length - 1) slider.value = 0;
  show();
  button.textContent = "Stop";
  timer = setInterval(step, 200);
};
slider.oninput = () => { stop(); show(); };
if (location.hash.length > 1) slider.value = location.hash.slice(1);  // movie.html#3 opens at frame 3 and waits
show();
if (location.hash.length < 2 && !matchMedia("(prefers-reduced-motion: reduce)").matches) button.onclick();
</script>
</body></html>
"""


def page(name, times, images, size):
    """Text of the page; images: data URIs, one for each time; size: pixels."""
    data = json.dumps({"t": [float(f"{t:.4g}") for t in times], "images": images})
    return PAGE % {"title": html.escape(name), "width": size[0], "height": size[1], "most": len(times) - 1,
                   "first": images[0], "data": data.replace("</", "<\\/")}
