// A bat drawn to scale, lying along the charts' axis: sweet spots, zone, balance point, hands and the ball.
//
//   const picture = new BatView(app, { onBall(position_m, { last }) {}, onStations(stations, { last }) {} });
//   root.append(picture.element);
//   picture.draw({ bat, sweet_spots, hands_m, ball: { position_m, radius_m } });   // bat as in web/outline.py
//   picture.drawing = true;     // the outline's stations can be dragged
//   paintBat(context, bat, place, colors)   // the bat alone; place = { left, scale, middle } in pixels and pixels per m
//
// In onStations, stations are [{ position_m, diameter_m }]. Everything but drawing stations has a control of its own.

import { LEFT, RIGHT } from "./chart.js";
import { FONT, Surface, haloText } from "./surface.js";
import { text } from "./units.js";

export const SPOTS = {
  max_exit_speed_m: ["fastest ball", "red"],
  max_collision_efficiency_m: ["greatest efficiency q", "orange"],
  min_sting_m: ["least sting", "purple"],
  node_1_m: ["node of mode 1", "sky"],
  node_2_m: ["node of mode 2", "blue"],
  center_of_percussion_m: ["centre of percussion", "green"],
};
const ROW = 17, ROOM_BELOW = 30, HANDLE = 5;
const NARROW = 500; // pixels per m below which there is no room for words under the bat
const WIDEST = 0.076; // m; room for the barrel and the ball is kept, so that the picture does not jump

export class BatView {
  constructor(app, { onBall = null, onStations = null, label = "The bat, drawn to scale" } = {}) {
    Object.assign(this, { app, onBall, onStations, drawing: false, data: null, held: null });
    this.surface = new Surface(app, { label, height: (width) => this.tall(width), paint: (...all) => this.paint(...all) });
    this.element = this.surface.element;
    if (onBall) this.listen();
  }

  draw(data) {
    this.data = data;
    this.surface.draw();
  }
  figure(name) { return this.surface.figure(name); }
  label(words) { this.surface.label(words); }

  scaleAt(width) { return (width - LEFT - RIGHT) / (this.data?.bat.length_m ?? 0.84); }
  tall(width) {
    const rows = this.data?.sweet_spots ? Object.keys(SPOTS).length * ROW + 10 : 8;
    return rows + (WIDEST + (this.data?.ball ? 2 * this.data.ball.radius_m : 0)) * this.scaleAt(width) + ROOM_BELOW;
  }
  place(width) {
    const rows = this.data.sweet_spots ? Object.keys(SPOTS).length * ROW + 10 : 8;
    const scale = this.scaleAt(width);
    return { left: LEFT, scale, middle: rows + (WIDEST / 2) * scale };
  }

  listen() {
    this.element.style.cursor = "grab";
    this.surface.drags(({ x, y, first, last }) => {
      if (!this.data) return false;
      const { left, scale, middle } = this.place(this.surface.width);
      if (first) this.held = this.drawing ? this.stationAt(x, y) : null;
      const along = (x - left) / scale;
      if (this.held !== null) this.dragStation(this.held, along, (2 * Math.abs(y - middle)) / scale, last);
      else if (!this.drawing) this.onBall(Math.min(this.data.bat.length_m, Math.max(0, along)), { last });
      return true;
    });
  }

  stationAt(x, y) {
    const { left, scale, middle } = this.place(this.surface.width);
    const far = this.data.bat.stations.map(({ position_m, diameter_m }) =>
      Math.hypot(x - left - position_m * scale, Math.abs(y - middle) - (diameter_m / 2) * scale));
    const nearest = far.indexOf(Math.min(...far));
    return far[nearest] < 24 ? nearest : null;
  }

  dragStation(index, along, width, last) {
    const stations = this.data.bat.stations.map((station) => ({ ...station }));
    const inner = index > 0 && index < stations.length - 1;
    const [before, after] = [stations[index - 1]?.position_m, stations[index + 1]?.position_m];
    if (inner) stations[index].position_m = Math.min(after - 0.002, Math.max(before + 0.002, along));
    stations[index].diameter_m = Math.min(0.07, Math.max(0.015, width));
    this.onStations(stations, { last });
  }

  paint(context, width) {
    if (!this.data) return;
    const { colors } = this.app;
    const { bat, sweet_spots: spots, hands_m: hands, ball } = this.data;
    const place = this.place(width);
    const across = (x) => place.left + x * place.scale;
    const bottom = place.middle + (WIDEST / 2 + (ball ? 2 * ball.radius_m : 0)) * place.scale;
    if (spots?.zone_m) this.paintZone(context, spots.zone_m, across, place, bottom);
    paintBat(context, bat, place, colors);
    this.paintBelow(context, bat, hands, across, place);
    if (ball) paintBall(context, ball, bat, place, colors);
    if (ball && ball.offset_m !== undefined) paintMeeting(context, ball, bat, place, colors);
    if (spots) this.paintSpots(context, spots, bat, across, place);
    if (this.drawing) this.paintStations(context, bat, across, place);
  }

  paintZone(context, [from, to], across, place, bottom) {
    const { colors } = this.app;
    const top = place.middle - (WIDEST / 2) * place.scale;
    context.fillStyle = colors.zone;
    context.fillRect(across(from), top, across(to) - across(from), bottom - top + 8);
    const y = bottom + 8;
    context.strokeStyle = colors.zoneEdge;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(across(from), y);
    context.lineTo(across(to), y);
    context.stroke();
    context.font = `600 12px ${FONT}`;
    context.textAlign = "right";
    context.textBaseline = "top";
    context.fillStyle = colors.zoneInk;
    context.fillText(`sweet zone ${this.app.text("zone_m", to - from, 1)}`, across(to), y + 4);
  }

  paintBelow(context, bat, hands, across, place) {
    const { colors } = this.app;
    const radius = (x) => (radiusAt(bat, x) * place.scale);
    context.font = `11px ${FONT}`;
    context.textAlign = "center";
    context.textBaseline = "top";
    if (hands) {
      context.strokeStyle = colors.muted;
      context.lineWidth = 1.5;
      context.setLineDash([2, 2]);
      for (const hand of hands) {
        context.beginPath();
        context.moveTo(across(hand), place.middle - radius(hand) - 6);
        context.lineTo(across(hand), place.middle + radius(hand) + 6);
        context.stroke();
      }
      context.setLineDash([]);
      context.fillStyle = colors.muted;
      context.fillText("hands", across((hands[0] + hands[1]) / 2), place.middle + radius(hands[0]) + 10);
    }
    if (bat.balance_point_m === undefined) return;
    const [x, y] = [across(bat.balance_point_m), place.middle + radius(bat.balance_point_m) + 2];
    context.fillStyle = colors.ink;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x - 5, y + 9);
    context.lineTo(x + 5, y + 9);
    context.closePath();
    context.fill();
    if (place.scale < NARROW) return;
    context.fillStyle = colors.muted;
    context.fillText(`balance ${text("balance_point_m", bat.balance_point_m, this.app.units, 1)}`, x, y + 12);
  }

  // Names on the left, each with a line that runs level and then down to its place; the nearest place lowest, so
  // that no line crosses another.
  paintSpots(context, spots, bat, across, place) {
    const { colors } = this.app;
    const found = Object.entries(SPOTS).map(([key, [name, color]]) => ({ name, color, at: spots[key] })).filter(({ at }) => at !== null);
    found.sort((a, b) => b.at - a.at);
    const column = across(found.at(-1)?.at ?? 0) - 14;
    context.textBaseline = "middle";
    found.forEach(({ name, color, at }, row) => {
      const [x, y] = [across(at), 12 + row * ROW];
      const dot = place.middle + radiusAt(bat, at) * place.scale * (0.72 - (1.44 * row) / Math.max(1, found.length - 1)) * -1;
      context.strokeStyle = colors[color];
      context.lineWidth = 1.4;
      context.beginPath();
      context.moveTo(column, y);
      context.lineTo(x, y);
      context.lineTo(x, dot);
      context.stroke();
      context.fillStyle = colors[color];
      context.strokeStyle = colors.panel;
      context.beginPath();
      context.arc(x, dot, 4.5, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
      context.font = `${color === "red" ? "600 " : ""}12px ${FONT}`;
      context.textAlign = "right";
      haloText(context, `${name}  ${text("spot_m", bat.length_m - at, this.app.units, 1)}`, column - 5, y, colors.ink, colors.panel);
    });
    context.font = `11px ${FONT}`;
    context.fillStyle = colors.muted;
    context.textAlign = "left";
    context.fillText("from the tip", LEFT, 12);
  }

  paintStations(context, bat, across, place) {
    const { colors } = this.app;
    for (const { position_m: position, diameter_m: diameter } of bat.stations) {
      for (const side of [-1, 1]) {
        context.fillStyle = colors.panel;
        context.strokeStyle = colors.accent;
        context.lineWidth = 2;
        context.beginPath();
        context.arc(across(position), place.middle + (side * diameter * place.scale) / 2, HANDLE, 0, 2 * Math.PI);
        context.fill();
        context.stroke();
      }
    }
  }
}

export function paintBall(context, ball, bat, place, colors) {
  const radius = ball.radius_m * place.scale;
  const x = place.left + ball.position_m * place.scale;
  const y = place.middle + radiusAt(bat, ball.position_m) * place.scale + radius;
  context.fillStyle = colors.paper;
  context.strokeStyle = colors.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.strokeStyle = colors.red;
  context.lineWidth = 1.2;
  for (const side of [-1, 1]) {
    context.beginPath();
    context.arc(x + side * 1.45 * radius, y, radius, side < 0 ? -0.72 : Math.PI - 0.72, side < 0 ? 0.72 : Math.PI + 0.72);
    context.stroke();
  }
}

// Bat and ball as seen along the bat: how far off the axis they meet, and where the ball goes.
function paintMeeting(context, ball, bat, place, colors) {
  const scale = Math.min(place.scale, 500);
  const [own, its] = [radiusAt(bat, ball.position_m) * scale, ball.radius_m * scale];
  const x = place.left + 0.3 * bat.length_m * place.scale;
  const y = place.middle + (WIDEST / 2) * place.scale + its + 4;
  const up = ball.offset_m * scale;
  const across = Math.sqrt(Math.max(0, (own + its) ** 2 - up ** 2));
  const circle = (at, height, radius, fill, edge) => {
    context.beginPath();
    context.arc(at, height, radius, 0, 2 * Math.PI);
    context.fillStyle = fill;
    context.fill();
    context.strokeStyle = edge;
    context.lineWidth = 1.3;
    context.stroke();
  };
  circle(x, y, own, bat.hollow ? colors.metal : colors.wood, bat.hollow ? colors.metalEdge : colors.woodEdge);
  circle(x + across, y - up, its, colors.paper, colors.ink);
  if (ball.launch_angle_rad !== null && ball.launch_angle_rad !== undefined) {
    const [c, s] = [Math.cos(ball.launch_angle_rad), Math.sin(ball.launch_angle_rad)];
    const [fromX, fromY, length] = [x + across, y - up, its + 26];
    context.strokeStyle = colors.red;
    context.fillStyle = colors.red;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(fromX, fromY);
    context.lineTo(fromX + length * c, fromY - length * s);
    context.stroke();
    context.beginPath();
    context.moveTo(fromX + (length + 7) * c, fromY - (length + 7) * s);
    context.lineTo(fromX + length * c - 4 * s, fromY - length * s - 4 * c);
    context.lineTo(fromX + length * c + 4 * s, fromY - length * s + 4 * c);
    context.closePath();
    context.fill();
  }
  if (place.scale < NARROW) return;
  context.font = `11px ${FONT}`;
  context.fillStyle = colors.muted;
  context.textAlign = "right";
  context.textBaseline = "middle";
  context.fillText("along the bat", x - own - 8, y);
}

export function radiusAt(bat, x) {
  const { position_m: places, diameter_m: widths } = bat.outline;
  let i = places.findIndex((place) => place >= x);
  if (i < 0) i = places.length - 1;
  if (i === 0) return widths[0] / 2;
  const part = (x - places[i - 1]) / (places[i] - places[i - 1] || 1);
  return (widths[i - 1] + part * (widths[i] - widths[i - 1])) / 2;
}

// The bat alone, cut open: wood, wall, holes, what fills them, and the cup.
export function paintBat(context, bat, { left, scale, middle }, colors) {
  const { position_m: places, diameter_m: widths } = bat.outline;
  const points = places.map((place, i) => [left + place * scale, (widths[i] / 2) * scale]);
  context.beginPath();
  points.forEach(([x, r]) => context.lineTo(x, middle - r));
  [...points].reverse().forEach(([x, r]) => context.lineTo(x, middle + r));
  context.closePath();
  context.fillStyle = bat.hollow ? colors.metal : colors.wood;
  context.fill();
  if (bat.hollow) paintInside(context, bat, points, { scale, middle }, colors);
  for (const bore of bat.bores) paintBore(context, bore, { left, scale, middle }, colors);
  if (bat.cup) paintCup(context, bat, { left, scale, middle }, colors);
  context.beginPath();
  points.forEach(([x, r]) => context.lineTo(x, middle - r));
  [...points].reverse().forEach(([x, r]) => context.lineTo(x, middle + r));
  context.closePath();
  context.strokeStyle = bat.hollow ? colors.metalEdge : colors.woodEdge;
  context.lineWidth = 1.3;
  context.lineJoin = "round";
  context.stroke();
  for (const weight of bat.weights) {
    context.fillStyle = colors.ink;
    context.beginPath();
    context.arc(left + weight.position_m * scale, middle, 4, 0, 2 * Math.PI);
    context.fill();
  }
}

function paintInside(context, bat, points, { scale, middle }, colors) {
  context.beginPath();
  const inner = points.map(([x, r], i) => [x, Math.max(0, r - bat.wall_m[i] * scale)]);
  inner.forEach(([x, r]) => context.lineTo(x, middle - r));
  [...inner].reverse().forEach(([x, r]) => context.lineTo(x, middle + r));
  context.closePath();
  context.fillStyle = colors.hollow;
  context.fill();
}

function paintBore(context, bore, { left, scale, middle }, colors) {
  const [x, y] = [left + bore.start_m * scale, middle - (bore.diameter_m / 2) * scale];
  const [width, height] = [(bore.stop_m - bore.start_m) * scale, bore.diameter_m * scale];
  context.fillStyle = colors.hollow;
  context.fillRect(x, y, width, height);
  if (bore.fill) {
    context.save();
    context.globalAlpha = 0.5;
    context.fillStyle = colors.orange;
    context.fillRect(x, y, width, height);
    context.restore();
  }
  context.strokeStyle = colors.woodEdge;
  context.lineWidth = 1;
  context.setLineDash([3, 2]);
  context.strokeRect(x, y, width, height);
  context.setLineDash([]);
}

function paintCup(context, bat, { left, scale, middle }, colors) {
  const tip = left + bat.length_m * scale;
  const [radius, depth] = [(bat.cup.diameter_m / 2) * scale, bat.cup.depth_m * scale];
  context.beginPath();
  context.moveTo(tip, middle - radius);
  for (let i = -10; i <= 10; i += 1) context.lineTo(tip - depth * (1 - (i / 10) ** 2), middle + (radius * i) / 10);
  context.closePath();
  context.fillStyle = colors.panel;
  context.fill();
  context.strokeStyle = colors.woodEdge;
  context.stroke();
}
