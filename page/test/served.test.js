import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { MAGIC, readFrame } from "../src/source/frame.js";
import { join } from "../src/source/join.js";
import { ServedFrames } from "../src/source/served.js";

const NODES = 2;
const SCALARS = ["tension_low", "tension_high", "tension_max", "speed_high", "low", "high"];
const layoutOf = (number, bytes = 192) => ({
  type: "layout",
  layout: number,
  bytes,
  up: [0, 0, 1],
  scalars: SCALARS,
  variants: [
    {
      nodes: NODES,
      anchors: [{ index: 0 }],
      offsets: {
        scalars: 48,
        positions: 72,
        tension: 96,
        speed: 100,
        least_tension: 104,
        greatest_tension: 108,
        greatest_speed: 112,
        least_height: 116,
        greatest_height: 120,
        greatest_force: 124,
        anchors: 128,
        grabs: 168,
      },
    },
  ],
});

/** A frame of a number, in which the shares and scalars are what a test says. */
function frameOf(number, layout, { scalars = [0, 1, 1, 1, 0, 1], shares = {}, force = 0 } = {}) {
  const buffer = new ArrayBuffer(layout.bytes);
  const head = new DataView(buffer);
  head.setUint32(0, MAGIC, true);
  head.setUint32(4, layout.layout, true);
  head.setFloat64(24, number, true);
  const { offsets } = layout.variants[0];
  new Float32Array(buffer, 48, 6).set(scalars);
  for (const [name, values] of Object.entries(shares))
    new Uint16Array(buffer, offsets[name], NODES).set(values.map((share) => share * 65535));
  new Float32Array(buffer, offsets.greatest_force, 1)[0] = force;
  return buffer;
}

const stepsOf = (buffer) => new DataView(buffer).getFloat64(24, true);

/** A server with so many frames in each part; what is asked of it is written down. */
function serve(frames, bytes = 192) {
  const asked = [];
  const first = frames.map((_, part) => frames.slice(0, part).reduce((a, b) => a + b, 0));
  const total = frames.reduce((a, b) => a + b, 0);
  const layouts = frames.map((_, part) => layoutOf(part + 1, bytes + 8 * part));
  globalThis.fetch = async (path) => {
    asked.push(path);
    const { pathname, searchParams } = new URL(path, "http://here/");
    const number = (name) => Number(searchParams.get(name));
    if (pathname.endsWith("times.bin"))
      return new Response(Float64Array.from({ length: total }, (_, i) => i / 10).buffer);
    if (pathname.endsWith("layout.json")) return Response.json(layouts[number("part")]);
    const found = [];
    for (let i = 0; i < number("count"); i++) {
      const at = number("first") + i * number("every");
      if (at >= total) break;
      found.push(new Uint8Array(frameOf(at, layouts[first.findLastIndex((one) => one <= at)])));
    }
    return new Response(await new Blob(found).arrayBuffer());
  };
  return asked;
}

const before = globalThis.fetch;
afterEach(() => {
  globalThis.fetch = before;
});

/** Ask for a frame until it is there, as a player does. */
async function took(frames, ...which) {
  for (let i = 0; i < 100; i++) {
    const found = frames.take(...which);
    if (found) return found;
    await new Promise((done) => setTimeout(done));
  }
  return null;
}

const framesAsked = (asked) => asked.filter((path) => path.includes("frames.bin"));

test("frames are fetched in pieces ahead, across parts, and each is the caller's own", async () => {
  const asked = serve([50, 100]);
  const frames = new ServedFrames("./", assert.fail);
  assert.equal((await frames.times()).length, 150);
  for (let i = 0; i < 150; i++) {
    const shown = await took(frames, i, i - 1, 1, true);
    assert.equal(stepsOf(shown), i);
    assert.equal(shown.byteLength, i < 50 ? 192 : 200);
    structuredClone(shown, { transfer: [shown] }); // the page forgets it
    await new Promise((done) => setTimeout(done));
  }
  assert.equal(stepsOf(await took(frames, 149, 148, 1, true)), 149);
  assert.deepEqual(framesAsked(asked), [
    "./replay/frames.bin?first=0&count=64&every=1",
    "./replay/frames.bin?first=64&count=64&every=1",
    "./replay/frames.bin?first=128&count=64&every=1",
  ]);
});

test("while nothing plays one frame is fetched, with what was seen since the one shown", async () => {
  const asked = serve([500]);
  const frames = new ServedFrames("./", assert.fail);
  await frames.times();
  assert.equal(stepsOf(await took(frames, 300, 299, 1, false)), 300);
  assert.equal(stepsOf(await took(frames, 400, 300, 1, false)), 400);
  assert.deepEqual(framesAsked(asked), [
    "./replay/frames.bin?first=300&count=1&every=1",
    "./replay/frames.bin?first=400&count=1&every=100",
  ]);
});

test("what is passed over for long, or does not fit the stride, the server puts together", async () => {
  const asked = serve([500]);
  const frames = new ServedFrames("./", assert.fail);
  await frames.times();
  await took(frames, 100, 0, 2, true);
  await took(frames, 103, 100, 2, true);
  assert.deepEqual(framesAsked(asked), [
    "./replay/frames.bin?first=100&count=1&every=100",
    "./replay/frames.bin?first=103&count=1&every=3",
  ]);
});

test("no more is kept than fits into the memory", async () => {
  const bytes = 1_000_000;
  serve([200], bytes);
  const frames = new ServedFrames("./", assert.fail);
  await frames.times();
  let most = 0;
  for (let i = 0; i < 200; i++) {
    await took(frames, i, i - 1, 1, true);
    most = Math.max(most, frames.held);
    const kept = [...frames.kept.values()].reduce((sum, one) => sum + one.byteLength, 0);
    assert.equal(frames.held, kept);
  }
  assert.ok(most > 60e6 && most <= 64e6);
});

test("a server's fault is told once; a server that is gone, not at all: the socket tells it", async () => {
  serve([5]);
  const said = [];
  const frames = new ServedFrames("./", (text) => said.push(text));
  await frames.times();
  globalThis.fetch = async () => new Response("run/data: is damaged\n", { status: 500 });
  for (let i = 0; i < 3; i++) {
    frames.failed = -Infinity;
    await frames.load(0, 1, 1);
  }
  assert.deepEqual(said, ["run/data: is damaged"]);
  globalThis.fetch = () => Promise.reject(new TypeError("Failed to fetch"));
  frames.failed = -Infinity;
  await frames.load(0, 1, 1);
  assert.deepEqual(said, ["run/data: is damaged"]);
  assert.equal(frames.take(0, -1, 1, true), null);
  assert.equal(frames.loading, false); // it was just tried: later again
  serve([5]);
  frames.failed = -Infinity;
  assert.equal(stepsOf(await took(frames, 0, -1, 1, true)), 0);
});

test("an answer cut short is no frame", async () => {
  serve([5]);
  const whole = globalThis.fetch;
  globalThis.fetch = async (path) => {
    const answer = await whole(path);
    if (!path.includes("frames.bin")) return answer;
    return new Response((await answer.arrayBuffer()).slice(0, -8));
  };
  const said = [];
  const frames = new ServedFrames("./", (text) => said.push(text));
  await frames.times();
  await frames.load(0, 1, 5);
  assert.match(said[0], /cut short/);
});

test("two frames are joined: ranges, extremes and the instant's own", () => {
  const layout = layoutOf(1);
  const older = frameOf(1, layout, {
    scalars: [-10, 90, 90, 2, -1, 3],
    shares: {
      tension: [1, 1],
      least_tension: [0, 0.5], // -10 N, 40 N
      greatest_tension: [1, 0.5], // 90 N, 40 N
      greatest_speed: [0.5, 1], // 1 m/s, 2 m/s
      least_height: [0, 0.5], // -1 m, 1 m
      greatest_height: [0.25, 1], // 0 m, 3 m
    },
    force: 7,
  });
  const newer = frameOf(2, layout, {
    scalars: [0, 50, 60, 4, 0, 4],
    shares: {
      tension: [0.5, 1], // 25 N, 50 N
      speed: [0.25, 0.5], // 1 m/s, 2 m/s
      least_tension: [0.5, 0.6], // 25 N, 30 N
      greatest_tension: [0.6, 1], // 30 N, 50 N
      greatest_speed: [0.5, 0.25], // 2 m/s, 1 m/s
      least_height: [0.25, 0], // 1 m, 0 m
      greatest_height: [0.5, 0.25], // 2 m, 1 m
    },
    force: 3,
  });
  join(older, newer, layout);
  const part = readFrame(newer, layout).parts[0];
  assert.deepEqual([...part.scalars], [-10, 90, 90, 4, -1, 4]);
  const near = (words, low, high, wanted) =>
    words.forEach((word, i) => {
      const value = low + (word / 65535) * (high - low);
      assert.ok(Math.abs(value - wanted[i]) < 2e-5 * (high - low), `${value} for ${wanted[i]}`);
    });
  near(part.tension, -10, 90, [25, 50]);
  near(part.speed, 0, 4, [1, 2]);
  near(part.seen.leastTension, -10, 90, [-10, 30]);
  near(part.seen.greatestTension, -10, 90, [90, 50]);
  near(part.seen.greatestSpeed, 0, 4, [2, 2]);
  near(part.seen.leastHeight, -1, 4, [-1, 0]);
  near(part.seen.greatestHeight, -1, 4, [2, 3]);
  assert.equal(part.seen.greatestForce[0], 7);
});

test("a frame of another layout is left as it is", () => {
  const newer = frameOf(2, layoutOf(2));
  const bytes = [...new Uint8Array(newer)];
  join(frameOf(1, layoutOf(1), { scalars: [-9, 9, 9, 9, -9, 9] }), newer, layoutOf(2));
  assert.deepEqual([...new Uint8Array(newer)], bytes);
});
