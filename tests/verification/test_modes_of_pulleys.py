"""Modes of loads on a line over a wheel: its turning is a motion of its own."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Cylinder, Points, Polyline, SceneError, Spin

RADIUS, THICK, EA, MASS, g = 0.05, 0.002, 1000.0, 1.0, 9.81
ROUND, DOWN = 16, 50  # segments round half of the wheel, and on each side of it
ARM = RADIUS + 0.5 * THICK  # of the line's middle
SEGMENT = 2.0 * ARM * math.sin(0.5 * math.pi / ROUND)  # stretched


def atwood(inertia: float = 1e-3, second: float = MASS, bearing: float = 0.0) -> rw.Scene:
    """Two loads on a light line over half of a wheel, drawn as stretched as they stretch it."""
    turn = np.linspace(math.pi, 0.0, ROUND + 1)
    over = np.stack([ARM * np.cos(turn), 0.0 * turn, ARM * np.sin(turn)], axis=1)
    down = SEGMENT * np.arange(DOWN, 0, -1)
    left, right = (np.stack([s * ARM + 0.0 * down, 0.0 * down, -down], axis=1) for s in (-1.0, 1.0))
    points = [tuple(map(float, p)) for p in np.concatenate([left, over, right[::-1]])]
    line = rw.Rope(
        name="line",
        segments=len(points) - 1,
        length=(len(points) - 1) * SEGMENT / (1.0 + MASS * g / EA),
        diameter=THICK,
        made_of=rw.Material(EA=EA, mass_per_length=1e-4),
        shape=Points(points=points),
        loads=[rw.Load(node=0, mass=MASS), rw.Load(node=-1, mass=second)],
    )
    wheel = Cylinder(
        name="wheel",
        start=(0, -0.02, 0),
        end=(0, 0.02, 0),
        radius=RADIUS,
        friction=0.8,
        compliance=1e-7,
        spin=Spin(free=True, inertia=inertia, bearing=bearing),
    )
    run = rw.RunSettings(duration=1.0, method="implicit-euler", time_step=1 / 240, frame_rate=60.0)
    return rw.Scene(ropes=[line], obstacles=[wheel], run=run)


def upright(scene: rw.Scene) -> tuple[list[float], list[float]]:
    """Frequencies of modes in which both loads move up and down: together, and against each other [Hz]."""
    modes = rw.modes(scene, count=9)
    together: list[float] = []
    against: list[float] = []
    for shape, frequency in zip(modes.shapes, modes.frequencies, strict=True):
        one, other = complex(shape[0, 2]), complex(shape[-1, 2])
        if min(abs(one), abs(other)) > 0.03:
            found = together if (one * other.conjugate()).real > 0.0 else against
            found.append(float(frequency))
    return together, against


@pytest.mark.parametrize("inertia", [3e-4, 1e-3, 1e-2])
def test_loads_over_a_wheel(inertia: float) -> None:
    """k of either side, J = I / r^2: together w^2 = k / m; against k / m + 2 k / J, and 0: it turns on."""
    k = EA / (DOWN * SEGMENT / (1.0 + MASS * g / EA))
    J = inertia / ARM**2
    together, against = upright(atwood(inertia))
    still = math.sqrt(k / MASS) / (2.0 * math.pi)
    assert together == pytest.approx([still], rel=3e-3)
    slow = [f for f in against if f < 0.05 * still]
    assert slow  # a pair of real ones, or one that hardly rings
    assert against[len(slow) :] == pytest.approx(
        [still * math.sqrt(1.0 + 2.0 * MASS / J)], rel=1e-3
    )


def test_a_bearing_that_rubs_holds_the_wheel() -> None:
    """In motions that are small enough: then both loads have the same frequency either way."""
    assert rw.modes(atwood(), count=1).notes == []
    assert "bearing holds it" in rw.modes(atwood(bearing=0.01), count=1).notes[0]
    together, against = upright(atwood(bearing=0.01))
    assert against == pytest.approx(together, rel=1e-3)


def test_corners_that_hold_a_wheel_are_told() -> None:
    """A rope leaves it 1.7 degrees past its last node: that node's arm holds the wheel, as a bump does."""
    turn, step = np.linspace(math.pi, 0.0, 25), 0.0551
    over = [(float(step * np.cos(a)), 0.0, float(step * np.sin(a))) for a in turn]
    points = [(-step, 0.0, -0.5), *over, (step, 0.0, -0.5)]
    line = rw.Rope(
        name="line",
        segments=120,
        length=float(np.linalg.norm(np.diff(np.array(points), axis=0), axis=1).sum()),
        diameter=0.01,
        made_of=rw.Material(EA=2e4, mass_per_length=0.002),
        shape=Polyline(points=points),
        loads=[rw.Load(node=node, mass=1.0) for node in (0, -1)],
    )
    spin = Spin(free=True, inertia=2e-3)
    wheel = Cylinder(
        name="wheel", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=RADIUS, friction=0.5, spin=spin
    )
    found = rw.modes(rw.Scene(ropes=[line], obstacles=[wheel], run=atwood().run), count=2)
    assert 0.2 < found.frequencies[0] < 0.4
    (note,) = found.bumps
    assert note in found.notes
    assert f"pulley 'wheel' turns in mode 1 at {found.frequencies[0]:.4g} Hz" in note
    assert note.endswith("without segments it is 0: it turns on")


def test_a_wheel_that_turns_on_has_no_modes() -> None:
    with pytest.raises(SceneError, match="balance what hangs on it"):
        rw.modes(atwood(second=0.9))
    with pytest.raises(SceneError, match="leave out spin"):
        rw.modes(atwood(), "start")
    rings = {"start": "at-rest", "ring": rw.scene.Ring(mode=1, speed=0.1)}
    scene = atwood()
    with pytest.raises(SceneError, match="leave out ring"):
        rw.Simulation(scene.replace(run=scene.run.replace(**rings)))
    assert rw.modes(atwood(second=0.9, bearing=0.1), count=1).count == 1  # its bearing holds it
