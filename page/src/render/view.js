// What a renderer is given to draw. Both renderers, WebGL2 and Canvas 2D, take the same.

/** @typedef {import("../view/camera.js").Camera} Camera */
/** @typedef {import("../view/colours.js").Colour} Colour */
/** @typedef {import("./trails.js").Trails} Trails */
/** @typedef {import("../view/solids.js").Solid} Solid */

/** One rope of one copy,
 *   its segments `spacing` metres long: nodes `first` to `first + count - 1` of the view; which ends are loose.
 * @typedef {{name: string, first: number, count: number, radius: number, spacing: number,
 *   colour: Colour, loose: [boolean, boolean]}} RopeSpan */

/** The constant part: which nodes make ropes.
 * @typedef {{nodes: number, ropes: RopeSpan[]}} Shape */

/** @typedef {"round" | "eye" | "ring" | "knot"} MarkerKind */
/** A ball, eye bolt or ring: size in metres and the least in pixels (diameters).
 * @typedef {{x: number, y: number, z: number, kind: MarkerKind, colour: Colour, size: number,
 *   pixels: number}} Marker */
/** @typedef {{from: ArrayLike<number>, to: ArrayLike<number>, colour: Colour, pixels: number,
 *   head: boolean}} Arrow */
/** @typedef {{height: number, solid: boolean, spacing: number, radius: number, center: [number, number,
 *   number]}} Ground */

/** @typedef {{background: Colour, horizon: Colour, grid: Colour, shadow: Colour, ground: Colour, anchor: Colour,
 *   hand: Colour, load: Colour, arrow: Colour, grab: Colour, pin: Colour, hover: Colour, node: Colour, post: Colour,
 *   body: Colour, joint: Colour, contact: Colour, rim: number, dark: boolean}} Theme */

/** What is drawn in one frame.
 * @typedef {Object} View
 * @property {Camera} camera
 * @property {Float32Array} nodes x, y, z, value of each node
 * @property {boolean} moved whether `nodes` changed since the last drawing
 * @property {{low: number, high: number}} range of the values, for the colours
 * @property {boolean} plain each rope in its own colour
 * @property {boolean} dots whether nodes are shown as dots
 * @property {number} pixels least width of a rope
 * @property {boolean} smooth whether ropes are curves through their nodes, not polylines
 * @property {Uint8Array} corners 1 for nodes where a rope may have a kink
 * @property {Marker[]} markers
 * @property {Arrow[]} arrows
 * @property {Arrow[]} touches forces of contacts, which bodies hide
 * @property {Arrow[]} posts that anchors stand on: no part of the model
 * @property {Trails | null} trails
 * @property {Ground} ground
 * @property {{center: number[], radius: number}} room of the scene [m]
 * @property {Solid[]} solids the bodies that ropes touch
 * @property {number[]} turns how far each has turned [rad]
 */

/** @typedef {Object} Renderer
 * @property {"webgl" | "canvas"} name
 * @property {HTMLCanvasElement} canvas
 * @property {(shape: Shape) => void} setShape
 * @property {(theme: Theme) => void} setTheme
 * @property {(width: number, height: number, ratio: number) => void} resize CSS pixels
 * @property {(view: View) => void} draw
 * @property {boolean} rough whether there are fewer pixels, as the camera moves
 * @property {boolean} unfinished whether it wants to draw the same again, with more pixels
 * @property {() => void} clear show the background only
 * @property {() => void} dispose
 */

export {};
