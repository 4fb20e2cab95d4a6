// The names of a chart's lines: beside the panel's title where there is room for them, else in rows beneath it.

import { line as stroke } from "./pen.js";
import { FONT } from "./surface.js";
import { unitOf } from "../controls/units.js";
/** @import { Curve, Panel } from "./chart.js" */
/** @import { System } from "../controls/units.js" */

const SAMPLE = 22, APART = 12; // pixels of a line's sample before its name, and between two names
const VALUE = 62; // of a value at the cursor, with its sample
export const ROW = 16; // of a row of names

/**
 * Rows of lines whose names stand beneath the title; none where they fit beside it.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Panel} panel
 * @param {{ room: number, values: boolean, units: System }} look  pixels across, and whether values stand at the right
 * @returns {Curve[][]}
 */
export function rowsOfNames(context, panel, { room, values, units }) {
  const named = panel.lines.filter((line) => line.label);
  if (!named.length) return [];
  context.font = `12px ${FONT}`;
  const wide = (/** @type {string} */ words) => context.measureText(words).width;
  const steps = named.map((line) => SAMPLE + wide(line.label ?? "") + APART);
  const title = 1.1 * wide(panel.title) + wide(unitOf(panel.kind, units)) + 18;
  if (steps.reduce((sum, step) => sum + step, title) + (values ? VALUE * panel.lines.length : 0) <= room) return [];
  /** @type {Curve[][]} */
  const rows = [];
  let left = room;
  named.forEach((line, i) => {
    if (left + steps[i] - APART > room) {
      rows.push([]);
      left = 0;
    }
    rows[rows.length - 1].push(line);
    left += steps[i];
  });
  return rows;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Panel} panel
 * @param {Curve[]} lines
 * @param {{ left: number, right: number, y: number, colors: Record<string, string> }} place
 */
export function paintNames(context, panel, lines, { left, right, y, colors }) {
  context.font = `12px ${FONT}`;
  context.textAlign = "left";
  for (const line of lines) {
    const room = SAMPLE + context.measureText(line.label ?? "").width;
    if (left + room > right) return;
    paintSample(context, line, panel, { from: left, to: left + SAMPLE - 4, y: y - 4, colors });
    context.fillStyle = colors.muted;
    context.fillText(line.label ?? "", left + SAMPLE, y);
    left += room + APART;
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Curve} line
 * @param {Panel} panel
 * @param {{ from: number, to: number, y: number, colors: Record<string, string> }} place
 */
export function paintSample(context, line, panel, { from, to, y, colors }) {
  stroke(context, [[from, y], [to, y]], colors[line.color], line.fill || panel.stacked ? 8 : line.width ?? 2, line.dash);
}
