// Materials of our own shaders: transparent edges, both sides, no tone mapping.

import * as THREE from "three";

/** @param {string} vertexShader @param {string} fragmentShader
 * @param {Record<string, THREE.IUniform>} uniforms @param {boolean} deep whether nearer things hide it */
export function material(vertexShader, fragmentShader, uniforms, deep) {
  return new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    transparent: true,
    depthTest: deep,
    depthWrite: deep,
    side: THREE.DoubleSide,
  });
}
