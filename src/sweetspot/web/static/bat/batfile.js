// A bat file that somebody hands in: short enough, and a bat to the server. A refusal is thrown with its message.

import { posted } from "../shell/post.js";

const LONGEST_TOML = 20000;

/** @param {File} file */
export async function textOf(file) {
  if (file.size > LONGEST_TOML)
    throw new RangeError(`${file.name} has ${file.size} bytes; a bat file has a few lines, at most ${LONGEST_TOML}.`);
  return file.text();
}

/** @param {string} toml */
export const checked = (toml) => posted("/api/v1/bat", { toml });
