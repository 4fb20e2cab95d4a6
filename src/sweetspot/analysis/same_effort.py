"""A bat that was changed, or is choked up, in the hands of the player whose swing with it as it was is known."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.analysis.comparison import speed_ratios
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw, turned_faster


@dataclass(frozen=True)
class Changed:
    """A changed bat beside the bat that it was.

    ``before``, ``body_before``: the bat that the player's speed is known with. ``law``: how bat speed depends on the
    bat's moment of inertia.
    """

    bat: Implement
    body: RigidBody
    before: Implement
    body_before: RigidBody
    law: SwingLaw

    @classmethod
    def of(cls, bat: Implement, *, law: SwingLaw) -> Changed:
        """Return a bat paired with what it was before it was changed, by its own description."""
        before = bat.before_changes()
        return cls(bat, rigid_body(beam_model(bat)), before, rigid_body(beam_model(before)), law)

    @property
    def ratio(self) -> float:
        """Angular speed of the changed bat over that of the bat as it was, with the same effort."""
        return speed_ratios(self.law, self.bat, self.body, self.before, self.body_before).value

    def with_same_effort(self, conditions: Conditions) -> Conditions:
        """Return the conditions of the same player's swing of the changed bat.

        ``conditions``: with the pivot and hands of the changed bat's grip, and the bat speed of the bat as it was.
        """
        swing, grip = conditions.swing, self.bat.choke - self.before.choke
        gripped = swing.replaced(pivot=swing.pivot - grip)
        turned = turned_faster(gripped, self.ratio, measured_at=swing.measured_at, pivot=swing.pivot)
        return conditions.replaced(swing=turned)

    def speed_before(self, conditions: Conditions) -> float:
        """Return the bat speed in m/s of the bat as it was, from the changed bat's swing with the same effort."""
        swing, grip = conditions.swing, self.bat.choke - self.before.choke
        return swing.angular_speed / self.ratio * (swing.measured_at - swing.pivot + grip)
