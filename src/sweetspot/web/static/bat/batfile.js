// A bat file that somebody hands in: short enough, and a bat to the server. A refusal is thrown with its message.

import { posted } from "../shell/post.js";
/** @import { App } from "../shell/main.js" */

const LONGEST_TOML = 20000;

/** @param {File} file */
export async function textOf(file) {
  if (file.size > LONGEST_TOML)
    throw new RangeError(`${file.name} has ${file.size} bytes; a bat file has a few lines, at most ${LONGEST_TOML}.`);
  return file.text();
}

/** @param {string} toml */
export const checked = (toml) => posted("/api/v1/bat", { toml });

// The bat as it stands, as the text of a bat file; a refusal is thrown.
/** @param {App} app */
export async function batText(app) {
  const { toml } = await posted("/api/v1/explorer/recipe", Object.fromEntries(
    Object.entries(app.carried).filter(([field]) => Object.hasOwn(app.entry("explorer").schema, field))));
  return toml;
}
