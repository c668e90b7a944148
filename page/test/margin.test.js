// How near to breaking, in words: which rope, what each number is, and the safe side of it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { marginText, usesOf } from "../src/view/margin.js";

/** @typedef {[name: string, load: number | null, least: number | null]} Made */

/** @param {Record<string, Made[]>} copies @returns {any} */
const layoutOf = (copies) => ({
  variants: Object.entries(copies).map(([label, ropes]) => ({
    label,
    ropes: ropes.map(([name, load, least]) => ({ name, breaking_load: load, least_load: least })),
  })),
});

/** @param {Made[]} ropes @param {number[]} tensions [N] */
const told = (ropes, tensions) =>
  marginText(usesOf(layoutOf({ one: ropes }), [tensions]), ropes.length);

test("one rope whose breaking load is known needs one line", () => {
  const rope = /** @type {Made} */ (["line", 1000, null]);
  assert.equal(told([rope], [250]), "Most now: 25 %, safety factor 4");
  assert.equal(told([rope], [1500]), "Most now: 150 %: more than it bears");
  assert.equal(told([rope], [1000]), "Most now: 100 %, safety factor 1");
  assert.equal(told([rope], [-3]), "Most now: 0 %");
  assert.equal(told([rope], [0.01]), "Most now: under 0.01 %");
});

test("numbers are rounded to the safe side, and what is exact stays so", () => {
  const rope = /** @type {Made} */ (["line", 1000, null]);
  assert.equal(told([rope], [123.1]), "Most now: 12.4 %, safety factor 8.12");
  assert.equal(told([rope], [300.1]), "Most now: 30.1 %, safety factor 3.33");
  assert.equal(told([rope], [1000.1]), "Most now: 101 %: more than it bears");
  assert.equal(told([rope], [0.3 * 1000]), "Most now: 30 %, safety factor 3.33");
});

test("of a guessed breaking load each number says what it is", () => {
  const rope = /** @type {Made} */ (["line", 12000, 8000]);
  const first = "Most now: 12.5 %, safety factor 8";
  const guess = "Its breaking load is a guess; if it is only 8000 N";
  assert.equal(told([rope], [1500]), `${first}\n${guess}: 18.8 %, safety factor 5.33`);
  const most = "Most now: 75 %, safety factor 1.33";
  assert.equal(told([rope], [9000]), `${most}\n${guess}: 113 %: more than it bears`);
});

test("of several ropes the nearest is named, and its own guess alone counts for it", () => {
  /** @type {Made[]} */ const ropes = [
    ["guy", 1000, null],
    ["tail", 500, 400],
  ];
  assert.equal(told(ropes, [500, 10]), "Most now: guy, 50 %, safety factor 2"); // the tail bears next to nothing
  assert.equal(
    told(ropes, [500, 220]),
    "Most now: guy, 50 %, safety factor 2\n" +
      "tail may be nearer: its breaking load is a guess; if it is only 400 N: 55 %, safety factor 1.81",
  );
  assert.equal(
    told(ropes, [100, 300]),
    "Most now: tail, 60 %, safety factor 1.66\n" +
      "Its breaking load is a guess; if it is only 400 N: 75 %, safety factor 1.33",
  );
});

test("ropes without a breaking load are not passed over in silence", () => {
  /** @type {Made[]} */ const ropes = [
    ["line", 1000, null],
    ["sling", null, null],
  ];
  assert.equal(
    told(ropes, [250, 9000]),
    "Most now: line, 25 %, safety factor 4\n1 of 2 ropes: no breaking load known",
  );
});

test("a tension that is not known is not taken for none", () => {
  /** @type {Made[]} */ const ropes = [
    ["line", 1000, null],
    ["sling", 1000, 800],
  ];
  for (const tensions of [[NaN, 900], [900, NaN], [Infinity, 1], [900], []])
    assert.equal(told(ropes, tensions), "Most now: not known");
});

test("of copies the copy is named", () => {
  const copies = layoutOf({
    "1 kN/m": [["line", 1000, null]],
    "9 kN/m": [["line", 1000, null]],
  });
  const text = marginText(usesOf(copies, [[100], [200]]), 2);
  assert.equal(text, "Most now: 9 kN/m, line, 20 %, safety factor 5");
});
