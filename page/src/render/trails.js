// Trails: where chosen nodes were in the last frames. A ring of points for each of them.

export const TRAIL_POINTS = 360;

export class Trails {
  /** @param {number[]} nodes indices in the view @param {import("../view/colours.js").Colour[]} colours */
  constructor(nodes, colours) {
    this.nodes = nodes;
    this.colours = colours;
    /** x, y, z, 1 of each point; one row of `TRAIL_POINTS` per node. */
    this.points = new Float32Array(4 * TRAIL_POINTS * nodes.length);
    this.head = 0; // column that is written next, the oldest point
    this.version = 0;
    this.empty = true;
  }

  /** Add the present places. @param {Float32Array} values x, y, z, value of each node of the view */
  push(values) {
    const times = this.empty ? TRAIL_POINTS : 1;
    for (let k = 0; k < times; k++) {
      this.nodes.forEach((node, row) => {
        const at = 4 * (row * TRAIL_POINTS + this.head);
        for (let i = 0; i < 3; i++) this.points[at + i] = values[4 * node + i];
      });
      this.head = (this.head + 1) % TRAIL_POINTS;
    }
    this.empty = false;
    this.version++;
  }

  clear() {
    this.empty = true;
    this.version++;
  }
}

/** The nodes that have a trail from a scene's start: of what flies freely, for the camera goes along with it, and all
 * that it passes is sky. @param {import("../source/protocol.js").Layout} layout @returns {number[]} */
export function fliers({ ground, obstacles, variants: [copy] }) {
  const free = !ground && !obstacles?.length && !copy.anchors.length;
  return free ? copy.ropes.slice(0, 1).map(({ first }) => first) : [];
}
