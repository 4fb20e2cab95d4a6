// To show others: links, an embedded picture, the lines that give the same numbers, print.

import { LONG_ADDRESS, addressOf, shortAddressOf } from "./address.js";
import { button } from "../controls/controls.js";
import { make } from "../controls/parts.js";
import { posted } from "./post.js";
/** @import { App } from "./main.js" */

/** @param {App} app */
export function shareButton(app) {
  const made = button("Share", () => open(app));
  made.id = "share";
  made.setAttribute("aria-haspopup", "dialog");
  return made;
}

/** @param {App} app */
async function open(app) {
  const { name, state, defaults } = app;
  const here = (/** @type {string} */ address) => `${location.origin}${address}${address.includes("?") ? "&" : "?"}units=${app.units}`;
  const [long, inFrame] = [false, true].map((embed) => here(addressOf(name, state, defaults, embed)));
  const [packed, packedInFrame] = await Promise.all([false, true].map(async (embed) => here(await shortAddressOf(name, state, defaults, embed))));
  const short = packed.length < long.length ? packed : long;
  const cut = long.length > LONG_ADDRESS; // on its way through mail or chats: the packed one holds the same
  const [link, embedded] = cut ? [short, packedInFrame] : [long, inFrame];
  const dialog = make("dialog", { className: "share" });
  dialog.setAttribute("aria-labelledby", "share-title");
  const said = make("p", { className: "note" });
  said.setAttribute("role", "status");
  /** @type {(words: string, text: string | (() => Promise<string | null>)) => HTMLButtonElement} */
  const copy = (words, text) => button(words, async () => {
    const found = typeof text === "function" ? await text() : text;
    if (!found) {
      said.textContent = "There is nothing of that kind for this view.";
      return;
    }
    try {
      await navigator.clipboard.writeText(found);
      said.textContent = `${words}: copied.`;
    } catch { // not allowed, or no secure address
      said.textContent = "The browser did not let it be copied; it stands above.";
      shown.value = found;
      shown.select();
    }
  });
  const lines = (/** @type {string} */ key) => async () => {
    try {
      return (await posted(`/api/v1/${name}/recipe`, state))[key];
    } catch (fault) {
      said.textContent = fault.message;
      return null;
    }
  };
  const shown = make("input", { type: "text", readOnly: true, value: short });
  shown.setAttribute("aria-label", "Link to this picture");
  dialog.append(make("h2", { id: "share-title", textContent: "Show it to others" }), shown,
    make("div", { className: "row" },
      copy("Copy the link", link), copy("Copy a short link", short),
      copy("Copy as Python", lines("python")), copy("Copy as command", lines("command")),
      copy("Copy to embed", `<iframe src="${embedded.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}" width="800" height="600" title="sweetspot: ${name}"></iframe>`),
      button("Print", () => {
        dialog.close();
        print();
      })), said,
    make("p", { className: "note", textContent: "Links lead to this server; who opens them needs one too. A short link holds everything itself." }),
    make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  shown.select();
}
