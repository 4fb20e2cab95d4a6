// A file that somebody was given: one implement, its ball and its hits, computed here, without a server or a network.

import { Along } from "./along.js";
import { Bat } from "./bat.js";
import { Picture } from "./picture.js";
import { SlowMotion } from "./slowmotion.js";
import { Speaker } from "./said.js";
import { sheet } from "./worksheet.js";
import { LITTLE, NEAR_BEST, NO_CONTACT, REACH, SEPARATED } from "./kernel.js";
import { group, slider } from "../controls/controls.js";
import { byId, make } from "../controls/parts.js";
import { text } from "../controls/units.js";
/** @import { App } from "../shell/main.js" */
/** @import { System } from "../controls/units.js" */
/** @import { Values } from "./said.js" */
/** @typedef {{ impact_from_tip_in: number, pitch_speed_mph: number, bat_speed_mph: number }} State */
/** @typedef {ReturnType<File["answer"]>} Answer */

const { numbers, words, drawing, state: first, bounds, units, sizes, system, filmed } = JSON.parse(byId("content").textContent ?? "{}");

// What the page's own parts (controls.js, chart.js, transport.js) ask of the page that they are on.
export class File {
  constructor() {
    this.bat = new Bat(numbers, sizes.inch);
    this.words = words;
    this.drawing = drawing;
    this.numbers = numbers;
    this.sizes = sizes;
    this.speaker = new Speaker(units);
    /** @type {System} */
    this.units = this.speaker.system = system;
    /** @type {State} */
    this.state = { ...first };
    this.schema = Object.fromEntries(Object.entries(bounds).map(([field, [minimum, maximum]]) => [field, { minimum, maximum }]));
    /** @type {{ field: string, sync: (state: object) => void }[]} */
    this.controls = [];
    /** @type {Record<string, string>} */
    this.colors = {};
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.rests = true;
    this.signal = new AbortController().signal;
    this.drawn = 0;
    this.text = (/** @type {string} */ kind, /** @type {number | null} */ value, /** @type {number} */ digits) => text(kind, value, this.units, digits);
    const app = /** @type {App} */ (/** @type {unknown} */ (this));
    this.picture = new Picture(this, app);
    this.film = filmed ? new SlowMotion(this, app) : null;
    this.build(app);
    const dark = matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", () => this.recolor());
    addEventListener("beforeprint", () => this.unfold(true));
    addEventListener("afterprint", () => this.unfold(false));
    this.recolor();
  }

  /** @param {App} app */
  build(app) {
    const { labels } = words;
    const fields = /** @type {[keyof State, string, number][]} */ ([["impact_from_tip_in", labels.place, 0.1], ["pitch_speed_mph", labels.pitch, 1], ["bat_speed_mph", labels.swing, 1]]);
    const sliders = fields.filter(([field]) => field in bounds).map(([field, label, step]) => slider(app, field, { label, step }));
    byId("controls").append(group(labels.controls, sliders, { open: true }));
    const choose = make("fieldset", { className: "switch" }, make("legend", { className: "unseen", textContent: labels.units }));
    for (const one of /** @type {System[]} */ (["us", "si"])) {
      const button = make("input", { type: "radio", name: "units", value: one, checked: one === this.units });
      button.addEventListener("change", () => this.change(one));
      choose.append(make("label", {}, button, make("span", { textContent: labels[one] })));
    }
    const print_ = make("button", { type: "button", textContent: labels.print });
    print_.addEventListener("click", () => print());
    const work = make("button", { type: "button", id: "worksheet", textContent: labels.worksheet });
    work.addEventListener("click", () => sheet(this, work));
    byId("tools").append(choose, print_, work);
    this.about = make("details", { className: "card" }, make("summary", { textContent: labels.about }));
    byId("rest").append(this.about);
  }

  // -- what the page's parts call

  /** @param {Partial<State>} change */
  setState(change) {
    Object.assign(this.state, change);
    this.state.impact_from_tip_in = (this.bat.placeAt(this.state.impact_from_tip_in * 10) - this.bat.scanned.length + this.bat.first) / 10;
    this.later();
  }
  commit() {}
  announce() {}
  /** @param {{ field: string, sync: (state: object) => void }} control */
  control(control) { this.controls.push(control); }
  /** @param {unknown} _ @param {() => void} draw */
  afterwards(_, draw) { draw(); }
  /** @param {(now: number) => void} step */
  onFrame(step) {
    let going = true;
    const frame = (/** @type {number} */ now) => {
      if (!going) return;
      step(now);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    return () => (going = false);
  }

  // -- answers

  // Once before the next picture, however much has changed until then.
  later() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  answer() {
    const { bat, state: { impact_from_tip_in: tip, pitch_speed_mph: pitch, bat_speed_mph: swing } } = this;
    const turning = (swing * sizes.mph) / (numbers.measured_at - numbers.turned_about), speeds = { pitch: pitch * sizes.mph, turning };
    if (this.along?.speeds.pitch !== speeds.pitch || this.along.speeds.turning !== turning) this.along = new Along(bat, speeds);
    const place = bat.placeAt(tip * 10), position = bat.positions[place];
    const closing = speeds.pitch + turning * (position - numbers.turned_about);
    const [hit] = bat.hits([place], [closing]), here = bat.told(place, hit, speeds);
    return { along: this.along, place, hit, here, closing, half: this.half(place, closing), leaves: hit.outcome === SEPARATED };
  }

  // Half of the interval of the exit speed at a place that can be hit, m/s; null where it is not known.
  /** @param {number} place @param {number} closing */
  half(place, closing) {
    const error = this.bat.error(place, closing);
    return error === null ? null : REACH * error;
  }

  draw() {
    const answer = this.answer(), said = this.say(answer);
    for (const control of this.controls) control.sync(this.state);
    this.picture.draw(answer, said);
    this.film?.update(answer);
    this.drawn += 1;
    document.body.dataset.drawn = String(this.drawn);
  }

  // The sentences and numbers of an answer, in the reader's units.
  /** @param {Answer} answer */
  say({ along, hit, here, half, leaves }) {
    const { speaker } = this, { length } = numbers, { best, fastest } = along;
    const ends = leaves ? "separated" : hit.outcome === NO_CONTACT ? "no_contact" : "still_in_contact";
    /** @type {Values} */
    const values = { from_tip: length - here.position, exit_speed: here.exit, best_from_tip: length - best, fastest };
    const lost = leaves ? fastest - here.exit : null;
    const headline = [speaker.fill(words.fastest, values), speaker.fill(words.here[ends], values)].join(" ");
    /** @type {Record<string, number | null>} */
    const facts = { exit_speed: here.exit, lost, efficiency: here.q, bbcor: here.bbcor, peak_force: hit.force, contact_time: hit.contact, hand_impulse: here.jolt, sting: here.sting };
    const look = { digits: null, sign: false, unit: true, round: false };
    return {
      headline,
      why: leaves ? `${this.why(along, here)} ${this.misses(along)}`.trim() : "",
      facts: words.facts.map((/** @type {{ label: string, scale: string, value: string }} */ { label, scale, value }) => [
        label, value === "exit_speed" && leaves ? speaker.withHalf(here.exit, half, scale) : speaker.number(leaves || value === "peak_force" ? facts[value] : null, { scale, ...look })]),
    };
  }

  // Why the ball leaves as it does: `why_here`.
  /** @param {Along} along @param {ReturnType<Bat["told"]>} here */
  why(along, here) {
    const { best, speeds } = along, parts = along.difference(here), near = Math.abs(here.position - best) < NEAR_BEST;
    const faster = here.bat - speeds.turning * (best - numbers.turned_about), vibrates = Math.abs(parts.keeping) > LITTLE;
    const there = 1 / (1 / numbers.body.mass + (best - numbers.body.balance_point) ** 2 / numbers.body.moi_cm);
    return this.speaker.tell(words.why, {
      near, near_in_the_middle: near, near_but_met_off_axis: false, faster_here: !near && faster > 0, slower_here: !near && !(faster > 0),
      keeping_told: !near && vibrates, keeping_untold: !near && !vibrates, keeps_more: !near && vibrates && parts.keeping < 0,
      keeps_less: !near && vibrates && !(parts.keeping < 0), change: Math.abs(faster), ...parts, met_here: here.met, met_there: there, whole_mass: numbers.body.mass,
    });
  }

  // What it costs to miss the best place, `miss_words`.
  /** @param {Along} along */
  misses(along) {
    const costs = words.costs.map((/** @type {any} */ { distance, words: on, off }) => {
      const { inside, outside } = along.miss(distance);
      return this.speaker.fill(Number.isNaN(outside) ? off : on, { distance, inside, outside });
    });
    return costs.length ? this.speaker.fill(words.misses, { costs: costs.join(words.between) }) : "";
  }

  // -- looks

  /** @param {System} to */
  change(to) {
    this.units = this.speaker.system = to;
    this.tellAbout();
    this.later();
  }

  tellAbout() {
    this.about?.replaceChildren(this.about.firstElementChild ?? "", ...words.about[this.units].map((/** @type {string} */ textContent) => make("p", { textContent })));
  }

  recolor() {
    const style = getComputedStyle(document.documentElement);
    const names = ["ink", "muted", "grid", "line", "paper", "panel", "accent", "zone", "zone-edge", "zone-ink", "blue", "sky", "green", "orange", "red", "purple", "wood", "wood-edge", "metal", "metal-edge", "hollow"];
    this.colors = Object.fromEntries(names.map((name) => [name.replace(/-(\w)/g, (_, letter) => letter.toUpperCase()), style.getPropertyValue(`--${name}`).trim()]));
    this.tellAbout();
    this.later();
  }

  // On paper what is folded is open.
  /** @param {boolean} open */
  unfold(open) {
    for (const fold of document.querySelectorAll("details")) {
      if (open) fold.dataset.open = String(fold.open);
      fold.open = open || fold.dataset.open === "true";
    }
  }
}

new File();
