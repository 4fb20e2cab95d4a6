// Colours for how much: from dark violet over green to yellow, which are told apart without red and green and in grey.

const STOPS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]]; // viridis

// Red, green and blue of a part between 0 and 1.
/** @param {number} part */
export function mixed(part) {
  const place = Math.min(1, Math.max(0, part)) * (STOPS.length - 1);
  const i = Math.min(STOPS.length - 2, Math.floor(place));
  return STOPS[i].map((value, k) => Math.round(value + (place - i) * (STOPS[i + 1][k] - value)));
}

// The colour of a part between 0 and 1.
/** @param {number} part */
export const heat = (part) => `rgb(${mixed(part).join(", ")})`;
