// A season's pictures: balls on the barrel, exit speeds over two ceilings, and balls on the field, each with its table.

import { Chart } from "../charts/chart.js";
import { heat } from "../charts/heat.js";
import { HeatMap } from "../charts/heatmap.js";
import { Numbers } from "../charts/numbers.js";
import { make } from "../controls/parts.js";
import { FONT, Surface, haloText } from "../charts/surface.js";
import { fromShown, grouped, kindOf, toShown, unitOf } from "../controls/units.js";
/** @import { Answer, App, Colors } from "../shell/main.js" */

/** @import { Point } from "../charts/surface.js" */
/** @typedef {(right: number, out: number) => Point} Placing from a place on the field, m from home, to a pixel */
const PANELS = [{ title: "Balls, by part of the greatest speed", kind: "share", height: 110, zero: true, lines: [
  { key: "squared_up_ratio", label: "this bat", color: "blue", width: 2.2 }, { key: "league_ratio", label: "the league's formula", color: "orange", width: 1.6, dash: [5, 4] }] }];

export class BarrelMap {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.length = 0.84;
    this.map = new HeatMap(app, {
      label: "Where on the barrel", title: "Where on the barrel: balls in each box", height: 190, lines: false,
      x: { kind: "position_m", from: () => this.length, label: "from the tip" }, y: { kind: "offset_m", label: "ball above the axis" }, z: { kind: "count" },
    });
    this.note = make("p", { className: "note" });
    this.element = make("div", {}, this.map.element, this.note, this.map.numbers.element);
  }

  /**
   * @param {{ across_m: Answer, along_m: Answer, balls: Answer, outside: number }} given
   * @param {Answer} bat
   */
  draw({ across_m: fromTip, along_m: above, balls, outside }, bat) {
    const { length_m: length, outline } = bat;
    this.length = length;
    this.found = { fromTip, above, balls };
    const turned = (/** @type {any[]} */ list) => [...list].reverse();
    const half = (/** @type {any[]} */ list) => (list[1] - list[0]) / 2;
    const edge = fromTip.at(-1) + half(fromTip);
    const side = outline.position_m.map((/** @type {number} */ place, /** @type {number} */ i) => [place, outline.diameter_m[i] / 2]).filter((/** @type {any} */ _, /** @type {number} */ i) => (outline.position_m[i + 1] ?? length) > length - edge); // the first lies left of the picture
    this.map.draw({
      x: turned(fromTip).map((place) => length - place), y: above, z: balls.map((/** @type {any} */ row) => turned(row).map((count) => count || null)),
      range: [length - edge, length + 0.004], heights: [above[0] - half(above), above.at(-1) + half(above)],
      outline: [...side, ...turned(side).map(([place, wide]) => [place, -wide])],
    });
    const all = balls.flat().reduce((/** @type {number} */ sum, /** @type {number} */ count) => sum + count, 0);
    this.note.textContent = `The barrel from the side, the tip at the right; each ball at one draw from what is known of it, so that doubt shows as width.${outside ? ` Outside of it: ${outside}.` : ""}`;
    this.map.label(`Where on the barrel ${all} balls were met, most ${this.most()}.`);
  }

  most() {
    if (!this.found) return "nowhere";
    const { fromTip, above, balls } = this.found;
    const most = Math.max(...balls.flat());
    const row = balls.findIndex((/** @type {number[]} */ one) => one.includes(most));
    return `${this.app.text("place", fromTip[balls[row].indexOf(most)])} from the tip and ${this.app.text("offset", above[row])} above the axis`;
  }

  /** @param {string} name */
  figure(name) { return this.map.figure(name); }

  columns() {
    if (!this.found) return {};
    const { fromTip, above, balls } = this.found;
    const boxes = above.flatMap((/** @type {number} */ up, /** @type {any} */ row) => fromTip.map((/** @type {number} */ place, /** @type {number} */ column) => [place, up, balls[row][column]]));
    return { from_tip_m: boxes.map((/** @type {[number]} */ [place]) => place), offset_m: boxes.map((/** @type {[any, number]} */ [, up]) => up), balls: boxes.map((/** @type {[any, any, number]} */ [, , count]) => count) };
  }
}

export class Ceilings {
  /** @param {App} app */
  constructor(app) {
    this.chart = new Chart(app, { label: "Exit speeds over the greatest that were possible", panels: PANELS, axis: { kind: "ratio", label: "of the greatest exit speed" } });
    this.note = make("p", { className: "note", textContent: "The league's formula needs each pitch's speed, which these tables do not have." });
    this.element = make("div", {}, this.chart.element, this.note);
  }

  /** @param {{ ratio: Answer, league_ratio?: Answer }} given */
  draw({ ratio, ...lines }) {
    this.note.hidden = Boolean(lines.league_ratio);
    this.chart.draw({ x: ratio, lines: { league_ratio: ratio.map(() => null), ...lines }, range: [ratio[0], ratio.at(-1)], marks: [{ at: 0.8, color: "muted", label: "squared up" }] });
  }

  /** @param {string} name */
  figure(name) { return this.chart.figure(name); }
}

// The field from above: boxes coloured by their balls, the chosen park's fence, and distances from home.
export class FieldMap {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.found = null;
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

  /**
   * @param {Answer} found
   * @param {Answer} park
   */
  draw(found, park) {
    this.found = found;
    this.park = park;
    const { app } = this;
    const box = app.text("distance", found.across_m[1] - found.across_m[0]);
    const number = (/** @type {number} */ count) => `${grouped(count)} ${count === 1 ? "ball" : "balls"}`;
    this.note.textContent = `Where balls come down in still air, in boxes of ${box}; the fence is that of ${park.name}. ` +
      `Not drawn: ${number(found.near)} that came down within ${app.text("distance", 27.432)} of home${found.outside ? `, and ${number(found.outside)} beyond the picture` : ""}.`;
    this.surface.label(`The field from above with where balls come down, and the fence of ${park.name}.`);
    this.surface.draw();
    this.numbers.redraw();
  }

  /** @param {string} name */
  figure(name) { return this.surface.figure(name); }

  /**
   * @param {number} width
   * @param {number} height
   */
  place(width, height) {
    const { across_m: across, along_m: along } = this.found;
    const half = (across[1] - across[0]) / 2;
    const [wide, far] = [across.at(-1) + half, along.at(-1) + half];
    const scale = Math.min(width / (2 * wide), (height - 40) / far);
    /** @type {Placing} */
    const at = (right, out) => [width / 2 + right * scale, height - 14 - out * scale];
    return { scale, half, at };
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   * @param {number} height
   */
  paint(context, width, height) {
    if (!this.found) return;
    const { colors } = this.app;
    const { at, scale, half } = this.place(width, height);
    const fence = this.park.right_m.map((/** @type {number} */ right, /** @type {number} */ i) => at(right, this.park.out_m[i]));
    context.beginPath();
    for (const [x, y] of [at(0, 0), ...fence]) context.lineTo(x, y);
    context.closePath();
    context.fillStyle = colors.grass;
    context.fill();
    const { across_m: across, along_m: along, balls } = this.found;
    const most = Math.max(1, ...balls.flat());
    balls.forEach((/** @type {any} */ row, /** @type {number} */ j) => row.forEach((/** @type {number} */ count, /** @type {number} */ i) => {
      if (!count) return;
      const [left, top] = at(across[i] - half, along[j] + half).map(Math.round);
      const [right, bottom] = at(across[i] + half, along[j] - half).map(Math.round);
      context.fillStyle = heat(Math.sqrt(count / most));
      context.fillRect(left, top, Math.max(1, right - left - 1), Math.max(1, bottom - top - 1));
    }));
    this.paintLines(context, { at, scale, fence, width, colors });
    this.paintLegend(context, { width, most, colors, at: this.boxAt(width, height) });
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {{ at: Placing, scale: number, fence: Answer, width: number, colors: Colors }} given
   */
  paintLines(context, { at, scale, fence, width, colors }) {
    const { app } = this;
    const stroke = (/** @type {number[][]} */ points, /** @type {string} */ color, /** @type {number} */ thick) => {
      Object.assign(context, { strokeStyle: color, lineWidth: thick });
      context.beginPath();
      points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
      context.stroke();
    };
    const [home, ...ends] = [at(0, 0), fence[0], fence.at(-1)];
    for (const end of ends) stroke([home, end], colors.line, 1);
    for (const [color, thick] of /** @type {[string, number][]} */ ([[colors.paper, 5], [colors.ink, 2.2]])) stroke(fence, color, thick);
    for (const shown of app.units === "us" ? [200, 300, 400] : [60, 90, 120]) {
      const far = fromShown("distance", shown, app.units);
      context.setLineDash([3, 4]);
      stroke(Array.from({ length: 31 }, (_, i) => at(far * Math.sin((i / 15 - 1) * Math.PI / 4), far * Math.cos((i / 15 - 1) * Math.PI / 4))), colors.line, 1);
      context.setLineDash([]);
      Object.assign(context, { font: `11px ${FONT}`, textAlign: "left", textBaseline: "middle" });
      const [x, y] = at(far * Math.SQRT1_2, far * Math.SQRT1_2);
      const words = `${shown} ${unitOf("distance", app.units)}`;
      haloText(context, words, Math.min(x + 5, width - context.measureText(words).width - 2), y + 3 * Math.min(1, scale), colors.ink, colors.panel);
    }
  }

  // The box under the pointer: its balls and where it lies.
  /**
   * @param {number} width
   * @param {number} height
   */
  boxAt(width, height) {
    if (!this.hover) return null;
    const { scale, half } = this.place(width, height);
    const { across_m: across, along_m: along, balls } = this.found;
    const [right, out] = [(this.hover.x - width / 2) / scale, (height - 14 - this.hover.y) / scale];
    const [i, j] = [[across, right], [along, out]].map(([list, value]) => list.findIndex((/** @type {number} */ one) => Math.abs(one - value) <= half));
    return i < 0 || j < 0 ? null : { balls: balls[j][i], far: Math.hypot(right, out) };
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {{ width: number, most: number, colors: Colors, at: { balls: number, far: number } | null }} given
   */
  paintLegend(context, { width, most, colors, at }) {
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
    const rows = new Map();
    const { across_m: across, along_m: along, balls } = this.found;
    balls.forEach((/** @type {any} */ row, /** @type {number} */ j) => row.forEach((/** @type {number} */ count, /** @type {number} */ i) => {
      if (!count) return;
      const band = Math.floor(toShown("distance", Math.hypot(across[i], along[j]), units) / step);
      const side = Math.min(4, Math.max(0, Math.floor((Math.atan2(across[i], along[j]) / (Math.PI / 2) + 0.5) * 5)));
      if (!rows.has(band)) rows.set(band, names.map(() => 0));
      rows.get(band)[side] += count;
    }));
    const unit = kindOf("distance")[units].unit;
    return {
      caption: "Balls by where they come down", columns: [`from home (${unit})`, ...names],
      rows: [...rows].sort(([one], [other]) => other - one).map(([band, counts]) => [`${band * step} to ${(band + 1) * step}`, ...counts.map(String)]),
    };
  }
}
