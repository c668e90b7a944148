// Bodies of triangles as three.js draws them: colour, depth and the shadow on the floor.

import * as THREE from "three";

import { flatMaterial, material } from "./material.js";
import {
  SURFACE_COLOUR,
  SURFACE_INFO,
  SURFACE_SHADOW,
  SURFACE_SHADOW_VERTEX,
  SURFACE_VERTEX,
} from "./surface_shaders.js";

/** Colour, depth and shadow of a body. @param {import("../../view/surface.js").Surface} surface
 * @param {Record<string, THREE.IUniform>} uniforms those of the body @returns {THREE.Mesh[]} */
export function surfaceMeshes({ places, normals }, uniforms) {
  const colour = material(SURFACE_VERTEX, SURFACE_COLOUR, uniforms, true);
  const depth = flatMaterial(SURFACE_VERTEX, SURFACE_INFO, uniforms);
  depth.depthTest = depth.depthWrite = true;
  const shadow = material(SURFACE_SHADOW_VERTEX, SURFACE_SHADOW, uniforms, false);
  return [colour, depth, shadow].map((made) => {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
    const mesh = new THREE.Mesh(geometry, made);
    mesh.frustumCulled = false;
    return mesh;
  });
}
