// Explorer: the bat to scale with its sweet spots; below it, on the same axis, what a hit at each place gives.

import { BatView } from "../batview.js";
import { Chart } from "../chart.js";
import { button, choice, group, slider } from "../controls.js";
import { Bench } from "./explorer_bench.js";

const INCH = 0.0254;
const PANELS = [
  { title: "Exit speed", kind: "exit_speed_m_s", height: 120, lines: [
    { key: "exit_speed_m_s", label: "real bat", color: "red", width: 2.4 },
    { key: "rigid_exit_speed_m_s", label: "rigid bat", color: "muted", dash: [5, 4], width: 1.6, silent: true }] },
  { title: "Collision efficiency q", kind: "ratio", height: 80, lines: [{ key: "collision_efficiency", color: "orange" }] },
  { title: "BBCOR", kind: "ratio", height: 80, lines: [{ key: "bbcor", color: "blue" }] },
  { title: "Jolt at the top hand", kind: "hand_impulse_n_s", height: 80, zero: true, lines: [{ key: "hand_impulse_n_s", color: "green" }] },
  { title: "Sting, vibration at the hands", kind: "sting", height: 80, zero: true, lines: [{ key: "sting", color: "purple" }] },
];
const FACTS = [
  ["Exit speed", (a) => ["exit_speed_m_s", a.hit.exit_speed_m_s]],
  ["Efficiency q", (a) => ["ratio", a.hit.collision_efficiency]],
  ["BBCOR", (a) => ["ratio", a.hit.bbcor]],
  ["Peak force", (a) => ["peak_force_n", a.hit.peak_force_n]],
  ["Contact time", (a) => ["contact_time_s", a.hit.contact_time_s]],
  ["Lost against the best", (a) => ["exit_speed_m_s", a.lost_m_s]],
  ["Launch angle", (a) => ["launch_angle_rad", a.hit.launch_angle_rad]],
  ["Backspin", (a) => ["backspin_rad_s", a.hit.backspin_rad_s]],
  ["Weight", (a) => ["mass_kg", a.bat.mass_kg]],
  ["Swing weight, 6 in axis", (a) => ["moi_6in_kg_m2", a.bat.moi_6in_kg_m2]],
];

export const view = {
  name: "explorer",

  mount(root, app) {
    Object.assign(this, { app, root });
    this.picture = new BatView(app, {
      onBall: (position, { last }) => this.moveBall(position, last),
      onStations: (stations, { last }) => this.bench.reshape(stations, last),
    });
    this.chart = new Chart(app, {
      label: "Curves along the bat", panels: PANELS,
      axis: { kind: "position_m", from: () => app.answer?.bat.length_m ?? 0.84, label: "from the tip" },
      onPick: (position, { last }) => this.moveBall(position, last),
    });
    this.bench = new Bench(app, this.picture, root);
    const side = Object.assign(document.createElement("div"), { className: "side" });
    side.append(this.bench.element, ...controls(app));
    this.words = Object.assign(document.createElement("p"), { className: "verdict wide", id: "verdict" });
    this.facts = Object.assign(document.createElement("dl"), { className: "facts" });
    this.values = FACTS.map(([name]) => this.fact(name));
    const picture = Object.assign(document.createElement("section"), { className: "picture" });
    picture.setAttribute("aria-label", "Bat and curves");
    picture.append(this.picture.element, this.chart.element, this.facts);
    root.append(this.words, side, picture);
    this.handle();
  },

  fact(name) {
    const [box, term, value] = ["div", "dt", "dd"].map((tag) => document.createElement(tag));
    term.textContent = name;
    box.append(term, value);
    this.facts.append(box);
    return value;
  },

  // The picture is also a slider for those who use the keyboard.
  handle() {
    const canvas = this.picture.element;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "slider");
    canvas.setAttribute("aria-valuemin", "0");
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: 0.1, ArrowRight: -0.1, PageUp: -1, PageDown: 1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      this.app.setState({ impact_from_tip_in: this.within(this.app.state.impact_from_tip_in + step) });
    });
  },

  within(inches) {
    const most = (this.app.answer.bat.length_m - this.app.answer.hands_m[0]) / INCH;
    return Math.round(100 * Math.min(most, Math.max(0, inches))) / 100;
  },

  moveBall(position, last) {
    if (!this.app.answer) return;
    const inches = (this.app.answer.bat.length_m - position) / INCH;
    this.app.setState({ impact_from_tip_in: this.within(inches) }, { commit: last });
  },

  update(answer, state) {
    const { bat, sweet_spots: spots, scan, hit } = answer;
    this.picture.draw({ bat, sweet_spots: spots, hands_m: answer.hands_m, ball: {
      position_m: hit.position_m, radius_m: answer.ball.radius_m, offset_m: state.offset_in * INCH,
      launch_angle_rad: hit.launch_angle_rad } });
    const zone = spots.zone_m;
    this.chart.draw({
      x: scan.position_m, lines: scan, range: [0, bat.length_m], cursor: hit.position_m,
      bands: zone ? [{ from: zone[0], to: zone[1] }] : [],
      marks: [{ at: spots.max_exit_speed_m, color: "red" }],
    });
    FACTS.forEach(([, value], i) => {
      const [name, number] = value(answer);
      this.values[i].textContent = this.app.text(name, number);
    });
    this.say(answer);
    this.bench.update(answer, state);
  },

  say({ bat, sweet_spots: spots, hit, best_exit_speed_m_s: best }) {
    const show = (name, value, digits) => this.app.text(name, value, digits);
    const here = hit.exit_speed_m_s === null ? hit.outcome_text : show("exit_speed_m_s", hit.exit_speed_m_s);
    const words = `${bat.name} hits fastest ${show("from_m", bat.length_m - spots.max_exit_speed_m, 1)} from the tip: ` +
      `${show("exit_speed_m_s", best)}. Here, ${show("from_m", bat.length_m - hit.position_m, 1)} from the tip: ${here}.`;
    this.words.textContent = words;
    this.app.announce(words);
    this.picture.label(`Ball along the bat. ${words}`);
    const canvas = this.picture.element;
    canvas.setAttribute("aria-valuemax", String(this.within(99)));
    canvas.setAttribute("aria-valuenow", String(this.app.state.impact_from_tip_in));
    canvas.setAttribute("aria-valuetext", `${show("from_m", bat.length_m - hit.position_m, 1)} from the tip`);
  },

  unmount() {
    this.root.classList.remove("drop");
  },

  figures() {
    return [this.picture.figure("bat"), this.chart.figure("curves")];
  },

  charts() {
    return [this.chart];
  },

  table() {
    return this.app.answer.scan;
  },
};

function controls(app) {
  return [
    group("Swing and pitch", [
      slider(app, "pitch_speed_mph", { label: "Pitch speed", step: 0.5 }),
      slider(app, "bat_speed_mph", { label: "Bat speed, 6 in from the tip", step: 0.5 }),
      slider(app, "choke_up_in", { label: "Choke up", step: 0.1 }),
      slider(app, "hands_in", { label: "Top hand above the grip's end", step: 0.1 }),
    ]),
    group("Impact", [
      slider(app, "impact_from_tip_in", { label: "From the tip", step: 0.1 }),
      slider(app, "offset_in", { label: "Ball above the bat's axis", step: 0.05 }),
    ]),
    group("Ball", [
      choice(app, "ball", { label: "Ball", options: app.lists().then(({ balls }) => balls.map((name) => [name, name])) }),
      slider(app, "ball_cor", { label: "Restitution (COR) as bought", step: 0.005, empty: () => app.answer?.ball.cor ?? 0.55 }),
      slider(app, "ball_humidity", { label: "Stored at humidity", step: 0.01, empty: () => app.answer?.ball.humidity ?? 0.5 }),
      slider(app, "ball_temperature_degf", { label: "Temperature", step: 1, empty: () => app.answer?.ball.temperature_degf ?? 70 }),
      button("As it came", () => app.setState({ ball_cor: null, ball_humidity: null, ball_temperature_degf: null })),
    ], { open: false }),
  ];
}
