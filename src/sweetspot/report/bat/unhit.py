"""What a bat says of itself where the ball outweighs it: weight, balance, tones and nodes, which need no ball."""

from __future__ import annotations

from sweetspot.answers.unhit import UnhitAnswer
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.report.bat.made_of import made_of_words
from sweetspot.report.bat.tables import mass_table, modes_table, places_table
from sweetspot.report.document import Document, Paragraph, Section
from sweetspot.report.sentences import Sentence, Slot
from sweetspot.report.sport_words import in_words, reader_of, weight, words_of


def unhit_document(answer: UnhitAnswer) -> Document:
    """Return the report of an implement that is no heavier than the ball."""
    bat, data = answer.reduced.bat, answer.to_dict()
    places = {name: place for name, place in vars(answer.sweet_spots).items() if place is not None}
    return Document(
        name="report",
        title=bat.name,
        subtitle=made_of_words(bat),
        kind=f"{sport(bat.sport).name}: without a ball",
        blocks=[Paragraph(_why(answer.reduced, answer.conditions))],
        details=[
            Section("sweet-spots", "What needs no ball", [places_table(bat, places)]),
            Section("mass", "Weight and balance", [mass_table(bat, answer.reduced.body, answer.bat)]),
            Section("modes", "How it rings", [modes_table(bat, answer.modes)]),
        ],
        data=data,
        rows={name: [mode[name] for mode in data["modes"]] for name in ("family", "harmonic", "frequency_hz")},
        reader=reader_of(bat),
    )


def _why(reduced: ReducedBat[Implement], conditions: Conditions) -> Sentence:
    bat = reduced.bat
    return in_words(
        "No hit is computed: the {ball} weighs {ball_mass} and this {implement} {mass}; a {ball} that is not lighter "
        "sweeps it aside. Its first two tones are {first} and {second}. What else needs no {ball} stands below.",
        words_of(bat),
        ball_mass=weight(conditions.ball.mass), mass=weight(reduced.body.mass),
        first=_tone(reduced, 1), second=_tone(reduced, 2),
    )  # fmt: skip


def _tone(reduced: ReducedBat[Implement], harmonic: int) -> Slot:
    modes = reduced.modes
    return Slot(float(modes.frequency[modes.of_family("bending")[harmonic - 1]]), "frequency")
