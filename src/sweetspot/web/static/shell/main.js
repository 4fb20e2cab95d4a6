// The page's shell: which view, with which state, asked over the socket, drawn when the answer comes.
//
// How to write a view, say static/views/modes.js (plain ES modules; web/bundle.py puts them into two files, nothing comes from elsewhere):
//
//   export default class ModesView {  // made anew whenever it is opened: its constructor gives every field a value
//     static guide = [[title, words]];   // the steps of the guide
//     constructor(root, app) {}       // build the elements once; no answer is there yet
//     update(answer, state) {}        // a new answer, or the same one again after a change of units, theme or size: draw
//     unmount() {}                    // optional: stop what runs; the shell empties root
//     bring(files) {}                // optional: take files of the view's kind, wherever they were dropped
//     other(kind) {}                  // optional: take what another sport hits with, "" for a bat, where it is chosen
//     figures() { return []; }        // optional: [{ name, width, height, paint(context, width, height) }] for PNG and SVG;
//                                     //   paint uses only what SvgContext in svgcontext.js knows of a canvas' 2d context
//     table() { return {}; }          // optional: { column_name_with_unit: [numbers] } for CSV
//   }
//
// The app that it gets:
//
//   app.state, app.setState({field: value}, {commit: false})   commit false while dragging (no step for the back button)
//   app.schema     JSON schema of each field: app.schema.pitch_speed_mph.maximum
//   app.answer     the last one, null before
//   app.units      "us" or "si"; app.text("exit_speed_m_s", 41.2) is "92.2 mph"; see units.js
//   app.colors     the theme's colours for canvases: ink, muted, grid, paper, panel, accent, zone, zoneEdge, zoneInk,
//                  blue, sky, green, orange, red, purple, wood, woodEdge, hollow
//   app.onFrame(step)   calls step(milliseconds) before every repaint until the returned function is called or the view goes
//   app.announce(text)  says something to a screen reader, at most twice a second
//   app.ask("own/tap", state)   a promise of another answer, of a view or one of its asides, over the API
//   app.aside(name, but, wait, onAnswer)   asks for one of the view's asides (web/view.py) once the state has rested
//   app.afterwards(who, draw)   draws what may follow the picture: while something is dragged, once the hand rests
//   app.rests      whether no hand is dragging just now: what moves by itself stands still meanwhile
//   app.lists("bats", "parks")   a promise of { bats, parks }; there are also balls, materials, leagues, implements, pitches
//   app.bounds(field)        [least, most] that the bat of the last answer allows, undefined where it sets none
//   app.signal     an AbortSignal that ends when the view goes: give it to listeners on what outlives the view
//   app.control(control)     registers a control made by controls.js; those made with (app, field, ...) do it themselves
//   app.calm       true where people asked their system for less motion: do not start animations by yourself

import { LONG_ADDRESS, addressOf, shortAddressOf, stateIn, unknownIn } from "./address.js";
import { Bench } from "../bat/bench.js";
import { Chip } from "../bat/chip.js";
import { drawerOf } from "./drawer.js";
import { defaultsOf, fieldsOf } from "../controls/fields.js";
import { guide } from "./guide.js";
import { Later } from "./later.js";
import { Lists } from "./lists.js";
import { byId, partOf, write } from "../controls/parts.js";
import { posted } from "./post.js";
import { shareButton } from "./share.js";
import { Line } from "./socket.js";
import { showAbsent, showFaults, showStatus, showUnknown } from "./status.js";
import { Steps } from "../controls/steps.js";
import { explain, listTerms } from "./terms.js";
import { exportButton, menuButton, stepButton, switchOf, themeButton } from "./toolbar.js";
import { text } from "../controls/units.js";
import { HOME, fillBar, pointBar } from "./viewbar.js";
import { fetchOthers, fetched } from "./viewfiles.js";
/** @import { Answers, Asides, BallPicture, BatState, Catalogue, HitConditions, States, UsualHit } from "../answers.js" */
/** @import { Property, Schema } from "../controls/fields.js" */
/** @import { System } from "../controls/units.js" */

const facts = JSON.parse(document.getElementById("facts")?.textContent ?? "{}");
/** @type {Field[]} */
const CARRIED = facts.carried; // from view to view
const LONGEST_ADDRESS = 16000; // of a packed one, which the server still takes
const LONG_FIELD = 1000; // letters beyond which a field does not go into an address that is too long
const EMBED = "/embed/";
const AGAIN = 2000; // ms until a view's files that could not be fetched are asked for again
const QUESTION = "answer";
const MEANINGS = "meanings of words";

/** @typedef {keyof Answers} ViewName */
/** @typedef {{ [Name in ViewName]: keyof Asides[Name] }[ViewName]} AsideName of some view */
/**
 * @template {AsideName} Aside
 * @typedef {{ [Name in ViewName]: Aside extends keyof Asides[Name] ? Asides[Name][Aside] : never }[ViewName]} AsideAnswer
 */
/** @typedef {{ [Name in ViewName]: keyof States[Name] }[ViewName]} Field of some view */
/** @typedef {{ [Wanted in Exclude<Field, "others">]: { [Name in ViewName]: Wanted extends keyof States[Name] ? States[Name][Wanted] : never }[ViewName] } & { others: Partial<BatState>[] }} State of a view, which has some of these fields */
/**
 * What is read of an answer by the shell and by parts that views share, where it has it.
 * @typedef {object} Answer
 * @property {{ name: string, length_m: number, mass_kg: number, bounds: Record<string, [number, number]>, usual?: UsualHit, swung?: Record<System, string> | null, sport?: string }} [bat]
 * @property {Partial<BallPicture>} [ball]
 * @property {{ name: string } | null} [tool]
 * @property {HitConditions} [conditions]
 * @property {string} [sport]
 */
/** @template {string} Path @typedef {Path extends `${infer Name extends ViewName}/${infer Aside}` ? Aside extends keyof Asides[Name] ? Asides[Name][Aside] : never : Path extends ViewName ? Answers[Path] : never} AnswerAt */
/** @typedef {Record<string, string>} Colors by name */
/** @typedef {{ name: string, width: number, height: number, paint: (context: CanvasRenderingContext2D, width: number, height: number) => void }} Figure */
/** @typedef {{ field: string, message: string, words?: Record<System, string>, more?: Fault[], again?: boolean }} Fault words: for readers of either system, where it tells lengths or weights */
/** @typedef {{ commit?: boolean, merge?: string | null, instead?: boolean }} Step how a change goes into the address */
/** @typedef {{ field: string, follows?: boolean, sync: (state: State) => void, fault?: (message: string) => void }} Control */
/** @typedef {{ name: string, title: string, group: string, schema: Record<string, Property>, bat: string[] }} Entry group: of views; none for the first page */
/** @typedef {[string, string][]} Guide title and words of each step */
/** @typedef {{ update(answer: Answer, state: State): void, unmount?(): void, other?(kind: string): void, bring?(files: File[]): void | Promise<void>, figures?(): Figure[], table?(): Record<string, unknown[]> }} View */
/** @template {ViewName} Name @typedef {{ aside<Aside extends keyof Asides[Name]>(name: Aside, but: string[], wait: number, onAnswer: (answer: Asides[Name][Aside]) => void): void }} AsidesOf */
/** @template {ViewName} Name @typedef {AsidesOf<Name> & App<Answers[Name] & Answer>} AppOf */

/** @template {Answer} [Own=Answer] of the view */
export class App {
  /** @type {View | null} */
  view = null; // until the first one's files are there
  /** @type {Guide} */
  guide = [];
  state = /** @type {State} */ ({});
  defaults = /** @type {State} */ ({});
  name = "";
  /** @type {AbortSignal} */
  signal = new AbortController().signal;
  /** @type {Colors} */
  colors = {};

  constructor() {
    /** @type {Map<string, Entry>} */
    this.views = new Map(facts.views.map((/** @type {{ name: string, title: string, group: string, schema: Schema }} */ { name, title, group, schema }) => [
      name, { name, title, group, schema: fieldsOf(schema), bat: Object.keys(schema.$defs?.BatState?.properties ?? {}) }]));
    const units = new URLSearchParams(location.search).get("units") ?? localStorage.getItem("units"); // a shared picture has its own
    /** @type {System} */
    this.units = units === "si" ? "si" : "us";
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    /** @type {Map<string, Control>} */
    this.controls = new Map();
    this.steps = new Steps();
    this.later = new Later(this);
    this.catalogue = new Lists((what, yes) => this.waits(what, yes), () => (this.hollow = true));
    this.lost = false; // whether the server is
    this.hollow = false; // whether the view lacks what a lost server could not give
    /** @type {Set<(now: number) => void>} */
    this.frames = new Set();
    /** @type {Partial<State>} */
    this.carried = {}; // what goes along from view to view: the bat, how it is swung, where the ball meets it
    /** @type {Map<string, Partial<State>>} */
    this.left = new Map(); // view -> its own controls as they were left
    /** @type {Set<string>} */
    this.awaited = new Set(); // what is asked for and not there yet; #view says it as data-waiting
    this.turn = 0;
    /** @type {Fault[]} */
    this.faults = []; // of the present state
    this.embedded = location.pathname.startsWith(EMBED);
    /** @type {Own | null} */
    this.answer = null;
    this.version = facts.version;
    this.chip = new Chip(this);
    this.bench = new Bench(this);
    this.line = new Line({
      apart: true,
      onAnswer: (view, answer, state) => view === this.name && this.answers(/** @type {Own} */ (answer), state),
      onFault: (view, fault, state) => view === this.name && this.faulted(fault, state),
      onStatus: (status) => this.heard(status),
    });
  }

  // What is known of a view; every name that the page uses is known.
  /** @param {string} name @returns {Entry} */
  entry(name) {
    const known = this.views.get(name);
    if (known) return known;
    throw new RangeError(`there is no view ${name}`);
  }

  get schema() {
    return this.entry(this.name).schema;
  }

  /** @param {string} name @param {number | null} value @param {number} [digits] */
  text(name, value, digits) {
    return text(name, value, this.units, digits);
  }

  /** @param {string} field @returns {[number, number] | undefined} */
  bounds(field) {
    return this.answer?.bat?.bounds?.[field];
  }

  // A merge is a name: steps of the same one after the other, such as key presses on a slider, are undone together.
  // Instead: nobody asked for this step, so that going back does not lead to what was before it.
  /** @param {Partial<State>} partial @param {Step} [step] */
  setState(partial, { commit = true, merge = null, instead = false } = {}) {
    this.take({ ...this.state, ...partial });
    if (commit) this.commit({ merge, instead });
    else this.later.dragged = true;
  }

  // Note that something has been asked for, or is there.
  /** @param {string} what */
  waits(what, yes = true) {
    if (this.awaited.has(what) === yes) return;
    this.awaited[yes ? "add" : "delete"](what);
    byId("view").dataset.waiting = [...this.awaited].join(" ");
  }

  /** @param {State} state */
  take(state) {
    this.waits(QUESTION);
    this.state = state;
    this.later.moved = performance.now();
    Object.assign(this.carried, Object.fromEntries(CARRIED.filter((field) => Object.hasOwn(this.schema, field)).map((field) => [field, state[field]])));
    this.left.set(this.name, state);
    this.line.ask(this.name, state);
    for (const control of this.controls.values()) control.sync(state);
    this.bench.sync();
    this.chip.sync();
  }

  // Put the state into the address as a step that the back button, and Undo, take back.
  /** @param {Step} [step] */
  commit({ merge = null, instead = false } = {}) {
    this.later.dragged = false;
    const again = instead || (merge !== null && merge === this.merging);
    this.merging = merge;
    let address = addressOf(this.name, this.state, this.defaults, this.embedded);
    /** @type {{ view?: string, state?: State }} */
    let kept = {};
    const long = address.length > LONG_ADDRESS;
    if (long) { // the browser keeps the rest, so that back and reload work at once; packed it all goes into the address
      const short = Object.entries(this.state).map(([field, value]) => [field, (JSON.stringify(value) ?? "").length > LONG_FIELD ? this.schema[field].default ?? null : value]);
      address = addressOf(this.name, Object.fromEntries(short), this.defaults, this.embedded);
      kept = { view: this.name, state: this.state };
    }
    if (kept.view || history.state?.view || address !== location.pathname + location.search) this.steps.to(address, kept, again);
    if (long) this.pack(this.state);
    pointBar(this);
  }

  // Give the present step an address that holds its long state, unless someone has gone on meanwhile.
  /** @param {State} state */
  async pack(state) {
    const address = await shortAddressOf(this.name, state, this.defaults, this.embedded);
    if (history.state?.state && state === this.state && address.length <= LONGEST_ADDRESS) history.replaceState(history.state, "", address);
  }

  /** @param {Control} control */
  control(control) {
    this.controls.set(control.field, control);
    control.sync(this.state);
  }

  /** @param {(now: number) => void} step @returns {() => void} */
  onFrame(step) {
    this.frames.add(step);
    if (this.frames.size === 1) requestAnimationFrame((now) => this.frame(now));
    return () => this.frames.delete(step);
  }

  /** @param {number} now */
  frame(now) {
    for (const step of this.frames) step(now);
    if (this.frames.size) requestAnimationFrame((later) => this.frame(later));
  }

  /** @param {string} words */
  announce(words) {
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => (byId("announcer").textContent = words), 500);
  }

  /**
   * @template {string} Path
   * @param {Path} path
   * @param {object} state
   * @returns {Promise<AnswerAt<Path>>}
   */
  async ask(path, state) {
    return posted(`/api/v1/${path}`, state);
  }

  get rests() {
    return this.later.rests;
  }

  /** @type {Later["aside"]} */
  aside(...question) {
    this.later.aside(...question);
  }

  /** @type {Later["afterwards"]} */
  afterwards(who, draw) {
    this.later.afterwards(who, draw);
  }

  // Whether the answer to the present state is still to come.
  get asking() {
    return this.awaited.has(QUESTION);
  }

  /** @template {keyof Catalogue} Name @param {Name[]} names */
  async lists(...names) {
    return this.catalogue.named(names);
  }

  redraw() {
    if (!this.answer || !this.view) return;
    const swung = this.answer.bat?.swung?.[this.units] ?? "";
    write(byId("swung"), swung);
    byId("swung").hidden = !swung;
    this.view.update(this.answer, this.answered ?? this.state);
    this.bench.update();
    this.explain();
  }

  // A view's tables are made anew whenever it is drawn, so the meanings of their words are put there anew.
  async explain() {
    this.waits(MEANINGS);
    await explain(byId("view"), this);
    this.waits(MEANINGS, false);
  }

  // Show the view that the address names; without its files, when the connection is back.
  async go() {
    this.waits(QUESTION);
    this.turn += 1;
    const turn = this.turn;
    const name = location.pathname.split("/").at(-1) || HOME;
    const entry = this.views.get(name) ?? this.entry(HOME);
    if (entry.name !== this.name || !this.view || this.hollow) {
      let view;
      try {
        view = (await fetched(entry.name)).default;
      } catch {
        if (turn !== this.turn) return; // someone has gone elsewhere meanwhile
        this.heard("lost");
        this.lacks(entry.title);
        setTimeout(() => turn === this.turn && this.go(), AGAIN); // the line may be open all the while, and then says nothing
        return;
      }
      if (turn !== this.turn) return; // someone has gone elsewhere meanwhile
      this.show(entry, view);
    }
    this.merging = null;
    const kept = history.state?.view === this.name ? history.state.state : null;
    const told = kept ?? await stateIn(location.search, this.schema, this.defaults);
    if (turn !== this.turn) return;
    showUnknown(unknownIn(location.search, this.schema), entry.title);
    this.take(told);
    if (location.href.length > LONG_ADDRESS) this.commit({ instead: true });
    else pointBar(this);
  }

  /** @param {Entry} entry @param {{ new (root: HTMLElement, app: App): View, guide: Guide }} kind */
  show(entry, kind) {
    this.view?.unmount?.();
    this.mounted?.abort();
    this.mounted = new AbortController();
    this.signal = this.mounted.signal;
    this.controls.clear();
    this.frames.clear();
    this.later.clear();
    this.answer = null;
    byId("swung").hidden = true;
    this.name = entry.name;
    this.defaults = defaultsOf(entry.schema);
    this.state = { ...this.defaults };
    this.guide = kind.guide;
    const root = byId("view");
    root.replaceChildren();
    root.dataset.view = entry.name;
    delete root.dataset.answered;
    document.title = `${entry.title} – sweetspot`;
    this.say([]);
    this.view = new kind(root, this);
    if (!root.querySelector("h1")) root.prepend(Object.assign(document.createElement("h1"), { className: "unseen", textContent: entry.title }));
    drawerOf(/** @type {HTMLElement | null} */ (root.querySelector(":scope > .side")), root, this.signal);
    this.hollow = false;
    showAbsent("");
    if (this.lost) this.lacks(entry.title);
  }

  // What the line says of the server. A view that has no picture without it says so; once it is back, what lacks is made anew.
  /** @param {string} status */
  heard(status) {
    const back = this.lost && status === "open";
    this.lost = status === "lost";
    showStatus(status);
    if (this.lost && this.view && this.answer === null) this.lacks(this.entry(this.name).title);
    if (back && this.hollow) this.go();
  }

  /** @param {string} title */
  lacks(title) {
    this.hollow = true;
    showAbsent(title);
  }

  // Where a view's link leads: its own controls as they were left, with the bat and the hit that go along.
  /** @param {string} name */
  addressFor(name) {
    const { schema } = this.entry(name);
    const first = defaultsOf(schema);
    const along = Object.entries(this.carried).filter(([field]) => Object.hasOwn(schema, field));
    return addressOf(name, { ...first, ...this.left.get(name), ...Object.fromEntries(along) }, first, this.embedded);
  }

  // What an overtaken question, or the first picture, gives is drawn; what is wrong with the present one stays said.
  /** @param {Own} answer @param {State} state */
  answers(answer, state) {
    const first = this.answer === null;
    this.answer = answer;
    this.answered = state;
    if (state === this.state) this.say([]);
    if (state === this.state || first) this.waits(QUESTION, false);
    for (const control of this.controls.values()) if (control.follows) control.sync(this.state);
    this.redraw();
    this.chip.sync();
    byId("view").dataset.answered = String(Number(byId("view").dataset.answered ?? 0) + 1);
    if (first && !this.embedded) fetchOthers(this); // so that the other views are there at once, even without a server
  }

  // Say beside each control what is wrong with it, and on top what belongs to none; without any picture, draw the first.
  /** @param {Fault} fault @param {State} state */
  faulted(fault, state) {
    if (state !== this.state) return;
    this.say([fault, ...(fault.more ?? [])]);
    if (this.answer === null) this.line.ask(this.name, this.defaults);
    else this.waits(QUESTION, false);
  }

  /** @param {Fault[]} faults */
  say(faults) {
    this.faults = faults;
    showFaults(faults, new Map([...this.bench.desk.controls, ...this.controls]), this.units);
  }

  // Every control of this view as it is in the first picture.
  reset() {
    this.setState(this.defaults);
  }

  start() {
    fillBar(this);
    this.readColors();
    byId("tools").append(switchOf("units", [["us", "US"], ["si", "SI"]], this.units, (units) => this.setUnits(units)));
    byId("tools").append(stepButton("undo", "↶", "Undo (Ctrl+Z)", () => this.steps.undo(-1)), stepButton("redo", "↷", "Redo (Ctrl+Y)", () => this.steps.undo(1)),
      themeButton(() => this.readColors(true)), shareButton(this), exportButton(this), guide(this));
    menuButton();
    document.body.classList.toggle("embed", this.embedded);
    this.steps.mark();
    byId("chip").append(this.chip.element);
    byId("terms").addEventListener("click", () => listTerms(this));
    for (const anew of [byId("anew"), partOf(byId("fault"), "button", HTMLElement)]) anew.addEventListener("click", () => this.reset());
    addEventListener("popstate", () => {
      this.steps.arrive();
      this.go();
    });
    addEventListener("keydown", (event) => this.steps.key(event));
    addEventListener("pointerup", () => this.later.dragged && this.commit());
    let wide = 0; // every canvas looks after its own size, and a view's height follows from what is in it
    new ResizeObserver(([{ contentRect: { width } }]) => {
      if (width !== wide) this.redraw();
      wide = width;
    }).observe(byId("view"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.readColors(true));
    return this.go();
  }

  // To another view, with some of its controls set.
  /** @param {ViewName} name @param {Partial<State>} fields */
  visitWith(name, fields) {
    this.left.set(name, { ...defaultsOf(this.entry(name).schema), ...this.left.get(name), ...fields });
    Object.assign(this.carried, Object.fromEntries(Object.entries(fields).filter(([field]) => Object.hasOwn(this.carried, field))));
    return this.visit(this.addressFor(name));
  }

  /** @param {string} address */
  async visit(address) {
    this.steps.to(address);
    await this.go();
    byId("view").focus({ preventScroll: true });
    scrollTo(0, 0);
  }

  /** @param {System} units */
  setUnits(units) {
    this.units = units;
    localStorage.setItem("units", units);
    for (const control of this.controls.values()) control.sync(this.state);
    this.bench.sync();
    if (this.faults.length) this.say(this.faults);
    this.redraw();
  }

  readColors(again = false) {
    const style = getComputedStyle(document.documentElement);
    this.colors = new Proxy(/** @type {Record<string | symbol, string>} */ ({}), {
      get: (known, name) => (known[name] ??= style.getPropertyValue(`--${String(name).replace(/[A-Z]/g, (l) => `-${l.toLowerCase()}`)}`).trim()),
    });
    if (again) this.redraw();
  }
}

new App().start();
