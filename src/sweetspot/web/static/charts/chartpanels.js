// Where a chart's panels lie, what they show in the reader's units, and how high a value stands in them.

import { limits, shownValues, stack } from "./chartpaint.js";
/** @import { Way } from "../bat/batpaint.js" */
/** @import { Curve, Measured, Panel, Published, Shown, Values } from "./chart.js" */
/** @import { Box } from "./chartpaint.js" */
/** @import { App } from "../shell/main.js" */
/** @import { Span } from "./zoom.js" */

/**
 * A panel where it is painted, with what it shows in the reader's units; bare: before what is stacked is added up.
 * @typedef {object} Placed
 * @property {Panel} panel
 * @property {Box} box
 * @property {number[][]} xs
 * @property {Values[]} shown
 * @property {Values[]} bare
 * @property {(Values[] | undefined)[]} bands
 * @property {Measured[][]} points
 * @property {Published[][]} published
 * @property {number} low
 * @property {number} high
 * @property {Way} up
 */

/**
 * @param {{ panels: Panel[], data: Shown, range: Span, app: App }} chart
 * @param {{ left: number, right: number, head: number, gap: number, row: number, namesOf: (panel: Panel) => Curve[][] }} room
 * @returns {Placed[]}
 */
export function panelsOf({ panels, data, range, app: { units } }, { left, right, head: above, gap, row, namesOf }) {
  let top = 0;
  return panels.map((panel) => {
    const [head, rows] = [top + above, namesOf(panel)];
    const start = head + row * rows.length;
    const box = { head, rows, top: start, bottom: start + panel.height, left, right };
    top = box.bottom + gap;
    const inUnits = (/** @type {Values | undefined} */ values) => shownValues(panel, values, units);
    const xs = panel.lines.map(({ key }) => data.xs?.[key] ?? data.x);
    const shown = panel.lines.map(({ key }) => inUnits(data.lines[key]));
    const bare = panel.stacked ? shown.map((values) => [...values]) : shown;
    if (panel.stacked) stack(shown);
    const bands = panel.lines.map(({ band }) => band?.map((key) => inUnits(data.lines[key])));
    const inUnit = (/** @type {number | null | undefined} */ value) => inUnits([value ?? null])[0];
    const points = panel.lines.map(({ key }) => (data.points?.[key] ?? []).map((point) => ({ ...point, y: inUnit(point.y), low: inUnit(point.low), high: inUnit(point.high) })));
    const published = panel.lines.map(({ key }) => (data.published?.[key] ?? []).map((mark) => ({ ...mark, low: inUnit(mark.low), high: inUnit(mark.high) })));
    const wide = published.map((marks, i) => [...points[i], ...marks.map(({ from: x, low, high }) => ({ x, low, high }))]);
    const [low, high] = limits({ xs, shown, bands, points: wide, range }, panel);
    const up = (/** @type {number} */ value) => box.bottom - ((value - low) / (high - low || 1)) * (box.bottom - box.top);
    return { panel, box, xs, shown, bare, bands, points, published, low, high, up };
  });
}
