// The players of a season as a table to choose from.

import { button } from "../controls/controls.js";
import { make, tableOf } from "../controls/parts.js";
import { Filter } from "./filter.js";
/** @import { ListedPlayer } from "../answers.js" */
/** @import { App } from "../shell/main.js" */

const SHOWN = 25;
/** @type {[keyof ListedPlayer, string, string, number?][]} a measure, how it is called and shown, and with how many decimals */
const COLUMNS = [
  ["balls", "balls", "count"], ["exit_speed", "exit speed", "speed"], ["ev20", "hardest fifth", "speed"], ["bat_speed", "bat speed", "speed"],
  ["squared_up", "squared up", "share"], ["from_best", "from the best place", "offset"], ["home_runs_expected", "home runs expected", "count", 1],
];
const LOW_FIRST = ["from_best"];

export class Players {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {ListedPlayer[]} */
    this.players = [];
    this.filter = new Filter(app, "batter", { label: "Player", all: "everybody" });
    this.element = this.filter.element;
    this.search = make("input", { type: "text", id: "season-search", autocomplete: "off" });
    this.order = make("select", { id: "season-order" }, ...COLUMNS.map(([name, words]) => new Option(words, name)));
    this.search.addEventListener("input", () => this.redraw());
    this.order.addEventListener("change", () => this.redraw());
    this.place = make("div");
    this.note = make("p", { className: "note" });
    this.table = make("div", {}, make("div", { className: "row" }, make("label", { htmlFor: "season-search", textContent: "Name or number" }), this.search,
      make("label", { htmlFor: "season-order", textContent: "first by" }), this.order), this.place, this.note);
  }

  /** @param {ListedPlayer[]} players */
  fill(players) {
    this.players = players;
    this.filter.fill(players.map(({ batter, name, balls }) => [batter, balls, name]));
    this.redraw();
  }

  redraw() {
    const { app } = this;
    const wanted = this.search.value.trim().toLowerCase();
    const [by] = COLUMNS[this.order.selectedIndex], way = LOW_FIRST.includes(by) ? 1 : -1;
    const found = this.players.filter(({ batter, name }) => `${name} ${batter}`.toLowerCase().includes(wanted))
      .sort((one, other) => Number(one[by] === null) - Number(other[by] === null) || way * (Number(one[by]) - Number(other[by])));
    const listed = found.slice(0, SHOWN), known = COLUMNS.filter(([name]) => this.players.some((player) => typeof player[name] === "number"));
    this.note.textContent = this.players.length ? `${listed.length} of ${this.players.length} players; means are partly pooled. Press a name for that player's page.` : "These tables name no batters.";
    if (!listed.length) {
      this.place.replaceChildren();
      return;
    }
    const box = tableOf("Players", ["player", ...known.map(([, words]) => words)], listed.map((player) => (
      [player.name, ...known.map(([name, , scale, digits]) => app.text(scale, numberOf(player[name]), digits))])));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      row.firstElementChild?.replaceChildren(button(listed[i].name, () => app.setState({ batter: listed[i].batter })));
    });
    const held = this.place.contains(document.activeElement) ? document.activeElement?.textContent : null;
    this.place.replaceChildren(box);
    if (held) [...box.querySelectorAll("button")].find((one) => one.textContent === held)?.focus(); // a redraw takes no focus away
  }
}

const numberOf = (/** @type {number | string | null} */ value) => (typeof value === "number" ? value : null);
