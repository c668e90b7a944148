// The drawer of graphs: the last seconds while it runs; paused, one can scroll back.

import { ROPES } from "../view/colours.js";
import { h } from "../panels/dom.js";
import { BROKEN, PLAYING } from "../source/frame.js";
import { History } from "./history.js";
import { PhasePlane } from "./phase.js";
import { Plot } from "./plot.js";
import { longestOf, numbered, samplesOf } from "./samples.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../source/frame.js").Frame} Frame */
/** @typedef {{low?: string, high?: string}} Bounds */
/** @typedef {"energies" | "tension" | "forces" | "motion" | "phase" | "difference"} Kind */
/** @typedef {{kind: Kind, box: HTMLElement, plot: Plot | PhasePlane | null}} Panel */

const WINDOWS = [2, 5, 10, 30, 60, Infinity]; // s
const LEAST = 0.1; // s on the axis at least
const REFRESH = 66; // ms between two drawings of a graph
const TITLES = {
  energies: "Energies",
  tension: "Tension",
  forces: "Forces",
  motion: "Height or speed",
  phase: "Phase plane",
  difference: "Difference",
};
const ENERGIES = /** @type {[string, string, string][]} */ ([
  ["kinetic", "kinetic", ROPES[0]],
  ["gravity", "gravity, from the start", ROPES[2]],
  ["elastic", "elastic", ROPES[1]],
  ["lost", "lost", ROPES[3]],
]);

const LOST = "lost: to friction, air, ground, obstacles, and what pulleys and contacts store";
const ONE = "(max-width: 700px), (max-height: 500px)"; // a window with room for one graph, as in the style sheet

/** The names of bounds since the frame before. @type {Record<string, (node: number) => Bounds>} */
const BOUNDS = {
  tension: (node) => ({ low: `low tension ${node}`, high: `tension ${node}` }),
  height: (node) => ({ low: `low height ${node}`, high: `high height ${node}` }),
  speed: () => ({}),
};

export class Graphs {
  /** @param {Viewport} viewport @param {HTMLElement} host */
  constructor(viewport, host) {
    this.viewport = viewport;
    this.host = host;
    this.history = new History();
    this.window = 10;
    this.back = 0; // s scrolled back
    /** Asks a replay for what is not known of the time before. */
    this.wanted = () => {};
    this.quantity = "height";
    /** @type {Map<Kind, Panel>} */ this.panels = new Map();
    this.lastDraw = 0;
    this.soon = false; // whether all are drawn at the next animation frame
    this.turn = 0;
    this.plots = h("div", { className: "plots" });
    this.chips = h("div", { className: "chips" });
    this.choice = h("select", {
      id: "graph-choice",
      "aria-label": "Graph shown",
      onchange: () => this.choose(this.choice.value),
    });
    this.scroll = h("input", {
      type: "range",
      id: "graph-scroll",
      min: "0",
      max: "0",
      step: "any",
      "aria-label": "Scroll back in time",
      oninput: () => {
        this.back = Number(this.scroll.max) - Number(this.scroll.value);
        this.drawAll();
      },
    });
    this.windowChoice = h(
      "select",
      {
        id: "graph-window",
        "aria-label": "Seconds shown",
        onchange: () => this.setWindow(Number(this.windowChoice.value.replace("all", "Infinity"))),
      },
      ...WINDOWS.map((s) =>
        h(
          "option",
          { value: Number.isFinite(s) ? String(s) : "all", selected: s === this.window },
          Number.isFinite(s) ? `${s} s` : "all",
        ),
      ),
    );
    this.quantityChoice = h(
      "select",
      { id: "graph-quantity", "aria-label": "Height or speed", onchange: () => this.setQuantity() },
      h("option", { value: "height" }, "Height"),
      h("option", { value: "speed" }, "Speed"),
    );
    this.own = false; // whether each line has a scale of its own
    this.ownScales = h(
      "button",
      {
        type: "button",
        className: "chip",
        id: "own-scales",
        "aria-pressed": "false",
        title: "Each line fills the height: its shape is seen, whatever its size",
        onclick: () => this.setOwn(!this.own),
      },
      "Own scales",
    );
    host.append(
      h(
        "div",
        { className: "graph-bar" },
        this.chips,
        this.choice,
        this.quantityChoice,
        this.ownScales,
        h("label", {}, h("span", { className: "words" }, "Last"), this.windowChoice),
        this.scroll,
      ),
      this.plots,
    );
    /** @type {Set<Kind>} */
    this.shown = new Set(
      matchMedia(ONE).matches ? ["energies"] : ["energies", "tension", "motion"],
    );
    viewport.session.on("frame", (frame) => this.take(frame));
    viewport.session.on("layout", (layout) => {
      this.history.tell(numbered(layout));
      this.rebuild();
    });
    viewport.session.on("status", () => this.bounds());
    new ResizeObserver(() => this.resize()).observe(this.plots);
    matchMedia(ONE).addEventListener("change", () => this.rebuild());
    this.plots.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
  }

  get open() {
    return !this.host.hidden;
  }

  /** @param {boolean} [open] */
  toggle(open = !this.open) {
    this.host.hidden = !open;
    if (open) return this.rebuild();
    this.clear();
    this.wanted(); // nothing any more: what is on its way is left off
  }

  /** @param {Frame} frame */
  take(frame) {
    const { layout } = this.viewport.session;
    if (!layout) return;
    if (frame.flags & BROKEN && this.viewport.session.hello?.mode === "replay") {
      this.drawSoon(); // no number is taken from beyond a break
      return;
    }
    const samples = samplesOf(layout, frame, this.viewport.marks.followed);
    this.history.add(frame.time, samples, longestOf(this.viewport.session));
    if (!this.open) return;
    if (!(frame.flags & PLAYING)) {
      this.drawSoon(); // there may be no further frame
      return;
    }
    const now = performance.now();
    if (now - this.lastDraw < REFRESH / Math.max(1, this.panels.size)) return;
    this.lastDraw = now;
    const panels = [...this.panels.values()];
    this.turn = (this.turn + 1) % Math.max(1, panels.length);
    if (panels[this.turn]) this.draw(panels[this.turn]); // one at a time, so that no frame waits long
    if (this.turn === 0) this.bounds();
  }

  clear() {
    for (const { plot, box } of this.panels.values()) {
      if (plot instanceof Plot) plot.destroy();
      box.remove();
    }
    this.panels.clear();
  }

  /** Make the graphs anew, after other nodes were chosen. */
  rebuild() {
    if (!this.open) return;
    this.clear();
    const many = (this.viewport.session.layout?.variants.length ?? 1) > 1;
    const held = (this.viewport.session.layout?.variants[0].anchors.length ?? 0) > 0;
    const kinds = /** @type {Kind[]} */ (Object.keys(TITLES)).filter(
      (kind) => (kind !== "difference" || many) && (kind !== "forces" || held),
    );
    this.chips.replaceChildren(...kinds.map((kind) => this.chip(kind)));
    this.offer(kinds);
    this.quantityChoice.hidden = !this.shown.has("motion");
    for (const kind of kinds) {
      if (!this.shown.has(kind)) continue;
      const box = h("div", {
        className: "plot",
        data: { kind },
        title: kind === "energies" ? LOST : "",
      });
      this.plots.append(box);
      this.panels.set(kind, { kind, box, plot: null });
    }
    for (const panel of this.panels.values()) panel.plot = this.make(panel);
    requestAnimationFrame(() => this.resize());
    this.bounds();
    this.wanted();
  }

  /** How much time is seen [s]. */
  get span() {
    if (Number.isFinite(this.window)) return this.window;
    return Math.max(WINDOWS[0], this.history.last - this.history.first) || WINDOWS[0];
  }

  /** @param {Kind} kind */
  chip(kind) {
    return h(
      "button",
      {
        type: "button",
        className: "chip",
        "aria-pressed": String(this.shown.has(kind)),
        data: { graph: kind },
        onclick: () => {
          if (!this.shown.delete(kind)) this.shown.add(kind);
          this.rebuild();
        },
      },
      TITLES[kind],
    );
  }

  /** Where there is room for one graph only, a menu names them. @param {Kind[]} kinds */
  offer(kinds) {
    if (matchMedia(ONE).matches) this.shown = new Set([...this.shown, kinds[0]].slice(0, 1));
    const names = kinds.flatMap((kind) => (kind === "motion" ? ["height", "speed"] : [kind]));
    this.choice.replaceChildren(
      ...names.map((name) =>
        h(
          "option",
          { value: name },
          TITLES[/** @type {Kind} */ (name)] ?? `${name[0].toUpperCase()}${name.slice(1)}`,
        ),
      ),
    );
    const [first] = this.shown;
    this.choice.value = first === "motion" ? this.quantity : first;
  }

  /** Show one graph. @param {string} name of its kind, or of the motion's quantity */
  choose(name) {
    const motion = name === "height" || name === "speed";
    this.shown = new Set([motion ? "motion" : /** @type {Kind} */ (name)]);
    if (!motion) return this.rebuild();
    this.quantityChoice.value = name;
    this.setQuantity();
  }

  /** @param {Panel} panel */
  make({ kind, box }) {
    if (kind === "phase") return new PhasePlane(box);
    const unit = {
      energies: "J",
      tension: "N",
      forces: "N",
      motion: this.quantity === "height" ? "m" : "m/s",
      difference: "m",
    }[kind];
    return new Plot(box, unit, this.series(kind), this.own);
  }

  /** @param {Kind} kind @returns {import("./plot.js").Series[]} */
  series(kind) {
    if (kind === "energies")
      return ENERGIES.map(([name, label, colour]) => ({ name, label, colour }));
    const variants = this.viewport.session.layout?.variants ?? [];
    if (kind === "difference") {
      return variants.slice(1).map((variant, v) => ({
        name: `difference ${v + 1}`,
        label: `${variant.label}, rms`,
        colour: ROPES[(v + 1) % ROPES.length],
      }));
    }
    if (kind === "forces") {
      return (variants[0]?.anchors ?? []).slice(0, ROPES.length).map(({ name }, a) => ({
        name: `force ${a}`,
        label: name,
        colour: ROPES[a],
      }));
    }
    const prefix = kind === "tension" ? "tension" : this.quantity;
    const followed = [...this.viewport.marks.followed].map((node, i) => ({
      name: `${prefix} ${node}`,
      label: this.nodeName(node),
      colour: ROPES[(i + 1) % ROPES.length],
      ...BOUNDS[prefix](node),
    }));
    if (kind === "tension")
      return [{ name: "tension_max", label: "largest", colour: ROPES[0] }, ...followed];
    if (this.quantity === "speed")
      return [{ name: "speed_high", label: "fastest", colour: ROPES[0] }, ...followed];
    if (followed.length) return followed;
    return [
      { name: "high", label: "highest", colour: ROPES[0] },
      { name: "low", label: "lowest", colour: ROPES[5] },
    ];
  }

  /** @param {number} node */
  nodeName(node) {
    const ropes = this.viewport.session.layout?.variants[0].ropes ?? [];
    const rope = ropes.find(({ first, nodes }) => node >= first && node < first + nodes);
    return ropes.length > 1 && rope
      ? `${rope.name} ${node - rope.zero}`
      : `node ${node - (rope?.zero ?? 0)}`;
  }

  /** @param {Panel} panel */
  draw({ kind, plot }) {
    if (!Number.isFinite(this.history.last)) return;
    const to = this.history.last - this.back; // what has not been yet is not on the axis
    const young = Math.min(Math.max(to - this.span, this.history.first), to - LEAST);
    const from = to > 0 ? Math.max(young, 0) : young; // no time before the first
    if (plot instanceof Plot) {
      const apart = this.history.apartBetween(from, to);
      plot.show(this.history.between(from, to, plot.names), apart, from, to);
    } else if (plot && kind === "phase") {
      const node = [...this.viewport.marks.followed][0];
      const [times, heights] = this.history.between(from, to, [`height ${node}`]);
      plot.show(times, heights, ROPES[1]);
    }
  }

  /** Draw all at the next animation frame, once. */
  drawSoon() {
    if (this.soon) return;
    this.soon = true;
    requestAnimationFrame(() => {
      this.soon = false;
      this.bounds();
      this.drawAll();
    });
  }

  drawAll() {
    for (const panel of this.panels.values()) this.draw(panel);
  }

  /** How far one can scroll back, only while paused. */
  bounds() {
    const playing = this.viewport.session.status?.playing ?? true;
    const most = Math.max(0, this.history.last - this.history.first - this.span) || 0;
    if (playing) this.back = 0;
    this.scroll.disabled = playing || most === 0;
    this.scroll.title = playing ? "Pause to scroll back" : "Scroll back in time";
    this.scroll.max = String(most);
    this.scroll.value = String(most - this.back);
    if (!playing) this.drawAll();
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    if (this.scroll.disabled) return;
    event.preventDefault();
    const by = ((event.deltaX || event.deltaY) / 400) * this.span;
    this.back = Math.min(Number(this.scroll.max), Math.max(0, this.back - by));
    this.bounds();
  }

  /** @param {number} seconds */
  setWindow(seconds) {
    this.window = seconds;
    this.back = 0;
    this.wanted();
    this.bounds();
    this.drawAll();
  }

  /** @param {boolean} own */
  setOwn(own) {
    this.own = own;
    this.ownScales.setAttribute("aria-pressed", String(own));
    this.rebuild();
  }

  setQuantity() {
    this.quantity = this.quantityChoice.value;
    this.rebuild();
  }

  resize() {
    for (const { plot } of this.panels.values()) plot?.resize();
    this.drawAll();
  }
}
