// Small helpers for the page's elements. All texts go in through textContent, never as markup.

export function $<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error("no element " + id);
  return found as T;
}

export function el<K extends keyof HTMLElementTagNameMap>(tag: K, cls = "", text?: string | number): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (cls) made.className = cls;
  if (text !== undefined) made.textContent = String(text);
  return made;
}

export function svg(tag: string, attributes: Record<string, string | number>, text?: string): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const name in attributes) made.setAttribute(name, String(attributes[name]));
  if (text !== undefined) made.textContent = text;
  return made;
}

export const mm = (v: number | null | undefined): string => v == null || !Number.isFinite(v) ? "?" : v.toFixed(3);

/** 4523.2 s as "1:15:23". */
export function clock(seconds: number): string {
  if (!Number.isFinite(seconds)) return "?";
  const s = Math.floor(seconds % 60), m = Math.floor(seconds / 60) % 60, h = Math.floor(seconds / 3600);
  const two = (n: number) => String(n).padStart(2, "0");
  return h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`;
}

/** 1, 2 or 5 times a power of ten, not below `raw`. */
export function niceStep(raw: number): number {
  const p = Math.pow(10, Math.floor(Math.log10(raw)));
  return (raw <= p ? 1 : raw <= 2 * p ? 2 : raw <= 5 * p ? 5 : 10) * p;
}
export const digitsOf = (step: number): number => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

export type Listener<T> = (value: T) => void;
