// How a bat is swung and what comes at it: groups of controls that many views have.

import { textOf } from "./batfile.js";
import { button, choice, group, reveal, slider } from "../controls/controls.js";
import { partOf } from "../controls/parts.js";
import { wordsOf } from "../shell/status.js";
import { INCH } from "../controls/units.js";
/** @import { BallPicture, UsualHit } from "../answers.js" */
/** @import { App, Field } from "../shell/main.js" */
/** @import { Desk, Options, Words } from "../controls/controls.js" */

const OWN = "own file";

// What a control stands at that nobody has moved: as is usual in the sport of the last answer's bat.
/** @param {Desk} app */
export const usual = (app, /** @type {keyof UsualHit} */ field) => () => app.answer?.bat?.usual?.[field] ?? null;

// A choice that follows the bat's sport until somebody chooses.
/** @param {Desk} app */
export function usualChoice(app, /** @type {keyof UsualHit & Field} */ field, /** @type {{ label: Words, options: Options | Promise<Options>, note?: string }} */ look) {
  return choice(app, field, { ...look, follows: true, shown: (state) => state[field] ?? usual(app, field)() });
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
