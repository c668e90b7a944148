// Arrows of reactions and the spring of the hand: flat arrows that face the camera, in one draw call.

import * as THREE from "three";

import { material } from "./material.js";
import { ARROW_FRAGMENT, ARROW_VERTEX } from "./shaders.js";

/** @typedef {import("../view.js").Arrow} Arrow */

const ROOM = 256;
const CORNERS = 7; // a shaft of four corners, a head of three
const INDEX = [0, 1, 2, 1, 3, 2, 4, 5, 6];

export class ArrowMesh {
  /** @param {Record<string, THREE.IUniform>} shared @param {boolean} [round] bars that stand in the scene
   * @param {boolean} [deep] whether nearer things hide them */
  constructor(shared, round = false, deep = round) {
    const geometry = new THREE.BufferGeometry();
    for (const [name, size] of /** @type {[string, number][]} */ ([
      ["position", 3],
      ["line", 3],
      ["ink", 4],
      ["edge", 1],
    ])) {
      const attribute = new THREE.BufferAttribute(new Float32Array(size * CORNERS * ROOM), size);
      attribute.setUsage(THREE.DynamicDrawUsage);
      geometry.setAttribute(name, attribute);
    }
    const index = [];
    for (let i = 0; i < ROOM; i++) index.push(...INDEX.map((corner) => corner + CORNERS * i));
    geometry.setIndex(index);
    this.mesh = new THREE.Mesh(
      geometry,
      material(ARROW_VERTEX, ARROW_FRAGMENT, { ...shared, round_: { value: Number(round) } }, deep),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = round ? 0.5 : deep ? 2.2 : 2.5;
  }

  /** @param {Arrow[]} arrows @param {number} perPixel metres per pixel near them */
  update(arrows, perPixel) {
    const count = Math.min(ROOM, arrows.length);
    this.mesh.visible = count > 0;
    if (!count) return;
    const geometry = this.mesh.geometry;
    const [place, line, ink, edge] = ["position", "line", "ink", "edge"].map(
      (name) => /** @type {THREE.BufferAttribute} */ (geometry.getAttribute(name)),
    );
    for (let k = 0; k < count; k++) {
      const { from, to, colour, pixels, head } = arrows[k];
      const d = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
      const size = Math.hypot(d[0], d[1], d[2]);
      const tip = head && size > 0 ? Math.min(0.5, (5.5 * pixels * perPixel) / size) : 0;
      const half = pixels / 2;
      const wide = head ? 2.2 * pixels : 0;
      // Where along the line, half the width there, to which side: a pixel wider, for smooth edges.
      const corners = [
        [0, half, -1],
        [0, half, 1],
        [1 - tip, half, -1],
        [1 - tip, half, 1],
        [1 - tip, wide, -1],
        [1 - tip, wide, 1],
        [1, 0, 0],
      ];
      corners.forEach(([along, width, side], corner) => {
        const v = CORNERS * k + corner;
        place.setXYZ(v, from[0] + along * d[0], from[1] + along * d[1], from[2] + along * d[2]);
        line.setXYZ(v, d[0], d[1], d[2]);
        ink.setXYZW(v, colour[0], colour[1], colour[2], side * (width && width + 1));
        edge.setX(v, width);
      });
    }
    place.needsUpdate = line.needsUpdate = ink.needsUpdate = edge.needsUpdate = true;
    geometry.setDrawRange(0, INDEX.length * count);
  }
}
