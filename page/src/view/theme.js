// Light and dark: the colours of the scene are read from the style sheet, so that they are kept once.

import { fromHex, rimOf } from "./colours.js";

/** @typedef {import("../render/view.js").Theme} Theme */

const NAMES = /** @type {const} */ ([
  "background",
  "horizon",
  "grid",
  "shadow",
  "ground",
  "anchor",
  "hand",
  "load",
  "arrow",
  "grab",
  "pin",
  "hover",
  "node",
  "post",
  "body",
  "joint",
  "contact",
]);
const KEY = "ropewalk-theme";

/** @returns {"light" | "dark"} */
export function chosenTheme() {
  const asked = new URLSearchParams(location.search).get("theme") ?? stored();
  if (asked === "light" || asked === "dark") return asked;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

function stored() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null; // storage may be forbidden, as in a page opened from disk
  }
}

/** @param {"light" | "dark"} name @param {boolean} keep remember it for the next visit */
export function applyTheme(name, keep = false) {
  document.documentElement.dataset.theme = name;
  if (!keep) return;
  try {
    localStorage.setItem(KEY, name);
  } catch {
    // it is then asked again the next time
  }
}

/** The scene's colours in the theme that is on. @returns {Theme} */
export function readTheme() {
  const dark = document.documentElement.dataset.theme === "dark";
  const style = getComputedStyle(document.documentElement);
  const colours = Object.fromEntries(
    NAMES.map((name) => [
      name,
      fromHex(style.getPropertyValue(`--scene-${name}`).trim() || "#888888"),
    ]),
  );
  return /** @type {Theme} */ ({
    ...colours,
    rim: rimOf(dark),
    dark,
  });
}
