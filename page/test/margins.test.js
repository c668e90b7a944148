// How near to breaking, in words, and what a guessed breaking load makes of it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { marginText, moreByGuess } from "../src/panels/legend.js";

test("a known breaking load needs no more words", () => {
  const ropes = /** @type {any} */ ([
    { breaking_load: 1000, least_load: null },
    { breaking_load: null },
  ]);
  assert.equal(moreByGuess(ropes), 1);
  assert.equal(marginText(0.25, 1), "Most now: 25 %, safety factor 4");
  assert.equal(marginText(1.5), "Most now: 150 %: it would have parted");
});

test("a guessed one is said to be one, with what the least of it makes", () => {
  const ropes = /** @type {any} */ ([
    { breaking_load: 1000, least_load: 800 },
    { breaking_load: 500 },
  ]);
  assert.equal(moreByGuess(ropes), 1.25);
  const told =
    "Most now: 20 %, safety factor 5. Breaking load guessed: with the least of it 25 %, 4";
  assert.equal(marginText(0.2, 1.25), told);
});
