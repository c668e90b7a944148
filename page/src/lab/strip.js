// Curves over the last seconds, with their axes; a pointer on them reads the values.

const SECONDS = 12;
const MOST = 6000; // points kept
const WINDOWS = [0.1, 0.2, 0.5, 1, 2, 5, SECONDS]; // what the time axis shows until it is full [s]
const [LEFT, FOOT, HEAD] = [56, 16, 8]; // room for the axes' numbers [px]

/** @typedef {{name: string, wide?: boolean}} Curve whose colour is the sheet's --name */
/** @typedef {{t: number, values: number[], parted?: boolean}} Point `parted`: there was nothing just before it */

const [FEW, MANY] = [3, 7]; // figures of the axis's numbers

/** @param {number} value as short as it can be @param {number} figures */
const short = (value, figures) => {
  const rounded = Number(value.toPrecision(figures)) + 0;
  return Math.abs(rounded) >= 1e5 || (rounded && Math.abs(rounded) < 1e-3)
    ? rounded.toExponential(1)
    : String(rounded);
};

export class Strip {
  /** @param {HTMLCanvasElement} canvas @param {Curve[]} curves @param {() => void} [read] called when a pointer
   * reads the curves */
  constructor(canvas, curves, read = () => this.draw()) {
    this.canvas = canvas;
    this.curves = curves;
    this.pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    /** @type {Point[]} */ this.kept = [];
    this.parted = false; // whether there is nothing since the last point
    /** @type {number | null} */ this.pointer = null; // of the canvas's width
    canvas.onpointermove = canvas.onpointerdown = (event) => {
      const box = canvas.getBoundingClientRect();
      this.pointer = (event.clientX - box.left) / box.width;
      read();
    };
    canvas.onpointerleave = () => {
      this.pointer = null;
      read();
    };
  }

  clear() {
    this.kept = [];
    this.parted = false;
    this.draw();
  }

  /** @param {number} t @param {number[]} values one of each curve, which is interrupted where they are not finite */
  add(t, values) {
    if (!values.every(Number.isFinite)) this.parted = true;
    if (!values.every(Number.isFinite) || this.kept.at(-1)?.t === t) return;
    this.kept.push({ t, values, parted: this.parted });
    this.parted = false;
    while (this.kept.length > MOST || this.kept[0].t < t - SECONDS) this.kept.shift();
  }

  /** The point under the pointer, if there is one. @returns {Point | null} */
  read() {
    const { kept, pointer } = this;
    if (pointer === null || kept.length < 2) return null;
    const { left, seconds, start } = this.#axes();
    const t = start + (seconds * (pointer - left)) / (1 - left);
    return kept.reduce((best, one) => (Math.abs(one.t - t) < Math.abs(best.t - t) ? one : best));
  }

  #axes() {
    const last = this.kept[this.kept.length - 1].t;
    const seconds = WINDOWS.find((one) => one >= last) ?? SECONDS;
    return { left: LEFT / this.canvas.clientWidth, seconds, start: Math.max(last - seconds, 0) };
  }

  draw() {
    const { canvas, pen, kept, curves } = this;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
    if (canvas.width !== width || canvas.height !== height)
      [canvas.width, canvas.height] = [width, height];
    pen.clearRect(0, 0, width, height);
    if (kept.length < 2) return;
    const { seconds, start } = this.#axes();
    const all = kept.flatMap(({ values }) => values);
    let [low, high] = [Math.min(...all), Math.max(...all)];
    if (curves.length > 1) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
    const least = 1e-9 + 1e-6 * Math.max(Math.abs(low), Math.abs(high)); // else rounding fills the graph
    const marks = low < 0 && high > 0 ? [low, 0, high] : [low, high];
    if (high - low < least) {
      marks.splice(0, 3, Math.abs(low) < least ? 0 : low); // one number says it all
      [low, high] = [low - least, high + least];
    }
    /** @param {number} t @param {number} value @returns {[number, number]} */
    const at = (t, value) => [
      LEFT * ratio + ((width - (LEFT + 4) * ratio) * (t - start)) / seconds,
      height - FOOT * ratio - ((height - (FOOT + HEAD) * ratio) * (value - low)) / (high - low),
    ];
    this.#grid(at, { low, high, start, seconds }, marks, ratio);
    const style = getComputedStyle(canvas);
    for (const [k, { name, wide }] of curves.entries()) {
      const points = kept.map(({ t, values }) => at(t, values[k]));
      const begins = kept.map(({ parted }) => parted ?? false);
      this.#line(points, style.getPropertyValue(`--${name}`), (wide ? 2.2 : 1.6) * ratio, begins);
    }
    const read = this.read();
    if (!read) return;
    const [x] = at(read.t, low);
    const ends = /** @type {[number, number][]} */ ([
      [x, HEAD * ratio],
      [x, height - FOOT * ratio],
    ]);
    this.#line(ends, style.getPropertyValue("--accent"), ratio);
  }

  /** @param {(t: number, value: number) => [number, number]} at
   * @param {{low: number, high: number, start: number, seconds: number}} range
   * @param {number[]} marks values that are told @param {number} ratio */
  #grid(at, { low, high, start, seconds }, marks, ratio) {
    const { pen, canvas } = this;
    const style = getComputedStyle(canvas);
    pen.fillStyle = style.getPropertyValue("--faint");
    pen.font = `${11 * ratio}px system-ui, sans-serif`;
    const room = Math.abs(at(0, low)[1] - at(0, high)[1]);
    let figures = FEW; // so many that no two numbers look the same
    while (figures < MANY && new Set(marks.map((one) => short(one, figures))).size < marks.length)
      figures++;
    for (const value of marks) {
      const [, y] = at(start, value);
      const close = marks.some(
        (other) => other !== value && (Math.abs(value - other) / (high - low)) * room < 12 * ratio,
      );
      this.#line(
        [at(start, value), at(start + seconds, value)],
        style.getPropertyValue("--grid"),
        ratio,
      );
      if (value === 0 && close) continue; // no room for the zero's sign
      pen.textAlign = "right";
      pen.fillText(short(value, figures), (LEFT - 5) * ratio, y + 4 * ratio);
    }
    for (const share of [0, 0.5, 1]) {
      const t = start + share * seconds;
      const [x, y] = at(t, low);
      pen.textAlign = share === 0 ? "left" : share === 1 ? "right" : "center";
      pen.fillText(`${Number(t.toFixed(2))} s`, x, y + 13 * ratio);
    }
  }

  /** @param {[number, number][]} points @param {string} style @param {number} width
   * @param {boolean[]} begins whether a line begins anew at a point */
  #line(points, style, width, begins = []) {
    const { pen } = this;
    pen.lineWidth = width;
    pen.strokeStyle = style;
    pen.beginPath();
    for (const [i, point] of points.entries()) {
      if (i && !begins[i]) pen.lineTo(...point);
      else pen.moveTo(...point);
    }
    pen.stroke();
  }
}
