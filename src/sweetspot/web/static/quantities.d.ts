// The module that the server writes from the package's own table (report/quantity_table.py).

/** What is shown of a stored value is value * scale + offset, with so many digits and the unit behind it. */
export interface Shown { unit: string; scale: number; offset: number; digits: number }
export interface Kind { us: Shown; si: Shown }

declare const table: {
  scales: Record<string, Kind>;
  endings: Record<string, Kind>;
  quantities: Record<string, { label: string; scale: string; colour: string | null }>;
  spots: Record<string, { label: string; colour: string | null }>;
  palette: Record<string, string>;
  reach: number;
};
export default table;
