import assert from "node:assert/strict";
import { test } from "node:test";

import { theoryOf, whyInShort, whyItBroke } from "../src/view/why.js";

const ONE = { stable: false, bound: 0.002, meter: 5.31, meter_limit: 4, meter_name: "a + 2b" };
const cause = (changes = {}) => /** @type {any} */ ({ ...ONE, ...changes });

test("a break is told without the theory's letters, differently for a long step and a hard pull", () => {
  const words = [{}, { stable: true }, { bound: null }, { rubs: true }].map((one) =>
    whyItBroke(cause(one)),
  );
  assert.equal(new Set(words).size, 4);
  for (const text of words) assert.ok(!/[=²]|a \+|bound|zigzag/.test(text), text);
  assert.match(words[0], /too long/);
  assert.match(words[1], /too far/);
  assert.match(words[3], /friction/); // where that breaks it, stiffness is not blamed
  assert.doesNotMatch(words[3], /stiff|spring/);
  assert.doesNotMatch(whyItBroke(null), /step|hand/); // nothing is said that is not known
});

test("softer springs are not advised where none are soft enough", () => {
  const words = whyItBroke(cause({ spring_factor: 0 })); // the meter: "largest EA 0 N"
  assert.doesNotMatch(words, /shorter step, softer springs/);
  assert.match(words, /less damping, softer contacts/);
  assert.match(whyItBroke(cause({ spring_factor: 0.4 })), /softer springs or more mass/);
});

test("in short it says the same of each, within a phone's line", () => {
  for (const one of [{}, { stable: true }, { bound: null }, { rubs: true }, { spring_factor: 0 }]) {
    const [short, long] = [whyInShort(cause(one)), whyItBroke(cause(one))];
    assert.ok(short.length < 56, short);
    const told = /too long|too far|pulled or threw/;
    assert.match(short, told);
  }
  assert.doesNotMatch(whyInShort(null), /step|hand/);
});

test("the theory is there for those who ask, where there is one", () => {
  assert.equal(theoryOf(cause()), "The meter: a + 2b = 5.31, at most 4.");
  assert.equal(theoryOf(cause({ meter: null })), "");
  assert.equal(theoryOf(null), "");
});
