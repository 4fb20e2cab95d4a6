// Pieces that several views are made of: tables, paragraphs, sentences in either system of units, controls inside a list.

import { MPH, toShown, unitOf } from "./units.js";
/** @import { Answer, App, State } from "./main.js" */

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

// "11,300 ± 680 oz in²": a value with its interval, with no more digits than are known; alone where there is none.
export function withDoubt(kind, value, half, app) {
  const size = half ? Math.abs(toShown(kind, half, app.units)) : 0;
  if (!size) return app.text(kind, value);
  const places = 1 - Math.floor(Math.log10(size)), step = 10 ** places;
  const shown = (number) => (Math.round(toShown(kind, number, app.units) * step) / step).toLocaleString("en-US", { minimumFractionDigits: Math.max(places, 0), maximumFractionDigits: Math.max(places, 0) });
  return `${shown(value)} ± ${shown(half)} ${unitOf(kind, app.units)}`;
}

const BEFORE_UNIT = /(?<=\d) (?=[a-zµ°²%/]{1,4}\d?[²³]?(?:[\s,;)]|$))/gi;

// A text in which number and unit stay on one line.
export function unbroken(text) {
  return String(text).replace(BEFORE_UNIT, "\u00a0");
}

// A table with a caption and row headers; a cell is a text, or { text, note, className }.
// No line breaks a number from its unit.
export function tableOf(caption, columns, rows) {
  const cell = (tag, given, number) => {
    const { text, note = "", className = "" } = typeof given === "object" && given !== null ? given : { text: given };
    const made = make(tag, { textContent: unbroken(text ?? "–"), className: [number ? "number" : "", className].filter(Boolean).join(" ") });
    if (note) made.append(make("small", { textContent: note }));
    return made;
  };
  const head = make("tr", {}, ...columns.map((words, i) => Object.assign(cell("th", words, i > 0), { scope: "col" })));
  const body = rows.map((row) => make("tr", {}, ...row.map((given, i) => (
    i === 0 ? Object.assign(cell("th", given, false), { scope: "row" }) : labelled(cell("td", given, true), columns[i])))));
  const table = make("table", {}, make("caption", { textContent: caption }), make("thead", {}, head), make("tbody", {}, ...body));
  return make("div", { className: "scroll", tabIndex: 0, role: "region", ariaLabel: caption }, table);
}

// The column's name beside the cell, for narrow screens where the head is not shown.
function labelled(cell, column) {
  cell.dataset.label = typeof column === "object" ? column.text : column;
  return cell;
}

// Sentences as they are printed: with minus signs, where programs are told hyphens, and no line between number and unit.
const printed = (text) => unbroken(text.replace(/(^|[\s(])-(?=\d)/g, "$1−"));

export function paragraphs(place, texts) {
  place.replaceChildren(...texts.map((text) => make("p", { textContent: printed(text) })));
}

// A value of a row whose unit stands beside it, in the reader's units: [number, unit].
const KIND_OF = {
  m: "x_m", mm: "x_m", "m/s": "x_m_s", mph: "x_m_s", "kg m^2": "x_kg_m2", kN: "x_n", "N s": "x_n_s", ms: "x_ms",
};
const TO_SI = { mm: 1e-3, mph: MPH, kN: 1e3 };

/**
 * @param {any} value
 * @param {string} unit
 * @param {App} app
 */
export function inReadersUnit(value, unit, app) {
  if (typeof value !== "number") return value ?? "–";
  const kind = KIND_OF[unit];
  if (kind) return app.text(kind, value * (TO_SI[unit] ?? 1), decimalsFor(kind, value * (TO_SI[unit] ?? 1), app));
  const shown = Math.abs(value) >= 1e4 ? value.toPrecision(4) : String(Number(value.toPrecision(4)));
  const tidy = Math.abs(value) >= 1e4 ? Number(shown).toLocaleString("en-US") : shown;
  return `${tidy.replace("-", "−")}${unit === "ratio" ? "" : ` ${unit.replace("^2", "²")}`}`;
}

// Four figures, but no more decimals than four.
/**
 * @param {string} kind
 * @param {number} value
 * @param {App} app
 */
function decimalsFor(kind, value, app) {
  const size = Math.abs(toShown(kind, value, app.units));
  return size === 0 ? 1 : Math.min(4, Math.max(0, 3 - Math.floor(Math.log10(size))));
}

// An app for the controls of one item of a list of bats in the state: scoped(app, "others", 1, bounds).
// The list keeps only what differs from the defaults, so that addresses stay short.
/**
 * @param {App} app
 * @param {string} list
 * @param {number} index
 * @param {App["bounds"]} bounds
 */
export function scoped(app, list, index, bounds) {
  const { schema } = app;
  const defaults = Object.fromEntries((app.views.get(app.name)?.bat ?? []).map((field) => [field, schema[field].default ?? null]));
  return {
    schema,
    bounds,
    lists: (...names) => app.lists(...names),
    text: (name, value, digits) => app.text(name, value, digits),
    get units() { return app.units; },
    /** @returns {State} */
    get state() { return { ...defaults, ...app.state[list][index] }; },
    setState(partial, options) {
      const items = app.state[list].map((item, i) => slim({ ...defaults, ...item, ...(i === index ? partial : {}) }, defaults));
      app.setState({ [list]: items }, options);
    },
    commit: (options) => app.commit(options),
    control(control) {
      app.control({
        field: `${list}.${index}.${control.field}`,
        sync: (state) => state[list][index] && control.sync({ ...defaults, ...state[list][index] }),
        fault: (message) => control.fault(message),
      });
    },
  };
}

function slim(item, defaults) {
  const kept = Object.entries(item).filter(([field, value]) => JSON.stringify(value) !== JSON.stringify(defaults[field]));
  return Object.fromEntries(kept);
}

// A list of numbers with names: facts as [name, (answer) => [kind, value] or text]; fill it after every answer.
/** @typedef {[string, number | null, number?]} Shown a kind (units.js), a value, and how many decimals where not the usual ones */
/** @typedef {[string, (answer: Answer, app: App) => string | Shown]} Fact */
/**
 * @param {Fact[]} facts
 * @param {App} app
 */
export function factList(facts, app) {
  const values = facts.map(() => make("dd"));
  const element = make("dl", { className: "facts" }, ...facts.map(([name], i) => make("div", {}, make("dt", { textContent: name }), values[i])));
  return {
    element,
    fill(answer) {
      facts.forEach(([, value], i) => {
        const found = value(answer, app);
        values[i].textContent = typeof found === "string" ? found : app.text(...found);
      });
    },
  };
}
