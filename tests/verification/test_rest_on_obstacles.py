"""Rest on obstacles, against closed forms.

Without friction the tension of a rope on a surface changes by weight times height alone; with it a rope holds
within the capstan's bounds, on a plane within mu times the weight, and slides beyond. A shape of rest stays
where it is when it is run.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.core.status import OK
from ropewalk.lowering.touching import SLIPS
from ropewalk.scene import (
    Anchor,
    Box,
    Cylinder,
    Force,
    Load,
    Material,
    Obstacle,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Spin,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.statics import NoRest, static_shape

g = 9.81
W = 0.1 * g  # weight per length of the ropes here [N/m]
RUN = RunSettings(duration=1.0, frame_rate=60.0, time_step=1.0 / 60.0, method="esdirk3")


def over(
    top: Floats, left: float, right: float, length: float, count: int, **more: Any
) -> dict[str, Any]:
    """A rope with its middle part along `top` (k, 3), that hangs down `left` and `right` [m] beyond."""
    down = np.array([0.0, 0.0, -1.0])
    corners = np.array([top[0] + left * down, *top, top[-1] + right * down])
    along = np.concatenate([[0.0], np.linalg.norm(np.diff(corners, axis=0), axis=1).cumsum()])
    at = np.linspace(0.0, along[-1], count + 1)
    points = np.stack([np.interp(at, along, corners[:, k]) for k in range(3)], axis=1)
    material = Material(EA=1e5, mass_per_length=0.1, axial_damping=5.0)
    rope: dict[str, Any] = {
        "segments": count,
        "length": along[-1] if length == 0.0 else length,
        "made_of": material,
        "shape": Points(points=[tuple(map(float, point)) for point in points]),
    }
    return rope | more


def arc(radius: float, degrees: float = 180.0, count: int = 200) -> Floats:
    """Places on a circle about the origin from the left over the top, (count, 3) [m]."""
    half = math.radians(0.5 * degrees)
    angle = np.linspace(-half, half, count)
    return radius * np.stack((np.sin(angle), 0.0 * angle, np.cos(angle)), axis=1)


def drum(friction: float, radius: float = 0.05, **more: Any) -> Cylinder:
    return Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=radius, friction=friction, **more)


def stays(scene: Scene) -> float:
    """How far a node moves in a second from rest [m]."""
    simulation = Simulation(scene.replace(run=RUN.replace(start="at-rest")))
    before, most = simulation.positions.copy(), 0.0
    for _ in range(60):
        assert simulation.advance_frames(1).status == OK
        most = max(most, float(np.abs(simulation.positions - before).max()))
    return most


def on_a_slope(degrees: float, friction: float = 0.3, **more: Any) -> Scene:
    """A straight rope of 0.3 m down an incline."""
    slope = math.radians(degrees)
    down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
    shape = Points(points=[tuple(0.05 * i * down) for i in range(7)])
    material = Material(EA=1e3, mass_per_length=0.1)
    rope = Rope(**({"segments": 6, "length": 0.3, "made_of": material, "shape": shape} | more))
    plane = Plane(normal=(math.sin(slope), 0.0, math.cos(slope)), friction=friction)
    return Scene(ropes=[rope], obstacles=[plane], run=RUN)


# -- without friction ------------------------------------------------------------------------


def hung_over(start: tuple[float, float]) -> Scene:
    """A rope of 0.9 m over a drum of 5 cm without friction, its ends held at two heights."""
    parts = over(arc(0.05), *start, 0.9, 60)
    anchors = [Anchor(node=0), Anchor(node=-1)]
    return Scene(ropes=[Rope(**parts)], anchors=anchors, obstacles=[drum(0.0)], run=RUN)


def test_without_friction_tension_follows_the_height() -> None:
    """T - w z is the same all along the rope; a plain segment spans two nodes' half weights."""
    scene = hung_over((0.30, 0.38))
    rest = static_shape(scene)
    (wrap,) = rest.wraps
    assert wrap.angle == pytest.approx(math.pi, rel=0.1)
    assert not rest.by_friction
    height = 0.5 * (rest.positions[1:, 2] + rest.positions[:-1, 2])
    level = rest.tension - W * height
    inside = level[wrap.first + 1 : wrap.last - 1]  # between nodes that touch
    assert np.ptp(inside) < 2e-3 * rest.largest_tension
    assert np.ptp(height[wrap.first + 1 : wrap.last - 1]) * W > 0.05 * rest.largest_tension
    assert stays(scene) < 1e-9


def test_without_friction_rest_is_the_same_from_other_starts() -> None:
    """Drawn with its middle lifted, and as it hangs: where it comes to differs by rounding."""
    scene = hung_over((0.30, 0.38))
    rest = static_shape(scene).positions
    aside = rest + 0.004 * np.sin(np.linspace(0.0, math.pi, 61))[:, None] * [0.0, 0.0, 1.0]
    shape = Points(points=[tuple(map(float, point)) for point in aside])
    again = static_shape(scene.replace(ropes=[scene.ropes[0].replace(shape=shape)]))
    assert np.abs(again.positions - rest).max() < 1e-6


# -- on a plane ------------------------------------------------------------------------------


def pulled(force: float) -> Scene:
    """A rope of 2 m on a plane of mu = 0.3, pulled at its end."""
    rope = Rope(
        segments=40,
        length=2.0,
        made_of=Material(EA=1e3, mass_per_length=0.1),
        shape=Straight(start=(0, 0, 0), end=(2, 0, 0)),
        forces=[Force(node=-1, force=(force, 0, 0))],
    )
    return Scene(ropes=[rope], obstacles=[Plane(compliance=1e-6)], run=RUN)


def test_a_rope_on_a_plane_takes_up_a_pull_by_mu_times_its_weight() -> None:
    """T falls by mu w per length from the end that is pulled, to nothing; the rest lies unmoved."""
    scene = pulled(0.4)
    rest = static_shape(scene)
    from_end = 2.0 - 0.05 * (np.arange(40) + 0.5)
    expected = np.maximum(0.4 - 0.3 * W * from_end, 0.0)
    assert np.abs(rest.tension - expected).max() < 0.3 * W * 0.05
    assert np.abs(rest.positions[:8, 0] - 0.05 * np.arange(8)).max() < 1e-9
    assert stays(scene) < 1e-9


def test_more_than_that_pulls_it_away() -> None:
    assert static_shape(pulled(0.99 * 0.3 * W * 2.0)).solved
    with pytest.raises(NoRest, match=r"On 'obstacle0' \(friction 0.3\) friction carries all"):
        static_shape(pulled(1.01 * 0.3 * W * 2.0))


@pytest.mark.parametrize("degrees", [0.0, 10.0, 16.69])
def test_an_incline_below_the_angle_of_friction_holds(degrees: float) -> None:
    """Atan 0.3 = 16.699 degrees."""
    scene = on_a_slope(degrees)
    contacts = static_shape(scene).contacts
    assert contacts is not None
    total = float(np.linalg.norm(contacts.rub.sum(axis=0)))
    assert total == pytest.approx(W * 0.3 * math.sin(math.radians(degrees)), rel=1e-6, abs=1e-9)
    assert contacts.use.max() <= 1.0 + 1e-9
    assert stays(scene) < 1e-9


@pytest.mark.parametrize("degrees", [16.71, 40.0])
def test_there_is_no_rest_above_it(degrees: float) -> None:
    with pytest.raises(NoRest, match=r"slopes of up to atan\(friction\) = 16.7 degrees"):
        static_shape(on_a_slope(degrees))


# -- round a drum ----------------------------------------------------------------------------


def hanging(mu: float, h1: float, h2: float, count: int = 80) -> Scene:
    """A heavy rope over a drum of 51 mm, h1 on one side and h2 on the other, without any other load."""
    parts = over(arc(0.051), h1, h2, 0.0, count)
    return Scene(ropes=[Rope(**parts)], obstacles=[drum(mu, 0.051, compliance=1e-5)], run=RUN)


def limit(mu: float, h1: float) -> float:
    """The length on the other side beyond which a heavy rope slips [m]."""
    grows = math.exp(mu * math.pi)
    return grows * h1 + 0.051 * 2.0 * mu / (1.0 + mu**2) * (grows + 1.0)


@pytest.mark.parametrize(("mu", "h2"), [(0.1, 0.229), (0.3, 0.485), (0.6, 1.329)])
def test_a_heavy_rope_holds_to_its_limit(mu: float, h2: float) -> None:
    """h2 = e^(mu pi) h1 + R 2 mu / (1 + mu^2) (e^(mu pi) + 1): it holds at 0.97 of it."""
    assert limit(mu, 0.15) == pytest.approx(h2, abs=5e-4)
    (wrap,) = static_shape(hanging(mu, 0.15, 0.97 * h2)).wraps
    assert wrap.share < 1.0
    # the tension that it can carry is that of a length h2, but for the ends of the wrap between two nodes
    assert wrap.most == pytest.approx(W * h2, rel=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.1, 0.3, 0.6])
def test_a_heavy_rope_slips_beyond_its_limit(mu: float) -> None:
    with pytest.raises(NoRest):
        static_shape(hanging(mu, 0.15, 1.03 * limit(mu, 0.15)))


def weighted(ratio: float, body: Obstacle, **more: Any) -> Scene:
    """Weights of 10 N and `ratio` times as much on a light rope over a body of 5 cm about the origin."""
    parts = over(arc(0.05, 180.0, 25), 0.1, 0.1, 0.0, 60)
    parts["made_of"] = Material(EA=1e5, mass_per_length=1e-3)
    parts["loads"] = [Load(node=0, mass=10.0 / g), Load(node=-1, mass=10.0 * ratio / g)]
    return Scene(ropes=[Rope(**(parts | more))], obstacles=[body], run=RUN)


@pytest.mark.parametrize("body", [drum(0.3), Sphere(center=(0, 0, 0), radius=0.05, friction=0.3)])
@pytest.mark.parametrize("f", [1.0 / 0.95, 0.95])
def test_what_friction_allows_is_the_capstans_interval(body: Obstacle, f: float) -> None:
    """exp(-mu theta) to exp(mu theta) of the tension before; weights within it rest."""
    ratio = math.exp(math.copysign(0.3 * math.pi, 1.0 - f)) * f
    scene = weighted(ratio, body)
    (wrap,) = static_shape(scene).wraps
    assert wrap.angle == pytest.approx(math.pi, rel=1e-3)
    assert wrap.most / wrap.before == pytest.approx(math.exp(0.3 * math.pi), rel=5e-3)
    assert wrap.least / wrap.before == pytest.approx(math.exp(-0.3 * math.pi), rel=5e-3)
    assert wrap.share == pytest.approx(abs(math.log(ratio)) / (0.3 * math.pi), rel=5e-3)
    assert stays(scene) < 1e-9


@pytest.mark.slow
def test_beyond_it_there_is_no_rest() -> None:
    with pytest.raises(NoRest):
        static_shape(weighted(1.02 * math.exp(0.3 * math.pi), drum(0.3)))


@pytest.mark.slow
@pytest.mark.parametrize(("f", "holds"), [(0.98, True), (1.02, False)])
def test_forces_alone_draw_a_rope_over_a_drum(f: float, holds: bool) -> None:
    """Without weight and anchors: 5 N and f exp(mu pi) times as much. It was told that they carry it away."""
    pulls = 5.0, 5.0 * f * math.exp(0.3 * math.pi)
    forces = [Force(node=k, force=(0, 0, -pull)) for k, pull in zip((0, -1), pulls, strict=True)]
    rope = Rope(**over(arc(0.05), 0.3, 0.3, 0.0, 80), forces=forces)
    scene = Scene(gravity=(0, 0, 0), ropes=[rope], obstacles=[drum(0.3)])
    if not holds:
        with pytest.raises(NoRest, match="slide or fall"):
            rw.equilibrium(scene)
        return
    found = static_shape(scene)
    (wrap,) = found.wraps
    assert found.solved
    assert (wrap.before, wrap.after) == pytest.approx(pulls, rel=1e-9)
    assert wrap.share == pytest.approx(f, rel=0.005)
    assert "nothing holds it" not in "\n".join(rw.check(scene).warnings)
    away = scene.replace(ropes=[rope.replace(forces=[Force(node=0, force=(0, 0, 1.0))])])
    with pytest.raises(NoRest, match="fall past all obstacles"):
        rw.equilibrium(away)


def table(hangs: float) -> Scene:
    """A rope of 1 m on a table with a rounded edge of 5 cm; it `hangs` over by so much of its length."""
    edge = np.array([0.95, 0.0, 0.45]) + arc(0.05, 180.0, 60)[30:]
    top = np.concatenate([[[edge[0, 0] - (1.0 - hangs - 0.0785), 0.0, 0.5]], edge])
    parts = over(top, 0.0, hangs, 0.0, 60)
    parts["made_of"] = Material(EA=1e4, mass_per_length=0.1)
    box = Box(center=(0, 0, 0.4), half_sizes=(1.0, 0.5, 0.1), edge_radius=0.05, friction=0.3)
    return Scene(ropes=[Rope(**parts)], obstacles=[box], run=RUN)


def test_a_rope_over_a_tables_edge_holds() -> None:
    """It slips where more hangs than mu e^(mu pi/2) / (1 + ...) = 0.325 of it, at an edge of no size."""
    scene = table(0.25)
    (wrap,) = static_shape(scene).wraps
    assert wrap.angle == pytest.approx(0.5 * math.pi, rel=0.02)
    assert 0.5 < wrap.share < 1.0
    assert stays(scene) < 1e-9


@pytest.mark.slow
def test_a_rope_that_hangs_farther_over_it_slides_off() -> None:
    with pytest.raises(NoRest):
        static_shape(table(0.36))


# -- what goes with it -----------------------------------------------------------------------


def test_rest_and_run_have_the_same_forces() -> None:
    """The result of rest has the contacts' forces, and a run that starts there has them too."""
    scene = weighted(1.5, drum(0.3))
    rest = rw.equilibrium(scene)
    run = rw.simulate(scene.replace(run=RUN.replace(start="at-rest", duration=0.1)))
    assert rest.residual < 1e-6
    for frame in (0, -1):
        assert np.abs(run.contact_force[frame] - rest.contact_force[0]).max() < 1e-6
        assert np.abs(run.tension[frame] - rest.tension[0]).max() < 1e-6


@pytest.mark.parametrize("method", ["implicit-euler", "bdf2", "verlet"])
def test_it_stays_at_rest_by_every_method(method: str) -> None:
    step = "auto" if method == "verlet" else RUN.time_step
    run = RUN.replace(start="at-rest", method=method, duration=0.2, time_step=step)
    scene = on_a_slope(12.0).replace(run=run)
    result = rw.simulate(scene)
    assert np.abs(result.positions - result.positions[0]).max() < 1e-9


def test_a_drum_that_turns_stands_still_for_it() -> None:
    scene = weighted(1.5, drum(0.3, spin=Spin(rate=5.0)))
    still = static_shape(weighted(1.5, drum(0.3)))
    assert static_shape(scene).positions.tobytes() == still.positions.tobytes()


def test_a_check_says_where_it_lies_and_what_it_could_carry() -> None:
    said = rw.check(weighted(1.5, drum(0.3)), measure=False)
    text = "\n".join(said.lines())
    assert "lie on 'obstacle0' and turn by 180 degrees, 10 N before and 15" in text
    assert "friction holds" in text
    assert any("many shapes of rest" in warning for warning in said.warnings)
    slides = rw.check(on_a_slope(25.0), measure=False)
    assert any("there is no rest" in warning for warning in slides.warnings)
    assert "at rest:" not in "\n".join(slides.lines())
    found: Any = slides.as_dict()["statics"]
    assert found["largest_tension"] is None


PLATE = Cylinder(name="thin", start=(0, 0, -0.002), end=(0, 0, 0.002), radius=0.35)
PLANK = Box(name="thin", center=(0, 0, 0), half_sizes=(0.3, 0.1, 0.01), edge_radius=0.005)


@pytest.mark.parametrize("body", [PLATE, PLANK], ids=["plate", "plank"])
def test_a_segment_that_lies_through_a_thin_body_is_no_rest(body: Obstacle) -> None:
    """A rope laid over it from ends beside it: its middle hung below the plate, its sides went through.

    Every run from such a rest was as wrong: only what comes to lie through a body is stopped there.
    """
    ends = [(x, 0.0, z) for x, z in ((-0.4, 0.05), (-0.4, 0.3), (0.4, 0.3), (0.4, 0.05))]
    rope = Rope(
        segments=14,
        length=1.3,
        diameter=0.01,
        made_of=Material(EA=1e4, mass_per_length=0.1),
        shape={"kind": "polyline", "points": ends},
    )
    scene = Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)], obstacles=[body])
    words = r"segment \d+ of rope 'rope' would go through obstacle 'thin' .* Try more segments"
    with pytest.raises(NoRest, match=words):
        static_shape(scene)
    assert not static_shape(scene, strict=False).solved


def test_modes_hold_what_has_friction() -> None:
    """A span of 1 m between two bars under 50 N rings with sqrt(T / m) / (2 L), where the bars hold it.

    Those contacts that carry all they can hold it, too, as runs have it (`test_modes_of_contacts`).
    """

    def bars(friction: float) -> Scene:
        bodies = [
            Cylinder(start=(x, -1, -0.05), end=(x, 1, -0.05), radius=0.05, friction=friction)
            for x in (0.0, 1.0)
        ]
        turns = arc(0.05) - np.array([0.0, 0.0, 0.05])
        left, right = turns[:100], turns[100:] + np.array([1.0, 0.0, 0.0])
        parts = over(np.concatenate([left, right]), 0.1, 0.1, 0.0, 80)
        parts["loads"] = [Load(node=0, mass=5.0), Load(node=-1, mass=5.0)]
        return Scene(ropes=[Rope(**parts)], obstacles=bodies, run=RUN)

    scene = bars(2.0)
    rest = static_shape(scene)
    assert rest.contacts is not None
    lies = rest.contacts.node
    assert (rest.contacts.use >= SLIPS).any()
    middle = rest.positions[lies[lies < 40].max() : lies[lies > 40].min() + 1]
    length = float(np.linalg.norm(np.diff(middle, axis=0), axis=1).sum())
    tension = float(rest.tension[40])
    expected = 0.5 * math.sqrt(tension / 0.1) / length
    across = [
        r["frequency [Hz]"] for r in rw.modes(scene, count=8).table if r["motion"] == "out of plane"
    ]
    assert min(abs(f / expected - 1.0) for f in across) < 0.01
    assert across[0] > 1.0  # of the ends
    assert rw.modes(bars(0.0), count=4).frequencies[0] < 1e-3  # free along the bars
