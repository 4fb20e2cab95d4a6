// The modules of the views, and what else is fetched only when wanted.

/** @import { App } from "./main.js" */

// A view's module. A failed import is remembered by the browser under its address, so another try needs another one.
const modules = new Map();
let tries = 0;

/** @param {string} name */
export function fetched(name) {
  if (!modules.has(name)) {
    const again = tries ? `?try=${tries}` : "";
    modules.set(name, import(`../views/${name}.js${again}`).catch((error) => {
      modules.delete(name);
      tries += 1;
      throw error;
    }));
  }
  return modules.get(name);
}

// Those of the other views, the exports and the wizard, so that they are there at once, even without a server; who goes there asks again.
/** @param {App} app */
export function fetchOthers(app) {
  for (const name of app.views.keys()) fetched(name).catch(() => {});
  import("./exports.js").then(({ onPaper }) => onPaper(app), () => {});
  import("../bat/wizard.js").catch(() => {});
}
