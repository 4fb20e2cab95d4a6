// What pictures are painted with: lines through points, filled shapes and dots.

/** @typedef {[number, number]} Point a place in pixels */
/** @typedef {{ fill?: string, edge?: string, width?: number, dash?: number[] }} Look colours, and how wide an edge is */

// A path through points.
/** @param {CanvasRenderingContext2D} context @param {number[][]} points */
export function trace(context, points) {
  context.beginPath();
  points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
}

// The present path, filled and then drawn.
/** @param {CanvasRenderingContext2D} context @param {Look} look */
export function ink(context, { fill, edge, width = 1.3, dash = [] }) {
  if (fill) {
    context.fillStyle = fill;
    context.fill();
  }
  if (!edge) return;
  Object.assign(context, { strokeStyle: edge, lineWidth: width, lineJoin: "round" });
  context.setLineDash(dash);
  context.stroke();
  context.setLineDash([]);
}

/** @param {CanvasRenderingContext2D} context @param {number[][]} points @param {string} edge */
export function line(context, points, edge, width = 1, /** @type {number[]} */ dash = []) {
  trace(context, points);
  ink(context, { edge, width, dash });
}

/** @param {CanvasRenderingContext2D} context @param {number[][]} points @param {Look} look */
export function shape(context, points, look) {
  trace(context, points);
  context.closePath();
  ink(context, look);
}

/** @param {CanvasRenderingContext2D} context @param {number[]} place @param {number} radius @param {Look} look */
export function dot(context, [x, y], radius, look) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  ink(context, look);
}
