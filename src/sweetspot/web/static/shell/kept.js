// What outlives a reload of the page: in this tab and nowhere else, and until the tab is closed.
//
//   const sounds = kept("sounds", []);      // what was kept under a name, or this
//   keep("sounds", [...]);                  // null: nothing any more

/** @template T @param {string} name @param {T} otherwise @returns {T} */
export const kept = (name, otherwise) => JSON.parse(sessionStorage.getItem(name) ?? "null") ?? otherwise;

/** @param {string} name @param {unknown} what */
export function keep(name, what) {
  if (what === null) sessionStorage.removeItem(name);
  else sessionStorage.setItem(name, JSON.stringify(what));
}
