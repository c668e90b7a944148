// Events by name.

/** @template {Record<string, any>} T */
export class Emitter {
  constructor() {
    /** @type {Map<keyof T, ((value: any) => void)[]>} */
    this.listeners = new Map();
  }

  /** @template {keyof T} K @param {K} name @param {(value: T[K]) => void} listener */
  on(name, listener) {
    const list = this.listeners.get(name) ?? [];
    list.push(listener);
    this.listeners.set(name, list);
  }

  /** @template {keyof T} K @param {K} name @param {T[K]} value */
  emit(name, value) {
    for (const listener of this.listeners.get(name) ?? []) listener(value);
  }
}
