import assert from "node:assert/strict";
import { test } from "node:test";

import { holdsYet } from "../src/source/recording.js";

test("an anchor holds until it lets go, and for ever where it never does", () => {
  assert.deepEqual(
    [0, 0.99, 1, 2].map((time) => holdsYet(1, time)),
    [true, true, false, false],
  );
  assert.ok(holdsYet(null, 5) && holdsYet(undefined, 5));
});
