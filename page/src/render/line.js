// What both renderers draw of the ropes: the points of a smooth line through the nodes, several for each segment
// where those are long on the screen, and not all nodes where they are much shorter than a pixel is wide.

import { carryNormals, refine } from "../view/curve.js";
import { textureSize } from "./webgl/texture_size.js";

/** @typedef {import("./view.js").Shape} Shape */
/** @typedef {import("./view.js").View} View */

const PIECE = 7; // CSS pixels between two points of the line, about
const SHORT = 1.5; // CSS pixels: of segments that are shorter, several make one piece
const MOST_STEPS = 8;
const MOST_SKIPPED = 16;

export class Line {
  /** @param {number} budget points that are drawn at most, unless there are more nodes @param {number} laid as long
   * as there are no more points than this, there are normals for strands */
  constructor(budget, laid) {
    this.budget = budget;
    this.laid = laid;
    this.steps = 0; // points of each segment
    this.every = 1; // nodes from one point to the next
    /** @type {Shape} of the nodes */ this.nodes = { nodes: 0, ropes: [] };
    /** @type {Shape} of the points */ this.shape = { nodes: 0, ropes: [] };
    this.points = new Float32Array(4); // x, y, z, value
    this.normals = new Float32Array(4); // a normal, and the length of rope from its first node [m]
  }

  /** @param {Shape} shape */
  setShape(shape) {
    this.nodes = shape;
    this.steps = 0;
  }

  /** Follow the view; tells whether there is now another number of points. @param {View} view */
  update(view) {
    const [steps, every] = this.wanted(view);
    const anew = steps !== this.steps || every !== this.every;
    if (anew) this.build(steps, every);
    if (!anew && !view.moved) return false;
    this.nodes.ropes.forEach((rope, r) => {
      const { first, count } = this.shape.ropes[r];
      if (every > 1) thin(view.nodes, rope.first, rope.count, every, this.points, first);
      else if (steps > 1) refine(view.nodes, rope, steps, view.corners, this.points, first);
      else
        this.points.set(
          view.nodes.subarray(4 * rope.first, 4 * (rope.first + rope.count)),
          4 * first,
        );
      if (this.framed) carryNormals(this.points, first, count, this.normals);
    });
    return anew;
  }

  /** Whether there are normals. */
  get framed() {
    return this.shape.nodes <= this.laid;
  }

  /** How many points each segment gets, as many as its length on the screen asks for, and how many nodes one piece
   * takes; neither is changed for little. @param {View} view @returns {[number, number]} */
  wanted({ camera, smooth, dots }) {
    const { ropes, nodes } = this.nodes;
    if (!smooth || !nodes) return [1, 1];
    const longest = ropes.reduce((most, { spacing }) => Math.max(most, spacing), 0);
    const pixels = (longest * camera.focal) / camera.pose.distance;
    if (!dots && (pixels < SHORT || (this.every > 1 && pixels < 1.3 * SHORT))) {
      const every = Math.min(MOST_SKIPPED, 2 ** Math.round(Math.log2((2 * SHORT) / pixels)));
      const near = this.every > 1 && every < 4 * this.every && this.every < 4 * every;
      return [1, near ? this.every : Math.max(2, every)];
    }
    const most = Math.max(1, Math.min(MOST_STEPS, Math.floor(this.budget / nodes)));
    const steps = Math.max(1, Math.min(most, Math.ceil(pixels / PIECE)));
    const enough = this.steps >= steps && this.steps <= Math.max(2, 2 * steps);
    return [enough && this.steps <= most ? this.steps : steps, 1];
  }

  /** @param {number} steps @param {number} every */
  build(steps, every) {
    const kept = this.shape.ropes.map(({ first }) => this.normals.slice(4 * first, 4 * first + 3));
    [this.steps, this.every] = [steps, every];
    let at = 0;
    const ropes = this.nodes.ropes.map((rope) => {
      const first = at;
      const segments = Math.max(0, rope.count - 1);
      const pieces = every > 1 ? Math.ceil(segments / every) : segments * steps;
      const count = rope.count > 0 ? pieces + 1 : 0;
      at += count;
      return { ...rope, first, count, spacing: (rope.spacing * segments) / Math.max(1, pieces) };
    });
    this.shape = { nodes: at, ropes };
    const [width, height] = textureSize(at);
    this.points = new Float32Array(4 * width * height);
    this.normals = new Float32Array(this.framed ? 4 * width * height : 4);
    if (!this.framed) return;
    ropes.forEach(({ first, count, spacing }, r) => {
      if (kept.length === ropes.length) this.normals.set(kept[r], 4 * first);
      for (let i = 0; i < count; i++) this.normals[4 * (first + i) + 3] = i * spacing;
    });
  }
}

/** Take some of a rope's nodes, always the last one, each with the greatest value of those it stands for.
 * @param {ArrayLike<number>} nodes @param {number} from @param {number} count @param {number} every
 * @param {Float32Array} out @param {number} first */
export function thin(nodes, from, count, every, out, first) {
  let at = 4 * first;
  for (let i = 0; i < count - 1; i += every, at += 4) {
    const end = Math.min(i + every, count - 1);
    const p = 4 * (from + i);
    let most = nodes[p + 3];
    for (let k = i + 1; k < end; k++) most = Math.max(most, nodes[4 * (from + k) + 3]);
    out[at] = nodes[p];
    out[at + 1] = nodes[p + 1];
    out[at + 2] = nodes[p + 2];
    out[at + 3] = most;
  }
  const last = 4 * (from + count - 1);
  for (let k = 0; k < 4; k++) out[at + k] = nodes[last + k];
}
