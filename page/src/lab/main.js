// The lab: a rope of springs that runs in the page itself, to be changed, pulled and broken.

import { largestStep } from "./bounds.js";
import { Drawing } from "./draw.js";
import { follow } from "./hand.js";
import { METHODS, Rope } from "./kernel.js";
import { energies, isBroken, tensions } from "./measures.js";
import { Probe } from "./probe.js";
import { Resampler, Sound } from "../sound.js";
import { bridge } from "./bridge.js";
import { Strip } from "./strip.js";

/** @typedef {import("./kernel.js").Scene} Scene */
/** @typedef {import("./kernel.js").Method} Method */

const BUDGET = 11; // milliseconds of a picture for steps
const SAFE = 0.8; // of the largest stable step

/** @param {string} id */
const find = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** @param {string} id */
const input = (id) => /** @type {HTMLInputElement} */ (find(id));
/** @param {string} id */
const choice = (id) => /** @type {HTMLSelectElement} */ (find(id));
/** @param {string} id */
const canvas = (id) => /** @type {HTMLCanvasElement} */ (find(id));
/** @param {number} value @param {string} unit three figures and a prefix */
const told = (value, unit) => {
  const size = Math.abs(value);
  const [factor, prefix] = size >= 1e6 ? [1e6, "M"] : size >= 1e4 ? [1e3, "k"] : [1, ""];
  return `${Number((value / factor).toPrecision(3))} ${prefix}${unit}`;
};
/** @param {number} seconds */
const milliseconds = (seconds) => `${Number((1e3 * seconds).toPrecision(4))} ms`;

class Lab {
  /** @param {Scene[]} scenes */
  constructor(scenes) {
    this.scenes = scenes;
    this.drawing = new Drawing(canvas("rope"));
    this.energy = new Strip(canvas("energy"), [
      { name: "gravity" },
      { name: "elastic" },
      { name: "kinetic" },
      { name: "total", wide: true },
    ]);
    this.fall = 0; // gravity's energy at time zero, from which it counts [J]
    this.probe = new Probe(this, find);
    this.sound = new Sound();
    this.playing = false;
    this.owed = 0; // simulated time that the clock is ahead [s]
    /** @type {number | null} */ this.hover = null;
    this.last = 0;
    for (const [i, scene] of scenes.entries())
      choice("scene").add(new Option(scene.name, String(i)));
    this.#listen();
    this.choose(this.#named());
    requestAnimationFrame((now) => this.#picture(now));
  }

  /** The scene that the address names behind its #, such as lessons.html#pendulum; else the first. */
  #named() {
    const wanted = decodeURIComponent(location.hash.slice(1)).toLowerCase().replaceAll("-", " ");
    const found = this.scenes.findIndex(
      (scene) => wanted && scene.name.toLowerCase().includes(wanted),
    );
    choice("scene").value = String(Math.max(found, 0));
    return Math.max(found, 0);
  }

  /** Take a scene with its own values. @param {number} index */
  choose(index) {
    this.scene = this.scenes[index];
    find("about").textContent = this.scene.about;
    this.base = new Rope(this.scene);
    const own = METHODS.find((method) => method === this.scene?.method) ?? METHODS[0];
    choice("method").value = own;
    input("k").value = "0";
    input("c").value = "0";
    input("step").value = String(Math.log10(this.scene.step));
    input("g").value = String(Math.hypot(...this.scene.gravity));
    this.probe.node = (this.base.n - 1) >> 1;
    this.restart();
    this.probe.choose(this.probe.node);
  }

  /** Begin at time zero, with the values that the controls have. */
  restart() {
    const { scene } = this;
    if (!scene) return;
    this.rope = new Rope(scene);
    this.tension = new Float64Array(this.rope.n);
    this.largest = this.reached = 0;
    this.broken = false;
    this.owed = 0;
    find("broken").hidden = true;
    this.apply();
    const whole = scene.length.reduce((sum, one) => sum + one, 0);
    this.drawing.look(...this.plane());
    this.drawing.fit(this.rope, whole / scene.ropes.length);
    this.fall = energies(this.rope).gravity;
    this.energy.clear();
    this.sound.restart();
    this.probe.strip.clear();
    this.note();
    this.draw();
  }

  /** The two axes that show most: up, and across where the ropes extend.
   * @returns {[number[], number[]]} */
  plane() {
    const { up, x } = /** @type {Scene} */ (this.scene);
    const spans = x.map((row, k) => (1 - Math.abs(up[k])) * (Math.max(...row) - Math.min(...row)));
    const best = Math.max(...spans);
    const axis = best > 0 ? spans.indexOf(best) : up.findIndex((part) => Math.abs(part) < 0.5);
    return [[0, 1, 2].map((k) => (k === axis ? 1 : 0)), up];
  }

  /** Bring the values of the controls to the rope, and say what they mean for its stability. */
  apply() {
    const { rope, base, scene } = this;
    if (!rope || !base || !scene) return;
    const [k, c] = [10 ** Number(input("k").value), this.#friction()];
    for (let j = 0; j < rope.n - 1; j++) {
      rope.stiffness[j] = k * base.stiffness[j];
      rope.vector[j] = c * base.vector[j];
      rope.axial[j] = c * base.axial[j];
    }
    const pull = Number(input("g").value);
    rope.gravity = scene.up.map((part) => -pull * part + 0);
    rope.renew();
    this.method = /** @type {Method} */ (choice("method").value);
    this.step = 10 ** Number(input("step").value);
    this.bound = largestStep(rope, this.method);
    const live = base.stiffness.findIndex((value) => value > 0);
    const rubs = base.vector[live] + base.axial[live];
    find("k-shown").textContent = told(rope.stiffness[live] ?? 0, "N/m");
    find("c-shown").textContent = rubs ? told(c * rubs, "N s/m") : "none in this scene";
    find("step-shown").textContent = milliseconds(this.step);
    find("g-shown").textContent = `${pull.toFixed(2)} m/s²`;
    this.#meter();
  }

  /** @returns {number} the factor of the friction: none at the slider's left end */
  #friction() {
    const slider = input("c");
    return slider.value === slider.min ? 0 : 10 ** Number(slider.value);
  }

  #meter() {
    const [step, bound] = [this.step ?? 1, this.bound ?? 1];
    const share = step / bound;
    const kind = share > 1 ? "over" : share > 0.9 ? "near" : "well";
    find("needle").style.width = `${100 * Math.min(share / 1.25, 1)}%`;
    find("needle").className = `needle ${kind}`;
    const limit = `the largest stable step is ${milliseconds(bound)}`;
    find("verdict").textContent =
      share > 1
        ? `Unstable: the step is ${Number(share.toPrecision(3))} times too long; ${limit}.`
        : `Stable: ${Math.round(100 * share)} % of what holds; ${limit}.`;
  }

  #listen() {
    choice("scene").onchange = () => this.choose(Number(choice("scene").value));
    for (const id of ["k", "c", "step", "g"]) input(id).oninput = () => this.apply();
    choice("method").onchange = () => this.apply();
    input("sound").onchange = () => this.sound.turn(input("sound").checked);
    choice("tall").onchange = () => {
      this.drawing.tall = Number(choice("tall").value);
      this.draw();
    };
    find("play").onclick = () => this.play(!this.playing);
    find("once").onclick = () => {
      this.play(false);
      this.advance(1);
      this.note();
      this.draw();
    };
    onhashchange = () => this.choose(this.#named());
    for (const id of ["restart", "again"]) find(id).onclick = () => this.restart();
    find("shorten").onclick = () => {
      input("step").value = String(Math.log10(SAFE * (this.bound ?? 1e-3)));
      this.restart();
      this.play(true);
    };
    follow(canvas("rope"), this);
  }

  /** @param {boolean} on */
  play(on) {
    this.playing = on && !this.broken;
    find("play").textContent = this.playing ? "Pause" : "Play";
  }

  /** Take steps until there are enough, or it breaks. @param {number} steps */
  advance(steps) {
    const { rope } = this;
    if (!rope || this.broken) return;
    for (let i = 0; i < steps; i++) {
      rope.step(this.method ?? METHODS[0], this.step ?? 1e-3);
      this.#peak(); // of every step, so that none is missed
      if (this.sound.on) this.#hear();
      if ((i & 7) === 7 || i === steps - 1) this.#look();
      if (this.broken) return;
    }
  }

  #peak() {
    const { rope, tension } = this;
    if (!rope || !tension) return;
    tensions(rope, tension);
    for (let j = 0; j < rope.n - 1; j++)
      if (tension[j] > (this.reached ?? 0)) this.reached = tension[j];
  }

  #hear() {
    const { rope, tension, scene, step } = this;
    if (!rope || !tension || !scene || !step) return;
    const slow = Number(choice("pace").value); // slow motion sounds lower, as a tape does
    this.sound.hear(bridge(rope, tension, scene.up), step / slow);
  }

  #look() {
    const { rope } = this;
    if (!rope) return;
    if (!isBroken(rope)) {
      this.largest = this.reached; // a break's own tensions say nothing
      return;
    }
    this.broken = true;
    this.play(false);
    const [step, bound] = [this.step ?? 0, this.bound ?? 0];
    find("why").textContent =
      step > bound
        ? `After ${rope.time.toPrecision(3)} s. With this stiffness and mass a step may be at most ` +
          `${milliseconds(bound)}; it is ${milliseconds(step)}. In one step the springs push a node past where ` +
          "it should be, in the next they push it back farther still: the zigzag grows until nothing is left."
        : `After ${rope.time.toPrecision(3)} s. The step is short enough: something pulled the rope beyond ` +
          "ten times its length.";
    find("shorten").hidden = step <= bound;
    find("broken").hidden = false;
  }

  /** @param {number} now [ms] */
  #picture(now) {
    const passed = Math.min((now - this.last) / 1e3, 0.1);
    this.last = now;
    if (this.playing) {
      const step = this.step ?? 1e-3;
      this.owed += passed * Number(choice("pace").value);
      const until = performance.now() + BUDGET;
      while (this.owed >= step && !this.broken && performance.now() < until) {
        const steps = Math.min(Math.floor(this.owed / step), 16);
        this.advance(steps);
        this.owed -= steps * step;
      }
      this.owed = Math.min(this.owed, 0.1); // a machine that is too slow shows it slower
      this.note();
      this.sound.play();
      this.draw();
    }
    requestAnimationFrame((then) => this.#picture(then));
  }

  /** Add this moment to the graphs. */
  note() {
    if (!this.rope || !this.tension) return;
    tensions(this.rope, this.tension);
    const { kinetic, elastic, gravity } = energies(this.rope);
    const high = gravity - this.fall;
    this.energy.add(this.rope.time, [high, elastic, kinetic, high + elastic + kinetic]);
    this.probe.note();
  }

  draw() {
    const { rope, tension, scene } = this;
    if (!rope || !tension || !scene) return;
    tensions(rope, tension);
    const now = this.broken ? NaN : Math.max(...tension.subarray(0, rope.n - 1), 0);
    const top = this.drawing.largest;
    if (!this.broken) this.drawing.largest = Math.max(now, 0.98 * top, 1e-9);
    this.drawing.draw(rope, tension, scene.ropes, this.hover, this.probe.node);
    this.energy.draw();
    this.probe.draw();
    find("state").textContent = `t = ${rope.time.toFixed(2)} s`;
    const numbers = [
      ["largest tension now", this.broken ? "none: it is broken" : told(now, "N")],
      ["largest tension so far", told(Math.max(this.largest ?? 0, now || 0), "N")],
    ];
    find("numbers").replaceChildren(
      ...numbers.flatMap(([name, value]) => {
        const [term, text] = [document.createElement("dt"), document.createElement("dd")];
        [term.textContent, text.textContent] = [name, value];
        return [term, text];
      }),
    );
  }
}

const scenes = JSON.parse(find("scenes").textContent ?? "[]");
const lab = new Lab(scenes);
// for tests and for the curious: the kernel itself
Object.assign(window, {
  ropewalkLab: { lab, scenes, Rope, largestStep, Resampler, bridge, tensions },
});
