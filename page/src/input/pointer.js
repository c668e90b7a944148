// Mouse, pen and fingers on the scene: turn, shift and zoom the view; take hold of anchors and ropes.

import { ofFirst } from "./counterpart.js";
import { Hand } from "./hand.js";
import { BodyHand, pickBody } from "./body.js";
import { pick } from "./pick.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("./pick.js").Hit} Hit */
/** @typedef {import("./pick.js").BodyHit} BodyHit */
/** @typedef {"hand" | "pin" | "cut" | "load" | "tie" | "kick" | "follow"} Tool */

const MOUSE = 18; // pixels from a rope that still take hold of it
const FINGER = 30;
const NEAR = 2.2; // times as far: a near miss
const CLICK = 5; // pixels a click may move
const LONG = 550; // ms of a long press, which opens the menu on a touch screen
const DOUBLE = 350; // ms

export class Pointer {
  /** @param {Viewport} viewport @param {HTMLElement} element
   * @param {{use: (tool: Tool, hit: Hit) => void, tie: (one: Hit, other: Hit) => void,
   *   menu: (hit: Hit | BodyHit | null, x: number,
   *   y: number) => void}} actions */
  constructor(viewport, element, actions) {
    this.viewport = viewport;
    this.element = element;
    this.actions = actions;
    /** @type {Tool} */ this.tool = "hand";
    this.keep = false; // grabs stay when the pointer is up
    /** The largest force of a pull [N]; null: what hands may at most. @type {number | null} */
    this.limit = null;
    /** @type {Map<number, {x: number, y: number}>} */ this.down = new Map();
    /** The hand of each pointer: on a touch screen there may be several. @type {Map<number, Hand | BodyHand>} */
    this.hands = new Map();
    this.near = false; // the press just missed a rope: it is not meant to turn the scene
    /** Where the mouse rests. @type {{x: number, y: number} | null} */ this.resting = null;
    /** @type {Hit | null} */ this.hit = null;
    /** The body under the press, where no rope is. @type {BodyHit | null} */ this.body = null;
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
    element.addEventListener("pointerleave", () => {
      this.resting = null;
      this.hover(null);
    });
    viewport.beforeDraw.push(() => this.look());
    let ropes = "";
    viewport.session.on("layout", ({ variants }) => {
      const now = JSON.stringify(
        variants.map((one) => one.ropes.map(({ first, nodes }) => [first, nodes])),
      );
      if (now !== ropes && this.hands.size > 0) this.leaveOff(); // its node has another number
      ropes = now;
    });
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
    return event.pointerType === "mouse" ? MOUSE : FINGER;
  }

  /** @param {PointerEvent} event */
  press(event) {
    this.element.setPointerCapture(event.pointerId);
    const { x, y } = this.at(event);
    this.down.set(event.pointerId, { x, y });
    this.viewport.flight = null;
    if (this.down.size > 1) {
      clearTimeout(this.longPress);
      const other = this.hands.size > 0 ? pick(this.viewport, x, y, this.reach(event)) : null;
      if (other && this.hold(event.pointerId, other)) return; // a second hand
      this.dropHands(false); // a second finger: pinch
      this.moved = true;
      return;
    }
    this.start = { x, y, button: event.button, shift: event.shiftKey };
    this.moved = this.menuOpened = false;
    this.hit = pick(this.viewport, x, y, this.reach(event));
    this.body = this.hit ? null : pickBody(this.viewport, x, y);
    this.near =
      !this.hit && !this.body && pick(this.viewport, x, y, NEAR * this.reach(event)) !== null;
    if (event.button === 0 && this.hit && !(event.ctrlKey || event.metaKey))
      this.hold(event.pointerId, this.hit);
    else if (event.button === 0 && this.body && this.tool === "hand")
      this.hands.set(event.pointerId, new BodyHand(this.viewport, this.body, event.shiftKey));
    if (event.pointerType !== "mouse") {
      this.longPress = window.setTimeout(() => this.openMenu(x, y), LONG);
    }
  }

  /** Take hold of something; tells whether there is anything to do with it. @param {number} id of the pointer
   * @param {Hit} hit */
  hold(id, hit) {
    const { tool } = this;
    if (tool !== "hand" && tool !== "kick" && tool !== "tie") return false;
    const way = tool !== "hand" ? tool : hit.kind === "anchor" ? "drag" : "grab";
    if (!this.viewport.session.can(way)) return false;
    const hand = new Hand(this.viewport, hit, way);
    hand.limit = this.limit;
    this.hands.set(id, hand);
    return true;
  }

  /** @param {PointerEvent} event */
  move(event) {
    const { x, y } = this.at(event);
    const before = this.down.get(event.pointerId);
    if (!before) {
      this.resting = event.pointerType === "mouse" ? { x, y } : null;
      this.look();
      return;
    }
    if (this.down.size === 2 && this.hands.size < 2) {
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
    const hand = this.hands.get(event.pointerId);
    if (hand) {
      hand.moveTo(x, y, event.timeStamp);
      const over = hand.way === "tie" ? pick(this.viewport, x, y, this.reach(event)) : null;
      this.viewport.marks.hover = hand instanceof BodyHand ? hand.ring : over;
      this.viewport.marks.dirty = true;
    } else if (this.hands.size) return;
    else if (start.button !== 0 || start.shift || this.near) this.viewport.camera.pan(dx, dy);
    else this.viewport.camera.orbit(dx, dy);
  }

  /** The same before the next animation frame, where the browser tells: the hand need not wait for it.
   * @param {PointerEvent} event */
  drag(event) {
    const hand = this.hands.get(event.pointerId);
    if (!hand || !this.moved || this.menuOpened) return;
    const { x, y } = this.at(event);
    hand.moveTo(x, y, event.timeStamp);
  }

  /** @param {PointerEvent} event */
  lift(event) {
    if (!this.down.delete(event.pointerId)) return;
    clearTimeout(this.longPress);
    const { x, y } = this.at(event);
    const hand = this.hands.get(event.pointerId);
    if (hand && this.moved) hand.moveTo(x, y, event.timeStamp);
    const ties = hand?.way === "tie" && this.moved && !this.menuOpened;
    const other = ties ? pick(this.viewport, x, y, this.reach(event)) : null;
    const hadHand = hand !== undefined && this.moved;
    this.dropHand(event.pointerId, event.shiftKey || this.keep, this.moved, event.timeStamp);
    const { layout } = this.viewport.session;
    if (hand instanceof Hand && other && ofFirst(layout, other).node !== hand.node)
      this.actions.tie(hand.hit, other);
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
    if (this.hit || this.body) return;
    if (time - this.lastClick < DOUBLE) this.letGo();
    this.lastClick = time;
  }

  /** Let go of everything this page holds. */
  letGo() {
    this.viewport.session.send({ type: "let_go" });
  }

  /** @param {number} x @param {number} y */
  openMenu(x, y) {
    this.menuOpened = true;
    this.dropHands(false, false);
    this.actions.menu(this.hit ?? this.body, x, y);
  }

  /** @param {number} id of the pointer @param {boolean} keep @param {boolean} [used] whether the hand did
   * anything @param {number} [time] of the event [ms] */
  dropHand(id, keep, used = true, time = Infinity) {
    const hand = this.hands.get(id);
    if (!hand) return;
    this.hands.delete(id);
    if (used) hand.release(keep, time);
    this.hover(null);
  }

  /** @param {boolean} keep @param {boolean} [used] */
  dropHands(keep, used = true) {
    for (const id of [...this.hands.keys()]) this.dropHand(id, keep, used);
  }

  /** Let go though the pointer is still down: what it held is another thing from now on. */
  leaveOff() {
    this.dropHands(false);
    this.menuOpened = this.down.size > 0;
  }

  /** Ring what lies under the resting mouse now: ropes move under it. */
  look() {
    if (this.down.size) return;
    const { resting } = this;
    const over = resting && pick(this.viewport, resting.x, resting.y, MOUSE);
    const takes = resting && !over && this.tool === "hand";
    this.hover(
      over ?? (takes ? (pickBody(this.viewport, resting.x, resting.y)?.place ?? null) : null),
    );
  }

  /** @param {number} id @param {number} x @param {number} y */
  pinch(id, x, y) {
    const other = [...this.down.entries()].find(([key]) => key !== id)?.[1];
    const before = this.down.get(id);
    if (!other || !before) return;
    const [was, now] = [before, { x, y }].map((p) => Math.hypot(p.x - other.x, p.y - other.y));
    this.viewport.camera.pan((x - before.x) / 2, (y - before.y) / 2);
    if (now > 1) this.viewport.camera.zoom(was / now, (x + other.x) / 2, (y + other.y) / 2);
    this.down.set(id, { x, y });
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    event.preventDefault();
    const { x, y } = this.at(event);
    const lines = event.deltaMode === 1 ? 18 : 1;
    this.viewport.flight = null;
    this.viewport.camera.zoom(
      Math.exp(Math.max(-60, Math.min(60, event.deltaY * lines)) * 0.003),
      x,
      y,
    );
  }

  /** @param {Hit | import("../view/vector.js").Vector | null} hit */
  hover(hit) {
    const { marks } = this.viewport;
    if (hit === null && marks.hover === null) return;
    marks.hover = hit;
    marks.dirty = true;
    this.element.classList.toggle("over", hit !== null);
  }
}
