import assert from "node:assert/strict";
import { test } from "node:test";

import { Camera } from "../src/view/camera.js";
import { dot, length, minus } from "../src/view/vector.js";

const near = (a, b, tolerance = 1e-9) =>
  assert.ok(Math.abs(a - b) <= tolerance * Math.max(1, Math.abs(b)), `${a} is not ${b}`);

function camera(up = [0, 0, 1]) {
  const made = new Camera();
  made.setUp(up);
  made.resize(800, 600);
  made.set({ target: [1, 2, 3], distance: 7, azimuth: 0.4, elevation: 0.3 });
  return made;
}

test("the target is in the middle, at its distance", () => {
  const [x, y, depth] = camera().project(1, 2, 3);
  near(x, 400, 1e-6);
  near(y, 300, 1e-6);
  near(depth, 7, 1e-6);
});

test("the three axes of the camera are at right angles and of length one", () => {
  const { right, top, toward } = camera([0.3, -0.5, 0.8]);
  for (const axis of [right, top, toward]) near(length(axis), 1);
  for (const [a, b] of [
    [right, top],
    [top, toward],
    [toward, right],
  ])
    near(dot(a, b), 0);
});

test("up points up on the screen, whatever up is", () => {
  for (const up of [
    [0, 0, 1],
    [0, 1, 0],
    [0, -1, 0],
    [1, 0, 0],
    [0.2, 0.9, -0.4],
  ]) {
    const made = camera(up);
    const [x0, y0] = made.project(1, 2, 3);
    const [x1, y1] = made.project(1 + made.up[0], 2 + made.up[1], 3 + made.up[2]);
    near(x1, x0, 1e-6);
    assert.ok(y1 < y0 - 10, `up ${up} goes from ${y0} to ${y1}`);
  }
});

test("the matrices that WebGL takes agree with project", () => {
  const made = camera([0, 1, 0]);
  const point = [1.7, 2.6, 3.9, 1];
  const times = (matrix, p) =>
    [0, 1, 2, 3].map((row) => [0, 1, 2, 3].reduce((sum, k) => sum + matrix[4 * k + row] * p[k], 0));
  const clip = times(made.projection, times(made.view, point));
  const [x, y] = made.project(1.7, 2.6, 3.9);
  near(400 * (1 + clip[0] / clip[3]), x, 1e-5);
  near(300 * (1 - clip[1] / clip[3]), y, 1e-5);
});

test("a dragged point stays under the pointer and in its plane", () => {
  const made = camera();
  const start = [1.5, 1.5, 3.5];
  const moved = made.inPlane(250, 420, start);
  const [x, y, depth] = made.project(...moved);
  near(x, 250, 1e-5);
  near(y, 420, 1e-5);
  near(depth, made.project(...start)[2], 1e-5);
});

test("zooming keeps the point under the pointer", () => {
  const made = camera();
  const point = made.inPlane(600, 150, made.pose.target);
  made.zoom(0.5, 600, 150);
  const [x, y] = made.project(...point);
  near(x, 600, 1e-4);
  near(y, 150, 1e-4);
  near(made.pose.distance, 3.5);
});

test("panning moves the target's plane with the hand", () => {
  const made = camera();
  made.pan(30, -20);
  const [x, y] = made.project(1, 2, 3);
  near(x, 430, 1e-5);
  near(y, 280, 1e-5);
});

test("a fitted box is seen whole and fills most of the picture", () => {
  const made = camera();
  const box = { low: [-3, 0, -1], high: [5, 1, 2] };
  made.set(made.fitted(box));
  let [widest, highest] = [0, 0];
  for (let corner = 0; corner < 8; corner++) {
    const point = [0, 1, 2].map((i) => ((corner >> i) & 1 ? box.high[i] : box.low[i]));
    const [x, y, depth] = made.project(...point);
    assert.ok(depth > 0 && x > 0 && x < 800 && y > 0 && y < 600, `${point} is at ${x}, ${y}`);
    widest = Math.max(widest, Math.abs(x - 400) / 400);
    highest = Math.max(highest, Math.abs(y - 300) / 300);
  }
  assert.ok(Math.max(widest, highest) > 0.6);
});

test("a fitted box keeps clear of strips at the top and the bottom", () => {
  const made = camera();
  const box = { low: [-1, 0, -4], high: [1, 1, 4] };
  for (const strips of [
    { top: 150, bottom: 0 },
    { top: 0, bottom: 200 },
    { top: 60, bottom: 150 },
  ]) {
    made.set(made.fitted(box, { elevation: 0.1 }, strips));
    for (let corner = 0; corner < 8; corner++) {
      const point = [0, 1, 2].map((i) => ((corner >> i) & 1 ? box.high[i] : box.low[i]));
      const [, y] = made.project(...point);
      assert.ok(y > strips.top && y < 600 - strips.bottom, `${point} is at ${y}`);
    }
  }
});

test("views along an axis have that axis towards the viewer", () => {
  for (const up of [
    [0, 0, 1],
    [0, 1, 0],
  ]) {
    const made = camera(up);
    for (const axis of [0, 1, 2]) {
      made.set(made.along(axis, -1));
      near(made.toward[axis], -1, 1e-6);
    }
  }
});

test("orbiting keeps the distance and the target", () => {
  const made = camera();
  made.orbit(123, -45);
  near(length(minus(made.eye, [1, 2, 3])), 7, 1e-9);
});
