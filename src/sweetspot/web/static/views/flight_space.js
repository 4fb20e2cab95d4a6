// A swing and a hit in space, to turn by hand: the plane of the swing and the barrel's path in it, how far off its axis
// the bat meets the ball, and how the ball leaves and turns. Nothing is nearer by being larger: lengths can be compared.
//
//   const space = new SpaceFold(app, () => path of the ball);   asks for the aside "space" once it is open
//   box.append(space.element);
//   space.update();          // after every answer

import { button } from "../controls/controls.js";
import { make, tell } from "../controls/parts.js";
import { dot, line, shape } from "../charts/pen.js";
import { FONT, Surface, arrow, haloText } from "../charts/surface.js";
/** @import { DrawnPath, FlownBall, HitInSpace } from "../answers.js" */
/** @import { AppOf } from "../shell/main.js" */
/** @import { Point } from "../charts/pen.js" */

/** @typedef {number[]} Vector to the right, to centre field, up */

const HEIGHT = 380, NEAR = 0.3, FAR = 8; // px; m that the picture is high
const FIRST = { turn: 0.85, rise: 0.2, high: 0.95 }; // rad round to the right and up from behind home plate; m
const WIDE = 0.62; // of a picture's width, beyond which its height makes it no larger
const STEEPEST = 1.5, STEP = 0.1, PIXELS = 160; // rad; rad of a key; px of a radian
const SWUNG = [-1.25, 0.35], GHOSTS = [-0.85, -0.42]; // rad of the swing that are drawn, before and after
const PLATE = [[-0.2159, 0.4318], [0.2159, 0.4318], [0.2159, 0.2159], [0, 0], [-0.2159, 0.2159]]; // m, of the rules
const FARTHEST = 4; // m that the ball is followed
const ROUND = Array.from({ length: 41 }, (_, i) => (i / 40) * 2 * Math.PI);
/** @type {Record<string, [number, number]>} */
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const plus = (/** @type {Vector} */ a, /** @type {Vector} */ b, factor = 1) => a.map((value, i) => value + factor * b[i]);
const dotted = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const size = (/** @type {Vector} */ a) => Math.sqrt(dotted(a, a));
const unit = (/** @type {Vector} */ a) => a.map((value) => value / (size(a) || 1));
const cross = (/** @type {Vector} */ a, /** @type {Vector} */ b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export class SpaceFold {
  /** @param {AppOf<"flight">} app */
  constructor(app) {
    this.app = app;
    /** @type {HitInSpace | null} */
    this.hit = null;
    /** @type {DrawnPath | null} */
    this.path = null;
    this.view = { ...FIRST };
    this.words = make("p", { className: "words" });
    this.surface = new Surface(app, { height: () => HEIGHT, paint: (...all) => this.paint(...all), label: "The swing and the hit in space" });
    const canvas = this.surface.element;
    canvas.tabIndex = 0;
    canvas.style.cursor = "grab";
    let from = { x: 0, y: 0, ...this.view };
    this.surface.drags(({ x, y, first }) => {
      if (first) from = { x, y, ...this.view };
      this.look(from.turn - (x - from.x) / PIXELS, from.rise + (y - from.y) / PIXELS);
    });
    canvas.addEventListener("keydown", (event) => {
      const way = KEYS[event.key];
      if (!way) return;
      event.preventDefault();
      this.look(this.view.turn + way[0] * STEP, this.view.rise + way[1] * STEP);
    });
    const nearer = (/** @type {number} */ factor) => {
      this.view.high = Math.min(FAR, Math.max(NEAR, this.view.high * factor));
      this.surface.draw();
    };
    const way = (/** @type {string} */ words, /** @type {number} */ turn, /** @type {number} */ rise) => button(words, () => this.look(turn, rise));
    this.element = make("details", { className: "report", id: "space", open: false }, make("summary", { textContent: "The swing and the hit in space" }), this.words, canvas,
      make("div", { className: "row tight" }, button("Nearer", () => nearer(1 / 1.5)), button("Farther", () => nearer(1.5)),
        way("From behind", 0, 0.1), way("From the side", Math.PI / 2, 0.05), way("From above", 0, STEEPEST)),
      make("p", { className: "note", textContent: "Drag the picture, or use the arrow keys, to walk around it. Pale: where the bat came from, and the plane that it swings in." }));
    this.element.addEventListener("toggle", () => this.ask());
  }

  /** @param {FlownBall | null} answer  null: the ball has its own numbers, or is missed */
  update(answer) {
    this.element.hidden = answer?.start !== "swing";
    this.path = answer?.path ?? null;
    this.ask();
  }

  ask() {
    if (this.element.hidden || !this.element.open) return;
    this.app.aside("space", ["own_elevation"], 60, (found) => {
      this.hit = found;
      this.draw();
    });
    this.draw();
  }

  draw() {
    if (!this.hit) return;
    const words = this.hit.sentence[this.app.units].join(" ");
    tell(this.words, words);
    this.surface.label(words);
    this.surface.draw();
  }

  /** @param {number} turn @param {number} rise */
  look(turn, rise) {
    Object.assign(this.view, { turn, rise: Math.min(STEEPEST, Math.max(-0.3, rise)) });
    this.surface.draw();
  }

  // From a place to a pixel, and how far behind the ball it lies.
  /** @param {number} width @param {number} height */
  camera(width, height) {
    const { turn, rise, high } = this.view, { ball_m: middle = [0, 0, 0] } = this.hit ?? {};
    const right = [Math.cos(turn), Math.sin(turn), 0], level = [-Math.sin(turn), Math.cos(turn), 0];
    const ahead = plus([0, 0, -Math.sin(rise)], level, Math.cos(rise)), up = plus([0, 0, Math.cos(rise)], level, Math.sin(rise));
    const scale = Math.min(height, WIDE * width) / high;
    /** @type {(place: Vector) => Point} */
    const at = (place) => {
      const from = plus(place, middle, -1);
      return [width / 2 + scale * dotted(from, right), 0.6 * height - scale * dotted(from, up)];
    };
    return { at, scale, deep: (/** @type {Vector} */ place) => dotted(plus(place, middle, -1), ahead) };
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    if (!this.hit) return;
    const { hit, app: { colors } } = this, look = this.camera(width, height), { at } = look;
    const { forward, tip, pivot_m: pivot, place_m: place, axis_m: axis, ball_m: ball, outline } = hit;
    context.font = `600 12px ${FONT}`;
    context.textBaseline = "middle";
    shape(context, PLATE.map(([right, out]) => at([right, out, 0])), { fill: colors.panel, edge: colors.line });
    const hub = plus(axis, tip, pivot - place), long = outline.position_m[outline.position_m.length - 1] - pivot;
    const swung = (/** @type {number} */ turn, /** @type {Vector} */ along = tip, /** @type {Vector} */ way = forward) => plus(along.map((value) => Math.cos(turn) * value), way, Math.sin(turn));
    const arc = Array.from({ length: 25 }, (_, i) => SWUNG[0] + (i / 24) * (SWUNG[1] - SWUNG[0])).map((turn) => at(plus(hub, swung(turn), long)));
    context.globalAlpha = 0.55;
    shape(context, [at(hub), ...arc], { fill: colors.zone, edge: colors.zoneEdge });
    for (const turn of GHOSTS) this.paintBat(context, look, hub, swung(turn), 0.25);
    context.globalAlpha = 1;
    this.paintPaths(context, look);
    const over = look.deep(ball) < look.deep(axis), bat = () => this.paintBat(context, look, hub, tip, 1);
    if (over) bat();
    this.paintBall(context, look);
    if (!over) bat();
    this.paintAngles(context, look);
  }

  // A solid of revolution, seen from far away: as wide as it is, about its axis.
  /** @param {CanvasRenderingContext2D} context @param {ReturnType<SpaceFold["camera"]>} look @param {Vector} hub @param {Vector} along @param {number} strength */
  paintBat(context, { at, scale }, hub, along, strength) {
    const { app: { colors }, hit } = this;
    if (!hit) return;
    const { position_m: places, diameter_m: wide } = hit.outline;
    const [[x0, y0], [x1, y1]] = [at(hub), at(plus(hub, along))], length = Math.hypot(x1 - x0, y1 - y0) || 1;
    const [aside, up] = [(y1 - y0) / length, -(x1 - x0) / length];
    const edge = (/** @type {number} */ side) => places.map((place, i) => {
      const [x, y] = at(plus(hub, along, place - hit.pivot_m)), radius = (side * wide[i] * scale) / 2;
      return [x + aside * radius, y + up * radius];
    });
    const seen = length / scale, last = places.length - 1; // 1: square to the line of sight; 0: along it
    const end = at(plus(hub, along, places[last] - hit.pivot_m)), tall = (wide[last] * scale) / 2;
    context.globalAlpha = strength;
    shape(context, [...edge(1), ...edge(-1).reverse()], { fill: colors.wood, edge: colors.woodEdge });
    context.beginPath();
    context.ellipse(end[0], end[1], tall * Math.sqrt(Math.max(0, 1 - seen * seen)), tall, Math.atan2(y1 - y0, x1 - x0), 0, 2 * Math.PI);
    Object.assign(context, { fillStyle: colors.wood, strokeStyle: colors.woodEdge, lineWidth: 1.3 });
    context.fill();
    context.stroke();
    context.globalAlpha = 1;
  }

  // The pitch as it comes, and the first metres of the ball's flight.
  /** @param {CanvasRenderingContext2D} context @param {ReturnType<SpaceFold["camera"]>} look */
  paintPaths(context, { at, scale }) {
    const { app: { colors }, hit, path } = this;
    if (!hit) return;
    const { ball_m: ball, radius_m: radius, pitch_m_s: pitch, leaves_m_s: leaves } = hit, back = unit(pitch);
    const room = HEIGHT / scale;
    arrow(context, at(plus(ball, back, -Math.min(FARTHEST, 1.2 * room))), at(plus(ball, back, -1.3 * radius)), colors.blue, 1.6);
    const places = path ? path.time_s.map((_, i) => [path.right_m[i], path.out_m[i], path.up_m[i]]).filter((place) => size(plus(place, ball, -1)) < FARTHEST) : [];
    const far = plus(ball, unit(leaves), Math.min(FARTHEST, 0.75 * room));
    line(context, [at(ball), ...places.filter((place) => size(plus(place, ball, -1)) < 0.75 * room).map(at)], colors.orange, 2.4);
    arrow(context, at(ball), at(far), colors.orange, 2.4);
  }

  // The ball with its seams' colour, the axis that it turns about, and which way.
  /** @param {CanvasRenderingContext2D} context @param {ReturnType<SpaceFold["camera"]>} look */
  paintBall(context, { at, scale, deep }) {
    const { app: { colors }, hit } = this;
    if (!hit) return;
    const { ball_m: ball, radius_m: radius, spin_rad_s: spin } = hit, axis = unit(spin), turns = size(spin) > 1;
    const first = unit(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), second = cross(axis, first);
    const ring = (/** @type {number} */ angle, /** @type {number} */ times) => plus(plus(ball, first, times * radius * Math.cos(angle)), second, times * radius * Math.sin(angle));
    const long = Math.max(2.2 * radius, 46 / scale), [start, end] = [at(plus(ball, axis, -long)), at(plus(ball, axis, long))];
    if (turns) arrow(context, start, end, colors.purple, 2);
    dot(context, at(ball), radius * scale, { fill: colors.paper, edge: colors.ink, width: 1.5 });
    if (!turns) return;
    const near = ROUND.map((angle) => ring(angle, 1)).filter((place) => deep(place) <= 0).map(at); // the equator's near half
    line(context, near.sort(([x], [y]) => x - y), colors.red, 1.2);
    const out = Math.max(1.5, 22 / (radius * scale)), sweep = ROUND.slice(4, 32).map((angle) => at(ring(angle, out)));
    line(context, sweep.slice(0, -1), colors.purple, 1.6);
    arrow(context, sweep[sweep.length - 3], sweep[sweep.length - 1], colors.purple, 1.6);
    if (deep(plus(ball, axis)) < 0) arrow(context, at(ball), end, colors.purple, 2);
  }

  // What the sentence says, where it is: the barrel's path above the level, the offset, the speeds and the spin.
  /** @param {CanvasRenderingContext2D} context @param {ReturnType<SpaceFold["camera"]>} look */
  paintAngles(context, { at, scale }) {
    const { app, hit } = this, { colors, state } = app;
    if (!hit) return;
    const { ball_m: ball, axis_m: axis, forward, radius_m: radius, leaves_m_s: leaves, spin_rad_s: spin, pitch_m_s: pitch } = hit;
    const room = HEIGHT / scale, reach = 0.34 * room, level = unit([forward[0], forward[1], 0]);
    const from = plus(axis, forward, dotted(plus(ball, axis, -1), forward));
    line(context, [at(axis), at(plus(axis, level, reach))], colors.muted, 1, [5, 4]);
    arrow(context, at(axis), at(plus(axis, forward, reach)), colors.green, 2);
    if (Math.abs(dotted(plus(ball, from, -1), plus(ball, from, -1))) > 1e-8) line(context, [at(from), at(ball)], colors.red, 2.4);
    const degrees = (/** @type {number} */ value) => app.text("angle_rad", (value * Math.PI) / 180, 0);
    /** @type {[string, Vector, string, number][]} */
    const labels = [
      [`barrel's path ${degrees(state.attack_angle_deg)}`, plus(axis, forward, reach), colors.green, 14],
      [`off the axis ${app.text("offset_m", Math.abs(dotted(plus(ball, from, -1), hit.up)))}`, plus(from, forward, 1.4 * radius), colors.red, 16],
      [`${app.text("exit_speed_m_s", size(leaves))}`, plus(ball, unit(leaves), 0.62 * room), colors.ink, -14],
      [`pitch ${app.text("pitch_speed_m_s", size(pitch))}`, plus(ball, unit(pitch), -0.5 * room), colors.blue, -12],
      [`${app.text("spin_rad_s", size(spin))}`, plus(ball, unit(spin), Math.max(2.2 * radius, 46 / scale)), colors.ink, -10],
      [`plane tilted ${degrees(state.tilt_deg)}`, plus(plus(axis, hit.tip, hit.pivot_m - hit.place_m), plus(hit.tip, forward, -0.7), 0.55 * hit.place_m), colors.zoneInk, 0],
    ];
    /** @type {[number, number, number, number][]} */
    const taken = [];
    context.textAlign = "left";
    for (const [words, place, color, down] of labels) {
      const wide = context.measureText(words).width;
      let [x, y] = at(place);
      x = Math.min(this.surface.width - wide - 4, Math.max(4, x + 8));
      y = Math.min(HEIGHT - 10, Math.max(10, y + down));
      while (taken.some(([left, top, w]) => x < left + w && left < x + wide && Math.abs(top - y) < 16) && y < HEIGHT - 12) y += 4;
      taken.push([x, y, wide, 16]);
      haloText(context, words, x, y, color, colors.panel);
    }
  }
}
