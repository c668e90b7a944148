// Keeping things: the run, tables, a picture, the scene, a page that replays it, the link.

import { download, popup } from "./dom.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("./notices.js").Notices} Notices */

const FILES = /** @type {Record<string, string>} */ ({
  "nodes.csv": "Table of nodes (CSV)",
  "energies.csv": "Table of energies (CSV)",
  "tension.csv": "Table of tension (CSV)",
  "scene.toml": "Scene (TOML)",
  "page.html": "Page that replays it (HTML)",
});

export class Keep {
  /** @param {Viewport} viewport @param {HTMLElement} host @param {Notices} notices */
  constructor(viewport, host, notices) {
    this.viewport = viewport;
    this.host = host;
    this.notices = notices;
  }

  /** @param {HTMLElement} at the button that opens the menu */
  open(at) {
    const { session } = this.viewport;
    const { base } = session.source;
    const { hello } = session;
    const items = [
      {
        label: "Save the run",
        id: "keep-save",
        hint: hello?.folder ?? "",
        show: session.can("save") && !session.gone,
        press: () => this.save(),
      },
      {
        label: "Copy the link to this set-up",
        id: "keep-link",
        show: session.can("scene") && !session.gone, // it leads to this server
        press: () => this.copyLink(),
      },
      {
        label: "Copy the command line",
        id: "keep-command",
        show: session.can("scene") && commandOf(session.status?.address) !== "",
        press: () => this.copyCommand(),
      },
      { label: "Picture (PNG)", id: "keep-png", show: true, press: () => this.picture() },
      ...(hello?.exports ?? []).map((name) => ({
        label: FILES[name] ?? name,
        id: `keep-${name.replace(".", "-")}`,
        show: !session.gone,
        press: () => this.file(`${base}export/${name}`, name),
      })),
    ];
    const box = at.getBoundingClientRect();
    const room = this.host.getBoundingClientRect();
    popup(
      this.host,
      box.right - room.left - 240,
      box.bottom - room.top + 4,
      items.filter(({ show }) => show),
      "Keep",
    );
  }

  async save() {
    await this.viewport.session.tell({ type: "save" }); // "saved" says where
  }

  /** Fetch a file of the server, so that a refusal can be told. @param {string} address
   * @param {string} name */
  async file(address, name) {
    this.notices.say(`Making ${name} …`);
    try {
      const answer = await fetch(address);
      if (!answer.ok) throw new Error((await answer.text()).trim() || "it cannot be made here");
      const url = URL.createObjectURL(await answer.blob());
      download(url, name);
      setTimeout(() => URL.revokeObjectURL(url), 10_000);
      this.notices.say(`${name} is in your downloads.`);
    } catch (error) {
      const gone = error instanceof TypeError; // what fetch throws without an answer
      const why = gone ? "the server is not there" : error instanceof Error ? error.message : error;
      this.notices.say(`${name}: ${why}`, "fault");
    }
  }

  /** The scene as it is drawn, with twice the pixels where that is possible. */
  picture() {
    this.viewport.draw(true); // toBlob reads what was drawn in this same task
    this.viewport.renderer.canvas.toBlob((blob) => {
      if (!blob) return;
      const url = URL.createObjectURL(blob);
      download(url, `${fileName(this.viewport.session.layout?.scene.name ?? "rope")}.png`);
      setTimeout(() => URL.revokeObjectURL(url), 10_000);
    });
  }

  async copyLink() {
    const status = this.viewport.session.status;
    const address = `${location.href.split("#")[0]}${status?.address ? `#${status.address}` : ""}`;
    await this.copy(
      address,
      "The link is copied. It opens this scene with these constants, as long as this view runs.",
    );
  }

  /** What starts this set-up when the view has ended, on another computer, too. */
  async copyCommand() {
    const command = commandOf(this.viewport.session.status?.address);
    await this.copy(command, "The command is copied. In a terminal it opens this set-up again.");
  }

  /** @param {string} text @param {string} done what to say then */
  async copy(text, done) {
    try {
      await navigator.clipboard.writeText(text);
      this.notices.say(done);
    } catch {
      this.notices.say(text); // no clipboard: it can be copied from here
    }
  }
}

/** The command that opens a set-up; "" where its scene is only in the program that shows it.
 * @param {string | undefined} address */
export function commandOf(address) {
  const scene = new URLSearchParams(address ?? "");
  const named = scene.get("toml") || !["", "start"].includes(scene.get("scene") ?? "");
  if (!address || !named) return "";
  return `ropewalk view --at "${address}"`;
}

/** @param {string} name */
export const fileName = (name) =>
  name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "") || "rope";
