import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { BodyHand, BodyKeys, pickBody } from "../src/input/body.js";
import { hullOf } from "../src/render/canvas/solids.js";
import { Camera } from "../src/view/camera.js";
import {
  cornersOf,
  distanceTo,
  hides,
  leaves,
  meets,
  placed,
  solidsOf,
  turnOf,
  whereabouts,
} from "../src/view/solids.js";
import { Solids } from "../src/solids.js";
import { plus } from "../src/view/vector.js";

const known = JSON.parse(readFileSync(new URL("solids.json", import.meta.url), "utf8"));
const here = [[0, 0, 0]];
const BAR = {
  name: "bar",
  kind: "cylinder",
  center: [0, 0, 0],
  axis: [0, 1, 0],
  size: [0.1, 0.5, 0, 0],
  friction: 0.3,
  spin: null,
};

test("surfaces are where the engine has them", () => {
  const solids = solidsOf(known.obstacles, here);
  assert.equal(solids.length, known.obstacles.length);
  solids.forEach((solid, k) =>
    known.places.forEach((place, i) =>
      assert.ok(Math.abs(distanceTo(solid, place) - known.away[k][i]) < 1e-9, solid.kind),
    ),
  );
});

test("what turns and is not round lies as the engine has it", () => {
  const solids = solidsOf(known.obstacles, here).map((solid) => placed(solid, known.time));
  solids.forEach((solid, k) =>
    known.places.forEach((place, i) =>
      assert.ok(Math.abs(distanceTo(solid, place) - known.later[k][i]) < 1e-9, solid.kind),
    ),
  );
  assert.equal(solids.filter(leaves).length, 2);
});

test("triangles turn about their position, and a way meets them where they are then", () => {
  const vertices = [0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 1];
  const faces = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];
  const tent = { ...BAR, kind: "mesh", axis: [0, 0, 1], size: [0], vertices, faces };
  const [still] = solidsOf([tent], here);
  const spin = [Math.PI / 2, 0, null];
  const later = placed(solidsOf([{ ...tent, axle: [0, 0, 1], spin }], here)[0], 1);
  for (const [x, y] of [
    [0.6, 0.2],
    [0.9, 0.4],
    [0.2, 0.6],
  ]) {
    // prettier-ignore
    const there = meets(still, [x, y, 5], [0, 0, -1]);
    const far = meets(later, [-y, x, 5], [0, 0, -1]);
    assert.equal(far === null, there === null);
    if (far !== null) assert.ok(Math.abs(far - there) < 1e-9);
  }
});

test("a stroke turns triangles around their position, where they turn, not around their middle", () => {
  const vertices = [0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 1];
  const faces = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];
  const tent = {
    ...BAR,
    kind: "mesh",
    axis: [0, 0, 1],
    axle: [0, 0, 1],
    size: [0],
    vertices,
    faces,
  };
  const [solid] = solidsOf([tent], here);
  assert.ok(Math.hypot(...solid.middle) > 0.3); // the twin: elsewhere
  const camera = new Camera();
  camera.resize(900, 600);
  camera.set({ target: [0, 0, 0], distance: 20, azimuth: -Math.PI / 2, elevation: Math.PI / 2 });
  const hand = { viewport: { camera, solids: { named: () => solid } }, hit: { obstacle: "bar" } };
  const [from, to] = [0, Math.PI / 2].map((angle) => {
    const [x, y] = camera.project(Math.cos(angle), Math.sin(angle), 0);
    return { x, y };
  });
  const turned = BodyHand.prototype.turnBetween.call(hand, from, to);
  assert.ok(Math.abs(turned - Math.PI / 2) < 1e-6, `${turned}`);
});

test("a half-pipe hides nothing: its near wall is cut away", () => {
  const trough = solidsOf(known.obstacles, here).find(({ kind }) => kind === "half-pipe");
  const above = trough.size.slice(1);
  const bottom = plus(trough.center, above, -0.9 * trough.size[0]);
  for (const far of [5, -5])
    assert.ok(!hides(trough, plus(trough.center, above, far), bottom, 0.01));
});

test("a way meets a ball where it enters, and passes by what lies beside it", () => {
  const [ball] = solidsOf([{ ...BAR, kind: "sphere", size: [0.5, 0, 0, 0] }], here);
  assert.ok(Math.abs(meets(ball, [0, 0, 3], [0, 0, -1]) - 2.5) < 1e-3);
  assert.equal(meets(ball, [0.6, 0, 3], [0, 0, -1]), null);
  assert.equal(meets(ball, [0, 0, 3], [0, 0, 1]), null);
});

test("no corner of the box around a body is inside it, and its reach goes to the farthest", () => {
  for (const solid of solidsOf(known.obstacles, here)) {
    if (!Number.isFinite(solid.reach)) continue;
    for (const corner of cornersOf(solid)) assert.ok(distanceTo(solid, corner) > -1e-9);
  }
});

test("what cannot be drawn is left out, and nothing throws", () => {
  const bad = [
    { center: [NaN, 0, 0] },
    { center: [1e300, 0, 0] },
    { axis: [0, 0, 0] },
    { axis: [Infinity, 0, 0] },
    { size: [null, 0.5, 0, 0] },
    { size: [0.1, NaN, 0, 0] },
    { kind: "teapot" },
    { kind: "capsule", size: [0.1, null, 0, 0] },
  ].map((change) => ({ ...BAR, ...change }));
  assert.deepEqual(solidsOf(bad, here), []);
  const [wild] = solidsOf([{ ...BAR, spin: [1e300, 0, null] }], here);
  assert.equal(turnOf(wild, 3), 0);
  assert.equal(solidsOf(Array(5000).fill(BAR), here).length, 200);
});

test("copies at one place are one body, those apart are several", () => {
  assert.equal(solidsOf([BAR], [...here, ...here]).length, 1);
  const apart = solidsOf([BAR], [...here, [2, 0, 0]]);
  assert.deepEqual(
    apart.map(({ center }) => center[0]),
    [0, 2],
  );
});

test("a pulley has turned as far as the frame tells", () => {
  const [pulley] = solidsOf([{ ...BAR, wheel: 1 }], here);
  assert.equal(turnOf(pulley, 9, [0.5, 1.25]), 1.25);
  assert.equal(turnOf(pulley, 9, [0.5]), 0); // a frame tells of four
});

test("a cam that turns freely lies where its angle has led it, about its hub", () => {
  const [cam] = solidsOf([{ ...BAR, wheel: 1, axle: [0, 1, 0], hub: [0.05, 0, 0] }], here);
  assert.ok(leaves(cam));
  const { center, middle } = placed(cam, 2, [0, Math.PI / 2]);
  [0.05, 0, 0.05].forEach((value, k) => assert.ok(Math.abs(center[k] - value) < 1e-12));
  assert.deepEqual(
    center.map((value, k) => value - middle[k]),
    [0, 0, 0],
  );
  const [round] = solidsOf([{ ...BAR, wheel: 1 }], here);
  assert.equal(placed(round, 2, [0, Math.PI / 2]), round);
  assert.ok(!leaves(round));
});

test("a body turns from its start to its stop", () => {
  const [drum] = solidsOf([{ ...BAR, spin: [2, 1, 3] }], here);
  assert.deepEqual([0, 1, 2, 3, 9].map((time) => turnOf(drum, time)), [0, 0, 2, 4, 4]); // prettier-ignore
});

test("a bar hides what is behind it, and not what lies on its front", () => {
  const [bar] = solidsOf([BAR], here);
  const eye = [0, 0, 5];
  assert.ok(hides(bar, eye, [0, 0, -0.12], 0.01));
  assert.ok(!hides(bar, eye, [0, 0, 0.1], 0.01));
  assert.ok(!hides(bar, eye, [0.3, 0, -0.12], 0.01));
});

test("a hull goes around all places", () => {
  const hull = hullOf([[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 0]]); // prettier-ignore
  assert.equal(hull.length, 4);
});

test("bodies that move are where the engine has them, in every copy", () => {
  assert.ok(known.ways.length >= 4);
  for (const { motion, center, times, places } of known.ways) {
    times.forEach((time, k) => {
      whereabouts(motion, time).forEach((value, c) =>
        assert.ok(Math.abs(value - places[k][c]) < 1e-9, `${motion.kind} at ${time}`),
      );
      const [one] = solidsOf([{ ...BAR, center, motion }], [[0, 5, 0]]);
      const moved = placed(one, time).center;
      [0, 5, 0].forEach((shift, c) => assert.ok(Math.abs(moved[c] - places[k][c] - shift) < 1e-9));
    });
  }
  const [still] = solidsOf([BAR], here);
  assert.equal(placed(still, 3), still);
});

test("what turns by a table has its angle", () => {
  const turns = [0, 1].map((time) => [time, 2 * time, 2 - 2 * time, ...Array(10).fill(0)]);
  const [bar] = solidsOf([{ ...BAR, turns }], here);
  assert.deepEqual(
    [-1, 0.25, 1, 9].map((time) => turnOf(bar, time)),
    [0, 0.5, 2, 2],
  );
});

test("a body of a replay's later part moves by the clock of that part", () => {
  const params = [0, 0, 0, 1, 0, 0, 0, 9]; // from the middle of all, at 1 m/s
  const motion = { kind: "velocity", params, table: [] };
  const spin = [2, 0, null];
  const body = { ...BAR, kind: "sphere", size: [0.1, 0, 0, 0], axle: [0, 0, 1], spin, motion };
  const layout = { up: [0, 1, 0], scalars: [], later: 0.3, obstacles: [body] };
  const session = { on() {}, layout, frame: { time: 0.5, parts: [{}] } };
  const solids = new Solids({ session, camera: { up: [0, 1, 0] }, shifts: here });
  solids.take(layout, here);
  assert.ok(Math.abs(solids.all[0].center[0] - 0.2) < 1e-12);
  assert.ok(Math.abs(solids.turns()[0] - 0.4) < 1e-12);
});

/** A viewport over some bodies, and what is sent from it. */
function over(...obstacles) {
  const sent = [];
  const layout = { up: [0, 1, 0], scalars: [], obstacles, view: { radius: 1 } };
  const session = { on() {}, can: () => true, send: (command) => sent.push(command), status: null };
  const camera = new Camera();
  camera.setUp([0, 1, 0]);
  camera.resize(900, 600);
  camera.set({ target: [0, 0, 0], distance: 5, azimuth: 0, elevation: 0 });
  const viewport = { session: { ...session, layout, frame: null }, camera, shifts: here };
  viewport.solids = new Solids(viewport);
  viewport.solids.take(layout, here);
  return { viewport, sent };
}

test("what its weight turns is not taken: the view turns, or what is behind it is taken", () => {
  const ball = { ...BAR, kind: "sphere", size: [0.5, 0, 0, 0] };
  const { viewport } = over({ ...ball, name: "free", movable: true });
  assert.equal(pickBody(viewport, 450, 300)?.obstacle, "free");
  const heavy = over({ ...ball, name: "heavy", movable: false });
  assert.equal(pickBody(heavy.viewport, 450, 300), null);
});

test("a floor is led by keys, though it is drawn as no body", () => {
  const floor = { ...BAR, name: "floor", kind: "plane", center: [0, -1, 0], size: [0, 0, 0, 0] };
  const { viewport, sent } = over({ ...floor, movable: true, turnable: true });
  assert.deepEqual([viewport.solids.all, viewport.solids.floor], [[], -1]);
  assert.deepEqual(viewport.solids.base("floor"), [0, -1, 0]);
  assert.equal(new BodyKeys(viewport).press("floor", "ArrowUp"), true);
  assert.equal(sent[0].obstacle, "floor");
  assert.ok(sent[0].target[1] > -1);
  assert.equal(pickBody(viewport, 450, 500), null);
});
