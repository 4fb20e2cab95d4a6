// A canvas context that writes SVG instead of pixels, so that what is drawn on the screen can also be exported as SVG.
// It knows what our drawings use: paths, rectangles, arcs, curves, text, dashes, alpha, save/restore, translate, rotate,
// uniform scale and rectangular clips.

const PROPERTIES = /** @type {const} */ (["fillStyle", "strokeStyle", "lineWidth", "font", "textAlign", "textBaseline", "globalAlpha", "lineCap", "lineJoin"]);
/** @type {Record<string, string>} */
const ANCHORS = { left: "start", start: "start", center: "middle", right: "end", end: "end" };
/** @type {Record<string, string>} */
const BASELINES = { alphabetic: "auto", middle: "central", top: "text-before-edge", bottom: "text-after-edge", hanging: "hanging" };
const measure = /** @type {CanvasRenderingContext2D} */ (document.createElement("canvas").getContext("2d"));

/** @typedef {[number, number, number, number, number, number]} Matrix */

export class SvgContext {
  fillStyle = "#000";
  strokeStyle = "#000";
  lineWidth = 1;
  font = "10px sans-serif";
  textAlign = "start";
  textBaseline = "alphabetic";
  globalAlpha = 1;
  lineCap = "butt";
  lineJoin = "miter";
  /** @type {string[]} */
  parts = [];
  /** @type {string[]} */
  path = [];
  /** @type {{ kept: Record<string, string | number>, matrix: Matrix, dash: number[], groups: number }[]} */
  stack = [];
  /** @type {Matrix} */
  matrix = [1, 0, 0, 1, 0, 0];
  /** @type {number[]} */
  dash = [];
  groups = 0;
  clips = 0;

  /** @param {number} width @param {number} height */
  constructor(width, height) {
    this.width = width;
    this.height = height;
  }

  save() {
    const kept = Object.fromEntries(PROPERTIES.map((name) => [name, this[name]]));
    this.stack.push({ kept, matrix: this.matrix, dash: this.dash, groups: this.groups });
    this.groups = 0;
  }

  restore() {
    const last = this.stack.pop();
    if (!last) return;
    this.parts.push("</g>".repeat(this.groups));
    Object.assign(this, last.kept, { matrix: last.matrix, dash: last.dash, groups: last.groups });
  }

  /** @param {number} x @param {number} y */
  translate(x, y) { this.matrix = times(this.matrix, [1, 0, 0, 1, x, y]); }
  /** @param {number} x */
  scale(x, y = x) { this.matrix = times(this.matrix, [x, 0, 0, y, 0, 0]); }
  /** @param {number} angle */
  rotate(angle) {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    this.matrix = times(this.matrix, [c, s, -s, c, 0, 0]);
  }
  /**
   * @param {number} a
   * @param {number} b
   * @param {number} c
   * @param {number} d
   * @param {number} e
   * @param {number} f
   */
  setTransform(a, b, c, d, e, f) { this.matrix = [a, b, c, d, e, f]; }
  /** @param {number[]} dash */
  setLineDash(dash) { this.dash = dash; }
  getLineDash() { return this.dash; }
  /** @param {string} words */
  measureText(words) {
    measure.font = this.font;
    return measure.measureText(words);
  }

  beginPath() { this.path = []; }
  closePath() { this.path.push("Z"); }
  /** @param {number} x @param {number} y */
  moveTo(x, y) { this.path.push(`M${this.at(x, y)}`); }
  /** @param {number} x @param {number} y */
  lineTo(x, y) { this.path.push(`${this.path.length ? "L" : "M"}${this.at(x, y)}`); }
  /** @param {number} a @param {number} b @param {number} x @param {number} y */
  quadraticCurveTo(a, b, x, y) { this.path.push(`Q${this.at(a, b)} ${this.at(x, y)}`); }
  /**
   * @param {number} a
   * @param {number} b
   * @param {number} c
   * @param {number} d
   * @param {number} x
   * @param {number} y
   */
  bezierCurveTo(a, b, c, d, x, y) { this.path.push(`C${this.at(a, b)} ${this.at(c, d)} ${this.at(x, y)}`); }
  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  rect(x, y, width, height) {
    this.moveTo(x, y);
    this.lineTo(x + width, y);
    this.lineTo(x + width, y + height);
    this.lineTo(x, y + height);
    this.closePath();
  }
  /**
   * @param {number} x
   * @param {number} y
   * @param {number} radius
   * @param {number} start
   * @param {number} stop
   */
  arc(x, y, radius, start, stop, backwards = false) { this.ellipse(x, y, radius, radius, 0, start, stop, backwards); }
  /**
   * @param {number} x
   * @param {number} y
   * @param {number} across
   * @param {number} up
   * @param {number} turn
   * @param {number} start
   * @param {number} stop
   */
  ellipse(x, y, across, up, turn, start, stop, backwards = false) {
    const sweep = swept(start, stop, backwards);
    const count = Math.max(2, Math.ceil(Math.abs(sweep) / (Math.PI / 2)));
    const step = sweep / count;
    const pull = (4 / 3) * Math.tan(step / 4);
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    /** @type {(u: number, v: number) => [number, number]} */
    const place = (u, v) => [x + across * u * c - up * v * s, y + across * u * s + up * v * c];
    this.lineTo(...place(Math.cos(start), Math.sin(start)));
    for (let i = 0; i < count; i += 1) {
      const [a, b] = [start + i * step, start + (i + 1) * step];
      const first = place(Math.cos(a) - pull * Math.sin(a), Math.sin(a) + pull * Math.cos(a));
      const second = place(Math.cos(b) + pull * Math.sin(b), Math.sin(b) - pull * Math.cos(b));
      this.bezierCurveTo(...first, ...second, ...place(Math.cos(b), Math.sin(b)));
    }
  }

  /** @param {string} [rule] */
  fill(rule) { this.draw(`fill="${escaped(this.fillStyle)}"${rule === "evenodd" ? ' fill-rule="evenodd"' : ""}`); }
  stroke() { this.draw(`fill="none" ${this.pen()}`); }
  clip() {
    this.clips += 1;
    this.groups += 1;
    this.parts.push(`<clipPath id="clip${this.clips}"><path d="${this.path.join("")}"/></clipPath><g clip-path="url(#clip${this.clips})">`);
  }
  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  fillRect(x, y, width, height) { this.alone(() => (this.rect(x, y, width, height), this.fill())); }
  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  strokeRect(x, y, width, height) { this.alone(() => (this.rect(x, y, width, height), this.stroke())); }
  clearRect() {}
  /** @param {string} words @param {number} x @param {number} y */
  fillText(words, x, y) { this.write(words, x, y, `fill="${escaped(this.fillStyle)}"`); }
  /** @param {string} words @param {number} x @param {number} y */
  strokeText(words, x, y) { this.write(words, x, y, `fill="none" ${this.pen()}`); }

  toString() {
    const size = `width="${this.width}" height="${this.height}" viewBox="0 0 ${this.width} ${this.height}"`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size}>${this.parts.join("")}</svg>\n`;
  }

  /** @param {() => void} draw */
  alone(draw) {
    const path = this.path;
    this.path = [];
    draw();
    this.path = path;
  }
  /** @param {number} x @param {number} y */
  at(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    return `${number(a * x + c * y + e)} ${number(b * x + d * y + f)}`;
  }
  pen() {
    const size = Math.hypot(this.matrix[0], this.matrix[1]);
    const dash = this.dash.length ? ` stroke-dasharray="${this.dash.map((length) => number(length * size)).join(" ")}"` : "";
    return `stroke="${escaped(this.strokeStyle)}" stroke-width="${number(this.lineWidth * size)}" stroke-linecap="${this.lineCap}" stroke-linejoin="${this.lineJoin}"${dash}`;
  }
  /** @param {string} look */
  draw(look) { this.parts.push(`<path d="${this.path.join("")}" ${look}${this.veil()}/>`); }
  veil() { return this.globalAlpha === 1 ? "" : ` opacity="${number(this.globalAlpha)}"`; }
  /** @param {string} words @param {number} x @param {number} y @param {string} look */
  write(words, x, y, look) {
    const matrix = times(this.matrix, [1, 0, 0, 1, x, y]).map(number).join(" ");
    const anchor = `text-anchor="${ANCHORS[this.textAlign]}" dominant-baseline="${BASELINES[this.textBaseline] ?? "auto"}"`;
    this.parts.push(`<text transform="matrix(${matrix})" ${anchor} style="font: ${escaped(this.font)}" ${look}${this.veil()}>${escaped(words)}</text>`);
  }
}

const number = (/** @type {number} */ value) => String(Math.round(value * 100) / 100);
const escaped = (/** @type {string} */ words) => String(words).replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);

// The angle an arc goes through, as a canvas takes it: a whole turn at most, in the direction asked for.
/** @param {number} start @param {number} stop @param {boolean} backwards */
function swept(start, stop, backwards) {
  const turn = 2 * Math.PI;
  const sweep = backwards ? start - stop : stop - start;
  const size = sweep >= turn ? turn : ((sweep % turn) + turn) % turn;
  return backwards ? -size : size;
}

/** @param {Matrix} first @param {Matrix} second @returns {Matrix} */
function times([a, b, c, d, e, f], [p, q, r, s, t, u]) {
  return [a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f];
}
