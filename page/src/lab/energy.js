// The last seconds of the energies, drawn as curves over time.

const SECONDS = 12;
const MOST = 1500; // points kept

export class EnergyStrip {
  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    /** @type {{t: number, kinetic: number, elastic: number, gravity: number, total: number}[]} */
    this.kept = [];
    this.zero = 0;
  }

  /** Begin anew: gravity's energy counts from here. @param {number} gravity [J] */
  clear(gravity) {
    this.kept = [];
    this.zero = gravity;
  }

  /** @param {number} t @param {{kinetic: number, elastic: number, gravity: number}} energies */
  add(t, { kinetic, elastic, gravity }) {
    const fall = gravity - this.zero;
    const total = kinetic + elastic + fall;
    if (!Number.isFinite(total)) return;
    this.kept.push({ t, kinetic, elastic, gravity: fall, total });
    while (this.kept.length > MOST || this.kept[0].t < t - SECONDS) this.kept.shift();
  }

  draw() {
    const { canvas, pen, kept } = this;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    if (canvas.width !== width || canvas.height !== height)
      [canvas.width, canvas.height] = [width, height];
    pen.clearRect(0, 0, width, height);
    if (kept.length < 2) return;
    const end = Math.max(kept[kept.length - 1].t, SECONDS);
    const all = kept.flatMap((one) => [one.kinetic, one.elastic, one.gravity, one.total]);
    const [low, high] = [Math.min(...all, 0), Math.max(...all, 1e-9)];
    /** @param {number} t @param {number} value */
    const at = (t, value) =>
      /** @type {[number, number]} */ ([
        width * (1 - (end - t) / SECONDS),
        height - 4 * ratio - ((height - 8 * ratio) * (value - low)) / (high - low),
      ]);
    const style = getComputedStyle(canvas);
    pen.lineWidth = ratio;
    pen.strokeStyle = style.getPropertyValue("--grid");
    pen.beginPath();
    pen.moveTo(...at(end - SECONDS, 0));
    pen.lineTo(...at(end, 0));
    pen.stroke();
    for (const name of /** @type {const} */ (["gravity", "elastic", "kinetic", "total"])) {
      pen.lineWidth = (name === "total" ? 2.2 : 1.6) * ratio;
      pen.strokeStyle = style.getPropertyValue(`--${name}`);
      pen.beginPath();
      for (const [i, one] of kept.entries()) {
        if (i) pen.lineTo(...at(one.t, one[name]));
        else pen.moveTo(...at(one.t, one[name]));
      }
      pen.stroke();
    }
  }
}
