// A hit's answer as a film: what ball, bat and wall do at any moment, straight between the moments of the answer.

/** @import { FilmAnswer } from "../answers.js" */

export const LEAD = 0.4e-3; // s before first touch at which the film begins

export class Film {
  /** @param {FilmAnswer} answer */
  constructor(answer) {
    const { film, hit, bat, ball, energy_j: energy } = answer;
    this.answer = answer;
    this.hit = hit;
    this.bat = bat;
    this.ball = ball;
    this.energy = energy;
    this.times = film.time_s;
    this.end = this.times[this.times.length - 1];
    this.shapes = film.shape_per_sqrt_kg;
    this.places = film.place_m;
    this.fastest = this.greatestSpeed();
    this.deepest = this.deepestDent();
    this.lowest = Math.max(...[0.25, 0.5, 0.75, 1].map((part) => Math.max(...this.line(part * this.end))));
  }

  // [index, part] of a moment between two moments of the answer; before first touch [0, 0].
  /** @param {number} moment */
  where(moment) {
    const { times } = this;
    if (moment <= times[0]) return [0, 0];
    let [low, high] = [0, times.length - 1];
    if (moment >= times[high]) return [high - 1, 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= moment) low = middle;
      else high = middle;
    }
    return [low, (moment - times[low]) / (times[high] - times[low])];
  }

  /** @param {number[]} series @param {number} moment */
  value(series, moment) {
    const [index, part] = this.where(moment);
    return series[index] + part * (series[index + 1] - series[index]);
  }

  // How far the bat's line has moved at every place, m, in the direction of the push; without recoil: its bending alone.
  /** @param {number} moment */
  line(moment, recoil = true) {
    const { film } = this.answer;
    const [index, part] = this.where(moment);
    const at = (/** @type {number[]} */ series) => series[index] + part * (series[index + 1] - series[index]);
    const motion = film.motion_sqrt_kg_m.map(at);
    const [push, turn] = recoil ? [0, 0] : [at(film.push_m), at(film.turn_rad)];
    return this.places.map((place, i) => {
      let moved = -push - turn * (place - this.bat.balance_point_m);
      for (let mode = 0; mode < motion.length; mode += 1) moved += motion[mode] * this.shapes[mode][i];
      return moved;
    });
  }

  // How fast each place moves, m/s: the wave.
  /** @param {number} moment */
  speeds(moment) {
    const step = 8e-6;
    if (moment < 0) return this.places.map(() => 0);
    const [after, before] = [this.line(moment + step), this.line(Math.max(0, moment - step))];
    const span = Math.min(this.end, moment + step) - Math.min(this.end - step, Math.max(0, moment - step));
    return after.map((value, i) => (value - before[i]) / span);
  }

  greatestSpeed() {
    let most = 0;
    for (let i = 1; i <= 24; i += 1) for (const speed of this.speeds((i / 24) * 1.5e-3)) most = Math.max(most, Math.abs(speed));
    return most || 1;
  }

  // The ball: how far it is pressed in, and how far it is from the bat, m.
  /** @param {number} moment */
  pressed(moment) {
    return moment <= 0 ? 0 : this.value(this.answer.film.compression_m, moment);
  }
  /** @param {number} moment */
  gap(moment) {
    return moment <= 0 ? -moment * this.hit.closing_speed_m_s : this.value(this.answer.film.gap_m, moment);
  }
  /** @param {number} moment */
  force(moment) {
    return moment <= 0 ? 0 : this.value(this.answer.film.force_n, moment);
  }

  // Dent of the wall inwards at an angle from the ball, m.
  /** @param {number} moment @param {number} angle */
  dent(moment, angle) {
    const { hoop } = this.answer;
    if (!hoop || moment <= 0) return 0;
    return hoop.harmonics.reduce((sum, n, i) => sum + this.value(hoop.dent_m[i], moment) * Math.cos(n * angle), 0);
  }
  deepestDent() {
    const { hoop } = this.answer;
    if (!hoop) return 0;
    return Math.max(...this.times.map((_, i) => Math.abs(hoop.dent_m.reduce((sum, series) => sum + series[i], 0))));
  }

  // Series for charts, with the ball's way before first touch put in front.
  series() {
    const { answer, hit } = this;
    const before = (/** @type {number[]} */ values, /** @type {number} */ first) => [first, first, ...values];
    /** @type {Record<string, number[]>} */
    const lines = {
      force_n: before(answer.film.force_n, 0),
      hand: before(answer.top_hand.velocity_m_s, 0),
    };
    for (const [name, values] of Object.entries(this.energy)) lines[name] = before(values, name === "ball" ? hit.incoming_energy_j : 0);
    return { x: [-LEAD, -1e-9, ...this.times], lines };
  }
}
