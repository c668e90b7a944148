import assert from "node:assert/strict";
import { test } from "node:test";

import { isStable, largestStep } from "../src/lab/bounds.js";
import { METHODS, Rope } from "../src/lab/kernel.js";
import { brief, tensions, told } from "../src/lab/measures.js";
import { atMost } from "../src/lab/why.js";

/** One mass of 0.5 kg on a spring of 200 N/m, in line with gravity. @param {object} [more] @returns {any} */
const one = (more = {}) => ({
  name: "one", about: "", up: [0, 0, 1], gravity: [0, 0, 0], step: 1e-3, method: "rk4",
  x: [[0, 0], [0, 0], [0, -1.2]], v: [[0, 0], [0, 0], [0, 0]], mass: [0.5, 0.5], length: [1], stiffness: [200],
  vector: [0], axial: [0], slack: [false], ropes: [[0, 1]],
  anchors: [{ node: 0, origin: [0, 0, 0], velocity: [0, 0, 0], start: 0, stop: Infinity, release: null }],
  ...more,
}); // prettier-ignore

/** Error of the swinging mass after a tenth of a second. @param {string} method @param {number} steps */
function error(method, steps) {
  const rope = new Rope(one());
  for (let i = 0; i < steps; i++)
    rope.step(/** @type {any} */ (method), 0.1 / steps, (0.1 * (i + 1)) / steps);
  return Math.abs(rope.x[2][1] - (-1 - 0.2 * Math.cos(Math.sqrt(400) * 0.1)));
}

test("every method converges with its order to the exact swing", () => {
  for (const [method, order] of /** @type {const} */ ([
    ["semi-implicit-euler", 1],
    ["verlet", 2],
    ["rk4", 4],
  ])) {
    const [coarse, fine] = [error(method, 40), error(method, 80)];
    assert.ok(Math.abs(Math.log2(coarse / fine) - order) < 0.15, `${method}: ${coarse} ${fine}`);
  }
});

test("free fall is a parabola, and a released anchor lets go", () => {
  const free = new Rope(one({ gravity: [0, 0, -10], anchors: [] }));
  const start = 0.5 * (free.x[2][0] + free.x[2][1]);
  for (let i = 0; i < 500; i++) free.step("rk4", 1e-3);
  assert.ok(Math.abs(0.5 * (free.x[2][0] + free.x[2][1]) - start + 1.25) < 1e-12);
  const anchors = [{ ...one().anchors[0], release: 0.0025 }];
  const held = new Rope(one({ gravity: [0, 0, -10], anchors }));
  const steps = [1, 2, 3, 4].map(() => (held.step("rk4", 1e-3), held.x[2][0]));
  assert.deepEqual(steps.slice(0, 2), [0, 0]);
  assert.ok(steps[2] < 0); // rk4 cuts its third step at 2.5 ms
  const late = new Rope(one({ gravity: [0, 0, -10], anchors }));
  const whole = [1, 2, 3, 4].map(() => (late.step("semi-implicit-euler", 1e-3), late.x[2][0]));
  assert.deepEqual(whole.slice(0, 3), [0, 0, 0]); // which cuts none
  assert.ok(whole[3] < 0);
});

test("below the largest step a swing keeps its size, above it grows", () => {
  for (const method of METHODS) {
    const bound = largestStep(new Rope(one()), method);
    for (const [share, grows] of /** @type {const} */ ([
      [0.95, false],
      [1.05, true],
    ])) {
      const rope = new Rope(one({ x: [[0, 0], [0, 0], [0, -1.001]] })); // prettier-ignore
      let most = 0;
      for (let i = 0; i < 60; i++) {
        rope.step(method, share * bound);
        most = Math.max(most, Math.abs(rope.x[2][1] + 1));
      }
      assert.equal(most > 0.05, grows, `${method} at ${share} of the bound: ${most}`);
    }
  }
  assert.ok(isStable(7.9, 0) && !isStable(8.1, 0)); // rk4 without friction: w h <= sqrt(8)
});

test("a slack segment of a rope that does not push carries nothing", () => {
  const rope = new Rope(
    one({
      x: [
        [0, 0],
        [0, 0],
        [0, -0.5],
      ],
      slack: [true],
      vector: [3],
    }),
  );
  const tension = new Float64Array(2);
  tensions(rope, tension);
  assert.equal(tension[0], 0);
  assert.equal(rope.a[2][1], 0);
  const pushes = new Rope(
    one({
      x: [
        [0, 0],
        [0, 0],
        [0, -0.5],
      ],
    }),
  );
  assert.ok(pushes.a[2][1] < 0);
});

test("the largest step is told no larger than it is", () => {
  assert.equal(atMost(1.23456e-3), "1.234 ms");
  assert.equal(atMost(9.99999e-4), "0.9999 ms");
  for (const seconds of [1.234e-3, 1e-3, 0.1, 2.5e-5])
    // nor smaller by its rounding
    assert.equal(atMost(seconds), `${Number((1e3 * seconds).toPrecision(4))} ms`);
  for (let i = 1; i < 500; i++) {
    const exact = 1e3 * Math.exp(-i / 37);
    assert.ok(parseFloat(atMost(exact / 1e3)) <= exact * (1 + 1e-12));
    assert.ok(parseFloat(atMost(exact / 1e3)) > exact * (1 - 1.1e-3));
  }
});

test("what breaks soon is told with a power of ten", () => {
  assert.equal(brief(113456789012345), "1.135e14");
  assert.equal(brief(-1550.26), "-1550");
  assert.equal(brief(2e-10), "0");
  assert.equal(told(1.23456e14, "N"), "1.23e14 N");
  assert.equal(told(1.23456e9, "N"), "1230 MN");
});
