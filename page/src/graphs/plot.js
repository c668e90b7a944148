// One graph over time, drawn by uPlot, with the values under the pointer below it.

import uPlot from "uplot";

import { marks, quantity } from "../view/range.js";
import { bridge, gapsOf } from "./holes.js";

/** `low` and `high` name the bounds of a band, what was between two samples.
 * @typedef {{name: string, label: string, colour: string, low?: string, high?: string}} Series */

const FONT = "11px system-ui, sans-serif";
const BESIDE = 14; // of an axis, for its ticks and beside its numbers [CSS pixels]

const colour = (/** @type {string} */ name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export class Plot {
  /** @param {HTMLElement} host @param {string} unit @param {Series[]} series
   * @param {boolean} [own] whether each has a scale of its own, and shows its shape only */
  constructor(host, unit, series, own = false) {
    this.host = host;
    this.series = series;
    const banded = series.filter(({ low, high }) => low && high);
    /** Names of the columns: the series, then low and high of each band. */
    /** Whether samples are missing before each. @type {ArrayLike<number>} */ this.apart = [];
    /** @type {uPlot.Series["gaps"]} */
    const gaps = (plot, i, first, last) => gapsOf(plot, i, first, last, this.apart);
    this.names = [
      ...series.map(({ name }) => name),
      ...banded.flatMap(({ low, high }) => [low ?? "", high ?? ""]),
    ];
    this.own = own && series.length > 1;
    const scaleOf = (/** @type {number} */ i) => (this.own ? `y${i}` : "y");
    const bound = (/** @type {string} */ stroke, /** @type {number} */ i) => ({
      scale: scaleOf(i),
      stroke: `${stroke}80`,
      width: 1,
      class: "bound", // without a line in the legend
      points: { show: false },
      gaps,
    });
    /** What the columns of each scale lie between. @type {[number | null, number | null][]} */
    this.extremes = [];
    const scales = (this.own ? series : [null]).map((_, i) => [
      scaleOf(i),
      { range: () => roomy(...(this.extremes[i] ?? [null, null])) },
    ]);
    const ink = () => colour("--faint");
    const line = { stroke: () => colour("--line"), width: 1 };
    this.uplot = new uPlot(
      {
        width: 100,
        height: 100,
        pxAlign: false,
        cursor: { drag: { x: false, y: false }, points: { size: 6 }, sync: { key: "ropewalk" } },
        legend: { live: true },
        scales: {
          x: { time: false, auto: false, range: (_, low, high) => [low, high] },
          ...Object.fromEntries(scales),
        },
        axes: [
          {
            stroke: ink,
            grid: line,
            ticks: { ...line, size: 4 },
            font: FONT,
            size: 24,
            values: (_, ticks) => marks(ticks, "s", true),
          },
          // With scales of their own the first two lines have an axis each, in their colour.
          ...(this.own ? series.slice(0, 2) : [null]).map((one, i) => ({
            scale: scaleOf(i),
            side: i === 0 ? 3 : 1,
            stroke: one ? one.colour : ink,
            grid: i === 0 ? line : { show: false },
            ticks: { ...line, size: 4 },
            font: FONT,
            size: widthOf,
            space: 15, // between two marks [CSS pixels]: a low graph has more than one
            values: (/** @type {uPlot} */ _, /** @type {number[]} */ ticks) => marks(ticks, unit),
          })),
        ],
        series: [
          { label: "time", value: (_, value) => (value === null ? "" : `${value.toFixed(2)} s`) },
          ...series.map(({ label, colour: stroke }, i) => ({
            label,
            scale: scaleOf(i),
            stroke,
            width: 1.6,
            points: { show: false },
            gaps,
            value: (/** @type {uPlot} */ _, /** @type {number} */ value) =>
              value === null ? "" : quantity(value, unit),
          })),
          ...banded.flatMap((one) => {
            const at = series.indexOf(one);
            return [bound(one.colour, at), bound(one.colour, at)];
          }),
        ],
        hooks: { drawSeries: [(plot, i) => i <= series.length && bridge(plot, i, this.apart)] },
        bands: banded.map(({ colour: fill }, i) => ({
          series: [series.length + 2 * i + 2, series.length + 2 * i + 1],
          fill: `${fill}40`,
        })),
      },
      /** @type {any} */ ([[], ...this.names.map(() => [])]),
      host,
    );
    this.resize();
  }

  resize() {
    const legend = this.host.querySelector(".u-legend");
    const below = legend instanceof HTMLElement ? legend.offsetHeight : 24;
    const width = this.host.clientWidth;
    const height = Math.max(60, this.host.clientHeight - below - 2);
    if (width > 40 && (this.uplot.width !== width || this.uplot.height !== height)) {
      this.uplot.setSize({ width, height });
    }
  }

  /** @param {Float64Array[]} columns @param {Uint8Array} apart whether samples are missing before each
   * @param {number} from @param {number} to [s] */
  show(columns, apart, from, to) {
    this.apart = apart;
    this.extremes = this.own
      ? this.series.map((_, i) => extremes(this.columnsOf(i, columns)))
      : [extremes(columns)];
    this.uplot.batch(() => {
      this.uplot.setData(/** @type {any} */ (columns), false);
      this.uplot.setScale("x", { min: from, max: to });
    });
  }

  /** Times, and the columns of one line with its bounds. @param {number} i @param {Float64Array[]} columns */
  columnsOf(i, columns) {
    const { name, low, high } = this.series[i];
    const wanted = new Set([name, low, high]);
    return columns.filter((_, k) => k === 0 || wanted.has(this.names[k - 1]));
  }

  destroy() {
    this.uplot.destroy();
  }
}

/** The width of an axis, by its longest number: none is cut off. @param {uPlot} plot
 * @param {string[] | null} values @returns {number} CSS pixels */
function widthOf(plot, values) {
  const { ctx } = plot;
  const before = ctx.font;
  ctx.font = FONT; // in CSS pixels, whatever the screen's
  const longest = Math.max(0, ...(values ?? []).map((text) => ctx.measureText(text).width));
  ctx.font = before;
  return Math.max(52, Math.ceil(longest) + BESIDE);
}

/** The least and the largest of all numbers but times; what is not there (NaN) does not count.
 * @param {Float64Array[]} columns times first @returns {[number | null, number | null]} */
export function extremes([, ...columns]) {
  let [low, high] = [Infinity, -Infinity];
  for (const column of columns) {
    for (const value of column) {
      if (!Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low <= high ? [low, high] : [null, null];
}

/** A range with room around the values, not empty where they are all the same.
 * @param {number | null} low @param {number | null} high @returns {[number, number]} */
function roomy(low, high) {
  if (low === null || high === null || !Number.isFinite(low) || !Number.isFinite(high))
    return [0, 1];
  const room = Math.max(0.08 * (high - low), 0.01 * Math.max(Math.abs(low), Math.abs(high)), 1e-9);
  return [low - room, high + room];
}
