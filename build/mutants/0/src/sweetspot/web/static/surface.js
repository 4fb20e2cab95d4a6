// A canvas that is as sharp as the screen, knows its size, and draws the same picture into a file.
//
//   const surface = new Surface(app, { height: (width) => 300, label: "what it shows", paint(context, width, height) {} });
//   root.append(surface.element); surface.draw();

export const FONT = "system-ui, 'DejaVu Sans', sans-serif";

export class Surface {
  constructor(app, { height, paint, label = "" }) {
    Object.assign(this, { app, height, paint });
    this.element = document.createElement("canvas");
    this.element.setAttribute("role", "img");
    this.label(label);
    this.width = 0;
    this.context = this.element.getContext("2d");
    new ResizeObserver(() => this.fit() && this.draw()).observe(this.element);
  }

  // What the picture shows, for people who do not see it.
  label(words) {
    if (words && this.element.getAttribute("aria-label") !== words) this.element.setAttribute("aria-label", words);
  }

  fit() {
    const width = this.element.clientWidth;
    if (!width) return false;
    const height = Math.round(this.height(width));
    const ratio = window.devicePixelRatio || 1;
    if (width === this.width && height === this.tall && ratio === this.ratio) return false;
    Object.assign(this, { width, tall: height, ratio });
    this.element.width = Math.round(width * ratio);
    this.element.height = Math.round(height * ratio);
    this.element.style.height = `${height}px`;
    return true;
  }

  draw() {
    if (!this.width || Math.round(this.height(this.width)) !== this.tall) this.fit();
    if (!this.width) return;
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.context.clearRect(0, 0, this.width, this.tall);
    this.paint(this.context, this.width, this.tall);
  }

  // For figures(): the drawing at its present size.
  figure(name) {
    return { name, width: this.width, height: this.tall, paint: (context, width, height) => this.paint(context, width, height) };
  }

  // Call onMove({x, y, first, last}) in the canvas' own coordinates while a pointer drags.
  drags(onMove) {
    const place = (event) => {
      const box = this.element.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    this.element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      if (onMove({ ...place(event), first: true, last: false }) === false) return;
      this.element.setPointerCapture(event.pointerId);
      const move = (moved) => onMove({ ...place(moved), first: false, last: false });
      const end = (ended) => {
        this.element.removeEventListener("pointermove", move);
        onMove({ ...place(ended), first: false, last: true });
      };
      this.element.addEventListener("pointermove", move);
      this.element.addEventListener("pointerup", end, { once: true });
      this.element.addEventListener("pointercancel", end, { once: true });
    });
  }
}

// Ticks at 1, 2 or 5 times a power of ten, about `count` of them.
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
export function haloText(context, words, x, y, ink, paper) {
  context.lineJoin = "round";
  context.lineWidth = 3.5;
  context.strokeStyle = paper;
  context.strokeText(words, x, y);
  context.fillStyle = ink;
  context.fillText(words, x, y);
}
