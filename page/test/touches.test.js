import assert from "node:assert/strict";
import { test } from "node:test";

import { arrowsOf, firmestOf, leftOut, pushesOf, strongestOf } from "../src/touches.js";
import { ratioOf, takenText, wordsOf, wrapText, wrapsOf } from "../src/panels/wraps.js";
import { touchedIn, touching } from "../src/source/frame.js";

const none = new Float32Array(0);
/** Four nodes along x, in two ropes of two. */
const places = new Float32Array([0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 1, 0, 2, 0]);
const part = (/** @type {Record<string, Float32Array>} */ more) =>
  /** @type {any} */ ({
    contact: none,
    ropeContacts: none,
    wraps: none,
    frictionWork: none,
    ...more,
  });

test("a contact of two ropes pushes both, each where it is touched, the other way", () => {
  const ropeContacts = new Float32Array([0.25, 2.5, 0, 0, -8, -1, -1, -1, -1, -1]);
  const pushes = pushesOf(part({ ropeContacts }), places);
  assert.deepEqual(
    pushes.map(({ from }) => from),
    [
      [0.25, 0, 0],
      [0.5, 0, 2],
    ],
  );
  assert.deepEqual(
    pushes.map(({ force: [, , z] }) => z),
    [-8, 8],
  );
  assert.equal(firmestOf(pushes), 8);
  const [down, up] = arrowsOf(pushes, 16, 4, [0, 0, 0]);
  assert.deepEqual(vectors(down), [0.25, 0, -2]); // half as long as the longest, which is 16 N
  assert.deepEqual(vectors(up), [0.5, 0, 4]);
  assert.deepEqual(arrowsOf(pushes, 300, 4, [0, 0, 0]), []); // too small to be seen
  assert.deepEqual(arrowsOf(pushes, 0, 4, [0, 0, 0]), []);
});

const vectors = (/** @type {any} */ { to }) => [...to];

test("a contact at the last node is at that node", () => {
  const ropeContacts = new Float32Array([3, 1, 0, 0, 5]);
  const [one] = pushesOf(part({ ropeContacts }), places);
  assert.deepEqual(one.from, [1, 0, 2]);
});

test("forces of obstacles and of ropes have one scale", () => {
  const contact = new Float32Array(12).fill(0);
  contact[2] = 20;
  const ropeContacts = new Float32Array([0.5, 2.5, 0, 0, 5]);
  const pushes = pushesOf(part({ contact, ropeContacts }), places);
  assert.equal(firmestOf(pushes), 20);
  assert.equal(arrowsOf(pushes, 20, 1, [0, 0, 0]).length, 3);
});

const layout = /** @type {any} */ ({
  scalars: ["rope_contacts", "rope_contact_force", "wraps", "wrap_age"],
  obstacles: [{ name: "drum" }, { name: "floor" }],
  variants: [{ ropes: [{ name: "line" }], surfaces: ["drum", "floor", "ropes on ropes"] }],
});

test("where not all contacts of ropes have arrows, it says how many, and of which force", () => {
  const ropeContacts = new Float32Array([0, 2, 0, 0, 3, 1, 2, 0, 4, 0, -1, -1, -1, -1, -1]);
  const told = (/** @type {number[]} */ scalars) =>
    strongestOf(layout, part({ ropeContacts, scalars: new Float32Array(scalars) }));
  assert.equal(told([2, 7, 0, 0]), null);
  assert.deepEqual(told([431, 10, 0, 0]), { drawn: 2, all: 431, share: 0.7 });
  assert.equal(
    leftOut(told([431, 10, 0, 0]), 0),
    "Arrows at the 2 strongest of 431 contacts of ropes, 70 % of their force.",
  );
  assert.equal(leftOut(null, 200), "");
  assert.equal(leftOut(null, 500), "On obstacles at the strongest of every 3 nodes.");
});

const drum = new Float32Array([0, 0, 22, 58, 3 * Math.PI, 10, 120, Math.log(16.9)]);

test("a wrap is told by angle, tensions, their ratio and its share of what friction holds", () => {
  const [wrap] = wrapsOf(layout, part({ wraps: drum }));
  assert.equal(wrap.obstacle, "drum");
  assert.ok(Math.abs(ratioOf(wrap) - 12) < 1e-6);
  assert.deepEqual(wrapText(wrap, false), [
    "drum: 540°, 10 N → 120 N",
    "ratio 12, slips at 16.9 (88 %)", // of the angle: ln 12 / ln 16.9
  ]);
  assert.equal(wrapText(wrap, true)[0], "line on drum: 540°, 10 N → 120 N");
  const back = { ...wrap, before: 120, after: 10 };
  assert.equal(wrapText(back, false)[1], "ratio 12, slips at 16.9 (88 %)"); // either way
  const idle = { ...wrap, before: 100, after: 101 };
  assert.equal(wrapText(idle, false)[1], "ratio 1.01, slips at 16.9 (0.35 %)"); // was 6 %
  const full = { ...wrap, after: 10 * 16.9 };
  assert.equal(wrapText(full, false)[1], "ratio 16.9, slips at 16.9 (100 %)");
  assert.equal(wrapText({ ...wrap, before: 0 }, false)[1], "one side is slack");
  assert.equal(wrapText({ ...wrap, slip: 1 }, false)[1], "ratio 12, no friction along it");
  assert.equal(wrapText({ ...wrap, slip: 1e30 }, false)[1], "ratio 12, slips at none");
});

test("a turn that holds more than it can by itself has no share of that", () => {
  const knot = new Float32Array([0, 0, 22, 58, 12.5, 2.04, 0.013, Math.log(41.5)]);
  const words = (/** @type {number} */ place) => {
    const ropeContacts = new Float32Array([place, 300, 0, 0, 8, -1, -1, -1, -1, -1]);
    return wrapText(wrapsOf(layout, part({ wraps: knot, ropeContacts }))[0], false);
  };
  assert.deepEqual(words(40), [
    "drum: 716°, 2.04 N → 13 mN",
    "ratio 157, slips at 41.5: held by ropes on it, too", // was (380 %)
  ]);
  assert.equal(words(80)[1], "ratio 157, slips at 41.5: more than its turn holds"); // it falls, or bears its own weight
  const [wrap] = wrapsOf(
    layout,
    part({ wraps: drum, ropeContacts: new Float32Array([30, 1, 0, 0, 1]) }),
  );
  assert.equal(wrapText(wrap, false)[1], "ratio 12, slips at 16.9 without the ropes on it");
  const pushed = { ...wrap, before: 86.7, after: -0.0401 };
  assert.deepEqual(wrapText(pushed, false), [
    "drum: 540°, 86.7 N → slack",
    "held by ropes on it, too",
  ]);
  assert.equal(wrapText({ ...pushed, pressed: false }, false)[1], "one side is slack");
});

test("what friction took is told by surface, the most first; nothing where it is not known", () => {
  const took = (/** @type {number[]} */ ...work) =>
    takenText(layout, part({ frictionWork: new Float32Array(work) }));
  assert.equal(
    took(-0.25, -2, -0.5),
    "Friction took 2 J on floor, 0.5 J between ropes, 0.25 J on drum",
  );
  assert.equal(took(-0.25, 0, 0), "Friction took 0.25 J on drum");
  assert.equal(took(0, 0, 5.85e-9), "Friction has taken nothing yet"); // was −5.85 nJ between ropes
  assert.equal(took(-0.25, 0.1, 0), "Friction took 0.25 J on drum, gave 0.1 J on floor");
  assert.equal(took(0.25, 0, 0), "Friction gave 0.25 J on drum"); // it drives the rope
  assert.equal(took(0, 0, 0), "Friction has taken nothing yet");
  assert.equal(took(NaN, NaN, NaN), "");
  assert.equal(took(), "");
});

test("wraps that are not listed are counted, and old ones have their age", () => {
  const many = new Float32Array(6 * 8).fill(-1);
  for (let row = 0; row < 5; row++) many.set(drum, 8 * row);
  const words = (/** @type {number} */ all, /** @type {number} */ age) =>
    wordsOf(layout, part({ wraps: many, scalars: new Float32Array([0, 0, all, age]) }));
  const [summary, lines] = words(14, 0.1);
  assert.equal(summary, "Wraps and friction");
  assert.equal(lines.length, 5);
  assert.deepEqual(lines[4], ["and 10 more wraps"]);
  assert.deepEqual(words(14, 1)[1][5], ["as it was 1 s ago"]);
  assert.deepEqual(words(14, 0.4833)[1][5], ["as it was 0.48 s ago"]);
  assert.equal(wordsOf(layout, part({ scalars: new Float32Array(4) }))[0], "Friction");
});

test("what tells of contacts lies between anchors and grabs, as long as to the next", () => {
  const offsets = /** @type {any} */ ({
    ...{ anchors: 0, contact: 8, rope_contacts: 20, wraps: 40, friction_work: 40, grabs: 48 },
  });
  const buffer = new ArrayBuffer(80);
  const sizes = /** @type {const} */ (["contact", "rope_contacts", "wraps", "friction_work"]).map(
    (name) => touchedIn(buffer, offsets, name).length,
  );
  assert.deepEqual(sizes, [3, 5, 0, 2]);
  assert.equal(touching(offsets), true);
  const nothing = { ...offsets, contact: 48, rope_contacts: 48, wraps: 48, friction_work: 48 };
  assert.equal(touching(nothing), false);
  assert.equal(touching(/** @type {any} */ ({ anchors: 0, grabs: 48 })), false);
  assert.equal(touchedIn(buffer, /** @type {any} */ ({ grabs: 48 }), "wraps").length, 0);
});
