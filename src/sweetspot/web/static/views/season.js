// Season: tables of balls in play of any size, read on the server; who did what, where on the barrel and on the field.

import { Bench } from "../bat/bench.js";
import { button, choice, group } from "../controls/controls.js";
import { DocumentPlace } from "../controls/document.js";
import { factList, make, tell } from "../controls/parts.js";
import { Filter } from "./filter.js";
import { Players } from "./season_players.js";
import { BarrelMap, Ceilings, FieldMap } from "./season_pictures.js";
import { Reading } from "./season_reading.js";
import { grouped } from "../controls/units.js";
/** @import { Fact } from "../controls/parts.js" */
/** @import { Answer, View } from "../shell/main.js" */

const FILTERS = [["team", "Hit for", "any club"], ["pitch_type", "Off", "all pitches"], ["count", "At the count", "all counts"], ["month", "In the month", "all months"], ["park", "In the park", "all parks"]];
const EVERYBODY = { batter: null, team: null, pitch_type: null, count: null, month: null, park: null };
/** @type {Fact<Answer>[]} */
const FACTS = [
  ["Balls", ({ means }) => grouped(means.balls)], ["Exit speed", ({ means }) => ["speed", means.exit_speed]],
  ["Hardest fifth (EV20)", ({ means }) => ["speed", means.ev20]], ["Bat speed", ({ means }) => ["speed", means.bat_speed]],
  ["Squared up, this bat", ({ means }) => ["share", means.squared_up]], ["Squared up, the league's formula", ({ means }) => ["share", means.league_squared_up]],
  ["From the best place", ({ means }) => ["offset", means.from_best]],
  ["Home runs", ({ means }) => ["count", means.home_runs]], ["Home runs expected", ({ means }) => ["count", means.home_runs_expected, 1]],
];

/** @type {View<"season">} */
export const view = {
  name: "season",
  guide: [
    ["Hand in tables", "Drop tables of balls in play anywhere on this page: Statcast, Trackman or plain CSV, or Parquet, of any size. They go to the program that shows this page, and nowhere else."],
    ["Where balls were met", "The maps show where on the barrel the balls were met and where they come down; choose a player, a club, a pitch, a month."],
    ["Who did what", "Each player's page has every measure partly pooled, with its intervals. All tables can be saved. "],
  ],

  mount(root, app) {
    Object.assign(this, { app, answer: null, found: null });
    this.bench = new Bench(app, { open: false });
    this.reading = new Reading(app, { onSeason: (read) => app.setState({ ...read, ...EVERYBODY }) });
    this.filters = FILTERS.map(([field, label, all]) => new Filter(app, field, { label, all }));
    this.players = new Players(app);
    this.words = make("p", { className: "verdict flow", id: "verdict" });
    this.facts = factList(FACTS, app);
    this.barrel = new BarrelMap(app);
    this.ceilings = new Ceilings(app);
    this.field = new FieldMap(app);
    this.page = new DocumentPlace(app, "Writing the player's page …");
    this.whole = new DocumentPlace(app, "Reading what was found …");
    this.files = make("ul", { className: "files" });
    this.none = make("p", { className: "note", hidden: true });
    const section = (/** @type {string} */ title, /** @type {(Node | string)[]} */ ...parts) => make("section", { className: "picture", hidden: true }, make("h2", { textContent: title }), ...parts);
    this.wrong = make("p", { className: "fault", hidden: true });
    this.design = button("Design a bat for this player", () => this.toDesign(), { title: "Where this player meets the ball, and how fast, goes along to the view Design" });
    this.player = section("This player", make("div", { className: "row tight" }, this.design), this.wrong, this.page.element);
    this.told = [
      section("How they were hit", this.none, this.facts.element, this.barrel.element, this.ceilings.element),
      section("Where they come down", this.field.element), section("Players", this.players.table),
      section("What was read", this.whole.element), section("Save the tables", this.files)];
    this.which = group("Which balls", [this.players.element, ...this.filters.map((/** @type {{ element: HTMLElement }} */ { element }) => element), button("All balls again", () => app.setState(EVERYBODY))]);
    root.append(make("div", { className: "side" },
      group("Tables", [this.reading.chooser]), this.which,
      group("Fence on the field", [choice(app, "fence", { label: "Park", options: app.lists("parks").then(({ parks }) => [["", "As above, else Fenway Park"], ...parks.map(({ key, name }) => [key, name])]), take: (key) => app.setState({ fence: key || null }) })], { open: false }),
      this.bench.element),
    make("div", { className: "stack" }, make("section", { className: "picture" }, this.words, this.reading.element), this.told[0], this.told[1], this.player, ...this.told.slice(2)));
  },

  update(answer) {
    this.answer = answer;
    const { app } = this;
    const { season } = answer;
    this.bench.update(answer);
    this.reading.draw(season);
    for (const one of this.told) one.hidden = !season;
    this.which.hidden = !season && !this.which.querySelector(".fault:not([hidden])");
    this.told[1].hidden ||= !this.found?.field;
    this.told[2].hidden ||= !this.players.players.length;
    this.player.hidden = !season || app.state.batter === null;
    this.wrong.hidden = true;
    for (const one of this.filters) one.fill(season?.choices[one.field] ?? []);
    if (!season) {
      this.found = null;
      this.players.fill([]);
      this.say();
      return;
    }
    this.listFiles(season.tables);
    const but = (/** @type {string[]} */ ...kept) => Object.keys(app.state).filter((field) => !kept.includes(field));
    app.aside("summary", but("season"), 0, (found) => {
      this.players.fill(found.players ?? []);
      this.told[2].hidden = !found.players?.length;
      this.whole.show(found);
      this.say();
    });
    app.aside("maps", but("season", ...Object.keys(EVERYBODY)), 60, (found) => {
      this.found = found;
      this.draw();
      this.say();
    });
    if (app.state.batter !== null) {
      this.page.waits();
      app.aside("player", but("season", "batter"), 60, (found) => found && this.page.show(found));
    }
    this.players.redraw();
    this.page.redraw();
    this.whole.redraw();
    this.draw();
    this.say();
  },

  draw() {
    const { answer, app, found } = this;
    if (!found?.means || !answer?.season) return;
    this.facts.fill(found);
    FACTS.forEach(([, value], i) => { // what these tables do not hold is left out
      const told = value(found, app);
      /** @type {HTMLElement} */ (this.facts.element.children[i]).hidden = Array.isArray(told) && typeof told[1] !== "number";
    });
    this.design.hidden = !found.barrel;
    this.barrel.element.hidden = !found.barrel;
    this.ceilings.element.hidden = !found.ceilings;
    this.told[1].hidden = !found.field;
    this.none.hidden = Boolean(found.barrel);
    this.none.textContent = found.means.balls ? "These tables have no bat speeds, so nothing is told of bats." : "No ball is left by this choice.";
    if (found.barrel) this.barrel.draw(found.barrel, answer.bat);
    if (found.ceilings) this.ceilings.draw(found.ceilings);
    if (found.field) this.field.draw(found.field, answer.park);
  },

  // Whose balls they are, and how well they were hit; before anything was read, what this place is for.
  say() {
    const { answer, app, found } = this;
    if (!answer?.season) {
      const absent = app.state.batter === null ? "" : `Player ${app.state.batter} is of a season that is not here. `;
      this.words.textContent = `${absent}Hand in tables of balls in play: every ball is judged against the bat on the bench, with where on the barrel it was met.`;
      return;
    }
    if (!found?.means) return;
    const { means } = found;
    const whose = app.state.batter === null ? "" : ` of ${this.players.nameOf(app.state.batter)}`;
    if (!means.balls) {
      this.words.textContent = `No ball in play${whose} is left by this choice.`;
      return;
    }
    const bats = typeof means.squared_up === "number" ? `, ${app.text("share", means.squared_up)} squared up against ${answer.season.same_bat ? answer.bat.name : "the bat they were read with"}, met ${app.text("offset", means.from_best)} from its best place on average` : "";
    tell(this.words, `${grouped(means.balls)} ${means.balls === 1 ? "ball" : "balls"} in play${whose}: ${app.text("speed", means.exit_speed)} of exit speed${bats}.`);
    app.announce(this.words.textContent);
  },

  async toDesign() {
    const { app } = this;
    this.wrong.hidden = true;
    try {
      app.visitWith("design", { ...await app.ask("season/contacts", app.state), design_si: null, design_for: null });
    } catch (fault) {
      this.wrong.textContent = fault.message;
      this.wrong.hidden = false;
    }
  },

  /** @param {{ name: string, bytes: number }[]} tables */
  listFiles(tables) {
    const { season } = this.app.state;
    const size = (/** @type {number} */ bytes) => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`);
    this.files.replaceChildren(...tables.map(({ name, bytes }) => make("li", {},
      make("a", { href: `/api/v1/uploads/${season}/${name}`, download: name, textContent: name }), ` ${size(bytes)}`)));
  },

  unmount() { Object.assign(this, { answer: null }); },
  figures() { return this.found ? [this.barrel.figure("barrel"), this.ceilings.figure("ceilings"), this.field.figure("field")] : []; },
  table() { return this.found ? this.barrel.columns() : {}; },
};
