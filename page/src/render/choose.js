// WebGL2 where there is one, else Canvas 2D; `?renderer=canvas` asks for the latter.

import { CanvasRenderer } from "./canvas/renderer.js";
import { WebglRenderer } from "./webgl/renderer.js";

/** @param {HTMLCanvasElement} canvas @returns {import("./view.js").Renderer} */
export function chooseRenderer(canvas) {
  const asked = new URLSearchParams(location.search).get("renderer");
  if (asked !== "canvas") {
    try {
      return new WebglRenderer(canvas);
    } catch (error) {
      console.info("Canvas 2D is used:", error);
      const fresh = /** @type {HTMLCanvasElement} */ (canvas.cloneNode()); // one canvas has one context
      canvas.replaceWith(fresh);
      return new CanvasRenderer(fresh);
    }
  }
  return new CanvasRenderer(canvas);
}
