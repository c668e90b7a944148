import assert from "node:assert/strict";
import { afterEach, beforeEach, mock, test } from "node:test";

import { SocketSource } from "../src/source/socket.js";

const real = { WebSocket: globalThis.WebSocket, location: globalThis.location };
let sockets = [];

class Socket {
  static CONNECTING = 0;
  static OPEN = 1;
  constructor() {
    this.readyState = Socket.CONNECTING;
    sockets.push(this);
  }
}

beforeEach(() => {
  mock.timers.enable({ apis: ["setTimeout"] });
  sockets = [];
  globalThis.WebSocket = Socket;
  globalThis.location = { href: "http://127.0.0.1:8712/token/" };
});
afterEach(() => {
  mock.timers.reset();
  Object.assign(globalThis, real);
});

function opened({ mode = "live" } = {}) {
  const states = [];
  new SocketSource().open({ state: (...said) => states.push(said), message() {}, frame() {} });
  accept(mode);
  return states;
}

function accept(mode) {
  const socket = sockets.at(-1);
  socket.readyState = Socket.OPEN;
  socket.onopen();
  if (mode) socket.onmessage({ data: JSON.stringify({ type: "hello", mode }) });
}

function close(code) {
  sockets.at(-1).readyState = 3;
  sockets.at(-1).onclose({ code, reason: "" });
}

test("a lost connection says that the run goes on, and not of a server that does not answer", () => {
  const states = opened();
  close(1006);
  assert.deepEqual(states.at(-1), [
    "lost",
    "The connection to the server is lost; the run goes on there.",
  ]);
  mock.timers.tick(500);
  close(1006); // refused
  assert.equal(states.at(-1)[0], "lost");
  assert.match(states.at(-1)[1], /does not answer: it has ended, or is out of reach/);
  mock.timers.tick(1000);
  accept("live");
  assert.equal(states.at(-1)[0], "open");
});

for (const code of [1000, 1001, 1012])
  test(`a server that ends by ${code} is said to have ended, also while it is looked for`, () => {
    const states = opened();
    close(1006);
    mock.timers.tick(500);
    accept(null); // the server ends before it has said anything
    close(code);
    assert.deepEqual(states.at(-1), ["ended", "The server has ended."]);
    mock.timers.tick(2000);
    close(1006);
    assert.deepEqual(states.at(-1), ["ended", "The server has ended."]);
  });

test("what a server says as it ends is shown", () => {
  const states = opened();
  sockets[0].onmessage({ data: JSON.stringify({ type: "bye", text: "Saved." }) });
  close(1012);
  assert.deepEqual(states.at(-1), ["ended", "Saved."]);
});
