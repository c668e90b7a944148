// Labels in the scene: forces in newtons, beside their arrows.

import { h } from "./dom.js";

/** @typedef {import("../stage.js").Stage} Stage */

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
    /** @type {[number, number][]} */ const taken = [];
    this.pool.forEach((element, i) => {
      const label = labels[i];
      const [x, y, depth] = label ? this.stage.camera.project(...label.at) : [0, 0, -1];
      const crowded = taken.some(([tx, ty]) => Math.abs(tx - x) < 56 && Math.abs(ty - y) < 18);
      const shown = label !== undefined && depth > 0 && !crowded;
      if (element.hidden === shown) element.hidden = !shown;
      if (!shown) return;
      taken.push([x, y]);
      if (element.textContent !== label.text) element.textContent = label.text;
      if (element.className !== label.kind) element.className = label.kind;
      element.style.transform = `translate(${Math.round(x) + 8}px, ${Math.round(y) - 10}px)`;
    });
  }
}
