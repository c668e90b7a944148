// The ground: a soft disc where there is a ground to land on, and a grid that fades out.

import * as THREE from "three";

import { material } from "./material.js";
import { FLOOR_FRAGMENT, FLOOR_VERTEX, GRID_FRAGMENT, GRID_VERTEX } from "./shaders.js";

/** @typedef {import("../view.js").Ground} Ground */
/** @typedef {import("../view.js").Theme} Theme */

const HALF = 14; // lines on each side of the middle

export class Floor {
  /** @param {Record<string, THREE.IUniform>} shared */
  constructor(shared) {
    this.uniforms = {
      center: { value: new THREE.Vector3() },
      first: { value: new THREE.Vector3(1, 0, 0) },
      second: { value: new THREE.Vector3(0, 1, 0) },
      spacing: { value: 1 },
      radius: { value: 1 },
      half_: { value: HALF },
    };
    this.gridInk = { value: new THREE.Vector4(0, 0, 0, 0.3) };
    this.floorInk = { value: new THREE.Vector4(0, 0, 0, 0.3) };
    const all = { ...shared, ...this.uniforms };
    this.grid = new THREE.Mesh(
      gridGeometry(),
      material(GRID_VERTEX, GRID_FRAGMENT, { ...all, ink: this.gridInk }, false),
    );
    const square = new THREE.BufferGeometry();
    const corners = new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]);
    square.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    square.setIndex([0, 1, 2, 1, 3, 2]);
    this.disc = new THREE.Mesh(
      square,
      material(FLOOR_VERTEX, FLOOR_FRAGMENT, { ...all, ink: this.floorInk }, false),
    );
    this.disc.renderOrder = -4;
    this.grid.renderOrder = -3;
    this.disc.frustumCulled = this.grid.frustumCulled = false;
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.gridInk.value.set(...theme.grid, 0.9);
    this.floorInk.value.set(...theme.ground, 0.95);
  }

  /** @param {Ground | null} ground @param {import("../../view/camera.js").Camera} camera */
  update(ground, camera) {
    this.grid.visible = ground !== null;
    this.disc.visible = ground !== null && ground.solid;
    if (!ground) return;
    this.uniforms.center.value.set(...ground.center);
    this.uniforms.first.value.set(...camera.first);
    this.uniforms.second.value.set(...camera.second);
    this.uniforms.spacing.value = ground.spacing;
    this.uniforms.radius.value = ground.spacing * HALF;
  }
}

function gridGeometry() {
  const corners = [];
  const index = [];
  for (let line = 0; line < 2 * (2 * HALF + 1); line++) {
    const v = corners.length / 3;
    for (const [end, side] of [
      [-1, -1],
      [-1, 1],
      [1, -1],
      [1, 1],
    ])
      corners.push(line, end, side);
    index.push(v, v + 1, v + 2, v + 1, v + 3, v + 2);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(corners), 3));
  geometry.setIndex(index);
  return geometry;
}
