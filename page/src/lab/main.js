// The lab: a rope of springs that runs in the page itself, to be changed, pulled and broken.

import { largestStep } from "./bounds.js";
import { Drawing } from "./draw.js";
import { follow } from "./hand.js";
import { METHODS, Rope } from "./kernel.js";
import { LITTLE, brief, energies, gravityAt, tautEnergy, tensions, told } from "./measures.js";
import { postRows, readPosts } from "./posts.js";
import { named } from "./named.js";
import { Probe, middle } from "./probe.js";
import { Resampler, Sound } from "../sound.js";
import { bridge } from "./bridge.js";
import { Strip } from "./strip.js";
import { Typed } from "./typed.js";
import { Values, scaled } from "./values.js";
import { Verdict } from "./verdict.js";
import { atMost, whyItBroke } from "./why.js";

/** @typedef {import("./kernel.js").Scene} Scene */
/** @typedef {import("./kernel.js").Method} Method */

const BUDGET = 11; // milliseconds of a picture for steps
const SAFE = 0.8; // of the largest stable step
const NOTE = 0.02; // seconds of the watch between points of the graphs
const ENERGIES = ["gravity", "elastic", "kinetic", "total"];

/** @param {string} id */
const find = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
/** @param {string} id */
const input = (id) => /** @type {HTMLInputElement} */ (find(id));
/** @param {string} id */
const choice = (id) => /** @type {HTMLSelectElement} */ (find(id));
/** @param {string} id */
const canvas = (id) => /** @type {HTMLCanvasElement} */ (find(id));

class Lab {
  /** @param {Scene[]} scenes */
  constructor(scenes) {
    this.scenes = scenes;
    this.drawing = new Drawing(canvas("rope"));
    this.energy = new Strip(
      canvas("energy"),
      ENERGIES.map((name) => ({ name, wide: name === "total" })),
      () => this.draw(),
    );
    this.fall = 0; // gravity's energy where the rope began, from which it counts [J]
    /** @type {number | undefined} */ this.step = undefined; // [s]
    this.since = this.count = 0; // when the steps got their length [s], and how many there were since
    this.taut = 0; // the elastic energy of the straight rope, from which that counts [J]
    const typed = new Typed(find("typed"));
    this.probe = new Probe(this, find, typed);
    this.sound = new Sound();
    const theme = matchMedia("(prefers-color-scheme: dark)");
    theme.onchange = () => this.tint(theme.matches);
    this.tint(theme.matches);
    this.values = new Values(find, typed, () => {
      this.apply();
      if (!this.playing) this.draw();
    });
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

  /** Take the colours of a theme. @param {boolean} dark */
  tint(dark) {
    this.drawing.tint(dark);
    find("ramp").style.backgroundImage = `linear-gradient(90deg, ${this.drawing.map.join(", ")})`;
    this.draw();
  }

  /** The scene that the address names behind its #, such as lessons.html#pendulum; else the first. */
  #named() {
    const found = named(
      this.scenes.map(({ name }) => name),
      location.hash,
    );
    choice("scene").value = String(found);
    return found;
  }

  /** Take a scene with its own values. @param {number} index */
  choose(index) {
    this.scene = this.scenes[index];
    find("about").textContent = this.scene.about;
    this.base = new Rope(this.scene);
    this.#offer(this.scene.posts.length > 0);
    this.values.choose(this.scene, this.base);
    this.probe.node = middle(this.base);
    this.restart();
    this.probe.choose(this.probe.node);
  }

  /** Show what only posts have, or hide it. @param {boolean} posts */
  #offer(posts) {
    find("posts").hidden = !posts;
    find("ratio").hidden = !posts;
    if (!posts && choice("quantity").value === "ratio") choice("quantity").value = "height";
  }

  /** Begin at time zero, with the values that the controls have. */
  restart() {
    const { scene } = this;
    if (!scene) return;
    this.rope = new Rope(scene);
    this.tension = new Float64Array(this.rope.n);
    this.largest = this.reached = 0;
    this.broken = false;
    this.owed = this.since = this.count = 0;
    find("broken").hidden = true;
    this.apply();
    const whole = scene.length.reduce((sum, one) => sum + one, 0);
    this.drawing.look(...this.plane());
    this.drawing.fit(this.rope, whole / scene.ropes.length);
    this.drawing.largest = 0;
    this.sound.restart();
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

  /** Bring the values to the rope, and say what they mean for its stability. */
  apply() {
    const { rope, base, scene } = this;
    const { now } = this.values;
    if (!rope || !base || !scene) return;
    if (rope.time > 0) this.verdict?.allow(rope, () => this.#change(rope, base, scene));
    else {
      this.#change(rope, base, scene);
      this.verdict = new Verdict(rope); // it begins with these values
    }
    [this.fall, this.taut] = [gravityAt(rope, base.x), tautEnergy(rope, base.x)];
    this.method = now.method;
    if (this.step !== now.step) [this.since, this.count] = [rope.time, 0];
    this.step = now.step;
    this.bound = largestStep(rope, this.method);
    this.#meter();
    if (rope.time > 0) return;
    for (const strip of [this.energy, this.probe.strip]) strip.clear(); // it begins with these values
    this.note();
  }

  /** Give a rope the values. @param {Rope} rope @param {Rope} base as the scene has it @param {Scene} scene */
  #change(rope, base, scene) {
    const { now, own } = this.values;
    for (let j = 0; j < rope.n - 1; j++) {
      rope.stiffness[j] = scaled(base.stiffness[j], own.k, now.k);
      const bare = base.stiffness[j] > 0 && base.axial[j] === 0; // which the gap between ropes is not
      if (own.c > 0 || bare) rope.vector[j] = scaled(base.vector[j], own.c, now.c);
      if (own.c > 0) rope.axial[j] = scaled(base.axial[j], own.c, now.c);
    }
    for (let i = 0; i < rope.n; i++) {
      rope.mass[i] = scaled(base.mass[i], own.m, now.m);
      if (rope.inverse[i] > 0) rope.inverse[i] = 1 / rope.mass[i]; // held ones have none
    }
    rope.gravity = scene.up.map((part) => -now.g * part + 0);
    rope.contact?.change(({ friction }) => scaled(friction, own.mu, now.mu), now.m / own.m);
    rope.renew();
  }

  #meter() {
    const [step, bound] = [this.step ?? 1, this.bound ?? 1];
    const share = step / bound;
    const kind = share > 1 ? "over" : share > 0.9 ? "near" : "well";
    find("needle").style.width = `${100 * Math.min(share / 1.25, 1)}%`;
    find("needle").className = `needle ${kind}`;
    const times = share < 1.005 ? "just" : `${Number(share.toPrecision(3))} times`;
    const limit = `the largest stable step is ${atMost(bound)}`;
    find("verdict").textContent =
      share > 1
        ? `Unstable: the step is ${times} too long; ${limit}.`
        : `Stable: ${Math.round(100 * share)} % of what holds; ${limit}.`;
  }

  #listen() {
    choice("scene").onchange = () => this.choose(Number(choice("scene").value));
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
      this.values.set({ step: Number((SAFE * (this.bound ?? 1e-3)).toPrecision(4)) });
      this.restart();
      this.play(true);
    };
    follow(canvas("rope"), this);
    const sized = new ResizeObserver(() => this.draw()); // else a paused picture is stretched
    for (const id of ["rope", "energy", "graph"]) sized.observe(canvas(id));
  }

  /** @param {boolean} on */
  play(on) {
    this.playing = on && !this.broken;
    find("play").textContent = this.playing ? "Pause" : "Play";
  }

  /** Take steps until there are enough, or it breaks. @param {number} steps */
  advance(steps) {
    const { rope, verdict } = this;
    if (!rope || !verdict || this.broken) return;
    const every = NOTE * Number(choice("pace").value);
    for (let i = 0; i < steps; i++) {
      const dt = this.step ?? 1e-3;
      const after = this.since + ++this.count * dt;
      verdict.watch(rope, () => rope.step(this.method ?? METHODS[0], dt, after));
      this.#peak(); // of every step, so that none is missed
      if (this.sound.on) this.#hear();
      if ((i & 7) === 7 || i === steps - 1) this.#look();
      if (this.broken) return;
      if (rope.time - (this.noted ?? 0) >= every * (1 - 1e-6)) this.note(); // as often on slow machines
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
    const { rope, verdict } = this;
    if (!rope || !verdict) return;
    const broke = verdict.judge(rope);
    if (!broke) {
      this.largest = this.reached; // a break's own tensions say nothing
      return;
    }
    this.broken = true;
    this.play(false);
    const [step, bound] = [this.step ?? 0, this.bound ?? 0];
    const method = this.method ?? METHODS[0];
    find("why").textContent = whyItBroke(rope, method, step, bound, verdict, broke);
    find("shorten").hidden = step <= bound;
    find("broken").hidden = false;
    find("broken").scrollIntoView({ block: "nearest" }); // on a phone
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
    if (!this.rope || !this.tension || this.broken) return; // a break would flatten what was before it
    tensions(this.rope, this.tension);
    const { kinetic, elastic, gravity } = energies(this.rope);
    const [high, taut] = [gravity - this.fall, elastic - this.taut];
    this.energy.add(this.rope.time, [high, taut, kinetic, high + taut + kinetic]);
    this.noted = this.rope.time;
    this.probe.note();
  }

  draw() {
    const { rope, tension, scene } = this;
    if (!rope || !tension || !scene) return;
    tensions(rope, tension);
    const now = this.broken ? NaN : Math.max(...tension.subarray(0, rope.n - 1), 0);
    const top = this.drawing.largest;
    if (!this.broken) this.drawing.largest = Math.max(now, 0.98 * top, LITTLE);
    const reading = this.broken ? null : readPosts(rope, tension);
    this.drawing.draw(rope, tension, scene.ropes, this.hover, this.probe.node, reading);
    this.#tell();
    this.probe.draw();
    find("state").textContent = `t = ${rope.time.toFixed(2)} s`;
    const numbers = [
      ["largest tension now", this.broken ? "none: it is broken" : told(now, "N")],
      ["largest tension so far", told(Math.max(this.largest ?? 0, now || 0), "N")],
      ...postRows(rope, reading, this.broken ?? false),
    ];
    find("numbers").replaceChildren(
      ...numbers.flatMap(([name, value]) => {
        const [term, text] = [document.createElement("dt"), document.createElement("dd")];
        [term.textContent, text.textContent] = [name, value];
        return [term, text];
      }),
    );
    find("hottest").textContent = told(this.drawing.largest, "N");
  }

  /** Draw the energies, and say what they are now, or were under the pointer. */
  #tell() {
    this.energy.draw();
    const point = this.energy.read() ?? this.energy.kept.at(-1);
    for (const [i, name] of ENERGIES.entries())
      find(`${name}-shown`).textContent = point ? brief(point.values[i]) : "";
    find("energy-time").textContent = this.energy.read() ? `at ${point?.t.toFixed(3)} s` : "";
  }
}

const scenes = JSON.parse(find("scenes").textContent ?? "[]");
const lab = new Lab(scenes);
// for tests and for the curious: the kernel itself
Object.assign(window, {
  ropewalkLab: { lab, scenes, Rope, largestStep, Resampler, bridge, tensions },
});
