// Buttons for the camera: show everything, and look along the axes.

import { button, h } from "./dom.js";

/** @typedef {import("../stage.js").Stage} Stage */

export class Views {
  /** @param {Stage} stage @param {HTMLElement} host */
  constructor(stage, host) {
    this.stage = stage;
    const axis = (/** @type {"X" | "Y" | "Z"} */ name, /** @type {0 | 1 | 2} */ k) =>
      h(
        "button",
        {
          type: "button",
          className: "plain letter",
          id: `view-${name.toLowerCase()}`,
          title: `Look along the ${name.toLowerCase()} axis; again: from the other side`,
          "aria-label": `Look along the ${name.toLowerCase()} axis`,
          onclick: () => this.along(k),
        },
        name,
      );
    host.append(
      h(
        "div",
        { className: "toolbar views", role: "toolbar", "aria-label": "View" },
        button("fit", "Show everything", () => stage.fit(), { key: "F", id: "view-fit" }),
        axis("X", 0),
        axis("Y", 1),
        axis("Z", 2),
        h(
          "button",
          {
            type: "button",
            className: "plain letter",
            id: "view-home",
            title: "The first view",
            "aria-label": "The first view",
            onclick: () => this.home(),
          },
          "3D",
        ),
      ),
    );
  }

  /** @param {0 | 1 | 2} axis */
  along(axis) {
    const { camera } = this.stage;
    const sign = axis === 1 && Math.abs(camera.up[1]) < 0.9 ? -1 : 1; // x to the right
    const first = camera.along(axis, sign);
    const there = Math.abs(camera.toward[axis] - sign) < 1e-3;
    this.stage.fit(there ? camera.along(axis, sign === 1 ? -1 : 1) : first);
  }

  home() {
    const { layout } = this.stage.session;
    if (!layout) return;
    this.stage.fly(this.stage.framing.first(layout));
  }
}
