// Where the line of a graph has nothing to tell of, and how that is drawn.

import uPlot from "uplot";

const PAUSE = 3; // s without a sample over which nothing goes
const DOT = 1.8; // of a sample beside what is missing [CSS pixels]

/** Where a line must not go [canvas pixels]: over samples that are not there, and over long pauses.
 * @param {uPlot} plot @param {number} index of the series @param {number} first @param {number} last
 * @param {ArrayLike<number>} apart @returns {[number, number][]} */
export function gapsOf(plot, index, first, last, apart) {
  const [times, values] = [plot.data[0], plot.data[index]];
  const across = (/** @type {number} */ i) => plot.valToPos(times[i], "x", true);
  return holes(times, /** @type {any} */ (values), first, last, apart).map(([from, to]) => [
    across(from),
    across(to),
  ]);
}

/** The samples between which there is nothing. @param {ArrayLike<number>} times
 * @param {ArrayLike<number>} values @param {number} first @param {number} last
 * @param {ArrayLike<number>} [apart] whether samples are missing before each
 * @returns {[number, number][]} */
export function holes(times, values, first, last, apart = []) {
  /** @type {[number, number][]} */ const found = [];
  let before = -1; // the last sample that is there
  for (let i = first; i <= last; i++) {
    if (!Number.isFinite(values[i])) continue;
    if (before >= 0 && (i > before + 1 || apart[i] || times[i] - times[before] > PAUSE))
      found.push([before, i]);
    before = i;
  }
  return found;
}

/** Mark the samples beside what is missing by dots, and join them by dots where it is little: the eye
 * finds its way, and sees that nothing is known there. @param {uPlot} plot @param {number} index of the series
 * @param {ArrayLike<number>} apart */
export function bridge(plot, index, apart) {
  const { ctx, bbox, data, series } = plot;
  const times = data[0];
  const values = /** @type {number[]} */ (/** @type {unknown} */ (data[index]));
  const found = holes(times, values, 0, times.length - 1, apart).filter(([a, b]) => b === a + 1);
  if (!found.length || !times.length) return;
  const { scale = "y", stroke } = series[index];
  const at = (/** @type {number} */ i) =>
    /** @type {const} */ ([
      plot.valToPos(times[i], "x", true),
      plot.valToPos(values[i], scale, true),
    ]);
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.strokeStyle = ctx.fillStyle = String(
    typeof stroke === "function" ? stroke(plot, index) : stroke,
  );
  ctx.lineWidth = uPlot.pxRatio;
  ctx.setLineDash([1.5 * uPlot.pxRatio, 3 * uPlot.pxRatio]);
  for (const [a, b] of found) {
    ctx.beginPath();
    ctx.moveTo(...at(a));
    if (times[b] - times[a] <= PAUSE) ctx.lineTo(...at(b));
    ctx.stroke();
    for (const i of [a, b]) {
      ctx.beginPath();
      ctx.arc(...at(i), DOT * uPlot.pxRatio, 0, 2 * Math.PI);
      ctx.fill();
    }
  }
  ctx.restore();
}
