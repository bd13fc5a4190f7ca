// Verdict on top, findings beside the picture, tables below it: the words and the order of the turning report.

import type { Document, Finding, Note, Site } from "./data";
import { $, el, mm } from "./dom";

export type OpenSite = (site: Site) => void;

export function siteLink(site: Site, open: OpenSite): HTMLElement {
  const a = el("a", "line", site.n + ":" + site.l);
  a.tabIndex = 0;
  a.setAttribute("role", "link");
  a.onclick = event => { event.stopPropagation(); open(site); };
  a.onkeydown = event => { if (event.key === "Enter") { event.stopPropagation(); open(site); } };
  return a;
}

const signs: Record<string, string> = { "clean": "\u2713", "findings": "\u2717", "not-fully-checked": "?" };

export function head(doc: Document) {
  const { head: h, unchecked } = doc, most = 3;
  $("head").className = h.verdict;
  $("sign").textContent = signs[h.verdict] ?? "?";
  $("line").textContent = h.line;
  $("about").textContent = [h.program, h.control && "control " + h.control, h.machine && "machine " + h.machine, h.date].filter(Boolean).join("  \u00b7  ");
  if (unchecked.length) {
    const list = el("ul");
    for (const n of unchecked.slice(0, most)) list.append(el("li", "", n.text + (n.where ? ` (${n.where.n}:${n.where.l})` : "")));
    if (unchecked.length > most) list.append(el("li", "", `and ${unchecked.length - most} more, listed below`));
    $("why").append("Not checked:", list);
  }
  const within = doc.tolerance ? ` The surface is computed to ${doc.tolerance} mm.` : "";
  $("foot").textContent = `obrys ${h.version}. Lengths in mm, workpiece coordinates.${within} Wheel: zoom. Drag: turn, with Shift or the `
    + "right button: move. Click the surface, the path, a finding or a line: the others follow. Keys in the picture: arrows turn it, with Shift "
    + "they move it, + and \u2212 zoom, Home shows everything; N and P: the next and the previous finding; in the text: arrows go from line to line, with Alt to the next line that moves, "
    + "Enter goes through the moves of a line.";
}

export class Findings {
  onPick: (finding: Finding) => void = () => {};
  onPass: (finding: Finding, move: number) => void = () => {};
  private readonly cards = new Map<Finding, HTMLElement>();

  constructor(doc: Document, private readonly numbers: Uint32Array, open: OpenSite) {
    const list = $("findings"), all = doc.findings;
    $("found").textContent = all.length ? `Findings (${all.length}), the most dangerous first` : "Findings";
    if (!all.length) list.append(el("div", "none", doc.unchecked.length ? "Nothing was found in what could be checked." : "Nothing was found."));
    for (const finding of all) list.append(this.card(doc, finding, open));
    if (doc.head.dropped) list.append(el("div", "none", doc.head.dropped + " further findings are counted only."));
  }

  private card(doc: Document, f: Finding, open: OpenSite): HTMLElement {
    const card = el("div", "finding " + f.severity), title = el("div");
    card.tabIndex = 0;
    card.setAttribute("role", "button");
    title.append(el("b", "", f.no + "."), el("span", "code", f.code + ": "), f.text);
    card.append(title);
    const place = el("div", "place");
    if (f.where) place.append(siteLink(f.where, open));
    if (f.move !== null) place.append(f.where ? ", " : "", "move " + this.numbers[f.move]);
    if (f.at) place.append(f.where || f.move !== null ? ", " : "", `at X ${mm(f.at[0])} Y ${mm(f.at[1])} Z ${mm(f.at[2])}`);
    if (place.childNodes.length) card.append(place);
    const text = f.where ? doc.texts[f.where.f].text.split(/\r\n|\n|\r/, f.where.l)[f.where.l - 1]?.trim() : "";
    if (text) card.append(el("pre", "", text));
    if (f.amounts.length) card.append(el("div", "amounts", f.amounts.map(a => a.join(" ").trim()).join(", ")));
    if (f.passes) card.append(this.passes(f));
    if (f.remedy) card.append(el("div", "amounts", "Remedy: " + f.remedy));
    card.onclick = () => this.onPick(f);
    card.onkeydown = event => {
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); this.onPick(f); }
      if (event.key === "ArrowDown") { event.preventDefault(); (card.nextElementSibling as HTMLElement | null)?.focus(); }
      if (event.key === "ArrowUp") { event.preventDefault(); (card.previousElementSibling as HTMLElement | null)?.focus(); }
    };
    this.cards.set(f, card);
    return card;
  }
  /** What its moves did together, and a way from one to the next. */
  private passes(f: Finding): HTMLElement {
    const line = el("div", "amounts", f.passes + " ");
    if (f.moves.length < 2) return line;
    const next = el("button", "", "next pass");
    let turn = -1;
    next.onclick = event => { event.stopPropagation(); turn = (turn + 1) % f.moves.length; this.onPass(f, f.moves[turn]); };
    next.onkeydown = event => event.stopPropagation();
    line.append(next);
    return line;
  }
  choose(finding: Finding | null) {
    for (const [f, card] of this.cards) card.classList.toggle("on", f === finding);
    if (finding) this.cards.get(finding)?.scrollIntoView({ block: "nearest" });
  }
}

function paper(title: string, content: HTMLElement, wide = false) {
  const box = el("div", wide ? "wide" : "");
  box.append(el("h2", "", title), content);
  $("papers").append(box);
}

function noteList(notes: Note[], open: OpenSite): HTMLElement {
  const list = el("ul");
  for (const n of notes) {
    const item = el("li", "", n.text + " ");
    if (n.where) item.append(siteLink(n.where, open));
    if (n.remedy) item.append(el("div", "amounts", "Remedy: " + n.remedy));
    list.append(item);
  }
  return list;
}

function table(heads: [text: string, number: boolean][], lines: (string | number)[][]): HTMLElement {
  const made = el("table"), top = el("tr");
  for (const [text, number] of heads) top.append(el("th", number ? "num" : "", text));
  made.append(top);
  for (const line of lines) {
    const row = el("tr");
    line.forEach((cell, k) => row.append(el("td", heads[k][1] ? "num" : "", cell)));
    made.append(row);
  }
  return made;
}

export function papers(doc: Document, moves: number, open: OpenSite) {
  const fixed = (v: number | null, digits: number) => v === null ? "?" : v.toFixed(digits);
  if (doc.unchecked.length) paper("Not checked", noteList(doc.unchecked, open), true);
  if (doc.tools.length)
    paper("Tool sheet", table(
      [["T", true], ["name", false], ["tool", false], ["\u00d8 mm", true], ["moves", true], ["feed mm", true], ["rapid mm", true], ["removed cm3", true]],
      doc.tools.map(t => [t.number, t.name, t.kind, t.radius === null ? "?" : +(2 * t.radius).toFixed(3), t.moves, fixed(t.feed, 1), fixed(t.rapid, 1),
        t.volume === null ? "?" : (t.volume / 1000).toFixed(2)])), true);
  if (doc.assumptions.length) paper("Assumed", noteList(doc.assumptions, open));
  if (doc.figures.length) paper("Figures", table([["", false], ["", true], ["", false]], doc.figures));
  if (doc.head.moves_left_out)
    paper("This page is not complete", el("p", "", `The picture shows the first ${moves} moves; ${doc.head.moves_left_out} more were checked and are not in it.`), true);
}
