// What a button does with the server's help; where that fails, a dialog says why.

import { make } from "./parts.js";

/** @param {() => Promise<void>} doing */
export async function orSaid(doing) {
  try {
    await doing();
  } catch (fault) {
    const dialog = make("dialog", {}, make("p", { textContent: fault.message }), make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }
}
