// Keys as in NeHe's lesson: arrows, Home and End move the first anchor at 3 m/s; more for other anchors.

import { length, plus, times } from "../view/vector.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {import("../view/camera.js").Camera} Camera */
/** @typedef {import("../view/vector.js").Vector} Vector */

const SPEED = 3; // m/s, as in the lesson

// Left, right, up, down, to the back, to the front: by the key's place on the keyboard.
export const HANDS = [
  ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"],
  ["KeyA", "KeyD", "KeyW", "KeyS", "KeyQ", "KeyE"],
  ["KeyJ", "KeyL", "KeyI", "KeyK", "KeyU", "KeyO"],
];

export class Keys {
  /** @param {Session} session @param {Camera} camera
   * @param {Record<string, () => void>} shortcuts by `event.key`, in lower case */
  constructor(session, camera, shortcuts) {
    this.session = session;
    this.camera = camera;
    this.shortcuts = shortcuts;
    /** @type {Set<string>} */ this.held = new Set();
    /** @type {Map<number, string>} anchors that move, by hand */ this.moving = new Map();
    addEventListener("keydown", (event) => this.press(event));
    addEventListener("keyup", (event) => this.lift(event.code));
    addEventListener("blur", () => this.releaseAll());
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) this.releaseAll();
    });
    document.addEventListener("click", giveBack);
    session.on("connection", () => this.forget());
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    if (takesKey(event)) return;
    if (event.ctrlKey || event.metaKey || event.altKey) {
      const undo = !event.altKey && !event.shiftKey && event.key.toLowerCase() === "z";
      if (undo && this.shortcuts.undo) {
        event.preventDefault();
        this.shortcuts.undo();
      }
      return;
    }
    const hand = HANDS.findIndex((codes) => codes.includes(event.code));
    if (hand >= 0 && this.anchor(hand) !== null && this.session.can("move")) {
      event.preventDefault();
      if (event.repeat || this.held.has(event.code)) return;
      this.held.add(event.code);
      this.sendHand(hand);
      return;
    }
    const shortcut = this.shortcuts[event.key.toLowerCase()];
    if (!shortcut) return;
    if (event.key === " " && inButton(event.target)) return; // the space bar presses that button
    if (event.key !== "Escape") event.preventDefault(); // it closes windows, too
    if (!event.repeat || event.key === ".") shortcut();
  }

  /** @param {string} code */
  lift(code) {
    if (!this.held.delete(code)) return;
    this.sendHand(HANDS.findIndex((codes) => codes.includes(code)));
  }

  releaseAll() {
    this.held.clear();
    for (const hand of [...this.moving.keys()]) this.sendHand(hand);
  }

  /** The server has released them already. */
  forget() {
    this.held.clear();
    this.moving.clear();
  }

  /** The anchor a hand moves: of those that hold, in the scene's order.
   * @param {number} hand @returns {string | null} */
  anchor(hand) {
    const anchors = this.session.layout?.variants[0].anchors ?? [];
    const part = this.session.frame?.parts[0];
    const holding = anchors.filter((_, i) => !part || part.anchors[10 * i + 9] > 0.5);
    return holding[hand]?.name ?? null;
  }

  /** @param {number} hand */
  sendHand(hand) {
    const pressed = HANDS[hand].map((code) => (this.held.has(code) ? 1 : 0));
    const anchor = this.moving.get(hand) ?? this.anchor(hand);
    if (anchor === null) return;
    const [left, right, up, down, back, front] = pressed;
    const { camera } = this;
    /** @type {Vector} */
    let way = times(camera.first, right - left);
    way = plus(way, camera.up, up - down);
    way = plus(way, camera.second, back - front);
    const size = length(way);
    const velocity = size > 0 ? times(way, SPEED / size) : [0, 0, 0];
    if (size > 0) this.moving.set(hand, anchor);
    else this.moving.delete(hand);
    this.session.send({ type: "move", anchor, velocity });
  }
}

/** After a press with the mouse the keys are the rope's again, not the button's or slider's.
 * @param {MouseEvent} event */
function giveBack(event) {
  const { target } = event;
  if (event.detail === 0 || !(target instanceof Element)) return; // a press by key
  const slider = target instanceof HTMLInputElement && ["range", "checkbox"].includes(target.type);
  if (slider) target.blur();
  else target.closest("button")?.blur();
}

/** Whether what is in focus takes a key for itself; a slider takes only those that move it.
 * @param {KeyboardEvent} event */
function takesKey({ target, code }) {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) {
    if (target.type === "range") return /^(Arrow|Page|Home|End)/.test(code);
    return !["checkbox", "radio", "button"].includes(target.type);
  }
  return target.isContentEditable || ["SELECT", "TEXTAREA"].includes(target.tagName);
}

/** @param {EventTarget | null} target */
function inButton(target) {
  return (
    target instanceof HTMLElement && target.closest("button, summary, [role=menuitem]") !== null
  );
}
