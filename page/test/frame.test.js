import assert from "node:assert/strict";
import { test } from "node:test";

import { MAGIC, between, readFrame, scalar } from "../src/source/frame.js";
import { gather } from "../src/source/gather.js";

// A frame as docs/reference/live-protocol.md describes it: 3 nodes (odd: with padding), 1 anchor, 1 grab.
const NODES = 3;
const variant = {
  label: "as it is",
  method: "rk4",
  changes: {},
  nodes: NODES,
  loads: [],
  ropes: [
    {
      name: "rope",
      first: 0,
      nodes: 3,
      zero: 0,
      segments: 2,
      length: 2,
      EA: 50,
      diameter: 0.01,
      mass: 1,
      color: 0,
    },
  ],
  anchors: [{ name: "left", rope: "rope", node: 0, index: 0, motion: "hand", pinned: false }],
  offsets: {
    scalars: 48,
    positions: 60,
    tension: 96,
    speed: 104,
    least_tension: 112,
    greatest_tension: 120,
    greatest_speed: 128,
    least_height: 136,
    greatest_height: 144,
    greatest_force: 152,
    anchors: 156,
    grabs: 196,
  },
};
const layout = {
  type: "layout",
  layout: 7,
  bytes: 228,
  scene: { name: "", description: "", preset: null },
  up: [0, 0, 1],
  gravity: [0, 0, -9.81],
  ground: null,
  view: { center: [0, 0, 0], radius: 1 },
  scalars: ["tension_low", "tension_high", "speed_high"],
  variants: [variant],
};

function frame() {
  const buffer = new ArrayBuffer(layout.bytes);
  const view = new DataView(buffer);
  view.setUint32(0, MAGIC, true);
  view.setUint32(4, 7, true);
  view.setUint32(8, 42, true);
  view.setUint32(12, 1 | 8, true);
  view.setFloat64(16, 1.25, true);
  view.setFloat64(24, 5e9, true);
  view.setFloat32(32, 0.5, true);
  [-10, 30, 8].forEach((value, i) => view.setFloat32(48 + 4 * i, value, true));
  for (let i = 0; i < 9; i++) view.setFloat32(60 + 4 * i, i + 0.5, true);
  [0, 65535, 0].forEach((value, i) => view.setUint16(96 + 2 * i, value, true));
  [0, 32768, 65535].forEach((value, i) => view.setUint16(104 + 2 * i, value, true));
  [0, 0, 0].forEach((value, i) => view.setUint16(112 + 2 * i, value, true));
  [0, 65535, 0].forEach((value, i) => view.setUint16(120 + 2 * i, value, true));
  [0, 32768, 65535].forEach((value, i) => view.setUint16(128 + 2 * i, value, true));
  view.setFloat32(152, 77, true);
  for (let i = 0; i < 10; i++) view.setFloat32(156 + 4 * i, 100 + i, true);
  [2, 7, 8, 9, 3, 4, 0, 0].forEach((value, i) => view.setFloat32(196 + 4 * i, value, true));
  return buffer;
}

test("the head and the parts lie where the protocol says", () => {
  const read = readFrame(frame(), layout);
  assert.equal(read.number, 42);
  assert.equal(read.flags, 9);
  assert.equal(read.time, 1.25);
  assert.equal(read.steps, 5e9);
  assert.equal(read.realtime, 0.5);
  const [part] = read.parts;
  assert.deepEqual([...part.positions], [0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5]);
  assert.deepEqual([...part.anchors.subarray(0, 3)], [100, 101, 102]);
  assert.deepEqual([...part.grabs.subarray(0, 4)], [2, 7, 8, 9]);
  assert.equal(part.grabs.length, 8);
});

test("tension is between its bounds", () => {
  const [part] = readFrame(frame(), layout).parts;
  assert.equal(scalar(layout, part, "tension_high"), 30);
  assert.ok(Number.isNaN(scalar(layout, part, "no such")));
  const pulls = [...part.tension].slice(0, 2);
  const found = pulls.map((share) => between(layout, part, share, "tension_low", "tension_high"));
  assert.deepEqual(found, [-10, 30]);
  assert.equal(between(layout, part, part.seen.greatestSpeed[2], null, "speed_high"), 8);
  assert.equal(part.seen.greatestForce[0], 77);
});

test("nothing is copied", () => {
  const buffer = frame();
  const [part] = readFrame(buffer, layout).parts;
  assert.equal(part.positions.buffer, buffer);
});

test("other bytes and other layouts are refused", () => {
  assert.throws(() => readFrame(new ArrayBuffer(10), layout), /not a frame/);
  assert.throws(() => readFrame(new ArrayBuffer(228), layout), /not a frame/);
  assert.throws(() => readFrame(frame(), { ...layout, layout: 8 }), /another layout/);
  assert.throws(() => readFrame(frame().slice(0, 100), layout), /cut short/);
});

test("gather puts places with their shift and values into the drawn array", () => {
  const read = readFrame(frame(), layout);
  const out = new Float32Array(12);
  assert.deepEqual(gather(read, layout, "tension", [[1, 0, 0]], out), {
    low: -10,
    high: 30,
    tensions: [[30]],
  });
  assert.deepEqual([...out], [1.5, 1.5, 2.5, -10, 4.5, 4.5, 5.5, 10, 7.5, 7.5, 8.5, 30]);
  gather(read, layout, "strain", [[0, 0, 0]], out);
  assert.ok(Math.abs(out[11] - 30 / 50) < 1e-6);
  const strong = structuredClone(layout);
  for (const rope of strong.variants[0].ropes) rope.breaking_load = 120;
  assert.deepEqual(gather(read, strong, "utilisation", [[0, 0, 0]], out), {
    low: 0, // colours mean the same at every moment: from nothing to the breaking load
    high: 1,
    tensions: [[30]],
  });
  assert.equal(out[11], 0.25);
  for (const rope of strong.variants[0].ropes) rope.breaking_load = 20;
  assert.equal(gather(read, strong, "utilisation", [[0, 0, 0]], out).high, 1.5); // it has parted
  gather(read, layout, "utilisation", [[0, 0, 0]], out);
  assert.equal(out[11], 0); // nothing is known
  assert.equal(gather(read, layout, "speed", [[0, 0, 0]], out).high, 8);
  assert.ok(Math.abs(out[7] - 4) < 1e-3);
  assert.equal(out[11], 8);
});

test("rigid links have no strain, and no end of a range is without end", () => {
  const rigid = structuredClone(layout);
  for (const rope of rigid.variants[0].ropes) rope.EA = null;
  const out = new Float32Array(12);
  const { low, high } = gather(readFrame(frame(), rigid), rigid, "strain", [[0, 0, 0]], out);
  assert.deepEqual([low + 0, high + 0, out[11] + 0], [0, 0, 0]);
});
