// Formulas as MathML from a short notation, words separated by blanks:
//   mathOf("{ F | I } = { J_C − m x l | J_C + m l^2 }")   fractions in braces, _ below, ^ above
// Names of several letters (cos, kg) stand upright; a plain text for those whose reader knows no MathML is alttext.

const FLAT = 0.12; // em: an index that stands less below its letter stands on the line
const DEEP = /[gjpqy]/, DEPTH = 0.2; // em: letters that reach below their own line, and by how much
const SPACE = "http://www.w3.org/1998/Math/MathML";

/** @param {string} source */
export function mathOf(source, { block = true } = {}) {
  const math = document.createElementNS(SPACE, "math");
  math.setAttribute("display", block ? "block" : "inline");
  math.setAttribute("alttext", source.replaceAll("{ ", "(").replaceAll(" | ", ") / (").replaceAll(" }", ")"));
  math.append(rowOf(source.split(" ").filter(Boolean)));
  if (!lowerScripts(math)) requestAnimationFrame(() => lowerScripts(math));
  return math;
}

/** @type {Map<string, boolean>} */
const flat = new Map(); // by a letter with its index: whether that stands on the line

// Without a font for formulas browsers set small indices on the line, as if they were factors: what says so is how
// low an index stands where it is shown. Whether all are known.
/** @param {Element} math */
function lowerScripts(math) {
  const scripts = [...math.querySelectorAll("msub, msubsup")];
  for (const script of scripts) {
    const words = script.textContent ?? "";
    if (!flat.has(words) && math.isConnected) {
      const [base, below] = [...script.children].map((part) => part.getBoundingClientRect().bottom);
      const least = FLAT + (DEEP.test(script.children[1].textContent ?? "") ? DEPTH : 0);
      flat.set(words, below - base < least * parseFloat(getComputedStyle(script).fontSize));
    }
    script.classList.toggle("flat", flat.get(words) ?? false);
  }
  return scripts.every(({ textContent }) => flat.has(textContent ?? ""));
}

/** @param {string[]} words */
function rowOf(words) {
  const row = element("mrow");
  for (let i = 0; i < words.length; i += 1) {
    if (i && (words[i - 1] === "," || (isFactor(words[i - 1], "}") && isFactor(words[i], "{")))) row.append(spaced());
    if (words[i] !== "{") {
      row.append(term(words[i]));
      continue;
    }
    const [bar, end] = [find(words, i, "|"), find(words, i, "}")];
    row.append(element("mfrac", rowOf(words.slice(i + 1, bar)), rowOf(words.slice(bar + 1, end))));
    i = end;
  }
  return row;
}

// Factors stand a little apart, so that "sin α T" is no word.
/**
 * @param {string} word
 * @param {string} brace  that of a fraction's end which stands on this side
 */
const isFactor = (word, brace) => word === brace || (/^[\p{L}\d]/u.test(word) && !UNITS.includes(word));

function spaced() {
  const made = element("mspace");
  made.setAttribute("width", "0.2em");
  return made;
}

// The bar or brace that belongs to the brace at `start`.
/** @param {string[]} words @param {number} start @param {"|" | "}"} sign */
function find(words, start, sign) {
  let depth = 0;
  for (let i = start; i < words.length; i += 1) {
    if (words[i] === "{") depth += 1;
    if (words[i] === sign && depth === 1) return i;
    if (words[i] === "}") depth -= 1;
  }
  throw new Error(`no ${sign} in the formula ${words.join(" ")}`);
}

/** @param {string} word */
function term(word) {
  if (UNITS.includes(word)) return element("mtext", `\u2009${word}`);
  const [, base, below, above] = /^(.+?)(?:_([^_^]+))?(?:\^([^_^]+))?$/.exec(word) ?? ["", word];
  const parts = [base, below, above].filter((part) => part !== undefined).map(token);
  if (below !== undefined && above !== undefined) return element("msubsup", ...parts);
  if (below !== undefined) return element("msub", ...parts);
  return above !== undefined ? element("msup", ...parts) : parts[0];
}

// Symbols inside running text: J_C, k_bat, v1^2, l^2, alpha. Each becomes a small formula in its place.
const SYMBOL = /\b(?:[aJEk]_(?:bat|ball|[A-Za-z]\b)(?:\^2)?|[mvkWz][012](?:\^2)?|[a-zA-Z]\^2|alpha)(?![\w^])/g;

/** @param {Element} place */
export function typeset(place) {
  const texts = document.createTreeWalker(place, NodeFilter.SHOW_TEXT);
  const found = [];
  for (let node = texts.nextNode(); node; node = texts.nextNode()) if ((node.textContent ?? "").search(SYMBOL) >= 0) found.push(node);
  for (const node of found) {
    const words = node.textContent ?? "";
    const parts = [];
    let end = 0;
    for (const match of words.matchAll(SYMBOL)) {
      const source = match[0] === "alpha" ? "α" : match[0].replace(/^([a-zA-Z])([012])/, "$1_$2");
      parts.push(words.slice(end, match.index), mathOf(source, { block: false }));
      end = match.index + match[0].length;
    }
    /** @type {ChildNode} */ (node).replaceWith(...parts, words.slice(end));
  }
}

const UNITS = ["mm", "cm", "in", "kN", "lbf", "N", "s", "J", "%"];

/** @param {string} text */
function token(text) {
  const tag = /^[−-]?[\d.,]+$/.test(text) ? "mn" : /^[\p{L}′]+$/u.test(text) ? "mi" : "mo";
  const made = element(tag, text);
  if (tag === "mi" && [...text].length > 1) made.setAttribute("mathvariant", "normal");
  return made;
}

/** @param {string} tag @param {(Node | string)[]} children */
function element(tag, ...children) {
  const made = document.createElementNS(SPACE, tag);
  made.append(...children);
  return made;
}
