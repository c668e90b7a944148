import assert from "node:assert/strict";
import { test } from "node:test";

import { balanceText, shareOf } from "../src/panels/balance.js";

test("an energy error is a share of what the server says has changed most", () => {
  assert.equal(shareOf(0.4, 4), 0.1);
  assert.equal(shareOf(0, 4), 0); // rounding
  assert.equal(shareOf(0.4, 0), 0);
  assert.equal(shareOf(NaN, 4), 0); // a server that does not say it
});

test("it says by how much, and of which copy", () => {
  assert.equal(balanceText(0.097, ""), "energy off by up to 9.7 %");
  assert.equal(balanceText(0.097, "EA = 1e4"), "energy of EA = 1e4 off by up to 9.7 %");
});
