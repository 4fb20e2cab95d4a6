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

import { between, limits, paintArea, paintAxis, paintGrid, paintLine, paintPoints, paintPublished, shownPlace, shownValues, stack, vertical } from "./chartpaint.js";
import { Numbers } from "./numbers.js";
import { make } from "./parts.js";
import { Surface, FONT, haloText } from "./surface.js";
import { kindOf, unitOf } from "./units.js";
import { Zoom } from "./zoom.js";
/** @import { App } from "./main.js" */
/** @import { Span } from "./zoom.js" */

export { between };
export const LEFT = 46, RIGHT = 12;
const HEAD = 22, FOOT = 34, GAP = 8;
const ROWS = 24; // of the table

/** @typedef {(number | null)[]} Values */
/** @typedef {{ key: string, color: string, label?: string, name?: string, dash?: number[], width?: number, fill?: boolean, silent?: boolean, band?: string[] }} Curve */
/** @typedef {{ title: string, kind: string, height: number, lines: Curve[], zero?: boolean, stacked?: boolean, empty?: number[], term?: string }} Panel */
/** @typedef {{ kind: string, label: string, from?: () => number }} Axis */
/** @typedef {{ at: number, color: string, label?: string }} Mark */
/** @typedef {{ from: number, to: number, low?: number, high?: number, label: string }} Published a stretch of the axis, or values around one place */
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
    /** @type {Shown} */
    this.data = /** @type {any} */ (null); // until it is first drawn
    /** @type {number | null} */
    this.hover = null;
    this.surface = new Surface(app, { label, height: () => this.tall(), paint: (context, width) => this.paint(context, width) });
    this.zoom = zoom ?? new Zoom({ onChange: () => this.surface.draw() });
    this.zoom.listen(this.surface, (x) => this.xAt(x));
    this.surface.hovers((at) => this.point(at));
    if (onPick) {
      this.surface.element.style.cursor = "ew-resize";
      this.surface.drags(({ x, last }) => onPick(this.xAt(x), { last }));
    }
    this.numbers = new Numbers("These curves as a table", () => this.tabled());
    const foot = make("div", { className: "chart-foot" }, ...(zoom ? [] : [this.zoom.buttons()]), this.numbers.element);
    this.element = make("div", { className: "chart" }, this.surface.element, foot);
  }

  tall() { return this.panels.reduce((sum, panel) => sum + panel.height + HEAD + GAP, FOOT); }
  /** @param {Shown} data */
  draw(data) {
    this.data = data;
    if (!this.zoom.shared) this.zoom.set(data.range, data.usual ?? null);
    this.surface.draw();
    this.numbers.redraw();
  }
  figure(name) { return this.surface.figure(name); }
  label(words) { this.surface.label(words); }
  get range() { return this.data?.fixed ? this.data.range : this.zoom.range; }

  xAt(pixel) {
    const [least, most] = this.range;
    const part = (pixel - LEFT) / (this.surface.width - LEFT - RIGHT);
    return least + Math.min(1, Math.max(0, part)) * (most - least);
  }

  point(at) {
    const inside = at && this.data && at.x >= LEFT && at.x <= this.surface.width - RIGHT;
    this.hover = inside ? this.xAt(at.x) : null;
    if (this.data) this.surface.draw();
  }

  paint(context, width) {
    if (!this.data) return;
    const [least, most] = this.range;
    const across = (x) => LEFT + ((x - least) / (most - least)) * (width - LEFT - RIGHT);
    let top = 0;
    for (const panel of this.panels) {
      const box = { top: top + HEAD, bottom: top + HEAD + panel.height, left: LEFT, right: width - RIGHT };
      this.paintPanel(context, panel, box, across);
      top = box.bottom + GAP;
    }
    paintAxis(context, this, across, top - GAP);
  }

  paintPanel(context, panel, box, across) {
    const { colors, units } = this.app;
    const { data } = this;
    const xs = panel.lines.map(({ key }) => data.xs?.[key] ?? data.x);
    const shown = panel.lines.map(({ key }) => shownValues(panel, data.lines[key], units));
    const bare = panel.stacked ? shown.map((values) => [...values]) : shown;
    if (panel.stacked) stack(shown);
    const bands = panel.lines.map(({ band }) => band?.map((key) => shownValues(panel, data.lines[key], units)));
    const points = panel.lines.map(({ key }) => (data.points?.[key] ?? []).map((one) => ({
      ...one, ...Object.fromEntries(["y", "low", "high"].map((name) => [name, shownValues(panel, [one[name] ?? null], units)[0]])) })));
    const published = panel.lines.map(({ key }) => (data.published?.[key] ?? []).map((one) => this.publishedIn(panel, one)));
    const wide = published.map((marks, i) => [...points[i], ...marks.map(({ from: x, low, high }) => ({ x, low, high }))]);
    const [low, high] = limits({ xs, shown, bands, points: wide, range: this.range }, panel);
    const up = (value) => box.bottom - ((value - low) / (high - low || 1)) * (box.bottom - box.top);
    context.save();
    context.beginPath();
    context.rect(box.left, box.top - 1, box.right - box.left, box.bottom - box.top + 2);
    context.clip();
    for (const band of data.bands ?? []) {
      context.fillStyle = colors.zone;
      context.fillRect(across(band.from), box.top, across(band.to) - across(band.from), box.bottom - box.top);
    }
    context.restore();
    paintGrid(context, colors, box, low, high, up);
    context.save();
    context.beginPath();
    context.rect(box.left, box.top - 1, box.right - box.left, box.bottom - box.top + 2);
    context.clip();
    for (const mark of data.marks ?? []) vertical(context, across(mark.at), box, colors[mark.color], 1, [3, 3]);
    panel.lines.forEach((line, i) => {
      if (bands[i]) paintArea(context, xs[i], bands[i][1], bands[i][0], across, up, colors[line.color], 0.2);
      paintLine(context, line, xs[i], shown[i], { across, up, colors, area: panel.stacked ? { below: i > 0 ? shown[i - 1] : null, low } : null });
      paintPoints(context, points[i], across, up, colors[line.color], colors.panel);
      paintPublished(context, published[i], { box, across, up, colors, hover: this.hover, width: this.surface.width });
    });
    this.paintCursors(context, panel, { xs, shown, box, across, up });
    context.restore();
    if (panel === this.panels[0]) this.paintMarkNames(context, box, across);
    this.paintTitle(context, panel, box, { xs, bare });
  }

  // A published number in the reader's units; values stand where they were given a place.
  publishedIn(panel, one) {
    const [low, high] = shownValues(panel, [one.low ?? null, one.high ?? null], this.app.units);
    return { ...one, low, high };
  }

  // In the first panel, each name a row lower than the one before.
  paintMarkNames(context, box, across) {
    const { colors } = this.app;
    context.font = `11px ${FONT}`;
    context.textBaseline = "middle";
    const [least, most] = this.range;
    (this.data.marks ?? []).filter((mark) => mark.label && mark.at >= least && mark.at <= most).forEach((mark, row) => {
      const room = box.right - across(mark.at) > context.measureText(mark.label).width + 8;
      context.textAlign = room ? "left" : "right";
      haloText(context, mark.label ?? "", across(mark.at) + (room ? 4 : -4), box.top + 7 + 14 * row, colors.ink, colors.panel);
    });
  }

  // Lines at the ball's place and at the pointer's, with a dot on every curve; the values stand in the title's row.
  paintCursors(context, panel, { xs, shown, box, across, up }) {
    const { colors } = this.app;
    for (const [at, color, dash] of [[this.data.cursor, colors.ink, []], [this.hover, colors.muted, [2, 3]]]) {
      if (at === null || at === undefined) continue;
      vertical(context, across(at), box, color, 1.2, dash);
      if (panel.stacked) continue;
      panel.lines.forEach((line, i) => {
        const value = between(xs[i], shown[i], at);
        if (value === null) return;
        context.fillStyle = colors[line.color];
        context.beginPath();
        context.arc(across(at), up(value), 3.5, 0, 2 * Math.PI);
        context.fill();
      });
    }
  }

  // Title, unit, names of the lines; on the right, where there is room, the values at the pointer or else at the cursor.
  paintTitle(context, panel, box, { xs, bare }) {
    const { colors, units } = this.app;
    const at = this.hover ?? this.data.cursor ?? null;
    const digits = kindOf(panel.kind)[units].digits;
    const values = at === null ? [] : panel.lines.map((line, i) => ({ line, value: between(xs[i], bare[i], at) })).filter(({ value, line }) => value !== null && !line.silent);
    Object.assign(context, { textBaseline: "alphabetic", textAlign: "right", font: `600 12px ${FONT}` });
    const words = values.map(({ value }) => value.toFixed(digits).replace("-", "−"));
    const wanted = words.reduce((sum, word) => sum + context.measureText(word).width + (values.length > 1 ? 29 : 13), 0);
    const fits = wanted <= box.right - box.left - context.measureText(panel.title).width - context.measureText(unitOf(panel.kind, units)).width - 8;
    let right = box.right;
    for (const [i, { line }] of fits ? [...values.entries()].reverse() : []) {
      context.fillStyle = colors.ink;
      context.fillText(words[i], right, box.top - 6);
      right -= context.measureText(words[i]).width + 5;
      if (values.length > 1) {
        this.sample(context, line, panel, right - 14, right, box.top - 10);
        right -= 24;
      } else right -= 8;
    }
    if (this.hover !== null && values.length && fits) {
      Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted });
      const place = `at ${this.app.text(this.axis.kind, this.axis.from ? this.axis.from() - this.hover : this.hover)}`;
      context.fillText(place, right, box.top - 6);
      right -= context.measureText(place).width + 10;
    }
    Object.assign(context, { textAlign: "left", font: `600 12px ${FONT}`, fillStyle: colors.ink });
    context.fillText(panel.title, box.left, box.top - 6);
    let left = box.left + context.measureText(panel.title).width + 6;
    context.font = `12px ${FONT}`;
    const unit = unitOf(panel.kind, units);
    context.fillStyle = colors.muted;
    if (unit) context.fillText(unit, left, box.top - 6);
    if (unit) left += context.measureText(unit).width + 12;
    for (const line of panel.lines.filter((one) => one.label)) {
      const room = 22 + context.measureText(line.label).width;
      if (left + room > right) return;
      this.sample(context, line, panel, left, left + 18, box.top - 10);
      context.fillStyle = colors.muted;
      context.fillText(line.label, left + 22, box.top - 6);
      left += room + 12;
    }
  }

  sample(context, line, panel, from, to, y) {
    Object.assign(context, { strokeStyle: this.app.colors[line.color], lineWidth: line.fill || panel.stacked ? 8 : line.width ?? 2 });
    context.setLineDash(line.dash ?? []);
    context.beginPath();
    context.moveTo(from, y);
    context.lineTo(to, y);
    context.stroke();
    context.setLineDash([]);
  }

  // The numbers of what is shown, at even places along the axis.
  tabled() {
    if (!this.data) return null;
    const { units } = this.app;
    const [least, most] = this.range;
    const lines = this.panels.flatMap((panel) => panel.lines.map((line) => ({ panel, line, values: shownValues(panel, this.data.lines[line.key], units) })));
    const head = [unitOf(this.axis.kind, units), this.axis.label].filter(Boolean).join(" ");
    const columns = lines.map(({ panel, line }) => [panel.title, line.name ?? line.label ?? "", unitOf(panel.kind, units)].filter(Boolean).join(", "));
    const rows = Array.from({ length: ROWS }, (_, i) => least + (i / (ROWS - 1)) * (most - least)).map((x) => [
      shownPlace(this.axis, x, units).toFixed(kindOf(this.axis.kind)[units].digits),
      ...lines.map(({ panel, line, values }) => between(this.data.xs?.[line.key] ?? this.data.x, values, x)?.toFixed(kindOf(panel.kind)[units].digits) ?? "–")]);
    return { caption: this.surface.element.getAttribute("aria-label") ?? "Curves", columns: [head, ...columns], rows };
  }
}
