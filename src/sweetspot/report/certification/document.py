"""A bat test and the rules held against it as a document."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sweetspot.analysis.certification.passing_wall import PassingWall
from sweetspot.analysis.certification.rules import Check, League, Verdict, title
from sweetspot.analysis.certification.shot_statistics import Estimate, Measured
from sweetspot.analysis.certification.shots import Shots
from sweetspot.analysis.certification.simulated_test import (
    BASEBALL_TEST,
    CLAMP,
    BatTest,
    Certification,
    SwungTest,
)
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.catalog.balls import ball
from sweetspot.catalog.bats import WALL_DOUBT, wall_pattern
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.report.bat.assumed_values import soft_note
from sweetspot.report.certification.limits_shown import (
    broken_words,
    limit_shown,
    marked_verdict,
    unsure_words,
    value_shown,
)
from sweetspot.report.certification.numbers import check_json, measured_json, simulated_json, wall_json
from sweetspot.report.certification.tested_bat import TestedBat
from sweetspot.report.document import Block, Bullets, Cell, Cited, Column, Document, Paragraph, Picture, Table
from sweetspot.report.json_shapes import as_columns, cleaned
from sweetspot.report.quantities import Reader
from sweetspot.report.sentences import Sentence, Slot, Span, Words, joined, say, with_doubt
from sweetspot.uncertainty.drawn_tests import RULED

PATCH_NOTE = (
    "By the patch: with the smallest and the largest patch through which a ball can push; the least certain number of "
    "the test. The ball is the catalogue's; a test normalises to one."
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
MANY = 14
"""Rules from which on a printed table is set smaller."""


def tested_document(tested: TestedBat) -> Document:
    """Return a tested bat as a document."""
    test = tested.test
    blocks: list[Block] = [Paragraph(_headline(tested))] if tested.checks else []
    blocks += [Paragraph(words, "warning") for words in _superseded(tested.checks)]
    blocks += [Paragraph(words) for words in _ball_of_the_rule(tested)]
    blocks += [Paragraph(_passing(tested, league, wall)) for league, wall in tested.walls]
    if tested.bat.remark:
        blocks.append(Paragraph(tested.bat.remark))
    if isinstance(test, Certification):
        blocks += _simulated(test)
    elif tested.shots is not None:
        blocks += _measured(test, tested.shots, length=tested.bat.length)
    blocks += soft_note(tested.bat, tested.ball)
    if tested.checks:
        blocks += [_rules(tested), *_listed(_reasons(tested.checks))]
    picture = Picture(
        "certify", lambda reading: _drawn(tested, reading),
        label=say("What the rules limit, place for place along {bat}, and the limits.", bat=tested.bat.name),
        caption="A test in the computer or on a bench; no certificate.",
        sheet=lambda reading: _drawn_sheet(tested, reading),
    )  # fmt: skip
    checks = [check_json(league.key, check) for league, check in tested.checks]
    return Document(
        name="certify", title=tested.bat.name, subtitle=tested.ball.name, kind="Bat test", blocks=[*blocks, picture],
        data=cleaned(_json(tested, checks)), rows=as_columns(checks), passed=tested.passed, drawing=picture,
    )  # fmt: skip


def _drawn_sheet(tested: TestedBat, reading: Reader) -> Any:
    from sweetspot.report.certification.picture import ON_A_SHEET, certification_figure

    return certification_figure(tested, reading, paper=ON_A_SHEET)


def _drawn(tested: TestedBat, reading: Reader) -> Any:
    from sweetspot.report.certification.picture import certification_figure

    return certification_figure(tested, reading)


def certification_document(certification: Certification) -> Document:
    """Return a simulated test alone, with no rules held against it, as a document."""
    return tested_document(TestedBat(certification.bat, certification.ball, certification.body, certification))


def _json(tested: TestedBat, checks: list[dict[str, Any]]) -> dict[str, Any]:
    bat, test = tested.bat, tested.test
    told = {"test": simulated_json(test)} if isinstance(test, Certification) else {}
    if isinstance(test, Measured) and tested.shots is not None:
        told = {"shots": measured_json(test, tested.shots)}
    described = {"bat": to_dict(mass_properties(bat, tested.body)), "ball": tested.ball.name}
    walls = [wall_json(league.key, wall) for league, wall in tested.walls]
    return described | told | {"checks": checks, "passed": tested.passed} | ({"walls": walls} if walls else {})


def _passing(tested: TestedBat, league: League, wall: PassingWall) -> Sentence:
    less = (
        " A barrel that is thick only where it is hit, or a ring or disc inside ([[shell.ring]]), does it with less."
        if wall.factor > 1 else ""
    )  # fmt: skip
    return say(
        "The wall that just passes {measure} {limit} ({league}): {thickness} in the middle of the barrel, {factor} "
        "times as thick as drawn. The bat would weigh {mass} instead of {before}." + less,
        measure=wall.measure.upper(), limit=Slot(wall.limit, "ratio", 3), league=league.name,
        thickness=say("{size} mm", size=Slot(1e3 * wall.thickness, "ratio", 2)), factor=Slot(wall.factor, "ratio", 2),
        mass=Slot(wall.mass, "mass"), before=Slot(tested.body.mass, "mass"),
    )  # fmt: skip


def _headline(tested: TestedBat) -> Sentence:
    exempt = any(
        check.verdict is Verdict.NOT_APPLICABLE and check.rule.construction == "not one piece of wood"
        for _, check in tested.checks
    )
    return (_broken(tested) if tested.failed else _kept(tested)) + (ONE_PIECE if exempt else "")


def _broken(tested: TestedBat) -> Sentence:
    """Return the rules that a bat breaks; where none is broken surely, those that it breaks as far as is known."""
    bat, sure = tested.bat.name, [(league, check) for league, check in tested.failed if check.sure]
    rules = joined([broken_words(league, check) for league, check in (sure or tested.failed)], "; ")
    if not sure:
        return say(
            "{bat} fails as far as is known, but not surely: {rules}. What is not known reaches across the limit.",
            bat=bat, rules=rules,
        )  # fmt: skip
    unsure = unsure_words([check for _, check in tested.checks], verdict=Verdict.FAIL)
    return say("{bat} fails: {rules}." + unsure, bat=bat, rules=rules)


def _kept(tested: TestedBat) -> Sentence:
    """Return how many rules a bat surely keeps, and those that are not sure or left open."""
    bat, checks = tested.bat.name, [check for _, check in tested.checks]
    if tested.untested:
        rules = joined(dict.fromkeys(title(check.rule) for _, check in tested.untested), " and ")
        return say(
            "{bat} is not passed: this test does not decide {rules}: {reason}.",
            bat=bat, rules=rules, reason=tested.untested[0][1].reason,
        )  # fmt: skip
    kept, unsure = sum(check.sure for check in checks), unsure_words(checks)
    counted = sum(check.verdict is not Verdict.NOT_APPLICABLE for check in checks)
    if not kept and not unsure:
        return say("No rule could be decided for {bat}, so nothing is passed.", bat=bat)
    if all(league.superseded for league, _ in tested.checks):
        return say("{bat} keeps limits that hold no more; they say nothing about today." + unsure, bat=bat)
    if kept == counted:
        return say("{bat} keeps every rule.", bat=bat)
    left = [title(check.rule) for check in checks if check.verdict is Verdict.NOT_DECIDABLE]
    return say(
        "{bat} surely keeps {kept} of {all} rules and breaks none.{unsure}{left}", bat=bat, kept=kept, all=counted,
        unsure=unsure, left=f" Not decidable: {'; '.join(left)}." if left else "",
    )  # fmt: skip


def _superseded(checks: Sequence[tuple[League, Check]]) -> list[str]:
    leagues = {league.key: league for league, _ in checks}.values()
    return [f"{league.name}: {league.superseded}." for league in leagues if league.superseded]


def _ball_of_the_rule(tested: TestedBat) -> list[Sentence]:
    """Return why a bat is tested with another ball than it is swung at; nothing where it is the same."""
    own = standard_conditions(tested.bat).ball
    named = {league.key: league for league, _ in tested.checks if ball(league.ball) == tested.ball}
    if tested.ball == own or not named or not isinstance(tested.test, Certification):
        return []
    source = next(iter(named.values())).rules[0].source
    return [
        say(
            'The test is with the ball that the rule names [{source}], "{ball}", not with "{own}", which this bat is '
            "swung at; --ball takes that.", source=source, ball=tested.ball.name, own=own.name,
        )
    ]  # fmt: skip


def _simulated(test: Certification) -> list[Block]:
    fast, slow, length = test.fast, test.slow, test.bat.length
    open_by = [spreads for spreads in (test.spreads, test.moi_spreads) if spreads]
    at = Slot(fast.closing_speed, "speed", 0)

    def ranges(name: str, scale: str = "ratio", digits: int = 4) -> list[Cell]:
        return [_range(spreads[name], scale, digits) for spreads in open_by]

    none: list[Cell] = [""] * len(open_by)
    turning = with_doubt(test.body.moi(CLAMP), moi_doubt(test.bat, test.body, CLAMP), "moi", of="bat.moi_6in_kg_m2")
    besr: list[Cell] = [
        "BESR", Slot(test.besr, "ratio", 4, of="test.besr"), *ranges("besr"), _place(fast, length, "fast"), "q + 1/2"
    ]  # fmt: skip
    game = "BBCOR of the test" if test.swung == BASEBALL_TEST else "ball-bat restitution"
    rows: list[list[Cell]] = [
        [game, Slot(test.bbcor, "ratio", 4, of="test.bbcor"), *ranges("bbcor"),
         _place(fast, length, "fast"),
         say("ball at {speed}, best of {count} places", speed=at, count=len(fast.position))],
        ["collision efficiency q", Slot(fast.best_efficiency, "ratio", 4, of="test.collision_efficiency"), *none,
         _place(fast, length, "fast"), "there"],
        *([besr] if test.swung == BASEBALL_TEST else []),
        ["BPF", Slot(test.bpf, "ratio", of="test.bpf"), *ranges("bpf", digits=3), _place(slow, length, "slow"),
         say("ball at {speed}, whose own restitution is {own}", speed=Slot(slow.closing_speed, "speed", 0),
             own=Slot(slow.ball_restitution, "ratio", 4))],
        ["batted-ball speed", Slot(test.batted_ball_speed, "speed", of="test.batted_ball_speed_m_s"),
         *ranges("batted_ball_speed", "speed", 1), _place(fast, length, "fast"), _swung(test.swung)],
        ["MOI", turning, *none, "", "the clamp's axis"],
    ]  # fmt: skip
    columns = [Column("measure"), Column("value", right=True), Column("by the patch", right=True)]
    columns += [Column("by the MOI", right=True) for _ in open_by[1:]]
    columns += [Column("from the tip", "length"), Column("test")]
    notes: list[Words] = [*_wall_note(test), PATCH_NOTE, *([MOI_NOTE] if test.other_mois else [])]
    return [Table("Simulated test", columns, rows, name="certified"), *(Paragraph(note, "note") for note in notes)]


def _wall_note(test: Certification) -> list[Words]:
    """Return whose wall was tested, and what another one would give; nothing for a bat with a wall of its own."""
    pattern = wall_pattern(test.bat)
    if pattern is None or not test.other_walls:
        return []
    measure = "bbcor" if test.swung == BASEBALL_TEST else "bpf"
    low, high = test.wall_spreads[measure]
    return [
        say(
            "The wall is that of the catalogue's {pattern}; it was not measured on this bat, and {measure} is the "
            "model's for that wall. A barrel wall {part} % thinner or thicker gives {spread}: measure yours and give "
            "[shell] in the bat file.",
            pattern=pattern,
            measure=measure.upper(),
            part=f"{100 * WALL_DOUBT:.0f}",
            spread=Sentence((Span(low, high, "ratio", 4, unit=False),)),
        )
    ]


def _range(spread: tuple[float, float], scale: str = "ratio", digits: int = 4) -> Sentence:
    return Sentence((Span(*spread, scale, digits, unit=False),))


def _swung(test: SwungTest) -> Sentence:
    ball, bat = Slot(test.ball_speed, "speed", 0), Slot(test.bat_speed, "speed", 0)
    return say("{ball} ball, {bat} bat", ball=ball, bat=bat)


def _place(test: BatTest, length: float, name: str) -> Sentence:
    place = Slot(length - test.best_position, "length", of=f"-test.{name}.best_position_m").bare
    return say("{place}{end}", place=place, end=" (end of scan)" if test.at_edge else "")


def _measured(measured: Measured, shots: Shots, *, length: float) -> list[Block]:
    """Return what the shots say: measures, places, hits that stand out, rows not used, notes."""
    raw = measured.standard_restitution is None
    rows = [_estimate("BBCOR, as measured" if raw else "BBCOR, normalised", measured.bbcor)]
    if not raw:
        rows.append(_estimate("BBCOR, as measured", measured.raw_bbcor))
    if measured.without_outliers is not None:
        rows.append(_estimate("BBCOR without outliers", measured.without_outliers))
    rows.append(_estimate("collision efficiency q", measured.efficiency))
    rows.append(
        _estimate(
            say("batted-ball speed, {swung}", swung=_swung(measured.swung)), measured.batted_ball_speed, "speed", 1
        )
    )
    if measured.bpf is not None:
        rows.append(_estimate("BPF", measured.bpf, digits=3))
    heading = say(
        "{count} shots {place} from the tip", count=len(measured.rows),
        place=Slot(length - measured.best_position, "length"),
    )  # fmt: skip
    columns = [Column("measure"), *(Column(name, right=True) for name in ("mean", "standard error", "90 % interval"))]
    places: list[list[Cell]] = [
        [Slot(length - place.position, "length").bare, place.count, place.bbcor] for place in measured.places
    ]
    lines = [
        f"Row {one.row} stands out: BBCOR {one.bbcor:.4f}, {one.deviation:+.1f} robust standard deviations from the "
        "median. It is counted." for one in measured.outliers
    ]  # fmt: skip
    lines += [f"Row {bad.row} is not used: {bad.reason}." for bad in shots.bad_rows]
    if shots.ignored_columns:
        lines.append(f"Columns not used: {', '.join(shots.ignored_columns)}.")
    where = [Column("from the tip", "length"), Column("shots", "count"), Column("BBCOR", "ratio", digits=4)]
    return [Table(heading, columns, rows), Table("Places", where, places), *_listed([*lines, *measured.notes])]


def _estimate(name: Words, estimate: Estimate, scale: str = "ratio", digits: int = 4) -> list[Cell]:
    error, low, high = (
        Slot(value, scale, digits).bare for value in (estimate.standard_error, estimate.low, estimate.high)
    )
    return [name, Slot(estimate.mean, scale, digits), error, say("{low} to {high}", low=low, high=high)]


def _rules(tested: TestedBat) -> Table:
    bat, body = tested.bat, tested.body
    alone = _only_league(tested.checks)
    columns = [Column(name) for name in ("league", "rule", "verdict") if name != "league" or alone is None]
    columns += [Column(name, right=True) for name in ("value", "limit", "margin")]
    rows: list[list[Cell]] = []
    for league, check in tested.checks:
        rule = check.rule
        of = RULED.get(rule.quantity, "")
        value = value_shown(rule.quantity, check.value, of=of)
        if rule.quantity == "moi" and check.value is not None:
            value = with_doubt(check.value, moi_doubt(bat, body, CLAMP), "moi", of=of)
        rows.append([
            *([league.key] if alone is None else []), title(rule),
            marked_verdict(check), value, limit_shown(check),
            value_shown(rule.quantity, check.margin, sign=True, of=f"-{of}" if rule.least is None and of else of),
            Cited(rule.source, str(rule.year or ""), "" if rule.reading == "primary" else rule.reading),
        ])  # fmt: skip
    name = "certified rules" if len(rows) < MANY else "certified rules many"
    heading = "Rules" if alone is None else f"Rules of {alone}"
    return Table(heading, [*columns, Column("source")], rows, name=name)


def _only_league(checks: Sequence[tuple[League, Check]]) -> str | None:
    """Return the league's name, if all rules are of one."""
    names = {league.name for league, _ in checks}
    return names.pop() if len(names) == 1 else None


def _listed(lines: Sequence[str]) -> list[Block]:
    return [Bullets(lines)] if lines else []


def _reasons(checks: Sequence[tuple[League, Check]]) -> list[str]:
    """Return why a rule is not a plain pass or fail."""
    alone = _only_league(checks)
    return [
        f"{title(check.rule)}{'' if alone else f' ({league.name})'}: {check.words}: {check.reason}."
        for league, check in checks
        if check.reason
    ]
