// The panel of what can be changed while it runs, built from the server's descriptions.

import GUI from "lil-gui";

import { unitText } from "../view/range.js";
import { backOf } from "./back.js";
import { h, icon } from "./dom.js";
import { QuantityController, VectorController, addFlag } from "./fields.js";

/** @typedef {import("../session.js").Session} Session */
/** @typedef {import("../source/protocol.js").Parameter} Parameter */
/** @typedef {{parameter: Parameter, holder: {value: any}, controller: any, back: HTMLButtonElement,
 *   fault: HTMLElement}} Row */

export class Tweak {
  /** @param {Session} session @param {HTMLElement} host */
  constructor(session, host) {
    this.session = session;
    this.host = host;
    /** @type {GUI | null} */ this.gui = null;
    /** @type {Map<string, Row>} */ this.rows = new Map();
    /** @type {Map<string, any>} values on their way, sent once per animation frame */ this.queue =
      new Map();
    /** @type {Set<string>} names whose answer has not come yet */ this.asked = new Set();
    this.rope = ""; // all ropes
    this.built = "";
    /** @type {Map<string, boolean>} folders the user has closed */ this.closed = new Map();
    session.on("parameters", (parameters) => this.build(parameters));
  }

  /** @param {Parameter[]} parameters */
  build(parameters) {
    const shape = JSON.stringify(
      parameters.map((p) => [
        p.name,
        p.kind,
        p.unit,
        p.choices,
        p.group,
        p.more,
        p.label,
        Object.keys(p.values ?? {}),
      ]),
    );
    if (shape === this.built && this.gui) this.refresh(parameters);
    else this.rebuild(parameters, shape);
  }

  /** @param {Parameter[]} parameters @param {string} shape */
  rebuild(parameters, shape) {
    const scrolled = this.host.scrollTop;
    this.built = shape;
    this.gui?.destroy();
    this.rows.clear();
    this.gui = new GUI({
      container: this.host,
      injectStyles: false,
      title: "Change it while it runs",
    });
    const ropes = [...new Set(parameters.flatMap((p) => Object.keys(p.values ?? {})))];
    if (!ropes.includes(this.rope)) this.rope = "";
    if (ropes.length > 1) this.addRopeChoice(this.gui, ropes);
    for (const parameter of parameters) if (!parameter.more) this.addRow(this.gui, parameter);
    const rest = parameters.filter(({ more }) => more);
    if (rest.length) {
      const more = this.addFolder(this.gui, "More", true);
      for (const group of [...new Set(rest.map((p) => p.group))]) {
        const folder = this.addFolder(more, group, group === "Air" || group.endsWith("ground"));
        for (const parameter of rest) if (parameter.group === group) this.addRow(folder, parameter);
      }
    }
    this.host.scrollTop = scrolled;
  }

  /** A folder that stays as the user left it. @param {GUI} parent @param {string} name
   * @param {boolean} closed at first */
  addFolder(parent, name, closed) {
    const folder = parent.addFolder(name);
    folder.onOpenClose((changed) => {
      if (changed === folder) this.closed.set(name, folder._closed);
    });
    if (this.closed.get(name) ?? closed) folder.close();
    return folder;
  }

  /** @param {GUI} folder @param {string[]} ropes */
  addRopeChoice(folder, ropes) {
    const choices = Object.fromEntries([["all ropes", ""], ...ropes.map((name) => [name, name])]);
    folder
      .add(this, "rope", choices)
      .name("Change")
      .onChange(() => this.refresh(this.session.parameters));
  }

  /** @param {GUI} folder @param {Parameter} parameter */
  addRow(folder, parameter) {
    const holder = { value: this.valueOf(parameter) };
    /** @type {any} */
    let controller;
    if (parameter.kind === "choice") {
      const names = (parameter.choices ?? []).map(({ value, label }) => [label, value]);
      controller = folder.add(holder, "value", Object.fromEntries(names));
    } else if (parameter.kind === "flag") controller = addFlag(folder, holder);
    else if (parameter.kind === "vector")
      controller = new VectorController(folder, holder, parameter);
    else controller = new QuantityController(folder, holder, parameter);
    const unit = unitText(parameter.unit);
    const back = h(
      "button",
      {
        type: "button",
        className: "back",
        onclick: () => this.set(parameter.name, null),
      },
      icon("undo"),
    );
    const fault = h("div", { className: "fault", hidden: true, role: "alert" });
    controller.name("");
    controller.$name.append(h("span", {}, parameter.label), unit && h("em", {}, unit), back);
    controller.domElement.append(fault);
    controller.domElement.dataset.parameter = parameter.name;
    controller.refused = (/** @type {string} */ text) => this.fault(parameter.name, text);
    controller.onChange((/** @type {any} */ value) => this.set(parameter.name, value));
    const row = { parameter, holder, controller, back, fault };
    this.rows.set(parameter.name, row);
    this.show(row);
  }

  /** The value of the chosen rope, or of all. @param {Parameter} parameter */
  valueOf(parameter) {
    return this.rope && parameter.values && this.rope in parameter.values
      ? parameter.values[this.rope]
      : parameter.value;
  }

  /** @param {Row} row */
  show(row) {
    const { parameter, controller, holder, back } = row;
    row.controller.parameter = parameter;
    holder.value = this.valueOf(parameter);
    controller.updateDisplay();
    controller.disable(!parameter.enabled);
    const { changed, title } = backOf(parameter, this.rope);
    back.classList.toggle("unused", !changed);
    back.disabled = !changed || !parameter.enabled;
    back.title = title;
    back.setAttribute("aria-label", `${parameter.label}: back to the scene's value`);
    controller.domElement.title = parameter.enabled
      ? parameter.help
      : parameter.why || parameter.help;
  }

  /** New descriptions of the same parameters. @param {Parameter[]} parameters */
  refresh(parameters) {
    for (const parameter of parameters) {
      const row = this.rows.get(parameter.name);
      if (!row) continue;
      row.parameter = parameter;
      if (!this.busy(parameter.name)) this.show(row);
    }
  }

  /** Whether the user is still at it. @param {string} name */
  busy(name) {
    return this.queue.has(name) || this.asked.has(name) || this.rows.get(name)?.controller.sliding;
  }

  /** Send a value at the next animation frame; the last one counts. @param {string} name
   * @param {any} value */
  set(name, value) {
    if (!this.queue.size) requestAnimationFrame(() => this.flush());
    this.queue.set(name, value);
  }

  flush() {
    for (const [name, value] of this.queue) {
      if (!this.asked.has(name)) {
        this.queue.delete(name);
        this.send(name, value);
      }
    }
  }

  /** @param {string} name @param {any} value */
  async send(name, value) {
    const row = this.rows.get(name);
    this.asked.add(name);
    try {
      const rope = this.rope && row?.parameter.values ? this.rope : null;
      await this.session.ask({ type: "set", name, value, rope });
      this.fault(name, "");
    } catch (fault) {
      this.fault(name, ruleOf(/** @type {import("../source/protocol.js").Fault} */ (fault), name));
    }
    this.asked.delete(name);
    if (this.queue.has(name)) {
      this.flush();
      return;
    }
    const now = this.rows.get(name);
    const parameter = this.session.parameters.find((p) => p.name === name);
    if (now && parameter && !now.controller.sliding) {
      now.parameter = parameter;
      this.show(now);
    }
  }

  /** @param {string} name @param {string} text */
  fault(name, text) {
    const row = this.rows.get(name);
    if (!row) return;
    row.fault.hidden = text === "";
    row.fault.textContent = text;
  }
}

/** What the row is told that was refused: where the fault is its own, without its name again.
 * @param {import("../source/protocol.js").Fault} fault @param {string} name */
function ruleOf({ text, faults }, name) {
  if (faults?.length !== 1 || faults[0].path !== name) return text;
  const [{ value, rule }] = faults;
  return value === null ? rule : `${value}: ${rule}`;
}
