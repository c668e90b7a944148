// What contacts do to ropes: the forces of obstacles and of other ropes behind their arrows.

import { plus, times, vector } from "./view/vector.js";
import { scalar } from "./source/frame.js";

/** @typedef {import("./viewport.js").Viewport} Viewport */
/** @typedef {import("./source/frame.js").Part} Part */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./view/camera.js").Camera} Camera */
/** @typedef {import("./view/vector.js").Vector} Vector */
/** @typedef {import("./render/view.js").Arrow} Arrow */
/** A force on a rope, at a place of it: `from` [m]. @typedef {{from: Vector, force: Vector, size: number}} Push */
/** Of contacts of ropes: how many have arrows of how many there are, and of which share of all their force.
 * @typedef {{drawn: number, all: number, share: number}} Strongest */

export const CONTACT = 56; // length of the longest arrow of a contact [CSS pixels]
export const MOST_CONTACTS = 200; // arrows of obstacles
const LEAST = 0.03; // of the strongest contact, below which there is no arrow
const HEADLESS = 0.2; // of the strongest contact, below which arrows have no head
const PAIR = 5; // numbers of a contact of two ropes
const NONE = 1e-9; // N, which is no force

/** The forces on the first copy's ropes that have arrows. @param {Part} part
 * @param {Float32Array} places of its nodes: x, y, z, value @returns {Push[]} */
export function pushesOf({ contact, ropeContacts }, places) {
  const found = strongestOfEach(contact, MOST_CONTACTS).map((node) =>
    push(vector(places.subarray(4 * node)), vector(contact.subarray(3 * node))),
  );
  for (let row = 0; row < ropeContacts.length; row += PAIR) {
    const [first, second, ...force] = ropeContacts.subarray(row, row + PAIR);
    if (!(first >= 0)) continue;
    found.push(push(along(first, places), vector(force)));
    found.push(push(along(second, places), times(force, -1)));
  }
  return found;
}

/** @param {Vector} from @param {Vector} force @returns {Push} */
const push = (from, force) => ({ from, force, size: Math.hypot(...force) });

/** A place on the ropes, by segment and share of it. @param {number} at @param {Float32Array} places */
function along(at, places) {
  const node = Math.floor(at);
  const here = vector(places.subarray(4 * node));
  if (at === node) return here;
  const next = vector(places.subarray(4 * node + 4));
  return plus(times(here, 1 - (at - node)), next, at - node);
}

/** The largest of them [N]. @param {Push[]} pushes */
export const firmestOf = (pushes) => pushes.reduce((most, { size }) => Math.max(most, size), 0);

/** Their arrows. @param {Push[]} pushes @param {number} firmest of the longest one [N]
 * @param {number} longest [m] @param {Arrow["colour"]} colour @returns {Arrow[]} */
export function arrowsOf(pushes, firmest, longest, colour) {
  if (!(firmest > NONE)) return [];
  return pushes
    .filter(({ size }) => size >= LEAST * firmest)
    .map(({ from, force, size }) => ({
      from,
      to: plus(from, force, longest / firmest),
      colour,
      pixels: 2,
      head: size > HEADLESS * firmest,
    }));
}

/** Where the arrows of contacts end [m], as long as they are for a camera.
 * @param {Viewport} viewport @param {Camera} camera @returns {Vector[]} */
export function contactTips({ session, nodes, marks }, camera) {
  if (!session.frame || !marks.contacts) return [];
  const pushes = pushesOf(session.frame.parts[0], nodes.to);
  const firmest = Math.max(firmestOf(pushes), marks.firmest);
  if (!(firmest < Infinity)) return [];
  const longest = (CONTACT * camera.pose.distance) / camera.focal;
  return arrowsOf(pushes, firmest, longest, [0, 0, 0]).map(({ to }) => vector(to));
}

/** Where there are more contacts of ropes than a frame has: how many of them are drawn; null: all are.
 * @param {Layout} layout @param {Part} part @returns {Strongest | null} */
export function strongestOf(layout, part) {
  const all = scalar(layout, part, "rope_contacts");
  let [drawn, carried] = [0, 0];
  for (let row = 0; row < part.ropeContacts.length; row += PAIR) {
    if (!(part.ropeContacts[row] >= 0)) continue;
    drawn += 1;
    carried += Math.hypot(...part.ropeContacts.subarray(row + 2, row + PAIR));
  }
  const whole = scalar(layout, part, "rope_contact_force");
  return all > drawn && drawn > 0 ? { drawn, all, share: carried / whole } : null;
}

/** Which arrows are left out of many contacts. @param {Strongest | null} ropes
 * @param {number} nodes that obstacles may push */
export function leftOut(ropes, nodes) {
  const every = Math.ceil(nodes / MOST_CONTACTS);
  const said = ropes
    ? [
        `Arrows at the ${ropes.drawn} strongest of ${ropes.all} contacts of ropes, ` +
          `${Math.round(100 * ropes.share)} % of their force.`,
      ]
    : [];
  if (every > 1) said.push(`On obstacles at the strongest of every ${every} nodes.`);
  return said.join(" ");
}

/** The nodes whose contacts are drawn, at most so many: of neighbours that share an arrow the strongest.
 * @param {ArrayLike<number>} contact forces, three numbers a node @param {number} most @returns {number[]} */
export function strongestOfEach(contact, most) {
  const size = (/** @type {number} */ node) =>
    Math.hypot(contact[3 * node], contact[3 * node + 1], contact[3 * node + 2]);
  const nodes = contact.length / 3;
  const every = Math.max(1, Math.ceil(nodes / most));
  const found = [];
  for (let first = 0; first < nodes; first += every) {
    let strongest = first;
    for (let node = first + 1; node < Math.min(first + every, nodes); node++)
      if (size(node) > size(strongest)) strongest = node;
    found.push(strongest);
  }
  return found;
}
