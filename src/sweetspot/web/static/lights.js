// Lights: a list of what is kept, missed, or cannot be told, each with a sign and words, never by colour alone.
//
//   const list = new Lights("What must stay");
//   box.append(list.element);
//   list.show([{ state: "pass", name: "weight", words: "31.0 oz" }]);     // pass, fail, doubt or none

import { make } from "./parts.js";

const SIGNS = { pass: ["✓", "kept"], fail: ["✗", "not kept"], doubt: ["?", "not decidable"], none: ["–", "does not apply"] };

export class Lights {
  constructor(title) {
    this.list = make("ul", {});
    this.element = make("div", { className: "lights", hidden: true }, make("h2", { textContent: title }), this.list);
  }

  show(lights) {
    this.element.hidden = lights.length === 0;
    this.list.replaceChildren(...lights.map(({ state, name, words = "" }) => {
      const [sign, said] = SIGNS[state];
      return make("li", { className: state }, make("span", { className: "sign", textContent: sign, ariaHidden: "true" }),
        make("span", {}, make("strong", { textContent: name }), make("span", { className: "unseen", textContent: `, ${said}` }), words ? ` ${words}` : ""));
    }));
  }
}

export const stateOf = (verdict) => ({ pass: "pass", fail: "fail", "not decidable": "doubt" }[verdict] ?? "none");
