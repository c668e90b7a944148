// Mouse, pen and fingers on the scene: turn, shift and zoom the view; take hold of anchors and ropes.

import { Hand } from "./hand.js";
import { pick } from "./pick.js";

/** @typedef {import("../stage.js").Stage} Stage */
/** @typedef {import("./pick.js").Hit} Hit */
/** @typedef {"hand" | "pin" | "cut" | "load" | "kick" | "follow"} Tool */

const CLICK = 5; // pixels a click may move
const LONG = 550; // ms of a long press, which opens the menu on a touch screen
const DOUBLE = 350; // ms

export class Pointer {
  /** @param {Stage} stage @param {HTMLElement} element
   * @param {{use: (tool: Tool, hit: Hit) => void, menu: (hit: Hit | null, x: number,
   *   y: number) => void}} actions */
  constructor(stage, element, actions) {
    this.stage = stage;
    this.element = element;
    this.actions = actions;
    /** @type {Tool} */ this.tool = "hand";
    this.keep = false; // grabs stay when the pointer is up
    /** @type {Map<number, {x: number, y: number}>} */ this.down = new Map();
    /** @type {Hand | null} */ this.hand = null;
    /** @type {Hit | null} */ this.hit = null;
    /** @type {{x: number, y: number, button: number, shift: boolean} | null} */ this.start = null;
    this.moved = false;
    this.lastClick = 0;
    this.longPress = 0;
    this.menuOpened = false;
    this.hovering = false;
    element.addEventListener("pointerdown", (event) => this.press(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    element.addEventListener("pointerrawupdate", (event) =>
      this.drag(/** @type {PointerEvent} */ (event)),
    );
    element.addEventListener("pointerup", (event) => this.lift(event));
    element.addEventListener("pointercancel", (event) => this.lift(event));
    element.addEventListener("pointerleave", () => this.hover(null));
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
  }

  /** @param {{clientX: number, clientY: number}} event */
  at(event) {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  /** @param {PointerEvent} event */
  reach(event) {
    return event.pointerType === "mouse" ? 11 : 24;
  }

  /** @param {PointerEvent} event */
  press(event) {
    this.element.setPointerCapture(event.pointerId);
    const { x, y } = this.at(event);
    this.down.set(event.pointerId, { x, y });
    this.stage.flight = null;
    if (this.down.size > 1) {
      // a second finger: pinch
      clearTimeout(this.longPress);
      this.dropHand(false);
      this.moved = true;
      return;
    }
    this.start = { x, y, button: event.button, shift: event.shiftKey };
    this.moved = this.menuOpened = false;
    this.hit = pick(this.stage, x, y, this.reach(event));
    if (event.button === 0 && this.hit && !(event.ctrlKey || event.metaKey)) {
      if (this.tool === "hand") {
        const way = this.hit.kind === "anchor" ? "drag" : "grab";
        if (this.stage.session.can(way)) this.hand = new Hand(this.stage, this.hit, way);
      } else if (this.tool === "kick") this.hand = new Hand(this.stage, this.hit, "kick");
    }
    if (event.pointerType !== "mouse") {
      this.longPress = window.setTimeout(() => this.openMenu(x, y), LONG);
    }
  }

  /** @param {PointerEvent} event */
  move(event) {
    const { x, y } = this.at(event);
    const before = this.down.get(event.pointerId);
    if (!before) {
      if (event.pointerType === "mouse") this.hover(pick(this.stage, x, y, 11));
      return;
    }
    if (this.down.size === 2) {
      this.pinch(event.pointerId, x, y);
      return;
    }
    const { start } = this;
    if (!start) return;
    if (!this.moved && Math.hypot(x - start.x, y - start.y) < CLICK) return;
    this.moved = true;
    clearTimeout(this.longPress);
    const [dx, dy] = [x - before.x, y - before.y];
    this.down.set(event.pointerId, { x, y });
    if (this.menuOpened) return;
    if (this.hand) {
      this.hand.moveTo(x, y);
      this.stage.marks.hover = this.hand.way === "kick" ? null : this.hand.ring;
      this.stage.marks.dirty = true;
    } else if (start.button !== 0 || start.shift) this.stage.camera.pan(dx, dy);
    else this.stage.camera.orbit(dx, dy);
  }

  /** The same before the next animation frame, where the browser tells: the hand need not wait for it.
   * @param {PointerEvent} event */
  drag(event) {
    if (!this.hand || !this.moved || this.menuOpened || this.down.size !== 1) return;
    const { x, y } = this.at(event);
    this.hand.moveTo(x, y);
  }

  /** @param {PointerEvent} event */
  lift(event) {
    if (!this.down.delete(event.pointerId)) return;
    clearTimeout(this.longPress);
    const { x, y } = this.at(event);
    if (this.hand && this.moved) this.hand.moveTo(x, y);
    const hadHand = this.hand !== null && this.moved;
    this.dropHand(event.shiftKey || this.keep, this.moved);
    if (this.moved || this.menuOpened || hadHand || this.down.size) return;
    if (event.button === 2) this.openMenu(x, y);
    else if (event.button === 0) this.click(event.timeStamp);
  }

  /** @param {number} time ms */
  click(time) {
    if (this.hit && this.tool !== "hand" && this.tool !== "kick") {
      this.actions.use(this.tool, this.hit);
      return;
    }
    if (this.hit) return;
    if (time - this.lastClick < DOUBLE) this.letGo();
    this.lastClick = time;
  }

  /** Let go of everything this page holds. */
  letGo() {
    this.stage.session.send({ type: "let_go" });
  }

  /** @param {number} x @param {number} y */
  openMenu(x, y) {
    this.menuOpened = true;
    this.dropHand(false, false);
    this.actions.menu(this.hit, x, y);
  }

  /** @param {boolean} keep @param {boolean} [used] whether the hand did anything */
  dropHand(keep, used = true) {
    const { hand } = this;
    this.hand = null;
    if (hand && used) hand.release(keep);
    if (hand) this.hover(null);
  }

  /** @param {number} id @param {number} x @param {number} y */
  pinch(id, x, y) {
    const other = [...this.down.entries()].find(([key]) => key !== id)?.[1];
    const before = this.down.get(id);
    if (!other || !before) return;
    const [was, now] = [before, { x, y }].map((p) => Math.hypot(p.x - other.x, p.y - other.y));
    this.stage.camera.pan((x - before.x) / 2, (y - before.y) / 2);
    if (now > 1) this.stage.camera.zoom(was / now, (x + other.x) / 2, (y + other.y) / 2);
    this.down.set(id, { x, y });
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    event.preventDefault();
    const { x, y } = this.at(event);
    const lines = event.deltaMode === 1 ? 18 : 1;
    this.stage.flight = null;
    this.stage.camera.zoom(
      Math.exp(Math.max(-60, Math.min(60, event.deltaY * lines)) * 0.003),
      x,
      y,
    );
  }

  /** @param {Hit | null} hit */
  hover(hit) {
    const { marks } = this.stage;
    const place = hit?.place ?? null;
    if (place === null && marks.hover === null) return;
    marks.hover = place;
    marks.dirty = true;
    this.element.classList.toggle("over", place !== null);
  }
}
