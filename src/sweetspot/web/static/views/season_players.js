// The players of a season as a table to choose from.

import { button } from "../controls/controls.js";
import { make, tableOf } from "../controls/parts.js";
import { Filter } from "./filter.js";
/** @import { Answer, App } from "../shell/main.js" */

const SHOWN = 25;
const COLUMNS = [
  ["balls", "balls", "count"], ["exit_speed", "exit speed", "speed"], ["ev20", "hardest fifth", "speed"], ["bat_speed", "bat speed", "speed"],
  ["squared_up", "squared up", "share"], ["from_best", "from the best place", "offset"], ["home_runs_expected", "home runs expected", "count"],
];
const LOW_FIRST = ["from_best"];

export class Players {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {Answer[]} */
    this.players = [];
    this.names = new Map();
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

  /** @param {Answer[]} players */
  fill(players) {
    this.players = players;
    this.names = new Map(players.map(({ batter, name }) => [batter, name]));
    this.filter.fill(players.map(({ batter, name, balls }) => [batter, balls, name]));
    this.redraw();
  }

  /** @param {Answer} batter */
  nameOf(batter) {
    const name = this.names.get(batter) ?? batter;
    return name === batter ? `player ${batter}` : name;
  }

  redraw() {
    const { app } = this;
    const wanted = this.search.value.trim().toLowerCase();
    const by = this.order.value;
    const way = LOW_FIRST.includes(by) ? 1 : -1;
    const found = this.players.filter(({ batter, name }) => `${name} ${batter}`.toLowerCase().includes(wanted))
      .sort((one, other) => Number(one[by] === null) - Number(other[by] === null) || way * ((one[by] ?? 0) - (other[by] ?? 0)));
    const shown = found.slice(0, SHOWN);
    const known = COLUMNS.filter(([name]) => this.players.some((one) => typeof one[name] === "number"));
    this.note.textContent = this.players.length ? `${shown.length} of ${this.players.length} players; means are partly pooled. Press a name for that player's page.` : "These tables name no batters.";
    if (!shown.length) {
      this.place.replaceChildren();
      return;
    }
    /** @type {Record<string, number>} */
    const digits = { home_runs_expected: 1 };
    const box = tableOf("Players", ["player", ...known.map(([, words]) => words)], shown.map((one) => (
      [one.name, ...known.map(([name, , scale]) => app.text(scale, one[name], digits[name]))])));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      row.firstElementChild?.replaceChildren(button(shown[i].name, () => app.setState({ batter: shown[i].batter })));
    });
    const held = this.place.contains(document.activeElement) ? document.activeElement?.textContent : null;
    this.place.replaceChildren(box);
    if (held) [...box.querySelectorAll("button")].find((one) => one.textContent === held)?.focus(); // a redraw takes no focus away
  }
}
