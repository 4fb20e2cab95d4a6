"""A player's fit in plain words: what the swings say, what they cannot, and what would serve."""

from __future__ import annotations

import math
from typing import Any

from sweetspot.motion.swing_law import Interval
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.player.advice import Advice, Option
from sweetspot.player.goal import told
from sweetspot.player.posterior import Learned, Posterior
from sweetspot.player.swings import Swings
from sweetspot.report.player.units import scale
from sweetspot.units import INCH, MPH, OUNCE, OUNCE_INCH_SQUARED

PARAMETERS: dict[str, tuple[str, float, int, str]] = {
    "bat_speed": ("mean bat speed", MPH, 1, "mph"),
    "bat_speed_spread": ("bat speed, swing to swing", MPH, 1, "mph"),
    "exponent": ("what a heavier bat costs in speed: exponent n", 1.0, 2, ""),
    "position": ("mean contact, from the tip", INCH, 1, "in"),
    "position_spread": ("scatter of contact along the bat", INCH, 1, "in"),
    "offset": ("mean height of the ball over the bat's axis", INCH, 2, "in"),
    "offset_spread": ("scatter of that height", INCH, 2, "in"),
    "attack_angle": ("mean attack angle", math.pi / 180, 1, "deg"),
    "efficiency_shift": ("ball and bat livelier than the model: change of q", 1.0, 3, ""),
    "exit_noise": ("exit speed beyond the model", MPH, 1, "mph"),
}
"""Of every parameter: its name in words, the size of its unit, digits, the unit."""
BADLY_MIXED = (
    "The draws have not mixed well: the intervals may be too narrow. Ask for more steps, or look for rows in the file "
    "that do not belong together."
)


def shown(interval: Interval, unit: tuple[float, int, str], *, sign: str = "") -> str:
    """Return a value with its interval: ``+1.2 mph (+0.4 to +2.0)``."""
    size, digits, name = unit
    value, low, high = (f"{end / size:{sign}z.{digits}f}" for end in (interval.value, interval.low, interval.high))
    return f"{value} {name} ({low} to {high})".replace("  ", " ")


def parameter_shown(one: Learned | str, interval: Interval) -> str:
    """Return a parameter's interval in the unit that people use for it."""
    _, size, digits, unit = PARAMETERS[one if isinstance(one, str) else one.name]
    return shown(interval, (size, digits, unit))


def findings(posterior: Posterior, swings: Swings) -> list[str]:
    """Return what the swings say about the player, and what they cannot tell."""
    found = posterior.learned
    words = [_data(posterior, swings), _speed(found), _contact(found)]
    unknown = [PARAMETERS[name][0] for name, one in found.items() if not one.told]
    if unknown:
        words.append(
            f"The data cannot tell: {'; '.join(unknown)}. What is shown for these is what is usual for players."
        )
    if not posterior.converged:
        words.append(BADLY_MIXED)
    return words


def answers(advice: Advice) -> list[tuple[str, str]]:
    """Return questions that players ask, each with its answer and interval."""
    goal = told(advice.goal)
    return [
        ("Which bat?", _which(advice)),
        ("Heavier or lighter?", _family(advice, "weight", f"No other weight tried is surely better for {goal}.")),
        ("Balanced or end-loaded?", _end_loaded(advice)),
        ("Longer or shorter?", _family(advice, "length", "Neither an inch more nor an inch less is surely better.")),
        ("Choke up?", _choke(advice)),
        ("Where should the ball meet the bat?", _place(advice)),
        ("What is one inch worth?", _inch(advice)),
        ("What is one mph of bat speed worth?", _worth(advice, "bat_speed", "One mph of bat speed")),
    ]


def _data(posterior: Posterior, swings: Swings) -> str:
    count = len(posterior.model.swings)
    both = sum(one.exit_speed is not None and one.bat_speed is not None for one in posterior.model.swings)
    kind = f"{swings.system} file" if swings.system != "plain" else "file"
    days = ""
    if swings.first_day and swings.last_day:
        same = swings.first_day == swings.last_day
        days = f" of {swings.first_day}" if same else f" from {swings.first_day} to {swings.last_day}"
    bats = len(posterior.model.bats)
    return (
        f"{count} swing{'s' if count != 1 else ''} from a {kind}{days}, {both} with bat speed and exit speed"
        f"{f', with {bats} bats' if bats > 1 else ''}."
    )


def _speed(found: dict[str, Learned]) -> str:
    mean = parameter_shown("bat_speed", found["bat_speed"].interval)
    spread = parameter_shown("bat_speed_spread", found["bat_speed_spread"].interval)
    text = f"Bat speed is {mean} on average and varies by {spread} from swing to swing."
    exponent = found["exponent"]
    if exponent.told:
        return f"{text} A bat with 10 % more moment of inertia is swung {_slower(exponent.interval)} slower."
    return f"{text} How much a heavier bat would slow this player is not known from these swings: they need two bats."


def _slower(exponent: Interval) -> str:
    ends = [100 * (1 - 1.1**-value) for value in (exponent.value, exponent.low, exponent.high)]
    return f"{ends[0]:.1f} % ({ends[1]:.1f} to {ends[2]:.1f})"


def _contact(found: dict[str, Learned]) -> str:
    position, spread = found["position"], found["position_spread"]
    text = (
        f"The ball is met {parameter_shown('position', position.interval)} from the tip on average, with a scatter of "
        f"{parameter_shown('position_spread', spread.interval)} along the bat"
    )
    if found["offset_spread"].told:
        text += f" and of {parameter_shown('offset_spread', found['offset_spread'].interval)} over and under it"
    return f"{text}."


def _verdict(interval: Interval) -> int:
    """Return 1 for a gain, -1 for a loss, 0 where the interval holds zero or is nothing."""
    return 1 if interval.low > NOTHING else -1 if interval.high < -NOTHING else 0


def _which(advice: Advice) -> str:
    best, unit = advice.options[0] if advice.options else None, scale(advice.goal)
    own = f"Expected {told(advice.goal)} with the bat now: {shown(advice.now, unit)}."
    if best is None or best.change.value <= 0:
        return f"{own} None of the bats tried is better."
    size = _sizes(best)
    sure = _verdict(best.change) > 0
    lead = "Best of those tried" if sure else "None is surely better; the likeliest gain is with"
    return (
        f"{own} {lead}: {best.candidate.label} ({size}), {shown(best.change, unit, sign='+')}, "
        f"better in {100 * best.chance:.0f} % of what {_speaker(advice)}."
        f"{'' if advice.posterior.learned['exponent'].told else USUAL_EXPONENT}"
    )


def _sizes(option: Option) -> str:
    bat, body = option.candidate.bat, option.candidate.body
    moi = body.moi(bat.choke + STANDARD_AXIS) / OUNCE_INCH_SQUARED
    return (
        f"{bat.length / INCH:.1f} in, {body.mass / OUNCE:.1f} oz, MOI {moi:,.0f} oz in² about 6 in above the grip's end"
    )


def _speaker(advice: Advice) -> str:
    """Return who says how fast another bat is swung: the data, or a law."""
    told_by_data = advice.posterior.learned["exponent"].told
    return (
        "the data allow" if told_by_data else "the average player's swing law allows, these swings saying nothing of it"
    )


def _by_law(advice: Advice) -> str:
    """Return that an answer is the law's, where these swings do not know how another bat would be swung."""
    if advice.posterior.learned["exponent"].told:
        return ""
    return " by the average player's swing law (these swings do not know it)"


def _family(advice: Advice, family: str, nothing: str) -> str:
    options = [option for option in advice.options if option.candidate.family == family]
    if not options:
        return "None could be tried."
    unit = scale(advice.goal)
    listed = "; ".join(
        f"{option.candidate.label} {shown(option.change, unit, sign='+')}"
        for option in sorted(options, key=lambda option: option.candidate.body.moi(0.0))
    )
    best = options[0]
    if _verdict(best.change) > 0:
        return f"{best.candidate.label[0].upper()}{best.candidate.label[1:]} is best{_by_law(advice)}. {listed}."
    return f"{nothing} {listed}."


def _end_loaded(advice: Advice) -> str:
    gain = shown(advice.end_loaded, scale(advice.goal), sign="+")
    against = f"the same ounce at the tip instead of at the knob changes {told(advice.goal)} by {gain}"
    words = {1: "End-loaded", -1: "Balanced", 0: "These swings cannot tell"}
    verdict = _verdict(advice.end_loaded)
    return f"{words[verdict]}{_by_law(advice) if verdict else ''}: {against}."


def _choke(advice: Advice) -> str:
    option = next((one for one in advice.options if one.candidate.key == "choke1in"), None)
    if option is None:
        return "Could not be tried."
    speed, gain = shown(option.bat_speed, (MPH, 1, "mph")), shown(option.change, scale(advice.goal), sign="+")
    words = {1: "Yes", -1: "No", 0: "These swings cannot tell"}[_verdict(option.change)]
    return (
        f"{words}, as far as {told(advice.goal)} goes: held 1 in further up, bat speed is {speed} and the change "
        f"{gain}. Better control, if there is any, is not counted; compare it with what an inch is worth."
    )


def _place(advice: Advice) -> str:
    place = shown(advice.contact_point, (INCH, 1, "in"))
    gain = shown(advice.contact_gain, scale(advice.goal), sign="+")
    text = f"On average {place} from the tip; against where it is met now that is worth {gain}."
    if advice.goal.name != "exit-speed":
        high = shown(advice.height_point, (INCH, 1, "in"))
        more = shown(advice.height_gain, scale(advice.goal), sign="+")
        text += f" And with the ball's centre {high} above the bat's axis on average, worth {more}."
    return text


def _inch(advice: Advice) -> str:
    unit, worth = scale(advice.goal), advice.worth
    parts = {
        "an inch less scatter along the bat": "position_spread",
        "a mean contact one inch nearer the tip": "towards_tip",
        "one inch nearer the hands": "towards_hands",
        "a quarter of an inch less scatter over and under the ball": "offset_spread",
    }
    told_parts = "; ".join(f"{words} {shown(worth[key].gain, unit, sign='+')}" for words, key in parts.items())
    return f"{told_parts[0].upper()}{told_parts[1:]}."


def _worth(advice: Advice, key: str, what: str) -> str:
    return f"{what}: {shown(advice.worth[key].gain, scale(advice.goal), sign='+')} of {told(advice.goal)}."


def notes(swings: Swings) -> list[str]:
    """Return what to know about the file, with the rows that were not used."""
    words = list(swings.notes)
    if swings.bad_rows:
        count = len(swings.bad_rows)
        first = "; ".join(f"row {row.row}: {row.reason}" for row in swings.bad_rows[:ROWS_SHOWN])
        more = f"; and {count - ROWS_SHOWN} more, all in the JSON" if count > ROWS_SHOWN else ""
        words.append(f"{count} row{'s are' if count != 1 else ' is'} not used: {first}{more}.")
    if swings.without_swing:
        words.append(f"{swings.without_swing} rows have neither bat speed nor exit speed and are no swings.")
    return words


ROWS_SHOWN = 8
"""Rows not used that are listed; the JSON has all."""
NOTHING = 1e-9
USUAL_EXPONENT = (
    " How much slower this player swings a heavier bat is not known from these swings: every answer about another bat "
    "rests on what is usual for players, and its interval with it."
)


def facts(posterior: Posterior) -> list[dict[str, Any]]:
    """Return a row per parameter for a table: value, interval, what was known before, whether the data told."""
    return [
        {
            "parameter": PARAMETERS[name][0],
            "value (95 %)": parameter_shown(one, one.interval),
            "before the data": parameter_shown(one, one.before),
            "width ratio": f"{one.width_ratio:.2f}",
            "learned": "yes" if one.told else "data cannot tell",
        }
        for name, one in posterior.learned.items()
    ]
