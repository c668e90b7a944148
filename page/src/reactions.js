// What anchors hold: the forces behind their arrows, and the room that these need in a picture.

import { contactTips } from "./touches.js";
import { quantity } from "./view/range.js";
import { minus, plus, unit, vector } from "./view/vector.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./source/frame.js").Frame} Frame */
/** @typedef {import("./view/camera.js").Camera} Camera */
/** @typedef {import("./view/vector.js").Vector} Vector */
/** An anchor that holds: its force now, the size of that, and the greatest since the frame before [N].
 * @typedef {{variant: number, a: number, anchor: Layout["variants"][0]["anchors"][0], place: Vector, force: Vector,
 *   size: number, peak: number}} Holding */

export const REACTION = 84; // length of the longest arrow [CSS pixels]
export const LEAST = 0.1; // of the strongest, below which there is neither arrow nor label: the eye hides it
export const CROWD = 8; // anchors, up to which all have their arrows; numbers, at most
const LOUD = 0.5; // of the strongest: of a crowd, those above it are shown
const HUSHED = 0.42; // below which one of them is no longer: it does not flicker
const KEPT = 1.15; // by which a force must be larger than one that has a number, to take its place
const WELL = 1.05; // times what it is now, above which the greatest is told as such
const GIVEN = 0.6; // of the longest arrow, which that of a constant force may have
const SHORTEST = 14; // length of an arrow that is to be seen [CSS pixels]
const CHIP = 34; // that a label takes beyond its arrow's tip [CSS pixels]
const CLEAR = 6; // that tips stay away from tools [CSS pixels]
const MOST = 0.12; // of the height that is free, which arrows may take at one side

/** The anchors that hold, where they are. @param {Viewport} viewport @param {Float32Array} places
 * @returns {Holding[]} */
export function holding({ session }, places) {
  const layout = /** @type {Layout} */ (session.layout);
  const frame = /** @type {Frame} */ (session.frame);
  /** @type {Holding[]} */ const found = [];
  let at = 0;
  layout.variants.forEach((copy, variant) => {
    const part = frame.parts[variant];
    copy.anchors.forEach((anchor, a) => {
      const place = vector(places.subarray(at, at + 3));
      at += 3;
      if (part.anchors[10 * a + 9] < 0.5) return; // it has let go
      if (!place.every(Number.isFinite)) return; // a recorded run may go on after its break
      const force = vector(part.anchors.subarray(10 * a + 6, 10 * a + 9));
      const size = Math.hypot(...force);
      const seen = part.seen.greatestForce[a];
      const peak = Number.isFinite(seen) ? Math.max(size, seen) : size;
      found.push({ variant, a, anchor, place, force, size, peak });
    });
  });
  return found;
}

/** The force of the longest arrow: as arrows point, it is that of now [N]. @param {Holding[]} held */
export const strongestOf = (held) =>
  Math.max(0, ...held.map(({ size }) => size).filter(Number.isFinite));

/** A force in words: what it is now, and the greatest since words were last written where that is well above it; while
 * time goes on there is no time to read both. @param {number} size @param {number} most [N]
 * @param {boolean} playing */
export function forceText(size, most, playing) {
  if (!(most > WELL * size)) return quantity(playing ? most : size, "N");
  const greatest = `max ${quantity(most, "N")}`;
  return playing ? greatest : `${quantity(size, "N")}, ${greatest}`;
}

/** Of those that hold, the ones whose force is drawn: of a crowd the strong ones, and what is pointed at.
 * @param {Holding[]} held @param {number} strongest [N] @param {Set<string>} [before] names of those drawn before
 * @param {(one: Holding) => boolean} [pointed] */
export function drawnOf(held, strongest, before = new Set(), pointed = () => false) {
  const crowd = crowded(held);
  const now = Math.max(0, ...held.map(({ peak }) => peak).filter(Number.isFinite)); // of which a crowd's are
  return held.filter((one) => {
    if (one.size < 1e-9) return false;
    if (pointed(one)) return true;
    const part = before.has(nameOf(one)) ? HUSHED : LOUD;
    return one.peak >= LEAST * strongest && (!crowd || one.peak >= part * now);
  });
}

/** Whether a copy has so many anchors that only strong ones have arrows. @param {Holding[]} held */
export const crowded = (held) =>
  held.filter(({ variant }) => variant === held[0]?.variant).length > CROWD;

/** Of those that are drawn, the ones that have numbers: the few largest, and what is pointed at.
 * @param {Holding[]} drawn
 * @param {Set<string>} before names of those that had numbers @param {(one: Holding) => boolean} pointed */
export function numberedOf(drawn, before, pointed) {
  const weight = (/** @type {Holding} */ one) => one.peak * (before.has(nameOf(one)) ? KEPT : 1);
  const largest = [...drawn].sort((a, b) => weight(b) - weight(a)).slice(0, CROWD);
  return drawn.filter((one) => largest.includes(one) || pointed(one));
}

/** @param {Holding} one */
export const nameOf = ({ variant, a }) => `${variant} ${a}`;

/** The longest arrow [CSS pixels]. @param {Camera} camera */
export const longest = ({ width, height }) => Math.min(REACTION, 0.14 * width, 0.17 * height);

/** How long arrows of forces are, of anchors and constant ones alike [m/N], for a camera. @param {number} strongest
 * of the anchors [N] @param {Layout} layout @param {Camera} camera */
export function scaleOf(strongest, layout, camera) {
  const given = (layout.variants[0].forces ?? []).map(({ force }) => Math.hypot(...force) / GIVEN);
  return (longest(camera) * camera.pose.distance) / camera.focal / Math.max(strongest, ...given);
}

/** Where the arrow of a force ends: to scale, but long enough to be seen. @param {Vector} from
 * @param {ArrayLike<number>} force [N] @param {number} per its scale [m/N] @param {Camera} camera @returns {Vector} */
export function tipOf(from, force, per, camera) {
  const shortest = (SHORTEST * camera.pose.distance) / camera.focal;
  return plus(from, force, Math.max(per, shortest / Math.hypot(force[0], force[1], force[2])));
}

/** Where the arrows of anchors end [m], as long as they are for a camera.
 * @param {Viewport} viewport @param {Camera} camera @returns {Vector[]} */
export function tipsOf(viewport, camera) {
  const { session, anchors, marks } = viewport;
  if (!session.frame || !marks.reactions) return [];
  const held = holding(viewport, anchors.to);
  const strongest = Math.max(strongestOf(held), marks.strongest);
  const length = (longest(camera) * camera.pose.distance) / camera.focal;
  const per = scaleOf(strongest, /** @type {Layout} */ (session.layout), camera);
  const tips = drawnOf(held, strongest, marks.arrowed).map(({ place, force }) =>
    tipOf(place, force, per, camera),
  );
  return marks.strongest || crowded(held) ? tips : [...tips, ...coming(viewport, held, length)];
}

/** Where arrows will end at the ends of ropes that nothing has loaded yet: they pull along the rope.
 * @param {Viewport} viewport @param {Holding[]} held @param {number} length [m] */
function coming({ nodes, starts, session }, held, length) {
  const ropes = session.layout?.variants[0].ropes ?? [];
  return held.flatMap(({ variant, anchor: { index }, place }) => {
    const rope = ropes.find(({ first, nodes }) => index === first || index === first + nodes - 1);
    if (!rope) return [];
    const node = starts[variant] + index + (index === rope.first ? 1 : -1);
    const along = minus(place, nodes.to.subarray(4 * node, 4 * node + 3));
    return [plus(place, unit(along), length)];
  });
}

/** What a picture must keep free around its ropes, so that arrows and their labels are in it, too, and under no bar
 * of tools at its sides: the strips, or more. @param {Viewport} viewport @param {Camera} camera
 * @param {import("./view/camera.js").Strips} strips */
export function roomFor(viewport, camera, strips) {
  const room = { top: 0, bottom: 0 };
  const tips = tipsOf(viewport, camera);
  const keep = (/** @type {Vector[]} */ tips, /** @type {number} */ margin) => {
    for (const tip of tips) {
      const [, y, depth] = camera.project(...tip);
      if (!(depth > 0)) continue;
      room.top = Math.max(room.top, strips.top + margin - y);
      room.bottom = Math.max(room.bottom, y + margin + strips.bottom - camera.height);
    }
  };
  keep(tips, CHIP);
  keep(contactTips(viewport, camera), 0);
  return mostOf(
    {
      ...strips,
      ...besideTools(viewport, camera, tips, strips),
      top: strips.top + room.top,
      bottom: strips.bottom + room.bottom,
    },
    strips,
    camera,
  );
}

/** Room for arrows, but no more than ropes can spare. @param {import("./view/camera.js").Strips} room
 * @param {import("./view/camera.js").Strips} strips @param {Camera} camera */
export function mostOf(room, strips, { height }) {
  const most = MOST * (height - strips.top - strips.bottom);
  return {
    ...room,
    top: Math.min(room.top, strips.top + most),
    bottom: Math.min(room.bottom, strips.bottom + most),
  };
}

/** Room and what is still missing with it; null: nothing is. @param {import("./view/camera.js").Strips} room
 * @param {import("./view/camera.js").Strips} found in a picture with that room
 * @param {import("./view/camera.js").Strips} strips */
export function widened(room, found, strips) {
  const sides = /** @type {const} */ (["top", "bottom", "left", "right"]);
  const missing = sides.map((side) => (found[side] ?? 0) - (strips[side] ?? 0));
  if (missing.every((part) => part < 1)) return null;
  const wider = { ...room };
  sides.forEach((side, k) => {
    if (missing[k] > 0) wider[side] = (room[side] ?? 0) + missing[k];
  });
  return wider;
}

/** What arrows need at the sides, to stay clear of the tools there; nothing where they do.
 * @param {Viewport} viewport @param {Camera} camera @param {Vector[]} tips
 * @param {import("./view/camera.js").Strips} strips */
function besideTools(viewport, camera, tips, { left = 0 }) {
  const sides = { left, right: 0 };
  for (const bar of viewport.bars?.() ?? []) {
    if (bar.height < bar.width) continue; // a row: strips keep the ropes below it
    for (const [x, y] of tips.map((tip) => camera.project(...tip))) {
      if (y < bar.top - CLEAR || y > bar.bottom + CLEAR) continue;
      if (bar.left < camera.width / 2) sides.left = Math.max(sides.left, bar.right + CLEAR - x);
      else sides.right = Math.max(sides.right, x + CLEAR - bar.left);
    }
  }
  return {
    ...(sides.left ? { left: sides.left } : {}),
    ...(sides.right ? { right: sides.right } : {}),
  };
}

/** Whether a loose end hangs from a held node, along its rope: nothing else holds that end.
 * @param {{anchors: {index: number}[], joints?: {nodes: number[]}[], ropes: {first: number, nodes: number}[]}} copy
 * @param {number} index of the node */
export function hasTail({ anchors, joints, ropes }, index) {
  const rope = ropes.find(({ first, nodes }) => index >= first && index < first + nodes);
  if (!rope) return false;
  const last = rope.first + rope.nodes - 1;
  const tied = (joints ?? []).flatMap(({ nodes }) => nodes);
  const held = [...anchors.map((anchor) => anchor.index), ...tied];
  const loose = (/** @type {number} */ from, /** @type {number} */ to) =>
    from <= to && !held.some((node) => node >= from && node <= to);
  return loose(rope.first, index - 1) || loose(index + 1, last);
}
