// Flight: the path from the side and from above over a park, in its air and wind; over which fences the ball goes.

import { ballGroup, swingGroup } from "../bat/swing.js";
import { button, choice, group, slider, toggle } from "../controls/controls.js";
import { HeatMap } from "../charts/heatmap.js";
import { HowSure } from "../controls/howsure.js";
import { factList, make, section, tableOf, tell } from "../controls/parts.js";
import { MPH, toShown } from "../controls/units.js";
import { FieldPicture, SidePicture } from "./flight_pictures.js";
import { SpaceFold } from "./flight_space.js";
/** @import { Answers, CarryMap, FlownBall, States } from "../answers.js" */
/** @import { Fact } from "../controls/parts.js" */
/** @import { AppOf, Field, Guide } from "../shell/main.js" */

/** @type {Record<string, string>} */
const CLASSES = { "home run": "good", foul: "muted" };
const MAPPED = ["exit_speed_mph", "launch_angle_deg", "own_elevation"]; // what the map does not depend on, for a ball with its own numbers
/** @type {Fact<FlownBall>[]} */
const FACTS = [
  ["Chance of a home run", (a, app) => app.text("share", a.chance, 0)],
  ["Parks it leaves on average", (a) => `${a.expected_out_in.toFixed(1)} of ${a.of}`],
  ["Carry", (a, app) => app.text("distance", a.flight.carry_m)],
  ["Hang time", (a, app) => app.text("seconds", a.flight.hang_time_s)],
  ["Apex", (a, app) => app.text("distance", a.flight.apex_m)],
  ["Lands at", (a, app) => `${app.text("landing_speed_m_s", a.flight.landing_speed_m_s)}, ${app.text("angle_rad", a.flight.landing_angle_rad, 0)} down`],
  ["Without air", (a, app) => app.text("distance", a.without_air.carry_m)],
  ["Air", (a, app) => app.text("air_density_kg_m3", a.air_density_kg_m3)],
];

export default class FlightView {
  /** @type {Guide} */
  static guide = [
    ["Where the ball goes", "The ball's path from the side and from above, through the air of a park, and over which fences it goes. " +
      "The dashed line is the path that it would take without air."],
    ["Launch it", "Move the sliders for speed, angle and spin, drag the place where the ball comes down, or press the map. Or let it start " +
      "from a pitch and a swing."],
    ["Change the weather", "Choose the park, turn the wind, heat the air. The table says what this ball does in every park. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"flight">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {FlownBall | null} */
    this.answer = null; // the last that was met
    /** @type {CarryMap | null} */
    this.carries = null;
    /** @type {(() => void) | null} */
    this.stop = null; // of a ball on its way
    this.otherFences = false; // whether they are drawn
    const own = ballControls(app), hint = make("p", { className: "note", textContent: "Drag the place where the ball comes down; press the map to launch it so; drag the wind's arrow." });
    const swung = make("div", { className: "side" }, ...swingControls(app), ballGroup(app));
    app.control({ field: "parts of start", sync: ({ start }) => {
      own.hidden = start !== "ball";
      swung.hidden = start === "ball";
      hint.hidden = start !== "ball";
    } });
    this.elevation = slider(app, "elevation_ft", { label: "Elevation", step: 50, empty: 0, note: "The park's, until moved." });
    const side = make("div", { className: "side" },
      group("Start", [choice(app, "start", { label: "The ball starts", options: [["ball", "with these numbers"], ["swing", "from pitch and swing"]] })]),
      own, swung, this.parkControls(app, this.elevation));
    this.words = make("p", { className: "headline", id: "verdict" });
    this.launch = make("p", { className: "note" });
    this.sure = new HowSure(app, { but: ["own_elevation"] });
    this.space = new SpaceFold(app);
    this.facts = factList(FACTS, app);
    this.side = new SidePicture(app);
    this.field = new FieldPicture(app, { onLand: (place, { last }) => this.land(place, last), onWind: (wind, { last }) => app.setState(wind, { commit: last }) });
    this.field.element.classList.add("pinned");
    this.map = new HeatMap(app, { label: "", title: "Carry", height: 170, x: { kind: "exit_speed_m_s", label: "exit speed" },
      y: { kind: "launch_angle_rad", label: "launch angle" }, z: { kind: "distance" }, onPick: (speed, angle, { last }) => this.launchAs(speed, angle, last) });
    this.parks = make("div");
    this.play = button("Let it fly", () => this.fly(), { primary: true });
    this.outlines = button("All parks' fences", () => this.showFences());
    this.pictures = make("div", { className: "pair" },
      make("div", {}, make("h2", { textContent: "From the side" }), this.side.element, make("div", { className: "row tight" }, this.play), this.side.numbers.element, this.facts.element, this.map.element, this.map.numbers.element),
      make("div", {}, make("h2", { textContent: "From above" }), this.field.element, make("div", { className: "row tight" }, this.outlines), hint));
    this.list = section("In every park",
      toggle(app, "own_elevation", { label: "Each park with the air of its own elevation" }), this.parks);
    root.append(side, make("div", { className: "stack" },
      make("section", { className: "picture" }, this.words, this.launch, this.space.element, this.pictures, this.sure.element), this.list));
  }

  /** @param {AppOf<"flight">} app @param {HTMLElement} elevation */
  parkControls(app, elevation) {
    const parks = app.lists("parks").then((lists) => lists.parks.map(({ key, name }) => [key, name]));
    return group("Park and weather", [
      choice(app, "park", { label: "Park", options: parks, follows: true, shown: (state) => state.park ?? app.answer?.usual_park, take: (park) => app.setState({ park, elevation_ft: null }) }),
      slider(app, "wind_speed_mph", { label: "Wind", step: 0.5 }),
      slider(app, "wind_direction_deg", { label: "Wind blows to: 0 out, ±180 home", step: 5 }),
      slider(app, "temperature_degf", { label: "Temperature", step: 1 }),
      slider(app, "relative_humidity", { label: "Humidity of the air", step: 0.01 }),
      slider(app, "pressure_inhg", { label: "Pressure at sea level", step: 0.02 }),
      elevation,
      slider(app, "height_ft", { label: "Height at contact", step: 0.1 }),
    ]);
  }

  // The ball that starts with its own numbers is sent to a place: turned, and hit harder or softer at the same angle.
  /** @param {{ distance: number, direction: number }} given @param {boolean} last */
  land({ distance, direction }, last) {
    const { state, answer, schema } = this.app;
    if (state.start !== "ball" || !answer || answer.missed) return false;
    const within = (/** @type {Field} */ field, /** @type {number} */ value) => Math.min(schema[field].maximum ?? value, Math.max(schema[field].minimum ?? value, Math.round(2 * value) / 2));
    const turned = state.direction === "landing" ? direction : direction - (answer.flight.landing_direction_rad - answer.launch.spray_rad);
    const harder = (answer.launch.exit_speed_m_s / MPH) * (Math.max(20, distance) / Math.max(20, answer.flight.carry_m)) ** 0.6;
    this.app.setState({ spray_deg: within("spray_deg", (turned * 180) / Math.PI), exit_speed_mph: within("exit_speed_mph", harder) }, { commit: last });
    return true;
  }

  /** @param {number} speed @param {number} angle @param {boolean} last */
  launchAs(speed, angle, last) {
    if (this.app.state.start !== "ball") return;
    this.app.setState({ exit_speed_mph: Math.round(2 * speed / MPH) / 2, launch_angle_deg: Math.round((2 * angle * 180) / Math.PI) / 2 }, { commit: last });
  }

  // The ball on its way, in its own time.
  fly() {
    if (this.stop) {
      this.rest();
      return;
    }
    if (!this.answer) return;
    const { hang_time_s: hang } = this.answer.flight;
    let begin = NaN;
    this.play.textContent = "Stop";
    this.stop = this.app.onFrame((now) => {
      if (Number.isNaN(begin)) begin = now;
      const moment = (now - begin) / 1000;
      this.side.at(moment);
      this.field.at(moment);
      if (moment >= hang) this.rest();
    });
  }

  rest() {
    this.stop?.();
    this.stop = null;
    this.play.textContent = "Let it fly";
    this.side.at(null);
    this.field.at(null);
  }

  async showFences() {
    this.otherFences = !this.otherFences;
    this.field.others(this.otherFences ? (await this.app.ask("flight/fences", this.app.state)).parks : null);
    this.outlines.textContent = this.otherFences ? "This park's fence alone" : "All parks' fences";
  }

  // Until it is moved the elevation's control shows the park's.
  /** @param {Answers["flight"]} given @param {States["flight"]} state */
  showElevation({ park }, state) {
    if (state.elevation_ft !== null) return;
    const elevation = Math.round(toShown("distance", park.elevation_m, this.app.units));
    for (const input of this.elevation.querySelectorAll("input")) if (document.activeElement !== input) input.value = String(elevation);
  }

  /** @param {Answers["flight"]} answer @param {States["flight"]} state */
  update(answer, state) {
    this.showElevation(answer, state);
    const { units } = this.app;
    const words = answer.headline[units].join(" ");
    tell(this.words, words);
    this.app.announce(words);
    this.pictures.hidden = this.list.hidden = answer.missed;
    this.space.update(answer.missed ? null : answer);
    if (answer.missed) {
      this.launch.textContent = "";
      return;
    }
    this.answer = answer;
    this.launch.textContent = answer.leaves[units].join(" ");
    this.facts.fill(answer);
    this.sure.update();
    this.drawMap(answer);
    this.app.aside("map", state.start === "ball" ? MAPPED : [], 120, (carries) => {
      this.carries = carries;
      if (this.answer) this.drawMap(this.answer);
    });
    this.side.draw(answer);
    this.field.draw(answer, state);
    this.app.afterwards(this.parks, () => this.parks.replaceChildren(this.listOfParks(answer)));
  }

  /** @param {FlownBall} given */
  drawMap({ launch }) {
    if (!this.carries) return;
    const { exit_speed_m_s: x, launch_angle_rad: y, carry_m: z } = this.carries;
    this.map.draw({ x, y, z, cross: [launch.exit_speed_m_s, launch.launch_angle_rad] });
    this.map.label("How far the ball carries, by exit speed and launch angle, with this spin, direction and weather.");
  }

  /** @param {FlownBall} given */
  listOfParks({ parks }) {
    const sorted = [...parks].sort((a, b) => b.chance - a.chance || (b.clearance_m ?? -1e3) - (a.clearance_m ?? -1e3));
    const far = (/** @type {number | null} */ value) => (value === null ? "–" : this.app.text("distance", value));
    return tableOf("Outcome in every park, the likeliest home run first; chance: with what balls, spin and weather scatter by; carry: to the ground, as if there were no fence", ["Park", "Outcome", "Chance", "Carry", "Fence there", "Above its top"], sorted.map((row) => [
      { text: row.park, note: row.team }, { text: row.outcome, className: CLASSES[row.outcome] ?? "" }, this.app.text("share", row.chance, 0),
      far(row.carry_m), far(row.fence_m), far(row.clearance_m)]));
  }

  unmount() { this.stop?.(); }
  figures() { return [this.side.surface.figure("side"), this.field.surface.figure("field")]; }
  table() { return { ...this.answer?.path }; }
}

/** @param {AppOf<"flight">} app */
function ballControls(app) {
  return group("The ball as it leaves", [
    slider(app, "exit_speed_mph", { label: "Exit speed", step: 0.5 }),
    slider(app, "launch_angle_deg", { label: "Launch angle", step: 0.5 }),
    slider(app, "spray_deg", { label: "Direction, − left, + right field", step: 0.5 }),
    choice(app, "direction", { label: "That is the direction", options: [["launch", "off the bat"], ["landing", "in which it comes down"]] }),
    slider(app, "backspin_rpm", { label: "Backspin", step: 50 }),
    slider(app, "sidespin_rpm", { label: "Sidespin, + bends to the left", step: 50 }),
  ]);
}

/** @param {AppOf<"flight">} app */
function swingControls(app) {
  return [
    group("Swing", [
      slider(app, "impact_from_tip_in", { label: "Met from the tip", step: 0.1 }),
      slider(app, "offset_in", { label: "Ball above the bat's axis", step: 0.05 }),
      slider(app, "attack_angle_deg", { label: "Attack angle, up", step: 0.5 }),
      slider(app, "attack_direction_deg", { label: "Attack direction, − pulled", step: 0.5 }),
      slider(app, "tilt_deg", { label: "Tilt of the swing's plane", step: 0.5, note: "No path in a plane is steeper than the plane." }),
      choice(app, "batter", { label: "Batter", options: [["right", "right-handed"], ["left", "left-handed"]] }),
    ]),
    swingGroup(app),
    group("Pitch at the plate", [
      slider(app, "pitch_angle_deg", { label: "Angle, − falls", step: 0.5 }),
      slider(app, "pitch_backspin_rpm", { label: "Backspin", step: 50 }),
    ]),
  ];
}
