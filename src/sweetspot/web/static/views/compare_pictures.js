// The pictures of the comparison: the bats below each other with tips aligned, and the change of exit speed with its interval.

import { paintBat } from "../bat/batview.js";
import { LEFT, RIGHT } from "../charts/chart.js";
import { dot, line } from "../charts/pen.js";
import { FONT, Surface, haloText, ticks } from "../charts/surface.js";
import { kindOf, toShown, unitOf } from "../controls/units.js";
/** @import { DrawnComparedBat } from "../answers.js" */
/** @import { App } from "../shell/main.js" */
/** @import { Way } from "../bat/batpaint.js" */

/** @typedef {{ color: string, width: number, dash: number[] }} Look */
/** @type {Look[]} */
export const LINES = [
  { color: "ink", width: 2.4, dash: [] }, { color: "red", width: 2.2, dash: [7, 3] }, { color: "blue", width: 2.2, dash: [2, 2.5] },
  { color: "orange", width: 2.2, dash: [10, 3, 2, 3] }, { color: "green", width: 2.2, dash: [4, 2] },
];
const NAME = 22, ROOM = 14, WIDEST = 0.068; // px, px, m

export class RowsPicture {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {DrawnComparedBat[]} */
    this.bats = [];
    this.longest = 1;
    this.surface = new Surface(app, { height: (width) => Math.max(1, this.bats.length) * this.row(width), paint: (context, width) => this.paint(context, width) });
    this.element = this.surface.element;
  }

  /** @param {DrawnComparedBat[]} bats @param {number} longest @param {string} words */
  draw(bats, longest, words) {
    Object.assign(this, { bats, longest });
    this.surface.label(words);
    this.surface.draw();
  }

  /** @param {number} width */
  scale(width) { return (width - LEFT - RIGHT) / this.longest; }
  /** @param {number} width */
  row(width) { return NAME + ROOM + WIDEST * this.scale(width); }

  /** @param {CanvasRenderingContext2D} context @param {number} width */
  paint(context, width) {
    this.bats.forEach((one, i) => this.paintRow(context, one, LINES[i], i * this.row(width), width));
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {DrawnComparedBat} given
   * @param {Look} look
   * @param {number} top
   * @param {number} width
   */
  paintRow(context, { bat, shape, label, zone_m: zone, max_exit_speed_m: best }, look, top, width) {
    const { colors } = this.app;
    const scale = this.scale(width);
    const left = width - RIGHT - bat.length_m * scale;
    const middle = top + NAME + (WIDEST * scale) / 2;
    const across = (/** @type {number} */ x) => left + x * scale;
    if (zone) {
      context.fillStyle = colors.zoneEdge;
      context.fillRect(across(zone[0]), top + NAME + WIDEST * scale + 4, across(zone[1]) - across(zone[0]), 4);
    }
    paintBat(context, { ...bat, ...shape }, { left, scale, middle }, colors);
    dot(context, [across(best), middle], 5, { fill: colors.red, edge: colors.panel, width: 1.5 });
    line(context, [[LEFT, top + 10], [LEFT + 30, top + 10]], colors[look.color], 3, look.dash);
    Object.assign(context, { font: `600 12px ${FONT}`, textAlign: "left", textBaseline: "middle" });
    haloText(context, label, LEFT + 36, top + 10, colors.ink, colors.panel);
  }
}

const CHANGE_ROW = 30, HEAD = 20, FOOT = 30;

export class ChangePicture {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {DrawnComparedBat[]} */
    this.bats = [];
    this.surface = new Surface(app, { height: () => HEAD + Math.max(1, this.bats.length - 1) * CHANGE_ROW + FOOT, paint: (context, width, height) => this.paint(context, width, height) });
    this.element = this.surface.element;
  }

  /** @param {DrawnComparedBat[]} bats @param {string} words */
  draw(bats, words) {
    this.bats = bats;
    this.element.hidden = bats.length < 2;
    this.surface.label(words);
    this.surface.draw();
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    const { colors, units } = this.app;
    const shown = (/** @type {number} */ value) => toShown("speed_change", value, units);
    const others = this.bats.slice(1);
    const ends = others.flatMap(({ change_m_s: { low, high } }) => [shown(low), shown(high)]);
    const room = 0.12 * Math.max(0.2, Math.max(0, ...ends) - Math.min(0, ...ends));
    const [least, most] = [Math.min(0, ...ends) - room, Math.max(0, ...ends) + room];
    const names = Math.min(0.42 * width, 220);
    const across = (/** @type {number} */ value) => names + 10 + ((value - least) / (most - least)) * (width - names - RIGHT - 20);
    const bottom = height - FOOT;
    Object.assign(context, { font: `600 12px ${FONT}`, fillStyle: colors.ink, textAlign: "left", textBaseline: "middle" });
    context.fillText("Change of exit speed", 0, 9);
    context.font = `11px ${FONT}`;
    for (const value of ticks(least, most, (width - names) / 60)) {
      line(context, [[across(value), HEAD], [across(value), bottom]], value === 0 ? colors.ink : colors.grid);
      Object.assign(context, { fillStyle: colors.muted, textAlign: "center", textBaseline: "top" });
      context.fillText(String(value).replace("-", "−"), across(value), bottom + 4);
    }
    context.textAlign = "right";
    context.fillText(`${unitOf("speed_change", units)} against ${clipped(context, this.bats[0]?.label ?? "", width / 2)}`, width - RIGHT, bottom + 17);
    others.forEach((one, i) => this.paintRow(context, one, LINES[i + 1], HEAD + (i + 0.5) * CHANGE_ROW, { across, shown, names }));
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {DrawnComparedBat} given
   * @param {Look} look
   * @param {number} y
   * @param {{ across: Way, shown: Way, names: number }} given
   */
  paintRow(context, { label, change_m_s: change }, look, y, { across, shown, names }) {
    const { colors } = this.app;
    Object.assign(context, { font: `12px ${FONT}`, fillStyle: colors.ink, textAlign: "left", textBaseline: "middle" });
    context.fillText(clipped(context, label, names), 0, y);
    const judged = change.low < change.high; // until its interval is there a change is a grey mark
    const color = judged ? colors[look.color] : colors.muted;
    context.lineCap = "round";
    if (judged) line(context, [[across(shown(change.low)), y], [across(shown(change.high)), y]], color, 4);
    context.lineCap = "butt";
    dot(context, [across(shown(change.value)), y], 6, { fill: color });
    Object.assign(context, { font: `600 11px ${FONT}`, textAlign: "center" });
    const digits = kindOf("speed_change")[this.app.units].digits;
    const words = `${change.value > 0 ? "+" : ""}${shown(change.value).toFixed(digits).replace("-", "−")}`;
    haloText(context, words, across(shown(change.value)), y - 12, colors.ink, colors.panel);
  }
}

/** @param {CanvasRenderingContext2D} context @param {string} text @param {number} width */
function clipped(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  let short = text;
  while (short.length > 3 && context.measureText(`${short}…`).width > width) short = short.slice(0, -1);
  return `${short.trimEnd()}…`;
}
