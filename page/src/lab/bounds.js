// The largest stable step of a rope, as the Python theory has it for a chain with one unknown a node: the
// highest frequency is that of all segments in line, which no shape exceeds.

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./kernel.js").Method} Method */

const MODES = 64; // up to the highest that are tried, for Runge-Kutta, whose region has a wavy edge
const SHARES = Array.from({ length: MODES }, (_, i) => (i + 1) / MODES);
/** What friction counts in 4 M - f h C - h^2 K, which is positive at a step h that holds. @type {Partial<Record<Method,
 * number>>} */
const PENCIL = { "semi-implicit-euler": 2, verlet: 4 };

/** One over the masses [1/kg], zero where an anchor holds for good: one that lets go later frees its node.
 * @param {Rope} rope */
function loose({ mass, anchors }) {
  const inverse = mass.map((one) => 1 / one);
  for (const { node, release } of anchors) if (release === null) inverse[node] = 0;
  return inverse;
}

/** The largest eigenvalue, if any is above zero, of a chain's matrix over its masses, by Sturm sequences.
 * @param {Rope} rope @param {Float64Array} values of the segments @param {Float64Array} own of the nodes */
function highest(rope, values, own) {
  const { n } = rope;
  const inverse = loose(rope);
  /** @type {number[]} */ const diagonal = [];
  /** @type {number[]} */ const squares = []; // of the entry before
  /** @type {number[]} */ const rows = []; // what no eigenvalue exceeds (Gershgorin)
  for (let i = 0; i < n; i++) {
    const [before, after] = [i ? values[i - 1] : 0, i < n - 1 ? values[i] : 0];
    const w = inverse[i];
    diagonal.push((before + after + own[i]) * w);
    rows.push(diagonal[i] + (Math.abs(before) + Math.abs(after)) * w);
    squares.push(i ? before * before * w * inverse[i - 1] : 0);
  }
  let [low, high] = [0, Math.max(...rows)];
  /** @param {number} at how many eigenvalues lie above it */
  const above = (at) => {
    let [count, q] = [0, 1];
    for (let i = 0; i < n; i++) {
      q = diagonal[i] - at - (i ? squares[i] / q : 0);
      if (q === 0) q = 1e-14 * at; // as if the matrix were changed by its rounding
      count += q > 0 ? 1 : 0;
    }
    return count;
  };
  for (let i = 0; i < 80 && high > low * (1 + 1e-14); i++) {
    const middle = 0.5 * (low + high);
    if (above(middle)) low = middle;
    else high = middle;
  }
  return high;
}

/** Whether Runge-Kutta keeps the size of a mode with a = (w h)^2 and b = c h / m: its two rates times the step are
 * those of z^2 + b z + a = 0. @param {number} a @param {number} b */
export function isStable(a, b) {
  const root = b * b - 4 * a;
  const size = Math.sqrt(Math.abs(root));
  const rates =
    root < 0 ? [[-b / 2, size / 2]] : [(-b - size) / 2, (-b + size) / 2].map((rate) => [rate, 0]);
  return rates.every(([p, q]) => quartic(p, q) <= 1 + 1e-9);
}

/** |1 + z + z^2/2 + z^3/6 + z^4/24| of z = p + i q. @param {number} p @param {number} q */
function quartic(p, q) {
  let [re, im] = [1, 0];
  for (const k of [4, 3, 2, 1]) [re, im] = [1 + (p * re - q * im) / k, (p * im + q * re) / k];
  return Math.hypot(re, im);
}

/** @typedef {{k: Float64Array, c: Float64Array, own: Float64Array, damp: Float64Array}} Chain stiffness and friction of
 *   its segments and of its nodes */

/** Pairs of stiffness and friction over the mass that enclose those of every mode [1/s^2], [1/s]. Without posts
 * friction goes with stiffness. With them it may be what no direction exceeds; sideways there is less of the springs'
 * stiffness, but of the friction all that does not only act along. @param {Rope} rope @param {Chain} chain
 * @param {boolean} friction @returns {number[][]} */
function modes(rope, chain, friction) {
  const [a, b] = [highest(rope, chain.k, chain.own), highest(rope, chain.c, chain.damp)];
  const along = SHARES.map((share) => [a * share, b * share]);
  if (!rope.contact || !(b > 0)) return along;
  const across = edge(rope, { ...chain, c: friction ? rope.vector : chain.c });
  return [
    ...along,
    ...edge(rope, chain),
    ...[0.3, 1e-3].flatMap((less) => across.map(([p, q]) => [less * p, q])),
  ];
}

/** The stiffest modes with so much friction. @param {Rope} rope @param {Chain} chain @returns {number[][]} */
function edge(rope, { k, c, own, damp }) {
  const [a, b] = [highest(rope, k, own), highest(rope, c, damp)];
  const slopes = [0, 0.1, 0.2, 0.5, 1, 2, 5, 10].map((slope) => (slope * a) / b);
  const reach = slopes.map((q) => {
    const both = k.map((one, j) => one - q * c[j]);
    return highest(rope, both, own.map((one, i) => one - q * damp[i])); // prettier-ignore
  });
  return [0, ...SHARES].map((share) => [
    Math.min(...slopes.map((q, i) => reach[i] + q * b * share)),
    b * share,
  ]);
}

/** The largest stable step [s] of a rope with a method, wherever it touches posts. @param {Rope} rope
 * @param {Method} method @param {boolean} [friction] false: of the springs alone */
export function largestStep(rope, method, friction = true) {
  const none = new Float64Array(rope.n);
  const { stiff: own, damp } = rope.contact?.hardest() ?? { stiff: none, damp: none };
  const c = rope.vector.map((one, j) => (friction ? one + rope.axial[j] : 0));
  const chain = { k: rope.stiffness, c, own, damp: friction ? damp : none };
  const spring = highest(rope, chain.k, own);
  if (!(spring > 0)) {
    const rub = highest(rope, c, chain.damp);
    return rub > 0 ? 2 / rub : Infinity;
  }
  const f = PENCIL[method];
  const pairs = f === undefined ? modes(rope, chain, friction) : [];
  /** @param {number} h whether every mode keeps its size */
  const holds = (h) => {
    if (f === undefined) return pairs.every(([a, b]) => isStable(h * h * a, h * b));
    const nodes = own.map((one, i) => h * h * one + f * h * chain.damp[i]);
    return highest(rope, chain.k.map((one, j) => h * h * one + f * h * c[j]), nodes) <= 4; // prettier-ignore
  };
  let [low, high] = [0, 4 / Math.sqrt(spring)];
  for (let i = 0; i < 60; i++) {
    const middle = 0.5 * (low + high);
    if (holds(middle)) low = middle;
    else high = middle;
  }
  return low;
}
