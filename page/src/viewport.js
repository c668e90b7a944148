// The viewport: takes frames, moves smoothly between them and draws when something has changed.

import { Blend } from "./view/blend.js";
import { Camera } from "./view/camera.js";
import { Flight } from "./view/flight.js";
import { Range } from "./view/range.js";
import { cornersOf, nodesOf, shiftsOf, starts } from "./view/copies.js";
import { boxOf, flatAxis, groundOf, lies, tame } from "./view/room.js";
import { readTheme } from "./view/theme.js";
import { textureSize } from "./render/webgl/texture_size.js";
import { BROKEN, PLAYING } from "./source/frame.js";
import { gather, gatherAnchors } from "./source/gather.js";
import { Floor } from "./floor.js";
import { Following } from "./following.js";
import { Framing } from "./framing.js";
import { Gaps } from "./gaps.js";
import { Marks } from "./marks.js";
import { Solids } from "./solids.js";

/** @typedef {import("./session.js").Session} Session */
/** @typedef {import("./source/protocol.js").Layout} Layout */
/** @typedef {import("./source/frame.js").Frame} Frame */
/** @typedef {import("./source/gather.js").Colouring} Colouring */
/** @typedef {import("./render/view.js").Renderer} Renderer */
/** @typedef {import("./render/view.js").Theme} Theme */
/** @typedef {import("./view/camera.js").Pose} Pose */

const LEAP = 1; // s between two frames of which the one does not go on from the other

const MANY = 12; // ropes, of a net

export class Viewport {
  /** @param {Session} session @param {Renderer} renderer */
  constructor(session, renderer) {
    this.session = session;
    this.renderer = renderer;
    this.camera = new Camera();
    this.nodes = new Blend(4);
    this.anchors = new Blend(0);
    this.range = new Range();
    /** Whether there is more than the range's ends. @type {[boolean, boolean]} */ this.beyond = [
      false,
      false,
    ];
    /** @type {Colouring} */
    this.colouring = "tension";
    /** The greatest tension of each rope of each copy [N]. @type {number[][]} */ this.tensions =
      [];
    this.dots = false;
    this.apart = false;
    /** @type {number[][]} */ this.shifts = [[0, 0, 0]];
    /** @type {number[]} */ this.starts = [0];
    this.corners = new Uint8Array(0);
    /** @type {Theme} */ this.theme = readTheme();
    this.marks = new Marks(this);
    this.dirty = true;
    this.drawn = 0;
    this.spacing = 1; // of the grid's lines [m]
    this.floor = new Floor(this);
    this.gaps = new Gaps(this);
    this.solids = new Solids(this);
    /** @type {Flight | import("./view/chase.js").Chase | null} */ this.flight = null;
    this.uncovering = false; // whether it is to bring ropes out from under a card
    this.follower = new Following(this);
    this.framing = new Framing(this);
    this.following = true; // until the user moves the camera
    this.ownVersion = -1; // of the camera, as the viewport has set it
    this.axis = -1; // that a flat scene has no extent along (0, 1, 2), else -1
    this.lying = false; // all of the scene on one level
    this.past = false; // what is shown is past a break
    this.lookPending = true;
    this.layoutNumber = -1;
    /** @type {number[]} */ this.up = [0, 0, 1];
    this.sceneKey = "";
    this.lastTime = -Infinity;
    this.lastPush = 0;
    this.cameraVersion = -1;
    /** The card that is in the way, if there is one. @type {() => DOMRect | null} */
    this.card = () => null;
    /** @type {(() => void)[]} */ this.beforeDraw = [];
    /** @type {(() => void)[]} */ this.afterDraw = [];
    session.on("layout", (layout) => this.takeLayout(layout));
    session.on("frame", (frame) => this.takeFrame(frame));
    session.on("broken", () => {
      this.range.fresh = true; // what broke must not rule the colours
      this.past = session.broken !== null;
    });
    renderer.setTheme(this.theme);
    renderer.canvas.addEventListener("webglcontextrestored", () => this.setTheme()); // it is black
    const tick = (/** @type {number} */ now) => {
      requestAnimationFrame(tick); // first: a fault in one frame must not end all
      this.tick(now);
    };
    requestAnimationFrame(tick);
  }

  /** @param {Layout} layout */
  takeLayout(layout) {
    this.dirty = true;
    if (layout.layout === this.layoutNumber) {
      this.follow(layout);
      this.solids.take(layout, this.shifts);
      return; // only values in it are new
    }
    this.layoutNumber = layout.layout;
    this.starts = starts(layout);
    const count = nodesOf(layout);
    const [width, height] = textureSize(count);
    this.nodes = new Blend(4 * width * height);
    this.anchors = new Blend(
      3 * layout.variants.reduce((sum, { anchors }) => sum + anchors.length, 0),
    );
    this.gaps.take(layout, -Infinity);
    this.corners = cornersOf(layout);
    this.marks.setLayout(layout);
    const key = `${layout.scene.name} ${layout.scene.preset} ${layout.variants.length > 1 && this.apart}`;
    if (key === this.sceneKey) this.follow(layout);
    else {
      this.up = layout.up;
      this.camera.setUp(layout.up);
      this.sceneKey = key;
      this.lookPending = true;
      this.range.fresh = true;
    }
    this.shift(layout);
  }

  /** Let up follow gravity that has turned; without any it stays. @param {Layout} layout */
  follow({ up, gravity }) {
    const same = up.every((value, k) => Math.abs(value - this.up[k]) < 1e-6);
    if (same || gravity.every((value) => value === 0)) return;
    this.up = up;
    this.camera.setUp(up);
    this.lookPending = true;
  }

  /** @param {Layout} layout */
  shift(layout) {
    const direction = this.lookPending ? this.camera.first : this.camera.right;
    this.shifts = shiftsOf(layout, this.apart, direction, 2.1 * layout.view.radius);
    this.solids.take(layout, this.shifts);
  }

  /** @param {boolean} apart copies side by side */
  setApart(apart) {
    this.apart = apart;
    const { layout, frame } = this.session;
    if (!layout) return;
    this.shift(layout);
    this.lookPending = true;
    if (frame) this.takeFrame(frame, true);
  }

  /** @param {Frame} frame @param {boolean} [again] the same one once more */
  takeFrame(frame, again = false) {
    const layout = /** @type {Layout} */ (this.session.layout);
    const now = performance.now();
    const jump = again || frame.time < this.lastTime || !(frame.flags & PLAYING);
    if (frame.time < this.lastTime) this.marks.trails?.clear();
    if (frame.time < this.lastTime || frame.time > this.lastTime + LEAP) {
      this.range.fresh = true; // what was strong then says nothing now
      this.marks.strongest = 0;
    }
    this.lastTime = frame.time;
    this.gaps.take(layout, frame.time);
    const nodes = this.nodes.next(now, jump);
    const extremes = gather(frame, layout, this.colouring, this.shifts, nodes);
    tame(nodes, nodesOf(layout), layout.view);
    this.past = this.session.broken !== null || (frame.flags & BROKEN) !== 0;
    const live = this.session.hello?.mode === "live"; // broken, it stands where it was still sound
    if (live || !(frame.flags & BROKEN) || this.range.unknown) {
      this.tensions = extremes.tensions;
      this.range.follow(extremes.low, extremes.high, Math.min(0.2, (now - this.lastPush) / 1000));
    }
    this.beyond = this.range.beyond(extremes.low, extremes.high);
    this.lastPush = now;
    if (!again) this.marks.take(frame);
    gatherAnchors(frame, this.shifts, this.anchors.next(now, jump));
    if (this.lookPending) this.look(layout);
    else if (!this.past) this.follower.take(layout, now);
    if (this.marks.trails) this.marks.trails.push(this.nodes.to);
    this.dirty = true;
  }

  /** Show other places of one variant's nodes than the newest frame's; null: that frame again.
   * @param {number[][] | null} positions [m] @param {number} [variant] */
  showInstead(positions, variant = 0) {
    const { frame } = this.session;
    if (!frame) return;
    if (!positions) return this.takeFrame(frame, true);
    const other = Float32Array.from(positions.flat());
    const parts = frame.parts.map((part, v) =>
      v === variant && other.length === part.positions.length
        ? { ...part, positions: other }
        : part,
    );
    this.takeFrame({ ...frame, parts, flags: frame.flags | BROKEN }, true);
  }

  /** The first look at a scene. @param {Layout} layout */
  look(layout) {
    this.lookPending = false;
    const box = boxOf(this.nodes.to, nodesOf(layout));
    const axis = flatAxis(box, this.camera.up, layout.view.radius);
    this.lying = lies(axis, this.camera.up, layout.gravity);
    this.axis = this.lying ? -1 : axis;
    this.floor.put(layout, box);
    this.follower.ropes.clear();
    this.setPose(this.framing.first(layout));
    this.following = true;
    this.flight = null;
  }

  /** The least width of a rope [CSS pixels]: of a net's less, so that its meshes are seen. */
  get leastWidth() {
    const { layout } = this.session;
    if (!layout) return 8;
    if (nodesOf(layout) > 4000) return 4;
    return layout.variants[0].ropes.length > MANY ? 5 : 8;
  }

  /** How many times thicker than it is the thickest rope is drawn in the middle of the scene. */
  thickness() {
    const { camera, session } = this;
    const ropes = session.layout?.variants.flatMap((variant) => variant.ropes) ?? [];
    const diameter = Math.max(1e-9, ...ropes.map((rope) => rope.diameter));
    return Math.max(1, (this.leastWidth * camera.pose.distance) / camera.focal / diameter);
  }

  /** Whether a pointer is down on the scene; then the camera stays. @type {() => boolean} */
  held = () => false;
  /** What to do when a flight has ended, but for one that uncovers ropes. */
  /** @type {() => void} */ landed = () => {};
  /** The legend, where it is shown. @type {() => DOMRect | null} */ legendCard = () => null;
  /** The bars of tools over the scene. @type {() => DOMRect[]} */ bars = () => [];
  windowShape = innerWidth / innerHeight;

  /** @param {Pose} pose */
  setPose(pose) {
    this.camera.set(pose);
    this.ownVersion = this.camera.version;
  }

  /** Show all ropes, from here or from other angles.
   * @param {{azimuth?: number, elevation?: number}} [from] */
  fit(from = {}) {
    const { layout } = this.session;
    if (!layout || this.nodes.empty) return;
    this.following = true;
    this.follower.ropes.clear();
    this.fly(this.framing.clear(layout, from));
  }

  /** Show all ropes if the card covers one, or the arrow of an anchor. */
  uncover() {
    if (this.lookPending || !this.framing.obstructed()) return;
    this.fit();
    this.uncovering = true;
  }

  /** @param {Pose} pose @param {number} [duration] ms */
  fly(pose, duration) {
    this.ownVersion = this.camera.version;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) this.setPose(pose);
    else this.flight = new Flight(this.camera.pose, pose, performance.now(), duration);
  }

  /** @param {Colouring} colouring */
  setColouring(colouring) {
    this.colouring = colouring;
    this.range = new Range();
    if (this.session.frame) this.takeFrame(this.session.frame, true);
  }

  /** Read the style sheet's colours again after the theme was changed. */
  setTheme() {
    this.theme = readTheme();
    this.renderer.setTheme(this.theme);
    this.dirty = true;
  }

  /** @param {number} width @param {number} height CSS pixels */
  resize(width, height) {
    const own = this.camera.version === this.ownVersion;
    this.camera.resize(width, height);
    if (own) this.ownVersion = this.camera.version;
    this.renderer.resize(width, height, Math.min(2, devicePixelRatio || 1));
    const shape = innerWidth / innerHeight; // of the window: what is opened in it keeps the camera
    if (this.following && Math.abs(shape / this.windowShape - 1) > 0.3) this.lookPending = true;
    this.windowShape = shape;
    if (this.following) this.uncover();
    if (this.past && this.following && !this.flight && this.framing.losesArrow()) this.fit();
    const { layout, frame } = this.session;
    if (layout && frame && this.lookPending) this.look(layout);
    this.renderer.clear(); // at once: a canvas of another size is empty, which is black
    this.draw(true);
  }

  /** End a flight; after one that was not to uncover ropes, they may have to be. */
  land() {
    this.flight = null;
    if (!this.uncovering) this.landed();
    this.uncovering = false;
  }

  /** Once per animation frame. @param {number} now ms */
  tick(now) {
    this.floor.advance();
    const moved = this.nodes.advance(performance.now());
    this.anchors.advance(performance.now());
    if (!this.nodes.empty) this.follower.advance(now);
    const turned = this.camera.version !== this.cameraVersion;
    const anew = turned || this.dirty || this.marks.dirty || this.renderer.unfinished;
    if (moved || anew) this.draw(moved || this.dirty);
    this.session.acknowledge();
  }

  /** @param {boolean} moved */
  draw(moved) {
    const { layout } = this.session;
    if (!layout || this.nodes.empty) return;
    if (moved) for (const hook of this.beforeDraw) hook();
    this.dirty = this.marks.dirty = false;
    this.cameraVersion = this.camera.version;
    this.solids.advance();
    const ground = groundOf(this.camera, this.floor);
    this.spacing = ground.spacing;
    this.renderer.draw({
      camera: this.camera,
      nodes: this.nodes.shown,
      moved,
      range: this.range,
      plain: this.colouring === "plain",
      dots: this.dots,
      pixels: this.leastWidth,
      smooth: !this.past,
      corners: this.corners,
      ...this.marks.collect(),
      touches: this.marks.touches,
      posts: this.marks.posts,
      trails: this.marks.trails,
      ground,
      room: layout.view,
      solids: this.solids.all,
      turns: this.solids.turns(),
    });
    this.drawn++;
    for (const hook of this.afterDraw) hook();
  }

  /** Where a node is on the screen [CSS pixels in the canvas]. @param {number} node
   * @param {number} [variant] */
  screenOf(node, variant = 0) {
    const at = 4 * (this.starts[variant] + node);
    const { shown } = this.nodes;
    const [x, y, depth] = this.camera.project(shown[at], shown[at + 1], shown[at + 2]);
    return { x, y, depth };
  }
}
