"use strict";
// Draws the data of a check. All texts go in through textContent, never as markup.
const D = JSON.parse(document.getElementById("data").textContent);
const M = D.moves, R = D.regions, $ = id => document.getElementById(id);
const svgns = "http://www.w3.org/2000/svg";
function el(tag, cls, text) { const e = document.createElement(tag); if (cls) e.className = cls; if (text !== undefined) e.textContent = text; return e; }
function sv(tag, attributes) { const e = document.createElementNS(svgns, tag); for (const k in attributes) e.setAttribute(k, attributes[k]); return e; }
const mm = v => v === null || v === undefined ? "?" : v.toFixed(3);

// ---- moves: start points, path pieces, which line runs which moves
const start = [], piece = [], ofLine = new Map();
const endOf = i => i < 0 ? [null, null] : [M.p[2 * i], M.p[2 * i + 1]];
const known = p => p && p[0] !== null && p[1] !== null;
const lineKey = (f, l) => f + ":" + l;
function arcPiece(from, to, arc) {
  const parts = Math.max(1, Math.ceil(Math.abs(arc[2]) / 2)), r = Math.hypot(from[0] - arc[0], from[1] - arc[1]);
  let d = "";
  for (let k = 1; k <= parts; ++k) {
    const a = -arc[2] * k / parts, c = Math.cos(a), s = Math.sin(a), x = from[0] - arc[0], y = from[1] - arc[1];
    const p = k === parts ? to : [arc[0] + c * x - s * y, arc[1] + s * x + c * y];
    d += "A" + r + " " + r + " 0 0 " + (arc[2] > 0 ? 0 : 1) + " " + p[0] + " " + p[1];
  }
  return d;
}
function viaPiece(via) {
  let d = "";
  for (let k = 0; via && k < via.length; k += 2) d += "L" + via[k] + " " + via[k + 1];
  return d;
}
for (let i = 0; i < M.n; ++i) {
  const from = M.start[i] || endOf(i - 1), to = endOf(i);
  start.push(from);
  piece.push(!known(from) || !known(to) ? "" : "M" + from[0] + " " + from[1] + (M.arc[i] ? arcPiece(from, to, M.arc[i]) : viaPiece(M.via[i]) + "L" + to[0] + " " + to[1]));
  const key = lineKey(M.f[i], M.l[i]);
  if (M.f[i] >= 0) ofLine.has(key) ? ofLine.get(key).push(i) : ofLine.set(key, [i]);
}

// ---- head
const signs = { "clean": "✓", "findings": "✗", "not-fully-checked": "?" };
$("head").className = D.head.verdict;
$("sign").textContent = signs[D.head.verdict];
$("line").textContent = D.head.line;
$("about").textContent = [D.head.program, D.head.control && "control " + D.head.control, "machine " + D.head.machine, D.head.date].filter(Boolean).join("  ·  ");
if (D.unchecked.length) {
  const list = el("ul"), most = 3;
  for (const n of D.unchecked.slice(0, most)) list.append(el("li", "", n.text + (n.where ? " (" + n.where.n + ":" + n.where.l + ")" : "")));
  if (D.unchecked.length > most) list.append(el("li", "", `and ${D.unchecked.length - most} more, listed below`));
  $("why").append("Not checked:", list);
}
$("foot").textContent = "obrys " + D.head.version + ". Lengths in mm, X is a radius; profiles of lines and arcs are exact, nothing is sampled. "
  + "Wheel: zoom. Drag: move. Click a move, a finding or a line: the others follow.";

// ---- view: screen = scale * (z, -x) + shift
const view = { s: 1, x: 0, y: 0 };
let box = null;
function bounds() {
  $("before").setAttribute("d", R.before); $("clamp").setAttribute("d", R.clamp); $("part").setAttribute("d", R.part); $("allowance").setAttribute("d", R.allowance);
  let b = null;
  const add = (x, y) => b = b ? [Math.min(b[0], x), Math.min(b[1], y), Math.max(b[2], x), Math.max(b[3], y)] : [x, y, x, y];
  for (const id of ["before", "part"]) if ($(id).getAttribute("d")) { const r = $(id).getBBox(); add(r.x, r.y); add(r.x + r.width, r.y + r.height); }
  if (b && R.clamp) {  // a chuck is seen as one where it cannot be shown whole
    const r = $("clamp").getBBox(), e = Math.max(b[2] - b[0], b[3] - b[1]) * 0.36, l = [b[0] - e, b[1] - e, b[2] + e, b[3] + e];
    const x = [Math.max(r.x, l[0]), Math.min(r.x + r.width, l[2])], y = [Math.max(r.y, l[1]), Math.min(r.y + r.height, l[3])];
    if (x[0] < x[1] && y[0] < y[1]) { add(x[0], y[0]); add(x[1], y[1]); }
  }
  // Rapids may come from far away: of them the way in is enough. What is cut is shown, wherever it lies.
  if (b) for (let i = 0; i < M.n; ++i) if (M.kind[i] !== "r") for (const p of [M.start[i] || endOf(i - 1), endOf(i)]) if (known(p)) add(p[0], p[1]);
  const fixed = b && b.slice(), size = b ? Math.max(b[2] - b[0], b[3] - b[1]) * 0.12 : 0;
  for (let i = 0; i < M.n; ++i) {
    const p = endOf(i);
    if (!known(p)) continue;
    if (!fixed) for (let k = 0, via = M.via[i] || []; k < via.length; k += 2) add(via[k], via[k + 1]);
    fixed ? add(Math.min(Math.max(p[0], fixed[0] - size), fixed[2] + size), Math.min(Math.max(p[1], fixed[1] - size), fixed[3] + size)) : add(p[0], p[1]);
  }
  return b || [0, -50, 100, 0];
}
let shown = null;  // what was last zoomed to
function zoomTo(b) {
  shown = b;
  const w = $("svg").clientWidth, h = $("svg").clientHeight, left = 58, low = 38, air = 20;
  view.s = Math.min((w - left - air) / Math.max(b[2] - b[0], 1e-6), (h - low - air) / Math.max(b[3] - b[1], 1e-6));
  view.x = left + (w - left - air - view.s * (b[2] - b[0])) / 2 - view.s * b[0];
  view.y = air + (h - low - air - view.s * (b[3] - b[1])) / 2 - view.s * b[1];
  drawView();
}
function niceStep(raw) { const p = Math.pow(10, Math.floor(Math.log10(raw))); return [1, 2, 5, 10].find(k => raw <= k * p) * p; }
function drawView() {
  $("world").setAttribute("transform", `matrix(${view.s} 0 0 ${view.s} ${view.x} ${view.y})`);
  const w = $("svg").clientWidth, h = $("svg").clientHeight, grid = [], axes = [], step = niceStep(80 / view.s), digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  axes.push(sv("rect", { x: 0, y: h - 26, width: w, height: 26, fill: "#fff", opacity: .85 }), sv("rect", { x: 0, y: 0, width: 50, height: h, fill: "#fff", opacity: .85 }));
  const label = (x, y, text, anchor) => { const t = sv("text", { x, y, "text-anchor": anchor }); t.textContent = text; axes.push(t); };
  for (let k = Math.ceil((50 - view.x) / view.s / step); k * step <= (w - view.x) / view.s; ++k) {
    const x = view.x + view.s * k * step;
    grid.push(sv("line", { class: "gridline", x1: x, y1: 0, x2: x, y2: h })); axes.push(sv("line", { class: "tick", x1: x, y1: h - 26, x2: x, y2: h - 21 }));
    label(x, h - 8, (k * step).toFixed(digits), "middle");
  }
  for (let k = Math.ceil((26 - h + view.y) / view.s / step); k * step <= view.y / view.s; ++k) {
    const y = view.y - view.s * k * step;
    grid.push(sv("line", { class: k === 0 ? "centre" : "gridline", x1: 50, y1: y, x2: w, y2: y })); axes.push(sv("line", { class: "tick", x1: 45, y1: y, x2: 50, y2: y }));
    label(43, y + 4, (k * step).toFixed(digits), "end");
  }
  label(w - 6, h - 30, "Z mm →", "end"); label(54, 14, "↑ X mm (radius)", "start");
  $("grid").replaceChildren(...grid); $("axes").replaceChildren(...axes);
  drawMarks();
}

// ---- findings in the picture
const badOf = new Map();
for (const f of D.findings) if (f.region) {
  const p = sv("path", { class: "bad", d: f.region, "fill-rule": "evenodd" });
  p.addEventListener("click", () => pickFinding(f, false));
  $("bad").append(p); badOf.set(f.no, p);
}
const byNumber = new Map(D.findings.map(f => [f.no, f]));
D.marks.forEach((m, k) => { const next = D.marks[k + 1]; for (const f of D.findings) if (f.no >= m.no && (!next || f.no < next.no)) f.mark = m; });
let active = null;
function drawMarks() {
  const taken = [], out = [], w = $("svg").clientWidth, h = $("svg").clientHeight;
  for (const m of D.marks.slice(0, 60)) {
    const x = view.x + view.s * m.at[0], y = view.y + view.s * m.at[1], half = m.label.length > 2 ? 6 + 3.3 * m.label.length : 9.5;
    if (x < 0 || y < 0 || x > w || y > h) continue;
    let cx = x + 24, cy = y - 20;
    for (let k = 0; k < 300 && taken.some(t => Math.abs(t[0] - cx) < 34 && Math.abs(t[1] - cy) < 21); ++k) { const a = -.78 + k * .45, r = 30 + k * 1.8; cx = x + r * Math.cos(a); cy = y + r * Math.sin(a); }
    taken.push([cx, cy]);
    const first = byNumber.get(m.no), on = active && active.mark === m;
    const c = sv("rect", { class: "mark" + (on ? " on" : ""), x: cx - half, y: cy - 9.5, width: 2 * half, height: 19, rx: 9.5 }), t = sv("text", { class: "no", x: cx, y: cy + 4 });
    t.textContent = m.label; c.addEventListener("click", () => pickFinding(first, false));
    out.push(sv("line", { class: "leader", x1: x, y1: y, x2: cx, y2: cy }), c, t);
  }
  $("marks").replaceChildren(...out);
}

// ---- stock, path and tool after `done` moves
let done = M.n;
const layers = { stock: true, clamp: true, part: true, allowance: true, feed: true, rapid: true, "path only so far": false, tool: true };
function show(n) {
  done = Math.max(0, Math.min(M.n, n));
  $("slider").value = done;
  let base = R.before, from = 0;
  for (const s of R.snapshots) if (s[0] <= done) { base = s[1]; from = s[0]; }
  let cut = "";
  if (done === M.n && D.head.moves_all === M.n && R.after) base = R.after;
  else for (let i = from; i < done; ++i) cut += M.removed[i] || "";
  $("stock").setAttribute("d", base); $("removed").setAttribute("d", cut);
  drawPath(); drawTool(); drawStatus();
}
let drawnTo = -1;
function drawPath() {
  const end = layers["path only so far"] ? done : M.n;
  if (end === drawnTo) return;
  drawnTo = end;
  let rapid = "", feed = "";
  for (let i = 0; i < end; ++i) M.kind[i] === "r" ? rapid += piece[i] : feed += piece[i];
  $("rapid").setAttribute("d", rapid); $("feed").setAttribute("d", feed);
}
function drawTool() {
  const p = endOf(done - 1), tool = done > 0 && M.t[done - 1] ? D.tools[M.t[done - 1] - 1] : null;
  const visible = layers.tool && tool && known(p) && done > 0 && done < M.n;
  for (const [id, d] of [["holder", "holder"], ["tool", "outline"]]) {
    $(id).setAttribute("d", visible ? tool[d] : "");
    if (visible) $(id).setAttribute("transform", `translate(${p[0]} ${p[1]})`);
  }
}
function drawStatus() {
  const box = $("status"); box.replaceChildren();
  if (done === 0) return box.append(el("span", "", M.n ? `before the first of ${M.n} moves` : "no moves to show"));
  const i = done - 1, a = start[i], b = endOf(i), where = M.f[i] >= 0 ? D.files[M.f[i]].name + ":" + M.l[i] : "";
  const x = p => p[1] === null ? null : -p[1];
  box.append(el("b", "", `move ${i} of ${M.n}: ${M.kind[i] === "r" ? "rapid" : "feed"}`), ` from Z ${mm(a[0])} X ${mm(x(a))} to Z ${mm(b[0])} X ${mm(x(b))} mm`);
  if (M.a[i] > 0) box.append(`, removes ${mm(M.a[i])} mm2, ${mm(M.d[i])} mm deep along X`);
  box.append(el("br"), lineLink({ f: M.f[i], l: M.l[i], n: where.replace(/:\d+$/, "") }));
  for (const s of M.stacks[M.k[i]] || []) box.append(" ← ", lineLink(s));
}

// ---- program text
const rows = new Map(); let shownFile = -1;
const tabs = [], texts = [];
D.files.forEach((file, f) => {
  const tab = el("button", "", file.name.replace(/^.*[\\/]/, "")); tab.title = file.name; tab.onclick = () => openFile(f);
  const text = el("div", "text"); text.hidden = true;
  file.lines.forEach((line, n) => {
    const row = el("div", "ln"), key = lineKey(f, n + 1);
    row.append(el("i", "", n + 1), el("span", "", line || " "));
    if (ofLine.has(key)) { row.classList.add("runs"); row.onclick = () => pickLine(f, n + 1); row.title = ofLine.get(key).length + " moves"; }
    rows.set(key, row); text.append(row);
  });
  if (file.cut) text.append(el("div", "none", `${file.cut} more lines are not shown here`));
  tabs.push(tab); texts.push(text); $("tabs").append(tab); $("texts").append(text);
});
for (const f of D.findings) if (f.where && rows.has(lineKey(f.where.f, f.where.l))) rows.get(lineKey(f.where.f, f.where.l)).classList.add("has");
function openFile(f) {
  if (f < 0 || f >= texts.length || f === shownFile) return;
  shownFile = f;
  texts.forEach((t, k) => t.hidden = k !== f); tabs.forEach((t, k) => t.classList.toggle("on", k === f));
}
let litRow = null;
function lightLine(f, l, scroll) {
  if (litRow) litRow.classList.remove("on");
  litRow = rows.get(lineKey(f, l)) || null;
  if (!litRow) return;
  openFile(f); litRow.classList.add("on");
  if (scroll) { const box = texts[f]; box.scrollTop += litRow.getBoundingClientRect().top - box.getBoundingClientRect().top - box.clientHeight / 2; }
}
function lineLink(site) {
  if (!site) return el("span", "", "");
  const a = el("a", "line", site.n + ":" + site.l + (site.b !== undefined ? " (block " + site.b + ")" : ""));
  a.onclick = e => { e.stopPropagation(); lightLine(site.f, site.l, true); };
  return a;
}

// ---- picking
let lastLine = "", turn = 0;
function choose(moves) { $("chosen").setAttribute("d", moves.map(i => piece[i]).join("")); }
function unpickFinding() {
  if (!active) return;
  if (badOf.has(active.no)) badOf.get(active.no).classList.remove("on");
  active.card.classList.remove("on"); active = null;
}
function pickMove(i) { unpickFinding(); choose([i]); show(i + 1); lightLine(M.f[i], M.l[i], true); drawMarks(); }
function pickLine(f, l) {
  const moves = ofLine.get(lineKey(f, l)); if (!moves) return;
  turn = lastLine === lineKey(f, l) ? (turn + 1) % moves.length : 0; lastLine = lineKey(f, l);
  unpickFinding(); choose(moves); show(moves[turn] + 1); lightLine(f, l, false); drawMarks();
  $("status").prepend(el("span", "", `pass ${turn + 1} of ${moves.length} of this line: `));
}
function pickFinding(f, zoom) {
  unpickFinding(); active = f; f.card.classList.add("on"); f.card.scrollIntoView({ block: "nearest" });
  if (f.move !== null && f.move < M.n) { choose([f.move]); show(f.code === "rest-material" ? M.n : f.move + 1); }
  if (f.where) lightLine(f.where.f, f.where.l, true);
  const bad = badOf.get(f.no);
  if (bad) bad.classList.add("on");
  if (zoom && bad) { const r = bad.getBBox(), k = Math.max(r.width, r.height, 4) * 1.2; zoomTo([r.x - k, r.y - k, r.x + r.width + k, r.y + r.height + k]); }
  else drawMarks();
}
/** Another move of the same finding. */
function pickPass(f, move) {
  if (move >= M.n) return;
  choose([move]); show(f.code === "rest-material" ? M.n : move + 1); lightLine(M.f[move], M.l[move], true);
  $("status").prepend(el("span", "", `pass ${f.turn + 1} of ${f.moves.length} of this finding: `));
}
function nearest(px, py) {
  let best = -1, least = 9;
  const ofSegment = (x1, y1, x2, y2) => {
    const dx = x2 - x1, dy = y2 - y1, t = Math.max(0, Math.min(1, ((px - x1) * dx + (py - y1) * dy) / (dx * dx + dy * dy || 1)));
    return Math.hypot(px - x1 - t * dx, py - y1 - t * dy);
  };
  for (let i = 0; i < M.n; ++i) {
    if (!piece[i] || !layers[M.kind[i] === "r" ? "rapid" : "feed"]) continue;
    const a = start[i], b = endOf(i), arc = M.arc[i];
    let d;
    if (arc) d = Math.abs(Math.hypot(px - view.x - view.s * arc[0], py - view.y - view.s * arc[1]) - view.s * Math.hypot(a[0] - arc[0], a[1] - arc[1]))
      + Math.max(0, ofSegment(view.x + view.s * a[0], view.y + view.s * a[1], view.x + view.s * b[0], view.y + view.s * b[1]) - view.s * Math.hypot(a[0] - arc[0], a[1] - arc[1]));
    else {
      const chain = [a[0], a[1], ...(M.via[i] || []), b[0], b[1]];
      d = Infinity;
      for (let k = 2; k < chain.length; k += 2)
        d = Math.min(d, ofSegment(view.x + view.s * chain[k - 2], view.y + view.s * chain[k - 1], view.x + view.s * chain[k], view.y + view.s * chain[k + 1]));
    }
    if (d < least) { least = d; best = i; }
  }
  return best;
}

// ---- mouse, slider, keys
let drag = null;
$("svg").addEventListener("wheel", e => {
  e.preventDefault();
  const r = $("svg").getBoundingClientRect(), x = e.clientX - r.left, y = e.clientY - r.top, k = Math.exp(-e.deltaY * (e.deltaMode ? .05 : .0015));
  const s = Math.max(1e-3, Math.min(1e5, view.s * k)), q = s / view.s;
  view.x = x - q * (x - view.x); view.y = y - q * (y - view.y); view.s = s; drawView();
}, { passive: false });
$("svg").addEventListener("pointerdown", e => drag = { x: e.clientX, y: e.clientY, vx: view.x, vy: view.y, moved: false });
window.addEventListener("pointermove", e => {
  if (!drag) return;
  if (Math.hypot(e.clientX - drag.x, e.clientY - drag.y) > 4) drag.moved = true;
  if (drag.moved) { view.x = drag.vx + e.clientX - drag.x; view.y = drag.vy + e.clientY - drag.y; drawView(); }
});
window.addEventListener("pointerup", e => {
  if (drag && !drag.moved && e.target.closest("#svg") && !e.target.closest(".mark,.bad")) {
    const r = $("svg").getBoundingClientRect(), i = nearest(e.clientX - r.left, e.clientY - r.top);
    if (i >= 0) pickMove(i);
  }
  drag = null;
});
$("slider").max = M.n;
const goTo = n => { stop(); show(n); const i = done - 1; choose(i >= 0 ? [i] : []); if (i >= 0) lightLine(M.f[i], M.l[i], true); };
$("slider").oninput = e => goTo(+e.target.value);
$("back").onclick = () => goTo(done - 1);
$("next").onclick = () => goTo(done + 1);
$("fit").onclick = () => zoomTo(box);
let timer = 0, last = 0, owed = 0;
function stop() { if (timer) cancelAnimationFrame(timer); timer = 0; $("play").textContent = "play"; }
function tick(now) {
  owed += (now - last) / 1000 * +$("speed").value; last = now;
  if (owed >= 1) { const n = Math.floor(owed); owed -= n; show(done + n); const i = done - 1; choose([i]); lightLine(M.f[i], M.l[i], true); }
  if (done >= M.n) return stop();
  timer = requestAnimationFrame(tick);
}
$("play").onclick = () => {
  if (timer) return stop();
  if (done >= M.n) show(0);
  last = performance.now(); owed = 0; $("play").textContent = "stop"; timer = requestAnimationFrame(tick);
};
const parts = { stock: ["before", "stock", "removed"], clamp: ["clamp"], part: ["part"], allowance: ["allowance"], feed: ["feed"], rapid: ["rapid"], tool: [], "path only so far": [] };
for (const name in layers) {
  if ((name === "allowance" && !R.allowance) || (name === "part" && !R.part) || (name === "clamp" && !R.clamp) || (name === "stock" && !R.before)) continue;
  const label = el("label"), check = el("input"); check.type = "checkbox"; check.checked = layers[name];
  check.onchange = () => { layers[name] = check.checked; for (const id of parts[name]) $(id).style.display = check.checked ? "" : "none"; drawnTo = -1; show(done); };
  label.append(check, name); $("layers").append(label);
}
function legend(draw, text) {
  const span = el("span"), s = sv("svg", { width: 30, height: 14 });
  s.append(draw); span.append(s, text); $("legend").append(span);
}
if (R.before) { legend(sv("rect", { x: 1, y: 1, width: 28, height: 12, fill: "#c9d3dc", stroke: "#4a5560" }), "stock"); legend(sv("rect", { x: 1, y: 1, width: 28, height: 12, fill: "#f6f1e4", stroke: "#8a8a8a", "stroke-dasharray": "2 3" }), "removed"); }
if (R.clamp) legend(sv("rect", { x: 1, y: 1, width: 28, height: 12, fill: "#e2b9c2", stroke: "#7a3040" }), "clamp");
if (R.part) legend(sv("path", { d: "M0 7H30", stroke: "#000", "stroke-width": 2 }), "finished part");
if (R.allowance) legend(sv("path", { d: "M0 7H30", stroke: "#000", "stroke-dasharray": "9 4" }), "allowance");
if (M.n) { legend(sv("path", { d: "M0 7H30", stroke: "#0a8f3c", "stroke-width": 1.6 }), "feed"); legend(sv("path", { d: "M0 7H30", stroke: "#d40000", "stroke-width": 1.4, "stroke-dasharray": "5 3" }), "rapid"); }
if (badOf.size) legend(sv("rect", { x: 1, y: 1, width: 28, height: 12, fill: "#ff5fb8", stroke: "#a00060" }), "finding");

// ---- lists
$("found").textContent = D.findings.length ? `Findings (${D.findings.length}), the most dangerous first` : "Findings";
if (!D.findings.length) $("findings").append(el("div", "none", D.unchecked.length ? "Nothing was found in what could be checked." : "Nothing was found."));
for (const f of D.findings) {
  const card = el("div", "finding " + f.severity), head = el("div");
  head.append(el("b", "", f.no + "."), el("span", "code", f.code + ": "), f.text);
  card.append(head);
  if (f.where) { const at = el("div", "place"); at.append(lineLink(f.where)); if (f.move !== null) at.append(", move " + f.move); for (const s of f.stack) at.append(" ← ", lineLink(s)); card.append(at, el("pre", "", f.where.t)); }
  if (f.passes) {
    const passes = el("div", "amounts", f.passes + " ");
    if (f.moves.length > 1) {
      const next = el("a", "line", "next pass");
      next.onclick = e => { e.stopPropagation(); f.turn = ((f.turn ?? -1) + 1) % f.moves.length; pickFinding(f, false); pickPass(f, f.moves[f.turn]); };
      passes.append(next);
    }
    card.append(passes);
  }
  if (f.amounts.some(a => a[2] === "mm3")) card.append(el("div", "amounts", f.amounts.filter(a => a[2] === "mm3" || a[0] === "contact length").map(a => `${a[0]} ${a[1]} ${a[2]}`).join(", ")));
  if (f.remedy) card.append(el("div", "amounts", "Remedy: " + f.remedy));
  card.onclick = () => pickFinding(f, true); f.card = card; $("findings").append(card);
}
if (D.head.dropped) $("findings").append(el("div", "none", D.head.dropped + " further findings are counted only."));
function paper(title, content, wide) { const box = el("div", wide ? "wide" : ""); box.append(el("h2", "", title), content); $("papers").append(box); }
function noteList(notes) {
  const list = el("ul");
  for (const n of notes) {
    const item = el("li", "", n.text + (n.times > 1 ? ` (${n.times} times)` : "") + " ");
    if (n.where) item.append(lineLink(n.where));
    if (n.where && n.where.t) item.append(el("pre", "", n.where.t));
    if (n.remedy) item.append(el("div", "amounts", "Remedy: " + n.remedy));
    list.append(item);
  }
  return list;
}
function table(heads, lines) {
  const t = el("table"), h = el("tr");
  for (const [text, num] of heads) h.append(el("th", num ? "num" : "", text));
  t.append(h);
  for (const line of lines) { const r = el("tr"); line.forEach((c, k) => { const d = el("td", heads[k][1] ? "num" : ""); d.append(c); r.append(d); }); t.append(r); }
  return t;
}
if (D.unchecked.length) paper("Not checked", noteList(D.unchecked), true);
if (D.tools.length) paper("Tool sheet, in order of use", table([["T", 1], ["D", 1], ["name"], ["tool"], ["first line"], ["last line"], ["moves", 1], ["feed mm", 1], ["rapid mm", 1], ["removed cm3", 1]],
  D.tools.map(t => [t.number || "", t.edge || "", t.name, t.kind, lineLink(t.first), lineLink(t.last), t.moves, t.feed_mm, t.rapid_mm, t.volume_cm3])), true);
if (D.assumptions.length) paper("Assumed", noteList(D.assumptions));
if (D.listed.length) paper("Accepted without effect on the motion", noteList(D.listed));
paper("Figures", table([["", 0], ["", 1], ["", 0]], D.stats));
if (D.head.moves_all > M.n) paper("This page is not complete", el("p", "", `The picture shows the first ${M.n} of ${D.head.moves_all} moves; the check covered all of them.`), true);

box = bounds();
zoomTo(box); show(M.n);
openFile(D.findings.length && D.findings[0].where ? D.findings[0].where.f : 0);
if (location.hash.startsWith("#finding-")) { const f = D.findings.find(f => f.no === +location.hash.slice(9)); if (f) pickFinding(f, true); }
if (location.hash.startsWith("#move-")) pickMove(Math.min(M.n - 1, +location.hash.slice(6)));
window.addEventListener("resize", () => zoomTo(shown));
window.addEventListener("beforeprint", () => zoomTo(box));
