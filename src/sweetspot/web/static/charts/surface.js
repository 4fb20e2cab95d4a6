// A canvas that is as sharp as the screen, knows its size, and draws the same picture into a file.
//
//   const surface = new Surface(app, { height: (width) => 300, label: "what it shows", paint(context, width, height) {} });
//   root.append(surface.element); surface.draw();

/** @import { Point } from "./pen.js" */
/** @import { App, Figure } from "../shell/main.js" */

export const FONT = "system-ui, 'DejaVu Sans', sans-serif";

const touching = new Set(); // fingers on the page, on whatever picture: two that pinch may lie on two of them
let alone = true; // whether the last of them came to no other
addEventListener("pointerdown", ({ pointerType, pointerId }) => {
  if (pointerType === "touch") touching.add(pointerId);
  alone = touching.size < 2;
}, true);
for (const gone of ["pointerup", "pointercancel"]) {
  addEventListener(gone, (event) => event instanceof PointerEvent && touching.delete(event.pointerId), true);
}

export class Surface {
  /**
   * @param {App} app
   * @param {{ height: (width: number) => number, paint: (context: CanvasRenderingContext2D, width: number, height: number) => void, label?: string }} look
   */
  constructor(app, { height, paint, label = "" }) {
    this.app = app;
    this.height = height;
    this.paint = paint;
    this.element = document.createElement("canvas");
    this.element.setAttribute("role", "img");
    this.label(label);
    this.width = 0;
    this.tall = 0;
    this.ratio = 0;
    this.pressed = false;
    /** @type {HTMLCanvasElement | null} */
    this.ground = null; // what `layer` has painted, and about what
    /** @type {unknown[]} */
    this.about = [];
    this.layered = false; // whether that is there
    this.context = /** @type {CanvasRenderingContext2D} */ (this.element.getContext("2d")); // which every browser has
    /** @type {Map<number, number>} */
    this.fingers = new Map(); // that touch it, by their number: where
    new ResizeObserver(() => this.fit() && this.draw()).observe(this.element);
    this.element.addEventListener("pointerdown", () => (this.pressed = true)); // from now on the wheel is the picture's
    this.element.addEventListener("pointerleave", () => (this.pressed = false));
    this.element.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "touch") this.fingers.set(event.pointerId, event.offsetX);
    });
    for (const gone of ["pointerup", "pointercancel", "pointerleave"]) {
      this.element.addEventListener(gone, (event) => event instanceof PointerEvent && this.fingers.delete(event.pointerId));
    }
  }

  // What the picture shows, for people who do not see it.
  /** @param {string} words */
  label(words) {
    if (words && this.element.getAttribute("aria-label") !== words) this.element.setAttribute("aria-label", words);
  }

  fit() {
    return this.size(this.element.clientWidth);
  }

  // Whether it had another size.
  /** @param {number} width */
  size(width) {
    if (!width) return false;
    const height = Math.round(this.height(width));
    const ratio = window.devicePixelRatio || 1;
    if (width === this.width && height === this.tall && ratio === this.ratio) return false;
    this.width = width;
    this.tall = height;
    this.ratio = ratio;
    this.element.width = Math.round(width * ratio);
    this.element.height = Math.round(height * ratio);
    this.element.style.height = `${height}px`;
    return true;
  }

  // What lies below a picture and stays: where it is painted again with nothing of `about` changed, from a layer of its
  // own. What changes each time, or goes into a file, is painted where it belongs, for a layer costs more than it spares.
  /**
   * @param {CanvasRenderingContext2D} context
   * @param {unknown[]} about
   * @param {(context: CanvasRenderingContext2D) => void} paint
   */
  layer(context, about, paint) {
    if (context !== this.context) {
      paint(context);
      return;
    }
    const known = [...about, this.width, this.tall, this.ratio];
    if (known.length !== this.about.length || known.some((value, i) => value !== this.about[i])) {
      this.about = known;
      this.layered = false;
      paint(context);
      return;
    }
    this.ground ??= document.createElement("canvas");
    if (!this.layered) {
      Object.assign(this.ground, { width: this.element.width, height: this.element.height });
      const below = /** @type {CanvasRenderingContext2D} */ (this.ground.getContext("2d"));
      below.save();
      below.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      paint(below);
      below.restore();
      this.layered = true;
    }
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.ground, 0, 0);
    context.restore();
  }

  draw() {
    if (!this.width) this.fit();
    else if (Math.round(this.height(this.width)) !== this.tall) this.size(this.width); // another width is told by the observer
    if (!this.width) return;
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.context.clearRect(0, 0, this.width, this.tall);
    this.context.save(); // so that each time it is painted with the same pens
    this.paint(this.context, this.width, this.tall);
    this.context.restore();
  }

  // For figures(): the drawing at its present size.
  /** @param {string} name @returns {Figure} */
  figure(name) {
    return { name, width: this.width, height: this.tall, paint: (context, width, height) => this.paint(context, width, height) };
  }

  // Call onMove({x, y, first, last}) in the canvas' own coordinates while a pointer drags: as it lay when it was pressed,
  // for what is dragged may change the room that words above it take. What a finger does is known once it moves or is
  // lifted: where the page is scrolled, or a second finger comes, nothing was dragged. A finger on what `holds` says is
  // held drags it at once, whichever way it goes.
  /**
   * @param {(at: { x: number, y: number, first: boolean, last: boolean }) => unknown} onMove  false: this is no drag
   * @param {(at: { x: number, y: number }) => boolean} [holds]
   */
  drags(onMove, holds = () => false) {
    const placed = (/** @type {{ clientX: number, clientY: number }} */ { clientX, clientY }, box = this.element.getBoundingClientRect()) => ({ x: clientX - box.left, y: clientY - box.top });
    this.element.addEventListener("touchstart", (event) => {
      if (event.touches.length === 1 && holds(placed(event.touches[0]))) event.preventDefault(); // the page is not scrolled
    }, { passive: false });
    this.element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !alone) return;
      const box = this.element.getBoundingClientRect();
      const place = (/** @type {PointerEvent} */ moved) => placed(moved, box);
      const start = place(event);
      const begin = () => onMove({ ...start, first: true, last: false }) !== false;
      let begun = event.pointerType !== "touch" || holds(start);
      if (begun && !begin()) return;
      this.element.setPointerCapture(event.pointerId);
      const stop = () => {
        this.element.removeEventListener("pointermove", move);
        this.element.removeEventListener("pointerup", end);
        this.element.removeEventListener("pointercancel", end);
      };
      const move = (/** @type {PointerEvent} */ moved) => {
        if (touching.size > 1) {
          if (!begun) stop();
          return;
        }
        const now = place(moved);
        if (!begun && Math.abs(now.x - start.x) < Math.abs(now.y - start.y)) return; // up or down scrolls the page (theme.css)
        if (!begun && !begin()) {
          stop();
          return;
        }
        begun = true;
        onMove({ ...now, first: false, last: false });
      };
      const end = (/** @type {PointerEvent} */ ended) => {
        stop();
        if (!begun && (ended.type === "pointercancel" || !alone || !begin())) return;
        onMove({ ...place(ended), first: false, last: true });
      };
      this.element.addEventListener("pointermove", move);
      this.element.addEventListener("pointerup", end);
      this.element.addEventListener("pointercancel", end);
    });
  }

  // Call onHover({x, y}) while a pointer is over the picture and presses nothing, onHover(null) when it goes.
  /** @param {(at: { x: number, y: number } | null) => void} onHover */
  hovers(onHover) {
    this.element.addEventListener("pointermove", (event) => {
      if (event.buttons === 0 && event.pointerType !== "touch") onHover({ x: event.offsetX, y: event.offsetY });
    });
    this.element.addEventListener("pointerleave", () => onHover(null));
  }

  // Call onPinch({x, factor}) while two fingers move apart (factor above 1) or together about x.
  /** @param {(at: { x: number, factor: number }) => void} onPinch */
  pinches(onPinch) {
    const far = () => {
      const [one, other] = [...this.fingers.values()];
      return { x: (one + other) / 2, apart: Math.max(20, Math.abs(one - other)) };
    };
    this.element.addEventListener("pointermove", (event) => {
      if (!this.fingers.has(event.pointerId)) return;
      const before = this.fingers.size === 2 ? far() : null;
      this.fingers.set(event.pointerId, event.offsetX);
      if (before) onPinch({ x: before.x, factor: far().apart / before.apart });
    });
  }
}

/**
 * A way from one point to another with a head at its end.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Point} from
 * @param {Point} to
 * @param {string} color
 * @param {number} width
 */
export function arrow(context, [fromX, fromY], [toX, toY], color, width = 2) {
  const angle = Math.atan2(toY - fromY, toX - fromX);
  const size = 4 + 2 * width;
  /** @type {(turn: number) => Point} */
  const wing = (turn) => [toX - size * Math.cos(angle + turn), toY - size * Math.sin(angle + turn)];
  Object.assign(context, { strokeStyle: color, fillStyle: color, lineWidth: width });
  context.beginPath();
  context.moveTo(fromX, fromY);
  context.lineTo(toX - 0.6 * size * Math.cos(angle), toY - 0.6 * size * Math.sin(angle));
  context.stroke();
  context.beginPath();
  context.moveTo(toX, toY);
  context.lineTo(...wing(0.45));
  context.lineTo(...wing(-0.45));
  context.closePath();
  context.fill();
}

// Ticks at 1, 2 or 5 times a power of ten, about `count` of them.
/** @param {number} least @param {number} most @param {number} count */
export function ticks(least, most, count) {
  const span = most - least;
  if (!(span > 0)) return [least];
  const rough = span / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((factor) => factor * power >= rough * 0.999) ?? 10);
  const found = [];
  for (let i = Math.ceil(least / step - 1e-9); i * step <= most + 1e-9 * step; i += 1) found.push(Number((i * step).toPrecision(12)));
  return found;
}

// Words with an outline in the colour of the paper, readable over lines.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {string} words
 * @param {number} x
 * @param {number} y
 * @param {string} ink
 * @param {string} paper
 */
export function haloText(context, words, x, y, ink, paper) {
  context.lineJoin = "round";
  context.lineWidth = 3.5;
  context.strokeStyle = paper;
  context.strokeText(words, x, y);
  context.fillStyle = ink;
  context.fillText(words, x, y);
}

// Words in rows that are no wider than so many pixels.
/**
 * @param {CanvasRenderingContext2D} context
 * @param {string} font
 * @param {string} words
 * @param {number} width
 */
export function wrapped(context, font, words, width) {
  context.font = font;
  const rows = [""];
  for (const word of words.split(" ")) {
    const longer = `${rows.at(-1)} ${word}`.trim();
    if (context.measureText(longer).width <= width || rows.at(-1) === "") rows[rows.length - 1] = longer;
    else rows.push(word);
  }
  return rows.filter(Boolean);
}
