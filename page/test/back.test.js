import assert from "node:assert/strict";
import { test } from "node:test";

import { backOf } from "../src/panels/back.js";

const friction = {
  name: "spring_friction",
  unit: "N s/m",
  value: null,
  default: 0.01,
  values: { a: 0.01, b: 0.5 },
  defaults: { a: 0.01, b: 0.5 },
};

test("every rope goes back to its own value", () => {
  assert.deepEqual(backOf(friction, "b"), { changed: false, title: "Back to 0.5 N s/m" });
  assert.deepEqual(backOf(friction, ""), { changed: false, title: "Back to each rope's own" });
  const moved = { ...friction, value: 0.01, values: { a: 0.01, b: 0.01 } };
  assert.deepEqual(backOf(moved, "a"), { changed: false, title: "Back to 0.01 N s/m" });
  assert.deepEqual(backOf(moved, "b"), { changed: true, title: "Back to 0.5 N s/m" });
  assert.equal(backOf(moved, "").changed, true);
  const one = { ...friction, value: 0.02, values: null, defaults: null };
  assert.deepEqual(backOf(one, ""), { changed: true, title: "Back to 0.01 N s/m" });
});

test("a piece of a cut rope has no mass to go back to", () => {
  const mass = { ...friction, unit: "kg", values: { a: 1, b: 2 }, defaults: { a: null, b: 4 } };
  for (const rope of ["a", ""]) assert.equal(backOf(mass, rope).changed, false);
  assert.match(backOf(mass, "a").title, /^A piece of a cut rope/);
  assert.deepEqual(backOf(mass, "b"), { changed: true, title: "Back to 4 kg" });
});
