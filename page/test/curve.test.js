import assert from "node:assert/strict";
import { test } from "node:test";

import { Line, thin } from "../src/render/line.js";
import { carryNormals, refine } from "../src/view/curve.js";

const STEPS = 8;

/** Points of the curve through places. @param {number[][]} places @param {number[]} [kinks] */
function curve(places, kinks = []) {
  const nodes = Float32Array.from(places.flatMap((p, i) => [...p, i]));
  const rope = { first: 0, count: places.length };
  const corners = Uint8Array.from(places, (_, i) => Number(kinks.includes(i)));
  const out = new Float32Array(4 * (STEPS * (places.length - 1) + 1));
  refine(nodes, rope, STEPS, corners, out, 0);
  return Array.from({ length: out.length / 4 }, (_, i) => [...out.subarray(4 * i, 4 * i + 4)]);
}

/** How far the curve goes from its chords [chords], and how far it runs back along one. @param {number[][]} places */
function faults(places) {
  const points = curve(places);
  let [aside, back] = [0, 0];
  for (let i = 0; i + 1 < places.length; i++) {
    const chord = places[i + 1].map((value, k) => value - places[i][k]);
    const size = Math.hypot(...chord);
    let along = 0;
    for (let k = 0; k <= STEPS; k++) {
      const off = points[STEPS * i + k].slice(0, 3).map((value, j) => value - places[i][j]);
      const part = off.reduce((sum, value, j) => sum + value * chord[j], 0) / size / size;
      const away = Math.hypot(...off.map((value, j) => value - part * chord[j])) / size;
      aside = Math.max(aside, away);
      back = Math.max(back, along - part, part - 1);
      along = part;
    }
  }
  return { aside, back };
}

/** Numbers that look random and are the same each time. */
function* random() {
  for (let seed = 7; ;) {
    seed = (16807 * seed) % 2147483647;
    yield seed / 2147483647;
  }
}

const numbers = random();
const next = () => /** @type {number} */ (numbers.next().value);
/** A rope whose direction turns by up to `bend` at each node. @param {number} bend @param {() => number} size */
function wander(bend, size) {
  const places = [[0, 0, 0]];
  let [angle, height] = [0, 0];
  for (let i = 0; i < 60; i++) {
    const last = places[places.length - 1];
    const step = size();
    angle += bend * (2 * next() - 1);
    height += 0.3 * bend * (next() - 0.5);
    places.push([
      last[0] + step * Math.cos(angle),
      last[1] + step * Math.sin(angle),
      last[2] + step * height,
    ]);
  }
  return places;
}

test("the curve goes through every node and carries its values", () => {
  const places = wander(0.6, () => 1);
  curve(places)
    .filter((_, i) => i % STEPS === 0)
    .forEach((point, i) => {
      point.slice(0, 3).forEach((value, k) => assert.ok(Math.abs(value - places[i][k]) < 1e-4));
      assert.equal(point[3], i);
    });
});

test("it neither overshoots nor turns back, however uneven the spacing and sharp the bends", () => {
  const ropes = {
    even: wander(0.5, () => 1),
    sharp: wander(1.5, () => 1),
    uneven: wander(0.5, () => 20 ** next()),
    zigzag: Array.from({ length: 40 }, (_, i) => [i, i % 2 ? 1.5 : 0, 0]),
    fold: Array.from({ length: 40 }, (_, i) => [i < 20 ? i : 40.01 - i, i < 20 ? 0 : 0.05, 0]),
  };
  for (const [name, places] of Object.entries(ropes)) {
    const { aside, back } = faults(places);
    assert.ok(aside < 0.25, `${name}: ${aside} of a chord aside`);
    assert.ok(back < 1e-3, `${name}: ${back} of a chord back`);
  }
});

test("the twin: uniform tangents do turn back where the spacing is uneven", () => {
  // The same measure finds a curve that does: nodes close together beside a long segment.
  const places = [
    [0, 0, 0],
    [20, 0, 0],
    [20.5, 0.5, 0],
    [21, 2, 0],
  ];
  const tangentAt = (/** @type {number} */ i) =>
    places[i + 1].map((value, k) => (value - places[i - 1][k]) / 2);
  const [from, to] = [places[1], places[2]];
  const [a, b] = [tangentAt(1), tangentAt(2)];
  const chord = [0, 1, 2].map((k) => to[k] - from[k]);
  let worst = 0;
  for (let t = 0; t <= 1; t += 0.05) {
    const point = [0, 1, 2].map(
      (k) =>
        (3 * t * t - 2 * t ** 3) * chord[k] +
        (t - 2 * t * t + t ** 3) * a[k] +
        (t ** 3 - t * t) * b[k],
    );
    const part = point.reduce((sum, value, k) => sum + value * chord[k], 0) / 0.5;
    worst = Math.max(worst, part - 1, -part);
  }
  assert.ok(worst > 0.1);
  assert.ok(faults(places).back < 1e-3);
});

test("a straight rope stays straight, and an anchor inside makes a corner", () => {
  assert.ok(faults(Array.from({ length: 9 }, (_, i) => [i, 0, 0])).aside < 1e-6);
  const bent = [-3, -2, -1, 0, 1, 2, 3].map((x) => [x, Math.abs(x), 0]);
  const away = (/** @type {number[]} */ kinks) =>
    Math.max(...curve(bent, kinks).map(([x, y]) => Math.abs(y - Math.abs(x))));
  assert.ok(away([3]) < 1e-6);
  assert.ok(away([]) > 0.01); // the twin
});

test("a circle of 24 nodes is drawn as a circle", () => {
  const places = Array.from({ length: 30 }, (_, i) => [
    Math.cos((i * Math.PI) / 12),
    Math.sin((i * Math.PI) / 12),
    0,
  ]);
  const radii = curve(places)
    .slice(2 * STEPS, -2 * STEPS)
    .map(([x, y]) => Math.hypot(x, y));
  assert.ok(Math.max(...radii) < 1.0005 && Math.min(...radii) > 0.9995);
});

test("normals stay at right angles and of length one, without twist in a plane", () => {
  const points = Float32Array.from(
    Array.from({ length: 50 }, (_, i) => [Math.cos(i / 8), Math.sin(i / 8), 0, 0]).flat(),
  );
  const normals = new Float32Array(4 * 50);
  normals.set([0, 0, 1]);
  carryNormals(points, 0, 50, normals);
  for (let i = 0; i < 50; i++) {
    const [x, y, z] = normals.subarray(4 * i, 4 * i + 3);
    assert.ok(Math.abs(x) < 1e-5 && Math.abs(y) < 1e-5 && Math.abs(z - 1) < 1e-5);
  }
});

test("of nodes that are too short to be seen some are left out, never the last nor the greatest value", () => {
  const nodes = Float32Array.from(
    Array.from({ length: 10 }, (_, i) => [i, 0, 0, i === 6 ? 99 : 1]).flat(),
  );
  const out = new Float32Array(16);
  thin(nodes, 0, 10, 4, out, 0);
  assert.deepEqual([out[0], out[4], out[8], out[12]], [0, 4, 8, 9]);
  assert.deepEqual([out[3], out[7], out[11]], [1, 99, 1]);
});

test("long segments get many points, short ones few, and as many as before for a small change", () => {
  const line = new Line(2000, 2000);
  const rope = { name: "", first: 0, count: 101, radius: 0.01, spacing: 0.1, colour: [0, 0, 0] };
  line.setShape({ nodes: 101, ropes: [/** @type {any} */ ({ ...rope, loose: [false, false] })] });
  const at = (/** @type {number} */ pixels, changes = {}) => {
    const camera = { focal: 10 * pixels, pose: { distance: 1 } };
    const nodes = new Float32Array(4 * 101);
    line.update(
      /** @type {any} */ ({
        camera,
        nodes,
        corners: new Uint8Array(101),
        smooth: true,
        moved: true,
        ...changes,
      }),
    );
    return line.shape.nodes;
  };
  assert.equal(at(20), 301);
  assert.equal(at(22), at(20));
  assert.equal(at(400), 801);
  assert.equal(at(5), 101);
  assert.ok(at(0.4) < 40);
  assert.equal(at(0.4, { dots: true }), 101); // each node is to be seen
  assert.equal(at(400, { smooth: false }), 101); // what broke is drawn as it is
});
