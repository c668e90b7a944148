// Buttons for the camera: show everything, and look along the axes.

import { button, h, unfolder } from "./dom.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */

export class Views {
  /** @param {Viewport} viewport @param {HTMLElement} host */
  constructor(viewport, host) {
    this.viewport = viewport;
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
      (this.bar = h(
        "div",
        { className: "toolbar views", role: "toolbar", "aria-label": "View" },
        button("fit", "Show everything", () => viewport.fit(), { key: "F", id: "view-fit" }),
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
      )),
    );
    this.bar.append(unfolder(this.bar, "All views"));
  }

  /** @param {0 | 1 | 2} axis */
  along(axis) {
    const { camera } = this.viewport;
    const sign = axis === 1 && Math.abs(camera.up[1]) < 0.9 ? -1 : 1; // x to the right
    const first = camera.along(axis, sign);
    const there = Math.abs(camera.toward[axis] - sign) < 1e-3;
    this.viewport.fit(there ? camera.along(axis, sign === 1 ? -1 : 1) : first);
  }

  home() {
    const { layout } = this.viewport.session;
    if (!layout) return;
    this.viewport.fly(this.viewport.framing.first(layout));
  }
}
