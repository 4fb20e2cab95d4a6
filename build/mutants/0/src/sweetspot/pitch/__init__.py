"""From the pitcher's hand to the plate: the ball's velocity and spin where the bat meets it.

Either tracked pitches, Statcast's nine parameters, are followed to the plate, or a `Delivery` is flown there through
the air. Both end in a `BallMotion` over the front edge of the plate.
"""

from sweetspot.pitch.delivery import Delivery, PitchFlight, aimed, thrown
from sweetspot.pitch.places import MIDDLE, PLATE, REFERENCE, RUBBER
from sweetspot.pitch.spin import pitch_spin, spin_from_movement
from sweetspot.pitch.tracked import NineParameters, approach_angles, at_plate, nine_parameters

__all__ = [
    "MIDDLE",
    "PLATE",
    "REFERENCE",
    "RUBBER",
    "Delivery",
    "NineParameters",
    "PitchFlight",
    "aimed",
    "approach_angles",
    "at_plate",
    "nine_parameters",
    "pitch_spin",
    "spin_from_movement",
    "thrown",
]
