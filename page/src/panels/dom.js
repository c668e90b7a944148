// Elements: built by script, text always as text.

/** @typedef {Node | string | null | false | undefined} Child */

/** Make an element; keys that start with "on" are listeners, others are properties or attributes.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag @param {Record<string, any>} [properties] @param {...Child} children
 * @returns {HTMLElementTagNameMap[K]} */
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (value === undefined || value === null) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key.includes("-") || key === "role" || key === "for")
      element.setAttribute(key, String(value));
    else if (key === "data") Object.assign(element.dataset, value);
    else Object.assign(element, { [key]: value });
  }
  for (const child of children) if (child) element.append(child);
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

// Drawn on 24 by 24, as lines.
const ICONS = {
  play: "M8 5.5v13l10.5-6.5z",
  pause: "M8 5v14M16 5v14",
  step: "M6 5.5v13l9-6.5zM18.5 5v14",
  reset: "M5 12a7 7 0 1 0 2.3-5.2M5 4.5v4.2h4.2",
  fit: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
  hand:
    "M8.5 12V6.2a1.4 1.4 0 0 1 2.8 0V11M11.3 10V4.9a1.4 1.4 0 0 1 2.8 0V11" +
    "M14.1 10.5V6.3a1.4 1.4 0 0 1 2.8 0V14" +
    "c0 4-2 6.5-5.3 6.5-3 0-4.3-1.5-5.8-4.2L4 13.2c-.8-1.5 1.1-2.6 2.2-1.3l2.3 2.6",
  pin: "M9 3.5h6M10 3.5l-.6 6.2L6.5 13h11l-2.9-3.3L14 3.5M12 13v7.5",
  cut:
    "M6.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4z" +
    "M17.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM8 15.5L16.5 4M16 15.5L7.5 4",
  load: "M12 3v5M12 8a1.5 1.5 0 0 0 0 0M7.5 10h9l2.5 10H5z",
  tie: "M3.5 8.5c6 0 11 7 17 7M3.5 15.5c6 0 11-7 17-7M12 9.2a2.8 2.8 0 1 1 0 5.6 2.8 2.8 0 0 1 0-5.6z",
  kick: "M4 12h13M12 6l6 6-6 6",
  follow: "M4 18c3-9 6 1 9-6 2-4.5 4-4 7-6",
  graph: "M4 4v16h16M7.5 15l3.5-5 3.5 3 5-7.5",
  scenes: "M4 5.5h7v5.5H4zM13.5 5.5H20v5.5h-6.5zM4 13.5h7V19H4zM13.5 13.5H20V19h-6.5z",
  tour: "M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM15.8 8.2l-2.3 5.3-5.3 2.3 2.3-5.3z",
  compare: "M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",
  keep: "M12 4v10.5M7.5 10.5L12 15l4.5-4.5M4.5 16v3.5h15V16",
  help:
    "M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18z" +
    "M9.5 9.5a2.6 2.6 0 1 1 3.6 2.4c-.8.4-1.1.9-1.1 1.8M12 16.8v.2",
  theme: "M12 20.5a8.5 8.5 0 1 0 0-17zM12 20.5a8.5 8.5 0 0 1 0-17",
  panel: "M4 7h9M17 7h3M15 5v4M4 12h3M11 12h9M9 10v4M4 17h11M19 17h1M17 15v4",
  more:
    "M5.5 11.2a.8.8 0 1 0 0 1.6.8.8 0 0 0 0-1.6zM12 11.2a.8.8 0 1 0 0 1.6.8.8 0 0 0 0-1.6z" +
    "M18.5 11.2a.8.8 0 1 0 0 1.6.8.8 0 0 0 0-1.6z",
  close: "M6 6l12 12M18 6L6 18",
  down: "M6 9.5l6 6 6-6",
  link:
    "M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1" +
    "M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",
  sound: "M4 9.5v5h3.5L12 18.5v-13L7.5 9.5zM15 9.5a3.5 3.5 0 0 1 0 5M17.5 7a7 7 0 0 1 0 10",
  undo: "M8.5 6L4.5 10l4 4M4.5 10h9a5.5 5.5 0 0 1 0 11h-2",
};

/** @typedef {keyof typeof ICONS} IconName */

/** @param {IconName} name @param {boolean} [solid] */
export function icon(name, solid = false) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  svg.classList.add("icon");
  if (solid) svg.classList.add("solid");
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", ICONS[name]);
  svg.append(path);
  return svg;
}

/** A button with an icon, and with words where there is room.
 * @param {IconName} name @param {string} title @param {() => void} press
 * @param {{words?: string, key?: string, id?: string, kind?: string}} [more] */
export function button(name, title, press, more = {}) {
  const label = more.key ? `${title} (${more.key})` : title;
  return h(
    "button",
    {
      type: "button",
      title: label,
      "aria-label": title,
      onclick: press,
      id: more.id ?? "",
      className: more.kind ?? "plain",
    },
    icon(name, name === "play"),
    more.words && h("span", { className: "words" }, more.words),
  );
}

/** A button for a bar that has no room for all of its buttons; the style sheet says where that is.
 * @param {HTMLElement} bar @param {string} title */
export function unfolder(bar, title) {
  const one = button("more", title, () => set(!bar.classList.contains("unfolded")), {
    kind: "plain fold",
  });
  const set = (/** @type {boolean} */ open) => {
    bar.classList.toggle("unfolded", open);
    one.setAttribute("aria-expanded", String(open));
  };
  set(false);
  bar.addEventListener("click", ({ target }) => {
    if (target instanceof Element && target.closest("button:not(.fold)")) set(false); // it is chosen
  });
  return one;
}

/** A window over the page, closed by Escape, its button or a press beside it.
 * @param {string} title @param {string} kind @param {...Child} children */
export function dialog(title, kind, ...children) {
  const close = h(
    "button",
    { type: "button", className: "plain close", "aria-label": "Close", title: "Close" },
    icon("close"),
  );
  const box = h(
    "dialog",
    { className: `window ${kind}`, "aria-label": title },
    h("header", {}, h("h2", {}, title), close),
    ...children,
  );
  close.onclick = () => box.close();
  box.addEventListener("close", () => {
    // the keys are the rope's again, not those of the button that opened this
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  });
  box.addEventListener("click", (event) => {
    if (event.target === box) box.close();
  });
  return box;
}

/** A small menu at a place, closed by the next press elsewhere.
 * @param {HTMLElement} host @param {number} x @param {number} y in the host
 * @param {{label: string, press: () => void, id?: string, disabled?: boolean, hint?: string}[]} items
 * @param {string} [title] */
export function popup(host, x, y, items, title = "") {
  host.querySelector(".popup")?.remove();
  const menu = h(
    "div",
    { className: "popup", role: "menu" },
    title && h("div", { className: "popup-title" }, title),
  );
  const opener = document.activeElement;
  const close = () => {
    const held = menu.contains(document.activeElement);
    menu.remove();
    if (held && opener instanceof HTMLElement) opener.focus({ preventScroll: true });
    removeEventListener("pointerdown", outside, true);
    removeEventListener("keydown", escape, true);
  };
  const outside = (/** @type {Event} */ event) => {
    if (!menu.contains(/** @type {Node} */ (event.target))) close();
  };
  const escape = (/** @type {KeyboardEvent} */ event) => {
    if (event.key === "Escape") close();
  };
  menu.addEventListener("keydown", (event) => goInMenu(menu, event));
  for (const item of items) {
    const press = () => {
      close();
      item.press();
    };
    menu.append(
      h(
        "button",
        {
          type: "button",
          role: "menuitem",
          onclick: press,
          disabled: item.disabled ?? false,
          id: item.id ?? "",
        },
        item.label,
        item.hint && h("small", {}, item.hint),
      ),
    );
  }
  host.append(menu);
  const room = host.getBoundingClientRect();
  menu.style.left = `${Math.max(4, Math.min(x, room.width - menu.offsetWidth - 4))}px`;
  menu.style.top = `${Math.max(4, Math.min(y, room.height - menu.offsetHeight - 4))}px`;
  addEventListener("pointerdown", outside, true);
  addEventListener("keydown", escape, true);
  menu.querySelector("button")?.focus({ preventScroll: true });
  return menu;
}

/** The arrows, Home and End go from item to item. @param {HTMLElement} menu @param {KeyboardEvent} event */
function goInMenu(menu, event) {
  const items = [.../** @type {NodeListOf<HTMLButtonElement>} */ (menu.querySelectorAll("button"))];
  const able = items.filter((one) => !one.disabled);
  const here = able.findIndex((one) => one === document.activeElement);
  const to = { ArrowDown: here + 1, ArrowUp: here - 1, Home: 0, End: able.length - 1 }[event.key];
  if (to === undefined || !able.length) return;
  event.preventDefault();
  event.stopPropagation(); // the arrows are no anchor's now
  able[(to + able.length) % able.length].focus({ preventScroll: true });
}

/** A file for the user to keep. @param {string} address @param {string} name */
export function download(address, name) {
  const link = h("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
}
