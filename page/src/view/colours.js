// Colours: a perceptually uniform map and the colours of single ropes.

/** @typedef {[number, number, number]} Colour red, green, blue from 0 to 1, as shown (sRGB) */

// Okabe and Ito, "Color Universal Design" (2008), as in the package's figures.
export const ROPES = ["#3b8bc4", "#d9652b", "#1f9e77", "#c879a7", "#d99a1c", "#5ab4e0", "#8a8f98"];

export const SHADES = 256;

// Each map runs along a smooth way through OKLab (Ottosson 2020), whose distances are those of the
// eye: the hue goes from blue over red to yellow, and the lightness rises all the way, also for those who
// see two kinds of colour only (Machado, Oliveira and Fernandes 2009). [lightness, chroma, hue]
// The dark theme's keeps a contrast of 3 with its floor; in the light one a darker rim does that.
const DARK = [
  [0.555, 0.159, 276],
  [0.628, 0.114, 307],
  [0.719, 0.116, 356],
  [0.776, 0.105, 32],
  [0.828, 0.11, 60],
  [0.915, 0.142, 103],
];
const LIGHT = [
  [0.346, 0.12, 275],
  [0.475, 0.135, 315],
  [0.555, 0.14, 352],
  [0.63, 0.165, 22],
  [0.7, 0.135, 48],
  [0.765, 0.15, 82],
];

/** What is left of the light (linear) at a rope's edge. @param {boolean} dark */
export const rimOf = (dark) => (dark ? 1 : 0.42);

/** How much lighter the floor's middle is, as shown. @param {boolean} dark */
export const poolOf = (dark) => (dark ? 0.022 : 0.04);

/** @type {(lightness: number, chroma: number, hue: number) => number[]} */
const lab = (lightness, chroma, hue) => {
  const angle = (hue * Math.PI) / 180;
  return [lightness, chroma * Math.cos(angle), chroma * Math.sin(angle)];
};

/** OKLab to linear red, green, blue. @param {number[]} colour */
export function linear([L, a, b]) {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

/** Linear red, green, blue to OKLab. @param {number[]} colour */
export function oklab([r, g, b]) {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/** @param {number} value linear */
const shown = (value) => {
  const v = Math.min(1, Math.max(0, value));
  return v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;
};

/** @param {number} value as shown (sRGB) */
export const unshown = (value) =>
  value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;

/** The map of a theme as `SHADES` colours with even distances in OKLab. @param {boolean} dark
 * @returns {Colour[]} */
export function uniformMap(dark) {
  const way = dark ? DARK : LIGHT;
  const fine = [];
  const pieces = way.length - 1;
  for (let i = 0; i <= 4000; i++) {
    const at = (i / 4000) * pieces;
    const piece = Math.min(pieces - 1, Math.floor(at));
    const part = at - piece;
    const [from, to] = [way[piece], way[piece + 1]];
    let turn = to[2] - from[2];
    if (turn < -180) turn += 360;
    const hue = from[2] + part * turn;
    fine.push(lab(from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]), hue));
  }
  const lengths = [0];
  for (let i = 1; i < fine.length; i++) {
    const [p, q] = [fine[i - 1], fine[i]];
    lengths.push(lengths[i - 1] + Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  const colours = [];
  let at = 0;
  for (let shade = 0; shade < SHADES; shade++) {
    const wanted = (lengths[lengths.length - 1] * shade) / (SHADES - 1);
    while (at < lengths.length - 1 && lengths[at] < wanted) at++;
    colours.push(/** @type {Colour} */ (linear(fine[at]).map(shown)));
  }
  return colours;
}

/** @param {string} hex "#rrggbb" @returns {Colour} */
export function fromHex(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

/** @param {ArrayLike<number>} colour @param {number} [alpha] */
export function css(colour, alpha = 1) {
  const [r, g, b] = [0, 1, 2].map((i) => Math.round(255 * colour[i]));
  return alpha < 1 ? `rgba(${r}, ${g}, ${b}, ${alpha})` : `rgb(${r}, ${g}, ${b})`;
}
