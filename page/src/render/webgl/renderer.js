// Draws with WebGL2 through three.js. Buffers are made once; a frame updates one texture in place.

import * as THREE from "three";

import { ArrowMesh } from "./arrow_mesh.js";
import { Floor } from "./floor.js";
import { MarkerPoints } from "./marker_points.js";
import { Ribbons } from "./ribbons.js";
import { TrailRibbons } from "./trail_ribbons.js";

/** @typedef {import("../view.js").View} View */
/** @typedef {import("../view.js").Theme} Theme */

/** @typedef {import("../view.js").Renderer} Renderer */

/** @implements {Renderer} */
export class WebglRenderer {
  /** @param {HTMLCanvasElement} canvas @throws {Error} where there is no WebGL2 */
  constructor(canvas) {
    const context = canvas.getContext("webgl2", {
      antialias: false, // edges are smoothed in the shaders
      alpha: false,
      powerPreference: "high-performance",
    });
    if (!context) throw new Error("no WebGL2");
    /** @type {"webgl"} */
    this.name = "webgl";
    this.canvas = canvas;
    this.three = new THREE.WebGLRenderer({ canvas, context, antialias: false });
    this.three.outputColorSpace = THREE.LinearSRGBColorSpace; // colours are given as shown
    this.shared = {
      view: { value: new THREE.Matrix4() },
      projection: { value: new THREE.Matrix4() },
      eye: { value: new THREE.Vector3() },
      up: { value: new THREE.Vector3() },
      right: { value: new THREE.Vector3() },
      pixel: { value: 0.001 },
      ratio: { value: 1 },
    };
    this.scene = new THREE.Scene();
    this.scene.matrixWorldAutoUpdate = false;
    this.camera = new THREE.Camera(); // unused by our shaders, which take the shared uniforms
    this.ribbons = new Ribbons(this.shared);
    this.floor = new Floor(this.shared);
    this.markers = new MarkerPoints(this.shared);
    this.arrows = new ArrowMesh(this.shared);
    this.trails = new TrailRibbons(this.shared);
    this.scene.add(
      this.floor.disc,
      this.floor.grid,
      this.ribbons.shadow,
      this.trails.mesh,
      this.ribbons.ropes,
      this.ribbons.dots,
      this.markers.points,
      this.arrows.mesh,
    );
  }

  /** @param {import("../view.js").Shape} shape */
  setShape(shape) {
    this.ribbons.setShape(shape);
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    const background = new THREE.Color().setRGB(...theme.background, THREE.LinearSRGBColorSpace);
    this.three.setClearColor(background, 1);
    this.floor.setTheme(theme);
    this.ribbons.shadowInk.value.set(...theme.shadow, theme.dark ? 0.85 : 0.3);
    this.ribbons.dotInk.value.set(...theme.node);
    this.ribbons.uniforms.night.value = theme.dark ? 1 : 0;
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  resize(width, height, ratio) {
    this.three.setPixelRatio(ratio);
    this.three.setSize(width, height, false);
    this.shared.ratio.value = ratio;
  }

  /** @param {View} view */
  draw(view) {
    const { camera } = view;
    this.shared.view.value.fromArray(camera.view);
    this.shared.projection.value.fromArray(camera.projection);
    this.shared.eye.value.set(...camera.eye);
    this.shared.up.value.set(...camera.up);
    this.shared.right.value.set(...camera.right);
    this.shared.pixel.value = 1 / camera.focal;
    this.ribbons.use(view.nodes);
    if (view.moved && this.ribbons.texture) this.ribbons.texture.needsUpdate = true;
    const uniforms = this.ribbons.uniforms;
    uniforms.range.value.set(view.range.low, view.range.high);
    uniforms.plain.value = view.plain;
    uniforms.least.value = view.pixels;
    uniforms.height.value = view.ground?.height ?? 0;
    this.ribbons.shadow.visible = view.ground !== null;
    this.ribbons.dots.visible = view.dots;
    this.floor.update(view.ground, camera);
    this.markers.update(view.markers);
    this.arrows.update(view.arrows, camera.pose.distance / camera.focal);
    this.trails.update(view.trails);
    this.three.render(this.scene, this.camera);
  }

  clear() {
    this.three.clear();
  }

  dispose() {
    this.ribbons.dispose();
    this.three.dispose();
  }
}
