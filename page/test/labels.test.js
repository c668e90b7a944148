import assert from "node:assert/strict";
import { test } from "node:test";

import { holes } from "../src/graphs/holes.js";
import { free, placesFor } from "../src/view/places.js";

const SIZE = [60, 20];
const first = (tip, way, room = [400, 300]) => placesFor(tip, way, SIZE, room)[0];

test("a label stands beyond its arrow's tip and inside the scene", () => {
  assert.ok(first([200, 100], [30, 0]).x >= 200);
  assert.ok(first([200, 100], [-30, 0]).x + 60 <= 200);
  const up = first([200, 100], [0, -30]);
  assert.ok(up.y + 20 <= 100);
  assert.equal(up.x, 170);
  for (const tip of [
    [395, 100],
    [5, 2],
    [200, 299],
  ]) {
    for (const { x, y } of placesFor(tip, [-1, -30], SIZE, [400, 300]))
      assert.ok(x >= 0 && x + 60 <= 400 && y >= 0 && y + 20 <= 300);
  }
});

test("a label is near its arrow's tip in all places but the last ones", () => {
  const near = ({ x, y }, [tx, ty]) =>
    Math.hypot(Math.max(x - tx, 0, tx - x - 60), Math.max(y - ty, 0, ty - y - 20));
  for (let angle = 0; angle < 6.3; angle += 0.1) {
    const places = placesFor(
      [200, 150],
      [50 * Math.cos(angle), 50 * Math.sin(angle)],
      SIZE,
      [400, 300],
    );
    const off = places.map((place) => near(place, [200, 150]));
    assert.ok(Math.max(...off.slice(0, -2)) <= 15.001, `${angle}: ${off}`);
  }
});

test("there is a place clear of a card, of an anchor and of a rope", () => {
  const places = placesFor([100, 100], [0, -30], SIZE, [400, 300]);
  const card = { x: 60, y: 0, width: 80, height: 98 }; // over the first place
  const plate = { x: 90, y: 120, width: 20, height: 20 };
  const rope = Array.from({ length: 60 }, (_, i) => [100 + 5 * i, 100]);
  assert.ok(!free(places[0], [card], []));
  const clear = places.find((place) => free(place, [card, plate], rope));
  assert.ok(clear);
  assert.ok(clear.x + 60 <= 100 || clear.y >= 140); // left of the tip, or below the anchor
  assert.ok(places.every((place) => !free(place, [{ x: 0, y: 0, width: 400, height: 300 }], [])));
});

test("lines of a graph leave gaps where there is nothing", () => {
  const times = [0, 0.1, 0.2, 0.3, 8, 8.1];
  const values = [NaN, 1, NaN, 2, 3, 4];
  assert.deepEqual(holes(times, values, 0, 5), [
    [1, 3],
    [3, 4],
  ]);
  assert.deepEqual(holes([0, 0.1, 0.2], [1, 2, 3], 0, 2), []);
  assert.deepEqual(holes([0, 0.1, 0.7], [1, 2, 3], 0, 2, [0, 0, 1]), [[1, 2]]); // samples are missing
});
