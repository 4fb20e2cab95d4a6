// The outline as numbers: stations where it has a corner, and how wide it is there. Its heading also shows handles on the
// pictures that have them.

import { ANY_STEP, button, reveal } from "../controls/controls.js";
import { partOf } from "../controls/parts.js";
import { endWithRow } from "../controls/tables.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { Desk } from "../controls/controls.js" */
/** @import { App } from "../shell/main.js" */

/** @typedef {{ position_m: number, diameter_m: number }} Station where the outline has a corner, and how wide it is there */

/** @type {[keyof Station, string][]} */
const SIZES = [["position_m", "place"], ["diameter_m", "diameter"]];

// The outline: a switch that shows handles on the picture, and the same stations as numbers.
export class Outline {
  /**
   * @param {Desk & Pick<App, "units">} app
   * @param {(stations: Station[], last: boolean) => void} onChange
   * @param {(on: boolean) => void} onDraw
   */
  constructor(app, onChange, onDraw) {
    this.app = app;
    this.onChange = onChange;
    /** @type {Station[]} */
    this.stations = [];
    this.shown = "";
    this.element = document.createElement("details");
    this.element.innerHTML = "<summary>Draw the outline</summary><p class=\"note\">" +
      "Drag the handles on the Explorer's picture, or change the numbers: place from the knob and diameter.</p><div class=\"stations\" tabindex=\"0\"><table><thead><tr><th scope=\"col\">" +
      "</th><th scope=\"col\"></th><th scope=\"col\"><span class=\"unseen\">Change</span></th></tr></thead><tbody></tbody></table></div>" +
      "<p class=\"fault\" role=\"alert\" hidden></p>";
    this.body = partOf(this.element, "tbody", HTMLElement);
    this.heads = [...this.element.querySelectorAll("th")].slice(0, 2);
    this.words = partOf(this.element, ".fault", HTMLElement);
    this.element.addEventListener("toggle", () => onDraw(this.element.open));
    app.control({ field: "profile_in", sync: () => {}, fault: (message) => this.fault(message) });
  }

  /** @param {string} message */
  fault(message) {
    this.words.textContent = message;
    this.words.hidden = message === "";
    if (message) reveal(this.element);
  }

  /** @param {Station[]} stations */
  update(stations) {
    this.stations = stations;
    const now = JSON.stringify(stations) + this.app.units;
    if (now === this.shown || this.body.contains(document.activeElement) || !this.element.open) {
      if (!this.element.open || now === this.shown) return;
    }
    this.shown = now;
    const parts = () => /** @type {NodeListOf<HTMLElement>} */ (this.body.querySelectorAll("input, button"));
    const focused = [...parts()].findIndex((one) => one === document.activeElement);
    this.heads.forEach((head, i) => (head.textContent = `${["Place", "Diameter"][i]}, ${this.unit}`));
    this.body.replaceChildren(...stations.map((station, index) => this.row(station, index)));
    parts()[focused]?.focus();
    endWithRow(partOf(this.element, ".stations", HTMLElement));
  }

  get unit() { return unitOf("length", this.app.units); }

  /** @param {Station} station @param {number} index */
  row(station, index) {
    const row = document.createElement("tr");
    const { unit, app: { units } } = this;
    for (const [key, words] of SIZES) {
      const field = Object.assign(document.createElement("input"), { type: "number", step: ANY_STEP, value: Number(toShown("length", station[key], units).toFixed(3)) });
      field.setAttribute("aria-label", `Station ${index + 1}, ${words}, ${unit}`);
      field.addEventListener("change", () => this.change(index, { [key]: fromShown("length", Number(field.value), units) }));
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

  /** @param {number} index @param {Partial<Station>} values */
  change(index, values) {
    this.onChange(this.stations.map((station, i) => (i === index ? { ...station, ...values } : station)), true);
  }

  /** @param {number} index */
  insert(index) {
    const [here, next] = [this.stations[index], this.stations[index + 1]];
    const middle = {
      position_m: (here.position_m + next.position_m) / 2, diameter_m: (here.diameter_m + next.diameter_m) / 2,
    };
    this.onChange([...this.stations.slice(0, index + 1), middle, ...this.stations.slice(index + 1)], true);
  }
}

/** @param {...(Node | string)} parts */
function cellOf(...parts) {
  const cell = document.createElement("td");
  cell.append(...parts);
  return cell;
}
