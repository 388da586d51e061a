"""The script of the page of a run in space: WebGL 2, flat light, bands of color."""

SCRIPT = r"""
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const [canvas, slider, time, button, showTools, showEdges] = ["view", "time", "t", "play", "tools", "edges"].map(id => document.getElementById(id));
const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;
const gl = canvas.getContext("webgl2", {alpha: false, preserveDrawingBuffer: true});
if (!gl) document.querySelector("p").textContent = "This browser has no WebGL 2; movie.gif shows the way.";

const vertexText = `#version 300 es
in vec3 place; in float value; uniform mat4 view; uniform float nearer; out vec3 at; out float shown;
void main() { at = place; shown = value; gl_Position = view * vec4(place, 1.); gl_Position.z -= nearer * gl_Position.w; }`;
const fragmentText = `#version 300 es
precision highp float;
in vec3 at; in float shown; uniform vec3 eye, above, plain; uniform vec2 limits; uniform int number; uniform vec3 bands[32]; uniform float opacity; uniform bool lit;
out vec4 color;
void main() {
  vec3 own = plain;
  if (number > 0) own = bands[clamp(int(floor((shown - limits.x)/(limits.y - limits.x)*float(number))), 0, number - 1)];
  float light = 1.;
  if (lit) { vec3 n = normalize(cross(dFdx(at), dFdy(at))); light = .4 + .35*abs(dot(n, eye)) + .3*abs(dot(n, above)); }
  color = vec4(own*light, opacity);
}`;
function shader(kind, text) {
  const made = gl.createShader(kind);
  gl.shaderSource(made, text); gl.compileShader(made);
  if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
  return made;
}
const program = gl.createProgram();
gl.attachShader(program, shader(gl.VERTEX_SHADER, vertexText)); gl.attachShader(program, shader(gl.FRAGMENT_SHADER, fragmentText));
gl.bindAttribLocation(program, 0, "place"); gl.bindAttribLocation(program, 1, "value");
gl.linkProgram(program); gl.useProgram(program);
const uniform = name => gl.getUniformLocation(program, name);
function buffer(kind, values) { const made = gl.createBuffer(); gl.bindBuffer(kind, made); gl.bufferData(kind, values, gl.STATIC_DRAW); return made; }
function indices(text) { const values = new Uint32Array(bytes(text)); return {buffer: buffer(gl.ELEMENT_ARRAY_BUFFER, values), count: values.length}; }
const numbers = text => buffer(gl.ARRAY_BUFFER, new Float32Array(bytes(text)));
const cells = indices(data.cells), edges = indices(data.edges);
for (const frame of data.frames) {
  frame.place = numbers(frame.points); frame.value = numbers(frame.values);
  for (const tool of frame.tools) { tool.place = numbers(tool.points); tool.index = indices(tool.cells); tool.edges = indices(tool.lines); }
}

// --- the view: a frame of three unit vectors, a distance, a shift
const dot = (a, b) => a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
const cross = (a, b) => [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]];
const scaled = (a, f) => a.map(v => v*f), sum = (a, b) => a.map((v, i) => v + b[i]);
const unit = a => scaled(a, 1/Math.hypot(...a));
let front = unit(data.eye), right = unit(cross(data.up, front)), upward = cross(front, right);
let distance = 2*data.size, shift = [0, 0];
function turned(a, axis, angle) { // Rodrigues
  const c = Math.cos(angle), s = Math.sin(angle);
  return sum(sum(scaled(a, c), scaled(cross(axis, a), s)), scaled(axis, dot(axis, a)*(1 - c)));
}
function matrix() {
  const n = .02*data.size, f = distance + 4*data.size, w = canvas.width/canvas.height, g = 1/Math.tan(.25);
  const rows = [[...right, shift[0]], [...upward, shift[1]], [...front, -distance]];
  const m = [scaled(rows[0], g/w), scaled(rows[1], g), sum(scaled(rows[2], (f + n)/(n - f)), [0, 0, 0, 2*f*n/(n - f)]), scaled(rows[2], -1)];
  return new Float32Array([0, 1, 2, 3].flatMap(column => m.map(row => row[column])));
}
function draw(place, value, index, how, {color = [0, 0, 0], opacity = 1, lit = true, nearer = 0} = {}) {
  gl.bindBuffer(gl.ARRAY_BUFFER, place); gl.enableVertexAttribArray(0); gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
  if (value) { gl.bindBuffer(gl.ARRAY_BUFFER, value); gl.enableVertexAttribArray(1); gl.vertexAttribPointer(1, 1, gl.FLOAT, false, 0, 0); }
  else gl.disableVertexAttribArray(1);
  gl.uniform1i(uniform("number"), value ? data.colors.length : 0);
  gl.uniform3fv(uniform("plain"), color); gl.uniform1f(uniform("opacity"), opacity); gl.uniform1i(uniform("lit"), lit); gl.uniform1f(uniform("nearer"), nearer);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, index.buffer);
  gl.drawElements(how, index.count, gl.UNSIGNED_INT, 0);
}
const letters = data.axes.map(name => { const mark = document.createElement("span"); mark.className = "axis"; mark.textContent = name; document.querySelector(".view").append(mark); return mark; });
const axisPlace = [0, 1, 2].map(k => { const end = [...data.corner]; end[k] += .16*data.size; return buffer(gl.ARRAY_BUFFER, new Float32Array([...data.corner, ...end])); });
const axisIndex = {buffer: buffer(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array([0, 1])), count: 2};
function letter(mark, k, m) {
  const p = [...data.corner, 1]; p[k] += .18*data.size;
  const clip = [0, 1, 3].map(row => [0, 1, 2, 3].reduce((s, c) => s + m[4*c + row]*p[c], 0));
  mark.style.left = (50 + 50*clip[0]/clip[2]) + "%"; mark.style.top = (50 - 50*clip[1]/clip[2]) + "%";
}
function show() {
  const frame = data.frames[Number(slider.value)];
  time.textContent = "t = " + frame.t;
  const size = [canvas.clientWidth, canvas.clientHeight].map(v => Math.round(v*devicePixelRatio));
  if (canvas.width != size[0] || canvas.height != size[1]) [canvas.width, canvas.height] = size;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.depthMask(true); gl.enable(gl.DEPTH_TEST); gl.disable(gl.BLEND); gl.clearColor(1, 1, 1, 1); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  const m = matrix();
  gl.uniformMatrix4fv(uniform("view"), false, m); gl.uniform3fv(uniform("eye"), front); gl.uniform3fv(uniform("above"), data.up); gl.uniform2fv(uniform("limits"), data.limits);
  gl.uniform3fv(uniform("bands"), data.colors.flat());
  draw(frame.place, frame.value, cells, gl.TRIANGLES);
  if (showEdges.checked) draw(frame.place, null, edges, gl.LINES, {color: [.35, .35, .35], lit: false, nearer: 2e-4});
  axisPlace.forEach((place, k) => { draw(place, null, axisIndex, gl.LINES, {lit: false}); letter(letters[k], k, m); });
  if (showTools.checked) {
    gl.enable(gl.BLEND); gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA); gl.depthMask(false);
    for (const tool of frame.tools) {
      draw(tool.place, null, tool.index, gl.TRIANGLES, {color: [.5, .55, .63], opacity: .2, nearer: -2e-4});
      draw(tool.place, null, tool.edges, gl.LINES, {color: [.3, .34, .4], opacity: .15, lit: false});
    }
  }
  document.body.dataset.drawn = slider.value;
}
let timer = null;
function stop() { clearInterval(timer); timer = null; button.textContent = "Play"; }
button.onclick = () => {
  if (timer) { stop(); return; }
  if (Number(slider.value) >= data.frames.length - 1) slider.value = 0;
  show();
  button.textContent = "Stop";
  timer = setInterval(() => { if (Number(slider.value) >= data.frames.length - 1) { stop(); return; } slider.value = Number(slider.value) + 1; show(); }, 200);
};
slider.oninput = () => { stop(); show(); };
showTools.onchange = showEdges.onchange = window.onresize = show;
canvas.onpointerdown = event => canvas.setPointerCapture(event.pointerId);
canvas.onpointermove = event => {
  if (!event.buttons) return;
  if (event.shiftKey) { const f = distance/canvas.clientHeight*.5; shift[0] += event.movementX*f; shift[1] -= event.movementY*f; }
  else {
    const about = unit(data.up), a = -.008*event.movementX, b = -.008*event.movementY;
    [front, right, upward] = [front, right, upward].map(v => turned(turned(v, right, b), about, a));
  }
  show();
};
canvas.onwheel = event => { event.preventDefault(); distance *= Math.exp(.001*event.deltaY); show(); };
if (location.hash.length > 1) slider.value = location.hash.slice(1);  // movie.html#3 opens at frame 3 and waits
show();
if (location.hash.length < 2 && !matchMedia("(prefers-reduced-motion: reduce)").matches) button.onclick();
"""
