// The shape of the module that `web/offline/kernel_module.py` translates from the solver's Python.

export type Rows = ArrayLike<number>[];
export type Bat = { shapes: Rows, give: ArrayLike<number>, omega: number[], step_give: number[], drift: number[][][], dashpots: number[][], half_dash: number[] };
export type Ball = { mass: number, stiffness: number, exponent: number, damping: number, restitution: object };
export type Output = { outcome: Float64Array, results: Float64Array[], motion: Float64Array[][] };
export type Lanes = { state: Float64Array[], displacement: Float64Array[], velocity: Float64Array[] };
export function solve(lanes: number, closing: ArrayLike<number>, bat: Bat, ball: Ball, steps: { step: number, first_kick: number, limit: number }, output: Output, watch?: ((lanes: Lanes) => void) | null): void;
export function free_restitution(ball: Ball, closing: number, recoil: number): number;
export function collision_efficiency(restitution: number, recoil: number): number;
export function exit_speed(efficiency: number, ball_speed: number, bat_speed: number): number;
export function restitution_from_efficiency(efficiency: number, recoil: number): number;
export function vertex(before: number, middle: number, after: number): [number, number];
export const EFFICIENCY: number, CONTACT_TIME: number, RELEASE_TIME: number, GREATEST_FORCE: number, GREATEST_COMPRESSION: number, TOUCHES: number, LATE: number;
export const RESULT_ROWS: number, SEPARATED: number, NO_CONTACT: number;
export const KICKS: number, TOTAL: number, FORCE: number, OFFSET: number, POWER: number, BALL_POSITION: number, BALL_SPEED: number;
export const NARROWEST: number, ZONE_LOSS: number, ZONE_STING: number, NEAR_BEST: number, LITTLE: number, ARRIVAL: number, DURATION: number, FREE_FRAMES: number, REACH: number;
