import assert from "node:assert/strict";
import { test } from "node:test";

import { Camera } from "../src/view/camera.js";
import { GONE, boxOf, firstAngles, flatAxis, lies, tame } from "../src/view/room.js";

const VIEW = { center: [0, 0, 0], radius: 2 };
const finite = (values) => [...values].every(Number.isFinite);

test("nodes that are nowhere go to their neighbours, and the box is that of the others", () => {
  const places = [NaN, 0, 0, 1, 1, 2, 3, 5, 2, 3, 4, 6, Infinity, 0, 0, NaN, 1e30, 2, 3, 7];
  const nodes = new Float32Array(places);
  tame(nodes, 5, VIEW);
  const gone = Math.fround(GONE);
  assert.deepEqual(
    [...nodes],
    [1, 2, 3, gone, 1, 2, 3, 5, 2, 3, 4, 6, 2, 3, 4, gone, 2, 3, 4, gone],
  );
  assert.deepEqual(boxOf(nodes, 5), { low: [1, 2, 3], high: [2, 3, 4] });
});

test("without any good node all go to the middle", () => {
  const nodes = new Float32Array([NaN, NaN, NaN, NaN, -1e20, 0, 0, 1]);
  tame(nodes, 2, VIEW);
  const gone = Math.fround(GONE);
  assert.deepEqual([...nodes], [0, 0, 0, gone, 0, 0, 0, gone]);
});

test("good nodes are left as they are", () => {
  const nodes = new Float32Array([1, 2, 3, 4, -5, 6, -7, 8]);
  tame(nodes, 2, VIEW);
  assert.deepEqual([...nodes], [1, 2, 3, 4, -5, 6, -7, 8]);
});

test("a camera takes no pose that is not finite, and goes on from the one it has", () => {
  const camera = new Camera();
  camera.resize(800, 600);
  camera.set({ target: [1, 2, 3], distance: 4 });
  camera.set({ target: [NaN, 0, 0] });
  camera.set({ distance: Infinity });
  camera.set(camera.fitted({ low: [Infinity, 0, 0], high: [-Infinity, 1, 1] }));
  assert.deepEqual(camera.pose.target, [1, 2, 3]);
  assert.equal(camera.pose.distance, 4);
  assert.ok(finite(camera.view) && finite(camera.projection));
});

test("a net that can sag is looked at from the side, a drawing on a table from above", () => {
  const camera = new Camera();
  const up = [0, 0, 1];
  const axis = flatAxis({ low: [0, 0, 1], high: [4, 4, 1] }, up, 4);
  assert.equal(axis, 2);
  assert.equal(lies(axis, up, [0, 0, -9.81]), true);
  assert.equal(lies(axis, up, [0, 0, 0]), false);
  assert.equal(lies(1, up, [0, 0, -9.81]), false); // one that hangs in a plane
  assert.ok(Math.abs(firstAngles(camera, -1, false, true).elevation - 0.62) < 1e-9);
  assert.equal(firstAngles(camera, axis).elevation, Math.PI / 2);
});
