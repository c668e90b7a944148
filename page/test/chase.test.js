import assert from "node:assert/strict";
import { test } from "node:test";

import { Chase } from "../src/view/chase.js";

const pose = (/** @type {number} */ x, distance = 10) => ({
  target: /** @type {[number, number, number]} */ ([x, 0, 0]),
  distance,
  azimuth: 0.3,
  elevation: 0.2,
});

/** @param {number} rate of pictures [1/s] @param {number} seconds @param {(chase: Chase, t: number) => void} [each] */
function run(rate, seconds, each = () => {}) {
  const chase = new Chase(pose(0), pose(5, 40), 0);
  for (let i = 1; i <= rate * seconds; i++) {
    each(chase, i / rate);
    chase.at((1000 * i) / rate);
  }
  return chase;
}

test("it starts softly, does not overshoot, and ends, the same at any rate of pictures", () => {
  let most = 0;
  const slow = run(20, 1, ({ pose: { target } }) => (most = Math.max(most, target[0])));
  const fast = run(120, 1);
  assert.ok(Math.abs(slow.pose.target[0] - fast.pose.target[0]) < 1e-9);
  assert.ok(Math.abs(slow.pose.distance - fast.pose.distance) < 1e-9);
  const part = 1 - (1 + 3.5) * Math.exp(-3.5); // of a critically damped way, after a second
  assert.ok(Math.abs(fast.pose.target[0] - 5 * part) < 1e-9);
  assert.ok(Math.abs(fast.pose.distance - 10 * 4 ** part) < 1e-9);
  assert.ok(run(60, 0.05).pose.target[0] < 0.1); // a jump would have begun at full speed
  assert.ok(most <= 5);
  assert.equal(fast.there, false);
  assert.equal(run(60, 4).there, true);
});

test("a goal that moves evenly is followed at two over the rate", () => {
  const chase = run(60, 6, (one, t) => (one.to = pose(3 * t)));
  assert.ok(Math.abs(18 - chase.pose.target[0] - (3 * 2) / 3.5) < 0.06);
});
