// The bat's part of the explorer: choose it, bring your own, draw it, or change it as a workshop would.

import { button, choice, group, slider } from "../controls.js";
import { posted } from "../post.js";

const INCH = 0.0254, OUNCE = 0.028349523125;
const LONGEST_TOML = 20000;
const UNCHANGED = ["bat_toml", "profile_in", "mass_oz", "wall_factor", "bore_diameter_in", "cup_diameter_in", "weight_oz"];
const FILLS = [["nothing", "nothing"], ["cork", "cork"], ["rubber", "rubber"], ["polyurethane-foam", "polyurethane foam"]];

export class Bench {
  constructor(app, picture, root) {
    Object.assign(this, { app, picture, stations: [] });
    this.own = new OwnBat(app, root);
    this.outline = new Outline(app, (stations, last) => this.reshape(stations, last), (on) => this.draw(on));
    const bats = app.lists().then((lists) => lists.bats.map((bat) => [bat.key, bat.name]));
    this.wall = slider(app, "wall_factor", { label: "Wall thickness, times", step: 0.01 });
    this.holes = document.createElement("div");
    this.holes.append(
      slider(app, "bore_diameter_in", { label: "Hole in the barrel, width", step: 0.05 }),
      slider(app, "bore_depth_in", { label: "Hole, depth from the tip", step: 0.25 }),
      choice(app, "bore_fill", { label: "Hole filled with", options: FILLS }),
      slider(app, "cup_diameter_in", { label: "Cupped end, width", step: 0.05 }),
      slider(app, "cup_depth_in", { label: "Cupped end, depth", step: 0.05 }),
    );
    this.element = group("Bat", [
      choice(app, "bat", { label: "Bat", options: bats, onChange: () => app.setState({ bat_toml: null, profile_in: null, mass_oz: null }) }),
      this.own.element, this.outline.element,
      group("Workshop", [
        slider(app, "mass_oz", { label: "Weight of the bat", step: 0.1, empty: () => (app.answer?.bat.mass_kg ?? 0.88) / OUNCE }),
        this.wall, this.holes,
        slider(app, "weight_oz", { label: "Added weight", step: 0.1 }),
        slider(app, "weight_from_tip_in", { label: "Added weight, from the tip", step: 0.25 }),
        button("As it was", () => app.setState(Object.fromEntries(UNCHANGED.map((field) => [field, app.defaults[field]])))),
      ], { open: false }),
    ]);
  }

  draw(on) {
    this.picture.drawing = on;
    this.app.redraw();
  }

  reshape(stations, last) {
    const profile = stations.map((station) => [rounded(station.position_m / INCH), rounded(station.diameter_m / INCH)]);
    this.app.setState({ profile_in: profile }, { commit: last });
  }

  update(answer, state) {
    this.wall.hidden = !answer.bat.hollow;
    this.holes.hidden = answer.bat.hollow;
    this.own.update(answer, state);
    this.outline.update(answer.bat.stations);
  }
}

// A bat file: chosen, dropped anywhere on the page, or written as text.
class OwnBat {
  constructor(app, root) {
    this.app = app;
    this.element = Object.assign(document.createElement("details"), { className: "own" });
    this.element.innerHTML = "<summary>Your own bat (file or text)</summary>" +
      "<p class=\"note\">Drop a bat file anywhere on this page, choose it, or change the text.</p>" +
      "<label for=\"bat-file\">Bat file (TOML)</label><input type=\"file\" id=\"bat-file\" accept=\".toml,text/plain\">" +
      "<label for=\"bat-text\">As text</label><textarea id=\"bat-text\" rows=\"12\" spellcheck=\"false\" aria-describedby=\"bat-fault\"></textarea>" +
      "<p class=\"fault\" id=\"bat-fault\" role=\"alert\" hidden></p><div class=\"row\"></div>";
    this.text = this.element.querySelector("textarea");
    this.words = this.element.querySelector(".fault");
    this.element.querySelector(".row").append(
      button("Use this text", () => this.take(this.text.value), { primary: true }),
      button("Show the present bat", () => this.show()),
    );
    this.element.querySelector("input").addEventListener("change", (event) => {
      this.read(event.target.files[0]);
      event.target.value = ""; // so that the same file can be chosen again once it is mended
    });
    this.element.addEventListener("toggle", () => this.element.open && !this.text.value && this.show());
    root.addEventListener("dragover", (event) => (event.preventDefault(), root.classList.add("drop")));
    root.addEventListener("dragleave", () => root.classList.remove("drop"));
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      root.classList.remove("drop");
      this.element.open = true;
      this.read(event.dataTransfer.files[0]);
    });
    app.control({ field: "bat_toml", sync() {}, fault: (message) => this.fault(message) });
  }

  fault(message) {
    this.words.textContent = message;
    this.words.hidden = message === "";
    this.text.toggleAttribute("aria-invalid", message !== "");
    if (message) this.element.open = true;
  }

  async read(file) {
    if (!file) return;
    if (file.size > LONGEST_TOML) {
      this.fault(`${file.name} has ${file.size} bytes; a bat file has a few lines, at most ${LONGEST_TOML}.`);
      return;
    }
    this.take(await file.text());
  }

  async take(text) {
    this.text.value = text;
    try {
      await posted("/api/v1/bat", { toml: text });
    } catch (fault) {
      this.fault(fault.message);
      return;
    }
    this.fault("");
    this.app.setState({ ...Object.fromEntries(UNCHANGED.map((field) => [field, this.app.defaults[field]])), bat_toml: text });
  }

  async show() {
    const { toml } = await posted("/api/v1/explorer/recipe", this.app.state);
    this.text.value = toml;
  }

  update(answer, state) {
    if (state.bat_toml !== null && document.activeElement !== this.text && !this.text.value) this.text.value = state.bat_toml;
  }
}

// The outline: a switch that shows handles on the picture, and the same stations as numbers.
class Outline {
  constructor(app, onChange, onDraw) {
    Object.assign(this, { app, onChange, stations: [], shown: "" });
    this.element = document.createElement("details");
    this.element.innerHTML = "<summary>Draw the outline</summary><p class=\"note\">Drag the handles on the picture, or " +
      "change the numbers: place from the knob and diameter.</p><div class=\"stations\" tabindex=\"0\"><table><thead><tr><th scope=\"col\">" +
      "Place</th><th scope=\"col\">Diameter</th><th scope=\"col\"><span class=\"unseen\">Change</span></th></tr></thead><tbody></tbody></table></div>" +
      "<p class=\"fault\" role=\"alert\" hidden></p>";
    this.body = this.element.querySelector("tbody");
    this.words = this.element.querySelector(".fault");
    this.element.addEventListener("toggle", () => onDraw(this.element.open));
    app.control({ field: "profile_in", sync: () => {}, fault: (message) => this.fault(message) });
  }

  fault(message) {
    this.words.textContent = message;
    this.words.hidden = message === "";
  }

  update(stations) {
    this.stations = stations;
    const now = JSON.stringify(stations) + this.app.units;
    if (now === this.shown || this.body.contains(document.activeElement) || !this.element.open) {
      if (!this.element.open || now === this.shown) return;
    }
    this.shown = now;
    const focused = [...this.body.querySelectorAll("input, button")].indexOf(document.activeElement);
    this.body.replaceChildren(...stations.map((station, index) => this.row(station, index)));
    this.body.querySelectorAll("input, button")[focused]?.focus();
  }

  row(station, index) {
    const row = document.createElement("tr");
    const scale = this.app.units === "us" ? 1 / INCH : 1000;
    const unit = this.app.units === "us" ? "in" : "mm";
    for (const [key, words] of [["position_m", "place"], ["diameter_m", "diameter"]]) {
      const field = Object.assign(document.createElement("input"), { type: "number", step: "any", value: rounded(station[key] * scale) });
      field.setAttribute("aria-label", `Station ${index + 1}, ${words}, ${unit}`);
      field.addEventListener("change", () => this.change(index, { [key]: Number(field.value) / scale }));
      row.append(cellOf(field));
    }
    const inner = index > 0 && index < this.stations.length - 1;
    const remove = button("−", () => this.onChange(this.stations.filter((_, i) => i !== index), true), { title: "Remove this station" });
    const add = button("+", () => this.insert(index), { title: "Add a station after this one" });
    remove.setAttribute("aria-label", `Remove station ${index + 1}`);
    add.setAttribute("aria-label", `Add a station after station ${index + 1}`);
    remove.disabled = !inner;
    add.disabled = index === this.stations.length - 1;
    row.append(cellOf(remove, add));
    return row;
  }

  change(index, values) {
    this.onChange(this.stations.map((station, i) => (i === index ? { ...station, ...values } : station)), true);
  }

  insert(index) {
    const [here, next] = [this.stations[index], this.stations[index + 1]];
    const middle = {
      position_m: (here.position_m + next.position_m) / 2, diameter_m: (here.diameter_m + next.diameter_m) / 2,
    };
    this.onChange([...this.stations.slice(0, index + 1), middle, ...this.stations.slice(index + 1)], true);
  }
}

function cellOf(...parts) {
  const cell = document.createElement("td");
  cell.append(...parts);
  return cell;
}

const rounded = (value) => Math.round(1e4 * value) / 1e4;
