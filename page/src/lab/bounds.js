// The largest stable step of a rope, as the Python theory has it for a chain with one unknown a node: the
// highest frequency is that of all segments in line, which no shape exceeds.

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./kernel.js").Method} Method */

const MODES = 64; // below the highest that are tried, for methods whose region has a wavy edge

/** The largest eigenvalue of the chain's stiffness, or friction, over its masses, by Sturm sequences.
 * @param {Rope} rope @param {Float64Array} values of the segments */
function highest(rope, values) {
  const n = rope.n;
  /** @type {number[]} */ const diagonal = [];
  /** @type {number[]} */ const squares = []; // of the entry before
  for (let i = 0; i < n; i++) {
    const [before, after] = [i ? values[i - 1] : 0, i < n - 1 ? values[i] : 0];
    const w = rope.inverse[i];
    diagonal.push((before + after) * w);
    squares.push(i ? before * before * w * rope.inverse[i - 1] : 0);
  }
  let [low, high] = [0, 2 * Math.max(...diagonal)];
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

/** Whether a mode with a = (w h)^2 and b = c h / m keeps its size; the Jury conditions of the methods' polynomials.
 * @param {Method} method @param {number} a @param {number} b */
export function isStable(method, a, b) {
  if (method === "semi-implicit-euler") return a + 2 * b <= 4 && b <= 2;
  if (method === "verlet") return a + 4 * b <= 4 && b + 0.5 * a * b + b * b <= 2;
  // the two rates of the mode times the step: z^2 + b z + a = 0
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

/** The largest stable step [s] of a rope with a method. @param {Rope} rope @param {Method} method
 * @param {boolean} [friction] false: of the springs alone */
export function largestStep(rope, method, friction = true) {
  const stiff = highest(rope, rope.stiffness);
  const rub = highest(
    rope,
    rope.vector.map((c, j) => (friction ? c + rope.axial[j] : 0)),
  );
  if (!(stiff > 0)) return rub > 0 ? 2 / rub : Infinity;
  /** @param {number} h whether every mode up to the highest keeps its size */
  const holds = (h) => {
    for (let i = 1; i <= MODES; i++) {
      const share = i / MODES;
      if (!isStable(method, h * h * stiff * share, h * rub * share)) return false;
    }
    return true;
  };
  let [low, high] = [0, 4 / Math.sqrt(stiff)];
  for (let i = 0; i < 60; i++) {
    const middle = 0.5 * (low + high);
    if (holds(middle)) low = middle;
    else high = middle;
  }
  return low;
}
