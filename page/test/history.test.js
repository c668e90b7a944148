import assert from "node:assert/strict";
import { test } from "node:test";

import { extremes } from "../src/graphs/plot.js";
import { History } from "../src/graphs/history.js";
import { longestOf, numbered } from "../src/graphs/samples.js";

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

test("a line has no past of another anchor, comparison or place", () => {
  const layoutOf = (anchors, nodes, ...labels) => ({
    variants: [
      { nodes, anchors: anchors.map((name) => ({ name })) },
      ...labels.map((label) => ({ label })),
    ],
  });
  const history = new History();
  const fill = (layout) => {
    history.tell(numbered(layout));
    const known = [...history.columns.keys()].sort();
    for (const name of ["kinetic", "force 0", "difference 1", "height 7", "low tension 7"])
      history.add(history.count, [[name, 1]]);
    return known;
  };
  fill(layoutOf(["left", "right"], 41, "rk4"));
  const all = ["difference 1", "force 0", "height 7", "kinetic", "low tension 7"];
  assert.deepEqual(fill(layoutOf(["left", "right"], 41, "rk4")), all);
  const without = (...gone) => all.filter((name) => !gone.includes(name));
  assert.deepEqual(fill(layoutOf(["right"], 41, "rk4")), without("force 0"));
  assert.deepEqual(fill(layoutOf(["right"], 41, "bdf2")), without("difference 1"));
  assert.deepEqual(fill(layoutOf(["right"], 61, "bdf2")), without("height 7", "low tension 7"));
});

test("samples that are missing are known, whatever speed comes later", () => {
  const history = new History();
  for (const time of [0, 0.1, 0.2]) history.add(time, [["a", time]], 0.12);
  history.add(0.7, [["a", 0.7]], 0.12);
  history.add(1.2, [["a", 1.2]], 0.8); // eight times as fast
  assert.deepEqual([...history.apartBetween(0, 2)], [0, 0, 0, 1, 0]);
  history.add(0.15, [["a", 0]], 0.12); // gone back
  assert.deepEqual([...history.apartBetween(0, 2)], [0, 0, 0]);
  assert.equal(history.between(0, 2, ["a"])[0].length, 3);
});

test("frames are late by the clock, or by the scene's own", () => {
  const hello = { mode: "live" };
  const status = { speed: 1, dt: 0.002, steps_per_frame: 8 };
  const near = (session, wanted) => assert.ok(Math.abs(longestOf(session) - wanted) < 1e-12);
  near({ hello, status }, 0.1);
  near({ hello, status: { ...status, speed: 8 } }, 0.8);
  near({ hello, status: { ...status, speed: 0.01 } }, 0.064);
  assert.equal(longestOf({ hello: { mode: "replay" }, status }), Infinity);
});
