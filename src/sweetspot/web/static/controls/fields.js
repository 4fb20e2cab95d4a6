// The fields of a view's state, as its JSON schema tells them.

/** @import { State } from "../shell/main.js" */

/** @typedef {{ type?: string, enum?: unknown[], anyOf?: Property[], $ref?: string, default?: unknown, description?: string, minimum?: number, maximum?: number, exclusiveMinimum?: number, exclusiveMaximum?: number }} Property of a schema */
/** @typedef {{ properties?: Record<string, Property>, required?: string[], $defs?: Record<string, Schema> }} Schema */

/** @param {Schema} schema @returns {Record<string, Property>} */
export function fieldsOf(schema) {
  const resolve = (/** @type {Property} */ property) => (property.$ref ? { ...schema.$defs?.[property.$ref.split("/").pop() ?? ""], ...property } : property);
  return Object.fromEntries(Object.entries(schema.properties ?? {}).map(([field, property]) => [field, resolve(property)]));
}

/** @param {Record<string, Property>} fields */
export function defaultsOf(fields) {
  return /** @type {State} */ (/** @type {unknown} */ (Object.fromEntries(Object.entries(fields).map(([field, property]) => [field, property.default ?? null]))));
}
