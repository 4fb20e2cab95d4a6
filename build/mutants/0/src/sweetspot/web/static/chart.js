// Line charts in panels one below the other on one shared axis.
//
//   const chart = new Chart(app, {
//     label: "what it shows",
//     panels: [{ title: "Exit speed", kind: "exit_speed_m_s", height: 110, zero: false,
//                lines: [{ key: "exit_speed_m_s", label: "flexible", color: "red", dash: [], width: 2, fill: false }] }],
//     axis: { kind: "position_m", from: () => length, label: "from the tip" },   // from: ticks count from there; optional
//     onPick(x, { last }) {},          // optional: pressed or dragged at x
//     stacked: false,                  // per panel: lines add up, as areas
//   });
//   root.append(chart.element);
//   chart.draw({ x: [...], lines: { exit_speed_m_s: [...] }, range: [0, 0.84], bands: [{ from, to, label }],
//                marks: [{ at, color, label }], cursor: 0.68 });
//
// kind is a name with a unit (units.js): values come in SI and are shown in the chosen system. color names a colour of
// the theme. Missing values are null. The margins LEFT and RIGHT are the same for every chart and for the bat above it.

import { Surface, FONT, haloText, ticks } from "./surface.js";
import { kindOf, toShown, unitOf } from "./units.js";

export const LEFT = 46, RIGHT = 12;
const HEAD = 22, FOOT = 34, GAP = 8;

export class Chart {
  constructor(app, { panels, axis, label, onPick = null }) {
    Object.assign(this, { app, panels, axis, data: null });
    this.surface = new Surface(app, { label, height: () => this.tall(), paint: (...all) => this.paint(...all) });
    this.element = this.surface.element;
    if (onPick) {
      this.element.style.cursor = "ew-resize";
      this.surface.drags(({ x, last }) => onPick(this.xAt(x), { last }));
    }
  }

  tall() { return this.panels.reduce((sum, panel) => sum + panel.height + HEAD + GAP, FOOT); }
  draw(data) {
    this.data = data;
    this.surface.draw();
  }
  figure(name) { return this.surface.figure(name); }
  label(words) { this.surface.label(words); }

  xAt(pixel) {
    const [least, most] = this.data.range;
    const part = (pixel - LEFT) / (this.surface.width - LEFT - RIGHT);
    return least + Math.min(1, Math.max(0, part)) * (most - least);
  }

  paint(context, width) {
    if (!this.data) return;
    const [least, most] = this.data.range;
    const across = (x) => LEFT + ((x - least) / (most - least)) * (width - LEFT - RIGHT);
    let top = 0;
    for (const panel of this.panels) {
      const box = { top: top + HEAD, bottom: top + HEAD + panel.height, left: LEFT, right: width - RIGHT };
      this.paintPanel(context, panel, box, across);
      top = box.bottom + GAP;
    }
    this.paintAxis(context, across, top - GAP);
  }

  paintPanel(context, panel, box, across) {
    const { colors, units } = this.app;
    const shown = panel.lines.map(({ key }) => shownValues(panel, this.data.lines[key], units));
    if (panel.stacked) stack(shown);
    const [low, high] = limits(shown, panel);
    const up = (value) => box.bottom - ((value - low) / (high - low || 1)) * (box.bottom - box.top);
    for (const band of this.data.bands ?? []) {
      context.fillStyle = colors.zone;
      context.fillRect(across(band.from), box.top, across(band.to) - across(band.from), box.bottom - box.top);
    }
    this.paintGrid(context, box, low, high, up);
    for (const mark of this.data.marks ?? []) vertical(context, across(mark.at), box, colors[mark.color], 1, [3, 3]);
    if (panel === this.panels[0]) this.paintMarkNames(context, box, across);
    context.save();
    context.beginPath();
    context.rect(box.left, box.top - 1, box.right - box.left, box.bottom - box.top + 2);
    context.clip();
    const xs = (this.data.xs ?? {});
    panel.lines.forEach((line, i) => {
      const below = panel.stacked && i > 0 ? shown[i - 1] : null;
      drawLine(context, line, xs[line.key] ?? this.data.x, shown[i], across, up, colors, panel.stacked ? { below, low } : null);
    });
    context.restore();
    if (this.data.cursor !== undefined && this.data.cursor !== null) this.paintCursor(context, panel, shown, box, across, up);
    this.paintTitle(context, panel, box);
  }

  // In the first panel, each name a row lower than the one before.
  paintMarkNames(context, box, across) {
    const { colors } = this.app;
    context.font = `11px ${FONT}`;
    context.textAlign = "left";
    context.textBaseline = "middle";
    (this.data.marks ?? []).filter((mark) => mark.label).forEach((mark, row) =>
      haloText(context, mark.label, across(mark.at) + 4, box.top + 7 + 13 * row, colors.ink, colors.panel));
  }

  paintGrid(context, box, low, high, up) {
    const { colors } = this.app;
    context.font = `11px ${FONT}`;
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const value of ticks(low, high, Math.max(2, (box.bottom - box.top) / 28))) {
      const y = Math.round(up(value)) + 0.5;
      horizontal(context, y, box, colors.grid);
      context.fillStyle = colors.muted;
      context.fillText(String(value).replace("-", "−"), box.left - 6, y);
    }
    if (low < 0 && high > 0) horizontal(context, Math.round(up(0)) + 0.5, box, colors.line);
  }

  paintTitle(context, panel, box) {
    const { colors, units } = this.app;
    context.textAlign = "left";
    context.textBaseline = "alphabetic";
    context.font = `600 12px ${FONT}`;
    context.fillStyle = colors.ink;
    context.fillText(panel.title, box.left, box.top - 6);
    let left = box.left + context.measureText(panel.title).width + 6;
    context.font = `12px ${FONT}`;
    const unit = unitOf(panel.kind, units);
    if (unit) {
      context.fillStyle = colors.muted;
      context.fillText(unit, left, box.top - 6);
      left += context.measureText(unit).width + 12;
    }
    for (const line of panel.lines.filter((one) => one.label)) {
      context.strokeStyle = colors[line.color];
      context.lineWidth = line.fill || panel.stacked ? 8 : line.width ?? 2;
      context.setLineDash(line.dash ?? []);
      context.beginPath();
      context.moveTo(left, box.top - 10);
      context.lineTo(left + 18, box.top - 10);
      context.stroke();
      context.setLineDash([]);
      context.fillStyle = colors.muted;
      context.fillText(line.label, left + 22, box.top - 6);
      left += 22 + context.measureText(line.label).width + 12;
    }
  }

  paintCursor(context, panel, shown, box, across, up) {
    const { colors } = this.app;
    const x = across(this.data.cursor);
    vertical(context, x, box, colors.ink, 1.2, []);
    if (panel.stacked) return;
    panel.lines.forEach((line, i) => {
      const value = between(this.data.xs?.[line.key] ?? this.data.x, shown[i], this.data.cursor);
      if (value === null) return;
      context.fillStyle = colors[line.color];
      context.beginPath();
      context.arc(x, up(value), 3.5, 0, 2 * Math.PI);
      context.fill();
      if (line.silent) return;
      context.font = `600 11px ${FONT}`;
      context.textBaseline = "middle";
      const right = x > box.right - 60;
      context.textAlign = right ? "right" : "left";
      const y = Math.min(box.bottom - 6, Math.max(box.top + 6, up(value) + (i ? 9 : -9)));
      const digits = kindOf(panel.kind)[this.app.units].digits;
      haloText(context, value.toFixed(digits).replace("-", "−"), x + (right ? -7 : 7), y, colors.ink, colors.panel);
    });
  }

  paintAxis(context, across, top) {
    const { colors, units } = this.app;
    const [least, most] = this.data.range;
    const from = this.axis.from?.() ?? 0;
    const backwards = this.axis.from !== undefined;
    const shown = (x) => shownPlace(this.axis, x, units);
    const real = (value) => {
      const { scale, offset = 0 } = kindOf(this.axis.kind)[units];
      return backwards ? from - (value - offset) / scale : (value - offset) / scale;
    };
    const [low, high] = [shown(least), shown(most)].sort((a, b) => a - b);
    context.font = `11px ${FONT}`;
    context.fillStyle = colors.muted;
    context.textAlign = "center";
    context.textBaseline = "top";
    const width = across(most) - across(least);
    for (const value of ticks(low, high, width / 60)) {
      const x = across(real(value));
      context.strokeStyle = colors.line;
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(x, top);
      context.lineTo(x, top + 4);
      context.stroke();
      context.fillText(String(value).replace("-", "−"), x, top + 6);
    }
    context.textAlign = "right";
    context.fillText(axisWords(this.axis, units), across(most), top + 19);
  }
}

function shownValues({ kind }, values, units) {
  return (values ?? []).map((value) => (value === null ? null : toShown(kind, value, units)));
}

function shownPlace({ kind, from }, x, units) {
  return toShown(kind, from ? from() - x : x, units);
}

function axisWords({ kind, label }, units) {
  return [unitOf(kind, units), label].filter(Boolean).join(" ");
}

// The numbers of a chart, or of anything with the same app, panels, axis and data, in the reader's units.
export function curvesOf({ app: { units }, panels, axis, data }) {
  const place = (x) => shownPlace(axis, x, units);
  return {
    words: axisWords(axis, units), digits: kindOf(axis.kind)[units].digits, range: data.range.map(place),
    bands: (data.bands ?? []).map(({ from, to }) => [place(from), place(to)]),
    marks: (data.marks ?? []).map((mark) => ({ ...mark, at: place(mark.at) })),
    panels: panels.map((panel) => ({
      ...panel, unit: unitOf(panel.kind, units), digits: kindOf(panel.kind)[units].digits,
      lines: panel.lines.map((line) => ({
        ...line, name: line.name || line.label || panel.title,
        x: (data.xs?.[line.key] ?? data.x).map(place), y: shownValues(panel, data.lines[line.key], units) })),
    })),
  };
}

function stack(lines) {
  for (let i = 1; i < lines.length; i += 1) lines[i] = lines[i].map((value, j) => (value ?? 0) + (lines[i - 1][j] ?? 0));
}

function limits(shown, panel) {
  let [low, high] = [Infinity, -Infinity];
  for (const line of shown) for (const value of line) if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (!(high >= low)) return [0, 1];
  if (panel.zero || panel.stacked) [low, high] = [Math.min(0, low), Math.max(0, high)];
  const room = 0.06 * (high - low || Math.abs(high) || 1);
  return [low === 0 ? 0 : low - room, high === 0 ? 0 : high + room];
}

function drawLine(context, line, xs, values, across, up, colors, area) {
  context.beginPath();
  let drawing = false;
  for (let i = 0; i < values.length; i += 1) {
    if (values[i] === null) drawing = false;
    else if (drawing) context.lineTo(across(xs[i]), up(values[i]));
    else {
      context.moveTo(across(xs[i]), up(values[i]));
      drawing = true;
    }
  }
  if (area || line.fill) {
    for (let i = values.length - 1; i >= 0; i -= 1) context.lineTo(across(xs[i]), up(area?.below?.[i] ?? 0));
    context.closePath();
    context.fillStyle = colors[line.color];
    context.globalAlpha = area ? 0.85 : 0.25;
    context.fill();
    context.globalAlpha = 1;
    if (area) return;
  }
  context.strokeStyle = colors[line.color];
  context.lineWidth = line.width ?? 2;
  context.lineJoin = "round";
  context.setLineDash(line.dash ?? []);
  context.stroke();
  context.setLineDash([]);
}

function vertical(context, x, box, color, width, dash) {
  context.strokeStyle = color;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  context.moveTo(x, box.top);
  context.lineTo(x, box.bottom);
  context.stroke();
  context.setLineDash([]);
}

function horizontal(context, y, box, color) {
  context.strokeStyle = color;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(box.left, y);
  context.lineTo(box.right, y);
  context.stroke();
}

// The value of a curve at x, straight between points; null outside.
export function between(xs, values, x) {
  if (!xs.length || x < xs[0] || x > xs.at(-1)) return null;
  let [low, high] = [0, xs.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  if (values[low] === null || values[high] === null || values[low] === undefined) return null;
  const span = xs[high] - xs[low];
  return span > 0 ? values[low] + ((x - xs[low]) / span) * (values[high] - values[low]) : values[low];
}
