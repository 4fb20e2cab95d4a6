// Pictures of one moment of a film: the bat from the side, bending, and the barrel from its end, with the ball on it.

import { radiusAt } from "./batview.js";
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
  const line = film.line(moment, recoil).map((/** @type {any} */ moved) => moved * exaggeration * scale);
  const below = beneath(film, { exaggeration, recoil }) * scale;
  const middle = sideMiddle(film, width) - Math.max(0, Math.max(...line) + GRIP * scale - below); // the camera follows a bat that leaves
  const drop = (/** @type {number} */ x) => interpolated(places, line, x);
  paintRest(context, { across, middle, length: bat.length_m }, colors);
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
/**
 * @param {Film} film
 * @param {number} width
 */
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
/**
 * @param {Film} film
 * @param {{ exaggeration: number, recoil: boolean }} given
 */
function beneath(film, { exaggeration, recoil }) {
  return recoil ? Math.min(0.25, Math.max(0.09, (exaggeration * film.lowest + GRIP) / 2)) : 0.09;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ across: Way, middle: number, length: number }} given
 * @param {Colors} colors
 */
function paintRest(context, { across, middle, length }, colors) {
  context.strokeStyle = colors.line;
  context.lineWidth = 1;
  context.setLineDash([5, 5]);
  context.beginPath();
  context.moveTo(across(0) - 8, middle);
  context.lineTo(across(length) + 8, middle);
  context.stroke();
  context.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Film} film
 * @param {{ across: Way, middle: number, drop: Way, scale: number }} given
 * @param {Colors} colors
 */
function paintBody(context, film, { across, middle, drop, scale }, colors) {
  const { bat } = film;
  const stations = unionOf(bat.outline.position_m, film.places);
  const edges = stations.map((x) => [across(x), middle + drop(x), radiusAt(bat, x) * scale]);
  context.beginPath();
  for (const [x, y, radius] of edges) context.lineTo(x, y - radius);
  for (const [x, y, radius] of [...edges].reverse()) context.lineTo(x, y + radius);
  context.closePath();
  context.fillStyle = bat.hollow ? colors.metal : colors.wood;
  context.fill();
  context.strokeStyle = bat.hollow ? colors.metalEdge : colors.woodEdge;
  context.lineWidth = 1.3;
  context.lineJoin = "round";
  context.stroke();
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
  context.fillStyle = colors.red;
  for (let i = 0; i + 1 < film.places.length; i += 1) {
    const strength = Math.min(1, Math.abs(speeds[i] + speeds[i + 1]) / (2 * film.fastest));
    if (strength < 0.02) continue;
    context.globalAlpha = 0.85 * strength;
    const [a, b] = [film.places[i], film.places[i + 1]];
    const [ra, rb] = [radiusAt(film.bat, a) * scale, radiusAt(film.bat, b) * scale];
    context.beginPath();
    const [left, right] = [Math.round(across(a)), Math.round(across(b))]; // whole pixels: no seams
    context.moveTo(left, middle + drop(a) - ra);
    context.lineTo(right, middle + drop(b) - rb);
    context.lineTo(right, middle + drop(b) + rb);
    context.lineTo(left, middle + drop(a) + ra);
    context.closePath();
    context.fill();
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
  context.lineWidth = 3;
  context.strokeStyle = arrived ? colors.purple : colors.muted;
  for (const place of hands) {
    const [x, y, reach] = [across(place), middle + drop(place), radiusAt(film.bat, place) * scale + 7];
    const tilt = (drop(place + 0.03) - drop(place - 0.03)) / 2;
    for (const side of [-1, 1]) {
      context.beginPath();
      context.moveTo(x - 0.03 * scale, y - tilt + side * reach);
      context.lineTo(x + 0.03 * scale, y + tilt + side * reach);
      context.stroke();
    }
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
  context.beginPath();
  for (let i = 0; i <= SIDES; i += 1) context.lineTo(...outline((2 * Math.PI * i) / SIDES, waist, radius, near));
  context.closePath();
  context.fillStyle = colors.paper;
  context.fill();
  context.strokeStyle = colors.ink;
  context.lineWidth = 1.5;
  context.stroke();
  context.strokeStyle = colors.red;
  context.lineWidth = 1.3;
  for (const side of [-1, 1]) {
    context.beginPath();
    for (let i = 0; i <= 16; i += 1) {
      const height = -0.75 + (1.5 * i) / 16;
      const bulge = side * waist * (0.42 + 0.36 * height ** 2);
      context.lineTo(x + bulge, centre - height * (height > 0 ? radius : near));
    }
    context.stroke();
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
  const ring = (/** @type {number} */ inset) => {
    for (let i = 0; i <= SIDES; i += 1) {
      const angle = (2 * Math.PI * i) / SIDES;
      const reach = (outer - inset - wall * film.dent(moment, angle)) * scale;
      context.lineTo(x + reach * Math.sin(angle), y - reach * Math.cos(angle));
    }
    context.closePath();
  };
  context.beginPath();
  ring(0);
  context.fillStyle = bat.hollow ? colors.metal : colors.wood;
  context.fill();
  if (answer.hoop) {
    context.beginPath();
    ring(answer.hoop.wall_m);
    context.fillStyle = colors.hollow;
    context.fill();
    context.strokeStyle = colors.metalEdge;
    context.lineWidth = 1;
    context.stroke();
    context.setLineDash([4, 4]);
    context.beginPath();
    context.ellipse(x, y, outer * scale, outer * scale, 0, 0, 2 * Math.PI);
    context.strokeStyle = colors.line;
    context.stroke();
    context.setLineDash([]);
  }
  context.beginPath();
  ring(0);
  context.strokeStyle = bat.hollow ? colors.metalEdge : colors.woodEdge;
  context.lineWidth = 1.5;
  context.stroke();
  const surface = y - (outer - wall * film.dent(moment, 0)) * scale - film.gap(moment) * scale;
  paintBall(context, { x, surface, radius: ball.radius_m * scale, pressed: film.pressed(moment) * scale }, colors);
  context.font = `12px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  const words = answer.hoop ? `from the end; wall × ${Number(wall.toFixed(1))}` : "from the end; solid";
  haloText(context, words, x, height - 5, colors.muted, colors.panel);
}

/**
 * @param {number[]} places
 * @param {number[]} values
 * @param {number} x
 */
function interpolated(places, values, x) {
  const step = places[1] - places[0];
  const i = Math.min(places.length - 2, Math.max(0, Math.floor(x / step)));
  return values[i] + ((x - places[i]) / (places[i + 1] - places[i])) * (values[i + 1] - values[i]);
}

/**
 * @param {number[]} first
 * @param {number[]} second
 */
function unionOf(first, second) {
  return [...new Set([...first, ...second])].sort((a, b) => a - b);
}
