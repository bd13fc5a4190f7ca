// Buttons and boxes: which picture, which colours, what is shown; and the legend that belongs to them.

import * as colours from "./colours";
import type { Document, Mesh, Run } from "./data";
import { $, el } from "./dom";
import { shownChoices, type Shown } from "./path";
import type { Picture as Scene } from "./scene";
import { type Colouring } from "./surface";
import { pictures, type Picture } from "./views";

const words: Record<Colouring, string> = { surface: "surface", tool: "by tool", height: "by depth", deviation: "by deviation" };

export class Controls {
  private colouring: Colouring = "surface";
  private readonly buttons = new Map<Picture, HTMLButtonElement>();
  private readonly select = el("select");
  private chosenByHand = false;

  constructor(
    private readonly doc: Document, private readonly scene: Scene, private readonly run: Run, mesh: Mesh,
    private readonly heights: [number, number], private readonly limit: number,
  ) {
    const group = el("span", "group");
    for (const name of pictures) {
      const button = el("button", "", name);
      button.onclick = () => this.show(name);
      this.buttons.set(name, button);
      group.append(button);
    }
    $("views").append(group);
    if (mesh.indices.length) this.colourChoice(mesh);
    this.layers();
    $("fit").onclick = () => { scene.views.fit(); scene.viewChanged(); };
  }

  /** The plan view is shaded by depth, as controls draw it; the others keep what was chosen. */
  show(picture: Picture) {
    this.scene.views.show(picture);
    for (const [name, button] of this.buttons) {
      button.classList.toggle("on", name === picture);
      button.setAttribute("aria-pressed", String(name === picture));
    }
    if (!this.chosenByHand) this.colour(picture === "plan view" ? "height" : "surface");
    this.scene.viewChanged();
  }

  private colourChoice(mesh: Mesh) {
    const label = el("label", "choice"), choices: Colouring[] = ["surface", "tool", "height"];
    if (mesh.deviation) choices.push("deviation");
    for (const name of choices) {
      const option = el("option", "", words[name]);
      option.value = name;
      this.select.append(option);
    }
    this.select.id = "colouring";
    this.select.onchange = () => { this.chosenByHand = true; this.colour(this.select.value as Colouring); };
    label.append("colours", this.select);
    $("views").append(label);
  }
  private colour(by: Colouring) {
    this.colouring = by;
    this.select.value = by;
    this.scene.colour(by);
    this.legend();
  }

  private layers() {
    const { path, bodies } = this.scene, choice = el("label"), select = el("select");
    for (const name of shownChoices) select.append(el("option", "", name));
    select.id = "shown";
    select.value = path.shown;
    select.onchange = () => { path.shown = select.value as Shown; this.scene.update(); };
    choice.append("path", select);
    $("layers").append(choice);
    const box = (name: string, set: (on: boolean) => void) => {
      const label = el("label"), check = el("input");
      check.type = "checkbox";
      check.checked = true;
      check.onchange = () => { set(check.checked); this.scene.update(); };
      label.append(check, name);
      $("layers").append(label);
    };
    box("feed", on => path.layer("feeds", on));
    box("rapid", on => path.layer("rapids", on));
    box("tool", on => { bodies.showTool = on; });
    if (this.doc.stock) box("stock's outline", on => { bodies.showStock = on; });
    if (this.doc.clamps.length) box("clamps", on => { bodies.showClamps = on; });
  }

  private legend() {
    const out: HTMLElement[] = [], swatch = (colour: string, text: string) => {
      const item = el("span"), patch = el("span", "swatch");
      patch.style.background = colour;
      item.append(patch, text);
      out.push(item);
    };
    const ramp = (list: colours.Rgb[], low: string, high: string, text: string) => {
      const item = el("span"), patch = el("span", "ramp");
      patch.style.background = colours.gradient(list);
      item.append(low, patch, high, text);
      out.push(item);
    };
    const [low, high] = this.heights;
    if (this.colouring === "surface") swatch(colours.css(colours.cut), "cut by now");
    if (this.colouring === "tool")
      this.doc.tools.forEach((t, k) => swatch(colours.css(colours.tools[k % colours.tools.length]), `T${t.number} ${t.name}`));
    if (this.colouring === "height") ramp(colours.heights, "Z " + low.toFixed(2), high.toFixed(2) + " mm", "");
    if (this.colouring === "deviation") ramp(colours.deviations, `gouge \u2212${this.limit.toPrecision(2)}`, `+${this.limit.toPrecision(2)} mm excess`, "");
    swatch(colours.css(colours.uncut), "cut later");
    if (this.colouring !== "height" && this.colouring !== "deviation") swatch(colours.css(colours.stockFace), "face of the stock");
    if (this.run.count) {
      swatch("#08803a", "feed");
      swatch("repeating-linear-gradient(90deg,#d40000 0 5px,#fff 5px 8px)", "rapid");
    }
    if (this.doc.clamps.length) swatch("rgb(199 127 143)", "clamp");
    $("legend").replaceChildren(...out);
  }
}
