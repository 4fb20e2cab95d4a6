// A bat of one's own as the text of its file. The server says what is wrong.

import { batText, checked } from "./batfile.js";
import { unchanged } from "./unchanged.js";
import { button, reveal } from "../controls/controls.js";
import { partOf } from "../controls/parts.js";
import { wordsOf } from "../shell/status.js";
/** @import { State } from "../shell/main.js" */
/** @import { BenchDesk } from "./desk.js" */

export class OwnBat {
  /** @param {BenchDesk} app */
  constructor(app) {
    this.app = app;
    this.element = Object.assign(document.createElement("details"), { className: "own" });
    this.element.innerHTML = "<summary>As text</summary>" +
      "<label for=\"bat-text\">Bat file (TOML)</label><textarea id=\"bat-text\" rows=\"12\" wrap=\"off\" spellcheck=\"false\" aria-describedby=\"bat-fault\"></textarea>" +
      "<p class=\"fault\" id=\"bat-fault\" role=\"alert\" hidden></p><div class=\"row\"></div>";
    this.text = partOf(this.element, "textarea", HTMLTextAreaElement);
    this.words = partOf(this.element, ".fault", HTMLElement);
    partOf(this.element, ".row", HTMLElement).append(
      button("Use this text", () => this.take(this.text.value), { primary: true }),
      button("Show the present bat", () => this.show()),
    );
    this.element.addEventListener("toggle", () => this.element.open && !this.text.value && this.show());
    app.control({ field: "bat_toml", sync: (state) => this.sync(state), fault: (message) => this.fault(message) });
  }

  /** @param {string} message */
  fault(message) {
    this.words.textContent = message;
    this.words.hidden = message === "";
    this.text.toggleAttribute("aria-invalid", message !== "");
    if (message) reveal(this.element);
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
      this.text.value = await batText(this.app.app);
    } catch (fault) {
      this.fault(wordsOf(fault, this.app.units));
    }
  }

  /** @param {State} state */
  sync({ bat_toml: text }) {
    if (text && document.activeElement !== this.text && !this.text.value) this.text.value = text;
  }
}
