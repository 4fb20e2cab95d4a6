// A bat and a ball painted to scale: the bat alone, cut open, the ball beside it, and both as seen from the tip.

import { heat } from "../charts/heat.js";
import { dot, ink, line, shape } from "../charts/pen.js";
import { FONT, arrow } from "../charts/surface.js";
/** @import { BatPicture, BatShape, DrawnBore } from "../answers.js" */
/** @import { Look } from "../charts/pen.js" */
/** @import { Colors } from "../shell/main.js" */
/** @typedef {BatShape & Pick<BatPicture, "length_m"> & Partial<Pick<BatPicture, "balance_point_m">>} DrawnBat */
/** @typedef {{ position_m: number[], values: (number | null)[], least: number, most: number }} Warmth */
/** @typedef {{ position_m: number, radius_m: number, offset_m?: number, launch_angle_rad?: number | null }} DrawnBall */

/** @typedef {{ left: number, scale: number, middle: number, edge?: number }} Place where a bat is drawn: pixels, and pixels per m */
/** @typedef {(x: number) => number} Way from a value to a pixel */

export const WIDEST = 0.076; // m; room for the barrel and the ball is kept, so that the picture does not jump
const BESIDE = 16, ARROW = 34; // pixels of the meeting seen from the tip: beside it, and that its arrow reaches out of the ball

/**
 * @param {CanvasRenderingContext2D} context
 * @param {DrawnBall} ball
 * @param {DrawnBat} bat
 * @param {Place} place
 * @param {Colors} colors
 */
export function paintBall(context, ball, bat, place, colors) {
  const radius = ball.radius_m * place.scale;
  const x = place.left + ball.position_m * place.scale;
  const y = place.middle + radiusAt(bat, ball.position_m) * place.scale + radius;
  dot(context, [x, y], radius, { fill: colors.paper, edge: colors.ink, width: 1.5 });
  for (const side of [-1, 1]) {
    context.beginPath();
    context.arc(x + side * 1.45 * radius, y, radius, side < 0 ? -0.72 : Math.PI - 0.72, side < 0 ? 0.72 : Math.PI + 0.72);
    ink(context, { edge: colors.red, width: 1.2 });
  }
}

/** @param {DrawnBall} ball @param {DrawnBat} bat @param {Place} place */
function meetingSizes(ball, bat, place) {
  const scale = Math.min(0.45 * place.scale, 420);
  return { scale, own: radiusAt(bat, ball.position_m) * scale, its: ball.radius_m * scale };
}

// Pixels that the meeting seen from the tip takes across.
/** @param {DrawnBall} ball @param {DrawnBat} bat @param {Place} place */
export function meetingWide(ball, bat, place) {
  const { own, its } = meetingSizes(ball, bat, place);
  return BESIDE + 2 * (own + its) + ARROW + BESIDE / 2;
}

// Bat and ball as seen along the bat: how far off the axis they meet, and where the ball goes.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {DrawnBall} ball
 * @param {DrawnBat} bat
 * @param {Place} place
 * @param {Colors} colors
 * @param {string} words
 */
export function paintMeeting(context, ball, bat, place, colors, words) {
  const { scale, own, its } = meetingSizes(ball, bat, place);
  const x = (place.edge ?? 0) + own + BESIDE;
  const y = place.middle + (WIDEST / 2) * place.scale + own + 2 * its;
  const up = (ball.offset_m ?? 0) * scale;
  const across = Math.sqrt(Math.max(0, (own + its) ** 2 - up ** 2));
  dot(context, [x, y], own, looks(bat, colors));
  dot(context, [x + across, y - up], its, { fill: colors.paper, edge: colors.ink });
  if (ball.launch_angle_rad !== null && ball.launch_angle_rad !== undefined) {
    const [c, s] = [Math.cos(ball.launch_angle_rad), Math.sin(ball.launch_angle_rad)];
    const reach = its + ARROW;
    arrow(context, [x + across, y - up], [x + across + reach * c, y - up - reach * s], colors.red);
  }
  Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted, textAlign: "center", textBaseline: "top" });
  context.fillText(words, x + across / 2, y + Math.max(own, its) + 6);
}

/** @param {DrawnBat} bat @param {number} x */
export function radiusAt(bat, x) {
  const { position_m: places, diameter_m: widths } = bat.outline;
  let i = places.findIndex((/** @type {number} */ place) => place >= x);
  if (i < 0) i = places.length - 1;
  if (i === 0) return widths[0] / 2;
  const part = (x - places[i - 1]) / (places[i] - places[i - 1] || 1);
  return (widths[i - 1] + part * (widths[i] - widths[i - 1])) / 2;
}

// The outline of another bat, dashed over this one.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ outline: { position_m: number[], diameter_m: number[] } }} given
 * @param {{ left: number, scale: number, middle: number }} given
 * @param {string} color
 */
export function paintOutline(context, { outline: { position_m: places, diameter_m: widths } }, { left, scale, middle }, color) {
  for (const side of [-1, 1]) line(context, places.map((place, i) => [left + place * scale, middle + (side * widths[i] * scale) / 2]), color, 1.1, [4, 3]);
}

// The colours of a bat of its kind.
/** @param {{ hollow: boolean }} bat @param {Colors} colors @returns {Look} */
export const looks = ({ hollow }, colors) => (hollow ? { fill: colors.metal, edge: colors.metalEdge } : { fill: colors.wood, edge: colors.woodEdge });

// The outline of a body along x, y below the top, with a radius at every place: its upper edge, and back along its lower.
/** @param {number[][]} places  x, y and radius of each, in pixels */
export const around = (places) => [...places.map(([x, y, radius]) => [x, y - radius]), ...[...places].reverse().map(([x, y, radius]) => [x, y + radius])];

// The bat alone, cut open: wood, wall, holes, what fills them, and the cup.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {DrawnBat} bat
 * @param {{ left: number, scale: number, middle: number }} given
 * @param {Colors} colors
 * @param {Warmth | null} [warm]
 */
export function paintBat(context, bat, { left, scale, middle }, colors, warm = null) {
  const { position_m: places, diameter_m: widths } = bat.outline;
  const points = places.map((place, i) => [left + place * scale, middle, (widths[i] / 2) * scale]);
  const { fill, edge } = looks(bat, colors);
  shape(context, around(points), { fill });
  if (bat.hollow) shape(context, around(points.map(([x, y, radius], i) => [x, y, Math.max(0, radius - (bat.wall_m?.[i] ?? 0) * scale)])), { fill: colors.hollow });
  if (warm) {
    context.globalAlpha = 0.82;
    paintHeat(context, bat, { left, scale, middle }, warm);
    context.globalAlpha = 1;
  }
  for (const bore of bat.bores) paintBore(context, bore, { left, scale, middle }, colors);
  paintCup(context, bat, { left, scale, middle }, colors);
  shape(context, around(points), { edge });
  for (const weight of bat.weights) {
    context.fillStyle = colors.ink;
    context.fillRect(left + weight.position_m * scale - 4, middle - 4, 8, 8);
  }
}

// Colours on the bat for a quantity along it: { position_m, values, least, most }.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {DrawnBat} bat
 * @param {{ left: number, scale: number, middle: number }} given
 * @param {Warmth} given
 */
export function paintHeat(context, bat, { left, scale, middle }, { position_m: places, values, least, most }) {
  for (let i = 0; i + 1 < places.length; i += 1) {
    const [here, next] = [values[i], values[i + 1]];
    if (here === null || next === null) continue;
    const [a, b] = [Math.round(left + places[i] * scale), Math.round(left + places[i + 1] * scale)];
    if (b <= a) continue;
    const [ra, rb] = [radiusAt(bat, places[i]) * scale, radiusAt(bat, places[i + 1]) * scale];
    shape(context, around([[a, middle, ra], [b, middle, rb]]), { fill: heat(((here + next) / 2 - least) / (most - least || 1)) });
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {DrawnBore} bore
 * @param {{ left: number, scale: number, middle: number }} given
 * @param {Colors} colors
 */
function paintBore(context, bore, { left, scale, middle }, colors) {
  const [x, y] = [left + bore.start_m * scale, middle - (bore.diameter_m / 2) * scale];
  const [width, height] = [(bore.stop_m - bore.start_m) * scale, bore.diameter_m * scale];
  context.fillStyle = colors.hollow;
  context.fillRect(x, y, width, height);
  if (bore.fill) {
    context.save();
    context.globalAlpha = 0.5;
    context.fillStyle = colors.orange;
    context.fillRect(x, y, width, height);
    context.restore();
  }
  shape(context, [[x, y], [x + width, y], [x + width, y + height], [x, y + height]], { edge: colors.woodEdge, width: 1, dash: [3, 2] });
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {DrawnBat} bat
 * @param {{ left: number, scale: number, middle: number }} given
 * @param {Colors} colors
 */
function paintCup(context, bat, { left, scale, middle }, colors) {
  if (!bat.cup) return;
  const tip = left + bat.length_m * scale;
  const [radius, depth] = [(bat.cup.diameter_m / 2) * scale, bat.cup.depth_m * scale];
  shape(context, Array.from({ length: 21 }, (_, i) => [tip - depth * (1 - (i / 10 - 1) ** 2), middle + radius * (i / 10 - 1)]), { fill: colors.panel, edge: colors.woodEdge, width: 1 });
}

/** @param {number[]} places @param {number[]} values @param {number} x */
export function between(places, values, x) {
  const step = places[1] - places[0];
  const i = Math.min(places.length - 2, Math.max(0, Math.floor(x / step + 1e-9)));
  return values[i] + ((x - places[i]) / (places[i + 1] - places[i])) * (values[i + 1] - values[i]);
}
