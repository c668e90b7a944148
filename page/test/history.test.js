import assert from "node:assert/strict";
import { test } from "node:test";

import { extremes } from "../src/graphs/plot.js";
import { History } from "../src/graphs/history.js";

test("going back in time keeps what was before then, and forgets what came after", () => {
  const history = new History();
  for (let i = 0; i < 10; i++) history.add(i, [["a", 10 * i]]);
  history.add(4.5, [["a", -1]]);
  const [times, values] = history.between(0, 10, ["a"]);
  assert.deepEqual([...times], [0, 1, 2, 3, 4, 4.5]);
  assert.deepEqual([...values], [0, 10, 20, 30, 40, -1]);
  history.add(0, [["a", 7]]);
  assert.deepEqual([...history.between(0, 10, ["a"])[1]], [7]);
});

test("the oldest samples make room, and new names have no past", () => {
  const history = new History();
  for (let i = 0; i < 20_000; i++) history.add(i, [["a", i]]);
  history.add(20_000, [["b", 1]]);
  assert.ok(history.count <= 7200 && history.last === 20_000);
  const [times, a, b] = history.between(19_998, 20_000, ["a", "b"]);
  assert.equal(a[times.indexOf(19_999)], 19_999);
  assert.ok(Number.isNaN(a[times.length - 1]) && b[times.length - 1] === 1);
  assert.ok(Number.isNaN(b[0]));
});

test("a graph's range is that of the numbers that are there", () => {
  const column = (...values) => Float64Array.from(values);
  assert.deepEqual(extremes([column(0, 1, 2), column(NaN, 3, 5), column(-1, 4, NaN)]), [-1, 5]);
  assert.deepEqual(extremes([column(0, 1), column(NaN, NaN)]), [null, null]);
});
