// Explorer: the bat to scale with its sweet spots; below it, on the same axis, what a hit at each place gives.

import { BatView } from "../batview.js";
import { Chart } from "../chart.js";
import { Bench, ballGroup, swingGroup } from "../bench.js";
import { group, slider } from "../controls.js";

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
  guide: [
    ["A bat, and where it hits best", "The bat is drawn to scale. Coloured marks are its sweet spots: there are several, " +
      "for each answers another question. The green zone is where a hit costs little speed and stings little."],
    ["Drag the ball", "Drag the ball along the bat, or anywhere on the curves. The curves say what a hit at each place " +
      "gives; the numbers below are those of the ball's place. With the keyboard: arrow keys on the picture."],
    ["Change everything", "Move a slider and all follows at once: pitch, swing, hands, ball. Choose another bat, drop a bat " +
      "file on the page, or drill, cork and cup this one. "],
  ],

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
    this.bench = new Bench(app, { picture: this.picture });
    const side = Object.assign(document.createElement("div"), { className: "side" });
    side.append(this.bench.element, swingGroup(app), impact(app), ballGroup(app));
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
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: 0.1, ArrowDown: 0.1, ArrowRight: -0.1, ArrowUp: -0.1, PageUp: -1, PageDown: 1, Home: 99, End: -99 }[event.key];
      if (step === undefined || !this.app.answer) return;
      event.preventDefault();
      this.app.setState({ impact_from_tip_in: this.within(this.app.state.impact_from_tip_in + step) }, { merge: "keys on the picture" });
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
    this.bench.update(answer);
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
    const inches = (place) => (place / INCH).toFixed(2);
    canvas.setAttribute("aria-valuemin", inches(this.app.answer.hands_m[0]));
    canvas.setAttribute("aria-valuemax", inches(bat.length_m));
    canvas.setAttribute("aria-valuenow", inches(hit.position_m)); // from the knob, so that right is more
    canvas.setAttribute("aria-valuetext", `${show("from_m", bat.length_m - hit.position_m, 1)} from the tip`);
  },

  unmount() {},

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

function impact(app) {
  return group("Impact", [
    slider(app, "impact_from_tip_in", { label: "From the tip", step: 0.1 }),
    slider(app, "offset_in", { label: "Ball above the bat's axis", step: 0.05 }),
  ]);
}
