"""What a winch does is the same at every height: rope on a drum counts where its drum is."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Winch

LINE, LOAD, g = 2.0, 50.0, 9.81  # kg/m, kg, m/s^2
LONG, SPEED = 5.0, 0.5  # m, m/s
METHODS = ["semi-implicit-euler", "esdirk3"]


def hoist(
    method: str, height: float, *, rises: float = 0.0, speed: float = -SPEED, start: float = 0.0
) -> rw.Result:
    """A load on a heavy rope; its drum begins `height` [m] above the origin and rises at `rises` [m/s]."""
    rope = Rope(
        segments=20,
        length=LONG,
        made_of=Material(EA=1e6, mass_per_length=LINE, axial_damping=2e4),
        shape={"kind": "hanging", "start": (0.0, 0.0, height)},
        loads=[{"node": -1, "mass": LOAD}],
    )
    moving = {"kind": "velocity", "velocity": (0.0, 0.0, rises)}
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(name="drum", node=0, motion=moving)],
            winches=[Winch(end="start", speed=speed, start=start, on_drum=4.0)],
            run=RunSettings(method=method, duration=2.0, start="at-rest", extremes=False),
        )
    )


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("speed", [-SPEED, SPEED])
def test_a_winch_does_the_same_work_at_every_height(method: str, speed: float) -> None:
    """It lifts the load and what hangs of the rope: the centre of mass of all, with what is on the drum.

    With that at the height of the origin, a drum 1000 m above it did -19 kJ for 0.58 as it took in a metre
    of this rope.
    """
    low, high = hoist(method, 0.0, speed=speed), hoist(method, 1000.0, speed=speed)
    for result in (low, high):
        wound = 2.0 * speed
        out = LONG + wound
        lift = -LOAD * g * wound - 0.5 * LINE * g * (out**2 - LONG**2)
        stretch = result.energy["elastic"][-1] - result.energy["elastic"][0]
        error = float(result.energy_error[-1])
        lost = result.work["friction"][-1]
        kept = result.energy["kinetic"][-1] + stretch - lost - error
        assert result.energy["gravity"][-1] - result.energy["gravity"][0] == pytest.approx(
            lift, rel=2e-3
        )
        assert result.work["winch"][-1] == pytest.approx(lift + kept, rel=2e-3)
    for part in ("gravity", "total"):
        np.testing.assert_allclose(high.energy[part], low.energy[part], atol=1e-2)
    np.testing.assert_allclose(high.work["winch"], low.work["winch"], atol=1e-2)
    share = "largest energy error, share of the energy turned over [%]"
    assert high.table[share] == pytest.approx(low.table[share], rel=1e-4)


@pytest.mark.parametrize("method", METHODS)
def test_rope_on_a_drum_that_rises_rises_with_it(method: str) -> None:
    """Its weight is in no reaction: what lifts it is the winch's work, and the books close."""
    still, up = hoist(method, 10.0, start=1.0), hoist(method, 10.0, rises=1.0, start=1.0)
    late = up.time > 1.0  # the jerk of the start is damped
    all_of_it = (LOAD + LINE * LONG) * g * up.time
    risen = up.energy["gravity"] - still.energy["gravity"]
    np.testing.assert_allclose(risen[late], all_of_it[late], rtol=2e-4)
    on = LINE * SPEED * np.maximum(up.time - 1.0, 0.0)
    lifted = float(np.trapezoid(on * g * 1.0, up.time))
    kinetic = -0.5 * on[-1] * ((1.0 + SPEED) ** 2 - SPEED**2)  # gone with what is on the drum
    more = up.work["winch"][-1] - still.work["winch"][-1]
    assert more == pytest.approx(lifted + kinetic, abs=0.1)
    assert np.abs(up.balance_residual).max() < 1e-8
