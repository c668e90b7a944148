import assert from "node:assert/strict";
import { test } from "node:test";

import { Range, figures, marks, quantity, round } from "../src/view/range.js";
import { fieldText, placeOf, noNumber, readNumber, valueAt } from "../src/panels/scale.js";
import { History } from "../src/graphs/history.js";
import { distance } from "../src/input/pick.js";
import { speedText } from "../src/panels/controls.js";

test("quantities for people", () => {
  assert.equal(quantity(12345, "N"), "12.3 kN");
  assert.equal(quantity(0.0021, "s"), "2.1 ms");
  assert.equal(quantity(2560, "N/m"), "2560 N/m");
  assert.equal(quantity(-0.02, "m"), "−20 mm");
  assert.equal(quantity(12345, "m"), "12345 m");
  assert.equal(quantity(9.81, "m/s^2"), "9.81 m/s²");
  assert.equal(quantity(null, "N"), "–");
  assert.equal(quantity(0, "J"), "0 J");
  assert.equal(quantity(1e-30, "N"), "0 N"); // of a rope that is slack everywhere
  assert.equal(quantity(3e-13, "J"), "3e−13 J");
  assert.equal(figures(0.098765), "0.0988");
  assert.equal(figures(1.5e-20), "1.5e−20");
  assert.equal(figures(-1.3e-4), "−1.3e−4");
  assert.equal(speedText(0.01), "1/100×");
  assert.equal(speedText(4), "4×");
});

test("an axis has one unit, and numbers that are what they mark", () => {
  assert.deepEqual(marks([-10000, -5000, 0], "J"), ["−10 kJ", "−5 kJ", "0 kJ"]); // not −5000 J
  assert.deepEqual(marks([-1e-9, -5e-10, 0, 5e-10], "m"), ["−1 nm", "−0.5 nm", "0 nm", "0.5 nm"]);
  assert.deepEqual(marks([12300, 12350, 12400], "N"), ["12.3 kN", "12.35 kN", "12.4 kN"]);
  assert.deepEqual(marks([1490, 1500, 1510], "N"), ["1490 N", "1500 N", "1510 N"]);
  assert.deepEqual(marks([100, 100.5, 101], "s", true), ["100 s", "100.5 s", "101 s"]); // not 101 twice
  assert.deepEqual(marks([0, 0.02, 0.04], "s", true), ["0 s", "0.02 s", "0.04 s"]);
  assert.deepEqual(marks([12000, 12500], "m"), ["12000 m", "12500 m"]);
  assert.deepEqual(marks([0, 0.1, 0.2, 0.1 + 0.2], "m"), ["0 m", "0.1 m", "0.2 m", "0.3 m"]);
  assert.deepEqual(marks([0, 2e-30], "J"), ["0 J", "0 J"]);
  assert.deepEqual(marks([0, 0.25, 0.5], "1"), ["0", "0.25", "0.5"]);
  assert.deepEqual(marks([], "N"), []);
});

test("round numbers for the grid", () => {
  for (const [size, wanted] of [
    [0.9, 1],
    [1.6, 2],
    [34, 20],
    [36, 50],
    [76, 100],
  ]) {
    assert.equal(round(size), wanted);
  }
});

test("a slider goes there and back, evenly or by powers of ten", () => {
  const log = { low: 10, high: 1e5, scale: "log", whole: false };
  assert.equal(valueAt(log, 0.5), 1000);
  assert.ok(Math.abs(placeOf(log, 1000) - 0.5) < 1e-12);
  assert.equal(placeOf(log, 1), 0);
  assert.equal(placeOf(log, 1e9), 1);
  const linear = { low: -5, high: 5, scale: "linear", whole: true };
  assert.equal(valueAt(linear, 0.71), 2);
  assert.equal(placeOf(linear, 0), 0.5);
});

test("numbers as people type them", () => {
  assert.equal(readNumber(" 1,5 "), 1.5);
  assert.equal(readNumber("−2e3"), -2000);
  assert.ok(Number.isNaN(readNumber("")));
  assert.ok(Number.isNaN(readNumber("two")));
  assert.ok(Number.isNaN(readNumber("1,000"))); // a thousand, or one?
  assert.ok(Number.isNaN(readNumber("0x10")));
});

test("what is wrong with what is no number", () => {
  const right = ["", " ", "0.3", ".3", "3.", "0,125", "-2e-3", "−2E3", "+1", "12,5"];
  assert.deepEqual(
    right.map((text) => noNumber(text)),
    right.map(() => ""),
  );
  assert.equal(noNumber("abc"), "abc: is no number");
  for (const text of ["nan", "inf", "-Infinity", "∞", "1e999"])
    assert.equal(noNumber(text), `${text}: must be a finite number`);
  assert.equal(noNumber(" 30 % "), "30 %: write 0.3");
  assert.equal(noNumber("0.3 N", "N/m"), "0.3 N: write the number alone, in N/m");
  assert.equal(noNumber("0.3 N"), "0.3 N: write the number alone");
  assert.equal(noNumber("1,250", "N"), "1,250: a comma is a decimal point here; write 1250");
  assert.equal(noNumber("1,250.5"), "1,250.5: a comma is a decimal point here; write 1250.5");
});

test("numbers that fit into their field", () => {
  assert.equal(fieldText(10000), "10000");
  assert.equal(fieldText(1 / 540), "0.00185185");
  assert.equal(fieldText(0.000123456), "0.000123456");
  assert.equal(fieldText(0.0000123456), "1.23456e-5");
  assert.equal(fieldText(123456789e6), "1.23457e+14");
  assert.equal(fieldText(-9.80665, 9), "-9.80665");
  assert.equal(fieldText(-1.2345678e-17, 9), "-1.235e-17");
});

test("the range of colours grows at once and shrinks slowly", () => {
  const range = new Range();
  range.follow(0, 10, 0);
  range.follow(0, 100, 0.016);
  assert.equal(range.high, 100);
  range.follow(0, 10, 0.016);
  assert.ok(range.high > 99);
  range.follow(0, 10, 60);
  assert.ok(range.high < 11);
  range.follow(NaN, NaN, 1);
  assert.ok(Number.isFinite(range.high));
});

test("a range knows that there is more than its ends have colours for", () => {
  const range = new Range();
  range.follow(-140, 150, 0);
  assert.deepEqual(range.beyond(-140, 150), [false, false]);
  assert.deepEqual(range.beyond(-3, 700), [false, true]);
  assert.deepEqual(range.beyond(-150, 20), [true, false]);
  const pushed = new Range();
  pushed.follow(-1, 150, 0);
  assert.deepEqual([pushed.low, ...pushed.beyond(-1, 150)], [0, false, false]); // left out there, too
});

test("a jolt at the start leaves the range, what comes again stays", () => {
  const jolt = new Range();
  jolt.follow(-660, 30, 0);
  for (let t = 0; t < 6; t += 0.05) jolt.follow(0, 30, 0.05);
  assert.ok(jolt.low > -1, `${jolt.low}`);
  const swing = new Range();
  let least = Infinity;
  for (let t = 0; t < 20; t += 0.05) {
    swing.follow(0, 50 + 50 * Math.sin(4 * t), 0.05);
    if (t > 2) least = Math.min(least, swing.high);
  }
  assert.ok(least > 60, `${least}`);
});

test("the history keeps the newest samples, in order, in constant memory", () => {
  const history = new History();
  for (let k = 0; k < 40_000; k++) history.add(k / 60, [["kinetic", k]]);
  assert.equal(history.count, 7200);
  assert.equal(history.last, 39_999 / 60);
  const [times, values] = history.between(history.last - 1, history.last, ["kinetic"]);
  assert.ok(times.length >= 60 && times.length <= 62);
  for (let i = 0; i < times.length; i++) assert.ok(Math.abs(values[i] - 60 * times[i]) < 1e-6);
  history.add(0, [["kinetic", 5]]); // a reset
  assert.equal(history.count, 1);
});

test("a name that comes later is empty before", () => {
  const history = new History();
  history.add(0, [["a", 1]]);
  history.add(1, [
    ["a", 2],
    ["b", 3],
  ]);
  const [, a, b] = history.between(0, 1, ["a", "b"]);
  assert.deepEqual([...a], [1, 2]);
  assert.deepEqual([...b], [NaN, 3]);
});

test("how far a point is from a segment", () => {
  assert.deepEqual(distance(5, 3, 0, 0, 10, 0), [3, 0.5]);
  assert.deepEqual(distance(-4, 3, 0, 0, 10, 0), [5, 0]);
  assert.deepEqual(distance(3, 4, 0, 0, 0, 0), [5, 0]);
});
