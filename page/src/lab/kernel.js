// The rope of springs, as the Python kernels have it: the same arithmetic in the same order, so that a thousand
// steps agree to rounding. Vectors are three rows of n numbers each; forces of segments have n + 1 columns,
// column j + 1 what segment j does to node j, so that no loop needs an edge case.

import { Contact } from "./contact.js";

/** @typedef {{node: number, origin: number[], velocity: number[], start: number, stop: number,
 *   release: number | null}} Anchor */
/** @typedef {{name: string, about: string, up: number[], gravity: number[], step: number, method: string,
 *   x: number[][], v: number[][], mass: number[], length: number[], stiffness: number[],
 *   vector: number[], axial: number[], slack: boolean[], anchors: Anchor[], ropes: number[][],
 *   posts: import("./solids.js").Post[], lines: import("./grips.js").Line[]}} Scene */
/** @typedef {"semi-implicit-euler" | "verlet" | "rk4"} Method */

/** @type {Method[]} */
export const METHODS = ["semi-implicit-euler", "verlet", "rk4"];

/** @param {number} n */
const rows = (n) => [new Float64Array(n), new Float64Array(n), new Float64Array(n)];

/** @param {Float64Array[]} from @param {Float64Array[]} to */
const copy = (from, to) => from.forEach((row, k) => to[k].set(row));

export class Rope {
  /** @param {Scene} scene */
  constructor(scene) {
    const n = scene.mass.length;
    this.n = n;
    this.time = 0;
    this.middle = 0; // of the present piece of a step [s]
    this.ropes = scene.ropes;
    this.first = 0; // of the nodes that are stepped at present
    this.last = n - 1;
    this.gravity = [...scene.gravity];
    this.x = scene.x.map((row) => Float64Array.from(row));
    this.v = scene.v.map((row) => Float64Array.from(row));
    this.mass = Float64Array.from(scene.mass);
    this.length = Float64Array.from(scene.length);
    this.stiffness = Float64Array.from(scene.stiffness);
    this.vector = Float64Array.from(scene.vector);
    this.axial = Float64Array.from(scene.axial);
    this.slack = scene.slack;
    this.anchors = scene.anchors.map((anchor) => ({ ...anchor, held: true }));
    this.inverse = this.mass.map((m) => 1 / m);
    for (const anchor of this.anchors) this.inverse[anchor.node] = 0;
    this.a = rows(n);
    this.pull = rows(n + 1);
    this.friction = rows(n + 1);
    this.xs = rows(n);
    this.vs = rows(n);
    this.old = rows(n);
    this.dx = rows(n);
    this.dv = rows(n);
    /** A node that is led by hand: where it is, where to, and how fast at most [m/s].
     * @type {{node: number, at: number[], to: number[], speed: number} | null} */
    this.hand = null;
    this.contact = scene.posts?.length ? new Contact(this, scene.posts, scene.lines) : null;
    this.renew();
  }

  /** Evaluate the accelerations at the state itself, after something was changed. */
  renew() {
    this.accelerate(this.x, this.v, this.a);
  }

  /** Write every node's acceleration [m/s^2]. @param {Float64Array[]} x @param {Float64Array[]} v
   * @param {Float64Array[]} a @param {number} [since] the last step [s] */
  accelerate(x, v, a, since = 0) {
    const [x0, x1, x2] = x;
    const [v0, v1, v2] = v;
    const [e0, e1, e2] = this.pull;
    const [c0, c1, c2] = this.friction;
    for (let j = this.first; j < this.last; j++) {
      const dx = x0[j + 1] - x0[j];
      const dy = x1[j + 1] - x1[j];
      const dz = x2[j + 1] - x2[j];
      const square = dx * dx + dy * dy + dz * dz;
      const r = Math.sqrt(square);
      const loose = this.slack[j] && r < this.length[j];
      const tension = loose ? 0 : this.stiffness[j] * (r - this.length[j]);
      const pull = r > 0 ? tension / r : 0;
      e0[j + 1] = pull * dx;
      e1[j + 1] = pull * dy;
      e2[j + 1] = pull * dz;
      const ux = v0[j + 1] - v0[j];
      const uy = v1[j + 1] - v1[j];
      const uz = v2[j + 1] - v2[j];
      const c = loose ? 0 : this.vector[j];
      const rate = ux * dx + uy * dy + uz * dz;
      const along = square > 0 && !loose ? (this.axial[j] * rate) / square : 0;
      c0[j + 1] = c * ux + along * dx;
      c1[j + 1] = c * uy + along * dy;
      c2[j + 1] = c * uz + along * dz;
    }
    for (let k = 0; k < 3; k++) {
      const [e, c, out, g] = [this.pull[k], this.friction[k], a[k], this.gravity[k]];
      for (let i = this.first; i <= this.last; i++) {
        const w = this.inverse[i];
        out[i] = (e[i + 1] + c[i + 1] - (e[i] + c[i])) * w + (w > 0 ? g : 0);
      }
    }
    this.contact?.accelerate(x, v, a, since);
  }

  /** Whether an anchor holds one of the nodes that are stepped at present.
   * @param {{node: number, held: boolean}} anchor */
  #steps({ node, held }) {
    return held && this.first <= node && node <= this.last;
  }

  /** Put the held nodes where they are at a time [s]; they move or not as in the middle of the present piece.
   * @param {number} time @param {Float64Array[]} x @param {Float64Array[]} v */
  place(time, x, v) {
    for (const anchor of this.anchors) {
      if (!this.#steps(anchor)) continue;
      const gone = Math.min(Math.max(time - anchor.start, 0), anchor.stop - anchor.start);
      const moves = anchor.start <= this.middle && this.middle < anchor.stop;
      for (let k = 0; k < 3; k++) {
        x[k][anchor.node] = anchor.origin[k] + anchor.velocity[k] * gone;
        v[k][anchor.node] = moves ? anchor.velocity[k] : 0;
      }
    }
    if (this.hand) {
      for (let k = 0; k < 3; k++) {
        x[k][this.hand.node] = this.hand.at[k];
        v[k][this.hand.node] = 0;
      }
    }
  }

  /** Take one step [s], with Verlet and Runge-Kutta in pieces where an anchor begins or ends to move, or lets go.
   * @param {Method} method @param {number} dt
   * @param {number} [after] the time at its end, where that is known better than as a sum */
  step(method, dt, after = this.time + dt) {
    this.#lead(dt);
    if (method === "semi-implicit-euler") {
      this.middle = after; // of order one: its steps are not cut
      this.#swing(dt, after);
      this.time = after;
      this.#release(dt);
    } else this.#each(method, dt, after);
  }

  /** Let every rope take the step by itself, so that the anchors of one cut no other's.
   * @param {Method} method @param {number} dt @param {number} after */
  #each(method, dt, after) {
    const begin = this.time;
    for (const [first, last] of this.ropes) {
      [this.first, this.last, this.time] = [first, last, begin];
      this.#pieces(method, dt, after);
      this.#release(dt);
    }
    [this.first, this.last] = [0, this.n - 1];
  }

  /** Let go of the anchors whose time has come. @param {number} dt */
  #release(dt) {
    for (const anchor of this.anchors) {
      if (
        this.#steps(anchor) &&
        anchor.release !== null &&
        anchor.release <= this.time + 1e-6 * dt
      ) {
        anchor.held = false;
        this.inverse[anchor.node] = 1 / this.mass[anchor.node];
        this.#let(anchor.node);
      }
    }
  }

  /** Let a node that was held go with the forces of the step that ends. @param {number} i */
  #let(i) {
    for (let k = 0; k < 3; k++) this.a[k][i] = this.force(i, k) * this.inverse[i] + this.gravity[k];
  }

  /** What springs, friction and posts do to a node along an axis, where they were last evaluated [N].
   * @param {number} i @param {number} k */
  force(i, k) {
    const [e, c] = [this.pull[k], this.friction[k]];
    return e[i + 1] + c[i + 1] - (e[i] + c[i]) + (this.contact?.force[k][i] ?? 0);
  }

  /** Move the hand towards where it is to be, no faster than it can. @param {number} dt */
  #lead(dt) {
    if (!this.hand) return;
    const { at, to, speed } = this.hand;
    const away = Math.hypot(...to.map((value, k) => value - at[k]));
    const share = away > speed * dt ? (speed * dt) / away : 1;
    for (let k = 0; k < 3; k++) at[k] += share * (to[k] - at[k]);
    this.contact?.keepOut(at, this.hand.node);
  }

  /** @param {Method} method @param {number} dt @param {number} after */
  #pieces(method, dt, after) {
    const begin = this.time;
    const cuts = this.anchors // of those that have let go, too, as in Python
      .filter(({ node }) => this.first <= node && node <= this.last)
      .flatMap(({ start, stop, release }) => [start, stop, release ?? -1])
      .filter((t) => t > begin + 1e-6 * dt && t < after - 1e-6 * dt)
      .sort((a, b) => a - b);
    for (const end of [...cuts, after]) {
      const h = end === after && !cuts.length ? dt : end - this.time;
      this.#jump(0.5 * (this.time + end), this.#isKink(this.time, dt));
      if (method === "verlet") this.#verlet(h, end);
      else this.#rungeKutta(h, end);
      this.time = end;
      this.#release(dt);
    }
  }

  /** Whether an anchor of the present ropes begins or ends to move at a time [s], or lets go.
   * @param {number} time @param {number} dt */
  #isKink(time, dt) {
    return this.anchors.some(
      ({ node, start, stop, release }) =>
        this.first <= node &&
        node <= this.last &&
        [start, stop, release ?? 0].some((t) => t > 0 && Math.abs(t - time) <= 1e-6 * dt),
    );
  }

  /** Begin a piece: an anchor that begins or ends to move has its new velocity from here on.
   * @param {number} middle time of the piece's middle [s] @param {boolean} kink whether it begins at one */
  #jump(middle, kink) {
    this.middle = middle;
    let jumped = kink && this.contact !== null; // posts go on from what they remember of it
    for (const anchor of this.anchors) {
      if (!this.#steps(anchor)) continue;
      const moves = anchor.start < middle && middle < anchor.stop;
      for (let k = 0; k < 3; k++) {
        const now = moves ? anchor.velocity[k] : 0;
        jumped ||= this.v[k][anchor.node] !== now;
        this.v[k][anchor.node] = now;
      }
    }
    if (jumped) this.renew(); // Verlet begins with the accelerations that the step before ended with
  }

  /** Semi-implicit Euler: velocity first, then place with it. @param {number} dt @param {number} after */
  #swing(dt, after) {
    this.contact?.begin();
    this.accelerate(this.x, this.v, this.a);
    this.contact?.weigh(1);
    for (let k = 0; k < 3; k++) {
      const [x, v, a] = [this.x[k], this.v[k], this.a[k]];
      for (let i = this.first; i <= this.last; i++) {
        const now = v[i] + dt * a[i];
        v[i] = now;
        x[i] += dt * now;
      }
    }
    this.#end(after, dt);
  }

  /** Velocity Verlet with a predicted velocity for friction. @param {number} dt @param {number} after */
  #verlet(dt, after) {
    this.contact?.begin();
    this.contact?.weigh(0.5);
    copy(this.a, this.old);
    for (let k = 0; k < 3; k++) {
      const [x, v, a, guess] = [this.x[k], this.v[k], this.a[k], this.vs[k]];
      for (let i = this.first; i <= this.last; i++) {
        guess[i] = v[i] + dt * a[i];
        x[i] += dt * v[i];
        x[i] += 0.5 * dt * dt * a[i];
      }
    }
    this.place(after, this.x, this.vs);
    this.accelerate(this.x, this.vs, this.a, dt);
    this.contact?.weigh(0.5);
    for (let k = 0; k < 3; k++) {
      const [v, a, old] = [this.v[k], this.a[k], this.old[k]];
      for (let i = this.first; i <= this.last; i++) v[i] += 0.5 * dt * (old[i] + a[i]);
    }
    this.#end(after, dt);
  }

  /** The classical Runge-Kutta method. @param {number} dt @param {number} after */
  #rungeKutta(dt, after) {
    const shares = [0, 0.5, 0.5, 1];
    const weights = [1 / 6, 1 / 3, 1 / 3, 1 / 6];
    const { xs, vs, a, dx, dv } = this;
    for (const row of [...dx, ...dv]) row.fill(0);
    this.contact?.begin();
    for (let s = 0; s < 4; s++) {
      const [c, b] = [dt * shares[s], dt * weights[s]];
      for (let k = 0; k < 3; k++) {
        const [x, v, X, V, A] = [this.x[k], this.v[k], xs[k], vs[k], a[k]];
        for (let i = this.first; i <= this.last; i++) {
          X[i] = s ? x[i] + c * V[i] : x[i];
          V[i] = s ? v[i] + c * A[i] : v[i];
        }
      }
      if (s) this.place(s === 3 ? after : this.time + c, xs, vs);
      this.accelerate(xs, vs, a, c);
      this.contact?.weigh(weights[s]);
      for (let k = 0; k < 3; k++) {
        for (let i = this.first; i <= this.last; i++) {
          dx[k][i] += b * vs[k][i];
          dv[k][i] += b * a[k][i];
        }
      }
    }
    for (let k = 0; k < 3; k++) {
      for (let i = this.first; i <= this.last; i++) {
        this.x[k][i] += dx[k][i];
        this.v[k][i] += dv[k][i];
      }
    }
    this.#end(after, dt);
  }

  /** End a step, or a piece of one. @param {number} after @param {number} dt */
  #end(after, dt) {
    this.place(after, this.x, this.v);
    this.contact?.end(dt);
  }
}
