// A node that is measured: what it does now, and over time.

import { readPosts } from "./posts.js";
import { Strip } from "./strip.js";
import { saidOf } from "./typed.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {{rope?: Rope, tension?: Float64Array, broken?: boolean, plane(): [number[], number[]],
 *   draw(): void}} Lab */

/** What can be measured, with its unit. @type {Record<string, string>} */
export const QUANTITIES = { height: "m", sideways: "m", speed: "m/s", tension: "N", ratio: "" };

/** The value of a quantity at a node, in the plane that is seen; NaN where there is none, as after a break.
 * @param {Lab} lab @param {number} node @param {string} quantity */
export function measured(lab, node, quantity) {
  const { rope, tension } = lab;
  if (!rope || !tension || lab.broken) return NaN;
  const [across, up] = lab.plane();
  /** @param {number[]} way */
  const along = (way) => way.reduce((sum, part, k) => sum + part * rope.x[k][node], 0);
  if (quantity === "height") return along(up);
  if (quantity === "sideways") return along(across);
  if (quantity === "ratio") return readPosts(rope, tension)?.ratio ?? NaN;
  if (quantity === "speed" && rope.hand?.node === node) return NaN; // it has no velocity of its own
  if (quantity === "speed") return Math.hypot(...rope.v.map((row) => row[node]));
  const beside = [node - 1, node].filter((j) => j >= 0 && j < rope.n - 1 && rope.stiffness[j] > 0);
  return beside.reduce((sum, j) => sum + tension[j], 0) / beside.length;
}

/** The node that is measured first: the middle of the longest piece between anchors or ends, which is not held.
 * @param {Rope} rope */
export function middle(rope) {
  const held = rope.anchors.map((anchor) => anchor.node);
  let [longest, node] = [0, 0];
  for (const [first, last] of rope.ropes) {
    const inside = held.filter((one) => first < one && one < last);
    const ends = [first, ...inside.sort((a, b) => a - b), last];
    for (const [i, end] of ends.slice(1).entries())
      if (end - ends[i] > longest) [longest, node] = [end - ends[i], (ends[i] + end + 1) >> 1];
  }
  return node;
}

export class Probe {
  /** @param {Lab} lab @param {(id: string) => HTMLElement} find @param {import("./typed.js").Typed} typed */
  constructor(lab, find, typed) {
    this.lab = lab;
    this.node = 0;
    this.field = /** @type {HTMLInputElement} */ (find("node"));
    this.choice = /** @type {HTMLSelectElement} */ (find("quantity"));
    this.reading = find("reading");
    const canvas = /** @type {HTMLCanvasElement} */ (find("graph"));
    this.strip = new Strip(canvas, [{ name: "accent" }], () => lab.draw());
    this.field.onchange = () => {
      const written = this.field.valueAsNumber;
      typed.say(this.field, saidOf("The node", written, 0, (lab.rope?.n ?? 1) - 1, this.node, ""));
      this.choose(Number.isNaN(written) ? this.node : written);
    };
    this.choice.onchange = () => this.choose(this.node);
    find("save").onclick = () => this.save();
  }

  /** Measure another node, from now on. @param {number} node */
  choose(node) {
    const last = (this.lab.rope?.n ?? 1) - 1;
    this.node = Math.min(Math.max(Math.round(node) || 0, 0), last);
    this.field.max = String(last);
    this.field.value = String(this.node);
    this.field.disabled = this.choice.value === "ratio"; // which is of no node
    this.strip.clear();
    this.note(); // the graph and its table begin now
    this.lab.draw();
  }

  /** Note the values of this moment. */
  note() {
    const { lab, node, choice } = this;
    if (lab.rope) this.strip.add(lab.rope.time, [measured(lab, node, choice.value)]);
  }

  /** Say what the node does now, or did under the pointer. */
  draw() {
    const { lab, node, choice } = this;
    this.strip.draw();
    const read = this.strip.read();
    const value = read ? read.values[0] : measured(lab, node, choice.value);
    const when = read ? ` at ${read.t.toFixed(3)} s` : "";
    const small = Math.abs(value) < 1e-3 && value !== 0;
    const rounded = small ? value.toExponential(4) : String(Number(value.toPrecision(5)) + 0);
    const told = Number.isFinite(value) ? `${rounded} ${QUANTITIES[choice.value]}` : "none";
    this.reading.textContent = `${told}${when}`;
  }

  /** The graph as a table that spreadsheets open. */
  table() {
    const { kept } = this.strip;
    const { value } = this.choice;
    const name = value === "ratio" ? "ratio at the post [1]" : `${value} of node ${this.node}`;
    const head = `time [s],${name}${value === "ratio" ? "" : ` [${QUANTITIES[value]}]`}`;
    return [
      head,
      ...kept.map(({ t, values }) => `${Number(t.toPrecision(9))},${values[0]}`),
      "",
    ].join("\n");
  }

  save() {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([this.table()], { type: "text/csv" }));
    link.download = `${this.choice.value}.csv`;
    link.click();
    URL.revokeObjectURL(link.href);
  }
}
