// What the views take and answer. Written by tools/answer_types.py; do not edit.

/** The controls of every view. */
export interface States {
  start: StartState;
  explorer: ExplorerState;
  hit: HitFilmState;
  modes: ModesState;
  own: OwnState;
  compare: CompareState;
  design: DesignState;
  player: PlayerState;
  flight: FlightState;
  optimum: OptimumState;
  season: SeasonState;
  paper: PaperState;
  sports: SportsState;
}

/** What every view answers. */
export interface Answers {
  start: StartAnswer;
  explorer: ExplorerAnswer;
  hit: FilmAnswer;
  modes: ModesAnswer;
  own: OwnAnswer;
  compare: ComparisonPicture;
  design: DesignPicture;
  player: ReadSwings;
  flight: FlownBall | MissedBall;
  optimum: LaunchAnswer;
  season: SeasonPicture;
  paper: PaperPicture;
  sports: SportsPicture;
}

/** What is asked apart, by view and name. */
export interface Asides {
  start: {  };
  explorer: { map: PowerMap; why: ReportWords; standing: BatStanding | null; sure: ReadDocument; file: OneFile; };
  hit: { sure: ReadDocument; };
  modes: {  };
  own: { tap: HeardTaps; file: WrittenBat; };
  compare: { intervals: SureComparison; rules: CertifiedBats; sure: ReadDocument; rules_sure: ReadDocument; };
  design: { gain: DesignWorth; files: DesignFiles; batter: BatterControls; };
  player: { fit: ReadDocument; table: SwingTable; };
  flight: { map: CarryMap; fences: Fences; space: HitInSpace | null; sure: ReadDocument; };
  optimum: { swing: ReadDocument; parks: ReadDocument; };
  season: { summary: SeasonWords; maps: SeasonMaps; player: ReadDocument | null; contacts: BatterControls; };
  paper: {  };
  sports: { face: SportsFace; sentences: SportsWords; file: OneFile; };
}

/** What long work gives, by view and name. */
export interface Jobs {
  start: {  };
  explorer: {  };
  hit: {  };
  modes: {  };
  own: {  };
  compare: {  };
  design: { search: FrontProgress; };
  player: {  };
  flight: {  };
  optimum: {  };
  season: { read: SeasonReading; };
  paper: {  };
  sports: {  };
}

/** The lists of the catalogue. */
export interface Catalogue {
  bats: BatFacts[];
  implements: Tool[];
  balls: Choice[];
  materials: string[];
  leagues: Choice[];
  parks: Choice[];
  pitches: Choice[];
  terms: Meaning[];
  questions: Form[];
}

/** A question of the paper: its claims, its formulas as they should read, and its misprints. */
export interface Asked {
  question: string;
  claim: string[];
  formulas: string[];
  misprints: string[];
}

/** Part of the balls by exit speed over the greatest possible: with this bat, and by the league's formula. */
export interface BallCeilings {
  ratio: number[];
  squared_up_ratio?: number[];
  league_ratio?: number[];
}

/** How a ball leaves the bat. */
export interface BallLeaving {
  exit_speed_m_s: number; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  launch_angle_rad: number; launch_angle_low_rad?: number; launch_angle_high_rad?: number;
  spray_rad: number; spray_low_rad?: number; spray_high_rad?: number;
  backspin_rad_s: number; backspin_low_rad_s?: number; backspin_high_rad_s?: number;
  sidespin_rad_s: number; sidespin_low_rad_s?: number; sidespin_high_rad_s?: number;
  gyrospin_rad_s: number; gyrospin_low_rad_s?: number; gyrospin_high_rad_s?: number;
  height_m: number; height_low_m?: number; height_high_m?: number;
}

/** Number of balls, and their means in SI, shares from 0 to 1; None where no table tells. */
export interface BallMeans {
  balls: number | null;
  exit_speed?: number;
  ev20?: number;
  bat_speed?: number;
  squared_up?: number;
  league_squared_up?: number;
  from_best?: number;
  carry?: number;
  home_runs?: number;
  home_runs_expected?: number;
}

/** A ball's size, and the values of its controls while they have not been moved. */
export interface BallPicture {
  radius_m: number; radius_low_m?: number; radius_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  cor: number; cor_low?: number; cor_high?: number;
  humidity: number; humidity_low?: number; humidity_high?: number;
  temperature_degf: number;
}

/** Nodes of the first two bending modes nearest to the tip. */
export interface BarrelNodes {
  node_1_m: number; node_1_low_m?: number; node_1_high_m?: number;
  node_2_m: number; node_2_low_m?: number; node_2_high_m?: number;
}

/** A bat in a list; ``use`` is the heading under which people look for it. */
export interface BatFacts {
  key: string;
  name: string;
  length_m: number;
  mass_kg: number;
  balance_point_m: number;
  moi_6in_kg_m2: number;
  hollow: boolean;
  sport: string;
  use: string;
}

/** How much faster than from the first bat the ball leaves, and how probable it is that it does. */
export interface BatGain {
  label: string;
  exit_speed_gain_m_s: number; exit_speed_gain_low_m_s?: number; exit_speed_gain_high_m_s?: number;
  faster_probability: number;
}

/** One motion of the bat. */
export interface BatMotion {
  family: string;
  name: string;
  number: number;
  harmonic: number;
  axial: number | null;
  frequency_hz: number; frequency_low_hz?: number; frequency_high_hz?: number;
  damping_ratio: number | null; damping_ratio_low?: number; damping_ratio_high?: number;
  decay_s: number | null; decay_low_s?: number; decay_high_s?: number;
  nodes_m: number[];
  shape: number[];
  tap: Tapped;
}

/** A bat as `BenchBat` has it, and what is usual in its sport. */
export interface BatPicture {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  outline: DrawnOutline;
  stations: Station[];
  hollow: boolean;
  wall_m: number[] | null;
  bores: DrawnBore[];
  cup: DrawnCup | null;
  weights: DrawnWeight[];
  material: string;
  remark: Record<"si" | "us", string>;
  bounds: Record<string, [number, number]>;
  moi_6in_half_kg_m2: number; moi_6in_half_low_kg_m2?: number; moi_6in_half_high_kg_m2?: number;
  sport: string;
  usual: UsualHit;
  swung: Record<"si" | "us", string> | null;
}

/** The data of a bat's drawing to scale; ``wall`` is of a hollow bat, at the places of its outline. */
export interface BatShape {
  outline: DrawnOutline;
  stations: Station[];
  hollow: boolean;
  wall_m: number[] | null;
  bores: DrawnBore[];
  cup: DrawnCup | null;
  weights: DrawnWeight[];
  material: string;
  remark: Record<"si" | "us", string>;
}

/** Where a bat stands. */
export interface BatStanding {
  below: Record<string, string>;
  among: string;
}

/** Which bat, and what was done to it. */
export interface BatState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
}

/** The place of the tap, from the knob end, and its duration. */
export interface BatTap {
  position_m: number; position_low_m?: number; position_high_m?: number;
  duration_s: number; duration_low_s?: number; duration_high_s?: number;
}

/** The verdict of a rule on one bat, in words. */
export interface BatVerdict {
  words: Record<"si" | "us", string>;
  reason: string;
  mark: "good" | "bad" | "muted" | "";
}

/** A batter as fields of a state; what is not known is left out. */
export interface BatterControls {
  contact_in?: number;
  contact_spread_in?: number;
  contact_doubt_in?: number;
  miss_in?: number;
  miss_spread_in?: number;
  bat_speed_mph?: number;
  pitch_speed_mph?: number;
}

/** A bat: its facts, its shape, and how far its controls may go. */
export interface BenchBat {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  outline: DrawnOutline;
  stations: Station[];
  hollow: boolean;
  wall_m: number[] | null;
  bores: DrawnBore[];
  cup: DrawnCup | null;
  weights: DrawnWeight[];
  material: string;
  remark: Record<"si" | "us", string>;
  bounds: Record<string, [number, number]>;
}

/** Carry, and chance of a home run, of balls hit harder and higher; rows by launch angle. */
export interface CarryMap {
  exit_speed_m_s: number[];
  launch_angle_rad: number[];
  carry_m: number[][];
  chance: number[][];
}

/** The results of a bat in the league's simulated test, and the verdict by every rule. */
export interface CertifiedBat {
  label: string;
  results: string;
  ball: string;
  checks: RuleCheck[];
}

/** Every bat's simulated test, and every rule held against the bats. */
export interface CertifiedBats {
  certification: CertifiedBat[];
  rules: RuleRow[];
}

/** One of a list: what programs call it, and what people do. */
export interface Choice {
  key: string;
  name: string;
}

/** The bat, its swing, the others beside it, and what is asked of them. */
export interface CompareState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  others: BatState[];
  swing_law: string | null;
  what_if: "none" | "cork" | "wall" | "change";
  hole_diameter_in: number;
  hole_depth_in: number;
  wall_times: number;
  change: string;
  league: string | null;
}

/** Exit speed, its change against the first bat's, and efficiencies along one bat. */
export interface ComparedCurvesInFull {
  position_m: number[];
  exit_speed_m_s: number[]; exit_speed_low_m_s?: number[]; exit_speed_high_m_s?: number[];
  change_m_s: (number | null)[]; change_low_m_s?: number[]; change_high_m_s?: number[];
  collision_efficiency: number[]; collision_efficiency_low?: number[]; collision_efficiency_high?: number[];
  bbcor: number[]; bbcor_low?: number[]; bbcor_high?: number[];
}

/** Bats beside each other, without intervals yet: `intervals` has them. */
export interface ComparisonPicture {
  reference: string;
  same: string;
  swing_law: EffortLaw | null;
  interval: string;
  bats: DrawnComparedBat[];
  conditions: HitConditions;
  uncertainty?: ComparisonUncertainty;
  bat: BatPicture;
  others_bounds: Record<string, [number, number]>[];
  ball: BallPicture;
  verdict: Record<"us" | "si", string[]>;
  assumptions: Record<"us" | "si", string[]>;
  fastest: Record<"us" | "si", string[]>;
  changes: Record<"us" | "si", string[]>;
}

/** The intervals of a comparison, and the probability of each bat's gain over the first. */
export interface ComparisonUncertainty {
  interval_level: number;
  draws: number;
  of: string;
  shares: Record<string, number>;
  sources: Record<string, string>;
  gains: BatGain[];
}

/** The force of both hits over time, and the exit speeds along both bats at the same bat speed. */
export interface CorkingPicture {
  time_s: number[];
  force_n: number[];
  corked_time_s: number[];
  corked_force_n: number[];
  position_m: number[];
  exit_speed_m_s: number[];
  corked_position_m: number[];
  corked_exit_speed_m_s: number[];
  corked_bat: BatShape;
}

/** Hits along an implement, shape (n,). */
export interface CurvesAlongTool {
  position_m: number[];
  exit_speed_m_s: (number | null)[];
  rigid_exit_speed_m_s: (number | null)[];
  collision_efficiency: (number | null)[];
  sting_m_s: (number | null)[];
}

/** Hits at every place along a bat, shape (n,), of a ball met so far off its axis; nan where nothing is known. */
export interface CurvesOfHits {
  position_m: number[];
  exit_speed_m_s: (number | null)[];
  rigid_exit_speed_m_s: (number | null)[];
  launch_angle_rad?: (number | null)[];
  collision_efficiency: (number | null)[];
  bbcor: (number | null)[];
  hand_impulse_n_s: (number | null)[];
  sting_m_s: (number | null)[];
}

/** A rule that is kept or broken; `RuleCheck` has its limits and its source. */
export interface DecidedRule {
  league: string;
  quantity: string;
  verdict: string;
  sure: boolean;
  value: number | null; value_low?: number; value_high?: number;
  unit: string;
}

/** Curves along the bat, knob end first, shape (n,): exit speeds, and how often the ball is met there. */
export interface DesignCurves {
  position_m: number[];
  exit_speed_m_s: number[];
  present_exit_speed_m_s: number[];
  difference_m_s: number[];
  contacts: number[];
}

/** The bat's file, and its drawings by their endings for readers of either system. */
export interface DesignFiles {
  toml: string;
  us: Record<string, string>;
  si: Record<string, string>;
}

/** Whether a limit is kept, with the value and the ends in words. */
export interface DesignLight {
  label: string;
  holds: boolean;
  words: Record<"si" | "us", string>;
}

/** The bat that is being shaped beside the present one: sizes, weights, rules, and curves along both. */
export interface DesignPicture {
  bat: BatPicture;
  ball: BallPicture;
  key: string;
  shaped: boolean;
  left_out: string[];
  present: BatShape;
  variables: ShapedNumber[];
  design: ShapedPicture;
  measures: MeasureBeside[];
  locks: DesignLight[];
  limits: DesignLight[];
  rules: RuleCheck[];
  curves: DesignCurves;
  gained: Record<"us" | "si", string[]>;
  weighs: Record<"us" | "si", string[]>;
}

/** The batter's present bat and swing, where the ball is met, the bat that is being shaped, and what must stay. */
export interface DesignState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  contact_in: number;
  contact_spread_in: number;
  contact_doubt_in: number;
  miss_in: number;
  miss_spread_in: number;
  swing_law: "baseball" | "none";
  design_si: number[] | null;
  design_for: string | null;
  pulled: number | null;
  keep_mass: boolean;
  keep_moi: boolean;
  keep_wood: boolean;
  keep_balance: boolean;
  keep_grip: boolean;
  deepest_cup_in: number;
  league: string;
  want: "exit_speed" | "zone" | "best" | "sting" | "swing_time" | "durability";
  also_want: "exit_speed" | "zone" | "best" | "sting" | "swing_time" | "durability";
  generations: number;
  seed: number;
  swings_csv: string | null;
  swings_of: string | null;
}

/** What the bat gains in this batter's hands beside wood that differs, in words and as a band. */
export interface DesignWorth {
  gained: Record<"us" | "si", string[]>;
  sentences: Record<"us" | "si", string[]>;
  noise_low_m_s: number[];
  noise_high_m_s: number[];
  expected_m_s: number; expected_low_m_s?: number; expected_high_m_s?: number;
  half_interval_m_s: number; half_interval_low_m_s?: number; half_interval_high_m_s?: number;
  likely_from_m_s: number; likely_from_low_m_s?: number; likely_from_high_m_s?: number;
  seen_from_m_s: number; seen_from_low_m_s?: number; seen_from_high_m_s?: number;
}

/** A way on: the view that it leads to, and its words. */
export interface Door {
  view: string;
  title: string;
  words: string;
}

/** A hole from the tip, between two places from the knob end; ``fill`` names what it is filled with. */
export interface DrawnBore {
  diameter_m: number; diameter_low_m?: number; diameter_high_m?: number;
  start_m: number; start_low_m?: number; start_high_m?: number;
  stop_m: number; stop_low_m?: number; stop_high_m?: number;
  fill: string | null;
}

/** One bat of the comparison with what is drawn of it; ``wall`` where another wall is asked about. */
export interface DrawnComparedBat {
  label: string;
  bat: WeighedBat;
  bending_1_hz: number; bending_1_low_hz?: number; bending_1_high_hz?: number;
  hoop_1_hz: number; hoop_1_low_hz?: number; hoop_1_high_hz?: number;
  max_collision_efficiency: number; max_collision_efficiency_low?: number; max_collision_efficiency_high?: number;
  max_bbcor: number; max_bbcor_low?: number; max_bbcor_high?: number;
  bat_speed_m_s: { value: number; low: number; high: number };
  exit_speed_m_s: { value: number; low: number; high: number };
  change_m_s: { value: number; low: number; high: number };
  break_even_bat_speed_m_s: number; break_even_bat_speed_low_m_s?: number; break_even_bat_speed_high_m_s?: number;
  max_exit_speed_m: number; max_exit_speed_low_m?: number; max_exit_speed_high_m?: number;
  zone_m: [number, number] | null;
  scan: ComparedCurvesInFull;
  breaking_speed_m_s: number; breaking_speed_low_m_s?: number; breaking_speed_high_m_s?: number;
  rules?: RulesKept;
  handling?: Handling;
  paddle?: PaddleFace;
  off_center: HitBeside[];
  worth_measuring: WorthMeasuring[];
  shape: BatShape;
  wall: WallInBestHit | null;
}

/** A hollow turned into the tip. */
export interface DrawnCup {
  diameter_m: number; diameter_low_m?: number; diameter_high_m?: number;
  depth_m: number; depth_low_m?: number; depth_high_m?: number;
}

/** Diameters along a bat, from the knob end, shape (n,). */
export interface DrawnOutline {
  position_m: number[];
  diameter_m: number[];
}

/** A park and its fence, by direction from centre field. */
export interface DrawnPark {
  name: string;
  right_m: number[];
  out_m: number[];
  team: string;
  city: string;
  roof: string;
  elevation_m: number; elevation_low_m?: number; elevation_high_m?: number;
  direction_rad: number[];
  distance_m: number[];
  height_m: number[];
}

/** The ball's path, and its distance over the ground from home plate. */
export interface DrawnPath {
  time_s: number[];
  right_m: number[];
  out_m: number[];
  up_m: number[];
  distance_m: number[];
}

/** A weight fixed to the bat. */
export interface DrawnWeight {
  position_m: number; position_low_m?: number; position_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
}

/** Rebound heights of both blocks, and rebound over fall of blocks of every thickness held so. */
export interface DropPicture {
  drop_height_m: number; drop_height_low_m?: number; drop_height_high_m?: number;
  thickness_m: number[];
  block_thickness_m: number; block_thickness_low_m?: number; block_thickness_high_m?: number;
  wood: DroppedOn;
  metal: DroppedOn;
}

/** Rebound from a block of one material, None: not in one contact; and rebound over fall by thickness. */
export interface DroppedOn {
  rebound_m: number | null; rebound_low_m?: number; rebound_high_m?: number;
  limit_rebound_m: number; limit_rebound_low_m?: number; limit_rebound_high_m?: number;
  rebound_ratios: number[];
}

/** The law by which bats are swung with the same effort; see `SwingLaw`. */
export interface EffortLaw {
  name: string;
  exponent: { value: number; low: number; high: number };
  axis_from_grip_m: number; axis_from_grip_low_m?: number; axis_from_grip_high_m?: number;
  lightest_moi_kg_m2: number; lightest_moi_low_kg_m2?: number; lightest_moi_high_kg_m2?: number;
}

/** W over z for wood and metal, and what aluminium bats with other walls give. */
export interface EnergyPicture {
  share: number[];
  wood_returned: number[];
  metal_returned: number[];
  wood: SpringPair;
  metal: SpringPair;
  walls: WallsOfBats;
}

/** A tone of a free bat as described, and how strongly the tap excites it. */
export interface ExpectedTone {
  name: string;
  frequency_hz: number; frequency_low_hz?: number; frequency_high_hz?: number;
  excitation: number;
}

/** Bat, sweet spots, curves along the bat, where the energy goes, the hit at the chosen place, and why. */
export interface ExplorerAnswer {
  bat: BatPicture;
  hands_m: number[];
  sweet_spots: SweetSpotPlaces;
  scan: CurvesOfHits;
  energy_shares: Record<string, number[]>;
  energy_names: Record<string, string>;
  touched_again: Record<"us" | "si", string[]>;
  hit: ExplorerHit;
  place: Record<"si" | "us", string>;
  headline: Record<"us" | "si", string[]>;
  why: Record<"us" | "si", string[]>;
  where_energy_goes: Record<"us" | "si", string[]>;
  difference_m_s: SpeedParts;
  best_exit_speed_m_s: number; best_exit_speed_low_m_s?: number; best_exit_speed_high_m_s?: number;
  lost_m_s: number | null; lost_low_m_s?: number; lost_high_m_s?: number;
  ball: BallPicture;
  published: Publication[];
  conditions: HitConditions;
}

/** The hit at the chosen place. */
export interface ExplorerHit {
  position_m: number; position_low_m?: number; position_high_m?: number;
  lateral_m: number; lateral_low_m?: number; lateral_high_m?: number;
  outcome: string;
  outcome_text: string;
  closing_speed_m_s: number; closing_speed_low_m_s?: number; closing_speed_high_m_s?: number;
  collision_efficiency: number; collision_efficiency_low?: number; collision_efficiency_high?: number;
  contact_time_s: number; contact_time_low_s?: number; contact_time_high_s?: number;
  peak_force_n: number; peak_force_low_n?: number; peak_force_high_n?: number;
  peak_compression_m: number; peak_compression_low_m?: number; peak_compression_high_m?: number;
  touched_again: Record<"us" | "si", string[]>;
  bat_speed_m_s: number; bat_speed_low_m_s?: number; bat_speed_high_m_s?: number;
  exit_speed_m_s: number | null; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  launch_angle_rad: number | null; launch_angle_low_rad?: number; launch_angle_high_rad?: number;
  backspin_rad_s: number | null; backspin_low_rad_s?: number; backspin_high_rad_s?: number;
  bbcor: number; bbcor_low?: number; bbcor_high?: number;
  energy_shares: Record<string, number>;
  hand_impulse_n_s?: number; hand_impulse_low_n_s?: number; hand_impulse_high_n_s?: number;
  sting_m_s?: number;
}

/** The explorer's controls: the bat, the swing, the ball, and where they meet. */
export interface ExplorerState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  impact_from_tip_in: number;
  offset_in: number;
}

/** Hits all over a face, and the best of them. */
export interface FaceMapPicture {
  position_m: number[];
  lateral_m: number[];
  collision_efficiency: (number | null)[][];
  exit_speed_m_s: (number | null)[][];
  sting: (number | null)[][];
  best_m: number; best_low_m?: number; best_high_m?: number;
  best_lateral_m: number; best_lateral_low_m?: number; best_lateral_high_m?: number;
}

/** A park's fence from above, shape (n,): to the right of home plate, and towards centre field. */
export interface FenceOutline {
  name: string;
  right_m: number[];
  out_m: number[];
}

/** The fences of every park. */
export interface Fences {
  parks: FenceOutline[];
}

/** A park's fence, to the right of the line to centre field and along it, from home. */
export interface FieldFence {
  name: string;
  right_m: number[];
  out_m: number[];
  words: string;
}

/** The hit and its film. */
export interface FilmAnswer {
  bat: BatPicture;
  ball: BallPicture;
  hands_m: number[];
  hit: FilmHit;
  film: HitFilm;
  energy_j: Record<string, number[]>;
  energy_names: Record<string, string>;
  energy_words: Record<"us" | "si", string[]>;
  speeds: Record<"us" | "si", string[]>;
  force: Record<"us" | "si", string[]>;
  phases: FilmPhase[];
  top_hand: HandMotion;
  hoop: WallMotion | null;
  words: Record<"us" | "si", string[]>;
  conditions: HitConditions;
}

/** The hit that is shown; ``release_time`` is when the ball is free. */
export interface FilmHit {
  position_m: number; position_low_m?: number; position_high_m?: number;
  lateral_m: number; lateral_low_m?: number; lateral_high_m?: number;
  outcome: string;
  outcome_text: string;
  closing_speed_m_s: number; closing_speed_low_m_s?: number; closing_speed_high_m_s?: number;
  collision_efficiency: number; collision_efficiency_low?: number; collision_efficiency_high?: number;
  contact_time_s: number; contact_time_low_s?: number; contact_time_high_s?: number;
  peak_force_n: number; peak_force_low_n?: number; peak_force_high_n?: number;
  peak_compression_m: number; peak_compression_low_m?: number; peak_compression_high_m?: number;
  release_time_s: number; release_time_low_s?: number; release_time_high_s?: number;
  touched_again: Record<"us" | "si", string[]>;
  bat_speed_m_s: number; bat_speed_low_m_s?: number; bat_speed_high_m_s?: number;
  exit_speed_m_s: number; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  incoming_energy_j: number; incoming_energy_low_j?: number; incoming_energy_high_j?: number;
}

/** What goes on from a moment on, in words with {moment}, {pressed} and {force} where these numbers stand. */
export interface FilmPhase {
  start_s: number; start_low_s?: number; start_high_s?: number;
  words: string;
}

/** The fitted implement; its swing weight about the axis of its sport, and half the 90 % interval of that. */
export interface FittedTool {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  swing_weight_kg_m2: number; swing_weight_low_kg_m2?: number; swing_weight_high_kg_m2?: number;
  swing_weight_half_kg_m2: number; swing_weight_half_low_kg_m2?: number; swing_weight_half_high_kg_m2?: number;
}

/** Where a flight ends in a park; see `sweetspot.flight.fence.Landing`. */
export interface FlightEnd {
  park: string;
  outcome: string;
  direction_rad: number; direction_low_rad?: number; direction_high_rad?: number;
  distance_m: number; distance_low_m?: number; distance_high_m?: number;
  height_m: number; height_low_m?: number; height_high_m?: number;
  clearance_m: number | null; clearance_low_m?: number; clearance_high_m?: number;
}

/** The ball's launch, from numbers or from a swing; the park, the air and the wind. */
export interface FlightState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  impact_from_tip_in: number;
  offset_in: number;
  start: "ball" | "swing";
  exit_speed_mph: number;
  launch_angle_deg: number;
  spray_deg: number;
  direction: "launch" | "landing";
  backspin_rpm: number;
  sidespin_rpm: number;
  height_ft: number;
  attack_angle_deg: number;
  attack_direction_deg: number;
  tilt_deg: number;
  batter: "right" | "left";
  pitch_angle_deg: number;
  pitch_backspin_rpm: number;
  park: string | null;
  temperature_degf: number;
  relative_humidity: number;
  pressure_inhg: number;
  elevation_ft: number | null;
  wind_speed_mph: number;
  wind_direction_deg: number;
  own_elevation: boolean;
}

/** The path, its end at the fence of the chosen park, and the outcome in every park. */
export interface FlownBall {
  parks: OutcomeInPark[];
  out_in: number;
  of: number;
  expected_out_in: number;
  chance: number; chance_low?: number; chance_high?: number;
  end: FlightEnd;
  start: "ball" | "swing";
  missed: false;
  swing: SwungAt | null;
  bat?: BatPicture;
  launch: BallLeaving;
  flight: ToTheGround;
  without_air: ToTheGround;
  path: DrawnPath;
  path_without_air: DrawnPath;
  park: DrawnPark;
  usual_park: string;
  air_density_kg_m3: number; air_density_low_kg_m3?: number; air_density_high_kg_m3?: number;
  elevation_m: number; elevation_low_m?: number; elevation_high_m?: number;
  headline: Record<"us" | "si", string[]>;
  leaves: Record<"us" | "si", string[]>;
  margin: Record<"us" | "si", string[]>;
  side: Record<"us" | "si", string[]>;
  above: Record<"us" | "si", string[]>;
}

/** The questions of a sport; ``view`` is where its implement is looked at. */
export interface Form {
  sport: string;
  name: string;
  implement: string;
  view: "explorer" | "sports";
  patterns: Pattern[];
}

/** One bat of a front: its numbers and measures, SI, and its outline where outlines differ. */
export interface FrontBat {
  numbers: number[];
  values: Record<string, number>;
  outline?: DrawnOutline;
}

/** The front after a generation, and the present bat, whose ``key`` is that of the answer. */
export interface FrontProgress {
  key: string;
  generation: number;
  generations: number;
  wants: string[];
  front: FrontBat[];
  present: Record<string, number>;
}

/** The motion of the top hand's place, and the arrival of the wave there; None: it does not arrive. */
export interface HandMotion {
  displacement_m: number[];
  velocity_m_s: number[];
  arrival_s: number | null; arrival_low_s?: number; arrival_high_s?: number;
  impulse_given: number | null; impulse_given_low?: number; impulse_given_high?: number;
}

/** How a racket handles; see `handling_of`. */
export interface Handling {
  swing_weight_kg_m2: number; swing_weight_low_kg_m2?: number; swing_weight_high_kg_m2?: number;
  axis_m: number; axis_low_m?: number; axis_high_m?: number;
  recoil_weight_kg_m2: number; recoil_weight_low_kg_m2?: number; recoil_weight_high_kg_m2?: number;
  twist_weight_kg_m2: number; twist_weight_low_kg_m2?: number; twist_weight_high_kg_m2?: number;
  mgr_over_i_per_s2: number; mgr_over_i_low_per_s2?: number; mgr_over_i_high_per_s2?: number;
  polarization: number; polarization_low?: number; polarization_high?: number;
}

/** What is heard in recorded taps; ``measured`` and ``damping`` are controls of the view. */
export interface HeardTaps {
  refused: RefusedSound[];
  taps: TapRow[];
  words: string;
  waveform?: TapWaveform;
  tones: ToneRow[];
  spectrum?: TapSpectrum;
  measured: (["bending-1" | "bending-2" | "bending-3" | "bending-4" | "bending-5" | "hoop", number, number])[];
  damping?: [number, number];
  fault: string | null;
  unlike: boolean;
  doubts: string[];
}

/** A hit beside the line: ``lateral`` m to either side; ``aside``: the angle to that side at which the ball goes. */
export interface HitBeside {
  position_m: number; position_low_m?: number; position_high_m?: number;
  lateral_m: number; lateral_low_m?: number; lateral_high_m?: number;
  exit_speed_m_s: number; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  aside_rad: number; aside_low_rad?: number; aside_high_rad?: number;
  gear_spin_rad_s?: number; gear_spin_low_rad_s?: number; gear_spin_high_rad_s?: number;
}

/** Pitch, swing, hands and ball; places from the knob end. See `Conditions`. */
export interface HitConditions {
  pitch_speed_m_s: number; pitch_speed_low_m_s?: number; pitch_speed_high_m_s?: number;
  bat_speed_m_s: number; bat_speed_low_m_s?: number; bat_speed_high_m_s?: number;
  bat_speed_at_m: number; bat_speed_at_low_m?: number; bat_speed_at_high_m?: number;
  pivot_m: number; pivot_low_m?: number; pivot_high_m?: number;
  hands_m: number; hands_low_m?: number; hands_high_m?: number;
  ball: string;
  ball_mass_kg: number; ball_mass_low_kg?: number; ball_mass_high_kg?: number;
  ball_restitution: number; ball_restitution_low?: number; ball_restitution_high?: number;
  ball_restitution_speed_m_s: number; ball_restitution_speed_low_m_s?: number; ball_restitution_speed_high_m_s?: number;
  ball_restitution_slope_s_m: number; ball_restitution_slope_low_s_m?: number; ball_restitution_slope_high_s_m?: number;
}

/** Ball and bat at a row of moments, shape (m,). */
export interface HitFilm {
  time_s: number[];
  ball_travel_m: number[];
  force_n: number[];
  compression_m: number[];
  gap_m: number[];
  place_m: number[];
  shape_per_sqrt_kg: number[][];
  motion_sqrt_kg_m: number[][];
  push_m: number[];
  turn_rad: number[];
}

/** The bat, the swing, where they meet, and how the film is shown. */
export interface HitFilmState {
  held: boolean;
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  impact_from_tip_in: number;
  duration_ms: number;
  moment_ms: number;
  exaggeration: number;
  recoil: boolean;
  slowness: number;
}

/** A swing and a hit where they happen: to the right as the catcher sees it, to centre field, and up. */
export interface HitInSpace {
  forward: number[];
  up: number[];
  tip: number[];
  outline: DrawnOutline;
  place_m: number; place_low_m?: number; place_high_m?: number;
  pivot_m: number; pivot_low_m?: number; pivot_high_m?: number;
  axis_m: number[];
  ball_m: number[];
  radius_m: number; radius_low_m?: number; radius_high_m?: number;
  pitch_m_s: number[];
  leaves_m_s: number[];
  spin_rad_s: number[];
  sentence: Record<"us" | "si", string[]>;
}

/** The best launch angle of an exit speed, and carries around it. */
export interface LaunchAnswer {
  bat: BatPicture;
  ball: BallPicture;
  launch: LaunchThatCarries;
  map: CarryMap;
  park: string;
  words: Record<"us" | "si", string[]>;
  chances: Record<"us" | "si", string[]>;
}

/** The launch angle at which a ball so fast carries farthest. */
export interface LaunchThatCarries {
  exit_speed_m_s: number; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  launch_angle_rad: number; launch_angle_low_rad?: number; launch_angle_high_rad?: number;
  carry_m: number; carry_low_m?: number; carry_high_m?: number;
}

/** One player in the list; measures in SI, partly pooled, None where no table tells. */
export interface ListedPlayer {
  batter: string;
  name: string;
  balls: number;
  ev20: number | null;
  exit_speed: number | null;
  bat_speed: number | null;
  squared_up: number | null;
  from_best: number | null;
  home_runs: number | null;
  home_runs_expected: number | null;
}

/** Balls in boxes; see `BallMap`. ``note`` explains the picture, and ``label`` tells it to who does not see it. */
export interface MappedBalls {
  across_m: number[];
  along_m: number[];
  balls: number[][];
  outside: number;
  near: number;
  note: Record<"si" | "us", string>;
  label: Record<"si" | "us", string>;
}

/** The meaning of a word: the names under which it is listed, the explanation in either system, and its source. */
export interface Meaning {
  names: string[];
  words: Record<"us" | "si", string>;
  source: string;
}

/** A measure of the bat that is being shaped, beside the present one's; None: that has none. */
export interface MeasureBeside {
  name: string;
  label: string;
  scale: string;
  value: number;
  present: number | null;
  change: number | null;
}

/** A swing that misses the ball, or from which it does not come off. */
export interface MissedBall {
  start: "ball" | "swing";
  missed: true;
  swing: SwungAt | null;
  bat?: BatPicture;
  park: DrawnPark;
  usual_park: string;
  headline: Record<"us" | "si", string[]>;
}

/** Every motion of the bat, lowest first, and what the tap leaves in it. */
export interface ModesAnswer {
  bat: BatPicture;
  hands_m: number[];
  nodes: BarrelNodes;
  place_m: number[];
  hoop_start_m: number | null; hoop_start_low_m?: number; hoop_start_high_m?: number;
  tap: BatTap;
  modes: BatMotion[];
  chosen: number;
  words: Record<"us" | "si", string[]>;
}

/** The bat, who holds it, which motion is shown, and where it is tapped. */
export interface ModesState {
  held: boolean;
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  family: "rigid" | "bending" | "hoop" | "hand";
  number: number;
  tap_from_tip_in: number;
  tap_ms: number;
  exaggeration: number;
}

/** A file of HTML and what it is called. */
export interface OneFile {
  name: string;
  html: string;
}

/** The bat, how fast it is swung, and the pitch it meets. */
export interface OptimumState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  pitch: string | null;
  tilt_deg: number;
  exit_speed_mph: number;
  backspin_rpm: number;
  park: string | null;
}

/** An implement of another sport, which has no drawing, and how far from its tip it can be tapped. */
export interface OtherTool {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  outline: null;
  bounds: Record<string, [number, number]>;
}

/** One ball in one park. */
export interface OutcomeInPark {
  park: string;
  team: string;
  outcome: "foul" | "home run" | "off the wall" | "in play";
  clearance_m: number | null; clearance_low_m?: number; clearance_high_m?: number;
  carry_m: number; carry_low_m?: number; carry_high_m?: number;
  fence_m: number | null; fence_low_m?: number; fence_high_m?: number;
  chance: number; chance_low?: number; chance_high?: number;
}

/** What the measurements allow: values with intervals, residuals, contradictions and rules. */
export interface OwnAnswer {
  bat: BenchBat | OtherTool;
  words: Terms;
  grip_end: string;
  fitted: FittedTool;
  guesses: Record<"weighed_oz" | "balanced_in" | "pendulum_ms" | "swing_weight_oz_in2" | "pivot_in", number | null>;
  expected: ExpectedTone[];
  expected_words: Record<"si" | "us", string>;
  headline: Record<"si" | "us", string>;
  values: OwnValue[];
  unfitted: string;
  unknowns: OwnUnknown[];
  measurements: OwnMeasurement[];
  contradictions: Record<"us" | "si", string[]>;
  budget: Record<"us" | "si", string[]>;
  rules: RuleCheck[];
}

/** A measurement beside what the fitted implement says to it. */
export interface OwnMeasurement {
  name: string;
  field: "weighed_oz" | "balanced_in" | "pendulum_ms" | "swing_weight_oz_in2" | "pivot_in" | null;
  scale: string;
  digits: number;
  value: number;
  half: number;
  counts: boolean;
  sigma: number | null;
  fitted: number | null;
  should: number | null;
  beside: Record<"si" | "us", string> | null;
  tone: "bending-1" | "bending-2" | "bending-3" | "bending-4" | "bending-5" | "hoop" | null;
  right_tone: "bending-1" | "bending-2" | "bending-3" | "bending-4" | "bending-5" | "hoop" | null;
}

/** The bat as described, and what scale, balance, pendulum and tap say of it; what is empty was not measured. */
export interface OwnState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  implement: string | null;
  implement_toml: string | null;
  weighed_oz: number | null;
  weighed_error_oz: number;
  balanced_in: number | null;
  balanced_error_in: number;
  pendulum_ms: number | null;
  pendulum_error_ms: number;
  swing_weight_oz_in2: number | null;
  swing_weight_error_oz_in2: number;
  pivot_in: number | null;
  tones: (["bending-1" | "bending-2" | "bending-3" | "bending-4" | "bending-5" | "hoop", number, number])[];
  damping: number | null;
  damping_error: number;
  diameter_error: number;
  left_out: string[];
  tap_from_tip_in: number;
  league: string;
  recordings: string[];
}

/** What was not known: half its interval before and after the measurements, as parts of it, and its sources. */
export interface OwnUnknown {
  name: string;
  label: string;
  before: number;
  off: number;
  after: number;
  budget: [string, number][];
}

/** A value of the fitted implement and half its 90 % interval, SI. */
export interface OwnValue {
  name: string;
  label: Record<"si" | "us", string>;
  scale: string;
  value: number;
  half: number;
  known_from: string;
}

/** Numbers of a paddle; see `face_stiffness` and `face_tone`. */
export interface PaddleFace {
  swing_weight_kg_m2: number; swing_weight_low_kg_m2?: number; swing_weight_high_kg_m2?: number;
  twist_weight_kg_m2: number; twist_weight_low_kg_m2?: number; twist_weight_high_kg_m2?: number;
  face_stiffness_n_m: number; face_stiffness_low_n_m?: number; face_stiffness_high_n_m?: number;
  deflection_force_n: number; deflection_force_low_n?: number; deflection_force_high_n?: number;
  face_tone_hz: number; face_tone_low_hz?: number; face_tone_high_hz?: number;
  rim_mass_kg: number; rim_mass_low_kg?: number; rim_mass_high_kg?: number;
  handle_mass_kg: number; handle_mass_low_kg?: number; handle_mass_high_kg?: number;
  pbcor?: number; pbcor_low?: number; pbcor_high?: number;
  pbcor_limit?: number; pbcor_limit_low?: number; pbcor_limit_high?: number;
}

/** The paper's statements on one question with its formula's number and the full model's, and a picture. */
export interface PaperPicture {
  question: "end" | "percussion" | "corking" | "drop" | "energy" | "verdict";
  asked: Asked;
  rows: Statement[];
  picture: SpeedsPicture | PercussionPicture | CorkingPicture | DropPicture | EnergyPicture;
  truth: Record<"us" | "si", string[]>;
  live: Record<"us" | "si", string[]>;
  label: Record<"us" | "si", string>;
  ball: BallPicture;
  bat: BatPicture;
  conditions: HitConditions;
}

/** The question, what the paper leaves open, and the bat and swing of the full model. */
export interface PaperState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  question: "end" | "percussion" | "corking" | "drop" | "energy" | "verdict";
  entry_angle_deg: number;
  rod_hands_in: number;
  hands_moved_in: number;
  hole_diameter_in: number;
  hole_depth_in: number;
  hole_fill: string;
  drop_height_m: number;
  block_thickness_m: number;
  block_support: "clamped" | "floor" | "free";
  ball_restitution: number;
  wood_restitution: number;
  metal_restitution: number;
  wood_share: number;
  metal_share: number;
}

/** A pattern for an own implement, and the questions that follow. */
export interface Pattern {
  key: string;
  name: string;
  questions: WizardQuestion[];
}

/** Equation 9 along the paper's rod and the bat, each held where its control says. */
export interface PercussionPicture {
  position_m: number[];
  rod_ratio: number[];
  bat_ratio: number[];
  moved_ratio: number[];
  rod_percussion_m: number; rod_percussion_low_m?: number; rod_percussion_high_m?: number;
  bat_percussion_m: number; bat_percussion_low_m?: number; bat_percussion_high_m?: number;
  moved_percussion_m: number; moved_percussion_low_m?: number; moved_percussion_high_m?: number;
  best_m: number; best_low_m?: number; best_high_m?: number;
}

/** The player's swings, the bat they were made with, and what is wanted. */
export interface PlayerState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  swings_csv: string | null;
  swings_of: string | null;
  upload: string | null;
  goal: "exit-speed" | "carry";
  given_pitch_mph: number;
}

/** Exit speeds over the barrel and over how far off its axis the ball is met; nan: it is fouled back. */
export interface PowerMap {
  position_m: number[];
  offset_m: number[];
  exit_speed_m_s: (number | null)[][];
}

/** One published number of a bat. */
export interface Publication {
  curve: string;
  words: Record<"si" | "us", string>;
  source: string;
  place_m: [number, number];
  values: [number, number] | null;
}

/** A document's title and its HTML for readers of either system; the server's own words, all escaped. */
export interface ReadDocument {
  title: string;
  html: Record<"us" | "si", string>;
}

/** The swings of a table as they were read. */
export interface ReadSwings {
  bat: BenchBat;
  bat_speed_m_s: (number | null)[];
  exit_speed_m_s: (number | null)[];
  batters: string[];
  batter: string | null;
  words: string;
  notes: Record<"us" | "si", string[]>;
}

/** A recording that cannot be read, and why. */
export interface RefusedSound {
  recording: string;
  fault: string;
}

/** The report's answer, and the cost of misses by two laws of the ball. */
export interface ReportWords {
  sentences: Record<"us" | "si", string[]>;
  other_law: SpeedSpan[];
}

/** One rule held against a bat; value, limits and margin in ``unit``, SI. */
export interface RuleCheck {
  league: string;
  league_name: string;
  quantity: string;
  title: string;
  verdict: string;
  sure: boolean;
  value: number | null; value_low?: number; value_high?: number;
  least: number | null;
  most: number | null;
  margin: number | null; margin_low?: number; margin_high?: number;
  unit: string;
  reason: string;
  source: string;
  where: string;
  year: number | null;
  reading: string;
  passes_probability?: number;
}

/** One rule held against every bat; ``decided``: at least one of them keeps or breaks it. */
export interface RuleRow {
  title: string;
  limit: Record<"si" | "us", string>;
  decided: boolean;
  verdicts: BatVerdict[];
}

/** Whether a bat keeps the rules of its own sport, and the rules behind that. */
export interface RulesKept {
  passed: boolean;
  verdict: string;
  sure: boolean;
  checks: DecidedRule[];
}

/** A table that can be taken away. */
export interface SavedTable {
  name: string;
  bytes: number;
}

/** Of the chosen balls how well they were hit, where on the barrel, and where they would come down. */
export interface SeasonMaps {
  words?: Record<"si" | "us", string>;
  unmapped?: string;
  means?: BallMeans;
  ceilings?: BallCeilings;
  barrel?: MappedBalls;
  field?: MappedBalls;
}

/** The bat, the chosen park's fence, and of a season that was read what can be chosen and taken away. */
export interface SeasonPicture {
  bat: BenchBat;
  park: FieldFence;
  season: SeasonSummary | null;
}

/** How far the reading of a season is. */
export interface SeasonReading {
  phase: "tables" | "rows" | "players" | "done";
  words: string;
  reached: string;
  rows_read: number;
  rows: number;
  season?: string;
}

/** Tables that were handed in, the bat that all hitters are taken to swing, and which balls are looked at. */
export interface SeasonState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  uploads: string[];
  season: string | null;
  batter: string | null;
  team: string | null;
  pitch_type: string | null;
  count: string | null;
  month: string | null;
  park: string | null;
  fence: string | null;
}

/** The summary of a season that was read to its end; ``bat`` is the state of the bat it was read with. */
export interface SeasonSummary {
  choices: Record<string, [string, number][]>;
  rows: number;
  files: string[];
  words: string;
  unread: string[];
  tables: SavedTable[];
  same_bat: boolean;
}

/** The summary of the whole season, and its players; nothing where none was read. */
export interface SeasonWords {
  html?: Record<"si" | "us", string>;
  players?: ListedPlayer[];
}

/** One number of the bat that is being shaped, SI by ``scale``; ``key`` names its control. */
export interface ShapedNumber {
  key: string;
  label: Record<"si" | "us", string>;
  scale: string;
  low: number;
  high: number;
  value: number;
}

/** The bat that is being shaped; its stations are the handles that can be pulled. */
export interface ShapedPicture {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  outline: DrawnOutline;
  stations: Station[];
  hollow: boolean;
  wall_m: number[] | null;
  bores: DrawnBore[];
  cup: DrawnCup | null;
  weights: DrawnWeight[];
  material: string;
  remark: Record<"si" | "us", string>;
  moi_6in_half_kg_m2: number; moi_6in_half_low_kg_m2?: number; moi_6in_half_high_kg_m2?: number;
}

/** The parts of the difference in exit speed from the best place; see `SpeedDifference`. */
export interface SpeedParts {
  motion: number;
  giving: number;
  keeping: number;
  whole: number;
}

/** Exit speed at a place by two laws of the ball. */
export interface SpeedSpan {
  position_m: number; position_low_m?: number; position_high_m?: number;
  low_m_s: number; low_low_m_s?: number; low_high_m_s?: number;
  high_m_s: number; high_low_m_s?: number; high_high_m_s?: number;
}

/** Exit speeds along a bat, from the knob end, shape (n,). */
export interface SpeedsAlong {
  position_m: number[];
  exit_speed_m_s: (number | null)[];
}

/** Exit speeds along the bat with every place that is called sweet. */
export interface SpeedsPicture {
  position_m: number[];
  exit_speed_m_s: number[];
  rigid_exit_speed_m_s: number[];
  sweet_spots: SweetSpotPlaces;
  elastic_travel_m?: number; elastic_travel_low_m?: number; elastic_travel_high_m?: number;
  travel_m?: number; travel_low_m?: number; travel_high_m?: number;
}

/** The ball of the sport. */
export interface SportsBall {
  name: string;
  radius_m: number; radius_low_m?: number; radius_high_m?: number;
}

/** Hits all over the face; None: there is none. */
export interface SportsFace {
  face: FaceMapPicture | null;
}

/** The hit at the chosen place; ``exit_speed`` None: the ball does not leave. */
export interface SportsHit {
  position_m: number; position_low_m?: number; position_high_m?: number;
  lateral_m: number; lateral_low_m?: number; lateral_high_m?: number;
  outcome: string;
  outcome_text: string;
  closing_speed_m_s: number; closing_speed_low_m_s?: number; closing_speed_high_m_s?: number;
  collision_efficiency: number; collision_efficiency_low?: number; collision_efficiency_high?: number;
  contact_time_s: number; contact_time_low_s?: number; contact_time_high_s?: number;
  peak_force_n: number; peak_force_low_n?: number; peak_force_high_n?: number;
  peak_compression_m: number; peak_compression_low_m?: number; peak_compression_high_m?: number;
  touched_again: Record<"us" | "si", string[]>;
  bat_speed_m_s: number; bat_speed_low_m_s?: number; bat_speed_high_m_s?: number;
  exit_speed_m_s: number; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  sting_m_s: number;
}

/** An implement's sweet spots, curves along it, and the hit at the chosen place, in its sport's words. */
export interface SportsPicture {
  implement: string;
  has_face: boolean;
  sport: string;
  words: Terms;
  tool: ToolFacts;
  ball: SportsBall;
  swing_mph: number;
  incoming_mph: number;
  sweet_spots: SweetSpotPlaces;
  scan: CurvesAlongTool;
  hit: SportsHit;
  headline: Record<"us" | "si", string[]>;
  touched_again: Record<"us" | "si", string[]>;
}

/** The implement, its speed, and the place of the ball; empty: as is usual in its sport. */
export interface SportsState {
  implement: string;
  implement_toml: string | null;
  swing_mph: number | null;
  incoming_mph: number | null;
  met_from_tip_in: number | null;
  aside_in: number;
}

/** The place of the best hits and the reasons. */
export interface SportsWords {
  sentences: Record<"us" | "si", string[]>;
}

/** The bat's share of the energy, and its restitution. */
export interface SpringPair {
  share: number; share_low?: number; share_high?: number;
  restitution: number; restitution_low?: number; restitution_high?: number;
}

/** A bat, its best place, and the hit at the chosen place: its speed, what a miss costs, and its tones. */
export interface StartAnswer {
  front: StartWords;
  bat: BatPicture;
  ball: BallPicture;
  hands_m: number[];
  best_m: number; best_low_m?: number; best_high_m?: number;
  scan: SpeedsAlong;
  position_m: number; position_low_m?: number; position_high_m?: number;
  exit_speed_m_s: number | null; exit_speed_low_m_s?: number; exit_speed_high_m_s?: number;
  place: Record<"si" | "us", string>;
  sentence: Record<"us" | "si", string[]>;
  tones: ToneOfHit[];
}

/** The bat, the swing, the ball, and where along the bat they meet, in its middle. */
export interface StartState {
  bat: string;
  bat_toml: string | null;
  profile_in: [number, number][] | null;
  mass_oz: number | null;
  wall_factor: number;
  bore_diameter_in: number;
  bore_depth_in: number;
  bore_fill: string;
  cup_diameter_in: number;
  cup_depth_in: number;
  weight_oz: number;
  weight_from_tip_in: number;
  choke_up_in: number;
  pitch_speed_mph: number | null;
  bat_speed_mph: number | null;
  same: "effort" | "speed";
  hands_in: number;
  ball: string | null;
  ball_toml: string | null;
  ball_cor: number | null;
  ball_humidity: number | null;
  ball_temperature_degf: number | null;
  impact_from_tip_in: number;
}

/** The words of the first page that stay. */
export interface StartWords {
  title: string;
  lead: string;
  doors: Door[];
}

/** One statement of the paper, with its words for readers of either system. */
export interface Statement {
  equation: string;
  quantity: string;
  unit: string;
  paper: number | string | null;
  computed: number | string | null;
  full_model: number | string | null;
  comment: string;
  name: string;
  words: Record<"us" | "si", StatementWords>;
}

/** Statement and comment of a row as readers of one system see them. */
export interface StatementWords {
  quantity: string;
  comment: string;
}

/** One diameter of a bat that is drawn by stations. */
export interface Station {
  position_m: number; position_low_m?: number; position_high_m?: number;
  diameter_m: number; diameter_low_m?: number; diameter_high_m?: number;
}

/** The intervals of one bat's numbers; ``change_low`` and ``change_high`` are those of its curve. */
export interface SureBat {
  bat_speed_m_s: { value: number; low: number; high: number };
  exit_speed_m_s: { value: number; low: number; high: number };
  change_m_s: { value: number; low: number; high: number };
  change_low_m_s?: (number | null)[];
  change_high_m_s?: (number | null)[];
}

/** The intervals of all that is not known, and the verdict that they allow. */
export interface SureComparison {
  bats: SureBat[];
  verdict: Record<"us" | "si", string[]>;
  assumptions: Record<"us" | "si", string[]>;
  changes: Record<"us" | "si", string[]>;
}

/** Every meaning of "sweet spot", from the knob end; see `SweetSpots`. */
export interface SweetSpotPlaces {
  center_of_percussion_m: number; center_of_percussion_low_m?: number; center_of_percussion_high_m?: number;
  node_1_m: number; node_1_low_m?: number; node_1_high_m?: number;
  node_2_m: number; node_2_low_m?: number; node_2_high_m?: number;
  max_collision_efficiency_m: number; max_collision_efficiency_low_m?: number; max_collision_efficiency_high_m?: number;
  max_exit_speed_m: number; max_exit_speed_low_m?: number; max_exit_speed_high_m?: number;
  min_sting_m: number; min_sting_low_m?: number; min_sting_high_m?: number;
  zone_m: number[] | null; zone_low_m?: number[]; zone_high_m?: number[];
}

/** A table of swings as text, None: no file was handed in. */
export interface SwingTable {
  csv?: string;
}

/** The swing where it meets the ball, from the knob end. */
export interface SwungAt {
  position_m: number; position_low_m?: number; position_high_m?: number;
  bat_speed_m_s: number; bat_speed_low_m_s?: number; bat_speed_high_m_s?: number;
  collision_efficiency: number; collision_efficiency_low?: number; collision_efficiency_high?: number;
}

/** A tap of a recording, s from its begin; ``fault`` says why it is not a good one. */
export interface TapRow {
  recording: string;
  time_s: number; time_low_s?: number; time_high_s?: number;
  good: boolean;
  fault: string | null;
}

/** Levels of what rings, dB below the loudest. */
export interface TapSpectrum {
  frequency_hz: number[];
  level_db: number[];
}

/** Least and greatest values of a recording over time, full scale 1. */
export interface TapWaveform {
  name: string;
  time_s: number[];
  low: number[];
  high: number[];
}

/** The tap's share in a motion: part of the vibration's energy, None of rigid motions, and speed at the hand. */
export interface Tapped {
  energy_share: number | null; energy_share_low?: number; energy_share_high?: number;
  hand_speed_m_s_per_n_s: number;
}

/** Vocabulary of a sport; the defaults are baseball's. */
export interface Terms {
  implement: string;
  tip: string;
  butt: string;
  efficiency: string;
  ball: string;
  incoming: string;
  exit_speed: string;
  zone: string;
  hands: string;
  smash_factor: string;
  strongest: string;
  deadest: string;
  speed_unit: "mph" | "m/s";
  place_unit: "in" | "cm";
  distance_unit: "ft" | "yd" | "m";
  mass_unit: "oz" | "g" | "";
}

/** A flight to the ground, as if there were no fence. */
export interface ToTheGround {
  carry_m: number; carry_low_m?: number; carry_high_m?: number;
  hang_time_s: number; hang_time_low_s?: number; hang_time_high_s?: number;
  apex_m: number; apex_low_m?: number; apex_high_m?: number;
  landing_speed_m_s: number; landing_speed_low_m_s?: number; landing_speed_high_m_s?: number;
  landing_angle_rad: number; landing_angle_low_rad?: number; landing_angle_high_rad?: number;
  landing_direction_rad: number; landing_direction_low_rad?: number; landing_direction_high_rad?: number;
}

/** A tone of a struck bat, and its part of the vibration's energy. */
export interface ToneOfHit {
  frequency_hz: number; frequency_low_hz?: number; frequency_high_hz?: number;
  decay_s: number; decay_low_s?: number; decay_high_s?: number;
  energy_share: number; energy_share_low?: number; energy_share_high?: number;
}

/** A tone of all good taps: its mode, half its 90 % interval, and whether it is the bat's own and not the room's. */
export interface ToneRow {
  name: string | null;
  frequency_hz: number; frequency_low_hz?: number; frequency_high_hz?: number;
  half_hz: number; half_low_hz?: number; half_high_hz?: number;
  damping_ratio: number;
  expected_hz: number | null;
  taps: number;
  from_bat: boolean;
}

/** Something that one hits a ball with, and in which sport. */
export interface Tool {
  key: string;
  name: string;
  sport: string;
}

/** An implement, and what it is made of. */
export interface ToolFacts {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  made_of: string;
}

/** The usual value of an answer, and its bounds. */
export interface Usual {
  value: number | string | null;
  least: number | null;
  most: number | null;
}

/** The usual hit of a bat: the values of controls that have not been moved. */
export interface UsualHit {
  pitch_speed_mph: number;
  bat_speed_mph: number;
  ball: string;
  pitch: string;
  swing_law: string;
  league: string;
  park: string;
}

/** The wall of a hollow bat in its best hit. */
export interface WallInBestHit {
  thickness_m: number; thickness_low_m?: number; thickness_high_m?: number;
  hoop_frequency_hz: number; hoop_frequency_low_hz?: number; hoop_frequency_high_hz?: number;
  energy_share: number; energy_share_low?: number; energy_share_high?: number;
  restitution: number; restitution_low?: number; restitution_high?: number;
}

/** The dent of a hollow barrel's wall under the ball by harmonics: inwards by dent_n(t) cos(n theta). */
export interface WallMotion {
  harmonics: number[];
  dent_m: number[][];
  radius_m: number; radius_low_m?: number; radius_high_m?: number;
  wall_m: number; wall_low_m?: number; wall_high_m?: number;
}

/** Results of the full model for aluminium bats with other walls. */
export interface WallsOfBats {
  thickness_m: number[];
  share: number[];
  returned: number[];
  restitution: number[];
  exit_speed_m_s: number[];
}

/** Mass properties, with half the 90 % interval of the swing weight; 0: it was measured. */
export interface WeighedBat {
  name: string;
  length_m: number; length_low_m?: number; length_high_m?: number;
  mass_kg: number; mass_low_kg?: number; mass_high_kg?: number;
  balance_point_m: number; balance_point_low_m?: number; balance_point_high_m?: number;
  moi_cm_kg_m2: number; moi_cm_low_kg_m2?: number; moi_cm_high_kg_m2?: number;
  moi_knob_kg_m2: number; moi_knob_low_kg_m2?: number; moi_knob_high_kg_m2?: number;
  moi_6in_kg_m2: number; moi_6in_low_kg_m2?: number; moi_6in_high_kg_m2?: number;
  roll_moi_kg_m2: number; roll_moi_low_kg_m2?: number; roll_moi_high_kg_m2?: number;
  moi_6in_half_kg_m2: number; moi_6in_half_low_kg_m2?: number; moi_6in_half_high_kg_m2?: number;
}

/** One question. */
export interface WizardQuestion {
  value: number | string | null;
  least: number | null;
  most: number | null;
  field: string;
  label: Record<"us" | "si", string>;
  kind: string;
  system: "us" | "si" | null;
  follows: string;
  by: Record<string, Usual>;
  proportion_to: string;
  options: Choice[];
}

/** What to measure on which implements, and half of the interval of the answer's speed once that is done. */
export interface WorthMeasuring {
  measured: ("mass" | "balance_point" | "moi" | "period" | "twist_weight" | "frequency" | "efficiency" | "face_stiffness")[];
  implements: string[];
  half_interval_m_s: number; half_interval_low_m_s?: number; half_interval_high_m_s?: number;
}

/** The text of a bat's file; None: nothing was measured. */
export interface WrittenBat {
  toml?: string;
}
