// A map of a quantity over two others: colours, lines of equal value with their numbers, and a cross that can be dragged.
//
//   const map = new HeatMap(app, {
//     label, height: 170, title: "Exit speed", zoom,                       // zoom: optional, shared with charts
//     x: { kind: "position_m", from: () => length, label: "from the tip" }, // from: optional, as in chart.js
//     y: { kind: "offset_m", label: "ball above the axis" },
//     z: { kind: "exit_speed_m_s" },
//     lines: true,                                                         // of equal value; optional
//     onPick(x, y, { last }) {},
//   });
//   map.draw({ x: [...], y: [...], z: [[...] per y], cross: [x, y], outline: [[x, y], ...],
//              range: [0, 0.84], heights: [-0.05, 0.05] });              // what is shown; optional: from first to last
//
// Missing values are null and stay blank. All values are SI.

import { LEFT, RIGHT } from "./chart.js";
import { paintAxis, shownPlace } from "./chartpaint.js";
import { heat } from "./heat.js";
import { Numbers, evenly } from "./numbers.js";
import { dot, line, shape } from "./pen.js";
import { isGrid, smoothed } from "./smooth.js";
import { FONT, Surface, haloText, ticks } from "./surface.js";
import { fromShown, grouped, kindOf, toShown, unitOf } from "../controls/units.js";
/** @import { Axis, Values } from "./chart.js" */
/** @import { App } from "../shell/main.js" */
/** @import { Span, Zoom } from "./zoom.js" */

const HEAD = 22, FOOT = 34;
const APART = 3, TALL = 15; // pixels around numbers on lines, and of their rows
const NARROW = 48; // pixels that a column of the map's table needs
const CROSS = /** @type {[string, number][]} */ ([["white", 5], ["black", 2]]); // as dark on every colour of the map, whatever the theme
/** @param {number[]} values @returns {Span} */
const ends = (values) => [values[0], values[values.length - 1]];

/** @typedef {{ x: number[], y: number[], z: Values[], cross?: number[], outline?: number[][], range?: Span, heights?: Span }} Drawn */

export class HeatMap {
  /**
   * @param {App} app
   * @param {{ label: string, title: string, height: number, x: Axis, y: Axis, z: { kind: string }, zoom?: Zoom | null, lines?: boolean, onPick?: ((x: number, y: number, on: { last: boolean }) => void) | null }} look
   */
  constructor(app, { label, title, height, x, y, z, zoom = null, lines = true, onPick = null }) {
    this.app = app;
    this.title = title;
    this.tall = height;
    this.x = x;
    this.y = y;
    this.z = z;
    this.zoom = zoom;
    this.lines = lines;
    this.data = /** @type {Drawn} */ (/** @type {unknown} */ (null)); // until it is first drawn
    this.axis = x;
    this.ends = { least: 0, most: 1 }; // of the values
    this.surface = new Surface(app, { label, height: () => HEAD + height + FOOT, paint: (context, width) => this.paint(context, width) });
    this.element = this.surface.element;
    this.numbers = new Numbers(app, "This map as a table", () => this.tabled());
    if (zoom) zoom.listen(this.surface, (pixel) => this.xAt(pixel));
    this.hover = null;
    this.surface.hovers((at) => {
      this.hover = at;
      if (this.data) this.surface.draw();
    });
    if (!onPick) return;
    this.element.style.cursor = "crosshair";
    this.surface.drags(({ x: across, y: down, last }) => this.data && onPick(this.xAt(across), this.yAt(down), { last }));
  }

  clear() {
    this.data = /** @type {Drawn} */ (/** @type {unknown} */ (null));
    this.surface.draw();
  }

  /** @param {Drawn} data */
  draw(data) {
    const other = data.z !== this.data?.z || this.units !== this.app.units;
    this.data = data;
    this.units = this.app.units;
    this.surface.draw();
    if (other) this.numbers.redraw();
  }
  /** @param {string} words */
  label(words) { this.surface.label(words); }
  /** @param {string} name */
  figure(name) { return this.surface.figure(name); }

  // A row for each of some values upwards, a column for each of some across; of counts all are there, added up.
  tabled() {
    if (!this.data) return null;
    const { units } = this.app;
    const words = (/** @type {Axis} */ axis, /** @type {number} */ value) => grouped(shownPlace(axis, value, units).toFixed(kindOf(axis.kind)[units].digits)).replace(/^-(0(\.0*)?)$/, "$1").replace("-", "−");
    const named = (/** @type {Axis} */ axis) => `${axis.label} (${unitOf(axis.kind, units)})`;
    const { x, y, z } = this.data;
    const counted = this.z.kind === "count";
    const boxes = (/** @type {Axis} */ axis, /** @type {number[]} */ values, /** @type {number} */ count) => counted
      ? runs(values.length, count).map((run) => ({ run, name: (axis.from ? edgesOf(values, run).reverse() : edgesOf(values, run)).map((edge) => words(axis, edge)).join(" to ") }))
      : evenly([...values.keys()], count).map((one) => ({ run: [one], name: words(axis, values[one]) }));
    const columns = boxes(this.x, x, counted ? 6 : 9);
    return {
      caption: [this.title, unitOf(this.z.kind, units)].filter(Boolean).join(", "),
      columns: [`${named(this.y)} ↓, ${named(this.x)} →`, ...columns.map(({ name }) => name)],
      column: NARROW,
      rows: boxes(this.y, y, 12).reverse().map((row) => [row.name, ...columns.map((column) => {
        const values = row.run.flatMap((j) => column.run.map((i) => z[j][i])).filter((value) => value !== null);
        const value = values.reduce((sum, one) => sum + one, 0);
        return values.length ? grouped(toShown(this.z.kind, value, units).toFixed(kindOf(this.z.kind)[units].digits)) : "–";
      })]),
    };
  }

  get range() { return this.zoom ? this.zoom.range : this.data.range ?? ends(this.data.x); }
  get height() { return this.data.heights ?? ends(this.data.y); }
  /** @param {number} pixel */
  xAt(pixel) {
    const [low, high] = this.range;
    return low + Math.min(1, Math.max(0, (pixel - LEFT) / (this.surface.width - LEFT - RIGHT))) * (high - low);
  }
  /** @param {number} pixel */
  yAt(pixel) {
    const [low, high] = this.height;
    return high - Math.min(1, Math.max(0, (pixel - HEAD) / this.tall)) * (high - low);
  }
  /** @param {number} x */
  across(x) {
    const [low, high] = this.range;
    return LEFT + ((x - low) / (high - low)) * (this.surface.width - LEFT - RIGHT);
  }
  /** @param {number} y */
  up(y) {
    const [low, high] = this.height;
    return HEAD + (1 - (y - low) / (high - low)) * this.tall;
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width */
  paint(context, width) {
    if (!this.data) return;
    const inside = (/** @type {CanvasRenderingContext2D} */ surface, /** @type {(() => void)[]} */ ...parts) => {
      surface.save();
      surface.beginPath();
      surface.rect(LEFT, HEAD, width - LEFT - RIGHT, this.tall);
      surface.clip();
      for (const part of parts) part();
      surface.restore();
    };
    const { data, app: { colors, units }, range, height } = this;
    this.surface.layer(context, [data.z, data.x, data.y, data.outline, colors, units, ...range, ...height], (ground) => {
      const values = data.z.flat().filter((value) => value !== null);
      this.ends = { least: Math.min(...values), most: Math.max(...values) };
      inside(ground, () => this.paintCells(ground, this.ends), () => this.lines && this.paintLines(ground, this.ends), () => data.outline && this.paintOutline(ground));
    });
    inside(context, () => this.paintCross(context));
    this.paintSides(context, width, this.ends);
    paintAxis(context, this, (/** @type {number} */ x) => this.across(x), HEAD + this.tall);
  }

  /** @param {CanvasRenderingContext2D} context @param {{ least: number, most: number }} given */
  paintCells(context, { least, most }) {
    const { x, y, z } = this.data;
    if (this.z.kind !== "count" && context instanceof CanvasRenderingContext2D && isGrid(x, y)) return this.paintSmooth(context, least, most);
    const beside = (/** @type {number[]} */ values, /** @type {number} */ i) => values[i] ?? (i < 0 ? 2 * values[0] - values[1] : 2 * values[values.length - 1] - values[values.length - 2]);
    const edges = (/** @type {number[]} */ values, /** @type {number} */ i) => [(beside(values, i - 1) + values[i]) / 2, (values[i] + beside(values, i + 1)) / 2];
    y.forEach((one, row) => {
      const [below, above] = edges(y, row).map((value) => Math.round(this.up(value)));
      x.forEach((_, column) => {
        const value = z[row][column];
        if (value === null) return;
        const [left, right] = edges(x, column).map((place) => Math.round(this.across(place)));
        context.fillStyle = heat((value - least) / (most - least || 1));
        context.fillRect(left, above, Math.max(1, right - left), Math.max(1, below - above));
      });
    });
  }

  /** @param {CanvasRenderingContext2D} context @param {number} least @param {number} most */
  paintSmooth(context, least, most) {
    const { x, y, z } = this.data;
    const picture = smoothed(z, least, most), [wide, high] = [(x[1] - x[0]) / 2, (y[1] - y[0]) / 2];
    const whole = Object.assign(document.createElement("canvas"), { width: picture.width, height: picture.height });
    whole.getContext("2d")?.putImageData(picture, 0, 0);
    const [left, right] = [this.across(x[0] - wide), this.across(x[x.length - 1] + wide)], [top, bottom] = [this.up(y[y.length - 1] + high), this.up(y[0] - high)];
    context.imageSmoothingEnabled = true;
    context.drawImage(whole, left, top, right - left, bottom - top);
  }

  // Lines of equal value, found square by square, each with its number once, where it lies on no other number.
  /** @param {CanvasRenderingContext2D} context @param {{ least: number, most: number }} given */
  paintLines(context, { least, most }) {
    const { units, colors } = this.app;
    const shown = (/** @type {number} */ value) => toShown(this.z.kind, value, units);
    /** @type {number[][]} */
    const taken = []; // middles and half widths of numbers
    Object.assign(context, { font: `600 11px ${FONT}`, textAlign: "center", textBaseline: "middle" });
    for (const level of ticks(shown(least), shown(most), 6)) {
      const pieces = squares(this.data, fromShown(this.z.kind, level, units));
      Object.assign(context, { strokeStyle: colors.paper, lineWidth: 1 });
      context.beginPath();
      for (const [from, to] of pieces) {
        context.moveTo(this.across(from[0]), this.up(from[1]));
        context.lineTo(this.across(to[0]), this.up(to[1]));
      }
      context.stroke();
      const places = pieces.map(([[x, y]]) => [this.across(x), this.up(y)]).filter(([x, y]) => x > LEFT + 20 && x < this.surface.width - RIGHT - 20 && y > HEAD + 9 && y < HEAD + this.tall - 9);
      const words = String(level).replace("-", "−"), half = context.measureText(words).width / 2 + APART;
      const first = Math.floor(places.length / 3);
      const free = [...places.slice(first), ...places.slice(0, first)].find(([x, y]) => taken.every(([a, b, other]) => Math.abs(x - a) > half + other || Math.abs(y - b) > TALL));
      if (!free) continue;
      taken.push([...free, half]);
      haloText(context, words, free[0], free[1], colors.ink, colors.panel);
    }
  }

  /** @param {CanvasRenderingContext2D} context */
  paintOutline(context) {
    shape(context, (this.data.outline ?? []).map(([x, y]) => [this.across(x), this.up(y)]), { edge: this.app.colors.ink, width: 1.5 });
  }

  /** @param {CanvasRenderingContext2D} context */
  paintCross(context) {
    if (!this.data.cross) return;
    const [x, y] = [this.across(this.data.cross[0]), this.up(this.data.cross[1])];
    for (const [color, width] of CROSS) {
      dot(context, [x, y], 8, { edge: color, width });
      line(context, [[x - 14, y], [x + 14, y]], color, width);
      line(context, [[x, y - 14], [x, y + 14]], color, width);
    }
  }

  // The value at the pointer, or else at the cross; null outside.
  /** @param {number} x @param {number} y */
  valueAt(x, y) {
    const near = (/** @type {number[]} */ values, /** @type {number} */ wanted) => values.reduce((best, value, i) => (Math.abs(value - wanted) < Math.abs(values[best] - wanted) ? i : best), 0);
    return this.data.z[near(this.data.y, y)][near(this.data.x, x)];
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   * @param {{ least: number, most: number }} given
   */
  paintSides(context, width, { least, most }) {
    const { colors, units } = this.app;
    const text = (/** @type {number} */ value) => this.app.text(this.z.kind, value);
    Object.assign(context, { font: `600 12px ${FONT}`, fillStyle: colors.ink, textAlign: "left", textBaseline: "alphabetic" });
    context.fillText(this.title, LEFT, HEAD - 6);
    const after = LEFT + context.measureText(this.title).width + 12;
    context.font = `11px ${FONT}`;
    context.textAlign = "right";
    const ends = `${text(least)} to ${text(most)}`;
    context.fillStyle = colors.muted;
    const bar = 60, right = width - RIGHT;
    const at = this.hover && this.hover.x > LEFT && this.hover.y > HEAD && this.hover.y < HEAD + this.tall ? /** @type {[number, number]} */ ([this.xAt(this.hover.x), this.yAt(this.hover.y)]) : null;
    if (at) {
      const value = this.valueAt(...at);
      const place = `${shownPlace(this.x, at[0], units).toFixed(1)} ${unitOf(this.x.kind, units)}, ${this.app.text(this.y.kind, at[1])}: ${value === null ? "–" : text(value)}`;
      context.fillText(place, right, HEAD - 6);
    } else if (after + context.measureText(ends).width + bar + 20 < right) {
      context.fillText(ends, right, HEAD - 6);
      const start = right - context.measureText(ends).width - bar - 8;
      for (let i = 0; i < bar; i += 1) {
        context.fillStyle = heat(i / (bar - 1));
        context.fillRect(start + i, HEAD - 15, 1.5, 10);
      }
    }
    const [low, high] = this.height.map((value) => toShown(this.y.kind, value, units));
    Object.assign(context, { textAlign: "right", textBaseline: "middle", fillStyle: colors.muted });
    for (const value of ticks(Math.min(low, high), Math.max(low, high), this.tall / 34)) {
      context.fillText(String(value).replace("-", "−"), LEFT - 6, this.up(fromShown(this.y.kind, value, units)));
    }
    Object.assign(context, { textAlign: "left", textBaseline: "top" });
    context.fillText(`↑ ${[unitOf(this.y.kind, units), this.y.label].filter(Boolean).join(" ")}`, LEFT, HEAD + this.tall + 19);
  }
}

// The places of a list in about so many runs, each as long as the others but the last.
/** @param {number} length @param {number} count */
function runs(length, count) {
  const long = Math.ceil(length / count);
  return Array.from({ length: Math.ceil(length / long) }, (_, k) => Array.from({ length: Math.min(long, length - k * long) }, (_, i) => k * long + i));
}

// Where a run of even boxes begins and ends, of which the values are the middles.
/** @param {number[]} values @param {number[]} run */
function edgesOf(values, run) {
  const half = (values[1] - values[0]) / 2;
  return [values[run[0]] - half, values[run[run.length - 1]] + half];
}

// The pieces of the line z = level in a grid: [[x, y], [x, y]] each.
/** @param {{ x: number[], y: number[], z: Values[] }} given @param {number} level */
export function squares({ x, y, z }, level) {
  const found = [];
  for (let j = 0; j + 1 < y.length; j += 1) {
    for (let i = 0; i + 1 < x.length; i += 1) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      if (corners.some(([a, b]) => z[b][a] === null)) continue;
      /** @type {number[][]} */
      const cuts = [];
      corners.forEach(([a, b], k) => {
        const [c, d] = corners[(k + 1) % 4];
        const [here, next] = [(z[b][a] ?? 0) - level, (z[d][c] ?? 0) - level];
        if (here < 0 === next < 0) return;
        const part = here / (here - next);
        cuts.push([x[a] + part * (x[c] - x[a]), y[b] + part * (y[d] - y[b])]);
      });
      for (let k = 0; k + 1 < cuts.length; k += 2) found.push([cuts[k], cuts[k + 1]]);
    }
  }
  return found;
}
