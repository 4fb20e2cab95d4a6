// The flight from the side (distance over the ground against height) and from above (the field with its fence).

import { between } from "../charts/chartpaint.js";
import { Numbers, evenly } from "../charts/numbers.js";
import { dot, line, shape } from "../charts/pen.js";
import { FONT, Surface, arrow, haloText, ticks } from "../charts/surface.js";
import { fromShown, kindOf, toShown, unitOf } from "../controls/units.js";
/** @import { DrawnPark, DrawnPath, FenceOutline, FlownBall, States } from "../answers.js" */
/** @import { App } from "../shell/main.js" */
/** @import { Point } from "../charts/pen.js" */
/** @import { Way } from "../bat/batpaint.js" */

/** @typedef {(right: number, out: number) => Point} Placing from a place on the field, m from home, to a pixel */
const LEFT = 42, RIGHT = 14, TOP = 16, FOOT = 34;
const ROW = 16;
const BASE = 27.432; // m between bases
const MOUND = 18.44;

// Where a ball is at a moment, straight between the points of its path.
/** @param {DrawnPath} given @param {number} moment */
function placeAt({ time_s: times, distance_m, right_m, out_m, up_m }, moment) {
  const at = (/** @type {number[]} */ values) => between(times, values, Math.min(times[times.length - 1], Math.max(times[0], moment))) ?? 0;
  return { distance_m: at(distance_m), right_m: at(right_m), out_m: at(out_m), up_m: at(up_m) };
}

export class SidePicture {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {FlownBall | null} */
    this.data = null;
    /** @type {number | null} */
    this.moment = null;
    this.surface = new Surface(app, { height: (width) => this.tall(width), paint: (...all) => this.paint(...all) });
    this.element = this.surface.element;
    this.numbers = new Numbers(app, "This path as a table", () => this.data && this.tabled(this.data));
  }

  // Where the ball is at even times, and where it would be without air.
  /** @param {FlownBall} answer */
  tabled({ path, path_without_air: vacuum }) {
    const { units } = this.app;
    const shown = (/** @type {string} */ kind, /** @type {number} */ value) => toShown(kind, value, units).toFixed(kindOf(kind)[units].digits).replace(/^-(0(\.0*)?)$/, "$1").replace("-", "−");
    const unit = unitOf("distance", units);
    const rows = evenly(path.time_s, 13).map((moment) => {
      const [here, there] = [placeAt(path, moment), placeAt(vacuum, moment)];
      return [shown("seconds", moment), ...[here.distance_m, here.up_m, here.right_m, there.distance_m, there.up_m].map((value) => shown("distance", value))];
    });
    return { caption: "The ball's path", rows, columns: ["Time, s", `Over the ground, ${unit}`, `Height, ${unit}`, `To the right, ${unit}`, `Without air: over the ground, ${unit}`, `Without air: height, ${unit}`] };
  }

  /** @param {FlownBall} answer */
  draw(answer) {
    this.data = answer;
    this.numbers.redraw();
    this.surface.label(answer.side[this.app.units].join(" "));
    this.surface.draw();
  }

  // The ball on its way; null: the whole path.
  /** @param {number | null} moment */
  at(moment) {
    this.moment = moment;
    this.surface.draw();
  }

  /** @param {FlownBall} data */
  reach({ flight, path_without_air: vacuum, park, end }) {
    const fence = this.fence({ park, end });
    const highest = Math.max(flight.apex_m, fence.height, 12, Math.min(Math.max(...vacuum.up_m), 1.3 * flight.apex_m));
    return { far: 1.06 * Math.max(flight.carry_m, fence.distance, 40), high: 1.12 * highest };
  }

  // The fence in the direction in which the ball passes or would pass it.
  /** @param {Pick<FlownBall, "park" | "end">} data */
  fence({ park, end }) {
    const wanted = Math.min(park.direction_rad.at(-1) ?? 0, Math.max(park.direction_rad[0], end.direction_rad));
    const at = park.direction_rad.findIndex((direction) => direction >= wanted - 1e-9);
    return { distance: park.distance_m[at], height: park.height_m[at] };
  }

  /** @param {number} width */
  tall(width) {
    if (!this.data) return 200;
    const { far, high } = this.reach(this.data);
    const room = TOP + FOOT + (high / far) * (width - LEFT - RIGHT);
    return Math.max(150, ROW * Math.ceil(room / ROW)); // in steps, so that what lies below seldom moves
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    if (!this.data) return;
    const { colors } = this.app;
    const { far } = this.reach(this.data);
    const scale = (width - LEFT - RIGHT) / far;
    const [across, up] = [(/** @type {number} */ x) => LEFT + x * scale, (/** @type {number} */ z) => height - FOOT - z * scale];
    this.paintAxes(context, { width, height, across, up, far, scale });
    const { path, path_without_air: vacuum, end, margin } = this.data;
    const { distance, height: top } = this.fence(this.data);
    const points = (/** @type {{ distance_m: number[], up_m: number[] }} */ { distance_m, up_m }) => distance_m.map((x, i) => /** @type {Point} */ ([across(x), up(up_m[i])]));
    context.save();
    context.beginPath();
    context.rect(LEFT, 0, width - LEFT - RIGHT, height - FOOT + 6);
    context.clip();
    line(context, points(vacuum), colors.muted, 1.4, [4, 4]);
    line(context, points(path), colors.red, 2.6);
    if (this.moment !== null) {
      const here = placeAt(path, this.moment);
      dot(context, [across(here.distance_m), up(here.up_m)], 7, { fill: colors.ink });
    }
    context.restore();
    line(context, [[across(distance), up(0)], [across(distance), up(top)]], colors.green, 5);
    const roomy = across(distance) < width - 100 && !((end.clearance_m ?? 0) > 0); // beyond a fence that it clears the ball comes down
    Object.assign(context, { font: `600 11px ${FONT}`, textAlign: roomy ? "left" : "right", textBaseline: "middle" });
    haloText(context, `fence ${this.app.text("distance", top)}`, across(distance) + (roomy ? 7 : -7), up(0) - 8, colors.ink, colors.panel);
    context.textAlign = "right";
    if (end.clearance_m !== null) {
      const [x, y] = [across(end.distance_m), up(end.height_m)];
      dot(context, [x, y], 4.5, { fill: colors.red });
      haloText(context, margin[this.app.units].join(" "), x - 9, Math.min(y + 12, up(0) - 24), colors.ink, colors.panel);
    }
    Object.assign(context, { font: `11px ${FONT}`, textAlign: "left" });
    const high = vacuum.up_m.indexOf(Math.max(...vacuum.up_m));
    haloText(context, "without air", Math.min(width - 80, across(vacuum.distance_m[high])), Math.max(10, up(vacuum.up_m[high]) - 9), colors.muted, colors.panel);
  }

  /** @param {CanvasRenderingContext2D} context @param {{ width: number, height: number, across: Way, up: Way, far: number, scale: number }} given */
  paintAxes(context, { width, height, across, up, far, scale }) {
    const { colors, units } = this.app;
    Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted, textAlign: "right", textBaseline: "middle" });
    const room = (height - FOOT - TOP) / scale;
    for (const value of ticks(0, toShown("distance", room, units), (height - FOOT) / 34)) {
      const y = up(fromShown("distance", value, units));
      line(context, [[LEFT, y], [width - RIGHT, y]], value ? colors.grid : colors.line);
      context.fillText(String(value), LEFT - 6, y);
    }
    Object.assign(context, { textAlign: "center", textBaseline: "top" });
    for (const value of ticks(0, toShown("distance", far, units), width / 80)) {
      const x = across(fromShown("distance", value, units));
      line(context, [[x, up(0)], [x, up(0) + 4]], colors.line);
      context.fillText(String(value), x, height - FOOT + 6);
    }
    context.textAlign = "right";
    context.fillText(`${unitOf("distance", units)} over the ground from home plate`, width - RIGHT, height - 15);
  }
}

export class FieldPicture {
  // onLand({ distance, direction }, { last }): where the ball comes down is dragged; onWind: the wind's arrow is.
  /** @param {App} app */
  constructor(app, /** @type {{ onLand: (place: { distance: number, direction: number }, on: { last: boolean }) => boolean, onWind: (wind: { wind_speed_mph: number, wind_direction_deg: number }, on: { last: boolean }) => void }} */ { onLand, onWind }) {
    this.app = app;
    /** @type {FlownBall | null} */
    this.data = null;
    /** @type {number | null} */
    this.moment = null;
    /** @type {FenceOutline[] | null} */
    this.fences = null;
    this.winding = false;
    this.wind = { wind_speed_mph: 0, wind_direction_deg: 0 };
    /** @type {Point | null} */
    this.plate = null; // where home plate is painted
    this.scale = 1; // pixels per m
    /** @type {number | null} */
    this.steady = null; // that scale while the ball is dragged, else it would flee from the hand
    /** @type {Point} */
    this.vane = [0, 0]; // where the wind's arrow is painted
    /** @type {Point} */
    this.landed = [-99, -99]; // where the ball comes down
    this.surface = new Surface(app, { height: (width) => 0.98 * width, paint: (...all) => this.paint(...all) });
    this.element = this.surface.element;
    this.element.style.cursor = "grab";
    this.surface.drags(({ x, y, first, last }) => {
      if (!this.plate) return false;
      if (first) this.winding = this.onVane(x, y);
      if (this.winding) return onWind(this.windFrom(x, y), { last });
      const [right, out] = [(x - this.plate[0]) / this.scale, (this.plate[1] - y) / this.scale];
      const drag = onLand({ distance: Math.hypot(right, out), direction: Math.atan2(right, out) }, { last });
      this.steady = drag && !last ? this.scale : null;
      return drag;
    }, ({ x, y }) => this.onVane(x, y) || Math.hypot(x - this.landed[0], y - this.landed[1]) < 24);
  }

  /** @param {number} x @param {number} y */
  onVane(x, y) { return Math.hypot(x - this.vane[0], y - this.vane[1]) < 34; }

  // The arrow's length is the wind's speed, as it is painted.
  /** @param {number} x @param {number} y */
  windFrom(x, y) {
    const [right, out] = [x - this.vane[0], this.vane[1] - y];
    const speed = Math.min(50, Math.max(0, Math.round((Math.hypot(right, out) - 8) / 0.6)));
    const degrees = Math.round((Math.atan2(right, out) * 180) / Math.PI / 5) * 5;
    return { wind_speed_mph: speed, wind_direction_deg: degrees };
  }

  /** @param {number | null} moment */
  at(moment) {
    this.moment = moment;
    this.surface.draw();
  }

  /** @param {FenceOutline[] | null} fences */
  others(fences) {
    this.fences = fences;
    this.surface.draw();
  }

  /** @param {FlownBall} answer @param {States["flight"]} wind */
  draw(answer, wind) {
    Object.assign(this, { data: answer, wind });
    this.surface.label(answer.above[this.app.units].join(" "));
    this.surface.draw();
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    if (!this.data) return;
    const { colors } = this.app;
    const { park, path, flight, end } = this.data;
    const reach = 1.05 * Math.max(...park.out_m, ...path.out_m, 60);
    const wide = 1.05 * Math.max(...park.right_m.map(Math.abs), ...path.right_m.map(Math.abs));
    const scale = this.steady ?? Math.min((height - 30) / (reach + 6), width / (2 * wide));
    /** @type {(right: number, out: number) => Point} */
    const at = (right, out) => [width / 2 + right * scale, height - 14 - (out + 4) * scale];
    /** @type {Point[]} */
    const fence = park.right_m.map((right, i) => at(right, park.out_m[i]));
    this.plate = at(0, 0);
    this.scale = scale;
    this.vane = [46, height - 66];
    shape(context, [at(0, 0), ...fence], { fill: colors.grass });
    this.paintInfield(context, at, scale, fence);
    for (const other of this.fences ?? []) line(context, other.right_m.map((right, i) => at(right, other.out_m[i])), colors.line, 0.7);
    park.height_m.slice(1).forEach((high, i) => line(context, fence.slice(i, i + 2), colors.green, Math.min(9, 1.5 + 0.6 * high))); // the thicker the higher it is
    line(context, path.right_m.map((right, i) => at(right, path.out_m[i])), colors.red, 2.6);
    this.landed = at(path.right_m.at(-1) ?? 0, path.out_m.at(-1) ?? 0);
    dot(context, this.landed, 6, { fill: colors.red });
    if (this.moment !== null) {
      const here = placeAt(path, this.moment);
      dot(context, at(here.right_m, here.out_m), 5 + here.up_m / 8, { fill: colors.ink });
    }
    if (end.clearance_m !== null) {
      const place = at(end.distance_m * Math.sin(end.direction_rad), end.distance_m * Math.cos(end.direction_rad));
      dot(context, place, 3.5, { fill: colors.ink });
    }
    Object.assign(context, { font: `600 12px ${FONT}`, textAlign: "center", textBaseline: "middle" });
    const [x, y] = this.landed;
    haloText(context, this.app.text("distance", flight.carry_m), Math.min(width - 30, Math.max(30, x)), Math.max(10, y - 13), colors.ink, colors.panel);
    this.paintDistances(context, fence, park);
    this.paintWind(context);
  }

  // Dirt and grass of the infield, the bases and the foul lines.
  /** @param {CanvasRenderingContext2D} context @param {Placing} at @param {number} scale @param {Point[]} fence */
  paintInfield(context, at, scale, fence) {
    const { colors } = this.app;
    const [first, last] = [fence[0], fence[fence.length - 1]];
    context.save();
    shape(context, [at(0, -2), first, [last[0], first[1]], last], {});
    context.clip();
    dot(context, at(0, MOUND), 28.956 * scale, { fill: colors.dirt }); // 95 ft about the pitcher's plate
    context.restore();
    const h = BASE / Math.SQRT2;
    shape(context, [[0, 2], [h - 2, h], [0, 2 * h - 2], [2 - h, h]].map(([right, out]) => at(right, out)), { fill: colors.grass });
    line(context, [first, at(0, 0), last], colors.paper, 1.5);
    for (const [right, out] of [[0, 0], [h, h], [0, 2 * h], [-h, h]]) dot(context, at(right, out), 2.5, { fill: colors.ink });
    dot(context, at(0, MOUND), 2.5, { fill: colors.ink });
  }

  /** @param {CanvasRenderingContext2D} context @param {Point[]} fence @param {DrawnPark} park */
  paintDistances(context, fence, park) {
    const { colors } = this.app;
    const last = fence.length - 1;
    Object.assign(context, { font: `11px ${FONT}`, textAlign: "center", textBaseline: "middle" });
    for (const i of [0, Math.round(last / 2), last]) {
      const [x, y] = fence[i];
      const words = this.app.text("distance", park.distance_m[i]);
      const shift = i === 0 ? 26 : i === last ? -26 : 0;
      haloText(context, words, x + shift, y + 15, colors.muted, colors.panel);
    }
  }

  // The wind's arrow down in the corner, where no ball goes; it can be dragged.
  /** @param {CanvasRenderingContext2D} context */
  paintWind(context) {
    const { wind_speed_mph: speed, wind_direction_deg: to } = this.wind;
    const { colors } = this.app;
    const [[x, y], angle] = [this.vane, (to * Math.PI) / 180];
    dot(context, [x, y], 8, { edge: colors.line, width: 1 });
    const reach = 8 + speed * 0.6;
    if (speed) arrow(context, [x, y], [x + reach * Math.sin(angle), y - reach * Math.cos(angle)], colors.blue, 3);
    Object.assign(context, { font: `11px ${FONT}`, textAlign: "left", textBaseline: "middle" });
    haloText(context, speed ? `wind ${this.app.text("wind_mph", speed, this.app.units === "us" ? 0 : 1)}` : "no wind", 6, y + 46, colors.ink, colors.panel);
  }
}
