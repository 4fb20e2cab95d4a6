// The page's shell: which view, with which state, asked over the socket, drawn when the answer comes.
//
// How to write a view, say static/views/modes.js (plain ES modules; nothing is built, nothing comes from elsewhere):
//
//   export const view = {
//     name: "modes",                  // as in web/views/__init__.py, which also gives title, fields, bounds, defaults
//     guide: [[title, words]],        // the steps of the guide
//     mount(root, app) {},            // build the elements once; no answer is there yet
//     update(answer, state) {},       // a new answer, or the same one again after a change of units, theme or size: draw
//     unmount() {},                   // stop what runs; the shell empties root
//     figures() { return [] },        // optional: [{ name, width, height, paint(context, width, height) }] for PNG and SVG;
//                                     //   paint uses only what SvgContext in svgcontext.js knows of a canvas' 2d context
//     table() { return {} },          // optional: { column_name_with_unit: [numbers] } for CSV
//   };
//
// The app that mount gets:
//
//   app.state, app.setState({field: value}, {commit: false})   commit false while dragging (no step for the back button)
//   app.schema     JSON schema of each field: app.schema.pitch_speed_mph.maximum
//   app.answer     the last one, null before
//   app.units      "us" or "si"; app.text("exit_speed_m_s", 41.2) is "92.2 mph"; see units.js
//   app.colors     the theme's colours for canvases: ink, muted, grid, paper, panel, accent, zone, zoneEdge, zoneInk,
//                  blue, sky, green, orange, red, purple, wood, woodEdge, hollow
//   app.onFrame(step)   calls step(milliseconds) before every repaint until the returned function is called or unmount
//   app.announce(text)  says something to a screen reader, at most twice a second
//   app.ask(view, state)     a promise of another answer, over the API
//   app.aside(name, but, wait, onAnswer)   asks for one of the view's asides (web/view.py) once the state has rested
//   app.lists("bats", "parks")   a promise of { bats, parks }; there are also balls, materials, leagues, implements, pitches
//   app.bounds(field)        [least, most] that the bat of the last answer allows, undefined where it sets none
//   app.signal     an AbortSignal that ends when the view goes: give it to listeners on what outlives the view
//   app.control(control)     registers a control made by controls.js; those made with (app, field, ...) do it themselves
//   app.calm       true where people asked their system for less motion: do not start animations by yourself

import { addressOf, stateIn } from "./address.js";
import { Chip } from "./chip.js";
import { exportButton } from "./exports.js";
import { guide, welcome } from "./guide.js";
import { shareButton } from "./share.js";
import { partOf } from "./parts.js";
import { posted } from "./post.js";
import { Line } from "./socket.js";
import { explain, listTerms } from "./terms.js";
import { text } from "./units.js";
/** @import { System } from "./units.js" */

const facts = JSON.parse(document.getElementById("facts")?.textContent ?? "{}");
const LONGEST_ADDRESS = 16000;
const LONG_TEXT = 2000; // letters of a field beyond which it does not go into an address that is too long
const EMBED = "/embed/";
const LISTS = ["bats", "balls", "materials", "leagues", "parks", "implements", "pitches"];
const QUESTION = "answer";
const MEANINGS = "meanings of words";
const element = (id) => partOf(document, `#${id}`, HTMLElement);

/**
 * What the server answers; its shape is that of the view (web/views) and is not written down a second time here.
 * @typedef {any} Answer
 */
/** @typedef {Record<string, any>} State of a view: its fields, by their names in web/views */
/** @typedef {Record<string, string>} Colors by name */
/** @typedef {{ name: string, width: number, height: number, paint: (context: any, width: number, height: number) => void }} Figure */
/** @typedef {{ field: string, message: string, more?: Fault[], again?: boolean }} Fault */
/** @typedef {{ commit?: boolean, merge?: string | null, instead?: boolean }} Step how a change goes into the address */
/** @typedef {{ field: string, follows?: boolean, sync: (state: State) => void, fault?: (message: string) => void }} Control */
/** @typedef {{ name: string, title: string, schema: Record<string, any>, bat: string[] }} Entry */
/**
 * A view, and whatever else it keeps; the shell calls nothing but these.
 * @typedef {object} OwnView
 * @property {string} name
 * @property {[string, string][]} guide
 * @property {(root: HTMLElement, app: App) => void} mount
 * @property {(answer: Answer, state: State) => void} update
 * @property {() => void} unmount
 * @property {() => Figure[]} [figures]
 * @property {() => Record<string, unknown[]>} [table]
 */
/** @typedef {OwnView & Record<string, any> & ThisType<OwnView & { app: App } & Record<string, any>>} View */

export class App {
  /** @type {View} */
  view = /** @type {any} */ (null); // until the first one's files are there
  /** @type {State} */
  state = {};
  /** @type {State} */
  defaults = {};
  name = "";
  /** @type {AbortSignal} */
  signal = new AbortController().signal;
  /** @type {Colors} */
  colors = {};
  /** @type {Line} */
  line = /** @type {any} */ (null); // it and the chip are there before the first view
  /** @type {Chip} */
  chip = /** @type {any} */ (null);

  constructor() {
    /** @type {Map<string, Entry>} */
    this.views = new Map(facts.views.map(({ name, title, schema }) => [
      name, { name, title, schema: fieldsOf(schema), bat: Object.keys(schema.$defs?.BatState?.properties ?? {}) }]));
    /** @type {System} */
    this.units = localStorage.getItem("units") === "si" ? "si" : "us";
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    /** @type {Map<string, Control>} */
    this.controls = new Map();
    /** @type {Set<(now: number) => void>} */
    this.frames = new Set();
    this.asides = new Map(); // what was asked apart: about what, and the timer that waits
    /** @type {State} */
    this.carried = {}; // what goes along from view to view: the bat, how it is swung, where the ball meets it
    this.left = new Map(); // view -> its own controls as they were left
    this.known = new Map(); // list -> a promise of it
    this.awaited = new Set(); // what is asked for and not there yet; #view says it as data-waiting
    this.turn = 0;
    this.step = this.lastStep = history.state?.step ?? 0; // of what was done since this page was opened
    this.embedded = location.pathname.startsWith(EMBED);
    /** @type {Answer} */
    this.answer = null;
    this.version = facts.version;
  }

  // What is known of a view; every name that the page uses is known.
  /**
   * @param {string} name
   * @returns {Entry}
   */
  entry(name) {
    const known = this.views.get(name);
    if (known) return known;
    throw new RangeError(`there is no view ${name}`);
  }

  get schema() {
    return this.entry(this.name).schema;
  }

  /**
   * @param {string} name
   * @param {number | null} value
   * @param {number} [digits]
   */
  text(name, value, digits) {
    return text(name, value, this.units, digits);
  }

  /**
   * @param {string} field
   * @returns {[number, number] | undefined}
   */
  bounds(field) {
    return this.answer?.bat?.bounds?.[field];
  }

  // A merge is a name: steps of the same one after the other, such as key presses on a slider, are undone together.
  // Instead: nobody asked for this step, so that going back does not lead to what was before it.
  /**
   * @param {State} partial
   * @param {Step} [step]
   */
  setState(partial, { commit = true, merge = null, instead = false } = {}) {
    this.take({ ...this.state, ...partial });
    if (commit) this.commit({ merge, instead });
    else this.dragged = true;
  }

  // Note that something has been asked for, or is there.
  waits(what, yes = true) {
    this.awaited[yes ? "add" : "delete"](what);
    element("view").dataset.waiting = [...this.awaited].join(" ");
  }

  take(state) {
    this.waits(QUESTION);
    this.state = state;
    for (const field of facts.carried) if (Object.hasOwn(this.schema, field)) this.carried[field] = state[field];
    this.left.set(this.name, state);
    this.line.ask(this.name, state);
    for (const control of this.controls.values()) control.sync(state);
    this.chip.sync();
  }

  // Put the state into the address as a step that the back button, and Undo, take back.
  /** @param {Step} [step] */
  commit({ merge = null, instead = false } = {}) {
    this.dragged = false;
    const again = instead || (merge !== null && merge === this.merging);
    this.merging = merge;
    let address = addressOf(this.name, this.state, this.defaults, this.embedded);
    let kept = {};
    if (address.length > LONGEST_ADDRESS) { // the browser keeps the rest, so that back and reload still work
      const short = Object.entries(this.state).map(([field, value]) => [field, typeof value === "string" && value.length > LONG_TEXT ? this.defaults[field] : value]);
      address = addressOf(this.name, Object.fromEntries(short), this.defaults, this.embedded);
      kept = { view: this.name, state: this.state };
    }
    if (kept.view || history.state?.view || address !== location.pathname + location.search) this.stepTo(address, kept, again);
    this.links();
  }

  stepTo(address, kept = {}, again = false) {
    this.step += again ? 0 : 1;
    this.lastStep = this.step;
    history[again ? "replaceState" : "pushState"]({ step: this.step, ...kept }, "", address);
    this.marks();
  }

  // What can be taken back, and done again.
  marks() {
    partOf(document, "#undo", HTMLButtonElement).disabled = this.step === 0;
    partOf(document, "#redo", HTMLButtonElement).disabled = this.step >= this.lastStep;
  }

  /** @param {Control} control */
  control(control) {
    this.controls.set(control.field, control);
    control.sync(this.state);
  }

  /**
   * @param {(now: number) => void} step
   * @returns {() => void}
   */
  onFrame(step) {
    this.frames.add(step);
    if (this.frames.size === 1) requestAnimationFrame((now) => this.frame(now));
    return () => this.frames.delete(step);
  }

  frame(now) {
    for (const step of this.frames) step(now);
    if (this.frames.size) requestAnimationFrame((later) => this.frame(later));
  }

  announce(words) {
    clearTimeout(this.speaking);
    this.speaking = setTimeout(() => (element("announcer").textContent = words), 500);
  }

  /**
   * @param {string} view
   * @param {State} state
   * @returns {Promise<Answer>}
   */
  async ask(view, state) {
    return posted(`/api/v1/${view}`, state);
  }

  // Ask apart for what takes longer, once the state has rested for a while (ms); asked again only when something changes
  // besides the fields in `but`. onAnswer hears what is still about the present state.
  /**
   * @param {string} name
   * @param {string[]} but
   * @param {number} wait
   * @param {(answer: Answer) => void} onAnswer
   */
  aside(name, but, wait, onAnswer) {
    const about = JSON.stringify(Object.entries(this.state).filter(([field]) => !but.includes(field)));
    const last = this.asides.get(name);
    if (last?.about === about) return;
    clearTimeout(last?.timer);
    this.waits(name);
    const asked = { about, timer: setTimeout(async () => {
      let found = null;
      let again = false;
      try {
        found = await this.ask(`${this.name}/${name}`, this.state);
      } catch (fault) {
        again = fault?.again; // it is still being worked out; otherwise the next answer asks
      }
      if (this.asides.get(name) !== asked) return;
      if (found) onAnswer(found);
      else this.asides.delete(name);
      if (again) this.aside(name, but, 2000, onAnswer);
      else this.waits(name, false);
    }, wait) };
    this.asides.set(name, asked);
  }

  // Each list is fetched when first wanted, and by itself: none waits for another.
  /**
   * @param {string[]} names
   * @returns {Promise<Record<string, any[]>>}
   */
  async lists(...names) {
    const wanted = names.length ? names : LISTS;
    const found = await Promise.all(wanted.map((name) => this.list(name)));
    return Object.fromEntries(wanted.map((name, i) => [name, found[i]]));
  }

  list(name) {
    if (!this.known.has(name)) {
      const what = `list of ${name}`;
      this.waits(what);
      this.known.set(name, fetch(`/api/v1/${name}`).then((response) => response.json())
        .catch((error) => {
          this.known.delete(name); // so that the next who asks tries again
          throw error;
        })
        .finally(() => setTimeout(() => this.waits(what, false)))); // once those who waited for it have drawn it
    }
    return this.known.get(name);
  }

  redraw() {
    if (!this.answer || !this.view) return;
    this.view.update(this.answer, this.answered);
    this.explain();
  }

  // A view's tables are made anew whenever it is drawn, so the meanings of their words are put there anew.
  async explain() {
    this.waits(MEANINGS);
    await explain(element("view"));
    this.waits(MEANINGS, false);
  }

  // Show the view that the address names; without its files, when the connection is back.
  async go() {
    this.waits(QUESTION);
    this.turn += 1;
    const turn = this.turn;
    const name = location.pathname.split("/").at(-1) || "explorer";
    const entry = this.views.get(name) ?? this.entry("explorer");
    if (entry.name !== this.name || !this.view) {
      let view;
      try {
        ({ view } = await fetched(entry.name));
      } catch {
        this.missing = true;
        showStatus("lost");
        return;
      }
      if (turn !== this.turn) return; // someone has gone elsewhere meanwhile
      this.show(entry, view);
    }
    this.merging = null;
    const kept = history.state?.view === this.name ? history.state.state : null;
    const told = kept ?? await stateIn(location.search, this.schema, this.defaults);
    if (turn !== this.turn) return;
    this.take(told);
    this.links();
  }

  show(entry, view) {
    this.view?.unmount();
    this.mounted?.abort();
    this.mounted = new AbortController();
    this.signal = this.mounted.signal;
    this.controls.clear();
    this.frames.clear();
    for (const { timer } of this.asides.values()) clearTimeout(timer);
    for (const name of this.asides.keys()) this.waits(name, false);
    this.asides.clear();
    this.answer = null;
    this.name = entry.name;
    this.defaults = defaultsOf(entry.schema);
    this.state = { ...this.defaults };
    this.view = view;
    const root = element("view");
    root.replaceChildren();
    root.dataset.view = entry.name;
    delete root.dataset.answered;
    document.title = `${entry.title} – sweetspot`;
    clearFault();
    view.mount(root, this);
    if (!root.querySelector("h1")) root.prepend(Object.assign(document.createElement("h1"), { className: "unseen", textContent: entry.title }));
    drawerOf(root.querySelector(":scope > .side"));
  }

  // Where a view's link leads: its own controls as they were left, with the bat and the hit that go along.
  addressFor(name) {
    const { schema } = this.entry(name);
    const first = defaultsOf(schema);
    const along = Object.entries(this.carried).filter(([field]) => Object.hasOwn(schema, field));
    return addressOf(name, { ...first, ...this.left.get(name), ...Object.fromEntries(along) }, first, this.embedded);
  }

  links() {
    for (const link of element("views").querySelectorAll("a")) {
      link.href = this.addressFor(link.dataset.name);
      if (link.dataset.name === this.name) {
        link.setAttribute("aria-current", "page");
        centre(link);
      }
      else link.removeAttribute("aria-current");
    }
  }

  // What an overtaken question, or the first picture, gives is drawn; what is wrong with the present one stays said.
  answers(answer, state) {
    const first = this.answer === null;
    this.answer = answer;
    this.answered = state;
    if (state === this.state) this.faults([]);
    if (state === this.state || first) this.waits(QUESTION, false);
    for (const control of this.controls.values()) if (control.follows) control.sync(this.state);
    this.redraw();
    this.chip.sync();
    element("view").dataset.answered = String(Number(element("view").dataset.answered ?? 0) + 1);
    if (!first || this.embedded) return;
    welcome(this);
    fetchOthers(this.views.keys()); // so that the other views are there at once, even without a server
  }

  // Say beside each control what is wrong with it, and on top what belongs to none; without any picture, draw the first.
  faulted(fault, state) {
    if (state !== this.state) return;
    this.faults([fault, ...(fault.more ?? [])]);
    if (this.answer === null) this.line.ask(this.name, this.defaults);
    else this.waits(QUESTION, false);
  }

  faults(faults) {
    for (const control of this.controls.values()) control.fault?.("");
    const homeless = faults.filter(({ field, message }) => {
      const control = this.controlOf(field);
      control?.fault?.(message);
      return !control;
    });
    partOf(element("fault"), "span", HTMLElement).textContent = homeless.map(({ field, message }) => (field ? `${field}: ${message}` : message)).join("; ");
    element("fault").hidden = homeless.length === 0;
  }

  // "profile_in.3.1" belongs to the control of profile_in.
  controlOf(field) {
    const parts = field.split(".");
    for (let length = parts.length; length > 0; length -= 1) {
      const control = this.controls.get(parts.slice(0, length).join("."));
      if (control?.fault) return control;
    }
    return undefined;
  }

  // A step back (−1) or on again (1), if there is one.
  undo(way) {
    if (way < 0 ? this.step > 0 : this.step < this.lastStep) history.go(way);
  }

  // Every control of this view as it is in the first picture.
  reset() {
    this.setState(this.defaults);
  }

  start() {
    const list = element("views");
    for (const { name, title } of this.views.values()) {
      const link = Object.assign(document.createElement("a"), { textContent: title });
      link.dataset.name = name;
      const item = document.createElement("li");
      item.append(link);
      list.append(item);
    }
    list.addEventListener("click", (event) => this.follow(event));
    this.readColors();
    element("tools").append(switchOf("units", ["us", "US"], ["si", "SI"], this.units, (units) => this.setUnits(units)));
    element("tools").append(stepButton("undo", "↶", "Undo (Ctrl+Z)", () => this.undo(-1)), stepButton("redo", "↷", "Redo (Ctrl+Y)", () => this.undo(1)),
      themeButton(() => this.readColors(true)), shareButton(this), exportButton(this), guide(this));
    document.body.classList.toggle("embed", this.embedded);
    this.marks();
    this.chip = new Chip(this);
    element("chip").append(this.chip.element);
    element("terms").addEventListener("click", () => listTerms());
    partOf(element("fault"), "button", HTMLElement).addEventListener("click", () => this.reset());
    this.line = new Line({
      apart: true,
      onAnswer: (view, answer, state) => view === this.name && this.answers(answer, state),
      onFault: (view, fault, state) => view === this.name && this.faulted(fault, state),
      onStatus: (status) => {
        showStatus(status);
        if (status !== "open" || !this.missing) return;
        this.missing = false;
        this.go();
      },
    });
    addEventListener("popstate", () => {
      this.step = history.state?.step ?? 0;
      this.marks();
      this.go();
    });
    addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || !(event.target instanceof Element)) return;
      if (event.target.matches("textarea, input[type=number], input[type=text]")) return;
      const way = { z: event.shiftKey ? 1 : -1, y: 1 }[event.key.toLowerCase()];
      if (way) this.undo(way);
    });
    addEventListener("pointerup", () => this.dragged && this.commit());
    new ResizeObserver(() => this.redraw()).observe(element("view"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.readColors(true));
    return this.go();
  }

  follow(event) {
    const link = event.target.closest("a");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    this.visit(link.href);
  }

  // To another view, with some of its controls set.
  visitWith(name, fields) {
    this.left.set(name, { ...defaultsOf(this.entry(name).schema), ...this.left.get(name), ...fields });
    for (const field of Object.keys(fields)) if (Object.hasOwn(this.carried, field)) this.carried[field] = fields[field];
    return this.visit(this.addressFor(name));
  }

  async visit(address) {
    this.stepTo(address);
    await this.go();
    element("view").focus({ preventScroll: true });
    scrollTo(0, 0);
  }

  setUnits(units) {
    this.units = units;
    localStorage.setItem("units", units);
    for (const control of this.controls.values()) control.sync(this.state);
    this.redraw();
  }

  readColors(again = false) {
    const style = getComputedStyle(document.documentElement);
    this.colors = new Proxy({}, {
      get: (known, name) => (known[name] ??= style.getPropertyValue(`--${String(name).replace(/[A-Z]/g, (l) => `-${l.toLowerCase()}`)}`).trim()),
    });
    if (again) this.redraw();
  }
}

function fieldsOf(schema) {
  const resolve = (property) => (property.$ref ? { ...schema.$defs[property.$ref.split("/").pop()], ...property } : property);
  return Object.fromEntries(Object.entries(schema.properties ?? {}).map(([field, property]) => [field, resolve(property)]));
}

function defaultsOf(schema) {
  return Object.fromEntries(Object.entries(schema).map(([field, property]) => [field, property.default ?? null]));
}

// A view's module. A failed import is remembered by the browser under its address, so another try needs another one.
const modules = new Map();
let tries = 0;

function fetched(name) {
  if (!modules.has(name)) {
    const again = tries ? `?try=${tries}` : "";
    modules.set(name, import(`./views/${name}.js${again}`).catch((error) => {
      modules.delete(name);
      tries += 1;
      throw error;
    }));
  }
  return modules.get(name);
}

function fetchOthers(names) {
  for (const name of names) fetched(name).catch(() => {}); // who goes there asks again
}

// Bring a link into the middle of a bar that is too narrow for all of them; the page itself stays where it is.
function centre(link) {
  const bar = link.closest("header");
  const [all, own] = [bar.getBoundingClientRect(), link.getBoundingClientRect()];
  bar.scrollLeft += own.left + own.width / 2 - all.left - all.width / 2;
}

// On a phone the controls are a drawer at the foot of the screen.
function drawerOf(side) {
  if (!side) return;
  const toggle = Object.assign(document.createElement("button"), { type: "button", className: "drawer" });
  const label = () => {
    const shut = side.classList.contains("shut");
    toggle.textContent = shut ? "▴ Controls" : "▾ Controls";
    toggle.setAttribute("aria-expanded", String(!shut));
  };
  toggle.addEventListener("click", () => {
    side.classList.toggle("shut");
    label();
  });
  label();
  side.prepend(toggle);
}

function clearFault() {
  element("fault").hidden = true;
}

function showStatus(status) {
  const words = {
    open: "",
    preparing: "First start: the solver is being compiled for this machine. That takes about a minute, once; the picture then comes by itself.",
    lost: "The connection to the server is lost. Trying again; the page then goes on by itself.",
    slow: "The server is taking its time with this answer.",
  }[status];
  element("status").textContent = words;
  element("status").hidden = words === "";
  document.body.dataset.line = status;
}

function stepButton(id, words, title, act) {
  const made = Object.assign(document.createElement("button"), { type: "button", id, textContent: words, title });
  made.setAttribute("aria-label", title);
  made.addEventListener("click", act);
  return made;
}

function switchOf(name, [first, firstWords], [second, secondWords], chosen, onChange) {
  const group = document.createElement("fieldset");
  group.className = "switch";
  group.innerHTML = `<legend class="unseen">${name}</legend>` + [[first, firstWords], [second, secondWords]].map(
    ([value, words]) => `<label><input type="radio" name="${name}" value="${value}"><span>${words}</span></label>`).join("");
  for (const one of group.querySelectorAll("input")) {
    one.checked = one.value === chosen;
    one.addEventListener("change", () => onChange(one.value));
  }
  return group;
}

function themeButton(onChange) {
  const root = document.documentElement;
  const dark = () => (root.dataset.theme ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark";
  const stored = localStorage.getItem("theme");
  if (stored) root.dataset.theme = stored;
  const button = Object.assign(document.createElement("button"), { type: "button", id: "theme" });
  const label = () => (button.textContent = dark() ? "Light" : "Dark");
  button.title = "Change between light and dark";
  button.addEventListener("click", () => {
    root.dataset.theme = dark() ? "light" : "dark";
    localStorage.setItem("theme", root.dataset.theme);
    label();
    onChange();
  });
  label();
  return button;
}

new App().start();
