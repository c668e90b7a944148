// How fast a node comes at a post, as far as it will touch it, as the Python `closing` has it.

const EVEN = 1e-3; // gap over r below which what may pass grows evenly
const SHARP = 1e-3; // least (r - gap) / r

/** How fast a gap grows that will close [m/s], 0: it will not. @param {number} rise how fast it grows at all
 * @param {number} gap [m] @param {Float64Array} found what `probe` wrote @param {number} v0 the node's velocity [m/s]
 * @param {number} v1 @param {number} v2 */
export function closing(rise, gap, found, v0, v1, v2) {
  const [, nx, ny, nz, ax, ay, az, ca, cb] = found;
  if (rise >= 0 || gap <= 0 || ca <= 0 || cb !== 0) return rise;
  const along = nx * v0 + ny * v1 + nz * v2;
  const aside = ax * v0 + ay * v1 + az * v2;
  const h0 = ca * (v0 - along * nx - aside * ax) + cb * aside * ax;
  const h1 = ca * (v1 - along * ny - aside * ay) + cb * aside * ay;
  const h2 = ca * (v2 - along * nz - aside * az) + cb * aside * az;
  const square = (h0 * v0 + h1 * v1 + h2 * v2) / ca;
  return square > 0 ? Math.min(rise + passing(gap, ca) * Math.sqrt(square), 0) : rise;
}

/** By how much a node may come nearer than it goes along the arc. @param {number} gap [m] @param {number} over 1/r
 * [1/m] */
function passing(gap, over) {
  const even = EVEN / over;
  const far = Math.max(gap, even);
  const inner = Math.max(1 - far * over, SHARP);
  const most = Math.sqrt(far * over * (1 + inner)) / inner;
  return gap < even ? (most * gap) / even : most;
}
