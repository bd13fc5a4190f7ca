// The programs' texts with line numbers. Only the lines in sight are elements, so that a text may have any length.

import type { Document, Lines } from "./data";
import { el } from "./dom";

const lineHeight = 21, spare = 12, tallest = 30_000_000;  // browsers draw nothing beyond some 33 million pixels

const rowId = (file: number, line: number) => `line-${file}-${line}`;

class Text {
  readonly box = el("div", "rows");
  private readonly space = el("div", "space");
  private readonly lines: string[];
  private shown = [-1, -1];
  caret = 0;
  lit = new Set<number>();

  constructor(
    readonly file: number, name: string, text: string, private readonly moves: Lines, private readonly bad: Map<number, string>,
    private readonly onLine: (file: number, line: number, step: number) => void,
  ) {
    this.lines = text.split(/\r\n|\n|\r/);
    if (this.lines.length > 1 && this.lines[this.lines.length - 1] === "") this.lines.pop();
    const widest = this.lines.reduce((most, line) => Math.max(most, line.length), 0);
    this.space.style.height = Math.min(tallest, lineHeight * this.lines.length) + "px";
    this.space.style.minWidth = `calc(${Math.min(widest, 4000)}ch + 8em)`;
    this.box.tabIndex = 0;
    this.box.setAttribute("role", "listbox");
    this.box.setAttribute("aria-label", "Program " + name);
    this.box.append(this.space);
    this.box.addEventListener("scroll", () => this.draw());
    this.box.addEventListener("click", event => this.clicked(event));
    this.box.addEventListener("keydown", event => this.key(event));
  }

  draw(anew = false) {
    const first = Math.max(0, Math.floor(this.box.scrollTop / lineHeight) - spare);
    const last = Math.min(this.lines.length, Math.ceil((this.box.scrollTop + this.box.clientHeight) / lineHeight) + spare);
    if (!anew && first === this.shown[0] && last === this.shown[1]) return;
    this.shown = [first, last];
    const rows: HTMLElement[] = [];
    for (let k = first; k < last; ++k) rows.push(this.row(k + 1));
    this.space.replaceChildren(...rows);
  }
  private row(line: number): HTMLElement {
    const row = el("div", "ln"), moves = this.moves.of(this.file, line).length, bad = this.bad.get(line);
    row.style.top = (line - 1) * lineHeight + "px";
    row.id = rowId(this.file, line);
    row.setAttribute("role", "option");
    row.setAttribute("aria-selected", String(line === this.caret));
    row.dataset.line = String(line);
    if (moves) { row.classList.add("runs"); row.title = moves === 1 ? "1 move" : moves + " moves"; }
    if (bad) { row.classList.add("has"); row.title = bad; }
    if (this.lit.has(line)) row.classList.add("on");
    if (line === this.caret) row.classList.add("lead");
    row.append(el("i", "", line), el("span", "", this.lines[line - 1] || " "));
    return row;
  }

  private clicked(event: MouseEvent) {
    const row = (event.target as Element).closest<HTMLElement>(".ln");
    if (row?.dataset.line) this.onLine(this.file, Number(row.dataset.line), 0);
  }
  /** Arrow keys go from line to line; with Alt to the next line that moves; Enter goes through the moves of a line. */
  private key(event: KeyboardEvent) {
    const page = Math.max(1, Math.floor(this.box.clientHeight / lineHeight) - 1);
    const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity };
    if (event.key === "Enter" && this.caret) { event.preventDefault(); this.onLine(this.file, this.caret, 0); }
    const step = steps[event.key];
    if (step === undefined) return;
    event.preventDefault();
    let line = this.caret + step;
    const runs = (n: number) => this.moves.of(this.file, n).length > 0;
    if (event.altKey) while (line > 1 && line < this.lines.length && !runs(line)) line += Math.sign(step);
    this.onLine(this.file, Math.max(1, Math.min(this.lines.length, line)), step);
  }

  reveal(line: number, middle: boolean) {
    const y = (line - 1) * lineHeight, box = this.box;
    if (middle && (y < box.scrollTop || y + lineHeight > box.scrollTop + box.clientHeight)) box.scrollTop = y - box.clientHeight / 2;
    else if (y < box.scrollTop) box.scrollTop = y;
    else if (y + lineHeight > box.scrollTop + box.clientHeight) box.scrollTop = y + lineHeight - box.clientHeight;
    box.setAttribute("aria-activedescendant", rowId(this.file, line));
  }
}

export class Texts {
  private readonly texts: Text[] = [];
  private readonly tabs: HTMLButtonElement[] = [];
  private open = -1;
  private lit: Text | null = null;
  onLine: (file: number, line: number, step: number) => void = () => {};

  constructor(doc: Document, lines: Lines, tabs: HTMLElement, texts: HTMLElement) {
    const bad = doc.texts.map(() => new Map<number, string>());
    for (const f of doc.findings) if (f.where) bad[f.where.f]?.set(f.where.l, `finding ${f.no}: ${f.code}`);
    doc.texts.forEach((file, f) => {
      const tab = el("button", "", file.name.replace(/^.*[\\/]/, ""));
      tab.title = file.name;
      tab.onclick = () => this.show(f);
      const text = new Text(f, file.name, file.text, lines, bad[f], (a, b, c) => this.onLine(a, b, c));
      text.box.hidden = true;
      this.tabs.push(tab);
      this.texts.push(text);
      tabs.append(tab);
      texts.append(text.box);
    });
  }
  show(file: number) {
    if (file === this.open || !this.texts[file]) return;
    this.open = file;
    this.texts.forEach((text, k) => { text.box.hidden = k !== file; });
    this.tabs.forEach((tab, k) => { tab.classList.toggle("on", k === file); tab.setAttribute("aria-pressed", String(k === file)); });
    this.texts[file].draw(true);
  }
  /** The line of the move under the slider; it is scrolled into sight. */
  light(file: number, line: number, middle = true) {
    const text = this.texts[file];
    if (this.lit && this.lit !== text) { this.lit.caret = 0; this.lit.lit.clear(); this.lit.draw(true); }
    if (!text) return;
    this.lit = text;
    this.show(file);
    text.caret = line;
    text.lit = new Set([line]);
    text.reveal(line, middle);
    text.draw(true);
  }
}
