// The API's description as a page, made from the same OpenAPI document that programs read.

import { partOf } from "./parts.js";
import { posted } from "./post.js";

const main = partOf(document, "#api", HTMLElement);

/**
 * @param {string} tag
 * @param {string} words
 */
function make(tag, words, properties = {}) {
  return Object.assign(document.createElement(tag), { textContent: words, ...properties });
}

/**
 * @param {any} document
 * @param {any} schema
 */
function resolve(document, schema) {
  return schema?.$ref ? document.components.schemas[schema.$ref.split("/").pop()] : schema;
}

/** @param {any} property */
function kindOf(property) {
  const choices = property.anyOf ?? [property];
  return choices.map((/** @type {any} */ one) => {
    if (one.enum) return one.enum.join(" | ");
    const bounds = [one.minimum ?? one.exclusiveMinimum, one.maximum ?? one.exclusiveMaximum];
    const range = bounds.some((bound) => bound !== undefined) ? ` ${bounds[0] ?? "…"} to ${bounds[1] ?? "…"}` : "";
    return `${one.type ?? one.$ref?.split("/").pop() ?? "any"}${range}`;
  }).join(", or ");
}

/** @param {any} schema */
function fieldsTable(schema) {
  const box = make("div", "", { className: "scroll", tabIndex: 0 });
  const table = document.createElement("table");
  const head = table.createTHead().insertRow();
  for (const words of ["Field", "Type and bounds", "Default", "What it is"]) head.append(make("th", words, { scope: "col" }));
  const body = table.createTBody();
  for (const [name, property] of Object.entries(schema.properties ?? {})) {
    const row = body.insertRow();
    const shown = schema.required?.includes(name) ? "required" : property.default === undefined ? "empty" : JSON.stringify(property.default);
    row.append(make("th", name, { scope: "row" }), make("td", kindOf(property)), make("td", shown), make("td", property.description ?? ""));
  }
  box.append(table);
  return box;
}

/** @param {string} path */
function trial(path) {
  const box = document.createElement("details");
  const label = make("label", "Message");
  const field = Object.assign(document.createElement("textarea"), { value: "{}", rows: 3 });
  const result = make("pre", "", { tabIndex: 0, hidden: true });
  const send = make("button", "Send", { type: "button" });
  label.append(field);
  send.addEventListener("click", async () => {
    result.hidden = false;
    try {
      result.textContent = JSON.stringify(await posted(path, JSON.parse(field.value)), null, 1).slice(0, 4000);
    } catch (fault) {
      result.textContent = fault.message;
    }
  });
  box.append(make("summary", "Try it"), label, send, result);
  return box;
}

/**
 * @param {any} document
 * @param {string} path
 * @param {string} method
 * @param {any} operation
 */
function route(document, path, method, operation) {
  const box = make("section", "", { className: "card" });
  box.append(make("h2", `${method.toUpperCase()} ${path}`), make("p", operation.description ?? operation.summary ?? ""));
  const body = resolve(document, operation.requestBody?.content["application/json"].schema);
  const repeated = path.endsWith("/recipe"); // the fields are those of the view above
  if (body && !repeated) box.append(fieldsTable(body));
  if (body) box.append(trial(path));
  return box;
}

const response = await fetch("/api/v1/openapi.json");
const found = await response.json();
partOf(main, "#about", HTMLElement).textContent = found.info.description;
for (const [path, methods] of Object.entries(found.paths)) {
  for (const [method, operation] of Object.entries(methods)) main.append(route(found, path, method, operation));
}
main.append(make("p", "Socket /ws: send {\"id\": 1, \"view\": \"explorer\", \"state\": {…}}; the answer carries the same id. " +
  "A newer question for the same view replaces one that still waits, which then gets no answer."));
