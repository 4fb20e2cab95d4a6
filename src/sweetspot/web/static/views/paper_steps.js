// The paper's questions in its order: claim, formulas as they should read, misprints, controls, and the answer in words.

import { FILLS } from "../bat/bench.js";
import { MPH } from "../controls/units.js";
import { choice, slider } from "../controls/controls.js";
/** @import { Answer, App, State } from "../shell/main.js" */

const FILLED = FILLS.filter(([fill]) => fill !== "nothing");
const HELD = [["floor", "lying on concrete"], ["clamped", "clamped at the edges"], ["free", "lying free"]];
const number = (/** @type {number} */ value, /** @type {number} */ digits) => value.toFixed(digits).replace("-", "−");
const rowsOf = (/** @type {Answer} */ answer, /** @type {string} */ equation) => answer.rows.filter((/** @type {Answer} */ row) => row.equation === equation);
/** @type {(answer: Answer, place: number, app: App) => string} */
const fromTip = (answer, place, app) => app.text("from_m", answer.bat.length_m - place, 1);

// A place at the tip's end of the bat, or beyond it, where the hands are held high.
/** @type {(length: number, place: number, app: App) => string} */
const tipwards = (length, place, app) => `${app.text("from_m", Math.abs(length - place), 1)} ${place > length ? "beyond" : "from"} the tip`;

/**
 * One question of the paper.
 * @typedef {object} Asked
 * @property {keyof typeof import("./paper_pictures.js").PICTURES} key
 * @property {string} title
 * @property {string} question
 * @property {string[]} claim
 * @property {[string, string, string][]} formulas  number of the paper's, source, what it is of
 * @property {(app: App) => HTMLElement[]} controls
 * @property {(answer: Answer, state: State, app: App) => string[]} live  formulas with the numbers of now
 * @property {(answer: Answer, state: State, app: App) => string} truth
 * @property {string[]} slips
 */

/** @type {Asked[]} */
export const STEPS = [
  {
    key: "end", title: "Why not the end?", question: "Why is the best place to hit not the end of the bat?",
    claim: [
      "If ball and bat moved on as one (a plastic hit), the ball would not shift along the bat, and the best place would be its end.",
      "If the hit lost no energy (an elastic one), a ball that comes in at an angle α would slide along the bat by S before it leaves. Real hits lie between, so the best place lies between the end and S from it.",
    ],
    formulas: [
      ["1", "F cos α = m_0 a_0", "along the ball's path"], ["2", "F sin α = m_0 { v_1^2 | r }", "across it"],
      ["3", "v_along = v_1 sin α", "along the bat"], ["4", "v_across = v_1 cos α", "across the bat"],
    ],
    slips: [
      "Equations 3 and 4 print the same symbol for the two parts of the speed.",
      "α is the entry angle here, and an angular acceleration in equations 5 and 6. ω is called an acceleration in the list of symbols.",
    ],
    controls: (app) => [slider(app, "entry_angle_deg", { label: "Entry angle α", step: 1 })],
    live({ picture }, state, app) {
      const show = (/** @type {number} */ length) => app.text("s_m", length, 2);
      return [`0 ≤ S ≤ v_1 sin α T = ${show(picture.elastic_travel_m)}`, `S_real = ${show(picture.travel_m)}`];
    },
    truth(answer, state, app) {
      const { best_m: best, travel_m: travel, exit_speed_m_s: speeds, rigid_exit_speed_m_s: rigid } = answer.picture;
      const show = (/** @type {number} */ value) => app.text("exit_speed_m_s", value);
      return `The ball does shift, by ${app.text("travel_m", travel, 2)}, but it is hit best ${fromTip(answer, best, app)} from the tip: S is far too short ` +
        `to explain it. The conclusion is right for another reason. At the tip even a rigid bat gives way by turning (${show(rigid.at(-1))}), ` +
        `and the real one also bends and keeps that energy (${show(speeds.at(-1))}); at its best place it gives ${show(Math.max(...speeds))}.`;
    },
  },
  {
    key: "percussion", title: "Where is it, then?", question: "Where is the best place to hit?",
    claim: [
      "The bat is a thin rod, struck at E with the impulse I and held at D. Where the hands feel no force, at the centre of percussion, is the best place.",
      "When the hands move away from the mass centre, the best place moves closer to it.",
    ],
    formulas: [
      ["5", "( J_C + m l^2 ) α = ( l + x ) I", "turning about the hands"], ["7", "I − F = m a_c", "moving the mass centre"],
      ["9", "{ F | I } = { J_C − m x l | J_C + m l^2 }", "force of the hands over the blow"],
      ["10", "x = { J_C | m l }", "beyond the mass centre"], ["11", "b = l + x = { J_D | m l }", "from the hands"],
      ["12", "J_D = J_C + m l^2", "parallel axes"],
    ],
    slips: [
      "In equations 5 to 9 and 11 the printed 1 + x is l + x: from the hands D to the mass centre C it is l, from there to the blow x.",
      "J_C is called the inertia “of the ball”; it is the bat's. The list of symbols has J_E where the text has J_D.",
      "The baseball is called a thin rod; the bat is meant. F is now the force of the hands, before it was that of the bat on the ball.",
    ],
    controls: (app) => [
      slider(app, "rod_hands_in", { label: "Rod held, from its end", step: 0.25 }),
      slider(app, "hands_moved_in", { label: "Hands moved up the handle by", step: 0.25 }),
    ],
    live(answer, state, app) {
      const { rod_percussion_m: rod, rod_hands_m: held } = answer.picture;
      return [`b_rod = ${app.text("b_m", rod - held, 1)}`, `b_bat = ${app.text("b_m", answer.picture.bat_percussion_m - answer.picture.hands_m, 1)}`];
    },
    truth(answer, state, app) {
      const { bat_percussion_m: place, best_m: best, moved_percussion_m: moved, rod_percussion_m: rod } = answer.picture;
      const length = answer.bat.length_m;
      const gap = best > place ? "further out" : "further in";
      return `The mechanics hold for any rigid bat. Held as here, the rod's centre of percussion lies ${tipwards(length, rod, app)}, ` +
        `this bat's ${tipwards(length, place, app)}, and when the hands move up, ${tipwards(length, moved, app)}. But it is the place where the top hand feels ` +
        `no jolt, not the place where the ball leaves fastest: that is ${app.text("from_m", length - best, 1)} from the tip, ` +
        `${app.text("gap_m", Math.abs(best - place), 1)} ${gap}, and it hardly moves with the hands.`;
    },
  },
  {
    key: "corking", title: "Does corking help?", question: "Why does Major League baseball forbid corked bats?",
    claim: [
      "A hollowed bat (or one filled with cork or rubber) weighs less and is pressed in further. So the force between bat and ball grows, contact lasts longer, and the ball leaves faster.",
    ],
    formulas: [["13", "F = k x", "Hooke's law"], ["14", "F t = m ( v_2 − v_1 )", "momentum"]],
    slips: ["k is a spring constant here, and a restitution in the formula for W.", "A softer bat has a larger x and a smaller k; F need not grow."],
    controls: (app) => [
      slider(app, "hole_diameter_in", { label: "Hole, width", step: 0.05 }),
      slider(app, "hole_depth_in", { label: "Hole, depth from the tip", step: 0.25 }),
      choice(app, "hole_fill", { label: "Filled with", options: FILLED }),
    ],
    live(answer, state, app) {
      const [[momentum], [plain, corked]] = [rowsOf(answer, "14"), rowsOf(answer, "13").slice(-2)];
      const show = (/** @type {number} */ thousands) => app.text("f_n", 1e3 * thousands);
      return [`m ( v_2 − v_1 ) = ${app.text("p_n_s", momentum.computed)}`, `F_plain = ${show(plain.full_model)} , F_corked = ${show(corked.full_model)}`];
    },
    truth(answer, state, app) {
      const [forces, others] = [rowsOf(answer, "13").slice(-2), rowsOf(answer, "14").slice(-4)]; // each of the plain bat, then of the corked one
      const [[before, after], [long, longer, fast, faster]] = [forces, others].map((rows) => rows.map((/** @type {Answer} */ row) => row.full_model));
      const change = (faster - fast) * MPH;
      const grows = after > before + 0.005 ? "grows" : "does not grow";
      return `The force ${grows}: ${app.text("f_n", 1e3 * before)} for the plain bat, ${app.text("f_n", 1e3 * after)} for the corked one. ` +
        `Contact lasts ${number(long, 3)} and ${number(longer, 3)} ms. At the same bat speed the ball leaves ` +
        `${app.text("change_m_s", Math.abs(change))} ${change < 0 ? "slower" : "faster"}. What drilling changes is the weight: a lighter barrel is pushed back more. ` +
        "Whether the lighter bat is swung enough faster to make up for it is the player's matter; the view Compare answers it.";
    },
  },
  {
    key: "drop", title: "The drop experiment", question: "What does a ball dropped on wood and metal show?",
    claim: [
      "Blocks of wood and metal of the same size lie side by side, and the same ball is dropped on them from the same height. It comes back higher from metal, so metal has the greater elastic energy, and a metal bat hits faster.",
    ],
    formulas: [["", "m g Δ H = E_D", "Figure 6: the height that is lost"]],
    slips: ["E_D is called an elastic energy. What the lost height measures is the energy that is lost."],
    controls: (app) => [
      slider(app, "drop_height_m", { label: "Height of the fall", step: 0.02 }),
      slider(app, "block_thickness_m", { label: "Thickness of the blocks", step: 0.001 }),
      choice(app, "block_support", { label: "The blocks are", options: HELD }),
    ],
    live(answer) {
      const { wood, metal, drop_height_m: height } = answer.picture;
      const lost = (/** @type {Answer} */ one) => (one.rebound_m === null ? "?" : `${number(9.80665 * answer.conditions.ball_mass_kg * (height - one.rebound_m), 3)} J`);
      return [`E_wood = ${lost(wood)} , E_metal = ${lost(metal)}`];
    },
    truth(answer, state, app) {
      const { wood, metal } = answer.picture;
      const show = (/** @type {{ rebound_m: number }} */ { rebound_m: back }) => (back === null ? "no height, for it does not come off in one contact" : app.text("rebound_m", back, 1));
      const thick = state.block_support === "floor" || state.block_thickness_m > 0.02;
      return `From wood the ball comes back to ${show(wood)}, from metal to ${show(metal)}. ` + (thick
        ? "On a thick block nearly all of the loss is in the ball, and the two hardly differ: the experiment measures the ball. Clamp the blocks and make them as thin as a bat's wall to see a trampoline."
        : "A thin, clamped plate is a trampoline: it takes energy that the ball would lose, and gives it back in time. That is what a metal bat's wall does, and what a thick block cannot show.");
    },
  },
  {
    key: "energy", title: "Why not metal?", question: "Why does Major League baseball forbid metal bats?",
    claim: [
      "Of the energy of the collision the bat stores the share z and returns k² of it; the ball stores the rest. With k₀ = k₁ = 0.45, k₂ = 0.9, z₁ = 2 % and z₂ = 10 % wood returns 20 %, metal 26 %. So the ball leaves a metal bat faster.",
    ],
    formulas: [["", "W_i = k_i^2 z_i + k_0^2 ( 1 − z_i )", "i = 1 wood, 2 metal"]],
    slips: ["z is called a ratio of deformations; as used it is the bat's share of the stored energy.", "W is e², the square of the restitution of the pair, not a ratio of speeds."],
    controls: (app) => [
      slider(app, "ball_restitution", { label: "k₀, restitution of the ball", step: 0.01 }),
      slider(app, "wood_restitution", { label: "k₁, of wood", step: 0.01 }),
      slider(app, "wood_share", { label: "z₁, share of wood", step: 0.005 }),
      slider(app, "metal_restitution", { label: "k₂, of metal", step: 0.01 }),
      slider(app, "metal_share", { label: "z₂, share of metal", step: 0.005 }),
    ],
    live(answer, { ball_restitution: k0, wood_restitution: k1, metal_restitution: k2, wood_share: z1, metal_share: z2 }) {
      const line = (/** @type {number} */ i, /** @type {number} */ k, /** @type {number} */ z) => `W_${i} = ${number(k, 2)}^2 · ${number(z, 3)} + ${number(k0, 2)}^2 · ${number(1 - z, 3)} = ${number(k * k * z + k0 * k0 * (1 - z), 4)}`;
      return [line(1, k1, z1), line(2, k2, z2)];
    },
    truth(answer, state, app) {
      const [wood, metal] = rowsOf(answer, "W");
      const [, thickness] = rowsOf(answer, "z");
      return `The formula is exact for two springs in series: e = √W is ${number(Math.sqrt(wood.computed), 3)} for wood and ${number(Math.sqrt(metal.computed), 3)} for metal here. ` +
        `The full model gives ${number(wood.full_model, 3)} for this bat, and ${number(metal.full_model, 3)} for an aluminium bat whose wall takes a tenth of the energy: ` +
        `one ${app.units === "us" ? app.text("wall_m", thickness.full_model / 1e3, 3) : `${number(thickness.full_model, 1)} mm`} thick. A metal bat does hit faster. The dotted line joins aluminium bats with thicker (left) and thinner (right) walls.`;
    },
  },
  {
    key: "verdict", title: "The answer", question: "So where does a bat hit best?",
    claim: [
      "The best place is not the end; it lies between the end and S from it. Solid wood suits the game better.",
      "Air resistance is left out, which is said to matter little. The model should help to train players, and serve table tennis, badminton and other sports with other coefficients.",
    ],
    formulas: [], slips: [],
    controls: () => [],
    live: () => [],
    truth(answer, state, app) {
      const { best_m: best, zone_m: zone } = answer.picture;
      return `${answer.bat.name} hits fastest ${fromTip(answer, best, app)} from the tip` +
        (zone ? `, and hits fast and quietly from ${fromTip(answer, zone[1], app)} to ${fromTip(answer, zone[0], app)}. ` : ". ") +
        "“Sweet spot” has at least six meanings, each with its own place: they differ because the ball asks for speed, the hands for quiet. " +
        "And air matters a great deal to a batted ball: the view Flight shows by how much. Other sports need other balls, other faces and other rules, not only other coefficients: the command sweetspot sports has them.";
    },
  },
];
