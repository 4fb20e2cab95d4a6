"""The same hit in a general rigid-body engine, MuJoCo: a capsule with the bat's mass and inertia, and a sphere."""

from __future__ import annotations

from collections.abc import Callable

from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.ball import Ball

STEP, STEPS = 1e-5, 1200
CONTACTS = {
    "default (0.02 s, ratio 1)": "0.02 1",
    "0.5 ms, ratio 0.3": "0.0005 0.3",
    "1e8 /s^2, 4e3 /s": "-1e8 -4e3",
}
"""Settings of the contact (solref): time constant and damping ratio, or minus stiffness and minus damping."""

SCENE = """
<mujoco>
  <option timestep="{step}" gravity="0 0 0" integrator="implicitfast"/>
  <default><geom condim="1" solref="{contact}" solimp="0.9 0.95 0.001"/></default>
  <worldbody>
    <body name="bat"><freejoint/>
      <inertial pos="{balance} 0 0" mass="{bat_mass}" diaginertia="{roll} {moi} {moi}"/>
      <geom type="capsule" fromto="0.03 0 0 0.80 0 0" size="{bat_radius}"/>
    </body>
    <body name="ball" pos="{place} {gap} 0"><freejoint/>
      <geom type="sphere" size="{ball_radius}" mass="{ball_mass}"/>
    </body>
  </worldbody>
</mujoco>
"""


def rigid_hit(
    contact: str, *, body: RigidBody, ball: Ball, bat_radius: float, place: float, closing: float
) -> Callable[[], float]:
    """Return a function that runs one hit and returns its collision efficiency q."""
    import mujoco  # noqa: PLC0415 - the table is printed without it, too

    numbers = {
        "step": STEP, "contact": contact, "balance": body.balance_point, "bat_mass": body.mass, "roll": body.roll_moi,
        "moi": body.moi_cm, "bat_radius": bat_radius, "place": place, "gap": bat_radius + ball.radius + 1e-4,
        "ball_radius": ball.radius, "ball_mass": ball.mass,
    }  # fmt: skip
    model = mujoco.MjModel.from_xml_string(SCENE.format(**numbers))
    data = mujoco.MjData(model)

    def run() -> float:
        mujoco.mj_resetData(model, data)
        data.qvel[7] = -closing  # the ball's speed across the bat
        mujoco.mj_step(model, data, nstep=STEPS)
        return float(data.qvel[7]) / closing

    return run
