"""Bodies that are not round and turn: planks, troughs, solids of triangles push what their surface meets.

A bead on a turning plank is flung out as cosh; a plank that tilts holds what lies on it up to atan mu; one
that has turned is one that was drawn so; and a plank that beats at ropes goes through none.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.scene import (
    Box,
    HalfPipe,
    Material,
    Mesh,
    Obstacle,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Spin,
)
from ropewalk.simulation import Simulation

g, MU = 9.81, 0.3
STUFF = Material(EA=1e4, mass_per_length=0.1)
HALF, RADIUS = 0.02, 0.005  # m, of the plank and the rope
RATE, START = 2.0, 0.3  # rad/s, m
CORNERS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def plank(**more: Any) -> Box:
    """A plank along x whose upper face looks along y, and which turns about z."""
    own = {"center": (0, 0, 0), "half_sizes": (1.5, HALF, 0.2), "edge_radius": 0.005}
    return Box(**(own | more))


def beam(**more: Any) -> Mesh:
    """The same of triangles."""
    corners = [tuple(np.array(one) * (1.495, HALF - 0.005, 0.195)) for one in CORNERS]
    faces = [part for a, b, c, d in SIDES for part in ((a, b, c), (a, c, d))]
    return Mesh(vertices=corners, faces=faces, rounding=0.005, **more)


def flung(body: Obstacle, method: str, step: Any) -> rw.Result:
    """A short rope parallel to the axle, which lies on a turning plank and goes with it at first."""
    y = HALF + RADIUS
    shape = Points(
        points=[(START, y, -0.05), (START, y, 0.05)], velocity=(-RATE * y, RATE * START, 0.0)
    )
    rope = Rope(segments=1, length=0.1, diameter=2 * RADIUS, made_of=STUFF, shape=shape)
    run = RunSettings(duration=0.6, frame_rate=60.0, time_step=step, method=method)
    return rw.simulate(Scene(ropes=[rope], gravity=(0, 0, 0), obstacles=[body], run=run))


def seen_turning(places: Floats, angles: Floats) -> tuple[Floats, Floats]:
    """Return how far out and how high places (frames, 3) are on a plank at these angles [rad]."""
    x, y, c, s = places[:, 0], places[:, 1], np.cos(angles), np.sin(angles)
    return x * c + y * s, y * c - x * s


@pytest.mark.parametrize("made", [plank, beam])
@pytest.mark.parametrize(
    ("method", "step", "within"),
    [("esdirk3", 1e-3, 1e-4), ("semi-implicit-euler", 5e-4, 1e-4), ("adaptive", "auto", 3e-4)],
)
def test_a_bead_on_a_turning_plank_is_flung_out_as_cosh(
    made: Any, method: str, step: Any, within: float
) -> None:
    """s'' = W^2 s without friction, and what the motor gives is its kinetic energy."""
    result = flung(made(friction=0.0, spin=Spin(rate=RATE)), method, step)
    assert result.status == "finished"
    out, high = seen_turning(result.positions[:, 0], RATE * result.time)
    expected = START * np.cosh(RATE * result.time)
    np.testing.assert_allclose(out, expected, atol=within)
    np.testing.assert_allclose(high, HALF + RADIUS, atol=within)
    gained = float(np.ptp(result.energy["kinetic"]))
    (entries,) = result.contact_work.values()
    assert float(entries["motor"][-1]) == pytest.approx(gained, rel=2e-3)
    work = sum(float(part[-1]) for part in entries.values())
    assert work == pytest.approx(gained, rel=2e-3)
    assert abs(expected[-1] - START) > 0.2


@pytest.mark.parametrize("made", [plank, beam])
def test_a_plank_that_tilts_holds_up_to_the_angle_of_friction(made: Any) -> None:
    """It sticks without creep below atan mu, and slides down at g (sin - mu cos) above."""
    rate, y = 0.1, HALF + RADIUS
    body = made(friction=MU, spin=Spin(rate=rate))
    shape = Points(points=[(-START, y, -0.05), (-START, y, 0.05)])
    rope = Rope(segments=1, length=0.1, diameter=2 * RADIUS, made_of=STUFF, shape=shape)
    run = RunSettings(duration=3.8, frame_rate=60.0, method="esdirk3", time_step=1 / 240)
    scene = Scene(ropes=[rope], gravity=(0, -g, 0), obstacles=[body], run=run)  # +x goes up
    result = rw.simulate(scene)
    angle = rate * result.time
    out, _ = seen_turning(result.positions[:, 0], angle)
    holds = math.atan(MU)
    early = (angle > 0.05) & (angle < 0.97 * holds)
    assert np.ptp(out[early]) < 3e-5  # m: what the springs of contacts give
    late = angle > 1.05 * holds
    slope = g * (np.sin(angle) - MU * np.cos(angle))[late]
    found = np.gradient(np.gradient(out, result.time), result.time)[late]
    np.testing.assert_allclose(-found[5:-5], slope[5:-5], rtol=0.05, atol=0.02)


@pytest.mark.parametrize(
    ("drawn", "turned"),
    [
        (plank(rotation=(0, 0, 0.4)), plank(spin=Spin(times=[0, 1], angles=[0.4, 0.4]))),
        (beam(rotation=(0, 0, 0.4)), beam(spin=Spin(times=[0, 1], angles=[0.4, 0.4]))),
        (
            HalfPipe(start=(0, 0, 0), end=(0, 0, 1), radius=0.2, open_to=(-math.sin(0.4), math.cos(0.4), 0)),
            HalfPipe(
                start=(0, 0, 0), end=(0, 0, 1), radius=0.2, open_to=(0, 1, 0),
                spin=Spin(times=[0, 1], angles=[0.4, 0.4]),
            ),
        ),
    ],
    ids=["box", "mesh", "half-pipe"],
)  # fmt: skip
def test_what_has_turned_is_what_was_drawn_so(drawn: Obstacle, turned: Obstacle) -> None:
    """Ropes move and rest on both alike; a twin that has not turned differs."""
    high, aside = (0.1, -3.0) if drawn.kind == "half-pipe" else (0.08, 0.0)  # towards its wall
    points = [(0.03 * i - 0.09, high, 0.01 * i) for i in range(7)]
    rope = Rope(
        segments=6,
        length=0.19,
        diameter=0.01,
        made_of=STUFF,
        shape=Points(points=points, velocity=(aside, 0, 0)),
    )
    run = RunSettings(duration=0.3, frame_rate=60.0, method="esdirk3", time_step=1 / 240)
    found = []
    for body in (drawn, turned, turned.replace(spin=None)):
        scene = Scene(ropes=[rope], gravity=(0, -g, 0), obstacles=[body], run=run)
        result = rw.simulate(scene)
        assert result.status == "finished"
        found.append(result.positions[-1])
    np.testing.assert_allclose(found[1], found[0], atol=1e-9)
    assert np.abs(found[2] - found[0]).max() > 1e-3


def cut(body: Box, places: Floats, angle: float) -> bool:
    """Tell whether a line through places (n, 3) goes through the inner half of a plank that has turned."""
    c, s = math.cos(angle), math.sin(angle)
    own = places @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    a, d = own[:-1], np.diff(own, axis=0)
    half = np.array(body.half_sizes) * (1.0, 0.5, 1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = np.stack([(-half - a) / d, (half - a) / d])
    low, high = ends.min(axis=0).max(axis=1), ends.max(axis=0).min(axis=1)
    return bool((np.maximum(low, 0.0) < np.minimum(high, 1.0)).any())


def beaten(seed: int) -> Scene:
    """A rope that hangs beside a plank that beats at it."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(15, 40))
    at = rng.uniform(0.15, 0.3)
    points = [(at, 0.06, 0.2 - 0.5 * i / count) for i in range(count + 1)]
    rope = Rope(
        segments=count, length=0.5, diameter=0.01,
        made_of=Material(EA=float(10 ** rng.uniform(3, 5)), mass_per_length=0.1),
        shape=Points(points=points),
    )  # fmt: skip
    body = Box(
        center=(0, 0, 0), half_sizes=(0.35, 0.015, 0.3), edge_radius=0.01,
        friction=float(rng.uniform(0.0, 0.6)),
        spin=Spin(rate=float(rng.uniform(3.0, 20.0))),
    )  # fmt: skip
    method = ["implicit-euler", "sdirk2", "esdirk3", "bdf2"][seed % 4]
    run = RunSettings(duration=0.5, frame_rate=240.0, method=method)
    return Scene(ropes=[rope], obstacles=[body], run=run)


@pytest.mark.parametrize("seed", range(8))
def test_a_plank_that_beats_at_a_rope_goes_through_none(seed: int) -> None:
    """By a check of its own of every frame; the rope as it hung, which it would see, is the twin."""
    scene = beaten(seed)
    (body,) = scene.obstacles
    assert isinstance(body, Box)
    assert body.spin is not None
    assert body.spin.rate is not None
    result = rw.simulate(scene)
    assert result.status == "finished", result.facts
    angles = body.spin.rate * result.time
    np.testing.assert_allclose(result.obstacle_angles()[:, 0], angles, atol=1e-12)
    assert not any(cut(body, x, a) for x, a in zip(result.positions, angles, strict=True))
    assert any(cut(body, result.positions[0], a) for a in angles)
    assert result.contact_force.any()


def test_hands_turn_a_plank_no_faster_than_it_can_be_followed() -> None:
    """Its surface goes at the rate times its reach."""
    simulation = Simulation(beaten(0))
    (handle,) = simulation.obstacles.values()
    handle.rate = 0.5 * handle.fastest_turn
    assert handle.rate == pytest.approx(0.5 * handle.fastest_turn)
    before = handle.angle
    simulation.advance_frames(6)
    assert handle.angle - before == pytest.approx(handle.rate * 6 / 240, rel=1e-9)
    with pytest.raises(ValueError, match="jump over nodes"):
        handle.rate = 2.0 * handle.fastest_turn
    left, most = handle.fastest, handle.fastest_turn
    handle.rate = 0.0
    assert left == pytest.approx(0.5 * handle.fastest)  # its turning took the other half
    handle.velocity = (0.0, 0.0, 1.2 * left)
    assert handle.fastest_turn == pytest.approx(0.4 * most)
    with pytest.raises(ValueError, match="jump over nodes"):
        handle.rate = 0.5 * most


def test_what_turns_too_far_in_a_step_is_refused() -> None:
    """With what helps."""
    with pytest.raises(SceneError, match="axis"):
        plank(axis=(0, 0, 0))
    scene = beaten(1)
    slow = scene.replace(run=scene.run.replace(time_step=0.02))
    with pytest.raises(SceneError, match=r"obstacle\[0\]\.spin.*jump over nodes"):
        rw.simulate(slow)
