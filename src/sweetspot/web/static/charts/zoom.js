// Which stretch of an axis is shown, shared by pictures one above the other: by wheel, by two fingers, by buttons.
//
//   const zoom = new Zoom({ onChange() {} });
//   zoom.set([0, 0.84], [0.38, 0.84]);    // all there is, and what is shown until somebody zooms
//   zoom.listen(surface, (x) => value);   // wheel (with Ctrl, or once the picture was pressed) and pinch on a Surface
//   zoom.range                            // what is shown now
//   zoom.buttons()                        // an element with +, − and All

import { button } from "../controls/controls.js";
/** @import { Surface } from "./surface.js" */

const PER_NOTCH = 1.0015;

/** @typedef {[number, number]} Span */

export class Zoom {
  // closest: the smallest part of everything that can be shown; shared: what all there is somebody else says than a chart.
  /** @param {{ onChange: () => void, closest?: number, shared?: boolean }} options */
  constructor({ onChange, closest = 0.02, shared = false }) {
    this.shared = shared;
    this.onChange = onChange;
    this.closest = closest;
    /** @type {Span} */
    this.full = [0, 1];
    /** @type {Span | null} */
    this.usual = null;
    /** @type {Span | null} */
    this.own = null;
  }

  get range() { return this.own ?? this.usual ?? this.full; }

  /** @param {Span} full @param {Span | null} usual */
  set(full, usual = null) {
    const other = full[0] !== this.full[0] || full[1] !== this.full[1];
    Object.assign(this, { full, usual });
    if (other && this.own) this.own = this.inside(this.own);
  }

  /** @param {Span} range @returns {Span} */
  inside([low, high]) {
    const [least, most] = this.full;
    const span = Math.min(most - least, Math.max(this.closest * (most - least), high - low));
    const start = Math.min(most - span, Math.max(least, low));
    return [start, start + span];
  }

  /** @param {Span} range */
  show(range) {
    this.own = this.inside(range);
    this.onChange();
  }

  // Nearer (a factor below 1) or farther about a place, which stays where it is.
  /** @param {number} place @param {number} factor */
  about(place, factor) {
    const [low, high] = this.range;
    this.show([place - (place - low) * factor, place + (high - place) * factor]);
  }

  all() { this.show(this.full); }
  back() {
    this.own = null;
    this.onChange();
  }

  /** @param {Surface} surface @param {(pixel: number) => number} placeAt */
  listen(surface, placeAt) {
    const { element } = surface;
    element.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey && surface.pressed !== true) return; // the page scrolls
      event.preventDefault();
      if (event.shiftKey) {
        const [low, high] = this.range;
        const way = ((event.deltaX || event.deltaY) / 800) * (high - low);
        this.show([low + way, high + way]);
      } else this.about(placeAt(event.offsetX), PER_NOTCH ** event.deltaY);
    }, { passive: false });
    surface.pinches(({ x, factor }) => this.about(placeAt(x), 1 / factor));
  }

  /** @param {string} whole  what the button says that shows all */
  buttons(whole = "All") {
    const middle = () => (this.range[0] + this.range[1]) / 2;
    /** @type {[string, string, () => void][]} */
    const acts = [
      ["+", "Nearer", () => this.about(middle(), 0.7)], ["−", "Farther", () => this.about(middle(), 1 / 0.7)],
      [whole, "Show all of it", () => this.all()],
    ];
    const made = acts.map(([words, title, act]) => {
      const one = button(words, act, { title });
      if (words !== whole) one.setAttribute("aria-label", title); // a sign is no name
      return one;
    });
    const box = Object.assign(document.createElement("div"), { className: "zoom" });
    box.append(...made);
    return box;
  }
}
