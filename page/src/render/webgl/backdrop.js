// Sky, floor and its grid in one pass over the picture, kept in a texture until the camera moves.

import * as THREE from "three";

import { poolOf } from "../../view/colours.js";
import { flatMaterial } from "./material.js";
import { COMMON } from "./shaders.js";
import { SOLID_COPY } from "./solid_shaders.js";
import { Solids } from "./solids.js";

/** @typedef {import("../view.js").Ground} Ground */
/** @typedef {import("../view.js").Theme} Theme */

const REST = 150; // ms without a move of the camera, after which all pixels are drawn

const VERTEX = /* glsl */ `
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
`;

const FRAGMENT = /* glsl */ `${COMMON}
uniform vec2 size;     // of the picture [CSS pixels]
uniform vec3 top;
uniform vec3 ahead;
uniform vec3 first;
uniform vec3 second;
uniform vec3 center;   // on the ground, on a crossing of lines
uniform float spacing; // of the lines [m]
uniform float reach;   // how far the floor is seen [m]
uniform float solid;   // 1: there is a ground to land on
uniform vec3 sky;
uniform vec3 horizon;
uniform vec3 ground;
uniform vec3 grid;
uniform float pool;    // how much lighter the middle is
out vec4 colour;
// How much of a pixel a line covers: "at" in lines, "wide" pixels; "step_" lines per pixel.
float line(float at, float step_, float wide) {
  float away = abs(fract(at - 0.5) - 0.5) / max(step_, 1e-6);
  float part = clamp(0.5 * wide + 0.5 - away, 0.0, 1.0);
  return mix(part, min(1.0, wide * step_), smoothstep(0.15, 0.5, step_));
}
void main() {
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 ray = ahead + (right * at.x + top * at.y) * pixel;
  float rise = dot(normalize(ray), up);
  vec3 highest = ahead + top * (0.5 * size.y * pixel);
  float most = max(dot(normalize(highest), up), 0.12);
  vec3 shown = mix(horizon, sky, smoothstep(0.0, 1.0, clamp(rise / most, 0.0, 1.0)));
  float above = dot(eye - center, up);
  float away = above / max(abs(dot(ray, up)), 1e-5) * (rise < 0.0 ? 1.0 : -1.0);
  if (away > 0.0) {
    vec3 place = eye + ray * away - center;
    vec2 q = vec2(dot(place, first), dot(place, second)) / spacing;
    float far = length(q) * spacing / reach;
    float fade = exp(-2.4 * far * far);
    // The size of a pixel on the floor: along the ray it is drawn out.
    float perPixel = pixel * away * length(ray);
    float drawn = perPixel / max(abs(rise), 1e-3);
    vec3 level = ray - up * dot(ray, up);
    vec2 flow = abs(vec2(dot(level, first), dot(level, second))) / max(length(level), 1e-6);
    vec2 step_ = (perPixel + (drawn - perPixel) * flow) / spacing;
    float fine = max(line(q.x, step_.x, 1.0), line(q.y, step_.y, 1.0));
    float coarse = max(line(q.x / 5.0, step_.x / 5.0, 1.5), line(q.y / 5.0, step_.y / 5.0, 1.5));
    float ink = max(0.5 * fine * exp(-5.0 * far * far), coarse) * fade;
    if (above > 0.0) {
      vec3 floor_ = ground + pool * exp(-9.0 * far * far);
      shown = mix(horizon, floor_, clamp(1.25 * fade, 0.0, 1.0));
      shown = mix(shown, grid, 0.9 * ink);
    } else shown = mix(shown, grid, 0.5 * ink);
  }
  // A little noise, so that no bands are seen.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(shown + (noise - 0.5) / 255.0, 1.0);
}
`;

const COPY = /* glsl */ `
precision highp float;
uniform highp sampler2D backdrop;
uniform int coarse;
out vec4 colour;
void main() { colour = texelFetch(backdrop, ivec2(gl_FragCoord.xy) / coarse, 0); }
`;

export class Backdrop {
  /** @param {Record<string, THREE.IUniform>} shared @param {boolean} soft whether the processor draws: then
   * with half the pixels each way while the camera moves */
  constructor(shared, soft) {
    this.shared = shared;
    this.soft = soft;
    this.full = [1, 1]; // device pixels
    this.moved = -Infinity; // when the camera did [ms]
    this.version = -1; // of the camera
    const ink = () => ({ value: new THREE.Vector3() });
    this.uniforms = {
      size: { value: new THREE.Vector2(1, 1) },
      top: ink(),
      ahead: ink(),
      first: ink(),
      second: ink(),
      center: ink(),
      spacing: { value: 1 },
      reach: { value: 1 },
      solid: { value: 0 },
      sky: ink(),
      horizon: ink(),
      ground: ink(),
      grid: ink(),
      pool: { value: 0 },
    };
    this.target = new THREE.WebGLRenderTarget(1, 1);
    this.target.texture.minFilter = this.target.texture.magFilter = THREE.NearestFilter;
    this.texture = { value: this.target.texture };
    this.scene = new THREE.Scene();
    this.scene.add(triangle(flatMaterial(VERTEX, FRAGMENT, { ...shared, ...this.uniforms })));
    /** Puts the texture behind everything. */
    this.mesh = triangle(
      flatMaterial(VERTEX, COPY, { backdrop: this.texture, coarse: shared.coarse }),
    );
    this.solids = new Solids(shared, this.uniforms);
    this.depths = { value: new THREE.Vector2() };
    const over = flatMaterial(VERTEX, SOLID_COPY, {
      backdrop: this.texture,
      info: this.solids.info,
      turns: this.solids.turns,
      depths: this.depths,
      coarse: shared.coarse,
    });
    over.depthTest = over.depthWrite = true;
    over.depthFunc = THREE.AlwaysDepth;
    /** The same, with bodies in it. */
    this.deep = triangle(over);
    this.mesh.renderOrder = this.deep.renderOrder = -5;
    this.key = "";
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    const { sky, horizon, ground, grid, pool } = this.uniforms;
    sky.value.set(...theme.background);
    horizon.value.set(...theme.horizon);
    ground.value.set(...theme.ground);
    grid.value.set(...theme.grid);
    pool.value = poolOf(theme.dark);
    this.solids.setTheme(theme);
    this.key = "";
  }

  /** @param {number} width @param {number} height device pixels */
  resize(width, height) {
    this.full = [width, height];
    this.fit();
  }

  /** Give the textures their size. */
  fit() {
    const [width, height] = this.full.map((one) => Math.ceil(one / this.shared.coarse.value));
    this.target.setSize(width, height);
    this.solids.resize(width, height);
    this.key = "";
  }

  /** Whether the camera rests, and there are still too few pixels. */
  get unfinished() {
    return this.shared.coarse.value > 1 && performance.now() - this.moved > REST;
  }

  /** Choose the number of pixels. @param {number} version of the camera */
  choose(version) {
    const moves = this.version >= 0 && version !== this.version;
    this.version = version;
    if (!this.soft) return;
    if (moves) this.moved = performance.now();
    const coarse = performance.now() - this.moved > REST ? 1 : 2;
    if (coarse === this.shared.coarse.value) return;
    this.shared.coarse.value = coarse;
    this.fit();
  }

  /** Paint anew what has changed. @param {THREE.WebGLRenderer} three @param {THREE.Camera} any
   * @param {import("../view.js").View} view */
  update(three, any, { ground, camera, solids, turns, room }) {
    this.choose(camera.version);
    if (this.solids.take(solids)) this.key = "";
    this.deep.visible = solids.length > 0;
    this.mesh.visible = !this.deep.visible;
    if (solids.length) this.solids.turn(turns);
    this.depths.value.set(camera.projection[10], camera.projection[14]);
    const key = [
      camera.version,
      ground.height,
      ground.spacing,
      ground.solid,
      ...ground.center,
    ].join();
    if (key === this.key) return;
    this.key = key;
    const { uniforms } = this;
    uniforms.size.value.set(camera.width, camera.height);
    uniforms.top.value.set(...camera.top);
    uniforms.ahead.value.set(-camera.toward[0], -camera.toward[1], -camera.toward[2]);
    uniforms.first.value.set(...camera.first);
    uniforms.second.value.set(...camera.second);
    uniforms.center.value.set(...ground.center);
    uniforms.spacing.value = ground.spacing;
    uniforms.reach.value = ground.radius;
    uniforms.solid.value = ground.solid ? 1 : 0;
    const { ratio, coarse } = this.shared;
    ratio.value /= coarse.value;
    three.setRenderTarget(this.target);
    three.render(this.scene, any);
    three.setRenderTarget(null);
    if (solids.length) this.solids.draw(three, any, this.target, camera, ground, room);
    ratio.value *= coarse.value;
  }

  dispose() {
    this.target.dispose();
    this.solids.dispose();
  }
}

/** One triangle that covers the picture. @param {THREE.Material} material */
function triangle(material) {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex([0, 1, 2]);
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}
