"""Questions about a bat as plain functions: what differs from the sport's usual in, a typed answer out.

The command line and the public functions of the same names (`sweetspot.hit`, ...) both ask here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import starmap
from pathlib import Path
from typing import TYPE_CHECKING

from sweetspot import catalog
from sweetspot.answers.places import PlaceName, position_of
from sweetspot.answers.setups import AS_USUAL, HitSetup, Place, SwungWith, check_beyond_hands, round_bat
from sweetspot.catalog.implements import Loaded
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.papers.choices import Choices

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from sweetspot.analysis.certification.rules import League
    from sweetspot.analysis.certification.shots import Shots
    from sweetspot.answers.certify import CertifyAnswer
    from sweetspot.answers.certify_club import CertifyClubAnswer
    from sweetspot.answers.certify_paddle import CertifyPaddleAnswer
    from sweetspot.answers.compare import CompareAnswer
    from sweetspot.answers.hit import HitAnswer
    from sweetspot.answers.match import MatchAnswer
    from sweetspot.answers.paper import PaperAnswer
    from sweetspot.answers.report import ReportAnswer, ReportQuestion
    from sweetspot.answers.unhit import UnhitAnswer
    from sweetspot.answers.what_if import BatCell, WhatIfAnswer, WhatIfQuestion
    from sweetspot.equipment.ball import Ball
    from sweetspot.equipment.implement import Implement
    from sweetspot.motion.swing_law import SwingLaw


def report(implement: Loaded, *, setup: HitSetup = AS_USUAL, uncertainty: bool = False) -> ReportAnswer:
    """Analyze one implement: sweet spots, curves along it, its best hit, and the cost of misses.

    Parameters
    ----------
    implement : a bat or another implement, its name in the catalogue, or its file.
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        when swing or hands do not go with it, or the ball outweighs it.

    >>> import sweetspot
    >>> best = sweetspot.report("r161-ash", pitch_speed="85 mph").best_hit
    >>> f"{best.position:.2f} m, {best.exit_speed:.1f} m/s"
    '0.69 m, 46.3 m/s'
    """
    from sweetspot.answers.report import report_answer

    question, swung_with = _report_question(implement, setup, drawn=uncertainty)
    return replace(report_answer(question), swung_with=swung_with)


def report_or_tones(
    implement: Loaded, *, setup: HitSetup = AS_USUAL, uncertainty: bool = False
) -> ReportAnswer | UnhitAnswer:
    """Return the report of an implement, or the tones and nodes of one that its ball outweighs; see `report`."""
    from sweetspot.analysis.bat_analysis import outweighed
    from sweetspot.answers.report import report_answer
    from sweetspot.answers.unhit import unhit_answer

    question, swung_with = _report_question(implement, setup, drawn=uncertainty)
    if outweighed(question.reduced.body, question.conditions.ball):
        return unhit_answer(question.reduced, question.conditions)
    return replace(report_answer(question), swung_with=swung_with)


def _report_question(implement: Loaded, setup: HitSetup, *, drawn: bool) -> tuple[ReportQuestion, SwungWith | None]:
    from sweetspot.answers.report import ReportQuestion
    from sweetspot.dynamics.reduction import reduced_bat

    conditions, swung_with = setup.swung(implement.implement)
    reduced = reduced_bat(implement.implement, ball=conditions.ball)
    return ReportQuestion(reduced, conditions, setup.sources(implement, conditions), drawn=drawn), swung_with


def hit(
    implement: Loaded,
    *,
    at: Place | PlaceName,
    beside: float = 0.0,
    setup: HitSetup = AS_USUAL,
    uncertainty: bool = False,
) -> HitAnswer:
    """Return one collision: exit speed, q, BBCOR, contact time, peak force and where the energy goes.

    Parameters
    ----------
    implement : a bat or another implement, its name in the catalogue, or its file.
    at : m from the knob end; as a text also from the tip, "6in-from-tip", or "sweet-spot", "barrel" or "tip".
    beside : m beside the middle line of a face; not for bats.
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        for a place that is not on the implement, or is where the hands are, or a swing that does not go with it.

    >>> import sweetspot
    >>> round(sweetspot.hit("r161-ash", at="6in-from-tip").exit_speed, 1)  # m/s
    46.5
    """
    from sweetspot.answers.hit import HitQuestion, hit_answer

    conditions, swung_with = setup.swung(implement.implement)
    place = position_of(at, implement.implement, conditions)
    implement.implement.check_position(place, "at")
    check_beyond_hands(place, conditions.hands.position)
    sources = setup.sources(implement, conditions) if uncertainty else None
    answer = hit_answer(HitQuestion(implement.implement, conditions, place, beside, sources))
    return replace(answer, swung_with=swung_with)


def match(implement: Loaded, target: Loaded, *, places: tuple[float, ...] = ()) -> MatchAnswer:
    """Find the lead that gives a racket another's mass, balance point, swing weight and twist weight at once.

    Parameters
    ----------
    implement : the racket that lead goes on, its name in the catalogue, or its file.
    target : the racket that it shall feel like.
    places : m from the butt end where lead may go; none: anywhere.

    Raises
    ------
    InputError
        for implements of two sports or without a face, and places that are not on it.

    >>> import sweetspot
    >>> from sweetspot import catalog
    >>> racket = catalog.implement("tennis-racket")
    >>> found = sweetspot.match(racket, racket.replaced(name="heavier", mass=0.33, moi=0.0335))
    >>> found.reached, round(1000 * sum(piece.mass for piece in found.lead), 1)
    (True, 12.0)
    """
    from sweetspot.answers.match import MatchQuestion, match_answer

    return match_answer(MatchQuestion(implement.implement, target.implement, places))


def compare(
    *implements: Loaded,
    what_if: str | Sequence[str] = (),
    swing_law: str | None = None,
    player: Path | str | None = None,
    setup: HitSetup = AS_USUAL,
    uncertainty: bool = False,
) -> CompareAnswer:
    """Put implements side by side for one player's swing: what each gains or loses, how surely, whether rules allow it.

    Parameters
    ----------
    implements : each a bat or another implement, its name in the catalogue, or its file; the first is the reference.
    what_if : changes of a single implement, each beside it: "lead 6 g @ 52 cm", "knob-weight 2 oz", "end-load 1 oz",
        "shaved 0.2 mm", "rolled", "broken-in", "moisture 14 %", "drilled 10 in", "cork 10 in x 1 in", "rubber", "foam",
        "cup 0.9 in", "cut 0.5 in", "handle -0.03 in", "taper 1 in"; several on one after commas.
    swing_law : name of the law by which speed depends on the bat; None: the sport's.
    player : what fit-player answered, as JSON: speeds of bat and ball, and how much a heavier bat slows that player.
    uncertainty : whether the intervals come from draws, with what they come from.

    Raises
    ------
    InputError
        without one, of different sports, or when one of them or its swing is refused.

    >>> import sweetspot
    >>> [bat.label for bat in sweetspot.compare("r161-ash", "corked-r161").bats]
    ['R161, white ash', 'R161, corked']
    """
    if not implements:
        raise InputError("no bat was given; name one or more, for example r161-ash and youth-30")
    law = _law(implements[0], swing_law, setup)
    if player is not None:
        law, setup = _of_player(Path(player), implements[0].implement, law, setup)
    texts = [what_if] if isinstance(what_if, str) else list(what_if)
    if not texts:
        return _compared(implements, law, setup, drawn=uncertainty)
    if len(implements) != 1:
        raise InputError(f"changes were given with {len(implements)} bats; they are made to one")
    from sweetspot.answers.changes import changed

    (first,) = implements
    made = [changed(first.implement, text) for text in texts]
    every = [first, *(Loaded(each.implement, first.table) for each in made)]
    return _compared(every, law, setup, drawn=uncertainty, ends=[None, *(each.ends for each in made)])


def _of_player(
    file: Path, implement: Implement, law: SwingLaw | None, setup: HitSetup
) -> tuple[SwingLaw | None, HitSetup]:
    """Return swing law and setup with a fitted player's numbers where none are given."""
    from sweetspot.designs.batter_files import fitted_player, law_of_player

    fitted = fitted_player(file)
    if setup.pitch_speed is None:
        setup = replace(setup, pitch_speed=fitted["pitch_speed"])
    if setup.bat_speed is None:
        measured_at = implement.length - fitted["bat_speed_from_tip"]
        setup = replace(setup, bat_speed=fitted["bat_speed"], bat_speed_at=measured_at)
    return None if law is None else law_of_player(law, fitted), setup


def what_if(
    bat: Loaded,
    vary: Mapping[str, ArrayLike],
    *,
    swing_law: str | None = None,
    setup: HitSetup = AS_USUAL,
    show: BatCell = "exit_speed",
) -> WhatIfAnswer:
    """Compute a what-if table of a bat: one or two things are varied, every cell has the best hit and its numbers.

    Parameters
    ----------
    bat : a round bat, its name in the catalogue, or its file.
    vary : values by what they are of, down the table's side and across: mass, bore_diameter, bore_depth, cup_depth,
        wall_factor (of the wall's thickness), bat_speed or pitch_speed.
    swing_law : name of the law by which speed depends on the bat; None: the sport's.
    show : the answer that is printed, a name of `answers`.

    Raises
    ------
    InputError
        for anything else to be varied. A cell whose bat cannot be has no numbers, and ``failures`` say why.

    >>> import sweetspot
    >>> table = sweetspot.what_if("r161-ash", {"mass": ["29 oz", "33 oz"], "bore_depth": ["0 in", "10 in"]})
    >>> table.answers.exit_speed.round(1)  # m/s
    array([[46.3, 45.9],
           [46.9, 46.6]])
    """
    from sweetspot.answers.what_if import what_if_answer

    return what_if_answer(what_if_question(bat, vary, swing_law=swing_law, setup=setup, show=show))


def what_if_question(
    bat: Loaded, vary: Mapping[str, ArrayLike], *, swing_law: str | None, setup: HitSetup, show: BatCell
) -> WhatIfQuestion:
    """Return the question of `what_if`."""
    from sweetspot.analysis.what_if import Axis
    from sweetspot.answers.what_if import WhatIfQuestion, two_sides

    described, (rows, *columns) = round_bat(bat), starmap(Axis, two_sides(vary))
    return WhatIfQuestion(
        bat=described,
        rows=rows,
        columns=columns[0] if columns else None,
        conditions=setup.conditions(described),
        law=_law(bat, swing_law, setup),
        cell=show,
    )


def _law(first: Loaded, name: str | None, setup: HitSetup) -> SwingLaw | None:
    """Return how the speed of a swing depends on the bat; None: not at all."""
    return None if setup.same_speed else catalog.swing_law(name or catalog.sport(first.implement.sport).swing_law)


def _compared(
    implements: Sequence[Loaded],
    law: SwingLaw | None,
    setup: HitSetup,
    *,
    drawn: bool,
    ends: Sequence[tuple[Implement, Implement] | None] = (),
) -> CompareAnswer:
    from sweetspot.answers.compare import CompareQuestion, compare_answer

    conditions = setup.conditions(implements[0].implement)
    asked = [setup, *[AS_USUAL] * (len(implements) - 1)]  # the speeds as they were written are the first one's
    question = CompareQuestion(
        [loaded.implement for loaded in implements],
        conditions,
        law,
        sources=[each.sources(loaded, conditions) for each, loaded in zip(asked, implements, strict=True)],
        drawn=drawn,
        rules=True,
        ends=ends,
    )
    return compare_answer(question)


def certify(
    bat: Loaded,
    *,
    league: str | None = None,
    ball: str | None = None,
    shots: Shots | None = None,
    standard_ball_cor: float | None = None,
    wall_that_passes: bool = False,
    uncertainty: bool = False,
) -> CertifyAnswer:
    """Test a bat: BBCOR, BESR, BPF and the rules of leagues, each with its margin.

    Parameters
    ----------
    bat : a round bat, its name in the catalogue, or its file.
    league : of the catalogue, or "all" that use the ball; None: that of the bat's sport.
    ball : its name in the catalogue; None: the league's.
    shots : measured ones in place of a computed test, as `read_shots` returns them.
    standard_ball_cor : restitution that shots are normalized to; None: the ball's at 60 mph.
    wall_that_passes : whether to say which barrel wall of a hollow bat would just pass.
    uncertainty : whether to say how probable it is that each rule is kept, with intervals.

    Raises
    ------
    InputError
        for a bat that cannot be clamped, or a league or ball that is not known or do not go together.

    >>> import sweetspot
    >>> sweetspot.certify("r161-ash").verdict.value
    'pass'
    """
    from sweetspot.answers.certify import CertifyQuestion, certify_answer
    from sweetspot.catalog.standard_hit import standard_conditions

    described = round_bat(bat)
    leagues, fired = _leagues_for(described, league, ball)
    conditions = standard_conditions(described).replaced(ball=fired)
    question = CertifyQuestion(
        described,
        leagues,
        fired,
        shots=shots,
        standard_restitution=standard_ball_cor,
        passing_wall=wall_that_passes,
        sources=AS_USUAL.sources(bat, conditions) if uncertainty else None,
    )
    return certify_answer(question)


def certify_paddle(
    paddle: Loaded,
    *,
    league: str | None = None,
    ball: str | None = None,
    speed: float | None = None,
    clamp_inertia: float | None = None,
    shots: Shots | None = None,
) -> CertifyPaddleAnswer:
    """Test a paddle: its paddle-ball restitution in a clamp, other clamps, and the rules of associations.

    Parameters
    ----------
    paddle : its name in the catalogue, or its file.
    league : of the catalogue, or "all" that use the ball; None: that of the sport.
    ball : its name in the catalogue; None: that of the associations' test at their speed, the sport's own at another.
    speed : m/s of the ball; None: 60 mph, as in the test.
    clamp_inertia : kg m^2 about the axis of the clamp; None: 33 kg cm^2, the association's.
    shots : measured ones, as `read_shots` returns them.

    Raises
    ------
    InputError
        for another implement, or a league or ball that is not known or do not go together.

    >>> import sweetspot
    >>> answer = sweetspot.certify_paddle("pickleball-paddle")
    >>> bool(0.37 < answer.test.pbcor.value < 0.43)
    True
    """
    from sweetspot.answers.certify_paddle import (
        HEAVY_CLAMP,
        TEST_SPEED,
        CertifyPaddleQuestion,
        certify_paddle_answer,
    )

    described = paddle.implement
    if not isinstance(described, Paddle):
        raise InputError(f"{described.name} is no paddle; its test is another: see certify")
    game = catalog.sport(described.sport)
    speed = TEST_SPEED if speed is None else speed
    if ball is None and abs(speed - TEST_SPEED) > 1e-6:
        ball = game.balls[0]
    leagues, fired = _leagues_for(described, league, ball)
    inertia = HEAVY_CLAMP if clamp_inertia is None else clamp_inertia
    return certify_paddle_answer(CertifyPaddleQuestion(described, leagues, fired, speed, inertia, shots))


def certify_club(club: Loaded, *, league: str | None = None, ball: str | None = None) -> CertifyClubAnswer:
    """Test a golf club: the characteristic time of its face, its restitution, and the rules of the associations.

    Parameters
    ----------
    club : its name in the catalogue, or its file; ``characteristic_time`` in its ``[head]`` is what a pendulum read.
    league : of the catalogue, or "all" that use the ball; None: that of the sport.
    ball : its name in the catalogue, or its file; None: the sport's.

    Raises
    ------
    InputError
        for another implement, or a league or ball that is not known or do not go together.

    >>> import sweetspot
    >>> sweetspot.certify_club("golf-driver").checks[0].verdict
    'pass'
    """
    from sweetspot.answers.certify_club import CertifyClubQuestion, certify_club_answer

    described = club.implement
    if not isinstance(described, GolfClub):
        raise InputError(f"{described.name} is no golf club; its test is another: see certify")
    leagues, fired = _leagues_for(described, league, ball)
    return certify_club_answer(CertifyClubQuestion(described, leagues, fired))


def _leagues_for(tool: Implement, league: str | None, ball: str | None) -> tuple[list[League], Ball]:
    """Return the leagues whose rules are held against an implement, those of its sport if none is named, and the ball.

    Raises `InputError` where none of their rules is for such an implement.
    """
    from sweetspot.analysis.certification.rules import applies
    from sweetspot.catalog.rules import DEFAULT_LEAGUE, leagues_and_ball

    leagues, fired = leagues_and_ball(league or catalog.sport(tool.sport).rules or DEFAULT_LEAGUE, ball)
    if not any(applies(rule, tool) for each in leagues for rule in each.rules):
        names = " and ".join(each.name for each in leagues)
        raise InputError(f"no rule of {names} is for {tool.name}; leave --league out for the rules of its sport")
    return leagues, fired


def paper(bat: Loaded, *, choices: Choices = Choices(), setup: HitSetup = AS_USUAL) -> PaperAnswer:
    """Work through the implemented paper: its claims, its formulas evaluated, and the full model's answer.

    Parameters
    ----------
    bat : a round bat, its name in the catalogue, or its file.

    >>> import sweetspot
    >>> sweetspot.paper("r161-ash").rows[0].equation
    '1'
    """
    from sweetspot.analysis.bat_analysis import analyse
    from sweetspot.answers.paper import paper_answer

    conditions, swung_with = setup.swung(round_bat(bat))
    return replace(paper_answer(analyse(round_bat(bat), conditions), choices), swung_with=swung_with)
