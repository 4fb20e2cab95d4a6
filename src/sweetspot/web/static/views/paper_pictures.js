// The pictures of the paper's questions, by the question's name.

import { BatView } from "../bat/batview.js";
import { Chart } from "../charts/chart.js";
import { dot } from "../charts/pen.js";
import { FONT, Surface, haloText } from "../charts/surface.js";
/** @import { BatPicture, CorkingPicture, DropPicture, EnergyPicture, PaperPicture, PercussionPicture, SpeedsPicture, SweetSpotPlaces } from "../answers.js" */
/** @import { Curve, Panel } from "../charts/chart.js" */
/** @import { App, Figure } from "../shell/main.js" */

/** @typedef {BatView | Chart | Blocks} Part */
/** @typedef {{ elements: HTMLElement[], draw: (answer: PaperPicture) => void, figures: () => Figure[] }} Drawing */

const AXIS = (/** @type {App} */ app) => ({ kind: "position_m", from: () => app.answer?.bat?.length_m ?? 0.84, label: "from the tip" });
/** @type {Curve[]} */
const REAL_AND_RIGID = [{ key: "exit_speed_m_s", label: "real bat", color: "red", width: 2.4 },
  { key: "rigid_exit_speed_m_s", label: "rigid bat", color: "muted", dash: [5, 4], width: 1.6 }];
/** @type {(title: string, kind: string, height: number, lines: Curve[], zero?: boolean) => Panel} */
const panel = (title, kind, height, lines, zero = false) => ({ title, kind, height, lines, zero });

// Charts and bats below each other; `fill` draws them.
/**
 * @template {Record<string, Part>} Parts
 * @template {PaperPicture["picture"]} Given  the picture's numbers
 * @param {Parts} parts
 * @param {(parts: Parts, picture: Given, bat: BatPicture) => string | void} fill
 * @returns {Drawing}
 */
function pictureOf(parts, fill) {
  return {
    elements: Object.values(parts).map((part) => part.element),
    draw: (answer) => {
      fill(parts, /** @type {Given} */ (answer.picture), answer.bat);
      const { curves, blocks = curves } = parts;
      blocks.label(answer.label[blocks.app.units]);
    },
    figures: () => Object.entries(parts).map(([name, part]) => part.figure(name)),
  };
}

/** @param {BatView} view @param {BatPicture} bat @param {Partial<SweetSpotPlaces>} places */
function strip(view, bat, places) {
  view.draw({ bat, sweet_spots: { max_exit_speed_m: null, center_of_percussion_m: null, zone_m: null,
    max_collision_efficiency_m: null, min_sting_m: null, node_1_m: null, node_2_m: null, ...places } });
}

// Exit speeds along the bat: with the stretch S at the tip where that is asked about, else with every sweet spot.
const speeds = (/** @type {App} */ app) => pictureOf({ bat: new BatView(app), curves: new Chart(app, { label: "Exit speed along the bat", panels: [panel("Exit speed", "exit_speed_m_s", 170, REAL_AND_RIGID)], axis: AXIS(app) }) },
  ({ bat, curves }, /** @type {SpeedsPicture} */ { position_m: x, sweet_spots: spots, elastic_travel_m: travel, ...lines }, given) => {
    const { length_m: length } = given, { zone_m: zone, max_exit_speed_m: best } = spots;
    strip(bat, given, travel === undefined ? spots : { max_exit_speed_m: best });
    const { exit_speed_m_s, rigid_exit_speed_m_s } = lines;
    curves.draw({ x, lines: { exit_speed_m_s, rigid_exit_speed_m_s }, range: [0, length], marks: [{ at: best, color: "red" }],
      bands: travel !== undefined ? [{ from: length - travel, to: length }] : zone ? [{ from: zone[0], to: zone[1] }] : [] });
  });

export const PICTURES = {
  end: speeds,

  percussion: (/** @type {App} */ app) => pictureOf({ bat: new BatView(app), curves: new Chart(app, { label: "Force of the hands over the blow", axis: AXIS(app), panels: [
    panel("Hands over blow, F / I", "ratio", 190, [{ key: "rod_ratio", label: "rod", color: "muted", dash: [5, 4] }, { key: "bat_ratio", label: "bat", color: "green", width: 2.4 },
      { key: "moved_ratio", label: "moved up", color: "purple", dash: [2, 2.5] }])] }) },
  ({ bat, curves }, /** @type {PercussionPicture} */ { rod_ratio, bat_ratio, moved_ratio, ...picture }, given) => {
    strip(bat, given, { max_exit_speed_m: picture.best_m, center_of_percussion_m: picture.bat_percussion_m });
    curves.draw({ x: picture.position_m, lines: { rod_ratio, bat_ratio, moved_ratio }, range: [0, given.length_m], marks: [
      { at: picture.rod_percussion_m, color: "muted" }, { at: picture.bat_percussion_m, color: "green" }, { at: picture.moved_percussion_m, color: "purple" }] });
  }),

  corking: (/** @type {App} */ app) => pictureOf({
    force: new Chart(app, { label: "Force during contact, plain and corked", axis: { kind: "time_s", label: "after first touch" }, panels: [
      panel("Force of the bat on the ball", "f_n", 170, [{ key: "force_n", label: "plain", color: "ink", width: 2.4 }, { key: "corked_force_n", label: "corked", color: "red", dash: [6, 3] }], true)] }),
    curves: new Chart(app, { label: "Exit speed along the bat at the same bat speed, plain and corked", axis: AXIS(app), panels: [
      panel("Exit speed at the same bat speed", "exit_speed_m_s", 150, [{ key: "exit_speed_m_s", label: "plain", color: "ink", width: 2.4 }, { key: "corked_exit_speed_m_s", label: "corked", color: "red", dash: [6, 3] }])] }),
  }, ({ force, curves }, /** @type {CorkingPicture} */ { force_n, corked_force_n, exit_speed_m_s, corked_exit_speed_m_s, ...picture }, { length_m: length }) => {
    force.draw({ x: picture.time_s, xs: { corked_force_n: picture.corked_time_s }, lines: { force_n, corked_force_n }, range: [0, Math.max(...picture.time_s, ...picture.corked_time_s)] });
    curves.draw({ x: picture.position_m, xs: { corked_exit_speed_m_s: picture.corked_position_m }, lines: { exit_speed_m_s, corked_exit_speed_m_s }, range: [0, length] });
  }),

  drop: (/** @type {App} */ app) => pictureOf({
    blocks: new Blocks(app),
    curves: new Chart(app, { label: "Rebound over fall against the thickness of the block", axis: { kind: "thickness_m", label: "thickness" }, panels: [
      panel("Rebound over fall", "ratio", 150, [{ key: "wood", label: "wood", color: "orange", width: 2.4 }, { key: "metal", label: "metal", color: "blue", dash: [6, 3] }])] }),
  }, ({ blocks, curves }, /** @type {DropPicture} */ picture) => {
    const { wood, metal, thickness_m: x, block_thickness_m: thickness } = picture;
    blocks.draw(picture);
    curves.draw({ x, lines: { wood: wood.rebound_ratios, metal: metal.rebound_ratios }, range: [0, 0.04], cursor: thickness <= 0.04 ? thickness : null });
  }),

  energy: (/** @type {App} */ app) => pictureOf({
    curves: new Chart(app, { label: "Energy returned against the bat's share", axis: { kind: "ratio", label: "z, the bat's share of the energy" }, panels: [
      panel("W", "ratio", 230, [{ key: "metal_returned", label: "metal", color: "blue" }, { key: "wood_returned", label: "wood", color: "orange", dash: [6, 3] },
        { key: "walls", label: "model, aluminium walls", color: "red", dash: [3, 3], width: 3 }], true)] }),
  }, ({ curves }, /** @type {EnergyPicture} */ { share: x, wood, metal, walls, wood_returned, metal_returned }) => {
    curves.draw({ x, xs: { walls: walls.share }, lines: { wood_returned, metal_returned, walls: walls.returned }, range: [0, 0.3],
      marks: [{ at: Math.min(0.3, wood.share), color: "orange" }, { at: Math.min(0.3, metal.share), color: "blue" }] });
  }),

  verdict: speeds,
};

// Figure 6: two blocks, the ball where it starts and where it comes back to.
class Blocks {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {DropPicture | null} */
    this.data = null;
    this.surface = new Surface(app, { height: () => 250, paint: (...all) => this.paint(...all) });
    this.element = this.surface.element;
  }

  /** @param {DropPicture} data */
  draw(data) {
    this.data = data;
    this.surface.draw();
  }

  /** @param {string} name */
  figure(name) { return this.surface.figure(name); }
  /** @param {string} words */
  label(words) { this.surface.label(words); }

  /** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height */
  paint(context, width, height) {
    if (!this.data) return;
    const floor = height - 46;
    const scale = (floor - 34) / Math.max(this.data.drop_height_m, this.data.wood.rebound_m ?? 0, this.data.metal.rebound_m ?? 0);
    const half = width / 2;
    /** @type {const} */ ([["wood", "woodEdge"], ["metal", "metalEdge"]]).forEach(([name, edge], i) => {
      this.paintBlock(context, name, edge, { middle: half * (i + 0.5), floor, scale, wide: Math.min(165, half * 0.5) });
    });
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {"wood" | "metal"} name
   * @param {string} edge
   * @param {{ middle: number, floor: number, scale: number, wide: number }} given
   */
  paintBlock(context, name, edge, { middle, floor, scale, wide }) {
    const { colors } = this.app;
    if (!this.data) return;
    const { [name]: found, drop_height_m: height, block_thickness_m: thickness } = this.data;
    const deep = Math.max(3, Math.min(30, thickness * 250));
    Object.assign(context, { fillStyle: colors[name], strokeStyle: colors[edge], lineWidth: 1.5 });
    context.fillRect(middle - wide / 2, floor, wide, deep);
    context.strokeRect(middle - wide / 2, floor, wide, deep);
    dot(context, [middle - 22, floor - height * scale - 9], 9, { edge: colors.muted, width: 2, dash: [3, 3] });
    this.paintLevel(context, middle, floor - height * scale, this.app.text("height_m", height, 1), colors.muted);
    if (found.rebound_m !== null) {
      dot(context, [middle + 4, floor - found.rebound_m * scale - 9], 9, { edge: colors.red, width: 2 });
      this.paintLevel(context, middle + 26, floor - found.rebound_m * scale, this.app.text("rebound_m", found.rebound_m, 1), colors.ink);
    }
    Object.assign(context, { font: `600 12px ${FONT}`, textAlign: "center", textBaseline: "top", fillStyle: colors.ink });
    context.fillText(name, middle, floor + deep + 4);
  }

  /** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {string} words @param {string} ink */
  paintLevel(context, x, y, words, ink) {
    const { colors } = this.app;
    Object.assign(context, { font: `12px ${FONT}`, textAlign: "left", textBaseline: "middle" });
    haloText(context, words, x + 4, y - 8, ink, colors.panel);
  }
}
