// One implement and ball: its hits at any place and speed, computed here by the solver's own formulas.

import { CONTACT_TIME, EFFICIENCY, GREATEST_COMPRESSION, GREATEST_FORCE, LATE, NO_CONTACT, RELEASE_TIME, RESULT_ROWS, TOUCHES, collision_efficiency, exit_speed, free_restitution, restitution_from_efficiency, solve } from "./kernel.js";
/** @import { Lanes } from "./kernel.js" */
/** @typedef {{ shape: number[], size: number, base64: string }} Packed */
/** @typedef {{ q: number, contact: number, release: number, force: number, pressed: number, touches: number, outcome: number, displacement: Float64Array, velocity: Float64Array }} Hit */
/** @typedef {{ pitch: number, turning: number }} Speeds m/s, and rad/s of the swing */

// The numbers of an array that is written as text: `PackedArray`.
/** @param {Packed} packed */
export function unpacked({ size, base64 }) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)), view = new DataView(bytes.buffer);
  if (size === 4) return Float64Array.from({ length: bytes.length / 4 }, (_, i) => view.getFloat32(4 * i, true));
  const whole = new DataView(new ArrayBuffer(8));
  return Float64Array.from({ length: bytes.length / size }, (_, i) => {
    for (let k = 0; k < size; k += 1) whole.setUint8(8 - size + k, bytes[i * size + k]);
    return whole.getFloat64(0, true);
  });
}

export class Bat {
  /** @param {any} numbers  `OfflineNumbers` @param {number} inch */
  constructor(numbers, inch) {
    this.numbers = numbers;
    const { places, wall, kernel, motion, doubt, length } = numbers;
    const { scan_start: start, scan_end: end, scanned, grid: [first, last] } = places;
    const step = (end - start) / (scanned - 1);
    /** @type {number[]} */
    this.scanned = Array.from({ length: scanned }, (_, i) => (i === scanned - 1 ? end : i * step + start)); // as numpy's linspace
    this.first = first;
    this.last = last;
    /** @type {number[]} */
    this.positions = [...this.scanned, ...Array.from({ length: last - first + 1 }, (_, i) => length - ((first + i) / 10) * inch)];
    this.size = kernel.omega.length;
    this.fixed = unpacked(places.shapes);
    this.give = unpacked(places.give);
    this.wall = wall && { modes: wall.modes, ends: wall.ends, values: unpacked(wall.values), slopes: unpacked(wall.slopes) };
    this.doubt = doubt && unpacked(doubt.values);
    this.filmShapes = unpacked(motion.film_shapes);
    this.squares = numbers.patch.radii.map((/** @type {number} */ radius) => radius ** 2);
  }

  // The number of the place that lies so many tenths of an inch from the tip.
  /** @param {number} tenths */
  placeAt(tenths) { return this.scanned.length + Math.min(this.last, Math.max(this.first, Math.round(tenths))) - this.first; }

  // Lagrange's weights of the tables by the patch, `PatchLaw.weights_at`.
  /** @param {number} closing */
  weights(closing) {
    const { squares, numbers: { patch: { reference, reference_speed: usual, power, radii } } } = this;
    const radius = Math.min(Math.max(reference * (Math.max(closing, 0) / usual) ** power, radii[0]), radii[radii.length - 1]);
    return squares.map((/** @type {number} */ own, /** @type {number} */ i) => squares.reduce((/** @type {number} */ product, /** @type {number} */ other, /** @type {number} */ j) => (i === j ? product : product * ((radius ** 2 - other) / (own - other))), 1));
  }

  // Shapes of the modes at a place as a ball of a closing speed meets it, and the surface's give there.
  /** @param {number} place @param {number} closing */
  struck(place, closing) {
    const { size, numbers: { places: { fixed }, kernel: { omega }, steps: { step } } } = this;
    const weights = this.weights(closing), shape = new Float64Array(size);
    fixed.forEach((/** @type {number} */ mode, /** @type {number} */ i) => (shape[mode] = this.fixed[place * fixed.length + i]));
    this.addWall(shape, this.positions[place], weights);
    let give = Math.max(0, weights.reduce((/** @type {number} */ sum, /** @type {number} */ weight, /** @type {number} */ k) => sum + weight * this.give[place * weights.length + k], 0));
    omega.forEach((/** @type {number} */ own, /** @type {number} */ i) => {
      if (own * step <= Math.PI) return;
      give += (shape[i] / own) ** 2; // `with_quick_modes_as_springs`
      shape[i] = 0;
    });
    return { shape, give };
  }

  // Shapes of the wall's modes, on the cubic piece where the place lies.
  /** @param {Float64Array} shape @param {number} position @param {number[]} weights */
  addWall(shape, position, weights) {
    if (!this.wall || position < this.wall.ends[0]) return;
    const { modes, ends, values, slopes } = this.wall, row = modes.length * weights.length;
    let piece = 0;
    while (piece < ends.length - 2 && ends[piece + 1] <= position) piece += 1;
    const long = ends[piece + 1] - ends[piece], at = (position - ends[piece]) / long;
    const near = (1 + 2 * at) * (1 - at) ** 2, far = 1 - near, rise = at * (1 - at) ** 2 * long, fall = at ** 2 * (at - 1) * long;
    for (let i = 0; i < modes.length; i += 1) {
      let sum = 0;
      for (let k = 0; k < weights.length; k += 1) {
        const here = piece * row + k * modes.length + i, next = here + row;
        sum += weights[k] * (near * values[here] + far * values[next] + rise * slopes[here] + fall * slopes[next]);
      }
      shape[modes[i]] = sum;
    }
  }

  // Hits at places by their numbers, each with its closing speed; `watch` sees every time step.
  /** @param {number[]} places @param {number[]} closing @param {((lanes: Lanes) => void) | null} [watch] @returns {Hit[]} */
  hits(places, closing, watch = null) {
    const { size, numbers: { kernel, ball, steps } } = this, count = places.length;
    const met = places.map((place, i) => this.struck(place, closing[i]));
    const rows = (/** @type {number} */ number, /** @type {number} */ length) => Array.from({ length: number }, () => new Float64Array(length));
    const output = { outcome: new Float64Array(count).fill(NO_CONTACT), results: rows(RESULT_ROWS, count), motion: [rows(count, size), rows(count, size)] };
    for (const row of output.results) row.fill(NaN);
    const moving = closing.every((speed) => speed > 0);
    const bat = { ...kernel, shapes: met.map(({ shape }) => shape), give: met.map(({ give }) => give), dashpots: [], half_dash: [] };
    if (moving) solve(1, closing, bat, ball, steps, output, watch);
    const { outcome, results, motion } = output;
    return places.map((_, i) => {
      const [displacement, velocity] = moved(kernel, motion[0][i], motion[1][i], -(results[LATE][i] || 0));
      return { q: results[EFFICIENCY][i], contact: results[CONTACT_TIME][i], release: results[RELEASE_TIME][i], force: results[GREATEST_FORCE][i], pressed: results[GREATEST_COMPRESSION][i], touches: results[TOUCHES][i], outcome: outcome[i], displacement, velocity };
    });
  }

  // What is told of a hit at a place under a swing.
  /** @param {number} place @param {Hit} hit @param {Speeds} speeds */
  told(place, { q, contact, force, pressed, displacement, velocity }, { pitch, turning }) {
    const { numbers: { turned_about: pivot, body, ball, hands, kernel: { omega }, motion } } = this;
    const position = this.positions[place], bat = turning * (position - pivot), closing = pitch + bat;
    const met = 1 / (1 / body.mass + (position - body.balance_point) ** 2 / body.moi_cm); // `effective_mass`
    const recoil = ball.mass / met, rigid = closing > 0 ? collision_efficiency(free_restitution(ball, closing, recoil), recoil) : NaN;
    let felt = 0;
    for (let i = 0; i < omega.length; i += 1) felt += motion.felt[i] * (velocity[i] ** 2 + (omega[i] * displacement[i]) ** 2);
    const hand = 1 - (body.mass * (body.balance_point - hands[0]) * (position - hands[0])) / body.moi_hands; // `hand_impulse_ratio`
    return {
      position, bat, closing, met, q, contact, force, pressed, rigid,
      bbcor: restitution_from_efficiency(q, (ball.mass * (position - body.clamp) ** 2) / body.moi_clamp),
      exit: exit_speed(q, pitch, bat),
      rigid_exit: exit_speed(rigid, pitch, bat),
      jolt: hand * ball.mass * closing * (1 + q),
      sting: Math.sqrt(felt),
      shares: this.shares(displacement, velocity, q, (ball.mass * closing ** 2) / 2),
    };
  }

  // Where the energy goes, `energy_shares`.
  /** @param {Float64Array} displacement @param {Float64Array} velocity @param {number} q @param {number} incoming */
  shares(displacement, velocity, q, incoming) {
    const { kernel: { omega }, motion: { families, rigid_part: rigid } } = this.numbers;
    /** @type {Record<string, number>} */
    const parts = { ball: q ** 2, translation: 0, rotation: 0, bending: 0, hoop: 0, face: 0 };
    let rest = 0;
    for (let i = 0; i < omega.length; i += 1) {
      const energy = (velocity[i] ** 2 + (omega[i] * displacement[i]) ** 2) / 2 / incoming, family = families[i];
      if (family === "hoop" || family === "face") parts[family] += energy;
      else rest += energy;
    }
    rigid.forEach((/** @type {number[]} */ row, /** @type {number} */ i) => {
      const speed = row.reduce((sum, part, mode) => sum + part * velocity[mode], 0);
      parts[i === 0 ? "translation" : "rotation"] += speed ** 2 / 2 / incoming;
    });
    parts.bending = rest - parts.translation - parts.rotation;
    parts.heat = 1 - Object.values(parts).reduce((sum, part) => sum + part, 0);
    return parts;
  }

  // One standard deviation of the exit speed at a place that can be hit, m/s; null where it is not known.
  /** @param {number} place @param {number} closing */
  error(place, closing) {
    const { doubt, numbers } = this;
    if (!doubt || closing < numbers.doubt.slowest) return null;
    const nodes = numbers.doubt.values.shape[1], [low, high] = [numbers.doubt.slowest, numbers.doubt.fastest].map(Math.sqrt);
    const at = (2 * Math.sqrt(closing) - low - high) / (high - low), row = (place - this.scanned.length) * nodes;
    let [sum, weights] = [0, 0]; // the barycentric formula at Chebyshev's nodes
    for (let j = 0; j < nodes; j += 1) {
      const angle = ((2 * j + 1) * Math.PI) / (2 * nodes), apart = at - Math.cos(angle);
      if (Math.abs(apart) < 1e-12) return closing * doubt[row + j];
      const weight = ((j % 2 ? -1 : 1) * Math.sin(angle)) / apart;
      sum += weight * doubt[row + j];
      weights += weight;
    }
    return (closing * sum) / weights;
  }
}

// Modal displacements and velocities of a free implement some seconds later, or earlier: `free_motion.moved`.
/** @param {{ omega: number[], damping_rate: number[] }} kernel @param {ArrayLike<number>} displacement @param {ArrayLike<number>} velocity @param {number} time */
export function moved({ omega, damping_rate: damping }, displacement, velocity, time) {
  const places = new Float64Array(omega.length), speeds = new Float64Array(omega.length);
  for (let i = 0; i < omega.length; i += 1) {
    const rate = damping[i] / 2, square = omega[i] ** 2 - rate ** 2, root = Math.sqrt(Math.abs(square)), turned = root * time;
    const cosine = square >= 0 ? Math.cos(turned) : Math.cosh(turned);
    const sine = Math.abs(turned) < 1e-8 ? time : (square >= 0 ? Math.sin(turned) : Math.sinh(turned)) / root;
    const decay = Math.exp(-rate * time);
    places[i] = decay * ((cosine + rate * sine) * displacement[i] + sine * velocity[i]);
    speeds[i] = decay * (-(omega[i] ** 2) * sine * displacement[i] + (cosine - rate * sine) * velocity[i]);
  }
  return [places, speeds];
}
