// What charts are painted with: grids, lines, areas, points and axes; and their numbers in the reader's units.

import { dot, line, shape } from "./pen.js";
import { FONT, haloText, ticks } from "./surface.js";
import { grouped, kindOf, toShown, unitOf } from "../controls/units.js";
/** @import { App, Colors } from "../shell/main.js" */
/** @import { Axis, Curve, Measured, Panel, Published, Values } from "./chart.js" */
/** @import { System } from "../controls/units.js" */
/** @import { Span } from "./zoom.js" */
/** @import { Way } from "../bat/batpaint.js" */

const EDGE = 12; // pixels beside the last place of an axis that its number may take

/** @typedef {{ left: number, right: number, top: number, bottom: number, head: number, rows: Curve[][] }} Box where a panel is painted, in pixels */
/**
 * What is shown of a panel's lines, in the reader's units.
 * @typedef {object} Plotted
 * @property {number[][]} xs
 * @property {Values[]} shown
 * @property {(Values[] | undefined)[]} [bands]
 * @property {(Measured | { x: number, y?: null, low?: number | null, high?: number | null })[][]} [points]
 * @property {Span} [range]
 */

/** @param {{ kind: string }} given @param {Values | undefined} values @param {System} units */
export function shownValues({ kind }, values, units) {
  return (values ?? []).map((value) => (value === null ? null : toShown(kind, value, units)));
}

/** @param {Axis} axis @param {number} x @param {System} units @returns {number} */
export function shownPlace({ kind, from }, x, units) {
  return toShown(kind, from ? from() - x : x, units);
}

/** @param {Axis} axis @param {System} units */
function axisWords({ kind, label }, units) {
  return [unitOf(kind, units), label].filter(Boolean).join(" ");
}

// Each line on top of the one before; nothing where both are unknown.
/** @param {Values[]} lines */
export function stack(lines) {
  for (let i = 1; i < lines.length; i += 1) {
    lines[i] = lines[i].map((value, j) => (value === null && lines[i - 1][j] === null ? null : (value ?? 0) + (lines[i - 1][j] ?? 0)));
  }
}

// Stretches of neighbours that are known: [first, last] each.
/** @param {Values} values */
export function stretches(values) {
  /** @type {[number, number][]} */
  const found = [];
  values.forEach((value, i) => {
    if (value === null || value === undefined) return;
    const last = found.at(-1);
    if (last && last[1] === i - 1) last[1] = i;
    else found.push([i, i]);
  });
  return found;
}

// Least and most of what is shown of a panel within the range of its axis.
/** @param {Plotted} given @param {Panel} panel */
export function limits({ xs, shown, bands = [], points = [], range = [-Infinity, Infinity] }, panel) {
  let [low, high] = [Infinity, -Infinity];
  const take = (/** @type {number | null | undefined} */ value) => {
    if (value !== null && value !== undefined) [low, high] = [Math.min(low, value), Math.max(high, value)];
  };
  const margin = 1e-9 + 0.02 * (range[1] - range[0]);
  const seen = (/** @type {number} */ x) => x >= range[0] - margin && x <= range[1] + margin;
  shown.forEach((values, i) => {
    for (const each of [values, ...(bands[i] ?? [])]) each.forEach((value, j) => seen(xs[i][j]) && take(value));
    for (const point of points[i] ?? []) if (seen(point.x)) for (const value of [point.y, point.low, point.high]) take(value);
  });
  if (!(high >= low)) return panel.empty ?? [0, 1];
  if (panel.zero || panel.stacked) [low, high] = [Math.min(0, low), Math.max(0, high)];
  const room = 0.06 * (high - low || Math.abs(high) || 1);
  return [low === 0 ? 0 : low - room, high === 0 ? 0 : high + room];
}

// As many as there is room for, but at least two: one number alone is no scale.
/** @param {number} low @param {number} high @param {number} room */
function scaleTicks(low, high, room) {
  for (let count = Math.max(2, room); ; count *= 2) {
    const found = ticks(low, high, count);
    if (found.length > 1 || count > 16) return found;
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Colors} colors
 * @param {Box} box
 * @param {number} low
 * @param {number} high
 * @param {Way} up
 */
export function paintGrid(context, colors, box, low, high, up) {
  Object.assign(context, { font: `11px ${FONT}`, textAlign: "right", textBaseline: "middle" });
  for (const value of scaleTicks(low, high, (box.bottom - box.top) / 28)) {
    const y = Math.round(up(value)) + 0.5;
    line(context, [[box.left, y], [box.right, y]], colors.grid);
    context.fillStyle = colors.muted;
    context.fillText(grouped(value).replace("-", "−"), box.left - 6, y);
  }
  if (low < 0 && high > 0) line(context, [box.left, box.right].map((x) => [x, Math.round(up(0)) + 0.5]), colors.line);
}

// An area between two curves over the same places.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {number[]} xs
 * @param {Values} above
 * @param {Values} below
 * @param {Way} across
 * @param {Way} up
 * @param {string} color
 * @param {number} alpha
 */
export function paintArea(context, xs, above, below, across, up, color, alpha) {
  const known = xs.map((_, i) => i).filter((i) => typeof above[i] === "number" && typeof below[i] === "number");
  if (known.length < 2) return;
  context.globalAlpha = alpha;
  shape(context, [...known.map((i) => [across(xs[i]), up(above[i] ?? 0)]), ...[...known].reverse().map((i) => [across(xs[i]), up(below[i] ?? 0)])], { fill: color });
  context.globalAlpha = 1;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Curve} curve
 * @param {number[]} xs
 * @param {Values} values
 * @param {{ across: Way, up: Way, colors: Colors, area?: { below: Values | null, low: number } | null }} given
 */
export function paintLine(context, curve, xs, values, { across, up, colors, area }) {
  const filled = area || curve.fill;
  context.beginPath();
  for (const [first, last] of stretches(values)) {
    context.moveTo(across(xs[first]), up(values[first] ?? 0));
    for (let i = first + 1; i <= last; i += 1) context.lineTo(across(xs[i]), up(values[i] ?? 0));
    if (!filled) continue;
    for (let i = last; i >= first; i -= 1) context.lineTo(across(xs[i]), up(area?.below?.[i] ?? 0));
    context.closePath();
  }
  if (filled) {
    context.fillStyle = colors[curve.color];
    context.globalAlpha = area ? 0.85 : 0.25;
    context.fill();
    context.globalAlpha = 1;
    if (area) return;
  }
  Object.assign(context, { strokeStyle: colors[curve.color], lineWidth: curve.width ?? 2, lineJoin: "round" });
  context.setLineDash(curve.dash ?? []);
  context.stroke();
  context.setLineDash([]);
}

// Values that somebody measured or published, with their interval where one is known.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {Measured[]} points
 * @param {Way} across
 * @param {Way} up
 * @param {string} color
 * @param {string} ground
 */
export function paintPoints(context, points, across, up, color, ground) {
  for (const { x, y, low, high } of points) {
    if (typeof low === "number" && typeof high === "number") line(context, [[across(x), up(low)], [across(x), up(high)]], color, 1.6);
    if (typeof y === "number") dot(context, [across(x), up(y)], 4, { fill: ground, edge: color, width: 1.6 });
  }
}

const NEAR = 7; // pixels from a published mark at which the pointer is on it

// Published numbers: a stretch as a bar with ends at the panel's foot, values as one across the curve, each with a
// diamond; the one at the pointer says what it is.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {Published[]} marks
 * @param {{ box: Box, across: Way, up: Way, colors: Colors, hover: number | null, width: number }} given
 */
export function paintPublished(context, marks, { box, across, up, colors, hover, width }) {
  let foot = box.bottom - 6;
  /** @type {{ label: string, x: number, y: number, reach: number } | null} */
  let told = null;
  for (const mark of marks) {
    const upright = typeof mark.low === "number";
    const [low, high] = [up(mark.low ?? 0), up(mark.high ?? 0)];
    const [x, y] = [(across(mark.from) + across(mark.to)) / 2, upright ? (low + high) / 2 : foot];
    const half = upright ? Math.abs(high - low) / 2 : (across(mark.to) - across(mark.from)) / 2;
    const [dx, dy] = upright ? [0, half] : [half, 0], [wide, tall] = upright ? [4, 0] : [0, 4];
    line(context, [[x - dx, y - dy], [x + dx, y + dy]], colors.ink, 1.4);
    for (const side of [-1, 1]) line(context, [-1, 1].map((end) => [x + side * dx + end * wide, y + side * dy + end * tall]), colors.ink, 1.4);
    shape(context, [[x - 5, y], [x, y - 5], [x + 5, y], [x, y + 5]], { fill: colors.panel, edge: colors.ink, width: 1.4 });
    const reach = upright ? NEAR : Math.max(NEAR, half + NEAR);
    if (hover !== null && Math.abs(across(hover) - x) <= reach && (!told || reach < told.reach)) told = { label: mark.label, x, y: upright ? box.top + 10 : y - 14, reach };
    if (!upright) foot -= 12;
  }
  if (!told) return;
  Object.assign(context, { font: `11px ${FONT}`, textBaseline: "middle" });
  const room = Math.min(context.measureText(told.label).width, box.right - box.left);
  context.textAlign = "left";
  haloText(context, told.label, Math.max(box.left + 2, Math.min(told.x - room / 2, Math.min(box.right, width) - room - 2)), told.y, colors.ink, colors.panel);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ app: App, axis: Axis, range: Span }} given
 * @param {Way} across
 * @param {number} top
 */
export function paintAxis(context, { app: { colors, units }, axis, range }, across, top) {
  const [least, most] = range;
  const from = axis.from?.() ?? 0;
  const { scale, offset = 0 } = kindOf(axis.kind)[units];
  const real = (/** @type {number} */ value) => (axis.from ? from - (value - offset) / scale : (value - offset) / scale);
  const [low, high] = [shownPlace(axis, least, units), shownPlace(axis, most, units)].sort((a, b) => a - b);
  Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted, textAlign: "center", textBaseline: "top" });
  for (const value of ticks(low, high, (across(most) - across(least)) / 60)) {
    const x = across(real(value));
    line(context, [[x, top], [x, top + 4]], colors.line);
    const words = grouped(value).replace("-", "−");
    context.fillText(words, Math.min(x, across(most) + EDGE - context.measureText(words).width / 2), top + 6);
  }
  context.textAlign = "right";
  context.fillText(axisWords(axis, units), across(most), top + 19);
}

// Paint no farther than a panel's box.
/** @param {CanvasRenderingContext2D} context @param {Box} box @param {() => void} paint */
export function within(context, box, paint) {
  context.save();
  context.beginPath();
  context.rect(box.left, box.top - 1, box.right - box.left, box.bottom - box.top + 2);
  context.clip();
  paint();
  context.restore();
}

// The value of a curve at x, straight between points; null outside.
/** @param {number[]} xs @param {Values} values @param {number} x */
export function between(xs, values, x) {
  if (!xs.length || x < xs[0] || x > xs[xs.length - 1]) return null;
  let [low, high] = [0, xs.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  const [first, second] = [values[low], values[high]];
  if (first === null || second === null || first === undefined) return null;
  const span = xs[high] - xs[low];
  return span > 0 ? first + ((x - xs[low]) / span) * (second - first) : first;
}
