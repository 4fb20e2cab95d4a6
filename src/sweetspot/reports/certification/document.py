"""A bat test and the rules held against it as a document."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from functools import partial
from math import hypot

from sweetspot.analysis.certification.rules import QUANTITIES, Verdict, title
from sweetspot.analysis.certification.shot_statistics import Estimate
from sweetspot.analysis.certification.simulated_test import BASEBALL_TEST, CLAMP, Certification, SwungTest
from sweetspot.answers.bat_test import MeasuredShots, MeasureSpreads, ScanAtRest, SimulatedTest, SpeedEstimate
from sweetspot.answers.certify import CertifyAnswer, CertifyQuestion, RuleCheck, WallThatPasses, certificate_of
from sweetspot.catalog.balls import ball
from sweetspot.catalog.bats import WALL_DOUBT, wall_pattern
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.rigid import moi_doubt
from sweetspot.reports.bat.provenance import soft_note
from sweetspot.reports.bat.tables import moment
from sweetspot.reports.certification.limits_shown import (
    broken_rules,
    limit_shown,
    unsure_words,
    value_shown,
    value_with_ends,
)
from sweetspot.reports.certification.rules_shown import applying, listed, reasons, rules_table
from sweetspot.reports.document import (
    Block,
    Cell,
    Column,
    Document,
    Paragraph,
    Picture,
    Table,
    as_columns,
    drawn,
    table_head,
)
from sweetspot.reports.sentences import PLUS_MINUS, Line, Sentence, Slot, Span, Words, joined, say, tell
from sweetspot.reports.uncertainty import chance_words, how_sure

NORMALISED_NOTE = " The ball is the catalogue's; a test normalises to one."
PATCH_NOTE = "By the ball: with the smallest and the largest patch through which it can push." + NORMALISED_NOTE
BALL_NOTE = (
    "By the ball: with the smallest and the largest patch through which it can push, with as little and as much of its "
    "loss going with the rate at which it is pressed, and as soft and as hard, as the evidence allows (90 %). On wood "
    "none of it matters much." + NORMALISED_NOTE
)
MOI_NOTE = (
    "By the MOI: it was not measured but follows from the outline, and ± is half of its 90 % interval. A bat that "
    "turns less easily gives more back; from BBCOR and BPF that recoil is taken out. Measure it and give moi in the "
    "bat file."
)
ONE_PIECE = (
    " It is taken as one piece of wood, which need not meet BBCOR; of glued wood or bamboo say laminated = true in its "
    "[material]."
)
KEEPS = "How sure: it keeps the limit on {check.title} ({check.league_name}) with a probability of {chance}."
WALL = (
    Line(
        "The wall that just passes {measure} {wall.limit:ratio, 3} ({wall.league_name}): {millimetres:ratio, 2} mm in "
    ),
    Line("the middle of the barrel, {wall.factor:ratio, 2} times as thick as drawn. The bat would weigh "),
    Line("{wall.mass:mass} instead of {before:mass}."),
    Line(
        " A barrel that is thick only where it is hit, or a ring or disc inside ([[shell.ring]]), does it ", "thicker"
    ),
    Line("with less.", "thicker"),
)
FAILS_UNSURELY = "{bat} fails as far as is known, but not surely: {rules}. What is not known reaches across the limit."
MEASURE = "{name} {shown}, {by}, {place:place} from the tip{limit}."
UNDECIDED = "{bat} is not passed: this test does not decide {rules}: {reason}."
KEPT = "{bat} surely keeps {kept} of {all} rules and breaks none.{unsure}{left}"
OTHER_BALL = (
    'The test is with the ball that the rule names [{source}], "{ball}", not with "{own}", which this bat is swung at; '
    "--ball takes that."
)


def certificate_document(answer: CertifyAnswer) -> Document:
    """Return a tested bat as a document."""
    chances = [check for check in answer.checks if check.passes_probability is not None]
    blocks: list[Block] = [Paragraph(_headline(answer))] if answer.checks else []
    blocks.append(Paragraph(_measure_words(answer)))
    blocks += [Paragraph(joined(map(_chance_words, chances)))] if chances else []
    blocks += [Paragraph(words, "warning") for words in _superseded(answer.checks)]
    blocks += [Paragraph(words) for words in _ball_of_the_rule(answer)]
    blocks += [Paragraph(_passing(answer, wall)) for wall in answer.walls or ()]
    if answer.implement.remark:
        blocks.append(Paragraph(answer.implement.remark))
    details: list[Block] = []
    if answer.test is not None:
        blocks += [Paragraph(words) for words in _wall_note(answer, answer.test)]
        details += _simulated(answer, answer.test)
    if answer.shots is not None:
        blocks += listed(_remarks(answer.shots))
        details += _measured(answer.shots, length=answer.implement.length)
    blocks += soft_note(answer.implement.sport, answer.fired)
    if answer.checks:
        value = partial(_value, answer)
        blocks += [rules_table(each, value, sources=False) for each in [applying(answer.checks)] if each]
        if answer.uncertainty is None and any(_doubted(answer, check) for check in applying(answer.checks)):
            blocks.append(Paragraph(PLUS_MINUS, "note"))
        details += [rules_table(answer.checks, value), *listed(reasons(answer.checks))]
    picture = Picture(
        "certify",
        drawn("sweetspot.reports.certification.picture:certification_figure", answer),
        label=say("What the rules limit, place for place along {bat}, and the limits.", bat=answer.bat.name),
        caption="A test in the computer or on a bench; no certificate.",
        sheet=drawn("sweetspot.reports.certification.picture:certification_sheet", answer),
    )
    sure = [] if answer.uncertainty is None else [how_sure(answer.uncertainty, "BBCOR")]
    data = answer.to_dict()
    return Document(
        name="certify",
        title=answer.bat.name,
        subtitle=answer.ball,
        kind="Bat test",
        blocks=[*blocks, picture, *sure],
        appendix=details,
        data=data,
        rows=as_columns(data["checks"]),
        passed=answer.passed,
        drawing=picture,
    )


def certification_document(certification: Certification) -> Document:
    """Return a simulated test alone, with no rules held against it, as a document."""
    question = CertifyQuestion(certification.bat, (), certification.ball)
    return certificate_document(certificate_of(question, body=certification.body, test=certification))


def _chance_words(check: RuleCheck) -> Sentence:
    assert check.passes_probability is not None
    chance = chance_words(check.passes_probability)
    return say(KEEPS, check=check, chance=chance)


def _passing(answer: CertifyAnswer, wall: WallThatPasses) -> Sentence:
    return tell(
        WALL,
        wall=wall,
        measure=wall.measure.upper(),
        millimetres=1e3 * wall.thickness,
        before=answer.body.mass,
        thicker=wall.factor > 1,
    )


def _headline(answer: CertifyAnswer) -> Sentence:
    exempt = any(
        check.outcome.verdict is Verdict.NOT_APPLICABLE and check.outcome.rule.construction == "not one piece of wood"
        for check in answer.checks
    )
    return (_broken(answer) if answer.failed else _kept(answer)) + (ONE_PIECE if exempt else "")


def _measure_words(answer: CertifyAnswer) -> Sentence:
    """Return the one number that the test is made for, and the limit where one league has one."""
    tested, shots = answer.measure, answer.shots
    limits = [check for check in applying(answer.checks) if check.quantity == tested.quantity]
    name = QUANTITIES[tested.quantity][0]
    return say(
        MEASURE,
        name=name[0].upper() + name[1:],
        shown=value_with_ends(tested.quantity, tested.value),
        by="simulated" if shots is None else f"{len(shots.rows)} shots",
        place=tested.position_from_tip,
        limit=say("; allowed is {limit}", limit=limit_shown(limits[0])) if len(limits) == 1 else "",
    )


def _broken(answer: CertifyAnswer) -> Sentence:
    """Return the rules that a bat breaks; where none is broken surely, those that it breaks as far as is known."""
    bat, sure = answer.bat.name, [each for each in answer.failed if each.sure]
    rules = broken_rules(sure or answer.failed)
    if not sure:
        return say(FAILS_UNSURELY, bat=bat, rules=rules)
    unsure = unsure_words([check.outcome for check in answer.checks], verdict=Verdict.FAIL)
    return say("{bat} fails: {rules}." + unsure, bat=bat, rules=rules)


def _kept(answer: CertifyAnswer) -> Sentence:
    """Return how many rules a bat surely keeps, and those that are not sure or left open."""
    bat, checks = answer.bat.name, [each.outcome for each in answer.checks]
    if answer.untested:
        rules = joined(dict.fromkeys(each.title for each in answer.untested), " and ")
        return say(UNDECIDED, bat=bat, rules=rules, reason=answer.untested[0].reason)
    passed, unsure = sum(check.sure for check in checks), unsure_words(checks)
    counted = sum(check.verdict is not Verdict.NOT_APPLICABLE for check in checks)
    if not passed and not unsure:
        return say("No rule could be decided for {bat}, so nothing is passed.", bat=bat)
    if all(each.rules.superseded for each in answer.checks):
        return say("{bat} keeps limits that hold no more; they say nothing about today." + unsure, bat=bat)
    if passed == counted:
        return say("{bat} keeps every rule.", bat=bat)
    left = dict.fromkeys(title(check.rule) for check in checks if check.verdict is Verdict.NOT_DECIDABLE)
    not_decidable = f" Not decidable: {'; '.join(left)}." if left else ""
    return say(KEPT, bat=bat, kept=passed, all=counted, unsure=unsure, left=not_decidable)


def _superseded(checks: Sequence[RuleCheck]) -> list[str]:
    leagues = {check.league: check.rules for check in checks}.values()
    return [f"{league.name}: {league.superseded}." for league in leagues if league.superseded]


def _ball_of_the_rule(answer: CertifyAnswer) -> list[Sentence]:
    """Return why a bat is tested with another ball than it is swung at; nothing where it is the same."""
    usual = standard_conditions(answer.implement).ball
    named = [check for check in answer.checks if ball(check.rules.ball) == answer.fired]
    if answer.fired == usual or not named or answer.test is None:
        return []
    source = named[0].rules.rules[0].source
    return [say(OTHER_BALL, source=source, ball=answer.ball, own=usual.name)]


def _simulated(answer: CertifyAnswer, test: SimulatedTest) -> list[Block]:
    fast, slow, length = test.fast, test.slow, answer.implement.length
    of_ball = test.spread if test.spread_by_law is None else _together(test, test.spread, test.spread_by_law)
    open_by = [spreads for spreads in (of_ball, test.spread_by_moi) if spreads is not None]
    at = Slot(fast.closing_speed, "speed", 0)

    def ranges(name: str, scale: str = "ratio", digits: int = 4) -> list[Cell]:
        return [_range(getattr(spreads, name), scale, digits) for spreads in open_by]

    none: list[Cell] = [""] * len(open_by)
    turning = moment(answer.bat.moi_6in, moi_doubt(answer.implement, answer.body, CLAMP))
    besr: list[Cell] = ["BESR", Slot(test.besr, "ratio", 4), *ranges("besr"), _place(fast, length), "q + 1/2"]
    game = "BBCOR of the test" if test.swung == BASEBALL_TEST else "ball-bat restitution"
    fast_place = _place(fast, length)
    at_best = say("ball at {speed}, best of {count} places", speed=at, count=len(fast.position))
    at_rest = "ball at {of.closing_speed:speed, 0}, whose own restitution is {of.ball_restitution:ratio, 4}"
    speed, speeds = Slot(test.batted_ball_speed, "speed"), ranges("batted_ball_speed", "speed", 1)
    rows: list[list[Cell]] = [
        [game, Slot(test.bbcor, "ratio", 4), *ranges("bbcor"), fast_place, at_best],
        ["collision efficiency q", Slot(test.collision_efficiency, "ratio", 4), *none, fast_place, "there"],
        *([besr] if test.swung == BASEBALL_TEST else []),
        ["BPF", Slot(test.bpf, "ratio"), *ranges("bpf", digits=3), _place(slow, length), say(at_rest, of=slow)],
        ["batted-ball speed", speed, *speeds, fast_place, _swung(test.swung)],
        ["MOI", turning, *none, "", "the clamp's axis"],
    ]
    columns = table_head("measure | value > | by the ball >")
    columns += [Column("by the MOI", right=True) for _ in open_by[1:]]
    columns += table_head("from the tip: length | test")
    ball_note = PATCH_NOTE if test.spread_by_law is None else BALL_NOTE
    moi_note = [] if test.spread_by_moi is None else [MOI_NOTE]
    notes: list[Words] = [ball_note, *moi_note]
    return [Table("Simulated test", columns, rows, name="certified"), *(Paragraph(note, "note") for note in notes)]


def _together(test: SimulatedTest, *spreads: MeasureSpreads) -> MeasureSpreads:
    """Return between which each measure lies by doubts that are independent."""

    def ends(name: str) -> tuple[float, float]:
        value = float(getattr(test, name))
        below, above = (hypot(*(value - getattr(each, name)[end] for each in spreads)) for end in (0, 1))
        return value - below, value + above

    return MeasureSpreads(**{each.name: ends(each.name) for each in fields(MeasureSpreads)})


def _wall_note(answer: CertifyAnswer, test: SimulatedTest) -> list[Words]:
    """Return the wall that was tested and the result of another one; nothing for a bat whose wall is described."""
    pattern, spreads = wall_pattern(answer.implement), test.spread_by_wall
    if pattern is None or spreads is None:
        return []
    measure = "bbcor" if test.swung == BASEBALL_TEST else "bpf"
    return [
        say(
            "The wall is that of the catalogue's {pattern}; it was not measured on this bat, and {measure} is the "
            "model's for that wall. A barrel wall {part} % thinner or thicker gives {spread}: measure yours and give "
            "[shell] in the bat file.",
            pattern=pattern,
            measure=measure.upper(),
            part=f"{100 * WALL_DOUBT:.0f}",
            spread=_range(getattr(spreads, measure)),
        )
    ]


def _range(spread: tuple[float, float], scale: str = "ratio", digits: int = 4) -> Sentence:
    return Sentence((Span(*spread, scale, digits, unit=False),))


def _swung(test: SwungTest) -> Sentence:
    ball, bat = Slot(test.ball_speed, "speed", 0), Slot(test.bat_speed, "speed", 0)
    return say("{ball} ball, {bat} bat", ball=ball, bat=bat)


def _place(scan: ScanAtRest, length: float) -> Sentence:
    place = Slot(length - scan.best_position, "length").bare
    return say("{place}{end}", place=place, end=" (end of scan)" if scan.best_at_edge else "")


def _measured(shots: MeasuredShots, *, length: float) -> list[Block]:
    """Return the results of the shots: measures and places."""
    raw = shots.standard_ball_cor is None
    rows = [_estimate("BBCOR, as measured" if raw else "BBCOR, normalised", shots.bbcor)]
    if not raw:
        rows.append(_estimate("BBCOR, as measured", shots.raw_bbcor))
    if shots.bbcor_without_outliers is not None:
        rows.append(_estimate("BBCOR without outliers", shots.bbcor_without_outliers))
    rows.append(_estimate("collision efficiency q", shots.collision_efficiency))
    speed = say("batted-ball speed, {swung}", swung=_swung(shots.swung))
    rows.append(_estimate(speed, shots.batted_ball_speed, "speed", 1))
    if shots.bpf is not None:
        rows.append(_estimate("BPF", shots.bpf, digits=3))
    heading = say(
        "{count} shots {place:length} from the tip", count=len(shots.rows), place=length - shots.best_position
    )
    columns = [Column("measure"), *(Column(name, right=True) for name in ("mean", "standard error", "90 % interval"))]
    places: list[list[Cell]] = [
        [Slot(length - place.position, "length").bare, place.count, Slot(place.bbcor, "ratio", 4)]
        for place in shots.places
    ]
    where = table_head("from the tip: length | shots: count | BBCOR: ratio, 4")
    return [Table(heading, columns, rows), Table("Places", where, places)]


def _remarks(shots: MeasuredShots) -> list[str]:
    """Return the remarks on a file of shots: outliers, unused rows and columns, notes."""
    lines = [
        f"Row {outlier.row} stands out: BBCOR {outlier.bbcor:.4f}, {outlier.deviation:+.1f} robust standard deviations "
        "from the median. It is counted."
        for outlier in shots.outliers
    ]
    lines += [f"Row {bad.row} is not used: {bad.reason}." for bad in shots.bad_rows]
    if shots.ignored_columns:
        lines.append(f"Columns not used: {', '.join(shots.ignored_columns)}.")
    return [*lines, *shots.notes]


def _estimate(name: Words, estimate: Estimate | SpeedEstimate, scale: str = "ratio", digits: int = 4) -> list[Cell]:
    error, low, high = (
        Slot(value, scale, digits).bare for value in (estimate.standard_error, estimate.low, estimate.high)
    )
    return [name, Slot(estimate.mean, scale, digits), error, say("{low} to {high}", low=low, high=high)]


def _doubted(answer: CertifyAnswer, check: RuleCheck) -> bool:
    """Return whether the value of a rule is a moment of inertia that was not measured."""
    return check.quantity == "moi" and moi_doubt(answer.implement, answer.body, CLAMP) > 0


def _value(answer: CertifyAnswer, check: RuleCheck) -> Sentence:
    if check.quantity == "moi" and check.value is not None:
        return moment(check.value, moi_doubt(answer.implement, answer.body, CLAMP))
    return value_shown(check.quantity, check.value)
