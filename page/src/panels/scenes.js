// The menu of scenes: a small picture and a sentence each.

import { dialog, h } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */

export class Scenes {
  /** @param {Session} session @param {HTMLElement} host */
  constructor(session, host) {
    this.session = session;
    this.list = h("div", { className: "scene-themes" });
    this.window = dialog("Scenes", "scenes", this.list);
    host.append(this.window);
    session.on("presets", () => this.fill());
    session.on("layout", () => this.mark());
  }

  open() {
    this.mark();
    this.window.showModal();
  }

  fill() {
    const { presets } = this.session;
    const themes = [...new Set(presets.map(({ theme }) => theme))];
    this.list.replaceChildren(
      ...themes.flatMap((theme) => [
        h("h3", {}, theme),
        h(
          "div",
          { className: "scene-list" },
          ...presets.filter((one) => one.theme === theme).map((one) => this.card(one)),
        ),
      ]),
    );
    this.mark();
  }

  /** @param {import("../source/protocol.js").Preset} preset */
  card(preset) {
    const { base } = this.session.source;
    const picture = h("div", { className: "picture" });
    if (preset.picture && base) {
      // As a mask, so that the lines take the theme's colour.
      picture.style.maskImage = `url("${new URL(base + preset.picture, location.href.split(/[?#]/)[0]).href}")`;
    }
    return h(
      "button",
      {
        type: "button",
        className: "scene-card",
        data: { preset: preset.name },
        onclick: () => this.choose(preset.name),
      },
      picture,
      h("strong", {}, preset.title),
      h("span", {}, preset.sentence),
    );
  }

  mark() {
    const now = this.session.layout?.scene.preset;
    for (const card of this.list.querySelectorAll(".scene-card")) {
      if (card instanceof HTMLElement) card.classList.toggle("now", card.dataset.preset === now);
    }
  }

  /** @param {string} preset */
  choose(preset) {
    this.window.close();
    this.session.tell({ type: "scene", preset });
  }
}
