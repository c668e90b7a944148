import assert from "node:assert/strict";
import { test } from "node:test";

import { said, sentence, Walk } from "../src/input/walk.js";
import { Compare } from "../src/panels/compare.js";
import { Keep } from "../src/panels/keep.js";
import { BROKEN, PLAYING } from "../src/source/frame.js";
import { Range } from "../src/view/range.js";
import { Viewport } from "../src/viewport.js";

/** @template T @param {new (...of: any[]) => T} kind @param {any} has @returns {T} */
const made = (kind, has) => Object.assign(Object.create(kind.prototype), has);

const scalars = ["difference", "difference_max", "tension_low", "tension_high"];

/** A comparison whose frames differ by so much, and what its card says. */
function comparison() {
  const output = { textContent: "" };
  const line = { querySelector: () => output };
  const layout = { variants: [{ label: "a" }, { label: "b" }], scalars };
  const session = { layout, frame: null };
  const card = { hidden: false };
  const lines = { children: [line, line], replaceChildren: () => (output.textContent = "") };
  const has = { viewport: { session }, card, lines, lastShown: -Infinity, fresh: false };
  const compare = made(Compare, { ...has, wasMany: true, colours() {} });
  const show = (far, flags) => {
    session.frame = { flags, parts: [0, far].map((one) => ({ scalars: [one, one, 0, 0] })) };
    compare.show();
    return output.textContent;
  };
  return { compare, show, output };
}

test("the card of a comparison is up to date when it is paused", () => {
  const { show } = comparison();
  assert.match(show(1, PLAYING), /by 1 m rms/);
  assert.match(show(2, PLAYING), /by 1 m rms/); // ten numbers a second could not be read
  assert.match(show(3, 0), /by 3 m rms/);
});

test("the card of a comparison is written anew with its lines", () => {
  const { compare, show, output } = comparison();
  show(1, PLAYING);
  const element = { append() {}, style: {}, dataset: {}, classList: { add() {} } };
  globalThis.document = { createElement: () => element, createTextNode: () => element };
  const anchors = [];
  const ropes = [{ name: "rope", first: 0, nodes: 2, color: 0 }];
  for (const variant of compare.viewport.session.layout.variants)
    Object.assign(variant, { anchors, ropes, nodes: 2 });
  compare.layout();
  assert.equal(output.textContent, "");
  assert.match(show(2, PLAYING), /by 2 m rms/);
});

test("a comparison that was thought of is none in a scene without that constant", () => {
  const parameters = [{ name: "mass", kind: "number", enabled: true, value: 2 }];
  const session = { parameters, status: { dt: 0.002 }, stability: [] };
  const has = { viewport: { session }, stop: {}, window: { showModal() {} }, fill() {} };
  const compare = made(Compare, has);
  compare.changes = [
    { name: "spring_constant", value: 5 },
    { name: "mass", value: 3 },
  ];
  compare.open();
  assert.deepEqual(compare.changes, [{ name: "mass", value: 3 }]);
  compare.changes = [{ name: "spring_constant", value: 5 }];
  compare.open();
  assert.deepEqual(compare.changes, [{ name: "time_step", value: 0.001 }]);
});

test("why a file cannot be made is told", async () => {
  const told = [];
  const keep = made(Keep, { notices: { say: (text, kind) => told.push([text, kind]) } });
  for (const text of ["run: has no frame that can be shown\n", ""]) {
    globalThis.fetch = async () => ({ ok: false, status: 404, text: async () => text });
    await keep.file("export/page.html", "page.html");
  }
  assert.deepEqual(
    told.filter(([, kind]) => kind === "fault").map(([text]) => text),
    ["page.html: run: has no frame that can be shown", "page.html: it cannot be made here"],
  );
});

test("what rounding leaves of nothing is heard as nothing", () => {
  const rope = { name: "rope", first: 0, nodes: 2, zero: 0 };
  const variant = { anchors: [{ name: "left", index: 0 }], loads: [], ropes: [rope] };
  const layout = { variants: [variant], scalars, scene: { name: "S" } };
  const anchors = Float64Array.of(0, 0, 0, 0, 0, 0, 1.1e-12, 0, 0, 1);
  const parts = [{ scalars: [0, 0, -3e-15, 2e-15], tension: [0, 0], anchors }];
  const frame = { time: 0, parts };
  assert.equal(said(layout, frame, { kind: "anchor", anchor: "left" }), "Anchor left, force 0 N");
  const node = { kind: "node", rope: "rope", node: 1, segment: 0 };
  assert.equal(said(layout, frame, node), "Node 1 of rope, tension 0 N");
  assert.match(sentence(layout, frame, "paused"), /greatest tension 0 N\.$/);
  parts[0].scalars = [0, 0, 0, 12];
  assert.match(sentence(layout, frame, "paused"), /greatest tension 12 N\.$/);
});

test("the state that is read out follows steps, resets and edits while it is paused", () => {
  const variant = { anchors: [], loads: [], ropes: [] };
  const layout = { layout: 1, variants: [variant], scalars, scene: { name: "S" } };
  const frame = { time: 1.1, parts: [{ scalars: [0, 0, 0, 857], anchors: [] }] };
  const session = { layout, frame, status: { playing: false }, broken: null };
  const walk = made(Walk, { viewport: { session }, voice: { textContent: "" }, state: "", at: -1 });
  const heard = () => (walk.tell(), walk.voice.textContent);
  assert.match(heard(), /paused at 1\.1 s.* 857 N/);
  Object.assign(frame, { time: 0, parts: [{ scalars: [0, 0, 0, 20], anchors: [] }] });
  assert.match(heard(), /paused at 0 s.* 20 N/);
  session.status.playing = true;
  assert.match(heard(), /playing at 0 s/);
  frame.time = 1;
  assert.match(heard(), /playing at 0 s/); // the twin: not sixty times a second
});

test("Tab stops at no body that hands can neither move nor turn", () => {
  const walk = made(Walk, { viewport: { session: { can: () => true } } });
  const all = [
    { name: "drum", movable: true, turnable: true },
    { name: "pulley", movable: true, turnable: false },
    { name: "gate", movable: false, turnable: false },
  ];
  const stops = walk.bodies({ obstacles: all }).map(({ obstacle }) => obstacle);
  assert.deepEqual(stops, ["drum", "pulley"]);
});

test("a part of a replay in which gravity has turned is looked at anew, as a live scene is", () => {
  const asked = [];
  const viewport = made(Viewport, {
    layoutNumber: 0,
    sceneKey: "",
    apart: false,
    range: {},
    camera: { setUp: (up) => asked.push(up) },
    gaps: { take() {} },
    marks: { setLayout() {} },
    shift() {},
  });
  const scene = { name: "S", preset: null };
  const show = (layout, up, gravity) => {
    viewport.lookPending = false;
    const variants = [{ nodes: 2, anchors: [], ropes: [], loads: [] }];
    viewport.takeLayout({ layout, scene, up, gravity, variants });
    return viewport.lookPending;
  };
  assert.equal(show(1, [0, 0, 1], [0, 0, -9.81]), true);
  assert.equal(show(2, [0, 0, 1], [0, 0, -5]), false);
  assert.equal(show(3, [0, 1, 0], [0, -5, 0]), true);
  assert.equal(show(4, [0, 0, 1], [0, 0, 0]), false); // without gravity up stays
  assert.deepEqual(asked, [[0, 0, 1], [0, 1, 0]]); // prettier-ignore
});

test("a live scene that broke has the range of where it was still sound; steps past a break have not", () => {
  const ropes = [{ first: 0, nodes: 2 }];
  const variants = [{ nodes: 2, anchors: [], ropes, loads: [] }];
  const layout = { variants, scalars, view: { center: [0, 0, 0], radius: 1 } };
  const frame = (time, high, flags) => {
    const tension = Uint16Array.of(65535, 65535);
    const seen = {
      greatestTension: tension,
      leastTension: Uint16Array.of(0, 0),
      greatestForce: [],
    };
    const anchors = new Float32Array(0);
    const positions = new Float32Array(6);
    return { time, flags, parts: [{ positions, seen, anchors, scalars: [0, 0, 0, high] }] };
  };
  const next = { next: (now, jump) => new Float32Array(8) };
  const shown = (mode) => {
    const viewport = made(Viewport, {
      ...{ session: { layout, hello: { mode }, broken: null }, range: new Range() },
      ...{ nodes: next, anchors: next, shifts: [[0, 0, 0]], colouring: "tension", lastTime: 0 },
      ...{ gaps: { take() {} }, marks: { take() {}, trails: null }, follower: { take() {} } },
    });
    viewport.takeFrame(frame(0, 6e-6, 0));
    viewport.range.fresh = true; // it broke
    viewport.takeFrame(frame(0.02, 14, BROKEN));
    return [viewport.range.high, ...viewport.beyond];
  };
  assert.deepEqual(shown("live"), [14, false, false]);
  assert.deepEqual(shown("replay"), [6e-6, false, true]);
});
