// Season: tables of balls in play of any size, read on the server; who did what, where on the barrel and on the field.


import { button, choice, group } from "../controls/controls.js";
import { DocumentPlace } from "../controls/document.js";
import { factList, make, section as titled, showWords, tell } from "../controls/parts.js";
import { Filter } from "./filter.js";
import { Players } from "./season_players.js";
import { BarrelMap, Ceilings, FieldMap } from "./season_pictures.js";
import { Reading } from "./season_reading.js";
/** @import { BallMeans, SeasonMaps, SeasonPicture } from "../answers.js" */
/** @import { Fact } from "../controls/parts.js" */
/** @import { AppOf, Field, Guide } from "../shell/main.js" */

/** @type {[Field, string, string][]} */
const FILTERS = [["team", "Hit for", "any club"], ["pitch_type", "Off", "all pitches"], ["count", "At the count", "all counts"], ["month", "In the month", "all months"], ["park", "In the park", "all parks"]];
const EVERYBODY = { batter: null, team: null, pitch_type: null, count: null, month: null, park: null };
/** @type {[string, keyof BallMeans, string, number?][]} a mean, how it is shown, and with how many decimals */
const MEANS = [
  ["Balls", "balls", "count"], ["Exit speed", "exit_speed", "speed"], ["Hardest fifth (EV20)", "ev20", "speed"], ["Bat speed", "bat_speed", "speed"],
  ["Squared up, this bat", "squared_up", "share"], ["Squared up, the league's formula", "league_squared_up", "share"],
  ["From the best place", "from_best", "offset"], ["Home runs", "home_runs", "count"], ["Home runs expected", "home_runs_expected", "count", 1],
];
/** @type {Fact<BallMeans>[]} */
const FACTS = MEANS.map(([words, name, kind, digits]) => [words, (means) => [kind, means[name] ?? null, digits]]);

export default class SeasonView {
  /** @type {Guide} */
  static guide = [
    ["Hand in tables", "Drop tables of balls in play anywhere on this page: Statcast, Trackman or plain CSV, or Parquet, of any size. They go to the program that shows this page, and nowhere else."],
    ["Where balls were met", "The maps show where on the barrel the balls were met and where they come down; choose a player, a club, a pitch, a month."],
    ["Who did what", "Each player's page has every measure partly pooled, with its intervals. All tables can be saved. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"season">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {SeasonPicture | null} */
    this.answer = null;
    /** @type {SeasonMaps | null} */
    this.found = null; // of the chosen balls
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
    const section = (/** @type {string} */ title, /** @type {(Node | string)[]} */ ...parts) => Object.assign(titled(title, ...parts), { hidden: true });
    this.wrong = make("p", { className: "fault", hidden: true });
    this.design = button("Design a bat for this player", () => this.toDesign(), { title: "Where this player meets the ball, and how fast, goes along to the view Design" });
    this.player = section("This player", make("div", { className: "row tight" }, this.design), this.wrong, this.page.element);
    this.told = [
      section("How they were hit", this.none, this.barrel.element, this.facts.element, this.ceilings.element),
      section("Where they come down", this.field.element), section("Players", this.players.table),
      section("What was read", this.whole.element), section("Save the tables", this.files)];
    this.which = group("Which balls", [this.players.element, ...this.filters.map(({ element }) => element), button("All balls again", () => app.setState(EVERYBODY))]);
    root.append(make("div", { className: "side" },
      group("Tables", [this.reading.chooser]), this.which,
      group("Fence on the field", [choice(app, "fence", { label: "Park", options: app.lists("parks").then(({ parks }) => [["", "As above, else Fenway Park"], ...parks.map(({ key, name }) => [key, name])]), take: (key) => app.setState({ fence: key || null }) })], { open: false })),
    make("div", { className: "stack" }, make("section", { className: "picture" }, this.words, this.reading.element), this.told[0], this.told[1], this.player, ...this.told.slice(2)));
  }

  /** @param {File[]} files */
  bring(files) { return this.reading.hand(files); }

  /** @param {SeasonPicture} answer */
  update(answer) {
    this.answer = answer;
    const { app } = this, { season } = answer;
    this.reading.draw(season);
    for (const part of this.told) part.hidden = !season;
    this.which.hidden = !season && !this.which.querySelector(".fault:not([hidden])");
    this.told[1].hidden ||= !this.found?.field;
    this.told[2].hidden ||= !this.players.players.length;
    this.player.hidden = !season || app.state.batter === null;
    this.wrong.hidden = true;
    for (const filter of this.filters) filter.fill(season?.choices[filter.field] ?? []);
    if (!season) {
      this.found = null;
      this.players.fill([]);
      this.draw();
      return;
    }
    this.listFiles(season.tables);
    const but = (/** @type {string[]} */ ...kept) => Object.keys(app.state).filter((field) => !kept.includes(field));
    app.aside("summary", but("season"), 0, (found) => {
      this.players.fill(found.players ?? []);
      this.told[2].hidden = !found.players?.length;
      if (found.html) this.whole.show({ html: found.html });
    });
    app.aside("maps", but("season", ...Object.keys(EVERYBODY)), 60, (found) => {
      this.found = found;
      this.draw();
    });
    if (app.state.batter !== null) {
      this.page.waits();
      app.aside("player", but("season", "batter"), 60, (found) => found && this.page.show(found));
    }
    this.players.redraw();
    this.page.redraw();
    this.whole.redraw();
    this.draw();
  }

  // What this place is for before anything was read; then whose balls they are, and how well they were hit.
  draw() {
    const { answer, app, found } = this;
    if (!answer?.season) {
      const absent = app.state.batter === null ? "" : `Player ${app.state.batter} is of a season that is not here. `;
      this.words.textContent = `${absent}Hand in tables of balls in play: every ball is judged against the bat on the bench, with where on the barrel it was met.`;
      return;
    }
    if (!found?.means || !found.words) return;
    const { means, words, unmapped, barrel, ceilings, field } = found;
    tell(this.words, words[app.units]);
    app.announce(words[app.units]);
    this.facts.fill(means);
    MEANS.forEach(([, name], i) => (/** @type {HTMLElement} */ (this.facts.element.children[i]).hidden = typeof means[name] !== "number")); // what these tables do not hold
    showWords(this.none, unmapped ?? "");
    this.design.hidden = this.barrel.element.hidden = !barrel;
    this.ceilings.element.hidden = !ceilings;
    this.told[1].hidden = !field;
    if (barrel) this.barrel.draw(barrel, answer.bat);
    if (ceilings) this.ceilings.draw(ceilings);
    if (field) this.field.draw(field, answer.park);
  }

  async toDesign() {
    const { app } = this;
    try {
      app.visitWith("design", { ...await app.ask("season/contacts", app.state), design_si: null, design_for: null });
    } catch (fault) {
      showWords(this.wrong, fault.message);
    }
  }

  /** @param {{ name: string, bytes: number }[]} tables */
  listFiles(tables) {
    const { season } = this.app.state;
    const size = (/** @type {number} */ bytes) => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`);
    this.files.replaceChildren(...tables.map(({ name, bytes }) => make("li", {},
      make("a", { href: `/api/v1/uploads/${season}/${name}`, download: name, textContent: name }), ` ${size(bytes)}`)));
  }

  figures() { return this.found ? [this.barrel.figure("barrel"), this.ceilings.figure("ceilings"), this.field.figure("field")] : []; }
  table() { return this.barrel.columns(); }
}
