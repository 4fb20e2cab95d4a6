// What can be made on the picture of a bat with the hand: each grip says where it is and what dragging it changes.
//
//   gripsOf(answer, app)   [{ at, aside, take(along, aside) -> part of the state }], m from the knob end and from the axis

import { INCH } from "../controls/units.js";
/** @import { BatPicture } from "../answers.js" */
/** @import { App, State } from "../shell/main.js" */

/** @typedef {{ at: number, aside: number, take: (along: number, aside: number) => Partial<State> }} Grip */
/** @param {{ bat: BatPicture, hands_m?: number[] }} answer @param {App} app */
export function gripsOf({ bat, hands_m: hands }, app) {
  const { state } = app;
  const inches = (/** @type {number} */ metres) => Math.round((20 * metres) / INCH) / 20;
  const within = (/** @type {string} */ field, /** @type {number} */ value) => {
    const { minimum = 0, maximum = 60 } = app.schema[field];
    const [least, most] = app.bounds(field) ?? [minimum, maximum];
    return Math.min(Math.min(most, maximum), Math.max(Math.max(least, minimum), value));
  };
  /** @type {Grip[]} */
  const grips = [];
  const bore = bat.bores.at(-1);
  if (state.bore_diameter_in && bore) {
    grips.push({ at: bore.start_m, aside: bore.diameter_m / 2, take: (along, aside) => ({
      bore_depth_in: within("bore_depth_in", inches(bat.length_m - along)), bore_diameter_in: Math.max(0.1, within("bore_diameter_in", inches(2 * aside))) }) });
  }
  const { cup } = bat;
  if (state.cup_diameter_in && cup) {
    grips.push({ at: bat.length_m - 0.6 * cup.depth_m, aside: cup.diameter_m / 2, take: (along, aside) => ({
      cup_depth_in: within("cup_depth_in", inches((bat.length_m - along) / 0.6)), cup_diameter_in: Math.max(0.1, within("cup_diameter_in", inches(2 * aside))) }) });
  }
  if (state.weight_oz) {
    grips.push({ at: bat.length_m - state.weight_from_tip_in * INCH, aside: 0, take: (along) => ({
      weight_from_tip_in: within("weight_from_tip_in", inches(bat.length_m - along)) }) });
  }
  if (hands) {
    grips.push({ at: hands[0], aside: 0, take: (along) => ({ hands_in: within("hands_in", inches(along) - (state.choke_up_in ?? 0)) }) });
  }
  return grips;
}
