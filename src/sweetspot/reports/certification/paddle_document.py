"""A tested paddle and the rules held against it as a document."""

from __future__ import annotations

from sweetspot.analysis.certification.rules import Verdict
from sweetspot.answers.certify_paddle import CertifyPaddleAnswer, PaddleShots
from sweetspot.numerics.interval import interval_of
from sweetspot.reports.certification.limits_shown import broken_rules, limit_shown, value_with_ends
from sweetspot.reports.certification.rules_shown import applying, listed, reasons, rules_table
from sweetspot.reports.document import Block, Cell, Column, Document, Paragraph, Table, as_columns, table_head
from sweetspot.reports.sentences import Sentence, Slot, Words, joined, say
from sweetspot.reports.uncertainty import chance_words

KEEPS = " It keeps the limit on PBCoR with a probability of {chance}."
PBCOR = "PBCoR {pbcor}, {place:length} from the tip, by ball and core{limit}."
WAVE = (
    "The clamp is felt where its wave is back early: from 7 in it takes {near}, and the ball is on the face for "
    "{contact}; from 4.4 in it takes {far}, when most of the push is over."
)
FORMULA = (
    "A clamp's moment of inertia stands in the formula of PBCoR, so a lighter one reads higher though the ball comes "
    "back as fast."
)


def certify_paddle_document(answer: CertifyPaddleAnswer) -> Document:
    """Return a tested paddle as a document."""
    chances = [check.passes_probability for check in answer.checks if check.passes_probability is not None]
    likely = [say(KEEPS, chance=chance_words(chance)) for chance in chances[:1]]
    blocks: list[Block] = [Paragraph(joined([_headline(answer), *likely], ""))] if answer.checks else []
    blocks.append(Paragraph(_measure_words(answer)))
    details: list[Block] = [_test(answer)]
    if answer.shots is not None:
        measured, *rows = _shots(answer.shots)
        blocks, details = [*blocks, measured], [*details, *rows]
    details += [_scan(answer), Paragraph(_wave(answer)), _clamps(answer), Paragraph(FORMULA)]
    if answer.checks:
        blocks += [rules_table(each, sources=False) for each in [applying(answer.checks)] if each]
        details += [rules_table(answer.checks), *listed(reasons(answer.checks))]
    data = answer.to_dict()
    return Document(
        name="certify",
        title=answer.paddle.name,
        subtitle=answer.ball,
        kind="Paddle test",
        blocks=blocks,
        appendix=details,
        data=data,
        rows=as_columns(data["test"]["scan"]),
        passed=answer.passed,
    )


def _headline(answer: CertifyPaddleAnswer) -> Sentence:
    name = answer.paddle.name
    if answer.failed:
        sure = [check for check in answer.failed if check.sure]
        words = "{name} fails: {rules}." if sure else "{name} fails as far as is known, but not surely: {rules}."
        return say(words, name=name, rules=broken_rules(sure or answer.failed))
    passes = sum(check.outcome.verdict is Verdict.PASS for check in answer.checks)
    every, left = len(answer.checks), "" if passes == len(answer.checks) else " The others are not decidable here."
    return say("{name} keeps {kept} of {all} rules and breaks none." + left, name=name, kept=passes, all=every)


def _measure_words(answer: CertifyPaddleAnswer) -> Sentence:
    """Return the one number that the test is made for."""
    limits = [check for check in applying(answer.checks) if check.quantity == "pbcor"]
    return say(
        PBCOR,
        pbcor=value_with_ends("pbcor", interval_of(answer.test.pbcor)),
        place=answer.test.position_from_tip,
        limit=say("; allowed is {limit}", limit=limit_shown(limits[0])) if len(limits) == 1 else "",
    )


def _test(answer: CertifyPaddleAnswer) -> Table:
    test = answer.test
    pbcor = interval_of(test.pbcor)
    rows: list[list[Cell]] = [
        ["PBCoR, greatest over the face", Slot(pbcor.value, "ratio", 3), _range(pbcor.low, pbcor.high)],
        ["at, from the tip", Slot(test.position_from_tip, "length"), ""],
        ["rebound there", Slot(test.rebound_speed, "speed", 1), say("ball at {speed:speed, 0}", speed=test.speed)],
        ["effective mass there", f"{1e3 * float(test.effective_mass):.0f} g", "paddle and clamp"],
        ["clamp", _inertia(float(test.clamp_inertia)), "about an axis 2 in from the butt"],
        ["PEF, as far as its formula is known", Slot(test.pef, "ratio", 3), "without the clamp"],
    ]
    return Table("", [Column("what"), Column("value", right=True), Column("")], rows)


def _range(low: float, high: float) -> Sentence:
    return say("{low:ratio, 3} to {high:ratio, 3}, by ball and core (90 %)", low=low, high=high)


def _inertia(moi: float) -> str:
    return f"{1e4 * moi:.4g} kg cm²"


def _scan(answer: CertifyPaddleAnswer) -> Table:
    rows: list[list[Cell]] = [
        [
            Slot(row.position_from_tip, "length").bare,
            Slot(row.pbcor, "ratio", 3),
            Slot(row.rebound_speed, "speed", 1).bare,
            _milliseconds(float(row.contact_time)),
            _milliseconds(float(row.wave_time)),
        ]
        for row in answer.test.scan
    ]
    head = table_head("from the tip: length | PBCoR: ratio, 3 | rebound: speed | contact, ms > | wave back, ms >")
    return Table("Along the face", head, rows)


def _milliseconds(time: float) -> str:
    return f"{1e3 * time:.2f}"


def _wave(answer: CertifyPaddleAnswer) -> Sentence:
    def nearest(inches: float) -> tuple[float, float]:
        row = min(answer.test.scan, key=lambda each: abs(float(each.position_from_tip) - inches * 0.0254))
        return float(row.wave_time), float(row.contact_time)

    (near, _), (far, contact) = nearest(7.0), nearest(4.4)
    return say(WAVE, near=f"{1e3 * near:.1f} ms", far=f"{1e3 * far:.1f} ms", contact=f"{1e3 * contact:.1f} ms")


def _clamps(answer: CertifyPaddleAnswer) -> Table:
    rows: list[list[Cell]] = [
        [
            _inertia(float(other.clamp_inertia)),
            Slot(other.pbcor, "ratio", 3),
            Slot(other.position_from_tip, "length").bare,
            Slot(other.rebound_speed, "speed", 1).bare,
            f"{100 * float(other.rebound_change):+.1f} %",
        ]
        for other in answer.clamps
    ]
    head = table_head("clamp | PBCoR: ratio, 3 | from the tip: length | rebound: speed | rebound 3 to 5 in from tip >")
    return Table("What another clamp would have said", head, rows)


def _shots(shots: PaddleShots) -> list[Block]:
    best: Words = say(
        "{count} shots {place:length} from the tip: PBCoR {mean:ratio, 4}, {low:ratio, 4} to {high:ratio, 4} (90 %).",
        count=shots.pbcor.count,
        place=shots.position_from_tip,
        mean=shots.pbcor.mean,
        low=shots.pbcor.low,
        high=shots.pbcor.high,
    )
    rows: list[list[Cell]] = [
        [Slot(place.position_from_tip, "length").bare, place.count, Slot(place.pbcor, "ratio", 4)]
        for place in shots.places
    ]
    where = table_head("from the tip: length | shots: count | PBCoR: ratio, 4")
    unused = [f"Row {bad.row} is not used: {bad.reason}." for bad in shots.bad_rows]
    return [Paragraph(best), Table("Measured", where, rows), *listed(unused)]
