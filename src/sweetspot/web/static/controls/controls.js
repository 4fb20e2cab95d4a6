// Controls: a label, what is chosen, its unit, and what is wrong with it beside it. Bounds come from the schema,
// narrowed by those of the answer (app.bounds).
//
//   slider(app, "pitch_speed_mph", { label: "Pitch speed", step: 0.5 })   a range and a number field
//   slider(app, "ball_cor", { label: "Ball COR", step: 0.005, empty: 0.55 })   may be empty (null): shows 0.55 until moved;
//                                                      empty may be a function, asked again after every answer; so may
//                                                      label
//   slider(app, "weighed_oz", { label: "It weighs", step: 0.05, empty: 31, absent: "not measured" })   empty is empty:
//                                                      no number until somebody gives one, and none once it is wiped out
//   slider(app, "error_oz", { label: "Give or take", step: 0.01, times: 1.6449 })   shown is so many times the value
//   choice(app, "ball", { label: "Ball", options: [["baseball", "Baseball"]] })
//   toggle(app, "fixed", { label: "Held fast" })
//   group("Swing", [slider(...), ...], { open: true })   controls under a heading that folds
//   button("Reset", () => ..., { primary: false })
// Each returns an element to append. A control shows the value of app.state[field] and calls app.setState.

import { changed, partOf, showWords } from "./parts.js";
import { fromShown, toShown, unitOf } from "./units.js";

/** @import { Property } from "./fields.js" */
/** @import { App, Field, State } from "../shell/main.js" */
/** @typedef {string | (() => string)} Words */
/** @typedef {string[][]} Options a value, what it is called and, where they are many, under which heading it stands */
/**
 * What a control needs of the app; scoped() of parts.js gives the same for one bat of a list.
 * @typedef {Pick<App, "schema" | "units" | "setState" | "commit" | "control"> & Partial<Pick<App, "state" | "bounds" | "lists" | "answer">>} Desk
 */

export const ANY_STEP = "any"; // of a field for numbers that need not be round
let count = 0;

/**
 * @param {Desk} app
 * @param {Field} field
 * @param {{ label: Words, step: number, empty?: number | null | (() => number | string | null), absent?: string, times?: number, note?: string, onInput?: ((value: number) => void) | null }} look
 */
export function slider(app, field, { label, step, empty = null, absent = "", times = 1, note = "", onInput = null }) {
  const limits = () => narrowed(boundsOf(app.schema[field]), app.bounds?.(field));
  let bounds = limits();
  const { box, fault, id, name } = frame(field, label, note);
  const range = input("range", id);
  const number = input("number", `${id}-number`);
  const unit = document.createElement("span");
  unit.className = "unit";
  if (field.endsWith("from_tip_in")) range.dir = "rtl"; // as in the pictures, where the tip is on the right
  number.setAttribute("inputmode", "decimal");
  range.setAttribute("aria-describedby", `${id}-fault`);
  number.setAttribute("aria-describedby", `${id}-fault`);
  partOf(box, ".entry", HTMLElement).append(range, number, unit);
  let scaled = "";
  if (absent) number.placeholder = "–";
  const shown = (/** @type {number} */ value) => toShown(field, times * value, app.units);
  const stepShown = () => niceStep(Math.abs(shown(step) - shown(0)), app.units === "us" && times === 1 ? 0 : 1);

  function scale() {
    bounds = limits();
    const words = typeof label === "function" ? label() : label;
    const now = `${app.units} ${bounds.least} ${bounds.most} ${words}`;
    if (scaled === now) return;
    scaled = now;
    name.textContent = words;
    for (const one of [range, number]) {
      const fine = stepShown();
      one.min = String(round(shown(bounds.least), fine, Math.ceil));
      one.max = String(round(shown(bounds.most), fine, Math.floor));
      one.step = one === range ? String(fine) : ANY_STEP;
    }
    unit.textContent = unitOf(field, app.units);
    number.setAttribute("aria-label", `${words}${unit.textContent ? `, ${unit.textContent}` : ""}`);
  }

  /** @param {string} text @param {boolean} commit */
  function take(text, commit) {
    const given = Number(text);
    if (absent && text.trim() === "" && !number.validity.badInput) {
      app.setState(changed(field, null), { commit });
      return;
    }
    if (text.trim() === "" || !Number.isFinite(given)) {
      control.fault(text.trim() === "" ? "Give a number." : `${text} is not a number.`);
      return;
    }
    const value = tidy(fromShown(field, given, app.units) / times);
    if (value < bounds.least - 1e-9 || value > bounds.most + 1e-9) {
      control.fault(`Allowed is ${range.min} to ${range.max} ${unit.textContent}.`);
      return;
    }
    const inside = Math.min(bounds.most, Math.max(bounds.least, value));
    app.setState(changed(field, inside), { commit });
    onInput?.(inside);
  }

  let byKey = false; // key presses on a slider are undone together, a drag is one step
  range.addEventListener("keydown", () => (byKey = true));
  range.addEventListener("pointerdown", () => (byKey = false));
  range.addEventListener("input", () => take(range.value, false));
  range.addEventListener("change", () => app.commit({ merge: byKey ? `keys ${id}` : null }));
  let typing = false; // what is being typed stays when an answer comes meanwhile
  number.addEventListener("input", () => (typing = true));
  number.addEventListener("change", () => {
    typing = false;
    take(number.value, true);
  });
  const control = {
    field,
    follows: true,
    /** @param {State} state */
    sync(state) {
      scale();
      const value = state[field] ?? (typeof empty === "function" ? empty() : empty) ?? (absent ? (bounds.least + bounds.most) / 2 : null);
      if (typeof value !== "number") return;
      const fine = stepShown();
      if (document.activeElement !== range || Math.abs(Number(range.value) - shown(value)) > fine / 2) range.value = String(shown(value));
      const given = !absent || state[field] !== null;
      const written = given ? String(Number(shown(value).toFixed(decimals(fine)))) : "";
      if (number.value !== written && (document.activeElement !== number || (fault.hidden && !typing))) number.value = written;
      const said = given ? `${number.value} ${unit.textContent}` : absent;
      if (range.getAttribute("aria-valuetext") !== said) range.setAttribute("aria-valuetext", said);
      box.classList.toggle("absent", !given);
    },
    fault: faultSetter(fault, [range, number]),
  };
  scale();
  app.control(control);
  return box;
}

// shown: what of the state is chosen, take: what a choice does, where these are not the field alone.
/**
 * @param {Desk} app
 * @param {Field} field
 * @param {{ label: Words, options: Options | Promise<Options>, note?: string, follows?: boolean, shown?: (state: State) => unknown, take?: ((value: string) => void) | null }} look
 */
export function choice(app, field, { label, options, note = "", follows = false, shown = (state) => state[field], take = null }) {
  const { box, fault, id } = frame(field, label, note);
  const select = document.createElement("select");
  select.id = id;
  select.setAttribute("aria-describedby", `${id}-fault`);
  const fill = (/** @type {Options} */ list) => {
    select.replaceChildren();
    for (const [value, words, kind] of list) {
      let place = /** @type {HTMLElement} */ (select);
      if (kind) {
        const last = select.lastElementChild;
        place = last instanceof HTMLOptGroupElement && last.label === kind ? last : select.appendChild(Object.assign(document.createElement("optgroup"), { label: kind }));
      }
      place.append(new Option(words, value));
    }
    if (app.state) control.sync(app.state);
  };
  partOf(box, ".entry", HTMLElement).append(select);
  select.addEventListener("change", () => {
    if (take) take(select.value);
    else app.setState(changed(field, select.value));
  });
  const control = {
    field,
    follows,
    /** @param {State} state */
    sync(state) {
      const value = String(shown(state) ?? "");
      if (select.value === value && select.selectedIndex >= 0) return; // options are many, and a hand moves on
      if (![...select.options].some((option) => option.value === value)) select.append(new Option(value, value));
      select.value = value;
    },
    fault: faultSetter(fault, [select]),
  };
  if (options instanceof Promise) options.then(fill, () => {}); // without the list the present choice stands there alone
  else fill(options);
  app.control(control);
  return box;
}

/** @param {Desk} app @param {Field} field @param {{ label: Words, note?: string }} look */
export function toggle(app, field, { label, note = "" }) {
  const { box, fault, id } = frame(field, label, note);
  const tick = input("checkbox", id);
  partOf(box, ".entry", HTMLElement).append(tick);
  tick.addEventListener("change", () => app.setState(changed(field, tick.checked)));
  const control = { field, sync: (/** @type {State} */ state) => (tick.checked = Boolean(state[field])), fault: faultSetter(fault, [tick]) };
  app.control(control);
  return box;
}

// A text that is taken when it is finished.
/** @param {Desk} app @param {Field} field @param {{ label: Words, note?: string }} look */
export function words(app, field, { label, note = "" }) {
  const { box, fault, id } = frame(field, label, note);
  const line = input("text", id);
  line.setAttribute("aria-describedby", `${id}-fault`);
  partOf(box, ".entry", HTMLElement).append(line);
  line.addEventListener("change", () => app.setState(changed(field, line.value)));
  const control = { field, sync: (/** @type {State} */ state) => (line.value = String(state[field] ?? "")), fault: faultSetter(fault, [line]) };
  app.control(control);
  return box;
}

/** @param {string} title @param {(Node | string)[]} controls @param {{ open?: boolean }} look */
export function group(title, controls, { open = true } = {}) {
  const details = document.createElement("details");
  details.className = "group";
  details.open = open;
  const summary = document.createElement("summary");
  summary.textContent = title;
  details.append(summary, ...controls);
  return details;
}

/**
 * @param {string} words
 * @param {(event: Event) => void} onClick
 * @param {{ primary?: boolean, title?: string }} look
 */
export function button(words, onClick, { primary = false, title = "" } = {}) {
  const made = Object.assign(document.createElement("button"), { type: "button", textContent: words, title });
  if (primary) made.className = "primary";
  made.addEventListener("click", onClick);
  return made;
}

/** @param {string} field @param {Words} label @param {string} note */
function frame(field, label, note) {
  count += 1;
  const id = `c${count}-${field}`;
  const box = document.createElement("div");
  box.className = "control";
  box.dataset.field = field;
  const name = Object.assign(document.createElement("label"), { htmlFor: id, textContent: typeof label === "function" ? label() : label });
  const entry = Object.assign(document.createElement("div"), { className: "entry" });
  const fault = Object.assign(document.createElement("p"), { className: "fault", id: `${id}-fault`, hidden: true });
  box.append(name, entry, fault);
  if (note) box.append(Object.assign(document.createElement("p"), { className: "note", textContent: note }));
  return { box, fault, id, name };
}

/** @param {HTMLElement} place @param {HTMLElement[]} inputs */
function faultSetter(place, inputs) {
  return (/** @type {string} */ message) => {
    if (message === place.textContent) return;
    place.textContent = message;
    place.hidden = message === "";
    if (message) reveal(place);
    for (const one of inputs) {
      if (message) one.setAttribute("aria-invalid", "true");
      else one.removeAttribute("aria-invalid");
    }
  };
}

// Where it is said what is wrong with fields that have no control of their own.
/** @param {Pick<App, "control">} app @param {Field[]} fields @param {(state: State) => void} sync */
export function faultPlace(app, fields, sync = () => {}) {
  const place = Object.assign(document.createElement("p"), { className: "fault", hidden: true });
  place.setAttribute("role", "alert");
  const fault = (/** @type {string} */ message) => {
    showWords(place, message);
    if (message) reveal(place);
  };
  for (const field of fields) app.control({ field, sync, fault });
  return place;
}

// Open and show everything that a place lies in.
/** @param {HTMLElement} place */
export function reveal(place) {
  for (let box = /** @type {HTMLElement | null} */ (place); box && box.id !== "view"; box = box.parentElement) {
    box.hidden = false;
    if (box instanceof HTMLDetailsElement) box.open = true;
    box.dispatchEvent(new Event("reveal")); // a drawer
  }
}

/** @param {{ least: number, most: number }} given @param {number[] | null | undefined} known */
function narrowed({ least, most }, known) {
  if (!known) return { least, most };
  const [low, high] = [Math.max(least, known[0]), Math.min(most, known[1])];
  return low < high ? { least: low, most: high } : { least, most };
}

/** @param {string} type @param {string} id */
function input(type, id) {
  return Object.assign(document.createElement("input"), { type, id });
}

// Bounds of a number in a schema, also of one that may be null.
/** @param {Property} property */
export function boundsOf(property) {
  const numeric = (property.anyOf ?? [property]).find((one) => one.minimum !== undefined || one.maximum !== undefined) ?? property;
  return {
    least: numeric.minimum ?? numeric.exclusiveMinimum ?? 0,
    most: numeric.maximum ?? numeric.exclusiveMaximum ?? 1,
  };
}

// 1, 2 or 5 times a power of ten at or below a step; as it is in the unit in which it was written.
/** @param {number} step @param {number} written */
function niceStep(step, written) {
  if (Math.abs(step / written - 1) < 1e-6) return written;
  const power = 10 ** Math.floor(Math.log10(step) + 1e-9);
  return power * (step / power >= 5 ? 5 : step / power >= 2 ? 2 : 1);
}

const decimals = (/** @type {number} */ step) => Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
const round = (/** @type {number} */ value, /** @type {number} */ step, /** @type {(value: number) => number} */ how) => Number((how(value / step - (how === Math.ceil ? 1e-9 : -1e-9)) * step).toFixed(6));
const tidy = (/** @type {number} */ value) => Number(value.toPrecision(9));
