// What the words mean, shown where they stand on hover and focus, with the source; and all of them in a list.

import { make } from "../controls/parts.js";
import { asked } from "./post.js";
/** @import { App } from "./main.js" */
/** @import { System } from "../controls/units.js" */

/** @typedef {{ names: string[], words: Record<System, string>, source: string }} Term */
/** @type {Promise<Map<string, Term>> | null} */
let wanted = null; // promise of them
/** @type {Map<string, Term>} */
let known = new Map(); // from a word, in small letters, to { words, source }
/** @type {HTMLElement | null} */
let tip = null; // one for the page: what the word that is pointed at means

// All that is known; nothing while the server cannot be reached, and whoever asks next tries again.
/** @returns {Promise<Map<string, Term>>} */
function meanings() {
  wanted ??= asked("/api/v1/terms").then((response) => response.json()).then((/** @type {Term[]} */ terms) => (
    known = new Map(terms.flatMap((term) => term.names.map((name) => /** @type {[string, Term]} */ ([name, term])))))).catch(() => {
    wanted = null;
    return known;
  });
  return wanted;
}

// Give every heading and name below a root that is known its meaning.
/** @param {ParentNode} root @param {App} app */
export async function explain(root, app) {
  const map = await meanings();
  if (!map.size) return;
  tip ??= tipOf(app);
  for (const place of /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("dt:not([data-term]), th[scope=col]:not([data-term])"))) {
    const name = (place.textContent ?? "").trim().toLowerCase();
    place.dataset.term = map.has(name) ? name : "";
    if (!map.has(name)) continue;
    const word = make("span", { className: "term", tabIndex: 0 }, ...place.childNodes);
    word.setAttribute("aria-describedby", tip.id);
    place.replaceChildren(word);
  }
}

// Shown on hover and focus, stays while the pointer is on it, goes with Escape.
/** @param {App} app */
function tipOf(app) {
  const made = make("div", { id: "tip", className: "tip", hidden: true });
  made.setAttribute("role", "tooltip");
  const show = (/** @type {Event} */ event) => {
    const word = event.target instanceof Element ? event.target.closest(".term") : null;
    const term = known.get(word?.parentElement?.dataset.term ?? "");
    if (!word || !term) return;
    const { words, source } = term;
    made.replaceChildren(words[app.units], make("small", { textContent: ` ${source}` }));
    made.hidden = false;
    const box = word.getBoundingClientRect();
    made.style.left = `${Math.max(8, Math.min(box.left + scrollX, scrollX + document.documentElement.clientWidth - made.offsetWidth - 8))}px`;
    made.style.top = `${box.bottom + scrollY}px`;
  };
  const hide = (/** @type {MouseEvent | FocusEvent} */ event) => {
    const next = event.relatedTarget;
    if (!(next instanceof Element && next.closest(".term, #tip"))) made.hidden = true;
  };
  document.addEventListener("mouseover", show);
  document.addEventListener("focusin", show);
  document.addEventListener("mouseout", hide);
  document.addEventListener("focusout", hide);
  document.addEventListener("keydown", (event) => event.key === "Escape" && (made.hidden = true));
  document.body.append(made);
  return made;
}

/** @param {App} app */
export async function listTerms(app) {
  const map = await meanings();
  const dialog = make("dialog", { className: "words-list" });
  dialog.setAttribute("aria-labelledby", "terms-title");
  const terms = [...new Set(map.values())];
  dialog.append(make("h2", { id: "terms-title", textContent: "What the words mean" }),
    make("dl", {}, ...terms.flatMap(({ names, words, source }) => [
      make("dt", { textContent: names[0] }), make("dd", {}, words[app.units], make("small", { textContent: ` ${source}` }))])),
    make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
