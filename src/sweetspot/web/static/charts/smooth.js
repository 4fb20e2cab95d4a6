// A map of values between those that are known: bilinear, and blank where more than half of what is around is unknown.

import { mixed } from "./heat.js";
/** @import { Values } from "./chart.js" */

const FINEST = 260, SHADES = 256; // pixels of the picture across at most
const EVEN = 0.05; // of a step, by which steps may differ

/** @param {number[]} values */
const isEven = (values) => values.every((value, i) => i < 2 || Math.abs(value - values[i - 1] - (values[1] - values[0])) < EVEN * Math.abs(values[1] - values[0]));

// Whether a grid can be drawn so: of more than one row and column, each as far from the next.
/** @param {number[]} x @param {number[]} y */
export const isGrid = (x, y) => x.length > 1 && y.length > 1 && isEven(x) && isEven(y);

// The picture of a grid from half a step before its first value to half a step behind its last, its first row lowest.
/** @param {Values[]} z @param {number} least @param {number} most */
export function smoothed(z, least, most) {
  const rows = z.length, columns = z[0].length;
  const fine = Math.max(1, Math.min(8, Math.floor(FINEST / columns)));
  const picture = new ImageData(columns * fine, rows * fine);
  const shades = Array.from({ length: SHADES }, (_, i) => mixed(i / (SHADES - 1)));
  const scale = (SHADES - 1) / (most - least || 1);
  for (let row = 0; row < rows * fine; row += 1) {
    const [below, above, up] = between(rows * fine - 1 - row, fine, rows);
    for (let column = 0; column < columns * fine; column += 1) {
      const [left, right, along] = between(column, fine, columns);
      let sum = 0, weight = 0;
      for (const [value, part] of /** @type {[number | null, number][]} */ ([[z[below][left], (1 - up) * (1 - along)], [z[below][right], (1 - up) * along],
        [z[above][left], up * (1 - along)], [z[above][right], up * along]])) {
        if (value === null) continue;
        sum += part * value;
        weight += part;
      }
      if (weight < 0.5) continue;
      const [red, green, blue] = shades[Math.min(SHADES - 1, Math.max(0, Math.round((sum / weight - least) * scale)))];
      picture.data.set([red, green, blue, 255], 4 * (row * columns * fine + column));
    }
  }
  return picture;
}

// Between which two values a pixel lies, and how far on.
/** @param {number} pixel @param {number} fine @param {number} count @returns {[number, number, number]} */
function between(pixel, fine, count) {
  const place = Math.min(count - 1, Math.max(0, (pixel + 0.5) / fine - 0.5));
  const before = Math.min(count - 2, Math.floor(place));
  return [before, before + 1, place - before];
}
