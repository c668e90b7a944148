// `window.ropewalk`: what tests and curious people may look at.

/** @typedef {import("./app.js").App} App */

/** @param {App} app */
export function makeHook(app) {
  const { session, viewport } = app;
  return {
    app,
    session,
    viewport,
    /** Frames that have arrived. */
    get frames() {
      return session.frames;
    },
    /** Pictures that were drawn. */
    get drawn() {
      return viewport.drawn;
    },
    /** Number of the newest frame, as in the server's answers. */
    get frame() {
      return session.frame?.number ?? -1;
    },
    get time() {
      return session.frame?.time ?? NaN;
    },
    get renderer() {
      return viewport.renderer.name;
    },
    /** What the page shows, in a few words. */
    get state() {
      if (session.connection !== "open") return session.connection;
      if (!session.frame) return "waiting";
      if (session.broken) return "broken";
      return session.status?.playing ? "playing" : "paused";
    },
    /** Where a node of the first variant is in the window [CSS pixels]. */
    screenOf(/** @type {number} */ node, variant = 0) {
      const box = viewport.renderer.canvas.getBoundingClientRect();
      const { x, y } = viewport.screenOf(node, variant);
      return { x: x + box.left, y: y + box.top };
    },
    /** Where a node is [m], in the newest frame. */
    nodeAt(/** @type {number} */ node, variant = 0) {
      const part = session.frame?.parts[variant];
      return part ? [...part.positions.subarray(3 * node, 3 * node + 3)] : null;
    },
  };
}
