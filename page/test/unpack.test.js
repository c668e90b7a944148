import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { fromBase64, inflate, rowOf, unpack } from "../src/source/unpack.js";

// Packed in Python; tests/live/test_packing.py checks that it still packs so.
const packed = JSON.parse(readFileSync(new URL("packed.json", import.meta.url), "utf8"));

test("what Python has packed is unpacked to within half a step", async () => {
  for (const { header, data, values } of packed.streams) {
    const numbers = unpack(header, packed.rows, await inflate(fromBase64(data)));
    for (let row = 0; row < packed.rows; row++) {
      const found = rowOf(numbers, row, new Float64Array(header.columns));
      found.forEach((value, column) => {
        const away = Math.abs(value - values[row][column]);
        assert.ok(away <= 0.5001 * header.step[column] + 1e-9, `${header.name} ${row} ${column}`);
      });
    }
  }
});

test("data of the wrong length is refused", () => {
  const [{ header }] = packed.streams;
  assert.throws(() => unpack(header, packed.rows, new Uint8Array(5)), /damaged/);
});
