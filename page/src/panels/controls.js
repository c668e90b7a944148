// Run controls: play, step, reset, speed, the clock and the reached real-time factor; seeking in a replay.

import { figures } from "../view/range.js";
import { button, h, icon } from "./dom.js";
import { Hearing } from "./hearing.js";

/** @typedef {import("../session.js").Session} Session */

const CLOCK = 100; // ms between two changes of the clock while time goes on: faster ones cannot be read
const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 4];

/** @param {number} speed */
export const speedText = (speed) =>
  speed >= 0.995 ? `${figures(speed)}×` : `1/${figures(1 / speed)}×`;

export class Controls {
  /** @param {Session} session @param {HTMLElement} host @param {() => void} toggleGraphs */
  constructor(session, host, toggleGraphs) {
    this.session = session;
    this.reset = button("reset", "Reset to time zero", () => this.doReset(), {
      key: "R",
      id: "reset",
    });
    this.undo = button("undo", "Undo", () => this.doUndo(), { id: "undo" });
    this.play = button("play", "Play", () => this.toggle(), {
      key: "space",
      id: "play",
      kind: "main",
    });
    this.step = button("step", "One step", () => this.doStep(), { key: "full stop", id: "step" });
    this.clock = h("output", { id: "clock", title: "Simulated time" }, "0.00 s");
    this.speed = h("input", {
      type: "range",
      id: "speed",
      min: "0",
      max: String(SPEEDS.length - 1),
      step: "1",
      "aria-label": "Speed",
      oninput: () => this.setSpeed(),
    });
    this.speedText = h("output", { id: "speed-text" }, "1×");
    this.reached = h("output", { id: "realtime", className: "faint" }, "");
    this.seek = h("input", {
      type: "range",
      id: "seek",
      min: "0",
      max: "1",
      step: "any",
      "aria-label": "Time in the recording",
      oninput: () => this.doSeek(),
    });
    this.graphs = button("graph", "Graphs", toggleGraphs, {
      words: "Graphs",
      key: "G",
      id: "toggle-graphs",
    });
    this.hearing = new Hearing(session);
    this.seeking = 0;
    this.resetting = false;
    this.shown = -Infinity; // when the clock was last changed [ms]
    host.append(
      h("div", { className: "group" }, this.reset, this.undo, this.play, this.step),
      this.clock,
      this.seek,
      h(
        "label",
        { className: "speed", title: "Speed, as a part of real time" },
        "Speed",
        this.speed,
        this.speedText,
      ),
      this.reached,
      h("span", { className: "gap" }),
      this.hearing.button,
      this.graphs,
    );
    session.on("hello", () => this.refresh());
    session.on("status", () => this.refresh());
    session.on("connection", () => this.refresh());
    session.on("frame", (frame) => this.showTime(frame.time));
    this.refresh();
  }

  refresh() {
    const { session } = this;
    const { status } = session;
    this.play.hidden = !session.can("play");
    this.step.hidden = !session.can("step");
    this.reset.hidden = !session.can("reset");
    this.undo.hidden = !session.can("undo");
    const label = /** @type {HTMLElement} */ (this.speed.parentElement);
    label.hidden = !session.can("speed");
    this.seek.hidden = !session.can("seek") || !status?.duration;
    if (!status) return;
    if (!status.playing && session.frame) this.showTime(session.frame.time);
    const undo = status.undo ? `Undo ${status.undo}` : "Nothing to undo";
    this.undo.disabled = session.gone || !status.undo;
    this.undo.title = `${undo} (Ctrl+Z)`;
    this.undo.setAttribute("aria-label", undo);
    this.reset.disabled = this.speed.disabled = session.gone;
    this.play.disabled = session.gone || status.broken;
    this.step.disabled = session.gone || status.broken || status.playing;
    const name = status.playing ? "pause" : "play";
    if (this.play.dataset.shows !== name) {
      this.play.dataset.shows = name;
      this.play.replaceChildren(icon(name, name === "play"));
      const title = status.playing ? "Pause" : "Play";
      this.play.title = `${title} (space)`;
      this.play.setAttribute("aria-label", title);
    }
    if (document.activeElement !== this.speed) this.speed.value = String(nearest(status.speed));
    this.speedText.textContent = speedText(status.speed);
    const playing = status.playing && !session.gone;
    this.reached.textContent = playing ? reachedText(status.realtime) : "paused";
    this.reached.classList.toggle("slow", status.slow);
    this.reached.title = status.text || "Simulated time per real time, over the last half second";
    if (status.duration) this.seek.max = String(status.duration);
  }

  /** @param {number} time */
  showTime(time) {
    const now = performance.now();
    if (now - this.shown >= CLOCK || !this.session.status?.playing) {
      this.shown = now;
      const text = `${time.toFixed(2)} s`;
      if (this.clock.textContent !== text) this.clock.textContent = text;
    }
    if (!this.seek.hidden && document.activeElement !== this.seek) this.seek.value = String(time);
  }

  toggle() {
    const { status } = this.session;
    if (!status || status.broken || !this.session.can("play")) return;
    this.session.tell({ type: status.playing ? "pause" : "play" });
  }

  async doStep() {
    const { status } = this.session;
    if (!status || status.broken || !this.session.can("step")) return;
    if (status.playing) await this.session.tell({ type: "pause" });
    else await this.session.tell({ type: "step" });
  }

  /** A second press is the same reset: to look for rest may take some seconds. */
  async doReset() {
    if (!this.session.can("reset") || this.resetting) return;
    this.resetting = true;
    await this.session.tell({ type: "reset" });
    this.resetting = false;
  }

  doUndo() {
    if (!this.session.status?.undo || !this.session.can("undo")) return;
    this.undoing();
    this.session.tell({ type: "undo" });
  }

  /** Called before anything is undone. */
  undoing() {}

  setSpeed() {
    const value = SPEEDS[Number(this.speed.value)];
    this.speedText.textContent = speedText(value);
    this.session.tell({ type: "speed", value });
  }

  doSeek() {
    cancelAnimationFrame(this.seeking);
    this.seeking = requestAnimationFrame(() => {
      this.session.send({ type: "seek", time: Number(this.seek.value) });
    });
  }
}

/** @param {number | null} realtime null: not measured yet */
const reachedText = (realtime) => (realtime === null ? "" : `reached ${figures(realtime)}×`);

/** @param {number} speed */
function nearest(speed) {
  const away = SPEEDS.map((value) => Math.abs(Math.log(value / speed)));
  return away.indexOf(Math.min(...away));
}
