// The tool path: rapids dashed and red, feeds thin and green, what is still to come faint; lit moves as thick lines.

import { BufferAttribute, BufferGeometry, GLSL3, Line, NormalBlending, RawShaderMaterial, Scene } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Run } from "./data";
import { pathFragment, pathVertex } from "./shaders";

export type Shown = "all" | "so far" | "near the tool" | "none";
export const shownChoices: Shown[] = ["all", "so far", "near the tool", "none"];
const nearMoves = 300, mostLit = 20_000;

/** Bit 30: rapid; bit 31: not drawn, since an end is not known; below: the move. Lengths along each move, for dashes. */
function numbersOf(run: Run): { numbers: Uint32Array; along: Float32Array; positions: Float32Array } {
  const n = run.moveOfPoint.length, numbers = new Uint32Array(n), along = new Float32Array(n), positions = run.points.slice();
  let hole = true;  // no piece ends at the first point
  for (let k = 0; k < n; ++k) {
    const p = 3 * k, known = Number.isFinite(positions[p] + positions[p + 1] + positions[p + 2]), move = run.moveOfPoint[k];
    if (!known) for (let c = 0; c < 3; ++c) positions[p + c] = k > 0 ? positions[p - 3 + c] : 0;
    const skipped = hole || !known;
    numbers[k] = (Math.min(move, 0xfffffd) | (run.kind[move] ? 0x40000000 : 0) | (skipped ? 0x80000000 : 0)) >>> 0;
    if (k > 0 && !skipped) {
      const length = Math.hypot(positions[p] - positions[p - 3], positions[p + 1] - positions[p - 2], positions[p + 2] - positions[p - 1]);
      // The flat value of a piece is its end's, the length is interpolated: it goes on over a change of move.
      along[k] = along[k - 1] + length;
    }
    hole = !known;
  }
  return { numbers, along, positions };
}

export class Path {
  readonly scene = new Scene();
  private readonly line: Line;
  private readonly material: RawShaderMaterial;
  private readonly lit: LineSegments2;
  private readonly litMaterial = new LineMaterial({ color: 0x0b57d0, linewidth: 3.5, depthTest: false, transparent: true });
  shown: Shown;

  constructor(private readonly run: Run) {
    const { numbers, along, positions } = numbersOf(run), geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("number", new BufferAttribute(numbers, 1));
    geometry.setAttribute("along", new BufferAttribute(along, 1));
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: pathVertex, fragmentShader: pathFragment, transparent: true, blending: NormalBlending, depthWrite: false,
      uniforms: {
        done: { value: 0 }, scale: { value: 1 }, lift: { value: 0 }, pick: { value: false }, rapids: { value: true }, feeds: { value: true },
      },
    });
    this.line = new Line(geometry, this.material);
    this.lit = new LineSegments2(new LineSegmentsGeometry(), this.litMaterial);
    this.line.frustumCulled = this.lit.frustumCulled = false;
    this.lit.visible = false;
    this.scene.add(this.line, this.lit);
    // The whole path of a large program hides the workpiece.
    this.shown = run.count > 3000 ? "near the tool" : "all";
  }

  set done(moves: number) {
    const { run } = this, reach = Math.floor(moves);
    this.material.uniforms.done.value = moves;
    let first = 0, last = run.count;
    if (this.shown === "so far") last = Math.min(run.count, reach + 1);
    if (this.shown === "near the tool") [first, last] = [Math.max(0, reach - nearMoves), Math.min(run.count, reach + nearMoves)];
    const from = Math.max(0, run.firstPoint[first] - 1);
    this.line.visible = this.shown !== "none" && run.count > 0;
    this.line.geometry.setDrawRange(from, run.firstPoint[last] - from);
  }
  layer(name: "rapids" | "feeds", on: boolean) { this.material.uniforms[name].value = on; }
  viewChanged(scale: number, pixelDepth: number, ratio: number) {
    this.material.uniforms.scale.value = scale;
    this.material.uniforms.lift.value = 3 * pixelDepth * ratio;
  }
  set picking(on: boolean) {
    this.material.uniforms.pick.value = on;
    this.material.transparent = !on;
    if (on) this.litWas = this.lit.visible;
    this.lit.visible = on ? false : this.litWas;
  }
  private litWas = false;

  /** Lights moves as thick lines. */
  light(moves: ArrayLike<number>) {
    const { run } = this, out: number[] = [];
    for (let i = 0; i < moves.length && i < mostLit; ++i)
      for (let k = Math.max(1, run.firstPoint[moves[i]]); k < run.firstPoint[moves[i] + 1]; ++k) {
        const piece = run.points.subarray(3 * k - 3, 3 * k + 3);
        if (piece.every(Number.isFinite)) out.push(...piece);
      }
    this.lit.visible = out.length > 0;
    if (!out.length) return;
    this.lit.geometry.dispose();
    this.lit.geometry = new LineSegmentsGeometry().setPositions(out);
  }
}

/** Where the tool is after `done` moves and a part of the next one; null: not known. */
export function placeAt(run: Run, done: number): { point: [number, number, number]; move: number } | null {
  if (run.count === 0) return null;
  const move = Math.min(run.count - 1, Math.floor(done)), share = done - move;
  let first = Math.max(0, run.firstPoint[move] - 1);
  if (run.moveOfPoint[0] === move) first = 0;
  const last = run.firstPoint[move + 1] - 1;
  const at = (k: number): [number, number, number] => [run.points[3 * k], run.points[3 * k + 1], run.points[3 * k + 2]];
  const known = (p: number[]) => Number.isFinite(p[0] + p[1] + p[2]);
  if (last < first) return null;
  let length = 0;
  const ends = [0];
  for (let k = first + 1; k <= last; ++k) {
    const a = at(k - 1), b = at(k);
    if (known(a) && known(b)) length += Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    ends.push(length);
  }
  let k = 0;
  while (k < ends.length - 2 && ends[k + 1] < share * length) ++k;
  const a = at(first + k), b = at(Math.min(last, first + k + 1)), span = (ends[k + 1] ?? 0) - ends[k];
  const t = span > 0 ? Math.min(1, (share * length - ends[k]) / span) : share > 0 ? 1 : 0;
  const point: [number, number, number] = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
  return known(point) ? { point, move } : known(b) && share > 0 ? { point: b, move } : known(a) ? { point: a, move } : null;
}
