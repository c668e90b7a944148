import assert from "node:assert/strict";
import { test } from "node:test";

import { meets, solidsOf } from "../src/view/solids.js";
import { struck, surfaceOf } from "../src/view/surface.js";

const CORNERS = [2, 0, 0, -2, 1, 0, -2, -1, 0, 0, 0, 3];
const FACES = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];

test("a surface lies about its middle, its normals point outwards", () => {
  const found = surfaceOf(CORNERS, FACES);
  assert.deepEqual(found?.middle, [0, 0, 1.5]);
  assert.deepEqual(found?.half, [2, 1, 1.5]);
  const normals = found?.normals ?? new Float32Array();
  assert.equal(normals.length, 36);
  for (let k = 0; k < 3; k++) assert.equal(normals[3 * k + 2], -1);
  for (let k = 0; k < 12; k++) {
    const size = Math.hypot(...normals.slice(3 * k, 3 * k + 3));
    assert.ok(Math.abs(size - 1) < 1e-6);
  }
});

test("faces that name no vertex make no surface", () => {
  assert.equal(surfaceOf(CORNERS, [0, 1, 4]), null);
  assert.equal(surfaceOf(CORNERS, []), null);
});

test("a mesh and distances are bodies as large as the box around them", () => {
  for (const kind of ["mesh", "sdf"]) {
    const one = {
      ...{ name: "a", kind, center: [1, 0, 0], axis: [0, 0, 1], size: [0.1], friction: 0.3 },
      ...{ spin: null, vertices: CORNERS, faces: FACES },
    };
    const [solid] = solidsOf([one], [[0, 0, 10]]);
    assert.equal(solid.kind, "mesh");
    assert.deepEqual(solid.center, [1, 0, 11.5]);
    assert.equal(solid.reach, Math.hypot(2, 1, 1.5));
    assert.deepEqual(solidsOf([{ ...one, faces: undefined }], [[0, 0, 0]]), []);
  }
});

test("a way meets the first of the triangles, or goes past them inside the box around them", () => {
  const surface = /** @type {import("../src/view/surface.js").Surface} */ (
    surfaceOf(CORNERS, FACES)
  );
  const from = (/** @type {number[]} */ ...place) => place.map((one, k) => one - surface.middle[k]);
  assert.ok(Math.abs(struck(surface, from(0.5, 0, -5), [0, 0, 1]) - 5) < 1e-12); // its floor
  assert.ok(Math.abs(struck(surface, from(1, 0, 9), [0, 0, -1]) - 7.5) < 1e-6); // the slope above it
  assert.equal(struck(surface, from(1.9, 0.9, -5), [0, 0, 1]), Infinity); // in the box only
  assert.equal(struck(surface, from(0.5, 0, -5), [0, 0, -1]), Infinity); // behind
  const one = { name: "a", kind: "mesh", center: [0, 0, 0], axis: [0, 0, 1], size: [0.1] };
  const [solid] = solidsOf(
    [{ ...one, friction: 0, spin: null, vertices: CORNERS, faces: FACES }],
    [[0, 0, 0]],
  );
  assert.ok(Math.abs((meets(solid, [0.5, 0, -5], [0, 0, 1]) ?? NaN) - 5) < 1e-12);
  assert.equal(meets(solid, [1.9, 0.9, -5], [0, 0, 1]), null);
});
