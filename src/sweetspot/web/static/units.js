// Units by the ending of a name, in both systems: what is shown is value * scale + offset.

export const INCH = 0.0254, OUNCE = 0.028349523125, MPH = 0.44704;
const FOOT = 0.3048, POUND = 4.4482216152605;
const same = (unit, scale = 1, digits = 2) => ({ us: { unit, scale, digits }, si: { unit, scale, digits } });

// Longest endings first. The second half are endings of answers, which are SI.
const ENDINGS = [
  ["_from_tip_in", { us: { unit: "in", scale: 1, digits: 2 }, si: { unit: "cm", scale: 2.54, digits: 1 } }],
  ["_mph", { us: { unit: "mph", scale: 1, digits: 1 }, si: { unit: "m/s", scale: MPH, digits: 1 } }],
  ["_in", { us: { unit: "in", scale: 1, digits: 2 }, si: { unit: "cm", scale: 2.54, digits: 1 } }],
  ["_ft", { us: { unit: "ft", scale: 1, digits: 0 }, si: { unit: "m", scale: FOOT, digits: 1 } }],
  ["_oz", { us: { unit: "oz", scale: 1, digits: 1 }, si: { unit: "g", scale: 1000 * OUNCE, digits: 0 } }],
  ["_degf", { us: { unit: "°F", scale: 1, digits: 0 }, si: { unit: "°C", scale: 5 / 9, offset: -160 / 9, digits: 0 } }],
  ["_degc", { us: { unit: "°F", scale: 1.8, offset: 32, digits: 0 }, si: { unit: "°C", scale: 1, digits: 0 } }],
  ["_deg", same("°", 1, 1)],
  ["_rpm", same("rpm", 1, 0)],
  ["_inhg", { us: { unit: "inHg", scale: 1, digits: 2 }, si: { unit: "hPa", scale: 33.86389, digits: 0 } }],
  ["_kg_m3", { us: { unit: "lb/ft³", scale: 0.06242796, digits: 4 }, si: { unit: "kg/m³", scale: 1, digits: 3 } }],
  ["_humidity", same("%", 100, 0)],
  ["_kg_m2", { us: { unit: "oz in²", scale: 1 / (OUNCE * INCH * INCH), digits: 0 }, si: { unit: "kg m²", scale: 1, digits: 4 } }],
  ["_m_s", { us: { unit: "mph", scale: 1 / MPH, digits: 1 }, si: { unit: "m/s", scale: 1, digits: 2 } }],
  ["_rad_s", same("rpm", 30 / Math.PI, 0)],
  ["_n_s", { us: { unit: "lbf s", scale: 1 / POUND, digits: 2 }, si: { unit: "N s", scale: 1, digits: 2 } }],
  ["_kg", { us: { unit: "oz", scale: 1 / OUNCE, digits: 1 }, si: { unit: "g", scale: 1000, digits: 0 } }],
  ["_rad", same("°", 180 / Math.PI, 1)],
  ["_hz", same("Hz", 1, 0)],
  ["_pct", same("%", 1, 1)],
  ["_j", same("J", 1, 1)],
  ["_n", { us: { unit: "lbf", scale: 1 / POUND, digits: 0 }, si: { unit: "kN", scale: 1e-3, digits: 2 } }],
  ["_ms", same("ms", 1, 2)],
  ["_s", same("ms", 1000, 2)],
  ["_m", { us: { unit: "in", scale: 1 / INCH, digits: 2 }, si: { unit: "cm", scale: 100, digits: 1 } }],
];
const RATIO = same("", 1, 3);
// Long distances and times of flights end in _m and _s too; a view names them so.
export const KINDS = {
  distance: { us: { unit: "ft", scale: 1 / FOOT, digits: 0 }, si: { unit: "m", scale: 1, digits: 1 } },
  seconds: same("s", 1, 2),
  sting: { us: { unit: "in/s", scale: 1 / INCH, digits: 0 }, si: { unit: "m/s", scale: 1, digits: 2 } },
  ratio: RATIO,
  share: same("%", 100, 0),
};

// The kind of a name like pitch_speed_mph, or of a word in KINDS.
export function kindOf(name) {
  if (Object.hasOwn(KINDS, name)) return KINDS[name];
  const ending = ENDINGS.find(([end]) => name.endsWith(end));
  return ending ? ending[1] : RATIO;
}

export function unitOf(name, system) {
  return kindOf(name)[system].unit;
}

// A stored value as the number that is shown, and back.
export function toShown(name, value, system) {
  const { scale, offset = 0 } = kindOf(name)[system];
  return value * scale + offset;
}

export function fromShown(name, shown, system) {
  const { scale, offset = 0 } = kindOf(name)[system];
  return (shown - offset) / scale;
}

// "93.1 mph"; a dash where there is no number.
export function text(name, value, system, digits = kindOf(name)[system].digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const { unit } = kindOf(name)[system];
  const shown = toShown(name, value, system).toFixed(digits).replace(/^-(0(\.0*)?)$/, "$1").replace("-", "−");
  return unit === "" ? shown : `${shown}${unit === "%" || unit.startsWith("°") ? "" : " "}${unit}`;
}
