import assert from "node:assert/strict";
import { test } from "node:test";

import { alike, ofFirst } from "../src/input/counterpart.js";
import { Hand } from "../src/input/hand.js";
import { Tools } from "../src/panels/tools.js";

/** A layout of the rope a and b in copies of so many segments. @param {number[][]} copies @returns {any} */
const layoutOf = (copies) => ({
  variants: copies.map(([a, b]) => ({
    loads: [],
    ropes: [
      { name: "a", first: 0, zero: 0, nodes: a + 1, segments: a },
      { name: "b", first: a + 1, zero: a + 1, nodes: b + 1, segments: b },
    ],
  })),
});
const layout = layoutOf([
  [40, 10],
  [80, 5],
]);

test("a hit on a copy stands for the same place on the first", () => {
  for (const [variant, node, segment, there, middle] of [
    [0, 17, 17, 17, 17],
    [1, 40, 40, 20, 20], // the middle of a
    [1, 80, 79, 40, 39],
    [1, 81, 81, 41, 42], // the start of b, which is coarser in the copy
    [1, 86, 85, 51, 50],
  ])
    assert.deepEqual(ofFirst(layout, { variant, node, segment }), { node: there, segment: middle });
  const lost = { variant: 1, node: 99, segment: 98 };
  assert.deepEqual(ofFirst(layout, lost), { node: 99, segment: 98 });
  assert.deepEqual(ofFirst(null, lost), { node: 99, segment: 98 });
});

test("what is pressed on a copy is told as the first has it", () => {
  /** @type {any[]} */ const told = [];
  const tell = (/** @type {any} */ command) => told.push(command);
  const session = { layout, can: () => true, tell, send: tell, frame: null, status: null };
  const viewport = /** @type {any} */ ({
    session,
    marks: { held: new Set() },
    shifts: [[], [1, 0, 0]],
  });
  const tools = Object.assign(Object.create(Tools.prototype), { viewport, mass: 2 });
  const hit = { kind: "node", variant: 1, rope: "a", node: 40, segment: 40, place: [0, 0, 0] };
  for (const tool of ["pin", "cut", "load"]) tools.use(tool, hit);
  const hand = new Hand(viewport, /** @type {any} */ (hit), "grab");
  hand.release(false, 0);
  assert.deepEqual(told, [
    { type: "pin", node: 20 },
    { type: "cut", segment: 20 },
    { type: "load", node: 20, mass: 2 },
    { type: "let_go", node: 20, velocity: null },
  ]);
});

test("a node that is followed is the same place once there are more or fewer", () => {
  const [before, finer, other] = [
    [40, 10],
    [80, 10],
    [80, 5],
  ].map(([a, b]) => ({ ...layoutOf([[a, b]]).variants[0], nodes: a + b + 2 }));
  assert.deepEqual([...alike(new Set([20, 46]), before, finer)], [40, 86]); // not of the first rope now
  assert.deepEqual([...alike(new Set([86]), finer, before)], [46]);
  assert.deepEqual([...alike(new Set([91]), finer, other)], [86]);
  const cut = { nodes: 52, ropes: [{ ...before.ropes[0], name: "a-1" }, before.ropes[1]] };
  assert.deepEqual([...alike(new Set([20]), before, cut)], [20]); // a piece keeps its numbers
  assert.deepEqual([...alike(new Set([60]), finer, { nodes: 5, ropes: [] })], []);
});
