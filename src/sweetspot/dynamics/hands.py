"""Effect of hands on the handle on the bat's motions."""

from __future__ import annotations

import numpy as np

from sweetspot.dynamics.modes import Family, Modes
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.eigen import eigenpairs
from sweetspot.numerics.piecewise import Piecewise


def held_modes(modes: Modes, hands: Hands) -> Modes:
    """Return the motions of the bat held by two hands, each a mass behind a spring and a damper (its flesh).

    Coordinates are the free motions q and the two hands' own displacements y. With s the shapes at a hand, the
    spring stores k (s.q - y)^2 / 2 and the damper takes c (s.q' - y')^2; M = diag(1, ..., 1, m, m). The undamped
    problem K v = omega^2 M v is solved exactly and the dampers are kept whole, as dashpots that couple the modes:
    leaving out that coupling would let hands reach the ball before any wave could.

    The hands move with the undisturbed swing, so springs and dampers act on the disturbance by the ball only.
    A hand without mass has no effect.

    Parameters
    ----------
    modes : of the free bat, from `all_modes`.
    hands : where they hold, and what they weigh.

    Returns
    -------
    Modes
        two more than the free ones; those in which the hands move most are of family "hand".

    >>> from sweetspot import all_modes, beam_model, catalog, held_modes, standard_conditions
    >>> bat = catalog.bat("r161-ash")
    >>> free = all_modes(beam_model(bat), catalog.ball())
    >>> held = held_modes(free, standard_conditions(bat).hands.replaced(mass=1.0, stiffness=2e4))
    >>> len(held) - len(free)
    2
    """
    if hands.mass == 0:
        return modes
    count = len(modes)
    stretch = np.hstack([modes.shape_at(np.array(hands.places)), -np.eye(2)])  # of each hand's flesh
    inertia = np.diag(np.concatenate([np.ones(count), [hands.mass, hands.mass]]))
    stiffness = np.diag(np.concatenate([modes.angular_frequency**2, [0.0, 0.0]]))
    squares, vectors = eigenpairs(stiffness + hands.stiffness * stretch.T @ stretch, inertia)
    dashpots = np.sqrt(hands.damping) * stretch @ vectors
    _, turn = np.linalg.eigh(dashpots @ dashpots.T)  # to orthogonal rows with the same damping matrix
    families, harmonics = _names(modes, vectors)
    return Modes(
        families=families,
        harmonics=harmonics,
        frequency=np.sqrt(np.maximum(squares, 0.0)) / (2 * np.pi),
        damping_rate=modes.damping_rate @ vectors[:count] ** 2,
        shapes=Piecewise(modes.shapes.coefficients @ vectors[:count], modes.shapes.ends),
        rigid_part=modes.rigid_part @ vectors[:count],
        dashpots=turn.T @ dashpots,
        surface=None if modes.surface is None else modes.surface.mixed(vectors[:count]),
        compliances=modes.compliances,
    )


def _names(modes: Modes, vectors: Array) -> tuple[tuple[Family, ...], tuple[int, ...]]:
    """Return family and harmonic of each held mode: the lowest ones are rigid, two belong to the hands.

    Modes of barrel and face, which hands on the handle do not feel, keep their names wherever they now stand in the
    list.
    """
    count = len(modes)
    apart = modes.of_family("hoop") + modes.of_family("face")
    ringing = (vectors[apart] ** 2).sum(axis=0) > (vectors**2).sum(axis=0) / 2
    share = (vectors[count:] ** 2).sum(axis=0) / (vectors**2).sum(axis=0)
    share[: modes.families.count("rigid")] = -1.0
    of_hands = set(np.argsort(share)[-2:].tolist())
    names = list(zip(modes.families, modes.harmonics, strict=True))
    others = [name for number, name in enumerate(names) if number not in apart]
    in_order = iter(sorted(others, key=lambda name: name[0] != "rigid"))
    named: list[tuple[Family, int]] = []
    for index in range(count + 2):
        if index in of_hands:
            named.append(("hand", 1 + sum(name == "hand" for name, _ in named)))
        elif ringing[index]:
            named.append(names[apart[int(np.argmax(vectors[apart, index] ** 2))]])
        else:
            named.append(next(in_order))
    families, harmonics = zip(*named, strict=True)
    return families, harmonics
