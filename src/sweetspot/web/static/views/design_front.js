// The front of a search: bats none of which is better in everything, each a small bat that can be taken.

import { button } from "../controls/controls.js";
import { longWork } from "../shell/longwork.js";
import { make, tableOf, write } from "../controls/parts.js";
import { FONT, Surface, haloText, ticks } from "../charts/surface.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
/** @import { Answer, App, State } from "../shell/main.js" */

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
    this.found = null;
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
  /**
   * @param {string} key
   * @param {number[] | null} numbers
   */
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

  axes() {
    const [x, y = "moi"] = this.found.wants;
    return [x, y];
  }

  /** @param {number} width */
  place(width) {
    const [x, y] = this.axes();
    const { front, present } = this.found;
    const span = (/** @type {string} */ name) => {
      const values = front.map((/** @type {Answer} */ { values: own }) => own[name]);
      if (present[name] !== undefined) values.push(present[name]);
      const [least, most] = [Math.min(...values), Math.max(...values)];
      const room = 0.14 * (most - least) || 0.02 * Math.abs(most) || 1;
      return [least - room, most + room];
    };
    const [[left, right], [low, high]] = [span(x), span(y)];
    return {
      x: [left, right], y: [low, high],
      across: (/** @type {number} */ value) => LEFT + ((value - left) / (right - left)) * (width - LEFT - RIGHT),
      up: (/** @type {number} */ value) => TALL - FOOT - ((value - low) / (high - low)) * (TALL - FOOT - TOP),
    };
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  pick(x, y) {
    if (!this.found) return false;
    const [one, other] = this.axes();
    const { across, up } = this.place(this.surface.width);
    const far = this.found.front.map((/** @type {Answer} */ { values }) => Math.hypot(across(values[one]) - x, 2 * (up(values[other]) - y)));
    const nearest = far.indexOf(Math.min(...far));
    if (far[nearest] > 45) return false;
    this.onTake(this.found.front[nearest].numbers);
    return true;
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {number} width
   */
  paint(context, width) {
    if (!this.found) return;
    const { colors, units } = this.app;
    const [x, y] = this.axes();
    const place = this.place(width);
    Object.assign(context, { font: `11px ${FONT}`, strokeStyle: colors.grid, lineWidth: 1 });
    for (const [name, range, level] of [[x, place.x, false], [y, place.y, true]]) {
      const kind = WANTS[name][0];
      for (const value of ticks(toShown(kind, range[0], units), toShown(kind, range[1], units), level ? 5 : width / 110)) {
        const at = fromShown(kind, value, units);
        context.beginPath();
        context.fillStyle = colors.muted;
        if (level) {
          Object.assign(context, { textAlign: "right", textBaseline: "middle" });
          context.moveTo(LEFT, place.up(at));
          context.lineTo(width - RIGHT, place.up(at));
          context.fillText(String(value), LEFT - 6, place.up(at));
        } else {
          Object.assign(context, { textAlign: "center", textBaseline: "top" });
          context.moveTo(place.across(at), TOP);
          context.lineTo(place.across(at), TALL - FOOT);
          context.fillText(String(value), place.across(at), TALL - FOOT + 4);
        }
        context.stroke();
      }
    }
    Object.assign(context, { textAlign: "right", textBaseline: "alphabetic", fillStyle: colors.muted });
    context.fillText(`${WANTS[x][1]}, ${unitOf(WANTS[x][0], units)} →`, width - RIGHT, TALL - 8);
    Object.assign(context, { textAlign: "left" });
    context.fillText(`↑ ${WANTS[y][1]}, ${unitOf(WANTS[y][0], units)}`, LEFT + 4, TOP + 4);
    this.paintBats(context, place, x, y);
    const { present } = this.found;
    if (present[x] === undefined || present[y] === undefined) return;
    const [px, py] = [place.across(present[x]), place.up(present[y])];
    context.fillStyle = colors.ink;
    context.fillRect(px - 4, py - 4, 8, 8);
    Object.assign(context, { textAlign: px > width / 2 ? "right" : "left", textBaseline: "middle", font: `12px ${FONT}` });
    haloText(context, "present bat", px + (px > width / 2 ? -8 : 8), py, colors.ink, colors.panel);
  }

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Answer} place
   * @param {number} x
   * @param {number} y
   */
  paintBats(context, place, x, y) {
    const { colors } = this.app;
    /** @type {number[][]} */
    const drawn = [];
    const chosen = this.chosen();
    this.found.front.forEach((/** @type {{ values: number[], outline: Answer }} */ { values, outline }, /** @type {number} */ row) => {
      const [px, py] = [place.across(values[x]), place.up(values[y])];
      const hidden = row !== chosen && drawn.some(([a, b]) => Math.abs(a - px) < SMALL * 0.8 && Math.abs(b - py) < 16);
      context.fillStyle = row === chosen ? colors.red : colors.blue;
      if (hidden || !outline) {
        context.beginPath();
        context.arc(px, py, row === chosen ? 6 : 3, 0, 2 * Math.PI);
        context.fill();
        return;
      }
      drawn.push([px, py]);
      const { position_m: along, diameter_m: wide } = outline;
      const scale = SMALL / along.at(-1);
      context.beginPath();
      along.forEach((/** @type {number} */ at, /** @type {number} */ i) => context.lineTo(px - SMALL / 2 + at * scale, py - (wide[i] / 2) * scale * THICK));
      [...along.keys()].reverse().forEach((i) => context.lineTo(px - SMALL / 2 + along[i] * scale, py + (wide[i] / 2) * scale * THICK));
      context.closePath();
      context.fill();
      context.strokeStyle = colors.panel;
      context.stroke();
    });
  }

  // Which bat of the front lies on the bench: none of its numbers is far off.
  chosen() {
    const { numbers: own } = this;
    if (!own) return -1;
    return this.found.front.findIndex((/** @type {{ numbers: number[] }} */ { numbers }) => numbers.every((one, i) => Math.abs(one - own[i]) <= 1e-6 * Math.abs(one) + 1e-12));
  }

  fill() {
    this.table.querySelector(".scroll")?.remove();
    if (!this.table.open || !this.found) return;
    const names = [...new Set([...this.found.wants, "best_from_tip", "mass", "moi"])];
    /** @type {typeof WANTS} */
    const heads = { best_from_tip: ["place", "best place from the tip"], mass: ["mass", "weight"], ...WANTS };
    const chosen = this.chosen();
    const box = tableOf("The front", ["Bat", ...names.map((name) => heads[name][1]), "take it"], this.found.front.map((/** @type {Answer} */ { values }, /** @type {number} */ row) => (
      [`${row + 1}${row === chosen ? " (taken)" : ""}`, ...names.map((name) => this.app.text(heads[name][0], values[name])), ""])));
    box.querySelectorAll("tbody tr").forEach((row, i) => {
      const take = button("Take", () => this.onTake(this.found.front[i].numbers));
      take.setAttribute("aria-label", `Take bat ${i + 1}`);
      row.lastElementChild?.replaceChildren(take);
    });
    this.table.append(box);
  }
}
