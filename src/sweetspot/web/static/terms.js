// What the words mean, shown where they stand on hover and focus, with the source; and all of them in a list.

import { make } from "./parts.js";

let known = null; // promise of a map from a word, in small letters, to { words, source }
let count = 0;

function meanings() {
  known ??= fetch("/api/v1/terms").then((response) => response.json()).then((terms) => (
    new Map(terms.flatMap((term) => term.names.map((name) => [name, term]))))).catch(() => {
    known = null; // so that the next who asks tries again
    return new Map();
  });
  return known;
}

// Give every heading and name below a root that is known its meaning.
export async function explain(root) {
  const map = await meanings();
  for (const place of root.querySelectorAll("dt:not([data-term]), th[scope=col]:not([data-term])")) {
    const term = map.get(place.textContent.trim().toLowerCase());
    place.dataset.term = term ? "known" : "";
    if (!term) continue;
    count += 1;
    const tip = make("span", { className: "tip", id: `tip-${count}`, textContent: `${term.words} ${term.source}` });
    tip.setAttribute("role", "tooltip");
    const word = make("span", { className: "term", tabIndex: 0 }, ...place.childNodes);
    word.setAttribute("aria-describedby", tip.id);
    place.replaceChildren(word, tip);
  }
}

export async function listTerms() {
  const map = await meanings();
  const dialog = make("dialog", { className: "words-list" });
  dialog.setAttribute("aria-labelledby", "terms-title");
  const terms = [...new Set(map.values())];
  dialog.append(make("h2", { id: "terms-title", textContent: "What the words mean" }),
    make("dl", {}, ...terms.flatMap(({ names, words, source }) => [
      make("dt", { textContent: names[0] }), make("dd", {}, words, make("small", { textContent: ` ${source}` }))])),
    make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
