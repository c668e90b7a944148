import assert from "node:assert/strict";
import { test } from "node:test";

import { SHADES, css, fromHex, linear, oklab, uniformMap, unshown } from "../src/view/colours.js";

const labs = uniformMap().map((colour) => oklab(colour.map(unshown)));

test("neighbouring shades are equally far apart for the eye", () => {
  const steps = labs.slice(1).map((q, i) => Math.hypot(...q.map((value, k) => value - labs[i][k])));
  const mean = steps.reduce((a, b) => a + b) / steps.length;
  assert.equal(labs.length, SHADES);
  for (const step of steps) assert.ok(Math.abs(step / mean - 1) < 0.1, `${step} against ${mean}`);
});

test("the map gets lighter all the way, so that it works without colours too", () => {
  for (let i = 1; i < labs.length; i++) assert.ok(labs[i][0] > labs[i - 1][0]);
  assert.ok(labs.at(-1)[0] - labs[0][0] > 0.3);
});

test("no shade had to be cut off to be shown", () => {
  for (const lab of labs) {
    // What is cut off does not come back: a shade that survives the way there and back was whole.
    for (const value of linear(lab)) assert.ok(value > -1e-6 && value < 1 + 1e-6);
  }
  for (const colour of uniformMap())
    assert.ok(
      colour.every((c) => c > 0 && c < 1),
      `${colour}`,
    );
});

test("OKLab and back", () => {
  const [l, a, b] = oklab([1, 1, 1]);
  assert.ok(Math.abs(l - 1) < 1e-6 && Math.abs(a) < 1e-6 && Math.abs(b) < 1e-6);
  linear(oklab([0.2, 0.5, 0.7])).forEach((value, i) => {
    assert.ok(Math.abs(value - [0.2, 0.5, 0.7][i]) < 1e-6);
  });
});

test("colours in style sheets", () => {
  assert.deepEqual(
    fromHex("#ff8000").map((c) => Math.round(255 * c)),
    [255, 128, 0],
  );
  assert.equal(css([1, 0.5, 0]), "rgb(255, 128, 0)");
  assert.equal(css([1, 0.5, 0], 0.5), "rgba(255, 128, 0, 0.5)");
});
