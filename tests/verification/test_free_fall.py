"""Free fall: every scheme has its own exact parabola."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.scene import Rope, Straight
from verification.setups import ALL, DOWN, NO_GRAVITY, g, hold, off, run, scene, springs

STEPS, DT = 200, 0.01


def fallen(method: str, s: np.ndarray, dt: float = DT) -> np.ndarray:
    """Depth after s steps [m]: the sum of the scheme's own velocities.

    v_i = -g i dt exactly for all. euler moves with v_i, hence s (s - 1) / 2; semi-implicit Euler with
    v_(i+1), hence s (s + 1) / 2; the others reach g t^2 / 2 (exact for constant acceleration).
    """
    shift = {"euler": -1.0, "semi-implicit-euler": 1.0, "implicit-euler": 1.0}.get(method, 0.0)
    return 0.5 * g * dt * dt * s * (s + shift)


def fall(method: str, gravity: tuple[float, float, float] = DOWN, friction: float = 0.3):
    made_of = springs(10.0, 0.05, 0.1, friction)
    rope = Rope(segments=5, made_of=made_of, shape=Straight(start=(0, 2, 0), velocity=(1, 0, 0)))
    return run(scene(rope, dt=DT, steps=STEPS, method=method, gravity=gravity))


@pytest.mark.parametrize("method", ALL)
def test_a_rope_without_anchors_falls_as_its_method_says_whatever_its_friction(method: str) -> None:
    """Source: the sum above. Round-off only: 200 additions of numbers up to 20 m -> 1e-12 m.

    Claim C6: spring friction does not slow a fall as air would.
    """
    film = fall(method)
    s = np.arange(STEPS + 1)
    depth = 2.0 - film.x[:, :, 1]
    assert off(depth, fallen(method, s)[:, None]) < 1e-12
    start = np.arange(6) * 0.1
    assert off(film.x[:, :, 0], start + (s * DT)[:, None]) < 1e-12
    # twins: gravity upside down; the other schemes' sums; half the step
    assert off(2.0 - fall(method, (0, g, 0)).x[:, :, 1], fallen(method, s)[:, None]) > 1.0
    for other in ALL:
        if fallen(other, s)[-1] != fallen(method, s)[-1]:
            assert off(depth, fallen(other, s)[:, None]) > 1e-3
    assert off(depth, fallen(method, s, 0.5 * DT)[:, None]) > 1.0


@pytest.mark.parametrize("method", ALL)
def test_at_the_start_only_gravity_acts(method: str) -> None:
    """Claim C3: the first acceleration of every free mass is g, to the bit, in direction too."""
    rope = Rope(segments=6, made_of=springs(1e4, 0.05, 1.0, 0.05))
    film = run(scene(rope, hold(0, 6), dt=1e-3, steps=1, method=method, gravity=DOWN))
    gained = (film.v[1] - film.v[0]) / 1e-3
    if method in ("euler", "semi-implicit-euler"):  # one force evaluation: exact
        assert off(gained[1:-1], [0.0, -g, 0.0]) < 1e-14
    assert off(gained[1:-1, [0, 2]], 0.0) < 1e-3
    assert off(gained[[0, -1]], 0.0) == 0.0
    # the twin: a rope 1 % longer between its anchors pulls along x at once
    stretched = Rope(
        segments=6,
        made_of=springs(1e4, 0.05, 1.0),
        shape=Straight(start=(0, 0, 0), end=(5, 3.4, 0)),
    )
    film = run(scene(stretched, hold(0), dt=1e-3, steps=1, method=method, gravity=DOWN))
    assert off(film.v[1, 1:, [0, 2]] / 1e-3, 0.0) > 1.0


@pytest.mark.parametrize("method", ALL)
def test_uniform_motion_without_gravity(method: str) -> None:
    """x = x0 + v t for every scheme (N39, constant velocity); the twin has gravity."""
    film = fall(method, NO_GRAVITY)
    assert off(film.x[:, 0, 0], film.t) < 1e-12
    assert off(film.x[:, :, 1], 2.0) < 1e-12
    assert off(fall(method).x[:, :, 1], 2.0) > 1.0
