// The ropes of all copies: one index buffer, points from a texture, one draw call; their shadows likewise.

import * as THREE from "three";

import { SHADES, uniformMap } from "../../view/colours.js";
import { flatMaterial, material } from "./material.js";
import { CONTACT_VERTEX, ROPE_FRAGMENT, ROPE_VERTEX } from "./rope_shaders.js";
import { SHADOW_FRAGMENT, SHADOW_VERTEX } from "./rope_shaders.js";
import { DOT_FRAGMENT, DOT_VERTEX } from "./shaders.js";
import { CONTACT_FRAGMENT } from "./solid_shaders.js";
import { textureSize } from "./texture_size.js";

/** @typedef {import("../view.js").Shape} Shape */
/** @typedef {import("../view.js").Theme} Theme */
/** @typedef {import("../line.js").Line} Line */

const FAR = 1e6; // m: no free end near

export class Ribbons {
  /** @param {Record<string, THREE.IUniform>} shared @param {import("./backdrop.js").Backdrop} behind */
  constructor(shared, { texture: backdrop, solids, uniforms: picture }) {
    this.uniforms = {
      points: { value: /** @type {THREE.DataTexture | null} */ (null) },
      normals: { value: /** @type {THREE.DataTexture | null} */ (null) },
      columns: { value: 1 },
      least: { value: 4 },
      thick: { value: 1 },
      laid: { value: 1 },
      map: { value: /** @type {THREE.DataTexture | null} */ (null) },
      range: { value: new THREE.Vector2(0, 1) },
      plain: { value: false },
      rim: { value: 1 },
      height: { value: 0 },
    };
    this.shadowInk = { value: 0.3 };
    this.dotInk = { value: new THREE.Vector3(0, 0, 0) };
    const near = { solids: solids.near, solidCount: solids.count, info: solids.info };
    const all = { ...shared, ...this.uniforms, ...near };
    this.ropes = new THREE.Mesh(undefined, material(ROPE_VERTEX, ROPE_FRAGMENT, all, true));
    this.shadow = new THREE.Mesh(
      undefined,
      flatMaterial(SHADOW_VERTEX, SHADOW_FRAGMENT, { ...all, backdrop, ink: this.shadowInk }, true),
    );
    const { size, top, ahead } = picture;
    this.contact = new THREE.Mesh(
      undefined,
      flatMaterial(
        CONTACT_VERTEX,
        CONTACT_FRAGMENT,
        { ...all, size, top, ahead, backdrop, ink: this.shadowInk },
        true,
      ),
    );
    this.dots = new THREE.Points(
      undefined,
      material(DOT_VERTEX, DOT_FRAGMENT, { ...all, ink: this.dotInk, dot_: { value: 5 } }, true),
    );
    this.shadow.renderOrder = -2;
    this.contact.renderOrder = -1;
    this.solid = false; // whether there are bodies
    this.ropes.renderOrder = 1;
    this.dots.renderOrder = 2;
    for (const part of [this.ropes, this.shadow, this.contact, this.dots])
      part.frustumCulled = false;
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.uniforms.map.value?.dispose();
    this.uniforms.map.value = mapTexture(theme.dark);
    this.uniforms.rim.value = theme.rim;
    this.shadowInk.value = theme.dark ? 0.75 : 0.42;
    this.dotInk.value.set(...theme.node);
  }

  /** Whether there are bodies that ropes lie on. @param {boolean} solid */
  setSolid(solid) {
    this.contact.visible = solid;
    if (solid === this.solid) return;
    this.solid = solid;
    for (const { material: made } of [this.ropes, this.shadow]) {
      made.defines = solid ? { SOLIDS: 1 } : {};
      made.needsUpdate = true;
    }
  }

  /** Build buffers for another number of points. @param {Line} line */
  setLine(line) {
    const geometry = ribbonGeometry(line.shape);
    this.ropes.geometry.dispose();
    this.ropes.geometry = geometry;
    this.shadow.geometry = this.contact.geometry = geometry;
    const dots = new THREE.BufferGeometry();
    const nodes = line.shape.ropes.flatMap(({ first, count }) =>
      Array.from({ length: Math.ceil(count / line.steps) }, (_, i) => first + i * line.steps),
    );
    dots.setIndex(new THREE.BufferAttribute(new Uint32Array(nodes), 1));
    this.dots.geometry.dispose();
    this.dots.geometry = dots;
    for (const name of /** @type {const} */ (["points", "normals"])) {
      this.uniforms[name].value?.dispose();
      this.uniforms[name].value = texture(line[name]);
    }
    this.uniforms.columns.value = textureSize(line.points.length / 4)[0];
    this.uniforms.laid.value = line.framed ? 1 : 0;
  }

  /** The points were moved. */
  moved() {
    const { points, normals, laid } = this.uniforms;
    if (points.value) points.value.needsUpdate = true;
    if (normals.value && laid.value) normals.value.needsUpdate = true;
  }

  dispose() {
    this.uniforms.points.value?.dispose();
    this.uniforms.normals.value?.dispose();
    this.uniforms.map.value?.dispose();
    this.ropes.geometry.dispose();
    this.dots.geometry.dispose();
  }
}

/** @param {Float32Array} values four of each point */
function texture(values) {
  const [width, height] = textureSize(values.length / 4);
  const made = new THREE.DataTexture(values, width, height, THREE.RGBAFormat, THREE.FloatType);
  made.internalFormat = "RGBA32F";
  made.needsUpdate = true;
  return made;
}

/** @param {Shape} shape */
function ribbonGeometry(shape) {
  const look = new Float32Array(8 * shape.nodes);
  const tint = new Float32Array(6 * shape.nodes);
  const index = [];
  for (const rope of shape.ropes) {
    for (let i = 0; i < rope.count; i++) {
      const node = rope.first + i;
      const before = i > 0;
      const after = i < rope.count - 1;
      const end = Math.min(
        rope.loose[0] ? i * rope.spacing : FAR,
        rope.loose[1] ? (rope.count - 1 - i) * rope.spacing : FAR,
      );
      for (const v of [2 * node, 2 * node + 1]) {
        look.set([rope.radius, Number(before), Number(after), end], 4 * v);
        tint.set(rope.colour, 3 * v);
      }
      if (after) {
        const v = 2 * node;
        index.push(v, v + 1, v + 2, v + 1, v + 3, v + 2);
      }
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("look", new THREE.BufferAttribute(look, 4));
  geometry.setAttribute("tint", new THREE.BufferAttribute(tint, 3));
  geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(index), 1));
  return geometry;
}

/** @param {boolean} dark */
function mapTexture(dark) {
  const bytes = new Uint8Array(4 * SHADES);
  uniformMap(dark).forEach((colour, i) =>
    bytes.set([...colour.map((c) => Math.round(255 * c)), 255], 4 * i),
  );
  const made = new THREE.DataTexture(bytes, SHADES, 1);
  made.minFilter = THREE.LinearFilter;
  made.magFilter = THREE.LinearFilter;
  made.needsUpdate = true;
  return made;
}
