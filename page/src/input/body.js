// Obstacles in the hand: which one is under the pointer, a stroke that moves or turns it, and keys that do.

import { meets } from "../view/solids.js";
import { cross, dot, minus, plus, times, unit } from "../view/vector.js";
import { paceOf } from "./throw.js";

/** @typedef {import("../viewport.js").Viewport} Viewport */
/** @typedef {import("../view/vector.js").Vector} Vector */
/** @typedef {import("./pick.js").BodyHit} BodyHit */

const APART = 16; // ms between two targets at least
const STEP = 0.02; // radii of the scene that an arrow key moves a body
const TURN = Math.PI / 12; // that a key turns it, as the menu does
const FACING = 0.5; // cosine of axis and view, above which a body is turned like a wheel that is looked at
const HELD = 400; // ms within which a key goes on from its last target

/** The nearest body under a pixel that has an end: a floor or an endless bar is the scene's frame.
 * @param {Viewport} viewport @param {number} px @param {number} py @returns {BodyHit | null} */
export function pickBody(viewport, px, py) {
  const { camera, session } = viewport;
  if (!session.can("obstacle")) return null;
  const ray = camera.ray(px, py);
  const size = Math.hypot(...ray);
  const way = times(ray, 1 / size);
  let nearest = Infinity;
  /** @type {BodyHit | null} */
  let best = null;
  for (const solid of viewport.solids.all) {
    const takes = Number.isFinite(solid.reach) && movable(viewport, solid.name);
    const far = takes ? meets(solid, camera.eye, way) : null;
    if (far === null || far >= nearest) continue;
    nearest = far;
    const place = plus(camera.eye, way, far);
    best = { kind: "obstacle", variant: 0, obstacle: solid.name, node: -1, segment: -1, place };
  }
  return best;
}

/** Whether a hand can turn it. @param {Viewport} viewport @param {string} name */
export const turnable = (viewport, name) =>
  (viewport.session.layout?.obstacles ?? []).some((one) => one.name === name && one.turnable);

/** Whether a hand can move it. @param {Viewport} viewport @param {string} name */
export const movable = (viewport, name) =>
  (viewport.session.layout?.obstacles ?? []).some((one) => one.name === name && one.movable);

/** A stroke on a body: like a `Hand` for what pointers ask of it. */
export class BodyHand {
  /** @param {Viewport} viewport @param {BodyHit} hit @param {boolean} turning */
  constructor(viewport, hit, turning) {
    this.viewport = viewport;
    this.hit = hit;
    this.way = /** @type {const} */ ("body");
    this.place = hit.place;
    this.turning = turning && turnable(viewport, hit.obstacle);
    this.start = viewport.solids.base(hit.obstacle);
    this.angle = viewport.solids.angleOf(hit.obstacle);
    this.begun = false;
    this.sent = -Infinity;
    this.pending = 0;
    /** @type {number | null} */ this.limit = null;
    /** @type {{x: number, y: number} | null} */ this.last = null;
  }

  /** @param {number} px @param {number} py */
  moveTo(px, py) {
    const { viewport, hit, last } = this;
    if (this.turning) {
      if (last) this.angle += this.turnBetween(last, { x: px, y: py });
      this.last = { x: px, y: py };
    } else this.place = viewport.camera.onPlane(px, py, hit.place, viewport.axis);
    const wait = this.sent + APART - performance.now();
    if (wait <= 0) this.sendTarget();
    else this.pending ||= window.setTimeout(() => this.sendTarget(), wait);
  }

  /** The angle of a stroke: around the axle of what faces the eye, else across the axis.
   * @param {{x: number, y: number}} from @param {{x: number, y: number}} to */
  turnBetween(from, to) {
    const { camera, solids } = this.viewport;
    const solid = solids.named(this.hit.obstacle);
    if (!solid) return 0;
    const [cx, cy, depth] = camera.project(...minus(solid.center, solid.middle));
    const facing = dot(solid.axle, camera.toward);
    if (Math.abs(facing) > FACING) {
      const [a, b] = [from, to].map(({ x, y }) => Math.atan2(cy - y, x - cx));
      const turned = b - a - 2 * Math.PI * Math.round((b - a) / (2 * Math.PI));
      return Math.sign(facing) * turned;
    }
    const side = unit(cross(solid.axle, camera.toward)); // the way its near face goes
    const moved = plus(times(camera.right, to.x - from.x), camera.top, from.y - to.y);
    const perPixel = depth / camera.focal;
    return (
      (dot(moved, side) * perPixel) / Math.max(solid.surface ? solid.reach : solid.size[0], 1e-9)
    );
  }

  sendTarget() {
    clearTimeout(this.pending);
    this.pending = 0;
    if (this.over || !this.start) return;
    this.sent = performance.now();
    const { session } = this.viewport;
    const moved = minus(this.place, this.hit.place);
    const target = this.turning ? null : plus(this.start, moved);
    lead(this.viewport, this.hit.obstacle, target, this.turning ? this.angle : null, !this.begun);
    this.begun = this.begun || session.can("obstacle");
  }

  /** The pointer is up: it rests where it was led to. */
  release() {
    if (this.pending) this.sendTarget();
    this.over = true;
  }

  over = false;

  get ring() {
    return this.place;
  }
}

/** @param {Viewport} viewport @param {string} obstacle @param {Vector | null} target @param {number | null} angle
 * @param {boolean} begin of a stroke: all of it is undone at once */
export function lead({ session }, obstacle, target, angle, begin) {
  const pace = paceOf(session.frame, session.status);
  session.send({ type: "obstacle", obstacle, target, angle, pace, begin });
}

/** The keys of a body that Tab has stopped at. */
export class BodyKeys {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    /** @type {{name: string, place: Vector, angle: number, time: number} | null} */ this.goal =
      null;
  }

  /** Move or turn it; tells whether the key is one of those. @param {string} name @param {string} code */
  press(name, code) {
    const { viewport } = this;
    const { camera, solids, session } = viewport;
    const step = STEP * (session.layout?.view.radius ?? 1);
    /** @type {Record<string, Vector>} */
    const ways = {
      ArrowLeft: times(camera.first, -step),
      ArrowRight: times(camera.first, step),
      ArrowUp: times(camera.up, step),
      ArrowDown: times(camera.up, -step),
      Home: times(camera.second, step),
      End: times(camera.second, -step),
    };
    const turn = { PageUp: TURN, PageDown: -TURN }[code];
    const way = ways[code];
    const place = solids.base(name);
    if ((!way && turn === undefined) || !place || !session.can("obstacle")) return false;
    const now = performance.now();
    const goes = this.goal?.name === name && now - this.goal.time < HELD ? this.goal : null;
    const goal = goes ?? { name, place, angle: solids.angleOf(name), time: now };
    if (way) goal.place = plus(goal.place, way);
    else if (turnable(viewport, name)) goal.angle += turn ?? 0;
    else return true;
    goal.time = now;
    this.goal = goal;
    lead(viewport, name, way ? goal.place : null, way ? null : goal.angle, !goes);
    return true;
  }
}
