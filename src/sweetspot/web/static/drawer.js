// On a phone the controls are a drawer at the foot of the screen; a fault in it opens it.

const LOW = 480; // px of a window, which the controls would fill: a telephone on its side, or a page at 400 %

/** @param {HTMLElement | null} side */
export function drawerOf(side) {
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
  toggle.addEventListener("click", () => turn(!side.classList.contains("shut")));
  side.addEventListener("reveal", () => turn(false));
  side.prepend(toggle);
  turn(globalThis.innerHeight < LOW && getComputedStyle(toggle).display !== "none");
}
