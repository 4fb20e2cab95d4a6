// The ball on the picture of a bat, moved by hand and, as a slider, by key: from the knob, so that right is more.

import { INCH } from "../controls/units.js";
/** @import { App } from "../shell/main.js" */
/** @import { BatView } from "./batview.js" */

/** @type {Record<string, number>} inches further from the tip */
const STEPS = { ArrowLeft: 0.1, ArrowDown: 0.1, ArrowRight: -0.1, ArrowUp: -0.1, PageUp: -1, PageDown: 1, Home: 99, End: -99 };

/** @typedef {{ bat: { length_m: number }, hands_m: number[] }} Held */

// Where the ball may be, inches from the tip: not on the hands.
/** @param {Held | null} held @param {number} inches */
export function within(held, inches) {
  const { bat, hands_m: hands } = held ?? { bat: { length_m: 1 }, hands_m: [0] };
  return Math.round(100 * Math.min((bat.length_m - hands[0]) / INCH, Math.max(0, inches))) / 100;
}

/** @param {App} app @param {BatView} picture @param {() => Held | null} held */
export function slideByKeys(app, picture, held) {
  const canvas = picture.element;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "slider");
  canvas.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    const step = STEPS[event.key];
    if (step === undefined || !app.answer) return;
    event.preventDefault();
    app.setState({ impact_from_tip_in: within(held(), app.state.impact_from_tip_in + step) }, { merge: "keys on the picture" });
  });
}

/** @param {BatView} picture @param {Held} held @param {number} position @param {string} words */
export function tellPlace(picture, { bat, hands_m: hands }, position, words) {
  const inches = (/** @type {number} */ metres) => (metres / INCH).toFixed(2);
  const told = { min: inches(hands[0]), max: inches(bat.length_m), now: inches(position), text: words };
  for (const [name, value] of Object.entries(told)) picture.element.setAttribute(`aria-value${name}`, value);
}
