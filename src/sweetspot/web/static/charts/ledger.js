// Where the incoming energy is at every moment: a stacked area over time, and a list of its parts at the moment shown.

import { Chart } from "./chart.js";
import { FONT, haloText } from "./surface.js";
/** @import { App } from "../shell/main.js" */
/** @import { Way } from "../bat/batpaint.js" */
/** @import { Panel } from "./chart.js" */
/** @import { Box } from "./chartpaint.js" */
/** @import { Placed } from "./chartpanels.js" */
/** @import { Film } from "../bat/film.js" */

// Part of the answer's energy_j: what it is called, colour.
export const PARTS = [
  ["ball", "ball's motion", "red"],
  ["stored", "ball, squeezed", "woodEdge"],
  ["heat", "heat in the ball", "muted"],
  ["translation", "bat pushed back", "blue"],
  ["rotation", "bat turned", "sky"],
  ["bending", "bat bending", "purple"],
  ["hoop", "barrel wall", "orange"],
  ["dent", "surface pressed in", "wood"],
  ["damping", "heat in bat and hands", "green"],
];

class Areas extends Chart {
  // The parts' names in their own areas, where those are high enough.
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Placed} place
   * @param {Way} across
   */
  paintGround(context, place, across) {
    super.paintGround(context, place, across);
    const names = this.named(context, place.panel, place.box, across);
    context.font = `600 12px ${FONT}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const { name, middle, y } of names) haloText(context, name, middle, y, this.app.colors.ink, this.app.colors.panel);
  }

  // Where each name fits into its own area, as high as possible; names that fit nowhere stand in the list alone.
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Panel} panel
   * @param {Box} box
   * @param {Way} across
   */
  named(context, panel, box, across) {
    const { x, lines } = this.data;
    const total = Math.max(...x.map((_, i) => panel.lines.reduce((sum, { key }) => sum + (lines[key][i] ?? 0), 0)));
    const up = (/** @type {number} */ joules) => ((box.bottom - box.top) * joules) / (1.06 * total);
    const at = x.map(across);
    context.font = `600 12px ${FONT}`;
    const below = x.map(() => 0);
    /** @type {{ name: string, middle: number, y: number }[]} */
    const found = [];
    for (const { key, name = "" } of panel.lines) {
      const half = context.measureText(name).width / 2 + 4;
      const tops = below.map((joules, i) => up(joules + (lines[key][i] ?? 0)));
      const bottoms = below.map(up);
      let best = { room: 15, middle: 0, y: 0 };
      let first = 0; // of the places beneath the name, which go on to the right with it
      for (let middle = box.left + half; middle < box.right - half; middle += 8) {
        while (at[first] <= middle - half - 4) first += 1;
        let [top, bottom] = [Infinity, -Infinity];
        for (let i = first; at[i] < middle + half + 4; i += 1) [top, bottom] = [Math.min(top, tops[i]), Math.max(bottom, bottoms[i])];
        if (top < Infinity && top - bottom > best.room) best = { room: top - bottom, middle, y: box.bottom - (top + bottom) / 2 };
      }
      if (best.middle) found.push({ name, middle: best.middle, y: best.y });
      lines[key].forEach((joules, i) => (below[i] += joules ?? 0));
    }
    return found;
  }
}

export class Ledger {
  /** @param {App} app */
  constructor(app, /** @type {{ onPick: (moment: number, on: { last: boolean }) => void }} */ { onPick }) {
    this.app = app;
    const lines = PARTS.map(([key, name, color]) => ({ key, name, color }));
    this.panel = { title: "Where the energy is", kind: "energy_j", height: 190, stacked: true, lines };
    this.all = lines;
    /** @type {unknown[]} */
    this.named = []; // what the list was last made of
    this.chart = new Areas(app, {
      label: "Where the energy is", panels: [this.panel], axis: { kind: "time_s", label: "after first touch" }, onPick,
    });
    this.list = Object.assign(document.createElement("dl"), { className: "ledger" });
    this.list.setAttribute("aria-label", "Energy at the moment shown");
    this.element = document.createElement("div");
    this.element.append(this.list); // the chart stands where its view wants it
  }

  /**
   * @param {Film} film
   * @param {{ x: number[], lines: Record<string, number[]> }} series
   */
  set(film, series) {
    this.film = film;
    this.series = series;
    const last = this.all.filter(({ key }) => film.energy[key]).map(({ key, name }) => `${name} ${this.app.text("energy_j", film.energy[key].at(-1) ?? null)}`).join(", ");
    this.chart.label(`Where the ${this.app.text("energy_j", film.hit.incoming_energy_j)} of incoming energy are over time. At the end: ${last}.`);
    return this.name();
  }

  // The parts that this hit has, in the theme's colours; the list is made anew where it has others, and then has no values.
  name() {
    const parts = this.all.filter(({ key }) => this.film?.energy[key]);
    const about = [this.app.colors, ...parts];
    if (about.length === this.named.length && about.every((one, i) => one === this.named[i])) return false;
    this.named = about;
    this.panel.lines = parts;
    this.list.replaceChildren();
    this.values = this.panel.lines.map(({ key, name, color }) => {
      const [box, term, value] = ["div", "dt", "dd"].map((tag) => document.createElement(tag));
      const chip = Object.assign(document.createElement("span"), { className: "chip" });
      chip.style.background = this.app.colors[color];
      term.append(chip, name);
      value.dataset.part = key;
      box.append(term, value);
      this.list.append(box);
      return value;
    });
    return true;
  }

  /** @param {number} moment */
  draw(moment) {
    const { film, series } = this;
    if (!film || !series) return;
    this.chart.draw({
      x: series.x, lines: series.lines, range: [series.x[0], film.end], cursor: moment,
      marks: [{ at: film.hit.contact_time_s, color: "ink" }],
    });
    const incoming = film.hit.incoming_energy_j;
    this.panel.lines.forEach(({ key }, i) => {
      const joules = moment <= 0 ? (key === "ball" ? incoming : 0) : film.value(film.energy[key], moment);
      const words = `${this.app.text("energy_j", joules)} · ${((100 * joules) / incoming).toFixed(0)} %`;
      const value = this.values?.[i];
      if (value && value.textContent !== words) value.textContent = words;
    });
  }

  /** @param {string} name */
  figure(name) { return this.chart.figure(name); }
}
