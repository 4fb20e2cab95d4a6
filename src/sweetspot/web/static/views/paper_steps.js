// The paper's questions in its order: claim, formulas as they should read, misprints, controls, and the answer in words.

import { FILLS } from "../bat/bench.js";
import { choice, slider } from "../controls/controls.js";
/** @import { App } from "../shell/main.js" */

const FILLED = FILLS.filter(([fill]) => fill !== "nothing");
const HELD = [["floor", "lying on concrete"], ["clamped", "clamped at the edges"], ["free", "lying free"]];

/**
 * One question of the paper.
 * @typedef {object} Asked
 * @property {keyof typeof import("./paper_pictures.js").PICTURES} key
 * @property {string} title
 * @property {string} question
 * @property {string[]} claim
 * @property {[string, string, string][]} formulas  number of the paper's, source, what it is of
 * @property {(app: App) => HTMLElement[]} controls
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
  },
  {
    key: "verdict", title: "The answer", question: "So where does a bat hit best?",
    claim: [
      "The best place is not the end; it lies between the end and S from it. Solid wood suits the game better.",
      "Air resistance is left out, which is said to matter little. The model should help to train players, and serve table tennis, badminton and other sports with other coefficients.",
    ],
    formulas: [], slips: [],
    controls: () => [],
  },
];
