import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";

class HTMLElement { disabled = false; }
const buttons = { "#undo": new HTMLElement(), "#redo": new HTMLElement(), "#tools": { __proto__: HTMLElement.prototype, querySelector: (at) => buttons[at] } };
Object.assign(globalThis, {
  HTMLElement, HTMLButtonElement: HTMLElement, ResizeObserver: class { observe() {} },
  document: { querySelector: (at) => buttons[at] },
});

const { Steps } = await import(`${process.env.PAGE}/controls/steps.js`);
const { Later } = await import(`${process.env.PAGE}/shell/later.js`);

let now = 0;
Object.defineProperty(globalThis, "performance", { value: { now: () => now } });
function pass(milliseconds) {
  now += milliseconds;
  mock.timers.tick(milliseconds);
}

beforeEach(() => {
  mock.timers.reset();
  mock.timers.enable({ apis: ["setTimeout"] });
});

// A browser's history: steps that one goes along, the later ones forgotten when another is made.
function browser() {
  const entries = [{ state: null, address: "/" }];
  let at = 0;
  globalThis.history = {
    get state() { return entries[at].state; },
    get address() { return entries[at].address; },
    pushState: (state, _, address) => entries.splice(++at, Infinity, { state, address }),
    replaceState: (state, _, address) => (entries[at] = { state, address }),
    go: (by) => {
      at += by;
      steps.arrive();
    },
  };
  const steps = new Steps();
  return steps;
}

test("each step is taken back and done again, and no further than there are steps", () => {
  const steps = browser();
  for (const address of ["/a", "/b", "/c"]) steps.to(address);
  assert.deepEqual([buttons["#undo"].disabled, buttons["#redo"].disabled], [false, true]);
  for (let i = 0; i < 5; i += 1) steps.undo(-1);
  assert.deepEqual([history.address, buttons["#undo"].disabled, buttons["#redo"].disabled], ["/", true, false]);
  steps.undo(1);
  assert.equal(history.address, "/a");
  steps.to("/d"); // what was taken back is gone
  steps.undo(1);
  assert.deepEqual([history.address, buttons["#redo"].disabled], ["/d", true]);
});

test("a step that replaces the present one is no step of its own", () => {
  const steps = browser();
  steps.to("/a");
  steps.to("/b", {}, true);
  steps.undo(-1);
  assert.equal(history.address, "/");
});

function app() {
  const waits = new Set();
  const made = {
    state: { x: 1, park: "here" }, name: "view", asking: false, asked: [], waits: (name, yes = true) => void waits[yes ? "add" : "delete"](name), waiting: waits,
    explain: async () => {}, ask: async (path, { x }) => made.asked.push([path, x]) && { x },
  };
  made.later = new Later(made);
  return made;
}
const settle = () => new Promise((done) => setImmediate(done));

test("an aside is asked once the state has rested, and not again for a field that makes no difference", async () => {
  const one = app(), heard = [];
  const ask = () => one.later.aside("sure", ["park"], 100, ({ x }) => heard.push(x));
  ask();
  one.state = { ...one.state, x: 2 };
  ask();
  pass(100);
  await settle();
  assert.deepEqual([one.asked, heard], [[["view/sure", 2]], [2]]);
  one.state = { ...one.state, park: "there" };
  ask();
  pass(1000);
  await settle();
  assert.equal(one.asked.length, 1);
  assert.equal(one.waiting.size, 0);
});

test("what a view that goes had asked for is heard by nobody", async () => {
  const one = app(), heard = [];
  one.later.aside("sure", [], 100, ({ x }) => heard.push(x));
  pass(100);
  one.later.clear();
  await settle();
  assert.deepEqual([heard, one.waiting.size], [[], 0]);
});

test("an aside that is still being worked out is asked again, one that failed is not", async () => {
  const one = app();
  let again = true;
  one.ask = async (path) => {
    one.asked.push(path);
    throw { again };
  };
  one.later.aside("sure", [], 0, () => assert.fail());
  pass(1);
  await settle();
  again = false;
  pass(2000);
  await settle();
  pass(10000);
  await settle();
  assert.deepEqual(one.asked, ["view/sure", "view/sure"]);
  assert.equal(one.waiting.size, 0);
});

test("what follows the picture is drawn at once, or once the hand that drags rests", () => {
  const one = app(), drawn = [];
  one.later.afterwards("table", () => drawn.push("at once"));
  one.later.dragged = true;
  for (const words of ["first", "last"]) one.later.afterwards("table", () => drawn.push(words));
  assert.deepEqual(drawn, ["at once"]);
  pass(120);
  assert.deepEqual(drawn, ["at once", "last"]);
});
