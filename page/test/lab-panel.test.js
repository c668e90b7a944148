import assert from "node:assert/strict";
import { test } from "node:test";

import { largestStep } from "../src/lab/bounds.js";
import { Rope } from "../src/lab/kernel.js";
import { named } from "../src/lab/named.js";
import { Probe, measured } from "../src/lab/probe.js";
import { saidOf } from "../src/lab/typed.js";

/** Two springs of 1000 N/m along x between nodes of 0.1, 1 and 0.1 kg. @param {object} [more] @returns {any} */
const pair = (more = {}) => ({
  name: "pair", about: "", up: [0, 0, 1], gravity: [0, 0, -9.81], step: 1e-3, method: "verlet",
  x: [[0, 1, 2], [0, 0, 0], [0, 0, 0]], v: [[0, 0, 0], [0, 2, 0], [0, 0, 0]], mass: [0.1, 1, 0.1], length: [1, 1],
  stiffness: [1e3, 1e3], vector: [0, 0], axial: [0, 0], slack: [false, false], ropes: [[0, 2]], posts: [], lines: [],
  anchors: [0, 2].map((node) => (
    { node, origin: [node, 0, 0], velocity: [0, 0, 0], start: 0, stop: 0, release: node ? 0.5 : null })),
  ...more,
}); // prettier-ignore

test("the largest step holds after an anchor has let go, too", () => {
  const rope = new Rope(pair());
  // with the first end held: w^2 of the masses 1 and 0.1 on two springs in a row
  const highest = 6000 + Math.sqrt(6000 ** 2 - 1e7);
  const expected = 2 / Math.sqrt(highest); // 18.98 ms; with both ends held it is 44.7
  const found = largestStep(rope, "semi-implicit-euler");
  assert.ok(Math.abs(found / expected - 1) < 1e-9, String(found));
  const [first, last] = pair().anchors;
  const both = new Rope(pair({ anchors: [first, { ...last, release: null }] }));
  assert.ok(Math.abs(largestStep(both, "verlet") / (2 / Math.sqrt(2000)) - 1) < 1e-9);
});

test("an address names a scene, one with a hyphen as well, and that of just this name first", () => {
  const names = ["Bounce", "Half-slack rope", "Pendulum, long", "Pendulum"];
  assert.equal(named(names, "#half-slack"), 1);
  assert.equal(named(names, "#half%20slack-rope"), 1);
  assert.equal(named(names, "#pendulum"), 3);
  assert.equal(named(names, "#pendulum,-l"), 2);
  for (const hash of ["", "#", "#nothing"]) assert.equal(named(names, hash), 0);
});

test("a node in hand has no speed of its own", () => {
  const rope = new Rope(pair());
  const plane = [[1, 0, 0], [0, 0, 1]]; // prettier-ignore
  const lab = /** @type {any} */ ({ rope, tension: new Float64Array(3), plane: () => plane });
  assert.equal(measured(lab, 1, "speed"), 2);
  rope.hand = { node: 1, at: [1, 0, 0], to: [1, 0, 1], speed: 1 };
  assert.ok(Number.isNaN(measured(lab, 1, "speed")));
  assert.equal(measured(lab, 2, "speed"), 0);
});

test("a measured curve begins where it is chosen", () => {
  const rope = new Rope(pair());
  /** @type {number[][]} */ let kept = [];
  const strip = {
    clear: () => (kept = []),
    add: (/** @type {number} */ t, /** @type {number[]} */ [value]) => kept.push([t, value]),
  };
  const plane = [[1, 0, 0], [0, 0, 1]]; // prettier-ignore
  const lab = { rope, tension: new Float64Array(3), plane: () => plane, draw: () => {} };
  const probe = Object.assign(Object.create(Probe.prototype), {
    lab, strip, choice: { value: "sideways" }, field: {},
  }); // prettier-ignore
  for (const node of [1, 2]) {
    probe.choose(node);
    assert.deepEqual(kept, [[0, node]]);
  }
});

test("what is written and cannot be had is told in a sentence", () => {
  const said = (/** @type {number} */ typed) => saidOf("Gravity g", typed, 0, 25, 9.81, "m/s²");
  assert.equal(said(NaN), "Gravity g needs a number; it stays 9.81 m/s².");
  assert.equal(
    said(-1),
    "Gravity g: -1 m/s² is less than the least here, 0 m/s², which it is now.",
  );
  assert.equal(
    said(26),
    "Gravity g: 26 m/s² is more than the most here, 25 m/s², which it is now.",
  );
  for (const fine of [0, 1.62, 25]) assert.equal(said(fine), "");
  const third = saidOf("k", 0.333333, 1 / 3, 1, 0.5, "N/m"); // as the least of it is shown
  assert.equal(third, "");
});
