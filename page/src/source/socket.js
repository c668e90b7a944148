// The live source: a WebSocket to the server, found again after it was lost.

/** @typedef {import("./protocol.js").Source} Source */
/** @typedef {import("./protocol.js").SourceEvents} SourceEvents */

const WAITS = [500, 1000, 2000]; // ms, the last one again and again
const PATIENCE = 1000; // ms for a server that is there to answer
const FULL = 4503;
const ENDED = [1000, 1001, 1012]; // codes of a server that ends; the last where it had no time for a word

/** @implements {Source} */
export class SocketSource {
  constructor() {
    this.base = "./";
    /** @type {WebSocket | null} */
    this.socket = null;
    this.tries = 0;
    this.ending = "";
    this.goesOn = true; // a run that a page replays does not
    /** @type {SourceEvents | null} */
    this.events = null;
  }

  /** @param {SourceEvents} events */
  open(events) {
    this.events = events;
    this.connect();
  }

  connect() {
    const events = /** @type {SourceEvents} */ (this.events);
    const address = new URL("socket", location.href.split(/[?#]/)[0]);
    address.protocol = address.protocol.replace("http", "ws");
    const socket = new WebSocket(address, "ropewalk.1");
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    setTimeout(() => {
      if (socket.readyState === WebSocket.CONNECTING)
        events.state("waiting", "Setting up the simulation; its first run takes a minute or two …");
    }, PATIENCE);
    let there = false;
    socket.onopen = () => {
      there = true;
      events.state("open", "");
    };
    socket.onmessage = ({ data }) => {
      if (typeof data !== "string") {
        events.frame(data);
        return;
      }
      const message = JSON.parse(data);
      if (message.type === "hello") {
        [this.tries, this.ending] = [0, ""];
        this.goesOn = message.mode !== "replay";
      }
      if (message.type === "bye") this.ending = message.text;
      events.message(message);
    };
    socket.onclose = ({ code, reason }) => {
      if (this.socket !== socket) return;
      const wait = this.ending ? WAITS[2] : WAITS[Math.min(this.tries++, WAITS.length - 1)];
      if (ENDED.includes(code)) this.ending ||= "The server has ended.";
      if (code === FULL) events.state("full", reason || "As many pages as allowed are open.");
      else if (this.ending)
        events.state("ended", this.ending); // also while it is looked for again
      else if (code === 4400 || code === 4429 || code === 1009) {
        events.state("lost", `The server closed the connection: ${reason || code}.`);
      } else if (there) {
        const more = this.goesOn ? "; the run goes on there" : "";
        events.state("lost", `The connection to the server is lost${more}.`);
      } else events.state("lost", "The server does not answer: it has ended, or is out of reach.");
      setTimeout(() => this.connect(), wait);
    };
  }

  /** @param {Record<string, any>} command */
  send(command) {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }

  /** @param {number} frame */
  used(frame) {
    this.send({ type: "ack", frame });
  }
}
