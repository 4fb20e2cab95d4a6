// A motion of the bat: above, the bat at rest with the still places marked; below, the bat moving, larger than life.

import { paintBat, radiusAt } from "./batview.js";
import { FONT, haloText } from "../charts/surface.js";
/** @import { ModesAnswer, BatMotion } from "../answers.js" */
/** @import { App, Colors } from "../shell/main.js" */

const PAD = 16, TOP = 34, SIDES = 120;
const SWING = 0.085; // m of drawing for the largest place of a motion of size 1
const ROUND = 0.3; // part of the barrel's radius, for a hoop motion of size 1

/** @typedef {{ answer: ModesAnswer, motion: BatMotion, phase: number, size: number, both: boolean, colors: Colors, text: (name: string, value: number, digits?: number) => string }} Shown */
export class Stage {
  /**
   * @param {ModesAnswer} answer
   * @param {number} width
   */
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
  context.strokeStyle = colors.line;
  context.lineWidth = 1;
  context.setLineDash([5, 5]);
  context.beginPath();
  context.moveTo(stage.across(0), stage.axis);
  context.lineTo(stage.across(answer.bat.length_m), stage.axis);
  context.stroke();
  context.setLineDash([]);
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
  context.strokeStyle = colors.muted;
  context.lineWidth = 3;
  for (const hand of answer.hands_m) {
    const reach = radiusAt(stage.bat, hand) * stage.scale + 6;
    for (const side of [-1, 1]) {
      context.beginPath();
      context.moveTo(stage.across(hand - 0.025), stage.rest + side * reach);
      context.lineTo(stage.across(hand + 0.025), stage.rest + side * reach);
      context.stroke();
    }
  }
  const { position_m: place } = answer.tap;
  const [x, y] = [stage.across(place), stage.rest - radiusAt(stage.bat, place) * stage.scale - 3];
  context.fillStyle = colors.red;
  context.strokeStyle = colors.red;
  context.lineWidth = 3;
  context.beginPath();
  context.moveTo(x, y - 22);
  context.lineTo(x, y - 8);
  context.stroke();
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x - 5, y - 9);
  context.lineTo(x + 5, y - 9);
  context.closePath();
  context.fill();
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
    context.beginPath();
    for (const [x, y, radius] of edges) context.lineTo(x, y - radius);
    for (const [x, y, radius] of [...edges].reverse()) context.lineTo(x, y + radius);
    context.closePath();
    context.fillStyle = stage.bat.hollow ? colors.metal : colors.wood;
    context.fill();
    context.strokeStyle = stage.bat.hollow ? colors.metalEdge : colors.woodEdge;
    context.lineWidth = 1.2;
    context.stroke();
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
  const places = answer.place_m.filter((/** @type {number} */ x) => x >= (answer.hoop_start_m ?? 0) - 0.03);
  const draw = (/** @type {number} */ part, /** @type {boolean} */ filled) => {
    const move = (/** @type {number} */ x) => part * largest * between(answer.place_m, motion.shape, x);
    context.beginPath();
    for (const x of places) context.lineTo(stage.across(x), stage.axis - (radiusAt(stage.bat, x) + move(x)) * stage.scale);
    for (const x of [...places].reverse()) context.lineTo(stage.across(x), stage.axis + (radiusAt(stage.bat, x) + opposite * move(x)) * stage.scale);
    context.closePath();
    context.fillStyle = colors.metal;
    if (filled) context.fill();
    context.strokeStyle = colors.metalEdge;
    context.lineWidth = 1.3;
    context.setLineDash(filled ? [] : [3, 3]);
    context.stroke();
    context.setLineDash([]);
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
  const top = motion.shape.reduce((/** @type {number} */ best, /** @type {number} */ value, /** @type {number} */ i) => (Math.abs(value) > Math.abs(motion.shape[best]) ? i : best), 0);
  const place = answer.place_m[top];
  const zoom = Math.min(1.25, (0.42 * stage.width) / (stage.scale * 4.4 * stage.widest));
  const radius = radiusAt(stage.bat, place);
  const [x, y] = [stage.across(0) + 2 * stage.widest * stage.scale * zoom, stage.axis];
  const ring = (/** @type {number} */ part) => {
    context.beginPath();
    for (let i = 0; i <= SIDES; i += 1) {
      const angle = (2 * Math.PI * i) / SIDES;
      const reach = (radius + part * largest * motion.shape[top] * Math.cos(motion.harmonic * angle)) * stage.scale * zoom;
      context.lineTo(x + reach * Math.sin(angle), y - reach * Math.cos(angle));
    }
    context.closePath();
  };
  context.strokeStyle = colors.line;
  context.lineWidth = 1;
  context.setLineDash([4, 4]);
  context.beginPath();
  context.ellipse(x, y, radius * stage.scale * zoom, radius * stage.scale * zoom, 0, 0, 2 * Math.PI);
  context.stroke();
  context.setLineDash([]);
  context.strokeStyle = colors.metalEdge;
  if (both) {
    context.globalAlpha = 0.4;
    context.lineWidth = 2;
    ring(-phase);
    context.stroke();
    context.globalAlpha = 1;
  }
  context.lineWidth = 4;
  ring(phase);
  context.stroke();
  context.fillStyle = colors.accent;
  for (let k = 0; k < 2 * motion.harmonic; k += 1) {
    const angle = ((k + 0.5) * Math.PI) / motion.harmonic;
    context.beginPath();
    context.arc(x + radius * stage.scale * zoom * Math.sin(angle), y - radius * stage.scale * zoom * Math.cos(angle), 4, 0, 2 * Math.PI);
    context.fill();
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
  motion.nodes_m.forEach((/** @type {number} */ node) => {
    const x = stage.across(node);
    context.strokeStyle = colors.accent;
    context.lineWidth = 1.3;
    context.setLineDash([3, 3]);
    context.beginPath();
    context.moveTo(x, stage.rest);
    context.lineTo(x, stage.axis);
    context.stroke();
    context.setLineDash([]);
    for (const y of [stage.rest, stage.axis]) {
      context.beginPath();
      context.arc(x, y, 4.5, 0, 2 * Math.PI);
      context.fillStyle = colors.accent;
      context.fill();
      context.strokeStyle = colors.panel;
      context.stroke();
    }
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

/**
 * @param {number[]} places
 * @param {number[]} values
 * @param {number} x
 */
export function between(places, values, x) {
  const step = places[1] - places[0];
  const i = Math.min(places.length - 2, Math.max(0, Math.floor(x / step + 1e-9)));
  return values[i] + ((x - places[i]) / (places[i + 1] - places[i])) * (values[i + 1] - values[i]);
}
