// What the hand does to a rope: the tools at the side and the menu at the pointer.

import { lead, turnable } from "../input/body.js";
import { ofFirst } from "../input/counterpart.js";
import { figures } from "../view/range.js";
import { times } from "../view/vector.js";
import { button, h, popup, unfolder } from "./dom.js";
import { noNumber, readNumber } from "./scale.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../input/pointer.js").Pointer} Pointer */
/** @typedef {import("../input/pointer.js").Tool} Tool */
/** @typedef {import("../input/pick.js").Hit} Hit */
/** @typedef {import("../input/pick.js").BodyHit} BodyHit */

const TOOLS =
  /** @type {[Tool, "hand" | "pin" | "cut" | "load" | "tie" | "kick" | "follow", string, string][]} */ ([
    ["hand", "hand", "Hand: drag anchors and ropes", ""],
    ["pin", "pin", "Pin: hold a node where it is, or let it go again", "pin"],
    ["cut", "cut", "Cut a segment", "cut"],
    ["load", "load", "Hang a load on a node", "load"],
    ["tie", "tie", "Tie two points together: press one, then the other", "tie"],
    ["kick", "kick", "Kick: draw the velocity from a node", "kick"],
    ["follow", "follow", "Follow a node: its trail and its graphs", ""],
  ]);

export class Tools {
  /** @param {Viewport} viewport @param {HTMLElement} host @param {(node: number) => void} follow
   * @param {(text: string, kind?: "note" | "fault") => () => void} say returns what takes the words away */
  constructor(viewport, host, follow, say) {
    this.viewport = viewport;
    this.host = host;
    this.follow = follow;
    this.say = say;
    /** @type {Pointer | null} */ this.pointer = null;
    this.unsay = () => {}; // take "choose the point" away
    this.mass = 1;
    /** @type {Map<Tool, HTMLButtonElement>} */ this.buttons = new Map();
    this.bar = h("div", { className: "toolbar", role: "toolbar", "aria-label": "Tools" });
    for (const [tool, name, title] of TOOLS) {
      const one = button(name, title, () => this.choose(tool), { id: `tool-${tool}` });
      this.buttons.set(tool, one);
      this.bar.append(one);
    }
    this.massField = h("input", {
      type: "text",
      inputMode: "decimal",
      value: "1",
      id: "load-mass",
      "aria-label": "Mass to hang [kg]",
      onchange: () => {
        const typed = this.massField.value;
        const mass = readNumber(typed);
        this.refuse(typed, "kg", mass < 0 ? "a mass must not be negative" : "");
        if (mass >= 0) this.mass = mass;
        this.massField.value = String(this.mass);
        this.massField.blur(); // the keys are the rope's again
      },
    });
    this.massBox = h("label", { className: "mass", hidden: true }, this.massField, "kg");
    this.pullField = h("input", {
      type: "text",
      inputMode: "decimal",
      value: "",
      placeholder: "auto",
      id: "pull-limit",
      title: "Pull with at most this force; empty: 20 times the rope's weight",
      "aria-label": "Largest force of a pull [N]; empty: 20 times the rope's weight",
      onchange: () => this.limitPull(),
    });
    this.pullBox = h("label", { className: "mass pull", hidden: true }, this.pullField, "N");
    this.bar.append(this.massBox, this.pullBox, unfolder(this.bar, "All tools"));
    host.append(this.bar);
    viewport.session.on("hello", () => this.refresh());
    this.refresh();
  }

  refresh() {
    for (const [tool, , , command] of TOOLS) {
      const one = this.buttons.get(tool);
      if (one) one.hidden = command !== "" && !this.viewport.session.can(command);
    }
    this.choose(this.pointer?.tool ?? "hand");
  }

  /** @param {Tool} tool */
  choose(tool) {
    if (this.pointer) this.pointer.tool = tool;
    this.tieNone();
    for (const [name, one] of this.buttons) one.setAttribute("aria-pressed", String(name === tool));
    this.massBox.hidden = tool !== "load";
    this.pullBox.hidden = tool !== "hand" || !this.viewport.session.can("grab");
    this.host.dataset.tool = tool;
  }

  limitPull() {
    const typed = this.pullField.value;
    const newtons = readNumber(typed);
    this.refuse(typed, "N", newtons <= 0 ? "must be positive; leave it empty for 20 weights" : "");
    const limit = newtons > 0 ? newtons : null;
    if (this.pointer) this.pointer.limit = limit;
    this.pullField.value = limit === null ? "" : String(limit);
    this.pullField.blur(); // the keys are the rope's again
  }

  /** Say what is wrong with what was typed. @param {string} typed @param {string} unit of the field
   * @param {string} rule that it breaks as a number, "" for none */
  refuse(typed, unit, rule) {
    const fault = rule ? `${typed.trim()}: ${rule}` : noNumber(typed, unit);
    if (fault) this.say(fault, "fault");
  }

  /** Use a tool on what was pressed. @param {Tool} tool @param {Hit} hit */
  use(tool, hit) {
    const { session } = this.viewport;
    const { node } = ofFirst(session.layout, hit);
    if (tool === "pin") {
      if (hit.kind === "anchor") session.tell({ type: "unpin", anchor: hit.anchor });
      else session.tell({ type: "pin", node });
    } else if (tool === "cut") this.cut(hit);
    else if (tool === "load") session.tell({ type: "load", node, mass: this.mass });
    else if (tool === "follow") this.follow(node);
    else if (tool === "tie") this.tie(hit);
  }

  /** Take a point to tie: the first of two, or the second. @param {Hit} hit */
  tie(hit) {
    const { session, marks } = this.viewport;
    const first = marks.tying;
    marks.dirty = true;
    if (!first) {
      marks.tying = hit;
      const name = this.nodeName(hit);
      this.unsay = this.say(`${name}: choose the point to tie it to; Esc lets it be`);
      return;
    }
    this.tieNone();
    const [one, other] = [first, hit].map((each) => ofFirst(session.layout, each).node);
    session.tell({ type: "tie", node: one, other });
  }

  /** Tie nothing after all. */
  tieNone() {
    const { marks } = this.viewport;
    if (marks.tying) marks.dirty = true;
    marks.tying = null;
    this.unsay();
  }

  /** Cut the joint, or the segment where there is none. @param {Hit} hit */
  cut(hit) {
    const { session } = this.viewport;
    const { joint } = hit;
    const { segment } = ofFirst(session.layout, hit);
    if (joint !== undefined && session.can("untie")) session.tell({ type: "untie", joint });
    else session.tell({ type: "cut", segment });
  }

  /** The menu of a body. @param {BodyHit} hit @param {number} x @param {number} y */
  bodyMenu({ obstacle }, x, y) {
    const { viewport } = this;
    const turn = (/** @type {number} */ part) => () =>
      lead(viewport, obstacle, null, viewport.solids.angleOf(obstacle) + part * Math.PI, true);
    const turns = turnable(viewport, obstacle);
    const items = [
      { label: "Turn it by 15° (Page Up)", press: turn(1 / 12), disabled: !turns },
      { label: "Turn it back by 15° (Page Down)", press: turn(-1 / 12), disabled: !turns },
    ];
    popup(this.host, x, y, items, `Obstacle ${obstacle}`);
  }

  /** The menu of a node or anchor, of a body, or of empty space. @param {Hit | BodyHit | null} hit
   * @param {number} x @param {number} y */
  menu(hit, x, y) {
    const { session, marks } = this.viewport;
    if (hit?.kind === "obstacle") {
      this.bodyMenu(hit, x, y);
      return;
    }
    if (!hit) {
      popup(this.host, x, y, [
        { label: "Show everything", press: () => this.viewport.fit() },
        {
          label: "Let go of everything",
          press: () => session.send({ type: "let_go" }),
          disabled: !session.can("let_go"),
        },
      ]);
      return;
    }
    const { node, segment } = ofFirst(session.layout, hit);
    const loads = session.layout?.variants[0].loads.filter((load) => load.index === node) ?? [];
    const hung = loads.reduce((sum, load) => sum + load.mass, 0);
    const up = this.viewport.camera.up;
    const items = [
      hit.kind === "anchor"
        ? {
            label: "Let this node go",
            command: "unpin",
            press: () => session.tell({ type: "unpin", anchor: hit.anchor }),
          }
        : {
            label: "Pin it here",
            command: "pin",
            press: () => session.tell({ type: "pin", node }),
          },
      ...(hit.joint !== undefined
        ? [{ label: `Cut the joint ${hit.joint}`, command: "untie", press: () => this.cut(hit) }]
        : []),
      {
        label: "Cut here",
        command: "cut",
        press: () => session.tell({ type: "cut", segment }),
      },
      ...[1, 10].map((mass) => ({
        label: `Hang ${mass} kg here`,
        command: "load",
        press: () => session.tell({ type: "load", node, mass }),
      })),
      ...(hung > 0
        ? [
            {
              label: `Take the load off (${figures(hung)} kg)`,
              command: "load",
              press: () => session.tell({ type: "load", node, mass: 0 }),
            },
          ]
        : []),
      {
        label: marks.tying ? `Tie ${this.nodeName(marks.tying)} to it` : "Tie it to another point",
        command: "tie",
        press: () => this.tie(hit),
      },
      {
        label: "Kick it up (5 m/s)",
        command: "kick",
        press: () => session.tell({ type: "kick", node, velocity: times(up, 5) }),
      },
    ];
    const allowed = items.filter((item) => session.can(item.command));
    const followed = marks.followed.has(node);
    popup(
      this.host,
      x,
      y,
      [
        ...allowed,
        {
          label: followed ? "Stop following" : "Follow: trail and graphs",
          press: () => this.follow(node),
        },
      ],
      this.nodeName(hit),
    );
  }

  /** @param {Hit} hit */
  nodeName(hit) {
    if (hit.kind === "anchor") return `Anchor ${hit.anchor}`;
    const ropes = this.viewport.session.layout?.variants[hit.variant].ropes ?? [];
    const rope = ropes.find(({ first, nodes }) => hit.node >= first && hit.node < first + nodes);
    if (!rope) return `Node ${hit.node}`;
    if (hit.joint !== undefined) return `Joint ${hit.joint}`;
    return `Node ${hit.node - rope.zero}${ropes.length > 1 ? ` of ${rope.name}` : ""}`;
  }
}
