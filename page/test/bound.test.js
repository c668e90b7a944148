import assert from "node:assert/strict";
import { test } from "node:test";

import { Pieces } from "../src/view/bound.js";

const shape = { nodes: 30, ropes: [0, 10, 20].map((first) => ({ first, count: 10 })) };
const layout = (/** @type {any} */ more) => ({ variants: [{ anchors: [{ index: 0 }], ...more }] });
const held = (/** @type {any} */ one, holds = () => true) =>
  new Pieces(one, shape, [0]).held(holds).map((piece) => piece.held);

test("a piece is held by an anchor, or by a joint with one that is, at any remove", () => {
  assert.deepEqual(held(layout({})), [true, false, false]);
  assert.deepEqual(held(layout({ joints: [{ nodes: [9, 10] }] })), [true, true, false]);
  const chain = { joints: [{ nodes: [19, 20] }, { nodes: [9, 10] }] };
  assert.deepEqual(held(layout(chain)), [true, true, true]);
  assert.deepEqual(
    held(layout(chain), () => false),
    [true, true, true],
  ); // it has let go: all are adrift
});

test("where nothing holds any rope the camera goes with all of them, bodies or not", () => {
  assert.deepEqual(held(layout({ anchors: [] })), [true, true, true]);
  assert.deepEqual(held({ ...layout({ anchors: [] }), obstacles: [{}] }), [true, true, true]);
  const adrift = (/** @type {any} */ one) =>
    new Pieces(one, shape, [0]).held(() => true).map((piece) => piece.adrift);
  assert.deepEqual(adrift(layout({ anchors: [] })), [true, true, true]);
  assert.deepEqual(adrift(layout({})), [false, false, false]);
});

test("the table is made once, and asked with what holds now", () => {
  const pieces = new Pieces(layout({ joints: [{ nodes: [9, 10] }] }), shape, [0]);
  const now = (/** @type {boolean} */ holds) => pieces.held(() => holds).map(({ held }) => held);
  assert.deepEqual(now(true), [true, true, false]);
  assert.deepEqual(now(false), [true, true, true]);
  assert.deepEqual(now(true), [true, true, false]);
});
