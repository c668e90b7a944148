import assert from "node:assert/strict";
import { test } from "node:test";

import { Camera } from "../src/view/camera.js";
import { Follow, lowest } from "../src/view/follow.js";

const STRIPS = { top: 0, bottom: 0 };
const ALL = [{ first: 0, nodes: 41, held: false }];
const ROOM = { center: [0, 0, 0], radius: 10 };

function camera(width = 900, height = 600) {
  const made = new Camera();
  made.resize(width, height);
  return made;
}

/** A hanging rope. @param {number} sag */
const rope = (sag, size = 10) =>
  Array.from({ length: 41 }, (_, i) => [
    (size * (i - 20)) / 20,
    0,
    sag * (((i - 20) / 20) ** 2 - 1),
  ]);
const nodesOf = (/** @type {number[][]} */ places) =>
  Float32Array.from(places.flatMap((place) => [...place, 0]));

/** How much of the room it may take a rope takes. @param {Camera} made @param {number[][]} places */
function share(made, places) {
  const seen = places.map(([x, y, z]) => made.project(x, y, z));
  const spread = (/** @type {number} */ k) =>
    Math.max(...seen.map((p) => p[k])) - Math.min(...seen.map((p) => p[k]));
  return Math.max(spread(0) / made.width / 0.72, spread(1) / made.height / 0.68);
}

test("what is framed fills the picture to its margin, from any side and in any shape", () => {
  for (const [width, height] of [
    [900, 600],
    [390, 640],
    [700, 200],
  ]) {
    for (const [azimuth, elevation] of [
      [-1.85, 0.14],
      [0.3, 0.6],
      [2, -0.4],
      [-Math.PI / 2, Math.PI / 2],
    ]) {
      const made = camera(width, height);
      const places = rope(6);
      made.set(made.framed(places, { azimuth, elevation }));
      const part = share(made, places);
      assert.ok(part > 0.93 && part < 1.001, `${part} at ${width} x ${height}, ${azimuth}`);
    }
  }
});

test("what is framed beside a card at the left is in the middle of what is left of the picture", () => {
  const made = camera(900, 600);
  const places = rope(6);
  const xs = () => places.map(([x, y, z]) => made.project(x, y, z)[0]);
  made.set(made.framed(places, { azimuth: -1.85, elevation: 0.14 }));
  assert.ok(Math.min(...xs()) < 240); // the twin
  made.set(made.framed(places, {}, { top: 0, bottom: 0, left: 240 }));
  const [low, high] = [Math.min(...xs()), Math.max(...xs())];
  assert.ok(low > 240 && high < 900);
  assert.ok(Math.abs((low + high) / 2 - 570) < 3, `${low} ${high}`);
  assert.ok((high - low) / 660 > 0.67);
});

test("the camera rests while the rope swings inside the picture", () => {
  const made = camera();
  const follow = new Follow();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  for (let i = 0; i < 200; i++) {
    const places = rope(6 + 0.8 * Math.sin(i / 7));
    follow.take(made, nodesOf(places), ALL, 1 / 60, ROOM);
    assert.equal(follow.wanted(made, STRIPS), null);
  }
});

test("it follows a rope that leaves the picture, and one that has become small, but that late", () => {
  const made = camera();
  const follow = new Follow();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  follow.take(made, nodesOf(rope(6)), ALL, 1 / 60, ROOM);
  follow.take(made, nodesOf(rope(20)), ALL, 1 / 60, ROOM);
  const pose = follow.wanted(made, STRIPS);
  assert.ok(pose && pose.distance > made.pose.distance);
  made.set(pose);
  assert.equal(follow.wanted(made, STRIPS), null);
  assert.ok(share(made, rope(20)) <= 1.001);
  let waited = 0;
  for (; waited < 20 && !follow.wanted(made, STRIPS); waited += 1 / 10)
    follow.take(made, nodesOf(rope(3, 4)), ALL, 1 / 10, ROOM);
  assert.ok(waited > 1 && waited < 10, `${waited} s`);
});

test("what flies off is not followed", () => {
  const made = camera();
  const follow = new Follow();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  const places = rope(6);
  places[7] = [0, 0, -500];
  follow.take(made, nodesOf(places), ALL, 1 / 60, ROOM);
  assert.equal(follow.wanted(made, STRIPS), null);
});

test("ropes can come as low as their length between what holds them lets them", () => {
  const up = /** @type {[number, number, number]} */ ([0, 0, 1]);
  const places = new Map([
    [0, [0, 0, 5]],
    [10, [6, 0, 5]],
    [20, [12, 0, 5]],
  ]);
  const at = (/** @type {number} */ i) =>
    /** @type {[number, number, number]} */ (places.get(i) ?? [0, 0, 0]);
  const line = { first: 0, nodes: 21, length: 20, segments: 20 };
  const held = (/** @type {number[]} */ ...list) => list.map((index) => ({ index }));
  assert.ok(Math.abs(lowest(held(0, 10, 20), line, at, up) - 1) < 1e-9); // 10 m over 6 m
  assert.equal(lowest(held(0), line, at, up), -15); // a loose end hangs down
  assert.equal(lowest(held(), line, at, up), Infinity);
});

test("it goes before what moves outwards, and not before what swings to and fro", () => {
  const made = camera();
  made.set(made.framed(rope(6), { azimuth: -Math.PI / 2, elevation: 0 }));
  const away = new Follow();
  const back = new Follow();
  for (let i = 0; i < 60; i++) {
    const shifted = (/** @type {number} */ by) =>
      nodesOf(rope(6).map(([x, y, z]) => [x + by, y, z]));
    away.take(made, shifted(i / 15), ALL, 1 / 60, ROOM); // 4 m/s
    back.take(made, shifted(2 * Math.sin(i / 3)), ALL, 1 / 60, ROOM);
  }
  const edge = 10 + 59 / 15;
  assert.ok(Math.abs(away.high[0] - edge - 2) < 0.1, `${away.high[0]}`); // half a second of 4 m/s
  assert.ok(back.high[0] < 12.01, `${back.high[0]}`);
});

test("what is held is followed far away, what nothing holds is not, and is forgotten", () => {
  const made = camera();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  const far = nodesOf(rope(6).map(([x, y, z]) => [x, y, z - 100]));
  const held = new Follow();
  held.take(made, far, [{ first: 0, nodes: 41, held: true }], 1 / 60, ROOM);
  assert.ok(held.wanted(made, STRIPS));
  const loose = new Follow();
  loose.take(made, nodesOf(rope(6)), ALL, 1 / 60, ROOM);
  for (let i = 0; i < 25; i++) loose.take(made, far, ALL, 0.1, ROOM);
  assert.equal(loose.wanted(made, STRIPS), null);
  assert.ok(!Number.isFinite(loose.low[0]));
});

/** Let a rope fly for two seconds with the camera behind it. @param {boolean} adrift */
function flown(adrift) {
  const made = camera();
  made.set(made.framed(rope(1, 1), { azimuth: -Math.PI / 2, elevation: 0 }));
  const follow = new Follow();
  const pieces = [{ first: 0, nodes: 41, held: true, adrift }];
  let drawn = nodesOf(rope(1, 1));
  let places = rope(1, 1);
  const far = { center: [0, 0, 0], radius: 100 };
  for (let i = 0; i < 120; i++) {
    places = rope(1, 1).map(([x, y, z]) => [x + i / 3, y, z - i / 6]); // 22 m/s
    follow.take(made, nodesOf(places), pieces, 1 / 60, far);
    drawn = nodesOf(places);
    const by = follow.goes(made, drawn, pieces, far);
    const pose = { ...made.pose, target: made.pose.target.map((value, k) => value + by[k]) };
    made.set(follow.keep(made, /** @type {any} */ (pose), STRIPS));
  }
  return { made, follow, places };
}

test("what nothing holds is gone along with, and stays large in the picture; what is held is not", () => {
  const { made, follow, places } = flown(true);
  const goal = follow.goal(made, STRIPS);
  assert.ok(goal && share(made.at(goal), places) > 0.4);
  const twin = flown(false);
  const wide = twin.follow.goal(twin.made, STRIPS);
  assert.ok(wide && share(twin.made.at(wide), twin.places) < 0.1);
});

test("ropes that are faster than a damped camera are kept in the picture, by as little as will do", () => {
  const made = camera();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  const follow = new Follow();
  follow.take(made, nodesOf(rope(6)), ALL, 1 / 60, ROOM);
  assert.equal(follow.keep(made, made.pose, STRIPS), made.pose); // it is in it
  for (const [by, size] of [
    [12, 10],
    [-12, 10],
    [0, 25],
  ]) {
    const places = rope(6, size).map(([x, y, z]) => [x + by, y, z + by / 2]);
    follow.take(made, nodesOf(places), ALL, 1 / 60, ROOM);
    const seen = (/** @type {Camera} */ one) =>
      places.every(([x, y, z]) => {
        const [px, py] = one.project(x, y, z);
        return px > 0 && px < 900 && py > 40 && py < 600;
      });
    const strips = { top: 40, bottom: 0 };
    assert.ok(!seen(made)); // the twin
    const kept = made.at(follow.keep(made, made.pose, strips));
    assert.ok(seen(kept), `${by} ${size}`);
    if (size === 10) assert.equal(kept.pose.distance, made.pose.distance);
  }
});

test("ropes that have come to rest are shown larger sooner than ropes that move", () => {
  const places = rope(5, 8.4); // the picture could be 0.84 as far away
  const waits = [0, 0.3].map((swing) => {
    const made = camera();
    made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
    const follow = new Follow();
    for (let i = 0; i < 600; i++) {
      const now = places.map(([x, y, z]) => [x, y, z + swing * Math.sin(i / 9)]);
      follow.take(made, nodesOf(now), ALL, 1 / 60, ROOM);
      if (follow.wanted(made, STRIPS)) return i / 60;
    }
    return Infinity;
  });
  assert.ok(waits[0] < 2, `${waits}`); // s
  assert.ok(waits[1] > 2.9 && waits[1] < 3.5, `${waits}`); // what swings evenly for so long will go on so
});

test("what becomes large and small again and again is not zoomed in on each time", () => {
  const made = camera();
  const follow = new Follow();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  let [turns, way] = [0, 0];
  for (let i = 0; i < 60 * 60; i++) {
    const small = i % 300 > 100; // for 3.3 s of 5
    follow.take(made, nodesOf(small ? rope(3, 4) : rope(6)), ALL, 1 / 60, ROOM);
    const pose = follow.wanted(made, STRIPS);
    if (!pose) continue;
    const now = Math.sign(pose.distance - made.pose.distance);
    if (now && now !== way) turns++;
    way = now || way;
    made.set(pose);
  }
  assert.ok(turns >= 2 && turns <= 8, `${turns} zooms in a minute`); // in and out each time: 24
  for (let i = 0; i < 20 * 60; i++) follow.take(made, nodesOf(rope(3, 4)), ALL, 1 / 60, ROOM);
  assert.ok(follow.wanted(made, STRIPS)); // the twin: what stays small is looked at from near
});

test("a rope that swings round fills the picture as far as it goes round, not the box around that", () => {
  const made = camera();
  const follow = new Follow();
  made.set(made.framed(rope(6), { azimuth: -1.85, elevation: 0.14 }));
  const turned = (/** @type {number} */ angle) =>
    rope(8).map(([x, , z]) => [x, -z * Math.sin(angle), z * Math.cos(angle)]);
  const turns = Array.from({ length: 120 }, (_, i) => turned(i / 5));
  for (const places of turns) follow.take(made, nodesOf(places), ALL, 1 / 60, ROOM);
  const pose = follow.goal(made, STRIPS);
  assert.ok(pose);
  const whole = made.framed(follow.corners(made)); // the twin
  made.set(pose);
  const part = share(made, turns.flat());
  assert.ok(part > 0.9 && part <= 1.001, `${part}`);
  made.set(whole);
  const box = share(made, turns.flat());
  assert.ok(box < 0.97 * part, `${box} ${part}`);
});
