// How the camera frames the ropes: all of them in the picture, clear of cards and of the legend, with their arrows.

import { covers, stripAside, stripsBeside, stripsBetween } from "./view/cards.js";
import { nodesOf, starts } from "./view/copies.js";
import { boxOf, firstAngles } from "./view/room.js";
import { inSight } from "./view/sight.js";
import { vector } from "./view/vector.js";
import { mostOf, roomFor, tipsOf, widened } from "./reactions.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./view/camera.js").Pose} Pose */
/** @typedef {import("./view/camera.js").Strips} Strips */
/** @typedef {{azimuth?: number, elevation?: number}} Angles */

const LEADS = 0.04; // of a rope: so far apart are the places that lead to an end
const ROUNDS = 3; // in which the room for arrows is found

export class Framing {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    this.besideLegend = false; // whether that would cover a rope
    this.right = false; // whether ropes are then to the right of it, not above
  }

  /** The pose for the first look. @param {Layout} layout @returns {Pose} */
  first(layout) {
    const { camera, axis, solids, lying } = this.viewport;
    const from = firstAngles(camera, axis, solids.all.length > 0, lying);
    const pose = this.clear(layout, from);
    if (axis >= 0 || solids.all.length === 0) return pose;
    const azimuth = inSight(camera, pose, [...this.ends(layout)], solids.all);
    return azimuth === pose.azimuth ? pose : this.clear(layout, { ...from, azimuth });
  }

  /** Where ropes end, and what leads there. @param {Layout} layout */
  *ends(layout) {
    const { to } = this.viewport.nodes;
    const first = starts(layout);
    for (const [k, { ropes }] of layout.variants.entries())
      for (const { first: start, nodes } of ropes)
        for (const share of [0, LEADS, 2 * LEADS]) {
          const away = Math.round(share * (nodes - 1));
          for (const i of [start + away, start + nodes - 1 - away])
            yield vector(to.subarray(4 * (first[k] + i), 4 * (first[k] + i) + 3));
        }
  }

  /** The pose that shows all ropes; if a card would cover one there, beside the card.
   * @param {Layout} layout @param {Angles} from @returns {Pose} */
  clear(layout, from) {
    this.besideLegend = false;
    const pose = this.whole(layout, from);
    return this.covered(pose) ? this.whole(layout, from) : pose;
  }

  /** The pose that shows all ropes, beside the card; above the legend or to its right, as they look larger.
   * @param {Layout} layout @param {Angles} from */
  whole(layout, from) {
    this.right = false;
    const above = this.framed(layout, from);
    if (!this.besideLegend || this.viewport.card()) return above;
    this.right = true;
    const beside = this.framed(layout, from);
    this.right = beside.distance < above.distance;
    return this.right ? beside : above;
  }

  /** @param {Layout} layout @param {Angles} from */
  framed(layout, from) {
    const { viewport } = this;
    const places = [...this.places(layout)];
    const framed = (/** @type {Strips} */ strips) => viewport.camera.framed(places, from, strips);
    return framed(this.roomIn(framed, this.strips()));
  }

  /** What arrows need beside the strips in a picture that leaves that room, not in the present one: there it would
   * be gone as soon as the camera has made it. @param {(room: Strips) => Pose | null} framed
   * @param {Strips} strips @returns {Strips} */
  roomIn(framed, strips) {
    const { viewport } = this;
    let room = strips;
    for (let round = 0; round < ROUNDS; round++) {
      const pose = framed(room);
      if (!pose) return strips;
      const wider = widened(room, roomFor(viewport, viewport.camera.at(pose), strips), strips);
      if (!wider) return room;
      room = mostOf(wider, strips, viewport.camera);
    }
    return room;
  }

  /** What the picture must hold: the nodes, and bodies. @param {Layout} layout */
  *places(layout) {
    const { to } = this.viewport.nodes;
    for (let i = 0; i < nodesOf(layout); i++) yield vector(to.subarray(4 * i, 4 * i + 3));
    yield* this.viewport.solids.places(boxOf(to, nodesOf(layout)));
  }

  /** Whether a card would cover a rope; the legend is kept clear of where it would. @param {Pose} pose */
  covered(pose) {
    const { session, camera, nodes, card, legendCard } = this.viewport;
    const { layout } = session;
    if (!layout) return false;
    const look = /** @type {const} */ ([camera.at(pose), nodes.to, nodesOf(layout)]);
    if (covers(...look, card())) return true;
    const under = covers(...look, legendCard());
    if (under) this.besideLegend = true;
    return under;
  }

  /** Whether a card covers a rope now, or the arrow of an anchor, or ropes have left the picture. */
  obstructed() {
    const { viewport } = this;
    const strips = this.strips();
    if (this.covered(viewport.camera.pose)) return true;
    if (!viewport.card() && !strips.right) return false; // nor tools that ropes go between
    const { camera, follower } = viewport; // with a card up nothing else brings back what has left the picture
    return (
      roomFor(viewport, camera, strips).top > strips.top + 1 ||
      follower.ropes.leaves(camera, strips)
    );
  }

  /** Whether the arrow of an anchor points out of the picture, to the side, or below the tools there. */
  losesArrow() {
    const { viewport } = this;
    const strips = this.strips();
    const { left = 0 } = strips;
    const tips = tipsOf(viewport, viewport.camera).map((tip) => viewport.camera.project(...tip)[0]);
    if (tips.some((x) => x < left || x > viewport.camera.width)) return true;
    const room = roomFor(viewport, viewport.camera, strips);
    return (room.left ?? 0) > left || (room.right ?? 0) > 0;
  }

  /** What cards take now: of a rope that sinks below the legend, too. */
  now() {
    if (!this.besideLegend) this.covered(this.viewport.camera.pose);
    return this.strips();
  }

  /** What a card takes of the scene [CSS pixels]. @returns {Strips} */
  strips() {
    const { card, legendCard, camera } = this.viewport;
    const legend = this.besideLegend ? legendCard() : null;
    const aside = this.right && !card() ? stripAside(legend, camera) : null;
    const beside = aside ?? stripsBeside(card() ?? legend, camera);
    return { ...beside, ...stripsBetween(this.viewport.bars(), camera) };
  }
}
