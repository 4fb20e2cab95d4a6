// The catalogue's lists, each fetched when first wanted and by itself: none waits for another.

import { asked } from "./post.js";

const ALL = ["bats", "balls", "materials", "leagues", "parks", "implements", "pitches"];

export class Lists {
  /**
   * @param {(what: string, yes?: boolean) => void} waits
   * @param {() => void} lacks  called when a list cannot be had
   */
  constructor(waits, lacks) {
    this.waits = waits;
    this.lacks = lacks;
    /** @type {Map<string, Promise<any[]>>} */
    this.known = new Map();
  }

  /**
   * @param {string[]} names  all of them where none is named
   * @returns {Promise<Record<string, any[]>>}
   */
  async named(names) {
    const wanted = names.length ? names : ALL;
    const found = await Promise.all(wanted.map((name) => this.known.get(name) ?? this.fetched(name)));
    return Object.fromEntries(wanted.map((name, i) => [name, found[i]]));
  }

  /** @param {string} name */
  fetched(name) {
    const what = `list of ${name}`;
    this.waits(what);
    const list = asked(`/api/v1/${name}`).then((response) => response.json())
      .catch((error) => {
        this.known.delete(name); // so that the next who asks tries again
        this.lacks();
        throw error;
      })
      .finally(() => setTimeout(() => this.waits(what, false))); // once those who waited for it have drawn it
    this.known.set(name, list);
    return list;
  }
}
