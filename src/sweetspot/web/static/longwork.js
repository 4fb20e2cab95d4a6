// Long work on the server (web/jobs.py): begun, looked at while it grows, stopped, gone on with. It outlives a view: who
// comes back to it sees how far it is, until nobody has asked for half a minute and the server stops it.
//
//   const work = longWork("design/search");            // one a name, as long as the page is open
//   work.watch(app.signal, (work) => draw(work));      // after every change, until the signal
//   work.start(state); work.stop(); work.goOn();
//   work.status   "none", "starting", "running", "done", "stopped", "failed"
//   work.found    the last that came, null before; work.fault   { field, message } or null

import { posted } from "./post.js";

const PAUSE = 400; // ms between two looks
/** @type {Map<string, Work>} */
const all = new Map();

/** @param {string} name */
export function longWork(name) {
  const known = all.get(name) ?? new Work(name);
  all.set(name, known);
  return known;
}

class Work {
  /** @param {string} name */
  constructor(name) {
    this.name = name;
    /** @type {string | null} */
    this.key = null;
    this.status = "none";
    /** @type {any} */
    this.found = null; // as the view's own work has it
    /** @type {{ field: string, message: string } | null} */
    this.fault = null;
    this.seen = 0;
    /** @type {string | null} */
    this.taken = null; // what of it a view has taken over already
    /** @type {((work: Work) => void) | null} */
    this.onChange = null;
    this.turn = 0;
  }

  /**
   * @param {AbortSignal} signal
   * @param {(work: Work) => void} onChange
   */
  watch(signal, onChange) {
    this.onChange = onChange;
    signal.addEventListener("abort", () => this.onChange === onChange && (this.onChange = null));
    onChange(this);
    if (this.key && this.status === "running") this.look();
  }

  /** @param {object} state */
  async start(state) {
    Object.assign(this, { key: null, status: "starting", found: null, fault: null, seen: 0 });
    this.onChange?.(this);
    try {
      this.key = (await posted(`/api/v1/${this.name}`, state)).job;
    } catch (fault) {
      this.failed(fault);
      return;
    }
    this.look();
  }

  stop() { return this.look({ stop: true }); }
  goOn() { return this.look({ go_on: true }); }

  /** @param {any} fault */
  failed(fault) {
    Object.assign(this, { status: "failed", fault });
    this.onChange?.(this);
  }

  // Ask once, tell what has changed, and ask again later while it runs and somebody watches.
  /** @param {{ stop?: boolean, go_on?: boolean }} also */
  async look(also = {}) {
    this.turn += 1;
    const turn = this.turn;
    clearTimeout(this.timer);
    let told;
    try {
      told = await posted(`/api/v1/jobs/${this.key}`, { seen: this.seen, ...also });
    } catch (fault) {
      if (turn === this.turn) this.failed(fault);
      return;
    }
    if (turn !== this.turn) return;
    const { status, count, found, error } = told;
    Object.assign(this, { status, seen: count, found: found ?? this.found, fault: error });
    this.onChange?.(this);
    if (status === "running" && this.onChange) this.timer = setTimeout(() => this.look(), PAUSE);
  }
}
