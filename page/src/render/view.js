// What a renderer is given to draw. Both renderers, WebGL2 and Canvas 2D, take the same.

/** @typedef {import("../view/camera.js").Camera} Camera */
/** @typedef {import("../view/colours.js").Colour} Colour */
/** @typedef {import("./trails.js").Trails} Trails */

/** One rope of one copy,
 *   its segments `spacing` metres long: nodes `first` to `first + count - 1` of the view.
 * @typedef {{name: string, first: number, count: number, radius: number, spacing: number,
 *   colour: Colour}} RopeSpan */

/** The constant part: which nodes make ropes.
 * @typedef {{nodes: number, ropes: RopeSpan[]}} Shape */

/** @typedef {"round" | "square" | "ring"} MarkerKind */
/** A ball, plate or ring: size in metres and the least in pixels (diameters).
 * @typedef {{x: number, y: number, z: number, kind: MarkerKind, colour: Colour, size: number,
 *   pixels: number}} Marker */
/** @typedef {{from: ArrayLike<number>, to: ArrayLike<number>, colour: Colour, pixels: number,
 *   head: boolean}} Arrow */
/** @typedef {{height: number, solid: boolean, spacing: number, radius: number, center: [number, number,
 *   number]}} Ground */

/** @typedef {{background: Colour, grid: Colour, shadow: Colour, ground: Colour, anchor: Colour,
 *   hand: Colour, load: Colour, arrow: Colour, grab: Colour, pin: Colour, hover: Colour, node: Colour,
 *   dark: boolean}} Theme */

/** What is drawn in one frame.
 * @typedef {Object} View
 * @property {Camera} camera
 * @property {Float32Array} nodes x, y, z, value of each node
 * @property {boolean} moved whether `nodes` changed since the last drawing
 * @property {{low: number, high: number}} range of the values, for the colours
 * @property {boolean} plain each rope in its own colour
 * @property {boolean} dots whether nodes are shown as dots
 * @property {number} pixels least width of a rope
 * @property {Marker[]} markers
 * @property {Arrow[]} arrows
 * @property {Trails | null} trails
 * @property {Ground | null} ground
 */

/** @typedef {Object} Renderer
 * @property {"webgl" | "canvas"} name
 * @property {HTMLCanvasElement} canvas
 * @property {(shape: Shape) => void} setShape
 * @property {(theme: Theme) => void} setTheme
 * @property {(width: number, height: number, ratio: number) => void} resize CSS pixels
 * @property {(view: View) => void} draw
 * @property {() => void} clear show the background only
 * @property {() => void} dispose
 */

export {};
