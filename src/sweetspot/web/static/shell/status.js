// What is wrong, said on top of the page: with the server, or with a question and no control to say it beside.

import { byId, make, partOf, showWords } from "../controls/parts.js";
/** @import { Control, Fault } from "./main.js" */
/** @import { System } from "../controls/units.js" */

const MOST = 4, LONGEST = 40; // names that are told, and letters of one
/** @type {Record<string, string>} */
const WORDS = {
  open: "",
  preparing: "First start: the solver is being compiled for this machine. That takes about a minute, once; the picture then comes by itself.",
  lost: "The connection to the server is lost. Trying again; the page then goes on by itself.",
  slow: "The server is taking its time with this answer.",
};

/** @param {string} status */
export function showStatus(status) {
  if (document.body.dataset.line === status) return;
  byId("status").textContent = WORDS[status];
  byId("status").hidden = WORDS[status] === "";
  document.body.dataset.line = status;
}

// In the place of a view that could not be fetched: that it comes. Nothing where there is no title.
/** @param {string} title */
export function showAbsent(title) {
  const view = byId("view");
  view.querySelector(":scope > .absent")?.remove();
  view.toggleAttribute("data-absent", title !== "");
  if (title) view.append(make("p", { className: "absent picture wide", textContent: `${title} needs the server, which does not answer. It comes by itself once the connection is back.` }));
}

// What an address names and no control of the view is called; a slip would otherwise change nothing without a word.
/** @param {string[]} names @param {string} title */
export function showUnknown(names, title) {
  showWords(byId("unknown"), names.length ? `${title} has no ${names.length > 1 ? "controls" : "control"} ${names.slice(0, MOST).map((name) => `“${name.slice(0, LONGEST)}”`).join(", ")}${names.length > MOST ? " …" : ""}; that part of the address changes nothing.` : "");
}

// What is wrong, in the reader's units.
/** @param {Fault} fault @param {System} units */
export const wordsOf = ({ words, message }, units) => words?.[units] ?? message;

// Beside each control what is wrong with it, and on top what belongs to none.
/** @param {Fault[]} faults @param {Map<string, Control>} controls @param {System} units */
export function showFaults(faults, controls, units) {
  for (const control of controls.values()) control.fault?.("");
  const homeless = faults.filter((fault) => {
    const control = controlOf(fault.field, controls);
    control?.fault?.(wordsOf(fault, units));
    return !control;
  });
  const words = homeless.map((fault) => (fault.field ? `${fault.field}: ` : "") + wordsOf(fault, units)).join("; ");
  partOf(byId("fault"), "span", HTMLElement).textContent = words;
  byId("fault").hidden = homeless.length === 0;
}

// "profile_in.3.1" belongs to the control of profile_in.
/** @param {string} field @param {Map<string, Control>} controls */
function controlOf(field, controls) {
  const parts = field.split(".");
  for (let length = parts.length; length > 0; length -= 1) {
    const control = controls.get(parts.slice(0, length).join("."));
    if (control?.fault) return control;
  }
  return undefined;
}
