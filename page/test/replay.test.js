import assert from "node:assert/strict";
import { test } from "node:test";

import { PLAYING } from "../src/source/frame.js";
import { Replay } from "../src/source/replay.js";

const HELLO = { type: "hello", mode: "replay", can: [] };

/** Frames of which only those are there that a test lets in; what is taken is written down. */
class Few {
  constructor(times) {
    Object.assign(this, { base: "", within: 1e-9, clock: Float64Array.from(times) });
    Object.assign(this, { taken: [], there: () => true });
  }

  async times() {
    return this.clock;
  }

  async layout(part) {
    return { type: "layout", layout: part + 1 };
  }

  take(index, after, every, on) {
    if (!this.there(index)) return null;
    this.taken.push({ index, after, every, on });
    return new ArrayBuffer(48);
  }

  async read(first, count, every) {
    return Array.from({ length: count }, (_, i) => first + i * every);
  }
}

/** A replay that is open, with what it sent. */
async function opened(times, { single = 0, playing = true, parts } = {}) {
  const frames = new Few(times);
  const usual = [{ frames: times.length, method: "rk4", dt: 0.001 }];
  const run = { duration: times.at(-1), single, playing, parts: parts ?? usual };
  const replay = new Replay(HELLO, run, frames);
  const sent = [];
  globalThis.requestAnimationFrame = () => 0;
  await replay.open({
    message: (message) => sent.push(message),
    frame: (buffer) => sent.push({ type: "frame", head: new DataView(buffer) }),
    state: (state, text) => sent.push({ type: "state", state, text }),
  });
  replay.last = replay.lastStatus = 0; // the clock of ticks, however late it was opened
  const answer = async (command) => {
    replay.send({ ...command, id: 7 });
    await null;
    return sent.at(-1);
  };
  return { replay, frames, sent, answer };
}

const every = (step, count) => Array.from({ length: count }, (_, i) => i * step);

test("it opens with a layout, a status and what it can", async () => {
  const { sent } = await opened(every(0.1, 11), { playing: false });
  const hello = sent.find(({ type }) => type === "hello");
  assert.deepEqual(hello.can, ["play", "pause", "step", "speed", "seek", "reset"]);
  assert.equal(sent.find(({ type }) => type === "layout").layout, 1);
  const status = sent.find(({ type }) => type === "status");
  assert.deepEqual([status.playing, status.duration, status.method], [false, 1, "rk4"]);
});

test("times that cannot be had are told", async () => {
  const frames = new Few([0, 1]);
  frames.times = () => Promise.reject(new Error("the recording is damaged"));
  const said = [];
  const run = { duration: 1, single: 0, playing: true, parts: [{ frames: 2 }] };
  await new Replay(HELLO, run, frames).open({ state: (...what) => said.push(what) });
  assert.deepEqual(said, [["damaged", "This page cannot be shown: the recording is damaged."]]);
});

test("it plays to the end in its speed, and plays again from the start", async () => {
  const { replay, frames, sent, answer } = await opened(every(1 / 60, 61));
  for (let now = 0; now <= 500; now += 20) replay.tick(now);
  assert.ok(Math.abs(replay.time - 0.5) < 1e-9);
  const shown = sent.findLast(({ type }) => type === "frame");
  assert.ok(shown.head.getUint32(12, true) & PLAYING);
  assert.equal((await answer({ type: "speed", value: 2 })).type, "done");
  for (let now = 500; now <= 800; now += 20) replay.tick(now);
  assert.deepEqual([replay.time, replay.playing, frames.taken.at(-1).index], [1, false, 60]);
  const last = sent.findLast(({ type }) => type === "status");
  assert.equal(last.playing, false);
  await answer({ type: "play" });
  assert.deepEqual([replay.time, replay.playing, frames.taken.at(-1).index], [0, true, 0]);
});

test("a frame shows what was seen since the one shown before, after a jump since the one before it", async () => {
  const { replay, frames, answer } = await opened(every(0.001, 400), { playing: false });
  replay.tick(0);
  await answer({ type: "step", count: 17 });
  assert.deepEqual([frames.taken.at(-1).index, frames.taken.at(-1).after], [17, 0]);
  await answer({ type: "step", count: 100 });
  assert.deepEqual([frames.taken.at(-1).index, frames.taken.at(-1).after], [117, 17]);
  await answer({ type: "seek", time: 0 });
  await answer({ type: "seek", time: 0.3 });
  assert.deepEqual([frames.taken.at(-1).index, frames.taken.at(-1).after], [300, 299]);
});

test("many frames a second are shown by a stride, the last one too", async () => {
  const { replay, frames } = await opened(every(0.001, 1001));
  for (let now = 0; now <= 1100; now += 20) replay.tick(now);
  const shown = frames.taken.map(({ index }) => index);
  assert.equal(replay.every, 16);
  assert.ok(shown.slice(1, -1).every((index) => index % 16 === shown[1] % 16));
  frames.taken.slice(1).forEach(({ after }, i) => assert.equal(after, shown[i]));
  assert.equal(shown.at(-1), 1000);
});

test("time waits for a frame that is not there, and a place sought is shown when it comes", async () => {
  const { replay, frames, sent, answer } = await opened(every(0.1, 11));
  replay.tick(0);
  frames.there = () => false;
  for (let now = 0; now <= 2000; now += 20) replay.tick(now);
  assert.ok(replay.time < 0.1);
  assert.equal(replay.playing, true);
  const done = await answer({ type: "seek", time: 0.75 });
  const before = sent.length;
  replay.tick(2020);
  assert.equal(replay.shown, 0);
  frames.there = () => true;
  replay.tick(2040);
  const shown = sent.slice(before).find(({ type }) => type === "frame");
  assert.equal(shown.head.getUint32(8, true), done.frame);
  assert.deepEqual([replay.shown, frames.taken.at(-1).after], [7, 6]);
});

test("what was reached is measured: waits for frames count, another speed begins anew", async () => {
  const { replay, frames, sent, answer } = await opened(every(1 / 60, 601));
  const told = () => sent.findLast(({ type }) => type === "status").realtime;
  assert.equal(told(), null); // nothing measured yet
  let now = 0;
  const go = (until) => {
    for (; now <= until; now += 20) replay.tick(now);
  };
  go(1000);
  assert.ok(Math.abs(told() - 1) < 0.05);
  frames.there = () => false;
  go(2000);
  assert.equal(told(), 0); // it waits, and says so
  frames.there = () => true;
  go(3000);
  assert.ok(Math.abs(told() - 1) < 0.05);
  const shown = sent.findLast(({ type }) => type === "frame");
  assert.ok(Math.abs(shown.head.getFloat32(32, true) - 1) < 0.05);
  await answer({ type: "speed", value: 0.5 });
  assert.equal(told(), null);
  go(4000);
  assert.ok(Math.abs(told() - 0.5) < 0.05);
  await answer({ type: "pause" });
  assert.equal(told(), 0);
});

test("the frame that is sought while it plays is asked for until it is there, and no other", async () => {
  const { replay, frames, answer } = await opened(every(1 / 240, 2401));
  for (let now = 0; now <= 200; now += 20) replay.tick(now);
  const asked = [];
  let late = 3;
  frames.there = (index) => {
    asked.push(index);
    return --late < 0;
  };
  await answer({ type: "seek", time: 5 });
  for (const now of [217, 250, 258]) replay.tick(now); // animation frames are not even
  assert.deepEqual(asked, [1200, 1200, 1200, 1200]);
  assert.equal(replay.shown, 1200);
});

test("a time outside the run, and what no replay can do, is refused", async () => {
  const { replay, answer } = await opened(every(0.1, 11), { playing: false });
  assert.match((await answer({ type: "seek", time: 9 })).text, /must be from 0 to 1 s/);
  assert.match((await answer({ type: "seek", time: -1 })).text, /must be from 0 to 1 s/);
  assert.match((await answer({ type: "seek", time: NaN })).text, /must be from 0 to 1 s/);
  assert.match((await answer({ type: "cut", segment: 1 })).text, /in a replay/);
  assert.equal(replay.time, 0);
});

test("steps past a break go by slowly", async () => {
  const times = [...every(0.1, 11), 1.001, 1.002, 1.003];
  const { replay } = await opened(times, { single: 3 });
  replay.time = 0.99;
  assert.equal(replay.later(0.02), 1); // however fast, it stops there first
  replay.time = 1;
  const later = replay.later(0.01) - replay.time;
  assert.ok(0 < later && later < 0.01);
  assert.equal(replay.later(1e9), 1.003);
});

test("a further part has its layout told before its frames; frames are read with their layouts", async () => {
  const parts = [5, 6].map((frames) => ({ frames, method: "rk4", dt: 0.001 }));
  const { replay, sent, answer } = await opened(every(0.1, 11), { playing: false, parts });
  await answer({ type: "seek", time: 0.8 });
  await null; // the layout comes
  replay.tick(20);
  const kinds = sent.map(({ type, layout }) => (type === "layout" ? layout : type));
  assert.ok(kinds.indexOf(2) >= 0);
  assert.equal(kinds.lastIndexOf("frame"), kinds.indexOf(2) + 1);
  const read = async (...which) =>
    (await replay.read(...which)).map(({ buffer, layout }) => [buffer, layout.layout]);
  assert.deepEqual(await read(3, 3, 1), [[3, 1], [4, 1], [5, 2]]); // prettier-ignore
  assert.deepEqual(await read(1, 99, 3), [[1, 1], [4, 1], [7, 2], [10, 2]]); // prettier-ignore
  assert.deepEqual(await read(11, 3, 1), []);
});

test("graphs hear of a jump, and not of a step", async () => {
  const { replay, answer } = await opened(every(0.1, 11), { playing: false });
  let jumps = 0;
  replay.jumped = () => jumps++;
  await answer({ type: "step" });
  await answer({ type: "seek", time: 0.2 });
  assert.equal(jumps, 0);
  await answer({ type: "seek", time: 0.9 });
  assert.equal(jumps, 1);
});
