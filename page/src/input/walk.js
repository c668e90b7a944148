// The keyboard's way to the ropes: Tab goes from place to place, Enter opens the menu there, and what is there is said.

import { between, scalar } from "../source/frame.js";
import { quantity } from "../view/range.js";
import { BodyKeys, turnable } from "./body.js";
import { placeOf } from "./pick.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../source/protocol.js").Layout} Layout */
/** @typedef {import("../source/frame.js").Frame} Frame */
/** @typedef {import("./pick.js").Hit} Hit */
/** @typedef {import("./pick.js").BodyHit} BodyHit */

const BETWEEN = 8; // places on a rope, its ends not counted
const MOST = 40;
const LITTLE = 1e-9; // what rounding leaves of nothing [N], [m]

/** A quantity, in which what rounding leaves of nothing is nothing. @param {number} value @param {string} unit */
const heard = (value, unit) => quantity(Math.abs(value) < LITTLE ? 0 : value, unit);

/** Where Tab stops: anchors that hold, loads, and some nodes of each rope, from end to end.
 * @param {Layout} layout @param {Frame} frame @returns {Hit[]} */
export function stopsOf(layout, frame) {
  const [variant] = layout.variants;
  const { anchors } = frame.parts[0];
  const held = new Map(
    variant.anchors
      .filter((_, a) => anchors[10 * a + 9] > 0.5)
      .map((anchor) => [anchor.index, anchor.name]),
  );
  const loads = variant.loads.map(({ index }) => index);
  const joints = variant.joints ?? [];
  const tied = joints.map(({ nodes }) => nodes[0]);
  const between = variant.ropes.length > 4 ? 0 : BETWEEN;
  return variant.ropes
    .flatMap((rope) => {
      const last = rope.nodes - 1;
      const some = Array.from({ length: between + 2 }, (_, i) =>
        Math.round((i * last) / (between + 1)),
      ).map((node) => rope.first + node);
      const inside = [...held.keys(), ...loads, ...tied].filter(
        (node) => node >= rope.first && node <= rope.first + last,
      );
      const nodes = [...new Set([...some, ...inside])].sort((a, b) => a - b);
      return nodes.map((node) => {
        const segment = Math.min(node, rope.first + last - 1);
        const common = { variant: 0, node, segment, place: /** @type {any} */ ([0, 0, 0]) };
        const joint = joints.find(({ nodes }) => nodes.includes(node))?.name;
        const anchor = held.get(node);
        return /** @type {Hit} */ (
          anchor === undefined
            ? { kind: "node", rope: rope.name, joint, ...common }
            : { kind: "anchor", anchor, joint, ...common }
        );
      });
    })
    .slice(0, MOST);
}

/** What is at a place, in words. @param {Layout} layout @param {Frame} frame @param {Hit} hit */
export function said(layout, frame, hit) {
  const [variant] = layout.variants;
  const [part] = frame.parts;
  if (hit.kind === "anchor") {
    const a = variant.anchors.findIndex(({ name }) => name === hit.anchor);
    const force = Math.hypot(...part.anchors.subarray(10 * a + 6, 10 * a + 9));
    return `Anchor ${hit.anchor}, force ${heard(force, "N")}`;
  }
  const rope = variant.ropes.find(({ name }) => name === hit.rope);
  const of = rope ? `Node ${hit.node - rope.zero} of ${rope.name}` : `Node ${hit.node}`;
  const mass = variant.loads
    .filter(({ index }) => index === hit.node)
    .reduce((sum, load) => sum + load.mass, 0);
  const pull = between(layout, part, part.tension[hit.segment], "tension_low", "tension_high");
  const load = mass > 0 ? `, load ${quantity(mass, "kg")}` : "";
  const joint = hit.joint === undefined ? "" : `, tied by joint ${hit.joint}`;
  return `${of}, tension ${heard(pull, "N")}${load}${joint}`;
}

/** The state in one sentence. @param {Layout} layout @param {Frame} frame @param {string} state */
export function sentence(layout, frame, state) {
  const [part] = frame.parts;
  const holding = layout.variants[0].anchors.filter(
    (_, a) => part.anchors[10 * a + 9] > 0.5,
  ).length;
  const anchors = holding === 1 ? "one anchor holds" : `${holding} anchors hold`;
  const most = heard(scalar(layout, part, "tension_high"), "N");
  return `${layout.scene.name}: ${state} at ${quantity(frame.time, "s")}, ${anchors}, greatest tension ${most}.`;
}

export class Walk {
  /** @param {Viewport} viewport @param {HTMLElement} canvas @param {HTMLElement} voice what is read out
   * @param {(hit: Hit | BodyHit, x: number, y: number) => void} menu */
  constructor(viewport, canvas, voice, menu) {
    this.viewport = viewport;
    this.canvas = canvas;
    this.voice = voice;
    this.menu = menu;
    this.at = -1; // of the stops
    this.back = -1; // to which a closed menu comes back
    this.state = "";
    this.bodyKeys = new BodyKeys(viewport);
    canvas.setAttribute("role", "slider");
    canvas.setAttribute("aria-label", "Places on the ropes");
    canvas.setAttribute("aria-valuemin", "1");
    canvas.addEventListener("keydown", (event) => this.press(event));
    canvas.addEventListener("blur", () => this.go(-1));
    canvas.addEventListener("focus", () => {
      this.go(this.back);
      this.back = -1;
    });
    canvas.addEventListener("pointerdown", () => this.go((this.back = -1)));
    for (const name of /** @type {const} */ (["status", "broken", "frame"]))
      viewport.session.on(name, () => this.tell());
  }

  /** @returns {(Hit | BodyHit)[]} */
  get stops() {
    const { layout, frame } = this.viewport.session;
    return layout && frame ? [...stopsOf(layout, frame), ...this.bodies(layout)] : [];
  }

  /** Obstacles that hands can move. @param {Layout} layout @returns {BodyHit[]} */
  bodies({ obstacles = [] }) {
    if (!this.viewport.session.can("obstacle")) return [];
    const common = { variant: 0, node: -1, segment: -1, place: /** @type {any} */ ([0, 0, 0]) };
    return obstacles
      .filter(({ movable, turnable }) => movable || turnable)
      .slice(0, MOST)
      .map(({ name }) => ({ kind: "obstacle", obstacle: name, ...common }));
  }

  /** What is at a stop, in words. @param {Hit | BodyHit} hit */
  words(hit) {
    const { layout, frame } = this.viewport.session;
    if (!layout || !frame) return "";
    if (hit.kind !== "obstacle") return said(layout, frame, hit);
    const at = (this.viewport.solids.base(hit.obstacle) ?? []).map((one) => heard(one, "m"));
    const turns = turnable(this.viewport, hit.obstacle) ? ", Page Up and Page Down turn it" : "";
    return `Obstacle ${hit.obstacle}, at ${at.join(", ")}: arrow keys, Home and End move it${turns}`;
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const { stops } = this;
    if (event.key === "Tab") {
      const next = this.at < 0 && event.shiftKey ? -1 : this.at + (event.shiftKey ? -1 : 1);
      if (next < 0 || next >= stops.length) return this.go(-1); // on to what is beside the scene
      event.preventDefault();
      this.go(next);
    } else if (event.key === "Enter" && stops[this.at]) {
      event.preventDefault();
      const place = placeOf(this.viewport, stops[this.at]);
      if (!place) return;
      const [x, y] = this.viewport.camera.project(...place);
      this.back = this.at;
      this.menu(stops[this.at], x, y);
    } else if (stops[this.at]?.kind === "obstacle") {
      const { obstacle } = /** @type {BodyHit} */ (stops[this.at]);
      if (!this.bodyKeys.press(obstacle, event.code)) return;
      event.preventDefault();
      event.stopPropagation(); // the arrows are not the first anchor's now
    }
  }

  /** @param {number} at */
  go(at) {
    const { viewport, canvas } = this;
    const { stops } = this;
    const hit = stops[at] ?? null;
    this.at = hit ? at : -1;
    if (viewport.marks.chosen !== hit) viewport.marks.dirty = true;
    viewport.marks.chosen = hit;
    canvas.setAttribute("aria-valuemax", String(stops.length));
    canvas.setAttribute("aria-valuenow", String(this.at + 1));
    const words = hit ? this.words(hit) : "None: Tab goes to the next";
    canvas.setAttribute("aria-valuetext", words);
  }

  /** Say what state the simulation is in, when that has changed. */
  tell() {
    const { layout, frame, status, broken } = this.viewport.session;
    if (!layout || !frame) return;
    const state = broken ? "broken" : status?.playing ? "playing" : "paused";
    const since = status?.playing ? "" : `${layout.layout} ${frame.time}`; // a step, a reset, an edit
    const key = `${layout.scene.name} ${state} ${since}`;
    if (key === this.state) return;
    this.state = key;
    this.voice.textContent = sentence(layout, frame, state);
    if (this.at >= 0) this.go(this.at); // what is there has changed since
  }
}
