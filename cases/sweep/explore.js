"use strict";
// The page of a sweep: sliders choose a variant, all the rest follows. #R=0.02,mu=0.3 at the end of the address chooses one, too.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = id => document.getElementById(id);
const indexOf = (p, variant) => p.values.indexOf(variant.values[p.name]);
const number = text => (text === null || text === "" ? NaN : Number(text));
let present = data.variants[0];

function element(parent, tag, attributes = {}, text = "") {
  const svg = ["svg", "path", "line", "rect", "circle", "text"].includes(tag);
  const made = svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.textContent = text;
  parent.append(made);
  return made;
}

// --- a plot -------------------------------------------------------------------------------------------------------
const SIZE = {w: 400, h: 250, left: 62, right: 12, top: 14, bottom: 42};

function ticksOf(low, high) {
  if (!(high > low)) return [low];
  const raw = (high - low) / 5, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 2.5, 5, 10].find(f => f * power >= raw);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(Number((k * step).toPrecision(8)));
  return ticks;
}

// Power of ten, a multiple of three, that shortens numbers up to the largest; a label with it before the unit.
function powerOf(values) {
  const largest = Math.max(...values.map(Math.abs));
  return largest > 0 && (largest < 0.01 || largest >= 1e5) ? 3 * Math.floor(Math.log10(largest) / 3) : 0;
}
function withPower(label, power) {
  if (!power) return label;
  return label.includes("[") ? label.replace("[", `[1e${power} `) : `${label} [1e${power}]`;
}

// Axes in parent for all points of the curves; returns where a point is drawn. names: of the axes; words: ticks of x, if they are words.
function axes(parent, curves, names, words = null) {
  const xs = curves.flatMap(c => c.x).filter(Number.isFinite), ys = curves.flatMap(c => c.y).filter(Number.isFinite);
  let [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  if (!(y1 > y0)) { y0 -= Math.abs(y0) * 0.1 || 1; y1 += Math.abs(y1) * 0.1 || 1; }
  if (!(x1 > x0)) { x0 -= Math.abs(x0) * 0.1 || 1; x1 += Math.abs(x1) * 0.1 || 1; }
  const powers = words ? [0, powerOf([y0, y1])] : [powerOf([x0, x1]), powerOf([y0, y1])];
  const tick = (v, power) => Number((v / 10 ** power).toPrecision(4));
  const pad = 0.05 * (y1 - y0);
  y0 -= pad; y1 += pad;
  const s = SIZE, svg = element(parent, "svg", {viewBox: `0 0 ${s.w} ${s.h}`});
  const place = (x, y) => [s.left + (x - x0) / (x1 - x0) * (s.w - s.left - s.right), s.h - s.bottom - (y - y0) / (y1 - y0) * (s.h - s.top - s.bottom)];
  for (const x of words ? words.map((_, i) => i) : ticksOf(x0, x1)) {
    const [px] = place(x, y0);
    element(svg, "line", {class: "grid", x1: px, x2: px, y1: s.top, y2: s.h - s.bottom});
    element(svg, "text", {x: px, y: s.h - s.bottom + 15, "text-anchor": "middle"}, words ? words[x] : tick(x, powers[0]));
  }
  for (const y of ticksOf(y0, y1)) {
    const [, py] = place(x0, y);
    element(svg, "line", {class: "grid", x1: s.left, x2: s.w - s.right, y1: py, y2: py});
    element(svg, "text", {x: s.left - 5, y: py + 4, "text-anchor": "end"}, tick(y, powers[1]));
  }
  element(svg, "rect", {class: "frame", x: s.left, y: s.top, width: s.w - s.left - s.right, height: s.h - s.top - s.bottom});
  element(svg, "text", {x: (s.left + s.w) / 2, y: s.h - 6, "text-anchor": "middle"}, withPower(names[0], powers[0]));
  const middle = (s.top + s.h - s.bottom) / 2;
  element(svg, "text", {x: 13, y: middle, "text-anchor": "middle", transform: `rotate(-90 13 ${middle})`}, withPower(names[1], powers[1]));
  return [svg, place];
}

function line(svg, place, curve, kind) {
  let d = "", open = false;
  curve.x.forEach((x, i) => {
    const known = Number.isFinite(x) && Number.isFinite(curve.y[i]);
    if (known) d += (open ? "L" : "M") + place(x, curve.y[i]).map(v => v.toFixed(1)).join(" ");
    open = known;
  });
  element(svg, "path", {class: kind, d});
}

// --- parts of the page ----------------------------------------------------------------------------------------------
const labelOf = p => p.unit ? `${p.name} [${p.unit}]` : p.name;

function showState() {
  byId("variant").textContent = data.parameters.map(p => `${p.name} = ${present.values[p.name]} ${p.unit}`.trim()).join(", ");
  byId("state").className = present.reason ? "failed" : "";
  byId("state").textContent = present.reason ? `${present.status}: ${present.reason} ` : "";
  for (const [file, name] of [["log.txt", "log"], ["summary.json", "summary"], ...(present.movie ? [["movie.html", "movie"]] : [])]) {
    element(byId("state"), "a", {href: encodeURI(`${present.folder}/${file}`)}, name);
    byId("state").append(" ");
  }
  data.parameters.forEach((p, k) => {
    byId(`slider-${k}`).value = indexOf(p, present);
    byId(`value-${k}`).textContent = `${present.values[p.name]} ${p.unit}`;
  });
}

function showPicture() {
  const name = byId("picture").value, path = present.pictures[name];
  byId("image").hidden = !path;
  if (!path) { byId("image").removeAttribute("src"); return; }
  byId("image").src = byId("link").href = encodeURI(path);
  byId("image").alt = `${name} of ${byId("variant").textContent}`;
}

function showResults() {
  const table = byId("results");
  table.replaceChildren();
  const known = present.results.some(r => r[3] !== null), head = element(table, "tr");
  for (const text of ["", "value", "unit", ...(known ? ["expected"] : [])]) element(head, "th", {}, text);
  for (const [name, value, unit, expected] of present.results) {
    const row = element(table, "tr");
    for (const text of [name, value ?? "none", unit, ...(known ? [expected ?? ""] : [])]) element(row, "td", {}, text);
  }
}

// The chosen result of the variants that differ from the present one by one option only.
function showTrend() {
  const p = data.parameters[Number(byId("against").value)], quantity = byId("quantity").value;
  byId("trend").replaceChildren();
  if (!p || !quantity) return;
  const valueOf = v => (v.results.find(r => r[0] === quantity) ?? [])[1] ?? NaN;
  const numeric = p.values.every(v => Number.isFinite(number(v)));
  const xOf = v => numeric ? number(v.values[p.name]) : indexOf(p, v);
  const order = (a, b) => xOf(a) - xOf(b), good = v => v.status === "finished";
  const groups = new Map();
  for (const v of data.variants.filter(good)) {
    const key = data.parameters.filter(q => q !== p).map(q => v.values[q.name]).join();
    groups.set(key, [...(groups.get(key) ?? []), v]);
  }
  const curves = [...groups.values()].map(g => g.sort(order)).map(g => ({x: g.map(xOf), y: g.map(valueOf), mine: g.includes(present)}));
  if (!curves.some(c => c.y.some(Number.isFinite))) { byId("trend").textContent = "no value"; return; }
  const unit = (data.variants.flatMap(v => v.results).find(r => r[0] === quantity) ?? [])[2];
  const [svg, place] = axes(byId("trend"), curves, [labelOf(p), unit ? `${quantity} [${unit}]` : quantity], numeric ? null : p.values);
  for (const c of [...curves].sort((a, b) => a.mine - b.mine)) line(svg, place, c, c.mine ? "mine" : "other");
  for (const c of curves.filter(c => c.mine))
    c.x.forEach((x, i) => Number.isFinite(c.y[i]) && element(svg, "circle", {class: "dot", r: 3, cx: place(x, c.y[i])[0], cy: place(x, c.y[i])[1]}));
  const now = [xOf(present), valueOf(present)];
  if (good(present) && now.every(Number.isFinite)) element(svg, "circle", {class: "now", r: 6, cx: place(...now)[0], cy: place(...now)[1]});
}

function showHistories() {
  byId("histories").replaceChildren();
  for (const [name, label] of data.columns) {
    const curveOf = v => ({x: v.t.map(number), y: (v.curves[name] ?? []).map(number)});
    const [svg, place] = axes(byId("histories"), data.variants.map(curveOf), ["load parameter t", label]);
    for (const v of data.variants) if (v !== present) line(svg, place, curveOf(v), "other");
    line(svg, place, curveOf(present), "mine");
  }
}

function show() {
  showState();
  showPicture();
  showResults();
  showTrend();
  showHistories();
  history.replaceState(null, "", "#" + data.parameters.map(p => `${p.name}=${present.values[p.name]}`).join());
}

// --- choosing -----------------------------------------------------------------------------------------------------
// Of the variants with this value of the parameter that whose other values are nearest to the present ones.
function choose(p, value) {
  const far = v => data.parameters.reduce((sum, q) => sum + (q === p ? 0 : (Math.abs(indexOf(q, v) - indexOf(q, present)) / q.values.length)), 0);
  const candidates = data.variants.filter(v => v.values[p.name] === value);
  present = candidates.reduce((best, v) => far(v) < far(best) ? v : best);
  show();
}

function chooseByAddress() {
  const wanted = Object.fromEntries(decodeURIComponent(location.hash.slice(1)).split(",").map(part => part.split("=")));
  const agrees = v => data.parameters.every(p => !(p.name in wanted) || v.values[p.name] === wanted[p.name]);
  present = data.variants.find(agrees) ?? data.variants.find(v => v.status === "finished") ?? present;
}

function build() {
  data.parameters.forEach((p, k) => {
    element(byId("sliders"), "label", {for: `slider-${k}`, title: p.meaning}, p.meaning ? `${p.name}: ${p.meaning}` : p.name);
    const slider = element(byId("sliders"), "input", {id: `slider-${k}`, type: "range", min: 0, max: p.values.length - 1});
    slider.oninput = () => { byId("against").value = k; choose(p, p.values[Number(slider.value)]); };
    element(byId("sliders"), "output", {id: `value-${k}`});
    element(byId("against"), "option", {value: k}, p.name);
  });
  for (const name of new Set(data.variants.flatMap(v => Object.keys(v.pictures)))) element(byId("picture"), "option", {value: name}, name);
  const stress = [...byId("picture").options].find(o => /^stress(?!-error)/.test(o.value));
  if (stress) byId("picture").value = stress.value;
  if (!byId("picture").options.length) element(byId("picture"), "option", {value: ""}, "none drawn; make explore draws them");
  const changing = name => new Set(data.variants.map(v => (v.results.find(r => r[0] === name) ?? [])[1])).size > 1;
  for (const name of new Set(data.variants.flatMap(v => v.results.map(r => r[0])))) if (changing(name)) element(byId("quantity"), "option", {value: name}, name);
  byId("picture").onchange = showPicture;
  byId("quantity").onchange = byId("against").onchange = showTrend;
}

build();
chooseByAddress();
show();
