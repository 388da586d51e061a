// Plots of the page, by plotly.js.
const COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8a6d3b", "#555555", "#7b4fa3", "#b8860b"];
const LAYOUT = {font: {size: 16}, margin: {l: 85, r: 20, t: 20, b: 65}, hovermode: "closest", plot_bgcolor: "#fff"};
const CONFIG = {responsive: true, displaylogo: false};
const MARK = "#E69F00";

function plot(id, traces, x, y, more = {}) {
  byId(id).hidden = false;
  const axis = title => ({title: {text: title}, gridcolor: "#ddd", zeroline: false, linecolor: "#444", mirror: true, automargin: true, ...(more[title] ?? {})});
  Plotly.react(byId(id), traces, {...LAYOUT, showlegend: false, ...more.layout, xaxis: {...axis(x), ...more.xaxis}, yaxis: {...axis(y), ...more.yaxis}}, CONFIG);
}
const empty = (id, words) => { Plotly.purge(byId(id)); byId(id).replaceChildren(); byId(id).textContent = words; byId(id).hidden = !words; };
const resultName = () => byId("result").value;
const axisOf = name => withUnit(name, (data.results.find(r => r.name === name) ?? {}).unit);
const axisOfParameter = p => withUnit(p.name, p.unit);
const spaced = p => numeric(p) ? {type: p.spacing === "log" ? "log" : "linear"} : {type: "category", categoryarray: p.values};
const known = (...names) => good.filter(v => names.every(n => v.results[n] !== null));
const dots = (vs, x, y) => ({x, y, mode: "markers", text: vs.map(labelOf), hovertemplate: "%{text}<br>%{y:.5g}<extra></extra>",
  marker: {size: vs.map(v => marked.has(v) ? 15 : 9), color: vs.map(v => marked.has(v) ? MARK : COLORS[0]), line: {width: 1, color: "#fff"}}});

function drawEffects() {
  const name = resultName(), vs = known(name), surface = (data.analysis[name] ?? {}).surface;
  byId("effectplots").replaceChildren();
  data.parameters.forEach((_, k) => element(byId("effectplots"), "div", {class: "plot", id: `effect-${k}`}));
  data.parameters.forEach((p, k) => {
    const xs = vs.map(v => numeric(p) ? Number(v.values[p.name]) : v.values[p.name]), ys = vs.map(v => v.results[name]);
    const means = p.values.map(t => vs.filter(v => v.values[p.name] === t).map(v => v.results[name])).map(a => a.length ? a.reduce((s, y) => s + y, 0) / a.length : null);
    const line = 2 * p.values.length > vs.length && surface && surface.lines[p.name] ? {x: surface.axes[p.name], y: surface.lines[p.name]}
      : {x: p.values.map(t => numeric(p) ? Number(t) : t).filter((_, i) => means[i] !== null), y: means.filter(y => y !== null)};
    plot(`effect-${k}`, [{...line, mode: "lines", line: {color: COLORS[1], width: 3}, hoverinfo: "skip"}, dots(vs, xs, ys)], axisOfParameter(p), axisOf(name), {xaxis: spaced(p)});
  });
}

function drawSensitivity() {
  const name = resultName(), {sobol, surface} = data.analysis[name] ?? {};
  const words = byId("sensitivitywords");
  if (!sobol) {
    words.textContent = surface ? `None: the response surface predicts too little of ${name} (${Math.round(100 * surface.share)} % of its variance).`
      : "None: too few finished variants, a result that does not change, or words among the values.";
    return empty("sensitivityplot", "");
  }
  words.textContent = `Sobol indices of the response surface, which predicts ${percent(surface.share)} of the variance of ${name}: its share that a parameter makes alone (first order), `
    + "and together with the others (total), all even in their ranges.";
  const bar = (kind, values, color) => ({type: "bar", orientation: "h", name: kind, y: sobol.names, x: values, marker: {color}, text: values.map(v => v.toFixed(2)), textposition: "outside", cliponaxis: false});
  plot("sensitivityplot", [bar("total", sobol.total, "#9ecae1"), bar("first order", sobol.first, COLORS[0])], "share of the variance", "",
    {layout: {showlegend: true, legend: {traceorder: "reversed"}}, xaxis: {range: [0, 1.15 * Math.max(1, ...sobol.total)]}, yaxis: {type: "category", autorange: "reversed"}});
}

function drawMorris() {
  const name = resultName(), effects = (data.analysis[name] ?? {}).effects, count = effects ? effects.number.reduce((s, n) => s + n, 0) : 0;
  byId("morriswords").textContent = count ? `Elementary effects (Morris), from ${count} pairs of neighbors that differ in one parameter alone: how much ${name} would change over the whole range. `
    + "Right: it matters. High up: its effect changes along the range or with the other parameters."
    : "Elementary effects (Morris): none, as no two finished variants differ in one numeric parameter alone; first:last:morris draws such ones.";
  if (!count) return empty("morrisplot", "");
  const used = effects.names.map((n, k) => k).filter(k => effects.number[k] > 0), of = values => used.map(k => values[k]), unit = axisOf(name).replace(name, "").trim();
  const reach = values => [0, 1.2 * Math.max(...of(values)) || 1];
  plot("morrisplot", [{x: of(effects.mean), y: of(effects.deviation), text: of(effects.names), mode: "markers+text", textposition: "top center", cliponaxis: false, marker: {size: 13, color: COLORS[0]},
    customdata: of(effects.number), hovertemplate: "%{text}: mean size %{x:.5g}, standard deviation %{y:.5g}, %{customdata} pairs<extra></extra>"}],
  `mean size ${unit}`, `standard deviation ${unit}`, {xaxis: {range: reach(effects.mean)}, yaxis: {range: reach(effects.deviation)}});
}
const percent = share => `${(100 * share).toFixed(share > 0.995 ? 2 : 0)} %`;

function drawSurface() {
  const name = resultName(), surface = (data.analysis[name] ?? {}).surface;
  byId("pairs").hidden = !surface || surface.pairs.length < 2;
  if (!surface) {
    byId("surfacewords").textContent = "None: too few finished variants, a result that does not change, or words among the values.";
    return empty("surfaceplot", "");
  }
  const unit = (data.results.find(r => r.name === name) ?? {}).unit ?? "";
  byId("surfacewords").textContent = `${surface.kind[0].toUpperCase()}${surface.kind.slice(1)}. Its error where each variant is left out in turn: ${short(surface.error)} ${unit}; `
    + (surface.share > 0 ? `it predicts ${percent(surface.share)} of the variance.` : "no better than the mean: do not read it.")
    + (surface.pairs.length > 1 ? " Parameters that are not shown are at the middles of their ranges." : "");
  const parameter = n => data.parameters.find(p => p.name === n), vs = known(name);
  if (!surface.pairs.length) {
    const p = parameter(Object.keys(surface.lines)[0]);
    return plot("surfaceplot", [{x: surface.axes[p.name], y: surface.lines[p.name], mode: "lines", line: {color: COLORS[1], width: 3}, hoverinfo: "skip"},
      dots(vs, vs.map(v => Number(v.values[p.name])), vs.map(v => v.results[name]))], axisOfParameter(p), axisOf(name), {xaxis: spaced(p)});
  }
  const pair = surface.pairs[Number(byId("pair").value) || 0] ?? surface.pairs[0], [p, q] = [parameter(pair.x), parameter(pair.y)];
  const points = dots(vs, vs.map(v => Number(v.values[p.name])), vs.map(v => Number(v.values[q.name])));
  points.text = vs.map(v => `${labelOf(v)}<br>${name} ${short(v.results[name])}`);
  points.hovertemplate = "%{text}<extra></extra>";
  points.marker.color = vs.map(v => marked.has(v) ? MARK : "#fff");
  points.marker.line = {width: 2, color: "#222"};
  plot("surfaceplot", [{type: "contour", x: surface.axes[p.name], y: surface.axes[q.name], z: pair.z, colorscale: "Viridis", contours: {showlabels: true, labelfont: {size: 15, color: "#fff"}},
    colorbar: {title: {text: axisOf(name), side: "right"}}, hovertemplate: `${p.name} %{x:.4g}, ${q.name} %{y:.4g}<br>%{z:.5g}<extra></extra>`}, points],
  axisOfParameter(p), axisOfParameter(q), {xaxis: {...spaced(p), autorange: false, range: ends(surface.axes[p.name], p)}, yaxis: {...spaced(q), autorange: false, range: ends(surface.axes[q.name], q)}});
}
function ends(values, p) {
  const of = v => p.spacing === "log" ? Math.log10(v) : v, [a, b] = [of(values[0]), of(values[values.length - 1])], room = 0.04 * (b - a);
  return [a - room, b + room];
}

function frontOf(vs, x, y, sx, sy) {
  const at = v => [sx * v.results[x], sy * v.results[y]];
  return vs.filter(v => !vs.some(w => at(w)[0] <= at(v)[0] && at(w)[1] <= at(v)[1] && (at(w)[0] < at(v)[0] || at(w)[1] < at(v)[1])));
}

function drawPareto() {
  const [x, y] = [byId("paretox").value, byId("paretoy").value], vs = known(x, y);
  const front = frontOf(vs, x, y, Number(byId("sensex").value), Number(byId("sensey").value)).sort((a, b) => a.results[x] - b.results[x]);
  const line = {x: front.map(v => v.results[x]), y: front.map(v => v.results[y]), mode: "lines+markers", line: {color: COLORS[1], width: 3}, marker: {size: 15, color: COLORS[1]}, hoverinfo: "skip"};
  plot("paretoplot", [line, dots(vs, vs.map(v => v.results[x]), vs.map(v => v.results[y]))], axisOf(x), axisOf(y));
  byId("front").textContent = `On the front: ${front.map(labelOf).join("; ")}.`;
}

function drawHistories() {
  const [x, y] = [byId("historyx").value, byId("historyy").value], label = n => (data.columns.find(c => c.name === n) ?? {}).label ?? n;
  const vs = data.variants.filter(v => v.curves[x] && v.curves[y]), gray = marked.size > 0 && vs.some(v => marked.has(v));
  const traces = vs.map((v, k) => ({x: v.curves[x], y: v.curves[y], name: labelOf(v) + (v.status === "finished" ? "" : " (failed)"), mode: "lines", hovertemplate: "%{y:.5g}",
    line: {width: gray && marked.has(v) ? 4 : 2, color: gray && !marked.has(v) ? "#ccc" : COLORS[k % COLORS.length], dash: ["solid", "dash", "dot", "dashdot"][Math.floor(k / COLORS.length) % 4]}}));
  traces.sort((a, b) => a.line.width - b.line.width); // marked ones over the others
  const measured = (data.answer ?? {}).measured;
  if (measured && measured[x] && measured[y]) {
    const factor = n => data.columns.find(c => c.name === n).factor;
    traces.push({x: measured[x].map(v => v * factor(x)), y: measured[y].map(v => v * factor(y)), name: "measured", mode: "markers", marker: {size: 11, color: "#222", symbol: "x"}});
  }
  plot("historyplot", traces, label(x), label(y), {layout: {showlegend: vs.length <= 40, legend: {font: {size: 14}}}});
}

function drawAll() {
  if (!window.Plotly) return;
  if (data.results.length) { drawEffects(); drawSensitivity(); drawMorris(); drawSurface(); drawPareto(); }
  if (data.columns.length) drawHistories();
}

function fillChoices() {
  const changing = data.results.filter(r => new Set(known(r.name).map(v => v.results[r.name])).size > 1), listed = changing.length ? changing : data.results;
  for (const id of ["result", "paretox", "paretoy"]) for (const r of listed) element(byId(id), "option", {value: r.name}, withUnit(r.name, r.unit));
  if (listed.length > 1) byId("paretoy").selectedIndex = 1;
  for (const id of ["historyx", "historyy"]) for (const c of data.columns) element(byId(id), "option", {value: c.name}, c.label === c.name ? c.name : `${c.name}: ${c.label}`);
  byId("historyx").value = data.columns.some(c => c.name === "t") ? "t" : byId("historyx").value;
  const own = data.columns.find(c => c.name !== "t"), measured = Object.keys((data.answer ?? {}).measured ?? {});
  if (own) byId("historyy").value = own.name;
  if (measured.length) [byId("historyx").value, byId("historyy").value] = measured;
  const pairs = Object.values(data.analysis).map(a => (a.surface ?? {}).pairs ?? []).sort((a, b) => b.length - a.length)[0] ?? [];
  pairs.forEach((pair, k) => element(byId("pair"), "option", {value: k}, `${pair.x} and ${pair.y}`));
  byId("result").onchange = drawAll;
  byId("pair").onchange = drawSurface;
  for (const id of ["paretox", "paretoy", "sensex", "sensey"]) byId(id).onchange = drawPareto;
  for (const id of ["historyx", "historyy"]) byId(id).onchange = drawHistories;
}

// plotly.js is packed: unpacked and run after the rest stands there.
async function unpack() {
  const packed = byId("plotly").textContent.trim();
  if (!packed || !window.DecompressionStream) throw new Error("no plots");
  const bytes = Uint8Array.from(atob(packed), c => c.charCodeAt(0));
  const code = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
  element(document.head, "script", {}, code);
}

showSummary();
showTable();
showScale();
showCards();
fillChoices();
byId("csv").onclick = () => save(`${data.name}.csv`, csv());
byId("markdown").onclick = () => save(`${data.name}.md`, markdown());
unpack().then(() => { drawAll(); document.body.dataset.drawn = "1"; }, () => { byId("noplots").hidden = false; });
