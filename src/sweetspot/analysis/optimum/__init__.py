"""The best way to hit: how to swing for carry, how high to send the ball, and the easiest way out of a park."""

from sweetspot.analysis.optimum.launch import BestLaunch, EasiestHomeRun, best_launch, easiest_home_run
from sweetspot.analysis.optimum.swing import BestSwing, best_swing

__all__ = ["BestLaunch", "BestSwing", "EasiestHomeRun", "best_launch", "best_swing", "easiest_home_run"]
