// Explorer: the bat to scale with its sweet spots; below it, on the same axis, what a hit at each place gives and why.

import { slideByKeys, tellPlace, within } from "../bat/ballslider.js";
import { BatView } from "../bat/batview.js";
import { ballGroup, swingGroup } from "../bat/swing.js";
import { Chart } from "../charts/chart.js";
import { button, group, slider } from "../controls/controls.js";
import { gripsOf } from "../bat/grips.js";
import { HeatMap } from "../charts/heatmap.js";
import { HowSure } from "../controls/howsure.js";
import { partsOf } from "../charts/ledger.js";
import { factList, make, paragraphs, showWords, tell, withDoubt } from "../controls/parts.js";
import { INCH } from "../controls/units.js";
import { Zoom } from "../charts/zoom.js";
/** @import { Curve, Panel, Published } from "../charts/chart.js" */
/** @import { BatStanding, ExplorerAnswer, PowerMap, ReportWords, States } from "../answers.js" */
/** @import { Fact } from "../controls/parts.js" */
/** @import { AppOf, Guide, State } from "../shell/main.js" */

const BARREL = 18 * INCH; // shown until somebody zooms
const ROOM = 1.06; // part of the greatest offset that the map leaves free, so that a ball met there is seen whole
const ELSEWHERE = ["impact_from_tip_in", "offset_in"]; // what the map and the report do not depend on
/** @type {Curve[]} */
const SPEEDS = [
  { key: "exit_speed_m_s", label: "real bat", color: "red", width: 2.4 },
  { key: "rigid_exit_speed_m_s", label: "rigid bat", color: "muted", dash: [5, 4], width: 1.6 },
];
/** @type {Panel[]} */
const PANELS = [
  { title: "Exit speed", kind: "exit_speed_m_s", height: 130, lines: SPEEDS },
  { title: "Where the energy goes", kind: "share", height: 110, stacked: true, lines: [] },
  { title: "Collision efficiency q", kind: "ratio", height: 70, lines: [{ key: "collision_efficiency", color: "orange" }] },
  { title: "BBCOR in play", kind: "ratio", height: 70, lines: [{ key: "bbcor", color: "blue" }] },
  { title: "Jolt at the top hand", kind: "hand_impulse_n_s", height: 70, zero: true, lines: [{ key: "hand_impulse_n_s", color: "green" }] },
  { title: "Sting, vibration at the hands", kind: "sting", height: 70, zero: true, lines: [{ key: "sting_m_s", color: "purple" }] },
];
/** @type {Fact<ExplorerAnswer>[]} */
const FACTS = [
  ["Exit speed", (a) => ["exit_speed_m_s", a.hit.exit_speed_m_s]],
  ["Lost against the best", (a) => ["exit_speed_m_s", a.lost_m_s]],
  ["Efficiency q", (a) => ["ratio", a.hit.collision_efficiency]],
  ["BBCOR in play", (a) => ["ratio", a.hit.bbcor]],
  ["Launch angle", (a) => ["launch_angle_rad", a.hit.launch_angle_rad]],
  ["Backspin", (a) => ["backspin_rad_s", a.hit.backspin_rad_s]],
  ["Peak force", (a) => ["peak_force_n", a.hit.peak_force_n]],
  ["Contact time", (a) => ["contact_time_s", a.hit.contact_time_s]],
  ["Weight", (a) => ["mass_kg", a.bat.mass_kg]],
  ["Swing weight", (a, app) => withDoubt("moi_6in_kg_m2", a.bat.moi_6in_kg_m2, a.bat.moi_6in_half_kg_m2, app)],
];

export default class ExplorerView {
  /** @type {Guide} */
  static guide = [
    ["A bat, and where it hits best", "The bat is drawn to scale. Colored marks are its sweet spots: there are several, " +
      "for each answers another question. The green zone is where a hit costs little speed and stings little."],
    ["Drag the ball", "Drag the ball along the bat, or anywhere on the curves or the map. The sentence below the numbers says " +
      "why a hit there is what it is. Small squares can be dragged too: hands, holes, weights. With the keyboard: arrow keys on the picture."],
    ["Change everything", "Move a slider and all follows at once: pitch, swing, hands, ball. Choose another bat, drop a bat " +
      "file on the page, or drill, cork and cup this one. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"explorer">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {ExplorerAnswer | null} */
    this.answer = null;
    /** @type {PowerMap | null} */
    this.map = null;
    /** @type {ReportWords | null} */
    this.found = null; // of the report
    this.listed = ""; // what was published of the bat
    this.offset = 0; // in, of the answer
    this.warm = true;
    this.zoom = new Zoom({ onChange: () => this.paint(), closest: 0.25, shared: true });
    const onPick = (/** @type {number} */ position, /** @type {{ last: boolean }} */ { last }) => this.moveBall(position, last);
    this.picture = new BatView(app, {
      zoom: this.zoom, onBall: onPick,
      onStations: (stations, { last }) => app.bench.reshape(stations, last),
      onGrip: (change, { last }) => this.app.setState(change, { commit: last }),
    });
    const axis = { kind: "position_m", from: () => app.answer?.bat.length_m ?? 0.84, label: "from the tip" };
    this.chart = new Chart(app, { label: "Curves along the bat", panels: PANELS, axis, onPick, zoom: this.zoom });
    this.power = new HeatMap(app, {
      label: "Exit speed over the barrel", title: "Exit speed, where the ball goes forward", height: 150, zoom: this.zoom, x: axis,
      y: { kind: "offset_m", label: "ball above the axis" }, z: { kind: "exit_speed_m_s" }, onPick: (x, y, { last }) => this.moveBall(x, last, y),
    });
    const side = make("div", { className: "side" }, swingGroup(app), group("Impact", [
      slider(app, "impact_from_tip_in", { label: "From the tip", step: 0.1 }),
      slider(app, "offset_in", { label: "Ball above the bat's axis", step: 0.05 }),
    ]), ballGroup(app));
    this.words = make("p", { className: "verdict wide", id: "verdict" });
    this.why = make("p", { className: "why", id: "why" });
    this.again = make("p", { className: "note", id: "again" });
    const { bat: ofBat, schema } = app.entry(app.name);
    this.notOfBat = Object.keys(schema).filter((field) => !ofBat.includes(field));
    this.facts = factList(FACTS, app);
    this.among = make("p", { className: "note", hidden: true });
    this.report = make("details", { className: "report", open: false }, make("summary", { textContent: "What the report says of this bat and swing" }));
    this.told = make("div", { className: "words" });
    this.report.append(this.told);
    this.sure = new HowSure(app, { but: ELSEWHERE });
    this.bars = make("p", { className: "note", textContent: "Upright bars on the exit speed: by another law of the ball, how fast it leaves after the misses that the report tells of.", hidden: true });
    this.knownList = make("ul");
    this.known = make("details", { className: "report" }, make("summary", { textContent: "What was published of this bat (diamonds on the curves)" }), this.knownList);
    const barrel = button("Barrel", () => this.zoom.back());
    this.heatSwitch = button("Colors off", () => this.switchHeat());
    const tools = make("div", { className: "row tight" }, barrel, this.zoom.buttons("Whole bat"), this.heatSwitch);
    const picture = make("section", { className: "picture", ariaLabel: "Bat and curves" },
      tools, this.picture.element, this.facts.element, this.among, this.why, this.power.element, this.power.numbers.element, this.chart.element, this.again, this.bars, this.known, this.report, this.sure.element);
    root.append(this.words, side, picture);
    this.picture.element.classList.add("pinned");
    slideByKeys(app, this.picture, () => app.answer);
  }

  switchHeat() {
    this.warm = !this.warm;
    this.heatSwitch.textContent = this.warm ? "Colors off" : "Colors on";
    this.paint();
  }

  /** @param {number} position @param {boolean} last @param {number} [offset] */
  moveBall(position, last, offset) {
    const { answer, schema: { offset_in: { minimum = -Infinity, maximum = Infinity } } } = this.app;
    if (!answer) return;
    /** @type {Partial<State>} */
    const change = { impact_from_tip_in: within(answer, (answer.bat.length_m - position) / INCH) };
    if (offset !== undefined) {
      const inches = Math.round((20 * offset) / INCH) / 20;
      change.offset_in = Math.abs(inches) < 0.08 ? 0 : Math.min(maximum, Math.max(minimum, inches));
    }
    this.app.setState(change, { commit: last });
  }

  /** @param {ExplorerAnswer} answer @param {States["explorer"]} state */
  update(answer, { offset_in: offset }) {
    Object.assign(this, { answer, offset });
    const { bat } = answer, { units } = this.app;
    this.zoom.set([0, bat.length_m], [bat.length_m - Math.min(BARREL, bat.length_m), bat.length_m]);
    PANELS[0].lines = offset === 0 ? SPEEDS : SPEEDS.slice(0, 1); // off the axis there is no rigid one
    PANELS[1].lines = partsOf(answer.energy_names).map((line) => ({ ...line, label: line.name }));
    this.paint();
    this.facts.fill(answer);
    this.say(answer);
    this.app.aside("map", ELSEWHERE, 150, (map) => {
      this.map = map;
      this.paint();
    });
    this.app.aside("standing", this.notOfBat, 800, (found) => this.stand(found));
    this.app.aside("why", ELSEWHERE, 600, (found) => {
      this.found = found;
      paragraphs(this.told, found.sentences[this.app.units]);
      this.paint();
    });
    if (this.found) paragraphs(this.told, this.found.sentences[units]);
    this.sure.update();
  }

  // Where the bat's own numbers stand among others; how it is swung makes no difference.
  /** @param {BatStanding | null} found */
  stand(found) {
    const below = found?.below ?? {};
    this.facts.remark({ Weight: below.mass ?? "", "Swing weight": below.moi_6in ?? "", "Efficiency q": below.collision_efficiency ?? "" });
    showWords(this.among, found?.among ?? "");
  }

  paint() {
    const { answer, map } = this;
    if (!answer) return;
    this.picture.drawing = this.app.bench.drawing;
    const { bat, sweet_spots: spots, scan, hit, hands_m } = answer, offset_m = this.offset * INCH;
    const { exit_speed_m_s, collision_efficiency, bbcor, hand_impulse_n_s, sting_m_s } = hit;
    const speeds = scan.exit_speed_m_s, most = Math.max(...speeds.filter((value) => value !== null));
    const costs = offset_m === 0 ? this.found?.other_law ?? [] : [];
    this.picture.draw({ bat, sweet_spots: spots, hands_m, grips: gripsOf(answer, this.app),
      warm: this.warm ? { position_m: scan.position_m, values: speeds, least: 0.55 * most, most } : null,
      ball: { position_m: hit.position_m, radius_m: answer.ball.radius_m, offset_m, launch_angle_rad: hit.launch_angle_rad } });
    const zone = spots.zone_m;
    this.chart.draw({
      x: scan.position_m, lines: { ...scan, ...answer.energy_shares }, range: [0, bat.length_m], cursor: hit.position_m,
      bands: zone ? [{ from: zone[0], to: zone[1] }] : [],
      marks: [{ at: spots.max_exit_speed_m, color: "red" }],
      published: this.published(answer),
      here: { exit_speed_m_s, collision_efficiency, bbcor, hand_impulse_n_s, sting_m_s },
      points: { exit_speed_m_s: costs.map(({ position_m: x, low_m_s: low, high_m_s: high }) => ({ x, y: null, low, high })) },
    });
    this.bars.hidden = !costs.length;
    if (map) this.power.draw({ x: map.position_m, y: map.offset_m, z: map.exit_speed_m_s, heights: [map.offset_m[0] * ROOM, map.offset_m[map.offset_m.length - 1] * ROOM], cross: [hit.position_m, offset_m] });
  }

  // What others have published of this very bat, where it lies on the curves, and in a list with its source.
  /** @param {ExplorerAnswer} given */
  published({ published }) {
    const { units } = this.app;
    this.known.hidden = published.length === 0;
    const list = published.map(({ words, source }) => `${words[units]} ${source}`).join();
    if (list !== this.listed) this.knownList.replaceChildren(...published.map(({ words, source }) => make("li", {}, `${words[units]} `, make("small", { textContent: source }))));
    this.listed = list;
    /** @type {Record<string, Published[]>} */
    const marks = {};
    for (const { curve, words, place_m: [from, to], values } of published) (marks[curve] ??= []).push({ from, to, low: values?.[0], high: values?.[1], label: words[units] });
    return marks;
  }

  /** @param {ExplorerAnswer} given */
  say({ bat, hit, hands_m: hands, place, headline, why, where_energy_goes: energy, touched_again: stretches }) {
    const { units } = this.app, again = hit.touched_again[units];
    const words = headline[units].join(" "), reasons = [...why[units], ...again, ...energy[units]].join(" ");
    tell(this.words, words);
    tell(this.why, reasons);
    tell(this.again, again.length ? "" : stretches[units].join(" "));
    this.app.announce(words);
    this.picture.label(`Ball along the bat. ${words}`);
    this.chart.label(`Curves along the bat. ${words} ${reasons}`);
    this.power.label(`Exit speed over the barrel and how far off its axis the ball is met. ${words}`);
    tellPlace(this.picture, { bat, hands_m: hands }, hit.position_m, place[units]);
  }

  figures() { return [this.picture.figure("bat"), ...(this.map ? [this.power.figure("map")] : []), this.chart.figure("curves")]; }
  table() { return { ...this.answer?.scan }; }
}
