// Materials of our own shaders: both sides, no tone mapping.

import * as THREE from "three";

/** With transparent edges. @param {string} vertexShader @param {string} fragmentShader
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

/** Painted over what was there; or, with `darker`, only where that makes it darker.
 * @param {string} vertexShader @param {string} fragmentShader
 * @param {Record<string, THREE.IUniform>} uniforms @param {boolean} [darker] */
export function flatMaterial(vertexShader, fragmentShader, uniforms, darker = false) {
  const made = material(vertexShader, fragmentShader, uniforms, false);
  made.blending = darker ? THREE.CustomBlending : THREE.NoBlending;
  if (darker) {
    made.blendEquation = THREE.MinEquation;
    made.blendSrc = THREE.OneFactor;
    made.blendDst = THREE.OneFactor;
  }
  return made;
}
