import assert from "node:assert/strict";
import { test } from "node:test";

import { Blend } from "../src/view/blend.js";

test("the first frame is shown at once", () => {
  const blend = new Blend(2);
  blend.next(0).set([1, 2]);
  assert.ok(blend.advance(1));
  assert.deepEqual([...blend.shown], [1, 2]);
  assert.ok(!blend.advance(2), "nothing more to draw");
});

test("a frame is reached one frame's time after it came, and not overshot", () => {
  const blend = new Blend(1);
  blend.next(0);
  blend.advance(0);
  for (let k = 1; k <= 100; k++) {
    blend.next(20 * k)[0] = k;
    blend.advance(20 * k + 19.999);
  }
  assert.ok(Math.abs(blend.spacing - 20) < 0.01);
  blend.next(2020)[0] = 101;
  blend.advance(2030);
  assert.ok(Math.abs(blend.shown[0] - 100.5) < 0.01, `half way: ${blend.shown[0]}`);
  blend.advance(2100);
  assert.equal(blend.shown[0], 101);
});

test("motion goes on from what is seen when a frame comes early", () => {
  const blend = new Blend(1);
  blend.next(0);
  blend.advance(0);
  blend.next(16)[0] = 10;
  blend.advance(20);
  const seen = blend.shown[0];
  assert.ok(seen > 0 && seen < 10);
  blend.next(20)[0] = 20;
  blend.advance(20);
  assert.equal(blend.shown[0], seen);
});

test("a jump is not blended", () => {
  const blend = new Blend(1);
  blend.next(0);
  blend.advance(0);
  blend.next(5, true)[0] = 7;
  blend.advance(5);
  assert.equal(blend.shown[0], 7);
});
