// The phase plane of one node: its height, and how fast that changes from frame to frame.

import { figures, quantity } from "../view/range.js";
import { h } from "../panels/dom.js";

const MARGIN = { left: 46, right: 10, top: 8, bottom: 34 };

export class PhasePlane {
  /** @param {HTMLElement} host */
  constructor(host) {
    this.canvas = h("canvas", { className: "phase" });
    this.host = host;
    host.append(this.canvas);
  }

  resize() {
    const ratio = devicePixelRatio || 1;
    const { clientWidth, clientHeight } = this.host;
    const [width, height] = [clientWidth * ratio, clientHeight * ratio].map(Math.round);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
  }

  /** @param {Float64Array} times @param {Float64Array} heights @param {string} colour */
  show(times, heights, colour) {
    const context = this.canvas.getContext("2d");
    if (!context) return;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [this.canvas.width / ratio, this.canvas.height / ratio];
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    /** @type {[number, number][]} */
    const points = [];
    for (let i = 1; i + 1 < times.length; i++) {
      const speed = (heights[i + 1] - heights[i - 1]) / (times[i + 1] - times[i - 1]);
      if (Number.isFinite(speed)) points.push([heights[i], speed]);
    }
    const style = getComputedStyle(document.documentElement);
    const faint = style.getPropertyValue("--faint").trim();
    context.font = "11px system-ui, sans-serif";
    context.fillStyle = faint;
    if (points.length < 3) {
      context.fillText("Follow a node to see its phase plane.", 12, 24);
      return;
    }
    const [x0, x1] = span(points.map(([x]) => x));
    const [y0, y1] = span(points.map(([, y]) => y));
    const inside = {
      w: width - MARGIN.left - MARGIN.right,
      h: height - MARGIN.top - MARGIN.bottom,
    };
    const across = (/** @type {number} */ x) => MARGIN.left + ((x - x0) / (x1 - x0)) * inside.w;
    const down = (/** @type {number} */ y) => MARGIN.top + (1 - (y - y0) / (y1 - y0)) * inside.h;
    context.strokeStyle = style.getPropertyValue("--line").trim();
    context.strokeRect(MARGIN.left, MARGIN.top, inside.w, inside.h);
    if (y0 < 0 && y1 > 0) {
      context.beginPath();
      context.moveTo(MARGIN.left, down(0));
      context.lineTo(MARGIN.left + inside.w, down(0));
      context.stroke();
    }
    context.textAlign = "right";
    for (const y of [y0, y1])
      context.fillText(
        figures(Number(y.toPrecision(2))),
        MARGIN.left - 4,
        down(y) + (y === y0 ? 0 : 9),
      );
    context.textAlign = "left";
    context.fillText(figures(Number(x0.toPrecision(3))), MARGIN.left, height - 20);
    context.textAlign = "right";
    context.fillText(quantity(Number(x1.toPrecision(3)), "m"), width - MARGIN.right, height - 20);
    context.textAlign = "center";
    context.fillText("height; upward velocity in m/s", MARGIN.left + inside.w / 2, height - 5);
    context.textAlign = "left";
    context.strokeStyle = colour;
    context.lineWidth = 1.4;
    context.beginPath();
    for (const [x, y] of points) context.lineTo(across(x), down(y));
    context.stroke();
    const [x, y] = points[points.length - 1];
    context.fillStyle = colour;
    context.beginPath();
    context.arc(across(x), down(y), 4, 0, 2 * Math.PI);
    context.fill();
  }
}

/** @param {number[]} values @returns {[number, number]} */
function span(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  const room = Math.max(1e-6, 0.06 * (high - low));
  return [low - room, high + room];
}
