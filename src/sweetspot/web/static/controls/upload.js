// Files to the server, piece by piece (web/uploads.py): to this machine's own, where the page comes from, and nowhere else.
//
//   const key = await upload(file, (part) => ..., signal);      // part: how much has gone, 0 to 1; a refusal is thrown

import { asked, posted } from "../shell/post.js";

/**
 * @param {File} file
 * @param {(part: number) => void} onPart
 * @param {AbortSignal} [signal]
 * @returns {Promise<string>}
 */
export async function upload(file, onPart = () => {}, signal = undefined) {
  const { upload: key, piece } = await posted("/api/v1/uploads", { name: file.name || "file", size: file.size });
  for (let offset = 0; offset < file.size; offset += piece) {
    signal?.throwIfAborted();
    const response = await asked(`/api/v1/uploads/${key}/${offset}`, { method: "POST", body: file.slice(offset, offset + piece), signal });
    if (!response.ok) throw (await response.json()).error;
    onPart(Math.min(1, (offset + piece) / file.size));
  }
  return key;
}

// Where files go, in words.
/** @param {string} what */
export function whereTo(what) {
  const own = ["localhost", "127.0.0.1", "[::1]"].includes(location.hostname);
  return own ? `${what} goes to the program on this machine that shows this page, and nowhere else.` : `${what} goes to the server at ${location.hostname}, which shows this page, and nowhere else.`;
}

/**
 * Files of a kind that are dropped anywhere on the view; others are left to whoever listens besides.
 * @param {HTMLElement} root @param {RegExp} kind of their names @param {AbortSignal} signal @param {(files: File[]) => void} take
 */
export function takeDrops(root, kind, signal, take) {
  root.addEventListener("drop", (event) => {
    const files = [...(event.dataTransfer?.files ?? [])].filter(({ name }) => kind.test(name));
    if (!files.length) return;
    event.preventDefault();
    event.stopPropagation();
    root.classList.remove("drop");
    take(files);
  }, { capture: true, signal });
}
