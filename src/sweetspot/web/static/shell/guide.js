// Three steps whenever asked for; each view has its own. Nothing lies over a picture by itself.

import { partOf } from "../controls/parts.js";
/** @import { App } from "./main.js" */

const LAST = "The address holds all of it: send it to someone, or go back.";

/** @param {App} app */
export function guide(app) {
  const button = Object.assign(document.createElement("button"), { type: "button", id: "guide", textContent: "Guide" });
  button.setAttribute("aria-haspopup", "dialog");
  button.addEventListener("click", () => open(app));
  return button;
}

/** @param {App} app */
function open({ guide: steps }) {
  const dialog = document.createElement("dialog");
  dialog.className = "guide";
  dialog.setAttribute("aria-labelledby", "guide-title");
  dialog.innerHTML = "<p class=\"note\"></p><h2 id=\"guide-title\"></h2><p class=\"words\"></p>" +
    "<div class=\"row\"><button type=\"button\" class=\"back\">Back</button><button type=\"button\" class=\"primary next\"></button>" +
    "<button type=\"button\" class=\"end\">Close</button></div>";
  const part = (/** @type {string} */ name) => partOf(dialog, name, HTMLElement);
  const [back, next] = [".back", ".next"].map((name) => partOf(dialog, name, HTMLButtonElement));
  let step = 0;
  const show = () => {
    part(".note").textContent = `Step ${step + 1} of ${steps.length}`;
    const last = step === steps.length - 1;
    const [title, words] = steps[step];
    part("h2").textContent = title;
    part(".words").textContent = last ? words + LAST : words;
    back.disabled = step === 0;
    next.textContent = last ? "Start" : "Next";
  };
  back.addEventListener("click", () => ((step -= 1), show()));
  next.addEventListener("click", () => {
    step += 1;
    if (step === steps.length) dialog.close();
    else show();
  });
  part(".end").addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => dialog.remove());
  show();
  document.body.append(dialog);
  dialog.showModal();
  next.focus();
}
