// Units by the ending of a name, in both systems: what is shown is value * scale + offset. The table is the package's
// own (report/quantities.py), which the server hands out as a module.

import table from "../quantities.js";

const { scales, endings } = table;
export const [INCH, OUNCE, MPH] = ["length", "mass", "speed"].map((scale) => 1 / scales[scale].us.scale);
// What a view calls a scale where the ending of a name would mean another: long distances and times of flights end in _m and _s too.
/** @type {Record<string, string>} */
const NAMED = { seconds: "time", sting: "vibration" };
const ENDINGS = Object.entries(endings).sort(([one], [other]) => other.length - one.length);

// Units of two words, which no line breaks: "oz in²", "N s".
export const TWO_WORDS = [...new Set(Object.values(scales).flatMap(({ us, si }) => [us.unit, si.unit]).filter((unit) => unit.includes(" ")))];

/** @typedef {"us" | "si"} System */

// How a name like pitch_speed_mph, or a scale of the table like distance, is shown.
/** @param {string} name */
export function kindOf(name) {
  const scale = scales[NAMED[name] ?? name];
  if (scale) return scale;
  const ending = ENDINGS.find(([end]) => name.endsWith(end));
  return ending ? ending[1] : scales.ratio;
}

/** @param {string} name @param {System} system */
export function unitOf(name, system) {
  return kindOf(name)[system].unit;
}

// A stored value as the number that is shown, and back.
/** @param {string} name @param {number} value @param {System} system */
export function toShown(name, value, system) {
  const { scale, offset = 0 } = kindOf(name)[system];
  return value * scale + offset;
}

/** @param {string} name @param {number} shown @param {System} system */
export function fromShown(name, shown, system) {
  const { scale, offset = 0 } = kindOf(name)[system];
  return (shown - offset) / scale;
}

// A written number with a comma at every third digit, where it has five or more before the point: "10,297", "3199".
/** @param {string | number} number */
export function grouped(number) {
  return String(number).replace(/^\D?\d{5,}(?=\.|$)/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, ","));
}

// "93.1 mph"; a dash where there is no number.
/**
 * @param {string} name
 * @param {number | null | undefined} value
 * @param {System} system
 * @param {number} [digits]
 */
export function text(name, value, system, digits = kindOf(name)[system].digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const { unit } = kindOf(name)[system];
  const shown = grouped(toShown(name, value, system).toFixed(digits)).replace(/^-(0(\.0*)?)$/, "$1").replace("-", "−");
  return unit === "" ? shown : `${shown}${unit.startsWith("°") ? "" : " "}${unit}`;
}
