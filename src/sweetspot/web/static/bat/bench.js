// The bench: one bat for every view. Choose it, bring your own, draw it, or change it as a workshop would; how it is swung.
//
//   this.bench = new Bench(app, { picture });   // picture: a BatView whose outline can be dragged; may be left out
//   side.append(this.bench.element, swingGroup(app), ballGroup(app));
//   this.bench.update(answer);                  // after every answer that has a bat

import { checked, textOf } from "./batfile.js";
import { unchanged } from "./unchanged.js";
import { ANY_STEP, button, choice, group, reveal, slider } from "../controls/controls.js";
import { make, partOf } from "../controls/parts.js";
import { posted } from "../shell/post.js";
import { wordsOf } from "../shell/status.js";
import { endWithRow } from "../controls/tables.js";
import { INCH, OUNCE, fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { BallPicture, BatShape, UsualHit } from "../answers.js" */
/** @import { App, Field, State } from "../shell/main.js" */
/** @import { Desk, Options, Words } from "../controls/controls.js" */
/** @import { BatView } from "./batview.js" */
/** @import { System } from "../controls/units.js" */

/** @typedef {{ position_m: number, diameter_m: number }} Station where the outline has a corner, and how wide it is there */

const OWN = "own file";
export const FILLS = [["nothing", "nothing"], ["cork", "cork"], ["rubber", "rubber"], ["polyurethane-foam", "polyurethane foam"]];

// What a button does with the server's help; where that fails, a dialog says why.
/** @param {() => Promise<void>} doing */
export async function orSaid(doing) {
  try {
    await doing();
  } catch (fault) {
    const dialog = make("dialog", {}, make("p", { textContent: fault.message }), make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
    dialog.addEventListener("close", () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }
}

// Questions about an implement of one's own; they are fetched when first wanted.
/** @param {App} app */
export async function describeOwn(app) {
  return orSaid(async () => (await import("./wizard.js")).wizard(app));
}

// The list of the catalogue's bats; a bat of one's own stands in it too, so that it never names another bat.
/** @param {Desk & Pick<App, "lists">} app */
export function batChoice(app, label = "Bat") {
  return choice(app, "bat", {
    label,
    options: app.lists("bats").then(({ bats }) => bats.map(({ key, name }) => [key, name])),
    shown: (state) => (state.bat_toml === null || state.bat_toml === undefined ? state.bat : OWN),
    take: (bat) => bat !== OWN && app.setState({ ...unchanged(app), bat }),
  });
}

// What a control stands at that nobody has moved: as is usual in the sport of the last answer's bat.
/** @param {Desk} app */
export const usual = (app, /** @type {keyof UsualHit} */ field) => () => app.answer?.bat?.usual?.[field] ?? null;

// A choice that follows the bat's sport until somebody chooses.
/** @param {Desk} app */
export function usualChoice(app, /** @type {keyof UsualHit & Field} */ field, /** @type {{ label: Words, options: Options | Promise<Options>, note?: string }} */ look) {
  return choice(app, field, { ...look, follows: true, shown: (state) => state[field] ?? usual(app, field)() });
}

// What a workshop does to a bat; parts that a bat cannot have are hidden by what `show` is told.
/** @param {Desk} app */
export function workshop(app, /** @type {() => number | null | undefined} */ mass) {
  const wall = slider(app, "wall_factor", { label: "Wall thickness, times", step: 0.01 });
  const holes = document.createElement("div");
  holes.append(
    slider(app, "bore_diameter_in", { label: "Hole in the barrel, width", step: 0.05 }),
    slider(app, "bore_depth_in", { label: "Hole, depth from the tip", step: 0.25 }),
    choice(app, "bore_fill", { label: "Hole filled with", options: FILLS }),
    slider(app, "cup_diameter_in", { label: "Cupped end, width", step: 0.05 }),
    slider(app, "cup_depth_in", { label: "Cupped end, depth", step: 0.05 }),
  );
  const remark = Object.assign(document.createElement("p"), { className: "note", hidden: true });
  const show = (/** @type {{ hollow: boolean, remark: Record<System, string> }} */ { hollow, remark: words }) => {
    wall.hidden = !hollow;
    holes.hidden = hollow;
    remark.hidden = !words[app.units];
    remark.textContent = words[app.units];
  };
  const controls = [
    slider(app, "mass_oz", { label: "Weight of the bat", step: 0.1, empty: () => (mass() ?? 0.88) / OUNCE }), remark, wall, holes,
    slider(app, "weight_oz", { label: "Added weight", step: 0.1 }),
    slider(app, "weight_from_tip_in", { label: "Added weight, from the tip", step: 0.25 }),
    slider(app, "choke_up_in", { label: "Choke up", step: 0.1 }),
  ];
  return { controls, show };
}

// How a bat that was changed or is choked up is swung; of another there is nothing to ask.
/** @param {App} app */
function swungWith(app) {
  const box = choice(app, "same", { label: "The changed bat is swung with", options: [["effort", "the same effort"], ["speed", "the same speed"]] });
  app.control({ field: "parts of same", follows: true, sync: () => (box.hidden = !app.answer?.bat?.swung) });
  return box;
}

// pitched: whether the pitch is told by its speed alone; else a view chooses it otherwise. asked: whether the group asks
// how a changed bat is swung; else the view asks that of every bat.
/** @param {App} app */
export function swingGroup(app, { open = true, title = "Swing and pitch", pitched = true, asked = true } = {}) {
  return group(title, [
    ...(pitched ? [slider(app, "pitch_speed_mph", { label: "Pitch speed", step: 0.5, empty: usual(app, "pitch_speed_mph") })] : []),
    slider(app, "bat_speed_mph", { label: () => `Bat speed, ${app.text("from_m", 6 * INCH, app.units === "us" ? 0 : 1)} from the tip`, step: 0.5,
      empty: usual(app, "bat_speed_mph") }),
    ...(asked ? [swungWith(app)] : []),
    slider(app, "hands_in", { label: "Top hand above the grip's end", step: 0.1 }),
    button("As usual with this bat", () => app.setState({ pitch_speed_mph: null, bat_speed_mph: null, ball: null, ball_toml: null }),
      { title: `${pitched ? "Pitch, bat" : "Bat"} speed and ball as is usual in the bat's sport` }),
  ], { open });
}

/** @param {App} app */
export function ballGroup(app) {
  const known = (/** @type {keyof BallPicture} */ name) => () => app.answer?.ball?.[name] ?? null;
  return group("Ball", [
    choice(app, "ball", {
      label: "Ball", follows: true,
      options: app.lists("balls").then(({ balls }) => balls.map(({ key, name }) => [key, name])),
      shown: (state) => (state.ball_toml ? OWN : state.ball ?? usual(app, "ball")()),
      take: (ball) => ball !== OWN && app.setState({ ball, ball_toml: null }),
    }),
    ownBall(app),
    slider(app, "ball_cor", { label: "Restitution (COR) as bought", step: 0.005, empty: known("cor") }),
    slider(app, "ball_humidity", { label: "Stored at humidity", step: 0.01, empty: known("humidity") }),
    slider(app, "ball_temperature_degf", { label: "Temperature", step: 1, empty: known("temperature_degf") }),
    button("As it came", () => app.setState({ ball_cor: null, ball_humidity: null, ball_temperature_degf: null })),
  ], { open: false });
}

// A ball file: chosen, or written as text. The server says what is wrong in it.
/** @param {App} app */
function ownBall(app) {
  const element = Object.assign(document.createElement("details"), { className: "own" });
  element.innerHTML = "<summary>Your own ball (file or text)</summary>" +
    "<p class=\"note\"><code>sweetspot show baseball</code> prints one; <code>like = \"baseball\"</code> and what differs is enough: " +
    "<code>cor_reference = 0.50</code>, <code>mass = \"5.1 oz\"</code>, <code>compression = \"230 lb\"</code>, <code>temperature = \"40 degF\"</code>.</p>" +
    "<label for=\"ball-file\">Ball file (TOML)</label><input type=\"file\" id=\"ball-file\" accept=\".toml,text/plain\">" +
    "<label for=\"ball-text\">As text</label><textarea id=\"ball-text\" rows=\"7\" wrap=\"off\" spellcheck=\"false\" aria-describedby=\"ball-fault\"></textarea>" +
    "<p class=\"fault\" id=\"ball-fault\" role=\"alert\" hidden></p><div class=\"row\"></div>";
  const text = partOf(element, "textarea", HTMLTextAreaElement);
  const words = partOf(element, ".fault", HTMLElement);
  const fault = (/** @type {string} */ message) => {
    words.textContent = message;
    words.hidden = message === "";
    text.toggleAttribute("aria-invalid", message !== "");
    if (message) reveal(element);
  };
  const take = () => app.setState({ ball_toml: text.value.trim() ? text.value : null });
  const chosen = partOf(element, "input", HTMLInputElement);
  chosen.addEventListener("change", async () => {
    const file = chosen.files?.[0];
    chosen.value = ""; // so that the same file can be chosen again once it is mended
    if (!file) return;
    try {
      text.value = await textOf(file);
      take();
    } catch (wrong) {
      fault(wordsOf(wrong, app.units));
    }
  });
  partOf(element, ".row", HTMLElement).append(button("Use this text", take, { primary: true }));
  app.control({
    field: "ball_toml",
    sync: ({ ball_toml: now }) => {
      if (now && document.activeElement !== text && !text.value) text.value = now;
    },
    fault,
  });
  return element;
}

export class Bench {
  /** @param {App} app @param {{ picture?: BatView | null, open?: boolean }} look */
  constructor(app, { picture = null, open = true } = {}) {
    this.app = app;
    this.picture = picture;
    /** @type {Station[]} */
    this.stations = [];
    this.own = new OwnBat(app);
    this.outline = new Outline(app, (stations, last) => this.reshape(stations, last), (on) => this.draw(on), picture !== null);
    const { controls, show } = workshop(app, () => app.answer?.bat?.mass_kg);
    this.show = show;
    this.element = group("Bat", [
      batChoice(app), button("Describe yours by questions\u00a0…", () => describeOwn(app)), this.own.element, this.outline.element,
      group("Workshop", [...controls, button("As it was", () => app.setState(unchanged(app)))], { open: false }),
    ], { open });
  }

  /** @param {boolean} on */
  draw(on) {
    if (this.picture) this.picture.drawing = on;
    this.app.redraw();
  }

  /** @param {Station[]} stations @param {boolean} last */
  reshape(stations, last) {
    const profile = stations.map((station) => /** @type {[number, number]} */ ([rounded(station.position_m / INCH), rounded(station.diameter_m / INCH)]));
    this.app.setState({ profile_in: profile }, { commit: last });
  }

  /** @param {{ bat?: BatShape }} given */
  update({ bat }) {
    if (!bat) return;
    this.show(bat);
    this.outline.update(bat.stations);
  }
}

// A bat file: chosen, dropped anywhere on the page, or written as text.
class OwnBat {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    const root = partOf(document, "#view", HTMLElement);
    const { signal } = app;
    this.element = Object.assign(document.createElement("details"), { className: "own" });
    this.element.innerHTML = "<summary>Your own bat (file or text)</summary>" +
      "<p class=\"note\">Drop a bat file anywhere on this page, choose it, or change the text.</p>" +
      "<label for=\"bat-file\">Bat file (TOML)</label><input type=\"file\" id=\"bat-file\" accept=\".toml,text/plain\">" +
      "<label for=\"bat-text\">As text</label><textarea id=\"bat-text\" rows=\"12\" wrap=\"off\" spellcheck=\"false\" aria-describedby=\"bat-fault\"></textarea>" +
      "<p class=\"fault\" id=\"bat-fault\" role=\"alert\" hidden></p><div class=\"row\"></div>";
    this.text = partOf(this.element, "textarea", HTMLTextAreaElement);
    this.words = partOf(this.element, ".fault", HTMLElement);
    partOf(this.element, ".row", HTMLElement).append(
      button("Use this text", () => this.take(this.text.value), { primary: true }),
      button("Show the present bat", () => this.show()),
    );
    const chosen = partOf(this.element, "input", HTMLInputElement);
    chosen.addEventListener("change", () => {
      this.read(chosen.files?.[0]);
      chosen.value = ""; // so that the same file can be chosen again once it is mended
    });
    this.element.addEventListener("toggle", () => this.element.open && !this.text.value && this.show());
    root.addEventListener("dragover", (event) => (event.preventDefault(), root.classList.add("drop")), { signal });
    root.addEventListener("dragleave", () => root.classList.remove("drop"), { signal });
    signal.addEventListener("abort", () => root.classList.remove("drop"));
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      root.classList.remove("drop");
      this.element.open = true;
      this.read(event.dataTransfer?.files[0]);
    }, { signal });
    app.control({ field: "bat_toml", sync: (state) => this.sync(state), fault: (message) => this.fault(message) });
  }

  /** @param {string} message */
  fault(message) {
    this.words.textContent = message;
    this.words.hidden = message === "";
    this.text.toggleAttribute("aria-invalid", message !== "");
    if (message) reveal(this.element);
  }

  /** @param {File | undefined} file */
  async read(file) {
    if (!file) return;
    try {
      this.take(await textOf(file));
    } catch (fault) {
      this.fault(wordsOf(fault, this.app.units));
    }
  }

  /** @param {string} text */
  async take(text) {
    this.text.value = text;
    try {
      await checked(text);
    } catch (fault) {
      this.fault(wordsOf(fault, this.app.units));
      return;
    }
    this.fault("");
    this.app.setState({ ...unchanged(this.app), bat_toml: text });
  }

  async show() {
    try {
      this.text.value = await batText(this.app);
    } catch (fault) {
      this.fault(wordsOf(fault, this.app.units));
    }
  }

  /** @param {State} state */
  sync({ bat_toml: text }) {
    if (text && document.activeElement !== this.text && !this.text.value) this.text.value = text;
  }
}

/** @type {[keyof Station, string][]} */
const SIZES = [["position_m", "place"], ["diameter_m", "diameter"]];

// The outline: a switch that shows handles on the picture, and the same stations as numbers.
class Outline {
  /**
   * @param {App} app
   * @param {(stations: Station[], last: boolean) => void} onChange
   * @param {(on: boolean) => void} onDraw
   * @param {boolean} drawn  whether a picture has handles too
   */
  constructor(app, onChange, onDraw, drawn) {
    this.app = app;
    this.onChange = onChange;
    /** @type {Station[]} */
    this.stations = [];
    this.shown = "";
    this.element = document.createElement("details");
    this.element.innerHTML = "<summary>Draw the outline</summary><p class=\"note\">" +
      (drawn ? "Drag the handles on the picture, or change the numbers" : "Change the numbers") + ": place from the knob and diameter.</p><div class=\"stations\" tabindex=\"0\"><table><thead><tr><th scope=\"col\">" +
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

// The bat as it stands, as the text of a bat file; a refusal is thrown.
/** @param {App} app */
export async function batText(app) {
  const { toml } = await posted("/api/v1/explorer/recipe", Object.fromEntries(
    Object.entries(app.carried).filter(([field]) => Object.hasOwn(app.entry("explorer").schema, field))));
  return toml;
}

const rounded = (/** @type {number} */ value) => Math.round(1e4 * value) / 1e4;
