// Compare: up to four bats in the same hands, or what a hole or another wall makes of one; curves, verdict, rules.

import { Chart } from "../chart.js";
import { Bench, ballGroup, swingGroup } from "../bench.js";
import { choice, group, slider } from "../controls.js";
import { make, paragraphs, tableOf } from "../parts.js";
import { ChangePicture, LINES, RowsPicture } from "./compare_pictures.js";
import { Slots } from "./compare_slots.js";

const VERDICTS = {
  pass: ["✓ pass", "good"], fail: ["✗ fail", "bad"], "not decidable": ["? not decidable", ""], "does not apply": ["– does not apply", "muted"],
};
const KINDS = { m: "x_m", "m/s": "x_m_s", "kg m^2": "x_kg_m2" };

export const view = {
  name: "compare",
  guide: [
    ["Which bat hits harder", "Up to four bats in the same player's hands, or one bat against itself with a hole or another wall. " +
      "The verdict says what changes and how sure that is."],
    ["Read the curves", "One curve for each bat, tips aligned: how fast the ball leaves from each place. The table below " +
      "gives weight, swing weight, speeds, and the swing that would make up for the difference."],
    ["Change the question", "Choose the bats, the same effort or the same bat speed, and whose rules they are held against. "],
  ],

  mount(root, app) {
    Object.assign(this, { app, root });
    this.bench = new Bench(app);
    this.slots = new Slots(app);
    this.hole = make("div", {},
      slider(app, "hole_diameter_in", { label: "Hole, width", step: 0.05 }),
      slider(app, "hole_depth_in", { label: "Hole, depth from the tip", step: 0.25 }));
    this.wall = slider(app, "wall_times", { label: "Wall, times bat 1's own", step: 0.01 });
    app.control({ field: "parts of what_if", sync: ({ what_if: asked }) => {
      this.hole.hidden = asked !== "cork";
      this.wall.hidden = asked !== "wall";
    } });
    const side = make("div", { className: "side" },
      group("Question", [
        choice(app, "what_if", { label: "Compare", options: [
          ["none", "these bats"], ["cork", "bat 1 drilled and corked"], ["wall", "bat 1 with another wall"]] }),
        this.hole, this.wall,
        choice(app, "same", { label: "Swung with", options: [["effort", "the same effort"], ["speed", "the same bat speed"]] }),
        choice(app, "swing_law", { label: "Players", options: [["baseball", "baseball"], ["slow-pitch", "slow-pitch softball"]] }),
      ]),
      this.bench.element, this.slots.element, swingGroup(app, { title: "Swing of bat 1, and pitch" }), ballGroup(app),
    );
    this.words = make("div", { className: "words", id: "verdict" });
    this.chart = new Chart(app, { label: "", panels: [], axis: { kind: "position_m", from: () => this.longest, label: "from the tip" } });
    this.rows = new RowsPicture(app);
    this.change = new ChangePicture(app);
    this.bats = make("div");
    this.rules = make("div");
    this.assumed = make("p", { className: "note" });
    const section = (title, ...parts) => make("section", { className: "picture" }, make("h2", { textContent: title }), ...parts);
    const legend = make("p", { className: "note", textContent: "Red dot: the ball leaves fastest there. Green bar: the sweet zone." });
    const main = make("div", { className: "stack" },
      section("Verdict", this.words, this.change.element),
      section("The bats and where they hit", this.rows.element, legend, this.chart.element, this.bats, this.assumed),
      section("League rules", choice(app, "league", { label: "Rules of", options: leagues(app) }), this.rules));
    root.append(side, main);
  },

  update(answer, state) {
    const { bats } = answer;
    this.longest = Math.max(...bats.map(({ bat }) => bat.length_m));
    this.bench.update(answer);
    this.slots.update(answer, state);
    const words = this.app.units === "si" ? answer.si : answer;
    paragraphs(this.words, words.verdict);
    this.assumed.textContent = words.assumptions;
    this.app.announce(words.verdict[0]);
    this.rows.draw(bats, this.longest);
    this.change.draw(bats);
    this.drawCurves(bats);
    this.bats.replaceChildren(this.tableOfBats(bats));
    this.rules.replaceChildren(...this.rulesOf(answer.certification));
  },

  drawCurves(bats) {
    const panel = (title, kind, height, key) => ({
      title, kind, height, lines: bats.map(({ label }, i) => ({ key: `${key}_${i}`, ...LINES[i], label: "", name: label })),
    });
    this.chart.panels = [
      panel("Exit speed", "exit_speed_m_s", 210, "exit_speed_m_s"),
      panel("Collision efficiency q", "ratio", 110, "collision_efficiency"),
    ];
    const [lines, xs] = [{}, {}];
    bats.forEach(({ scan, bat }, i) => {
      for (const key of ["exit_speed_m_s", "collision_efficiency"]) {
        lines[`${key}_${i}`] = scan[key];
        xs[`${key}_${i}`] = scan.position_m.map((place) => place + this.longest - bat.length_m);
      }
    });
    this.chart.draw({ x: [], xs, lines, range: [0, this.longest], marks: [], bands: [] });
    this.chart.label(`Exit speed and collision efficiency along ${bats.map(({ label }) => label).join(", ")}, tips aligned.`);
  },

  tableOfBats(bats) {
    const show = (name, value, digits) => this.app.text(name, value, digits);
    const range = (name, { value, low, high }) => ({
      text: show(name, value), note: low < high ? `${show(name, low).split(" ")[0]} to ${show(name, high)}` : "",
    });
    return tableOf("The bats and what they do in play; small: the interval", [
      "Bat", "Weight", "Balance", "Swing weight", "Bat speed", "Exit speed", "Change", "Breaks even at", "BBCOR",
    ], bats.map((one, i) => [
      one.label, show("mass_kg", one.bat.mass_kg), show("balance_point_m", one.bat.balance_point_m, 1),
      show("moi_6in_kg_m2", one.bat.moi_6in_kg_m2), range("bat_speed_m_s", one.bat_speed_m_s),
      range("exit_speed_m_s", one.exit_speed_m_s), i ? range("change_m_s", one.change_m_s) : "reference",
      i ? show("bat_speed_m_s", one.break_even_bat_speed_m_s) : "reference", one.max_bbcor.toFixed(3),
    ]));
  },

  rulesOf(certification) {
    const first = certification[0].checks;
    const rows = first.map((check, row) => [
      { text: check.title, note: [check.league_name, this.limit(check)].filter(Boolean).join(": ") },
      ...certification.map(({ checks }) => this.verdictOf(checks[row])),
    ]);
    const measures = certification.map(({ bbcor, besr, bpf }) => `BBCOR ${bbcor.toFixed(3)}, BESR ${besr.toFixed(3)}, BPF ${bpf.toFixed(2)}`);
    const table = tableOf("Every rule held against every bat, from the simulated test",
      ["Rule", ...certification.map(({ label }, i) => ({ text: label, note: measures[i] }))], rows);
    table.classList.add("rules");
    return [table];
  },

  limit({ least, most, unit }) {
    if (unit === "yes or no") return "";
    const sides = [["at least", least], ["at most", most]].filter(([, value]) => value !== null);
    return sides.map(([words, value]) => `${words} ${this.amount(value, unit)}`).join(", ");
  },

  amount(value, unit) {
    if (unit === "yes or no") return value ? "yes" : "no";
    return KINDS[unit] ? this.app.text(KINDS[unit], value) : value.toFixed(unit === "-" ? 3 : 2);
  },

  verdictOf(check) {
    const [words, className] = VERDICTS[check.verdict];
    const value = check.value === null || check.verdict === "does not apply" ? "" : ` (${this.amount(check.value, check.unit)})`;
    return { text: words + value, className, note: check.reason };
  },

  unmount() {},

  figures() {
    return [this.change.surface.figure("change"), this.rows.surface.figure("bats"), this.chart.figure("curves")];
  },

  table() {
    const columns = { label: [], position_m: [], exit_speed_m_s: [], collision_efficiency: [], bbcor: [] };
    for (const { label, scan } of this.app.answer.bats) {
      columns.label.push(...scan.position_m.map(() => label));
      for (const key of Object.keys(columns).slice(1)) columns[key].push(...scan[key]);
    }
    return columns;
  },
};

const leagues = (app) => app.lists().then((lists) => [["all", "all leagues"], ...(lists.leagues ?? []).map(({ key, name }) => [key, name])]);
