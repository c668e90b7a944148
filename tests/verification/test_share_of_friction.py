"""How much of its friction a rope at rest takes: the least share of it that would hold the rope.

Of a rope without weight on a drum that is ln(ratio of tensions) / (mu angle).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from laid import half_round, laid
from ropewalk.statics import static_shape
from verification.test_rest_on_obstacles import drum, table, weighted


@pytest.mark.parametrize("ratio", [1.0, 1.2, 1.5, 2.0, 1.0 / 1.5])
def test_the_share_of_friction_is_that_of_logarithms(ratio: float) -> None:
    """As pages tell it of runs; a half of what held 2.566 to 1 was told where 1.283 pulled, which is 26 %."""
    (wrap,) = static_shape(weighted(ratio, drum(0.3))).wraps
    assert wrap.share == pytest.approx(abs(math.log(ratio)) / (0.3 * math.pi), abs=0.003)


def needed(hangs: float, edge: float) -> float:
    """Return the friction that holds a rope of 1 m of which so much hangs over a rounded edge [1].

    dT = (mu (T + w R cos a) - w R sin a) da from the table on, for w = 1.
    """

    def holds(mu: float) -> float:
        pull, count = mu * (1.0 - hangs - 0.5 * math.pi * edge), 1000
        for a in (np.arange(count) + 0.5) * 0.5 * math.pi / count:
            rate = mu * (pull + edge * math.cos(a)) - edge * math.sin(a)
            pull += rate * 0.5 * math.pi / count
        return pull

    tried = np.linspace(0.0, 0.4, 401)
    return float(np.interp(hangs, [holds(mu) for mu in tried], tried))


@pytest.mark.parametrize("hangs", [0.1, 0.2])
def test_the_share_of_friction_is_that_which_would_do(hangs: float) -> None:
    """The end of a tail that lies pulls nothing, so that no logarithm is known: 14 and 58 % for 47 and 78."""
    (wrap,) = static_shape(table(hangs)).wraps
    assert min(wrap.before, wrap.after) == 0.0
    assert wrap.share == pytest.approx(needed(hangs, 0.05) / 0.3, rel=0.03)


def groove(tilt: float, friction: tuple[float, float], **more: object) -> rw.Scene:
    """A rope that lies along a groove, its sides at 30 degrees to its middle, on a slope [rad]."""
    half = math.radians(30.0)
    rope = rw.Rope(
        segments=10,
        length=0.5,
        diameter=0.01,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0),
        shape={"kind": "straight", "start": (0, 0, 0.01), "end": (0.5, 0, 0.01)},
    )
    normals = [(0, side * math.cos(half), math.sin(half)) for side in (1, -1)]
    sides = [rw.Plane(normal=one, friction=mu) for one, mu in zip(normals, friction, strict=True)]
    down = (9.81 * math.sin(tilt), 0, -9.81 * math.cos(tilt))
    return rw.Scene(gravity=down, ropes=[rope], obstacles=sides, **more)


@pytest.mark.parametrize("friction", [(0.3, 0.3), (0.1, 0.5)])
@pytest.mark.parametrize("short", [15.0, 5.0, 0.3])
def test_what_wedges_a_rope_in_a_groove_is_not_what_holds_it_along(
    friction: tuple[float, float], short: float
) -> None:
    """It slides from tan(slope) = mu / sin(30 degrees) on; 100 % was told from 5 degrees below that on."""
    slides = sum(friction)
    tilt = math.atan(slides) - math.radians(short)
    found = static_shape(groove(tilt, friction)).wraps
    assert [wrap.beside for wrap in found] == [("obstacle1",), ("obstacle0",)]
    for wrap in found:
        assert wrap.taken == pytest.approx(math.tan(tilt) / slides, rel=1e-3)
        assert "along 'obstacle" in wrap.words


def test_a_groove_holds_a_rope_by_the_friction_of_both_sides() -> None:
    """One that hangs down in it from an anchor; nothing was told of what friction holds."""
    tilt, weight = (
        math.radians(46.0),
        0.475 * 0.1 * 9.81,
    )  # half of the first segment is the anchor's
    scene = groove(tilt, (0.1, 0.5), anchors=[rw.Anchor(node=0)])
    for wrap in static_shape(scene).wraps:
        least, most = (
            weight * (math.sin(tilt) + sign * 0.6 * math.cos(tilt)) for sign in (-1.0, 1.0)
        )
        assert (wrap.least, wrap.most) == pytest.approx((least, most), rel=1e-3)
        assert "friction with that of 'obstacle" in wrap.words


@pytest.mark.parametrize("aside", [0.0, 0.2])
def test_what_friction_holds_is_of_the_shape_as_it_lies(aside: float) -> None:
    """Led to a side by 0.2 rad, half a turn held up to 18.2 N as told; 23.1 N stood, 24.9 N of 25.7 slid."""
    radius, count, pull, mu = 0.014, 24, 10.0, 0.3
    step = 2.0 * radius * math.sin(0.5 * math.pi / count)
    turn = np.linspace(math.pi, 0.0, count + 1)
    arc = np.stack([0.0 * turn, radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    down = np.array([math.sin(aside), 0.0, -math.cos(aside)])
    way = step * np.arange(1, 61)[:, None] * down
    points = np.concatenate([arc[0] + way[::-1], arc, arc[-1] + way])
    forces = [{"node": 0, "force": pull * down}, {"node": -1, "force": 1.5 * pull * down}]
    rope = rw.Rope(
        segments=len(points) - 1,
        length=step * (len(points) - 1),
        diameter=0.008,
        made_of=rw.Material(EA=1e5, mass_per_length=0.02, axial_damping=10.0),
        shape={"kind": "points", "points": points.tolist()},
        forces=forces,
    )
    bar = rw.Cylinder(start=(-1, 0, 0), end=(1, 0, 0), radius=0.01, friction=mu)
    (wrap,) = static_shape(rw.Scene(gravity=(0, 0, 0), ropes=[rope], obstacles=[bar])).wraps
    capstan = pull * math.exp(mu * math.pi)
    assert wrap.wider * wrap.most == pytest.approx(capstan, rel=0.01)
    if aside:
        assert wrap.most < 0.8 * capstan
        assert "in this shape" in wrap.words
        assert "that may widen towards 3.89 N to 25.7 N" in wrap.words
    else:
        assert wrap.most == pytest.approx(capstan, rel=0.01)
        assert "in this shape" not in wrap.words


def test_a_helix_may_hold_what_its_whole_way_round_holds() -> None:
    """It turned by 489 degrees, 540 once it had slipped sideways: 16.7 N were told, and 20 N came to rest."""
    turns, pitch, mu, before = 1.5, 0.2, 0.3, 1.261
    angles = np.linspace(0.0, turns * 2.0 * math.pi, 73)
    out = 0.055 * 1.004
    helix = [(out * math.cos(a), pitch * a / math.tau, out * math.sin(a)) for a in angles]
    x, y, z = helix[-1]
    points = [(out, 0.0, -1.2), *helix, (x, y, z - 1.2)]
    masses = {0: before / 9.81, -1: 9.0 / 9.81}
    rope = laid(points, masses, spacing=0.01, mass_per_length=2e-3)
    drum = rw.Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=0.05, friction=mu)
    (wrap,) = static_shape(rw.Scene(ropes=[rope], obstacles=[drum])).wraps
    capstan = math.exp(mu * turns * math.tau)
    assert wrap.angle < math.radians(500.0)
    assert wrap.wider * wrap.most == pytest.approx(wrap.before * capstan, rel=0.02)
    assert wrap.least / wrap.wider == pytest.approx(wrap.before / capstan, rel=0.02)
    assert not wrap.beyond


@pytest.mark.parametrize("angle", [0.0, 0.5])
def test_a_rope_along_a_helix_turns_by_no_more(angle: float) -> None:
    """The twin: what comes and goes along it needs nothing across, and slipping sideways changes nothing."""
    radius, count, turns, pull, mu = 0.014, 48, 1.0, 10.0, 0.3
    a = np.linspace(0.0, turns * math.tau, count + 1)
    helix = np.stack([radius * a * math.tan(angle), radius * np.cos(a), radius * np.sin(a)], axis=1)
    into, out = helix[1] - helix[0], helix[-1] - helix[-2]
    step = float(np.linalg.norm(into))
    tail = np.arange(1, 41)[:, None]
    points = np.concatenate([helix[0] - tail[::-1] * into, helix, helix[-1] + tail * out])
    rope = rw.Rope(
        segments=len(points) - 1,
        length=step * (len(points) - 1),
        diameter=0.008,
        made_of=rw.Material(EA=1e5, mass_per_length=0.02, axial_damping=10.0),
        shape={"kind": "points", "points": points.tolist()},
        forces=[
            {"node": 0, "force": (-pull * into / step).tolist()},
            {"node": -1, "force": (1.2 * pull * out / step).tolist()},
        ],
    )
    bar = rw.Cylinder(start=(-1, 0, 0), end=(1, 0, 0), radius=0.01, friction=mu)
    (wrap,) = static_shape(rw.Scene(gravity=(0, 0, 0), ropes=[rope], obstacles=[bar])).wraps
    assert wrap.most == pytest.approx(pull * math.exp(mu * wrap.angle), rel=0.02)
    assert wrap.wider < 1.02
    assert "sideways" not in wrap.words


def test_no_interval_widens_in_a_groove() -> None:
    """Between two balls a rope cannot slip sideways: 35.5 N were told, where it slides from 21.1 N on."""
    radius, apart, mu = 0.1, 0.06, 0.2
    out = math.sqrt(0.105**2 - apart**2)
    rope = laid(half_round(1.01 * out), {0: 1.0, -1: 1.5})
    balls = [rw.Sphere(center=(0, y, 0), radius=radius, friction=mu) for y in (-apart, apart)]
    for wrap in static_shape(rw.Scene(ropes=[rope], obstacles=balls)).wraps:
        limit = math.exp(mu * math.pi / math.sqrt(1.0 - (apart / 0.105) ** 2))
        assert wrap.most / wrap.before == pytest.approx(limit, rel=0.01)
        assert wrap.wider == pytest.approx(1.0)
        assert "sideways" not in wrap.words


@pytest.mark.parametrize("covered", [True, False])
def test_no_interval_is_told_where_another_rope_presses(covered: bool) -> None:
    """Its friction holds, too: up to 9.9 N were told after 14.8 N before, and 29.8 N were held."""
    drawn = {"a": (0.0555, 1.0)} | ({"b": (0.066, 3.0)} if covered else {})
    ropes = [
        laid(half_round(out, bends=24), {-1: mass}, name=name, mass_per_length=0.01)
        for name, (out, mass) in drawn.items()
    ]
    drum = rw.Cylinder(name="drum", start=(0, -0.2, 0), end=(0, 0.2, 0), radius=0.05, friction=0.2)
    scene = rw.Scene(
        ropes=ropes,
        anchors=[rw.Anchor(node=0, rope=rope.name) for rope in ropes],
        obstacles=[drum],
        contact=rw.Contact(friction=0.3),
    )
    (wrap,) = static_shape(scene).wraps
    if covered:  # the upper one presses with T1 + T2 and more, as it is curved more widely
        assert math.isnan(wrap.most)
        assert math.isnan(wrap.share)
        assert wrap.ropes > 2.0 * 3.0 * 9.81
        assert f"ropes press on it there with {wrap.ropes:.4g} N" in wrap.words
        assert "before and" in wrap.words
    else:
        assert wrap.ropes == 0.0
        assert wrap.most == pytest.approx(wrap.before * math.exp(0.2 * math.pi), rel=0.02)
        assert "press" not in wrap.words


@pytest.mark.parametrize(("name", "until"), [("capstan", 1.3), ("bollard", 0.4)])
def test_no_node_on_one_body_has_more_friction_than_it_can(name: str, until: float) -> None:
    """1.049 and 1.021 at a round's ends: limits were of the spring's direction, not of the friction's."""
    scene = rw.preset(name)
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=until)))
    used = result.to_pandas("contacts")["friction used [1]"]
    assert used.max() <= 1.0 + 1e-3
    assert (used > 0.99).sum() > 10
