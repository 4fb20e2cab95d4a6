// The numbers of a picture as a table under a heading that folds, for those who do not see the picture.
//
//   const numbers = new Numbers("These curves as a table", () => ({ caption, columns, rows }));   or null: nothing yet
//   box.append(numbers.element);
//   numbers.redraw();        // after every change of the picture

import { make, tableOf } from "./parts.js";

export class Numbers {
  constructor(words, tabled) {
    this.tabled = tabled;
    this.element = make("details", { className: "numbers" }, make("summary", { textContent: words }));
    this.element.addEventListener("toggle", () => this.redraw());
  }

  redraw() {
    this.element.querySelector(".scroll")?.remove();
    const found = this.element.open ? this.tabled() : null;
    if (found) this.element.append(tableOf(found.caption, found.columns, found.rows));
  }
}

// About so many of a list, evenly, with the first and the last.
export function evenly(list, count) {
  if (list.length <= count) return list;
  return Array.from({ length: count }, (_, i) => list[Math.round((i * (list.length - 1)) / (count - 1))]);
}
