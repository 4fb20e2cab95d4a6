// What can be taken away: pictures, numbers, the bat, and the lines that give the same numbers without the page.

import { isPacked } from "./address.js";
import { download, downloadBlob } from "./download.js";
import { makerOf, saveOneFile } from "./onefile.js";
import { posted } from "./post.js";
import { FONT, wrapped } from "../charts/surface.js";
import { byId, make, partOf } from "../controls/parts.js";
import { SvgContext } from "../charts/svgcontext.js";
/** @import { App } from "./main.js" */

const LONGEST_LINE = 300; // letters of an address that a picture's foot has room for
const SHARP = 2; // pixels of a PNG per pixel of the page
const GAP = 12, ROW = 20;

/** @param {App} app */
export async function openExports(app) {
  const dialog = document.createElement("dialog");
  dialog.setAttribute("aria-label", "Export");
  dialog.innerHTML = "<h2>Take it with you</h2><div class=\"row files\"></div><div class=\"lines\"></div>" +
    "<form method=\"dialog\"><button>Close</button></form>";
  dialog.addEventListener("close", () => dialog.remove());
  const files = partOf(dialog, ".files", HTMLElement);
  for (const [words, act] of choices(app)) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: words });
    button.dataset.format = words.toLowerCase();
    button.addEventListener("click", act);
    files.append(button);
  }
  document.body.append(dialog);
  dialog.showModal();
  await addLines(app, dialog);
}

/** @param {App} app */
function choices(app) {
  /** @type {[string, () => void][]} */
  const found = [];
  if (app.view?.figures?.().length) {
    found.push(["PNG", () => savePng(app)], ["SVG", () => save(app, "svg", "image/svg+xml", svgOf(app))]);
  }
  if (app.view?.table) found.push(["CSV", () => save(app, "csv", "text/csv", csvOf(app.view?.table?.() ?? {}))]);
  found.push(["JSON", () => save(app, "json", "application/json", jsonOf(app))]);
  const maker = makerOf(app);
  if (maker) found.unshift(["Save as one file", () => saveOneFile(app, maker)]);
  return found;
}

// The lines come from the server, which knows what the command line and the library call these things.
/** @param {App} app */
async function addLines(app, /** @type {HTMLDialogElement} */ dialog) {
  const place = partOf(dialog, ".lines", HTMLElement), files = partOf(dialog, ".files", HTMLElement);
  let lines;
  try {
    lines = await posted(`/api/v1/${app.name}/recipe`, app.state);
  } catch (fault) {
    if (fault?.message) place.textContent = fault.message;
    lines = {};
  }
  if (lines.toml) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: "Bat (TOML)" });
    button.dataset.format = "toml";
    button.addEventListener("click", () => download("bat.toml", "application/toml", lines.toml));
    files.append(button);
  }
  for (const name of Object.keys(lines).filter((key) => key.endsWith(".toml"))) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
    button.dataset.format = "toml";
    button.addEventListener("click", () => download(name, "application/toml", lines[name]));
    files.append(button);
  }
  for (const [key, words] of [["command", "Command line"], ["python", "Python"]]) {
    if (lines[key]) place.append(block(app, words, lines[key], key));
  }
  if (lines.note) place.append(Object.assign(document.createElement("p"), { className: "note", textContent: lines.note }));
  if (lines.command?.includes("bat.toml")) {
    place.append(Object.assign(document.createElement("p"), {
      className: "note", textContent: "bat.toml is this bat; save it with the button above." }));
  }
  place.append(block(app, "Address of this picture", location.href, "address"));
  if (history.state?.view && !isPacked(location.search)) {
    place.append(Object.assign(document.createElement("p"), {
      className: "note", textContent: "The bat's file is too long for an address; send bat.toml along." }));
  }
}

/** @param {App} app */
function block(app, /** @type {string} */ words, /** @type {string} */ lines, /** @type {string} */ key) {
  const box = document.createElement("section");
  const pre = Object.assign(document.createElement("pre"), { textContent: lines, tabIndex: 0 });
  pre.dataset.lines = key;
  pre.setAttribute("aria-label", words);
  const copy = Object.assign(document.createElement("button"), { type: "button", textContent: "Copy" });
  copy.setAttribute("aria-label", `Copy: ${words}`);
  copy.addEventListener("click", async () => {
    await navigator.clipboard.writeText(lines);
    copy.textContent = "Copied";
    app.announce(`${words} copied`);
  });
  const head = Object.assign(document.createElement("div"), { className: "row" });
  head.append(Object.assign(document.createElement("h3"), { textContent: words }), copy);
  box.append(head, pre);
  return box;
}

// All drawings of the view, one below the other, on the theme's ground: what they show above, under which conditions,
// by what and when below, so that a picture that travels alone still says what it is.
/** @param {App} app */
function onto(app, /** @type {(width: number, height: number) => CanvasRenderingContext2D} */ make) {
  const figures = app.view?.figures?.() ?? [];
  const width = Math.max(...figures.map((figure) => figure.width));
  const measure = /** @type {CanvasRenderingContext2D} */ (document.createElement("canvas").getContext("2d")); // which every browser has
  const rows = [
    ...wrapped(measure, `600 15px ${FONT}`, titleOf(app), width - 2 * GAP).map((words) => [words, `600 15px ${FONT}`, "ink"]),
    ...wrapped(measure, `12px ${FONT}`, conditionsOf(app), width - 2 * GAP).map((words) => [words, `12px ${FONT}`, "muted"])];
  const foot = wrapped(measure, `11px ${FONT}`, sourceOf(app), width - 2 * GAP);
  const height = figures.reduce((sum, figure) => sum + figure.height + GAP, 2 * GAP) + ROW * (rows.length + foot.length);
  const context = make(width, height);
  context.fillStyle = app.colors.panel;
  context.fillRect(0, 0, width, height);
  let top = GAP;
  const write = (/** @type {string} */ words, /** @type {string} */ font, /** @type {string} */ color) => {
    Object.assign(context, { font, fillStyle: app.colors[color], textAlign: "left", textBaseline: "top" });
    context.fillText(words, GAP, top);
    top += ROW;
  };
  for (const [words, font, color] of rows) write(words, font, color);
  for (const figure of figures) {
    context.save();
    context.translate(0, top);
    figure.paint(context, figure.width, figure.height);
    context.restore();
    top += figure.height + GAP;
  }
  for (const words of foot) write(words, `11px ${FONT}`, "muted");
  return context;
}

/** @param {App} app */
const titleOf = (app) => document.getElementById("verdict")?.textContent || app.entry(app.name).title;

// The conditions of the answer, in words and in the reader's units.
/** @param {App} app */
function conditionsOf(app) {
  /** @type {Record<string, string>} */
  const known = { pitch_speed_m_s: "pitch", bat_speed_m_s: "bat speed", hands_position_m: "top hand" };
  const said = Object.entries(app.answer?.conditions ?? {}).filter(([name, value]) => known[name] && typeof value === "number")
    .map(([name, value]) => `${known[name]} ${app.text(name, value)}`);
  const changes = app.bench.made().map(([, words]) => words);
  return [app.entry(app.name).title, app.answer?.bat?.name, ...changes, ...said].filter(Boolean).join(" · ");
}

/** @param {App} app */
function sourceOf(app) {
  const date = new Date().toISOString().slice(0, 10);
  const address = decodeURIComponent(location.pathname + location.search);
  const state = address.length > LONGEST_LINE ? `${location.pathname}, its address is too long to stand here` : address;
  return `sweetspot ${app.version}, ${date}. Model, data and their sources: the documentation, "Sources" and "Validation". State: ${state}`;
}

// A printed sheet has no controls, and its folds are open but for tables of a picture's numbers and for what was never
// asked for; at its foot stands under which conditions it holds, by what and when.
/** @param {App} app */
export function onPaper(app) {
  addEventListener("beforeprint", () => {
    const foot = make("p", { className: "note", textContent: `${conditionsOf(app)}. ${sourceOf(app)}` });
    const view = byId("view"), shut = [...view.querySelectorAll("details:not([open], .numbers)")].filter((fold) => !fold.querySelector("[aria-busy=true]"));
    for (const fold of shut) fold.setAttribute("open", "");
    view.append(foot);
    addEventListener("afterprint", () => {
      foot.remove();
      for (const fold of shut) fold.removeAttribute("open");
    }, { once: true });
  });
}

/** @param {App} app */
export function svgOf(app) {
  return onto(app, (width, height) => /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (new SvgContext(width, height)))).toString();
}

/** @param {App} app */
function savePng(app) {
  const canvas = document.createElement("canvas");
  onto(app, (width, height) => {
    Object.assign(canvas, { width: width * SHARP, height: height * SHARP });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.scale(SHARP, SHARP);
    return context;
  });
  canvas.toBlob((blob) => blob && downloadBlob(`sweetspot-${app.name}.png`, blob));
}

/** @param {Record<string, unknown[]>} table */
export function csvOf(table) {
  const columns = Object.entries(table).filter(([, values]) => Array.isArray(values));
  const rows = Math.max(0, ...columns.map(([, values]) => values.length));
  const cell = (/** @type {unknown} */ value) => (value === null || value === undefined ? "" : /[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value));
  const lines = [columns.map(([name]) => name).join(",")];
  for (let row = 0; row < rows; row += 1) lines.push(columns.map(([, values]) => cell(values[row])).join(","));
  return `${lines.join("\n")}\n`;
}

/** @param {App} app */
function jsonOf(app) {
  return `${JSON.stringify({ view: app.name, version: app.version, date: new Date().toISOString(), title: titleOf(app), state: app.answered, answer: app.answer }, null, 1)}\n`;
}

/** @param {App} app */
function save(app, /** @type {string} */ ending, /** @type {string} */ type, /** @type {string} */ content) {
  download(`sweetspot-${app.name}.${ending}`, type, content);
}
