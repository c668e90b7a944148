// One graph over time, drawn by uPlot, with the values under the pointer below it.

import uPlot from "uplot";

import { figures, quantity } from "../view/range.js";

/** `low` and `high` name the bounds of a band, what was between two samples.
 * @typedef {{name: string, label: string, colour: string, low?: string, high?: string}} Series */

const PAUSE = 3; // s without a sample that leave a gap

const colour = (/** @type {string} */ name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export class Plot {
  /** @param {HTMLElement} host @param {string} unit @param {Series[]} series */
  constructor(host, unit, series) {
    this.host = host;
    this.series = series;
    const banded = series.filter(({ low, high }) => low && high);
    /** Names of the columns: the series, then low and high of each band. */
    this.names = [
      ...series.map(({ name }) => name),
      ...banded.flatMap(({ low, high }) => [low ?? "", high ?? ""]),
    ];
    const bound = (/** @type {string} */ stroke) => ({
      stroke: `${stroke}80`,
      width: 1,
      class: "bound", // without a line in the legend
      points: { show: false },
      gaps: gapsOf,
    });
    /** @type {number | null} */ this.low = null;
    /** @type {number | null} */ this.high = null;
    const ink = () => colour("--faint");
    const line = { stroke: () => colour("--line"), width: 1 };
    const font = "11px system-ui, sans-serif";
    this.uplot = new uPlot(
      {
        width: 100,
        height: 100,
        pxAlign: false,
        cursor: { drag: { x: false, y: false }, points: { size: 6 }, sync: { key: "ropewalk" } },
        legend: { live: true },
        scales: {
          x: { time: false, auto: false, range: (_, low, high) => [low, high] },
          y: { range: () => roomy(this.low, this.high) },
        },
        axes: [
          {
            stroke: ink,
            grid: line,
            ticks: { ...line, size: 4 },
            font,
            size: 24,
            values: (_, ticks) => ticks.map((t) => `${figures(t)} s`),
          },
          {
            stroke: ink,
            grid: line,
            ticks: { ...line, size: 4 },
            font,
            size: 52,
            space: 20, // between two marks [CSS pixels]: a low graph has more than one
            values: (_, ticks) => ticks.map((v) => quantity(v, unit)),
          },
        ],
        series: [
          { label: "time", value: (_, value) => (value === null ? "" : `${value.toFixed(2)} s`) },
          ...series.map(({ label, colour: stroke }) => ({
            label,
            stroke,
            width: 1.6,
            points: { show: false },
            gaps: gapsOf,
            value: (/** @type {uPlot} */ _, /** @type {number} */ value) =>
              value === null ? "" : quantity(value, unit),
          })),
          ...banded.flatMap(({ colour: stroke }) => [bound(stroke), bound(stroke)]),
        ],
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

  /** @param {Float64Array[]} columns @param {number} from @param {number} to [s] */
  show(columns, from, to) {
    [this.low, this.high] = extremes(columns);
    this.uplot.batch(() => {
      this.uplot.setData(/** @type {any} */ (columns), false);
      this.uplot.setScale("x", { min: from, max: to });
    });
  }

  destroy() {
    this.uplot.destroy();
  }
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

/** Where a line must not go [canvas pixels]: over samples that are not there, and over long pauses.
 * @param {uPlot} plot @param {number} index of the series @param {number} first @param {number} last
 * @returns {[number, number][]} */
function gapsOf(plot, index, first, last) {
  const [times, values] = [plot.data[0], plot.data[index]];
  const across = (/** @type {number} */ i) => plot.valToPos(times[i], "x", true);
  return holes(times, /** @type {any} */ (values), first, last).map(([from, to]) => [
    across(from),
    across(to),
  ]);
}

/** The samples between which there is nothing. @param {ArrayLike<number>} times
 * @param {ArrayLike<number>} values @param {number} first @param {number} last
 * @returns {[number, number][]} */
export function holes(times, values, first, last) {
  /** @type {[number, number][]} */ const found = [];
  let before = -1; // the last sample that is there
  for (let i = first; i <= last; i++) {
    if (!Number.isFinite(values[i])) continue;
    if (before >= 0 && (i > before + 1 || times[i] - times[before] > PAUSE))
      found.push([before, i]);
    before = i;
  }
  return found;
}
