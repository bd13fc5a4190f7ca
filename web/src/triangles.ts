// The surface as the shader wants it: a number for each triangle, without a copy of its corners.
//
// A `flat` value of a triangle is that of its last corner. So each triangle is turned until its last corner carries its
// number; corners are doubled only where all three carry another one. Of 500 000 triangles that a raster program cut, about
// every second needs no corner of its own.

import { none32, type Mesh } from "./data";

/** A number holds the move that cut the triangle last (24 bits) and how far it lies off the part (8 bits). */
export const noMove = 0xfffffe, nothing = 0xffffff, noLevel = 255, levels = 254;

export interface Triangles { positions: Float32Array; numbers: Uint32Array; indices: Uint32Array }

/** 0: as deep as `most`, 127: on the part, 254: as high as `most`. */
function level(deviation: number, most: number): number {
  if (!Number.isFinite(deviation)) return noLevel;
  return Math.round(127 + 127 * Math.max(-1, Math.min(1, deviation / most)));
}

function numbersOf(mesh: Mesh, most: number): Uint32Array {
  const out = new Uint32Array(mesh.moveOf.length);
  for (let t = 0; t < out.length; ++t) {
    const move = mesh.moveOf[t], owner = move === none32 ? noMove : Math.min(move, noMove - 1);
    const off = mesh.deviation ? level(mesh.deviation[t], most) : noLevel;
    out[t] = ((off << 24) | owner) >>> 0;
  }
  return out;
}

class Corners {
  readonly positions: Float32Array;
  readonly numbers: Uint32Array;
  private readonly taken: Uint8Array;
  private readonly double: Uint32Array;  // of a corner: its last copy
  count: number;

  constructor(vertices: Float32Array, triangles: number) {
    this.count = vertices.length / 3;
    this.positions = new Float32Array(vertices.length + 3 * triangles);
    this.positions.set(vertices);
    this.numbers = new Uint32Array(this.count + triangles);
    this.taken = new Uint8Array(this.count + triangles);
    this.double = new Uint32Array(this.count);
  }
  carries(v: number, number: number): boolean { return this.taken[v] === 1 && this.numbers[v] === number; }
  take(v: number, number: number): boolean {
    if (this.taken[v]) return false;
    this.taken[v] = 1;
    this.numbers[v] = number;
    return true;
  }
  copy(v: number, number: number): number {
    const last = this.double[v];
    if (last && this.numbers[last] === number) return last;
    const made = this.count++;
    this.positions.copyWithin(3 * made, 3 * v, 3 * v + 3);
    this.numbers[made] = number;
    return this.double[v] = made;
  }
}

export function triangles(mesh: Mesh, most: number): Triangles {
  const of = numbersOf(mesh, most), corners = new Corners(mesh.vertices, of.length), indices = new Uint32Array(3 * of.length);
  for (let t = 0, k = 0; t < of.length; ++t, k += 3) {
    let a = mesh.indices[k], b = mesh.indices[k + 1], c = mesh.indices[k + 2];
    const number = of[t];
    if (corners.carries(c, number)) { /* as it is */ }
    else if (corners.carries(a, number)) [a, b, c] = [b, c, a];
    else if (corners.carries(b, number)) [a, b, c] = [c, a, b];
    else if (corners.take(c, number)) { /* as it is */ }
    else if (corners.take(a, number)) [a, b, c] = [b, c, a];
    else if (corners.take(b, number)) [a, b, c] = [c, a, b];
    else c = corners.copy(c, number);
    indices[k] = a; indices[k + 1] = b; indices[k + 2] = c;
  }
  return {
    positions: corners.positions.subarray(0, 3 * corners.count), numbers: corners.numbers.subarray(0, corners.count), indices,
  };
}

/** Fewer triangles for while the view is being turned: corners that lie in one cell of a lattice become one. */
export function coarse({ positions, indices }: Triangles, cells: number): Uint32Array {
  const count = positions.length / 3, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let v = 0; v < positions.length; ++v) {
    low[v % 3] = Math.min(low[v % 3], positions[v]);
    high[v % 3] = Math.max(high[v % 3], positions[v]);
  }
  const size = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-9) / cells, of = new Uint32Array(count);
  const first = new Map<number, number>(), cell = (v: number, c: number) => Math.floor((positions[3 * v + c] - low[c]) / size);
  for (let v = 0; v < count; ++v) {
    const key = (cell(v, 0) * 1024 + cell(v, 1)) * 1024 + cell(v, 2), known = first.get(key);
    if (known === undefined) first.set(key, v);
    of[v] = known ?? v;
  }
  const out = new Uint32Array(indices.length);
  let n = 0;
  for (let k = 0; k < indices.length; k += 3) {
    const a = of[indices[k]], b = of[indices[k + 1]], c = of[indices[k + 2]];
    if (a === b || b === c || c === a) continue;
    out[n++] = a; out[n++] = b; out[n++] = c;
  }
  return out.slice(0, n);
}
