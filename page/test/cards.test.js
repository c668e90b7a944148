import assert from "node:assert/strict";
import { test } from "node:test";

import { stripsBeside, stripsBetween } from "../src/view/cards.js";

test("the row of tools is kept free where tools lie in a row: in a low scene, and on a phone", () => {
  assert.deepEqual(stripsBeside(null, { width: 390, height: 640 }), { top: 60, bottom: 0 });
  assert.deepEqual(stripsBeside(null, { width: 844, height: 300 }), { top: 60, bottom: 0 });
  assert.deepEqual(stripsBeside(null, { width: 968, height: 660 }), { top: 0, bottom: 0 });
});

test("in a scene without height to spare ropes are between the tools at its sides", () => {
  const bars = [
    { left: 12, right: 167 },
    { left: 736, right: 832 },
  ];
  assert.deepEqual(stripsBetween(bars, { width: 844, height: 103 }), { left: 167, right: 108 });
  assert.deepEqual(stripsBetween(bars, { width: 844, height: 260 }), {}); // the twin
  assert.deepEqual(
    stripsBetween([{ left: 12, right: 600 }, bars[1]], { width: 844, height: 103 }),
    {},
  );
});
