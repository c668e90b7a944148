// The shaders of bodies of triangles: their light is that of other bodies, see `solid_shaders`.

import { COMMON } from "./shaders.js";

const FRAME = /* glsl */ `
uniform vec3 centre;   // of the body
uniform vec3 axis;     // its third direction
uniform vec3 zero;     // its first
mat3 frame() { return mat3(zero, cross(axis, zero), axis); }
`;

export const SURFACE_VERTEX = /* glsl */ `${COMMON}
${FRAME}
in vec3 position;
in vec3 normal;
out vec3 place;
out vec3 outward;
void main() {
  place = centre + frame() * position;
  outward = frame() * normal;
  gl_Position = projection * view * vec4(place, 1.0);
}
`;

const SEEN = /* glsl */ `${COMMON}
in vec3 place;
in vec3 outward;
float depthOf() { return -(view * vec4(place, 1.0)).z; }
`;

export const SURFACE_COLOUR = /* glsl */ `${SEEN}
uniform vec3 paint;
uniform float height;  // of the floor along up [m]
uniform float reach;   // of the body [m]
uniform float radius;  // of the scene [m]
out vec4 colour;
void main() {
  vec3 way = normalize(place - eye), n = normalize(outward);
  float wrapped = max(dot(n, key) + 0.2, 0.0) / 1.2;
  float light = 0.5 + 0.22 * dot(n, up) + 0.6 * wrapped * wrapped + 0.12 * max(dot(n, -way), 0.0);
  float sheen = 0.07 * pow(max(dot(n, normalize(key - way)), 0.0), 26.0);
  float above = dot(place, up) - height; // near the floor there is less light
  light *= 1.0 - 0.4 * exp(-max(above, 0.0) / (0.25 * min(reach, radius))) * max(0.0, 0.6 - dot(n, up));
  colour = vec4(sqrt(paint * paint * max(light, 0.0) + sheen), 1.0);
}
`;

/** How deep a body is at each pixel, and which it is; no marks show how it turns. */
export const SURFACE_INFO = /* glsl */ `${SEEN}
uniform int number;
out highp uvec4 info;
void main() { info = uvec4(floatBitsToUint(depthOf()), 0u, uint(number + 1), 0u); }
`;

/** The shadow on the floor, of the triangles that face the light. */
export const SURFACE_SHADOW_VERTEX = /* glsl */ `${COMMON}
${FRAME}
uniform float height;
in vec3 position;
in vec3 normal;
out float lit;
void main() {
  vec3 level = key - up * dot(key, up);
  vec3 light = normalize(up + 0.75 * level / dot(key, up));
  vec3 place = centre + frame() * position;
  float above = max(dot(place, up) - height, 0.0);
  lit = dot(frame() * normal, light);
  gl_Position = projection * view * vec4(place - light * (above / dot(light, up)), 1.0);
}
`;

export const SURFACE_SHADOW = /* glsl */ `
precision highp float;
uniform float ink;
in float lit;
out vec4 colour;
void main() {
  if (lit <= 0.0) discard;
  colour = vec4(0.0, 0.0, 0.0, 0.6 * ink);
}
`;
