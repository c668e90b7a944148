// The help panel: what mouse, fingers and keys do.

import { dialog, h } from "./dom.js";

const HAND = [
  [
    "Drag an anchor (a ring)",
    "it follows the hand, in the plane of a flat scene, else parallel to the screen; at most 30 m/s in the rope's time",
  ],
  [
    "Drag the rope",
    "by a soft spring; its force is shown in newtons, and below the tools one may limit it",
  ],
  [
    "Drag an obstacle",
    "it is moved in the plane of the screen, and takes along what lies on it; with Shift it is turned",
  ],
  ["Let go in motion", "throws it: it has the hand's velocity"],
  ["Hold Shift at the end of a drag", "the spring stays; double-click on empty space lets go"],
  ["Right-click, or a long press", "pin, cut, load, tie, kick, follow; of an obstacle: turn it"],
  [
    "Tie",
    "press two points, or drag from one to the other: hands bring them together at 1 m/s and tie them",
  ],
  ["Drag empty space", "turn the view; with Shift, the right button or near a rope: shift it"],
  ["Wheel, or two fingers", "zoom"],
];
const KEYS = [
  ["← → ↑ ↓", "move the first anchor at 3 m/s"],
  ["Home, End", "move it away from you, towards you"],
  ["A D W S Q E", "the same for the second anchor"],
  ["J L I K U O", "the same for the third anchor"],
  ["Tab, Enter", "on the scene: the next place on the ropes, or obstacle, and its menu"],
  ["Page Up, Page Down", "turn the obstacle that Tab has chosen; arrow keys, Home and End move it"],
  ["Space", "play or pause; paused it stays so, over a reset or another scene"],
  [".", "one step"],
  ["R", "reset to time zero"],
  ["Ctrl Z", "undo the last cut, pin, load, tie, kick, reset or move of an obstacle"],
  ["F", "show everything"],
  ["G", "graphs"],
  ["P", "panel of constants"],
  ["T", "light or dark"],
  ["H or ?", "this help"],
];

export class Help {
  /** @param {HTMLElement} host */
  constructor(host) {
    const rows = (/** @type {string[][]} */ list, /** @type {"kbd" | "span"} */ tag) =>
      h(
        "dl",
        {},
        ...list.flatMap(([what, does]) => [h("dt", {}, h(tag, {}, what)), h("dd", {}, does)]),
      );
    this.version = h("p", { className: "faint" });
    this.window = dialog(
      "Help",
      "help",
      h(
        "div",
        { className: "columns" },
        h("section", {}, h("h3", {}, "Hand"), rows(HAND, "span")),
        h("section", {}, h("h3", {}, "Keys"), rows(KEYS, "kbd")),
      ),
      this.version,
    );
    host.append(this.window);
  }

  open() {
    if (this.window.open) this.window.close();
    else this.window.showModal();
  }
}
