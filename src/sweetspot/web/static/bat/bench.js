// The bench: one bat for every view, behind the chip in the bar. Choose it, bring your own, draw it, or change it as a
// workshop would. It lies beside the picture, which shows every change at once.

import { BatList } from "./batlist.js";
import { batText } from "./batfile.js";
import { BenchDesk } from "./desk.js";
import { fileField, takeDrops } from "./bring.js";
import { Outline } from "./outline.js";
import { OwnBat } from "./ownbat.js";
import { unchanged } from "./unchanged.js";
import { workshop } from "./workshop.js";
import { button, faultPlace, group } from "../controls/controls.js";
import { byId, make, write } from "../controls/parts.js";
import { orSaid } from "../controls/said.js";
import { INCH } from "../controls/units.js";
import { download } from "../shell/download.js";
/** @import { BatShape } from "../answers.js" */
/** @import { App, Field } from "../shell/main.js" */
/** @import { Station } from "./outline.js" */
/** @import { System } from "../controls/units.js" */

const NARROW = matchMedia("(max-width: 54rem)"); // as in theme.css
/** @type {[Field, string][]} a field that changes the bat, and what is said of it; #: its value */
const CHANGES = [["profile_in", "outline drawn"], ["mass_oz", "weight #"], ["wall_factor", "wall × #"], ["bore_diameter_in", "hole # wide"],
  ["cup_diameter_in", "cup # wide"], ["weight_oz", "# added"], ["choke_up_in", "choked up #"]];

// Questions about an implement of one's own; they are fetched when first wanted.
/** @param {App} app */
export async function describeOwn(app) {
  app.bench.turn(false, false);
  return orSaid(async () => (await import("./wizard.js")).wizard(app));
}

export class Bench {
  guesses = { toml: "", lines: /** @type {Record<System, string[]>} */ ({ us: [], si: [] }) };
  listed = ""; // what was changed, as the list has it
  drawing = false; // whether the outline's handles are shown on pictures

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    const desk = this.desk = new BenchDesk(app);
    this.element = byId("bench");
    this.title = make("h2", { id: "bench-name", tabIndex: -1 });
    this.changes = make("ul");
    this.assumedList = make("ul");
    this.assumed = make("details", { open: true, hidden: true }, make("summary", { textContent: "What was assumed of it" }), this.assumedList);
    this.list = new BatList(desk, (key, bat) => this.choose(key, bat));
    this.outline = new Outline(desk, (stations, last) => this.reshape(stations, last), (on) => {
      this.drawing = on;
      app.redraw();
    });
    const { controls, show } = workshop(desk, () => app.answer?.bat?.mass_kg);
    this.show = show;
    const bat = make("div", { id: "bench-bat" });
    bat.dataset.field = "bat";
    bat.append(this.list.element, faultPlace(desk, ["bat"], () => this.list.sync()));
    this.ofBat = make("div", {}, new OwnBat(desk).element, this.outline.element,
      group("Workshop", [...controls, button("As it was", () => this.asItWas())], { open: false }),
      make("div", { className: "row" },
        button("Save as bat.toml", () => orSaid(async () => download("bat.toml", "application/toml", await batText(app)))),
        button("Compare this with …", () => {
          this.turn(false, false);
          app.visit(app.addressFor("compare"));
        })));
    this.ofOther = make("div", { className: "row" }, button("Save as mine.toml", () => download("mine.toml", "application/toml", app.state.implement_toml ?? "")));
    this.element.append(make("div", { className: "row bench-head" }, this.title, button("Close", () => this.turn(false))),
      this.assumed, this.changes, bat,
      make("div", { className: "own" }, make("label", { htmlFor: "any-file", textContent: "Open a file, or drop it anywhere: a bat (TOML, table of diameters, DXF, SVG, STL, photo), a ball, swings, a season, sounds of taps" }), fileField(app, "any-file")),
      button("Describe yours by questions\u00a0…", () => describeOwn(app), { primary: true }), this.ofBat, this.ofOther);
    takeDrops(app);
    this.element.addEventListener("reveal", () => this.turn(true, false));
    addEventListener("keydown", ({ key }) => key === "Escape" && this.element.contains(document.activeElement) && this.turn(false));
  }

  get open() { return !this.element.hidden; }

  // Open or shut; focus: whether the keyboard goes along.
  turn(open = !this.open, focus = true) {
    this.element.hidden = !open;
    const chip = this.app.chip.open;
    chip.setAttribute("aria-expanded", String(open));
    if (open) {
      this.sync();
      this.update();
      this.list.show();
      if (NARROW.matches) byId("view").querySelector("canvas")?.scrollIntoView(); // above the bench
    }
    if (focus) (open ? this.title : chip).focus({ preventScroll: true });
  }

  // A bat for every view; what other sports hit with has a view of its own.
  /** @param {string} key @param {boolean} bat */
  choose(key, bat) {
    const { view, state } = this.app;
    if (view?.other && (!bat || state.implement)) view.other(bat ? "" : key);
    if (bat) this.desk.setState({ ...unchanged(this.desk), bat: key });
    else if (!view?.other) this.app.visitWith("sports", { implement: key, implement_toml: null, swing_mph: null, incoming_mph: null, met_from_tip_in: null, aside_in: 0 });
  }

  asItWas() { this.desk.setState(unchanged(this.desk)); }

  /** @param {Station[]} stations @param {boolean} last */
  reshape(stations, last) {
    const profile = stations.map((station) => /** @type {[number, number]} */ ([rounded(station.position_m / INCH), rounded(station.diameter_m / INCH)]));
    this.desk.setState({ profile_in: profile }, { commit: last });
  }

  // What was changed of the bat, in words.
  /** @returns {[Field, string][]} */
  made() {
    const { app } = this, { schema } = this.desk, { carried } = app;
    const changed = CHANGES.filter(([field]) => carried[field] !== undefined && JSON.stringify(carried[field]) !== JSON.stringify(schema[field].default ?? null));
    return changed.map(([field, words]) => [field, words.replace("#", field === "wall_factor" ? String(carried[field]) : app.text(field, Number(carried[field])))]);
  }

  // Nothing is done for a bench that is shut.
  // A bat by questions: what its answers left open, in either system; until another one lies here.
  /** @param {string} toml @param {Record<System, string[]>} lines */
  assume(toml, lines) {
    this.guesses = { toml, lines };
    this.turn(true);
  }

  sync() {
    if (!this.open) return;
    const { toml, lines } = this.guesses, { units } = this.app;
    this.assumed.hidden = toml === "" || ![this.desk.state.bat_toml, this.app.state.implement_toml].includes(toml);
    if (this.assumedList.dataset.shown !== units + toml) this.assumedList.replaceChildren(...lines[units].map((words) => make("li", { textContent: words })));
    this.assumedList.dataset.shown = units + toml;
    this.desk.sync();
    const other = Boolean(this.app.state.implement);
    this.ofBat.hidden = other;
    this.ofOther.hidden = !this.app.state.implement_toml;
    const made = other ? [] : this.made(), words = JSON.stringify(made);
    this.changes.hidden = !made.length;
    if (words === this.listed) return;
    this.listed = words;
    this.changes.replaceChildren(...made.map(([field, said]) => make("li", {}, `${said} `,
      button("Undo", () => this.desk.setState({ [field]: this.desk.schema[field].default ?? null }), { title: `Undo: ${said}` }))));
  }

  /** @param {string} name */
  named(name) { write(this.title, name); }

  // Show the bat of the last answer, where it has one.
  update() {
    const bat = /** @type {Partial<BatShape> | undefined} */ (this.app.answer?.bat);
    if (!this.open || !bat?.stations) return;
    this.desk.sync();
    this.show(/** @type {BatShape} */ (bat));
    this.outline.update(bat.stations);
  }
}

const rounded = (/** @type {number} */ value) => Math.round(1e4 * value) / 1e4;
