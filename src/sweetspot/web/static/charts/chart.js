// Line charts in panels one below the other on one shared axis, with values at the pointer, zoom, and a table.
//
//   const chart = new Chart(app, {
//     label: "what it shows",
//     panels: [{ title: "Exit speed", kind: "exit_speed_m_s", height: 110, zero: false, term: "exit speed",
//                lines: [{ key: "exit_speed_m_s", label: "flexible", color: "red", dash: [], width: 2, fill: false,
//                          band: ["low_key", "high_key"] }] }],          // band: optional, an interval around the line
//     axis: { kind: "position_m", from: () => length, label: "from the tip" },   // from: ticks count from there; optional
//     onPick(x, { last }) {},          // optional: pressed or dragged at x
//     zoom: new Zoom(...),             // optional: one that pictures share; otherwise the chart's own
//   });
//   root.append(chart.element);
//   chart.draw({ x: [...], lines: { exit_speed_m_s: [...] }, range: [0, 0.84], bands: [{ from, to }],
//                marks: [{ at, color, label }], points: { exit_speed_m_s: [{ x, y, low, high, label }] }, cursor: 0.68 });
//
// A panel with stacked: true adds its lines up, as areas; empty: [least, most] is its range while it has no values. kind is a name with a unit (units.js): values come in SI and
// are shown in the chosen system. color names a colour of the theme. Missing values are null. The margins LEFT and RIGHT
// are the same for every chart and for the bat above it.

import { between, paintArea, paintAxis, paintGrid, paintLine, paintPoints, paintPublished, shownPlace, shownValues, within } from "./chartpaint.js";
import { panelsOf } from "./chartpanels.js";
import { paintNames, paintSample, rowsOfNames, ROW } from "./legend.js";
import { Numbers } from "./numbers.js";
import { make } from "../controls/parts.js";
import { dot, line } from "./pen.js";
import { Surface, FONT, haloText } from "./surface.js";
import { grouped, kindOf, unitOf } from "../controls/units.js";
import { Zoom } from "./zoom.js";
/** @import { App } from "../shell/main.js" */
/** @import { Span } from "./zoom.js" */
/** @import { Way } from "../bat/batpaint.js" */
/** @import { Box } from "./chartpaint.js" */
/** @import { Placed } from "./chartpanels.js" */

export { between };
export const LEFT = 46, RIGHT = 12;
const HEAD = 22, FOOT = 34, GAP = 8;
const ROWS = 24; // of the table

/** @typedef {(number | null)[]} Values */
/** @typedef {{ key: string, color: string, label?: string, name?: string, dash?: number[], width?: number, fill?: boolean, silent?: boolean, band?: string[] }} Curve */
/** @typedef {{ title: string, kind: string, height: number, lines: Curve[], zero?: boolean, stacked?: boolean, empty?: number[], term?: string }} Panel */
/** @typedef {{ kind: string, label: string, from?: () => number }} Axis */
/** @typedef {{ at: number, color: string, label?: string }} Mark */
/** @typedef {{ from: number, to: number, low?: number | null, high?: number | null, label: string }} Published a stretch of the axis, or values around one place */
/** @typedef {{ x: number, y: number | null, low?: number | null, high?: number | null, label?: string }} Measured */
/**
 * What a chart shows; xs are places of curves that have their own.
 * @typedef {object} Shown
 * @property {number[]} x
 * @property {Record<string, number[]>} [xs]
 * @property {Record<string, Values>} lines
 * @property {Span} range
 * @property {Span} [usual]
 * @property {boolean} [fixed]
 * @property {{ from: number, to: number }[]} [bands]
 * @property {Mark[]} [marks]
 * @property {Record<string, Measured[]>} [points]
 * @property {Record<string, Published[]>} [published]  beside which curve, by its key
 * @property {number | null} [cursor]
 * @property {Record<string, number | null | undefined>} [here]  values at the cursor by curve, where they are worked out for that very place
 */

export class Chart {
  /**
   * @param {App} app
   * @param {{ panels: Panel[], axis: Axis, label: string, onPick?: ((x: number, on: { last: boolean }) => void) | null, zoom?: Zoom | null }} look
   */
  constructor(app, { panels, axis, label, onPick = null, zoom = null }) {
    this.app = app;
    this.panels = panels;
    this.axis = axis;
    this.caption = label || "Curves";
    this.data = /** @type {Shown} */ (/** @type {unknown} */ (null)); // until it is first drawn
    /** @type {number | null} */
    this.hover = null;
    /** @type {Placed[]} */
    this.places = []; // of the panels, since the ground was last painted
    /** @type {Map<Panel, { key: string, lines: Curve[], rows: Curve[][] }>} */
    this.legend = new Map();
    this.surface = new Surface(app, { label, height: (width) => this.tall(width), paint: (context, width) => this.paint(context, width) });
    this.zoom = zoom ?? new Zoom({ onChange: () => this.surface.draw() });
    this.zoom.listen(this.surface, (x) => this.xAt(x));
    this.surface.hovers((at) => this.point(at));
    if (onPick) {
      this.surface.element.style.cursor = "ew-resize";
      this.surface.drags(({ x, last }) => onPick(this.xAt(x), { last }));
    }
    this.numbers = new Numbers(app, "These curves as a table", () => this.tabled());
    const foot = make("div", { className: "chart-foot" }, ...(zoom ? [] : [this.zoom.buttons()]), this.numbers.element);
    this.element = make("div", { className: "chart" }, this.surface.element, foot);
  }

  /** @param {number} width */
  tall(width) { return this.panels.reduce((sum, panel) => sum + panel.height + HEAD + ROW * this.namesOf(panel, width).length + GAP, FOOT); }

  // Rows of names beneath a panel's title, as worked out for this width, system of units and cursor.
  /** @param {Panel} panel @param {number} width */
  namesOf(panel, width) {
    const { units } = this.app;
    const values = this.data?.cursor !== null && this.data?.cursor !== undefined;
    const key = `${width} ${units} ${values}`;
    let known = this.legend.get(panel);
    if (!known || known.key !== key || known.lines !== panel.lines) {
      known = { key, lines: panel.lines, rows: rowsOfNames(this.surface.context, panel, { room: width - LEFT - RIGHT, values, units }) };
      this.legend.set(panel, known);
    }
    return known.rows;
  }

  /** @param {Shown} data */
  draw(data) {
    const other = data.lines !== this.data?.lines || this.units !== this.app.units;
    this.data = data;
    this.units = this.app.units;
    if (!this.zoom.shared) this.zoom.set(data.range, data.usual ?? null);
    this.surface.draw();
    if (other) this.numbers.redraw();
  }
  /** @param {string} name */
  figure(name) { return this.surface.figure(name); }
  /** @param {string} words */
  label(words) { this.surface.label(words); }
  get range() { return this.data?.fixed ? this.data.range : this.zoom.range; }

  /** @param {number} pixel */
  xAt(pixel) {
    const [least, most] = this.range;
    const part = (pixel - LEFT) / (this.surface.width - LEFT - RIGHT);
    return least + Math.min(1, Math.max(0, part)) * (most - least);
  }

  /** @param {{ x: number, y: number } | null} at */
  point(at) {
    const inside = at && this.data && at.x >= LEFT && at.x <= this.surface.width - RIGHT;
    this.hover = inside ? this.xAt(at.x) : null;
    if (this.data) this.surface.draw();
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width */
  paint(context, width) {
    if (!this.data) return;
    const { data, app: { colors, units } } = this;
    const [least, most] = this.range;
    const across = (/** @type {number} */ x) => LEFT + ((x - least) / (most - least)) * (width - LEFT - RIGHT);
    const about = [data.lines, data.x, data.xs, colors, units, least, most, this.axis.from?.(), ...this.panels, ...this.panels.map(({ lines }) => lines),
      JSON.stringify([data.bands, data.marks, data.points, data.published])];
    this.surface.layer(context, about, (ground) => {
      this.places = panelsOf(this, { left: LEFT, right: width - RIGHT, head: HEAD, gap: GAP, row: ROW, namesOf: (panel) => this.namesOf(panel, width) });
      for (const place of this.places) this.paintGround(ground, place, across);
      paintAxis(ground, this, across, (this.places.at(-1)?.box.bottom ?? 0));
    });
    for (const place of this.places) this.paintOver(context, place, across);
  }

  // What stays while a pointer or the cursor moves: it is painted once.
  /** @param {CanvasRenderingContext2D} context @param {Placed} given @param {Way} across */
  paintGround(context, { panel, box, xs, shown, bands, points, low, high, up }, across) {
    const { data, app: { colors } } = this;
    within(context, box, () => {
      for (const band of data.bands ?? []) {
        context.fillStyle = colors.zone;
        context.fillRect(across(band.from), box.top, across(band.to) - across(band.from), box.bottom - box.top);
      }
    });
    paintGrid(context, colors, box, low, high, up);
    within(context, box, () => {
      const named = panel === this.panels[0] ? this.namedMarks() : [];
      for (const mark of data.marks ?? []) line(context, [[across(mark.at), box.top + ROW * rowOf(Math.max(0, named.indexOf(mark)), box)], [across(mark.at), box.bottom]], colors[mark.color], 1, [3, 3]);
      panel.lines.forEach((curve, i) => {
        if (bands[i]) paintArea(context, xs[i], bands[i][1], bands[i][0], across, up, colors[curve.color], 0.2);
        paintLine(context, curve, xs[i], shown[i], { across, up, colors, area: panel.stacked ? { below: i > 0 ? shown[i - 1] : null, low } : null });
        paintPoints(context, points[i], across, up, colors[curve.color], colors.panel);
      });
    });
  }

  /** @param {CanvasRenderingContext2D} context @param {Placed} given @param {Way} across */
  paintOver(context, { panel, box, xs, shown, bare, published, up }, across) {
    const { colors } = this.app;
    within(context, box, () => {
      for (const marks of published) paintPublished(context, marks, { box, across, up, colors, hover: this.hover, width: this.surface.width });
      this.paintCursors(context, panel, { xs, shown, box, across, up });
    });
    if (panel === this.panels[0]) this.paintMarkNames(context, box, across);
    this.paintTitle(context, panel, box, { xs, bare });
  }

  // Marks with a name within what is shown, as they follow each other.
  namedMarks() {
    const [least, most] = this.range;
    return (this.data.marks ?? []).filter((mark) => mark.label && mark.at >= least && mark.at <= most).sort((one, other) => one.at - other.at);
  }

  // In the first panel, each name a row lower than the one before, where its line begins: no line crosses a name. Below the
  // last row they go on at the top.
  /** @param {CanvasRenderingContext2D} context @param {Box} box @param {Way} across */
  paintMarkNames(context, box, across) {
    const { colors } = this.app;
    context.font = `11px ${FONT}`;
    context.textBaseline = "middle";
    this.namedMarks().forEach((mark, row) => {
      const room = box.right - across(mark.at) > context.measureText(mark.label ?? "").width + 8;
      context.textAlign = room ? "left" : "right";
      haloText(context, mark.label ?? "", across(mark.at) + (room ? 4 : -4), box.top + 7 + ROW * rowOf(row, box), colors.ink, colors.panel);
    });
  }

  // Lines at the ball's place and at the pointer's, with a dot on every curve; the values stand in the title's row.
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Panel} panel
   * @param {Pick<Placed, "xs" | "shown" | "box" | "up"> & { across: Way }} given
   */
  paintCursors(context, panel, { xs, shown, box, across, up }) {
    const { colors } = this.app;
    for (const { at, color, dash } of [{ at: this.data.cursor, color: colors.ink, dash: [] }, { at: this.hover, color: colors.muted, dash: [2, 3] }]) {
      if (at === null || at === undefined) continue;
      line(context, [[across(at), box.top], [across(at), box.bottom]], color, 1.2, dash);
      if (panel.stacked) continue;
      for (const [i, curve] of [...panel.lines.entries()].reverse()) { // the first line's dot lies on top
        const value = this.valueOf(panel, curve, xs[i], shown[i], at);
        if (value !== null) dot(context, [across(at), up(value)], 3.5, { fill: colors[curve.color] });
      }
    }
  }

  // A curve's value at a place, in the reader's units; at the cursor the one that was worked out there, where it is known.
  /**
   * @param {Panel} panel
   * @param {Curve} line
   * @param {number[]} xs
   * @param {Values} values
   * @param {number} at
   */
  valueOf(panel, line, xs, values, at) {
    const known = at === this.data.cursor ? this.data.here?.[line.key] : undefined;
    return known === undefined ? between(xs, values, at) : shownValues(panel, [known], this.app.units)[0];
  }

  // Title, unit, names of the lines; on the right, where there is room, the values at the pointer or else at the cursor.
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Panel} panel
   * @param {Box} box
   * @param {Pick<Placed, "xs" | "bare">} given
   */
  paintTitle(context, panel, box, { xs, bare }) {
    const { colors, units } = this.app;
    const at = this.hover ?? this.data.cursor ?? null;
    const digits = kindOf(panel.kind)[units].digits;
    const values = at === null ? [] : panel.lines.map((line, i) => ({ line, value: this.valueOf(panel, line, xs[i], bare[i], at) })).filter(({ value, line }) => value !== null && !line.silent);
    Object.assign(context, { textBaseline: "alphabetic", textAlign: "right", font: `600 12px ${FONT}` });
    const words = values.map(({ value }) => grouped((value ?? 0).toFixed(digits)).replace("-", "−"));
    const wanted = words.reduce((sum, word) => sum + context.measureText(word).width + (values.length > 1 ? 29 : 13), 0);
    const fits = wanted <= box.right - box.left - context.measureText(panel.title).width - context.measureText(unitOf(panel.kind, units)).width - 8;
    let right = box.right;
    for (const [i, { line }] of fits ? [...values.entries()].reverse() : []) {
      context.fillStyle = colors.ink;
      context.fillText(words[i], right, box.head - 6);
      right -= context.measureText(words[i]).width + 5;
      if (values.length > 1) {
        paintSample(context, line, panel, { from: right - 14, to: right, y: box.head - 10, colors });
        right -= 24;
      } else right -= 8;
    }
    if (this.hover !== null && values.length && fits) {
      Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted });
      const place = `at ${this.app.text(this.axis.kind, this.axis.from ? this.axis.from() - this.hover : this.hover)}`;
      context.fillText(place, right, box.head - 6);
      right -= context.measureText(place).width + 10;
    }
    Object.assign(context, { textAlign: "left", font: `600 12px ${FONT}`, fillStyle: colors.ink });
    context.fillText(panel.title, box.left, box.head - 6);
    let left = box.left + context.measureText(panel.title).width + 6;
    context.font = `12px ${FONT}`;
    const unit = unitOf(panel.kind, units);
    context.fillStyle = colors.muted;
    if (unit) context.fillText(unit, left, box.head - 6);
    if (unit) left += context.measureText(unit).width + 12;
    box.rows.forEach((lines, row) => paintNames(context, panel, lines, { left: box.left, right: box.right, y: box.head - 6 + ROW * (row + 1), colors }));
    if (!box.rows.length) paintNames(context, panel, panel.lines.filter((one) => one.label), { left, right, y: box.head - 6, colors });
  }

  // The numbers of what is shown, at even places along the axis.
  tabled() {
    if (!this.data) return null;
    const { units } = this.app;
    const [least, most] = this.range;
    const lines = this.panels.flatMap((panel) => panel.lines.filter((line) => !line.silent).map((line) => ({ panel, line, values: shownValues(panel, this.data.lines[line.key], units) })));
    const head = [unitOf(this.axis.kind, units), this.axis.label].filter(Boolean).join(" ");
    const columns = lines.map(({ panel, line }) => [panel.title, line.name ?? line.label ?? "", unitOf(panel.kind, units)].filter(Boolean).join(", "));
    const rows = Array.from({ length: ROWS }, (_, i) => least + (i / (ROWS - 1)) * (most - least)).map((x) => [
      grouped(shownPlace(this.axis, x, units).toFixed(kindOf(this.axis.kind)[units].digits)),
      ...lines.map(({ panel, line, values }) => between(this.data.xs?.[line.key] ?? this.data.x, values, x)?.toFixed(kindOf(panel.kind)[units].digits) ?? "–")]);
    return { caption: this.caption, columns: [head, ...columns], rows };
  }
}

// The row of the panel for one name of many.
const rowOf = (/** @type {number} */ number, /** @type {Box} */ { top, bottom }) => number % Math.max(1, Math.floor((bottom - top) / ROW));
