// Explorer: the bat to scale with its sweet spots; below it, on the same axis, what a hit at each place gives.

import { choice, group, slider } from "../controls.js";

export const view = {
  name: "explorer",

  mount(root, app) {
    this.app = app;
    const side = Object.assign(document.createElement("div"), { className: "side" });
    side.append(
      group("Bat", [choice(app, "bat", { label: "Bat", options: app.lists().then(({ bats }) => bats.map((bat) => [bat.key, bat.name])) })]),
      group("Swing", [slider(app, "pitch_speed_mph", { label: "Pitch speed", step: 0.5 })]),
    );
    this.picture = Object.assign(document.createElement("div"), { className: "picture" });
    root.append(side, this.picture);
  },

  update(answer) {
    this.picture.textContent = this.app.text("exit_speed_m_s", answer.hit.exit_speed_m_s);
  },

  unmount() {},
};
