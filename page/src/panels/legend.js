// What the colours mean, with the range in units, and what is shown besides the ropes.

import { css, uniformMap } from "../view/colours.js";
import { marginText, usesOf } from "../view/margin.js";
import { figures, quantity } from "../view/range.js";
import { colourOf } from "../view/copies.js";
import { touching } from "../source/frame.js";
import { h } from "./dom.js";
import { placeOn } from "../view/cards.js";
import { leftOut, strongestOf } from "../touches.js";
import { WrapNote } from "./wraps.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../source/gather.js").Colouring} Colouring */

const NUMBERS = 100; // ms between two changes of the numbers: faster ones cannot be read
const ROUNDING = 1e-6; // of a range's width, below which an end of it is zero
const NOTHING = 2e-9; // of a range's width: see `Range.follow`

/** The unit for the numbers of a colouring, and what they are multiplied with.
 * @param {Colouring} colouring @param {number} most @returns {[string, number]} */
function unitFor(colouring, most) {
  if (colouring === "strain" || colouring === "utilisation") return ["%", 100];
  if (colouring === "speed") return ["m/s", 1];
  if (most >= 1e7) return ["MN", 1e-6];
  return most >= 1e4 ? ["kN", 1e-3] : ["N", 1];
}

/** Which arrows are left out where many anchors hold. @param {{forces: number, large: number}} crowd */
export const crowdText = ({ forces, large }) =>
  large
    ? `The ${large} larger of ${forces} forces. Point at others.`
    : `${forces} forces, too small now for arrows. Point at an anchor.`;

export class Legend {
  /** @param {Viewport} viewport @param {HTMLElement} host */
  constructor(viewport, host) {
    this.viewport = viewport;
    this.written = -Infinity;
    this.select = h(
      "select",
      { id: "colouring", "aria-label": "Colour of the ropes", onchange: () => this.choose() },
      h("option", { value: "tension" }, "Tension"),
      h("option", { value: "strain" }, "Tension / EA"),
      (this.near = h("option", { value: "utilisation", hidden: true }, "Tension / breaking load")),
      h("option", { value: "speed" }, "Speed"),
      h("option", { value: "plain" }, "Plain colours"),
    );
    this.bar = h("div", { className: "map" });
    /** @type {boolean | null} the theme the bar is painted for */ this.dark = null;
    this.low = h("span", {});
    this.middle = h("span", {});
    this.high = h("span", {});
    this.numbers = h(
      "div",
      { className: "numbers", id: "legend-numbers" },
      this.low,
      this.middle,
      this.high,
    );
    this.ropes = h("div", { className: "rope-names" });
    this.arrows = this.check(
      "Forces",
      "show-forces",
      true,
      (on) => (viewport.marks.reactions = on),
    );
    this.dots = this.check("Nodes", "show-nodes", false, (on) => (viewport.dots = on));
    this.contacts = this.check("Contact", "show-contacts", true, (on) => {
      viewport.marks.contacts = on;
    });
    this.contacts.hidden = true;
    this.contacts.title =
      "Forces of obstacles on ropes, and of ropes on each other: one on either rope. On a scale of their own";
    this.firmest = h("div", { className: "numbers", id: "contact-scale", hidden: true });
    this.fewer = h("div", { className: "numbers", id: "contacts-left-out", hidden: true });
    this.wraps = new WrapNote();
    this.posts = this.check("Stands", "show-posts", true, (on) => (viewport.marks.standing = on));
    this.posts.title = "What anchors stand on: drawn only, ropes pass through it";
    this.posts.className = "posts";
    this.margin = h("div", { className: "numbers", id: "margin", hidden: true });
    this.given = h("div", { className: "numbers", id: "given", hidden: true });
    this.crowd = h("div", { className: "numbers", id: "crowd", hidden: true });
    this.grid = h("span", {});
    this.thick = h("span", {});
    host.append(
      (this.card = h(
        "div",
        { className: "card legend" },
        this.select,
        this.bar,
        this.numbers,
        this.margin,
        this.ropes,
        h("div", { className: "row" }, this.arrows, this.dots, this.posts),
        h("div", { className: "row" }, this.contacts, this.firmest),
        this.fewer,
        this.wraps.host,
        h("div", { className: "numbers drawn-as" }, this.grid, this.thick),
        this.given,
        this.crowd,
      )),
    );
    viewport.session.on("layout", () => this.names());
    viewport.session.on("status", () => this.refresh());
    viewport.afterDraw.push(() => {
      const playing = viewport.session.status?.playing;
      if (!playing || performance.now() - this.written >= NUMBERS) this.refresh();
    });
  }

  /** @param {string} text @param {string} id @param {boolean} on @param {(on: boolean) => void} change */
  check(text, id, on, change) {
    const box = h("input", {
      type: "checkbox",
      id,
      checked: on,
      onchange: () => {
        change(box.checked);
        this.viewport.dirty = true;
      },
    });
    return h("label", {}, box, text);
  }

  place() {
    return placeOn(this.card, this.viewport.renderer.canvas);
  }

  choose() {
    this.viewport.setColouring(/** @type {Colouring} */ (this.select.value));
    this.names();
  }

  /** The names of ropes or copies in their colours. */
  names() {
    this.written = -Infinity;
    const { layout } = this.viewport.session;
    const plain = this.viewport.colouring === "plain";
    this.bar.hidden = this.numbers.hidden = plain;
    this.ropes.replaceChildren();
    if (layout) {
      this.tellGiven(layout);
      this.contacts.hidden = !touching(layout.variants[0].offsets);
      const known = layout.variants.some(({ ropes }) => ropes.some((one) => one.breaking_load));
      this.near.hidden = this.near.disabled = !known;
      if (!known && this.viewport.colouring === "utilisation") {
        this.select.value = "tension";
        return this.choose();
      }
    }
    this.margin.hidden = this.viewport.colouring !== "utilisation";
    if (!layout || !plain) return;
    const many = layout.variants.length > 1;
    const entries = many
      ? layout.variants.map((variant, v) => ({
          name: variant.label,
          colour: colourOf(layout, v, 0),
        }))
      : layout.variants[0].ropes.map((rope, r) => ({
          name: rope.name,
          colour: colourOf(layout, 0, r),
        }));
    for (const { name, colour } of entries.slice(0, 6)) {
      const dot = h("i", {});
      dot.style.background = css(colour);
      this.ropes.append(h("span", {}, dot, name));
    }
    if (entries.length > 6)
      this.ropes.append(h("span", { className: "faint" }, `and ${entries.length - 6} more`));
  }

  /** What the scene gives besides: weight in water, constant forces.
   * @param {import("../source/protocol.js").Layout} layout */
  tellGiven({ variants: [{ ropes, forces }] }) {
    const wet = ropes.filter(({ submerged_weight: weight }) => typeof weight === "number");
    const said = wet.slice(0, 2).map(({ name, submerged_weight: weight }) => {
      const of = ropes.length > 1 ? `${name} ` : "";
      return `${of}weighs ${quantity(weight, "N/m")} in water`;
    });
    if (forces.length) said.push("arrows at nodes: constant forces");
    const text = said.join("; ");
    this.given.hidden = !text;
    write(this.given, text && text[0].toUpperCase() + text.slice(1));
  }

  /** Paint the bar in the map's colours. */
  paint() {
    const { dark } = this.viewport.theme;
    if (dark === this.dark) return;
    this.dark = dark;
    const map = uniformMap(dark);
    const stops = Array.from({ length: 17 }, (_, i) =>
      css(map[Math.round((i / 16) * (map.length - 1))]),
    );
    this.bar.style.backgroundImage = `linear-gradient(to right, ${stops.join(", ")})`;
  }

  refresh() {
    this.paint();
    this.written = performance.now();
    this.tellMargin();
    const { range, colouring, beyond } = this.viewport;
    const { low, high } = range;
    const [less, more] = [beyond[0] ? "≤ " : "", beyond[1] ? "≥ " : ""];
    const [unit, scale] = unitFor(colouring, Math.max(Math.abs(low), Math.abs(high)));
    const text = (/** @type {number} */ value) => endText(value, scale, high - low);
    const some = high - low > NOTHING;
    this.low.hidden = this.middle.hidden = !some; // one number where all are the same
    if (!some) {
      write(this.high, `${more}${text(low)} ${unit}`);
      return this.showGrid();
    }
    write(this.low, `${less}${text(low)}`);
    write(this.middle, text((low + high) / 2));
    write(this.high, `${more}${text(high)} ${unit}`);
    this.showGrid();
  }

  /** How near to breaking. */
  tellMargin() {
    const { session, tensions } = this.viewport;
    const { layout } = session;
    if (this.margin.hidden || !layout || tensions.length !== layout.variants.length) return;
    const ropes = layout.variants.reduce((sum, variant) => sum + variant.ropes.length, 0);
    write(this.margin, marginText(usesOf(layout, tensions), ropes));
  }

  tellCrowd() {
    const { reactions, crowd } = this.viewport.marks;
    this.crowd.hidden = !reactions || !crowd || crowd.large === crowd.forces;
    if (!this.crowd.hidden && crowd) write(this.crowd, crowdText(crowd));
  }

  /** The scale of the arrows of contacts, which are left out, and wraps. */
  tellContacts() {
    const { session, marks } = this.viewport;
    const { layout, frame } = session;
    this.wraps.show(layout, frame);
    const shown = !this.contacts.hidden && marks.contacts && marks.firmest > 1e-9;
    this.firmest.hidden = !shown;
    this.fewer.hidden = true;
    if (!shown || !layout || !frame) return;
    write(this.firmest, `longest ${quantity(Number(marks.firmest.toPrecision(2)), "N")}`);
    const [part] = frame.parts;
    const text = leftOut(strongestOf(layout, part), part.contact.length / 3);
    this.fewer.hidden = !text;
    write(this.fewer, text);
  }

  showGrid() {
    this.tellContacts();
    this.tellCrowd();
    write(this.grid, `Grid ${quantity(this.viewport.spacing, "m")}`);
    const times = this.viewport.thickness();
    write(
      this.thick,
      times > 1.05 ? `Drawn ${figures(Number(times.toPrecision(2)))}× thick` : "True thickness",
    );
  }
}

/** @param {HTMLElement} element @param {string} text */
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** A number of a range in two figures; what is next to nothing beside its width is what rounding left.
 * @param {number} value @param {number} scale of the unit it is told in @param {number} width of the range */
export const endText = (value, scale, width) =>
  figures(Math.abs(value) < ROUNDING * width ? 0 : Number((value * scale).toPrecision(2)));
