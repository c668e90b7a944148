// Draws with WebGL2 through three.js. Buffers are made once; a frame updates one texture in place.

import * as THREE from "three";

import { ArrowMesh } from "./arrow_mesh.js";
import { Line } from "../line.js";
import { Backdrop } from "./backdrop.js";
import { MarkerPoints } from "./marker_points.js";
import { Ribbons } from "./ribbons.js";
import { TrailRibbons } from "./trail_ribbons.js";

/** @typedef {import("../view.js").View} View */
/** @typedef {import("../view.js").Theme} Theme */

/** @typedef {import("../view.js").Renderer} Renderer */

/** Points of the ropes' lines, at most; and with strands, at most. @type {[number, number]} */
const POINTS = [24_000, 40_000];
/** The same where the processor draws. @type {[number, number]} */
const SOFT_POINTS = [2_400, 2_600];
const LAY_CHANGE = 0.65; // powers of two by which the drawn width changes before the drawn lay does

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
      key: { value: new THREE.Vector3(0, 0, 1) },
      pixel: { value: 0.001 },
      ratio: { value: 1 },
      coarse: { value: 1 },
    };
    this.scene = new THREE.Scene();
    this.scene.matrixWorldAutoUpdate = false;
    this.camera = new THREE.Camera(); // unused by our shaders, which take the shared uniforms
    this.soft = drawnInSoftware(context);
    this.line = new Line(...(this.soft ? SOFT_POINTS : POINTS));
    this.backdrop = new Backdrop(this.shared, this.soft);
    this.ribbons = new Ribbons(this.shared, this.backdrop);
    this.markers = new MarkerPoints(this.shared);
    this.arrows = new ArrowMesh(this.shared);
    this.touches = new ArrowMesh(this.shared, false, true);
    this.posts = new ArrowMesh(this.shared, true);
    this.trails = new TrailRibbons(this.shared);
    this.scene.add(
      this.backdrop.mesh,
      this.backdrop.deep,
      this.ribbons.shadow,
      this.ribbons.contact,
      this.trails.mesh,
      this.ribbons.ropes,
      this.ribbons.dots,
      this.markers.points,
      this.arrows.mesh,
      this.touches.mesh,
      this.posts.mesh,
    );
  }

  /** @param {import("../view.js").Shape} shape */
  setShape(shape) {
    this.line.setShape(shape);
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    const background = new THREE.Color().setRGB(...theme.background, THREE.LinearSRGBColorSpace);
    this.three.setClearColor(background, 1);
    this.backdrop.setTheme(theme);
    this.ribbons.setTheme(theme);
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  resize(width, height, ratio) {
    this.three.setPixelRatio(ratio);
    this.three.setSize(width, height, false);
    this.shared.ratio.value = ratio;
    this.backdrop.resize(this.canvas.width, this.canvas.height);
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
    this.shared.key.value.set(...camera.light);
    if (this.line.update(view)) this.ribbons.setLine(this.line);
    else if (view.moved) this.ribbons.moved();
    const uniforms = this.ribbons.uniforms;
    const thick = (0.5 * view.pixels * camera.pose.distance) / camera.focal;
    if (Math.abs(Math.log2(thick / uniforms.thick.value)) > LAY_CHANGE)
      uniforms.thick.value = thick;
    uniforms.range.value.set(view.range.low, view.range.high);
    uniforms.plain.value = view.plain;
    uniforms.least.value = view.pixels;
    uniforms.height.value = view.ground.height;
    this.ribbons.shadow.visible = camera.eyeHeight(view.ground.height) > 0;
    this.ribbons.dots.visible = view.dots;
    this.ribbons.setSolid(view.solids.length > 0);
    this.backdrop.update(this.three, this.camera, view);
    this.markers.update(view.markers);
    this.arrows.update(view.arrows, camera.pose.distance / camera.focal);
    this.touches.update(view.touches, camera.pose.distance / camera.focal);
    this.posts.update(view.posts, camera.pose.distance / camera.focal);
    this.trails.update(view.trails);
    this.three.render(this.scene, this.camera);
  }

  get rough() {
    return this.shared.coarse.value > 1;
  }

  get unfinished() {
    return this.backdrop.unfinished;
  }

  clear() {
    this.three.clear();
  }

  dispose() {
    this.ribbons.dispose();
    this.backdrop.dispose();
    this.three.dispose();
  }
}

/** Whether the processor does a graphics card's work. @param {WebGL2RenderingContext} context */
function drawnInSoftware(context) {
  const info = context.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(context.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
