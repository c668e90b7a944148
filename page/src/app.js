// The page: puts viewport, hand, panels and graphs together over one session.

import { Keys } from "./input/keys.js";
import { Walk } from "./input/walk.js";
import { Pointer } from "./input/pointer.js";
import { Graphs } from "./graphs/graphs.js";
import { BalanceNote } from "./panels/balance.js";
import { Bar } from "./panels/bar.js";
import { BrokenCard } from "./panels/broken.js";
import { Compare } from "./panels/compare.js";
import { Controls } from "./panels/controls.js";
import { h } from "./panels/dom.js";
import { Help } from "./panels/help.js";
import { Keep } from "./panels/keep.js";
import { Labels } from "./panels/labels.js";
import { Legend } from "./panels/legend.js";
import { Meter } from "./panels/meter.js";
import { Notices } from "./panels/notices.js";
import { PartedNote } from "./panels/parted.js";
import { Scenes } from "./panels/scenes.js";
import { Tools } from "./panels/tools.js";
import { Tour } from "./panels/tour.js";
import { Tweak } from "./panels/tweak.js";
import { Views } from "./panels/views.js";
import { Viewport } from "./viewport.js";
import { placeOn } from "./view/cards.js";
import { applyTheme } from "./view/theme.js";

/** @typedef {import("./session.js").Session} Session */
/** @typedef {import("./render/view.js").Renderer} Renderer */

const NARROW = "(max-width: 700px), (max-height: 500px)";

export class App {
  /** @param {HTMLElement} root @param {Session} session
   * @param {(canvas: HTMLCanvasElement) => Renderer} render */
  constructor(root, session, render) {
    this.session = session;
    this.root = root;
    const part = (/** @type {keyof HTMLElementTagNameMap} */ tag, /** @type {string} */ name) =>
      h(tag, { className: name, id: name });
    this.barHost = part("header", "bar");
    this.meterHost = part("section", "meter");
    this.scene = part("main", "scene");
    this.panel = part("aside", "panel");
    this.graphHost = part("section", "graphs");
    this.footer = part("footer", "controls");
    const canvas = h("canvas", { id: "view", tabIndex: 0, "aria-label": "The ropes" });
    this.scene.append(canvas);
    root.replaceChildren(
      this.barHost,
      this.meterHost,
      this.scene,
      this.panel,
      this.graphHost,
      this.footer,
    );
    this.graphHost.hidden = true;

    this.viewport = new Viewport(session, render(canvas));
    this.labels = new Labels(this.viewport, this.scene);
    this.notices = new Notices(session, this.scene);
    this.legend = new Legend(this.viewport, this.scene);
    this.parted = new PartedNote(session, (text) => this.notices.say(text));
    this.balance = new BalanceNote(session);
    this.legend.card.append(this.parted.host, this.balance.host);
    this.views = new Views(this.viewport, this.scene);
    this.graphs = new Graphs(this.viewport, this.graphHost);
    this.tools = new Tools(
      this.viewport,
      this.scene,
      (node) => this.follow(node),
      (text, kind) => this.notices.say(text, kind),
    );
    this.pointer = new Pointer(this.viewport, this.viewport.renderer.canvas, {
      use: (tool, hit) => this.tools.use(tool, hit),
      tie: (one, other) => {
        this.tools.tieNone();
        this.viewport.marks.tying = one;
        this.tools.tie(other);
      },
      menu: (hit, x, y) => this.tools.menu(hit, x, y),
    });
    this.tools.pointer = this.pointer;
    const voice = h("div", { className: "unseen", role: "status", id: "voice" });
    this.scene.append(voice);
    this.walk = new Walk(this.viewport, this.viewport.renderer.canvas, voice, (hit, x, y) =>
      this.tools.menu(hit, x, y),
    );
    this.viewport.legendCard = () => this.legend.place();
    this.viewport.bars = () =>
      [this.tools.bar, this.views.bar].flatMap((bar) => placeOn(bar, canvas) ?? []);
    this.viewport.held = () => this.pointer.down.size > 0;
    this.meter = new Meter(session, this.meterHost);
    this.controls = new Controls(session, this.footer, () => this.graphs.toggle());
    this.controls.undoing = () => this.pointer.leaveOff();
    this.tweak = new Tweak(session, this.panel);
    this.broken = new BrokenCard(session, this.scene, (...what) =>
      this.viewport.showInstead(...what),
    );
    this.tour = new Tour(session, this.scene);
    this.scenes = new Scenes(session, root);
    this.compare = new Compare(this.viewport, root, this.scene, (many) =>
      this.compareColours(many),
    );
    const compared = this.viewport.card;
    this.viewport.card = () => this.broken.place(this.viewport.renderer.canvas) ?? compared();
    for (const news of /** @type {const} */ (["broken", "frame"]))
      session.on(news, () => this.uncoverBroken());
    let late = 0; // flights that were on when the words came up, or set off from them
    session.on("broken", () => (late = 0));
    this.viewport.landed = () => late++ < 2 && this.uncoverBroken();
    this.help = new Help(root);
    this.keep = new Keep(this.viewport, root, this.notices);
    this.bar = new Bar(this.barHost, {
      scenes: () => this.scenes.open(),
      tour: () => this.tour.start(),
      compare: () => this.compare.open(),
      keep: (at) => this.keep.open(at),
      help: () => this.help.open(),
      theme: () => this.toggleTheme(),
      panel: () => this.togglePanel(),
    });
    this.keys = new Keys(session, this.viewport.camera, this.shortcuts());
    this.watchHand();
    this.panel.hidden = matchMedia(NARROW).matches;
    new ResizeObserver(() => this.resize()).observe(this.scene);
    this.resize();
    session.on("hello", () => this.hello());
    session.on("layout", ({ scene }) => this.bar.show(scene.name));
    session.on("status", ({ address }) => this.writeAddress(address));
    this.asked = false;
    addEventListener("hashchange", () => this.openAddress());
  }

  /** The words about a break must not hide what they are about. */
  uncoverBroken() {
    const { viewport, session } = this;
    if (session.broken && viewport.following && !viewport.flight && !viewport.held())
      viewport.uncover();
  }

  /** @returns {Record<string, () => void>} */
  shortcuts() {
    return {
      " ": () => this.controls.toggle(),
      ".": () => this.controls.doStep(),
      r: () => this.controls.doReset(),
      undo: () => this.controls.doUndo(), // Ctrl and Z
      f: () => this.viewport.fit(),
      g: () => this.graphs.toggle(),
      p: () => this.togglePanel(),
      t: () => this.toggleTheme(),
      h: () => this.help.open(),
      "?": () => this.help.open(),
      escape: () => this.tools.tieNone(),
    };
  }

  /** The tour wants to know when the hand moved something. */
  watchHand() {
    const { source } = this.session;
    const send = source.send.bind(source);
    source.send = (command) => {
      send(command);
      if (["drag", "move", "grab", "obstacle"].includes(command.type)) this.tour.handMoved();
    };
  }

  hello() {
    const { session } = this;
    const hello = /** @type {import("./source/protocol.js").Hello} */ (session.hello);
    const drawn = this.viewport.renderer.name === "webgl" ? "WebGL" : "Canvas 2D";
    this.help.version.textContent = `Ropewalk ${hello.ropewalk}, drawn with ${drawn}.`;
    this.root.dataset.mode = hello.mode;
    this.bar.compare.hidden = !session.can("compare");
    this.bar.tour.hidden = !session.can("set");
    this.bar.choose.disabled = !session.can("scene");
    const tweak = session.can("set");
    if (!tweak) this.panel.hidden = true;
    this.bar.panel.hidden = !tweak;
    if (!this.asked && location.hash.slice(1) !== hello.address) this.openAddress();
    this.asked = true;
    this.resize();
  }

  /** Open the set-up that the page's address names. */
  openAddress() {
    const { session } = this;
    const wanted = location.hash.slice(1);
    if (wanted && wanted !== session.status?.address && session.can("scene")) {
      session.tell({ type: "scene", address: wanted });
    }
  }

  /** @param {string} address */
  writeAddress(address) {
    if (!this.session.source.base || !address || location.hash.slice(1) === address) return;
    history.replaceState(null, "", `#${address}`);
  }

  /** @param {number} node of the first variant */
  follow(node) {
    this.viewport.marks.toggleTrail(node);
    this.graphs.rebuild();
    if (!this.graphs.open && this.viewport.marks.followed.size === 1 && !matchMedia(NARROW).matches)
      this.graphs.toggle(true);
  }

  /** Several copies are told apart by colour. @param {boolean} many */
  compareColours(many) {
    this.legend.select.value = many ? "plain" : "tension";
    this.legend.choose();
  }

  togglePanel() {
    if (this.bar.panel.hidden) return; // there is nothing to change in a recording
    this.panel.hidden = !this.panel.hidden;
    this.resize();
  }

  toggleTheme() {
    applyTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark", true);
    this.viewport.setTheme();
    this.graphs.rebuild();
  }

  resize() {
    this.root.classList.toggle("with-panel", !this.panel.hidden);
    const { clientWidth, clientHeight } = this.scene;
    if (clientWidth && clientHeight) this.viewport.resize(clientWidth, clientHeight);
  }
}
