"""Whom a bat is shaped for, as plain numbers: where the ball is met, how high, and how the swing depends on the bat."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import analyse
from sweetspot.designs.batter import Batter, ContactPlaces, contacts_at, fitted_contact, known_contact, usual_batter
from sweetspot.designs.batter_files import contacts_of_file, fitted_player, law_of_player
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.seasons.ball_maps import contact_places
from sweetspot.units import INCH, format_length

WIDEST_SPREAD, WIDEST_DOUBT = 0.1, 0.2
"""m; larger ones are slips of the unit."""


@dataclass(frozen=True, kw_only=True)
class BatterSetup:
    """Contacts and swing of a batter; None: as is usual, or as the file says.

    Parameters
    ----------
    contact, contact_spread : mean place of contact from the tip, and its standard deviation, m.
    contacts : table of contacts, or the folder that a season was written to.
    batter : whose of them.
    player : what fit-player answered, as JSON.
    doubt : standard deviation in m of where the mean contact lies, beyond what few balls leave open.
    offset, offset_spread : mean and standard deviation of the ball's centre above the bat's axis, m.
    swing_law : name in the catalogue, or "none" for the same speed with every bat; None: its sport's.
    exponent : in place of the law's own.
    """

    contact: float | None = None
    contact_spread: float | None = None
    contacts: Path | str | None = None
    batter: str | None = None
    player: Path | str | None = None
    doubt: float = 0.5 * INCH
    offset: float | None = None
    offset_spread: float | None = None
    swing_law: str | None = None
    exponent: float | None = None

    def of(self, implement: Implement, conditions: Conditions) -> Batter:
        """Return the batter who swings an implement under these conditions.

        Raises
        ------
        InputError
            for values that no batter has, two ways of saying where the ball is met, or files that do not say it.
        """
        if self.batter is not None and self.contacts is None:
            raise InputError(f"batter was given as {self.batter}, but no table; give it by contacts")
        ways = [name for name in ("contact", "contacts", "player") if getattr(self, name) is not None]
        if len(ways) > 1:
            raise InputError(f"{' and '.join(ways)} both say where the ball is met; give one of them")
        usual = dict(usual_batter())
        if implement.outline is not None:
            usual |= _on_a_face(implement, conditions)
        if self.player is not None:
            usual |= fitted_player(Path(self.player))
        spread = usual["offset_spread"] if self.offset_spread is None else self.offset_spread
        if not 0 < spread < WIDEST_SPREAD:
            raise InputError(
                f"offset_spread was given as {format_length(spread)}; allowed is more than 0 in, up to 3.9 in"
            )
        if not 0 <= self.doubt < WIDEST_DOUBT:
            raise InputError(f"doubt was given as {format_length(self.doubt)}; allowed is 0 in to 7.8 in")
        contacts = self._contacts(usual)
        return Batter(
            weight=contacts.weight,
            offset=usual["offset"] if self.offset is None else self.offset,
            offset_spread=spread,
            bat_speed=usual.get("bat_speed", conditions.swing.bat_speed),
            pitch_speed=usual.get("pitch_speed", conditions.pitch.speed),
            law=self._law(implement, usual),
            doubt=self.doubt,
            speed_from_tip=usual.get("bat_speed_from_tip", implement.length - conditions.swing.measured_at),
            sample=contacts if contacts.balls else None,
        )

    def _contacts(self, usual: dict[str, float]) -> ContactPlaces:
        table = None if self.contacts is None else Path(self.contacts)
        if table is not None and table.is_dir():
            if self.batter is None:
                raise InputError(
                    f"{table} is a season's folder; name the batter by --batter, a number of its players.csv"
                )
            return contacts_at(contact_places(table, self.batter))
        if table is not None:
            return contacts_of_file(table, batter=self.batter)
        mean = usual["position"] if self.contact is None else self.contact
        scatter = usual["position_spread"] if self.contact_spread is None else self.contact_spread
        if not usual.get("balls"):
            return known_contact(mean, scatter)
        doubts = usual["position_doubt"], usual["position_spread_doubt"]
        return fitted_contact((mean, doubts[0]), (scatter, doubts[1]), balls=usual["balls"])

    def _law(self, implement: Implement, usual: dict[str, float]) -> SwingLaw | None:
        if self.swing_law == "none":
            if self.exponent is not None:
                raise InputError("exponent belongs to a law; leave out the swing law none")
            return None
        law = catalog.swing_law(self.swing_law or catalog.sport(implement.sport).swing_law)
        if self.exponent is not None:
            return replace(law, exponent=self.exponent)
        return law_of_player(law, usual) if self.player is not None else law


def _on_a_face(implement: Implement, conditions: Conditions) -> dict[str, float]:
    """Return the contact places of an unknown player: about the fastest place, spread by a sixth of the face."""
    face = implement.outline
    assert face is not None  # whoever asks has looked
    return {
        "position": implement.length - analyse(implement, conditions).best.position,
        "position_spread": min(usual_batter()["position_spread"], (face.end - face.start) / 6),
    }
