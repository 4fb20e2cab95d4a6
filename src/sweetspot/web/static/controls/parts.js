// Pieces that several views are made of: tables, paragraphs, sentences in either system of units, controls inside a list.

import { fitted, unbroken } from "./tables.js";
import { MPH, grouped, toShown, unitOf } from "./units.js";
/** @import { App, AppOf, Control, Field, State, Step } from "../shell/main.js" */

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {object} properties
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/**
 * The first element at a selector, which is of that kind; anything else is a mistake of the page, and said at once.
 *
 * @template {Element} Kind
 * @param {ParentNode} place
 * @param {string} selector
 * @param {new () => Kind} kind
 * @returns {Kind}
 */
export function partOf(place, selector, kind) {
  const first = place.querySelector(selector);
  if (first instanceof kind) return first;
  throw new TypeError(`no ${kind.name} at ${selector}`);
}

// A part of a view with its heading.
/** @param {string} title @param {(Node | string)[]} parts */
export const section = (title, ...parts) => make("section", { className: "picture" }, make("h2", { textContent: title }), ...parts);

// Words in a place that is hidden without any.
/** @param {HTMLElement} place @param {string} words */
export function showWords(place, words) {
  place.textContent = words;
  place.hidden = words === "";
}

// A change of one field of a state.
/** @param {Field} field @param {unknown} value */
export const changed = (field, value) => /** @type {Partial<State>} */ ({ [field]: value });

// An element of the page's frame (index.html), which is always there.
export const byId = (/** @type {string} */ id) => partOf(document, `#${id}`, HTMLElement);

// "11,300 ± 680 oz in²": a value with its interval, with no more digits than are known; alone where there is none.
/**
 * @param {string} kind
 * @param {number | null | undefined} value
 * @param {number | null | undefined} half
 * @param {App} app
 */
export function withDoubt(kind, value, half, app) {
  const size = half ? Math.abs(toShown(kind, half, app.units)) : 0;
  if (!size || !half || value === null || value === undefined) return app.text(kind, value ?? null);
  const places = 1 - Math.floor(Math.log10(size)), step = 10 ** places;
  const shown = (/** @type {number} */ number) => grouped((Math.round(toShown(kind, number, app.units) * step) / step).toFixed(Math.max(places, 0)));
  return unbroken(`${shown(value)} ± ${shown(half)} ${unitOf(kind, app.units)}`);
}

// A table with a caption and row headers; a cell is a text, or { text, note, className }.
// No line breaks a number from its unit.
/**
 * @typedef {string | { text?: string, note?: string, className?: string }} Cell
 * @param {string} caption
 * @param {Cell[]} columns
 * @param {Cell[][]} rows
 * @param {{ column?: number, all?: boolean }} [look]  pixels that a column needs, where they are not the usual ones; whether a long one is shown whole
 */
export function tableOf(caption, columns, rows, { column, all } = {}) {
  const cell = (/** @type {"th" | "td"} */ tag, /** @type {Cell} */ given, /** @type {boolean} */ number) => {
    const { text, note = "", className = "" } = typeof given === "object" && given !== null ? given : { text: given };
    const made = make(tag, { textContent: printed(text ?? "–"), className: [number ? "number" : "", className].filter(Boolean).join(" ") });
    if (note) made.append(make("small", { textContent: unbroken(note) }));
    return made;
  };
  const head = make("tr", {}, ...columns.map((words, i) => (words === "" ? make("td") : Object.assign(cell("th", words, i > 0), { scope: "col" }))));
  const body = rows.map((row) => make("tr", {}, ...row.map((given, i) => (
    i === 0 ? Object.assign(cell("th", given, false), { scope: "row" }) : cell("td", given, true)))));
  const table = make("table", {}, make("caption", { textContent: caption }), make("thead", {}, head), make("tbody", {}, ...body));
  const box = make("div", { className: "scroll", tabIndex: 0, role: "region", ariaLabel: caption }, table);
  fitted(box, { column, all });
  return box;
}

// Sentences as they are printed: with minus signs, where programs are told hyphens, and no line between number and unit.
const printed = (/** @type {string} */ text) => unbroken(text.replace(/(^|[\s(])-(?=\d)/g, "$1−"));

// Words where others stand: what stays as it is costs the browser nothing.
/**
 * @param {Element} place
 * @param {string} words
 * @returns whether they are other words than before
 */
export function write(place, words) {
  if (place.textContent === words) return false;
  place.textContent = words;
  return true;
}

// A sentence where another stands; no line breaks a number from its unit.
/** @param {Element} place @param {string} words */
export function tell(place, words) { return write(place, unbroken(words)); }

/** @param {HTMLElement} place @param {string[]} texts */
export function paragraphs(place, texts) {
  const rows = [...place.children];
  if (rows.length === texts.length && rows.every((row) => row.localName === "p")) rows.forEach((row, i) => write(row, printed(texts[i])));
  else place.replaceChildren(...texts.map((text) => make("p", { textContent: printed(text) })));
}

// A value of a row whose unit stands beside it, in the reader's units: [number, unit].
/** @type {Record<string, string>} */
const KIND_OF = {
  m: "x_m", mm: "x_m", "m/s": "x_m_s", mph: "x_m_s", "m/s^2": "x_m_s2", "kg m^2": "x_kg_m2", kN: "x_n", "N s": "x_n_s", ms: "x_ms",
};
/** @type {Record<string, number>} */
const TO_SI = { mm: 1e-3, mph: MPH, kN: 1e3 };

/** @param {number | string | null} value @param {string} unit @param {App} app */
export function inReadersUnit(value, unit, app) {
  if (typeof value !== "number") return value ?? "–";
  const kind = KIND_OF[unit];
  const si = value * (TO_SI[unit] ?? 1);
  if (kind && Math.abs(toShown(kind, si, app.units)) >= MANY) return `${four(toShown(kind, si, app.units))} ${unitOf(kind, app.units)}`;
  if (kind) return app.text(kind, si, decimalsFor(kind, si, app));
  return `${four(value)}${unit === "ratio" ? "" : ` ${unit.replace("^2", "²")}`}`;
}

// A number with four figures, thousands apart where there are many.
const MANY = 1e4;
/** @param {number} value */
function four(value) {
  return grouped(Number(value.toPrecision(4))).replace("-", "−");
}

// Four figures, but no more decimals than four.
/** @param {string} kind @param {number} value @param {App} app */
function decimalsFor(kind, value, app) {
  const size = Math.abs(toShown(kind, value, app.units));
  return size === 0 ? 1 : Math.min(4, Math.max(0, 3 - Math.floor(Math.log10(size))));
}

// An app for the controls of one of the other bats in the state of a comparison: scoped(app, 1, bounds).
// The list keeps only what differs from the defaults, so that addresses stay short.
/** @param {AppOf<"compare">} app @param {number} index @param {App["bounds"]} bounds */
export function scoped(app, index, bounds) {
  const { schema } = app;
  const defaults = Object.fromEntries((app.views.get(app.name)?.bat ?? []).map((field) => [field, schema[field].default ?? null]));
  const whole = (/** @type {Partial<State>} */ bat) => /** @type {State} */ ({ ...defaults, ...bat });
  return {
    schema,
    bounds,
    lists: app.lists.bind(app),
    text: app.text.bind(app),
    get units() { return app.units; },
    get state() { return whole(app.state.others[index]); },
    /** @param {Partial<State>} partial @param {Step} [step] */
    setState(partial, step) {
      const slim = (/** @type {State} */ bat) => Object.fromEntries(Object.entries(bat).filter(([field, value]) => JSON.stringify(value) !== JSON.stringify(defaults[field])));
      app.setState(changed("others", app.state.others.map((bat, i) => slim(whole({ ...bat, ...(i === index ? partial : {}) })))), step);
    },
    commit: app.commit.bind(app),
    /** @param {Control} control */
    control(control) {
      app.control({
        field: `others.${index}.${control.field}`,
        follows: control.follows,
        sync: ({ others }) => others[index] && control.sync(whole(others[index])),
        fault: (message) => control.fault?.(message),
      });
    },
  };
}

// A list of numbers with names: facts as [name, (answer) => [kind, value] or text]; fill it after every answer.
/** @typedef {[string, number | null, number?]} Shown a kind (units.js), a value, and how many decimals where not the usual ones */
/**
 * @template A  the answer
 * @typedef {[string, (answer: A, app: App) => string | Shown]} Fact
 */
/** @template A @param {Fact<A>[]} facts @param {App} app */
export function factList(facts, app) {
  const values = facts.map(() => make("span")), remarks = facts.map(() => make("small"));
  const element = make("dl", { className: "facts" }, ...facts.map(([name], i) => make("div", {}, make("dt", { textContent: name }), make("dd", {}, values[i], remarks[i]))));
  return {
    element,
    // Words below a number, by its name; none where there are none.
    /** @param {Record<string, string>} words */
    remark(words) {
      facts.forEach(([name], i) => write(remarks[i], words[name] ?? ""));
    },
    /** @param {A} answer */
    fill(answer) {
      facts.forEach(([, value], i) => {
        const found = value(answer, app);
        const words = typeof found === "string" ? found : app.text(...found);
        write(values[i], words.replace("\u00a0±", " ±")); // an interval is too long for the box of a telephone
      });
    },
  };
}
