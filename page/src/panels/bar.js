// The bar at the top: the scene's name and menu, tour, compare, keep, help, theme, panel.

import { button, h, icon } from "./dom.js";

/** @typedef {Record<"scenes" | "tour" | "compare" | "help" | "theme" | "panel", () => void> &
 *   {keep: (at: HTMLElement) => void}} BarActions */

export class Bar {
  /** @param {HTMLElement} host @param {BarActions} act */
  constructor(host, act) {
    this.name = h("span", { className: "scene-name" }, "…");
    this.choose = h(
      "button",
      {
        type: "button",
        className: "scene-choice",
        id: "open-scenes",
        title: "Scenes",
        onclick: act.scenes,
      },
      this.name,
      icon("down"),
    );
    this.tour = button("tour", "Guided tour", act.tour, { words: "Tour", id: "open-tour" });
    this.compare = button("compare", "Compare copies", act.compare, {
      words: "Compare",
      id: "open-compare",
    });
    this.keep = button("keep", "Save, export, link", () => act.keep(this.keep), {
      words: "Keep",
      id: "open-keep",
    });
    this.panel = button("panel", "Panel of constants", act.panel, { key: "P", id: "toggle-panel" });
    host.append(
      h("strong", { className: "brand" }, "Ropewalk"),
      this.choose,
      h("span", { className: "gap" }),
      this.tour,
      this.compare,
      this.keep,
      button("help", "Help", act.help, { key: "H", id: "open-help" }),
      button("theme", "Light or dark", act.theme, { key: "T", id: "toggle-theme" }),
      this.panel,
    );
  }

  /** @param {string} name of the scene */
  show(name) {
    this.name.textContent = name;
    this.choose.setAttribute("aria-label", `Scene: ${name}. Choose another`);
    document.title = `${name} – Ropewalk`;
  }
}
