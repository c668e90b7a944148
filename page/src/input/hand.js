// The hand: what a drag of an anchor or a rope sends, at once, but not more often than is of use.

import { figures } from "../view/range.js";
import { length, minus, times } from "../view/vector.js";
import { ofFirst } from "./counterpart.js";
import { paceOf, throwOf } from "./throw.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("./pick.js").Hit} Hit */
/** @typedef {import("../view/vector.js").Vector} Vector */

const APART = 8; // ms between two targets at least
const RECENT = 80; // ms before its release in which the hand's velocity is taken
const TRACE = 40; // places of late that are kept
const THROW = 0.05; // [m/s] of a throw at least
const KICK = 0.05; // [m/s] of velocity per pixel of arrow

export class Hand {
  /** @param {Viewport} viewport @param {Hit} hit @param {"drag" | "grab" | "kick" | "tie"} way */
  constructor(viewport, hit, way) {
    this.viewport = viewport;
    this.hit = hit;
    this.way = way;
    this.node = ofFirst(viewport.session.layout, hit).node; // which commands name
    /** @type {Vector} where the pointer has it, in the picture */
    this.place = hit.place;
    this.sent = -Infinity; // when [ms]
    this.pending = 0;
    /** Where it was of late. @type {import("./throw.js").Trace} */ this.trace = [];
    /** The largest force of a pull [N]; null: what hands may at most. @type {number | null} */
    this.limit = null;
  }

  /** @param {number} px @param {number} py @param {number} time of the event [ms] */
  moveTo(px, py, time) {
    const { viewport, hit } = this;
    this.place = viewport.camera.onPlane(px, py, hit.place, viewport.axis);
    if (this.way === "kick") {
      const text = `${figures(length(this.velocity()))} m/s`;
      viewport.marks.kick = { from: hit.place, to: this.place, text };
      viewport.marks.dirty = true;
      return;
    }
    if (this.way === "tie") {
      viewport.marks.line = { hit, to: this.place };
      viewport.marks.dirty = true;
      return;
    }
    viewport.marks.held.add(this);
    viewport.marks.dirty = true;
    this.trace.push({ time, place: this.place });
    if (this.trace.length > TRACE) this.trace.shift();
    const wait = this.sent + APART - performance.now();
    if (wait <= 0) this.sendTarget();
    else this.pending ||= window.setTimeout(() => this.sendTarget(), wait);
  }

  sendTarget() {
    clearTimeout(this.pending);
    this.pending = 0;
    if (this.over) return;
    this.sent = performance.now();
    const target = minus(this.place, this.viewport.shifts[this.hit.variant]);
    const { hit, limit } = this;
    const { session } = this.viewport;
    const pace = paceOf(session.frame, session.status);
    if (hit.kind === "anchor") session.send({ type: "drag", anchor: hit.anchor, target, pace });
    else session.send({ type: "grab", node: this.node, target, pace, limit });
  }

  /** The velocity of a kick [m/s], as long as its arrow is on the screen. */
  velocity() {
    const { camera } = this.viewport;
    const perPixel = camera.pose.distance / camera.focal;
    return times(minus(this.place, this.hit.place), KICK / perPixel);
  }

  /** The pointer is up. @param {boolean} keep hold on to a grabbed node @param {number} time of the event [ms] */
  release(keep, time) {
    const { session, marks } = this.viewport;
    marks.held.delete(this);
    marks.dirty = true;
    if (this.way === "tie") {
      marks.line = null;
    } else if (this.way === "kick") {
      marks.kick = null;
      const velocity = this.velocity();
      if (length(velocity) > 0.05) session.tell({ type: "kick", node: this.node, velocity });
    } else if (this.hit.kind === "anchor") {
      this.sendTarget();
      session.send({ type: "drop", anchor: this.hit.anchor });
    } else if (keep) this.sendTarget();
    else {
      const pace = paceOf(session.frame, session.status);
      const thrown = session.status?.playing
        ? times(throwOf(this.trace, time, RECENT), 1 / pace)
        : [0, 0, 0];
      const velocity = length(thrown) > THROW ? thrown : null;
      session.send({ type: "let_go", node: this.node, velocity });
    }
    this.over = true;
  }

  over = false;
}
