// The hand: a node that the pointer leads.

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {{rope?: Rope, drawing: import("./draw.js").Drawing, hover: number | null, playing: boolean,
 *   broken?: boolean, probe: import("./probe.js").Probe, plane(): [number[], number[]], play(on: boolean): void,
 *   draw(): void}} Lab */

const REACH = 40; // pixels from a node at which it can be taken
const STILL = 6; // pixels that a pointer moves at most in a click
const SPEED = 0.7; // widths of the drawing that a hand moves in a second, at most
const PRESS = 0.03; // widths of the drawing that a press of a key pulls
const WAYS = /** @type {Record<string, [number, number]>} */ ({
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowDown: [0, -1],
  ArrowUp: [0, 1],
});

/** Let the pointer take, lead and let go of nodes. @param {HTMLCanvasElement} board @param {Lab} lab */
export function follow(board, lab) {
  /** @param {PointerEvent} event @returns {[number, number]} */
  const at = (event) => {
    const [ratio, box] = [devicePixelRatio || 1, board.getBoundingClientRect()];
    return [ratio * (event.clientX - box.left), ratio * (event.clientY - box.top)];
  };
  /** @param {PointerEvent} event */
  const look = (event) => {
    if (!lab.rope) return;
    const { node, away } = lab.drawing.nearest(lab.rope, ...at(event));
    lab.hover = away < REACH * (devicePixelRatio || 1) ? node : null;
  };
  /** Where a node was pressed that is neither pulled nor let go yet.
   * @type {{x: number, y: number, node: number} | null} */
  let pressed = null;
  board.onpointermove = (event) => {
    const still =
      pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) <= STILL;
    if (pressed && !still) {
      if (lab.rope && !lab.broken) take(lab, lab.rope, pressed.node);
      pressed = null;
    }
    if (lab.rope?.hand) lead(lab, lab.rope, at(event));
    else look(event);
    if (!lab.playing) lab.draw();
  };
  board.onpointerdown = (event) => {
    look(event); // a finger has not moved before
    if (lab.hover === null) return;
    pressed = { x: event.clientX, y: event.clientY, node: lab.hover };
    board.setPointerCapture(event.pointerId);
  };
  board.onpointerup = board.onpointercancel = () => {
    if (pressed) lab.probe.choose(pressed.node); // a click measures, so that it does not disturb
    pressed = null;
    release(lab.rope);
  };
  board.onkeydown = (event) => {
    const { altKey, ctrlKey, metaKey } = event;
    if (altKey || ctrlKey || metaKey || !press(lab, event.key, event.shiftKey)) return;
    event.preventDefault(); // the page does not scroll
    if (!lab.playing) lab.draw();
  };
}

/** What a key does on the drawing: choose a node, pull it, let go, play. @param {Lab} lab @param {string} key
 * @param {boolean} shift @returns {boolean} whether it did something */
function press(lab, key, shift) {
  const { rope, probe } = lab;
  if (!rope) return false;
  const way = WAYS[key];
  if (key === " ") lab.play(!lab.playing);
  else if (key === "Enter" || key === "Escape") release(rope);
  else if (way && shift) pull(lab, rope, way);
  else if (way && way[0]) probe.choose(probe.node + way[0]);
  else return false;
  return true;
}

/** Pull the measured node on. @param {Lab} lab @param {Rope} rope @param {[number, number]} way */
function pull(lab, rope, [right, high]) {
  if (lab.broken) return;
  if (rope.hand?.node !== lab.probe.node) {
    release(rope);
    take(lab, rope, lab.probe.node);
  }
  if (!rope.hand) return;
  const [across, up] = lab.plane();
  const far = PRESS * (lab.drawing.box.right - lab.drawing.box.left);
  rope.hand.to = rope.hand.to.map((x, k) => x + far * (right * across[k] + high * up[k]));
}

/** @param {Lab} lab @param {Rope} rope @param {number} node */
function take(lab, rope, node) {
  if (rope.anchors.some((anchor) => anchor.held && anchor.node === node)) return;
  const at = rope.x.map((row) => row[node]);
  const { left, right } = lab.drawing.box;
  rope.inverse[node] = 0;
  rope.hand = { node, at, to: [...at], speed: SPEED * (right - left) };
  lab.play(true); // else nothing would follow the hand
}

/** Lead the node in hand to a pixel, in the plane that is seen. @param {Lab} lab @param {Rope} rope
 * @param {[number, number]} pixel */
function lead(lab, rope, pixel) {
  if (!rope.hand) return;
  const [across, up] = lab.plane();
  const [x, y] = lab.drawing.place(...pixel);
  const deep = rope.hand.to.map((value, k) => (across[k] || up[k] ? 0 : value));
  rope.hand.to = deep.map((value, k) => value + across[k] * x + up[k] * y);
}

/** @param {Rope | undefined} rope */
function release(rope) {
  if (!rope?.hand) return;
  rope.inverse[rope.hand.node] = 1 / rope.mass[rope.hand.node];
  rope.hand = null;
  rope.renew();
}
