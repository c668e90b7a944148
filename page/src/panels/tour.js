// The guided tour: five steps that tell the report's story, each done by the user or at a press.

import { h, icon } from "./dom.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {{title: string, text: string, act: string, press: (tour: Tour) => Promise<any> | void,
 *   done: (tour: Tour) => boolean}} Step */

const SCENES = ["r4", "hanging-rope"]; // the report's rope comes first
const STIFFER = 2;
const IMPLICIT = "bdf2"; // rather than others, as the server does after a break

/** @type {Step[]} */
const STEPS = [
  {
    title: "Hang it",
    text:
      "A rope is a chain of masses and springs. Let it hang and swing: its colour is the " +
      "tension in newtons.",
    act: "Hang the rope",
    press: (tour) => tour.hang(),
    done: ({ session, hung }) => hung && (session.frame?.time ?? 0) > 1,
  },
  {
    title: "Move it",
    text:
      "Take an anchor, one of the squares, and move it. The arrow keys do it too, at 3 " +
      "m/s. Then pull at the rope itself.",
    act: "",
    press: () => {},
    done: ({ moved }) => moved,
  },
  {
    title: "Stiffen it until it breaks",
    text:
      "Make the springs stiffer and watch the meter: beyond the red line every step " +
      "overshoots, nodes jump to and fro, and the rope breaks.",
    act: "Twice as stiff",
    press: (tour) => tour.stiffen(),
    done: ({ session }) => session.broken !== null,
  },
  {
    title: "Make the step smaller",
    text:
      "Nothing is wrong with the rope: the time step is too long for springs so stiff. A " +
      "shorter step mends it, and costs more computing.",
    act: "Use a shorter step",
    press: (tour) => tour.shorten(),
    done: ({ session }) => session.broken === null && session.stability[0]?.stable === true,
  },
  {
    title: "Take an implicit method",
    text:
      "An implicit method solves for the next state and bears any stiffness with long " +
      "steps. The meter has no red any more.",
    act: "Use an implicit method",
    press: (tour) => tour.implicit(),
    done: ({ session }) => session.stability[0]?.bound === null,
  },
];

export class Tour {
  /** @param {Session} session @param {HTMLElement} host */
  constructor(session, host) {
    this.session = session;
    this.at = -1;
    this.hung = this.moved = false;
    this.card = h("section", {
      className: "card tour",
      hidden: true,
      "aria-label": "Guided tour",
      id: "tour",
    });
    host.append(this.card);
    session.on("status", () => this.check());
    session.on("stability", () => this.check());
    session.on("broken", () => this.check());
  }

  start() {
    if (this.at >= 0) {
      this.end();
      return;
    }
    this.hung = this.moved = false;
    this.go(0);
  }

  end() {
    this.at = -1;
    this.card.hidden = true;
  }

  /** The user has moved an anchor. */
  handMoved() {
    if (this.moved) return;
    this.moved = true;
    this.check();
  }

  /** @param {number} step */
  go(step) {
    this.at = step;
    if (step >= STEPS.length) {
      this.end();
      return;
    }
    const { title, text, act, press } = STEPS[step];
    const last = step === STEPS.length - 1;
    if (step === 1) this.moved = false;
    const implicit = step !== 4 || this.implicitMethod() !== null;
    const close = h(
      "button",
      {
        type: "button",
        className: "plain close",
        "aria-label": "End the tour",
        onclick: () => this.end(),
      },
      icon("close"),
    );
    this.card.replaceChildren(
      h("header", {}, h("small", {}, `Step ${step + 1} of ${STEPS.length}`), close),
      h("h2", {}, title),
      h("p", {}, text),
      !implicit
        ? h(
            "p",
            { className: "faint" },
            "This version has no implicit method yet; a Runge-Kutta method bears a longer step.",
          )
        : "",
      h(
        "div",
        { className: "row" },
        act !== ""
          ? h(
              "button",
              {
                type: "button",
                className: "main",
                id: "tour-act",
                disabled: !implicit,
                onclick: () => press(this),
              },
              act,
            )
          : "",
        h("span", { className: "gap" }),
        step > 0
          ? h(
              "button",
              { type: "button", className: "second", onclick: () => this.go(step - 1) },
              "Back",
            )
          : "",
        h(
          "button",
          {
            type: "button",
            className: "second",
            id: "tour-next",
            onclick: () => this.go(step + 1),
          },
          last ? "Finish" : "Next",
        ),
      ),
    );
    this.card.hidden = false;
    this.check();
  }

  /** Mark the step as done; going on is the user's. */
  check() {
    if (this.at < 0) return;
    const done = STEPS[this.at].done(this);
    this.card.classList.toggle("done", done);
    const next = this.card.querySelector("#tour-next");
    if (next) next.className = done ? "main" : "second";
  }

  async hang() {
    const { session } = this;
    const preset =
      SCENES.find((name) => session.presets.some((one) => one.name === name)) ??
      session.presets[0]?.name;
    if (preset && session.can("scene")) await session.tell({ type: "scene", preset });
    this.hung = true;
    await session.tell({ type: "play" });
  }

  async stiffen() {
    const { session } = this;
    const stiffness =
      session.parameters.find((p) => p.name === "spring_constant") ??
      session.parameters.find((p) => p.name === "EA");
    if (!stiffness || typeof stiffness.value !== "number") return;
    await session.tell({ type: "set", name: stiffness.name, value: stiffness.value * STIFFER });
    if (!session.status?.playing) await session.tell({ type: "play" });
  }

  async shorten() {
    const { session } = this;
    if (session.broken) await session.tell({ type: "remedy", remedy: "step" });
    else await session.tell({ type: "set", name: "time_step", value: "auto" });
    await session.tell({ type: "play" });
  }

  /** @returns {string | null} */
  implicitMethod() {
    const method = this.session.parameters.find((p) => p.name === "method");
    const choices = method?.choices ?? [];
    if (choices.some(({ value }) => value === IMPLICIT)) return IMPLICIT;
    const found = choices.find(
      ({ value, label }) =>
        /implicit|sdirk|bdf|midpoint/i.test(`${value} ${label}`) &&
        !/semi-implicit/i.test(`${value}`),
    );
    return found ? found.value : null;
  }

  async implicit() {
    const method = this.implicitMethod();
    if (method === null) return;
    if (this.session.broken) await this.session.tell({ type: "remedy", remedy: "implicit" });
    else await this.session.tell({ type: "set", name: "method", value: method });
    await this.session.tell({ type: "play" });
  }
}
