// What is told of a rope: tensions and energies.

/** @typedef {import("./kernel.js").Rope} Rope */

export const LITTLE = 1e-9; // what rounding leaves of nothing [N], [J]

const HUGE = 1e10; // from which on a number has a power of ten, as what breaks soon needs

/** @param {number} value four figures; what is below a billionth is rounding */
export const brief = (value) => {
  const rounded = Math.abs(value) < LITTLE ? 0 : Number(value.toPrecision(4));
  return Math.abs(rounded) >= HUGE ? powered(rounded) : String(rounded);
};

/** @param {number} value as 1.5e14 */
const powered = (value) => value.toExponential().replace("+", "");

/** @param {number} value three figures and a prefix @param {string} unit */
export const told = (value, unit) => {
  if (Math.abs(value) <= LITTLE) return `0 ${unit}`;
  const size = Math.abs(value);
  if (size >= HUGE) return `${powered(Number(value.toPrecision(3)))} ${unit}`;
  const [factor, prefix] = size >= 1e6 ? [1e6, "M"] : size >= 1e4 ? [1e3, "k"] : [1, ""];
  return `${Number((value / factor).toPrecision(3))} ${prefix}${unit}`;
};

/** The distance of a segment's ends [m]. @param {Rope} rope @param {number} j */
export function size(rope, j) {
  const [x, y, z] = rope.x;
  const [dx, dy, dz] = [x[j + 1] - x[j], y[j + 1] - y[j], z[j + 1] - z[j]];
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}

/** Write what every segment carries, friction along it included [N]. @param {Rope} rope @param {Float64Array} out */
export function tensions(rope, out) {
  const [x0, x1, x2] = rope.x;
  const [v0, v1, v2] = rope.v;
  for (let j = 0; j < rope.n - 1; j++) {
    const [dx, dy, dz] = [x0[j + 1] - x0[j], x1[j + 1] - x1[j], x2[j + 1] - x2[j]];
    const [ux, uy, uz] = [v0[j + 1] - v0[j], v1[j + 1] - v1[j], v2[j + 1] - v2[j]];
    const r = Math.sqrt(dx * dx + dy * dy + dz * dz);
    const loose = rope.slack[j] && r < rope.length[j];
    const rate = r > 0 ? (dx * ux + dy * uy + dz * uz) / r : 0;
    const carried = rope.stiffness[j] * (r - rope.length[j]);
    out[j] = loose ? 0 : carried + (rope.vector[j] + rope.axial[j]) * rate;
  }
}

/** Kinetic, elastic and gravity's energy [J], the last from the origin. @param {Rope} rope */
export function energies(rope) {
  let [kinetic, elastic] = [0, 0];
  for (let i = 0; i < rope.n; i++)
    for (const row of rope.v) kinetic += 0.5 * rope.mass[i] * row[i] * row[i];
  for (let j = 0; j < rope.n - 1; j++) {
    const r = size(rope, j);
    const more = rope.slack[j] ? Math.max(r - rope.length[j], 0) : r - rope.length[j];
    elastic += 0.5 * rope.stiffness[j] * more * more;
  }
  elastic += rope.contact?.stored() ?? 0; // where posts are pressed in
  return { kinetic, elastic, gravity: gravityAt(rope, rope.x) };
}

/** Gravity's energy at other places, from the origin [J]. @param {Rope} rope @param {Float64Array[]} x */
export function gravityAt(rope, x) {
  let energy = 0;
  for (let i = 0; i < rope.n; i++)
    for (let k = 0; k < 3; k++) energy -= rope.mass[i] * rope.gravity[k] * x[k][i];
  return energy;
}

/** The least elastic energy that a rope can have between its anchors where they are: each piece straight [J].
 * @param {Rope} rope @param {Float64Array[]} x */
export function tautEnergy(rope, x) {
  const held = rope.anchors.map((anchor) => anchor.node).sort((a, b) => a - b);
  let energy = 0;
  for (const [i, last] of held.slice(1).entries()) {
    let [soft, long] = [0, 0]; // 1/k of the piece, and its length without tension
    for (let j = held[i]; j < last; j++) {
      soft += 1 / rope.stiffness[j]; // between two ropes there is no spring: infinite
      long += rope.length[j];
    }
    const apart = Math.hypot(...x.map((row) => row[last] - row[held[i]]));
    energy += (0.5 * Math.max(apart - long, 0) ** 2) / soft;
  }
  return energy;
}
