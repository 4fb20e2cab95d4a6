// Tables that show each row apart, one beneath the other, where there is no room for their columns.
//
//   fitted(box);             // a .scroll with one table in it; its cells get their columns' names, and it is shortened
//                            // where it is long, unless { all: true }
//
// A table is shown so while it would have to be scrolled sideways, or its columns would be narrower than words are.

import { TWO_WORDS } from "./units.js";

const COLUMN = 76; // pixels that a column needs at least
const LONG = 14; // letters of a row's name from which on it needs the room of two columns
const BRACKETS = /\([^()]{1,24}\)/g; // an interval, which no line breaks
const BEFORE_UNIT = /(?<=\d) (?!(?:and|as|at|by|for|from|half|is|of|on|or|per|that|the|to|with)\b)(?=[a-zµ°²%/]{1,4}\d?[²³]?(?:[\s,;:.)]|$))/gi;
const INSIDE_UNIT = /(?<=\d[ \u00a0](?:oz|kg|N)) (?=(?:in²|cm²|m²|s)(?![a-z]))/g;
const UNIT_OF_HEAD = new RegExp(`(?<=[ (])(?:${TWO_WORDS.join("|")})(?![\\w²])`, "g");
const LEAST = 5.4; // rem that a cell of such a row has at least
const SENTENCE = 24; // letters from which on a cell of a row that stands apart has a line of its own
const LONG_TABLE = 15, FIRST = 10; // rows from which on a table shows its first alone, and how many those are
const [LETTER, AROUND] = [0.6, 0.8]; // rem that a letter takes at most, and that stand around a cell's words

// A text in which number and unit stay on one line, and so does what it may be off by.
/** @param {string} text */
export function unbroken(text) {
  return String(text).replace(BEFORE_UNIT, "\u00a0").replace(INSIDE_UNIT, "\u00a0").replaceAll(/(?<=\d) ± | ?± /g, "\u00a0±\u00a0");
}

const whole = new Set(); // the names of long tables that somebody wanted all of
/** @type {WeakMap<Element, number>} */
const needed = new WeakMap(); // by the ruler of a table: pixels that its columns need

const watched = new ResizeObserver((rulers) => {
  for (const { target } of rulers) arrange(target);
});

/**
 * @param {Element} box
 * @param {{ column?: number, all?: boolean }} [look]  pixels that each column of this table needs; whether every row is shown
 */
export function fitted(box, { column = COLUMN, all = false } = {}) {
  const heads = [...box.querySelectorAll("thead tr > *")];
  const rows = [...box.querySelectorAll("tbody tr")];
  for (const { firstChild: words } of heads) if (words instanceof Text) words.data = words.data.replace(UNIT_OF_HEAD, (unit) => unit.replaceAll(" ", "\u00a0"));
  for (const row of rows) [...row.children].forEach((cell, i) => cell instanceof HTMLElement && fit(cell, i, heads[i]?.firstChild?.textContent ?? ""));
  const widest = Math.max(0, ...rows.flatMap((row) => [...row.children].slice(1).map(longestOf)));
  box.querySelector("table")?.style.setProperty("--cell", `${Math.max(LEAST, LETTER * widest + AROUND)}rem`);
  const named = rows.some((row) => (row.firstElementChild?.textContent ?? "").length > LONG);
  const ruler = document.createElement("div"); // as wide as the box, and never resized by what becomes of the table
  box.prepend(ruler);
  needed.set(ruler, heads.length > 2 ? column * (heads.length + Number(named)) : 0);
  watched.observe(ruler);
  if (!all) shorten(box, rows);
}

// A long table begins with its first rows and a button for the others; on paper it is whole.
/** @param {Element} box @param {Element[]} rows */
function shorten(box, rows) {
  const name = box.getAttribute("aria-label");
  if (rows.length < LONG_TABLE || whole.has(name)) return;
  for (const row of rows.slice(FIRST)) row.classList.add("later");
  const more = Object.assign(document.createElement("button"), { type: "button", textContent: `All ${rows.length} rows` });
  more.addEventListener("click", () => {
    whole.add(name);
    for (const row of rows) row.classList.remove("later");
    more.remove();
    if (box instanceof HTMLElement) box.focus();
  });
  box.append(more);
}

// A cell with its column's name, its numbers in one piece; the name of a row that is a number says what of.
/** @param {HTMLElement} cell @param {number} i @param {string} label */
function fit(cell, i, label) {
  const words = cell.textContent ?? "";
  if (i > 0 || /^[−-]?[\d.,]+$/.test(words)) cell.dataset.label ??= label;
  if (i === 0 || cell.childElementCount) return;
  if (words.trim() === "") cell.classList.add("blank");
  else if (/^█+$/.test(words)) cell.classList.add("bars");
  else if (words.length > SENTENCE) cell.classList.add("sentence");
  cell.textContent = unbroken(words).replace(BRACKETS, (one) => one.replaceAll(" ", "\u00a0"));
}

// Letters of the longest piece of a cell that no line breaks; a sentence has a line of its own.
/** @param {Element} cell */
function longestOf(cell) {
  if (cell.matches(".sentence, .bars")) return 0;
  return Math.max(...(cell.firstChild?.textContent ?? "").split(/[ -]/).map((piece) => piece.length));
}

// As a table where it fits, else row by row.
/** @param {Element} ruler */
function arrange(ruler) {
  const [room, table] = [ruler.clientWidth, ruler.parentElement?.querySelector("table")];
  if (!table || !room) return;
  if (!table.classList.contains("apart") && table.scrollWidth > room + 1) needed.set(ruler, Math.max(table.scrollWidth, needed.get(ruler) ?? 0));
  table.classList.toggle("apart", room < (needed.get(ruler) ?? 0) - 1);
  if (ruler.parentElement) endWithRow(ruler.parentElement);
}

// A box that is scrolled ends where one of its rows does, so that none is cut through.
/** @param {HTMLElement} box */
export function endWithRow(box) {
  box.style.maxHeight = "";
  const most = parseFloat(getComputedStyle(box).maxHeight);
  if (!(box.scrollHeight > most + 1)) return;
  const top = box.getBoundingClientRect().top - box.scrollTop;
  const ends = [...box.querySelectorAll("tbody tr")].map((row) => row.getBoundingClientRect().bottom - top);
  box.style.maxHeight = `${Math.ceil(Math.max(ends[0] ?? most, ...ends.filter((end) => end <= most)))}px`;
}
