// Long work on the server (web/jobs.py): begun, looked at while it grows, stopped, gone on with. It outlives a view, a
// reload of the page and a server that does not answer for a while; work that no page asks about the server stops.
//
//   const work = longWork("design/search");            // one a name, as long as the tab is open
//   work.watch(app.signal, (work) => draw(work));      // after every change, until the signal
//   work.start(state, about); work.stop(); work.goOn();
//   work.status   "none", "starting", "running", "done", "stopped", "failed"
//   work.found    the last that came, null before; work.fault   { field, message } or null
//   work.about    what the view wants to know of it still after a reload
//   work.takenOver()      the view holds what came of it: a reload need not ask for it again

import { keep, kept } from "./kept.js";
import { posted } from "./post.js";
/** @import { Jobs } from "../answers.js" */
/** @import { State } from "./main.js" */

const PAUSE = 400; // ms between two looks
const ELSEWHERE = 5000; // the same while another view is open
const LOST = 2000; // the same while the server does not answer
/** @typedef {{ "season/read": Jobs["season"]["read"], "design/search": Jobs["design"]["search"] }} Works what comes of each */
/** @type {Map<string, unknown>} */
const all = new Map();

/** @template {keyof Works} Name @param {Name} name @returns {Work<Name>} */
export function longWork(name) {
  const known = /** @type {Work<Name> | undefined} */ (all.get(name)) ?? new Work(name);
  all.set(name, known);
  return known;
}

/** @template {keyof Works} Name */
class Work {
  /** @param {Name} name */
  constructor(name) {
    this.name = name;
    /** @type {{ key: string | null, about: Partial<State> | null }} */
    const before = kept(name, { key: null, about: null });
    /** @type {string | null} */
    this.key = before.key;
    this.about = before.about; // as the view's own work has it
    this.status = this.key ? "running" : "none"; // until the server has said how it stands
    /** @type {Works[Name] | null} */
    this.found = null;
    /** @type {{ field: string, message: string } | null} */
    this.fault = null;
    this.seen = 0;
    this.taken = false;
    /** @type {((work: Work<Name>) => void) | null} */
    this.onChange = null;
    this.turn = 0;
  }

  /** @param {AbortSignal} signal @param {(work: Work<Name>) => void} onChange */
  watch(signal, onChange) {
    this.onChange = onChange;
    signal.addEventListener("abort", () => this.onChange === onChange && (this.onChange = null));
    onChange(this);
    if (this.key && this.status === "running") this.look();
  }

  /** @param {object} state @param {Partial<State> | null} about */
  async start(state, about = null) {
    Object.assign(this, { key: null, about, status: "starting", found: null, fault: null, seen: 0, taken: false });
    this.onChange?.(this);
    try {
      this.key = (await posted(`/api/v1/${this.name}`, state)).job;
    } catch (fault) {
      this.failed(fault);
      return;
    }
    keep(this.name, { key: this.key, about });
    this.look();
  }

  stop() { return this.look({ stop: true }); }
  goOn() { return this.look({ go_on: true }); }

  takenOver() {
    this.taken = true;
    keep(this.name, null);
  }

  /** @param {{ field: string, message: string }} fault */
  failed(fault) {
    Object.assign(this, { key: null, status: "failed", fault });
    keep(this.name, null);
    this.onChange?.(this);
  }

  // Ask once, tell what has changed, and ask again later while it runs, or until a lost server is back.
  /** @param {{ stop?: boolean, go_on?: boolean }} also */
  async look(also = {}) {
    this.turn += 1;
    const turn = this.turn;
    clearTimeout(this.timer);
    let told;
    try {
      told = await posted(`/api/v1/jobs/${this.key}`, { seen: this.seen, ...also });
    } catch (fault) {
      if (turn !== this.turn) return;
      if (!(/** @type {{ lost?: boolean }} */ (fault)?.lost)) {
        this.failed(fault);
        return;
      }
      this.fault = { field: "", message: "The server does not answer; this is looked after again once it does." };
      this.onChange?.(this);
      this.timer = setTimeout(() => this.look(also), LOST);
      return;
    }
    if (turn !== this.turn) return;
    const { status, count, found, error } = told;
    Object.assign(this, { status, seen: count, found: found ?? this.found, fault: error });
    this.onChange?.(this);
    if (status === "running") this.timer = setTimeout(() => this.look(), this.onChange ? PAUSE : ELSEWHERE);
  }
}
