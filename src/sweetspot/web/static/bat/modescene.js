// A motion of the bat: above, the bat at rest with the still places marked; below, the bat moving, larger than life.

import { around, between, looks, paintBat, radiusAt } from "./batpaint.js";
import { dot, line, shape } from "../charts/pen.js";
import { FONT, haloText } from "../charts/surface.js";
/** @import { ModesAnswer, BatMotion } from "../answers.js" */
/** @import { App, Colors } from "../shell/main.js" */

const PAD = 16, TOP = 34, SIDES = 120;
const SWING = 0.085; // m of drawing for the largest place of a motion of size 1
const ROUND = 0.3; // part of the barrel's radius, for a hoop motion of size 1

/** @typedef {{ answer: ModesAnswer, motion: BatMotion, phase: number, size: number, both: boolean, colors: Colors, text: (name: string, value: number, digits?: number) => string }} Shown */
export class Stage {
  /** @param {ModesAnswer} answer @param {number} width */
  constructor(answer, width) {
    const { bat } = answer;
    this.answer = answer;
    this.bat = bat;
    this.width = width;
    this.scale = (width - 2 * PAD) / bat.length_m;
    this.widest = Math.max(...bat.outline.diameter_m) / 2;
    this.rest = TOP + this.widest * this.scale;
    this.axis = this.rest + this.widest * this.scale + 46 + 0.12 * this.scale;
    this.height = Math.round(this.axis + 0.12 * this.scale + 34);
  }

  /** @param {number} x */
  across(x) { return PAD + x * this.scale; }
  /** @param {number} pixel */
  along(pixel) { return Math.min(this.bat.length_m, Math.max(0, (pixel - PAD) / this.scale)); }
}

// shown: { answer, motion (of answer.modes), phase: -1 to 1, size, both: draw the opposite extreme too, colors, text, app }
/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {Shown} shown
 */
export function paintMotion(context, width, height, shown) {
  const stage = new Stage(shown.answer, width);
  const { colors, answer } = shown;
  paintZone(context, stage, shown);
  paintBat(context, stage.bat, { left: PAD, scale: stage.scale, middle: stage.rest }, colors);
  paintMarks(context, stage, shown);
  line(context, [[stage.across(0), stage.axis], [stage.across(answer.bat.length_m), stage.axis]], colors.line, 1, [5, 5]);
  if (shown.motion.family === "hoop") paintHoop(context, stage, shown);
  else paintBent(context, stage, shown);
  paintNodes(context, stage, shown);
}

// Between the outer nodes of the first two bending motions: where neither is much excited.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {Stage} stage
 * @param {{ answer: ModesAnswer, motion: BatMotion, colors: Colors }} given
 */
function paintZone(context, stage, { answer, motion, colors }) {
  if (motion.family !== "bending" || motion.number > 2) return;
  const [from, to] = [answer.nodes.node_1_m, answer.nodes.node_2_m].sort((a, b) => a - b);
  context.fillStyle = colors.zone;
  context.fillRect(stage.across(from), TOP - 6, stage.across(to) - stage.across(from), stage.height - TOP - 20);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Stage} stage
 * @param {{ answer: ModesAnswer, colors: Colors }} given
 */
function paintMarks(context, stage, { answer, colors }) {
  for (const hand of answer.hands_m) {
    const reach = radiusAt(stage.bat, hand) * stage.scale + 6;
    for (const side of [-1, 1]) line(context, [-0.025, 0.025].map((beside) => [stage.across(hand + beside), stage.rest + side * reach]), colors.muted, 3);
  }
  const { position_m: place } = answer.tap;
  const [x, y] = [stage.across(place), stage.rest - radiusAt(stage.bat, place) * stage.scale - 3];
  line(context, [[x, y - 22], [x, y - 8]], colors.red, 3);
  shape(context, [[x, y], [x - 5, y - 9], [x + 5, y - 9]], { fill: colors.red });
  context.font = `600 12px ${FONT}`;
  context.textAlign = x > stage.width - 60 ? "right" : "left";
  context.textBaseline = "middle";
  haloText(context, "tap", x + (x > stage.width - 60 ? -9 : 9), y - 16, colors.ink, colors.panel);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Stage} stage
 * @param {{ motion: BatMotion, answer: ModesAnswer, phase: number, size: number, both: boolean, colors: Colors }} given
 */
function paintBent(context, stage, { motion, answer, phase, size, both, colors }) {
  const draw = (/** @type {number} */ part, /** @type {number} */ strength) => {
    const shift = (/** @type {number} */ x) => -part * size * SWING * stage.scale * between(answer.place_m, motion.shape, x);
    const edges = [...new Set([...stage.bat.outline.position_m, ...answer.place_m])].sort((a, b) => a - b)
      .map((x) => [stage.across(x), stage.axis + shift(x), radiusAt(stage.bat, x) * stage.scale]);
    context.globalAlpha = strength;
    shape(context, around(edges), looks(stage.bat, colors));
    context.globalAlpha = 1;
  };
  if (both) draw(-phase, 0.3);
  draw(phase, 1);
}

// The barrel's wall going out of round: from the side its upper and lower edge, and a cut where it moves most.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {Stage} stage
 * @param {{ motion: BatMotion, answer: ModesAnswer, phase: number, size: number, both: boolean, colors: Colors }} given
 */
function paintHoop(context, stage, { motion, answer, phase, size, both, colors }) {
  const { harmonic } = motion;
  const largest = stage.widest * ROUND * size;
  const opposite = harmonic % 2 ? -1 : 1; // cos(n pi): how the side away from the ball moves
  const places = answer.place_m.filter((x) => x >= (answer.hoop_start_m ?? 0) - 0.03);
  const draw = (/** @type {number} */ part, /** @type {boolean} */ filled) => {
    const move = (/** @type {number} */ x) => part * largest * between(answer.place_m, motion.shape, x);
    const upper = places.map((x) => [stage.across(x), stage.axis - (radiusAt(stage.bat, x) + move(x)) * stage.scale]);
    const lower = places.map((x) => [stage.across(x), stage.axis + (radiusAt(stage.bat, x) + opposite * move(x)) * stage.scale]);
    shape(context, [...upper, ...lower.reverse()], { edge: colors.metalEdge, ...(filled ? { fill: colors.metal } : { dash: [3, 3] }) });
  };
  draw(phase, true);
  if (both) draw(-phase, false);
  paintCut(context, stage, { motion, answer, phase, largest, both, colors });
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Stage} stage
 * @param {{ motion: BatMotion, answer: ModesAnswer, phase: number, largest: number, both: boolean, colors: Colors }} given
 */
function paintCut(context, stage, { motion, answer, phase, largest, both, colors }) {
  const top = motion.shape.reduce((best, value, i) => (Math.abs(value) > Math.abs(motion.shape[best]) ? i : best), 0);
  const place = answer.place_m[top];
  const zoom = Math.min(1.25, (0.42 * stage.width) / (stage.scale * 4.4 * stage.widest));
  const radius = radiusAt(stage.bat, place);
  const [x, y] = [stage.across(0) + 2 * stage.widest * stage.scale * zoom, stage.axis];
  const ring = (/** @type {number} */ part, /** @type {number} */ width) => shape(context, Array.from({ length: SIDES }, (_, i) => {
    const angle = (2 * Math.PI * i) / SIDES;
    const reach = (radius + part * largest * motion.shape[top] * Math.cos(motion.harmonic * angle)) * stage.scale * zoom;
    return [x + reach * Math.sin(angle), y - reach * Math.cos(angle)];
  }), { edge: colors.metalEdge, width });
  dot(context, [x, y], radius * stage.scale * zoom, { edge: colors.line, width: 1, dash: [4, 4] });
  if (both) {
    context.globalAlpha = 0.4;
    ring(-phase, 2);
    context.globalAlpha = 1;
  }
  ring(phase, 4);
  for (let k = 0; k < 2 * motion.harmonic; k += 1) {
    const angle = ((k + 0.5) * Math.PI) / motion.harmonic;
    dot(context, [x + radius * stage.scale * zoom * Math.sin(angle), y - radius * stage.scale * zoom * Math.cos(angle)], 4, { fill: colors.accent });
  }
  context.font = `12px ${FONT}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  haloText(context, `cut across: ${2 * motion.harmonic} still lines`, PAD, stage.height - 8, colors.muted, colors.panel);
}

// Still places: from the moving bat up to the bat at rest, with their distance from the tip.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {Stage} stage
 * @param {{ motion: BatMotion, answer: ModesAnswer, colors: Colors, text: App["text"] }} given
 */
function paintNodes(context, stage, { motion, answer, colors, text }) {
  const few = motion.nodes_m.length <= 4;
  context.font = `12px ${FONT}`;
  context.textBaseline = "middle";
  motion.nodes_m.forEach((node) => {
    const x = stage.across(node);
    line(context, [[x, stage.rest], [x, stage.axis]], colors.accent, 1.3, [3, 3]);
    for (const y of [stage.rest, stage.axis]) dot(context, [x, y], 4.5, { fill: colors.accent, edge: colors.panel });
    const words = text("node_m", answer.bat.length_m - node, few ? undefined : 1);
    const last = x > stage.width - 70; // beside its line, which would run through it
    context.textAlign = last ? "right" : "left";
    if (few || stage.width > 900) haloText(context, words, x + (last ? -7 : 7), stage.rest + stage.widest * stage.scale + 16, colors.ink, colors.panel);
  });
  context.textAlign = "right";
  context.fillStyle = colors.muted;
  context.textBaseline = "alphabetic";
  context.fillText(stage.width < 560 ? "● stands still" : "● stands still; numbers are from the tip", stage.width - PAD, stage.height - 8);
}
