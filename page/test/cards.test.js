import assert from "node:assert/strict";
import { test } from "node:test";

import { stripsBeside } from "../src/view/cards.js";

test("the row of tools is kept free where tools lie in a row: in a low scene, and on a phone", () => {
  assert.deepEqual(stripsBeside(null, { width: 390, height: 640 }), { top: 60, bottom: 0 });
  assert.deepEqual(stripsBeside(null, { width: 844, height: 300 }), { top: 60, bottom: 0 });
  assert.deepEqual(stripsBeside(null, { width: 968, height: 660 }), { top: 0, bottom: 0 });
});
