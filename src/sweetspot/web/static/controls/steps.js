// What was done since the page was opened: each step is an address that the back button, and Undo, take back.

import { byId, partOf } from "./parts.js";

export class Steps {
  constructor() {
    this.now = this.last = history.state?.step ?? 0;
  }

  // On to an address; again: the present step gets another address and none is made.
  /**
   * @param {string} address
   * @param {object} [kept] by the browser beside the address
   * @param {boolean} [again]
   */
  to(address, kept = {}, again = false) {
    this.now += again ? 0 : 1;
    this.last = this.now;
    history[again ? "replaceState" : "pushState"]({ step: this.now, ...kept }, "", address);
    this.mark();
  }

  // The browser has gone to another step by itself.
  arrive() {
    this.now = history.state?.step ?? 0;
    this.mark();
  }

  // A step back (−1) or on again (1), if there is one.
  /** @param {number} way */
  undo(way) {
    if (way < 0 ? this.now > 0 : this.now < this.last) history.go(way);
  }

  // Ctrl+Z and Ctrl+Y, but for where one types.
  /** @param {KeyboardEvent} event */
  key(event) {
    if (!(event.ctrlKey || event.metaKey) || !(event.target instanceof Element)) return;
    if (event.target.matches("textarea, input[type=number], input[type=text]")) return;
    const way = { z: event.shiftKey ? 1 : -1, y: 1 }[event.key.toLowerCase()];
    if (way) this.undo(way);
  }

  // What can be taken back, and done again.
  mark() {
    partOf(byId("tools"), "#undo", HTMLButtonElement).disabled = this.now === 0;
    partOf(byId("tools"), "#redo", HTMLButtonElement).disabled = this.now >= this.last;
  }
}
