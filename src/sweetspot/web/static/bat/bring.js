// Anything at one drop: a bat as file, table, drawing, solid or photograph; a ball; another sport's implement; tables of
// swings or of a season; a player's file; sounds of taps. The server says what each is.

import { unchanged } from "./unchanged.js";
import { button } from "../controls/controls.js";
import { byId, make, paragraphs } from "../controls/parts.js";
import { fromShown, toShown, unitOf } from "../controls/units.js";
import { upload } from "../controls/upload.js";
import { posted } from "../shell/post.js";
import { wordsOf } from "../shell/status.js";
/** @import { App, ViewName } from "../shell/main.js" */
/** @import { System } from "../controls/units.js" */
/** @typedef {{ kind: "bat" | "implement" | "ball" | "swings" | "season" | "batter" | "sound", name: string, toml: string, notes: Record<System, string[]>, asks: string }} Found what a file is (web/bring.py) */

/** @type {Partial<Record<Found["kind"], ViewName>>} where what is read by a view of its own goes */
const VIEWS = { swings: "player", season: "season", batter: "design", sound: "own" };
const USUAL = 33; // in, offered as a bat's length
const LARGEST = 50e6; // bytes that are looked at before they go to a view
const TABLES = /\.(gz|parquet)$/i;
export const ANYTHING = ".toml,.csv,.tsv,.txt,.gz,.parquet,.json,.svg,.dxf,.stl,image/*,audio/*,.wav";

// Files dropped anywhere on the page that no view has taken.
/** @param {App} app */
export function takeDrops(app) {
  const view = byId("view");
  addEventListener("dragover", (event) => (event.preventDefault(), view.classList.add("drop")));
  addEventListener("dragleave", () => view.classList.remove("drop"));
  addEventListener("drop", (event) => {
    event.preventDefault();
    view.classList.remove("drop");
    bring(app, [...(event.dataTransfer?.files ?? [])]);
  });
}

// A field for files of any kind.
/** @param {App} app @param {string} id */
export function fileField(app, id) {
  const chosen = make("input", { type: "file", id, multiple: true, accept: ANYTHING });
  chosen.addEventListener("change", () => {
    const files = [...(chosen.files ?? [])];
    chosen.value = ""; // so that the same file can be chosen again once it is mended
    bring(app, files);
  });
  return chosen;
}

/** @param {App} app @param {File[]} files */
export async function bring(app, files) {
  const [file] = files;
  if (!file) return;
  app.waits("file");
  try {
    if (TABLES.test(file.name) || file.size > LARGEST) await goTo(app, "season", files);
    else {
      const key = await upload(file);
      await take(app, files, key, await posted("/api/v1/bring", { upload: key }));
    }
  } catch (fault) {
    say(app, file.name, [wordsOf(fault, app.units)]);
  }
  app.waits("file", false);
}

/** @param {App} app @param {File[]} files @param {string} key @param {Found} found */
async function take(app, files, key, found) {
  const { kind, name, toml, notes } = found, words = notes[app.units];
  if (found.asks) return ask(app, files, key, found);
  const view = VIEWS[kind];
  if (view) return goTo(app, view, files);
  if (kind === "implement") {
    app.visitWith("sports", { implement_toml: toml, swing_mph: null, incoming_mph: null, met_from_tip_in: null, aside_in: 0 });
  } else if (kind === "ball") app.bench.desk.setState({ ball_toml: toml });
  else app.bench.desk.setState({ ...unchanged(app.bench.desk), bat_toml: toml });
  if (words.length) say(app, name, words);
}

// To the view that reads such files, which takes them as if they were handed in there.
/** @param {App} app @param {ViewName} name @param {File[]} files */
async function goTo(app, name, files) {
  if (app.name !== name) await app.visit(app.addressFor(name));
  await app.view?.bring?.(files);
}

/** @param {App} app @param {string} title @param {string[]} words @param {...Node} more */
function say(app, title, words, ...more) {
  const notes = make("div", { className: "words" });
  const dialog = make("dialog", { className: "brought" }, make("h2", { id: "brought-title", textContent: title }), notes, ...more,
    make("form", { method: "dialog" }, make("button", { textContent: "Close" })));
  paragraphs(notes, words);
  dialog.setAttribute("aria-labelledby", "brought-title");
  dialog.addEventListener("close", () => dialog.remove());
  addEventListener("popstate", () => dialog.close(), { once: true });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

// What a file does not hold itself: how long the bat is.
/** @param {App} app @param {File[]} files @param {string} key @param {Found} found */
function ask(app, files, key, { name, notes }) {
  const number = make("input", { type: "number", step: "any", id: "brought-length", value: String(Number(toShown("length_in", USUAL, app.units).toFixed(1))) });
  const fault = make("p", { className: "fault", hidden: true });
  fault.setAttribute("role", "alert");
  const read = async () => {
    try {
      const found = await posted("/api/v1/bring", { upload: key, length_in: fromShown("length_in", Number(number.value), app.units) });
      dialog.close();
      await take(app, files, key, found);
    } catch (wrong) {
      fault.textContent = wordsOf(wrong, app.units);
      fault.hidden = false;
    }
  };
  const dialog = say(app, name, notes[app.units], make("div", { className: "control" }, make("label", { htmlFor: number.id, textContent: "Length of the bat" }),
    make("div", { className: "entry" }, number, make("span", { className: "unit", textContent: unitOf("length_in", app.units) })), fault),
  make("div", { className: "row" }, button("Read it", read, { primary: true })));
  number.focus();
}
