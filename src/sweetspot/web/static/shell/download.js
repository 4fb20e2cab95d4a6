// A file made on the page, given to the browser to save.

/** @param {string} name @param {string} type @param {string} content */
export function download(name, type, content) {
  downloadBlob(name, new Blob([content], { type }));
}

/** @param {string} name @param {Blob} blob */
export function downloadBlob(name, blob) {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
