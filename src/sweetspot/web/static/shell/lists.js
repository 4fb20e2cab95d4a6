// The catalogue's lists, each fetched when first wanted and by itself: none waits for another.

import { asked } from "./post.js";

/** @import { Catalogue } from "../answers.js" */

export class Lists {
  /**
   * @param {(what: string, yes?: boolean) => void} waits
   * @param {() => void} lacks  called when a list cannot be had
   */
  constructor(waits, lacks) {
    this.waits = waits;
    this.lacks = lacks;
    /** @type {Map<keyof Catalogue, Promise<Catalogue[keyof Catalogue]>>} */
    this.known = new Map();
  }

  /** @template {keyof Catalogue} Name @param {Name[]} names @returns {Promise<Pick<Catalogue, Name>>} */
  async named(names) {
    const found = await Promise.all(names.map(async (name) => [name, await (this.known.get(name) ?? this.fetched(name))]));
    return Object.fromEntries(found);
  }

  /** @param {keyof Catalogue} name */
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
