// What is done to a bat on the bench, and the bat as it was before anything was.

/** @import { App, State } from "../shell/main.js" */

export const UNCHANGED = ["bat_toml", "profile_in", "mass_oz", "wall_factor", "bore_diameter_in", "cup_diameter_in", "weight_oz", "choke_up_in"];

// The fields of a bat as it was before anything was done to it; another bat starts with them.
/** @param {Pick<App, "schema">} app */
export function unchanged(app) {
  return /** @type {Partial<State>} */ (Object.fromEntries(UNCHANGED.map((field) => [field, app.schema[field].default ?? null])));
}
