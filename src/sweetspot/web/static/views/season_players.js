// Which balls: selects whose lists come with a season, and its players as a table to choose from.

import { button } from "../controls.js";
import { make, tableOf } from "../parts.js";
import { grouped } from "../units.js";
/** @import { Answer, App, State } from "../main.js" */

const SHOWN = 25;
const COLUMNS = [
  ["balls", "balls", "count"], ["exit_speed", "exit speed", "speed"], ["ev20", "hardest fifth", "speed"], ["bat_speed", "bat speed", "speed"],
  ["squared_up", "squared up", "share"], ["from_best", "from the best place", "offset"], ["home_runs_expected", "home runs expected", "count"],
];
const LOW_FIRST = ["from_best"];

// One field of the state that may be empty: a list of [value, balls]; hidden where there is nothing to choose.
export class Filter {
  /** @param {App} app */
  constructor(app, /** @type {string} */ field, /** @type {{ label: string, all: string }} */ { label, all }) {
    this.app = app;
    this.field = field;
    this.all = all;
    this.made = "";
    const id = `season-${field}`;
    this.select = make("select", { id });
    this.fault = make("p", { className: "fault", id: `${id}-fault`, hidden: true });
    this.select.setAttribute("aria-describedby", this.fault.id);
    this.select.addEventListener("change", () => app.setState({ [field]: this.select.value || null }));
    this.element = make("div", { className: "control", hidden: true }, make("label", { htmlFor: id, textContent: label }), make("div", { className: "entry" }, this.select), this.fault);
    this.element.dataset.field = field;
    this.fill([]);
    app.control({ field, sync: (state) => this.sync(state), fault: (message) => {
      this.fault.textContent = message;
      this.fault.hidden = message === "";
      if (message) this.element.hidden = false;
    } });
  }

  /** @param {Answer[]} list */
  fill(list) {
    const made = JSON.stringify(list);
    if (made !== this.made) {
      this.made = made;
      this.select.replaceChildren(new Option(this.all, ""), ...list.map(([value, balls, words = value]) => new Option(`${words} (${grouped(balls)})`, value)));
    }
    this.element.hidden = list.length < 2 && this.app.state[this.field] === null;
    this.sync(this.app.state);
  }

  /** @param {State} state */
  sync(state) {
    const value = state[this.field] ?? "";
    if (![...this.select.options].some((option) => option.value === value)) this.select.append(new Option(value, value));
    this.select.value = value;
  }
}

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
