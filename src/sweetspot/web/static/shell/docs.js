// The API's description as a page, made from the same OpenAPI document that programs read.

import { partOf } from "../controls/parts.js";
import { posted } from "./post.js";
/** @import { Property, Schema } from "../controls/fields.js" */

const main = partOf(document, "#api", HTMLElement);

/** @param {string} tag @param {string} words */
function make(tag, words, properties = {}) {
  return Object.assign(document.createElement(tag), { textContent: words, ...properties });
}

/** @typedef {{ $ref?: string }} Reference */
/** @typedef {{ description?: string, summary?: string, tags: string[], requestBody?: { content: Record<string, { schema: Reference }> } }} Operation */
/** @typedef {{ info: { description: string }, paths: Record<string, Record<string, Operation>>, components: { schemas: Record<string, Schema> } }} Described */

/** @param {Described} document @param {Reference | undefined} schema */
const resolve = (document, schema) => (schema?.$ref ? document.components.schemas[schema.$ref.split("/").pop() ?? ""] : undefined);

/** @param {Property} property */
function kindOf(property) {
  const choices = property.anyOf ?? [property];
  return choices.map((one) => {
    if (one.enum) return one.enum.join(" | ");
    const bounds = [one.minimum ?? one.exclusiveMinimum, one.maximum ?? one.exclusiveMaximum];
    const range = bounds.some((bound) => bound !== undefined) ? ` ${bounds[0] ?? "…"} to ${bounds[1] ?? "…"}` : "";
    return (one.type ?? one.$ref?.split("/").pop() ?? "value") + range;
  }).join(", or ");
}

/** @param {Schema} schema */
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

// What to type for a route's answer: the first control that has a number, a little of it.
/** @param {string} path @param {Schema} schema */
function example(path, schema) {
  const numbers = Object.entries(schema.properties ?? {}).filter(([, { default: usual }]) => typeof usual === "number").slice(0, 1);
  const state = JSON.stringify(Object.fromEntries(numbers.map(([name, { default: usual }]) => [name, usual])));
  return `curl -s ${location.origin}${path} -H 'content-type: application/json' -d '${state}'`;
}

// Above: the route of the group that has the same fields.
/** @param {Described} document @param {string} path @param {string} method @param {Operation} operation @param {string | undefined} above */
function route(document, path, method, operation, above) {
  const box = make("details", "", { className: "card" });
  const body = resolve(document, operation.requestBody?.content["application/json"]?.schema);
  box.append(make("summary", `${method.toUpperCase()} ${path}`), make("p", operation.description ?? operation.summary ?? ""));
  if (body) box.append(above ? make("p", `Its fields are those of ${above}.`, { className: "note" }) : fieldsTable(body));
  if (path.includes("{")) return box;
  box.append(make("pre", body ? example(path, body) : `curl -s ${location.origin}${path}`, { tabIndex: 0 }));
  if (body) box.append(trial(path));
  return box;
}

/** @param {Described} found */
function groups(found) {
  /** @type {Map<string, HTMLElement[]>} */
  const all = new Map();
  /** @type {Map<string, string>} */
  const told = new Map(); // fields -> the route that tells them
  for (const [path, methods] of Object.entries(found.paths)) {
    for (const [method, operation] of Object.entries(methods)) {
      const [tag] = operation.tags;
      const name = tag === "catalogue" ? "Catalogue" : path.split("/")[3];
      const fields = operation.requestBody?.content["application/json"].schema.$ref ?? "";
      const made = route(found, path, method, operation, told.get(fields));
      if (fields && !told.has(fields)) told.set(fields, `${method.toUpperCase()} ${path}`);
      all.set(name, [...(all.get(name) ?? []), made]);
    }
  }
  return all;
}

const response = await fetch("/api/v1/openapi.json");
const found = await response.json();
partOf(main, "#about", HTMLElement).textContent = found.info.description;
const contents = make("ul", "");
const index = make("nav", "", { className: "card", ariaLabel: "Contents" });
index.append(contents);
main.append(index);
for (const [name, routes] of groups(found)) {
  const section = make("section", "", { id: name });
  section.append(make("h2", name), ...routes);
  main.append(section);
  const line = make("li", "");
  line.append(make("a", name, { href: `#${name}` }), `: ${routes.length} route${routes.length === 1 ? "" : "s"}`);
  contents.append(line);
}
main.append(make("p", "Socket /ws: send {\"id\": 1, \"view\": \"explorer\", \"state\": {…}}; the answer carries the same id. " +
  "A newer question for the same view replaces one that still waits, which then gets no answer."));
