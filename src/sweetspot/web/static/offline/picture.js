// The implement to scale with the ball, and below it on the same axis what a hit at each place gives.

import { Chart, LEFT, RIGHT } from "../charts/chart.js";
import { line } from "../charts/pen.js";
import { Surface } from "../charts/surface.js";
import { Zoom } from "../charts/zoom.js";
import { WIDEST, paintBall, paintBat } from "../bat/batpaint.js";
import { byId, make, tell } from "../controls/parts.js";
import { unbroken } from "../controls/tables.js";
/** @import { Answer, File } from "./file.js" */
/** @import { Panel } from "../charts/chart.js" */
/** @import { App } from "../shell/main.js" */

const COLDEST = 0.55; // part of the greatest exit speed from which on the implement is coloured
const BARREL = 18 * 0.0254; // m, shown until somebody zooms

export class Picture {
  /** @param {File} file @param {App} app */
  constructor(file, app) {
    this.file = file;
    const { words, drawing, numbers } = file, { labels } = words;
    /** @type {Answer | null} */
    this.answer = null;
    /** @type {Answer["along"] | null} */
    this.shown = null; // whose curves are drawn
    /** @type {Record<string, (number | null)[]>} */
    this.lines = {};
    this.zoom = new Zoom({ onChange: () => this.paint(), closest: 0.1, shared: true });
    this.zoom.set([0, numbers.length], [Math.max(0, numbers.length - BARREL), numbers.length]);
    this.surface = new Surface(app, { label: labels.bat, height: (width) => this.tall(width), paint: (context, width) => this.paintBat(context, width) });
    this.zoom.listen(this.surface, (x) => this.along(x));
    this.surface.element.style.cursor = "grab";
    this.surface.drags(({ x }) => this.put(this.along(x)));
    /** @type {Panel[]} */
    const panels = words.panels;
    this.chart = new Chart(app, { label: labels.curves, panels, axis: { kind: "position_m", from: () => numbers.length, label: labels.axis }, onPick: (x) => this.put(x), zoom: this.zoom });
    this.facts = make("dl", { className: "facts" });
    this.headline = make("p", { className: "verdict", id: "verdict" });
    this.why = make("p", { className: "why", id: "why" });
    const box = make("section", { className: "picture", ariaLabel: labels.picture },
      make("div", { className: "row tight" }, this.zoom.buttons(labels.whole)), this.surface.element, this.facts, this.why, this.chart.element);
    byId("headline").append(this.headline);
    byId("picture").append(box);
    this.drawing = drawing;
  }

  get range() { return this.zoom.range; }
  /** @param {number} width */
  scale(width) { return (width - LEFT - RIGHT) / (this.range[1] - this.range[0]); }
  /** @param {number} x */
  along(x) { return this.range[0] + (x - LEFT) / this.scale(this.surface.width); }
  /** @param {number} width */
  tall(width) { return (this.wide + 2 * this.file.numbers.ball_radius) * this.scale(width) + 24; }
  get wide() { return Math.max(WIDEST, ...this.file.drawing.outline.diameter_m); }

  // The ball goes to a place, m from the butt end.
  /** @param {number} position */
  put(position) {
    const { numbers, sizes, state } = this.file;
    const tip = (numbers.length - position) / sizes.inch;
    if (Math.abs(tip - state.impact_from_tip_in) > 0.05) this.file.setState({ impact_from_tip_in: tip });
    return true;
  }

  /** @param {Answer} answer @param {{ headline: string, why: string, facts: [string, string][] }} said */
  draw(answer, { headline, why, facts }) {
    this.answer = answer;
    tell(this.headline, headline);
    tell(this.why, why);
    if (this.facts.children.length !== facts.length) this.facts.replaceChildren(...facts.map(([label]) => make("div", {}, make("dt", { textContent: label }), make("dd"))));
    facts.forEach(([, value], i) => tell(/** @type {Element} */ (this.facts.children[i].lastElementChild), value));
    const { labels } = this.file.words;
    this.surface.label(`${labels.bat} ${headline}`);
    this.chart.label(`${labels.curves} ${headline}`);
    const canvas = this.surface.element, { bat, state } = this.file;
    canvas.classList.add("pinned");
    if (!canvas.hasAttribute("tabindex")) this.keys(canvas);
    for (const [name, value] of Object.entries({ min: bat.first / 10, max: bat.last / 10, now: state.impact_from_tip_in, text: unbroken(headline) })) canvas.setAttribute(`aria-value${name}`, String(value));
    this.paint();
  }

  // The picture is also a slider for those who use the keyboard; the tip is on the right.
  /** @param {HTMLElement} canvas */
  keys(canvas) {
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "slider");
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: 0.1, ArrowDown: 0.1, ArrowRight: -0.1, ArrowUp: -0.1, PageUp: -1, PageDown: 1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      this.file.setState({ impact_from_tip_in: this.file.state.impact_from_tip_in + step });
    });
  }

  paint() {
    if (!this.answer) return;
    const { along, here } = this.answer, { zone, best } = along;
    this.surface.draw();
    if (this.shown !== along) {
      this.shown = along;
      this.lines = this.curves(along);
    }
    this.chart.draw({
      x: along.places, lines: this.lines, range: [0, this.file.numbers.length], cursor: here.position,
      bands: zone ? [{ from: zone[0], to: zone[1] }] : [], marks: [{ at: best, color: "red" }],
      here: { exit_speed: here.exit, rigid_exit_speed: here.rigid_exit, efficiency: here.q, hand_impulse: here.jolt, sting: here.sting },
    });
  }

  /** @param {Answer["along"]} along */
  curves({ told, places }) {
    const { bat, numbers, sizes } = this.file;
    const half = told.map(({ closing }, i) => {
      const tenths = (10 * (numbers.length - places[i])) / sizes.inch;
      return tenths < bat.first - 0.5 || tenths > bat.last + 0.5 ? null : this.file.half(bat.placeAt(tenths), closing);
    });
    /** @type {Record<string, (number | null)[]>} */
    const lines = {
      exit_speed: told.map(({ exit }) => exit), rigid_exit_speed: told.map(({ rigid_exit: exit }) => exit), efficiency: told.map(({ q }) => q),
      hand_impulse: told.map(({ jolt }) => jolt), sting: told.map(({ sting }) => sting),
      exit_speed_low: told.map(({ exit }, i) => (half[i] === null ? null : exit - /** @type {number} */ (half[i]))),
      exit_speed_high: told.map(({ exit }, i) => (half[i] === null ? null : exit + /** @type {number} */ (half[i]))),
    };
    for (const part of Object.keys(told[0].shares)) lines[part] = told.map(({ shares }) => shares[part]);
    for (const [key, values] of Object.entries(lines)) lines[key] = values.map((value) => (value === null || Number.isNaN(value) ? null : value));
    return lines;
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width */
  paintBat(context, width) {
    if (!this.answer) return;
    const { along, here } = this.answer, { colors, numbers } = this.file, scale = this.scale(width);
    const place = { left: LEFT - this.range[0] * scale, scale, middle: (this.wide / 2) * scale + 4 };
    const across = (/** @type {number} */ x) => place.left + x * scale;
    if (along.zone) {
      context.fillStyle = colors.zone;
      context.fillRect(across(along.zone[0]), 0, across(along.zone[1]) - across(along.zone[0]), this.tall(width));
    }
    const known = along.exit.filter(Number.isFinite), most = Math.max(...known);
    paintBat(context, this.drawing, place, colors, { position_m: along.places, values: along.exit.map((value) => (Number.isFinite(value) ? value : null)), least: COLDEST * most, most });
    line(context, [[across(along.best), 0], [across(along.best), this.tall(width)]], colors.red, 1.2, [3, 3]);
    paintBall(context, { position_m: here.position, radius_m: numbers.ball_radius }, this.drawing, place, colors);
  }
}
