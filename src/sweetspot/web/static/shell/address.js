// A view's state as an address and back: /explorer?pitch_speed_mph=85; only what differs from the first picture.

const PACKED = "s", SYSTEM = "units"; // what an address may hold beside fields
export const LONG_ADDRESS = 2000; // letters from which mail programs, chats and servers on the way may cut an address off
const MOST_UNPACKED = 65536; // letters of what a short address may hold

/** @typedef {Record<string, unknown>} Fields the state of a view, by its fields */
/** @import { Property } from "../controls/fields.js" */

const HOME = "start"; // whose address is that of the server
/** @param {string} name @param {boolean} embedded */
const pathOf = (name, embedded) => (embedded ? `/embed/${name}` : name === HOME ? "/" : `/${name}`);

/** @param {string} name @param {Fields} state @param {Fields} defaults */
export function addressOf(name, state, defaults, embedded = false) {
  const query = new URLSearchParams();
  for (const [field, value] of Object.entries(state)) {
    if (JSON.stringify(value) === JSON.stringify(defaults[field])) continue;
    query.set(field, typeof value === "string" ? value : JSON.stringify(value));
  }
  const text = query.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
  return `${pathOf(name, embedded)}${text ? `?${text}` : ""}`;
}

// The same as a short address: what differs, packed by deflate. It needs no server to remember it.
/** @param {string} name @param {Fields} state @param {Fields} defaults */
export async function shortAddressOf(name, state, defaults, embedded = false) {
  const changed = Object.entries(state).filter(([field, value]) => JSON.stringify(value) !== JSON.stringify(defaults[field]));
  const path = pathOf(name, embedded);
  if (!changed.length) return path;
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(Object.fromEntries(changed))));
  const text = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  return `${path}?${PACKED}=${text}`;
}

// Whether an address holds its state packed.
/** @param {string} search */
export const isPacked = (search) => new URLSearchParams(search).has(PACKED);

/** @param {string} text */
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  const found = new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
  return JSON.parse(found);
}

/**
 * @param {CompressionStream | DecompressionStream} stream
 * @param {Uint8Array<ArrayBuffer>} bytes
 */
async function through(stream, bytes) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (let piece = await reader.read(); !piece.done; piece = await reader.read()) {
    size += piece.value.length;
    if (size > MOST_UNPACKED) throw new RangeError("this address holds more than any state has");
    parts.push(...piece.value);
  }
  return Uint8Array.from(parts);
}

// The names in an address that are no fields of the view, such as those of another version, or of a slip of the pen.
/** @param {string} search @param {Record<string, Property>} schema */
export const unknownIn = (search, schema) => [...new Set(new URLSearchParams(search).keys())].filter((name) => name !== PACKED && name !== SYSTEM && !Object.hasOwn(schema, name));

// Unknown names are left out; values are read by the schema's type and checked by the server.
/** @param {string} search @param {Record<string, Property>} schema @param {Fields} defaults */
export async function stateIn(search, schema, defaults) {
  const state = { ...defaults };
  const packed = new URLSearchParams(search).get(PACKED);
  if (packed) {
    try {
      for (const [field, value] of Object.entries(await unpacked(packed))) if (Object.hasOwn(schema, field)) state[field] = value;
    } catch {
      // cut off on its way: the first picture, and the rest of the address
    }
  }
  for (const [field, text] of new URLSearchParams(search)) {
    if (!Object.hasOwn(schema, field)) continue;
    state[field] = isText(schema[field]) ? text : parsed(text);
  }
  return state;
}

/** @param {Property} property */
function isText(property) {
  const choices = property.anyOf ?? [property];
  return choices.some((choice) => choice.type === "string" || choice.enum?.every((item) => typeof item === "string"));
}

/** @param {string} text */
function parsed(text) {
  try {
    const value = JSON.parse(text);
    return Math.abs(value) === Infinity ? text : value; // which no JSON holds
  } catch {
    return text; // the server says what is wrong with it
  }
}
