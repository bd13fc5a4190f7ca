// What stands around the surface: the tool with shank and holder, clamps, the outline of the stock.

import {
  BoxGeometry, Color, EdgesGeometry, GLSL3, Group, LatheGeometry, LineSegments, Mesh, Quaternion, RawShaderMaterial, Scene, Vector2,
  Vector3, type OrthographicCamera,
} from "three";
import type { Box, Run, Tool } from "./data";
import { placeAt } from "./path";
import { bodyFragment, bodyVertex, lineFragment, lineVertex } from "./shaders";

function paint(colour: number, opacity: number, line = false): RawShaderMaterial {
  const { r, g, b } = new Color().setHex(colour, "srgb-linear");  // as it is: these shaders write what the screen shows
  return new RawShaderMaterial({
    glslVersion: GLSL3, vertexShader: line ? lineVertex : bodyVertex, fragmentShader: line ? lineFragment : bodyFragment,
    transparent: opacity < 1, uniforms: { paint: { value: [r, g, b, opacity] } },
  });
}
const cutting = paint(0xf2bf2e, 0.82), shank = paint(0xb4bdc5, 0.9), holder = paint(0x76808a, 0.9), clamp = paint(0xcf8a99, 0.6);
const outline = paint(0x6b4e00, 0.8, true), stockLine = paint(0x8a7a50, 0.75, true), clampLine = paint(0x7a3040, 1, true);
const round = 48;

/** Half the section of the cutting part: radius and height above the tip. */
export function profileOf(tool: Tool): Vector2[] {
  if (tool.outline.length > 1) {
    const points = tool.outline.map(([r, h]) => new Vector2(Math.max(0, r), h));
    if (points[0].x > 0) points.unshift(new Vector2(0, points[0].y));
    return closed(points);
  }
  const r = tool.radius ?? 0, c = Math.min(Math.max(0, tool.corner ?? 0), r), length = Math.max(tool.cutting ?? 0, c, 1e-3);
  const points = [new Vector2(0, 0)];
  for (let k = 0; k <= 8 && c > 0; ++k) points.push(new Vector2(r - c + c * Math.sin(k * Math.PI / 16), c - c * Math.cos(k * Math.PI / 16)));
  if (c === 0) points.push(new Vector2(r, 0));
  points.push(new Vector2(r, length));
  return closed(points);
}
function closed(points: Vector2[]): Vector2[] {
  points.push(new Vector2(0, points[points.length - 1].y));
  return points;
}

function lathe(points: Vector2[], material: RawShaderMaterial): Group {
  const group = new Group(), geometry = new LatheGeometry(points, round);
  group.add(new Mesh(geometry, material));
  group.add(new LineSegments(new EdgesGeometry(geometry, 28), outline));
  return group;
}

/** Along +z with the tip at the origin; its second child holds shank and holder. */
function toolGroup(tool: Tool): Group {
  const group = new Group(), above = new Group();
  if ((tool.radius ?? 0) > 0 || tool.outline.length > 1) group.add(lathe(profileOf(tool), cutting));
  for (const [from, to, r0, r1, holds] of tool.bodies)
    above.add(lathe([new Vector2(0, from), new Vector2(r0, from), new Vector2(r1, to), new Vector2(0, to)], holds ? holder : shank));
  group.rotation.x = above.rotation.x = Math.PI / 2;  // a lathe turns about y
  const stand = new Group();
  stand.add(group, above);
  return stand;
}

function boxLines(box: Box, material: RawShaderMaterial): { solid: BoxGeometry; lines: LineSegments; middle: Vector3 } {
  const low = new Vector3(...box.min), high = new Vector3(...box.max), size = high.clone().sub(low);
  const solid = new BoxGeometry(size.x, size.y, size.z), lines = new LineSegments(new EdgesGeometry(solid), material);
  const middle = low.add(high).multiplyScalar(0.5);
  lines.position.copy(middle);
  return { solid, lines, middle };
}

export class Bodies {
  readonly scene = new Scene();
  private readonly tools: Group[];
  private readonly clamps = new Group();
  private readonly stock = new Group();
  showTool = true;

  constructor(private readonly run: Run, tools: Tool[], clamps: Box[], stock: Box | null) {
    this.tools = tools.map(toolGroup);
    for (const tool of this.tools) this.scene.add(tool);
    for (const box of clamps) {
      const { solid, lines, middle } = boxLines(box, clampLine), mesh = new Mesh(solid, clamp);
      mesh.position.copy(middle);
      this.clamps.add(mesh, lines);
    }
    if (stock) this.stock.add(boxLines(stock, stockLine).lines);
    this.scene.add(this.clamps, this.stock);
  }

  set showClamps(on: boolean) { this.clamps.visible = on; }
  set showStock(on: boolean) { this.stock.visible = on; }

  set done(moves: number) {
    for (const tool of this.tools) tool.visible = false;
    if (!this.showTool || moves >= this.run.count) return;
    const place = placeAt(this.run, moves), tool = place && this.tools[this.run.tool[place.move]];
    if (!tool) return;
    tool.visible = true;
    tool.position.set(...place.point);
    const axes = this.run.axes, a = 3 * place.move;
    tool.quaternion.copy(axes
      ? new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(axes[a], axes[a + 1], axes[a + 2]).normalize())
      : new Quaternion());
  }
  /** Seen along its axis, a tool would hide what it cuts behind its holder: there only the cutting part is drawn. */
  lookFrom(camera: OrthographicCamera) {
    const m = camera.matrixWorld.elements, back = new Vector3(m[8], m[9], m[10]);
    for (const tool of this.tools) tool.children[1].visible = new Vector3(0, 0, 1).applyQuaternion(tool.quaternion).dot(back) < 0.94;
  }
}
