import assert from "node:assert/strict";
import { test } from "node:test";

import { partedText } from "../src/panels/parted.js";
import { gapsAt, shapeOf } from "../src/view/copies.js";

const rope = { name: "one", first: 0, nodes: 6, zero: 0, segments: 5, length: 5, diameter: 0.1 };
const layout = /** @type {any} */ ({
  variants: [
    {
      nodes: 9,
      ropes: [
        { ...rope, color: 0 },
        { ...rope, name: "two", first: 6, nodes: 3, segments: 2, length: 2, color: 1 },
      ],
      anchors: [{ index: 0 }],
      loads: [],
      gaps: [
        { index: 3, time: 2 },
        { index: 1, time: 1 },
      ],
    },
  ],
});

test("a rope is drawn in pieces from when it has parted", () => {
  const pieces = (/** @type {number} */ time) =>
    shapeOf(layout, gapsAt(layout, time)).ropes.map(({ first, count, loose }) => [
      first,
      count,
      ...loose.map(Number),
    ]);
  assert.deepEqual(pieces(0.5), [
    [0, 6, 0, 1],
    [6, 3, 1, 1],
  ]);
  assert.deepEqual(pieces(1), [
    [0, 2, 0, 1],
    [2, 4, 1, 1],
    [6, 3, 1, 1],
  ]);
  assert.deepEqual(
    pieces(3).map(([first, count]) => [first, count]),
    [
      [0, 2],
      [2, 2],
      [4, 2],
      [6, 3],
    ],
  );
});

test("words say where from the nearer end", () => {
  const told = { rope: "line", length: 2, tension: 24.34, time: 0.42 };
  assert.equal(
    partedText({ ...told, place: 0.5 }),
    "line parted 0.5 m from its start, at 24.3 N, t = 0.42 s",
  );
  assert.match(partedText({ ...told, place: 1.75 }), /0\.25 m from its end/);
});
