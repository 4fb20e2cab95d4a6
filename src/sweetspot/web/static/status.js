// What is wrong, said on top of the page: with the server, or with a question and no control to say it beside.

import { byId, partOf } from "./parts.js";
/** @import { Control, Fault } from "./main.js" */

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

// Beside each control what is wrong with it, and on top what belongs to none.
/**
 * @param {Fault[]} faults
 * @param {Map<string, Control>} controls
 */
export function showFaults(faults, controls) {
  for (const control of controls.values()) control.fault?.("");
  const homeless = faults.filter(({ field, message }) => {
    const control = controlOf(field, controls);
    control?.fault?.(message);
    return !control;
  });
  const words = homeless.map(({ field, message }) => (field ? `${field}: ${message}` : message)).join("; ");
  partOf(byId("fault"), "span", HTMLElement).textContent = words;
  byId("fault").hidden = homeless.length === 0;
}

// "profile_in.3.1" belongs to the control of profile_in.
/**
 * @param {string} field
 * @param {Map<string, Control>} controls
 */
function controlOf(field, controls) {
  const parts = field.split(".");
  for (let length = parts.length; length > 0; length -= 1) {
    const control = controls.get(parts.slice(0, length).join("."));
    if (control?.fault) return control;
  }
  return undefined;
}
