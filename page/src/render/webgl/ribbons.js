// The ropes of all copies: one static index buffer, positions from a texture, one draw call.

import * as THREE from "three";

import { SHADES, uniformMap } from "../../view/colours.js";
import { material } from "./material.js";
import {
  DOT_FRAGMENT,
  DOT_VERTEX,
  ROPE_FRAGMENT,
  ROPE_VERTEX,
  SHADOW_FRAGMENT,
  SHADOW_VERTEX,
} from "./shaders.js";
import { textureSize } from "./texture_size.js";

/** @typedef {import("../view.js").Shape} Shape */

export class Ribbons {
  /** @param {Record<string, THREE.IUniform>} shared */
  constructor(shared) {
    this.uniforms = {
      nodes: { value: /** @type {THREE.DataTexture | null} */ (null) },
      columns: { value: 1 },
      least: { value: 4 },
      map: { value: mapTexture() },
      range: { value: new THREE.Vector2(0, 1) },
      plain: { value: false },
      night: { value: 0 },
      height: { value: 0 },
    };
    this.shadowInk = { value: new THREE.Vector4(0, 0, 0, 0.2) };
    this.dotInk = { value: new THREE.Vector3(0, 0, 0) };
    const all = { ...shared, ...this.uniforms };
    this.ropes = new THREE.Mesh(undefined, material(ROPE_VERTEX, ROPE_FRAGMENT, all, true));
    this.shadow = new THREE.Mesh(
      undefined,
      material(SHADOW_VERTEX, SHADOW_FRAGMENT, { ...all, ink: this.shadowInk }, false),
    );
    this.dots = new THREE.Points(
      undefined,
      material(DOT_VERTEX, DOT_FRAGMENT, { ...all, ink: this.dotInk, dot_: { value: 5 } }, true),
    );
    this.shadow.renderOrder = -2;
    this.ropes.renderOrder = 1;
    this.dots.renderOrder = 2;
    for (const part of [this.ropes, this.shadow, this.dots]) part.frustumCulled = false;
    /** @type {THREE.DataTexture | null} */
    this.texture = null;
  }

  /** Build buffers for other ropes or cuts. @param {Shape} shape */
  setShape(shape) {
    const geometry = ribbonGeometry(shape);
    this.ropes.geometry.dispose();
    this.ropes.geometry = geometry;
    this.shadow.geometry = geometry;
    const dots = new THREE.BufferGeometry();
    dots.setIndex(
      new THREE.BufferAttribute(
        Uint32Array.from({ length: shape.nodes }, (_, i) => i),
        1,
      ),
    );
    this.dots.geometry.dispose();
    this.dots.geometry = dots;
  }

  /** Use these values, which are written in place from now on. @param {Float32Array} values */
  use(values) {
    if (this.texture?.image.data === values) return;
    this.texture?.dispose();
    const [width, height] = textureSize(values.length / 4);
    this.texture = new THREE.DataTexture(values, width, height, THREE.RGBAFormat, THREE.FloatType);
    this.texture.internalFormat = "RGBA32F";
    this.uniforms.nodes.value = this.texture;
    this.uniforms.columns.value = width;
    this.texture.needsUpdate = true;
  }

  dispose() {
    this.texture?.dispose();
    this.ropes.geometry.dispose();
    this.dots.geometry.dispose();
  }
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
      for (const v of [2 * node, 2 * node + 1]) {
        look.set([rope.radius, i * rope.spacing, Number(before), Number(after)], 4 * v);
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

function mapTexture() {
  const bytes = new Uint8Array(4 * SHADES);
  uniformMap().forEach((colour, i) =>
    bytes.set([...colour.map((c) => Math.round(255 * c)), 255], 4 * i),
  );
  const texture = new THREE.DataTexture(bytes, SHADES, 1);
  texture.minFilter = THREE.LinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
