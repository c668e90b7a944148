import assert from "node:assert/strict";
import { test } from "node:test";

import { paceOf, throwOf } from "../src/input/throw.js";

const trace = (/** @type {number[]} */ ...times) =>
  times.map((time, i) => ({ time, place: /** @type {any} */ ([0.02 * i, 0, 0]) }));

test("a hand has the velocity of its last places", () => {
  const [x, y, z] = throwOf(trace(0, 10, 20, 30), 30, 80);
  assert.ok(Math.abs(x - 2) < 1e-9 && y === 0 && z === 0);
  assert.ok(Math.abs(throwOf(trace(0, 500, 510, 520), 520, 80)[0] - 2) < 1e-9); // only the last
});

test("a hand that has rested throws nothing", () => {
  assert.deepEqual(throwOf(trace(0, 10, 20), 200, 80), [0, 0, 0]);
  assert.deepEqual(throwOf([], 200, 80), [0, 0, 0]);
});

test("the pace is what is reached where the computer is slow, else what is asked for", () => {
  const frame = { realtime: 0.2 };
  assert.equal(paceOf(frame, { playing: true, slow: true, speed: 1 }), 0.2);
  assert.equal(paceOf(frame, { playing: true, slow: false, speed: 1 }), 1);
  assert.equal(paceOf(frame, { playing: true, slow: false, speed: 0.1 }), 0.1);
  assert.equal(paceOf(frame, { playing: false, slow: false, speed: 0.1 }), 1);
  assert.equal(paceOf(null, null), 1);
  const slowly = { realtime: 2e-4 }; // ten thousand nodes on a machine that does other things, too
  assert.equal(paceOf(slowly, { playing: true, slow: true, speed: 1 }), 2e-4);
});
