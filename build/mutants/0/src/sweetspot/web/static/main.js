// The page's shell: which view, with which state, asked over the socket, drawn when the answer comes.
//
// How to write a view, say static/views/modes.js (plain ES modules; nothing is built, nothing comes from elsewhere):
//
//   export const view = {
//     name: "modes",                  // as in web/views/__init__.py, which also gives title, fields, bounds, defaults
//     defaults: {},                   // optional: first values that differ from those of the Python state
//     mount(root, app) {},            // build the elements once; no answer is there yet
//     update(answer, state) {},       // a new answer, or the same one again after a change of units, theme or size: draw
//     unmount() {},                   // stop what runs; the shell empties root
//     figures() { return [] },        // optional: [{ name, width, height, paint(context, width, height) }] for PNG and SVG;
//                                     //   paint uses only what SvgContext in svgcontext.js knows of a canvas' 2d context
//     charts() { return [] },         // optional: the Charts (chart.js) with the curves, for the interactive chart
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
//   app.lists()    a promise of { bats, balls, materials, leagues, parks }
//   app.control(control)     registers a control made by controls.js; those made with (app, field, ...) do it themselves
//   app.calm       true where people asked their system for less motion: do not start animations by yourself

import { addressOf, stateIn } from "./address.js";
import { exportButton } from "./exports.js";
import { guide, welcome } from "./guide.js";
import { posted } from "./post.js";
import { Line } from "./socket.js";
import { text } from "./units.js";

const facts = JSON.parse(document.getElementById("facts").textContent);
const LONGEST_ADDRESS = 16000;
const element = (id) => document.getElementById(id);

class App {
  constructor() {
    this.views = new Map(facts.views.map((entry) => [entry.name, { ...entry, schema: fieldsOf(entry.schema) }]));
    this.units = localStorage.getItem("units") === "si" ? "si" : "us";
    this.calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.controls = new Map();
    this.frames = new Set();
    this.answer = null;
    this.version = facts.version;
  }

  get schema() {
    return this.views.get(this.name).schema;
  }

  text(name, value, digits) {
    return text(name, value, this.units, digits);
  }

  setState(partial, { commit = true } = {}) {
    this.state = { ...this.state, ...partial };
    this.line.ask(this.name, this.state);
    for (const control of this.controls.values()) control.sync(this.state);
    if (commit) this.commit();
    else this.dragged = true;
  }

  // Put the state into the address as a step that the back button undoes.
  commit() {
    this.dragged = false;
    const address = addressOf(this.name, this.state, this.defaults);
    if (address.length > LONGEST_ADDRESS) { // the browser keeps the rest, so that back and reload still work
      const short = addressOf(this.name, { ...this.state, bat_toml: null }, this.defaults);
      history.pushState({ view: this.name, state: this.state }, "", short);
    } else if (address !== location.pathname + location.search || history.state) history.pushState(null, "", address);
    this.links();
  }

  control(control) {
    this.controls.set(control.field, control);
    control.sync(this.state);
  }

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

  async ask(view, state) {
    return posted(`/api/v1/${view}`, state);
  }

  lists() {
    this.known ??= Promise.all(["bats", "balls", "materials", "leagues", "parks"].map((name) => fetch(`/api/v1/${name}`).then((r) => r.json())))
      .then(([bats, balls, materials, leagues, parks]) => ({ bats, balls, materials, leagues, parks }));
    return this.known;
  }

  redraw() {
    if (this.answer && this.view) this.view.update(this.answer, this.answered);
  }

  // Show the view that the address names.
  async go() {
    const name = location.pathname.slice(1) || "explorer";
    const entry = this.views.get(name) ?? this.views.values().next().value;
    if (entry.name !== this.name || !this.view) await this.show(entry);
    const kept = history.state?.view === this.name ? history.state.state : null;
    this.state = kept ?? stateIn(location.search, this.schema, this.defaults);
    for (const control of this.controls.values()) control.sync(this.state);
    this.line.ask(this.name, this.state);
    this.links();
  }

  async show(entry) {
    const { view } = await import(`./views/${entry.name}.js`);
    this.view?.unmount();
    this.controls.clear();
    this.frames.clear();
    this.answer = null;
    this.name = entry.name;
    this.defaults = { ...defaultsOf(entry.schema), ...view.defaults };
    this.state = { ...this.defaults };
    this.view = view;
    const root = element("view");
    root.replaceChildren();
    root.dataset.view = entry.name;
    delete root.dataset.answered;
    document.title = `${entry.title} – sweetspot`;
    clearFault();
    view.mount(root, this);
  }

  // The other views' links carry the fields that they share with this one: the same bat, the same swing.
  links() {
    for (const link of document.querySelectorAll("#views a")) {
      const { name, schema } = this.views.get(link.dataset.name);
      const first = defaultsOf(schema);
      const shared = Object.entries(this.state ?? {}).filter(([field]) => Object.hasOwn(schema, field));
      const same = name === this.name;
      link.href = addressOf(name, same ? this.state : { ...first, ...Object.fromEntries(shared) }, same ? this.defaults : first);
      if (same) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
  }

  answers(answer, state) {
    this.answer = answer;
    this.answered = state;
    clearFault();
    for (const control of this.controls.values()) {
      control.fault("");
      if (control.follows) control.sync(this.state);
    }
    this.view.update(answer, state);
    element("view").dataset.answered = String(Number(element("view").dataset.answered ?? 0) + 1);
  }

  faulted(fault) {
    for (const control of this.controls.values()) control.fault("");
    const control = this.controls.get(fault.field);
    clearFault();
    if (control) control.fault(fault.message);
    else {
      element("fault").textContent = fault.message;
      element("fault").hidden = false;
    }
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
    element("tools").append(themeButton(() => this.readColors(true)), exportButton(this), guide(this));
    this.line = new Line({
      onAnswer: (view, answer, state) => view === this.name && this.answers(answer, state),
      onFault: (view, fault) => view === this.name && this.faulted(fault),
      onStatus: showStatus,
    });
    addEventListener("popstate", () => this.go());
    addEventListener("pointerup", () => this.dragged && this.commit());
    new ResizeObserver(() => this.redraw()).observe(element("view"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.readColors(true));
    return this.go();
  }

  follow(event) {
    const link = event.target.closest("a");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    history.pushState(null, "", link.href);
    this.go().then(() => element("view").focus());
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

function clearFault() {
  element("fault").hidden = true;
  element("fault").textContent = "";
}

function showStatus(status) {
  const words = {
    open: "",
    lost: "The connection to the server is lost. Trying again; the page then goes on by itself.",
    slow: "The server is taking its time with this answer.",
  }[status];
  element("status").textContent = words;
  element("status").hidden = words === "";
  document.body.dataset.line = status;
}

function switchOf(name, [first, firstWords], [second, secondWords], chosen, onChange) {
  const group = document.createElement("fieldset");
  group.className = "switch";
  group.innerHTML = `<legend class="unseen">${name}</legend>` + [[first, firstWords], [second, secondWords]].map(
    ([value, words]) => `<label><input type="radio" name="${name}" value="${value}"><span>${words}</span></label>`).join("");
  group.querySelector(`[value=${chosen}]`).checked = true;
  group.addEventListener("change", (event) => onChange(event.target.value));
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

const app = new App();
app.start().then(() => welcome(app));
