// Where ropes have parted by the time that is shown: they are drawn in pieces.

import { gapsAt, shapeOf } from "./view/copies.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/protocol.js").Layout} Layout */

export class Gaps {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    /** @type {number[][]} segments of each variant */ this.now = [];
    this.key = "";
    /** @type {import("./render/view.js").Shape | null} */ this.drawn = null;
  }

  /** Draw what a layout and a time ask for. @param {Layout} layout @param {number} time [s] */
  take(layout, time) {
    const now = gapsAt(layout, time);
    const key = `${layout.layout}: ${now.join("; ")}`;
    if (key === this.key) return;
    [this.now, this.key] = [now, key];
    this.drawn = shapeOf(layout, now);
    this.viewport.renderer.setShape(this.drawn);
  }

  /** The ropes in pieces, as they are drawn. @param {Layout} layout */
  shape(layout) {
    return this.drawn ?? shapeOf(layout);
  }
}
