"""What a bat says of itself where the ball outweighs it: weight, balance, tones and nodes, which need no ball."""

from __future__ import annotations

from sweetspot.analysis.sweet_spot import barrel_node
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.answers.report import vibration_modes
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import centre_of_percussion
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.report.bat.made_of import made_of_words
from sweetspot.report.bat.tables import mass_table, modes_table, places_table
from sweetspot.report.document import Document, Paragraph, Section
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.sentences import Sentence, Slot
from sweetspot.report.sport_words import in_words, reader_of, weight, words_of


def unhit_document(reduced: ReducedBat[Implement], conditions: Conditions) -> Document:
    """Return the report of an implement that is no heavier than the ball, without anything that a hit would tell."""
    bat, body, modes = reduced.bat, reduced.body, reduced.modes
    places = {
        "node_1": barrel_node(modes, harmonic=1),
        "node_2": barrel_node(modes, harmonic=2),
        "center_of_percussion": centre_of_percussion(body, pivot=conditions.hands.position),
    }
    places = {name: place for name, place in places.items() if place <= bat.length}  # a short one may lack one
    data = cleaned(
        {
            "bat": to_dict(mass_properties(bat, body)),
            "modes": [to_dict(mode) for mode in vibration_modes(modes)],
            "sweet_spots": {f"{name}_m": place for name, place in places.items()},
            "outcome": "the ball is no lighter than what would hit it",
        }
    )
    return Document(
        name="report", title=bat.name, subtitle=made_of_words(bat), kind=f"{sport(bat.sport).name}: without a ball",
        blocks=[Paragraph(_why(reduced, conditions))],
        details=[
            Section("sweet-spots", "What needs no ball", [places_table(bat, places)]),
            Section("mass", "Weight and balance", [mass_table(bat, body, mass_properties(bat, body))]),
            Section("modes", "How it rings", [modes_table(bat, vibration_modes(modes))]),
        ],
        data=data,
        rows={name: [mode[name] for mode in data["modes"]] for name in ("family", "harmonic", "frequency_hz")},
        reader=reader_of(bat),
    )  # fmt: skip


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
