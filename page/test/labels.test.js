import assert from "node:assert/strict";
import { test } from "node:test";

import { holes } from "../src/graphs/plot.js";
import { placeLabel } from "../src/panels/labels.js";

test("a label stands beyond its arrow's tip and inside the scene", () => {
  const room = [400, 300];
  const right = placeLabel([200, 100], [30, 0], 60, room);
  assert.ok(right.x >= 200);
  const left = placeLabel([200, 100], [-30, 0], 60, room);
  assert.ok(left.x + 60 <= 200);
  const up = placeLabel([200, 100], [0, -30], 60, room);
  assert.ok(up.y + 20 <= 100);
  assert.equal(up.x, 170);
  const edge = placeLabel([395, 100], [30, 0], 60, room);
  assert.ok(edge.x + 60 <= 400);
  assert.ok(placeLabel([5, 2], [-1, -30], 60, room).y >= 0);
});

test("lines of a graph leave gaps where there is nothing", () => {
  const times = [0, 0.1, 0.2, 0.3, 8, 8.1];
  const values = [NaN, 1, NaN, 2, 3, 4];
  assert.deepEqual(holes(times, values, 0, 5), [
    [1, 3],
    [3, 4],
  ]);
  assert.deepEqual(holes([0, 0.1, 0.2], [1, 2, 3], 0, 2), []);
});
