"""A player's fit in plain words: what the swings say, what they cannot, and what would serve."""

from __future__ import annotations

import re
from collections import defaultdict
from textwrap import shorten

from sweetspot.answers.player import FitPlayerAnswer
from sweetspot.catalog.bats import bat_names
from sweetspot.errors import maybe_meant
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Interval, sure_sign
from sweetspot.player.advice import Advice, Option
from sweetspot.player.bat_pairs import measured_bats
from sweetspot.player.model import PlayerModel
from sweetspot.player.posterior import Learned, PlayerPosterior
from sweetspot.player.swings import SwingFile
from sweetspot.reports.player.decision import lead_paragraphs
from sweetspot.reports.player.phrases import goal_shown, goal_words, of_those_swung, option_words
from sweetspot.reports.sentences import Sentence, Words, joined, say, within
from sweetspot.tables.cells import BadRow
from sweetspot.units import INCH, OUNCE

PARAMETERS: dict[str, tuple[str, str, int | None]] = {
    "bat_speed": ("mean bat speed", "speed", None),
    "bat_speed_spread": ("bat speed, swing to swing", "speed", None),
    "exponent": ("what a heavier bat costs in speed: exponent n", "ratio", 2),
    "position": ("mean contact, from the tip", "place", None),
    "position_spread": ("scatter of contact along the bat", "place", None),
    "offset": ("mean height of the ball over the bat's axis", "offset", None),
    "offset_spread": ("scatter of that height", "offset", None),
    "attack_angle": ("mean attack angle", "angle", None),
    "efficiency_shift": ("ball and bat livelier than the model: change of q", "ratio", None),
    "exit_noise": ("exit speed beyond the model", "speed", None),
}
"""Of every parameter: its name in words, its scale, and digits where others than usual."""
TOO_FEW_DRAWS = (
    "Few of the draws count, so the intervals may be too narrow. Look for rows in the file that do not belong "
    "together, or for one row that was copied."
)
CANNOT_TELL = "These swings cannot tell."
CANNOT_TELL_BATS = "Of the bats tried in the computer these swings tell nothing beyond what holds for everybody."
LENGTH_UNKNOWN = (
    "Not known: another length changes timing, reach and how often the ball is missed, which no computer tells. Swing "
    "a bat of another length."
)
REASONS, LONGEST_REASON = 3, 160
"""Kinds of reasons listed in the first line, and letters of each."""
ROWS_SHOWN = 8
"""Rows not used that are listed; the JSON has all."""


def parameter_shown(name: str, interval: Interval) -> Sentence:
    """Return a parameter's value with its interval."""
    _, scale, digits = PARAMETERS[name]
    return within(interval, scale, digits=digits)


def findings(answer: FitPlayerAnswer) -> list[Words]:
    """Return the findings from the swings, and what they leave undetermined."""
    posterior, swings = answer.posterior, answer.file
    learned = posterior.learned
    words: list[Words] = [*lead_paragraphs(answer.advice), _data(posterior, swings), *taken_for(posterior.model)]
    if side_by_side := measured(posterior):
        words.append(side_by_side)
    words += [_speed(posterior), *_sensor(posterior.model), _contact(learned)]
    unknown = [PARAMETERS[name][0] for name, parameter in learned.items() if not parameter.told]
    if unknown:
        words.append(
            f"The data cannot tell: {'; '.join(unknown)}. What is shown for these is what is usual for players."
        )
    if not posterior.converged:
        words.append(TOO_FEW_DRAWS)
    return words


def answers(advice: Advice) -> list[tuple[str, Sentence]]:
    """Return questions that players ask, each with its answer and interval."""
    return [
        ("Which bat?", _which(advice)),
        ("Heavier or lighter?", _weight(advice)),
        ("Balanced or end-loaded?", _end_loaded(advice)),
        ("Longer or shorter?", _length(advice)),
        ("Choke up?", _choke(advice)),
        ("Where should the ball meet the bat?", _place(advice)),
    ]


def _data(posterior: PlayerPosterior, swings: SwingFile) -> Sentence:
    """Say how many swings counted, with which bats, and why the rest did not."""
    model = posterior.model
    count, bad = len(model.swings), len(swings.bad_rows)
    both = sum(swing.exit_speed is not None and swing.bat_speed is not None for swing in model.swings)
    article = "an" if swings.system.startswith(tuple("AEIO")) else "a"
    kind = f"{article} {swings.system} file" if swings.system != "plain" else "a file"
    days = ""
    if swings.first_day and swings.last_day:
        same = swings.first_day == swings.last_day
        days = f" of {swings.first_day}" if same else f" from {swings.first_day} to {swings.last_day}"
    noun = "swing counts" if count == 1 else "swings count"
    text = f"{count} {noun}, {both} with bat speed and exit speed, from {kind}{days}"
    swung = measured_bats(model)
    if len(swung) > 1:
        text += ": " + ", ".join(f"{bat.count} with {bat.bat.name}" for bat in swung)
    if not bad and not swings.without_swing:
        return say("{text}; every row was used.", text=text)
    why = "; ".join(_reasons(swings))
    rest = f"{bad} row{'s do' if bad != 1 else ' does'} not ({why})" if bad else ""
    empty = f"{swings.without_swing} hold no swing" if swings.without_swing else ""
    return say("{text}; {rest}.", text=text, rest=" and ".join(part for part in (rest, empty) if part))


def taken_for(model: PlayerModel) -> list[str]:
    """Return, where the file's name of a bat is not known, for which bat it is taken; nothing where all are known."""
    pairs = zip(model.swings, model.bat_of, strict=True)
    names = sorted({swing.bat for swing, index in pairs if index == 0 and swing.bat})
    bat_now = model.bats[0].bat.name
    return [
        f"The file calls the bat {maybe_meant(name, bat_names())}, which is not known here: it is taken for {bat_now}."
        for name in names
    ]


def _reasons(swings: SwingFile) -> list[str]:
    """Return the commonest reasons why rows are not used: those that differ in their numbers only are one."""
    alike: dict[str, list[BadRow]] = defaultdict(list)
    for row in swings.bad_rows:
        alike[re.sub(r"[-\d.]+", "", row.reason)].append(row)
    reasons = []
    for rows in sorted(alike.values(), key=len, reverse=True)[:REASONS]:
        reason = shorten(rows[0].reason, LONGEST_REASON, placeholder=" ...")
        reasons.append(f"row {rows[0].row}{f' and {len(rows) - 1} like it' if len(rows) > 1 else ''}: {reason}")
    return reasons


def measured(posterior: PlayerPosterior) -> Words:
    """Return the bats of the file against each other as they were measured; "" where only one was swung."""
    swung = [bat for bat in measured_bats(posterior.model) if bat.exit_speed is not None]
    if len(swung) < 2:
        return ""
    swung.sort(key=lambda bat: -float(bat.exit_speed or 0.0))
    parts = [
        say("{bat.bat.name} {bat.exit_speed:speed, ends}", bat=bat)
        + (say(" at {speed:speed, ends} of bat speed", speed=bat.bat_speed) if bat.bat_speed else "")
        for bat in swung
        if bat.exit_speed
    ]
    return say("As measured, mean exit speed by bat: {parts}.", parts=joined(parts, "; "))


def _speed(posterior: PlayerPosterior) -> Sentence:
    learned, bat_now = posterior.learned, posterior.model.bats[0].bat
    swung = any(measured.bat is bat_now for measured in measured_bats(posterior.model))
    text = say(
        "Bat speed is {mean} on average and varies by {spread} from swing to swing."
        if swung
        else "With {own}, which no swing of the file was made with, bat speed would be {mean} on average and vary by "
        "{spread} from swing to swing.",
        own=bat_now.name,
        mean=parameter_shown("bat_speed", learned["bat_speed"].interval),
        spread=parameter_shown("bat_speed_spread", learned["bat_speed_spread"].interval),
    )
    exponent = learned["exponent"]
    if exponent.told:
        slower = _slower(exponent.interval)
        return text + say(" A bat with 10 % more moment of inertia is swung {slower} slower.", slower=slower)
    unknown = " How much a heavier bat would slow this player is not known from these swings: "
    if len(measured_bats(posterior.model)) > 1:
        return text + unknown + "the bats are too much alike for it, or too few swings were made with each."
    return text + unknown + "they need two bats."


def _sensor(model: PlayerModel) -> list[Words]:
    """Return a warning of the errors of the sensor, where these are published."""
    if model.sensor is None:
        return []
    return [
        say(
            "Bat speeds are as {sensor.name} reads them. Against motion capture its readings were off by "
            "{sensor.speed_bias:share} on average, and single swings by {sensor.speed_noise:speed_change} more or "
            "less; attack angles by {sensor.angle_noise:angle, 0}. So how lively ball and bat are is left more open. "
            "Bats swung with the same sensor are off alike, and what they differ by stands.",
            sensor=model.sensor,
        )
    ]


def _slower(exponent: Interval) -> Sentence:
    parts = [1 - 1.1**-value for value in (exponent.value, exponent.low, exponent.high)]
    return within(Interval(*parts), "share", digits=1)


def _contact(learned: dict[str, Learned]) -> Sentence:
    text = say(
        "The ball is met {place} from the tip on average, with a scatter of {spread} along the bat",
        place=parameter_shown("position", learned["position"].interval),
        spread=parameter_shown("position_spread", learned["position_spread"].interval),
    )
    if learned["offset_spread"].told:
        spread = parameter_shown("offset_spread", learned["offset_spread"].interval)
        text += say(" and of {spread} over and under it", spread=spread)
    return text + "."


def _which(advice: Advice) -> Sentence:
    goal = advice.goal
    lead = say("Expected {goal} with the bat now: {now}.", goal=goal_words(goal), now=goal_shown(advice.now, goal))
    return joined([lead, of_those_swung(advice), _chances(advice), _of_those_tried(advice)])


def _chances(advice: Advice) -> Words:
    """Say how likely each of several bats is the best, where own swings tell anything of it."""
    choice = advice.choice
    if choice is None or not choice.own:
        return ""
    listed = joined([say("{bat.name} {bat.chance:share}", bat=bat) for bat in choice.bats], ", ")
    return say("Chance of being the best: {listed}.", listed=listed)


def _of_those_tried(advice: Advice) -> Words:
    """Name the best of the changes tried in the computer that the player's own swings tell of."""
    by_swings = [option for option in advice.options if option.own and option.candidate.family != "swung"]
    if not by_swings:
        return CANNOT_TELL_BATS
    best = by_swings[0]
    if best.change.value <= advice.goal.nothing:
        return "None of the bats tried in the computer is better by these swings."
    return say(
        "{lead}: {label} ({size}), {change}, better in {chance:share} of what the data allow.",
        lead="Best of those tried in the computer"
        if advice.sign_of(best) > 0
        else "Of those tried in the computer none is surely better; the likeliest gain is with",
        label=option_words(best.candidate),
        size=_sizes(best),
        change=goal_shown(best.change, advice.goal, sign=True),
        chance=best.chance,
    )


def _sizes(option: Option) -> Sentence:
    bat, body = option.candidate.bat, option.candidate.body
    return say(
        "{length:place}, {mass:mass}, MOI {moi:moi} about {axis:place, 0} above the grip's end",
        length=bat.length,
        mass=body.mass,
        moi=body.moi(bat.choke + STANDARD_AXIS),
        axis=STANDARD_AXIS,
    )


def _weight(advice: Advice) -> Sentence:
    options = [option for option in advice.options if option.candidate.family == "weight"]
    by_swings = [option for option in options if option.own]
    if not options:
        return say("None could be tried.")
    if not by_swings:
        return say("{words}", words=CANNOT_TELL)
    listed = joined(
        [
            say(
                "{label} {change}",
                label=option_words(option.candidate),
                change=goal_shown(option.change, advice.goal, sign=True),
            )
            for option in sorted(by_swings, key=lambda option: option.candidate.body.moi(0.0))
        ],
        "; ",
    )
    if advice.sign_of(by_swings[0]) > 0:
        return say("Best is {label}. {listed}.", label=option_words(by_swings[0].candidate), listed=listed)
    return say(
        "No other weight tried is surely better for {goal}. {listed}.", goal=goal_words(advice.goal), listed=listed
    )


def _length(advice: Advice) -> Sentence:
    """Say that length is known only of bats that were swung: it changes more than radius and moment of inertia."""
    lengths = {round(table.bat.length / INCH, 1) for table in advice.posterior.model.bats}
    if len(lengths) > 1:
        return say("Only the bats that were swung tell: see the first answer.")
    return say("{words}", words=LENGTH_UNKNOWN)


def _end_loaded(advice: Advice) -> Sentence:
    ends = [option for option in advice.options if option.candidate.family == "balance"]
    if not any(option.own for option in ends):
        return say("{words}", words=CANNOT_TELL)
    words = {1: "End-loaded", -1: "Balanced", 0: CANNOT_TELL.rstrip(".")}
    verdict = sure_sign(advice.end_loaded.low, advice.end_loaded.high, nothing=advice.goal.nothing)
    return say(
        "{answer}: the same weight of {mass:mass} at the tip instead of at the knob changes {goal} by {gain}.",
        answer=words[verdict],
        mass=OUNCE,
        goal=goal_words(advice.goal),
        gain=goal_shown(advice.end_loaded, advice.goal, sign=True),
    )


def _choke(advice: Advice) -> Sentence:
    option = next((option for option in advice.options if option.candidate.key == "choke1in"), None)
    if option is None:
        return say("Could not be tried.")
    if not option.own:
        return say(
            "{words}",
            words=CANNOT_TELL,
        )
    return say(
        "{answer}, as far as {goal} goes: held {inch:place} further up, bat speed is {speed:speed, ends} and the "
        "change {gain}. Better control, if there is any, is not counted; compare it with what less scatter is worth.",
        answer={1: "Yes", -1: "No", 0: "These swings cannot tell"}[advice.sign_of(option)],
        goal=goal_words(advice.goal),
        inch=INCH,
        speed=option.bat_speed,
        gain=goal_shown(option.change, advice.goal, sign=True),
    )


def _place(advice: Advice) -> Sentence:
    text = say(
        "On average {place:place, ends} from the tip; against where it is met now that is worth {gain}.",
        place=advice.contact_point,
        gain=goal_shown(advice.contact_gain, advice.goal, sign=True),
    )
    if advice.goal.name == "exit-speed":
        return text
    return text + say(
        " And with the ball's centre {high:place, ends} above the bat's axis on average, worth {more}.",
        high=advice.height_point,
        more=goal_shown(advice.height_gain, advice.goal, sign=True),
    )


def notes(swings: SwingFile) -> list[str]:
    """Return notes on the file, with the rows that were not used."""
    words = list(swings.notes)
    if swings.bad_rows:
        count = len(swings.bad_rows)
        first = "; ".join(f"row {row.row}: {row.reason}" for row in swings.bad_rows[:ROWS_SHOWN])
        more = f"; and {count - ROWS_SHOWN} more, all in the JSON" if count > ROWS_SHOWN else ""
        words.append(f"{count} row{'s are' if count != 1 else ' is'} not used: {first}{more}.")
    if swings.without_swing:
        words.append(f"{swings.without_swing} rows have neither bat speed nor exit speed and are no swings.")
    return words
