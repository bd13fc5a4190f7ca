// Over the canvas: axes with their names, rulers in millimetres, the scale, marks of the findings.

import { Vector3 } from "three";
import type { Finding, Vec } from "./data";
import { digitsOf, niceStep, svg } from "./dom";
import type { Views, Viewport } from "./views";

const axisColours = { X: "#c00018", Y: "#08702f", Z: "#0b57d0" } as const;
const unit: Record<"X" | "Y" | "Z", Vector3> = { X: new Vector3(1, 0, 0), Y: new Vector3(0, 1, 0), Z: new Vector3(0, 0, 1) };
const mostMarks = 60;

/** The axis a direction lies along and its sense. */
function axisOf(v: Vector3): { name: "X" | "Y" | "Z"; sense: number } {
  for (const name of ["X", "Y", "Z"] as const) {
    const d = v.dot(unit[name]);
    if (Math.abs(d) > 0.9) return { name, sense: Math.sign(d) };
  }
  return { name: "X", sense: 1 };
}

function halo(x: number, y: number, text: string, anchor: string, cls = "halo"): SVGElement {
  return svg("text", { x, y, "text-anchor": anchor, class: cls }, text);
}

function triad(view: Viewport): SVGElement[] {
  const cx = view.left + 52, cy = view.top + view.high - 52, out: SVGElement[] = [], length = 36;
  const axes = (["X", "Y", "Z"] as const).map(name => ({ name, depth: unit[name].dot(view.basis.back) }));
  for (const { name } of axes.sort((a, b) => a.depth - b.depth)) {
    const dx = length * unit[name].dot(view.basis.right), dy = -length * unit[name].dot(view.basis.up);
    out.push(svg("line", { class: "axis", x1: cx, y1: cy, x2: cx + dx, y2: cy + dy, stroke: axisColours[name] }));
    const t = halo(cx + 1.32 * dx, cy + 1.32 * dy + 4, name, "middle", "halo name");
    t.style.fill = axisColours[name];
    out.push(t);
  }
  return out;
}

function scaleBar(view: Viewport, scale: number): SVGElement[] {
  const step = niceStep(70 / scale), w = step * scale, x = view.left + view.wide - 22 - w, y = view.top + view.high - 18;
  return [
    svg("path", { class: "scale", d: `M${x} ${y - 5}v5h${w}v-5` }),
    halo(x + w / 2, y - 8, step.toFixed(digitsOf(step)) + " mm", "middle"),
  ];
}

function rulers(views: Views, view: Viewport): SVGElement[] {
  const out: SVGElement[] = [], { scale, target } = views.look, step = niceStep(46 / scale), stepUp = niceStep(26 / scale);
  const low = view.top + view.high - 24, side = view.left + 48;
  out.push(svg("rect", { class: "band", x: view.left, y: low, width: view.wide, height: 24 }),
    svg("rect", { class: "band", x: view.left, y: view.top, width: 48, height: view.high }));
  const h = axisOf(view.basis.right), v = axisOf(view.basis.up);
  const key = (n: "X" | "Y" | "Z") => n.toLowerCase() as "x" | "y" | "z", middleX = view.left + view.wide / 2, middleY = view.top + view.high / 2;
  const label = (value: number, of: number) => (value || 0).toFixed(digitsOf(of));
  const half = view.wide / 2 / scale, t = target[key(h.name)];
  for (let n = Math.ceil((t - half) / step); n * step <= t + half; ++n) {
    const x = middleX + h.sense * scale * (n * step - t);
    if (x < side + 8 || x > view.left + view.wide - 34) continue;
    out.push(svg("line", { class: "tick", x1: x, y1: low, x2: x, y2: low + 5 }), halo(x, low + 17, label(n * step, step), "middle", ""));
  }
  const tall = view.high / 2 / scale, tv = target[key(v.name)];
  for (let n = Math.ceil((tv - tall) / stepUp); n * stepUp <= tv + tall; ++n) {
    const y = middleY - v.sense * scale * (n * stepUp - tv);
    if (y > low - 8 || y < view.top + 30) continue;
    out.push(svg("line", { class: "tick", x1: side - 5, y1: y, x2: side, y2: y }), halo(side - 8, y + 4, label(n * stepUp, stepUp), "end", ""));
  }
  out.push(halo(view.left + view.wide - 6, low + 17, h.sense > 0 ? h.name + " →" : "← " + h.name, "end", "name"),
    halo(side - 8, view.top + 18, "↑ " + v.name, "end", "name"),
    halo(side + 10, view.top + 18, view.name + ", mm", "start", "halo name"));
  return out;
}

/** First angle: the left view stands on the right (ISO 5456-2); a cone's symbol as drawings have it. */
function symbol(view: Viewport): SVGElement[] {
  const x = view.left + view.wide + 60, y = view.top + 66;
  return [
    svg("path", { class: "scale", d: `M${x} ${y - 8}l44 -8v32l-44 -8zM${x - 8} ${y}h60M${x + 62} ${y}h44M${x + 84} ${y - 22}v44` }),
    svg("circle", { class: "scale", cx: x + 84, cy: y, r: 8 }), svg("circle", { class: "scale", cx: x + 84, cy: y, r: 16 }),
    halo(x - 8, y + 44, "first-angle projection, one scale", "start", ""),
  ];
}

export class Overlay {
  active: Finding | null = null;
  onPick: (finding: Finding) => void = () => {};

  constructor(private readonly root: Element, private readonly views: Views, private readonly findings: Finding[],
    private readonly placeOf: (finding: Finding) => Vec | undefined) {}

  draw() {
    const out: SVGElement[] = [];
    for (const view of this.views.all) {
      if (this.views.all.length > 1) out.push(svg("rect", { class: "frame", x: view.left, y: view.top, width: view.wide, height: view.high }));
      out.push(...(view.flat ? rulers(this.views, view) : [...triad(view), ...scaleBar(view, this.views.look.scale)]));
    }
    const plan = this.views.all[2];
    if (plan) out.push(...symbol(plan));
    for (const view of this.views.all) out.push(...this.marks(view));
    this.root.replaceChildren(...out);
  }

  /** The chosen finding's mark first, so that it is never the one left out. */
  private marks(view: Viewport): SVGElement[] {
    const under: SVGElement[] = [], over: SVGElement[] = [], taken: [number, number][] = [];
    const placed = this.findings.filter(f => this.placeOf(f)).sort((a, b) => Number(b === this.active) - Number(a === this.active) || a.no - b.no);
    for (const finding of placed.slice(0, mostMarks)) {
      const [x, y] = this.views.project(view, this.placeOf(finding) as Vec);
      if (x < view.left || y < view.top || x > view.left + view.wide || y > view.top + view.high) continue;
      let cx = x + 26, cy = y - 24;
      for (let k = 0; k < 200 && taken.some(t => Math.abs(t[0] - cx) < 26 && Math.abs(t[1] - cy) < 22); ++k) {
        const a = -0.78 + k * 0.45, r = 34 + k * 1.8;
        cx = x + r * Math.cos(a); cy = y + r * Math.sin(a);
      }
      taken.push([cx, cy]);
      const on = finding === this.active, half = finding.no > 99 ? 14 : 10;
      const mark = svg("rect", { class: on ? "mark on" : "mark", x: cx - half, y: cy - 9.5, width: 2 * half, height: 19, rx: 9.5 });
      const no = svg("text", { class: "no", x: cx, y: cy + 4, "data-no": finding.no }, String(finding.no));
      for (const part of [mark, no]) {
        part.append(svg("title", {}, `${finding.no} ${finding.code}: ${finding.text}`));
        part.addEventListener("click", () => this.onPick(finding));
      }
      under.push(svg("line", { class: "leader", x1: x, y1: y, x2: cx, y2: cy }), svg("circle", { class: on ? "spot on" : "spot", cx: x, cy: y, r: on ? 8 : 4 }));
      over.push(mark, no);
    }
    return [...under, ...over];
  }
}
