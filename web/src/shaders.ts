// The surface is drawn in three steps, so that a step of the slider costs the same for any number of triangles:
//   1. geometry: normal, height and number (triangles.ts) of what is seen at each pixel; again when the view changes;
//   2. shade:    the colour it has when it is cut, and its light; again when the view or the colouring changes;
//   3. compose:  cut by now or not, onto the canvas, with its depth for what is drawn over it; at every step.

import { cut, deviations, heights, rampCode, stockFace, tools, uncut, type Rgb } from "./colours";

const vec = (c: Rgb) => `vec3(${c.map(v => v.toFixed(3)).join(",")})`;

export const geometryVertex = `
  in vec3 position;
  in uint number;
  uniform mat4 modelViewMatrix, projectionMatrix;
  uniform vec2 heightRange;
  flat out uint id;
  out vec3 seen;
  out float height;
  void main() {
    vec4 p = modelViewMatrix * vec4(position, 1.0);
    id = number;
    seen = p.xyz;
    height = (position.z - heightRange.x) / max(heightRange.y - heightRange.x, 1e-9);
    gl_Position = projectionMatrix * p;
  }`;

export const geometryFragment = `
  precision highp float;
  precision highp int;
  flat in uint id;
  in vec3 seen;
  in float height;
  layout(location = 0) out vec4 shape;
  layout(location = 1) out vec4 owner;
  void main() {
    vec3 n = normalize(cross(dFdx(seen), dFdy(seen)));
    float h = clamp(height, 0.0, 1.0) * 255.0;
    shape = vec4(n.xy * 0.5 + 0.5, floor(h) / 255.0, fract(h));
    owner = vec4(float(id & 255u), float(id >> 8 & 255u), float(id >> 16 & 255u), float(id >> 24)) / 255.0;
  }`;

export const screenVertex = `
  in vec3 position;
  void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;

// 0xfffffd, the largest number of a move: above it lie faces of the stock.
const unpack = `
  const float lastMove = 16777213.0;
  float moveAt(vec4 owner) { return dot(floor(owner.xyz * 255.0 + 0.5), vec3(1.0, 256.0, 65536.0)); }`;

export const shadeFragment = `
  precision highp float;
  precision highp int;
  uniform sampler2D shape, owner, depth, toolOf;
  uniform int colouring;
  uniform float pixelDepth;  // depth of as many mm as a pixel is wide
  layout(location = 0) out vec4 colour;
  ${unpack}
  ${rampCode("heightColour", heights)}
  ${rampCode("deviationColour", deviations)}
  vec3 normalAt(ivec2 at) {
    vec2 xy = texelFetch(shape, at, 0).xy * 2.0 - 1.0;
    return vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy))));
  }
  vec3 toolColour(float move) {
    vec3 c[${tools.length}] = vec3[${tools.length}](${tools.map(vec).join(",")});
    int m = int(move), t = int(texelFetch(toolOf, ivec2(m & 4095, m >> 12), 0).x * 255.0 + 0.5);
    return t == 255 ? ${vec(cut)} : c[t % ${tools.length}];
  }
  // Sharp edges and outlines: where the normal turns or the depth jumps between neighbours, seen from the nearer side.
  float edge(ivec2 at, vec3 n, float d) {
    float e = 0.0;
    ivec2 last = textureSize(depth, 0) - 1;
    for (int k = 0; k < 4; ++k) {
      ivec2 near = clamp(at + ivec2(k == 0 ? 1 : k == 1 ? -1 : 0, k == 2 ? 1 : k == 3 ? -1 : 0), ivec2(0), last);
      float dn = texelFetch(depth, near, 0).x;
      float slope = sqrt(max(0.0, 1.0 - n.z * n.z)) / max(n.z, 0.1);
      if (dn - d > pixelDepth * (2.0 + 2.5 * slope)) e = max(e, 1.0);
      else if (dn < 1.0) e = max(e, smoothstep(0.35, 0.65, 1.0 - dot(n, normalAt(near))));
    }
    return e;
  }
  void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 own = texelFetch(owner, at, 0);
    float move = moveAt(own), d = texelFetch(depth, at, 0).x;
    if (d >= 1.0) { colour = vec4(1.0); return; }
    vec3 n = normalAt(at);
    vec4 s = texelFetch(shape, at, 0);
    float height = (s.z * 255.0 + s.w) / 255.0;
    // A strong lamp from the upper left shows low waves, a weak one from the right keeps what it does not reach apart.
    float light = 0.42 + 0.56 * pow(max(0.0, dot(n, normalize(vec3(-0.65, 0.45, 0.62)))), 1.4) + 0.26 * max(0.0, dot(n, normalize(vec3(0.75, 0.05, 0.45))));
    light *= 1.0 - 0.62 * edge(at, n, d);
    vec3 base = move > lastMove ? ${vec(stockFace)} : ${vec(cut)};
    if (colouring == 1 && move <= lastMove) base = toolColour(move);
    if (colouring == 2) base = heightColour(height);
    if (colouring == 3) base = own.w > 0.999 ? vec3(0.75) : deviationColour(own.w * 255.0 / 254.0);
    // Scales are read off: what faces the viewer has the legend's colour.
    colour = vec4(base * (colouring >= 2 ? min(1.1, 1.25 * light) : light), min(1.0, light * 0.8));
  }`;

export const composeFragment = `
  precision highp float;
  uniform sampler2D shaded, owner, depth;
  uniform float done, chosen;
  layout(location = 0) out vec4 colour;
  ${unpack}
  void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float d = texelFetch(depth, at, 0).x;
    gl_FragDepth = d;
    if (d >= 1.0) { colour = vec4(1.0); return; }
    float move = moveAt(texelFetch(owner, at, 0));
    vec4 c = texelFetch(shaded, at, 0);
    colour = vec4(move < done || move > lastMove ? c.rgb : ${vec(uncut)} * c.a / 0.8, 1.0);
    if (move == chosen) colour.rgb = mix(colour.rgb, vec3(0.04, 0.34, 0.82), 0.55);
  }`;

/** Which move is seen at a pixel, as a colour; the path is drawn over it by pathFragment with \`pick\`. */
export const pickFragment = `
  precision highp float;
  uniform sampler2D owner, depth;
  layout(location = 0) out vec4 colour;
  void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float d = texelFetch(depth, at, 0).x;
    gl_FragDepth = d;
    colour = d >= 1.0 ? vec4(1.0) : vec4(texelFetch(owner, at, 0).xyz, 0.0);
  }`;

/** The path as one strip: a piece belongs to its second point, whose \`number\` the flat value takes. */
export const pathVertex = `
  in vec3 position;
  in uint number;
  in float along;
  uniform mat4 modelViewMatrix, projectionMatrix;
  uniform float lift;
  flat out uint id;
  out float at;
  void main() {
    id = number;
    at = along;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_Position.z -= lift;
  }`;

export const pathFragment = `
  precision highp float;
  precision highp int;
  flat in uint id;
  in float at;
  uniform float done, scale;
  uniform bool pick, rapids, feeds;
  layout(location = 0) out vec4 colour;
  void main() {
    bool rapid = (id & 0x40000000u) != 0u;
    uint move = id & 0xffffffu;
    if ((id & 0x80000000u) != 0u || (rapid ? !rapids : !feeds)) discard;
    if (pick) { colour = vec4(float(move & 255u), float(move >> 8 & 255u), float(move >> 16), 128.0) / 255.0; return; }
    if (rapid && fract(at * scale / 9.0) > 0.58) discard;
    vec3 c = rapid ? vec3(0.83, 0.0, 0.0) : vec3(0.03, 0.50, 0.22);
    float seen = float(move) < done ? 1.0 : 0.32;
    colour = vec4(c, seen);
  }`;

/** Tool, clamps and lines around the workpiece: one colour, the surface's lamps. Lines have no normals. */
export const bodyVertex = `
  in vec3 position, normal;
  uniform mat4 modelViewMatrix, projectionMatrix;
  uniform mat3 normalMatrix;
  out vec3 n;
  void main() {
    n = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

export const bodyFragment = `
  precision highp float;
  in vec3 n;
  uniform vec4 paint;
  layout(location = 0) out vec4 colour;
  void main() {
    vec3 out_ = normalize(gl_FrontFacing ? n : -n);
    float light = 0.45 + 0.55 * max(0.0, dot(out_, normalize(vec3(-0.45, 0.55, 0.70)))) + 0.15 * max(0.0, dot(out_, normalize(vec3(0.75, 0.05, 0.45))));
    colour = vec4(paint.rgb * light, paint.a);
  }`;

export const lineVertex = `
  in vec3 position;
  uniform mat4 modelViewMatrix, projectionMatrix;
  void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

export const lineFragment = `
  precision highp float;
  uniform vec4 paint;
  layout(location = 0) out vec4 colour;
  void main() { colour = paint; }`;
