// A worksheet to print: the pictures, questions with room for answers, and no numbers that give them away.

import { byId, make } from "../controls/parts.js";
/** @import { File } from "./file.js" */

const ROWS = 3; // lines to write on below a question

// Turn the sheet on or off.
/** @param {File} file @param {HTMLButtonElement} button */
export function sheet(file, button) {
  const shown = document.body.classList.toggle("sheet"), { labels, questions } = file.words, place = byId("sheet");
  button.setAttribute("aria-pressed", String(shown));
  place.hidden = !shown;
  if (!shown) return;
  const blank = () => make("span", { className: "blank-line" });
  place.replaceChildren(make("h2", { textContent: labels.worksheet_title }),
    make("p", { className: "row" }, `${labels.name}:`, blank(), `${labels.date}:`, blank()),
    make("ol", {}, ...questions[file.units].map((/** @type {string} */ words) => make("li", {}, words, ...Array.from({ length: ROWS }, blank)))));
  place.scrollIntoView();
}
