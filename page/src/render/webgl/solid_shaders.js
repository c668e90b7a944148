// The shaders of the bodies that ropes touch. A body is found by going along each pixel's ray by the distance to its
// surface; what is found is kept, with its depth, until the camera moves.

import { RIM } from "../../view/solids.js";
import { COMMON } from "./shaders.js";

const real = (/** @type {number} */ value) => value.toFixed(4);

/** The distance of a place, from the body's centre, to its surface; `zero` is the direction of a box's first edge. */
export const SURFACE = /* glsl */ `
float surface(vec3 p, int kind, vec3 axis, vec3 zero, vec4 size, float bevel) {
  float along = dot(p, axis);
  if (kind == 0) return along;
  if (kind == 1) return length(p) - size.x;
  if (kind == 4) {
    vec3 q = abs(vec3(dot(p, zero), dot(p, cross(axis, zero)), along)) - size.xyz;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - size.w;
  }
  vec3 across = p - along * axis;
  float rho = length(across);
  if (kind == 6) return size.x - (dot(across, size.yzw) > 0.0 ? abs(dot(across, cross(size.yzw, axis))) : rho);
  if (kind == 5) return length(vec2(rho - size.x, along)) - size.y;
  if (kind == 3) return length(vec2(rho, max(abs(along) - size.y, 0.0))) - size.x;
  vec2 q = vec2(rho - size.x, abs(along) - size.y) + bevel;
  return min(max(q.x, q.y), 0.0) + length(max(q, 0.0)) - bevel;
}
`;

/** All bodies near ropes, four texels each. */
export const SOLIDS = /* glsl */ `
uniform highp sampler2D solids;
uniform int solidCount;
${SURFACE}
float awayFrom(int k, vec3 place) {
  vec4 centre = texelFetch(solids, ivec2(0, k), 0);
  vec4 axis = texelFetch(solids, ivec2(1, k), 0);
  vec3 zero = texelFetch(solids, ivec2(3, k), 0).xyz;
  return surface(place - centre.xyz, int(centre.w), axis.xyz, zero, texelFetch(solids, ivec2(2, k), 0), axis.w);
}
float awayFromAll(vec3 place) {
  float found = 1e30;
  for (int k = 0; k < solidCount; k++) found = min(found, awayFrom(k, place));
  return found;
}
// Ropes that are drawn thicker than they are lie on bodies, too: how far to lift a place off them.
vec3 lifted(vec3 place, float radius) {
  for (int k = 0; k < solidCount; k++) {
    float away = awayFrom(k, place);
    if (away >= radius) continue;
    float e = 0.2 * radius;
    vec3 slope = vec3(awayFrom(k, place + vec3(e, 0.0, 0.0)), awayFrom(k, place + vec3(0.0, e, 0.0)),
                      awayFrom(k, place + vec3(0.0, 0.0, e))) - away;
    if (dot(slope, slope) > 0.0) place += normalize(slope) * min(radius - away, 2.0 * radius);
  }
  return place;
}
`;

export const SOLID_VERTEX = /* glsl */ `
uniform vec4 box;      // of the screen, -1 to 1: left, bottom, right, top
void main() {
  vec2 part = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(box.xy, box.zw, part), 0.5, 1.0);
}
`;

const BODY = /* glsl */ `${COMMON}${SURFACE}
uniform vec2 size;     // of the picture [CSS pixels]
uniform vec3 top;
uniform vec3 ahead;
uniform int kind;
uniform vec3 centre;   // of the body
uniform vec3 axis;
uniform vec3 zero;     // across the axis: of a box its first edge, of others where angles begin
uniform vec4 sizes;
uniform float bevel;
uniform float reach;   // of the body [m]
uniform vec3 middle;   // of the scene
uniform float radius;  // of the scene [m]
vec3 ray(out float straight) {
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 found = ahead + (right * at.x + top * at.y) * pixel;
  straight = 1.0 / length(found);
  return found * straight;
}
// Where a ray leaves a trough: the wall before it is cut away. It fades far from the scene, as a plane does.
vec2 leave(vec3 from, vec3 way) {
  vec3 above = sizes.yzw, side = cross(above, axis);
  vec2 o = vec2(dot(from, side), dot(from, above)), d = vec2(dot(way, side), dot(way, above));
  float r = sizes.x, a = max(dot(d, d), 1e-12), b = dot(o, d), c = dot(o, o) - r * r, root = b * b - a * c;
  float rim = ${real(RIM)} * r, wall = (sign(d.x) * r - o.x) / d.x, t = 0.0, cover = 0.0;
  float high = o.y + d.y * wall, perPixel = pixel * max(wall, 0.0) + 1e-9;
  if (wall > 0.0 && high > 0.0) { t = wall; cover = clamp((rim - high) / perPixel + 0.5, 0.0, 1.0); }
  float round = root > 0.0 ? (sqrt(root) - b) / a : 0.0;
  if (cover == 0.0 && round > 0.0 && o.y + d.y * round <= 0.0) { t = round; cover = 1.0; }
  float far = length(from + way * t + centre - middle) / (2.2 * radius);
  return vec2(t, cover * exp(-far * far * far));
}
// Go along a ray; returns the way to the surface, or to where the ray comes nearest, and how much of the pixel it
// covers.
vec2 follow(vec3 way, float straight) {
  vec3 from = eye - centre;
  if (kind == 0) {
    float t = -dot(from, axis) / dot(way, axis);
    vec3 p = from + way * t + centre - middle;
    float far = length(p) / (2.2 * radius);
    return vec2(t, t > 0.0 ? exp(-far * far * far) : 0.0);
  }
  if (kind == 6) return leave(from, way);
  float towards = -dot(from, way);
  float aside = dot(from, from) - towards * towards, room = reach + 2.0 * pixel * max(towards, 0.0);
  if (aside > room * room) return vec2(0.0);
  float t = max(0.0, min(towards, length(from)) - reach), end = towards + reach;
  float wide = pixel * straight; // of a pixel, per metre
  vec2 found = vec2(t, 1e9);
  for (int i = 0; i < 64; i++) {
    float away = surface(from + way * t, kind, axis, zero, sizes, bevel);
    float pixels = away / (wide * max(t, 1e-6));
    if (pixels < found.y) found = vec2(t, pixels);
    if (pixels < 0.1 || t > end) break;
    t += max(away, 0.1 * wide * t);
  }
  return vec2(found.x, clamp(1.1 - found.y, 0.0, 1.0));
}
`;

/** What lies at each pixel: how deep it is [m], where around the axis it is, which body it is, and how much of that
 * angle a pixel takes. */
export const SOLID_INFO = /* glsl */ `${BODY}
uniform int number;
out highp uvec4 info;
void main() {
  float straight;
  vec3 way = ray(straight);
  vec2 found = follow(way, straight);
  if (found.y < 0.5) discard;
  vec3 p = eye - centre + way * found.x;
  float depth = found.x * straight;
  float angle = atan(dot(p, cross(axis, zero)), dot(p, zero));
  float rho = max(length(p - dot(p, axis) * axis), 1e-9);
  info = uvec4(floatBitsToUint(depth), floatBitsToUint(angle), uint(number + 1),
               floatBitsToUint(pixel * depth / rho));
  gl_FragDepth = 0.5 + 0.5 * (projection[3][2] / depth - projection[2][2]);
}
`;

export const SOLID_COLOUR = /* glsl */ `${BODY}
uniform vec3 paint;
uniform vec3 grid;
uniform float spacing; // of the floor's lines [m]
uniform float height;  // of the floor along up [m]
uniform int number;
uniform highp usampler2D info;
out vec4 colour;
vec3 normalAt(vec3 p, float e) {
  vec2 k = vec2(1.0, -1.0);
  return normalize(k.xyy * surface(p + k.xyy * e, kind, axis, zero, sizes, bevel) +
                   k.yyx * surface(p + k.yyx * e, kind, axis, zero, sizes, bevel) +
                   k.yxy * surface(p + k.yxy * e, kind, axis, zero, sizes, bevel) +
                   k.xxx * surface(p + k.xxx * e, kind, axis, zero, sizes, bevel));
}
// Whether the body is next to this pixel: only there it may cover a part of it.
bool atEdge() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint own = uint(number + 1);
  return texelFetch(info, at + ivec2(1, 0), 0).z == own || texelFetch(info, at - ivec2(1, 0), 0).z == own ||
         texelFetch(info, at + ivec2(0, 1), 0).z == own || texelFetch(info, at - ivec2(0, 1), 0).z == own;
}
// How much of a pixel a groove covers that is "wide" and "away" from its middle.
float groove(float away, float wide, float perPixel) {
  return clamp((0.5 * wide - abs(away)) / perPixel + 0.5, 0.0, 1.0) * min(1.0, wide / perPixel);
}
float lines(vec2 at, float perPixel) {
  vec2 away = abs(fract(at - 0.5) - 0.5) / max(perPixel, 1e-6);
  vec2 part = clamp(1.0 - away, 0.0, 1.0);
  return max(part.x, part.y) * (1.0 - smoothstep(0.15, 0.5, perPixel));
}
void main() {
  float straight;
  vec3 way = ray(straight);
  uvec4 known = texelFetch(info, ivec2(gl_FragCoord.xy), 0);
  bool fades = kind == 0 || kind == 6;
  vec2 found = known.z == uint(number + 1) && !fades
    ? vec2(uintBitsToFloat(known.x) / straight, 1.0)
    : fades || atEdge() ? follow(way, straight) : vec2(0.0);
  if (found.y <= 0.0) discard;
  vec3 p = eye - centre + way * found.x;
  float depth = found.x * straight, perPixel = pixel * depth;
  vec3 n = kind == 0 ? axis * -sign(dot(axis, way)) : normalAt(p, max(0.4 * perPixel, 1e-5 * length(p)));
  float wrapped = max(dot(n, key) + 0.2, 0.0) / 1.2;
  float front = max(dot(n, -way), 0.0);
  float light = 0.5 + 0.22 * dot(n, up) + 0.6 * wrapped * wrapped + 0.12 * front;
  float sheen = 0.07 * pow(max(dot(n, normalize(key - way)), 0.0), 26.0);
  vec3 base = paint * paint;
  float along = dot(p, axis), rho = length(p - along * axis);
  if (kind == 2 && abs(dot(n, axis)) > 0.7 && sizes.x > 12.0 * perPixel) { // a turned face
    float wide = 0.018 * sizes.x;
    light *= 1.0 - 0.26 * (groove(rho - 0.84 * sizes.x, wide, perPixel) + groove(rho - 0.3 * sizes.x, wide, perPixel));
    light *= 1.0 - 0.4 * clamp((0.11 * sizes.x - rho) / perPixel + 0.5, 0.0, 1.0);
  }
  if (kind == 0) {
    vec3 first = normalize(abs(axis.z) < 0.9 ? cross(vec3(0.0, 0.0, 1.0), axis) : cross(vec3(1.0, 0.0, 0.0), axis));
    vec2 at = vec2(dot(p, first), dot(p, cross(axis, first))) / spacing;
    float ink = lines(at, perPixel / max(abs(dot(n, way)), 0.05) / spacing);
    base = mix(base, grid * grid, 0.7 * ink);
    sheen = 0.0;
  }
  float above = dot(p + centre, up) - height; // near the floor there is less light
  light *= 1.0 - 0.4 * exp(-max(above, 0.0) / (0.25 * min(reach, radius))) * max(0.0, 0.6 - dot(n, up));
  colour = vec4(sqrt(base * max(light, 0.0) + sheen), found.y);
  gl_FragDepth = 0.5 + 0.5 * (projection[3][2] / depth - projection[2][2]);
}
`;

/** The shadow of a body on the floor. */
export const SOLID_SHADOW = /* glsl */ `${BODY}
uniform float height;
uniform float ink;
out vec4 colour;
void main() {
  float straight;
  vec3 way = ray(straight);
  float down = dot(way, up);
  if (down > -1e-4) discard;
  vec3 q = eye + way * ((dot(eye, up) - height) / -down) - centre;
  vec3 level = key - up * dot(key, up);
  vec3 light = normalize(up + 0.75 * level / dot(key, up));
  float towards = -dot(q, light), least = 1.0;
  vec3 past = q + light * towards; // where the way to the light comes nearest to the middle
  float room = 1.05 * reach + 0.22 * max(towards, 0.0);
  if (dot(past, past) > room * room && dot(q, q) > 4.0 * reach * reach) discard;
  float t = max(0.02 * reach, towards - reach), end = towards + reach;
  for (int i = 0; i < 20 && t < end; i++) {
    float away = surface(q + light * t, kind, axis, zero, sizes, bevel);
    least = min(least, away / (0.22 * t + 0.01 * reach));
    if (least < -1.0) break;
    t += clamp(away, 0.06 * reach, 0.5 * reach);
  }
  float dark = 1.0 - smoothstep(-1.0, 1.0, least);
  float near = exp(-max(surface(q, kind, axis, zero, sizes, bevel), 0.0) / (0.16 * min(reach, radius)));
  dark = max(0.8 * dark, 0.75 * near * near);
  if (dark < 0.004) discard;
  colour = vec4(0.0, 0.0, 0.0, ink * dark);
}
`;

/** Where a rope is near a body: the same ribbon, wider, which darkens the surface behind it. */
export const CONTACT_VERTEX = /* glsl */ `
out vec3 on;           // a place on the rope's middle
out vec3 along;
out float thickness;   // radius as drawn [m]
void main() {
  int i = gl_VertexID >> 1;
  vec3 here = point(i).xyz;
  vec3 before = look.y > 0.5 ? point(i - 1).xyz : here;
  vec3 after = look.z > 0.5 ? point(i + 1).xyz : here;
  float perPixel = pixel * max(-(view * vec4(here, 1.0)).z, 1e-3);
  thickness = max(look.x, 0.5 * least * perPixel);
  float away = awayFromAll(here);
  on = lifted(here, thickness);
  along = after - before;
  along = length(along) > 0.0 ? normalize(along) : right;
  float wide = away < 4.0 * thickness && point(i).w < 1e30 ? 3.2 * thickness : 0.0;
  vec3 side = sideways(before, here, after, normalize(eye - here));
  float across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  gl_Position = projection * view * vec4(on + side * across * wide, 1.0);
}
`;

export const CONTACT_FRAGMENT = /* glsl */ `${COMMON}
uniform highp sampler2D backdrop;
uniform highp usampler2D info;
uniform vec2 size;
uniform vec3 top;
uniform vec3 ahead;
uniform float ink;
uniform int coarse;
in vec3 on;
in vec3 along;
in float thickness;
out vec4 colour;
void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) / coarse;
  uvec4 known = texelFetch(info, texel, 0);
  if (known.z == 0u) discard;
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 place = eye + (ahead + (right * at.x + top * at.y) * pixel) * uintBitsToFloat(known.x);
  vec3 way = place - on + 0.5 * thickness * key; // the shadow falls away from the light
  way -= along * dot(way, along);
  float far = length(way) / max(thickness, 1e-9);
  float dark = 0.85 * ink * (1.0 - smoothstep(0.7, 2.7, far));
  if (dark < 0.004) discard;
  colour = vec4(texelFetch(backdrop, texel, 0).rgb * (1.0 - dark), 1.0);
}
`;

/** Puts sky, floor and bodies behind everything, with the depth of bodies, and the marks of those that turn. */
export const SOLID_COPY = /* glsl */ `
precision highp float;
uniform highp sampler2D backdrop;
uniform highp usampler2D info;
uniform highp sampler2D turns; // of each body [rad], and whether it ever turns
uniform vec2 depths;   // of the projection
uniform int coarse;    // pixels each way for one of the backdrop's
out vec4 colour;
const float MARKS = 6.0;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) / coarse;
  colour = texelFetch(backdrop, at, 0);
  uvec4 known = texelFetch(info, at, 0);
  if (known.z == 0u) { gl_FragDepth = 1.0; return; }
  float depth = uintBitsToFloat(known.x);
  gl_FragDepth = 0.5 + 0.5 * (depths.y / depth - depths.x);
  vec4 turn = texelFetch(turns, ivec2(int(known.z) - 1, 0), 0);
  if (turn.y < 0.5) return;
  float part = (uintBitsToFloat(known.y) - turn.x) / 6.2831853;
  float sector = fract(part * MARKS), first = floor(mod(part * MARKS + 0.5, MARKS));
  float away = (0.5 - abs(sector - 0.5)) * 6.2831853 / MARKS; // from the nearest mark [rad]
  float fine = uintBitsToFloat(known.w); // of the angle, that one pixel takes
  float wide = first < 0.5 ? min(0.16, 2.6 * fine) : min(0.05, 1.1 * fine); // lines, narrower near the axis
  float cover = clamp((wide - away) / max(fine, 1e-4) + 0.5, 0.0, 1.0) * smoothstep(1.2, 0.3, fine);
  colour.rgb *= 1.0 - 0.42 * cover;
}
`;
