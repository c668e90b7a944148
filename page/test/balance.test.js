import assert from "node:assert/strict";
import { test } from "node:test";

import { Balance, balanceText } from "../src/panels/balance.js";

/** @param {Record<string, number>} energies */
const of = (energies) => (name) => energies[name] ?? 0;

test("an energy error is a share of what has changed most, from the session's begin on", () => {
  const balance = new Balance();
  balance.take(0, of({ elastic: 50 }));
  assert.equal(balance.share, 0);
  balance.take(1, of({ elastic: 51, kinetic: 2, gravity: -4, energy_error: -0.4 }));
  assert.equal(balance.share, 0.1); // of 4 J of gravity, not of the 50 J that it was stretched with
  balance.take(2, of({ elastic: 51, gravity: -8, energy_error: 0.1 }));
  assert.equal(balance.share, 0.05); // the largest error stays
});

test("what rounding leaves where nothing moves is no error, nor is a step that broke one", () => {
  const balance = new Balance();
  balance.take(0, of({ elastic: 1 }));
  balance.take(1, of({ elastic: 1 + 1e-9, energy_error: 6e-7 }));
  assert.equal(balance.share, 0);
  balance.take(2, of({ elastic: 1, energy_error: Infinity, kinetic: NaN }));
  assert.equal(balance.share, 0);
});

test("after a reset it begins anew", () => {
  const balance = new Balance();
  balance.take(1, of({ kinetic: 1, energy_error: 0.5 }));
  assert.equal(balance.share, 0.5);
  balance.take(0, of({}));
  assert.equal(balance.share, 0);
});

test("it says by how much, and of which copy", () => {
  assert.equal(balanceText(0.097, ""), "energy off by up to 9.7 %");
  assert.equal(balanceText(0.097, "EA = 1e4"), "energy of EA = 1e4 off by up to 9.7 %");
});

test("a shorter step is judged by what it does itself", () => {
  const balance = new Balance();
  balance.take(1, of({ kinetic: 2, energy_error: 0.5 }));
  balance.again();
  balance.take(2, of({ kinetic: 2, energy_error: 0.51 }));
  assert.ok(Math.abs(balance.share - 0.005) < 1e-12);
});
