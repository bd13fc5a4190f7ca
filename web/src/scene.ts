// Puts surface, path and bodies onto the canvas, when something has changed; says what is seen at a place.

import { NearestFilter, WebGLRenderer, WebGLRenderTarget } from "three";
import type { Bodies } from "./bodies";
import type { Path } from "./path";
import { type Colouring, type Surface } from "./surface";
import type { Views } from "./views";

export class Picture {
  private readonly renderer: WebGLRenderer;
  private readonly picked = new WebGLRenderTarget(1, 1, { minFilter: NearestFilter, magFilter: NearestFilter });
  private waiting = 0;
  private viewIsNew = true;
  private done = 0;
  private readonly fast: boolean;
  private size = [0, 0, 0];
  private resting = 0;
  private fence: WebGLSync | null = null;
  /** Called after each frame; `viewIsNew`: what lies over the canvas has to move. */
  onFrame: (viewIsNew: boolean) => void = () => {};

  constructor(
    private readonly canvas: HTMLCanvasElement, readonly views: Views,
    readonly surface: Surface, readonly path: Path, readonly bodies: Bodies,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: false, powerPreference: "high-performance" });
    this.fast = !/swiftshader|llvmpipe|software|basic render/i.test(String(rendererName(this.renderer.getContext())));
    this.renderer.autoClear = false;
    canvas.addEventListener("webglcontextrestored", () => this.viewChanged());
  }

  /** Twice as many pixels as the screen has smooth all edges, where there is a graphics processor to draw them. */
  resize(wide: number, high: number) {
    const ratio = this.fast ? 2 : Math.min(2, window.devicePixelRatio || 1);
    if (this.size[0] === wide && this.size[1] === high && this.size[2] === ratio) return;
    this.size = [wide, high, ratio];
    const width = Math.max(1, Math.round(wide * ratio)), height = Math.max(1, Math.round(high * ratio));
    this.renderer.setSize(width, height, false);
    this.picked.setSize(width, height);
    this.surface.resize(width, height);
    this.views.resize(wide, high, ratio);
    this.viewChanged();
  }
  /** `moving`: by hand, and it may go on; where drawing is slow, details follow when the hand rests. */
  viewChanged(moving = false) {
    window.clearTimeout(this.resting);
    this.surface.roughly = moving && !this.fast;
    if (moving && !this.fast) this.resting = window.setTimeout(() => this.viewChanged(), 200);
    this.viewIsNew = true;
    this.surface.viewChanged();
    this.invalidate();
  }
  colour(by: Colouring) {
    this.surface.colour(by);
    this.invalidate();
  }
  /** A step of the run: no buffer is touched, only numbers in the shaders. */
  show(done: number, chosen: number) {
    this.done = done;
    this.surface.chosen = chosen;
    this.update();
  }
  update() {
    this.surface.done = Math.floor(this.done);
    this.path.done = this.done;
    this.bodies.done = this.done;
    this.invalidate();
  }
  invalidate() {
    if (!this.waiting) this.waiting = requestAnimationFrame(() => this.frame());
  }
  /** A slow graphics processor is given one frame at a time: else they would queue up and the page would lag behind the hand. */
  private frame() {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    this.waiting = 0;
    if (this.fence && gl.getSyncParameter(this.fence, gl.SYNC_STATUS) !== gl.SIGNALED && !gl.isContextLost()) return this.invalidate();
    if (this.fence) gl.deleteSync(this.fence);
    this.draw();
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  draw() {
    if (this.waiting) cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    const { renderer, views } = this, ratio = views.all[0].width / views.all[0].wide;
    this.surface.prepare(renderer, views.all);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, this.canvas.width, this.canvas.height);
    renderer.setClearColor(0xffffff, 1);
    renderer.clear();
    this.surface.draw(renderer);
    this.path.viewChanged(views.look.scale, views.all[0].pixelDepth, ratio);
    renderer.setScissorTest(true);
    for (const view of views.all) {
      renderer.setViewport(view.x, view.y, view.width, view.height);
      renderer.setScissor(view.x, view.y, view.width, view.height);
      this.bodies.lookFrom(view.camera);
      renderer.render(this.path.scene, view.camera);
      renderer.render(this.bodies.scene, view.camera);
    }
    const viewWasNew = this.viewIsNew;
    this.viewIsNew = false;
    this.onFrame(viewWasNew);
  }
  /** Waits until the frame is really there, for measuring. */
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** The move seen at a place of the canvas, path before surface; null: none. A path may be some pixels off. */
  pick(px: number, py: number): number | null {
    const { renderer, picked, views } = this, view = views.at(px, py), ratio = view.width / view.wide;
    const reach = Math.round(5 * ratio), size = 2 * reach + 1;
    const x = Math.round(px * ratio) - reach, y = this.canvas.height - Math.round(py * ratio) - reach - 1;
    picked.viewport.set(0, 0, picked.width, picked.height);
    picked.scissor.set(x, y, size, size);
    picked.scissorTest = true;
    renderer.setRenderTarget(picked);
    renderer.setClearColor(0xffffff, 1);
    renderer.clear();
    this.surface.drawPicking(renderer);
    picked.viewport.set(view.x, view.y, view.width, view.height);
    renderer.setRenderTarget(picked);
    this.path.picking = true;
    renderer.render(this.path.scene, view.camera);
    this.path.picking = false;
    const pixels = new Uint8Array(4 * size * size);
    renderer.readRenderTargetPixels(picked, x, y, size, size, pixels);
    renderer.setRenderTarget(null);
    return nearestMove(pixels, reach);
  }
}

function rendererName(gl: WebGLRenderingContext | WebGL2RenderingContext): unknown {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
}

function nearestMove(pixels: Uint8Array, reach: number): number | null {
  const size = 2 * reach + 1, moveAt = (k: number) => pixels[k] + 256 * pixels[k + 1] + 65536 * pixels[k + 2];
  let best: number | null = null, least = Infinity;
  for (let k = 0; k < pixels.length; k += 4) {
    if (pixels[k + 3] !== 128) continue;
    const dx = (k / 4) % size - reach, dy = Math.floor(k / 4 / size) - reach, off = dx * dx + dy * dy;
    if (off < least) { least = off; best = moveAt(k); }
  }
  if (best !== null) return best;
  const middle = 4 * (reach * size + reach), move = moveAt(middle);
  return pixels[middle + 3] === 0 && move < 0xfffffe ? move : null;
}
