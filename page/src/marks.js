// What stands beside the ropes: anchors, loads, reactions, the hand, trails, and labels in newtons.

import { ROPES, fromHex } from "./view/colours.js";
import { quantity } from "./view/range.js";
import { dot, plus, vector } from "./view/vector.js";
import { alike } from "./input/counterpart.js";
import { placeOf } from "./input/pick.js";
import {
  CROWD,
  drawnOf,
  forceText,
  hasTail,
  holding,
  crowded,
  nameOf,
  numberedOf,
  scaleOf,
  strongestOf,
  tipOf,
} from "./reactions.js";
import { CONTACT, arrowsOf, firmestOf, pushesOf } from "./touches.js";
import { Trails, fliers } from "./render/trails.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./source/protocol.js").Variant} Variant */
/** @typedef {import("./source/frame.js").Frame} Frame */
/** @typedef {import("./render/view.js").Marker} Marker */
/** @typedef {import("./render/view.js").Arrow} Arrow */
/** @typedef {import("./view/vector.js").Vector} Vector */
/** @typedef {import("./input/pick.js").Hit} Hit */
/** @typedef {{id: string, from: Vector, at: Vector, text: string,
 *   kind: "reaction" | "given" | "grab" | "kick"}} Label beside the tip of an arrow; `id` tells it from others */

const MOST_LABELS = CROWD;
const MOST_POSTS = 24;
const MANY = 12; // anchors
const STILL = new Set(["fixed", "velocity", "table"]); // motions of anchors that may stand on a post
const BEHIND = 9; // that a post stands behind a rope that hangs before it [CSS pixels]
const FOOT = 5; // height of a post's foot [CSS pixels]

/** The force of a hand, and whether it can pull no harder. @param {number} force @param {number} most [N] */
const pulls = (force, most) =>
  `${quantity(force, "N")}${most > 0 && force > 0.995 * most ? " (no more)" : ""}`;

export class Marks {
  /** @param {Viewport} viewport */
  constructor(viewport) {
    this.viewport = viewport;
    this.dirty = true;
    this.reactions = true;
    this.contacts = true; // whether the forces of contacts are shown
    /** The contact force that has the longest arrow [N]; 0: there is none to see. */
    this.firmest = 0;
    /** @type {Trails | null} */ this.trails = null;
    /** @type {Set<number>} nodes of the first variant */ this.followed = new Set();
    this.scene = ""; // whose they are
    /** @type {Variant | null} */ this.copy = null; // in which they are so numbered
    /** What has a ring: what lies under the pointer, or where the hand is. @type {Hit | Vector | null} */
    this.hover = null;
    /** What this page's pointers hold: drawn where the pointers are, however late ropes follow.
     * @type {Set<import("./input/hand.js").Hand>} */
    this.held = new Set();
    /** What the keyboard has chosen. @type {Hit | import("./input/pick.js").BodyHit | null} */ this.chosen =
      null;
    /** A kick that is being drawn. @type {{from: Vector, to: Vector, text: string} | null} */
    this.kick = null;
    /** The first of two points that are to be tied. @type {Hit | null} */ this.tying = null;
    /** A line that is drawn from one to the other. @type {{hit: Hit, to: Vector} | null} */
    this.line = null;
    this.strongest = 0; // the force that has the longest arrow [N]
    /** Anchors that have an arrow. @type {Set<string>} */ this.arrowed = new Set();
    /** Anchors that have a number, too. @type {Set<string>} */ this.numbered = new Set();
    /** Of a crowd: how many forces there are, and how many have arrows because they are large.
     * @type {{forces: number, large: number} | null} */ this.crowd = null;
    /** The greatest force of each anchor of each variant since labels were last written [N].
     * @type {number[][]} */ this.most = [];
    /** @type {Label[]} */ this.labels = [];
    /** The forces of contacts. @type {Arrow[]} */ this.touches = [];
    /** What anchors stand on, on the floor. @type {Arrow[]} */ this.posts = [];
    this.standing = true; // whether they are shown
    /** Anchors from which a loose end hangs: a post would run along it. @type {Set<number>} */
    this.hanging = new Set();
  }

  /** @param {Layout} layout */
  setLayout(layout) {
    const [copy] = layout.variants;
    const held = layout.obstacles?.length ? [] : copy.anchors.map(({ index }) => index); // bodies bear ropes
    this.hanging = new Set(held.filter((index) => hasTail(copy, index)));
    const scene = `${layout.scene.name} ${layout.scene.preset}`;
    if (scene !== this.scene) this.followed = new Set(fliers(layout));
    else if (this.copy) this.followed = alike(this.followed, this.copy, copy);
    [this.scene, this.copy] = [scene, copy];
    this.resetTrails();
    this.strongest = this.firmest = 0;
    this.most = [];
    this.hover = this.kick = this.chosen = this.tying = this.line = null;
  }

  /** Note what the anchors of a frame have held since the one before. @param {Frame} frame */
  take({ parts }) {
    this.most = parts.map(({ seen }, v) =>
      Array.from(seen.greatestForce, (force, a) => Math.max(force, this.most[v]?.[a] ?? 0)),
    );
  }

  /** Labels were written: a new interval begins. */
  written() {
    this.most = [];
  }

  /** Start or stop a trail. @param {number} node of the first variant */
  toggleTrail(node) {
    if (!this.followed.delete(node)) this.followed.add(node);
    if (this.followed.size > 8) this.followed.delete([...this.followed][0]);
    this.resetTrails();
  }

  resetTrails() {
    const nodes = [...this.followed];
    const colours = nodes.map((_, i) => fromHex(ROPES[(i + 1) % ROPES.length]));
    this.trails = nodes.length ? new Trails(nodes, colours) : null;
    this.dirty = true;
  }

  /** Build markers, arrows and labels from the last frame. */
  collect() {
    /** @type {Marker[]} */ const markers = [];
    /** @type {Arrow[]} */ const arrows = [];
    this.labels = [];
    this.posts = [];
    this.touches = [];
    const { session } = this.viewport;
    if (session.layout && session.frame) {
      this.addAnchors(markers, arrows);
      this.addLoads(markers);
      this.addJoints(markers);
      this.addForces(arrows);
      this.addContacts();
      this.addGrabs(markers, arrows);
      this.addHand(markers, arrows);
    }
    return { markers, arrows };
  }

  /** @param {Marker[]} markers @param {Arrow[]} arrows */
  addAnchors(markers, arrows) {
    const { viewport } = this;
    const { theme } = viewport;
    const held = holding(viewport, viewport.anchors.shown);
    const eye = held.length > MANY ? 12 : 19; // around a net they would be all that is seen
    for (const { place, anchor } of held) {
      const [x, y, z] = place;
      const colour = anchor.pinned
        ? theme.pin
        : anchor.motion === "hand"
          ? theme.hand
          : theme.anchor;
      markers.push({
        x,
        y,
        z,
        kind: "eye",
        colour,
        size: 0,
        pixels: anchor.pinned ? Math.min(eye, 14) : eye,
      });
      if (STILL.has(anchor.motion) && !this.hanging.has(anchor.index)) this.addPost(place);
    }
    if (!this.reactions) return;
    this.strongest = Math.max(strongestOf(held), this.strongest * 0.995);
    const shown = held.filter(({ variant }) => variant === 0 || viewport.apart);
    this.addReactions(shown, arrows);
  }

  /** What anchors hold. @param {import("./reactions.js").Holding[]} held @param {Arrow[]} arrows */
  addReactions(held, arrows) {
    const { camera, theme, session } = this.viewport;
    const playing = session.status?.playing ?? false;
    const per = scaleOf(this.strongest, /** @type {Layout} */ (session.layout), camera);
    const large = drawnOf(held, this.strongest, this.arrowed);
    const pointed = (/** @type {import("./reactions.js").Holding} */ one) => this.pointedAt(one);
    const drawn = drawnOf(held, this.strongest, this.arrowed, pointed);
    const numbered = numberedOf(drawn, this.numbered, pointed);
    this.arrowed = new Set(large.map(nameOf));
    this.numbered = new Set(numbered.map(nameOf));
    this.crowd = crowded(held) ? { forces: held.length, large: large.length } : null;
    for (const one of drawn) {
      const { variant, a, place: from, force, size, peak } = one;
      const to = tipOf(from, force, per, camera);
      arrows.push({ from, to, colour: theme.arrow, pixels: 2.6, head: true });
      if (!numbered.includes(one)) continue;
      const most = Math.max(peak, this.most[variant]?.[a] ?? 0);
      const id = `reaction ${nameOf(one)}`;
      this.labels.push({
        id,
        from,
        at: to,
        text: forceText(size, most, playing),
        kind: "reaction",
      });
    }
  }

  /** Whether the pointer or the keyboard is at an anchor. @param {import("./reactions.js").Holding} one */
  pointedAt({ variant, anchor }) {
    return [this.hover, this.chosen].some(
      (hit) =>
        hit !== null &&
        !Array.isArray(hit) &&
        hit.kind === "anchor" &&
        hit.variant === variant &&
        hit.anchor === anchor.name,
    );
  }

  /** A post from the floor to an anchor. @param {Vector} place */
  addPost(place) {
    const { camera, theme, floor } = this.viewport;
    const above = dot(place, camera.up) - floor.level;
    const foot = (FOOT * camera.pose.distance) / camera.focal;
    if (!this.standing || above < 2 * foot || this.posts.length >= 2 * MOST_POSTS) return;
    const behind = (BEHIND * camera.pose.distance) / camera.focal;
    const top = plus(place, camera.toward, -behind);
    const to = plus(top, camera.up, -above);
    const near = plus(to, camera.toward, 0.3 * foot); // so that the foot hides the post
    this.posts.push(
      { from: top, to, colour: theme.post, pixels: 4.5, head: false },
      { from: plus(near, camera.up, foot), to: near, colour: theme.post, pixels: 16, head: false },
    );
  }

  /** @param {Marker[]} markers */
  addLoads(markers) {
    const { session, theme, nodes, starts } = this.viewport;
    const layout = /** @type {Layout} */ (session.layout);
    layout.variants.forEach((variant, v) => {
      const total = variant.ropes.reduce((sum, rope) => sum + rope.mass, 0);
      for (const load of variant.loads) {
        const at = 4 * (starts[v] + load.index);
        const [x, y, z] = nodes.shown.subarray(at, at + 3);
        const pixels = 9 + 11 * Math.min(1.6, Math.cbrt(load.mass / Math.max(total, 1e-9)));
        markers.push({ x, y, z, kind: "round", colour: theme.load, size: 0, pixels });
      }
    });
    for (const [i, node] of [...this.followed].entries()) {
      const [x, y, z] = nodes.shown.subarray(4 * node, 4 * node + 3);
      const colour = fromHex(ROPES[(i + 1) % ROPES.length]);
      markers.push({ x, y, z, kind: "round", colour, size: 0, pixels: 8 });
    }
  }

  /** Knots where joints tie nodes; the one that the pointer is at has its name beside it.
   * @param {Marker[]} markers */
  addJoints(markers) {
    const { session, theme, nodes, starts, camera } = this.viewport;
    const { variants } = /** @type {Layout} */ (session.layout);
    const hover = this.hover && !Array.isArray(this.hover) ? this.hover : null;
    variants.forEach(({ joints, ropes }, v) => {
      const thick = Math.max(0, ...ropes.map(({ diameter }) => diameter));
      for (const { name, nodes: tied } of joints ?? []) {
        const at = 4 * (starts[v] + tied[0]);
        const place = vector(nodes.shown.subarray(at, at + 3));
        if (!place.every(Number.isFinite)) continue;
        const [x, y, z] = place;
        const pixels = (joints ?? []).length > MOST_LABELS ? 10 : 15;
        const colour = theme.joint;
        markers.push({ x, y, z, kind: "knot", colour, size: 1.9 * thick, pixels });
        if (hover?.joint !== name || hover.variant !== v) continue;
        const away = (26 * camera.pose.distance) / camera.focal;
        const tip = plus(place, camera.top, away);
        this.labels.push({ id: `joint ${name}`, from: place, at: tip, text: name, kind: "given" });
      }
    });
  }

  /** The constant forces of the scene, on the scale of what anchors hold. @param {Arrow[]} arrows */
  addForces(arrows) {
    const { session, theme, nodes, camera } = this.viewport;
    const { forces } = /** @type {Layout} */ (session.layout).variants[0];
    if (!this.reactions || !forces.length) return;
    const sizes = forces.map(({ force }) => Math.hypot(...force));
    const per = scaleOf(this.strongest, /** @type {Layout} */ (session.layout), camera);
    const numbered = new Set(
      [...sizes.keys()].sort((a, b) => sizes[b] - sizes[a]).slice(0, MOST_LABELS),
    );
    for (const [i, { index, force }] of forces.entries()) {
      if (!(sizes[i] > 0)) continue;
      const from = vector(nodes.shown.subarray(4 * index, 4 * index + 3));
      const to = tipOf(from, vector(force), per, camera);
      arrows.push({ from, to, colour: theme.load, pixels: 2.6, head: true });
      const [id, text] = [`given ${i}`, quantity(sizes[i], "N")];
      if (numbered.has(i)) this.labels.push({ id, from, at: to, text, kind: "given" });
    }
  }

  /** What obstacles and other ropes do to ropes: the longest arrow is the strongest's. */
  addContacts() {
    const { session, theme, nodes, camera } = this.viewport;
    const pushes = pushesOf(/** @type {Frame} */ (session.frame).parts[0], nodes.shown);
    const strongest = firmestOf(pushes);
    if (!Number.isFinite(strongest)) return;
    const calm = session.status?.playing ? 0.98 * this.firmest : 0; // it does not flicker
    this.firmest = Math.max(strongest, calm);
    const longest = (CONTACT * camera.pose.distance) / camera.focal;
    if (this.contacts) this.touches = arrowsOf(pushes, this.firmest, longest, theme.contact);
  }

  /** The springs of hands, this page's and others'. @param {Marker[]} markers @param {Arrow[]} arrows */
  addGrabs(markers, arrows) {
    const { session, theme, nodes, starts, shifts } = this.viewport;
    const own = [...this.held];
    const frame = /** @type {Frame} */ (session.frame);
    frame.parts.forEach((part, v) => {
      for (let i = 0; i < part.grabs.length; i += 8) {
        const node = part.grabs[i];
        if (!(node >= 0)) continue;
        const at = 4 * (starts[v] + node);
        const from = vector(nodes.shown.subarray(at, at + 3));
        const mine = own.find(({ hit }) => hit.variant === v && hit.node === node);
        const to = mine ? mine.place : plus(part.grabs.subarray(i + 1, i + 4), shifts[v]);
        const [x, y, z] = to;
        if (!mine) {
          arrows.push({ from, to, colour: theme.grab, pixels: 2, head: false });
          markers.push({ x, y, z, kind: "ring", colour: theme.grab, size: 0, pixels: 16 });
        }
        const [fx, fy, fz] = part.grabs.subarray(i + 4, i + 7);
        if (v > 0) continue;
        const text = pulls(Math.hypot(fx, fy, fz), part.grabs[i + 7]);
        this.labels.push({ id: `grab ${i}`, from, at: to, text, kind: "grab" });
      }
    });
  }

  /** The ring under the pointer and a kick's arrow. @param {Marker[]} markers @param {Arrow[]} arrows */
  addHand(markers, arrows) {
    const { theme } = this.viewport;
    const chosen = this.chosen && placeOf(this.viewport, this.chosen);
    const hands = [...this.held];
    for (const { hit, place } of hands) {
      const from = placeOf(this.viewport, hit);
      if (!from) continue;
      arrows.push({ from, to: place, colour: theme.grab, pixels: 2, head: false });
      const text = hit.kind === "anchor" ? this.fastest(hit) : "";
      const id = `lead ${hit.variant} ${hit.node}`;
      if (text) this.labels.push({ id, from, at: place, text, kind: "grab" });
    }
    for (const ring of [this.ringPlace(), chosen, ...hands.map(({ place }) => place)]) {
      if (!ring) continue;
      const [x, y, z] = ring;
      markers.push({ x, y, z, kind: "ring", colour: theme.hover, size: 0, pixels: 24 });
    }
    const first = this.line?.hit ?? this.tying;
    const from = first && placeOf(this.viewport, first);
    const to = this.line?.to ?? this.ringPlace() ?? chosen;
    if (from) {
      const [x, y, z] = from;
      markers.push({ x, y, z, kind: "ring", colour: theme.joint, size: 0, pixels: 24 });
      if (to) arrows.push({ from, to, colour: theme.joint, pixels: 2, head: false });
    }
    this.addKick(arrows);
  }

  /** What is said of a led anchor that goes as fast as any may, and so comes late; "" of others.
   * @param {import("./input/pick.js").AnchorHit} hit */
  fastest({ variant, anchor }) {
    const { layout, frame, hello } = this.viewport.session;
    const most = hello?.limits.anchor_speed;
    const a = layout?.variants[variant].anchors.findIndex(({ name }) => name === anchor) ?? -1;
    if (!most || !frame || a < 0) return "";
    const speed = Math.hypot(...frame.parts[variant].anchors.subarray(10 * a + 3, 10 * a + 6));
    return speed > 0.995 * most ? `${quantity(most, "m/s")} (no faster)` : "";
  }

  /** @param {Arrow[]} arrows */
  addKick(arrows) {
    const { theme } = this.viewport;
    if (!this.kick) return;
    const { from, to, text } = this.kick;
    arrows.push({ from, to, colour: theme.grab, pixels: 3, head: true });
    this.labels.push({ id: "kick", from, at: to, text, kind: "kick" });
  }

  /** Where the ring is now: it goes with the rope. @returns {Vector | null} */
  ringPlace() {
    const { hover, viewport } = this;
    if (hover === null || Array.isArray(hover)) return hover;
    return placeOf(viewport, hover);
  }
}
