// Pictures of one moment of a film: the bat from the side, bending, and the barrel from its end, with the ball on it.

import { around, between, looks, radiusAt } from "./batpaint.js";
import { dot, line, shape } from "../charts/pen.js";
import { FONT, haloText, wrapped } from "../charts/surface.js";
/** @import { Colors } from "../shell/main.js" */
/** @import { Way } from "./batpaint.js" */
/** @import { Film } from "./film.js" */

/** @typedef {{ film: Film, moment: number, exaggeration: number, recoil: boolean, colors: Colors, notes: string[] }} SideLook */

const PAD = 16, SIDES = 96;
const GRIP = 0.04; // m, half of a bat's thickness and what is drawn beside its handle

// Ball and bat as a camera beside the bat sees them; the ball comes from above. How it is shown:
// { film, moment, exaggeration, recoil, colors, notes: [texts] }
/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {SideLook} given
 */
export function paintSide(context, width, height, { film, moment, exaggeration, recoil, colors, notes }) {
  const { bat, ball, hit, places } = film;
  const scale = (width - 2 * PAD) / bat.length_m;
  const across = (/** @type {number} */ x) => PAD + x * scale;
  const bent = film.line(moment, recoil).map((moved) => moved * exaggeration * scale);
  const below = beneath(film, { exaggeration, recoil }) * scale;
  const middle = sideMiddle(film, width) - Math.max(0, Math.max(...bent) + GRIP * scale - below); // the camera follows a bat that leaves
  const drop = (/** @type {number} */ x) => between(places, bent, x);
  line(context, [[across(0) - 8, middle], [across(bat.length_m) + 8, middle]], colors.line, 1, [5, 5]);
  paintBody(context, film, { across, middle, drop, scale }, colors);
  paintSpeed(context, film, moment, { across, middle, drop, scale }, colors);
  paintHands(context, film, moment, { across, middle, drop, scale }, colors);
  const top = middle + drop(hit.position_m) - radiusAt(bat, hit.position_m) * scale;
  paintBall(context, {
    x: across(hit.position_m), surface: top - film.gap(moment) * scale, radius: ball.radius_m * scale,
    pressed: film.pressed(moment) * scale,
  }, colors);
  context.font = `12px ${FONT}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  const rows = notes.flatMap((words) => wrapped(context, context.font, words, width - 2 * PAD));
  rows.forEach((words, i) => haloText(context, words, PAD, height - 8 - 16 * (rows.length - 1 - i), colors.muted, colors.panel));
}

// Where the axis of the undisturbed bat lies, px from the top: room for the ball on its way.
/** @param {Film} film @param {number} width */
export function sideMiddle(film, width) {
  const scale = (width - 2 * PAD) / film.bat.length_m;
  return 14 + scale * (2 * film.ball.radius_m + 0.05 + radiusAt(film.bat, film.hit.position_m));
}

/**
 * @param {Film} film
 * @param {number} width
 * @param {{ exaggeration: number, recoil: boolean }} given
 */
export function sideHeight(film, width, { exaggeration, recoil }) {
  const scale = (width - 2 * PAD) / film.bat.length_m;
  return Math.round(sideMiddle(film, width) + beneath(film, { exaggeration, recoil }) * scale + (width < 640 ? 112 : 64));
}

// Room below the undisturbed bat's axis, m: half of what the bat needs in the end, since the camera follows it there.
/** @param {Film} film @param {{ exaggeration: number, recoil: boolean }} given */
function beneath(film, { exaggeration, recoil }) {
  return recoil ? Math.min(0.25, Math.max(0.09, (exaggeration * film.lowest + GRIP) / 2)) : 0.09;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Film} film
 * @param {{ across: Way, middle: number, drop: Way, scale: number }} given
 * @param {Colors} colors
 */
function paintBody(context, film, { across, middle, drop, scale }, colors) {
  const { bat } = film;
  const stations = [...new Set([...bat.outline.position_m, ...film.places])].sort((a, b) => a - b);
  shape(context, around(stations.map((x) => [across(x), middle + drop(x), radiusAt(bat, x) * scale])), looks(bat, colors));
}

// Red where the bat moves fast: the wave on its way.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {Film} film
 * @param {number} moment
 * @param {{ across: Way, middle: number, drop: Way, scale: number }} given
 * @param {Colors} colors
 */
function paintSpeed(context, film, moment, { across, middle, drop, scale }, colors) {
  const speeds = film.speeds(moment);
  for (let i = 0; i + 1 < film.places.length; i += 1) {
    const strength = Math.min(1, Math.abs(speeds[i] + speeds[i + 1]) / (2 * film.fastest));
    if (strength < 0.02) continue;
    context.globalAlpha = 0.85 * strength;
    const [a, b] = [film.places[i], film.places[i + 1]];
    shape(context, around([a, b].map((x) => [Math.round(across(x)), middle + drop(x), radiusAt(film.bat, x) * scale])), { fill: colors.red }); // whole pixels: no seams
  }
  context.globalAlpha = 1;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Film} film
 * @param {number} moment
 * @param {{ across: Way, middle: number, drop: Way, scale: number }} given
 * @param {Colors} colors
 */
function paintHands(context, film, moment, { across, middle, drop, scale }, colors) {
  const { hands_m: hands, top_hand: felt } = film.answer;
  const arrived = felt.arrival_s !== null && moment >= felt.arrival_s;
  for (const place of hands) {
    const [x, y, reach] = [across(place), middle + drop(place), radiusAt(film.bat, place) * scale + 7];
    const tilt = (drop(place + 0.03) - drop(place - 0.03)) / 2;
    for (const side of [-1, 1]) line(context, [-1, 1].map((end) => [x + end * 0.03 * scale, y + end * tilt + side * reach]), arrived ? colors.purple : colors.muted, 3);
  }
  const top = Math.min(...hands.map((hand) => drop(hand)));
  const [x, y] = [across((hands[0] + hands[1]) / 2), middle + top - radiusAt(film.bat, hands[0]) * scale - 14];
  context.font = `${arrived ? "600 " : ""}12px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  haloText(context, arrived ? "hands: the wave is here" : "hands: nothing yet", Math.max(x, PAD + 62), y, colors.ink, colors.panel);
}

// A ball resting on or above a surface: its near side flattened by what it is pressed in, its waist wider for that.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ x: number, surface: number, radius: number, pressed: number }} given
 * @param {Colors} colors
 */
export function paintBall(context, { x, surface, radius, pressed }, colors) {
  const near = radius - pressed;
  const waist = radius * Math.sqrt((2 * radius) / (2 * radius - pressed));
  const centre = surface - near;
  /** @type {(turn: number, across: number, up: number, down: number) => [number, number]} */
  const outline = (turn, across, up, down) => [x + across * Math.sin(turn), centre - (Math.cos(turn) > 0 ? up : down) * Math.cos(turn)];
  shape(context, ringOf((turn) => outline(turn, waist, radius, near)), { fill: colors.paper, edge: colors.ink, width: 1.5 });
  for (const side of [-1, 1]) {
    line(context, Array.from({ length: 17 }, (_, i) => {
      const height = -0.75 + (1.5 * i) / 16, bulge = side * waist * (0.42 + 0.36 * height ** 2);
      return [x + bulge, centre - height * (height > 0 ? radius : near)];
    }), colors.red, 1.3);
  }
}

// The barrel from its end where the ball meets it, the ball above; a hollow wall breathes, `wall` times as far as in life.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {{ film: Film, moment: number, wall: number, colors: Colors }} given
 */
export function paintEnd(context, width, height, { film, moment, wall, colors }) {
  const { bat, ball, hit, answer } = film;
  const outer = radiusAt(bat, hit.position_m);
  const scale = Math.min((width - 16) / (2 * ball.radius_m * 1.25), (height - 30) / (2 * ball.radius_m + 2 * outer + 0.012));
  const [x, y] = [width / 2, height - 22 - outer * scale];
  const ring = (/** @type {number} */ inset) => ringOf((turn) => {
    const reach = (outer - inset - wall * film.dent(moment, turn)) * scale;
    return [x + reach * Math.sin(turn), y - reach * Math.cos(turn)];
  });
  const { fill, edge } = looks(bat, colors);
  shape(context, ring(0), { fill });
  if (answer.hoop) {
    shape(context, ring(answer.hoop.wall_m), { fill: colors.hollow, edge: colors.metalEdge, width: 1 });
    dot(context, [x, y], outer * scale, { edge: colors.line, width: 1, dash: [4, 4] });
  }
  shape(context, ring(0), { edge, width: 1.5 });
  const surface = y - (outer - wall * film.dent(moment, 0)) * scale - film.gap(moment) * scale;
  paintBall(context, { x, surface, radius: ball.radius_m * scale, pressed: film.pressed(moment) * scale }, colors);
  context.font = `12px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  const words = answer.hoop ? `from the end; wall × ${Number(wall.toFixed(1))}` : "from the end; solid";
  haloText(context, words, x, height - 5, colors.muted, colors.panel);
}

// The points of a closed line around something, by their angle from the top.
const ringOf = (/** @type {(turn: number) => number[]} */ place) => Array.from({ length: SIDES }, (_, i) => place((2 * Math.PI * i) / SIDES));
