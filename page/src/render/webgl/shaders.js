// The shaders. All read the same uniforms; positions come from a texture of x, y, z, value.

export const COMMON = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;
uniform vec3 up;
uniform vec3 right;
uniform float pixel;   // metres per CSS pixel at a depth of one metre
uniform float ratio;   // device pixels per CSS pixel
uniform vec3 key;      // direction to the light
`;

export const RIBBON = /* glsl */ `
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
in vec4 ink;           // colour, kind: 0 ball, 1 eye bolt, 2 ring, 3 knot
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
    float tube = 0.3 * radius;
    float x = (length(at) - 0.7 * radius) / tube;
    float z = sqrt(max(0.0, 1.0 - x * x));
    vec3 n = vec3(at / max(length(at), 1e-3) * clamp(x, -1.0, 1.0), z);
    float light = 0.42 + 0.62 * max(dot(n, normalize(vec3(-0.35, 0.8, 0.6))), 0.0);
    float glint = pow(max(dot(n, normalize(vec3(-0.2, 0.6, 0.9))), 0.0), 24.0);
    colour = vec4(colourOf.rgb * light + 0.25 * glint, clamp(tube * (1.0 - abs(x)) + 0.5, 0.0, 1.0));
  } else {
    float cover = clamp(radius + 0.5 - length(at), 0.0, 1.0);
    vec2 n = at / radius;
    float z = sqrt(max(0.0, 1.0 - dot(n, n)));
    float light = 0.62 + 0.42 * max(dot(vec3(n, z), normalize(vec3(0.35, 0.8, 0.7))), 0.0);
    float glint = pow(max(dot(vec3(n, z), normalize(vec3(0.2, 0.5, 0.9))), 0.0), 30.0);
    if (kind == 3) { // turns of a rope, over each other
      bool over = abs(n.x - n.y) < 0.5;
      float turns = (over ? n.x + n.y : n.x - n.y) * 2.6;
      light *= 0.62 + 0.45 * abs(cos(turns * 1.57)) * (over ? 1.0 : 0.82);
      glint = 0.0;
    }
    colour = vec4(colourOf.rgb * light + 0.18 * glint, cover);
  }
  if (colour.a <= 0.0) discard;
}
`;

export const DOT_VERTEX = /* glsl */ `${COMMON}
uniform highp sampler2D points;
uniform int columns;
uniform float dot_;    // CSS pixels
void main() {
  vec4 here = texelFetch(points, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0);
  vec4 seen = view * vec4(here.xyz, 1.0);
  seen.z += 0.02 * -seen.z;
  gl_Position = projection * seen;
  gl_PointSize = here.w > 1e30 ? 0.0 : dot_ * ratio;
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
uniform float round_;  // 1: shaded as a round bar
out vec4 colour;
void main() {
  float u = clamp(away / max(halfWidth, 1.0), -1.0, 1.0);
  float light = mix(1.0, 0.55 + 0.5 * sqrt(max(0.0, 1.0 - (u + 0.35) * (u + 0.35) / 1.9)), round_);
  colour = vec4(colourOf * light, clamp(halfWidth + 0.5 - abs(away), 0.0, 1.0));
}
`;
