// What the page knows of the simulation: the last message of each kind, and commands with their answers.

import { Emitter } from "./emitter.js";
import { forget, layoutOf, numberOf, readFrame } from "./source/frame.js";

/** @typedef {import("./source/protocol.js").Source} Source */
/** @typedef {import("./source/replay.js").Run} Run */
/** @typedef {import("./source/protocol.js").Hello} Hello */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./source/protocol.js").Parameter} Parameter */
/** @typedef {import("./source/protocol.js").Preset} Preset */
/** @typedef {import("./source/protocol.js").Status} Status */
/** @typedef {import("./source/protocol.js").Stability} Stability */
/** @typedef {import("./source/protocol.js").Broken} Broken */
/** @typedef {import("./source/protocol.js").Done} Done */
/** @typedef {import("./source/protocol.js").Fault} Fault */
/** @typedef {import("./source/protocol.js").Obstacle} Obstacle */
/** @typedef {import("./source/frame.js").Frame} Frame */

/** @typedef {{hello: Hello, layout: Layout, parameters: Parameter[], presets: Preset[],
 *   status: Status, stability: Stability[], replay: Run, broken: Broken | null, frame: Frame,
 *   obstacles: {obstacles: Obstacle[]}, saved: {folder: string}, sound: {seconds: number, forces: number[]},
 *   exported: {name: string, url: string}, note: {text: string},
 *   bye: {text: string},
 *   error: Fault, connection: {state: string, text: string}}} Events */

/** @extends {Emitter<Events>} */
export class Session extends Emitter {
  /** @param {Source} source */
  constructor(source) {
    super();
    this.source = source;
    /** @type {Hello | null} */ this.hello = null;
    /** @type {Layout | null} */ this.layout = null;
    /** @type {Parameter[]} */ this.parameters = [];
    /** @type {Preset[]} */ this.presets = [];
    /** @type {Status | null} */ this.status = null;
    /** @type {Stability[]} */ this.stability = [];
    /** @type {Broken | null} */ this.broken = null;
    /** @type {Frame | null} */ this.frame = null;
    this.frames = 0;
    this.connection = "connecting";
    this.lastId = 0;
    this.pendingFrame = -1;
    this.resting = false;
    /** @type {Map<number, {resolve: (done: Done) => void, reject: (fault: Fault) => void}>} */
    this.waiting = new Map();
  }

  /** @param {Source} source that is played from now on; another one may go on telling of its connection */
  open(source = this.source) {
    this.source = source;
    source.open({
      message: (message) => this.take(message),
      frame: (buffer) => this.takeFrame(buffer),
      state: (state, text) => {
        this.connection = state;
        if (state !== "open") {
          const fault = /** @type {Fault} */ ({ type: "error", text: "The server is not there." });
          for (const { reject } of this.waiting.values()) reject(fault);
          this.waiting.clear();
        }
        this.emit("connection", { state, text });
      },
    });
  }

  /** Whether there is no server to answer, as the banner says. */
  get gone() {
    return ["ended", "lost", "full"].includes(this.connection);
  }

  /** Whether the server accepts a command. @param {string} type */
  can(type) {
    return this.hello?.can.includes(type) ?? false;
  }

  /** Send a command and forget it. @param {Record<string, any>} command */
  send(command) {
    if (this.can(command.type)) this.source.send(command);
  }

  /** Send a command; the promise ends with the answer, and fails with the server's fault.
   * @param {Record<string, any>} command @returns {Promise<Done>} */
  ask(command) {
    const id = ++this.lastId;
    return new Promise((resolve, reject) => {
      if (!this.can(command.type)) {
        reject({ type: "error", text: `This cannot be done here (${command.type})` });
        return;
      }
      this.waiting.set(id, { resolve, reject });
      this.source.send({ ...command, id });
    });
  }

  /** Send a command for its effect; a fault is shown to the user. @param {Record<string, any>} command */
  async tell(command) {
    if (this.gone) return false; // the banner says so
    try {
      await this.ask(command);
      return true;
    } catch (fault) {
      this.emit("error", /** @type {Fault} */ (fault));
      return false;
    }
  }

  /** @param {any} message */
  take(message) {
    switch (message.type) {
      case "hello":
        this.hello = message;
        break;
      case "layout":
        if (message.layout !== this.layout?.layout) this.frame = null; // written in the old layout
        this.layout = message;
        break;
      case "obstacles": // a hand moves one
        if (this.layout) this.layout.obstacles = message.obstacles;
        break;
      case "parameters":
        this.parameters = message.parameters;
        this.emit("parameters", this.parameters);
        return;
      case "presets":
        this.presets = message.presets;
        this.emit("presets", this.presets);
        return;
      case "status":
        this.status = message;
        if (!message.broken && this.broken) {
          this.broken = null;
          this.emit("broken", null);
        }
        break;
      case "stability":
        this.stability = message.variants;
        this.emit("stability", this.stability);
        return;
      case "broken":
        this.broken = message;
        break;
      case "done":
      case "error":
        this.answer(message);
        return;
    }
    this.emit(message.type, message);
  }

  /** @param {any} message */
  answer(message) {
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.type === "done") waiting?.resolve(message);
    else if (waiting) waiting.reject(message);
    else this.emit("error", message);
  }

  /** @param {ArrayBuffer} buffer */
  takeFrame(buffer) {
    this.pendingFrame = numberOf(buffer);
    if (!this.layout || layoutOf(buffer) !== this.layout.layout) {
      this.acknowledge();
      return;
    }
    const before = this.frame;
    this.frame = readFrame(buffer, this.layout);
    this.frames++;
    this.emit("frame", this.frame);
    if (before) forget(before);
  }

  /** The newest frame is used: the server may send on. Called once per animation frame; says so in every
   * second one, since a message takes the page as long as half of its drawing. */
  acknowledge() {
    this.resting = !this.resting;
    if (this.pendingFrame < 0 || this.resting) return;
    this.source.used(this.pendingFrame);
    this.pendingFrame = -1;
  }
}
