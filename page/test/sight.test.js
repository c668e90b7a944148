import assert from "node:assert/strict";
import { test } from "node:test";

import { Camera } from "../src/view/camera.js";
import { inSight } from "../src/view/sight.js";
import { hides, solidsOf } from "../src/view/solids.js";

const POST = {
  name: "post", kind: "cylinder", center: [0, 0, 0], axis: [0, 0, 1], size: [0.1, 1, 0, 0], friction: 0.3, spin: null,
}; // prettier-ignore
const POSE = { target: [0, 0, 0], distance: 3, azimuth: -1, elevation: 0.2 };

/** A camera, the post, and a place straight behind it as the pose sees it. */
function behind() {
  const camera = new Camera();
  camera.resize(800, 600);
  const [solid] = solidsOf([POST], [[0, 0, 0]]);
  const { eye } = camera.at(POSE);
  const far = Math.hypot(eye[0], eye[1]);
  return { camera, solid, place: [(-0.4 * eye[0]) / far, (-0.4 * eye[1]) / far, 0], eye };
}

test("an end that a post hides is looked at from beside it", () => {
  const { camera, solid, place, eye } = behind();
  assert.ok(hides(solid, eye, place, 0)); // the twin: from where it was
  const azimuth = inSight(camera, POSE, [place], [solid]);
  assert.ok(Math.abs(azimuth - POSE.azimuth) <= 0.5);
  assert.ok(!hides(solid, camera.at({ ...POSE, azimuth }).eye, place, 0));
});

test("what is in sight is looked at as ever, and so is what a post hides from everywhere", () => {
  const { camera, solid, eye } = behind();
  assert.equal(inSight(camera, POSE, [eye.map((part) => 0.4 * part)], [solid]), POSE.azimuth);
  assert.equal(inSight(camera, POSE, [[0, 0, 0]], [solid]), POSE.azimuth);
});
