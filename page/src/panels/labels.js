// Labels in the scene: forces in newtons, beside their arrows.

import { h } from "./dom.js";

/** @typedef {import("../stage.js").Stage} Stage */
/** @typedef {import("../marks.js").Label} Label */
/** @typedef {{x: number, y: number, width: number}} Place [CSS pixels] */

const LETTER = 7.4; // of the labels' font, wide [CSS pixels]
const HEIGHT = 20;
const APART = 5; // from the tip

export class Labels {
  /** @param {Stage} stage @param {HTMLElement} host */
  constructor(stage, host) {
    this.stage = stage;
    this.box = h("div", { className: "labels", "aria-hidden": "true" });
    /** @type {HTMLElement[]} */ this.pool = [];
    host.append(this.box);
    stage.afterDraw.push(() => this.refresh());
  }

  refresh() {
    const { labels } = this.stage.marks;
    while (this.pool.length < labels.length) {
      const label = h("span", {});
      this.pool.push(label);
      this.box.append(label);
    }
    /** @type {Place[]} */ const taken = [];
    this.pool.forEach((element, i) => {
      const label = labels[i];
      const place = label ? this.place(label) : null;
      const crowded = taken.some((other) => place && overlap(place, other));
      if (element.hidden === (place !== null && !crowded)) element.hidden = !element.hidden;
      if (!place || crowded) return;
      taken.push(place);
      if (element.textContent !== label.text) element.textContent = label.text;
      if (element.className !== label.kind) element.className = label.kind;
      element.style.transform = `translate(${Math.round(place.x)}px, ${Math.round(place.y)}px)`;
    });
  }

  /** Beyond the arrow's tip, in its direction, and inside the scene. @param {Label} label
   * @returns {Place | null} */
  place({ from, at, text }) {
    const { camera } = this.stage;
    const [x, y, depth] = camera.project(...at);
    if (!(depth > 0)) return null;
    const [fx, fy] = camera.project(...from);
    return placeLabel([x, y], [x - fx, y - fy], LETTER * text.length + 14, [
      camera.width,
      camera.height,
    ]);
  }
}

/** The upper left corner of a label at an arrow's tip. @param {number[]} tip @param {number[]} way
 * @param {number} width @param {number[]} room @returns {Place} */
export function placeLabel([x, y], [dx, dy], width, room) {
  const size = Math.hypot(dx, dy);
  const [ux, uy] = size > 1 ? [dx / size, dy / size] : [1, 0];
  const reach =
    APART + Math.min(width / 2 / Math.abs(ux || 1e-9), HEIGHT / 2 / Math.abs(uy || 1e-9));
  const inside = (/** @type {number} */ value, /** @type {number} */ most) =>
    Math.max(2, Math.min(value, most - 2));
  const wanted = x + ux * reach - width / 2;
  const across = inside(wanted, room[0] - width);
  const pushed = Math.abs(across - wanted) > 4; // then above the arrow, which it would cover
  const down = y + uy * reach - HEIGHT / 2 - (pushed ? HEIGHT : 0);
  return { x: across, y: inside(down, room[1] - HEIGHT), width };
}

/** @param {Place} one @param {Place} other */
function overlap(one, other) {
  const apart = one.x < other.x ? other.x - one.x - one.width : one.x - other.x - other.width;
  return apart < 0 && Math.abs(one.y - other.y) < HEIGHT;
}
