// Hits all along an implement under one swing, and what is read from them: `position_scan.scan` and `sweet_spot`.

import { NARROWEST, ZONE_LOSS, ZONE_STING, vertex } from "./kernel.js";
/** @import { Bat, Speeds } from "./bat.js" */

export class Along {
  /** @param {Bat} bat @param {Speeds} speeds */
  constructor(bat, speeds) {
    const { scanned: places, numbers: { turned_about: pivot } } = bat;
    const closing = places.map((place) => speeds.pitch + speeds.turning * (place - pivot));
    const hits = bat.hits(places.map((_, i) => i), closing);
    this.places = places;
    this.speeds = speeds;
    this.told = hits.map((hit, i) => bat.told(i, hit, speeds));
    this.exit = this.told.map(({ exit }) => exit);
    this.held = withoutSpikes(this.exit, places[1] - places[0]);
    this.best = topPlace(places, this.held);
    const beyond = Math.max(1, places.findIndex((place) => place >= this.best));
    this.fastest = Math.max(...this.exit.slice(beyond - 1, beyond + 1).filter(Number.isFinite));
    this.zone = zoneOf(places, this.held, this.told.map(({ sting }) => sting), this.best);
  }

  // A value straight between the places.
  /** @param {number[]} values @param {number} place */
  at(values, place) { return between(this.places, values, place) ?? NaN; }

  // What it costs to miss the best place by so much towards the hands and towards the tip, m/s.
  /** @param {number} distance */
  miss(distance) {
    const { held, best } = this, top = this.at(held, best);
    return { inside: top - this.at(held, best - distance), outside: top - this.at(held, best + distance) };
  }

  // What of the difference from the best place comes from motion, recoil and vibration: `speed_difference`.
  /** @param {ReturnType<Bat["told"]>} here */
  difference(here) {
    const { best, told } = this, of = (/** @type {"exit" | "rigid_exit" | "rigid" | "bat"} */ name, /** @type {number} */ place) => this.at(told.map((one) => one[name]), place);
    const rigid = of("rigid_exit", here.position) - of("rigid_exit", best), real = here.exit - of("exit", best);
    const motion = (1 + of("rigid", best)) * (of("bat", here.position) - of("bat", best));
    return { motion, giving: rigid - motion, keeping: real - rigid, together: motion + (rigid - motion) + (real - rigid) };
  }
}

// A value between sorted places, straight; null beyond their ends.
/** @param {number[]} places @param {number[]} values @param {number} at */
export function between(places, values, at) {
  const last = places.length - 1;
  if (at < places[0] || at > places[last]) return null;
  let [low, high] = [0, last];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (places[middle] <= at) low = middle;
    else high = middle;
  }
  return values[low] + ((at - places[low]) / (places[high] - places[low])) * (values[high] - values[low]);
}

/** @param {number[]} speeds @param {number} step */
function withoutSpikes(speeds, step) {
  const half = (Math.max(3, 2 * Math.round(NARROWEST / step / 2) + 1) - 1) / 2;
  const around = (/** @type {number[]} */ values, /** @type {(...values: number[]) => number} */ extreme) => values.map((_, i) =>
    extreme(...Array.from({ length: 2 * half + 1 }, (_, shift) => values[Math.min(values.length - 1, Math.max(0, i + shift - half))])));
  const opened = around(around(speeds.map((speed) => (Number.isNaN(speed) ? -Infinity : speed)), Math.min), Math.max);
  return speeds.map((speed, i) => Math.min(speed, opened[i] + ZONE_LOSS));
}

// The place of the greatest of evenly sampled values.
/** @param {number[]} places @param {number[]} values */
function topPlace(places, values) {
  const index = values.reduce((best, value, i) => (value > values[best] || Number.isNaN(values[best]) ? i : best), 0);
  const shift = index === 0 || index === values.length - 1 ? 0 : vertex(values[index - 1], values[index], values[index + 1])[0];
  return places[index] + shift * (places[1] - places[0]);
}

/** @param {number[]} places @param {number[]} held @param {number[]} sting @param {number} best @returns {[number, number] | null} */
function zoneOf(places, held, sting, best) {
  const known = sting.filter(Number.isFinite), quiet = (ZONE_STING * known.reduce((sum, value) => sum + value, 0)) / known.length;
  const least = Math.max(...held.filter(Number.isFinite)) - ZONE_LOSS, count = 20 * held.length;
  const fine = Array.from({ length: count }, (_, i) => places[0] + (i * (places[places.length - 1] - places[0])) / (count - 1));
  /** @type {[number, number][]} */
  const runs = [];
  let open = false;
  for (const place of fine) {
    const good = (between(places, held, place) ?? NaN) >= least && (between(places, sting, place) ?? NaN) < quiet;
    if (good && open) runs[runs.length - 1][1] = place;
    else if (good) runs.push([place, place]);
    open = good;
  }
  const far = (/** @type {[number, number]} */ [from, to]) => Math.max(from - best, best - to, 0);
  return runs.length ? runs.reduce((nearest, run) => (far(run) < far(nearest) ? run : nearest)) : null;
}
