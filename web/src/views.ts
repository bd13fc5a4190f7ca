// The three pictures: 3D, plan view, three projections (first angle: front, from the left beside it, from above below it).
// All are parallel projections; the views of one picture share their scale and the point they look at.

import { OrthographicCamera, Vector3 } from "three";
import type { Vec } from "./data";

export type Picture = "3D" | "plan view" | "three projections";
export const pictures: Picture[] = ["3D", "plan view", "three projections"];

export interface Bounds { min: Vec; max: Vec }

/** Directions of a view in the workpiece: to the right, up, and to who looks. */
export interface Basis { right: Vector3; up: Vector3; back: Vector3 }

export interface Viewport {
  name: string;
  x: number; y: number; width: number; height: number;  // device pixels, y from below
  left: number; top: number; wide: number; high: number;  // page pixels
  camera: OrthographicCamera;
  basis: Basis;
  flat: boolean;  // looks along an axis: has rulers
  pixelDepth: number;
}

interface Look { target: Vector3; scale: number; turn: number; tilt: number }  // scale: page pixels per mm

const x = new Vector3(1, 0, 0), y = new Vector3(0, 1, 0), z = new Vector3(0, 0, 1);
const top: Basis = { right: x, up: y, back: z };
const front: Basis = { right: x, up: z, back: y.clone().negate() };
const left: Basis = { right: y.clone().negate(), up: z, back: x.clone().negate() };

function turned(turn: number, tilt: number): Basis {
  const c = Math.cos(turn), s = Math.sin(turn), ct = Math.cos(tilt), st = Math.sin(tilt);
  return { right: new Vector3(-s, c, 0), up: new Vector3(-st * c, -st * s, ct), back: new Vector3(ct * c, ct * s, st) };
}

export class Views {
  picture: Picture = "3D";
  all: Viewport[] = [];
  private looks = new Map<Picture, Look>();
  private size = { wide: 1, high: 1, ratio: 1 };
  private readonly centre: Vector3;
  private readonly radius: number;

  /** `scene` holds all that is drawn, `subject` is what is fitted into the picture. */
  constructor(scene: Bounds, private readonly subject: Bounds) {
    const low = new Vector3(...scene.min), high = new Vector3(...scene.max);
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.radius = Math.max(1, 0.5 * low.distanceTo(high));
  }

  get look(): Look {
    let found = this.looks.get(this.picture);
    if (!found) this.looks.set(this.picture, found = { target: new Vector3(), scale: 0, turn: -1.05, tilt: 0.62 });
    return found;
  }

  resize(wide: number, high: number, ratio: number) {
    this.size = { wide, high, ratio };
    for (const look of this.looks.values()) look.scale = 0;
    this.update();
  }
  show(picture: Picture) {
    this.picture = picture;
    this.update();
  }

  /** Where the views of the picture lie, in page pixels, and where they look from. */
  private cells(): { name: string; basis: Basis; flat: boolean; left: number; top: number; wide: number; high: number }[] {
    const { wide, high } = this.size, w = Math.floor(wide / 2), h = Math.floor(high / 2);
    if (this.picture === "3D") {
      const { turn, tilt } = this.look;
      return [{ name: "", basis: turned(turn, tilt), flat: false, left: 0, top: 0, wide, high }];
    }
    if (this.picture === "plan view") return [{ name: "plan view, from +Z", basis: top, flat: true, left: 0, top: 0, wide, high }];
    return [
      { name: "front, from −Y", basis: front, flat: true, left: 0, top: 0, wide: w, high: h },
      { name: "from the left, −X", basis: left, flat: true, left: w, top: 0, wide: wide - w, high: h },
      { name: "plan view, from +Z", basis: top, flat: true, left: 0, top: h, wide: w, high: high - h },
    ];
  }

  fit(bounds: Bounds = this.subject) {
    const look = this.look, low = new Vector3(...bounds.min), high = new Vector3(...bounds.max), size = high.clone().sub(low);
    look.target.copy(low).add(high).multiplyScalar(0.5);
    look.scale = Infinity;
    for (const cell of this.cells()) {
      const extent = (v: Vector3) => Math.abs(v.x) * size.x + Math.abs(v.y) * size.y + Math.abs(v.z) * size.z;
      const margin = cell.flat ? 130 : 90;
      look.scale = Math.min(look.scale, Math.max(40, cell.wide - margin) / Math.max(extent(cell.basis.right), 1e-3),
        Math.max(40, cell.high - (cell.flat ? 84 : 90)) / Math.max(extent(cell.basis.up), 1e-3));
    }
    this.update();
  }

  update() {
    const look = this.look;
    if (!look.scale) return this.fit();
    look.scale = Math.max(1e-3, Math.min(1e5, look.scale));
    const far = this.radius + this.centre.distanceTo(look.target) + 1, { high, ratio } = this.size;
    this.all = this.cells().map(cell => {
      const w = cell.wide / look.scale / 2, h = cell.high / look.scale / 2;
      const camera = new OrthographicCamera(-w, w, h, -h, 0, 2 * far);
      camera.position.copy(look.target).addScaledVector(cell.basis.back, far);
      camera.up.copy(cell.basis.up);
      camera.lookAt(look.target);
      camera.updateMatrixWorld();
      return {
        ...cell, camera, pixelDepth: 1 / (look.scale * ratio) / (2 * far),
        x: Math.round(cell.left * ratio), y: Math.round((high - cell.top - cell.high) * ratio),
        width: Math.round(cell.wide * ratio), height: Math.round(cell.high * ratio),
      };
    });
  }

  /** The view at a place of the picture. */
  at(px: number, py: number): Viewport {
    return this.all.find(v => px >= v.left && px < v.left + v.wide && py >= v.top && py < v.top + v.high) ?? this.all[0];
  }
  project(view: Viewport, p: Vec): [number, number] {
    const { target, scale } = this.look, d = new Vector3(...p).sub(target);
    return [view.left + view.wide / 2 + scale * d.dot(view.basis.right), view.top + view.high / 2 - scale * d.dot(view.basis.up)];
  }
  pan(view: Viewport, dx: number, dy: number) {
    const { target, scale } = this.look;
    target.addScaledVector(view.basis.right, -dx / scale).addScaledVector(view.basis.up, dy / scale);
    this.update();
  }
  orbit(dx: number, dy: number) {
    const look = this.look;
    look.turn -= dx * 0.008;
    look.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, look.tilt + dy * 0.008));
    this.update();
  }
  /** What lies under the place stays there. */
  zoom(view: Viewport, factor: number, px = view.left + view.wide / 2, py = view.top + view.high / 2) {
    const dx = px - view.left - view.wide / 2, dy = py - view.top - view.high / 2;
    this.pan(view, -dx, -dy);
    this.look.scale *= factor;
    this.pan(view, dx, dy);
  }
  lookAt(p: Vec, scale?: number) {
    this.look.target.set(...p);
    if (scale) this.look.scale = Math.max(this.look.scale, scale);
    this.update();
  }
}
