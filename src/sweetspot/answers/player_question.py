"""SwingFile of a player as a question, and as they are read from a file with the bats that they were made with."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from sweetspot import catalog
from sweetspot.answers.bat_sizes import sized_bats
from sweetspot.catalog.bats import DEFAULT_BAT
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError, maybe_meant, spelt_almost
from sweetspot.flight.air import Air
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.player.advice import Advice, advise
from sweetspot.player.goal import Goal
from sweetspot.player.model import PlayerModel, bats_of, player_model
from sweetspot.player.player_swing import check_enough
from sweetspot.player.posterior import PlayerPosterior, fit_player
from sweetspot.player.sensor import sensor_of
from sweetspot.player.swing_table import one_name
from sweetspot.player.swings import MOST_SWINGS, SwingFile, evenly, read_swings
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns

BBCOR, COLLEGE_BAT = "bbcor", "college-alloy"
"""What a bat that is not known has in its name, and the bat that it is then taken for."""


@dataclass(frozen=True)
class FitPlayerQuestion:
    """SwingFile of one player, or of every batter of a file.

    Parameters
    ----------
    file : CSV or Parquet, a row per swing.
    bat : the player's; None: the one most swung in the file, or a usual one.
    named_bats : which bat a name in the file is.
    load_bat : returns a bat by a name in the file, or raises `InputError`.
    stand_ins : whether bats that are not known are taken for usual ones; else their rows are left out.
    batter : whose rows to use, where the file has several batters.
    pitch_speed : m/s at the plate, for rows without one; 0: a tee.
    speed_from_tip : m from the tip where bat speed is measured, or that place on a bat.
    ball : name in the catalogue; None: the first of the bat's sport.
    columns : what a person says of the columns.
    goal : what the player wants more of.
    other_bats : to try, besides changes of the player's own and the bats of the file.
    air : that balls fly in.
    seed : of the random numbers.
    """

    file: Path
    bat: Bat | None = None
    named_bats: Mapping[str, Bat] = field(default_factory=dict)
    load_bat: Callable[[str], Bat] = catalog.load_bat
    stand_ins: bool = True
    batter: str | None = None
    pitch_speed: float | None = None
    speed_from_tip: float | Callable[[Bat], float] = SPEED_FROM_TIP
    ball: str | None = None
    columns: GivenColumns = NOTHING_GIVEN
    goal: Goal = field(default_factory=Goal)
    other_bats: Sequence[Bat] = ()
    air: Air = field(default_factory=Air)
    seed: int = 1

    def ball_for(self, bat: Bat) -> str:
        """Return the name of the ball that is hit with a bat."""
        return self.ball or catalog.sport(bat.sport).balls[0]

    def bat_named(self, name: str) -> Bat:
        """Return the bat that a name in the file is; raises `InputError` where it is not known."""
        named = {one_name(name_in_file): bat for name_in_file, bat in self.named_bats.items()}
        return named[one_name(name)] if one_name(name) in named else self.load_bat(name)

    def stand_in_for(self, name: str) -> Bat:
        """Return the bat that one of an unknown name is taken for."""
        return self.bat or catalog.load_bat(COLLEGE_BAT if BBCOR in name.casefold() else DEFAULT_BAT)

    def pattern_of(self, name: str) -> Bat:
        """Return the bat that one of a name in the file is like where its row has a weight or a length; "": no name."""
        if name:
            try:
                return self.bat_named(name)
            except InputError:
                pass  # a sensor's own name
        return self.stand_in_for(name)


@dataclass(frozen=True)
class PlayerSwings:
    """A player's swings as they were read, with the bats that they were made with.

    ``file``: the swings that count, and what to know about the file. ``bat``, ``others``: the player's own bat, and the
    others by their names in the file.
    """

    question: FitPlayerQuestion
    file: SwingFile
    bat: Bat
    others: Mapping[str, Bat]

    def model(self) -> PlayerModel:
        """Return the swings ready to be fitted."""
        place, bat = self.question.speed_from_tip, self.bat
        return player_model(
            self.file.swings,
            bat=bat,
            ball=catalog.ball(self.question.ball_for(bat)),
            others=dict(self.others),
            law=catalog.swing_law(catalog.sport(bat.sport).swing_law),
            speed_from_tip=place(bat) if callable(place) else place,
            sensor=sensor_of(self.file.system),
        )


def read_player(question: FitPlayerQuestion, most_swung: Bat | None = None) -> PlayerSwings:
    """Return the swings of one player, those with unknown bats among the bad rows.

    ``most_swung``: the player's bat where the question names none and the file was read before.

    Raises
    ------
    InputError
        for a file that cannot be read, tells too little of a player, or has a misspelt bat.
    """
    players_bat = most_swung or question.bat or catalog.load_bat(DEFAULT_BAT)
    table = read_swings(
        question.file,
        length=players_bat.length,
        given=question.columns,
        pitch_speed=question.pitch_speed,
        batter=question.batter,
        sport=players_bat.sport,
    )
    sized = sized_bats(table.swings, pattern_of=question.pattern_of)
    if not sized.swings:
        first = sized.bad_rows[0]
        raise InputError(f"{question.file} has no bat that can be: row {first.row}: {first.reason}")
    good, bats, bad, notes = bats_of(
        sized.swings,
        load=lambda name: sized.bats[name] if name in sized.bats else question.bat_named(name),
        stand_in_for=question.stand_in_for if question.stand_ins else None,
    )
    if question.bat is None and most_swung is None:  # the file says itself what is swung
        swung = Counter(swing.bat for swing in good if swing.bat in bats).most_common(1)
        if swung:
            return read_player(question, bats[swung[0][0]])
        if good and BBCOR in good[0].bat.casefold():
            return read_player(question, question.stand_in_for(good[0].bat))
    names = sorted({swing.bat for swing in good} - {"", *bats})
    if names and question.bat is None and spelt_almost(names[0], catalog.bat_names()):
        meant = maybe_meant(names[0], catalog.bat_names())
        raise InputError(f"{question.file} has the bat {meant}: mend the name, or say which bat it is with --bat")
    if callable(question.speed_from_tip):
        question.speed_from_tip(players_bat)  # is that place on the bat?
    same = {name for name, other in bats.items() if other == players_bat}
    good = tuple(replace(swing, bat="") if swing.bat in same else swing for swing in good)
    rows = tuple(sorted((*table.bad_rows, *sized.bad_rows, *bad), key=lambda row: row.row))
    check_enough(good, question.file, rows)
    good, thinned = evenly(good, MOST_SWINGS)
    unnamed = question.bat is None and most_swung is None
    assumed = (
        (f"No bat was named: the swings are taken as made with {players_bat.name}; say --bat.",) if unnamed else ()
    )
    file = replace(table, swings=good, bad_rows=rows, notes=(*assumed, *table.notes, *sized.notes, *notes, *thinned))
    return PlayerSwings(question, file, players_bat, {name: bat for name, bat in bats.items() if name not in same})


def player_posterior(swings: PlayerSwings) -> PlayerPosterior:
    """Return the player's parameters fitted to the swings."""
    return fit_player(swings.model(), seed=swings.question.seed)


def player_advice(
    question: FitPlayerQuestion, posterior: PlayerPosterior, progress: Callable[[int, int], None] | None = None
) -> Advice:
    """Return the bat and contact point advised for a player."""
    return advise(
        posterior,
        goal=question.goal,
        aerodynamics=catalog.aerodynamics_of_ball(question.ball_for(posterior.model.bats[0].bat)),
        air=question.air,
        others=question.other_bats,
        progress=progress,
    )
