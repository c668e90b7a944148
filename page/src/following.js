// The camera goes with the ropes, calmly, until the user moves it.

import { Pieces } from "./view/bound.js";
import { Chase } from "./view/chase.js";
import { Follow } from "./view/follow.js";
import { plus } from "./view/vector.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./view/camera.js").Pose} Pose */

const LONGEST = 0.2; // s between two frames

export class Following {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    this.ropes = new Follow();
    /** @type {Pieces | null} */ this.bound = null;
    /** @type {import("./view/camera.js").Strips} */ this.strips = { top: 0, bottom: 0 };
    this.looked = 0; // ms
  }

  /** Take over where the ropes are, and set off where they leave the picture. @param {Layout} layout
   * @param {number} now ms */
  take(layout, now) {
    const { viewport, ropes } = this;
    const { camera, framing, solids } = viewport;
    const seconds = Math.min(LONGEST, (now - this.looked) / 1000);
    this.looked = now;
    ropes.take(camera, viewport.nodes.to, this.pieces(layout), seconds, layout.view);
    ropes.hold(camera, solids.places(ropes.box(camera)));
    viewport.floor.giveWay(layout);
    if (camera.version !== viewport.ownVersion && !viewport.flight) viewport.following = false;
    if (!viewport.following || viewport.held()) return;
    this.strips = framing.now();
    const room = framing.roomIn((strips) => ropes.goal(camera, strips), this.strips);
    const goal = ropes.goal(camera, room);
    const { flight } = viewport;
    if (flight instanceof Chase) {
      const near = Math.min(flight.to.distance, flight.pose.distance);
      if (goal) flight.to = ropes.calm(goal, near);
    } else if (!flight && framing.losesArrow())
      this.chase(goal && ropes.calm(goal, camera.pose.distance), now);
    else if (!flight) this.chase(ropes.wanted(camera, this.strips, room), now);
  }

  /** The ropes as they hang together, and whether anything holds them. @param {Layout} layout */
  pieces(layout) {
    const { session, gaps, starts } = this.viewport;
    const parts = session.frame?.parts;
    const holds = (/** @type {number} */ v, /** @type {number} */ a) =>
      (parts?.[v]?.anchors[10 * a + 9] ?? 1) >= 0.5;
    const shape = gaps.shape(layout);
    if (this.bound?.shape !== shape) this.bound = new Pieces(layout, shape, starts);
    return this.bound.held(holds);
  }

  /** @param {Pose | null} pose null: the camera may stay @param {number} now ms */
  chase(pose, now) {
    const { viewport } = this;
    if (!pose) return;
    viewport.ownVersion = viewport.camera.version;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) viewport.setPose(pose);
    else viewport.flight = new Chase(viewport.camera.pose, pose, now);
  }

  /** Once per animation frame: go on with a flight, and along with ropes that nothing holds.
   * @param {number} now ms */
  advance(now) {
    const { viewport, ropes } = this;
    const { flight, camera } = viewport;
    const { layout } = viewport.session;
    /** @type {import("./view/vector.js").Vector} */
    const by =
      layout && this.goes()
        ? ropes.goes(camera, viewport.nodes.shown, this.pieces(layout), layout.view)
        : [0, 0, 0];
    if (flight instanceof Chase) flight.carry(by);
    else if (by.some((part) => part !== 0) && !flight)
      viewport.setPose({ ...camera.pose, target: plus(camera.pose.target, by) });
    const step = flight?.at(now);
    if (!step) return;
    const follows = flight instanceof Chase && !viewport.past;
    if (follows) flight.pose = ropes.keep(camera, step.pose, this.strips);
    viewport.setPose(follows ? flight.pose : step.pose);
    if (step.over) viewport.land();
  }

  /** Whether the camera goes along now. */
  goes() {
    const { viewport } = this;
    const own = viewport.following && viewport.camera.version === viewport.ownVersion;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    return own && !viewport.past && !viewport.held() && !still;
  }
}
