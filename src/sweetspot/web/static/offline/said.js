// Sentences of the package, written into the file with slots: here numbers are put into them, in the reader's units.

/** @import { System } from "../controls/units.js" */
/** @typedef {{ slot: string, scale: string, digits: number | null, sign: boolean, unit: boolean, round: boolean }} Slot */
/** @typedef {(string | Slot)[]} Said */
/** @typedef {{ when: string, unless: string, words: Said }} Line */
/** @typedef {Record<System, Record<string, { name: string, size: number, digits: number, zero: number }>>} Units */
/** @typedef {Record<string, number | string | boolean | null>} Values */

const NOTHING = "–";

export class Speaker {
  /** @param {Units} units */
  constructor(units) {
    this.all = units;
    /** @type {System} */
    this.system = "us";
  }

  get units() { return this.all[this.system]; }

  // A number in SI as `Slot.read` writes it.
  /** @param {number | null} value @param {Omit<Slot, "slot">} look */
  number(value, { scale, digits, sign, unit, round }) {
    const own = this.units[scale];
    if (value === null || !Number.isFinite(value)) return NOTHING;
    const number = written((value - own.zero) / own.size, digits ?? own.digits, sign);
    return (round && number.includes(".") ? number.replace(/\.?0+$/, "") : number) + (unit ? this.behind(scale) : "");
  }

  /** @param {string} scale */
  behind(scale) {
    const { name } = this.units[scale];
    return name === "" || name === "°" ? name : ` ${name}`;
  }

  // A number with half of its 90 % interval, with as many digits of both.
  /** @param {number | null} value @param {number | null} half @param {string} scale */
  withHalf(value, half, scale) {
    const { size, digits } = this.units[scale], look = { scale, digits, sign: false, round: false };
    if (half === null || value === null || !Number.isFinite(value)) return this.number(value, { ...look, unit: true });
    return `${this.number(value, { ...look, unit: false })} ± ${written(half / size, digits, false)}${this.behind(scale)}`;
  }

  /** @param {Said} said @param {Values} values */
  fill(said, values) {
    return said.map((part) => {
      if (typeof part === "string") return part;
      const value = values[part.slot];
      return typeof value === "string" ? value : this.number(/** @type {number | null} */ (value), part);
    }).join("");
  }

  // The words of the lines whose facts hold: `sentences.tell`.
  /** @param {Line[]} lines @param {Values} values */
  tell(lines, values) {
    return lines.filter(({ when, unless }) => (!when || values[when]) && !(unless && values[unless])).map(({ words }) => this.fill(words, values)).join("");
  }
}

// A number with so many decimals, halves to the even digit, as Python writes it; commas from 10,000 on, never minus zero.
/** @param {number} value @param {number} digits @param {boolean} sign */
export function written(value, digits, sign) {
  const scaled = Math.abs(value) * 10 ** digits;
  const half = digits === 0 && scaled % 1 === 0.5 && Math.floor(scaled) % 2 === 0; // toFixed goes up, Python to the even one
  const number = half ? String(Math.floor(scaled)) : Math.abs(value).toFixed(digits);
  const none = Number(number) === 0, [whole, rest] = number.split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, ",") : whole;
  return `${value < 0 && !none ? "−" : sign ? "+" : ""}${grouped}${rest ? `.${rest}` : ""}`;
}
