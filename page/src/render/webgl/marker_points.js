// Anchors, loads, pins and the ring under the pointer: points drawn as lit balls, eye bolts and rings.

import * as THREE from "three";

import { material } from "./material.js";
import { MARKER_FRAGMENT, MARKER_VERTEX } from "./shaders.js";

/** @typedef {import("../view.js").Marker} Marker */

const KINDS = { round: 0, eye: 1, ring: 2, knot: 3 };

export class MarkerPoints {
  /** @param {Record<string, THREE.IUniform>} shared */
  constructor(shared) {
    this.room = 0;
    this.points = new THREE.Points(
      undefined,
      material(MARKER_VERTEX, MARKER_FRAGMENT, shared, true),
    );
    this.points.frustumCulled = false;
    this.points.renderOrder = 3;
    this.grow(32);
  }

  /** @param {number} room */
  grow(room) {
    this.room = room;
    this.points.geometry.dispose();
    const geometry = new THREE.BufferGeometry();
    for (const [name, size] of /** @type {[string, number][]} */ ([
      ["position", 3],
      ["ink", 4],
      ["sizes", 2],
    ])) {
      const attribute = new THREE.BufferAttribute(new Float32Array(size * room), size);
      attribute.setUsage(THREE.DynamicDrawUsage);
      geometry.setAttribute(name, attribute);
    }
    this.points.geometry = geometry;
  }

  /** @param {Marker[]} markers */
  update(markers) {
    if (markers.length > this.room) this.grow(2 * markers.length);
    const geometry = this.points.geometry;
    const [place, ink, sizes] = ["position", "ink", "sizes"].map(
      (name) => /** @type {THREE.BufferAttribute} */ (geometry.getAttribute(name)),
    );
    markers.forEach((marker, i) => {
      place.setXYZ(i, marker.x, marker.y, marker.z);
      const [r, g, b] = marker.colour;
      ink.setXYZW(i, r, g, b, KINDS[marker.kind]);
      sizes.setXY(i, marker.size, marker.pixels);
    });
    place.needsUpdate = ink.needsUpdate = sizes.needsUpdate = true;
    geometry.setDrawRange(0, markers.length);
    this.points.visible = markers.length > 0;
  }
}
