// The rope on its canvas: floor, curve coloured by tension, anchors, the hand.

import { uniformMap } from "../view/colours.js";
import { drawPosts, drawReading } from "./post-drawing.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {{left: number, right: number, low: number, high: number}} Box in metres */

const ROOM = 0.14; // of the drawing on every side
const FAR = 1e5; // pixels
const FLAT = 0.45; // a box is at least that high over its width

/** @param {number} pixel what broke flies off farther than canvases can draw */
const near = (pixel) => Math.min(Math.max(pixel, -FAR), FAR);
/** @param {HTMLElement} element @param {string} name */
const colour = (element, name) => getComputedStyle(element).getPropertyValue(name).trim();

export class Drawing {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    /** @type {Box} */ this.box = { left: 0, right: 1, low: 0, high: 1 };
    this.scale = 1; // pixels per metre
    this.tall = 1; // how many times as high heights are drawn
    this.level = 0; // the height that stays in the middle if they are [m]
    /** @type {number[]} */ this.across = [1, 0, 0];
    /** @type {number[]} */ this.up = [0, 1, 0];
    this.largest = 1; // tension at the top of the colours [N]
    /** @type {string[]} */ this.map = [];
  }

  /** Take the colours of a theme. @param {boolean} dark */
  tint(dark) {
    this.map = uniformMap(dark).map(
      ([r, g, b]) => `rgb(${[r, g, b].map((part) => Math.round(255 * part)).join(" ")})`,
    );
  }

  /** Say which axes are seen: across and up. @param {number[]} across @param {number[]} up */
  look(across, up) {
    [this.across, this.up] = [across, up];
  }

  /** Make the box hold the rope, with the room that it needs to swing. @param {Rope} rope @param {number} length */
  fit(rope, length) {
    const places = this.#project(rope);
    const [xs, ys] = [places.map(([x]) => x), places.map(([, y]) => y)];
    const reach = 0.5 * length;
    const [left, right] = [Math.min(...xs), Math.max(...xs)];
    const [low, high] = [Math.min(...ys, Math.max(...ys) - 0.6 * reach), Math.max(...ys)];
    const width = Math.max(right - left, (high - low) / FLAT / 2, 1e-3);
    const middle = 0.5 * (left + right);
    this.level = ys.reduce((sum, y) => sum + y, 0) / ys.length;
    this.box = { left: middle - 0.5 * width, right: middle + 0.5 * width, low, high };
  }

  /** @param {Rope} rope @returns {[number, number][]} */
  #project(rope) {
    const { across, up } = this;
    /** @param {number[]} way @param {number} i */
    const along = (way, i) => way.reduce((sum, part, k) => sum + part * rope.x[k][i], 0);
    return Array.from({ length: rope.n }, (_, i) => [along(across, i), along(up, i)]);
  }

  /** The place in the middle of the drawing [m]. */
  #middle() {
    const { left, right, low, high } = this.box;
    return [0.5 * (left + right), this.tall === 1 ? 0.5 * (low + high) : this.level];
  }

  /** Metres to pixels. @param {[number, number]} place @returns {[number, number]} */
  shown([x, y]) {
    const { width, height } = this.canvas;
    const middle = this.#middle();
    return [
      0.5 * width + this.scale * (x - middle[0]),
      0.5 * height - this.tall * this.scale * (y - middle[1]),
    ];
  }

  /** Pixels to metres. @param {number} px @param {number} py @returns {[number, number]} */
  place(px, py) {
    const { width, height } = this.canvas;
    const middle = this.#middle();
    return [
      middle[0] + (px - 0.5 * width) / this.scale,
      middle[1] - (py - 0.5 * height) / (this.tall * this.scale),
    ];
  }

  /** The node that is nearest to a pixel, and how far it is [px]. @param {Rope} rope @param {number} px
   * @param {number} py */
  nearest(rope, px, py) {
    let [best, node] = [Infinity, 0];
    for (const [i, place] of this.#project(rope).entries()) {
      const [x, y] = this.shown(place);
      const away = Math.hypot(x - px, y - py);
      if (away < best) [best, node] = [away, i];
    }
    return { node, away: best };
  }

  /** Draw one picture. @param {Rope} rope @param {Float64Array} tension @param {number[][]} ropes first and last
   * node of each @param {number | null} hover @param {number} probe the node that is measured
   * @param {import("./posts.js").Reading | null} reading of a post */
  draw(rope, tension, ropes, hover, probe, reading) {
    const { canvas, pen, box } = this;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    if (canvas.width !== width || canvas.height !== height)
      [canvas.width, canvas.height] = [width, height];
    const free = 1 - 2 * ROOM;
    this.scale = Math.min(
      (free * width) / (box.right - box.left),
      (free * height) / Math.max(box.high - box.low, 1e-3),
    );
    pen.clearRect(0, 0, width, height);
    this.#grid(width, height, ratio);
    const [fill, rim] = [colour(canvas, "--post"), colour(canvas, "--faint")];
    drawPosts(this, rope.contact?.holds.map(({ post }) => post) ?? [], fill, rim, ratio);
    const places = this.#project(rope).map((place) => this.shown(place));
    pen.lineCap = "round";
    pen.lineJoin = "round";
    for (const [first, last] of ropes) {
      this.#stroke(places.slice(first, last + 1), 7 * ratio, colour(canvas, "--rim"));
      for (let j = first; j < last; j++) {
        const share = Math.min(Math.max(tension[j] / this.largest, 0), 1) || 0;
        const shade = this.map[Math.round(share * (this.map.length - 1))];
        this.#stroke([places[j], places[j + 1]], 4.5 * ratio, shade);
      }
    }
    drawReading(this, reading, places, colour(canvas, "--ink"), ratio);
    this.#nodes(rope, places, ratio, hover);
    pen.fillStyle = colour(canvas, "--accent");
    pen.beginPath();
    pen.arc(...places[probe], 5 * ratio, 0, 2 * Math.PI);
    pen.fill();
  }

  /** @param {[number, number][]} places @param {number} width @param {string} style */
  #stroke(places, width, style) {
    const { pen } = this;
    pen.lineWidth = width;
    pen.strokeStyle = style;
    pen.beginPath();
    for (const [i, [x, y]] of places.entries()) {
      if (!Number.isFinite(x + y)) continue;
      if (i) pen.lineTo(near(x), near(y));
      else pen.moveTo(near(x), near(y));
    }
    pen.stroke();
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  #grid(width, height, ratio) {
    const { pen, canvas } = this;
    /** @param {number} scale */
    const spacing = (scale) => {
      const rough = (90 * ratio) / scale;
      const power = 10 ** Math.floor(Math.log10(rough));
      return power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
    };
    /** @param {number} low @param {number} high @param {number} step */
    const marks = (low, high, step) =>
      Array.from(
        { length: Math.max(Math.floor(high / step) - Math.ceil(low / step) + 1, 0) },
        (_, i) => Number(((Math.ceil(low / step) + i) * step).toPrecision(12)) + 0,
      );
    const [left, top] = this.place(0, 0);
    const [right, bottom] = this.place(width, height);
    pen.lineWidth = ratio;
    pen.strokeStyle = colour(canvas, "--grid");
    pen.fillStyle = colour(canvas, "--faint");
    pen.font = `${11 * ratio}px system-ui, sans-serif`;
    for (const x of marks(left, right, spacing(this.scale))) {
      const [px] = this.shown([x, 0]);
      this.#stroke(
        [
          [px, 0],
          [px, height],
        ],
        ratio,
        colour(canvas, "--grid"),
      );
      pen.fillText(`${Number(x.toPrecision(6))} m`, px + 4 * ratio, height - 6 * ratio);
    }
    for (const y of marks(bottom, top, spacing(this.tall * this.scale))) {
      const [, py] = this.shown([0, y]);
      this.#stroke(
        [
          [0, py],
          [width, py],
        ],
        ratio,
        colour(canvas, "--grid"),
      );
      pen.fillText(`${Number(y.toPrecision(6))} m`, 4 * ratio, py - 4 * ratio);
    }
  }

  /** @param {Rope} rope @param {[number, number][]} places @param {number} ratio @param {number | null} hover */
  #nodes(rope, places, ratio, hover) {
    const { pen, canvas } = this;
    pen.fillStyle = colour(canvas, "--anchor");
    for (const anchor of rope.anchors) {
      if (!anchor.held) continue;
      const [x, y] = places[anchor.node];
      pen.fillRect(x - 6 * ratio, y - 6 * ratio, 12 * ratio, 12 * ratio);
    }
    const typical = [...rope.mass].sort((a, b) => a - b)[(rope.n - 1) >> 1];
    for (const [i, mass] of rope.mass.entries()) {
      if (mass < 4 * typical) continue; // a load
      pen.beginPath();
      pen.arc(...places[i], 9 * ratio, 0, 2 * Math.PI);
      pen.fill();
    }
    const ring = rope.hand?.node ?? hover;
    if (ring === null || ring === undefined) return;
    pen.lineWidth = 2.5 * ratio;
    pen.strokeStyle = colour(canvas, "--accent");
    pen.beginPath();
    pen.arc(...places[ring], 11 * ratio, 0, 2 * Math.PI);
    pen.stroke();
  }
}
