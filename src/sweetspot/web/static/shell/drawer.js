// On a phone the controls are a drawer at the foot of the screen, also for the keyboard; a fault in it opens it. What the
// keyboard goes to is moved from under it, and from under the picture that stays on top.

const LOW = 480; // px of a window, which the controls would fill: a telephone on its side, or a page at 400 %
const NARROW = matchMedia("(max-width: 54rem)"); // as in theme.css
const CLEAR = 8; // px between what has the focus and what would lie over it

/** @param {HTMLElement | null} side */
export function drawerOf(side, /** @type {HTMLElement} */ root, /** @type {AbortSignal} */ signal) {
  if (!side) return;
  const toggle = Object.assign(document.createElement("button"), { type: "button", className: "drawer" });
  const label = () => {
    const shut = side.classList.contains("shut");
    toggle.textContent = shut ? "▴ Controls" : "▾ Controls";
    toggle.setAttribute("aria-expanded", String(!shut));
  };
  const turn = (/** @type {boolean} */ shut) => {
    side.classList.toggle("shut", shut);
    label();
  };
  let chosen = false; // somebody opened or shut it
  toggle.addEventListener("click", () => {
    chosen = true;
    turn(!side.classList.contains("shut"));
  });
  side.addEventListener("reveal", () => turn(false));
  side.prepend(toggle);
  turn(globalThis.innerHeight < LOW && getComputedStyle(toggle).display !== "none");
  addEventListener("resize", () => chosen || globalThis.innerHeight < LOW || turn(false), { signal }); // a telephone upright again
  const after = side.nextSibling;
  const put = () => root.insertBefore(side, NARROW.matches ? null : after);
  put();
  NARROW.addEventListener("change", put, { signal });
  root.addEventListener("focusin", () => requestAnimationFrame(() => uncover(side, root)), { signal }); // once the browser has scrolled
}

// Scroll what has the focus between the picture on top and the drawer, as far as it has room there.
/** @param {HTMLElement} side @param {HTMLElement} root */
function uncover(side, root) {
  const at = document.activeElement;
  const lies = (/** @type {Element} */ one) => getComputedStyle(one).position === "sticky";
  if (!at || at === root || !lies(side) || !root.contains(at) || side.contains(at) || !at.matches(":focus-visible")) return;
  const box = at.getBoundingClientRect();
  const pinned = [...root.querySelectorAll(".pinned")].find((one) => lies(one) && one !== at && Boolean(one.compareDocumentPosition(at) & Node.DOCUMENT_POSITION_FOLLOWING));
  const over = pinned?.getBoundingClientRect();
  const top = (over && over.bottom > 0 ? over.height : 0) + CLEAR, bottom = side.getBoundingClientRect().top - CLEAR;
  if (box.bottom > bottom) scrollBy(0, Math.min(box.bottom - bottom, box.top - top));
  else if (box.top < top) scrollBy(0, box.top - top);
}
