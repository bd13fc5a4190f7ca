// The machined surface on its way to the canvas: see shaders.ts for the three steps.

import {
  AlwaysDepth, BufferAttribute, BufferGeometry, DataTexture, DepthTexture, GLSL3, Mesh as ThreeMesh, NearestFilter, NoBlending, OrthographicCamera,
  PlaneGeometry, RawShaderMaterial, RedFormat, Scene, UnsignedByteType, UnsignedIntType, WebGLRenderTarget, type WebGLRenderer,
} from "three";
import type { Mesh, Run } from "./data";
import { composeFragment, geometryFragment, geometryVertex, pickFragment, screenVertex, shadeFragment } from "./shaders";
import { coarse, triangles, type Triangles } from "./triangles";
import type { Viewport } from "./views";

export type Colouring = "surface" | "tool" | "height" | "deviation";
export const colourings: Colouring[] = ["surface", "tool", "height", "deviation"];

const plain = { glslVersion: GLSL3, blending: NoBlending } as const;

/** A rectangle over all of the target, drawn with one shader. */
class Screen {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  constructor(readonly material: RawShaderMaterial) {
    const plane = new ThreeMesh(new PlaneGeometry(2, 2), material);
    plane.frustumCulled = false;
    this.scene.add(plane);
  }
  draw(renderer: WebGLRenderer) { renderer.render(this.scene, this.camera); }
}

/** Which tool made a move, as a texture of 4096 columns. */
function toolTexture(run: Run): DataTexture {
  const width = 4096, height = Math.max(1, Math.ceil(run.count / width)), data = new Uint8Array(width * height).fill(255);
  for (let i = 0; i < run.count; ++i) data[i] = run.tool[i] === 0xffff ? 255 : run.tool[i] % 255;
  const texture = new DataTexture(data, width, height, RedFormat, UnsignedByteType);
  texture.needsUpdate = true;
  return texture;
}

function geometryOf(made: Triangles, indices: Uint32Array, shared?: BufferGeometry): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", shared?.getAttribute("position") ?? new BufferAttribute(made.positions, 3));
  geometry.setAttribute("number", shared?.getAttribute("number") ?? new BufferAttribute(made.numbers, 1));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}

export class Surface {
  private readonly scene = new Scene();
  private readonly target: WebGLRenderTarget;
  private readonly shaded: WebGLRenderTarget;
  private readonly shade: Screen;
  private readonly compose: Screen;
  private readonly picking: Screen;
  private readonly made: Triangles;
  private readonly fine: BufferGeometry;
  private readonly mesh: ThreeMesh;
  private rough: BufferGeometry | null = null;
  private geometryWanted = true;
  private shadeWanted = true;

  constructor(mesh: Mesh, run: Run, heightRange: [number, number], mostDeviation: number) {
    const nearest = { minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false } as const;
    this.target = new WebGLRenderTarget(1, 1, { count: 2, depthTexture: new DepthTexture(1, 1, UnsignedIntType), ...nearest });
    this.shaded = new WebGLRenderTarget(1, 1, { depthBuffer: false, ...nearest });
    const [shape, owner] = this.target.textures, depth = this.target.depthTexture;
    const material = new RawShaderMaterial({
      ...plain, vertexShader: geometryVertex, fragmentShader: geometryFragment, uniforms: { heightRange: { value: heightRange } },
    });
    this.made = triangles(mesh, mostDeviation);
    this.fine = geometryOf(this.made, this.made.indices);
    this.mesh = new ThreeMesh(this.fine, material);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
    const screen = (fragmentShader: string, uniforms: Record<string, { value: unknown }>, depthWrite: boolean) =>
      new Screen(new RawShaderMaterial({ ...plain, vertexShader: screenVertex, fragmentShader, uniforms, depthTest: depthWrite, depthWrite, depthFunc: AlwaysDepth }));
    this.shade = screen(shadeFragment, {
      shape: { value: shape }, owner: { value: owner }, depth: { value: depth }, toolOf: { value: toolTexture(run) }, colouring: { value: 0 }, pixelDepth: { value: 0 },
    }, false);
    this.compose = screen(composeFragment, {
      shaded: { value: this.shaded.texture }, owner: { value: owner }, depth: { value: depth }, done: { value: 0 }, chosen: { value: -1 },
    }, true);
    this.picking = screen(pickFragment, { owner: { value: owner }, depth: { value: depth } }, true);
  }

  resize(width: number, height: number) {
    this.target.setSize(width, height);
    this.shaded.setSize(width, height);
    this.viewChanged();
  }
  /** Draws fewer triangles, where there are many; for while the view is turned on a slow machine. */
  set roughly(on: boolean) {
    const many = this.made.indices.length > 3 * 100_000;
    if (on && many) this.rough ??= geometryOf(this.made, coarse(this.made, 150), this.fine);
    this.mesh.geometry = on && this.rough ? this.rough : this.fine;
  }
  viewChanged() { this.geometryWanted = this.shadeWanted = true; }
  colour(by: Colouring) {
    this.shade.material.uniforms.colouring.value = colourings.indexOf(by);
    this.shadeWanted = true;
  }
  set done(moves: number) { this.compose.material.uniforms.done.value = moves; }
  set chosen(move: number) { this.compose.material.uniforms.chosen.value = move; }

  /** Steps 1 and 2 where they are wanted; the canvas is the target afterwards. */
  prepare(renderer: WebGLRenderer, views: Viewport[]) {
    if (this.geometryWanted) {
      renderer.setRenderTarget(this.target);
      renderer.setClearColor(0xffffff, 1);
      this.target.viewport.set(0, 0, this.target.width, this.target.height);
      this.target.scissorTest = false;
      renderer.setRenderTarget(this.target);
      renderer.clear();
      for (const view of views) {
        this.target.viewport.set(view.x, view.y, view.width, view.height);
        this.target.scissor.copy(this.target.viewport);
        this.target.scissorTest = true;
        renderer.setRenderTarget(this.target);
        renderer.render(this.scene, view.camera);
      }
    }
    if (this.shadeWanted) {
      this.shade.material.uniforms.pixelDepth.value = views[0].pixelDepth;
      renderer.setRenderTarget(this.shaded);
      this.shade.draw(renderer);
    }
    renderer.setRenderTarget(null);
    this.geometryWanted = this.shadeWanted = false;
  }
  /** Step 3. */
  draw(renderer: WebGLRenderer) { this.compose.draw(renderer); }
  drawPicking(renderer: WebGLRenderer) { this.picking.draw(renderer); }
}
