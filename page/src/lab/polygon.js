// Friction of nodes round a post: that of the arcs which they stand for, as the Python `polygon` has it.

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./solids.js").Post} Post */
/** @typedef {{turn: number, middle: number, off: number}} Turned how a node turns towards a post [rad], the
 *   coefficient were it pressed along the middle of that, and how far off the middle it is [rad] */

const LEVEL = 1e-6; // a node that turns by less lies straight [rad]
const NEARLY = 0.95; // of the angle of friction counts: with all of it there were none one way
const HALF_WAY = 0.5; // to a right angle: beyond that friction were less than none
const FINE = 0.35; // longest segment over the radius
export const MOVES = 1e-3; // a node that is off the middle by less is between others [rad]

/** The coefficient with which a node that turns acts as its arc would. @param {number} friction @param {number} turn
 * [rad] */
const onPolygon = (friction, turn) =>
  turn < LEVEL ? friction : Math.tanh(0.5 * friction * turn) / Math.tan(0.5 * turn);

/** How a node turns towards a post in `dt` [s], as nodes go now. @param {Rope} rope @param {Float64Array[]} v
 * @param {Post} post @param {number} friction @param {number} i @param {Float64Array} found what `probe` writes of it
 * @param {number} dt @returns {Turned} */
export function turnedBy(rope, v, post, friction, i, found, dt) {
  const [rise, fall] = slopes(rope, v, i, found, dt);
  const turn = Math.max(rise + fall, 0);
  const middle = onPolygon(friction, turn);
  if (turn < LEVEL || post.kind === "plane") return { turn, middle, off: 0 };
  const step = Math.max(angleOf(rope.x, i - 1, found), angleOf(rope.x, i, found));
  const counts = counting(step, middle);
  return { turn, middle, off: Math.min(Math.max(0.5 * (rise - fall), -counts), counts) };
}

/** By how much the rope turns at a node towards a post [rad]. @param {Rope} rope @param {number} i
 * @param {Float64Array} found */
export function turnAt(rope, i, found) {
  const [rise, fall] = slopes(rope, rope.v, i, found, 0);
  return Math.max(rise + fall, 0);
}

/** The coefficient of a node that is off the middle of its turn. @param {Turned} turned @param {number} ahead the
 * cosine between the rope and what it pulls with on what rubs */
export const tilted = ({ middle, off }, ahead) =>
  off === 0 ? middle : Math.tan(Math.atan(middle) + ahead * off);

/** Up to which angle a normal off the middle counts [rad]. @param {number} step a segment's angle [rad]
 * @param {number} middle */
function counting(step, middle) {
  const p = Math.atan(middle);
  if (!(step > 0 && step <= FINE)) return 0;
  return Math.max(Math.min(0.5 * step, NEARLY * p, HALF_WAY * (0.5 * Math.PI - p)), 0);
}

/** A segment's length over the radius of the surface along it. @param {Float64Array[]} x @param {number} i
 * @param {Float64Array} found */
function angleOf(x, i, found) {
  const dx = x[0][i + 1] - x[0][i];
  const dy = x[1][i + 1] - x[1][i];
  const dz = x[2][i + 1] - x[2][i];
  const square = dx * dx + dy * dy + dz * dz;
  const along = found[4] * dx + found[5] * dy + found[6] * dz;
  if (!(square > 0)) return 0;
  const part = (along * along) / square;
  return Math.sqrt(square) * (found[7] * (1 - part) + found[8] * part);
}

/** How steeply the rope rises to a node from a surface, and falls after it [rad]; 0 where it does not turn towards it.
 * @param {Rope} rope @param {Float64Array[]} v @param {number} i @param {Float64Array} found @param {number} dt
 * @returns {[number, number]} */
function slopes({ n, x, stiffness }, v, i, found, dt) {
  if (i === 0 || i === n - 1 || stiffness[i - 1] === 0 || stiffness[i] === 0) return [0, 0];
  const [, nx, ny, nz] = found;
  let [ax, ay, az] = x.map((row) => row[i] - row[i - 1]);
  let [bx, by, bz] = x.map((row) => row[i + 1] - row[i]);
  if (dt > 0) {
    ax += dt * (v[0][i] - v[0][i - 1]);
    ay += dt * (v[1][i] - v[1][i - 1]);
    az += dt * (v[2][i] - v[2][i - 1]);
    bx += dt * (v[0][i + 1] - v[0][i]);
    by += dt * (v[1][i + 1] - v[1][i]);
    bz += dt * (v[2][i + 1] - v[2][i]);
  }
  const up = nx * ax + ny * ay + nz * az;
  const on = nx * bx + ny * by + nz * bz;
  if (up <= 0 && on >= 0) return [0, 0];
  const a = Math.sqrt(ax * ax + ay * ay + az * az);
  const b = Math.sqrt(bx * bx + by * by + bz * bz);
  if (!(a > 0 && b > 0)) return [0, 0];
  const [before, after] = [up / a, on / b];
  if (!(before > after)) return [0, 0];
  const angle = (/** @type {number} */ share) => Math.asin(Math.min(Math.max(share, -1), 1));
  return [angle(before), -angle(after)];
}

/** The cosine between the rope at a node along a surface and its pull on what rubs; 0: none. @param {Float64Array[]} x
 * @param {number} i @param {Float64Array} found @param {number[]} rubs force on the node [N] */
export function pullsAhead(x, i, found, rubs) {
  const [, nx, ny, nz] = found;
  const [rx, ry, rz] = rubs;
  const size = Math.sqrt(rx * rx + ry * ry + rz * rz);
  if (!(size > 0)) return 0;
  let tx = 0;
  let ty = 0;
  let tz = 0;
  for (const j of [i - 1, i]) {
    const [ax, ay, az] = x.map((row) => row[j + 1] - row[j]);
    const a = Math.sqrt(ax * ax + ay * ay + az * az);
    tx += ax / a;
    ty += ay / a;
    tz += az / a;
  }
  const across = nx * tx + ny * ty + nz * tz;
  tx -= across * nx;
  ty -= across * ny;
  tz -= across * nz;
  const along = Math.sqrt(tx * tx + ty * ty + tz * tz);
  if (!(along > 0)) return 0;
  return -(tx * rx + ty * ry + tz * rz) / (along * size);
}
