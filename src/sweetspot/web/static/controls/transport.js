// Play, pause, step and scrub through a time that is drawn, by pointer and keyboard.
//
//   const transport = new Transport(app, { field: "moment_ms", onMoment(seconds) {} });
//   box.append(transport.element); transport.keys(root);        // transport.end() when the view goes
//   transport.set({ from, to, frames: [seconds], slowness });   // after every answer
//   transport.play(); transport.pause(); transport.moment
//
// The moment is the view's own while it plays or is scrubbed; where it rests, it goes into app.state[field] in ms.

import { button } from "./controls.js";
import { changed, write } from "./parts.js";
/** @import { App, Field, State } from "../shell/main.js" */

/** @type {Record<string, (transport: Transport) => void>} */
const KEYS = { k: (transport) => transport.flip(), ",": (transport) => transport.step(-1), ".": (transport) => transport.step(1) };

export class Transport {
  /**
   * @param {App} app
   * @param {{ field: Field, onMoment: (moment: number) => void, describe: (moment: number) => { short: string, long: string } }} options
   */
  constructor(app, { field, onMoment, describe }) {
    this.app = app;
    this.field = field;
    this.onMoment = onMoment;
    this.describe = describe;
    this.moment = this.known = 0;
    this.from = 0;
    this.to = 1;
    /** @type {number[]} */
    this.frames = [];
    this.slowness = 1000;
    /** @type {(() => void) | null} */
    this.stop = null;
    this.toggle = button("Play", () => this.flip(), { primary: true, title: "Play or pause (K)" });
    this.toggle.id = "play";
    const back = button("◀", () => this.step(-1), { title: "One picture back (,)" });
    const on = button("▶", () => this.step(1), { title: "One picture on (.)" });
    back.setAttribute("aria-label", "One picture back");
    on.setAttribute("aria-label", "One picture on");
    this.range = Object.assign(document.createElement("input"), { type: "range", id: "moment", step: "0.001" });
    this.range.setAttribute("aria-label", "Moment, ms after first touch");
    this.range.addEventListener("input", () => {
      this.pause();
      this.show(Number(this.range.value) / 1000);
    });
    this.range.addEventListener("change", () => this.rest());
    this.words = Object.assign(document.createElement("span"), { className: "moment", ariaHidden: "true" }); // the slider says it
    this.element = Object.assign(document.createElement("div"), { className: "transport" });
    this.wrong = Object.assign(document.createElement("p"), { className: "fault", hidden: true });
    this.element.append(this.toggle, back, this.range, on, this.words, this.wrong);
    app.control({ field, sync: (state) => this.sync(state), fault: (message) => {
      this.wrong.textContent = message;
      this.wrong.hidden = message === "";
    } });
  }

  /** @param {{ from: number, to: number, frames: number[], slowness: number }} given */
  set({ from, to, frames, slowness }) {
    Object.assign(this, { from, to, frames, slowness });
    const [least, most] = [String(from * 1000), String(to * 1000)];
    if (this.range.min !== least) this.range.min = least;
    if (this.range.max !== most) this.range.max = most;
    this.show(this.moment, false);
  }

  // The address' moment, unless it is the one that this view has just put there.
  /** @param {State} state */
  sync(state) {
    const moment = Number(state[this.field]);
    if (moment === this.known || this.stop) return;
    this.known = moment;
    this.moment = moment / 1000;
    if (this.frames.length) this.show(this.moment);
  }

  /** @param {number} moment */
  show(moment, draw = true) {
    this.moment = Math.min(this.to, Math.max(this.from, moment));
    if (document.activeElement !== this.range || this.stop || Math.abs(Number(this.range.value) / 1000 - this.moment) > 2e-6)
      this.range.value = String(this.moment * 1000);
    const { short, long } = this.describe(this.moment);
    write(this.words, short);
    if (this.range.ariaValueText !== long) this.range.ariaValueText = long;
    if (draw) this.onMoment(this.moment);
  }

  // Leave the moment in the address.
  rest() {
    const moment = Math.round(this.moment * 1e6) / 1000;
    this.known = moment;
    if (moment !== this.app.state[this.field]) this.app.setState(changed(this.field, moment));
    this.app.announce(this.describe(this.moment).long);
  }

  flip() {
    if (this.stop) {
      this.pause();
      this.rest();
    } else this.play();
  }

  play() {
    if (this.stop) return;
    if (this.moment >= this.to - 1e-9) this.moment = this.from;
    /** @type {number | null} */
    let before = null;
    this.stop = this.app.onFrame((now) => {
      const passed = before === null ? 0 : Math.min(100, now - before);
      before = now;
      if (!this.app.rests) return; // the picture follows the hand, and stays at its moment
      this.show(this.moment + passed / 1000 / this.slowness);
      if (this.moment >= this.to - 1e-9) this.pause();
    });
    this.label();
  }

  // Whether pictures come by themselves.
  get moving() {
    return this.stop !== null && this.app.rests;
  }

  pause() {
    this.stop?.();
    this.stop = null;
    this.label();
  }

  label() {
    this.toggle.textContent = this.stop ? "Pause" : "Play";
  }

  // To the next or the last picture of the answer.
  /** @param {number} direction */
  step(direction) {
    this.pause();
    const margin = 1e-9;
    const next = direction > 0 ? this.frames.find((time) => time > this.moment + margin)
      : [...this.frames].reverse().find((time) => time < this.moment - margin);
    this.show(next ?? (direction > 0 ? this.to : this.from));
    this.rest();
  }

  /** @param {HTMLElement} root */
  keys(root) {
    this.heard = new AbortController();
    root.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || !(event.target instanceof Element) || event.target.matches("input[type=number], input[type=text], select, textarea")) return;
      const act = KEYS[event.key.toLowerCase()];
      if (!act) return;
      event.preventDefault();
      act(this);
    }, { signal: this.heard.signal });
  }

  // Nothing moves or listens any more.
  end() {
    this.stop?.();
    this.stop = null;
    this.heard?.abort();
  }
}
