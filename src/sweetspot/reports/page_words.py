"""Sentences that the page says over its pictures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from sweetspot.answers.flight import BallLeaving, FlightEnd
from sweetspot.equipment.sport import Terms
from sweetspot.reports.quantities import ENERGY_NAMES, FILM_NAMES
from sweetspot.reports.sentences import Sentence, Slot, joined, say
from sweetspot.reports.sport_words import in_words
from sweetspot.units import RPM

LEAST_SHARE = 0.004
"""Part of the energy below which it would be printed as 0 %."""
SURE = 0.05
"""Chances nearer to 0 or 1 are reported as one outcome."""
NEAR = 1.0
"""m from a fence's top within which margins are in inches or centimetres."""
STRAIGHT = 5e-4
"""rad off centre field below which a direction counts as centre field."""
NO_SPIN = RPM / 2
"""rad/s of sidespin that would be printed as none."""
FEW = 1e-4
"""Part of a tap's energy below which a motion's part is reported as less than this."""


def hits_fastest(name: str, from_tip: float, exit_speed: float, *, words: Terms) -> Sentence:
    """Return the place of the greatest exit speed, m from the tip, and that speed, m/s."""
    return in_words(
        "{name} hits fastest {place:place} from the {tip}: {speed:speed}.",
        words,
        name=name,
        place=from_tip,
        speed=exit_speed,
    )


def cost_of_misses(exit_speed: float, sides: Mapping[str, float], *, step: float, words: Terms) -> Sentence:
    """Return an exit speed, m/s, and what a hit a step, m, further to each side loses of it, by the side's name.

    >>> from sweetspot.equipment.sport import Terms
    >>> print(cost_of_misses(28.4, {"hands": 3.1, "tip": -0.9}, step=0.0508, words=Terms()))
    63.5 mph here; 2 in towards the hands costs 6.9 mph, 2 in towards the tip gains 2 mph.
    """
    parts = [
        in_words(
            "{step} towards the {side} {verb} {change}",
            words,
            step=Slot(step, "place", 0),
            side=in_words(f"{{{side}}}", words),
            change=Slot(abs(loss), "speed", round=True),
            verb="costs" if loss >= 0 else "gains",
        )
        for side, loss in sides.items()
    ]
    here = in_words("{speed} here", words, speed=Slot(exit_speed, "speed"))
    return say("{here}; {sides}.", here=here, sides=joined(parts, ", ")) if parts else say("{here}.", here=here)


def brought_bat(*, length: float, widest: float, mass: float, material: str, guessed: int) -> list[Sentence]:
    """Return the size of an outline, m, and what makes a bat of it, kg; guessed: ends that were not measured.

    >>> bat = brought_bat(length=0.8636, widest=0.0635, mass=0.88, material="white ash", guessed=1)
    >>> print(bat[0])
    Read: 34.0 in long, 2.50 in at its widest.
    """
    read = say("Read: {length:place} long, {widest:length} at its widest.", length=length, widest=widest)
    assumed = say(
        "Assumed: turned of solid {material} of usual density, so that it weighs {mass:mass}; if you weighed it, "
        "set its weight in the workshop.",
        material=material,
        mass=mass,
    )
    ends = say("No one measured the very {ends}: rounded as bats usually are.", ends="ends" if guessed > 1 else "end")
    return [read, assumed, *([ends] if guessed else [])]


def assumed_measures(
    pattern: str,
    *,
    mass: float | None,
    balance: float | None,
    moi: float | None,
    axis: float,
    lively: bool,
    words: Terms,
) -> list[Sentence]:
    """Return the properties that a description leaves open: kg, m from the butt and kg m^2; None: it was given.

    >>> from sweetspot.equipment.sport import Terms
    >>> for line in assumed_measures("R161", mass=None, balance=0.56, moi=None, axis=0.15, lively=False, words=Terms()):
    ...     print(line)
    Its shape and what it is made of are those of R161, stretched to its length.
    Balance point not measured: 22.0 in from the knob, as its shape has it.
    """
    lines = [say("Its shape and what it is made of are those of {pattern}, stretched to its length.", pattern=pattern)]
    if mass is not None:
        lines.append(say("Weight not given: {mass:mass}, in proportion.", mass=mass))
    if balance is not None:
        template = "Balance point not measured: {balance:place} from the {butt}, as its shape has it."
        lines.append(in_words(template, words, balance=balance))
    if moi is not None:
        template = "Swing weight not measured: {moi:moi} about {axis:place} from the {butt}."
        lines.append(in_words(template, words, moi=moi, axis=axis))
    if lively:
        lines.append(say("How lively its barrel is follows from its wall, which was not measured; a stamp is a limit."))
    return lines


def place_words(from_tip: float, *, words: Terms) -> Sentence:
    """Return the position of a place on an implement, m from the tip."""
    return in_words("{place:place} from the {tip}", words, place=from_tip)


def leaves_here(
    from_tip: float, exit_speed: float | None, *, ends: str, words: Terms, aside: float = 0.0, backwards: bool = False
) -> Sentence:
    """Return how fast a ball leaves a place, m from the tip and aside; ``ends`` says what happens where it does not."""
    off = say(" and {aside:place} off the line", aside=abs(aside)) if aside else ""
    return in_words(
        "Here, {place} from the {tip}{off}: {speed}" + (", fouled back." if backwards else "."),
        words,
        place=Slot(from_tip, "place"),
        off=off,
        speed=ends if exit_speed is None else Slot(exit_speed, "speed"),
    )


def energy_words(shares: Mapping[str, float], words: Terms) -> list[Sentence]:
    """Return in a sentence where the energy of a hit goes, by part of `ENERGY_NAMES`; none where nothing is known."""
    parts = [
        in_words(ENERGY_NAMES[name][0] + " {share}", words, share=Slot(share, "share"))
        for name, share in shares.items()
        if share > LEAST_SHARE
    ]
    return [say("Of the energy of the meeting: {parts}.", parts=joined(parts, "; "))] if parts else []


def energy_names(parts: Iterable[str], words: Terms) -> dict[str, str]:
    """Return the names of parts of a hit's energy, in the sport's words."""
    return {name: str(in_words(ENERGY_NAMES[name][0], words)) for name in parts}


def film_energy_names(parts: Iterable[str], words: Terms) -> dict[str, str]:
    """Return the names of parts of the energy while a hit lasts, in the sport's words."""
    return {name: str(in_words(FILM_NAMES[name], words)) for name in parts}


def film_energy_words(incoming: float, last: Mapping[str, float], words: Terms) -> Sentence:
    """Return the incoming energy and where it is at a film's end, J, by part of `FILM_NAMES`."""
    parts = [
        in_words(FILM_NAMES[name] + " {energy}", words, energy=Slot(energy, "energy")) for name, energy in last.items()
    ]
    return say(
        "Where the {incoming:energy} of incoming energy are over time. At the end: {parts}.",
        incoming=incoming,
        parts=joined(parts, ", "),
    )


def film_speeds(bat: float, ball: float, exit_speed: float) -> Sentence:
    """Return the speeds with which bat and ball meet at a place and the ball leaves, m/s."""
    bat_slot, ball_slot, exit_slot = (Slot(speed, "speed", digits=0) for speed in (bat, ball, exit_speed))
    return say(
        "the bat comes at {bat} here, the ball at {ball}; it leaves at {exit}",
        bat=bat_slot,
        ball=ball_slot,
        exit=exit_slot,
    )


def force_words(peak: float) -> Sentence:
    """Describe a picture of the force in time, N, and of the hands' motion."""
    words = "Force on the ball, at most {peak}, and speed of the bat under the top hand, in time."
    return say(words, peak=Slot(peak, "blow"))


BEFORE = -1.0
"""s before first touch at which every film has begun."""


def film_phases(release: float, arrival: float | None) -> list[tuple[float, str]]:
    """Return the phases of a hit from some moments on, s after first touch; earliest first.

    The words have the names of what changes all the time: {moment}, {pressed}, {force}.
    """
    ball = list(zip((BEFORE, 0.0, release), FILMED_BALL, strict=True))
    hands = list(zip((BEFORE,) if arrival is None else (BEFORE, arrival), FILMED_HANDS, strict=False))
    phases = []
    for start in sorted({moment for moment, _ in ball + hands}):
        doing, felt = (next(words for moment, words in reversed(row) if moment <= start) for row in (ball, hands))
        phases.append((start, FILMED.format(doing=doing, felt=felt)))
    return phases


FILMED_BALL = ("the ball is on its way", "the ball is pressed in by {pressed} with {force}", "the ball has left")
"""Before first touch, from then on, and when it has left."""
FILMED_HANDS = ("the hands feel nothing yet", "the wave has reached the hands")
FILMED = "{{moment}} after first touch: {doing}; {felt}"
"""What a film shows at a moment."""


def wave_words(name: str, *, contact_time: float, arrival: float | None, given: float | None) -> list[Sentence]:
    """Return how long the push lasts, and whether what the hands do could still reach the ball.

    Parameters
    ----------
    arrival : s, of the wave at the top hand; None: none arrives.
    given : part of the push that the ball has had by then.
    """
    push = say("{name}: the push is over {time:contact, 2} after first touch.", name=name, time=contact_time)
    if arrival is None or given is None:
        return [push, say("No wave to speak of reaches the top hand in this film.")]
    wave = say(
        "The wave reaches the top hand {time:contact, 2} after first touch, when the ball has had {share:share} of "
        "its push.",
        time=arrival,
        share=given,
    )
    late = "too late." if 2 * arrival > contact_time else "while ball and bat still push each other."
    back = say(
        "What the hands do about it could be back at the ball after {time}, " + late,
        time=Slot(2 * arrival, "contact", digits=2),
    )
    return [push, wave, back]


def motion_words(
    name: str,
    family: str,
    *,
    frequency: float,
    waves: tuple[int, int | None],
    nodes: Sequence[float],
    tap: tuple[float, float | None],
) -> list[Sentence]:
    """Return the kind of a motion of a bat, its nodes, and its share of a tap's energy.

    Parameters
    ----------
    waves : of a hoop mode, around the barrel, and half waves along it.
    nodes : m from the tip.
    tap : m from the tip, and the part of the vibration's energy that it gives; None: it is no vibration.
    """
    (around, along), (place, share) = waves, tap
    head = name if family == "rigid" else say("{name}, {tone:frequency}", name=name, tone=frequency)
    halves = f"{along} half {'wave' if along == 1 else 'waves'}"
    kinds = {
        "rigid": "{head}: the bat moves without bending.",
        "hoop": f"{{head}}: the barrel goes out of round with {around} waves around it and {halves} along it.",
        "hand": "{head}: hands and bat against each other, on the hands' flesh.",
    }
    words = [say(kinds.get(family, "{head}."), head=head)]
    if nodes:
        *others, last = [say("{place:length}", place=node) for node in nodes]
        places = joined([joined(others, ", "), last], " and ")
        words.append(say("It stands still {places} from the tip.", places=places))
    else:
        words.append(say("It stands still nowhere along the bat."))
    if share is not None:
        digits = 2 if share < 0.01 else 1
        part = say("less than {few:share, 2}", few=FEW) if 0 < share < FEW else ""
        words.append(
            say(
                "The tap {place:length} from the tip gives it {share} of the vibration's energy.",
                place=place,
                share=part or Slot(share, "share", digits=digits),
            )
        )
    return words


def missed_words() -> Sentence:
    """Return the sentence for a swing after which no ball leaves."""
    return say("The bat misses the ball, or the ball does not come off it. Move the ball nearer to the bat's axis.")


def outcome_words(end: FlightEnd, *, carry: float, chance: float) -> Sentence:
    """Return the outcome of a ball in a park, with the likelihood from balls that are hit alike.

    Parameters
    ----------
    carry : m to the ground.
    chance : of a home run by balls that are hit like it.
    """
    out = end.outcome == "home run"
    name = "home run" if out else "in play"
    lead = f"{name.capitalize()}: "
    if SURE < chance < 1 - SURE:
        lead = ("Probably " if out == (chance > 0.5) else "Perhaps ") + f"{'a ' if out else ''}{name}: "
    ways = {
        "home run": lead + "over the fence of {park}, {clearance} above its top at {distance}.",
        "off the wall": lead + "against the fence of {park}, {clearance} below its top at {distance}.",
        "in play": lead + "comes down {carry} from the plate in {park}.",
        "foul": "Foul.",
    }
    return say(
        ways[end.outcome],
        park=end.park,
        clearance=_clearance(end),
        distance=Slot(end.distance, "distance"),
        carry=Slot(carry, "distance"),
    )


def _clearance(end: FlightEnd) -> Slot:
    above = 0.0 if end.clearance is None else abs(float(end.clearance))
    return Slot(above, "place" if above < NEAR else "distance")


def margin_words(end: FlightEnd) -> list[Sentence]:
    """Return by how much a ball passes the top of a fence or stays below it; nothing where it does not reach it."""
    if end.clearance is None:
        return []
    return [say("{way} by {clearance}", way="over" if float(end.clearance) > 0 else "short", clearance=_clearance(end))]


def side_words(end: FlightEnd, *, apex: float, carry: float) -> Sentence:
    """Describe a picture of a flight from the side; m."""
    passes = say("not reaching the fence")
    if end.clearance is not None:
        way = "above" if float(end.clearance) > 0 else "below"
        passes = say("{clearance} {way} the fence's top", clearance=_clearance(end), way=way)
    return say(
        "The flight from the side: {apex} high at its apex, {carry} of carry, {passes}.",
        apex=Slot(apex, "distance"),
        carry=Slot(carry, "distance"),
        passes=passes,
    )


def above_words(end: FlightEnd) -> Sentence:
    """Describe a picture of a flight from above."""
    return say(
        "The field of {park} from above, with the path of the ball, which is {outcome}.",
        park=end.park,
        outcome=end.outcome,
    )


def chance_words(chance: float) -> list[Sentence]:
    """Return how many balls that are hit alike are home runs, where that is not all or none."""
    if not SURE < chance < 1 - SURE:
        return []
    return [say("Of a hundred like it {count:count} are home runs.", count=100 * chance)]


def parks_words(count: int, of: int) -> Sentence:
    """Return in how many parks a ball is out."""
    return say(f"Out in {count} of {of} {'park' if of == 1 else 'parks'}.")


def leaving_words(ball: BallLeaving) -> Sentence:
    """Return how a ball leaves the bat: how fast, where to and with which spin."""
    up, spray, back, bend = (float(side) for side in (ball.launch_angle, ball.spray, ball.backspin, ball.sidespin))
    side = say("to centre field")
    if abs(spray) > STRAIGHT:
        side = say("{spray} to " + ("left" if spray < 0 else "right") + " field", spray=Slot(abs(spray), "angle"))
    bent = say(" and {spin} that bend it " + ("right" if bend < 0 else "left"), spin=Slot(abs(bend), "spin"))
    return say(
        f"The ball leaves at {{speed}}, {{angle}} {'down' if up < 0 else 'up'}, {{side}}, with {{spin}} of "
        f"{'topspin' if back < 0 else 'backspin'}{{bent}}.",
        speed=Slot(ball.exit_speed, "speed"),
        angle=Slot(abs(up), "angle"),
        side=side,
        spin=Slot(abs(back), "spin"),
        bent=bent if abs(bend) > NO_SPIN else "",
    )


def bat_speed_words(speed: float) -> Sentence:
    """Return how fast the bat moves where it meets the ball."""
    return say("The bat moves at {speed:speed} where they meet.", speed=speed)


def park_chances(park: str) -> Sentence:
    """Describe a map of the chances of home runs in a park."""
    words = (
        "How likely a ball to centre field leaves {park}, in its own air, with what balls, spin and weather scatter by."
    )
    return say(words, park=park)


def carries_farthest(exit_speed: float, launch_angle: float, carry: float) -> Sentence:
    """Return the launch angle at which a ball so fast carries farthest."""
    return say(
        "A ball at {speed:speed} carries farthest at {angle:angle}: {carry:distance}.",
        speed=exit_speed,
        angle=launch_angle,
        carry=carry,
    )
