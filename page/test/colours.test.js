import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import {
  SHADES,
  css,
  fromHex,
  linear,
  oklab,
  poolOf,
  rimOf,
  uniformMap,
  unshown,
} from "../src/view/colours.js";

const SHEET = readFileSync(new URL("../src/style/colours.css", import.meta.url), "utf8");
/** The style sheet's colours of a theme. @param {boolean} dark @param {string} name */
function sheet(dark, name) {
  const part = SHEET.split(':root[data-theme="dark"]')[Number(dark)];
  return fromHex(
    /** @type {RegExpExecArray} */ (new RegExp(`--${name}: (#\\w{6});`).exec(part))[1],
  );
}

// What eyes without one kind of cone see, for linear colours: Machado, Oliveira and Fernandes (2009), severity 1.
const EYES = {
  all: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

/** @param {number[][]} eye @param {number[]} colour linear */
const seen = (eye, colour) =>
  eye.map((row) =>
    Math.min(
      1,
      Math.max(
        0,
        row.reduce((sum, f, k) => sum + f * colour[k], 0),
      ),
    ),
  );

/** Contrast of two linear colours, WCAG 2. @param {number[]} one @param {number[]} other */
function contrast(one, other) {
  const [a, b] = [one, other].map(([r, g, b_]) => 0.2126 * r + 0.7152 * g + 0.0722 * b_ + 0.05);
  return Math.max(a, b) / Math.min(a, b);
}

for (const dark of [true, false]) {
  const theme = dark ? "dark" : "light";
  const shades = uniformMap(dark).map((colour) => colour.map(unshown));
  const labs = shades.map((colour) => oklab(colour));

  test(`${theme}: neighbouring shades are equally far apart for the eye`, () => {
    const steps = labs
      .slice(1)
      .map((q, i) => Math.hypot(...q.map((value, k) => value - labs[i][k])));
    const mean = steps.reduce((a, b) => a + b) / steps.length;
    assert.equal(labs.length, SHADES);
    for (const step of steps) assert.ok(Math.abs(step / mean - 1) < 0.1, `${step} against ${mean}`);
  });

  test(`${theme}: the map gets lighter all the way, for every kind of eye`, () => {
    for (const [name, eye] of Object.entries(EYES)) {
      const there = shades.map((colour) => oklab(seen(eye, colour)));
      for (let i = 1; i < there.length; i++)
        assert.ok(there[i][0] > there[i - 1][0], `${name} ${i}`);
      assert.ok(there[SHADES - 1][0] - there[0][0] > 0.3, name);
      for (let i = 0; i + 25 < SHADES; i += 5) {
        const step = Math.hypot(...there[i + 25].map((value, k) => value - there[i][k]));
        assert.ok(step > 0.029, `${name}: a tenth of the map from ${i} is ${step}`);
      }
    }
  });

  test(`${theme}: the rope, or its rim, has a contrast of 3 with floor and sky`, () => {
    const rim = rimOf(dark);
    for (const place of ["scene-ground", "scene-horizon", "scene-background"]) {
      const light = place === "scene-ground" ? poolOf(dark) : 0; // the floor's middle
      const behind = sheet(dark, place).map((value) => unshown(value + light));
      const least = Math.min(
        ...shades.map((colour) =>
          contrast(
            colour.map((value) => rim * value),
            behind,
          ),
        ),
      );
      assert.ok(least >= 3, `${place}: ${least}`);
    }
  });

  test(`${theme}: labels, their units and their arrows can be read`, () => {
    const card = sheet(dark, "card").map(unshown);
    for (const name of ["ink", "faint"])
      assert.ok(contrast(sheet(dark, name).map(unshown), card) >= 4.5, name);
    for (const name of ["scene-ground", "scene-horizon", "scene-background"]) {
      const found = contrast(
        sheet(dark, "scene-arrow").map(unshown),
        sheet(dark, name).map(unshown),
      );
      assert.ok(found >= 4.5, `${name}: ${found}`);
    }
  });

  test(`${theme}: no shade had to be cut off to be shown`, () => {
    for (const lab of labs) {
      // What is cut off does not come back: a shade that survives the way there and back was whole.
      for (const value of linear(lab)) assert.ok(value > -1e-6 && value < 1 + 1e-6);
    }
    for (const colour of uniformMap(dark))
      assert.ok(
        colour.every((c) => c > 0 && c < 1),
        `${colour}`,
      );
  });
}

test("OKLab and back", () => {
  const [l, a, b] = oklab([1, 1, 1]);
  assert.ok(Math.abs(l - 1) < 1e-6 && Math.abs(a) < 1e-6 && Math.abs(b) < 1e-6);
  linear(oklab([0.2, 0.5, 0.7])).forEach((value, i) => {
    assert.ok(Math.abs(value - [0.2, 0.5, 0.7][i]) < 1e-6);
  });
});

test("colours in style sheets", () => {
  assert.deepEqual(
    fromHex("#ff8000").map((c) => Math.round(255 * c)),
    [255, 128, 0],
  );
  assert.equal(css([1, 0.5, 0]), "rgb(255, 128, 0)");
  assert.equal(css([1, 0.5, 0], 0.5), "rgba(255, 128, 0, 0.5)");
});
