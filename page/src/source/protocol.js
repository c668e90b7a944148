// The messages of the live view, as docs/reference/live-protocol.md describes them. Types only.

/** @typedef {{name: string, first: number, nodes: number, zero: number, segments: number, length: number,
 *   EA: number | null, breaking_load?: number | null, least_load?: number | null,
 *   diameter: number, mass: number, submerged_weight: number | null, color: number}} Rope */
/** @typedef {{name: string, rope: string, node: number, index: number, motion: string,
 *   pinned: boolean, until?: number | null}} Anchor */
/** @typedef {{rope: string, node: number, index: number, mass: number}} Load */
/** @typedef {{scalars: number, positions: number, tension: number, speed: number, least_tension: number,
 *   greatest_tension: number, greatest_speed: number, least_height: number, greatest_height: number,
 *   greatest_force: number, anchors: number, contact?: number, rope_contacts?: number, wraps?: number,
 *   friction_work?: number, grabs: number}} Offsets */
/** @typedef {{label: string, method: string, changes: Record<string, any>, nodes: number, ropes: Rope[],
 *   anchors: Anchor[], loads: Load[], forces: {index: number, force: number[]}[], joints?: Joint[],
 *   parted?: Parted[], gaps?: {index: number, time: number}[], surfaces?: string[],
 *   offsets: Offsets}} Variant */
/** @typedef {{rope: string, place: number, length: number, tension: number, time: number}} Parted */
/** @typedef {{name: string, kind: string, center: number[], axis: number[], size: (number | null)[],
 *   friction: number, spin: [number, number, number | null] | null, turns?: number[][] | null,
 *   motion?: Motion | null, wheel?: number, vertices?: number[], faces?: number[], first?: number[],
 *   axle?: number[], hub?: number[], turnable?: boolean, movable?: boolean}} Obstacle */
/** @typedef {{kind: string, params: (number | null)[], table: number[][]}} Motion */
/** @typedef {{name: string, nodes: number[]}} Joint */

/** @typedef {{type: "hello", protocol: number, ropewalk: string, client: number,
 *   mode: "live" | "replay" | "program", can: string[], limits: Record<string, number>, title: string,
 *   folder: string | null, address: string, speeds: [number, number], grabs: number,
 *   exports: string[]}} Hello */
/** @typedef {{type: "layout", layout: number, bytes: number,
 *   scene: {name: string, description: string, preset: string | null}, up: number[], gravity: number[],
 *   ground: {height: number} | null, view: {center: number[], radius: number}, obstacles?: Obstacle[],
 *   scalars: string[],
 *   later?: number, variants: Variant[], broke?: {time: number, text: string} | null}} Layout */
/** @typedef {{name: string, label: string, group: string, unit: string,
 *   kind: "number" | "whole" | "vector" | "choice" | "flag", value: any, default: any,
 *   low: number, high: number, scale: "linear" | "log", minimum: number, maximum: number,
 *   choices?: {value: any, label: string}[], values?: Record<string, any> | null,
 *   defaults?: Record<string, any> | null, enabled: boolean, why: string, more: boolean, help: string}} Parameter */
/** @typedef {{name: string, title: string, theme: string, sentence: string, picture: string}} Preset */
/** `realtime` null: not measured yet.
 * @typedef {{type: "status", playing: boolean, speed: number, realtime: number | null, slow: boolean, text: string,
 *   time: number, step: number, dt: number, steps_per_frame: number, method: string, broken: boolean,
 *   clients: number, address: string, undo: string, duration: number | null, waits?: string}} Status */
/** @typedef {{stable: boolean, breaks: boolean, zone: "green" | "amber" | "red", ratio: number | null,
 *   step: number, bound: number | null, meter: number | null, meter_limit: number | null,
 *   meter_name: string | null,
 *   largest_spring_constant: number | null, largest_axial_stiffness: number | null,
 *   spring_factor: number | null, case: string, method: string, verdict: string,
 *   remedies: string[], steps: Record<string, number>}} Stability */
/** What the meter says of the step that broke. @typedef {Pick<Stability, "stable" | "bound" | "meter" |
 *   "meter_limit" | "meter_name"> & {rubs?: boolean, spring_factor?: number | null}} Cause `rubs`: without friction
 * the step would hold; `spring_factor` 0: however soft its springs are, it would not */
/** @typedef {{id: string, label: string, value?: any}} Remedy */
/** @typedef {{type: "broken", variant: number, time: number, step: number, rope: string, node: number,
 *   index: number, text: string, sign: string, cause: Cause | null, remedies: Remedy[],
 *   past?: {time: number, positions: number[][]}[]}} Broken */
/** @typedef {{type: "error", id?: number, command?: string, text: string,
 *   faults?: {path: string, value: any, rule: string, low: number | null, high: number | null}[]}} Fault */
/** @typedef {{type: "done", id: number, command: string, step: number, frame: number}} Done */

/** Where frames and messages come from and commands go to: the socket, or a run inside the page.
 * @typedef {Object} Source
 * @property {(events: SourceEvents) => void} open begin; events come from now on, none before
 * @property {(command: Record<string, any>) => void} send
 * @property {(frame: number) => void} used the page has used this frame
 * @property {string} base address of the server's files, "./", or "" where there are none
 */
/** @typedef {"open" | "waiting" | "lost" | "full" | "ended" | "damaged"} Connection */
/** @typedef {Object} SourceEvents
 * @property {(message: any) => void} message a JSON message of the server
 * @property {(frame: ArrayBuffer) => void} frame
 * @property {(state: Connection, text: string) => void} state of the connection
 */

export {};
