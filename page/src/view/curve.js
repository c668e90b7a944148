// The smooth line that is drawn through a rope's nodes: a cubic Hermite curve with centripetal Catmull-Rom
// tangents (Yuksel, Schaefer and Keyser 2011), held back at folds so that it neither overshoots nor turns back.

/** @typedef {import("../render/view.js").RopeSpan} RopeSpan */

const LONGEST = 1.6; // of a tangent, in chords
const FOLD = [-0.3, 0.4]; // cosines of a bend between which the curve becomes the polyline

/** Tangents of the segment before the present one and of the present one, at its two ends. */
const enter = new Float64Array(3);
const leave = new Float64Array(3);

/** Write the points of a rope's curve: `steps` for each segment and the last node. Each has x, y, z and the value
 * that goes linearly from node to node.
 * @param {ArrayLike<number>} nodes x, y, z, value of all nodes @param {RopeSpan} rope
 * @param {number} steps @param {ArrayLike<number>} corners 1 for nodes where the rope may have a kink
 * @param {Float32Array} out @param {number} first point of this rope in `out` */
export function refine(nodes, rope, steps, corners, out, first) {
  const last = rope.first + rope.count - 1;
  let at = 4 * first;
  for (let i = rope.first; i < last; i++) {
    const p = 4 * i;
    const chord = distance(nodes, p, p + 4);
    const before = i > rope.first && !corners[i];
    const after = i + 1 < last && !corners[i + 1];
    if (before) tangent(nodes, p, p, chord, enter);
    if (after) tangent(nodes, p + 4, p, chord, leave);
    for (let k = 0; k < 3; k++) {
      const along = nodes[p + 4 + k] - nodes[p + k];
      if (!before) enter[k] = after ? 1.5 * along - 0.5 * leave[k] : along;
      if (!after) leave[k] = before ? 1.5 * along - 0.5 * enter[k] : along;
    }
    shorten(enter, LONGEST * chord);
    shorten(leave, LONGEST * chord);
    for (let step = 0; step < steps; step++, at += 4) {
      const t = step / steps;
      const [t2, t3] = [t * t, t * t * t];
      const [h1, h2, h3] = [3 * t2 - 2 * t3, t - 2 * t2 + t3, t3 - t2];
      for (let k = 0; k < 3; k++) {
        const from = nodes[p + k];
        out[at + k] = from + h1 * (nodes[p + 4 + k] - from) + h2 * enter[k] + h3 * leave[k];
      }
      out[at + 3] = nodes[p + 3] + t * (nodes[p + 7] - nodes[p + 3]);
    }
  }
  for (let k = 0; k < 4; k++) out[at + k] = nodes[4 * last + k];
}

/** The tangent at node `q`, for the segment that begins at `p`.
 * @param {ArrayLike<number>} nodes @param {number} q @param {number} p @param {number} chord
 * @param {Float64Array} out */
function tangent(nodes, q, p, chord, out) {
  const a = distance(nodes, q - 4, q);
  const b = distance(nodes, q, q + 4);
  const own = Math.sqrt(chord);
  if (!(a > 0 && b > 0)) {
    for (let k = 0; k < 3; k++) out[k] = nodes[p + 4 + k] - nodes[p + k];
    return;
  }
  const [ka, kb] = [Math.sqrt(a), Math.sqrt(b)]; // knots
  let cosine = 0;
  for (let k = 0; k < 3; k++) {
    cosine += ((nodes[q + k] - nodes[q - 4 + k]) * (nodes[q + 4 + k] - nodes[q + k])) / (a * b);
  }
  const part = Math.min(1, Math.max(0, (cosine - FOLD[0]) / (FOLD[1] - FOLD[0])));
  const smooth = part * part * (3 - 2 * part);
  for (let k = 0; k < 3; k++) {
    const [x, y, z] = [nodes[q - 4 + k], nodes[q + k], nodes[q + 4 + k]];
    const slope = (y - x) / ka - (z - x) / (ka + kb) + (z - y) / kb;
    const along = nodes[p + 4 + k] - nodes[p + k];
    out[k] = along + smooth * (slope * own - along);
  }
}

/** @param {Float64Array} a @param {number} most */
function shorten(a, most) {
  const size = Math.hypot(a[0], a[1], a[2]);
  if (size > most) for (let k = 0; k < 3; k++) a[k] *= most / size;
}

/** @param {ArrayLike<number>} nodes @param {number} p @param {number} q */
function distance(nodes, p, q) {
  return Math.hypot(nodes[q] - nodes[p], nodes[q + 1] - nodes[p + 1], nodes[q + 2] - nodes[p + 2]);
}

/** Write a normal at each point that does not twist about the line: by double reflection (Wang et al. 2008) from
 * the first one, which stays what it was in the last picture, so that the strands do not swim.
 * @param {Float32Array} points x, y, z, value @param {number} first @param {number} count
 * @param {Float32Array} out normal and one more number, which is kept; out of `first` is what was there before */
export function carryNormals(points, first, count, out) {
  let q = 4 * first;
  let [tx, ty, tz] = [1, 0, 0];
  let [nx, ny, nz] = [out[q], out[q + 1], out[q + 2]];
  let begun = false;
  for (let i = 0; i < count; i++, q += 4) {
    if (i > 0 && i + 1 === count) {
      out[q] = nx;
      out[q + 1] = ny;
      out[q + 2] = nz;
      break;
    }
    const dx = points[q + 4] - points[q];
    const dy = points[q + 5] - points[q + 1];
    const dz = points[q + 6] - points[q + 2];
    const size = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (size > 0) {
      const [ux, uy, uz] = [dx / size, dy / size, dz / size];
      if (begun) {
        // The rotation that takes the last direction to this one takes the normal along.
        const c = tx * ux + ty * uy + tz * uz;
        if (c > -0.999) {
          const s = (nx * ux + ny * uy + nz * uz) / (1 + c);
          nx -= s * (tx + ux);
          ny -= s * (ty + uy);
          nz -= s * (tz + uz);
        }
      }
      [tx, ty, tz] = [ux, uy, uz];
      const off = nx * tx + ny * ty + nz * tz;
      [nx, ny, nz] = [nx - off * tx, ny - off * ty, nz - off * tz];
      let long = Math.sqrt(nx * nx + ny * ny + nz * nz);
      if (!(long > 1e-3)) {
        [nx, ny, nz] = Math.abs(tz) < 0.9 ? [-ty, tx, 0] : [0, -tz, ty];
        long = Math.sqrt(nx * nx + ny * ny + nz * nz);
      }
      nx /= long;
      ny /= long;
      nz /= long;
      begun = true;
    }
    out[q] = nx;
    out[q + 1] = ny;
    out[q + 2] = nz;
  }
}
