// The fields of a view's state, as its JSON schema tells them.

/** @param {Record<string, any>} schema */
export function fieldsOf(schema) {
  const resolve = (/** @type {any} */ property) => (property.$ref ? { ...schema.$defs[property.$ref.split("/").pop()], ...property } : property);
  return Object.fromEntries(Object.entries(schema.properties ?? {}).map(([field, property]) => [field, resolve(property)]));
}

/** @param {Record<string, any>} fields */
export function defaultsOf(fields) {
  return Object.fromEntries(Object.entries(fields).map(([field, property]) => [field, property.default ?? null]));
}
