"""What a season says, in plain words: the league, its bats, what tracked distances leave over, and one player."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from sweetspot.answers.season import SeasonAnswer
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.reports.sentences import Line, Sentence, Slot, say, tell
from sweetspot.seasons.agreement import APART
from sweetspot.seasons.ball_columns import WITH
from sweetspot.seasons.season_drag import LeftOver, OwnDrag
from sweetspot.seasons.standings import MEASURES
from sweetspot.units import grouped

SCALES: Mapping[str, str] = {"launch_angle": "angle", "exit_speed": "speed", "bearing": "angle", "park": ""}
"""By what balls are compared, and the scale of its values; "" where they are names."""
LEAGUE = (
    Line("{rows} rows in {files}; {balls} balls in play with an exit speed."),
    Line("Home runs: {expected} expected in the parks they were hit in, {hit} hit.", "home_runs"),
    Line(
        "Chance alone does that in one season in {seasons}: most likely these balls were selected by how they ended, "
        "or exit speeds, parks or events are wrong; no average of them holds for other balls.",
        "selected",
    ),
    Line(
        "They fly with the season's own drag, by its tracked distances {drag:ratio, 3, ends} of the law's; its error "
        "alone makes that {league.home_runs_by_drag:count, ends}, and with the law's drag it would be {usual}.",
        "own_drag",
    ),
    Line("They fly with the drag of the law: no table tells the season's own.", "usual_drag"),
    Line("They fly with {given_drag:ratio, 3} of the law's drag, as given.", "given_drag"),
    Line(
        "Squared up (0.80 of what the bat could give): {league.squared_up:share} of the balls, against {bats}.",
        "bat_speeds",
    ),
    Line("By the league's formula, which knows no bat: {league.league_squared_up:share}.", "formula_of_all"),
    Line(
        "By the league's formula, which knows no bat: {league.league_squared_up:share} of the {some} balls whose pitch "
        "has a speed, {league.squared_up_of_the_same:share} of the same against the bat.",
        "formula_of_some",
    ),
    Line("Balls are met {league.from_best:offset} from the best place on average.", "bat_speeds"),
)
"""A paragraph each."""
LEAGUE_COUNTED = 3
"""Of these paragraphs, those that count balls and home runs."""
AGREES = (
    Line("Checked against the tables: "),
    Line(
        "home runs of {agreement.home_runs_agree} of {agreement.home_run_kinds} kinds of balls, by launch angle and "
        "direction, are as expected, within a tenth or two standard deviations of chance",
        "gone",
    ),
    Line("; ", "both"),
    Line(
        "tracked distances are {agreement.distance_above:distance, 1, sign} beside the computed ones on average, "
        "{agreement.distances_agree} of {agreement.distance_kinds} kinds within {near:distance} or two standard errors",
        "tracked",
    ),
    Line("."),
)
"""What agrees, in one line; tables break it down."""
SELECTED_TAIL = 1e-3
"""Probability of so few or so many home runs below which a table counts as selected [our choice]."""
OTHER_BAT = (
    "With {bat} the same swings would have given {gain:speed_change, 1, sign, ends} of exit speed on average, over "
    "{balls} balls."
)
PLACES = (
    Line(
        "Learnt from {swings} swings: the ball is met {places.marginal[0]:place} from the tip on average, ", "learned"
    ),
    Line("scattering by {places.spread:place} about what the pitch's place says; a pitch ", "learned"),
    Line("{pitch.outside:distance} further outside is met {slope:place} ", "learned"),
    Line("nearer", "nearer"),
    Line("further from", "further"),
    Line(
        " the tip; exit speeds are {level} beside the bat's and scatter by {places.noise:speed} more than ", "learned"
    ),
    Line("measuring errors do.", "learned"),
    Line("No table has bat speeds, so nothing is reported about bats.", "no_speeds"),
    Line("Too few balls have a bat speed to learn from them where these batters meet the ball; where ", "few_speeds"),
    Line("batters usually do is taken instead, so what is reported about bats is rough.", "few_speeds"),
)
UNTRACKED = (
    Line("{balls} in play without exit speed; nothing tells how they ended, so what they would ", unless="bias"),
    Line("change is open.", unless="bias"),
    Line("{bias.share:share, 1} of the balls in play have no exit speed. Were they hit as tracked ones ", "bias"),
    Line("that ended alike, as far out, the mean exit speed of all would be ", "bias"),
    Line("{bias.mean_exit_speed_of_all:speed} instead of {bias.mean_exit_speed_of_tracked:speed}; most ", "bias"),
    Line("likely they were hit less hard still.", "bias"),
)
RARE = (
    "Fewer than three of a kind a player: {shares}. Such intervals of 90 % hold about 84 to 88 %, for the truth may "
    "lie nearer 0 or 100 %."
)
LEFT_OVER = (
    Line("By {kind}: from {low} at {there} to {high} at {here}"),
    Line(", which chance alone could do", "chance"),
    Line("."),
)
PLAYER = (
    Line("{balls} in play with an exit speed, the hardest fifth at {ev20:speed} on average."),
    Line(" Home runs: ", "home_runs"),
    Line("{expected:count, 1} expected in the parks they were hit in", "forecast"),
    Line(", ", "both"),
    Line("{hit} hit", "counted"),
    Line("; ", "counts_and_kinds"),
    Line("{kinds}", "kinds"),
    Line(".", "home_runs"),
)
KINDS = (
    ("doubters", "doubter", "doubters"),
    ("mostly_gone", "mostly gone", "mostly gone"),
    ("no_doubters", "no-doubter", "no-doubters"),
)
"""Kinds of home runs: column, and what one and several are called."""
BEST_BAT = (
    Line("None of the bats tried gives more exit speed than the player's own.", unless="better"),
    Line("Of the bats tried {bat} would serve best: {gain:speed_change, 1, sign} of exit speed", "better"),
    Line("; so few balls do not tell how sure it is.", "few_balls"),
    Line(" on average ({low:speed_change, 1, sign, bare} to {high:speed_change, 1, sign} in 90 % by chance ", "sure"),
    Line("alone; the error of the swing law comes on top).", "sure"),
)


def league_words(answer: SeasonAnswer) -> list[Sentence]:
    """Return the season of all its players, a paragraph each."""
    league, count, names = answer.league, len(answer.tables), answer.season.setting.bat_names
    home_runs = league.home_runs_expected is not None and league.home_runs is not None
    bat_speeds = league.squared_up is not None and league.from_best is not None
    formula = bat_speeds and league.league_squared_up is not None and league.squared_up_of_the_same is not None
    nearly_all = league.league_squared_up_balls > 0.9 * league.squared_up_balls
    own_drag = home_runs and league.home_runs_by_drag is not None
    given_drag = answer.question.flights.drag if home_runs else None
    facts = {
        "league": league,
        "rows": grouped(sum(table.rows for table in answer.tables)),
        "files": "one file" if count == 1 else f"{count} files",
        "balls": grouped(league.balls),
        "home_runs": home_runs,
        "expected": grouped(league.home_runs_expected or 0),
        "hit": grouped(league.home_runs or 0),
        "selected": home_runs and league.home_runs_tail is not None and league.home_runs_tail < SELECTED_TAIL,
        "seasons": grouped(float(f"{1 / max(league.home_runs_tail or 1.0, 1e-6):.1g}")),
        "own_drag": own_drag,
        "drag": _drag_interval(answer.own_drag),
        "usual": f"{league.home_runs_with_usual_drag or 0:,.0f}",
        "usual_drag": home_runs and answer.own_drag is None and given_drag is None,
        "given_drag": given_drag,
        "bat_speeds": bat_speeds,
        "bats": names[0] if len(names) == 1 else f"{len(names)} bats",
        "formula_of_all": formula and nearly_all,
        "formula_of_some": formula and not nearly_all,
        "some": grouped(league.league_squared_up_balls),
    }
    paragraphs = [tell([line], **facts) for line in LEAGUE]
    paragraphs.insert(LEAGUE_COUNTED, _agreement_words(answer))
    for other in answer.other_bats:
        gain = Interval(other.gain, other.low, other.high)
        paragraphs.append(say(OTHER_BAT, bat=other.bat, gain=gain, balls=grouped(other.balls)))
    paragraphs.append(_places_words(answer))
    return [paragraph for paragraph in paragraphs if paragraph.parts]


def _agreement_words(answer: SeasonAnswer) -> Sentence:
    """Return how home runs and distances agree with the tables; nothing where no table has either."""
    found = answer.agreement
    gone, tracked = found.home_run_kinds > 0, found.distance_above is not None
    if not gone and not tracked:
        return Sentence(())
    return tell(AGREES, agreement=found, gone=gone, tracked=tracked, both=gone and tracked, near=APART)


def _drag_interval(drag: OwnDrag | None) -> Interval | None:
    if drag is None:
        return None
    return Interval(drag.drag, drag.drag - REACH * drag.error, drag.drag + REACH * drag.error)


def _places_words(answer: SeasonAnswer) -> Sentence:
    """Return the place at which these batters meet the ball, or why it is unknown."""
    places = answer.places
    if places is None:
        return Sentence(())
    learned, pitch, no_speeds = places.balls > 0, places.a_pitch_outside, answer.league.squared_up is None
    return tell(
        PLACES,
        places=places,
        pitch=pitch,
        swings=grouped(places.balls),
        slope=abs(pitch.nearer_the_tip),
        level=f"{round(100 * float(places.level_weights[0]), 1) + 0.0:+.1f} %",
        learned=learned,
        nearer=learned and pitch.nearer_the_tip >= 0,
        further=learned and pitch.nearer_the_tip < 0,
        no_speeds=not learned and no_speeds,
        few_speeds=not learned and not no_speeds,
    )


def untracked_words(answer: SeasonAnswer) -> list[Sentence]:
    """Return the effect of balls without exit speed; nothing where there are none."""
    count = sum(table.ledger["untracked"] for table in answer.tables)
    balls = "1 ball" if count == 1 else f"{grouped(count)} balls"
    return [tell(UNTRACKED, balls=balls, bias=answer.untracked)] if count else []


def few_of_a_kind(rare: Sequence[str]) -> list[Sentence]:
    """Return which shares are so rare that their intervals are surer than they should be."""
    shares = "; ".join(MEASURES[name][1].partition(":")[0] for name in rare)
    return [say(RARE, shares=shares)] if rare else []


def left_over_words(left_over: Mapping[str, Sequence[LeftOver]]) -> list[Sentence]:
    """Return a sentence for each comparison: where tracked distances are shortest and longest beside the carries."""
    sentences = []
    for kind, groups in left_over.items():
        if len(groups) < 2:
            continue
        mean = np.array([group.mean for group in groups])
        weight = 1 / np.maximum([group.error for group in groups], 1e-6) ** 2
        spread = float(np.sum(weight * (mean - np.average(mean, weights=weight)) ** 2))
        freedom = len(mean) - 1
        chance = spread <= freedom + 2 * np.sqrt(2 * freedom)
        low, high = groups[int(np.argmin(mean))], groups[int(np.argmax(mean))]
        ends = {"low": _mean(low), "high": _mean(high), "there": _where(low, kind), "here": _where(high, kind)}
        sentences.append(tell(LEFT_OVER, kind=kind.replace("_", " "), chance=chance, **ends))
    return sentences


def _mean(group: LeftOver) -> Slot:
    half = REACH * group.error
    return Slot(Interval(group.mean, group.mean - half, group.mean + half), "distance", digits=1, sign=True)


def _where(group: LeftOver, kind: str) -> str | Slot:
    return str(group.name) if group.middle is None else Slot(group.middle, SCALES[kind], digits=0)


def player_words(row: Mapping[str, object]) -> Sentence:
    """Return a player's balls and home runs."""
    expected, hit = row["home_runs_expected"], row["home_runs"]
    kinds = ", ".join(
        f"{grouped(count)} {singular if count == 1 else several}"
        for key, singular, several in KINDS
        if isinstance(count := row[key], (int, float))
    )
    counts = expected is not None or hit is not None
    return tell(
        PLAYER,
        balls=_count(row["balls"], "ball"),
        ev20=row["ev20"],
        expected=expected,
        hit=_count(hit),
        kinds=kinds,
        forecast=expected is not None,
        counted=hit is not None,
        both=expected is not None and hit is not None,
        counts_and_kinds=counts and bool(kinds),
        home_runs=counts or bool(kinds),
    )


def _count(number: object, noun: str = "") -> str:
    """Return a count of things, "1 ball", "12 balls"; "" where there is none."""
    text = grouped(number) if isinstance(number, (int, float)) else ""
    return f"{text} {noun}{'' if number == 1 else 's'}" if noun else text


def best_bat_words(row: Mapping[str, object]) -> list[Sentence]:
    """Return which of the bats tried would serve a player best; nothing where none was tried."""
    gains = {
        name.removeprefix(WITH): value
        for name, value in row.items()
        if name.startswith(WITH) and f"{name}_balls" in row and isinstance(value, (int, float))
    }
    if not gains:
        return []
    best = max(gains, key=lambda name: gains[name])
    low, high = (row.get(f"{WITH}{best}_{end}") for end in ("low90", "high90"))
    better, has_interval = gains[best] > 0, low is not None and high is not None
    ends = {"low": low, "high": high, "few_balls": better and not has_interval, "sure": better and has_interval}
    return [tell(BEST_BAT, bat=best, gain=gains[best], better=better, **ends)]
