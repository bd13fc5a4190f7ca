// Mouse, pen, finger and keys in the picture.

import { $ } from "./dom";
import type { Picture } from "./scene";

export function pointer(picture: Picture, onPick: (move: number | null) => void) {
  const view = $("view"), { views } = picture;
  let drag: { id: number; x: number; y: number; moved: boolean; pan: boolean } | null = null;
  const place = (event: MouseEvent): [number, number] => {
    const r = view.getBoundingClientRect();
    return [event.clientX - r.left - view.clientLeft, event.clientY - r.top - view.clientTop];
  };
  const change = (act: () => void) => { act(); picture.viewChanged(true); };

  view.addEventListener("pointerdown", event => {
    if ((event.target as Element).closest(".mark,.no")) return;
    view.setPointerCapture(event.pointerId);
    drag = { id: event.pointerId, x: event.clientX, y: event.clientY, moved: false, pan: event.button !== 0 || event.shiftKey || views.picture !== "3D" };
  });
  view.addEventListener("pointermove", event => {
    if (!drag || event.pointerId !== drag.id) return;
    const dx = event.clientX - drag.x, dy = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(dx, dy) < 4) return;
    const { pan } = drag;
    drag = { ...drag, x: event.clientX, y: event.clientY, moved: true };
    change(() => pan ? views.pan(views.at(...place(event)), dx, dy) : views.orbit(dx, dy));
  });
  const end = (event: PointerEvent) => {
    if (!drag || event.pointerId !== drag.id) return;
    const click = !drag.moved && event.type === "pointerup" && event.button === 0;
    drag = null;
    if (click) onPick(picture.pick(...place(event)));
  };
  view.addEventListener("pointerup", end);
  view.addEventListener("pointercancel", end);
  view.addEventListener("contextmenu", event => event.preventDefault());
  view.addEventListener("wheel", event => {
    event.preventDefault();
    const [x, y] = place(event);
    change(() => views.zoom(views.at(x, y), Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), x, y));
  }, { passive: false });

  const keys: Record<string, [number, number]> = { ArrowLeft: [-24, 0], ArrowRight: [24, 0], ArrowUp: [0, -24], ArrowDown: [0, 24] };
  view.addEventListener("keydown", event => {
    if (event.target !== view) return;
    const step = keys[event.key], all = views.all[0];
    if (step) change(() => event.shiftKey || views.picture !== "3D" ? views.pan(all, ...step) : views.orbit(...step));
    else if (event.key === "+" || event.key === "=") change(() => views.zoom(all, 1.25));
    else if (event.key === "-") change(() => views.zoom(all, 0.8));
    else if (event.key === "Home") change(() => views.fit());
    else return;
    event.preventDefault();
  });
}
