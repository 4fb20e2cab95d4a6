// Lights: a list of what is kept, missed, or cannot be told, each with a sign and words, never by colour alone.
//
//   const list = new Lights("What must stay");
//   box.append(list.element);
//   list.show([{ state: "pass", name: "weight", words: "31.0 oz" }]);     // pass, fail, unsure, doubt or none

import { make, partOf } from "./parts.js";
/** @import { RuleCheck } from "../answers.js" */
/** @import { App } from "../shell/main.js" */

const SIGNS = { pass: ["✓", "kept"], fail: ["✗", "not kept"], unsure: ["?", "not sure"], doubt: ["?", "not decidable"], none: ["–", "does not apply"] };

/** @typedef {keyof typeof SIGNS} Light */

export class Lights {
  /** @param {string} title */
  constructor(title) {
    this.list = make("ul", {});
    this.shown = "";
    this.element = make("div", { className: "lights", hidden: true }, make("h2", { textContent: title }), this.list);
  }

  /** @param {string} title */
  head(title) { partOf(this.element, "h2", HTMLElement).textContent = title; }

  /** @param {{ state: Light, name: string, words?: string }[]} lights */
  show(lights) {
    const now = JSON.stringify(lights);
    if (now === this.shown) return;
    this.shown = now;
    this.element.hidden = lights.length === 0;
    this.list.replaceChildren(...lights.map(({ state, name, words = "" }) => {
      const [sign, said] = SIGNS[state];
      return make("li", { className: state }, make("span", { className: "sign", textContent: sign, ariaHidden: "true" }),
        make("span", {}, make("strong", { textContent: name }), make("span", { className: "unseen", textContent: `, ${said}` }), words ? ` ${words}` : ""));
    }));
  }
}

/** @type {Record<string, Light>} */
const LIGHTS = { pass: "pass", fail: "fail", "not decidable": "doubt" };

/** Whether a rule is decided though what is not known of the value reaches across its limit. */
export const isUnsure = (/** @type {Pick<RuleCheck, "verdict" | "sure">} */ { verdict, sure }) => (verdict === "pass" || verdict === "fail") && !sure;

/** The light of a rule that was held against a bat. */
export const stateOf = (/** @type {Pick<RuleCheck, "verdict" | "sure">} */ check) => (isUnsure(check) ? "unsure" : LIGHTS[check.verdict] ?? "none");

/** @type {Record<string, string>} */
const KINDS = { m: "length", "kg m^2": "moi" };

// A value, and what it may be.
/**
 * @param {{ value: number, least: number | null, most: number | null }} one
 * @param {(value: number) => string} show
 */
export function beside({ value, least, most }, show) {
  if (least !== null && most !== null) return `${show(value)}, allowed ${show(least)} to ${show(most)}`;
  return [show(value), least === null ? "" : `at least ${show(least)}`, most === null ? "" : `at most ${show(most)}`].filter(Boolean).join(", ");
}

/**
 * A league's rules, each with what the bat has and the limit.
 * @param {Lights} lights
 * @param {RuleCheck[]} rules
 * @param {App} app
 */
export function showRules(lights, rules, app) {
  lights.head(rules.length ? `Rules of ${rules[0].league_name}` : "Rules");
  lights.show(rules.map((rule) => {
    const show = (/** @type {number} */ one) => app.text(KINDS[rule.unit] ?? "ratio", one);
    const known = typeof rule.value === "number" && rule.unit !== "yes or no" ? beside({ ...rule, value: rule.value }, show) : "";
    return { state: stateOf(rule), name: rule.title, words: [known, rule.reason].filter(Boolean).join("; ") };
  }));
}
