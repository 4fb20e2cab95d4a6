// Start: one bat, one ball to drag, what a hit there gives in one sentence, its sound, and the ways on.

import { slideByKeys, tellPlace, within } from "../bat/ballslider.js";
import { BatView } from "../bat/batview.js";
import { describeOwn } from "../bat/bench.js";
import { usual } from "../bat/swing.js";
import { button, slider } from "../controls/controls.js";
import { make, paragraphs, write } from "../controls/parts.js";
import { strike } from "../controls/tapsound.js";
import { INCH } from "../controls/units.js";
import { follow } from "../shell/viewbar.js";
/** @import { Door, StartAnswer } from "../answers.js" */
/** @import { AppOf, Guide } from "../shell/main.js" */

const SLOWEST = 0.55; // of the greatest exit speed, where the colours begin

export default class StartView {
  /** @type {Guide} */
  static guide = [
    ["Drag the ball", "Drag it along the bat; the sentence below says how fast the ball leaves there and what a miss costs. With the keyboard: arrow keys on the picture."],
    ["Your bat", "Choose another bat, describe yours by a few numbers, or drop a file on the page. "],
    ["Go on", "Each door leads on with your bat and your swing. "],
  ];

  /** @param {HTMLElement} root @param {AppOf<"start">} app */
  constructor(root, app) {
    this.app = app;
    /** @type {StartAnswer | null} */
    this.answer = null;
    this.title = make("h1");
    this.lead = make("p", { className: "lead" });
    this.words = make("div", { id: "verdict", className: "spoken" });
    this.picture = new BatView(app, { onBall: (position, { last }) => this.moveBall(position, last) });
    slideByKeys(app, this.picture, () => app.answer);
    this.doors = make("nav", { className: "doors", ariaLabel: "Ways on" });
    this.doors.addEventListener("click", (event) => follow(event, app));
    root.append(make("section", { className: "picture wide start" }, this.title, this.lead, this.picture.element, this.words,
      make("div", { className: "swing" },
        make("div", { className: "row" },
          button("\u266a\u00a0Hear this hit", () => strike(this.answer?.tones ?? []), { primary: true }),
          button("Describe your bat\u00a0…", () => describeOwn(app))),
        slider(app, "pitch_speed_mph", { label: "Pitch speed", step: 0.5, empty: usual(app, "pitch_speed_mph") }),
        slider(app, "bat_speed_mph", { label: "Bat speed", step: 0.5, empty: usual(app, "bat_speed_mph") }))),
    this.doors);
  }

  /** @param {number} position @param {boolean} last */
  moveBall(position, last) {
    const { answer } = this.app;
    if (answer) this.app.setState({ impact_from_tip_in: within(answer, (answer.bat.length_m - position) / INCH) }, { commit: last });
  }

  /** @param {StartAnswer} answer */
  update(answer) {
    this.answer = answer;
    const { front, bat, ball, best_m: best, hands_m: hands, scan, position_m: at, place, sentence } = answer, { units } = this.app;
    write(this.title, front.title);
    write(this.lead, front.lead);
    this.open(front.doors);
    const speeds = scan.exit_speed_m_s, most = Math.max(...speeds.filter((value) => value !== null));
    this.picture.draw({ bat, hands_m: hands, sweet_spots: { max_exit_speed_m: best }, warm: { position_m: scan.position_m, values: speeds, least: SLOWEST * most, most },
      ball: { position_m: at, radius_m: ball.radius_m } });
    paragraphs(this.words, sentence[units]);
    const words = sentence[units].join(" ");
    this.app.announce(words);
    this.picture.label(`Ball along the bat. ${words}`);
    tellPlace(this.picture, answer, at, place[units]);
  }

  // The ways on, which lead there with the bat and the hit as they are.
  /** @param {Door[]} doors */
  open(doors) {
    if (!this.doors.childElementCount) this.doors.append(...doors.map(({ title, words }) => make("a", {}, make("strong", { textContent: title }), make("span", { textContent: words }))));
    [...this.doors.querySelectorAll("a")].forEach((door, i) => { door.href = this.app.addressFor(doors[i].view); });
  }

  figures() { return [this.picture.figure("bat")]; }
  table() { return { ...this.answer?.scan }; }
}
