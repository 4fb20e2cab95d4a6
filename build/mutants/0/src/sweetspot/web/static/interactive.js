// The view's curves by plotly.js: zoom, read values, switch curves off, save a PNG. It is large, so it is loaded only when asked for.

import { curvesOf } from "./chart.js";
import { make } from "./parts.js";
import { FONT } from "./surface.js";

const SOURCE = "/vendor/plotly.min.js";
const HEAD = 34, GAP = 40, FOOT = 60; // px above, between and below the panels
const MISSING = "The chart's program could not be loaded. It comes with the Python package plotly: is that installed?";
let loading = null;

export async function interactive(app) {
  const charts = app.view.charts();
  const status = make("p", { className: "note", textContent: "Loading the chart …" });
  status.setAttribute("role", "status");
  const close = make("button", { type: "button", textContent: "Close" });
  const places = make("div");
  const dialog = make("dialog", { className: "interactive" },
    make("h2", { id: "interactive-title", textContent: "Interactive chart" }),
    make("p", { className: "note", textContent: "Drag to zoom, double-click to go back; point at a curve to read it; click a name to switch its curve off." }),
    status, places, make("div", { className: "row" }, close));
  dialog.setAttribute("aria-labelledby", "interactive-title");
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => {
    for (const plot of places.querySelectorAll(".plot")) window.Plotly?.purge(plot);
    dialog.remove();
  });
  document.body.append(dialog);
  dialog.showModal();
  close.focus();
  try {
    const plotly = await plotlyJs();
    if (!dialog.open) return;
    for (const [i, chart] of charts.entries()) await addPlot(plotly, places, chart, i ? `${app.name}-${i + 1}` : app.name);
    status.remove();
  } catch (error) {
    status.textContent = error.message;
  }
}

function plotlyJs() {
  loading ??= new Promise((resolve, reject) => {
    const script = make("script", { src: SOURCE });
    script.addEventListener("load", () => resolve(window.Plotly));
    script.addEventListener("error", () => {
      loading = null; // so that the next try asks again
      script.remove();
      reject(new Error(MISSING));
    });
    document.head.append(script);
  });
  return loading;
}

async function addPlot(plotly, places, chart, name) {
  const words = chart.surface?.element.getAttribute("aria-label") ?? chart.label;
  const plot = make("div", { className: "plot", ariaLabel: words });
  plot.setAttribute("role", "group");
  const save = make("button", { type: "button", textContent: "Download PNG" });
  save.setAttribute("aria-label", `Download PNG: ${words}`);
  places.append(plot, make("div", { className: "row" }, save));
  const { traces, layout } = drawn(curvesOf(chart), chart.app.colors);
  const picture = { format: "png", filename: `sweetspot-${name}-chart`, scale: 2 };
  await plotly.newPlot(plot, traces, layout, {
    responsive: true, displaylogo: false, displayModeBar: true, toImageButtonOptions: picture,
    modeBarButtonsToRemove: ["select2d", "lasso2d"], showSendToCloud: false, // what is drawn stays here
  });
  save.addEventListener("click", () => plotly.downloadImage(plot, { ...picture, width: plot.clientWidth, height: layout.height }));
}

function drawn(curves, colors) {
  const { panels, bands, marks } = curves;
  const inner = panels.reduce((sum, { height }) => sum + height, 0) + GAP * (panels.length - 1);
  const paper = (fromTop) => Math.max(0, 1 - fromTop / inner);
  const axes = {}, titles = [], traces = [];
  let top = 0;
  panels.forEach((panel, i) => {
    const key = i ? i + 1 : "";
    axes[`yaxis${key}`] = { domain: [paper(top + panel.height), paper(top)], hoverformat: `.${panel.digits}f`, ...gridOf(colors),
      zeroline: true, zerolinecolor: colors.line, rangemode: panel.zero || panel.stacked ? "tozero" : "normal" };
    titles.push({ text: `<b>${escaped(panel.title)}</b> ${panel.unit}`, x: 0, y: paper(top), xanchor: "left", yanchor: "bottom" });
    traces.push(...panel.lines.map((line) => trace(line, panel, `y${key}`, colors)));
    top += panel.height + GAP;
  });
  const seen = new Set(); // a bat in several panels is one name, which switches all its curves
  for (const one of traces) {
    one.showlegend = !seen.has(one.legendgroup);
    seen.add(one.legendgroup);
  }
  const across = { xref: "x", yref: "paper" };
  const layout = {
    height: HEAD + inner + FOOT, margin: { l: 56, r: 16, t: HEAD, b: FOOT }, paper_bgcolor: colors.panel, plot_bgcolor: colors.panel,
    font: { family: FONT, size: 12, color: colors.ink }, colorway: [colors.blue], hovermode: "x unified", hoversubplots: "axis",
    hoverlabel: { bgcolor: colors.panel, bordercolor: colors.line, font: { color: colors.ink } },
    modebar: { bgcolor: colors.panel, color: colors.muted, activecolor: colors.accent },
    legend: { bgcolor: colors.panel, groupclick: "togglegroup", tracegroupgap: 0 },
    xaxis: { range: curves.range, anchor: panels.length > 1 ? `y${panels.length}` : "y", title: { text: escaped(curves.words) },
      hoverformat: `.${curves.digits}f`, zeroline: false, ...gridOf(colors) },
    ...axes,
    shapes: [
      ...bands.map(([x0, x1]) => ({ type: "rect", ...across, x0, x1, y0: 0, y1: 1, fillcolor: colors.zone, line: { width: 0 }, layer: "below" })),
      ...marks.map(({ at, color }) => ({ type: "line", ...across, x0: at, x1: at, y0: 0, y1: 1, line: { color: colors[color], width: 1, dash: "3px,3px" } })),
    ],
    annotations: [
      ...titles.map((title) => ({ ...title, xref: "paper", yref: "paper", showarrow: false })),
      ...marks.filter(({ label }) => label).map(({ at, label }, row) => ({
        text: escaped(label), ...across, x: at, y: 1, yshift: -13 * row, xanchor: "left", yanchor: "top", showarrow: false })),
    ],
  };
  return { traces, layout };
}

const gridOf = (colors) => ({ gridcolor: colors.grid, linecolor: colors.line, tickcolor: colors.line });

function trace({ name, x, y, color, dash, width = 2, fill = false }, { stacked, digits, unit }, yaxis, colors) {
  const shade = stacked ? { stackgroup: yaxis, fillcolor: colors[color] } : fill ? { fill: "tozeroy" } : {};
  return {
    type: "scatter", mode: "lines", name: escaped(name), legendgroup: name, x, y, xaxis: "x", yaxis, ...shade,
    line: { color: colors[color], width, dash: dash?.length ? dash.map((one) => `${one}px`).join(",") : "solid" },
    hovertemplate: `%{y:.${digits}f} ${unit}`,
  };
}

// plotly reads its words as HTML; names of bats are anyone's.
function escaped(words) {
  return words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}
