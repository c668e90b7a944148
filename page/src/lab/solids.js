// Surfaces of posts: how far a place is from one, and the way out, as the Python `obstacle_shapes` has it.

/** @typedef {"plane" | "sphere" | "cylinder" | "capsule"} Kind */
/** @typedef {{kind: Kind, center: number[], axis: number[], radius: number, half: number | null, friction: number,
 *   compliance: number | null}} Post `half` is half its length [m], null: endless */

/** Write the distance from a post's surface, negative inside, the normal n out of it, and how it turns, (9): a, c, c'.
 * @param {Post} post @param {number} x @param {number} y @param {number} z @param {Float64Array} out */
export function probe({ kind, center, axis, radius, half }, x, y, z, out) {
  const px = x - center[0];
  const py = y - center[1];
  const pz = z - center[2];
  if (kind === "sphere") {
    ball(px, py, pz, radius, out);
    return;
  }
  const ex = axis[0];
  const ey = axis[1];
  const ez = axis[2];
  const along = px * ex + py * ey + pz * ez;
  if (kind === "plane") {
    write(along, ex, ey, ez, out);
    return;
  }
  const ux = px - along * ex;
  const uy = py - along * ey;
  const uz = pz - along * ez;
  const rho = Math.sqrt(ux * ux + uy * uy + uz * uz);
  if (rho > 0) {
    write(rho - radius, ux / rho, uy / rho, uz / rho, out);
    turn(ex, ey, ez, 1 / rho, 0, out);
  } else across(axis, -radius, out);
  const beyond = Math.abs(along) - (half ?? Infinity);
  const far = along > 0 ? beyond : -beyond;
  const side = along > 0 ? 1 : -1;
  if (kind === "capsule") {
    if (beyond > 0)
      ball(rho * out[1] + far * ex, rho * out[2] + far * ey, rho * out[3] + far * ez, radius, out);
  } else if (out[0] > 0 && beyond > 0) rim(far, rho, axis, out);
  else if (out[0] < beyond) write(beyond, side * ex, side * ey, side * ez, out);
}

/** @param {number} gap @param {number} nx @param {number} ny @param {number} nz @param {Float64Array} out */
function write(gap, nx, ny, nz, out) {
  out[0] = gap;
  out[1] = nx;
  out[2] = ny;
  out[3] = nz;
  out.fill(0, 4);
}

/** dn = (c (I - n n' - a a') + c' a a') dx. @param {number} ax @param {number} ay @param {number} az @param {number} c
 * [1/m] @param {number} other c' @param {Float64Array} out */
function turn(ax, ay, az, c, other, out) {
  out[4] = ax;
  out[5] = ay;
  out[6] = az;
  out[7] = c;
  out[8] = other;
}

/** Some direction across an axis. @param {number[]} axis @param {number} gap @param {Float64Array} out */
function across([ex, ey, ez], gap, out) {
  const [x, y, z] = Math.abs(ex) < 0.7 ? [0, ez, -ey] : [-ez, 0, ex];
  const size = Math.sqrt(x * x + y * y + z * z);
  write(gap, x / size, y / size, z / size, out);
}

/** About a point. @param {number} px from it @param {number} py @param {number} pz @param {number} radius
 * @param {Float64Array} out */
function ball(px, py, pz, radius, out) {
  const d = Math.sqrt(px * px + py * py + pz * pz);
  if (d === 0) write(-radius, 0, 0, 1, out);
  else {
    write(d - radius, px / d, py / d, pz / d, out);
    turn(0, 0, 0, 1 / d, 0, out);
  }
}

/** Beyond the edge of a flat end. @param {number} far past the end @param {number} rho [m] from the axis
 * @param {number[]} axis @param {Float64Array} out the way from the axis, which becomes that from the edge */
function rim(far, rho, [ex, ey, ez], out) {
  const [gap, ux, uy, uz] = out;
  const d = Math.sqrt(gap * gap + far * far);
  const p = gap / d;
  const q = far / d;
  write(d, p * ux + q * ex, p * uy + q * ey, p * uz + q * ez, out);
  turn(ey * uz - ez * uy, ez * ux - ex * uz, ex * uy - ey * ux, 1 / d, p / rho, out);
}
