// The hit in slow motion, followed step by step by the solver and then swinging freely on.

import { ARRIVAL, BALL_POSITION, BALL_SPEED, DURATION, FORCE, FREE_FRAMES, KICKS, OFFSET, POWER, TOTAL } from "./kernel.js";
import { moved } from "./bat.js";
import { Film, LEAD } from "../bat/film.js";
import { paintEnd, paintSide, sideHeight } from "../bat/filmscene.js";
import { Surface } from "../charts/surface.js";
import { byId, make } from "../controls/parts.js";
import { Transport } from "../controls/transport.js";
/** @import { FilmAnswer } from "../answers.js" */
/** @import { Answer, File } from "./file.js" */
/** @import { Lanes } from "./kernel.js" */
/** @import { App } from "../shell/main.js" */

const LARGER = 4, SLOWER = 2000; // how much larger the bending is drawn, and how much slower than life it plays
const NO_FORCE = 1; // N, below which the ball counts as free

export class SlowMotion {
  /** @param {File} file @param {App} app */
  constructor(file, app) {
    this.file = file;
    const { labels } = file.words;
    /** @type {Film | null} */
    this.film = null;
    this.stale = true;
    const look = { exaggeration: LARGER, recoil: false };
    this.side = new Surface(app, { label: labels.side, height: (width) => (this.film ? sideHeight(this.film, width, look) : 200), paint: (context, width, height) => {
      if (this.film) paintSide(context, width, height, { film: this.film, moment: this.transport.moment, ...look, colors: file.colors, notes: [file.words.film.note] });
    } });
    this.end = new Surface(app, { label: labels.end, height: () => 220, paint: (context, width, height) => {
      if (this.film) paintEnd(context, width, height, { film: this.film, moment: this.transport.moment, wall: 1, colors: file.colors });
    } });
    this.transport = new Transport(app, { field: /** @type {any} */ ("moment_ms"), onMoment: () => this.paint(), describe: (moment) => this.describe(moment) });
    this.caption = make("p", { className: "note", id: "moment-words" });
    this.element = make("details", { className: "card", id: "film" }, make("summary", { textContent: labels.film }), this.side.element, this.transport.element, this.caption, make("div", { className: "end" }, this.end.element));
    this.element.addEventListener("toggle", () => this.element.open && this.refresh());
    byId("rest").append(this.element);
  }

  /** @param {Answer} answer */
  update(answer) {
    this.answer = answer;
    this.stale = true;
    if (this.element.open) this.refresh();
  }

  refresh() {
    if (!this.answer) return;
    if (this.stale) {
      this.film = this.filmed(this.answer);
      this.stale = false;
    }
    if (!this.film) return;
    this.transport.set({ from: -LEAD, to: this.film.end, frames: this.film.times, slowness: SLOWER });
    this.paint();
  }

  paint() {
    this.side.draw();
    this.end.draw();
    this.caption.textContent = this.describe(this.transport.moment).long;
  }

  // The words of a moment, `film_phases`.
  /** @param {number} moment */
  describe(moment) {
    const { film, file } = this, { speaker, words } = file, number = { digits: null, sign: false, unit: true, round: false };
    const short = speaker.number(moment, { ...number, scale: "contact", digits: 2 });
    if (!film) return { short, long: short };
    const { arrival_s: arrival } = film.answer.top_hand;
    const doing = words.film.ball[moment < 0 ? 0 : moment < film.hit.release_time_s ? 1 : 2], felt = words.film.hands[arrival !== null && moment >= arrival ? 1 : 0];
    /** @type {Record<string, string>} */
    const slots = { moment: short, doing, felt, pressed: speaker.number(film.pressed(moment), { ...number, scale: "pressed" }), force: speaker.number(film.force(moment), { ...number, scale: "blow" }) };
    const filled = (/** @type {string} */ said) => said.replace(/\{+(\w+)\}+/g, (_, name) => slots[name] ?? "");
    return { short, long: filled(filled(words.film.whole)) };
  }

  // The hit as `FilmAnswer` has it, from the solver's own steps.
  /** @param {Answer} answer */
  filmed({ place, closing, here, hit }) {
    const { bat, numbers, drawing } = this.file, { steps, kernel, motion } = numbers;
    /** @type {{ time: number, ball: number, displacement: ArrayLike<number>, velocity: ArrayLike<number>, force: number, pressed: number }[]} */
    const frames = [];
    const watch = (/** @type {Lanes} */ { state, displacement, velocity }) => {
      const last = frames.at(-1), [elastic] = state[FORCE];
      if (last && state[KICKS][0] > 0) Object.assign(last, { force: state[TOTAL][0] > NO_FORCE ? state[TOTAL][0] : 0, pressed: elastic > NO_FORCE ? Math.exp((Math.log(elastic) - state[OFFSET][0]) / state[POWER][0]) : 0 });
      frames.push({ time: (state[KICKS][0] + steps.first_kick) * steps.step, ball: state[BALL_POSITION][0], displacement: displacement.map(([value]) => value), velocity: velocity.map(([value]) => value), force: 0, pressed: 0 });
      this.left = state[BALL_SPEED][0];
    };
    bat.hits([place], [closing], watch);
    if (!frames.length || !Number.isFinite(hit.q)) return null;
    const seen = frames.filter(({ time }) => time < Math.max(hit.release + 2 * steps.step, 1e-4));
    const last = seen[seen.length - 1];
    for (let i = 1; i <= FREE_FRAMES && last.time < DURATION; i += 1) {
      const after = (i * (DURATION - last.time)) / FREE_FRAMES, [displacement, velocity] = moved(kernel, last.displacement, last.velocity, after);
      seen.push({ time: last.time + after, ball: last.ball - hit.q * closing * after, displacement, velocity, force: 0, pressed: 0 });
    }
    const { shape } = bat.struck(place, closing);
    const dot = (/** @type {ArrayLike<number>} */ one, /** @type {ArrayLike<number>} */ other) => Array.prototype.reduce.call(one, (sum, value, i) => Number(sum) + value * other[i], 0);
    const fastest = Math.max(...seen.map(({ velocity }) => Math.abs(Number(dot(shape, velocity)))));
    const arrived = seen.find(({ velocity }) => Math.abs(Number(dot(motion.hand_shape, velocity))) >= ARRIVAL * fastest);
    const places = motion.places.length;
    return new Film(/** @type {FilmAnswer} */ (/** @type {unknown} */ ({
      bat: { ...drawing, length_m: numbers.length, balance_point_m: numbers.body.balance_point }, ball: { radius_m: numbers.ball_radius }, hands_m: numbers.hands, energy_j: {}, hoop: null,
      hit: { position_m: here.position, closing_speed_m_s: closing, release_time_s: hit.release, incoming_energy_j: 0 },
      top_hand: { arrival_s: arrived ? arrived.time : null },
      film: {
        time_s: seen.map(({ time }) => time), force_n: seen.map(({ force }) => force), compression_m: seen.map(({ pressed }) => pressed),
        gap_m: seen.map(({ displacement, ball }) => Math.max(Number(dot(shape, displacement)) - ball, 0)), place_m: motion.places,
        shape_per_sqrt_kg: motion.film_modes.map((/** @type {number} */ _, /** @type {number} */ i) => [...bat.filmShapes.subarray(i * places, (i + 1) * places)]),
        motion_sqrt_kg_m: motion.film_modes.map((/** @type {number} */ mode) => seen.map(({ displacement }) => displacement[mode])),
        push_m: seen.map(({ displacement }) => dot(motion.push, displacement)), turn_rad: seen.map(({ displacement }) => dot(motion.turn, displacement)),
      },
    })));
  }
}
