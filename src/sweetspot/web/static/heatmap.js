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
import { FONT, Surface, haloText, ticks } from "./surface.js";
import { fromShown, kindOf, toShown, unitOf } from "./units.js";
/** @import { Axis, Values } from "./chart.js" */
/** @import { App } from "./main.js" */
/** @import { Span, Zoom } from "./zoom.js" */

const HEAD = 22, FOOT = 34;
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
    /** @type {Drawn} */
    this.data = /** @type {any} */ (null); // until it is first drawn
    this.axis = x;
    this.surface = new Surface(app, { label, height: () => HEAD + height + FOOT, paint: (context, width) => this.paint(context, width) });
    this.element = this.surface.element;
    this.numbers = new Numbers("This map as a table", () => this.tabled());
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
    this.data = /** @type {any} */ (null);
    this.surface.draw();
  }

  /** @param {Drawn} data */
  draw(data) {
    this.data = data;
    this.surface.draw();
    this.numbers.redraw();
  }
  label(words) { this.surface.label(words); }
  figure(name) { return this.surface.figure(name); }

  // A row for each of some values upwards, a column for each of some across.
  tabled() {
    if (!this.data) return null;
    const { units } = this.app;
    const words = (axis, value) => shownPlace(axis, value, units).toFixed(kindOf(axis.kind)[units].digits).replace("-", "−");
    const places = (values, count) => evenly([...values.keys()], count);
    const { x, y, z } = this.data;
    const columns = places(x, 9).map((column) => [column, `${words(this.x, x[column])} ${unitOf(this.x.kind, units)}`]);
    return {
      caption: [this.title, unitOf(this.z.kind, units)].filter(Boolean).join(", "),
      columns: [`${this.y.label} (${unitOf(this.y.kind, units)}) ↓, ${this.x.label} →`, ...columns.map(([, name]) => name)],
      rows: places(y, 12).reverse().map((row) => [words(this.y, y[row]), ...columns.map(([column]) => {
        const value = z[row][column];
        return value === null ? "–" : toShown(this.z.kind, value, units).toFixed(kindOf(this.z.kind)[units].digits);
      })]),
    };
  }

  get range() { return this.zoom ? this.zoom.range : this.data.range ?? ends(this.data.x); }
  get height() { return this.data.heights ?? ends(this.data.y); }
  xAt(pixel) {
    const [low, high] = this.range;
    return low + Math.min(1, Math.max(0, (pixel - LEFT) / (this.surface.width - LEFT - RIGHT))) * (high - low);
  }
  yAt(pixel) {
    const [low, high] = this.height;
    return high - Math.min(1, Math.max(0, (pixel - HEAD) / this.tall)) * (high - low);
  }
  across(x) {
    const [low, high] = this.range;
    return LEFT + ((x - low) / (high - low)) * (this.surface.width - LEFT - RIGHT);
  }
  up(y) {
    const [low, high] = this.height;
    return HEAD + (1 - (y - low) / (high - low)) * this.tall;
  }

  paint(context, width) {
    if (!this.data) return;
    const { colors } = this.app;
    const values = this.data.z.flat().filter((value) => value !== null);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    context.save();
    context.beginPath();
    context.rect(LEFT, HEAD, width - LEFT - RIGHT, this.tall);
    context.clip();
    this.paintCells(context, least, most);
    if (this.lines) this.paintLines(context, least, most);
    if (this.data.outline) this.paintOutline(context);
    this.paintCross(context, colors);
    context.restore();
    this.paintSides(context, width, { least, most });
    paintAxis(context, this, (x) => this.across(x), HEAD + this.tall);
  }

  paintCells(context, least, most) {
    const { x, y, z } = this.data;
    const beside = (values, i) => values[i] ?? (i < 0 ? 2 * values[0] - values[1] : 2 * values.at(-1) - values.at(-2));
    const edges = (values, i) => [(beside(values, i - 1) + values[i]) / 2, (values[i] + beside(values, i + 1)) / 2];
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

  // Lines of equal value, found square by square, each with its number once.
  paintLines(context, least, most) {
    const { units, colors } = this.app;
    const shown = (value) => toShown(this.z.kind, value, units);
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
      if (!places.length) continue;
      const [x, y] = places[Math.floor(places.length / 3)];
      Object.assign(context, { font: `600 11px ${FONT}`, textAlign: "center", textBaseline: "middle" });
      haloText(context, String(level).replace("-", "−"), x, y, colors.ink, colors.panel);
    }
  }

  paintOutline(context) {
    Object.assign(context, { strokeStyle: this.app.colors.ink, lineWidth: 1.5 });
    context.beginPath();
    for (const [x, y] of this.data.outline ?? []) context.lineTo(this.across(x), this.up(y));
    context.closePath();
    context.stroke();
  }

  paintCross(context, colors) {
    if (!this.data.cross) return;
    const [x, y] = [this.across(this.data.cross[0]), this.up(this.data.cross[1])];
    for (const [color, width] of [[colors.paper, 4], [colors.ink, 1.6]]) {
      Object.assign(context, { strokeStyle: color, lineWidth: width });
      context.beginPath();
      context.arc(x, y, 8, 0, 2 * Math.PI);
      context.moveTo(x - 14, y);
      context.lineTo(x + 14, y);
      context.moveTo(x, y - 14);
      context.lineTo(x, y + 14);
      context.stroke();
    }
  }

  // The value at the pointer, or else at the cross; null outside.
  valueAt(x, y) {
    const near = (values, wanted) => values.reduce((best, value, i) => (Math.abs(value - wanted) < Math.abs(values[best] - wanted) ? i : best), 0);
    return this.data.z[near(this.data.y, y)][near(this.data.x, x)];
  }

  paintSides(context, width, { least, most }) {
    const { colors, units } = this.app;
    const text = (value) => this.app.text(this.z.kind, value);
    Object.assign(context, { font: `600 12px ${FONT}`, fillStyle: colors.ink, textAlign: "left", textBaseline: "alphabetic" });
    context.fillText(this.title, LEFT, HEAD - 6);
    const after = LEFT + context.measureText(this.title).width + 12;
    context.font = `11px ${FONT}`;
    context.textAlign = "right";
    const ends = `${text(least)} to ${text(most)}`;
    context.fillStyle = colors.muted;
    const bar = 60, right = width - RIGHT;
    const at = this.hover && this.hover.x > LEFT && this.hover.y > HEAD && this.hover.y < HEAD + this.tall ? [this.xAt(this.hover.x), this.yAt(this.hover.y)] : null;
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

// The pieces of the line z = level in a grid: [[x, y], [x, y]] each.
export function squares({ x, y, z }, level) {
  const found = [];
  for (let j = 0; j + 1 < y.length; j += 1) {
    for (let i = 0; i + 1 < x.length; i += 1) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      if (corners.some(([a, b]) => z[b][a] === null)) continue;
      const cuts = [];
      corners.forEach(([a, b], k) => {
        const [c, d] = corners[(k + 1) % 4];
        const [here, next] = [z[b][a] - level, z[d][c] - level];
        if (here < 0 === next < 0) return;
        const part = here / (here - next);
        cuts.push([x[a] + part * (x[c] - x[a]), y[b] + part * (y[d] - y[b])]);
      });
      for (let k = 0; k + 1 < cuts.length; k += 2) found.push([cuts[k], cuts[k + 1]]);
    }
  }
  return found;
}
