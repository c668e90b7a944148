// The bodies that ropes touch, kept in two textures until the camera moves: their colours over sky and floor, and
// how deep they are.

import * as THREE from "three";

import { KINDS, bevelOf, cornersOf, slides } from "../../view/solids.js";
import { times, plus, dot } from "../../view/vector.js";
import { flatMaterial, material } from "./material.js";
import { surfaceMeshes } from "./surface_meshes.js";
import { SOLID_COLOUR, SOLID_INFO, SOLID_SHADOW, SOLID_VERTEX } from "./solid_shaders.js";

/** @typedef {import("../../view/solids.js").Solid} Solid */
/** @typedef {import("../../view/camera.js").Camera} Camera */
/** @typedef {import("../../view/vector.js").Vector} Vector */
/** @typedef {import("../view.js").Theme} Theme */
/** @typedef {import("../view.js").Ground} Ground */

const NEAR_ROPES = 64; // bodies that ropes are lifted off, at most
const FULL = [-1, -1, 1, 1];
const SHADOW_ROOM = 1.35; // of a body's reach: its shadow is soft

export class Solids {
  /** @param {Record<string, THREE.IUniform>} shared @param {Record<string, THREE.IUniform>} picture uniforms of the
   * backdrop: size, top, ahead, grid, spacing */
  constructor(shared, picture) {
    this.shared = shared;
    this.picture = picture;
    /** @type {Solid[]} */ this.all = [];
    this.paint = { value: new THREE.Vector3() };
    this.ink = { value: 0.5 };
    this.height = { value: 0 };
    this.middle = { value: new THREE.Vector3() };
    this.radius = { value: 1 };
    this.near = { value: dataTexture(new Float32Array(16), 4, 1) };
    this.count = { value: 0 };
    this.turns = { value: dataTexture(new Float32Array(4), 1, 1) };
    this.target = new THREE.WebGLRenderTarget(1, 1, {
      format: THREE.RGBAIntegerFormat,
      type: THREE.UnsignedIntType,
      internalFormat: "RGBA32UI",
      minFilter: THREE.NearestFilter,
      magFilter: THREE.NearestFilter,
    });
    this.info = { value: this.target.texture };
    this.colours = new THREE.Scene();
    this.depths = new THREE.Scene();
    /** @type {{solid: Solid, boxes: [THREE.IUniform, THREE.IUniform], meshes: THREE.Mesh[]}[]} */
    this.drawn = [];
    for (const scene of [this.colours, this.depths]) scene.matrixWorldAutoUpdate = false;
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.paint.value.set(...theme.body);
    this.ink.value = theme.dark ? 0.62 : 0.36;
  }

  /** @param {number} width @param {number} height device pixels */
  resize(width, height) {
    this.target.setSize(width, height);
  }

  /** Take other bodies; tells whether there are others. @param {Solid[]} all */
  take(all) {
    if (all === this.all) return false;
    this.all = all;
    for (const { meshes } of this.drawn) {
      for (const mesh of meshes) {
        mesh.removeFromParent();
        mesh.geometry.dispose();
        /** @type {THREE.Material} */ (mesh.material).dispose();
      }
    }
    this.drawn = all.map((solid, number) => this.make(solid, number));
    const near = all.filter(({ kind }) => kind !== "mesh").slice(0, NEAR_ROPES);
    const values = new Float32Array(16 * Math.max(1, near.length));
    near.forEach((solid, k) => {
      values.set([...solid.center, solid.number, ...solid.axis, bevelOf(solid)], 16 * k);
      values.set([...solid.size.map(finite), ...solid.zero], 16 * k + 8);
    });
    this.near.value.dispose();
    this.near.value = dataTexture(values, 4, Math.max(1, near.length));
    this.count.value = near.length;
    this.turns.value.dispose();
    const turns = new Float32Array(4 * Math.max(1, all.length));
    this.turns.value = dataTexture(turns, Math.max(1, all.length), 1);
    return true;
  }

  /** @param {Solid} solid @param {number} number */
  make(solid, number) {
    const uniforms = {
      ...this.shared,
      ...this.picture,
      kind: { value: KINDS.indexOf(solid.kind) },
      centre: { value: new THREE.Vector3(...solid.center) },
      axis: { value: new THREE.Vector3(...solid.axis) },
      zero: { value: new THREE.Vector3(...solid.zero) },
      sizes: { value: new THREE.Vector4(...solid.size.map(finite)) },
      bevel: { value: bevelOf(solid) },
      reach: { value: finite(solid.reach) },
      number: { value: number },
      paint: this.paint,
      ink: this.ink,
      height: this.height,
      middle: this.middle,
      radius: this.radius,
    };
    const boxes = /** @type {[THREE.IUniform, THREE.IUniform]} */ (
      [0, 1].map(() => ({ value: new THREE.Vector4(...FULL) }))
    );
    const meshes = solid.surface
      ? surfaceMeshes(solid.surface, uniforms)
      : bodyMeshes(uniforms, boxes, this.info);
    this.colours.add(meshes[0], meshes[2]);
    this.depths.add(meshes[1]);
    return { solid, boxes, meshes };
  }

  /** Turn those that turn. @param {number[]} turns [rad] */
  turn(turns) {
    const data = /** @type {Float32Array} */ (this.turns.value.image.data);
    this.all.forEach((solid, k) => {
      data[4 * k] = turns[k] % (2 * Math.PI);
      data[4 * k + 1] = slides(solid) ? 1 : 0;
    });
    this.turns.value.needsUpdate = true;
  }

  /** Draw them: colours into a target that has sky and floor already, depths into their own.
   * @param {THREE.WebGLRenderer} three @param {THREE.Camera} any @param {THREE.WebGLRenderTarget} sheet
   * @param {Camera} camera @param {Ground} ground @param {{center: ArrayLike<number>, radius: number}} room */
  draw(three, any, sheet, camera, ground, room) {
    const above = camera.eyeHeight(ground.height) > 0;
    this.height.value = ground.height;
    this.middle.value.set(room.center[0], room.center[1], room.center[2]);
    this.radius.value = room.radius;
    this.drawn.forEach(({ solid, boxes, meshes }) => {
      const corners = cornersOf(solid);
      const whole = Number.isFinite(solid.reach);
      boxes[0].value.set(...(whole ? boxOf(camera, corners) : FULL));
      const fallen = whole ? shadowOf(solid, camera, ground.height) : null;
      boxes[1].value.set(...(fallen ? boxOf(camera, fallen) : FULL));
      meshes[2].visible = above && whole;
      const away = dot(solid.center, camera.toward);
      meshes[0].renderOrder = 1 + Math.atan(away / room.radius); // the nearer, the later
      meshes[2].renderOrder = -1;
    });
    const auto = three.autoClear;
    three.autoClear = false;
    three.setRenderTarget(this.target);
    three.clear();
    three.render(this.depths, any);
    three.setRenderTarget(sheet);
    three.clearDepth();
    three.render(this.colours, any);
    three.setRenderTarget(null);
    three.autoClear = auto;
  }

  dispose() {
    this.target.dispose();
    this.near.value.dispose();
    this.turns.value.dispose();
  }
}

/** @param {number} value */
const finite = (value) => Math.min(value, 1e15); // squared it is still a number

/** The part of the screen that some places take, -1 to 1; all of it where one is behind the eye.
 * @param {Camera} camera @param {Vector[]} places */
function boxOf(camera, places) {
  const box = [1, 1, -1, -1];
  for (const place of places) {
    const [x, y, depth] = camera.project(...place);
    if (depth < 0.02 * camera.pose.distance) return FULL;
    const [u, v] = [(2 * x) / camera.width - 1, 1 - (2 * y) / camera.height];
    box[0] = Math.min(box[0], u);
    box[1] = Math.min(box[1], v);
    box[2] = Math.max(box[2], u);
    box[3] = Math.max(box[3], v);
  }
  const [dx, dy] = [3 / camera.width, 3 / camera.height]; // room for smooth edges
  return [
    Math.max(-1, box[0] - dx),
    Math.max(-1, box[1] - dy),
    Math.min(1, box[2] + dx),
    Math.min(1, box[3] + dy),
  ];
}

/** Places on the floor around a body's shadow. @param {Solid} solid @param {Camera} camera @param {number} height
 * @returns {Vector[]} */
function shadowOf(solid, camera, height) {
  const { up, light, first, second } = camera;
  const level = plus(light, up, -dot(light, up));
  const slant = times(level, 0.75 / dot(light, up));
  const lift = dot(solid.center, up) - height;
  const most = SHADOW_ROOM * solid.reach;
  return [Math.max(0, lift - most), Math.max(0, lift + most)].flatMap((above) => {
    const foot = plus(plus(solid.center, up, -lift), slant, -above);
    const wide = most + 0.3 * above;
    return [-1, 1].flatMap((a) =>
      [-1, 1].map((b) => plus(plus(foot, first, a * wide), second, b * wide)),
    );
  });
}

/** Colour, depth and shadow of a body that pixels' rays are followed to.
 * @param {Record<string, THREE.IUniform>} uniforms
 * @param {[THREE.IUniform, THREE.IUniform]} boxes of the screen @param {THREE.IUniform} info */
function bodyMeshes(uniforms, [box, fallen], info) {
  const colour = material(SOLID_VERTEX, SOLID_COLOUR, { ...uniforms, box, info }, true);
  const depth = flatMaterial(SOLID_VERTEX, SOLID_INFO, { ...uniforms, box });
  depth.depthTest = depth.depthWrite = true;
  const shadow = material(SOLID_VERTEX, SOLID_SHADOW, { ...uniforms, box: fallen }, false);
  return [colour, depth, shadow].map((made) => quad(made));
}

/** @param {THREE.Material} made */
function quad(made) {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex([0, 1, 2, 1, 3, 2]);
  const mesh = new THREE.Mesh(geometry, made);
  mesh.frustumCulled = false;
  return mesh;
}

/** @param {Float32Array} values @param {number} width @param {number} height */
function dataTexture(values, width, height) {
  const made = new THREE.DataTexture(values, width, height, THREE.RGBAFormat, THREE.FloatType);
  made.internalFormat = "RGBA32F";
  made.needsUpdate = true;
  return made;
}
