import assert from "node:assert/strict";
import { test } from "node:test";

import { Framing } from "../src/framing.js";
import { partNear } from "../src/solids.js";
import {
  drawnOf,
  forceText,
  hasTail,
  numberedOf,
  roomFor,
  scaleOf,
  tipOf,
  tipsOf,
} from "../src/reactions.js";
import { contactTips, strongestOfEach } from "../src/touches.js";
import { crowdText, endText } from "../src/panels/legend.js";
import { Camera } from "../src/view/camera.js";

test("a loose end hangs from an anchor, not from one between two others, nor from a tied one", () => {
  const ropes = [{ first: 0, nodes: 11 }];
  const held = (...nodes) => ({ ropes, anchors: nodes.map((index) => ({ index })) });
  assert.equal(hasTail(held(0), 0), true);
  assert.equal(hasTail(held(0, 10), 0), false);
  assert.equal(hasTail(held(0, 5), 0), false); // the next one has the loose end
  assert.equal(hasTail(held(0, 5), 5), true);
  assert.equal(hasTail({ ...held(0), joints: [{ nodes: [10, 30] }] }, 0), false);
  assert.equal(hasTail(held(40), 40), false); // of no rope
});

/** A viewport with one anchor at the origin. */
function viewport(force, seen = [0]) {
  const anchors = new Float32Array(10);
  anchors.set(force, 6);
  anchors[9] = 1;
  const layout = { variants: [{ anchors: [{ index: 0, motion: "fixed" }] }] };
  return {
    session: { layout, frame: { parts: [{ anchors, seen: { greatestForce: seen } }] } },
    anchors: { to: new Float32Array(3) },
    marks: { reactions: true, strongest: 0 },
  };
}

test("an arrow that would leave the picture is given room, at its side only", () => {
  const camera = new Camera();
  camera.resize(900, 200); // where it is 34 pixels long
  camera.set({ target: [0, 0, 0], distance: 10, azimuth: -Math.PI / 2, elevation: 0 });
  const strips = { top: 40, bottom: 50 };
  const above = roomFor(viewport([0, 0, 5]), camera, strips);
  assert.ok(Math.abs(above.top - 48) < 0.1, `${above.top}`); // 40, and 34 for the label: 8 too many
  assert.equal(above.bottom, 50);
  const below = roomFor(viewport([0, 0, -5]), camera, strips);
  assert.ok(Math.abs(below.bottom - 63.2) < 0.1, `${below.bottom}`); // no more than a part of what is free
  assert.equal(below.top, 40);
  assert.deepEqual(roomFor(viewport([5, 0, 0]), camera, strips), strips); // the twin: to the side
  assert.deepEqual(roomFor(viewport([0, 0, 0]), camera, strips), strips);
  const card = roomFor(viewport([0, 0, 5]), camera, { top: 90, bottom: 0 });
  assert.equal(card.top, 90 + 0.12 * 110);
});

test("the arrow of a contact is given room, too", () => {
  const camera = new Camera();
  camera.resize(390, 640);
  camera.set({ target: [0, 0, 0], distance: 10, azimuth: -Math.PI / 2, elevation: 0 });
  const made = viewport([0, 0, 0]);
  made.nodes = { to: new Float32Array([0, 0, 3, 0]) };
  Object.assign(made.marks, { contacts: true, firmest: 0 });
  made.session.frame.parts[0].contact = new Float32Array([0, 0, 7]);
  made.session.frame.parts[0].ropeContacts = new Float32Array(0);
  const [tip] = contactTips(made, camera);
  const [, foot] = camera.project(0, 0, 3);
  const [, y] = camera.project(...tip);
  assert.ok(Math.abs(foot - y - 56) < 0.1, `${foot - y}`);
  const strips = { top: Math.round(y + 20), bottom: 0 }; // a row of tools lies over its tip
  assert.ok(Math.abs(roomFor(made, camera, strips).top - (2 * strips.top - y)) < 1e-6);
  made.marks.contacts = false; // the twin
  assert.deepEqual(roomFor(made, camera, strips), strips);
});

/** Anchors that hold forces. @param {number[]} sizes [N] */
const holding = (sizes) => sizes.map((size, a) => ({ variant: 0, a, size, peak: size }));
const drawn = (/** @type {number[]} */ sizes, /** @type {any[]} */ ...more) =>
  drawnOf(/** @type {any} */ (holding(sizes)), Math.max(...sizes), ...more).map(({ a }) => a);

test("of a crowd of anchors the strong ones have arrows, and the one that is pointed at", () => {
  const few = [100, 60, 45, 30, 11, 9];
  assert.deepEqual(drawn(few), [0, 1, 2, 3, 4]);
  const many = [...few, 8, 7, 6];
  assert.deepEqual(drawn(many), [0, 1]);
  assert.deepEqual(drawn(many, new Set(["0 2", "0 3"])), [0, 1, 2]); // stays: it does not flicker
  assert.deepEqual(
    drawn(many, new Set(), ({ a }) => a === 8),
    [0, 1, 8],
  );
  assert.deepEqual(drawn(Array(28).fill(0)), []);
  const later = (/** @type {number} */ part) =>
    drawnOf(/** @type {any} */ (holding(many.map((size) => part * size))), 100).map(({ a }) => a);
  assert.deepEqual(later(0.2), [0, 1]); // of what they are now, though they were all far stronger once
  assert.deepEqual(later(0.05), []); // arrows that the eye hides
});

test("of many arrows the eight largest have numbers, and the one that is pointed at", () => {
  const sizes = [60, 61, 62, 63, 100, 90, 80, 70, 65, 64, 99, 50];
  const drawn = /** @type {any} */ (holding(sizes));
  const numbered = (/** @type {string[]} */ before, pointed = -1) =>
    numberedOf(drawn, new Set(before), ({ a }) => a === pointed).map(({ a }) => a);
  assert.deepEqual(numbered([]), [3, 4, 5, 6, 7, 8, 9, 10]);
  assert.deepEqual(numbered(["0 2"]), [2, 4, 5, 6, 7, 8, 9, 10]); // nearly as large: it does not flicker
  assert.deepEqual(numbered(["0 11"]), [3, 4, 5, 6, 7, 8, 9, 10]); // the twin
  assert.deepEqual(numbered([], 11), [3, 4, 5, 6, 7, 8, 9, 10, 11]);
  assert.equal(
    crowdText({ forces: 12, large: 11 }),
    "The 11 larger of 12 forces. Point at others.",
  );
});

test("an arrow keeps clear of the tools beside the picture, where these are as high as it", () => {
  const camera = new Camera();
  camera.resize(900, 600);
  camera.set({ target: [0, 0, 0], distance: 10, azimuth: -Math.PI / 2, elevation: 0 });
  const made = viewport([-5, 0, 0]); // its tip is at 450 - 84 = 366
  const strips = { top: 0, bottom: 0 };
  const bar = (left, top, width, height) => [
    { left, top, width, height, right: left + width, bottom: top + height },
  ];
  made.bars = () => bar(340, 100, 56, 300);
  assert.ok(Math.abs(roomFor(made, camera, strips).left - (396 + 6 - 366)) < 0.5);
  made.bars = () => bar(340, 320, 56, 200); // the twins: below it, and a row at the top
  assert.equal(roomFor(made, camera, strips).left, undefined);
  made.bars = () => bar(300, 280, 100, 40);
  assert.equal(roomFor(made, camera, strips).left, undefined);
});

test("the room for arrows is what the picture needs that leaves it, wherever the camera is now", () => {
  const camera = new Camera();
  camera.resize(900, 600);
  const made = viewport([-5, 0, 0]);
  const [left, width, top, height] = [0, 90, 100, 400];
  made.bars = () => [{ left, top, width, height, right: width, bottom: top + height }];
  made.camera = camera;
  const framing = new Framing(made);
  const strips = { top: 0, bottom: 0 };
  const framed = (room) =>
    camera.framed(
      [
        [0, 0, 0],
        [10, 0, 0.1],
      ],
      {},
      room,
    );
  for (const x of [0, 50]) {
    camera.set({ target: [x, 0, 0], distance: 30, azimuth: -Math.PI / 2, elevation: 0 });
    const room = framing.roomIn(framed, strips);
    const clear = camera.at(framed(room));
    assert.ok((roomFor(made, clear, strips).left ?? 0) < 1, `seen from ${x}`); // pixel
    assert.ok(roomFor(made, camera.at(framed(strips)), strips).left > 0); // the twin: without it
  }
});

test("newtons of constant forces and of anchors are as long, and none is too short to be seen", () => {
  const camera = new Camera();
  camera.resize(900, 600);
  camera.set({ target: [0, 0, 0], distance: 10, azimuth: -Math.PI / 2, elevation: 0 });
  const layout = (/** @type {number[]} */ ...forces) =>
    /** @type {any} */ ({
      variants: [{ forces: forces.map((size) => ({ force: [size, 0, 0] })) }],
    });
  const pixel = camera.pose.distance / camera.focal;
  const long = (/** @type {number} */ size, /** @type {number} */ per) =>
    tipOf([0, 0, 0], [0, size, 0], per, camera)[1] / pixel;
  const hauled = scaleOf(200, layout(100, 10), camera);
  assert.ok(Math.abs(long(200, hauled) - 84) < 1e-6);
  assert.ok(Math.abs(long(100, hauled) - 42) < 1e-6); // was 50, and the 10 N of a bollard as well
  assert.ok(Math.abs(long(10, hauled) - 14) < 1e-6);
  const given = scaleOf(20, layout(100), camera); // no longer than 0.6 of the longest
  assert.ok(Math.abs(long(100, given) - 50.4) < 1e-6);
});

test("before anything is drawn the end of a rope is given the room of an arrow along it", () => {
  const camera = new Camera();
  camera.resize(900, 600);
  camera.set({ target: [0, 0, 0], distance: 10, azimuth: -Math.PI / 2, elevation: 0 });
  const made = viewport([0, 0, 0]);
  made.session.layout.variants[0].ropes = [{ first: 0, nodes: 2 }];
  made.nodes = { to: new Float32Array([0, 0, 0, 0, 1, 0, 0, 0]) }; // the rope lies to the right
  made.starts = [0];
  made.bars = () => [{ left: 340, top: 100, width: 56, height: 300, right: 396, bottom: 400 }];
  const strips = { top: 0, bottom: 0 };
  assert.ok(Math.abs(roomFor(made, camera, strips).left - (396 + 6 - 366)) < 0.5);
  made.marks.strongest = 1; // the twin: it holds nothing, as is seen by now
  assert.equal(roomFor(made, camera, strips).left, undefined);
});

test("of a body the picture holds what is near the ropes", () => {
  const ropes = { low: [0, 0, 0], high: [1, 0.2, 0.5] };
  const stairs = [-5, 2].flatMap((x) => [0, 1].flatMap((y) => [-1, 0].map((z) => [x, y, z])));
  const held = partNear(stairs, ropes);
  assert.deepEqual(
    [Math.min(...held.map(([x]) => x)), Math.max(...held.map(([x]) => x))],
    [-0.25, 1.25], // a little of what goes on
  );
  const beam = [1.5, 9].flatMap((x) => [0, 0.1].flatMap((y) => [0, 0.1].map((z) => [x, y, z])));
  assert.equal(Math.min(...partNear(beam, ropes).map(([x]) => x)), 1.5); // and where what is near begins
  assert.deepEqual(partNear(stairs, { low: [0, 0, -9], high: [1, 0.2, -8.5] }), []); // it fell off
  const wide = { low: [-9, 0, 0], high: [9, 1, 0] };
  assert.deepEqual(partNear(stairs, wide), stairs);
});

test("an end of the legend that rounding left says zero", () => {
  assert.equal(endText(-5.5e-9, 1, 6.4), "0");
  assert.equal(endText(-5.5e-3, 1, 6.4), "−0.0055");
});

test("of many contacts the strongest has its arrow", () => {
  const contact = new Float32Array(3 * 501);
  contact[3 * 100 + 2] = 1;
  contact[3 * 101 + 1] = -5; // every third one was drawn, 99 and 102
  const drawn = strongestOfEach(contact, 200);
  assert.ok(drawn.length <= 200 && drawn.includes(101) && !drawn.includes(100));
  assert.deepEqual(strongestOfEach(contact.subarray(0, 9), 200), [0, 1, 2]);
});

test("a force says what it is now, and marks what it was at most", () => {
  assert.equal(forceText(10.8, 65, false), "10.8 N, max 65 N");
  assert.equal(forceText(10.8, 65, true), "max 65 N");
  assert.equal(forceText(10.8, 11, false), "10.8 N");
  assert.equal(forceText(10.8, 11, true), "11 N"); // a tenth of a second is told by its greatest
});

test("an arrow is as long as the force that it points along, whatever was before", () => {
  const camera = new Camera();
  camera.resize(900, 600);
  camera.set({ target: [0, 0, 0], distance: 10, azimuth: -Math.PI / 2, elevation: 0 });
  const made = viewport([0, 0, 5], [50]);
  made.marks.strongest = 20;
  const [tip] = tipsOf(made, camera);
  const [, foot] = camera.project(0, 0, 0);
  const [, y] = camera.project(...tip);
  assert.ok(Math.abs(foot - y - 84 / 4) < 0.1, `${foot - y}`); // a quarter of the longest
});
