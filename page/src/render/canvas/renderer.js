// Draws with Canvas 2D where there is no WebGL: the same camera, colours in a few batches.

import { css, uniformMap } from "../../view/colours.js";
import { Line } from "../line.js";
import { TRAIL_POINTS } from "../trails.js";
import { drawGrid, drawSky } from "./floor.js";
import { dot, plus } from "../../view/vector.js";
import { drawArrow, drawMarker } from "./marks.js";
import { drawSolids } from "./solids.js";
import { hides } from "../../view/solids.js";

/** @typedef {import("../view.js").Renderer} Renderer */
/** @typedef {import("../view.js").View} View */
/** @typedef {import("../view.js").Theme} Theme */
/** @typedef {import("../view.js").Shape} Shape */
/** @typedef {import("../view.js").RopeSpan} RopeSpan */

const BATCHES = 32;
const POINTS = 1200; // of the ropes' lines, at most
const TRAIL_BATCHES = 6;

/** @implements {Renderer} */
export class CanvasRenderer {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    const context = canvas.getContext("2d", { alpha: false });
    if (!context) throw new Error("no canvas to draw on");
    /** @type {"canvas"} */
    this.name = "canvas";
    this.canvas = canvas;
    this.context = context;
    /** @type {string[]} */
    this.colours = [];
    this.line = new Line(POINTS, 0);
    /** @type {Shape} */
    this.shape = { nodes: 0, ropes: [] };
    this.seen = new Float32Array(0); // x, y [CSS pixels], depth [m] of each node
    this.batch = new Uint8Array(0);
    this.ratio = 1;
    this.rough = this.unfinished = false;
    /** @type {Theme | null} */
    this.theme = null;
  }

  /** @param {Shape} shape */
  setShape(shape) {
    this.line.setShape(shape);
  }

  /** @param {Theme} theme */
  setTheme(theme) {
    this.theme = theme;
    const map = uniformMap(theme.dark);
    this.colours = Array.from({ length: BATCHES }, (_, i) =>
      css(map[Math.round((i / (BATCHES - 1)) * (map.length - 1))]),
    );
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  resize(width, height, ratio) {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.ratio = ratio;
  }

  clear() {
    const { context, canvas, theme } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = theme ? css(theme.background) : "#888888";
    context.fillRect(0, 0, canvas.width, canvas.height);
  }

  /** Take over the line of the ropes. @param {View} view */
  follow(view) {
    if (!this.line.update(view)) return;
    this.shape = this.line.shape;
    this.seen = new Float32Array(3 * this.shape.nodes);
    this.batch = new Uint8Array(this.shape.nodes);
  }

  /** @param {View} view */
  draw(view) {
    const { context, theme } = this;
    if (!theme) return;
    this.follow(view);
    this.clear();
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.lineJoin = "round";
    context.lineCap = "round";
    drawSky(context, view.camera, theme);
    drawGrid(context, view.camera, view.ground, theme);
    this.shadows(view, theme);
    for (const post of view.posts) drawArrow(context, view.camera, post);
    drawSolids(context, view, theme);
    this.project(view, null);
    if (view.solids.length) this.hide(view);
    if (view.trails && !view.trails.empty) this.trails(view);
    this.ropes(view);
    if (view.dots) this.dots(theme);
    for (const marker of view.markers) drawMarker(context, view.camera, marker);
    for (const arrow of view.touches) {
      const { camera, solids } = view;
      const hidden = solids.some((one) => hides(one, camera.eye, arrow.to, 0));
      if (!hidden) drawArrow(context, camera, arrow);
    }
    for (const arrow of view.arrows) drawArrow(context, view.camera, arrow);
  }

  /** @param {View} view @param {Theme} theme */
  shadows(view, theme) {
    const { context } = this;
    this.project(view, view.ground.height);
    context.strokeStyle = css(theme.shadow, theme.dark ? 0.5 : 0.16);
    for (const rope of this.shape.ropes) {
      context.lineWidth = this.width(rope, view) * 1.2;
      context.beginPath();
      this.path(rope);
      context.stroke();
    }
  }

  /** Places on the screen, or those of the shadows. @param {View} view @param {number | null} ground */
  project(view, ground) {
    const { seen } = this;
    const { camera } = view;
    const { points } = this.line;
    const v = camera.view;
    const [ux, uy, uz] = camera.up;
    const slant = plus(camera.light, camera.up, -dot(camera.light, camera.up));
    const [lx, ly, lz] = plus(camera.up, slant, 0.75 / dot(camera.light, camera.up));
    const [left, top, focal] = [camera.width / 2, camera.height / 2, camera.focal];
    for (let i = 0; i < this.shape.nodes; i++) {
      let [x, y, z] = [points[4 * i], points[4 * i + 1], points[4 * i + 2]];
      if (ground !== null) {
        const height = x * ux + y * uy + z * uz - ground;
        x -= height * lx;
        y -= height * ly;
        z -= height * lz;
      }
      const depth = -(v[2] * x + v[6] * y + v[10] * z + v[14]);
      const scale = focal / Math.max(depth, 1e-9);
      seen[3 * i] = left + (v[0] * x + v[4] * y + v[8] * z + v[12]) * scale;
      seen[3 * i + 1] = top - (v[1] * x + v[5] * y + v[9] * z + v[13]) * scale;
      seen[3 * i + 2] = points[4 * i + 3] > 1e30 ? -1 : depth; // as if behind: not drawn
    }
  }

  /** Let no rope be drawn where a body is before it. @param {View} view */
  hide({ camera, solids, pixels }) {
    const { seen } = this;
    const { points } = this.line;
    for (const rope of this.shape.ropes) {
      for (let i = rope.first; i < rope.first + rope.count; i++) {
        const place = points.subarray(4 * i, 4 * i + 3);
        const slack = Math.max(rope.radius, (0.5 * pixels * seen[3 * i + 2]) / camera.focal);
        if (solids.some((one) => hides(one, camera.eye, place, slack))) seen[3 * i + 2] *= -1;
      }
    }
  }

  /** @param {RopeSpan} rope @param {View} view */
  width(rope, view) {
    const middle = this.seen[3 * (rope.first + (rope.count >> 1)) + 2];
    const depth = Math.max(1e-9, Math.abs(middle)); // below zero where it is hidden
    return Math.max(view.pixels, (2 * rope.radius * view.camera.focal) / depth);
  }

  /** The whole rope as one path. @param {RopeSpan} rope */
  path(rope) {
    const { context, seen } = this;
    let drawing = false;
    for (let i = rope.first; i < rope.first + rope.count; i++) {
      const behind = seen[3 * i + 2] <= 0;
      if (drawing && !behind) context.lineTo(seen[3 * i], seen[3 * i + 1]);
      else context.moveTo(seen[3 * i], seen[3 * i + 1]);
      drawing = !behind;
    }
  }

  /** @param {View} view */
  ropes(view) {
    const { context } = this;
    const theme = /** @type {Theme} */ (this.theme);
    for (const rope of this.shape.ropes) {
      const width = this.width(rope, view);
      if (view.plain) {
        context.lineWidth = width;
        context.strokeStyle = css(rope.colour);
        context.beginPath();
        this.path(rope);
        context.stroke();
        continue;
      }
      this.coloured(rope, view, width);
      if (width > 6) {
        // a light line along the middle makes it round
        context.lineWidth = width * 0.25;
        context.strokeStyle = theme.dark ? "rgba(255, 255, 255, 0.18)" : "rgba(255, 255, 255, 0.3)";
        context.beginPath();
        this.path(rope);
        context.stroke();
      }
    }
  }

  /** Segments of one shade in one path each. @param {RopeSpan} rope @param {View} view
   * @param {number} width */
  coloured(rope, view, width) {
    const { context, seen, batch } = this;
    const { points } = this.line;
    const { low, high } = view.range;
    const scale = BATCHES / Math.max(high - low, 1e-30);
    const last = rope.first + rope.count - 1;
    for (let i = rope.first; i < last; i++) {
      const value = 0.5 * (points[4 * i + 3] + points[4 * i + 7]);
      batch[i] = Math.min(BATCHES - 1, Math.max(0, Math.floor((value - low) * scale)));
    }
    context.lineWidth = width;
    for (let shade = 0; shade < BATCHES; shade++) {
      let joined = false;
      let used = false;
      for (let i = rope.first; i < last; i++) {
        const shown = batch[i] === shade;
        if (!shown || !(seen[3 * i + 2] > 0 && seen[3 * i + 5] > 0)) {
          joined = false;
          continue;
        }
        if (!used) context.beginPath();
        if (!joined) context.moveTo(seen[3 * i], seen[3 * i + 1]);
        context.lineTo(seen[3 * i + 3], seen[3 * i + 4]);
        joined = used = true;
      }
      if (!used) continue;
      context.strokeStyle = this.colours[shade];
      context.stroke();
    }
  }

  /** @param {Theme} theme */
  dots(theme) {
    const { context, seen } = this;
    context.fillStyle = css(theme.node);
    context.beginPath();
    for (const { first, count } of this.shape.ropes) {
      for (let i = first; i < first + count; i += this.line.steps) {
        if (seen[3 * i + 2] <= 0) continue;
        context.moveTo(seen[3 * i] + 2.2, seen[3 * i + 1]);
        context.arc(seen[3 * i], seen[3 * i + 1], 2.2, 0, 2 * Math.PI);
      }
    }
    context.fill();
  }

  /** @param {View} view */
  trails(view) {
    const trails = /** @type {import("../trails.js").Trails} */ (view.trails);
    const { context } = this;
    context.lineWidth = 2.5;
    const each = TRAIL_POINTS / TRAIL_BATCHES;
    trails.nodes.forEach((_, row) => {
      for (let batch = 0; batch < TRAIL_BATCHES; batch++) {
        context.strokeStyle = css(trails.colours[row], 0.7 * ((batch + 1) / TRAIL_BATCHES) ** 2);
        context.beginPath();
        for (let k = batch * each; k <= Math.min((batch + 1) * each, TRAIL_POINTS - 1); k++) {
          const at = 4 * (row * TRAIL_POINTS + ((trails.head + k) % TRAIL_POINTS));
          const p = trails.points;
          const [x, y, depth] = view.camera.project(p[at], p[at + 1], p[at + 2]);
          if (depth > 0) context.lineTo(x, y);
        }
        context.stroke();
      }
    });
  }

  dispose() {}
}
