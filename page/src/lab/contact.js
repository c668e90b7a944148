// Posts that nodes touch, with Coulomb friction that sticks, as the Python `contact` has it: the same arithmetic in
// the same order. A post does not move. What is remembered of the last step is every node's friction force.

import { closing } from "./closing.js";
import { HARD, SKIN, gripOf, squeeze } from "./grips.js";
import { MOVES, pullsAhead, tilted, turnedBy } from "./polygon.js";
import { probe } from "./solids.js";

/** @typedef {import("./kernel.js").Rope} Rope */
/** @typedef {import("./solids.js").Post} Post */
/** @typedef {import("./grips.js").Line} Line */
/** @typedef {import("./grips.js").Grip & {post: Post, friction: number, spring: Float64Array[], slide: Float64Array,
 *   grows: Float64Array, push: Float64Array, k: Float64Array, c: Float64Array, near: Uint8Array}} Hold what a post is
 *   to all nodes: the friction spring's force [N], the coefficient where the node turns and its rate [1/s], what
 *   presses [N], the springs' stiffness [N/m], the damper [N s/m], whether a step may touch it */

const DEEPEST = 0.75; // depth over the thinnest from which it counts as going through

/** @param {number} n */
const rows = (n) => [new Float64Array(n), new Float64Array(n), new Float64Array(n)];

export class Contact {
  /** @param {Rope} rope @param {Post[]} posts @param {Line[]} lines */
  constructor(rope, posts, lines) {
    const n = rope.n;
    this.rope = rope;
    this.lines = lines;
    this.thickness = new Float64Array(n);
    this.skin = new Float64Array(n);
    this.reach = new Float64Array(n); // farther off than a segment is long no step touches [m]
    for (const { first, last, thickness, diameter, segment } of lines) {
      this.reach.fill(thickness + segment, first, last + 1);
      this.thickness.fill(thickness, first, last + 1);
      this.skin.fill(SKIN * diameter, first, last + 1);
    }
    this.force = rows(n);
    this.mean = rows(n); // of the step [N]
    this.before = rows(n); // velocity as it begins
    this.place = rows(n); // as the last step ended
    this.work = this.first = 0; // of all posts so far, and what they had stored as it began and got by changes [J]
    this.found = new Float64Array(9); // what `probe` writes
    this.squeezed = new Float64Array(3);
    /** @type {Hold[]} */ this.holds = posts.map((post) => ({
      post,
      friction: post.friction,
      spring: rows(n),
      slide: new Float64Array(n),
      grows: new Float64Array(n),
      push: new Float64Array(n),
      k: new Float64Array(n),
      c: new Float64Array(n),
      near: new Uint8Array(n).fill(1),
      ...gripOf(rope, post, lines),
    }));
    this.start();
  }

  /** Remember nothing but the places. */
  start() {
    for (const hold of this.holds) {
      hold.k.set(hold.stiff);
      hold.c.set(hold.damp);
      for (const row of hold.spring) row.fill(0);
    }
    this.work = 0;
    for (const [k, row] of this.rope.x.entries()) this.place[k].set(row);
    this.#keep(rows(this.rope.n), 0, this.rope.n - 1, 0);
    this.first = this.stored();
  }

  /** Take the values that the rope has now, and friction. @param {(post: Post) => number} friction
   * @param {number} heavier how many times its own mass it has */
  change(friction, heavier) {
    const lines = this.lines.map((line) => ({
      ...line,
      own: heavier * line.own,
      whole: heavier * line.whole,
      loads: line.loads.map(
        ([node, mass]) => /** @type {[number, number]} */ ([node, heavier * mass]),
      ),
    }));
    const before = this.stored();
    for (const hold of this.holds) {
      hold.friction = friction(hold.post);
      Object.assign(hold, gripOf(this.rope, hold.post, lines));
    }
    this.first += this.stored() - before;
    if (this.rope.time === 0) this.start();
    else this.#turn();
  }

  /** Let the coefficients of friction hold from now on. */
  #turn() {
    const { x, v, n } = this.rope;
    for (const hold of this.holds)
      for (let i = 0; i < n; i++) {
        probe(hold.post, x[0][i], x[1][i], x[2][i], this.found);
        this.#slide(hold, i, v, 0, hold.slide[i] * hold.push[i] > 0);
      }
  }

  /** What rubs at a node where a step has ended: the spring's pull, and the damper on how it goes [N]; `found` is
   * known. @param {Hold} hold @param {number} i @param {Float64Array[]} v @returns {number[]} */
  #rubs({ spring, c }, i, v) {
    const [, nx, ny, nz] = this.found;
    const fx = spring[0][i] - c[i] * v[0][i];
    const fy = spring[1][i] - c[i] * v[1][i];
    const fz = spring[2][i] - c[i] * v[2][i];
    const across = nx * fx + ny * fy + nz * fz;
    return [fx - across * nx, fy - across * ny, fz - across * nz];
  }

  /** Keep a node's coefficient, and its rate by what the next `dt` [s] bring; `found` is known. @param {Hold} hold
   * @param {number} i @param {Float64Array[]} v @param {number} dt @param {boolean} rubs whether anything does */
  #slide(hold, i, v, dt, rubs) {
    const { rope, found } = this;
    const { x } = rope;
    const turned = turnedBy(rope, v, hold.post, hold.friction, i, found, 0);
    hold.slide[i] = turned.middle;
    hold.grows[i] = 0;
    if (turned.off === 0) return;
    const ahead = pullsAhead(x, i, found, rubs ? this.#rubs(hold, i, v) : [0, 0, 0]);
    hold.slide[i] = tilted(turned, ahead);
    if (ahead === 0 || !(Math.abs(turned.off) > MOVES) || !(dt > 0)) return;
    probe(hold.post, x[0][i] + dt * v[0][i], x[1][i] + dt * v[1][i], x[2][i] + dt * v[2][i], found);
    const later = turnedBy(rope, v, hold.post, hold.friction, i, found, dt);
    hold.grows[i] = (tilted(later, ahead) - hold.slide[i]) / dt;
  }

  /** Add to the nodes' accelerations [m/s^2] what the posts do to them.
   * @param {Float64Array[]} x @param {Float64Array[]} v @param {Float64Array[]} a @param {number} since what is
   * remembered [s] */
  accelerate(x, v, a, since) {
    const { first, last, inverse } = this.rope;
    for (const row of this.force) row.fill(0, first, last + 1);
    for (const hold of this.holds) this.#press(hold, x, v, since, first, last);
    for (let k = 0; k < 3; k++)
      for (let i = first; i <= last; i++) a[k][i] += this.force[k][i] * inverse[i];
  }

  /** @param {Hold} hold @param {Float64Array[]} x @param {Float64Array[]} v @param {number} since
   * @param {number} first @param {number} last */
  #press(hold, x, v, since, first, last) {
    const [x0, x1, x2] = x;
    const [v0, v1, v2] = v;
    const [f0, f1, f2] = this.force;
    const [s0, s1, s2] = hold.spring;
    const [p0, p1, p2] = this.place;
    const [c0, c1, c2] = hold.post.center;
    const { found, squeezed, thickness } = this;
    const { near } = hold;
    for (let i = first; i <= last; i++) {
      if (!near[i]) continue;
      probe(hold.post, x0[i], x1[i], x2[i], found);
      const nx = found[1];
      const ny = found[2];
      const nz = found[3];
      const k = hold.k[i];
      const c = hold.c[i];
      squeeze(hold.stiff[i], hold.hard[i], this.skin[i], thickness[i] - found[0], squeezed);
      const rise = nx * v0[i] + ny * v1[i] + nz * v2[i];
      if (!(squeezed[0] - c * rise > 0)) continue;
      const comes = closing(rise, found[0] - thickness[i], found, v0[i], v1[i], v2[i]);
      const push = squeezed[0] - c * comes;
      if (!(push > 0)) continue;
      let sx = 0;
      let sy = 0;
      let sz = 0;
      const bound = Math.max(hold.slide[i] + hold.grows[i] * since, 0) * push;
      if (bound > 0) {
        sx = s0[i] - k * (x0[i] - c0 - (p0[i] - c0)) - c * v0[i];
        sy = s1[i] - k * (x1[i] - c1 - (p1[i] - c1)) - c * v1[i];
        sz = s2[i] - k * (x2[i] - c2 - (p2[i] - c2)) - c * v2[i];
        const across = nx * sx + ny * sy + nz * sz;
        sx -= across * nx;
        sy -= across * ny;
        sz -= across * nz;
        const total = Math.sqrt(sx * sx + sy * sy + sz * sz);
        if (total > bound) {
          const share = bound / total;
          sx *= share;
          sy *= share;
          sz *= share;
        }
      }
      f0[i] += push * nx + sx;
      f1[i] += push * ny + sy;
      f2[i] += push * nz + sz;
    }
  }

  /** Begin to add up a step's mean force and work. */
  begin() {
    const { first, last, v } = this.rope;
    for (let k = 0; k < 3; k++) {
      this.mean[k].fill(0, first, last + 1);
      for (let i = first; i <= last; i++) this.before[k][i] = v[k][i];
    }
  }

  /** Add a share of the present forces to the step's mean. @param {number} share */
  weigh(share) {
    const { first, last } = this.rope;
    for (let k = 0; k < 3; k++)
      for (let i = first; i <= last; i++) this.mean[k][i] += share * this.force[k][i];
  }

  /** Remember the step that has ended, and book what the posts have done in it. @param {number} dt */
  end(dt) {
    const { first, last, v } = this.rope;
    for (let k = 0; k < 3; k++)
      for (let i = first; i <= last; i++)
        this.work += 0.5 * dt * this.mean[k][i] * (this.before[k][i] + v[k][i]);
    this.#keep(v, first, last, dt);
  }

  /** @param {Float64Array[]} v @param {number} first @param {number} last @param {number} dt */
  #keep(v, first, last, dt) {
    const { x } = this.rope;
    for (const hold of this.holds) {
      for (let i = first; i <= last; i++) {
        probe(hold.post, x[0][i], x[1][i], x[2][i], this.found);
        const speed = Math.hypot(v[0][i], v[1][i], v[2][i]);
        const brakes = (hold.damp[i] / hold.stiff[i]) * speed; // from so far off the damper takes hold
        const near = this.found[0] < this.reach[i] + brakes;
        if (near || hold.near[i]) this.#remember(hold, i, x, v, dt);
        hold.near[i] = near ? 1 : 0;
      }
    }
    for (let k = 0; k < 3; k++) for (let i = first; i <= last; i++) this.place[k][i] = x[k][i];
  }

  /** Keep what a post carries at a node, how stiff it is there, and the coefficient of friction; `found` is known.
   * @param {Hold} hold @param {number} i @param {Float64Array[]} x @param {Float64Array[]} v @param {number} dt */
  #remember(hold, i, x, v, dt) {
    const { spring, stiff, damp, hard } = hold;
    const { found, squeezed, place } = this;
    const nx = found[1];
    const ny = found[2];
    const nz = found[3];
    const depth = this.thickness[i] - found[0];
    squeeze(stiff[i], hard[i], this.skin[i], depth, squeezed);
    const k = hold.k[i];
    const rise = nx * v[0][i] + ny * v[1][i] + nz * v[2][i];
    const comes = closing(rise, -depth, found, v[0][i], v[1][i], v[2][i]);
    const push = squeezed[0] - hold.c[i] * comes;
    hold.push[i] = Math.max(push, 0);
    const deep = hard[i] !== 0 && depth > this.skin[i];
    hold.k[i] = deep ? squeezed[0] / depth : stiff[i];
    hold.c[i] = deep ? damp[i] * Math.max(1, HARD * Math.sqrt(hold.k[i] / stiff[i])) : damp[i];
    const softer = hold.k[i] < k ? Math.sqrt(hold.k[i] / k) : 1; // it keeps what it has stored
    const bound = Math.max(hold.slide[i] + hold.grows[i] * dt, 0) * hold.push[i];
    let sx = 0;
    let sy = 0;
    let sz = 0;
    if (bound > 0) {
      const [c0, c1, c2] = hold.post.center;
      sx = spring[0][i] - k * (x[0][i] - c0 - (place[0][i] - c0));
      sy = spring[1][i] - k * (x[1][i] - c1 - (place[1][i] - c1));
      sz = spring[2][i] - k * (x[2][i] - c2 - (place[2][i] - c2));
      const across = nx * sx + ny * sy + nz * sz;
      sx = softer * (sx - across * nx);
      sy = softer * (sy - across * ny);
      sz = softer * (sz - across * nz);
      const total = Math.sqrt(sx * sx + sy * sy + sz * sz);
      if (total > bound) {
        const share = bound / total;
        sx *= share;
        sy *= share;
        sz *= share;
      }
    }
    spring[0][i] = sx;
    spring[1][i] = sy;
    spring[2][i] = sz;
    this.#slide(hold, i, v, dt, bound > 0);
  }

  /** Whether a free node is so deep in a post that it may go through. */
  through() {
    const { x, n, inverse } = this.rope;
    return this.holds.some(({ post }) => {
      const thin = Math.min(
        post.radius,
        post.kind === "cylinder" ? (post.half ?? Infinity) : Infinity,
      );
      for (let i = 0; i < n && post.kind !== "plane"; i++) {
        probe(post, x[0][i], x[1][i], x[2][i], this.found);
        const [depth, most] = [this.thickness[i] - this.found[0], thin + this.thickness[i]];
        if (inverse[i] > 0 && depth >= DEEPEST * most) return true;
      }
      return false;
    });
  }

  /** Move a place that is in hand out of the posts. @param {number[]} at @param {number} node */
  keepOut(at, node) {
    for (const { post } of this.holds) {
      probe(post, at[0], at[1], at[2], this.found);
      const depth = this.thickness[node] - this.found[0];
      if (depth > 0) for (let k = 0; k < 3; k++) at[k] += depth * this.found[k + 1];
    }
  }

  /** The stiffness and the damper of nodes pressed deep into the stiffest post, or three, as in a corner. */
  hardest() {
    const most = Math.min(this.holds.length, 3);
    const [stiff, damp] = [new Float64Array(this.rope.n), new Float64Array(this.rope.n)];
    for (const hold of this.holds)
      for (let i = 0; i < this.rope.n; i++) {
        const whole = hold.stiff[i] + hold.hard[i];
        const firmer = Math.max(1, HARD * Math.sqrt(whole / hold.stiff[i]));
        stiff[i] = Math.max(stiff[i], most * whole);
        damp[i] = Math.max(damp[i], most * hold.damp[i] * firmer);
      }
    return { stiff, damp };
  }

  /** What the posts' surfaces have stored where they are pressed in [J]. */
  stored() {
    const { x, n } = this.rope;
    let energy = 0;
    for (const { post, stiff, hard } of this.holds)
      for (let i = 0; i < n; i++) {
        probe(post, x[0][i], x[1][i], x[2][i], this.found);
        const depth = this.thickness[i] - this.found[0];
        squeeze(stiff[i], hard[i], this.skin[i], depth, this.squeezed);
        energy += this.squeezed[2];
      }
    return energy;
  }
}
