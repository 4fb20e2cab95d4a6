// The bats of the comparison: each chosen from the catalogue or a file, each changed as a workshop would.

import { button, choice, slider } from "../controls.js";
import { make, scoped } from "../parts.js";
import { posted } from "../post.js";

const MOST = 4;
const LONGEST_TOML = 20000;
const FILLS = [["nothing", "nothing"], ["cork", "cork"], ["rubber", "rubber"], ["polyurethane-foam", "polyurethane foam"]];
const FIRST_CHOICES = ["r161-ash", "russell-b6", "youth-30", "composite"];

export class Slots {
  constructor(app) {
    this.app = app;
    this.schema = app.views.get("explorer").schema;
    const kept = ["bat", "bat_toml", "profile_in", "mass_oz", "wall_factor", "bore_diameter_in", "bore_depth_in", "bore_fill",
      "cup_diameter_in", "cup_depth_in", "weight_oz", "weight_from_tip_in", "choke_up_in"];
    this.defaults = Object.fromEntries(kept.map((field) => [field, this.schema[field].default ?? null]));
    this.names = app.lists().then(({ bats }) => bats.map((bat) => [bat.key, bat.name]));
    this.slots = Array.from({ length: MOST }, (_, index) => this.slot(index));
    this.more = button("Add a bat", () => this.add());
    this.fault = make("p", { className: "fault", hidden: true });
    app.control({ field: "bats", sync: (state) => this.sync(state), fault: (message) => {
      this.fault.textContent = message;
      this.fault.hidden = message === "";
    } });
    this.element = make("details", { className: "group", open: true }, make("summary", { textContent: "Bats" }),
      ...this.slots.map(({ element }) => element), this.more, this.fault);
  }

  slot(index) {
    const one = scoped(this.app, "bats", index, this.schema, this.defaults);
    const title = index === 0 ? "Bat 1, the reference" : `Bat ${index + 1}`;
    const own = make("span", { className: "note", hidden: true, textContent: "From your file; choosing a name above takes that bat instead." });
    const file = make("input", { type: "file", accept: ".toml,text/plain", ariaLabel: `${title}: your own bat file (TOML)` });
    file.addEventListener("change", () => this.read(file, one, index));
    const wall = slider(one, "wall_factor", { label: "Wall thickness, times", step: 0.01 });
    const hole = make("div", {},
      slider(one, "bore_diameter_in", { label: "Hole in the barrel, width", step: 0.05 }),
      slider(one, "bore_depth_in", { label: "Hole, depth from the tip", step: 0.25 }),
      choice(one, "bore_fill", { label: "Hole filled with", options: FILLS }));
    const change = make("details", {}, make("summary", { textContent: "Change it" }),
      slider(one, "mass_oz", { label: "Weight of the bat", step: 0.1, empty: 31 }), wall, hole,
      slider(one, "choke_up_in", { label: "Choke up", step: 0.1 }),
      make("label", { className: "note" }, "Your own bat file ", file));
    const row = make("div", { className: "row" });
    if (index > 0) {
      const remove = button("Remove", () => this.remove(index));
      remove.setAttribute("aria-label", `Remove ${title}`);
      row.append(remove);
    }
    const pick = choice(one, "bat", { label: title, options: this.names, onChange: () => one.setState({ bat_toml: null, mass_oz: null }) });
    const element = make("fieldset", { className: "slot" }, make("legend", { className: "unseen", textContent: title }), pick, own, change, row);
    return { element, own, wall, hole };
  }

  // A what-if is about bat 1 alone; the others keep their places in the state until it is over.
  sync({ bats, what_if: asked }) {
    this.slots.forEach(({ element, own }, i) => {
      element.hidden = i >= (asked === "none" ? bats.length : 1);
      own.hidden = !bats[i]?.bat_toml;
    });
    this.more.hidden = bats.length >= MOST || asked !== "none";
  }

  update({ bats }, { what_if: asked }) {
    const shown = asked === "none" ? bats : bats.slice(0, 1);
    shown.forEach(({ shape }, i) => {
      this.slots[i].wall.hidden = !shape.hollow;
      this.slots[i].hole.hidden = shape.hollow;
    });
  }

  add() {
    const taken = this.app.state.bats.map(({ bat = this.defaults.bat }) => bat);
    const next = FIRST_CHOICES.find((name) => !taken.includes(name)) ?? this.defaults.bat;
    this.app.setState({ bats: [...this.app.state.bats, { bat: next }] });
  }

  remove(index) {
    this.app.setState({ bats: this.app.state.bats.filter((_, i) => i !== index) });
    this.more.focus();
  }

  async read(input, one, index) {
    const file = input.files[0];
    if (!file) return;
    const say = (message) => this.app.controls.get(`bats.${index}.bat`).fault(message);
    if (file.size > LONGEST_TOML) {
      say(`${file.name} has ${file.size} bytes; a bat file has a few lines, at most ${LONGEST_TOML}.`);
      return;
    }
    const text = await file.text();
    input.value = ""; // so that the same file, mended, can be chosen again
    try {
      await posted("/api/v1/bat", { toml: text });
    } catch (fault) {
      say(fault.message);
      return;
    }
    one.setState({ ...this.defaults, bat_toml: text });
  }
}
