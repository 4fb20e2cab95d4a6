// What is asked or drawn later, once the hand that drags rests: asides of a view's answer, and what follows its picture.

/** @import { App, AsideAnswer, AsideName } from "./main.js" */

const REST = 120; // ms without a change after which a dragging hand rests

/** @typedef {{ about: string, timer: number }} Asked */
/** @typedef {{ name: string, timer: number }} Drawn */

export class Later {
  dragged = false; // whether the state has changed since its last step
  moved = 0; // when the state last changed, ms

  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** @type {Map<string, Asked>} */
    this.asides = new Map();
    /** @type {Map<object, Drawn>} */
    this.parts = new Map(); // by who draws them
    this.count = 0; // of parts that ever waited
  }

  // Whether no hand is dragging, or one that does has stayed where it is for a moment.
  get rests() {
    return !this.dragged || performance.now() - this.moved > REST;
  }

  // Nothing is wanted any more: the view goes.
  clear() {
    for (const [name, { timer }] of this.asides) {
      clearTimeout(timer);
      this.app.waits(name, false);
    }
    for (const { name, timer } of this.parts.values()) {
      clearTimeout(timer);
      this.app.waits(name, false);
    }
    this.asides.clear();
    this.parts.clear();
  }

  // Ask apart for what takes longer, once the state has rested for a while (ms); asked again only when something changes
  // besides the fields in `but`. onAnswer hears what is still about the present state.
  /**
   * @template {AsideName} Aside
   * @param {Aside} name
   * @param {string[]} but
   * @param {number} wait
   * @param {(answer: AsideAnswer<Aside>) => void} onAnswer
   */
  aside(name, but, wait, onAnswer) {
    const about = JSON.stringify(Object.entries(this.app.state).filter(([field]) => !but.includes(field)));
    const last = this.asides.get(name);
    if (last?.about === about) return;
    clearTimeout(last?.timer);
    this.app.waits(name);
    const asked = { about, timer: 0 };
    const ask = async () => {
      let found = null;
      let again = false;
      try {
        found = /** @type {AsideAnswer<Aside>} */ (/** @type {unknown} */ (await this.app.ask(`${this.app.name}/${name}`, this.app.state)));
      } catch (fault) {
        again = /** @type {{ again?: boolean }} */ (fault)?.again ?? false; // it is still being worked out; otherwise the next answer asks
      }
      if (this.asides.get(name) !== asked) return;
      if (found) {
        onAnswer(found);
        await this.app.explain(); // what is drawn anew lacks the meanings of its words
      } else this.asides.delete(name);
      if (again) this.aside(name, but, 2000, onAnswer);
      else this.app.waits(name, false);
    };
    const look = () => { // a hand that goes on moving, or waits for its picture, has better use for the processor
      const left = this.app.asking ? REST : this.moved + wait - performance.now();
      if (left > 1) asked.timer = setTimeout(look, left);
      else ask();
    };
    asked.timer = setTimeout(look, wait);
    this.asides.set(name, asked);
  }

  // What follows the picture, such as its numbers in a table: at once, or while something is dragged once the hand rests.
  /**
   * @param {object} who draws it; what it wanted to draw before is forgotten
   * @param {() => void} draw
   */
  afterwards(who, draw) {
    const before = this.parts.get(who);
    clearTimeout(before?.timer);
    const name = before?.name ?? `part ${(this.count += 1)}`;
    const done = () => {
      this.parts.delete(who);
      draw();
      this.app.waits(name, false);
    };
    if (!this.dragged) return done();
    this.app.waits(name);
    const rested = () => {
      if (this.app.asking) return wait(); // the hand goes on, and the server is slower than it
      done();
      return this.app.explain();
    };
    const wait = () => {
      this.parts.set(who, { name, timer: setTimeout(rested, REST) });
    };
    return wait();
  }
}
