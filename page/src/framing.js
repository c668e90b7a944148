// How the camera frames the ropes: all of them in the picture, clear of cards and of the legend, with their arrows.

import { covers, stripAside, stripsBeside } from "./view/cards.js";
import { nodesOf } from "./view/copies.js";
import { firstAngles } from "./view/room.js";
import { vector } from "./view/vector.js";
import { roomFor, tipsOf } from "./reactions.js";

/** @typedef {import("./stage.js").Stage} Stage */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./view/camera.js").Pose} Pose */
/** @typedef {import("./view/camera.js").Strips} Strips */
/** @typedef {{azimuth?: number, elevation?: number}} Angles */

export class Framing {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.besideLegend = false; // whether that would cover a rope
    this.right = false; // whether ropes are then to the right of it, not above
  }

  /** The pose for the first look. @param {Layout} layout @returns {Pose} */
  first(layout) {
    const { camera, axis, solids, lying } = this.stage;
    return this.clear(layout, firstAngles(camera, axis, solids.all.length > 0, lying));
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
    if (!this.besideLegend || this.stage.card()) return above;
    this.right = true;
    const beside = this.framed(layout, from);
    this.right = beside.distance < above.distance;
    return this.right ? beside : above;
  }

  /** @param {Layout} layout @param {Angles} from */
  framed(layout, from) {
    const { stage } = this;
    const strips = this.strips();
    const pose = stage.camera.framed(this.places(layout), from, strips);
    const room = roomFor(stage, stage.camera.at(pose), strips);
    return stage.camera.framed(this.places(layout), from, room);
  }

  /** What the picture must hold: the nodes, and bodies. @param {Layout} layout */
  *places(layout) {
    const { to } = this.stage.nodes;
    for (let i = 0; i < nodesOf(layout); i++) yield vector(to.subarray(4 * i, 4 * i + 3));
    yield* this.stage.solids.places();
  }

  /** Whether a card would cover a rope; the legend is kept clear of where it would. @param {Pose} pose */
  covered(pose) {
    const { session, camera, nodes, card, legendCard } = this.stage;
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
    const { stage } = this;
    const strips = this.strips();
    if (this.covered(stage.camera.pose)) return true;
    if (!stage.card()) return false;
    const { camera, follower } = stage; // with a card up nothing else brings back what has left the picture
    return roomFor(stage, camera, strips).top > strips.top + 1 || follower.leaves(camera, strips);
  }

  /** Whether the arrow of an anchor points out of the picture, to the side. */
  losesArrow() {
    const { stage } = this;
    const { left = 0 } = this.strips();
    const tips = tipsOf(stage, stage.camera).map((tip) => stage.camera.project(...tip)[0]);
    return tips.some((x) => x < left || x > stage.camera.width);
  }

  /** What cards take now: of a rope that sinks below the legend, too. */
  now() {
    if (!this.besideLegend) this.covered(this.stage.camera.pose);
    return this.strips();
  }

  /** What a card takes of the scene [CSS pixels]. @returns {Strips} */
  strips() {
    const { card, legendCard, camera } = this.stage;
    const legend = this.besideLegend ? legendCard() : null;
    const aside = this.right && !card() ? stripAside(legend, camera) : null;
    return aside ?? stripsBeside(card() ?? legend, camera);
  }
}
