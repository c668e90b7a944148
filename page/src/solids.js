// The bodies of a scene: what is drawn of them, where the floor is, and what the picture must hold.

import { MOST_SOLIDS, cornersOf, extent, leaves, placed, solidsOf, turnOf } from "./view/solids.js";
import { scalar } from "./source/frame.js";
import { dot, length, minus, plus, times, vector } from "./view/vector.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./view/solids.js").Solid} Solid */
/** @typedef {import("./view/vector.js").Vector} Vector */
/** @typedef {import("./source/protocol.js").Layout} Layout */

const ROOM = 1.3; // radii of the scene: what of a large body is farther away need not be in the picture
const NEAR = 0.6; // of the ropes' extent: a body that is farther from them need not, either
const BESIDE = 0.25; // of it, up to which a body that goes on beyond the ropes is shown
const WHEEL = /^turn\d+$/; // scalars of a frame, in their order
const LEVEL = 0.9999; // cosine of the tilt up to which a plane is a floor

export class Solids {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    /** @type {Solid[]} */ this.all = [];
    /** Those at time zero. @type {Solid[]} */ this.starts = [];
    /** Planes that are nothing but floor. @type {Solid[]} */ this.level = [];
    this.time = NaN; // [s] for which those that move are placed
    /** Height of the highest level plane, which is the floor [m]. @type {number | null} */
    this.floor = null;
    this.key = "";
    this.version = 0; // changes with them
    viewport.session.on("obstacles", () => {
      if (viewport.session.layout) this.take(viewport.session.layout, viewport.shifts);
      viewport.dirty = true;
    });
  }

  /** @param {Layout} layout @param {number[][]} shifts [m] of the copies */
  take(layout, shifts) {
    const key = JSON.stringify([layout.obstacles ?? [], shifts, layout.up]);
    if (key === this.key) return;
    this.key = key;
    const found = solidsOf((layout.obstacles ?? []).slice(0, MOST_SOLIDS), shifts);
    const { up } = this.viewport.camera;
    const level = found.filter(
      ({ kind, axis, motion }) => kind === "plane" && !motion && dot(axis, up) > LEVEL,
    );
    const heights = level.map(({ center }) => dot(center, up));
    this.floor = heights.length ? Math.max(...heights) : null;
    this.starts = found.filter(
      (one) => !level.includes(one) || one.spin || one.turns || one.wheel !== null,
    );
    this.all = this.starts;
    this.level = level.filter((one) => !this.starts.includes(one));
    this.version++;
    this.time = NaN;
    this.advance();
  }

  /** The time of the bodies' motions [s]: a replay's parts have each its own. */
  clock() {
    const { frame, layout } = this.viewport.session;
    return (frame?.time ?? 0) - (layout?.later ?? 0);
  }

  /** Put those that move where they are now. */
  advance() {
    const time = this.clock();
    if (time === this.time) return;
    this.time = time;
    if (!this.starts.some(leaves)) return;
    const told = this.told();
    this.all = this.starts.map((one) => placed(one, time, told));
    this.version++;
  }

  /** A body, of the first copy; or what is the floor. @param {string} name */
  named(name) {
    return [...this.all, ...this.level].find((one) => one.name === name) ?? null;
  }

  /** Where a body's middle is, as the server has it [m]. @param {string} name @returns {Vector | null} */
  base(name) {
    const found = this.named(name);
    if (!found) return null;
    return minus(minus(found.center, found.middle), this.viewport.shifts[0] ?? [0, 0, 0]);
  }

  /** How far a body has turned [rad]. @param {string} name */
  angleOf(name) {
    return this.turns()[this.all.findIndex((one) => one.name === name)] ?? 0;
  }

  /** How far those have that turn freely [rad]. */
  told() {
    const { frame, layout } = this.viewport.session;
    const part = frame?.parts[0];
    if (!layout || !part) return [];
    return layout.scalars
      .filter((name) => WHEEL.test(name))
      .map((name) => scalar(layout, part, name));
  }

  /** How far each has turned [rad]. */
  turns() {
    const time = this.clock();
    const told = this.told();
    return this.all.map((one) => turnOf(one, time, told));
  }

  /** What of them a picture of ropes must hold: what is near them. @param {import("./view/camera.js").Box} ropes
   * @returns {Vector[]} */
  places(ropes) {
    const { layout } = this.viewport.session;
    if (!layout) return [];
    const { center, radius } = layout.view;
    return this.all
      .filter(({ reach }) => Number.isFinite(reach))
      .flatMap((solid) => partNear(cornersOf(solid), ropes))
      .map((corner) => {
        const away = minus(corner, center);
        const far = length(away);
        return far > ROOM * radius ? plus(center, times(away, (ROOM * radius) / far)) : corner;
      });
  }

  /** The height of the lowest of them [m]. */
  lowest() {
    const { up } = this.viewport.camera;
    const low = this.all
      .filter(({ reach }) => Number.isFinite(reach))
      .map((one) => dot(one.center, up) - extent(one, up));
    return Math.min(Infinity, ...low);
  }
}

/** The corners of a body, or of what of it is near the ropes. @param {Vector[]} corners
 * @param {import("./view/camera.js").Box} ropes @returns {Vector[]} */
export function partNear(corners, { low, high }) {
  const size = Math.max(...high.map((value, k) => value - low[k]));
  if (!Number.isFinite(size)) return corners; // there are none
  const least = low.map((_, k) => Math.min(...corners.map((corner) => corner[k])));
  const most = low.map((_, k) => Math.max(...corners.map((corner) => corner[k])));
  const away = low.map((value, k) => Math.max(least[k] - high[k], value - most[k]));
  if (away.some((far) => far > NEAR * size)) return [];
  const room = away.map((far) => (far > 0 ? NEAR : BESIDE) * size);
  return corners.map((corner) =>
    vector(
      corner.map((value, k) => Math.min(high[k] + room[k], Math.max(low[k] - room[k], value))),
    ),
  );
}
