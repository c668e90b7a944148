// The floor of a scene that has no ground: below all that its ropes can reach, and it gives way.

import { nodesOf } from "./view/copies.js";
import { lowest } from "./view/follow.js";
import { dot, vector } from "./view/vector.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/protocol.js").Layout} Layout */

const BELOW = 0.12; // of the ropes' extent, below the lowest place they can reach
const CLEAR = 0.03; // of the ropes' extent, by which a body must be lower than they to stand on the floor
const STEP = 0.1; // radii of the scene, by which it goes below what came through it
const DEEPEST = 4; // radii of the scene: what is lower fell off

export class Floor {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    this.height = 0; // along up [m]
    this.goal = 0; // where it goes
  }

  /** The height of the ground or of a level plane, or of the floor where there is none [m]. */
  get level() {
    return this.given ?? this.height;
  }

  /** The height of what ropes land on [m], null where there is nothing. */
  get given() {
    const { session, solids } = this.viewport;
    return session.layout?.ground?.height ?? solids.floor;
  }

  /** Put it below all that ropes can reach. @param {Layout} layout @param {import("./view/camera.js").Box} box
   * of the ropes */
  put(layout, box) {
    const { camera, nodes, starts } = this.viewport;
    const { up } = camera;
    const placeOf = (/** @type {number} */ node) =>
      vector(nodes.to.subarray(4 * node, 4 * node + 3));
    const { solids } = this.viewport; // what holds ropes up by touching them lets none hang to its length
    const hanging = solids.all.length ? [] : layout.variants;
    const levels = hanging.flatMap(({ ropes, anchors }, v) =>
      ropes.map((rope) => lowest(anchors, rope, (node) => placeOf(starts[v] + node), up)),
    );
    const size = Math.hypot(...box.high.map((value, k) => value - box.low[k]));
    const now = Math.min(...[box.low, box.high].map((corner) => dot(corner, up)));
    const ropes = Math.min(...levels, now);
    const body = solids.lowest(); // that stands on the floor where it is lower than all ropes
    const height = body < ropes - CLEAR * size ? body : Math.min(ropes, body) - BELOW * size;
    if (Number.isFinite(height)) this.height = this.goal = height;
  }

  /** Let it give way to ropes that came through. @param {Layout} layout */
  giveWay(layout) {
    if (this.given !== null) return;
    const { up } = this.viewport.camera;
    const { to } = this.viewport.nodes;
    const { center, radius } = layout.view;
    let least = Infinity;
    for (let i = 0; i < 4 * nodesOf(layout); i += 4) {
      least = Math.min(least, to[i] * up[0] + to[i + 1] * up[1] + to[i + 2] * up[2]);
    }
    const deepest = dot(center, up) - DEEPEST * radius;
    if (least < this.height && least >= deepest)
      this.goal = Math.min(this.goal, least - STEP * radius);
    const body = this.viewport.solids.lowest(); // one that a hand leads down
    if (body < this.height && body >= deepest) this.goal = Math.min(this.goal, body);
  }

  /** Once per animation frame. */
  advance() {
    const away = this.goal - this.height;
    const { layout } = this.viewport.session;
    if (away === 0 || !layout) return;
    this.height += Math.abs(away) < 0.003 * layout.view.radius ? away : 0.08 * away;
    this.viewport.dirty = true;
  }
}
