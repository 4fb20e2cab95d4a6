// Own bat: its fields of what was measured, as they are before anything is.

/** @import { State } from "../shell/main.js" */

/** @type {Partial<State>} */
export const FORGOTTEN = { weighed_oz: null, balanced_in: null, pendulum_ms: null, swing_weight_oz_in2: null, tones: [], damping: null, left_out: [] };
