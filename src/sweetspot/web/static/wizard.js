// A bat by questions: what it is for, how long and heavy it is, where it balances, what it is made of.

import { unchanged } from "./bench.js";
import { button } from "./controls.js";
import { make } from "./parts.js";
import { posted } from "./post.js";
import table from "./quantities.js";
import { fromShown, toShown, unitOf } from "./units.js";
/** @import { App } from "./main.js" */

const PER_OUNCE_INCH_SQUARED = 1 / table.scales.moi.us.scale; // kg m^2
// Field of the answer: words, kind, first value in the answer's unit (null where it may stay empty).
/** @type {[string, string, string, number | null][]} */
const NUMBERS = [
  ["length_in", "Length", "length_in", 33], ["mass_oz", "Weight", "mass_oz", 31],
  ["balance_in", "Balance point from the knob, if measured", "balance_in", null],
  ["swing_weight_oz_in2", "Swing weight about the axis 6 in from the knob, if measured", "moi", null],
];
const WOODS = [["white-ash", "white ash"], ["sugar-maple", "sugar maple"], ["yellow-birch", "yellow birch"], ["hickory", "hickory"]];

/** @param {App} app */
export function wizard(app) {
  const dialog = make("dialog", { className: "wizard" });
  dialog.setAttribute("aria-labelledby", "wizard-title");
  const faults = new Map();
  const row = (field, words, input, unit = "") => {
    input.id = `wizard-${field}`;
    const fault = make("p", { className: "fault", hidden: true, id: `wizard-${field}-fault` });
    input.setAttribute("aria-describedby", fault.id);
    faults.set(field, fault);
    return make("div", { className: "control" }, make("label", { htmlFor: input.id, textContent: words }),
      make("div", { className: "entry" }, input, make("span", { className: "unit", textContent: unit })), fault);
  };
  const pick = (options) => make("select", {}, ...options.map(([value, words]) => new Option(words, value)));
  const kind = pick([["baseball", "baseball"], ["softball", "softball"], ["youth", "youth baseball"]]);
  const built = pick([["wood", "of wood, turned"], ["hollow", "hollow, of metal"]]);
  const material = pick(WOODS);
  const name = make("input", { type: "text", value: "my bat", maxLength: 60 });
  const inner = (field, shown) => (field === "swing_weight_oz_in2" ? fromShown("x_kg_m2", shown, app.units) / PER_OUNCE_INCH_SQUARED : fromShown(field, shown, app.units));
  const numbers = NUMBERS.map(([field, words, kindOf, first]) => {
    const input = make("input", { type: "number", step: "any", value: first === null ? "" : String(Number(toShown(field, first, app.units).toFixed(1))) });
    return { field, input, row: row(field, words, input, unitOf(kindOf, app.units)) };
  });
  const wood = row("material", "Wood", material);
  built.addEventListener("change", () => (wood.hidden = built.value !== "wood"));
  const said = make("p", { className: "fault", hidden: true });
  said.setAttribute("role", "alert");
  const use = button("Put it on the bench", async () => {
    for (const fault of [...faults.values(), said]) fault.hidden = true;
    const wanted = { name: name.value || "my bat", used_for: kind.value, built: built.value, material: material.value };
    for (const { field, input } of numbers) if (input.value !== "") wanted[field] = inner(field, Number(input.value));
    try {
      const { toml } = await posted("/api/v1/describe", wanted);
      dialog.close();
      const fields = unchanged({ schema: app.entry("explorer").schema });
      if (Object.hasOwn(app.schema, "bat_toml")) app.setState({ ...fields, bat_toml: toml });
      else {
        Object.assign(app.carried, fields, { bat_toml: toml });
        app.visit(app.addressFor("explorer"));
      }
    } catch (fault) {
      const place = faults.get(fault.field) ?? said;
      place.textContent = fault.message;
      place.hidden = false;
    }
  }, { primary: true });
  dialog.append(make("h2", { id: "wizard-title", textContent: "Describe your bat" }),
    make("p", { className: "note", textContent: "Its outline is that of a usual bat, stretched to your length; what you measured is matched or, where it cannot be, refused with the reason. A file says more." }),
    row("name", "Name", name), row("used_for", "For", kind), row("built", "Built", built), wood, ...numbers.map((one) => one.row), said,
    make("div", { className: "row" }, use, button("Close", () => dialog.close())));
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
