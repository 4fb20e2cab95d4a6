// The bar with a link to each view, which leads there with the bat and the hit that go along.

import { byId } from "../controls/parts.js";
/** @import { App } from "./main.js" */

/** @param {App} app */
export function fillBar(app) {
  const bar = byId("views");
  for (const { name, title } of app.views.values()) {
    const link = Object.assign(document.createElement("a"), { textContent: title });
    link.dataset.name = name;
    const item = document.createElement("li");
    item.append(link);
    bar.append(item);
  }
  bar.addEventListener("click", (event) => follow(event, app));
  new ResizeObserver(() => bar.querySelectorAll("[aria-current]").forEach(centre)).observe(bar); // a phone that is turned
}

/** @param {App} app */
export function pointBar(app) {
  for (const link of byId("views").querySelectorAll("a")) {
    link.href = app.addressFor(link.dataset.name ?? "");
    if (link.dataset.name === app.name) {
      link.setAttribute("aria-current", "page");
      centre(link);
    }
    else link.removeAttribute("aria-current");
  }
}

/** @param {MouseEvent} event @param {App} app */
function follow(event, app) {
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
