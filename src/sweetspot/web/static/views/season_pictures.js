// A season's pictures: balls on the barrel, exit speeds over two ceilings, and balls on the field, each with its table.

import { Chart } from "../charts/chart.js";
import { heat } from "../charts/heat.js";
import { HeatMap } from "../charts/heatmap.js";
import { Numbers } from "../charts/numbers.js";
import { make } from "../controls/parts.js";
import { line, shape } from "../charts/pen.js";
import { FONT, Surface, haloText } from "../charts/surface.js";
import { fromShown, grouped, kindOf, toShown, unitOf } from "../controls/units.js";
/** @import { BallCeilings, BenchBat, FieldFence, MappedBalls } from "../answers.js" */
/** @import { Point } from "../charts/pen.js" */
/** @import { App } from "../shell/main.js" */

/** @typedef {(right: number, out: number) => Point} Placing from a place on the field, m from home, to a pixel */
const PANELS = [{ title: "Balls, by part of the greatest speed", kind: "share", height: 110, zero: true, lines: [
  { key: "squared_up_ratio", label: "this bat", color: "blue", width: 2.2 }, { key: "league_ratio", label: "the league's formula", color: "orange", width: 1.6, dash: [5, 4] }] }];

export class BarrelMap {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.length = 0.84;
    this.found = { fromTip: /** @type {number[]} */ ([]), above: /** @type {number[]} */ ([]), balls: /** @type {number[][]} */ ([]) };
    this.map = new HeatMap(app, {
      label: "Where on the barrel", title: "Where on the barrel: balls in each box", height: 190, lines: false,
      x: { kind: "position_m", from: () => this.length, label: "from the tip" }, y: { kind: "offset_m", label: "ball above the axis" }, z: { kind: "count" },
    });
    this.note = make("p", { className: "note" });
    this.element = make("div", {}, this.map.element, this.note, this.map.numbers.element);
  }

  /** @param {MappedBalls} given @param {BenchBat} bat */
  draw({ across_m: fromTip, along_m: above, balls, note, label }, { length_m: length, outline }) {
    const { units } = this.app;
    this.length = length;
    this.found = { fromTip, above, balls };
    const half = (/** @type {number[]} */ list) => (list[1] - list[0]) / 2;
    const edge = fromTip[fromTip.length - 1] + half(fromTip);
    const side = outline.position_m.map((place, i) => [place, outline.diameter_m[i] / 2]).filter((_, i) => (outline.position_m[i + 1] ?? length) > length - edge); // the first lies left of the picture
    this.map.draw({
      x: fromTip.map((place) => length - place).reverse(), y: above, z: balls.map((row) => row.map((count) => count || null).reverse()),
      range: [length - edge, length + 0.004], heights: [above[0] - half(above), above[above.length - 1] + half(above)],
      outline: [...side, ...[...side].reverse().map(([place, wide]) => [place, -wide])],
    });
    this.note.textContent = note[units];
    this.map.label(label[units]);
  }

  /** @param {string} name */
  figure(name) { return this.map.figure(name); }

  columns() {
    const { fromTip, above, balls } = this.found;
    return { from_tip_m: above.flatMap(() => fromTip), offset_m: above.flatMap((up) => fromTip.map(() => up)), balls: balls.flat() };
  }
}

export class Ceilings {
  /** @param {App} app */
  constructor(app) {
    this.chart = new Chart(app, { label: "Exit speeds over the greatest that were possible", panels: PANELS, axis: { kind: "ratio", label: "of the greatest exit speed" } });
    this.note = make("p", { className: "note", textContent: "The league's formula needs each pitch's speed, which these tables do not have." });
    this.element = make("div", {}, this.chart.element, this.note);
  }

  /** @param {BallCeilings} given */
  draw({ ratio, squared_up_ratio = [], league_ratio }) {
    this.note.hidden = Boolean(league_ratio);
    this.chart.draw({ x: ratio, lines: { squared_up_ratio, league_ratio: league_ratio ?? ratio.map(() => null) }, range: [ratio[0], ratio[ratio.length - 1]], marks: [{ at: 0.8, color: "muted", label: "squared up" }] });
  }

  /** @param {string} name */
  figure(name) { return this.chart.figure(name); }
}

// The field from above: boxes coloured by their balls, the chosen park's fence, and distances from home.
export class FieldMap {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {MappedBalls | null} */
    this.found = null;
    /** @type {FieldFence | null} */
    this.park = null;
    /** @type {{ x: number, y: number } | null} */
    this.hover = null;
    this.surface = new Surface(app, { height: (width) => Math.min(560, 0.8 * width), paint: (...all) => this.paint(...all), label: "Where balls come down" });
    this.surface.hovers((at) => {
      this.hover = at;
      this.surface.draw();
    });
    this.note = make("p", { className: "note" });
    this.numbers = new Numbers(app, "These balls as a table", () => this.tabled());
    this.element = make("div", {}, this.surface.element, this.note, this.numbers.element);
  }

  /** @param {MappedBalls} found @param {FieldFence} park */
  draw(found, park) {
    const { units } = this.app;
    Object.assign(this, { found, park });
    this.note.textContent = `${found.note[units]} ${park.words}`;
    this.surface.label(`${found.label[units]} ${park.words}`);
    this.surface.draw();
    this.numbers.redraw();
  }

  /** @param {string} name */
  figure(name) { return this.surface.figure(name); }

  /** @param {MappedBalls} found @param {number} width @param {number} height */
  place({ across_m: across, along_m: along }, width, height) {
    const half = (across[1] - across[0]) / 2;
    const [wide, far] = [across, along].map((list) => list[list.length - 1] + half);
    const scale = Math.min(width / (2 * wide), (height - 40) / far);
    /** @type {Placing} */
    const at = (right, out) => [width / 2 + right * scale, height - 14 - out * scale];
    return { scale, half, at };
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    const { found, park, app: { colors } } = this;
    if (!found || !park) return;
    const { at, scale, half } = this.place(found, width, height);
    const fence = park.right_m.map((right, i) => at(right, park.out_m[i]));
    shape(context, [at(0, 0), ...fence], { fill: colors.grass });
    const { across_m: across, along_m: along, balls } = found;
    const most = Math.max(1, ...balls.flat());
    balls.forEach((row, j) => row.forEach((count, i) => {
      if (!count) return;
      const [left, top] = at(across[i] - half, along[j] + half).map(Math.round);
      const [right, bottom] = at(across[i] + half, along[j] - half).map(Math.round);
      context.fillStyle = heat(Math.sqrt(count / most));
      context.fillRect(left, top, Math.max(1, right - left - 1), Math.max(1, bottom - top - 1));
    }));
    this.paintLines(context, at, scale, fence, width);
    this.paintLegend(context, width, most, this.boxAt(found, width, height));
  }

  /** @param {CanvasRenderingContext2D} context @param {Placing} at @param {number} scale @param {Point[]} fence @param {number} width */
  paintLines(context, at, scale, fence, width) {
    const { colors, units } = this.app;
    for (const end of [fence[0], fence[fence.length - 1]]) line(context, [at(0, 0), end], colors.line);
    line(context, fence, colors.paper, 5);
    line(context, fence, colors.ink, 2.2);
    for (const distance of units === "us" ? [200, 300, 400] : [60, 90, 120]) {
      const far = fromShown("distance", distance, units);
      line(context, Array.from({ length: 31 }, (_, i) => at(far * Math.sin((i / 15 - 1) * Math.PI / 4), far * Math.cos((i / 15 - 1) * Math.PI / 4))), colors.line, 1, [3, 4]);
      Object.assign(context, { font: `11px ${FONT}`, textAlign: "left", textBaseline: "middle" });
      const [x, y] = at(far * Math.SQRT1_2, far * Math.SQRT1_2);
      const words = `${distance} ${unitOf("distance", units)}`;
      haloText(context, words, Math.min(x + 5, width - context.measureText(words).width - 2), y + 3 * Math.min(1, scale), colors.ink, colors.panel);
    }
  }

  // The box under the pointer: its balls and where it lies.
  /** @param {MappedBalls} found @param {number} width @param {number} height */
  boxAt(found, width, height) {
    if (!this.hover) return null;
    const { scale, half } = this.place(found, width, height);
    const [right, out] = [(this.hover.x - width / 2) / scale, (height - 14 - this.hover.y) / scale];
    const [i, j] = /** @type {[number[], number][]} */ ([[found.across_m, right], [found.along_m, out]]).map(([list, value]) => list.findIndex((middle) => Math.abs(middle - value) <= half));
    return i < 0 || j < 0 ? null : { balls: found.balls[j][i], far: Math.hypot(right, out) };
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} most @param {{ balls: number, far: number } | null} at */
  paintLegend(context, width, most, at) {
    const { colors } = this.app;
    const words = at ? `${at.balls} ${at.balls === 1 ? "ball" : "balls"} about ${this.app.text("distance", at.far)} from home` : most === 1 ? "each box: one ball" : `1 to ${grouped(most)} balls in each box`;
    Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted, textAlign: "right", textBaseline: "alphabetic" });
    context.fillText(words, width - 12, 14);
    if (at || most === 1) return;
    const start = width - 12 - context.measureText(words).width - 68;
    for (let i = 0; i < 60; i += 1) {
      context.fillStyle = heat(i / 59);
      context.fillRect(start + i, 5, 1.5, 10);
    }
  }

  // Rows of distance from home, columns from the left to the right, counted over the boxes.
  tabled() {
    if (!this.found) return null;
    const { units } = this.app;
    const step = units === "us" ? 50 : 15;
    const names = ["left", "left-centre", "centre", "right-centre", "right"];
    /** @type {Map<number, number[]>} */
    const rows = new Map();
    const { across_m: across, along_m: along, balls } = this.found;
    balls.forEach((row, j) => row.forEach((count, i) => {
      if (!count) return;
      const band = Math.floor(toShown("distance", Math.hypot(across[i], along[j]), units) / step);
      const side = Math.min(4, Math.max(0, Math.floor((Math.atan2(across[i], along[j]) / (Math.PI / 2) + 0.5) * 5)));
      const counts = rows.get(band) ?? names.map(() => 0);
      counts[side] += count;
      rows.set(band, counts);
    }));
    const unit = kindOf("distance")[units].unit;
    return {
      caption: "Balls by where they come down", columns: [`from home (${unit})`, ...names],
      rows: [...rows].sort(([one], [other]) => other - one).map(([band, counts]) => [`${band * step} to ${(band + 1) * step}`, ...counts.map(String)]),
    };
  }
}
