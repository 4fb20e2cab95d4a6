// The pictures of the paper's questions: each is { elements, draw(answer, state), figures() }.

import { BatView } from "../bat/batview.js";
import { Chart } from "../charts/chart.js";
import { FONT, Surface, haloText } from "../charts/surface.js";
/** @import { BatPicture, CorkingPicture, DropPicture, EndPicture, EnergyPicture, PercussionPicture, SweetSpotPlaces, VerdictPicture } from "../answers.js" */
/** @import { App } from "../shell/main.js" */

/** @param {App} app */
const AXIS = (app) => ({ kind: "position_m", from: () => app.answer?.bat.length_m ?? 0.84, label: "from the tip" });
const SPEEDS = { title: "Exit speed", kind: "exit_speed_m_s", height: 170, lines: [
  { key: "exit_speed_m_s", label: "real bat", color: "red", width: 2.4 },
  { key: "rigid_exit_speed_m_s", label: "rigid bat", color: "muted", dash: [5, 4], width: 1.6 }] };

/** @typedef {BatView | Chart | Blocks} Part */

// Charts and bats below each other; `fill` draws them.
/**
 * @template {Record<string, Part>} Parts
 * @template Given  the picture's numbers
 * @param {Parts} parts
 * @param {(parts: Parts, answer: { bat: BatPicture, picture: Given }) => void} fill
 */
function pictureOf(parts, fill) {
  return {
    elements: Object.values(parts).map((part) => part.element),
    draw: (/** @type {{ bat: BatPicture, picture: Given }} */ answer) => fill(parts, answer),
    figures: () => Object.entries(parts).map(([name, part]) => ("surface" in part ? part.surface : part).figure(name)),
  };
}

/**
 * @param {BatView} view
 * @param {BatPicture} bat
 * @param {Partial<SweetSpotPlaces>} places
 */
function strip(view, bat, places) {
  view.draw({ bat, sweet_spots: { max_exit_speed_m: null, center_of_percussion_m: null, zone_m: null,
    max_collision_efficiency_m: null, min_sting_m: null, node_1_m: null, node_2_m: null, ...places } });
}

export const PICTURES = {
  end: (/** @type {App} */ app) => pictureOf({ bat: new BatView(app), curves: new Chart(app, { label: "Exit speed along the bat", panels: [SPEEDS], axis: AXIS(app) }) },
    (/** @type {{ bat: BatView, curves: Chart }} */ { bat, curves }, /** @type {{ bat: BatPicture, picture: EndPicture }} */ answer) => {
      const { picture, bat: { length_m: length } } = answer;
      const best = picture.sweet_spots.max_exit_speed_m;
      strip(bat, answer.bat, { max_exit_speed_m: best });
      curves.draw({ x: picture.position_m, lines: { exit_speed_m_s: picture.exit_speed_m_s, rigid_exit_speed_m_s: picture.rigid_exit_speed_m_s }, range: [0, length], marks: [{ at: best, color: "red" }],
        bands: [{ from: length - picture.elastic_travel_m, to: length }] });
      curves.label(`Exit speed along the bat; the stretch S of the paper, ${app.text("s_m", picture.elastic_travel_m, 2)}, is shaded at the tip.`);
    }),

  percussion: (/** @type {App} */ app) => pictureOf({ bat: new BatView(app), curves: new Chart(app, { label: "Force of the hands over the blow", axis: AXIS(app), panels: [
    { title: "Hands over blow, F / I", kind: "ratio", height: 190, lines: [
      { key: "rod_ratio", label: "rod", color: "muted", dash: [5, 4] }, { key: "bat_ratio", label: "bat", color: "green", width: 2.4 },
      { key: "moved_ratio", label: "moved up", color: "purple", dash: [2, 2.5] }] }] }) },
  (/** @type {{ bat: BatView, curves: Chart }} */ { bat, curves }, /** @type {{ bat: BatPicture, picture: PercussionPicture }} */ answer) => {
    const { picture } = answer;
    strip(bat, answer.bat, { max_exit_speed_m: picture.best_m, center_of_percussion_m: picture.bat_percussion_m });
    curves.draw({ x: picture.position_m, lines: { rod_ratio: picture.rod_ratio, bat_ratio: picture.bat_ratio, moved_ratio: picture.moved_ratio }, range: [0, answer.bat.length_m], bands: [], marks: [
      { at: picture.rod_percussion_m, color: "muted" }, { at: picture.bat_percussion_m, color: "green" }, { at: picture.moved_percussion_m, color: "purple" }] });
    curves.label("Force of the hands over the blow along rod and bat; it is zero at each one's centre of percussion.");
  }),

  corking: (/** @type {App} */ app) => pictureOf({
    force: new Chart(app, { label: "Force during contact, plain and corked", axis: { kind: "time_s", label: "after first touch" }, panels: [
      { title: "Force of the bat on the ball", kind: "f_n", height: 170, zero: true, lines: [
        { key: "force_n", label: "plain", color: "ink", width: 2.4 }, { key: "corked_force_n", label: "corked", color: "red", dash: [6, 3] }] }] }),
    curves: new Chart(app, { label: "Exit speed along the bat at the same bat speed, plain and corked", axis: AXIS(app), panels: [
      { title: "Exit speed at the same bat speed", kind: "exit_speed_m_s", height: 150, lines: [
        { key: "exit_speed_m_s", label: "plain", color: "ink", width: 2.4 }, { key: "corked_exit_speed_m_s", label: "corked", color: "red", dash: [6, 3] }] }] }),
  }, (/** @type {{ force: Chart, curves: Chart }} */ { force, curves }, /** @type {{ bat: BatPicture, picture: CorkingPicture }} */ answer) => {
    const { picture } = answer;
    force.draw({ x: picture.time_s, xs: { corked_force_n: picture.corked_time_s }, lines: { force_n: picture.force_n, corked_force_n: picture.corked_force_n }, bands: [], marks: [],
      range: [0, Math.max(...picture.time_s, ...picture.corked_time_s)] });
    curves.draw({ x: picture.position_m, xs: { corked_exit_speed_m_s: picture.corked_position_m }, lines: { exit_speed_m_s: picture.exit_speed_m_s, corked_exit_speed_m_s: picture.corked_exit_speed_m_s }, range: [0, answer.bat.length_m], bands: [], marks: [] });
  }),

  drop: (/** @type {App} */ app) => pictureOf({
    blocks: new Blocks(app),
    curves: new Chart(app, { label: "Rebound over fall against the thickness of the block", axis: { kind: "thickness_m", label: "thickness" }, panels: [
      { title: "Rebound over fall", kind: "ratio", height: 150, lines: [
        { key: "wood", label: "wood", color: "orange", width: 2.4 }, { key: "metal", label: "metal", color: "blue", dash: [6, 3] }] }] }),
  }, (/** @type {{ blocks: Blocks, curves: Chart }} */ { blocks, curves }, /** @type {{ bat: BatPicture, picture: DropPicture }} */ answer) => {
    const { wood, metal, thickness_m: thickness, block_thickness_m: own } = answer.picture;
    blocks.draw(answer.picture);
    curves.draw({ x: thickness, lines: { wood: wood.rebound_ratios, metal: metal.rebound_ratios }, range: [0, 0.04], bands: [], marks: [],
      cursor: own <= 0.04 ? own : null });
  }),

  energy: (/** @type {App} */ app) => pictureOf({
    curves: new Chart(app, { label: "Energy returned against the bat's share", axis: { kind: "ratio", label: "z, the bat's share of the energy" }, panels: [
      { title: "W", kind: "ratio", height: 230, zero: true, lines: [
        { key: "metal_returned", label: "metal", color: "blue" }, { key: "wood_returned", label: "wood", color: "orange", dash: [6, 3] },
        { key: "walls", label: "model, aluminium walls", color: "red", dash: [3, 3], width: 3 }] }] }),
  }, (/** @type {{ curves: Chart }} */ { curves }, /** @type {{ bat: BatPicture, picture: EnergyPicture }} */ answer) => {
    const { share, wood, metal, walls, wood_returned, metal_returned } = answer.picture;
    curves.draw({ x: share, xs: { walls: walls.share }, lines: { wood_returned, metal_returned, walls: walls.returned }, range: [0, 0.3], bands: [],
      marks: [{ at: Math.min(0.3, wood.share), color: "orange" }, { at: Math.min(0.3, metal.share), color: "blue" }] });
  }),

  verdict: (/** @type {App} */ app) => pictureOf({ bat: new BatView(app), curves: new Chart(app, { label: "Exit speed along the bat", panels: [SPEEDS], axis: AXIS(app) }) },
    (/** @type {{ bat: BatView, curves: Chart }} */ { bat, curves }, /** @type {{ bat: BatPicture, picture: VerdictPicture }} */ answer) => {
      const { picture, picture: { sweet_spots: spots } } = answer;
      strip(bat, answer.bat, spots);
      curves.draw({ x: picture.position_m, lines: { exit_speed_m_s: picture.exit_speed_m_s, rigid_exit_speed_m_s: picture.rigid_exit_speed_m_s }, range: [0, answer.bat.length_m], marks: [{ at: spots.max_exit_speed_m, color: "red" }],
        bands: spots.zone_m ? [{ from: spots.zone_m[0], to: spots.zone_m[1] }] : [] });
    }),
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
    const height = (/** @type {number | null} */ value) => (value === null ? "does not come back cleanly" : `comes back to ${this.app.text("rebound_m", value, 1)}`);
    this.surface.label(`A ball dropped from ${this.app.text("height_m", data.drop_height_m, 1)}: from wood it ${height(data.wood.rebound_m)}, from metal it ${height(data.metal.rebound_m)}.`);
    this.surface.draw();
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   * @param {number} height
   */
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
    this.paintBall(context, middle - 22, floor - height * scale, colors.muted, [3, 3]);
    this.paintLevel(context, middle, floor - height * scale, this.app.text("height_m", height, 1), colors.muted);
    if (found.rebound_m !== null) {
      this.paintBall(context, middle + 4, floor - found.rebound_m * scale, colors.red, []);
      this.paintLevel(context, middle + 26, floor - found.rebound_m * scale, this.app.text("rebound_m", found.rebound_m, 1), colors.ink);
    }
    Object.assign(context, { font: `600 12px ${FONT}`, textAlign: "center", textBaseline: "top", fillStyle: colors.ink });
    context.fillText(name, middle, floor + deep + 4);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} x
   * @param {number} y
   * @param {string} color
   * @param {number[]} dash
   */
  paintBall(context, x, y, color, dash) {
    Object.assign(context, { strokeStyle: color, lineWidth: 2 });
    context.setLineDash(dash);
    context.beginPath();
    context.arc(x, y - 9, 9, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} x
   * @param {number} y
   * @param {string} words
   * @param {string} ink
   */
  paintLevel(context, x, y, words, ink) {
    const { colors } = this.app;
    Object.assign(context, { font: `12px ${FONT}`, textAlign: "left", textBaseline: "middle" });
    haloText(context, words, x + 4, y - 8, ink, colors.panel);
  }
}
