// The bat's part of the explorer: choose it, bring your own, or change it as a workshop would.

import { button, choice, group, slider } from "../controls.js";

const INCH = 0.0254;

export function benchOf(app, picture) {
  void picture;
  const element = group("Bat", [
    choice(app, "bat", { label: "Bat", options: app.lists().then(({ bats }) => bats.map((bat) => [bat.key, bat.name])) }),
    button("Reset", () => app.setState({ ...app.defaults, bat: app.state.bat })),
  ]);
  return {
    element,
    reshape(stations, last) {
      app.setState({ profile_in: stations.map((s) => [s.position_m / INCH, s.diameter_m / INCH]) }, { commit: last });
    },
    update() {},
  };
}
void slider;
