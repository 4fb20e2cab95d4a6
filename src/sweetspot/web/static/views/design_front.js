// The front of a search: bats none of which is better in everything, each a small bat that can be taken.

import { button } from "../controls/controls.js";
import { longWork } from "../shell/longwork.js";
import { make, tableOf, write } from "../controls/parts.js";
import { dot, line, shape } from "../charts/pen.js";
import { FONT, Surface, haloText, ticks } from "../charts/surface.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { FrontProgress, FrontBat } from "../answers.js" */
/** @import { Point } from "../charts/pen.js" */
/** @import { App, State } from "../shell/main.js" */

const LEFT = 56, RIGHT = 18, TOP = 14, FOOT = 40, TALL = 300, SMALL = 64, THICK = 2.2;
/** @type {Record<string, [string, string]>} */
export const WANTS = {
  exit_speed: ["speed", "exit speed over the contacts"], zone: ["place", "width of the zone"], best: ["speed", "greatest exit speed"],
  sting: ["vibration", "sting"], swing_time: ["contact", "time to contact"], durability: ["ratio", "durability"], moi: ["moi", "swing weight"],
};

export class Front {
  /** @param {App} app */
  constructor(app, /** @type {{ onTake: (numbers: number[]) => void, state: () => State }} */ { onTake, state }) {
    this.app = app;
    this.onTake = onTake;
    /** @type {FrontProgress | null} */
    this.found = null;
    /** @type {string | undefined} */
    this.key = undefined;
    /** @type {number[] | null} */
    this.numbers = null;
    this.work = longWork("design/search");
    this.words = make("p", { className: "note" });
    this.words.setAttribute("role", "status");
    this.fault = make("p", { className: "fault", hidden: true });
    this.bar = make("progress", { max: 1, value: 0, ariaLabel: "Generations looked at" });
    this.begin = button("Find better", () => this.work.start(state()), { primary: true });
    this.halt = button("Stop", () => this.work.stop());
    this.on = button("Go on", () => this.work.goOn());
    this.surface = new Surface(app, { height: () => TALL, paint: (context, width) => this.paint(context, width), label: "The front" });
    this.surface.drags(({ x, y, first }) => first && this.pick(x, y));
    this.surface.element.style.cursor = "pointer";
    this.table = make("details", { className: "numbers" }, make("summary", { textContent: "These bats as a table, to take one" }));
    this.table.addEventListener("toggle", () => this.fill());
    this.shown = make("div", { hidden: true }, this.surface.element, this.table);
    this.element = make("div", {}, make("div", { className: "row" }, this.begin, this.halt, this.on, this.bar), this.words, this.fault, this.shown);
    this.work.watch(app.signal, () => this.update());
  }

  // key: of the bat on the bench; a front of another bat is no longer shown.
  /** @param {string} key @param {number[] | null} numbers */
  draw(key, numbers) {
    this.key = key;
    this.numbers = numbers;
    this.update();
  }

  update() {
    const { status, fault } = this.work;
    const { found } = this.work;
    const mine = found && (this.key === undefined || found.key === this.key);
    this.found = mine && found.front.length ? found : null;
    const runs = status === "running" || status === "starting";
    this.begin.disabled = runs;
    this.halt.disabled = status !== "running";
    this.on.disabled = !(mine && this.work.key && !runs);
    this.bar.hidden = !runs;
    this.bar.value = found ? found.generation / found.generations : 0;
    this.fault.hidden = !fault;
    write(this.fault, fault?.message ?? "");
    const bats = this.found?.front.length;
    const count = bats ? `${bats} bat${bats === 1 ? "" : "s"} on the front, none better in everything` : "";
    const kept = count || "no bat keeps every limit yet";
    const first = count ? `: ${count}.` : "; this takes some seconds …";
    const far = found ? `${found.generation} of ${found.generations} generations` : "";
    /** @type {Record<string, string>} */
    const told = {
      none: "The search runs on this server, beside the page; it can be stopped and gone on with.",
      starting: "The search begins …", failed: "",
      running: found?.generation ? `Looking: ${far}; ${kept}.` : `Looking for first bats that keep every limit${first}`,
      stopped: found ? `Stopped after ${far}; ${kept}. Go on, or begin anew.` : "Stopped before the first bats were found. Press Find better to begin anew.",
      done: `Looked at ${far}; ${kept}.${count ? " Click one to take it." : ""}`,
    };
    write(this.words, found && !mine ? "The front was another bat's; look again for this one." : told[status]);
    this.shown.hidden = !this.found;
    if (!this.found) return;
    this.surface.label(`The front: ${count}. ${this.words.textContent} The table below takes them by keyboard.`);
    this.surface.draw();
    if (this.table.open) this.fill();
  }

  // How the plane of the two wants lies on the picture: names, ranges, and from a value to a pixel.
  /** @param {FrontProgress} found @param {number} width */
  plane({ wants: [x, y = "moi"], front, present }, width) {
    const span = (/** @type {string} */ name) => {
      const values = front.map((bat) => bat.values[name]);
      if (present[name] !== undefined) values.push(present[name]);
      const [least, most] = [Math.min(...values), Math.max(...values)];
      const room = 0.14 * (most - least) || 0.02 * Math.abs(most) || 1;
      return [least - room, most + room];
    };
    const [[left, right], [low, high]] = [span(x), span(y)];
    const across = (/** @type {number} */ value) => LEFT + ((value - left) / (right - left)) * (width - LEFT - RIGHT);
    const up = (/** @type {number} */ value) => TALL - FOOT - ((value - low) / (high - low)) * (TALL - FOOT - TOP);
    const place = (/** @type {Record<string, number>} */ values) => /** @type {Point} */ ([across(values[x]), up(values[y])]);
    return { x, y, ranges: { [x]: [left, right], [y]: [low, high] }, across, up, place };
  }

  /** @param {number} x @param {number} y */
  pick(x, y) {
    if (!this.found) return false;
    const { place } = this.plane(this.found, this.surface.width);
    const far = this.found.front.map(({ values }) => Math.hypot(place(values)[0] - x, 2 * (place(values)[1] - y)));
    const nearest = far.indexOf(Math.min(...far));
    if (far[nearest] > 45) return false;
    this.onTake(this.found.front[nearest].numbers);
    return true;
  }

  /** @param {CanvasRenderingContext2D} context @param {number} width */
  paint(context, width) {
    if (!this.found) return;
    const { colors, units } = this.app;
    const { x, y, ranges, across, up, place } = this.plane(this.found, width);
    Object.assign(context, { font: `11px ${FONT}`, fillStyle: colors.muted });
    const marks = (/** @type {string} */ name, /** @type {number} */ count) => {
      const [[kind], [least, most]] = [WANTS[name], ranges[name]];
      return ticks(toShown(kind, least, units), toShown(kind, most, units), count).map((value) => /** @type {[string, number]} */ ([String(value), fromShown(kind, value, units)]));
    };
    Object.assign(context, { textAlign: "right", textBaseline: "middle" });
    for (const [words, value] of marks(y, 5)) {
      line(context, [[LEFT, up(value)], [width - RIGHT, up(value)]], colors.grid);
      context.fillText(words, LEFT - 6, up(value));
    }
    Object.assign(context, { textAlign: "center", textBaseline: "top" });
    for (const [words, value] of marks(x, width / 110)) {
      line(context, [[across(value), TOP], [across(value), TALL - FOOT]], colors.grid);
      context.fillText(words, across(value), TALL - FOOT + 4);
    }
    Object.assign(context, { textAlign: "right", textBaseline: "alphabetic" });
    context.fillText(`${WANTS[x][1]}, ${unitOf(WANTS[x][0], units)} →`, width - RIGHT, TALL - 8);
    context.textAlign = "left";
    context.fillText(`↑ ${WANTS[y][1]}, ${unitOf(WANTS[y][0], units)}`, LEFT + 4, TOP + 4);
    this.paintBats(context, this.found.front, place);
    const { present } = this.found;
    if (present[x] === undefined || present[y] === undefined) return;
    const [px, py] = place(present);
    const side = px > width / 2 ? -8 : 8;
    context.fillStyle = colors.ink;
    context.fillRect(px - 4, py - 4, 8, 8);
    Object.assign(context, { textAlign: side < 0 ? "right" : "left", textBaseline: "middle", font: `12px ${FONT}` });
    haloText(context, "present bat", px + side, py, colors.ink, colors.panel);
  }

  /** @param {CanvasRenderingContext2D} context @param {FrontBat[]} front @param {(values: Record<string, number>) => Point} place */
  paintBats(context, front, place) {
    const { colors } = this.app;
    /** @type {Point[]} */
    const drawn = [];
    const chosen = this.chosen();
    front.forEach(({ values, outline }, row) => {
      const [px, py] = place(values);
      const hidden = row !== chosen && drawn.some(([a, b]) => Math.abs(a - px) < SMALL * 0.8 && Math.abs(b - py) < 16);
      const fill = row === chosen ? colors.red : colors.blue;
      if (hidden || !outline) {
        dot(context, [px, py], row === chosen ? 6 : 3, { fill });
        return;
      }
      drawn.push([px, py]);
      const { position_m: along, diameter_m: wide } = outline, scale = SMALL / along[along.length - 1];
      const edge = (/** @type {number} */ side) => along.map((place, i) => [px - SMALL / 2 + place * scale, py + (side * wide[i] / 2) * scale * THICK]);
      shape(context, [...edge(-1), ...edge(1).reverse()], { fill, edge: colors.panel, width: 1 });
    });
  }

  // Which bat of the front lies on the bench: none of its numbers is far off.
  chosen() {
    const present = this.numbers;
    if (!present || !this.found) return -1;
    return this.found.front.findIndex(({ numbers }) => numbers.every((number, i) => Math.abs(number - present[i]) <= 1e-6 * Math.abs(number) + 1e-12));
  }

  fill() {
    this.table.querySelector(".scroll")?.remove();
    if (!this.table.open || !this.found) return;
    const { wants, front } = this.found;
    const names = [...new Set([...wants, "best_from_tip", "mass", "moi"])];
    /** @type {typeof WANTS} */
    const heads = { best_from_tip: ["place", "best place from the tip"], mass: ["mass", "weight"], ...WANTS };
    const chosen = this.chosen();
    const box = tableOf("The front", ["Bat", ...names.map((name) => heads[name][1]), "take it"], front.map(({ values }, row) => (
      [`${row + 1}${row === chosen ? " (taken)" : ""}`, ...names.map((name) => this.app.text(heads[name][0], values[name])), ""])));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      const take = button("Take", () => this.onTake(front[i].numbers));
      take.setAttribute("aria-label", `Take bat ${i + 1}`);
      row.lastElementChild?.replaceChildren(take);
    });
    this.table.append(box);
  }
}
