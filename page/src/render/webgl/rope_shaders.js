// The shaders of ropes and of their shadows. A rope is a ribbon that faces the eye; the surface of its three laid
// strands is worked out for each pixel.

import { COMMON, RIBBON } from "./shaders.js";
import * as SOLID from "./solid_shaders.js";

const POINTS = /* glsl */ `
uniform highp sampler2D points;
uniform int columns;
uniform float least;   // least width in CSS pixels
in vec4 look;          // radius [m], has a point before, after, length of rope to a free end [m]
vec4 point(int i) { return texelFetch(points, ivec2(i % columns, i / columns), 0); }
`;

const BODIES = /* glsl */ `
#ifdef SOLIDS
${SOLID.SOLIDS}
#endif
`;

export const ROPE_VERTEX = /* glsl */ `${COMMON}${RIBBON}${POINTS}${BODIES}
uniform highp sampler2D normals; // of the rope, and the length of rope up to here [m]
uniform float laid;    // 1: there are strands
uniform float thick;   // the least radius as drawn in the scene's middle [m]
in vec3 tint;
out float across;
out float halfWidth;   // CSS pixels
out float value;
out float phase;       // turns of the strands
out vec2 turn;         // the rope's normal, as seen: to the side and towards the eye
out float slope;       // of the rope towards the eye
out float toEnd;       // radii to a free end
out vec3 side;
out vec3 toward;
out vec3 ropeTint;
out float behind;
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 here = point(i);
  vec3 before = look.y > 0.5 ? point(i - 1).xyz : here.xyz;
  vec3 after = look.z > 0.5 ? point(i + 1).xyz : here.xyz;
  vec3 sight = normalize(eye - here.xyz);
  vec3 out_ = sideways(before, here.xyz, after, sight);
  float depth = -(view * vec4(here.xyz, 1.0)).z;
  behind = depth > 0.0 ? 0.0 : 1.0;
  float perPixel = pixel * max(depth, 1e-3);
  halfWidth = max(look.x / perPixel, 0.5 * least);
  value = here.w;
  ropeTint = tint;
  vec3 along = after - before;
  along = length(along) > 0.0 ? normalize(along) : right;
  float size = length(out_);
  side = size > 0.0 ? out_ / size : right;
  toward = normalize(cross(side, along));
  vec4 material = laid < 0.5 ? vec4(up, 0.0) : texelFetch(normals, ivec2(i % columns, i / columns), 0);
  turn = vec2(dot(material.xyz, side), dot(material.xyz, toward));
  float radius = max(look.x, 1e-9); // where ropes are drawn thicker than they are, their lay is longer
  float lay = 7.0 * radius * exp2(floor(log2(max(thick / radius, 1.0)) + 0.9));
  phase = material.w / lay;
  float cot = dot(along, sight) / max(length(cross(along, sight)), 1e-3);
  slope = cot / sqrt(1.0 + 0.6 * cot * cot);
  toEnd = look.w / (halfWidth * perPixel);
  vec3 middle = here.xyz;
#ifdef SOLIDS
  middle = lifted(middle, halfWidth * perPixel);
#endif
  vec3 place = middle + out_ * across * (halfWidth + 1.0) * perPixel;
  gl_Position = projection * view * vec4(place, 1.0);
}
`;

export const ROPE_FRAGMENT = /* glsl */ `${COMMON}
uniform sampler2D map;
uniform vec2 range;    // values of the map's two ends
uniform bool plain;
uniform float rim;     // what is left of the light at the rope's edge: 1 where the floor is dark
uniform float laid;    // 1: draw strands
in float across;
in float halfWidth;
in float value;
in float phase;
in vec2 turn;
in float slope;
in float toEnd;
in vec3 side;
in vec3 toward;
in vec3 ropeTint;
in float behind;       // > 0: a part of a segment that ends behind the eye
out vec4 colour;
const float CENTRE = 0.5359, STRAND = 0.4641; // of three strands in a rope of radius 1
void main() {
  if (behind > 0.0 || value > 1e30) discard;
  float w = across * (halfWidth + 1.0);
  float u = clamp(w / halfWidth, -1.0, 1.0);
  vec3 n = vec3(u, sqrt(1.0 - u * u), 0.0); // to the side, towards the eye, along
  float edge = 1.0, shade = 1.0;
  float strands = laid * smoothstep(1.6, 3.2, halfWidth);
  bool whipped = toEnd < 4.2;
  if (strands > 0.0 && !whipped) {
    float angle = 6.2831853 * (phase + slope * n.y * 0.1214);
    float c = cos(angle), s = sin(angle);
    vec2 t = normalize(turn + 1e-6);
    vec2 centre = CENTRE * vec2(t.x * c + t.y * s, t.y * c - t.x * s);
    float best = -2.0, outer = -1.0;
    vec2 hit = centre;
    for (int k = 0; k < 3; k++) {
      float off = u - centre.x;
      float q = STRAND * STRAND - off * off;
      float z = centre.y + sqrt(max(q, 0.0));
      if (q > 0.0 && z > best) { best = z; hit = centre; }
      outer = max(outer, sign(u) * centre.x + STRAND);
      centre = vec2(-0.5 * centre.x - 0.8660254 * centre.y, 0.8660254 * centre.x - 0.5 * centre.y);
    }
    vec2 o = vec2(u - hit.x, max(best, hit.y) - hit.y) / STRAND;
    vec3 lie = vec3(0.8976 * hit.y, -0.8976 * hit.x, 1.0); // the direction of the strand
    vec3 m = vec3(o, 0.0);
    m = normalize(m - lie * (dot(m, lie) / dot(lie, lie)));
    float groove = smoothstep(0.46, 0.93, length(vec2(u, best)));
    n = normalize(mix(n, m, strands));
    edge = mix(1.0, outer, strands);
    shade = mix(1.0, 0.42 + 0.58 * groove, strands * mix(0.7, 1.0, smoothstep(4.0, 10.0, halfWidth)));
  }
  float cover = clamp(edge * halfWidth + 0.5 - abs(w), 0.0, 1.0);
  if (cover <= 0.0) discard;
  float part = (value - range.x) / max(range.y - range.x, 1e-30);
  vec3 base = plain ? ropeTint : texture(map, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
  if (whipped) {
    base = vec3(0.86, 0.82, 0.74); // whipped with twine
    shade = 0.8 + 0.2 * cos(toEnd * 9.0);
  }
  vec3 normal = normalize(side) * n.x + normalize(toward) * n.y + cross(toward, side) * n.z;
  float wrapped = max(dot(normal, key) + 0.25, 0.0) / 1.25;
  float front = max(n.y, 0.0);
  float light = (0.36 + 0.2 * dot(normal, up) + 0.62 * wrapped * wrapped + 0.3 * front) * shade;
  vec3 half_ = normalize(key + normalize(toward));
  float sheen = 0.1 * pow(max(dot(normal, half_), 0.0), 22.0);
  float band = 1.0 - smoothstep(0.7, 2.0, edge * halfWidth - abs(w));
  float bright = dot(base * base, vec3(0.2126, 0.7152, 0.0722)); // what is dark needs no rim
  band *= smoothstep(0.08, 0.2, bright);
  vec3 lit = base * base * light * mix(1.0, rim, band) + sheen * shade;
  colour = vec4(sqrt(lit), cover);
}
`;

// The shadow: the ribbon laid along the light onto the ground, as wide as the rope and its penumbra. It is
// drawn by the least of what is there, so that pieces that overlap do not darken twice.
export const SHADOW_VERTEX = /* glsl */ `${COMMON}${RIBBON}${POINTS}
uniform float height;  // of the ground along up [m]
out float across;
out float strength;
out float sharp;
vec3 fallen(int i) {
  vec3 p = point(i).xyz;
  float above = dot(p, up) - height;
  vec3 level = key - up * dot(key, up);
  return p - above * (up + 0.75 * level / dot(key, up));
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 here = fallen(i);
  vec3 before = look.y > 0.5 ? fallen(i - 1) : here;
  vec3 after = look.z > 0.5 ? fallen(i + 1) : here;
  vec3 side = sideways(before, here, after, up);
  float above = dot(point(i).xyz, up) - height;
  float perPixel = pixel * max(-(view * vec4(here, 1.0)).z, 1e-3);
  float radius = max(look.x, 0.5 * least * perPixel);
  float blur = 0.11 * max(above, 0.0);
  float wide = sqrt(radius * radius + blur * blur);
  strength = above < -radius ? 0.0 : radius / (radius + 0.38 * blur);
  if (point(i).w > 1e30) strength = 0.0;
  strength *= min(look.y, look.z); // it fades out at the ends
  sharp = radius / wide;
  gl_Position = projection * view * vec4(here + side * across * 1.7 * wide, 1.0);
}
`;

export const SHADOW_FRAGMENT = /* glsl */ `
precision highp float;
uniform highp sampler2D backdrop;
#ifdef SOLIDS
uniform highp usampler2D info;
#endif
uniform float ink;
uniform int coarse;    // pixels each way for one of the backdrop's
in float across;
in float strength;
in float sharp;
out vec4 colour;
void main() {
#ifdef SOLIDS
  if (texelFetch(info, ivec2(gl_FragCoord.xy) / coarse, 0).z != 0u) discard; // a body is before the floor
#endif
  float soft = exp(-3.0 * across * across) - 0.05;
  float hard = 1.0 - smoothstep(0.45, 0.8, abs(across));
  float dark = ink * strength * max(mix(soft, hard, sharp * sharp), 0.0);
  colour = vec4(texelFetch(backdrop, ivec2(gl_FragCoord.xy) / coarse, 0).rgb * (1.0 - dark), 1.0);
}
`;

export const CONTACT_VERTEX = /* glsl */ `${COMMON}${RIBBON}${POINTS}${SOLID.SOLIDS}${SOLID.CONTACT_VERTEX}`;
