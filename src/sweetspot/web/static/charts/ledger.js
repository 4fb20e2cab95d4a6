// Where the incoming energy is at every moment: a stacked area over time, and a list of its parts at the moment shown.

import { Chart } from "./chart.js";
import { make, write } from "../controls/parts.js";
import { FONT, haloText } from "./surface.js";
/** @import { App } from "../shell/main.js" */
/** @import { Way } from "../bat/batpaint.js" */
/** @import { Panel } from "./chart.js" */
/** @import { Box } from "./chartpaint.js" */
/** @import { Placed } from "./chartpanels.js" */
/** @import { Film } from "../bat/film.js" */

// The colours of the energy's parts, in the order in which they are stacked.
const COLORS = { ball: "red", stored: "woodEdge", heat: "muted", translation: "blue", rotation: "sky", bending: "purple", hoop: "orange", dent: "wood", damping: "green" };

/**
 * The lines of a chart of the energy's parts.
 * @param {Record<string, string>} names
 */
export const partsOf = (names) => Object.entries(COLORS).filter(([key]) => names[key]).map(([key, color]) => ({ key, name: names[key], color }));

class Areas extends Chart {
  // The parts' names in their own areas, where those are high enough.
  /** @param {CanvasRenderingContext2D} context @param {Placed} place @param {Way} across */
  paintGround(context, place, across) {
    super.paintGround(context, place, across);
    const names = this.named(context, place.panel, place.box, across);
    context.font = `600 12px ${FONT}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const { name, middle, y } of names) haloText(context, name, middle, y, this.app.colors.ink, this.app.colors.panel);
  }

  // Where each name fits into its own area, as high as possible; names that fit nowhere stand in the list alone.
  /** @param {CanvasRenderingContext2D} context @param {Panel} panel @param {Box} box @param {Way} across */
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
    /** @type {Panel} */
    this.panel = { title: "Where the energy is", kind: "energy_j", height: 190, stacked: true, lines: [] };
    this.named = ""; // what the list was last made of
    this.chart = new Areas(app, {
      label: "Where the energy is", panels: [this.panel], axis: { kind: "time_s", label: "after first touch" }, onPick,
    });
    this.list = make("dl", { className: "ledger", ariaLabel: "Energy at the moment shown" });
    this.element = make("div", {}, this.list); // the chart stands where its view wants it
  }

  /** @param {Film} film @param {{ x: number[], lines: Record<string, number[]> }} series */
  set(film, series) {
    this.film = film;
    this.series = series;
    this.chart.label(film.answer.energy_words[this.app.units].join(" "));
    return this.name();
  }

  // The parts that this hit has, in the theme's colours; the list is made anew where it has others, and then has no values.
  name() {
    const parts = partsOf(this.film?.answer.energy_names ?? {});
    const about = JSON.stringify([this.app.colors, parts]);
    if (about === this.named) return false;
    this.named = about;
    this.panel.lines = parts;
    this.list.replaceChildren();
    this.values = parts.map(({ key, name, color }) => {
      const chip = make("span", { className: "chip" });
      chip.style.background = this.app.colors[color];
      const value = make("dd");
      value.dataset.part = key;
      this.list.append(make("div", {}, make("dt", {}, chip, name), value));
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
      if (this.values) write(this.values[i], words);
    });
  }

  /** @param {string} name */
  figure(name) { return this.chart.figure(name); }
}
