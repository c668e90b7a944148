// Where ropes have parted by the time that is shown: they are drawn in pieces.

import { gapsAt, shapeOf } from "./view/copies.js";

/** @typedef {import("./stage.js").Stage} Stage */
/** @typedef {import("./source/protocol.js").Layout} Layout */

export class Gaps {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
    /** @type {number[][]} segments of each variant */ this.now = [];
    this.key = "";
  }

  /** Draw what a layout and a time ask for. @param {Layout} layout @param {number} time [s] */
  take(layout, time) {
    const now = gapsAt(layout, time);
    const key = `${layout.layout}: ${now.join("; ")}`;
    if (key === this.key) return;
    [this.now, this.key] = [now, key];
    this.stage.renderer.setShape(shapeOf(layout, now));
  }
}
