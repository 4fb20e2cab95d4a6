// The buttons of the page's head: undo and redo, units, light or dark, export.

import { byId } from "../controls/parts.js";
/** @import { App } from "./main.js" */

/** @param {string} id @param {string} words @param {string} title @param {() => void} act */
export function stepButton(id, words, title, act) {
  const made = Object.assign(document.createElement("button"), { type: "button", id, textContent: words, title });
  made.setAttribute("aria-label", title);
  made.addEventListener("click", act);
  return made;
}

/** @template {string} Value @param {string} name @param {[Value, string][]} choices @param {Value} chosen @param {(value: Value) => void} onChange */
export function switchOf(name, choices, chosen, onChange) {
  const group = document.createElement("fieldset");
  group.className = "switch";
  group.innerHTML = `<legend class="unseen">${name}</legend>` + choices.map(
    ([value, words]) => `<label><input type="radio" name="${name}" value="${value}"><span>${words}</span></label>`).join("");
  for (const one of group.querySelectorAll("input")) {
    one.checked = one.value === chosen;
    one.addEventListener("change", () => onChange(/** @type {Value} */ (one.value)));
  }
  return group;
}

/** @param {() => void} onChange */
export function themeButton(onChange) {
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
  addEventListener("beforeprint", () => { // paper is white
    const { theme } = root.dataset;
    root.dataset.theme = "light";
    onChange();
    addEventListener("afterprint", () => {
      if (theme) root.dataset.theme = theme;
      else delete root.dataset.theme;
      onChange();
    }, { once: true });
  });
  label();
  return button;
}

// On a narrow page the tools lie behind a button of their own.
export function menuButton() {
  const menu = byId("menu"), tools = byId("tools");
  const turn = (/** @type {boolean} */ open) => {
    tools.classList.toggle("open", open);
    menu.setAttribute("aria-expanded", String(open));
  };
  menu.addEventListener("click", () => turn(!tools.classList.contains("open")));
  addEventListener("keydown", ({ key }) => key === "Escape" && tools.contains(document.activeElement) && (turn(false), menu.checkVisibility() && menu.focus()));
}

// What it opens is fetched when first wanted.
/** @param {App} app */
export function exportButton(app) {
  const button = Object.assign(document.createElement("button"), { type: "button", id: "export", textContent: "Export" });
  button.setAttribute("aria-haspopup", "dialog");
  button.addEventListener("click", async () => (await import("./exports.js")).openExports(app));
  return button;
}
