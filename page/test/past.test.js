import assert from "node:assert/strict";
import { test } from "node:test";

import { Past } from "../src/graphs/past.js";
import { History } from "../src/graphs/history.js";

globalThis.window = globalThis;

const SCALARS = ["kinetic"];
/** A layout of so many nodes. */
const layoutOf = (layout, bytes, nodes = 3, names = []) => ({
  layout,
  bytes,
  scalars: SCALARS,
  up: [0, 0, 1],
  variants: [{ nodes, anchors: names.map((name) => ({ name })), ropes: [] }],
});

/** A frame as the graphs read it; `high` says what was seen since the one before. */
const frameOf = (index, high = 0) => ({
  steps: index,
  time: index / 100,
  flags: 0,
  parts: [{ scalars: [high], positions: [], seen: { greatestForce: [] } }],
});

/** A past of a run whose frame `index` is shown, each frame `bytes` large; what is read is written down. */
function made({ index, bytes, read }) {
  const layout = layoutOf(1, bytes);
  const history = new History();
  const graphs = { open: true, window: 10, history, take: () => {}, bounds: () => {} };
  const said = [];
  const session = { layout, frame: frameOf(index), take: (message) => said.push(message) };
  const viewport = { marks: { followed: new Set() } };
  const asked = [];
  const past = new Past({ graphs, session, viewport }, async (first, count, every, signal) => {
    asked.push({ first, count, every, signal });
    return read(first, count, every, signal);
  });
  return { past, asked, graphs, said };
}

const frames = (first, count, every) =>
  Array.from({ length: count }, (_, i) => ({
    frame: frameOf(first + i * every),
    layout: layoutOf(1, 200),
  }));

test("small frames are read at once, all of the last seconds", async () => {
  const { past, asked, graphs } = made({ index: 800, bytes: 200, read: frames });
  await past.fill();
  const which = asked.map(({ first, count, every }) => [first, count, every]);
  assert.deepEqual(which, [
    [0, 400, 2],
    [0, 800, 1],
  ]);
  assert.equal(graphs.history.count, 800);
});

test("large frames are read in pieces and fewer of them, a bounded number of bytes in all", async () => {
  const bytes = 400_000; // ten thousand nodes
  const { past, asked } = made({ index: 30_000, bytes, read: frames });
  await past.fill();
  const counts = asked.map(({ count }) => count);
  assert.ok(Math.max(...counts) * bytes <= 2e6);
  assert.ok(counts.reduce((a, b) => a + b) * bytes <= 48e6 + 2 * bytes);
  const coarse = asked.filter(({ every }) => every > 100).map(({ first }) => first);
  assert.deepEqual(
    coarse,
    [...coarse].sort((a, b) => a - b),
  );
  asked.forEach(({ first, count, every }) => assert.ok(first + (count - 1) * every < 30_000));
});

test("what is on its way is left off when something else is wanted, and nothing of it is shown", async () => {
  let release = () => {};
  const held = new Promise((done) => (release = done));
  const read = async (...which) => (await held, frames(...which));
  const { past, asked, graphs, said } = made({ index: 800, bytes: 200, read });
  const first = past.fill();
  past.want();
  clearTimeout(past.timer);
  assert.equal(asked[0].signal.aborted, true);
  release();
  await first;
  assert.equal(asked.length, 1);
  assert.equal(graphs.history.count, 0);
  assert.deepEqual(said, []);
});

test("a past that cannot be read is told", async () => {
  const read = () => Promise.reject(new Error("frame 7 is damaged"));
  const { past, said } = made({ index: 800, bytes: 200, read });
  await past.fill();
  assert.match(said[0].text, /cannot tell of the time before: frame 7 is damaged\./);
});

test("the past goes on through other parts of a run, but for what is another thing there", async () => {
  const [before, now] = [layoutOf(1, 200, 3, ["left"]), layoutOf(2, 200, 3, ["right"])];
  const read = (first, count, every) =>
    Array.from({ length: count }, (_, i) => {
      const frame = frameOf(first + i * every);
      frame.parts[0].seen.greatestForce = [7];
      return { frame, layout: first + i * every < 400 ? before : now };
    });
  const { past, graphs } = made({ index: 800, bytes: 200, read });
  past.app.session.layout = now;
  await past.fill();
  const { history } = graphs;
  assert.equal(history.count, 800);
  const [times, kinetic, force] = history.between(0, 9, ["kinetic", "force 0"]);
  assert.deepEqual([...new Set(kinetic)], [0]);
  times.forEach((time, i) => assert.equal(Number.isFinite(force[i]), time >= 4, `${time}`));
});
