// "Save as one file": the present bat, its swing and its ball as one file of HTML, to be sent to somebody.

import { download } from "./download.js";
/** @import { App } from "./main.js" */

const FIELDS = ["bat", "pitch_speed_mph"]; // of a view whose bat is hit

// Which view makes the file of what the present one shows; none where nothing is hit.
/** @param {App} app */
export const makerOf = (app) => (app.name === "sports" ? "sports" : FIELDS.every((field) => field in app.schema) ? "explorer" : null);

/** @param {App} app @param {"explorer" | "sports"} maker */
export async function saveOneFile(app, maker) {
  const fields = Object.keys(app.entry(maker).schema);
  const state = Object.fromEntries(Object.entries(app.state).filter(([field]) => fields.includes(field)));
  const { name, html } = await app.ask(`${maker}/file`, /** @type {any} */ (state));
  download(name, "text/html", html);
}
