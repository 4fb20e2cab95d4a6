// The hit in slow motion: ball, bat and wall at one moment, and force, hands and energy over time.

import { Chart } from "../charts/chart.js";
import { ballGroup, swingGroup } from "../bat/swing.js";
import { group, slider, toggle } from "../controls/controls.js";
import { Film, LEAD } from "../bat/film.js";
import { paintEnd, paintSide, sideHeight } from "../bat/filmscene.js";
import { HowSure } from "../controls/howsure.js";
import { Ledger } from "../charts/ledger.js";
import { factList, make, tell } from "../controls/parts.js";
import { Surface } from "../charts/surface.js";
import { Transport } from "../controls/transport.js";
/** @import { FilmAnswer, States } from "../answers.js" */
/** @import { AppOf, Guide } from "../shell/main.js" */
/** @import { Fact } from "../controls/parts.js" */

const PANELS = [
  { title: "Force on the ball", kind: "force_n", height: 84, zero: true, lines: [{ key: "force_n", color: "red", fill: true }] },
  { title: "Speed of the bat under the top hand", kind: "hand_velocity_m_s", height: 84, lines: [{ key: "hand", color: "purple" }] },
];
const FILMED = ["held", "duration_ms", "moment_ms", "exaggeration", "recoil", "slowness"]; // what the hit's numbers do not depend on
/** @type {Fact<FilmAnswer>[]} */
const FACTS = [
  ["Exit speed", (a) => ["exit_speed_m_s", a.hit.exit_speed_m_s]],
  ["Push over, below 1 % of its peak", (a) => ["contact_time_s", a.hit.contact_time_s]],
  ["Ball free", (a) => ["release_time_s", a.hit.release_time_s]],
  ["Peak force", (a) => ["peak_force_n", a.hit.peak_force_n]],
  ["Ball pressed in by", (a) => ["pressed", a.hit.peak_compression_m]],
  ["Wave reaches the top hand", (a) => ["arrival_s", a.top_hand.arrival_s]],
  ["Push given by then", (a) => ["given_pct", a.top_hand.impulse_given === null ? null : 100 * a.top_hand.impulse_given]],
];

export default class HitView {
  /** @type {Guide} */
  static guide = [
    ["A hit, slowed down", "Ball and bat meet for about a thousandth of a second. Here it is a film: the ball is pressed in, " +
      "the bat bends, and a wave runs from the ball to the hands."],
    ["Move through time", "Play and pause, or drag anywhere on the curves to see that moment: the force on the ball, the bat " +
      "under the hands, and below them where the energy is."],
    ["Change the hit", "Meet the ball nearer to the tip or to the hands, choose another bat, make the film slower or the " +
      "bat's motion larger. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"hit">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {Film | null} */
    this.film = null;
    this.series = { x: /** @type {number[]} */ ([]), lines: /** @type {Record<string, number[]>} */ ({}) }; // of the film, for charts
    this.look = { exaggeration: 1, recoil: false }; // of the bat's motion
    this.started = false;
    this.side = new Surface(app, {
      label: "Ball and bat from the side", height: (width) => (this.film ? sideHeight(this.film, width, this.look) : 300),
      paint: (context, width, height) => this.film && paintSide(context, width, height, this.shown(this.film)),
    });
    this.side.element.classList.add("pinned");
    this.end = new Surface(app, {
      label: "Barrel and ball from the end, where the ball meets it.", height: () => 250,
      paint: (context, width, height) => this.film && paintEnd(context, width, height, this.shown(this.film)),
    });
    const onPick = (/** @type {number} */ moment, /** @type {{ last: boolean }} */ { last }) => this.pick(moment, last);
    this.chart = new Chart(app, { label: "Force and the hands' motion in time", panels: PANELS, axis: { kind: "time_s", label: "after first touch" }, onPick });
    this.ledger = new Ledger(app, { onPick });
    this.transport = new Transport(app, { field: "moment_ms", onMoment: () => this.paint(), describe: (moment) => this.describe(moment) });
    this.words = make("p", { className: "verdict flow", id: "verdict" });
    this.facts = factList(FACTS, app);
    this.sure = new HowSure(app, { but: FILMED });
    root.append(
      make("div", { className: "side" },
        group("Hit", [
          slider(app, "impact_from_tip_in", { label: "Ball meets bat, from the tip", step: 0.1 }),
          toggle(app, "held", { label: "Typical hands hold the bat", note: "Their grip changes the handle's motion, not the ball's." }),
        ]),
        group("Film", [
          slider(app, "slowness", { label: "Slower than life, times", step: 100 }),
          slider(app, "exaggeration", { label: "Bat's motion drawn larger, times", step: 0.5 }),
          slider(app, "duration_ms", { label: "Lasts, after first touch", step: 0.5 }),
          toggle(app, "recoil", { label: "Show the whole motion", note: "Without: the bending alone, the bat's push back and turn left out." }),
        ]),
        swingGroup(app), ballGroup(app)),
      make("section", { className: "picture", ariaLabel: "The hit in slow motion" }, this.words, this.side.element, this.transport.element,
        make("div", { className: "film-pair" }, this.end.element, make("div", {}, this.chart.element, this.ledger.chart.element)), // one width, so that a moment stands at one place in both
        this.ledger.element, this.facts.element, this.sure.element));
    this.transport.keys(root);
  }

  /** @param {FilmAnswer} answer @param {States["hit"]} state */
  update(answer, state) {
    const film = this.film?.answer === answer ? this.film : new Film(answer);
    if (film !== this.film) Object.assign(this, { film, series: film.series() });
    this.look = state;
    this.facts.fill(answer);
    this.sure.update();
    const renamed = this.ledger.set(film, this.series);
    this.transport.set({ from: -LEAD, to: film.end, frames: film.times, slowness: state.slowness });
    this.say(answer);
    if (renamed || !this.transport.moving) this.paint(); // while it plays, every frame does
    if (!this.started && !this.app.calm && !new URLSearchParams(location.search).has("moment_ms")) {
      this.transport.moment = -LEAD;
      this.transport.play();
    }
    this.started = true;
  }

  // What the pictures need to know of this moment.
  /** @param {Film} film */
  shown(film) {
    const { app, look: { exaggeration, recoil } } = this, { deepest, answer: { hoop, speeds } } = film;
    return {
      film, moment: this.transport.moment, colors: app.colors, exaggeration, recoil,
      wall: hoop && deepest > 0 ? Math.min(exaggeration, (0.5 * hoop.radius_m) / deepest) : 1,
      notes: [`${recoil ? "bat's motion" : "bat's bending alone"} × ${Number(exaggeration.toFixed(1))}; ball and bat to scale; dashed: ${recoil ? "where the swing alone would take it" : "the straight bat"}`,
        `colored: the bat moves fast against its swing, up to ${app.text("speed_m_s", film.fastest, 0)}`,
        ...speeds[app.units]],
    };
  }

  paint() {
    if (!this.film) return;
    const { film, series } = this;
    const moment = this.transport.moment;
    this.side.draw();
    this.end.draw();
    const { arrival_s: arrival } = film.answer.top_hand;
    const marks = [{ at: film.hit.contact_time_s, color: "muted", label: "push over" }, { at: film.hit.release_time_s, color: "muted", label: "ball free" }];
    if (arrival !== null) marks.push({ at: arrival, color: "purple", label: "wave at the top hand" });
    marks.sort((a, b) => b.at - a.at);
    this.chart.draw({ x: series.x, lines: series.lines, range: [-LEAD, film.end], marks, cursor: moment });
    this.ledger.draw(moment);
  }

  /** @param {number} moment @param {boolean} last */
  pick(moment, last) {
    this.transport.pause();
    this.transport.show(moment);
    if (last) this.transport.rest();
  }

  /** @param {number} moment */
  describe(moment) {
    const { film, app } = this;
    const short = app.text("moment_s", moment, 2);
    if (!film) return { short, long: short };
    /** @type {Record<string, string>} */
    const numbers = { moment: short, pressed: app.text("pressed_m", film.pressed(moment)), force: app.text("force_n", film.force(moment)) };
    const phase = film.answer.phases.filter(({ start_s: start }) => start <= moment).at(-1);
    return { short, long: phase?.words.replace(/\{(\w+)\}/g, (_, name) => numbers[name]) ?? short };
  }

  /** @param {FilmAnswer} given */
  say({ force, words: told }) {
    const words = told[this.app.units].join(" ");
    if (tell(this.words, words)) this.app.announce(words);
    this.side.label(`Ball and bat from the side, ${this.look.exaggeration} times its motion. ${words}`);
    this.chart.label(force[this.app.units].join(" "));
  }

  unmount() { this.transport.end(); }
  figures() { return [this.side.figure("hit"), this.end.figure("end"), this.chart.figure("time"), this.ledger.figure("energy")]; }
  table() {
    if (!this.film) return {};
    const { film, top_hand: hand, hoop, energy_j: energy } = this.film.answer;
    const dents = Object.fromEntries((hoop?.harmonics ?? []).map((n, i) => [`wall_dent_harmonic_${n}_m`, hoop?.dent_m[i] ?? []]));
    return {
      time_s: film.time_s, force_n: film.force_n, compression_m: film.compression_m, ball_travel_m: film.ball_travel_m,
      hand_displacement_m: hand.displacement_m, hand_velocity_m_s: hand.velocity_m_s,
      ...Object.fromEntries(Object.entries(energy).map(([name, values]) => [`energy_${name}_j`, values])), ...dents,
    };
  }
}
