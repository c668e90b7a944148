"""A stretch limiter that makes up energy is told of: it can only take where nothing drives a scene."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.limiter_note import MOST
from ropewalk.scene import (
    Air,
    Anchor,
    Force,
    Kick,
    Limiter,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Velocity,
)

ABOUT = "about the stretch limiter"


def hung(mass: float, speed: float, **more: object) -> rw.Result:
    """A load on a fine, soft rope, which swings at its bound."""
    soft = Material(EA=5.0, mass_per_length=0.05, axial_damping=0.1)
    count = int(more.pop("segments", 60))
    rope = Rope(
        segments=count,
        length=1.0,
        made_of=soft,
        shape=Points(points=[(0, 0, -i / count) for i in range(count + 1)]),
        loads=[{"node": -1, "mass": mass}],
        diameter=0.01,
        forces=more.pop("forces", []),
        kicks=[Kick(node=-1, velocity=(speed, 0, 0))] if speed else [],
    )
    run = {"method": "semi-implicit-euler", "time_step": 1e-4, "duration": 0.5, "frame_rate": 100.0}
    scene = Scene(
        ropes=[rope],
        anchors=[Anchor(node=0)],
        limiter=Limiter(min_stretch=0.5, max_stretch=1.05),
        air=more.pop("air", None),
        obstacles=more.pop("obstacles", []),
        run=RunSettings(**(run | more)),
    )
    return rw.simulate(scene)


def test_energy_from_a_limiter_is_told() -> None:
    """A hundred kilograms on 0.05 kg. The twins: a load that it stops; one that does not swing; esdirk3."""
    said = hung(100.0, 1.0).table[ABOUT]
    assert "can only take" in said
    assert "time_step = 1e-05 s" in said
    assert ABOUT not in hung(10.0, 1.0).table
    assert ABOUT not in hung(100.0, 0.0).table
    long = hung(1.0, 0.0, segments=20, time_step=1e-3, duration=4.0)  # its work grows as it hangs
    assert ABOUT not in long.table
    assert long.work["limiter"][-1] > long.work["limiter"].min() + 0.1
    assert ABOUT not in hung(100.0, 1.0, method="esdirk3", time_step=1 / 240).table


def test_what_it_put_in_is_told_whole_where_other_things_take_of_it() -> None:
    """Drag took a quarter; the rise of the energy was told for what the limiter had put in."""
    thick = hung(100.0, 1.0, air={"node_drag": 5.0})
    work, total = thick.work["limiter"], thick.energy["total"]
    put_in, risen = ((one - np.minimum.accumulate(one)).max() for one in (work, total))
    assert put_in > 1.2 * risen
    assert f"it has put in {put_in:.3g} J" in thick.table[ABOUT]


@pytest.mark.parametrize(
    "driver",
    [
        {"forces": [Force(node=-1, force=(3.0, 0, 0))]},
        {"air": Air(node_drag=1.0, wind=(1.0, 0, 0))},
        {
            "obstacles": [
                Sphere(center=(-0.3, 0, -1.0), radius=0.1, motion=Velocity(velocity=(0.15, 0, 0)))
            ]
        },
    ],
)
def test_what_drives_a_scene_is_not_the_limiters(driver: dict[str, object]) -> None:
    """A force, wind or an obstacle that pushes raised the energy, and the limiter was told to have."""
    result = hung(1.0, 0.0, segments=20, time_step=1e-3, duration=4.0, **driver)
    work, total = result.work["limiter"], result.energy["total"]
    given, risen = ((one - np.minimum.accumulate(one)).max() for one in (work, total))
    turned = np.ptp(result.energy["gravity"])
    assert min(given, risen) > MOST * turned  # what was asked alone
    assert ABOUT not in result.table


@pytest.mark.parametrize("method", ["semi-implicit-euler", "esdirk3"])
def test_a_load_that_hangs_at_its_bound_has_no_share_of_energy(method: str) -> None:
    """Nothing is turned over but rounding; the twin swings."""
    soft = Material(EA=5.0, mass_per_length=0.05, axial_damping=0.1)
    shares = []
    for speed in (0.0, 0.5):
        rope = Rope(
            segments=20,
            length=1.0,
            made_of=soft,
            shape=Points(points=[(0, 0, -1.05 * i / 20) for i in range(21)]),
            loads=[{"node": -1, "mass": 1.0}],
            kicks=[Kick(node=-1, velocity=(speed, 0, 0))] if speed else [],
        )
        run = RunSettings(method=method, time_step=1e-3, duration=0.2, frame_rate=100.0)
        limiter = Limiter(min_stretch=0.5, max_stretch=1.05)
        scene = Scene(ropes=[rope], anchors=[Anchor(node=0)], limiter=limiter, run=run)
        table = rw.simulate(scene).table
        shares.append(table["largest energy error, share of the energy turned over [%]"])
    assert math.isnan(shares[0])
    assert shares[1] > 0.0
