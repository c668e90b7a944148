// The shaders. All read the same uniforms; positions come from a texture of x, y, z, value.

const COMMON = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;
uniform vec3 up;
uniform vec3 right;
uniform float pixel;   // metres per CSS pixel at a depth of one metre
uniform float ratio;   // device pixels per CSS pixel
`;

const RIBBON = /* glsl */ `
// The direction to the side of a line through a node, at a right angle to "sight" (length 1),
// drawn out at a bend so that the ribbon keeps its width; sharp folds are cut off.
vec3 sideways(vec3 before, vec3 here, vec3 after, vec3 sight) {
  vec3 a = cross(here - before, sight);
  vec3 b = cross(after - here, sight);
  float la = length(a), lb = length(b);
  a = la > 0.0 ? a / la : vec3(0.0);
  b = lb > 0.0 ? b / lb : a;
  if (la == 0.0) a = b;
  vec3 sum = a + b;
  float size = length(sum);
  if (size < 0.7) return b;
  sum /= size;
  return sum / max(0.6, dot(sum, b));
}
`;

export const ROPE_VERTEX = /* glsl */ `${COMMON}${RIBBON}
uniform highp sampler2D nodes;
uniform int columns;
uniform float least;   // least width in CSS pixels
in vec4 look;          // radius [m], distance along the rope [m], has a node before, after
in vec3 tint;
out float across;
out float halfWidth;   // CSS pixels
out float value;
out float along;
out vec3 side;
out vec3 sight;
out vec3 ropeTint;
out float behind;
vec4 node(int i) { return texelFetch(nodes, ivec2(i % columns, i / columns), 0); }
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 here = node(i);
  vec3 before = look.z > 0.5 ? node(i - 1).xyz : here.xyz;
  vec3 after = look.w > 0.5 ? node(i + 1).xyz : here.xyz;
  sight = normalize(eye - here.xyz);
  side = sideways(before, here.xyz, after, sight);
  float depth = -(view * vec4(here.xyz, 1.0)).z;
  behind = depth > 0.0 ? 0.0 : 1.0;
  float perPixel = pixel * max(depth, 1e-3);
  halfWidth = max(look.x / perPixel, 0.5 * least);
  value = here.w;
  along = look.y / max(look.x, 1e-9);
  ropeTint = tint;
  vec3 place = here.xyz + side * across * (halfWidth + 1.0) * perPixel;
  gl_Position = projection * view * vec4(place, 1.0);
}
`;

export const ROPE_FRAGMENT = /* glsl */ `${COMMON}
uniform sampler2D map;
uniform vec2 range;    // values of the map's two ends
uniform bool plain;
uniform float night;   // 1 in the dark theme
in float across;
in float halfWidth;
in float value;
in float along;
in vec3 side;
in vec3 sight;
in vec3 ropeTint;
in float behind;       // > 0: a part of a segment that ends behind the eye
out vec4 colour;
void main() {
  if (behind > 0.0) discard;
  float w = across * (halfWidth + 1.0);
  float cover = clamp(halfWidth + 0.5 - abs(w), 0.0, 1.0);
  if (cover <= 0.0) discard;
  float u = clamp(w / halfWidth, -1.0, 1.0);
  float z = sqrt(1.0 - u * u);
  vec3 normal = normalize(side) * u + normalize(sight) * z;
  float part = (value - range.x) / max(range.y - range.x, 1e-30);
  vec3 base = plain ? ropeTint : texture(map, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
  // Strands, seen when the rope is wide enough: ridges that wind around it.
  float lay = sin(along * 1.7 + asin(u) * 2.0);
  float near = smoothstep(5.0, 12.0, halfWidth);
  base *= 1.0 - 0.22 * near * smoothstep(0.35, 1.0, lay);
  vec3 key = normalize(up * 0.85 + normalize(sight) * 0.75 + right * 0.35);
  float light = 0.62 + 0.4 * max(dot(normal, key), 0.0) + 0.08 * dot(normal, up);
  float glint = pow(max(dot(reflect(-key, normal), normalize(sight)), 0.0), 24.0);
  float rim = mix(0.8, 1.0, smoothstep(0.0, 0.55, z));
  vec3 lit = base * light * rim * mix(1.0, 1.06, night) + 0.14 * glint;
  colour = vec4(lit, cover);
}
`;

export const SHADOW_VERTEX = /* glsl */ `${COMMON}${RIBBON}
uniform highp sampler2D nodes;
uniform int columns;
uniform float least;
uniform float height;  // of the ground along up [m]
in vec4 look;
out float across;
out float halfWidth;
out float far;
vec3 flat_(int i) {
  vec3 p = texelFetch(nodes, ivec2(i % columns, i / columns), 0).xyz;
  return p - up * (dot(p, up) - height);
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 here = flat_(i);
  vec3 before = look.z > 0.5 ? flat_(i - 1) : here;
  vec3 after = look.w > 0.5 ? flat_(i + 1) : here;
  vec3 side = sideways(before, here, after, up);
  float perPixel = pixel * -(view * vec4(here, 1.0)).z;
  halfWidth = max(look.x / perPixel, 0.6 * least) + 1.0;
  gl_Position = projection * view * vec4(here + side * across * halfWidth * perPixel, 1.0);
}
`;

export const SHADOW_FRAGMENT = /* glsl */ `${COMMON}
uniform vec4 ink;
in float across;
in float halfWidth;
out vec4 colour;
void main() {
  float edge = 1.0 - smoothstep(0.25, 1.0, abs(across));
  colour = vec4(ink.rgb, ink.a * edge);
}
`;

export const TRAIL_VERTEX = /* glsl */ `${COMMON}${RIBBON}
uniform highp sampler2D points;
uniform int columns;
uniform int head;
in vec3 tint;
out float across;
out float age;
out vec3 colourOf;
vec3 point(int row, int step) {
  return texelFetch(points, ivec2((head + clamp(step, 0, columns - 1)) % columns, row), 0).xyz;
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  int row = i / columns, step = i % columns;
  vec3 here = point(row, step);
  vec3 side = sideways(point(row, step - 1), here, point(row, step + 1), normalize(eye - here));
  float perPixel = pixel * -(view * vec4(here, 1.0)).z;
  age = 1.0 - float(step) / float(columns - 1);
  colourOf = tint;
  gl_Position = projection * view * vec4(here + side * across * 2.0 * perPixel, 1.0);
}
`;

export const TRAIL_FRAGMENT = /* glsl */ `
precision highp float;
in float across;
in float age;
in vec3 colourOf;
out vec4 colour;
void main() {
  float cover = clamp(1.8 - 2.0 * abs(across), 0.0, 1.0);
  colour = vec4(colourOf, 0.75 * cover * (1.0 - age) * (1.0 - age));
}
`;

export const MARKER_VERTEX = /* glsl */ `${COMMON}
in vec3 position;
in vec4 ink;           // colour, kind: 0 ball, 1 plate, 2 ring
in vec2 sizes;         // diameter [m], least diameter in CSS pixels
out vec4 colourOf;
out float diameter;    // CSS pixels
void main() {
  vec4 seen = view * vec4(position, 1.0);
  diameter = max(sizes.x / (pixel * -seen.z), sizes.y);
  colourOf = ink;
  gl_Position = projection * seen;
  seen.z *= 1.0 - min(0.5, pixel * diameter);  // before the rope that ends in it
  vec4 nearer = projection * seen;
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  gl_PointSize = (diameter + 2.0) * ratio;
}
`;

export const MARKER_FRAGMENT = /* glsl */ `${COMMON}
in vec4 colourOf;
in float diameter;
out vec4 colour;
void main() {
  float radius = 0.5 * diameter;
  vec2 at = (gl_PointCoord * 2.0 - 1.0) * vec2(1.0, -1.0) * (radius + 1.0);
  int kind = int(colourOf.w + 0.5);
  if (kind == 2) {
    float band = abs(length(at) - radius + 1.2) - 1.2;
    colour = vec4(colourOf.rgb, clamp(0.5 - band, 0.0, 1.0));
  } else if (kind == 1) {
    vec2 corner = abs(at) - vec2(radius * 0.62);
    float away = length(max(corner, 0.0)) + min(max(corner.x, corner.y), 0.0) - radius * 0.22;
    float cover = clamp(0.5 - away, 0.0, 1.0);
    float line = smoothstep(-2.6, -1.4, away);
    colour = vec4(mix(colourOf.rgb * (1.04 + 0.1 * at.y / radius), colourOf.rgb * 0.72, line), cover);
  } else {
    float cover = clamp(radius + 0.5 - length(at), 0.0, 1.0);
    vec2 n = at / radius;
    float z = sqrt(max(0.0, 1.0 - dot(n, n)));
    float light = 0.62 + 0.42 * max(dot(vec3(n, z), normalize(vec3(0.35, 0.8, 0.7))), 0.0);
    float glint = pow(max(dot(vec3(n, z), normalize(vec3(0.2, 0.5, 0.9))), 0.0), 30.0);
    colour = vec4(colourOf.rgb * light + 0.18 * glint, cover);
  }
  if (colour.a <= 0.0) discard;
}
`;

export const DOT_VERTEX = /* glsl */ `${COMMON}
uniform highp sampler2D nodes;
uniform int columns;
uniform float dot_;    // CSS pixels
void main() {
  vec3 here = texelFetch(nodes, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).xyz;
  vec4 seen = view * vec4(here, 1.0);
  seen.z += 0.02 * -seen.z;
  gl_Position = projection * seen;
  gl_PointSize = dot_ * ratio;
}
`;

export const DOT_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 ink;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord * 2.0 - 1.0);
  float cover = 1.0 - smoothstep(0.7, 1.0, away);
  if (cover <= 0.0) discard;
  colour = vec4(ink, cover);
}
`;

export const GRID_VERTEX = /* glsl */ `${COMMON}
uniform vec3 center;   // on the ground, on a crossing of lines
uniform vec3 first;
uniform vec3 second;
uniform float spacing;
uniform int half_;     // lines on each side of the middle
in vec3 position;      // line, end, side
out vec2 place;        // in the plane, 1 at the rim
out float across;
void main() {
  bool turned = position.x > float(2 * half_) + 0.5;
  float line = position.x - (turned ? float(2 * half_ + 1) : 0.0) - float(half_);
  vec3 along = turned ? second : first;
  vec3 over = turned ? first : second;
  vec3 here = center + (over * line + along * position.y * float(half_)) * spacing;
  place = vec2(line / float(half_), position.y);
  across = position.z;
  float depth = max(-(view * vec4(here, 1.0)).z, 0.02);
  vec3 flat_ = cross(along, normalize(eye - here));
  here += normalize(flat_ + 1e-9) * position.z * 1.1 * pixel * depth;
  gl_Position = projection * view * vec4(here, 1.0);
}
`;

export const GRID_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec4 ink;
in vec2 place;
in float across;
out vec4 colour;
void main() {
  float fade = 1.0 - smoothstep(0.25, 1.0, length(place));
  colour = vec4(ink.rgb, ink.a * fade * (1.0 - smoothstep(0.3, 1.0, abs(across))));
}
`;

export const FLOOR_VERTEX = /* glsl */ `${COMMON}
uniform vec3 center;
uniform vec3 first;
uniform vec3 second;
uniform float radius;
in vec3 position;
out vec2 place;
void main() {
  place = position.xy;
  vec3 here = center + (first * position.x + second * position.y) * radius;
  gl_Position = projection * view * vec4(here, 1.0);
}
`;

export const FLOOR_FRAGMENT = /* glsl */ `
precision highp float;
uniform vec4 ink;
in vec2 place;
out vec4 colour;
void main() {
  colour = vec4(ink.rgb, ink.a * (1.0 - smoothstep(0.2, 1.0, length(place))));
}
`;

export const ARROW_VERTEX = /* glsl */ `${COMMON}
in vec3 position;      // a place on the arrow's line
in vec3 line;          // the arrow's direction
in vec4 ink;           // colour, CSS pixels to the side
in float edge;         // half the arrow's width there [CSS pixels]
out vec3 colourOf;
out float away;
out float halfWidth;
void main() {
  vec3 side = cross(line, eye - position);
  float size = length(side);
  side = size > 0.0 ? side / size : right;
  float perPixel = pixel * -(view * vec4(position, 1.0)).z;
  colourOf = ink.rgb;
  away = ink.w;
  halfWidth = edge;
  gl_Position = projection * view * vec4(position + side * ink.w * perPixel, 1.0);
}
`;

export const ARROW_FRAGMENT = /* glsl */ `
precision highp float;
in vec3 colourOf;
in float away;
in float halfWidth;
out vec4 colour;
void main() {
  colour = vec4(colourOf, clamp(halfWidth + 0.5 - abs(away), 0.0, 1.0));
}
`;
