// Reads the page's data, puts the parts together, and carries each choice to all the others.

import { Bodies } from "./bodies";
import { Controls } from "./controls";
import { Lines, none16, none32, readDocument, readMesh, readRun, type Document, type Finding, type Mesh, type Run, type Site, type Vec } from "./data";
import { $, clock, el, mm } from "./dom";
import { Overlay } from "./overlay";
import { Findings, head, papers, siteLink } from "./papers";
import { Path, placeAt } from "./path";
import { pointer } from "./pointer";
import { Picture } from "./scene";
import { Slider } from "./slider";
import { Surface } from "./surface";
import { Texts } from "./text";
import { Views, type Bounds } from "./views";

function grow(bounds: Bounds, numbers: ArrayLike<number>) {
  for (let k = 0; k + 2 < numbers.length; k += 3)
    for (let c = 0; c < 3; ++c) {
      const v = numbers[k + c];
      if (v < bounds.min[c]) bounds.min[c] = v;
      if (v > bounds.max[c]) bounds.max[c] = v;
    }
}
const nowhere = (): Bounds => ({ min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] });
const orUnit = (b: Bounds): Bounds => b.min[0] <= b.max[0] ? b : { min: [0, 0, 0], max: [100, 100, 10] };

/** The depth colours reach from the deepest cut to the top, not to the bottom of the stock. */
function lowestCut(mesh: Mesh, top: number): number {
  let low = Number.isFinite(top) ? top : 0;
  for (let k = 0; k < mesh.indices.length; ++k)
    if (mesh.moveOf[(k / 3) | 0] !== none32) low = Math.min(low, mesh.vertices[3 * mesh.indices[k] + 2]);
  return low;
}

/** `subject`: workpiece and clamps, or the path where there is neither; `scene`: everything that is drawn. */
function boundsOf(doc: Document, run: Run, mesh: Mesh): { scene: Bounds; subject: Bounds; heights: [number, number] } {
  const work = nowhere(), scene = nowhere();
  grow(work, mesh.vertices);
  const heights: [number, number] = [lowestCut(mesh, work.max[2]), Number.isFinite(work.max[2]) ? work.max[2] : 1];
  if (doc.stock) grow(work, [...doc.stock.min, ...doc.stock.max]);
  for (const clamp of doc.clamps) grow(work, [...clamp.min, ...clamp.max]);
  grow(scene, run.points);
  const subject = work.min[0] <= work.max[0] ? work : orUnit({ min: [...scene.min], max: [...scene.max] });
  grow(scene, [...subject.min, ...subject.max]);
  // Tools stand above the path; nothing of them is to be cut off.
  const tall = Math.max(50, ...doc.tools.map(t => Math.max(t.cutting ?? 0, ...t.bodies.map(b => b[1]))));
  for (let c = 0; c < 3; ++c) { scene.min[c] -= tall; scene.max[c] += tall; }
  return { scene, subject, heights };
}

function deviationLimit(doc: Document, mesh: Mesh): number {
  if (doc.deviation_limit) return doc.deviation_limit;
  let most = 0;
  for (const d of mesh.deviation ?? []) if (Math.abs(d) > most) most = Math.abs(d);
  return most || 1;
}

class Report {
  private readonly slider: Slider;
  private turn = 0;
  private lastLine = "";

  constructor(
    private readonly doc: Document, private readonly run: Run, private readonly picture: Picture,
    private readonly overlay: Overlay, private readonly texts: Texts, private readonly lines: Lines, private readonly findings: Findings,
  ) {
    this.slider = new Slider(run);
    this.slider.onMove = done => this.moved(done);
    findings.onPick = overlay.onPick = finding => this.pickFinding(finding);
    findings.onPass = (finding, move) => this.pickFinding(finding, move);
    texts.onLine = (file, line, step) => this.pickLine(file, line, step);
    pointer(picture, move => { if (move !== null) this.pickMove(move); });
    document.addEventListener("keydown", event => {
      const target = event.target as Element;
      if (event.key === " " && !target.closest("button,select,input,.finding,a")) { event.preventDefault(); this.slider.toggle(); }
      const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !target.closest("select,input,textarea");
      if (plain && (event.key === "n" || event.key === "p")) { event.preventDefault(); this.step(event.key === "n" ? 1 : -1); }
    });
  }

  start() {
    this.slider.set(this.run.count);
    this.show(this.run.count, -1);
    const [, kind, number] = location.hash.match(/^#(finding|move)-(\d+)$/) ?? [];
    const finding = this.doc.findings.find(f => f.no === Number(number));
    if (kind === "finding" && finding) this.pickFinding(finding);
    else if (kind !== "move" && this.doc.findings.length) this.point(this.doc.findings[0]);
    if (kind === "move" && this.run.count) this.pickMove(indexOf(this.run, Number(number)));
  }

  /** The whole part stays in view: the mark says where the worst finding is. */
  private point(finding: Finding) {
    this.overlay.active = finding;
    this.findings.choose(finding);
    if (finding.where) this.texts.light(finding.where.f, finding.where.l);
    this.overlay.draw();
  }
  /** To the finding after the chosen one or before it, round and round. */
  private step(by: number) {
    const all = this.doc.findings, at = this.overlay.active ? all.indexOf(this.overlay.active) : by > 0 ? -1 : 0;
    if (all.length) this.pickFinding(all[(at + by + all.length) % all.length]);
  }

  /** The move under way, or the one that is just done. */
  private moveAt(done: number): number {
    return Number.isInteger(done) ? done - 1 : Math.floor(done);
  }
  private show(done: number, chosen: number) {
    this.picture.show(done, chosen);
    this.status(done);
  }
  private unpick() {
    this.overlay.active = null;
    this.findings.choose(null);
  }
  /** Slider or playing: picture and text follow. */
  private moved(done: number) {
    if (this.overlay.active) { this.unpick(); this.overlay.draw(); }
    const move = this.moveAt(done);
    this.picture.path.light(move >= 0 ? [move] : []);
    this.show(done, -1);
    if (move >= 0) this.lightLine(move);
  }
  private lightLine(move: number) {
    if (this.run.file[move] !== none16) this.texts.light(this.run.file[move], this.run.line[move]);
  }

  pickMove(move: number) {
    this.slider.stop();
    this.unpick();
    this.slider.set(move + 1);
    this.picture.path.light([move]);
    this.show(move + 1, move);
    this.lightLine(move);
    this.overlay.draw();
  }
  /** All moves of the line are lit; the slider goes to the first one, and on when the line is picked again. */
  pickLine(file: number, line: number, step = 0) {
    this.slider.stop();
    this.unpick();
    const moves = this.lines.of(file, line), key = file + ":" + line;
    this.turn = this.lastLine === key && step === 0 && moves.length ? (this.turn + 1) % moves.length : 0;
    this.lastLine = key;
    this.texts.light(file, line, false);
    this.picture.path.light(moves);
    if (moves.length) {
      this.slider.set(moves[this.turn] + 1);
      this.show(moves[this.turn] + 1, moves[this.turn]);
      if (moves.length > 1) $("status").prepend(el("span", "", `pass ${this.turn + 1} of ${moves.length} of this line: `));
    } else {
      this.picture.invalidate();
    }
    this.overlay.draw();
  }
  /** `pass`: one of its moves; the worst one where none is named. */
  pickFinding(finding: Finding, pass = finding.move) {
    this.slider.stop();
    this.overlay.active = finding;
    this.findings.choose(finding);
    const { run, picture } = this, move = pass;
    if (move !== null && move < run.count) {
      this.slider.set(move + 1);
      picture.path.light([move]);
      this.show(move + 1, move);
    }
    const other = move !== finding.move;
    if (finding.where && !other) this.texts.light(finding.where.f, finding.where.l);
    else if (move !== null && move < run.count) this.lightLine(move);
    const at: Vec | undefined = (other ? null : finding.at) ?? (move !== null ? placeAt(run, move + 1)?.point : undefined);
    if (at) { picture.views.lookAt(at, 12); picture.viewChanged(); }
    this.overlay.draw();
  }

  private status(done: number) {
    const box = $("status"), { run, doc } = this, move = this.moveAt(done);
    box.replaceChildren();
    if (move < 0) return box.append(el("span", "", run.count ? `before the first of ${run.count} moves` : "no moves to show"));
    const tool = doc.tools[run.tool[move]], place = endOf(run, move, done);
    box.append(el("b", "", `move ${run.number[move]} of ${Math.max(doc.head.moves_all, run.count)}: ${run.kind[move] ? "rapid" : "feed"}`),
      ` to X ${mm(place[0])} Y ${mm(place[1])} Z ${mm(place[2])} mm`, tool ? `, T${tool.number} ${tool.name}` : "");
    const seconds = run.seconds[move], length = run.lengths[move];
    box.append(el("br"));
    const file = run.file[move];
    if (file !== none16) box.append(siteLink({ f: file, l: run.line[move], n: doc.texts[file].name }, site => this.pickLine(site.f, site.l)));
    if (Number.isFinite(seconds)) box.append(`, ${clock(seconds)} of ${clock(run.seconds[run.count - 1])}`);
    if (Number.isFinite(length)) box.append(`, path ${(length / 1000).toFixed(2)} m`);
  }
}

/** Where a finding is shown: its own place, or the end of its worst move. */
function placeOf(run: Run, finding: Finding): Vec | undefined {
  if (finding.at) return finding.at;
  return finding.move !== null && finding.move < run.count ? placeAt(run, finding.move + 1)?.point : undefined;
}

/** Where the page holds a move of this number, or the next one that it holds. */
function indexOf(run: Run, number: number): number {
  const at = run.number.findIndex(n => n >= number);
  return at < 0 ? run.count - 1 : at;
}

function endOf(run: Run, move: number, done: number): [number, number, number] {
  const point = placeAt(run, Number.isInteger(done) ? done - 1e-9 : done)?.point;
  const last = 3 * (run.firstPoint[move + 1] - 1);
  return Number.isInteger(done) && last >= 0 ? [run.points[last], run.points[last + 1], run.points[last + 2]] : point ?? [NaN, NaN, NaN];
}

function pictureOf(doc: Document, run: Run, mesh: Mesh): { picture: Picture; heights: [number, number]; limit: number } {
  const { scene, subject, heights } = boundsOf(doc, run, mesh), limit = deviationLimit(doc, mesh);
  const picture = new Picture($<HTMLCanvasElement>("canvas"), new Views(scene, subject), new Surface(mesh, run, heights, limit), new Path(run),
    new Bodies(run, doc.tools, doc.clamps, doc.stock));
  return { picture, heights, limit };
}

function main() {
  const doc = readDocument();
  head(doc);
  const run = readRun(), mesh = readMesh(), lines = new Lines(run, doc.texts.length);
  const texts = new Texts(doc, lines, $("tabs"), $("texts")), open = (site: Site) => texts.onLine(site.f, site.l, 0);
  texts.onLine = (file, line) => texts.light(file, line);
  const findings = new Findings(doc, run.number, open);
  findings.onPick = finding => { findings.choose(finding); if (finding.where) open(finding.where); };
  papers(doc, run.count, open);
  texts.show(doc.findings[0]?.where?.f ?? 0);
  // All of the above can be read where no picture can be drawn.
  const { picture, heights, limit } = pictureOf(doc, run, mesh);
  const overlay = new Overlay($("overlay"), picture.views, doc.findings, finding => placeOf(run, finding)), report = new Report(doc, run, picture, overlay, texts, lines, findings);
  const view = $("view"), resize = () => picture.resize(view.clientWidth, view.clientHeight);
  picture.onFrame = viewIsNew => { if (viewIsNew) overlay.draw(); };
  resize();
  new Controls(doc, picture, run, mesh, heights, limit).show("3D");
  report.start();
  new ResizeObserver(resize).observe(view);
  window.addEventListener("beforeprint", () => { resize(); picture.draw(); });
  // For tests and for who looks into it with the browser's tools.
  (window as unknown as { obrys: unknown }).obrys = { picture, report, run };
  picture.draw();
  picture.finish();
  performance.mark("obrys-first-frame");
}

try {
  main();
} catch (error) {
  // Most likely there is no WebGL 2; verdict and findings can be read all the same.
  $("failed").hidden = false;
  $("failed").textContent = "The picture cannot be drawn here: " + (error instanceof Error ? error.message : String(error));
  throw error;
}
