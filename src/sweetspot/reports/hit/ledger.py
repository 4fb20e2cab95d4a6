"""Where the energy of a hit goes: the parts, what each is called, and its colour."""

from __future__ import annotations

from collections.abc import Mapping

from sweetspot.reports.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, SKY

MUTED = "#59636e"

ENERGY_NAMES: Mapping[str, tuple[str, str]] = {
    "ball": ("{ball}, flying back", RED),
    "heat": ("heat in the {ball}", MUTED),
    "translation": ("{implement}, pushed back", BLUE),
    "rotation": ("{implement}, turned", SKY),
    "bending": ("{implement}, bending vibration", PURPLE),
    "hoop": ("{implement}, barrel vibration", ORANGE),
    "face": ("face, vibration", ORANGE),
    "damping": ("heat in {implement} and {hands}", GREEN),
}
"""Field of `EnergyLedger`: (what it is called, with a sport's words; colour)."""
FILM_NAMES = {name: words for name, (words, _) in ENERGY_NAMES.items()} | {
    "ball": "{ball}, moving",
    "stored": "{ball}, squeezed",
    "dent": "surface, pressed in",
}
"""Field of `EnergyHistory`: what it is called while the hit lasts."""
