// Modes: how a bat moves and rings, where each motion stands still, and what a tap excites.


import { button, group, slider, toggle } from "../controls/controls.js";
import { Stage, paintMotion } from "../bat/modescene.js";
import { Numbers, evenly } from "../charts/numbers.js";
import { changed, make, partOf, tell } from "../controls/parts.js";
import { Surface } from "../charts/surface.js";
import { unbroken } from "../controls/tables.js";
import { strike } from "../controls/tapsound.js";
import { INCH, kindOf, toShown } from "../controls/units.js";
/** @import { BatMotion, ModesAnswer, States } from "../answers.js" */
/** @import { AppOf, Guide } from "../shell/main.js" */

const PERIOD = 1400; // ms on the screen of one swing to and fro, whatever its real frequency
const MOST_ROWS = 14;

export default class ModesView {
  /** @type {Guide} */
  static guide = [
    ["How a bat rings", "A bat that is struck bends to and fro in several ways at once, its modes. One of them is shown, " +
      "slowed down and drawn larger than it is."],
    ["Tap it", "Press or drag along the bat to tap it there. A tap where a mode stands still does not excite it. " +
      "Listen to the tap, and choose the mode to look at from the table."],
    ["Change the tap", "A short, hard tap excites the high notes, a long, soft one only the low. Hold the bat with hands, or let " +
      "it hang free. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"modes">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {ModesAnswer | null} */
    this.answer = null;
    this.state = /** @type {States["modes"]} */ (app.state);
    this.phase = 1;
    /** @type {(() => void) | null} */
    this.stop = null;
    this.begun = false;
    this.all = false; // whether motions are listed that barely ring
    this.listed = this.spoken = ""; // the motions in the list, and what was last said
    /** @type {{ line: HTMLElement, input: HTMLInputElement, share: HTMLElement, felt: HTMLElement }[]} */
    this.cells = [];
    /** @type {Set<number>} */
    this.woken = new Set(); // rows that some tap has woken so far: none goes while one drags
    this.stage = new Surface(app, {
      label: "A motion of the bat", height: (width) => (this.answer ? new Stage(this.answer, width).height : 360),
      paint: (context, width, height) => this.answer && paintMotion(context, width, height, this.shown(this.answer)),
    });
    this.stage.element.style.cursor = "ew-resize";
    this.stage.element.classList.add("pinned");
    this.stage.drags((/** @type {{ x: number, last: boolean }} */ { x, last }) => this.tapAt(x, last));
    this.words = make("p", { className: "verdict flow", id: "verdict" });
    this.toggle = button("Play", () => (this.stop ? this.pause() : this.play()), { primary: true, title: "Play or pause (K)" });
    this.toggle.id = "play";
    this.speed = make("span", { className: "note" });
    const row = make("div", { className: "transport" }, this.toggle,
      button("Listen to the tap", () => strike((this.answer?.modes ?? []).map(({ tap, ...tone }) => ({ ...tone, energy_share: tap.energy_share }))), { title: "The motions at their frequencies, dying away as they do" }), this.speed);
    this.rowsBox = make("div", { className: "scroll", tabIndex: 0, role: "region", ariaLabel: "List of the motions" });
    this.aside = make("p", { className: "note" });
    this.more = button("", () => {
      this.all = !this.all;
      if (this.answer) this.list(this.answer);
    });
    this.numbers = new Numbers(app, "This motion as a table", () => this.answer && this.tabled(this.answer));
    root.append(
      make("div", { className: "side" },
        group("Tap", [
          toggle(app, "held", { label: "Typical hands hold the bat", note: "Without hands it hangs free, as in a laboratory." }),
          slider(app, "tap_from_tip_in", { label: "Where, from the tip", step: 0.1 }),
          slider(app, "tap_ms", { label: "How long", step: 0.05, note: "A ball about 1 ms, a knuckle 2, a steel ball 0.1." }),
        ]),
        group("Picture", [slider(app, "exaggeration", { label: "Size of the motion", step: 0.1 })], { open: false })),
      make("section", { className: "picture", ariaLabel: "Motions of the bat" },
        this.words, this.stage.element, row, this.numbers.element, this.rowsBox, this.more, this.aside));
    root.addEventListener("keydown", (event) => this.key(event), { signal: app.signal });
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.key.toLowerCase() !== "k" || !(event.target instanceof Element) || event.target.matches("input[type=number], select") || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    this.toggle.click();
  }

  /** @param {number} pixel @param {boolean} last */
  tapAt(pixel, last) {
    if (!this.answer) return;
    const stage = new Stage(this.answer, this.stage.width);
    const inches = (this.answer.bat.length_m - stage.along(pixel)) / INCH;
    this.app.setState({ tap_from_tip_in: Math.round(20 * inches) / 20 }, { commit: last });
  }

  /** @param {ModesAnswer} answer @param {States["modes"]} state */
  update(answer, state) {
    Object.assign(this, { answer, state });
    this.list(answer);
    this.say(answer);
    this.numbers.redraw();
    this.aside.textContent = `Shaded: between the nodes of the first two bending modes. ${state.held
      ? "Damping of a held bat is each motion's own part; the hands' dampers couple the motions too. Hands: typical values, recalled and not measured."
      : "Damping of the hanging bat: the material's, the same ratio for every motion."}`;
    this.stage.draw();
    if (!this.begun && !this.app.calm) this.play();
    this.begun = true;
  }

  /** @param {ModesAnswer} answer */
  shown(answer) {
    const { state, app } = this;
    return { answer, motion: answer.modes[answer.chosen], phase: this.phase, size: state.exaggeration, both: !this.stop, colors: app.colors, text: app.text.bind(app) };
  }

  play() {
    let begin = NaN;
    this.stop = this.app.onFrame((now) => {
      if (Number.isNaN(begin)) begin = now;
      this.phase = Math.cos((2 * Math.PI * (now - begin)) / PERIOD);
      this.stage.draw();
    });
    this.toggle.textContent = "Pause";
  }

  // At rest the picture shows both ends of the motion.
  pause() {
    this.stop?.();
    this.stop = null;
    this.phase = 1;
    this.toggle.textContent = "Play";
    this.stage.draw();
  }

  /** @param {ModesAnswer} answer */
  list({ modes, chosen: index }) {
    const rows = modes.slice(0, MOST_ROWS);
    const shape = JSON.stringify(rows.map((row) => [row.family, row.number, row.shape]));
    if (shape !== this.listed) {
      this.listed = shape;
      this.rows(rows);
    }
    const chosen = modes[index];
    const most = Math.max(...rows.map((row) => row.tap.hand_speed_m_s_per_n_s));
    rows.forEach((row, i) => {
      const cells = this.cells[i];
      if (worthShowing(row) || row === chosen) this.woken.add(i);
      cells.line.hidden = !this.all && !this.woken.has(i);
      cells.input.checked = row.family === chosen.family && row.number === chosen.number;
      const share = row.tap.energy_share;
      bar(cells.share, share ?? 0, share === null ? "–" : percent(share));
      const felt = row.tap.hand_speed_m_s_per_n_s;
      bar(cells.felt, felt / (most || 1), this.app.text("sting", felt));
    });
    const quiet = rows.length - this.woken.size;
    this.more.hidden = quiet === 0;
    this.more.textContent = this.all ? "Leave out what barely rings" : `Show ${quiet} more that barely ring`;
  }

  /** @param {BatMotion[]} rows */
  rows(rows) {
    const held = document.activeElement?.matches("[name=motion]") ?? false;
    const heads = ["Motion", "Frequency", "Damping", "Dies away in", "Share of the tap's energy", "Felt at the hands after 1 N s"];
    const head = make("tr", {}, ...heads.map((words, i) => make("th", { textContent: unbroken(words), scope: "col", className: i && i < 4 ? "number" : "" })));
    const table = make("table", { className: "motions" }, make("caption", { className: "unseen", textContent: "Motions of the bat; choose one to see it" }), head);
    this.cells = rows.map((row) => {
      const input = make("input", { type: "radio", name: "motion", value: `${row.family} ${row.number}` });
      input.addEventListener("change", () => this.app.setState({ ...changed("family", row.family), number: row.number }));
      const { damping_ratio: damping, decay_s: decay } = row, numbers = [
        row.frequency_hz ? this.app.text("f_hz", row.frequency_hz) : "–", damping === null ? "–" : `${(100 * damping).toFixed(damping < 0.1 ? 2 : 0)} %`,
        decay === null ? "–" : this.app.text("decay_s", decay, decay < 0.01 ? 1 : 0)].map((textContent) => make("td", { className: "number", textContent }));
      const [share, felt] = [make("td"), make("td")];
      [...numbers, share, felt].forEach((cell, i) => (cell.dataset.label = heads[i + 1]));
      const line = make("tr", {}, make("td", {}, make("label", {}, input, thumbnail(row), row.name)), ...numbers, share, felt);
      table.append(line);
      return { line, input, share, felt };
    });
    this.woken.clear();
    this.rowsBox.replaceChildren(table);
    if (held) /** @type {HTMLElement | null} */ (table.querySelector(":checked"))?.focus();
  }

  /** @param {ModesAnswer} answer */
  say({ bat, modes, chosen, words }) {
    const { app } = this, { frequency_hz: hertz } = modes[chosen], said = words[app.units].join(" ");
    tell(this.words, said);
    this.speed.textContent = hertz ? `slowed down ${Math.round((hertz * PERIOD) / 1000)} times, drawn larger than life` : "drawn larger than life";
    const label = `${bat.name}. ${said}`;
    this.stage.label(label);
    if (label !== this.spoken) app.announce(said);
    this.spoken = label;
  }

  // The chosen motion at even places along the bat.
  /** @param {ModesAnswer} answer */
  tabled({ bat, place_m: places, modes, chosen }) {
    const { units } = this.app, { digits, unit } = kindOf("node_m")[units], { shape, name } = modes[chosen];
    return {
      caption: `${name}: how far each place moves, as a part of the most`, columns: [`${unit} from the tip`, "Moves by"],
      rows: evenly([...places.keys()], 18).map((i) => [toShown("node_m", bat.length_m - places[i], units).toFixed(digits), shape[i].toFixed(2).replace(/^-(0\.00)$/, "$1").replace("-", "−")]),
    };
  }

  unmount() { this.stop?.(); }
  figures() { return [this.stage.figure("mode")]; }
  table() {
    const { modes, place_m: position_m } = this.answer ?? { modes: [], place_m: [] };
    return { position_m, ...Object.fromEntries(modes.map((row) => [`shape_${row.family}_${row.number}_${Math.round(row.frequency_hz)}_hz`, row.shape])) };
  }
}

// Whether a tap wakes a motion so that a number shows it; rigid motions have no share of the vibration.
const worthShowing = (/** @type {BatMotion} */ { tap: { energy_share: share, hand_speed_m_s_per_n_s: felt } }) => share === null || share >= 1e-3 || felt >= 0.05;
const percent = (/** @type {number} */ share) => (share > 0 && share < 1e-4 ? "< 0.01 %" : `${(100 * share).toFixed(share < 0.01 ? 2 : 1)} %`);

/** @param {HTMLElement} cell @param {number} part @param {string} words */
function bar(cell, part, words) {
  if (!cell.firstElementChild) cell.append(make("span", { className: "bar" }), "");
  partOf(cell, ".bar", HTMLElement).style.width = `calc(${Math.min(1, Math.max(0, part)).toFixed(3)} * var(--bar))`;
  /** @type {ChildNode} */ (cell.lastChild).textContent = words;
}

/** @param {{ shape: number[] }} given */
function thumbnail({ shape }) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 84 26");
  svg.setAttribute("aria-hidden", "true");
  const points = shape.filter((_, i) => i % 4 === 0).map((value, i, all) => `${(2 + (80 * i) / (all.length - 1)).toFixed(1)},${(13 - 10 * value).toFixed(1)}`);
  const looks = {
    line: { x1: 2, x2: 82, y1: 13, y2: 13, stroke: "var(--line)", "stroke-dasharray": "3 3" },
    polyline: { points: points.join(" "), fill: "none", stroke: "var(--accent)", "stroke-width": 2 },
  };
  for (const [tag, look] of Object.entries(looks)) {
    const element = document.createElementNS(space, tag);
    for (const [name, value] of Object.entries(look)) element.setAttribute(name, String(value));
    svg.append(element);
  }
  return svg;
}
