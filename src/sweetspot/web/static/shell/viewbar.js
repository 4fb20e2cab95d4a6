// The bar: the groups of views, and below it the views of the present one. A link leads to its view with the bat and the
// hit that go along; a group's to the view of it that was seen last.

import { byId, make, partOf } from "../controls/parts.js";
/** @import { App } from "./main.js" */

export const HOME = "start";

/** @param {string} id */
const linksOf = (id) => [...byId(id).querySelectorAll("a")];

/** @param {App} app */
export function fillBar(app) {
  const [groups, views] = ["groups", "views"].map((id) => partOf(byId(id), "ul", HTMLElement));
  for (const { name, title, group } of app.views.values()) {
    if (name === HOME) continue;
    if (!linksOf("groups").some(({ dataset }) => dataset.group === group)) groups.append(make("li", {}, linkTo(group, { group, name })));
    views.append(make("li", {}, linkTo(title, { group, name })));
  }
  for (const bar of [byId("groups"), byId("views"), partOf(document, ".brand", HTMLElement)]) bar.addEventListener("click", (event) => follow(event, app));
  new ResizeObserver(() => linksOf("views").filter((link) => link.hasAttribute("aria-current")).forEach(centre)).observe(byId("views")); // a phone that is turned
}

/** @param {string} words @param {{ group: string, name: string }} data */
function linkTo(words, data) {
  const link = make("a", { textContent: words });
  Object.assign(link.dataset, data);
  return link;
}

/** @param {App} app */
export function pointBar(app) {
  const here = app.entry(app.name);
  byId("views").hidden = here.group === "";
  for (const link of linksOf("groups")) {
    const its = link.dataset.group === here.group;
    if (its) link.dataset.name = here.name;
    link.href = app.addressFor(link.dataset.name ?? HOME);
    mark(link, its ? "true" : "");
  }
  for (const link of linksOf("views")) {
    const { name = HOME, group } = link.dataset;
    link.href = app.addressFor(name);
    if (link.parentElement) link.parentElement.hidden = group !== here.group;
    mark(link, name === here.name ? "page" : "");
    if (name === here.name) centre(link);
  }
  const brand = partOf(document, ".brand", HTMLAnchorElement);
  brand.href = app.addressFor(HOME);
  mark(brand, here.name === HOME ? "page" : "");
}

/** @param {Element} link @param {string} current */
function mark(link, current) {
  if (current) link.setAttribute("aria-current", current);
  else link.removeAttribute("aria-current");
}

/** @param {MouseEvent} event @param {App} app */
export function follow(event, app) {
  const link = event.target instanceof Element ? event.target.closest("a") : null;
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
  event.preventDefault();
  app.visit(link.href);
}

// Bring a link into the middle of a bar that is too narrow for all of them; the page itself stays where it is.
/** @param {Element} link */
function centre(link) {
  const bar = link.closest("nav");
  if (!bar) return;
  const [all, own] = [bar.getBoundingClientRect(), link.getBoundingClientRect()];
  bar.scrollLeft += own.left + own.width / 2 - all.left - all.width / 2;
}
