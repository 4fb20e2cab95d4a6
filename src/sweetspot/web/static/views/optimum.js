// The best way to hit: the launch angle of an exit speed, the swing at a pitch, and every park's slowest home run.

import { ballGroup, swingGroup, usualChoice } from "../bat/swing.js";
import { group, slider } from "../controls/controls.js";
import { DocumentPlace } from "../controls/document.js";
import { HeatMap } from "../charts/heatmap.js";
import { make, section, tell } from "../controls/parts.js";
import { MPH } from "../controls/units.js";
/** @import { LaunchAnswer } from "../answers.js" */
/** @import { AppOf, Guide } from "../shell/main.js" */

const LEAST = 0.005; // a chance below which nothing is shown

// The part of a map where there is any chance, and the cross: from and to across and upwards; all of it where there is none.
/** @param {number[]} x @param {number[]} y @param {(number | null)[][]} z @param {number[]} cross */
function around(x, y, z, cross) {
  const rows = y.filter((_, j) => z[j].some((value) => (value ?? 0) >= LEAST)), columns = x.filter((_, i) => z.some((row) => (row[i] ?? 0) >= LEAST));
  if (rows.length < 2 || columns.length < 2) return {};
  /** @type {(all: number[], some: number[], also: number) => [number, number]} */
  const span = (all, some, also) => [Math.max(all[0], Math.min(some[0], also) - (all[1] - all[0])), Math.min(all[all.length - 1], Math.max(some[some.length - 1], also) + (all[1] - all[0]))];
  return { range: span(x, columns, cross[0]), heights: span(y, rows, cross[1]) };
}

export default class OptimumView {
  /** @type {Guide} */
  static guide = [
    ["The best swing", "For a pitch and a bat speed: how far below the ball, how steeply upwards and with which part of the barrel a hit carries farthest."],
    ["The best launch", "The map shows how far a ball carries by its exit speed and launch angle; the cross is the best angle for yours. Drag it."],
    ["The easiest fence", "The last table has the slowest ball that leaves each park. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"optimum">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {LaunchAnswer | null} */
    this.answer = null;
    const pitches = app.lists("pitches").then(({ pitches: all }) => all.map(({ key, name }) => [key, name]));
    const parks = app.lists("parks").then((lists) => lists.parks.map(({ key, name }) => [key, name]));
    const side = make("div", { className: "side" },
      group("The pitch and the swing", [
        usualChoice(app, "pitch", { label: "Pitch", options: pitches }),
        slider(app, "tilt_deg", { label: "Tilt of the swing's plane", step: 0.5 }),
      ]),
      group("A ball as it leaves", [
        slider(app, "exit_speed_mph", { label: "Exit speed", step: 0.5 }),
        slider(app, "backspin_rpm", { label: "Backspin", step: 50 }),
        usualChoice(app, "park", { label: "Park", options: parks }),
      ]), swingGroup(app, { title: "Swing", pitched: false }), ballGroup(app));
    this.words = make("p", { className: "verdict", id: "verdict" });
    const onPick = (/** @type {number} */ speed, /** @type {number} */ _, /** @type {{ last: boolean }} */ { last }) => (
      app.setState({ exit_speed_mph: Math.round(2 * Math.min(120, Math.max(50, speed / MPH))) / 2 }, { commit: last }));
    this.map = new HeatMap(app, { label: "", title: "How far it carries", height: 260, x: { kind: "exit_speed_m_s", label: "exit speed" },
      y: { kind: "launch_angle_rad", label: "launch angle" }, z: { kind: "distance" }, onPick });
    this.map.element.classList.add("pinned");
    this.chances = new HeatMap(app, { label: "", title: "Chance that it leaves the park, hit to centre field", height: 200, x: { kind: "exit_speed_m_s", label: "exit speed" },
      y: { kind: "launch_angle_rad", label: "launch angle" }, z: { kind: "share" }, onPick });
    this.park = make("p", { className: "note" });
    this.swing = new DocumentPlace(app, "Searching the best contact …");
    this.parks = new DocumentPlace(app, "Searching every park …");
    root.append(side, make("div", { className: "stack" },
      section("How high to send it", this.words, this.map.element, this.map.numbers.element, this.park, this.chances.element, this.chances.numbers.element),
      section("How to swing", this.swing.element),
      section("The slowest home run of every park", this.parks.element)));
  }

  /** @param {LaunchAnswer} answer */
  update(answer) {
    this.answer = answer;
    const { launch, map } = answer;
    const words = answer.words[this.app.units].join(" ");
    tell(this.words, words);
    this.app.announce(words);
    const [x, y, cross] = [map.exit_speed_m_s, map.launch_angle_rad, [launch.exit_speed_m_s, launch.launch_angle_rad]];
    this.map.draw({ x, y, z: map.carry_m, cross });
    this.chances.draw({ x, y, z: map.chance, cross, ...around(x, y, map.chance, cross) });
    const chance = answer.chances[this.app.units].join(" ");
    this.park.textContent = chance;
    this.chances.label(`${chance} The table below has its numbers.`);
    this.map.label(`How far balls carry, by exit speed and launch angle. ${words}`);
    this.swing.redraw();
    this.parks.redraw();
    this.app.aside("swing", ["park"], 500, (found) => this.swing.show(found));
    const others = Object.keys(this.app.state).filter((field) => !["ball", "ball_toml", "bat", "bat_toml", "backspin_rpm"].includes(field)); // another bat may be of another sport, with another ball
    this.app.aside("parks", others, 900, (found) => this.parks.show(found));
  }

  figures() { return [this.map.figure("carry"), this.chances.figure("chance")]; }
  table() {
    if (!this.answer) return {};
    const { exit_speed_m_s: speeds, launch_angle_rad: angles, carry_m, chance } = this.answer.map;
    return { exit_speed_m_s: angles.flatMap(() => speeds), launch_angle_rad: angles.flatMap((angle) => speeds.map(() => angle)), carry_m: carry_m.flat(), chance: chance.flat() };
  }
}
