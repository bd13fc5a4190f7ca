// What the page holds: the JSON and the arrays that src/report/milling_page.cpp writes.

export interface Site { f: number; l: number; n: string }
export interface Finding {
  no: number; code: string; severity: string; text: string; remedy: string;
  passes: string; moves: number[];  // what several moves of one cause did, and which
  where: Site | null; move: number | null; at: [number, number, number] | null;
  amounts: [label: string, value: string, unit: string][];
}
export interface Note { text: string; remedy: string; where: Site | null }
export type Body = [from: number, to: number, radiusFrom: number, radiusTo: number, holder: boolean];
export interface Tool {
  number: number; name: string; kind: string; radius: number | null; corner: number | null; cutting: number | null;
  outline: [number, number][]; bodies: Body[];
  volume: number | null; moves: number; feed: number | null; rapid: number | null;
}
export type Vec = [number, number, number];
export interface Box { min: Vec; max: Vec; name: string }
export interface Head {
  program: string; control: string; machine: string; date: string; version: string;
  verdict: string; line: string; dropped: number; moves_all: number; moves_left_out: number;
}
export interface Document {
  head: Head; findings: Finding[]; texts: { name: string; text: string }[]; tools: Tool[]; clamps: Box[];
  figures: [string, string, string][]; unchecked: Note[]; assumptions: Note[];
  stock: Box | null; tolerance: number | null; deviation_limit: number | null;
}

export const none16 = 0xffff, none32 = 0xffffffff;

/** The run: per point and per move, as src/report/milling_arrays.hpp describes them. */
export interface Run {
  count: number;
  points: Float32Array; moveOfPoint: Uint32Array;
  /** First point of each move and, at the end, the number of points; a move's first piece begins at the point before. */
  firstPoint: Uint32Array;
  /** The moves' numbers in every report; the page may leave moves out. */
  number: Uint32Array;
  kind: Uint8Array; file: Uint16Array; line: Uint32Array; tool: Uint16Array; axes: Float32Array | null;
  seconds: Float64Array; lengths: Float64Array;
}
export interface Mesh {
  vertices: Float32Array; indices: Uint32Array; moveOf: Uint32Array; deviation: Float32Array | null;
}

function textOf(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}

const has = (name: string): boolean => document.getElementById("array-" + name) !== null;

function bytes(name: string): ArrayBuffer {
  const text = textOf("array-" + name);
  const direct = (Uint8Array as unknown as { fromBase64?: (s: string) => Uint8Array<ArrayBuffer> }).fromBase64;
  if (direct) return direct.call(Uint8Array, text).buffer;
  const raw = atob(text), out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out.buffer;
}

/** The arrays are little-endian; so are all machines browsers run on today. */
export function readRun(): Run {
  const moveOfPoint = new Uint32Array(bytes("moveOfPoint"));
  const kind = new Uint8Array(bytes("kind")), count = kind.length;
  const firstPoint = new Uint32Array(count + 1);
  for (let m = 0, p = 0; m <= count; ++m) {
    while (p < moveOfPoint.length && moveOfPoint[p] < m) ++p;
    firstPoint[m] = p;
  }
  return {
    count, moveOfPoint, firstPoint, kind,
    points: new Float32Array(bytes("points")),
    number: new Uint32Array(bytes("number")),
    file: new Uint16Array(bytes("file")), line: new Uint32Array(bytes("line")), tool: new Uint16Array(bytes("tool")),
    axes: has("axes") ? new Float32Array(bytes("axes")) : null,
    seconds: new Float64Array(bytes("seconds")), lengths: new Float64Array(bytes("lengths")),
  };
}

export function readMesh(): Mesh {
  return {
    vertices: new Float32Array(bytes("vertices")), indices: new Uint32Array(bytes("indices")),
    moveOf: new Uint32Array(bytes("moveOf")),
    deviation: has("deviation") ? new Float32Array(bytes("deviation")) : null,
  };
}

export function readDocument(): Document {
  return JSON.parse(textOf("data"));
}

const mostLines = 20_000_000;

/** Which moves a program line makes: for each text, the moves in the order of their lines, and where each line begins in them. */
export class Lines {
  private readonly first: Uint32Array[] = [];
  private readonly moves: Uint32Array[] = [];

  constructor(run: Run, texts: number) {
    const has = (i: number) => run.file[i] < texts && run.line[i] > 0 && run.line[i] < mostLines, last = new Uint32Array(texts);
    for (let i = 0; i < run.count; ++i) if (has(i)) last[run.file[i]] = Math.max(last[run.file[i]], run.line[i]);
    for (const line of last) this.first.push(new Uint32Array(line + 2));
    for (let i = 0; i < run.count; ++i) if (has(i)) ++this.first[run.file[i]][run.line[i] + 1];
    for (const first of this.first) {
      for (let k = 1; k < first.length; ++k) first[k] += first[k - 1];
      this.moves.push(new Uint32Array(first[first.length - 1]));
    }
    const next = this.first.map(first => first.slice());
    for (let i = 0; i < run.count; ++i) if (has(i)) this.moves[run.file[i]][next[run.file[i]][run.line[i]]++] = i;
  }

  of(file: number, line: number): Uint32Array {
    const first = this.first[file];
    return first && line > 0 && line + 1 < first.length ? this.moves[file].subarray(first[line], first[line + 1]) : new Uint32Array(0);
  }
}
