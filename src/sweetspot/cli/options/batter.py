"""Whom a bat is for: where the ball is met, how high, and how the swing depends on the bat."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.design.batter import Batter
    from sweetspot.design.contacts import ContactPlaces
    from sweetspot.equipment.implement import Implement
    from sweetspot.motion.swing import Conditions
    from sweetspot.motion.swing_law import SwingLaw


@Parameter(name="*")
@dataclass(frozen=True)
class BatterOptions:
    """Contacts and swing of a batter."""

    contact: Annotated[
        str | None,
        Parameter(help="Where the ball is met on average, from the tip; default: 6.5in, on a face its best place."),
    ] = None
    contact_spread: Annotated[
        str | None, Parameter(help="Standard deviation of that; default: 1.8in, at most a sixth of a face.")
    ] = None
    contacts: Annotated[
        Path | None,
        Parameter(
            help="CSV of contacts instead: a column from_tip_in, perhaps weight; or the folder that season --out wrote."
        ),
    ] = None
    batter: Annotated[
        str | None, Parameter(help="Whose of them, where the table has a column batter: a number or a name.")
    ] = None
    player: Annotated[
        Path | None, Parameter(help="Answer of fit-player --format json instead: contacts and speeds of that player.")
    ] = None
    doubt: Annotated[
        str,
        Parameter(
            help="How well the mean contact is known, one standard deviation; what few balls leave open comes on top."
        ),
    ] = "0.5in"
    offset: Annotated[str | None, Parameter(help="Ball's centre above the bat's axis on average; default: 0.2in.")] = (
        None
    )
    offset_spread: Annotated[str | None, Parameter(help="Standard deviation of that; default: 1.1in.")] = None
    swing_law: Annotated[
        str | None,
        Parameter(
            help="How bat speed depends on the bat: a law of the catalogue, or none for the same speed; default: its "
            "sport's."
        ),
    ] = None
    exponent: Annotated[float | None, Parameter(help="Exponent of the law in place of its own, 0 to 0.5.")] = None


DEFAULT_BATTER = BatterOptions()


def batter_of(options: BatterOptions, bat: Implement, conditions: Conditions) -> Batter:
    """Return the batter that the options describe, with the present bat under these conditions."""
    from sweetspot.design.batter import Batter
    from sweetspot.design.batter_files import fitted_player
    from sweetspot.design.contacts import fitted_contact, known_contact, usual_batter
    from sweetspot.plausibility import parse

    if options.batter is not None and options.contacts is None:
        raise InputError(f"--batter was given as {options.batter}, but no table; give it by --contacts")
    ways = [name for name in ("contact", "contacts", "player") if getattr(options, name) is not None]
    if len(ways) > 1:
        raise InputError(f"--{' and --'.join(ways)} both say where the ball is met; give one of them")
    known = dict(usual_batter())
    if bat.outline is not None:
        known |= _on_a_face(bat, conditions)
    if options.player is not None:
        known |= fitted_player(options.player)

    def length(text: str | None, name: str, option: str) -> float:
        return known[name] if text is None else parse(text, "length", option)

    if options.contacts is not None:
        contacts = _contacts(options.contacts, options.batter)
    else:
        mean = length(options.contact, "position", "--contact")
        scatter = length(options.contact_spread, "position_spread", "--contact-spread")
        contacts = known_contact(mean, scatter) if not known.get("balls") else fitted_contact(
            (mean, known["position_doubt"]), (scatter, known["position_spread_doubt"]), balls=known["balls"]
        )  # fmt: skip
    spread = length(options.offset_spread, "offset_spread", "--offset-spread")
    doubt = parse(options.doubt, "length", "--doubt")
    if not 0 < spread < 0.1:
        raise InputError(
            f"--offset-spread was given as {options.offset_spread}; allowed is more than 0 in, up to 3.9 in"
        )
    if not 0 <= doubt < 0.2:
        raise InputError(f"--doubt was given as {options.doubt}; allowed is 0 in to 7.8 in")
    return Batter(
        weight=contacts.weight, offset=length(options.offset, "offset", "--offset"), offset_spread=spread,
        bat_speed=known.get("bat_speed", conditions.swing.bat_speed),
        pitch_speed=known.get("pitch_speed", conditions.pitch.speed), law=_law(options, bat), doubt=doubt,
        speed_from_tip=bat.length - conditions.swing.measured_at, sample=contacts if contacts.balls else None,
    )  # fmt: skip


def _contacts(path: Path, batter: str | None) -> ContactPlaces:
    """Return the contacts of a table, or of one batter of a season's folder."""
    from sweetspot.design.batter_files import contacts_of_file
    from sweetspot.design.contacts import contacts_at

    if not path.is_dir():
        return contacts_of_file(path, batter=batter)
    from sweetspot.season.ball_maps import contact_places

    if batter is None:
        raise InputError(f"{path} is a season's folder; name the batter by --batter, a number of its players.csv")
    return contacts_at(contact_places(path, batter))


def _on_a_face(bat: Implement, conditions: Conditions) -> dict[str, float]:
    """Return where a player who is not known meets the ball: where it is fastest, give or take a sixth of the face."""
    from sweetspot.analysis.bat_analysis import analyse
    from sweetspot.design.contacts import usual_batter

    assert bat.outline is not None
    best = analyse(bat, conditions).best.position
    return {
        "position": bat.length - best,
        "position_spread": min(usual_batter()["position_spread"], (bat.outline.end - bat.outline.start) / 6),
    }


def _law(options: BatterOptions, bat: Implement) -> SwingLaw | None:
    from dataclasses import replace

    from sweetspot.catalog.sports import sport
    from sweetspot.catalog.swing_laws import swing_law

    if options.swing_law == "none":
        if options.exponent is not None:
            raise InputError("--exponent goes with a law; leave out --swing-law none")
        return None
    law = swing_law(options.swing_law or sport(bat.sport).swing_law)
    return law if options.exponent is None else replace(law, exponent=options.exponent)
