"use strict";
// The page of a study: table, fields, marks. What draws is page_plots.js.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = id => document.getElementById(id);
const MOST_CARDS = 24;
const good = data.variants.filter(v => v.status === "finished");
const marked = new Set();
let order = {column: null, sign: 1};

function element(parent, tag, attributes = {}, text = "") {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.textContent = text;
  parent.append(made);
  return made;
}

const numeric = p => p.values.every(v => v !== "" && Number.isFinite(Number(v)));
const withUnit = (name, unit) => unit ? `${name} [${unit}]` : name;
const labelOf = v => data.parameters.map(p => `${p.name} = ${v.values[p.name]}`).join(", ");
const short = x => x === null || x === undefined ? "" : String(Number(Number(x).toPrecision(5)));

// --- summary ------------------------------------------------------------------------------------------------------
function showSummary() {
  const failed = data.variants.filter(v => v.status !== "finished");
  const range = p => p.ends.length && data.answer ? `between ${p.ends[0]} and ${p.ends[1]}` : p.values.length > 6 ? `${p.values[0]} to ${p.values[p.values.length - 1]}` : p.values.join(", ");
  const of = data.parameters.map(p => `${p.meaning || p.name} (${p.name}) ${range(p)} ${p.unit}`.trim()).join("; ");
  byId("summary").textContent = `${data.variants.length} variants of ${data.script}: ${of}. `;
  if (failed.length) element(byId("summary"), "b", {class: "failed"}, `${failed.length} failed; their rows say why.`);
  else byId("summary").append("All finished.");
  if (!data.answer) return;
  const interval = data.answer.interval ?? {};
  const found = Object.entries(data.answer.values).map(([n, v]) => `${n} = ${v}${interval[n] ?? ""}`).join(", ");
  const asked = Object.entries(data.goals).map(([n, v]) => `${n}=${v}`).join(", ");
  byId("answer").hidden = false;
  byId("answer").textContent = `${asked}: ${found}. ${data.answer.told.join("; ")}.` + (data.answer.interval ? " +- are 95 % intervals." : "");
}

// --- table --------------------------------------------------------------------------------------------------------
// Columns: title, unit, what a cell holds.
const columns = [
  ...data.parameters.map(p => ({title: p.name, unit: p.unit, hint: p.meaning, of: v => v.values[p.name]})),
  ...data.results.map(r => ({title: r.name, unit: r.unit, hint: r.expected === null ? "" : `expected ${r.expected}`, of: v => v.results[r.name]})),
  {title: "steps", unit: "", hint: "steps of the run", of: v => v.steps ?? null},
  {title: "CPU", unit: "s", hint: "CPU seconds", of: v => v.seconds},
  {title: "status", unit: "", hint: "", of: v => v.status + (v.again ? `, again with ${v.again}` : "") + (v.reason ? `: ${v.reason}` : "")},
];

function compare(a, b) {
  const [x, y] = [order.column.of(a), order.column.of(b)];
  const empty = z => z === null || z === undefined || z === "";
  if (empty(x) || empty(y)) return empty(x) - empty(y);
  const numbers = Number.isFinite(Number(x)) && Number.isFinite(Number(y));
  return order.sign * (numbers ? Number(x) - Number(y) : String(x).localeCompare(String(y)));
}
const sorted = () => order.column ? [...data.variants].sort(compare) : [...data.variants];

const cellOf = (c, v) => typeof c.of(v) === "number" ? short(c.of(v)) : c.of(v) ?? "";

// Cells of the columns; of a run that failed the reason takes the place of its results.
function addCells(row, v) {
  const failed = v.status !== "finished", count = data.parameters.length;
  for (const c of failed ? columns.slice(0, count) : columns) element(row, "td", c.title === "status" ? {class: "words"} : {}, cellOf(c, v));
  if (failed) element(row, "td", {class: "words reason", colspan: columns.length - count}, columns[columns.length - 1].of(v));
}

function showTable() {
  byId("head").replaceChildren();
  const head = element(byId("head"), "tr");
  element(head, "th", {}, "field");
  for (const c of columns) {
    const arrow = order.column === c ? (order.sign > 0 ? " \u25b2" : " \u25bc") : "";
    const cell = element(head, "th", {title: c.hint}, c.title + arrow);
    if (c.unit) element(cell, "small", {}, c.unit);
    cell.onclick = () => { order = {column: c, sign: order.column === c ? -order.sign : 1}; showTable(); };
  }
  element(head, "th", {}, "files");
  byId("rows").replaceChildren();
  for (const v of sorted()) {
    const row = element(byId("rows"), "tr", {class: (v.status === "finished" ? "" : "failed ") + (marked.has(v) ? "marked" : "")});
    const picture = element(row, "td");
    if (v.picture) element(picture, "img", {src: v.picture, alt: `field of ${labelOf(v)}`, loading: "lazy"});
    addCells(row, v);
    const files = element(row, "td", {class: "words"});
    for (const f of v.files) { element(files, "a", {href: encodeURI(`${v.folder}/${f}`)}, f.split(".")[0]); files.append(" "); }
    row.onclick = event => { if (event.target.tagName !== "A") mark(v); };
  }
}

function texts() {
  return [columns.map(c => withUnit(c.title, c.unit)), ...sorted().map(v => columns.map(c => String(c.of(v) ?? "")))];
}
function save(name, text) {
  const link = element(document.body, "a", {download: name, href: URL.createObjectURL(new Blob([text], {type: "text/plain"}))});
  link.click();
  link.remove();
}
const quoted = t => /[",\n]/.test(t) ? `"${t.replaceAll('"', '""')}"` : t;
const csv = () => texts().map(row => row.map(quoted).join(",")).join("\n") + "\n";
function markdown() {
  const [head, ...rows] = texts().map(row => `| ${row.map(t => t.replaceAll("|", "\\|")).join(" | ")} |`);
  return [head, `|${columns.map(() => "---:|").join("")}`, ...rows].join("\n") + "\n";
}

// --- fields -------------------------------------------------------------------------------------------------------
function showScale() {
  const s = data.scale;
  byId("field").textContent = s ? `${s.label[0].toUpperCase()}${s.label.slice(1)}${s.unit ? ` [${s.unit}]` : ""} at the end of each run; the largest of all is ${s.largest}. ${s.words}`
    : "No variant left a field.";
  if (!s) return;
  s.colors.forEach((color, k) => element(element(byId("scale"), "span", {style: `background:${color}`}), "i", {}, s.levels[k]));
  element(element(byId("scale"), "span", {}), "i", {}, s.levels[s.levels.length - 1]);
}

function showCards(all = false) {
  byId("cards").replaceChildren();
  const shown = all ? data.variants : data.variants.slice(0, MOST_CARDS);
  for (const v of shown) {
    const card = element(byId("cards"), "div", {class: `card ${v.status === "finished" ? "" : "failed"} ${marked.has(v) ? "marked" : ""}`});
    element(card, "b", {}, labelOf(v));
    if (v.picture) element(card, "img", {src: v.picture, alt: `field of ${labelOf(v)}`, loading: "lazy"});
    else element(card, "span", {class: "failed"}, `${v.status}: ${v.reason}`);
    card.onclick = () => mark(v);
  }
  byId("all").hidden = shown.length === data.variants.length;
  byId("all").textContent = `Show all ${data.variants.length}`;
  byId("all").onclick = () => showCards(true);
}

function mark(v) {
  if (!marked.delete(v)) marked.add(v);
  showTable();
  showCards(byId("all").hidden);
  drawAll();
}
