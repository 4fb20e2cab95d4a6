"""The printed report of a racket, club, stick or cricket bat: the sport's words, and maps of its face."""

from __future__ import annotations

from pathlib import Path

from sweetspot import __version__
from sweetspot.analysis import Analysis, exit_speed_of
from sweetspot.catalog.swing_weights import swing_weight
from sweetspot.face_map import face_map
from sweetspot.implement import Implement
from sweetspot.report import sections
from sweetspot.report.markup import Html, bullets, paragraphs, picture, section, table, text
from sweetspot.report.provenance import used_records
from sweetspot.report.speech import Speech, speech
from sweetspot.report.sport_words import sport_answer
from sweetspot.scan import STING_BAND
from sweetspot.sport import ASSUMED_MARK

COLUMNS, ROWS = 120, 90
"""Places of the maps in the page: enough for the eye."""
SPOTS = {
    "max_exit_speed": "where the {incoming} leaves fastest for this swing",
    "max_collision_efficiency": "where a {implement} at rest gives back most speed",
    "min_sting": "where the hand feels least vibration",
    "node_1": "a hit here does not excite the first bending mode",
    "node_2": "a hit here does not excite the second bending mode",
    "center_of_percussion": "a hit here does not jolt the hand",
}
"""Field of `SweetSpots`: what it means."""


def sport_page(analysis: Analysis[Implement], *, overview: bytes, hit: bytes) -> str:
    """Return the whole page as HTML.

    Parameters
    ----------
    overview, hit : the two pictures as SVG files.
    """
    said, bat, body = speech(analysis.bat.sport), analysis.bat, analysis.body
    words = said.words
    best = picture(
        hit, name="hit", label=f"Force and energy of the best hit of {bat.name}.",
        caption="The force in time and against the ball's compression; below, where the energy goes, as a laboratory "
        f"counts it that fires the {words.incoming} at a {words.implement} at rest.",
    )  # fmt: skip
    sizes = f"{100 * bat.length:.1f} cm long, {1e3 * body.mass:.0f} g, {bat.made_of}"
    label = f"{bat.name} drawn to scale with its sweet spots, and below it what a hit does, place for place."
    parts = [
        f"<header>\n<p>{text(said.sport.name)}: sweet spot report</p>\n<h1>{text(bat.name)}</h1>\n"
        f"<p>{text(sizes)}</p>\n</header>",
        f'<div class="answer">\n{paragraphs(sport_answer(analysis))}\n</div>',
        picture(overview, name="overview", label=label, caption=(
            f"The {words.implement} to scale and, place for place, what a hit there does. Shaded: the {words.zone}.")),
        _maps(analysis, said),
        _spots(analysis, said),
        _mass(analysis, said),
        _best(analysis, said, best),
        _assumptions(analysis, said),
        sections.provenance(analysis),
        sections.sources(analysis),
        f"<footer>sweetspot {text(__version__)}. Places are measured along the {text(words.implement)}.</footer>",
    ]  # fmt: skip
    style = Path(__file__).with_name("page.css").read_text(encoding="utf-8")
    content = "\n".join(part for part in parts if part)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{text(bat.name)}: sweet spot report</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n"
        f"{content}\n</main>\n</body>\n</html>\n"
    )


def _maps(analysis: Analysis[Implement], said: Speech) -> Html:
    from sweetspot.plot.face import face_figure
    from sweetspot.plot.save import svg_bytes

    if analysis.bat.face is None:
        return Html("")
    found = face_map(analysis.reduced, analysis.conditions, columns=COLUMNS, rows=ROWS)
    drawing = svg_bytes(face_figure(found, analysis.bat))
    caption = (
        f"Hits all over the face, handle to the left: {said.words.exit_speed}, efficiency and vibration at the hand. "
        "The dot is the best place. A hit beside the line also turns the face, which sends the ball off at an angle: "
        "that is not in these maps."
    )
    label = f"Three maps of the face of {analysis.bat.name}: exit speed, efficiency and sting."
    return section("All over the face", picture(drawing, name="face", label=label, caption=caption), name="face-map")


def _spots(analysis: Analysis[Implement], said: Speech) -> Html:
    words, bat = said.words, analysis.bat
    rows = [
        (
            Html(f'<span class="dot {field}"></span>{text(field.replace("_", " ").replace("center", "centre"))}'),
            said.place(bat.length - getattr(analysis.sweet_spots, field)),
            meaning.format(incoming=words.incoming, implement=words.implement),
        )
        for field, meaning in SPOTS.items()
    ]
    columns = ("sweet spot", f"from the {words.tip}", "what it means")
    return section("Every sweet spot", table(columns, rows, numbers=(1,), name="spots"), name="sweet-spots")


def _mass(analysis: Analysis[Implement], said: Speech) -> Html:
    body, butt = analysis.body, said.words.butt
    convention = swing_weight(analysis.bat.sport)
    rows = [
        ("weight", f"{1e3 * body.mass:.1f} g"),
        (f"balance point, from the {butt}", f"{100 * body.balance_point:.1f} cm"),
        (convention.name, convention.shown(body)),
        ("moment of inertia about the balance point", f"{1e4 * body.moi_cm:.1f} kg cm²"),
        ("moment of inertia about the long axis", f"{1e4 * body.roll_moi:.2f} kg cm²"),
    ]
    return section("Weight and balance", table(("", "value"), rows, numbers=(1,)), name="mass")


def _best(analysis: Analysis[Implement], said: Speech, figure: Html) -> Html:
    impact, conditions, words = analysis.best, analysis.conditions, said.words
    swung, leaves = conditions.swing.speed_at(impact.position), exit_speed_of(impact, conditions)
    rows = [
        ("place", f"{said.place(analysis.bat.length - impact.position)} from the {words.tip}"),
        (f"{words.implement} speed there", said.speed(swung)),
        (f"{words.incoming} comes at", said.speed(conditions.pitch.speed)),
        (words.exit_speed, said.speed(leaves)),
        (words.efficiency, f"{impact.collision_efficiency:.3f}"),
        *([(words.smash_factor, f"{leaves / swung:.3f}")] if words.smash_factor else []),
        ("contact, force above 1 % of its peak", f"{1e3 * impact.contact_time:.2f} ms"),
        ("peak force", f"{impact.peak_force / 1e3:.3g} kN"),
        ("ball", conditions.ball.name),
    ]
    return section("The best hit", table(("", "value"), rows, numbers=(1,)), figure, name="best-hit")


def _assumptions(analysis: Analysis[Implement], said: Speech) -> Html:
    """Return what the model takes for granted, what the sport's description leaves out, and what was assumed."""
    records = used_records(analysis)
    assumed = sum(record.kind == "assumed" for entries in records.values() for record in entries)
    total = sum(map(len, records.values()))
    low, high = STING_BAND
    tool, face = said.words.implement, analysis.bat.face
    points = [
        f"The {tool} bends as a beam and rolls as a rigid body; it is free while ball and {tool} touch.",
        "The face is one spring and damper under the ball, softer or stiffer by its place."
        if face is not None and face.stiffness is not None
        else "The face is rigid: what it gives is contained in the ball's restitution.",
        f"Sting is the speed of the handle's vibration right after the hit, {low:.0f} to {high:.0f} Hz.",
        *(f"Not covered: {words}." for words in said.sport.not_covered),
        f"{assumed} of the {total} constants are soft defaults that no source was read for; where this page or "
        f"`sweetspot sports` shows a stroke's number, {ASSUMED_MARK} stands behind it.",
    ]
    return section("Assumptions and limits", bullets(points), name="assumptions")
