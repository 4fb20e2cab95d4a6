// What a workshop does to a bat, and the list of the catalogue's bats beside another one.

import { unchanged } from "./unchanged.js";
import { choice, slider } from "../controls/controls.js";
import { OUNCE } from "../controls/units.js";
/** @import { App } from "../shell/main.js" */
/** @import { Desk } from "../controls/controls.js" */
/** @import { System } from "../controls/units.js" */

const OWN = "own file";
export const FILLS = [["nothing", "nothing"], ["cork", "cork"], ["rubber", "rubber"], ["polyurethane-foam", "polyurethane foam"]];

// The list of the catalogue's bats; a bat of one's own stands in it too, so that it never names another bat.
/** @param {Desk & Pick<App, "lists">} app */
export function batChoice(app, label = "Bat") {
  return choice(app, "bat", {
    label,
    options: app.lists("bats").then(({ bats }) => bats.map(({ key, name, use }) => [key, name, use])),
    shown: (state) => (state.bat_toml === null || state.bat_toml === undefined ? state.bat : OWN),
    take: (bat) => bat !== OWN && app.setState({ ...unchanged(app), bat }),
  });
}

// What a workshop does to a bat; parts that a bat cannot have are hidden by what `show` is told.
/** @param {Desk} app */
export function workshop(app, /** @type {() => number | null | undefined} */ mass) {
  const wall = slider(app, "wall_factor", { label: "Wall thickness, times", step: 0.01 });
  const holes = document.createElement("div");
  holes.append(
    slider(app, "bore_diameter_in", { label: "Hole in the barrel, width", step: 0.05 }),
    slider(app, "bore_depth_in", { label: "Hole, depth from the tip", step: 0.25 }),
    choice(app, "bore_fill", { label: "Hole filled with", options: FILLS }),
    slider(app, "cup_diameter_in", { label: "Cupped end, width", step: 0.05 }),
    slider(app, "cup_depth_in", { label: "Cupped end, depth", step: 0.05 }),
  );
  const remark = Object.assign(document.createElement("p"), { className: "note", hidden: true });
  const show = (/** @type {{ hollow: boolean, remark: Record<System, string> }} */ { hollow, remark: words }) => {
    wall.hidden = !hollow;
    holes.hidden = hollow;
    remark.hidden = !words[app.units];
    remark.textContent = words[app.units];
  };
  const controls = [
    slider(app, "mass_oz", { label: "Weight of the bat", step: 0.1, empty: () => (mass() ?? 0.88) / OUNCE }), remark, wall, holes,
    slider(app, "weight_oz", { label: "Added weight", step: 0.1 }),
    slider(app, "weight_from_tip_in", { label: "Added weight, from the tip", step: 0.25 }),
    slider(app, "choke_up_in", { label: "Choke up", step: 0.1 }),
  ];
  return { controls, show };
}
