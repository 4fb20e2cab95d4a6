"""The one-page training report: what the swings say, the questions players ask with their answers, the bats tried."""

from __future__ import annotations

import json
from pathlib import Path

from sweetspot import __version__
from sweetspot.player.advice import Advice
from sweetspot.player.goal import told
from sweetspot.player.posterior import Posterior
from sweetspot.player.swings import Swings
from sweetspot.report.file_set import check_folder, write_folder
from sweetspot.report.markup import Html, bullets, paragraphs, picture, section, table, text
from sweetspot.report.pictures.files import png_bytes, svg_bytes
from sweetspot.report.player.player_report import bat_rows, means, player_json
from sweetspot.report.player.units import scale
from sweetspot.report.player.words import answers, facts, findings, notes
from sweetspot.units import INCH, MPH

NAMES = ("player.html", "player.png", "player.svg", "player.json")


def check_player_folder(folder: Path) -> None:
    """Refuse a folder that the report could not be written to, without touching anything."""
    check_folder(folder, NAMES)


def write_player(posterior: Posterior, advice: Advice, swings: Swings, folder: Path) -> list[Path]:
    """Write player.html, player.png, player.svg and player.json into a folder, all of them or none."""
    from sweetspot.report.player.picture import player_figure

    figure = player_figure(posterior, advice)
    drawing = svg_bytes(figure)
    found = json.dumps(player_json(posterior, advice, swings), indent=1, allow_nan=False) + "\n"
    contents = (
        player_page(posterior, advice, swings, drawing=drawing).encode(),
        png_bytes(figure),
        drawing,
        found.encode(),
    )
    return write_folder(folder, dict(zip(NAMES, contents, strict=True)))


def player_page(posterior: Posterior, advice: Advice, swings: Swings, *, drawing: bytes) -> str:
    """Return the whole page as HTML.

    Parameters
    ----------
    drawing : the picture as an SVG file.
    """
    asked = answers(advice)
    untried = [f"Could not be tried: {fault}." for fault in advice.faults]
    questions = "\n".join(f"<h3>{text(question)}</h3>\n<p>{text(answer)}</p>" for question, answer in asked)
    label = f"Expected {told(advice.goal)} against the contact point, and what changes of player and bat are worth."
    parts = [
        f"<header>\n<p>Training report</p>\n<h1>{text(posterior.model.bats[0].bat.name)}</h1>\n"
        f"<p>for {text(told(advice.goal))}, {advice.pitch_speed / MPH:.0f} mph pitch at the plate</p>\n</header>",
        _cards(posterior, advice),
        f'<div class="answer">\n{paragraphs(findings(posterior, swings))}\n</div>',
        section("Questions and answers", Html(questions), name="answers"),
        picture(drawing, name="player", label=label, caption="Lines are 95 % intervals over what the swings allow."),
        section("Bats tried, the best first", _table(bat_rows(advice)), name="bats"),
        section("The player in numbers", _table(facts(posterior)), name="numbers"),
        section("About the file", bullets([*notes(swings), *untried, means(advice.goal)]), name="file"),
        f"<footer>sweetspot {text(__version__)}</footer>",
    ]
    style = Path(__file__).parents[1].joinpath("page.css").read_text(encoding="utf-8")
    content = "\n".join(parts)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>Training report</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n"
        f"{content}\n</main>\n</body>\n</html>\n"
    )


def _cards(posterior: Posterior, advice: Advice) -> Html:
    """Return the numbers that a player asks for first, large."""
    size, digits, unit = scale(advice.goal)
    speed = posterior.learned["bat_speed"].interval
    cards = (
        (
            f"{advice.now.value / size:.{digits}f} {unit}".replace("of 100 swings", "%"),
            f"expected {told(advice.goal)} now",
        ),
        (f"{speed.value / MPH:.1f} mph", "mean bat speed"),
        (f"{posterior.learned['position_spread'].interval.value / INCH:.1f} in", "scatter of contact along the bat"),
        (f"{advice.contact_point.value / INCH:.1f} in", "from the tip: best place to meet the ball"),
    )
    items = "\n".join(f"<div><dt>{text(words)}</dt><dd>{text(number)}</dd></div>" for number, words in cards)
    return Html(f'<dl class="cards">\n{items}\n</dl>')


def _table(rows: list[dict[str, str]]) -> Html:
    return table(tuple(rows[0]), [tuple(str(cell) for cell in row.values()) for row in rows])
