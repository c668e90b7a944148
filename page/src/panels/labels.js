// Labels in the scene: forces in newtons beside their arrows, clear of cards, anchors and ropes.

import { nodesOf } from "../view/copies.js";
import { free, placesFor } from "../view/places.js";
import { h } from "./dom.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../marks.js").Label} Label */
/** @typedef {import("../view/places.js").Box} Box */

const LETTER = 7.4; // of the labels' font, wide [CSS pixels]
const HEIGHT = 22;
const FRAME = 18; // beside the letters
const TIP = 2.5; // half of an arrow's, that stays free
const STAY = 600; // ms a label keeps its place while a better one is free
const PLATE = 10; // half of an anchor's
const BEADS = 90; // nodes that are looked at, at most
const CARDS = ".toolbar, .legend, .difference, .tour, .broken, .slow-note, .banner";
const WORDS = 100; // ms between two changes of the numbers while time goes on: faster ones cannot be read
const LOOK = 1000; // ms between two looks at the cards, which may move without another size

export class Labels {
  /** @param {Viewport} viewport @param {HTMLElement} host */
  constructor(viewport, host) {
    this.viewport = viewport;
    this.host = host;
    this.box = h("div", { className: "labels", "aria-hidden": "true" });
    /** Each label's element, which place it took, and since when [ms].
     * @type {Map<string, {element: HTMLElement, taken: number, since: number}>} */ this.known =
      new Map();
    /** @type {Box[]} */ this.cards = [];
    /** @type {Set<Element>} */ this.watched = new Set();
    this.looked = this.worded = -Infinity;
    this.waits = false; // whether a label keeps its place though a better one is free
    this.later = 0; // the timer that then looks again: nothing else may be drawn
    this.watch = new ResizeObserver(() => {
      this.looked = -Infinity;
      viewport.marks.dirty = true;
    });
    this.watch.observe(host);
    host.append(this.box);
    viewport.afterDraw.push(() => this.refresh());
    viewport.session.on("status", () => (viewport.marks.dirty = true)); // time stands: the last words count
  }

  refresh() {
    const { labels } = this.viewport.marks;
    const plates = labels.flatMap(({ from, at }) => [this.plate(from, PLATE), this.plate(at, TIP)]);
    const blocked = labels.length ? [...this.cardsNow(), ...plates] : [];
    const beads = labels.length ? this.beads() : [];
    const now = performance.now();
    this.waits = false;
    const anew = now - this.worded >= WORDS || !this.viewport.session.status?.playing;
    if (anew) this.worded = now;
    this.forget(labels);
    for (const label of labels) {
      const { element } = this.known.get(label.id) ?? this.add(label);
      const stale = anew || element.hidden;
      const text = (stale ? label.text : element.textContent) ?? ""; // what stands there needs the room
      const place = this.place({ ...label, text }, blocked, beads);
      if (element.hidden === (place !== null)) element.hidden = !element.hidden;
      if (!place) continue;
      blocked.push(place);
      if (element.textContent !== text) element.textContent = text;
      element.style.transform = `translate(${Math.round(place.x)}px, ${Math.round(place.y)}px)`;
    }
    if (anew) this.viewport.marks.written();
    if (this.waits && !this.later) this.later = setTimeout(() => this.lookAgain(), STAY);
  }

  /** Take away what is no label any more. @param {Label[]} labels */
  forget(labels) {
    const now = new Set(labels.map(({ id }) => id));
    for (const [id, { element }] of this.known) {
      if (now.has(id)) continue;
      element.remove();
      this.known.delete(id);
    }
  }

  /** @param {Label} label */
  add({ id, kind }) {
    const element = h("span", { className: kind, hidden: true });
    const made = { element, taken: 0, since: -Infinity };
    this.known.set(id, made);
    this.box.append(element);
    return made;
  }

  lookAgain() {
    this.later = 0;
    this.viewport.marks.dirty = true;
  }

  /** Where a label goes: where it was, else beyond its arrow's tip, else near by. A place on the rope will do,
   * none on anything else. @param {Label} label one that is known @param {Box[]} blocked
   * @param {number[][]} beads @returns {Box | null} */
  place({ id, from, at, text }, blocked, beads) {
    const { camera } = this.viewport;
    const [x, y, depth] = camera.project(...at);
    if (!(depth > 0)) return null;
    const [fx, fy] = camera.project(...from);
    const size = [LETTER * text.length + FRAME, HEIGHT];
    const room = [camera.width, camera.height];
    const places = placesFor([x, y], [x - fx, y - fy], size, room);
    const known = /** @type {{taken: number, since: number}} */ (this.known.get(id));
    const before = known.taken;
    const now = performance.now();
    const order = now - known.since < STAY ? [before, ...places.keys()] : [...places.keys()];
    const clear = order.find((k) => free(places[k], blocked, beads));
    const found = clear ?? order.find((k) => free(places[k], blocked, []));
    if (found === undefined) return null;
    if (found !== before) known.since = now;
    else if (found > 0 && order.length > places.length) this.waits = true;
    known.taken = found;
    return places[found];
  }

  /** What an arrow starts from, or its tip. @param {import("../view/vector.js").Vector} place
   * @param {number} half [CSS pixels] @returns {Box} */
  plate(place, half) {
    const [x, y] = this.viewport.camera.project(...place);
    return { x: x - half, y: y - half, width: 2 * half, height: 2 * half };
  }

  /** Where some of the nodes are on the screen. */
  beads() {
    const { camera, nodes, session } = this.viewport;
    const count = session.layout ? nodesOf(session.layout) : 0;
    const every = Math.max(1, Math.ceil(count / BEADS));
    const found = [];
    for (let i = 0; i < count; i += every) {
      const [x, y, z] = nodes.shown.subarray(4 * i, 4 * i + 3);
      found.push(camera.project(x, y, z));
    }
    return found;
  }

  /** The cards over the scene, looked up now and then. @returns {Box[]} */
  cardsNow() {
    const now = performance.now();
    if (now - this.looked < LOOK) return this.cards;
    this.looked = now;
    const { left, top } = this.host.getBoundingClientRect();
    this.cards = [...this.host.querySelectorAll(CARDS)].map((card) => {
      if (!this.watched.has(card)) this.watch.observe(card); // also when it opens or closes
      this.watched.add(card);
      const { x, y, width, height } = card.getBoundingClientRect();
      return { x: x - left, y: y - top, width, height };
    });
    return this.cards;
  }
}
