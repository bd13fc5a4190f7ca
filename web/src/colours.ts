// Colours of the picture, as shader code and for the legend.

export const cut: Rgb = [0.66, 0.74, 0.83];       // machined by now
export const uncut: Rgb = [0.92, 0.84, 0.62];     // stock that is still to be cut
export const stockFace: Rgb = [0.74, 0.70, 0.62]; // faces no move touches
export type Rgb = [number, number, number];

/** Twelve tools that can be told apart, then again. */
export const tools: Rgb[] = [
  [0.31, 0.55, 0.78], [0.93, 0.60, 0.25], [0.38, 0.66, 0.40], [0.78, 0.38, 0.40], [0.58, 0.48, 0.74], [0.60, 0.46, 0.40],
  [0.87, 0.55, 0.73], [0.73, 0.72, 0.32], [0.36, 0.70, 0.75], [0.45, 0.50, 0.56], [0.85, 0.75, 0.55], [0.30, 0.42, 0.34],
];

/** Low to high: deep is dark blue, the top is pale yellow. */
export const heights: Rgb[] = [
  [0.10, 0.15, 0.40], [0.14, 0.36, 0.58], [0.16, 0.56, 0.60], [0.40, 0.72, 0.50], [0.75, 0.82, 0.42], [0.98, 0.93, 0.68],
];
/** Gouge, within the limit, excess. */
export const deviations: Rgb[] = [
  [0.70, 0.02, 0.10], [0.95, 0.45, 0.40], [0.80, 0.83, 0.84], [0.40, 0.60, 0.95], [0.05, 0.20, 0.65],
];

export const css = (c: Rgb): string => `rgb(${c.map(v => Math.round(255 * v)).join(" ")})`;
export const gradient = (ramp: Rgb[]): string => `linear-gradient(90deg,${ramp.map(css).join(",")})`;

/** GLSL: a function `name(float t)` that goes through the ramp's colours for t from 0 to 1. */
export function rampCode(name: string, ramp: Rgb[]): string {
  const n = ramp.length, list = ramp.map(c => `vec3(${c.map(v => v.toFixed(3)).join(",")})`).join(",");
  return `vec3 ${name}(float t) {
    vec3 c[${n}] = vec3[${n}](${list});
    float at = clamp(t, 0.0, 1.0) * ${(n - 1).toFixed(1)};
    int low = min(int(at), ${n - 2});
    return mix(c[low], c[low + 1], at - float(low));
  }`;
}
