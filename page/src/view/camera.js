// The camera of both renderers: it looks at a target from a direction given by two angles around "up".

import { cross, dot, minus, plus, times, unit, vector } from "./vector.js";

/** @typedef {import("./vector.js").Vector} Vector */
/** @typedef {{low: Vector, high: Vector}} Box a box of the scene [m] */
/** @typedef {{target: Vector, distance: number, azimuth: number, elevation: number}} Pose */

/** What cards take of the picture at its sides [CSS pixels].
 * @typedef {{top: number, bottom: number, left?: number, right?: number}} Strips */

const FIELD = (28 * Math.PI) / 180; // vertical field of view [rad]
const WIDE = 0.72; // of the picture's width, which ropes fill when all is shown
const EDGE = 0.35; // of a plane, seen from there: too little of it to be drawn about on
const HIGH = 0.68; // of its height
const HALF_TURN = Math.PI / 2;

export class Camera {
  constructor() {
    this.width = 1; // CSS pixels
    this.height = 1;
    /** @type {Pose} */
    this.pose = { target: [0, 0, 0], distance: 5, azimuth: -HALF_TURN + 0.5, elevation: 0.22 };
    this.view = new Float32Array(16); // column-major, as WebGL takes it
    this.projection = new Float32Array(16);
    /** Changes with every change of the camera. */
    this.version = 0;
    /** @type {Vector} */ this.up = [0, 0, 1];
    /** @type {Vector} */ this.first = [1, 0, 0];
    /** @type {Vector} */ this.second = [0, 1, 0];
    /** To the light: from the front left, above. @type {Vector} */ this.light = [0, 0, 1];
    /** @type {Vector} */ this.eye = [0, 0, 0];
    /** @type {Vector} */ this.right = [1, 0, 0];
    /** @type {Vector} */ this.top = [0, 0, 1];
    /** @type {Vector} */ this.toward = [0, -1, 0];
    this.update();
  }

  /** Let this direction point up on the screen. @param {ArrayLike<number>} up */
  setUp(up) {
    this.up = unit(up);
    const along = Math.abs(this.up[0]) < 0.9 ? [1, 0, 0] : [0, 0, 1];
    this.first = unit(minus(along, times(this.up, dot(along, this.up))));
    this.second = cross(this.up, this.first);
    const level = plus(times(this.first, -0.45), this.second, -0.55);
    this.light = unit(plus(level, this.up));
    this.update();
  }

  /** @param {number} width @param {number} height in CSS pixels */
  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.update();
  }

  /** Take over a pose or part of one; what is not finite is no pose. @param {Partial<Pose>} pose */
  set(pose) {
    const wanted = { ...this.pose, ...pose };
    const { target, distance, azimuth, elevation } = wanted;
    if (![...target, distance, azimuth, elevation].every(Number.isFinite)) return;
    this.pose = wanted;
    this.pose.elevation = Math.min(HALF_TURN, Math.max(-HALF_TURN, this.pose.elevation));
    this.pose.distance = Math.min(1e7, Math.max(1e-4, this.pose.distance));
    this.update();
  }

  /** Work out axes and matrices from the pose. */
  update() {
    const { target, distance, azimuth, elevation } = this.pose;
    const [ca, sa] = [Math.cos(azimuth), Math.sin(azimuth)];
    const [ce, se] = [Math.cos(elevation), Math.sin(elevation)];
    const level = plus(times(this.first, ca), this.second, sa);
    this.toward = plus(times(level, ce), this.up, se);
    this.right = plus(times(this.first, -sa), this.second, ca);
    this.top = cross(this.toward, this.right);
    this.eye = plus(target, this.toward, distance);
    const axes = [this.right, this.top, this.toward];
    for (let row = 0; row < 3; row++) {
      for (let column = 0; column < 3; column++) this.view[4 * column + row] = axes[row][column];
      this.view[12 + row] = -dot(axes[row], this.eye);
      this.view[4 * row + 3] = 0;
    }
    this.view[15] = 1;
    const near = distance * 0.01;
    const far = distance * 200;
    const focal = 1 / Math.tan(FIELD / 2);
    this.projection.fill(0);
    this.projection[0] = (focal * this.height) / this.width;
    this.projection[5] = focal;
    this.projection[10] = (far + near) / (near - far);
    this.projection[11] = -1;
    this.projection[14] = (2 * far * near) / (near - far);
    this.version++;
  }

  /** Pixels that one metre takes up at a depth of one metre. */
  get focal() {
    return this.height / 2 / Math.tan(FIELD / 2);
  }

  /** Where a point is on the screen: pixels right, pixels down, depth [m] (negative: behind).
   * @param {number} x @param {number} y @param {number} z @returns {Vector} */
  project(x, y, z) {
    const v = this.view;
    const depth = -(v[2] * x + v[6] * y + v[10] * z + v[14]);
    const scale = this.focal / Math.max(depth, 1e-9);
    return [
      this.width / 2 + (v[0] * x + v[4] * y + v[8] * z + v[12]) * scale,
      this.height / 2 - (v[1] * x + v[5] * y + v[9] * z + v[13]) * scale,
      depth,
    ];
  }

  /** How far the eye is above a level [m]. @param {number} level */
  eyeHeight(level) {
    return dot(this.eye, this.up) - level;
  }

  /** The direction (length 1 along the view) from the eye through a pixel.
   * @param {number} px @param {number} py @returns {Vector} */
  ray(px, py) {
    const across = (px - this.width / 2) / this.focal;
    const upward = (this.height / 2 - py) / this.focal;
    return plus(plus(times(this.toward, -1), this.right, across), this.top, upward);
  }

  /** The point under a pixel in the plane through `point` parallel to the screen.
   * @param {number} px @param {number} py @param {ArrayLike<number>} point @returns {Vector} */
  inPlane(px, py, point) {
    const depth = dot(minus(this.eye, point), this.toward);
    return plus(this.eye, this.ray(px, py), depth);
  }

  /** The point under a pixel in the plane through `point` at a right angle to an axis of the scene (0, 1, 2), or
   * parallel to the screen where that plane is seen too much from its edge.
   * @param {number} px @param {number} py @param {ArrayLike<number>} point @param {number} axis or -1
   * @returns {Vector} */
  onPlane(px, py, point, axis) {
    const ray = this.ray(px, py);
    if (axis < 0 || Math.abs(ray[axis]) < EDGE) return this.inPlane(px, py, point);
    return plus(this.eye, ray, (point[axis] - this.eye[axis]) / ray[axis]);
  }

  /** Turn around the target. @param {number} dx @param {number} dy pixels */
  orbit(dx, dy) {
    const turn = (1.2 * Math.PI) / Math.min(this.width, this.height);
    this.set({
      azimuth: this.pose.azimuth - dx * turn,
      elevation: this.pose.elevation + dy * turn,
    });
  }

  /** Shift the scene with the hand. @param {number} dx @param {number} dy pixels */
  pan(dx, dy) {
    const scale = this.pose.distance / this.focal;
    const shifted = plus(plus(this.pose.target, this.right, -dx * scale), this.top, dy * scale);
    this.set({ target: shifted });
  }

  /** Come closer (factor below 1), keeping the point under the pixel where it is.
   * @param {number} factor @param {number} [px] @param {number} [py] */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const before = this.inPlane(px, py, this.pose.target);
    this.set({ distance: this.pose.distance * factor });
    const after = this.inPlane(px, py, this.pose.target);
    this.set({ target: plus(this.pose.target, minus(before, after)) });
  }

  /** The same camera elsewhere. @param {Partial<Pose>} pose */
  at(pose) {
    const probe = new Camera();
    probe.setUp(this.up);
    probe.resize(this.width, this.height);
    probe.set({ ...this.pose, ...pose });
    return probe;
  }

  /** The pose that shows a whole box from the present direction, or from another one.
   * @param {Box} box @param {{azimuth?: number, elevation?: number}} [from]
   * @param {Strips} [strips] to be kept free @returns {Pose} */
  fitted(box, from = {}, strips) {
    const corners = Array.from({ length: 8 }, (_, corner) =>
      vector([0, 1, 2].map((i) => ((corner >> i) & 1 ? box.high[i] : box.low[i]))),
    );
    return this.framed(corners, from, strips);
  }

  /** The pose that lets points fill the picture, up to a margin, from the present direction or another one: along
   * each side of the view the point that needs the most room says where the eye must be.
   * @param {Iterable<Vector>} points @param {{azimuth?: number, elevation?: number}} [from]
   * @param {Strips} [strips] to be kept free @returns {Pose} */
  framed(
    points,
    from = {},
    { top, bottom, left: aside = 0, right: beyond = 0 } = { top: 0, bottom: 0 },
  ) {
    const probe = this.at({ ...from, target: [0, 0, 0], distance: 1 });
    const half = Math.tan(FIELD / 2);
    const free = Math.max(0.3, 1 - (top + bottom) / this.height);
    const high = half * HIGH * free;
    const wide =
      (half * WIDE * Math.max(0.3 * this.width, this.width - aside - beyond)) / this.height;
    let [right, left, above, below] = [-Infinity, -Infinity, -Infinity, -Infinity];
    let [nearest, farthest] = [-Infinity, Infinity];
    for (const point of points) {
      const [r, t, n] = [probe.right, probe.top, probe.toward].map((axis) => dot(point, axis));
      right = Math.max(right, r + wide * n);
      left = Math.max(left, wide * n - r);
      above = Math.max(above, t + high * n);
      below = Math.max(below, high * n - t);
      nearest = Math.max(nearest, n);
      farthest = Math.min(farthest, n);
    }
    const eye = Math.max((right + left) / (2 * wide), (above + below) / (2 * high), nearest + 1e-3);
    const middle = (nearest + farthest) / 2;
    const distance = eye - middle;
    const shift = ((top - bottom) / 2) * (distance / this.focal);
    const across = ((aside - beyond) / 2) * (distance / this.focal);
    const target = plus(
      plus(times(probe.right, (right - left) / 2 - across), probe.top, (above - below) / 2 + shift),
      probe.toward,
      middle,
    );
    return { ...probe.pose, target, distance };
  }

  /** The angles from which an axis of the scene (0, 1, 2 for x, y, z) points at the viewer.
   * @param {0 | 1 | 2} axis @param {1 | -1} [sign] @returns {{azimuth: number, elevation: number}} */
  along(axis, sign = 1) {
    /** @type {Vector} */
    const from = [0, 0, 0];
    from[axis] = sign;
    return this.angles(from);
  }

  /** The angles of a direction towards the viewer. @param {ArrayLike<number>} toward */
  angles(toward) {
    const height = dot(toward, this.up);
    const a = dot(toward, this.first);
    const b = dot(toward, this.second);
    const level = Math.hypot(a, b) > 1e-6;
    return {
      azimuth: level ? Math.atan2(b, a) : -HALF_TURN,
      elevation: Math.atan2(height, Math.hypot(a, b)),
    };
  }
}
