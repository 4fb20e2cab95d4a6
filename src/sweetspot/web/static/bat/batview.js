// A bat drawn to scale, lying along the charts' axis: sweet spots, zone, balance point, hands and the ball.
//
//   const picture = new BatView(app, { onBall(position_m, { last }) {}, onStations(stations, { last }) {} });
//   root.append(picture.element);
//   picture.draw({ bat, sweet_spots, hands_m, ball: { position_m, radius_m } });   // bat as in web/outline.py
//   picture.drawing = true;     // the outline's stations can be dragged; draw({ ghost }): another bat's outline, dashed
//   paintBat in batpaint.js: the bat alone; place = { left, scale, middle } in pixels and pixels per m
//
// In onStations, stations are [{ position_m, diameter_m }]. Everything but drawing stations has a control of its own.

import { LEFT, RIGHT } from "../charts/chart.js";
import { WIDEST, meetingWide, paintBall, paintBat, paintMeeting, paintOutline, radiusAt } from "./batpaint.js";
import table from "../quantities.js";
import { dot, ink, line, shape } from "../charts/pen.js";
import { FONT, Surface, haloText } from "../charts/surface.js";
import { text } from "../controls/units.js";
/** @import { SweetSpotPlaces } from "../answers.js" */
/** @import { App, State } from "../shell/main.js" */
/** @import { DrawnBall, DrawnBat, Warmth } from "./batpaint.js" */
/** @import { Grip } from "./grips.js" */
/** @typedef {Exclude<keyof SweetSpotPlaces, "zone_m" | "zone_low_m" | "zone_high_m">} Spot */
/** @typedef {{ [Name in keyof SweetSpotPlaces]?: SweetSpotPlaces[Name] | null }} Spots those that are shown */
/**
 * What is shown: warm colours by values along the bat, what can be gripped, and the ball.
 * @typedef {object} Shown
 * @property {DrawnBat} bat
 * @property {Spots} [sweet_spots]
 * @property {number[]} [hands_m]
 * @property {Grip[]} [grips]
 * @property {Warmth | null} [warm]
 * @property {DrawnBall} [ball]
 * @property {Pick<DrawnBat, "outline">} [ghost] another outline over it
 */
/** @import { Zoom } from "../charts/zoom.js" */
/** @import { Place, Way } from "./batpaint.js" */

export { paintBat, radiusAt };

export const SPOTS = Object.fromEntries(Object.entries(table.spots).map(([name, { label, colour }]) => [`${name}_m`, [label, colour]]));
const ROW = 17, ROOM_BELOW = 30, HANDLE = 5;
const NARROW = 500; // pixels per m below which there is no room for words under the bat

export class BatView {
  /**
   * @param {App} app
   * @param {object} look
   * @param {((position: number, on: { last: boolean }) => void) | null} [look.onBall]
   * @param {((stations: { position_m: number, diameter_m: number }[], on: { last: boolean }) => void) | null} [look.onStations]
   * @param {((change: Partial<State>, on: { last: boolean }) => void) | null} [look.onGrip]
   * @param {Zoom | null} [look.zoom]
   * @param {string} [look.label]
   */
  constructor(app, { onBall = null, onStations = null, onGrip = null, zoom = null, label = "The bat, drawn to scale" } = {}) {
    this.app = app;
    this.onBall = onBall;
    this.onStations = onStations;
    this.onGrip = onGrip;
    this.zoom = zoom;
    this.drawing = false;
    /** @type {Shown | null} */
    this.data = null;
    this.zoneWords = { left: Infinity, top: 0 }; // px, where those of the zone are
    this.held = null;
    this.grip = null;
    this.slip = [0, 0]; // m from the hand to what it holds, along and from the axis
    this.surface = new Surface(app, { label, height: (width) => this.tall(width), paint: (context, width) => this.paint(context, width) });
    this.element = this.surface.element;
    if (zoom) zoom.listen(this.surface, (x) => this.along(x));
    if (onBall) this.listen();
  }

  /** @param {Shown} data */
  draw(data) {
    this.data = data;
    this.surface.draw();
  }
  /** @param {string} name */
  figure(name) { return this.surface.figure(name); }
  /** @param {string} words */
  label(words) { this.surface.label(words); }

  get range() { return this.zoom ? this.zoom.range : [0, this.data?.bat.length_m ?? 0.84]; }
  /** @param {number} width */
  scaleAt(width) { return (width - LEFT - RIGHT) / (this.range[1] - this.range[0]); }
  /** @param {number} x */
  along(x) {
    const { left, scale } = this.place(this.surface.width);
    return (x - left) / scale;
  }
  // Pixels above the bat, where the sweet spots have their names.
  get rows() { return this.data?.sweet_spots ? Object.keys(SPOTS).filter((name) => name in (this.data?.sweet_spots ?? {})).length * ROW + 10 : 8; }
  /** @param {number} width */
  tall(width) {
    return this.rows + (WIDEST + (this.data?.ball ? 2 * this.data.ball.radius_m : 0)) * this.scaleAt(width) + ROOM_BELOW;
  }
  /** @param {number} width */
  place(width) {
    const scale = this.scaleAt(width);
    return { left: LEFT - this.range[0] * scale, edge: LEFT, scale, middle: this.rows + (WIDEST / 2) * scale };
  }

  listen() {
    this.element.style.cursor = "grab";
    this.surface.drags(({ x, y, first, last }) => {
      if (!this.data) return false;
      const { left, scale, middle } = this.place(this.surface.width);
      const [along, aside] = [(x - left) / scale, Math.abs(y - middle) / scale];
      if (first) this.take(x, y, along, aside);
      const [at, out] = [along + this.slip[0], Math.max(0, aside + this.slip[1])];
      if (this.held !== null) this.dragStation(this.held, at, 2 * out, last);
      else if (this.grip) this.onGrip?.(this.grip.take(at, out), { last });
      else this.onBall?.(Math.min(this.data.bat.length_m, Math.max(0, along)), { last });
      return true;
    }, ({ x, y }) => Boolean(this.data && ((this.drawing && this.stationAt(x, y) !== null) || this.gripAt(x, y))));
  }

  // What is pressed, and how far beside its middle: it stays so far from the hand, and nothing jumps.
  /** @param {number} x @param {number} y @param {number} along @param {number} aside */
  take(x, y, along, aside) {
    this.held = this.drawing ? this.stationAt(x, y) : null;
    this.grip = this.held === null ? this.gripAt(x, y) : null;
    const station = this.held === null ? null : this.data?.bat.stations[this.held];
    const taken = station ? { at: station.position_m, aside: station.diameter_m / 2 } : this.grip;
    this.slip = taken ? [taken.at - along, taken.aside - aside] : [0, 0];
  }

  // What is made with the hand: the end of a hole, a cup, a weight, the top hand; see grips.js.
  /** @param {number} x @param {number} y */
  gripAt(x, y) {
    const { left, scale, middle } = this.place(this.surface.width);
    const grips = this.data?.grips ?? [];
    const far = grips.map(({ at, aside }) => Math.hypot(x - left - at * scale, Math.abs(y - middle) - aside * scale));
    const nearest = far.indexOf(Math.min(...far));
    return far[nearest] < 15 ? grips[nearest] : null;
  }

  /** @param {number} x @param {number} y */
  stationAt(x, y) {
    const { left, scale, middle } = this.place(this.surface.width);
    const far = (this.data?.bat.stations ?? []).map(({ position_m, diameter_m }) =>
      Math.hypot(x - left - position_m * scale, Math.abs(y - middle) - (diameter_m / 2) * scale));
    const nearest = far.indexOf(Math.min(...far));
    return far[nearest] < 24 ? nearest : null;
  }

  /** @param {number} index @param {number} along @param {number} width @param {boolean} last */
  dragStation(index, along, width, last) {
    const stations = (this.data?.bat.stations ?? []).map((station) => ({ ...station }));
    const inner = index > 0 && index < stations.length - 1;
    const [before, after] = [stations[index - 1]?.position_m, stations[index + 1]?.position_m];
    if (inner) stations[index].position_m = Math.min(after - 0.002, Math.max(before + 0.002, along));
    stations[index].diameter_m = Math.min(0.07, Math.max(0.015, width));
    this.onStations?.(stations, { last });
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width */
  paint(context, width) {
    if (!this.data) return;
    const { colors } = this.app;
    const { bat, sweet_spots: spots, hands_m: hands, ball, warm = null } = this.data;
    const place = this.place(width);
    const across = (/** @type {number} */ x) => place.left + x * place.scale;
    const bottom = place.middle + (WIDEST / 2 + (ball ? 2 * ball.radius_m : 0)) * place.scale;
    context.save();
    context.beginPath();
    context.rect(this.range[0] > 0 ? LEFT : 0, 0, width, bottom + ROOM_BELOW);
    context.clip();
    this.zoneWords.left = Infinity;
    if (spots?.zone_m) this.paintZone(context, spots.zone_m, across, place, bottom);
    paintBat(context, bat, place, colors, warm);
    if (this.data.ghost) paintOutline(context, this.data.ghost, place, colors.ink);
    this.paintBelow(context, bat, hands, across, place);
    if (ball) paintBall(context, ball, bat, place, colors);
    if (this.drawing) this.paintStations(context, bat, across, place);
    else this.paintGrips(context, across, place);
    context.restore();
    if (spots) this.paintSpots(context, spots, bat, across, place);
    if (ball && ball.offset_m !== undefined) {
      const [x, radius] = [across(ball.position_m), ball.radius_m * place.scale]; // beside the ball, where there is room
      const wide = meetingWide(ball, bat, place);
      const edge = [place.edge ?? 0, width - wide].find((one) => x - radius > one + wide || x + radius < one);
      if (edge !== undefined) paintMeeting(context, ball, bat, { ...place, edge }, colors, "seen from the tip");
    }
  }

  /** @param {CanvasRenderingContext2D} context @param {Way} across @param {Place} place */
  paintGrips(context, across, place) {
    const { colors } = this.app;
    for (const { at, aside } of this.data?.grips ?? []) {
      for (const side of aside ? [-1, 1] : [1]) {
        context.beginPath();
        context.rect(across(at) - 4.5, place.middle + side * aside * place.scale - 4.5, 9, 9);
        ink(context, { fill: colors.panel, edge: colors.accent, width: 2 });
      }
    }
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number[]} given
   * @param {Way} across
   * @param {Place} place
   * @param {number} bottom
   */
  paintZone(context, [from, to], across, place, bottom) {
    const { colors } = this.app;
    const top = place.middle - (WIDEST / 2) * place.scale;
    context.fillStyle = colors.zone;
    context.fillRect(across(from), top, across(to) - across(from), bottom - top + 8);
    const y = bottom + 8;
    line(context, [[across(from), y], [across(to), y]], colors.zoneEdge, 2);
    context.font = `600 12px ${FONT}`;
    context.textAlign = "right";
    context.textBaseline = "top";
    context.fillStyle = colors.zoneInk;
    const words = `sweet zone ${this.app.text("zone_m", to - from, 1)}`;
    context.fillText(words, across(to), y + 4);
    this.zoneWords = { left: across(to) - context.measureText(words).width, top: y + 4 };
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {DrawnBat} bat
   * @param {number[] | undefined} hands
   * @param {Way} across
   * @param {Place} place
   */
  paintBelow(context, bat, hands, across, place) {
    const { colors } = this.app;
    const radius = (/** @type {number} */ x) => (radiusAt(bat, x) * place.scale);
    context.font = `11px ${FONT}`;
    context.textAlign = "center";
    context.textBaseline = "top";
    if (hands) {
      for (const hand of hands) line(context, [-1, 1].map((side) => [across(hand), place.middle + side * (radius(hand) + 6)]), colors.muted, 1.5, [2, 2]);
      context.fillStyle = colors.muted;
      context.fillText("hands", across((hands[0] + hands[1]) / 2), place.middle + radius(hands[0]) + 10);
    }
    if (bat.balance_point_m === undefined) return;
    const [x, y] = [across(bat.balance_point_m), place.middle + radius(bat.balance_point_m) + 2];
    shape(context, [[x, y], [x - 5, y + 9], [x + 5, y + 9]], { fill: colors.ink });
    if (place.scale < NARROW) return;
    context.fillStyle = colors.muted;
    const words = `balance ${text("balance_point_m", bat.balance_point_m, this.app.units, 1)}`;
    const half = context.measureText(words).width / 2 + 3, { left, top } = this.zoneWords;
    const middle = this.besideBall(x, half, across, place), over = Math.abs(y + 12 - top) < 14 && middle + half > left;
    context.fillText(words, over ? left - half : middle, y + 12);
  }

  // The middle of words under the bat, moved from where the ball would cover them.
  /** @param {number} x @param {number} half @param {Way} across @param {Place} place */
  besideBall(x, half, across, place) {
    const ball = this.data?.ball;
    if (!ball) return x;
    const [at, clear] = [across(ball.position_m), ball.radius_m * place.scale + half];
    if (Math.abs(x - at) >= clear) return x;
    return x < at && at - clear - half > (place.edge ?? 0) ? at - clear : at + clear;
  }

  // Names on the left, each with a line that runs level and then down to its place; the nearest place lowest, so
  // that no line crosses another.
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Spots} spots
   * @param {DrawnBat} bat
   * @param {Way} across
   * @param {Place} place
   */
  paintSpots(context, spots, bat, across, place) {
    const { colors } = this.app;
    const [least, most] = this.range;
    const found = Object.entries(SPOTS).map(([key, [name, color]]) => ({ name, color, at: spots[/** @type {Spot} */ (key)] ?? NaN })).filter(({ at }) => at >= least && at <= most);
    found.sort((a, b) => a.at - b.at);
    const wordsOf = (/** @type {{ name: string | null, at: number }} */ { name, at }) => `${name}  ${text("spot_m", bat.length_m - at, this.app.units, 1)}`;
    context.font = `600 12px ${FONT}`;
    const widest = Math.max(0, ...found.map((one) => context.measureText(wordsOf(one)).width)) + 8;
    const ends = [found[0], found[found.length - 1]].map((one) => across(one?.at ?? 0));
    const right = ends[0] - 14 < widest && ends[1] + 14 < this.surface.width - widest; // where the names stand
    const column = right ? ends[1] + 14 : Math.max(ends[0] - 14, widest);
    if (!right) found.reverse();
    context.textBaseline = "middle";
    found.forEach(({ color, at }, row) => {
      const [x, y] = [across(at), 12 + row * ROW];
      const end = place.middle + radiusAt(bat, at) * place.scale * (0.72 - (1.44 * row) / Math.max(1, found.length - 1)) * -1;
      line(context, [[column, y], [x, y], [x, end]], colors[color ?? "ink"], 1.4);
      dot(context, [x, end], 4.5, { fill: colors[color ?? "ink"], edge: colors.panel, width: 1.4 });
    });
    const fontOf = (/** @type {(typeof found)[number]} */ one) => `${one.color === "red" ? "600 " : ""}12px ${FONT}`;
    found.forEach((one, row) => { // over all lines, which may run behind them where there is little room
      context.font = fontOf(one);
      context.textAlign = right ? "left" : "right";
      const [words, x, y] = [wordsOf(one), column + (right ? 5 : -5), 12 + row * ROW];
      const wide = context.measureText(words).width;
      context.fillStyle = colors.panel;
      context.fillRect(right ? x : x - wide, y - 7, wide, 14);
      haloText(context, words, x, y, colors.ink, colors.panel);
    });
    if (right || !found.length) return;
    const beside = "from the tip:"; // of all numbers, left of the first name, where there is room
    context.fillStyle = colors.muted;
    context.textAlign = "right";
    context.font = fontOf(found[0]);
    const end = column - context.measureText(wordsOf(found[0])).width - 20;
    context.font = `11px ${FONT}`;
    if (end - context.measureText(beside).width > LEFT) context.fillText(beside, end, 12);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {DrawnBat} bat
   * @param {Way} across
   * @param {Place} place
   */
  paintStations(context, bat, across, place) {
    const { colors } = this.app;
    for (const { position_m: position, diameter_m: diameter } of bat.stations) {
      for (const side of [-1, 1]) {
        dot(context, [across(position), place.middle + (side * diameter * place.scale) / 2], HANDLE, { fill: colors.panel, edge: colors.accent, width: 2 });
      }
    }
  }
}
