// Trails of chosen nodes as fading ribbons; their points lie in a texture that is written in place.

import * as THREE from "three";

import { TRAIL_POINTS } from "../trails.js";
import { material } from "./material.js";
import { TRAIL_FRAGMENT, TRAIL_VERTEX } from "./shaders.js";

/** @typedef {import("../trails.js").Trails} Trails */

export class TrailRibbons {
  /** @param {Record<string, THREE.IUniform>} shared */
  constructor(shared) {
    this.uniforms = {
      points: { value: /** @type {THREE.DataTexture | null} */ (null) },
      columns: { value: TRAIL_POINTS },
      head: { value: 0 },
    };
    this.mesh = new THREE.Mesh(
      undefined,
      material(TRAIL_VERTEX, TRAIL_FRAGMENT, { ...shared, ...this.uniforms }, false),
    );
    this.mesh.frustumCulled = false;
    /** @type {Trails | null} */
    this.trails = null;
    this.version = -1;
  }

  /** @param {Trails | null} trails */
  update(trails) {
    this.mesh.visible = trails !== null && !trails.empty;
    if (!trails) return;
    if (trails !== this.trails) this.rebuild(trails);
    if (trails.version === this.version) return;
    this.version = trails.version;
    this.uniforms.head.value = trails.head;
    const texture = this.uniforms.points.value;
    if (texture) texture.needsUpdate = true;
  }

  /** @param {Trails} trails */
  rebuild(trails) {
    this.trails = trails;
    this.version = -1;
    const rows = trails.nodes.length;
    this.uniforms.points.value?.dispose();
    const texture = new THREE.DataTexture(
      trails.points,
      TRAIL_POINTS,
      rows,
      THREE.RGBAFormat,
      THREE.FloatType,
    );
    texture.internalFormat = "RGBA32F";
    this.uniforms.points.value = texture;
    const tint = new Float32Array(6 * TRAIL_POINTS * rows);
    const index = [];
    for (let row = 0; row < rows; row++) {
      for (let i = 0; i < TRAIL_POINTS; i++) {
        const v = 2 * (row * TRAIL_POINTS + i);
        tint.set([...trails.colours[row], ...trails.colours[row]], 3 * v);
        if (i < TRAIL_POINTS - 1) index.push(v, v + 1, v + 2, v + 1, v + 3, v + 2);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("tint", new THREE.BufferAttribute(tint, 3));
    geometry.setIndex(index);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
}
