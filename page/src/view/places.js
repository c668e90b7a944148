// Where a label may stand beside the tip of an arrow.

/** @typedef {{x: number, y: number, width: number, height: number}} Box [CSS pixels] */

const APART = 5; // from the tip

/** Places for a label, the best first: beyond the tip in the arrow's direction, at the corners of that, above, below,
 * right and left of the tip, then farther off; all inside the room. @param {number[]} tip
 * @param {number[]} way of the arrow @param {number[]} size width and height @param {number[]} room @returns {Box[]} */
export function placesFor([x, y], [dx, dy], [width, height], room) {
  const length = Math.hypot(dx, dy);
  const [ux, uy] = length > 1 ? [dx / length, dy / length] : [1, 0];
  const reach =
    APART + Math.min(width / 2 / Math.abs(ux || 1e-9), height / 2 / Math.abs(uy || 1e-9));
  const beyond = [x + ux * reach, y + uy * reach];
  const aside = width / 2 + 3 * APART;
  const level = height / 2 + 3 * APART;
  const [across, up] = [width / 2 + APART, height / 2 + APART];
  const [sx, sy] = [ux < 0 ? -1 : 1, uy < 0 ? -1 : 1];
  const middles = [
    beyond,
    [x + sx * across, y + sy * up],
    [x - sx * across, y + sy * up],
    [x + sx * across, y - sy * up],
    [x, y - level],
    [x, y + level],
    [x + aside, y],
    [x - aside, y],
    [x - sx * across, y - sy * up],
    [x, y - level - 1.5 * height],
    [x, y + level + 1.5 * height],
  ];
  const inside = (/** @type {number} */ value, /** @type {number} */ most) =>
    Math.max(2, Math.min(value, most - 2));
  return middles.map(([mx, my]) => ({
    x: inside(mx - width / 2, room[0] - width),
    y: inside(my - height / 2, room[1] - height),
    width,
    height,
  }));
}

/** Whether a place lies over none of these boxes and points. @param {Box} place @param {Box[]} boxes
 * @param {number[][]} points */
export function free(place, boxes, points) {
  return (
    !boxes.some((box) => overlap(place, box)) &&
    !points.some(
      ([x, y]) =>
        x > place.x && x < place.x + place.width && y > place.y && y < place.y + place.height,
    )
  );
}

/** @param {Box} one @param {Box} other */
function overlap(one, other) {
  return (
    one.x < other.x + other.width &&
    other.x < one.x + one.width &&
    one.y < other.y + other.height &&
    other.y < one.y + one.height
  );
}
