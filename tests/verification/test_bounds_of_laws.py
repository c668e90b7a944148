"""The stretch limiter beside curves, relaxation and rigid links: bounds that hold, laws that go on within."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.status import OK
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Anchor,
    Force,
    Joint,
    Limiter,
    Load,
    Material,
    Rope,
    Scene,
    SceneError,
    Straight,
    Tie,
)
from ropewalk.simulation import Simulation
from verification.test_bounds import ABLE, folded

CURVE = [(0.02, 20.0), (0.1, 60.0), (0.2, 400.0)]  # 60 N at the bound
TAU, SOFT, ARM = 0.5, 400.0, 400.0  # s, N, N
BEND = {"curve": CURVE}
SOLID = {"EA": SOFT, "relaxing_EA": ARM, "relaxation_time": TAU}
LIMIT = Limiter(min_stretch=0.9, max_stretch=1.1)
EXPLICIT = ("semi-implicit-euler", "verlet", "heun", "rk4")
STEPS = {"adaptive": "auto"} | dict.fromkeys(EXPLICIT, 2e-4)
BELOW = 9.81 * (10.0 + 0.1 * np.array([3.5, 2.5, 1.5, 0.5]))  # [N] weights below the segments


def hung(method: str, limiter: Limiter | None = LIMIT, mass: float = 10.0, **stuff: Any) -> Scene:
    """Four metres with a load at the end, let go at their unstretched length."""
    made_of = Material(mass_per_length=0.1, axial_damping=30.0, **stuff)
    rope = Rope(
        segments=4, length=4.0, made_of=made_of, loads=[Load(node=-1, mass=mass)],
        shape=Straight(end=(0.0, 0.0, -4.0)),
    )  # fmt: skip
    run = {"method": method, "time_step": STEPS.get(method, 5e-3), "duration": 3.0}
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], limiter=limiter, run=run)


def lengths(result: rw.Result) -> np.ndarray:
    """Of all segments in all frames [m]."""
    return np.asarray(np.linalg.norm(np.diff(result.positions, axis=1), axis=2))


@pytest.mark.parametrize("method", [*ABLE, *EXPLICIT])
@pytest.mark.parametrize("stuff", [BEND, SOLID], ids=["curve", "solid"])
def test_a_load_hangs_in_the_bound(method: str, stuff: dict[str, Any]) -> None:
    """The rope pulls as its law has it at the bound, the limiter bears the rest of the weight, and the books
    close. Explicit steps let the load fall and put it back, where the tension is a mean: of their first and
    last segment to 0.05 %. The twin: without the limiter the rope is longer.
    """
    result = rw.simulate(hung(method, **stuff))
    able = method in ABLE
    np.testing.assert_allclose(lengths(result)[-1], 1.1, rtol=1e-12 if able else 1e-9)
    np.testing.assert_allclose(result.tension[-1], BELOW, rtol=1e-8 if able else 5e-4)
    own = 60.0 if stuff is BEND else SOFT * 0.1
    np.testing.assert_allclose(
        result.elastic_tension[-1], own, rtol=1e-9 if stuff is BEND else 1e-2
    )
    assert lengths(result).max() < 1.1 * (1.0 + 1e-9)
    assert result.table["largest balance residual [J]"] < 1e-10
    assert result.work["limiter"][-1] < -1.0
    if method == "esdirk3":
        assert lengths(rw.simulate(hung(method, None, **stuff))).max() > 1.15


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3", "adaptive", "heun", "rk4"])
@pytest.mark.parametrize("stuff", [BEND, SOLID], ids=["curve", "solid"])
def test_below_its_bound_nothing_is_changed(method: str, stuff: dict[str, Any]) -> None:
    """To the bits (but of bdf2, which begins with another method, and verlet, which takes forces once more).
    The twin: a bound that it comes to.
    """
    free, far, near = (
        rw.simulate(hung(method, limiter, mass=2.0, **stuff)).positions
        for limiter in (
            None,
            Limiter(min_stretch=0.5, max_stretch=1.5),
            Limiter(max_stretch=1.02),
        )
    )
    np.testing.assert_array_equal(free, far)
    assert np.abs(free - near).max() > 1e-3


@pytest.mark.parametrize(
    ("method", "error"),
    [("implicit-euler", 1e-9), ("bdf2", 2e-4), ("esdirk3", 1e-6), ("adaptive", 1e-3), ("verlet", 1e-3)],
)  # fmt: skip
def test_a_solid_relaxes_at_its_bound(method: str, error: float) -> None:
    """While the load hangs there the rope's share falls by exp(-t / tau), implicit Euler's by its own factor,
    and the limiter bears the more. The twin: it would be seen if the share were that of the whole tension.
    """
    result = rw.simulate(hung(method, **SOLID))
    held = slice(int(np.searchsorted(result.time, 1.5)), None)
    t, own = result.time[held], result.elastic_tension[held] - SOFT * 0.1
    t = t - t[0]
    fall = np.exp(-t / TAU)
    if method == "implicit-euler":
        fall = (1.0 + result.plan.dt / TAU) ** (-t / result.plan.dt)
    expected = own[0] * fall[:, None]
    assert own[0].min() > 1.0
    np.testing.assert_allclose(own, expected, atol=error * own[0].max())
    np.testing.assert_allclose(result.tension[held], np.tile(BELOW, (len(t), 1)), rtol=1e-3)


@pytest.mark.parametrize("method", ABLE)
def test_a_rope_creeps_to_its_bound(method: str) -> None:
    """Ten grams follow their force soon. The strain creeps from F/(EA + E1) towards F/EA, comes
    to the bound after a time in closed form, and stays; from then on the rope's share falls.
    """
    EA, E1, tau, force, bound = 1e4, 2.5e4, 0.05, 700.0, 0.05
    made_of = Material(
        EA=EA, relaxing_EA=E1, relaxation_time=tau, mass_per_length=1e-9, axial_damping=2.0
    )
    rope = Rope(
        segments=1, length=1.0, made_of=made_of, loads=[Load(node=1, mass=0.01)],
        shape=Straight(end=(1.0, 0.0, 0.0)), forces=[Force(node=1, force=(force, 0.0, 0.0))],
    )  # fmt: skip
    run = {"method": method, "time_step": STEPS.get(method, 1e-3), "duration": 0.4}
    scene = Scene(
        gravity=(0, 0, 0), ropes=[rope], anchors=[Anchor(node=0)],
        limiter=Limiter(max_stretch=1.0 + bound), run=run | {"frame_rate": 50.0, "tolerance": 1e-5},
    )  # fmt: skip
    result = rw.simulate(scene)
    first, last, slow = force / (EA + E1), force / EA, tau * (EA + E1) / EA
    comes = slow * math.log((last - first) / (last - bound))
    assert 0.1 < comes < 0.2
    late = result.time > 0.1
    t = result.time[late]
    strain = np.minimum(last - (last - first) * np.exp(-t / slow), bound)
    own = EA * bound + (force - EA * bound) * np.exp(-np.maximum(t - comes, 0.0) / tau)
    error = 1e-2 if method == "implicit-euler" else 3e-3
    np.testing.assert_allclose(lengths(result)[late, 0] - 1.0, strain, atol=error * bound)
    np.testing.assert_allclose(result.elastic_tension[late, 0], own, atol=error * force)
    np.testing.assert_allclose(result.tension[late, 0], force, rtol=2e-3)
    assert lengths(result)[-1, 0] == pytest.approx(1.0 + bound, rel=1e-12)
    assert result.table["largest balance residual [J]"] < 1e-10


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3"])
def test_a_slack_rope_at_its_shortest_relaxes_as_one_that_nothing_pulls(method: str) -> None:
    """Drawn for long, let go and pressed to the least length: what it remembers falls by tau (EA + E1) / EA.
    The twin that can push is pressed there, and forgets by tau.
    """
    left = []
    for tension_only in (True, False):
        made_of = Material(**SOLID, mass_per_length=0.1, tension_only=tension_only)
        rope = Rope(segments=1, length=1.0, made_of=made_of, shape=Straight(end=(1.1, 0.0, 0.0)))
        run = {"method": method, "time_step": 1e-3, "duration": 0.5, "frame_rate": 50.0}
        scene = Scene(
            gravity=(-3000.0, 0.0, 0.0), ropes=[rope], anchors=[Anchor(node=0)],
            limiter=Limiter(min_stretch=0.95, max_stretch=1.1), run=run,
        )  # fmt: skip
        simulation = Simulation(scene)
        kept = []
        for frames in (10, 10):
            block = simulation.advance_frames(frames)
            kept.append(float(simulation.arrays.inner[0, 0]))
        assert block.recording.x[-1, 0, 1] == pytest.approx(0.95, abs=1e-12)
        left.append(kept)
    slow = TAU * (SOFT + ARM) / SOFT
    assert left[0][1] / left[0][0] == pytest.approx(math.exp(-0.2 / slow), rel=1e-3)
    other = (left[1][1] + 0.05) / (left[1][0] + 0.05)
    assert other == pytest.approx(math.exp(-0.2 / TAU), rel=1e-3)


@pytest.mark.parametrize("method", [name for name in ABLE if METHODS[name].fixed])
@pytest.mark.parametrize("tension_only", [False, True])
@pytest.mark.parametrize("law", ["curve", "solid"])
def test_bounds_of_laws_never_make_energy(method: str, tension_only: bool, law: str) -> None:
    """As `test_bounds_never_make_energy`: from folded and thrown states, with bounds that leave out L."""
    for size in (1.0, 1e6):
        stuff: dict[str, Any] = {"curve": [(e, size * T) for e, T in CURVE]}
        if law == "solid":
            stuff = {"EA": size, "relaxing_EA": 2.0 * size, "relaxation_time": 0.01}
        for low, high in [(0.98, 1.02), (1.0, 1.0), (1.05, 1.2), (0.7, 0.9)]:
            for step in (1e-3, 3e-2):
                limiter = Limiter(min_stretch=low, max_stretch=high)
                simulation = Simulation(
                    folded(method, limiter, step, tension_only=tension_only, **stuff)
                )
                first = simulation.recording().recording.energy[0]
                there = first[0] + first[2] + 2.0 * 0.1 * 9.81
                block = simulation.advance_frames(60)
                assert block.status == OK, simulation.failure
                energy = block.recording.energy
                assert float((energy[:, 0] + energy[:, 2]).max()) < 1.2 * there
                x = block.recording.x
                found = np.sqrt((np.diff(x, axis=2) ** 2).sum(axis=1)) * 12.0
                assert low - 1e-8 < found.min() <= found.max() < high + 1e-8


def pair(method: str, *names: str, limiter: Limiter | None = LIMIT, **more: Any) -> Scene:
    """An elastic rope, a curved one that relaxes and one of rigid links, which swing with a load each."""
    stuff = {
        "soft": {"EA": 200.0},
        "solid": {**BEND, "relaxing_EA": ARM, "relaxation_time": TAU},
        "rigid": {"EA": math.inf},
    }
    ropes = [
        Rope(
            name=name, segments=4, length=1.0, loads=[Load(node=-1, mass=4.0)],
            made_of=Material(mass_per_length=0.1, **stuff[name]),
            shape=Straight(start=(0, i, 0), end=(0.8, i, -0.6)),
        )
        for i, name in enumerate(stuff) if name in names
    ]  # fmt: skip
    anchors = [Anchor(name=name, rope=name, node=0) for name in names]
    run = {"method": method, "time_step": STEPS.get(method, 2e-3), "duration": 0.6}
    return Scene(ropes=ropes, anchors=anchors, limiter=limiter, run=run, **more)


@pytest.mark.parametrize("method", ABLE)
def test_ropes_of_all_kinds_move_as_each_alone(method: str) -> None:
    """In one scene the limiter holds those that stretch, and leaves rigid links alone."""
    names = ("soft", "solid", "rigid")
    together = rw.simulate(pair(method, *names))
    for name in names:
        alone = rw.simulate(pair(method, name, limiter=None if name == "rigid" else LIMIT))
        assert np.abs(together.rope(name).positions - alone.positions).max() < 1e-9
        assert np.abs(together.rope(name).tension - alone.tension).max() < 1e-5
    stretch = lengths(together)[:, [0, 5, 10]] * 4.0
    assert stretch[:, :2].max() == pytest.approx(1.1, abs=1e-9)
    np.testing.assert_allclose(stretch[:, 2], 1.0, atol=1e-12)
    free = rw.simulate(pair(method, *names, limiter=None))
    assert lengths(free)[:, [0, 5]].max() * 4.0 > 1.15


@pytest.mark.parametrize("method", ABLE)
@pytest.mark.parametrize("drawn", [1.0, 1.3], ids=["as long as it is", "beyond the bound"])
def test_rigid_links_hang_from_a_rope_at_its_bound(method: str, drawn: float) -> None:
    """Tied to each other: the tensions are the weights below in both, from the first step on that begins at
    the bounds, and the tied nodes are one.
    """
    made = {"mass_per_length": 0.1, "axial_damping": 30.0}
    upper = Rope(
        name="upper", segments=2, length=2.0, made_of=Material(**BEND, **made),
        shape=Straight(end=(0, 0, -2.0 * drawn)),
    )  # fmt: skip
    lower = Rope(
        name="lower", segments=2, length=2.0, loads=[Load(node=-1, mass=10.0)],
        made_of=Material(EA=math.inf, mass_per_length=0.1),
        shape=Straight(start=(0, 0, -2.0 * drawn), end=(0, 0, -2.0 * drawn - 2.0)),
    )  # fmt: skip
    tied = Joint(name="knot", points=[Tie(rope="upper", node=-1), Tie(rope="lower", node=0)])
    scene = Scene(
        ropes=[upper, lower], joints=[tied], anchors=[Anchor(name="a", rope="upper", node=0)],
        limiter=LIMIT, run={"method": method, "time_step": STEPS.get(method, 5e-3), "duration": 2.0},
    )  # fmt: skip
    result = rw.simulate(scene)
    last = result.positions[-1]
    np.testing.assert_allclose(np.diff(last[:3, 2]), -1.1, rtol=1e-10)
    np.testing.assert_allclose(np.diff(last[3:, 2]), -1.0, rtol=1e-10)
    found = [*result.rope("upper").tension[-1], *result.rope("lower").tension[-1]]
    np.testing.assert_allclose(found, BELOW, rtol=1e-7)
    np.testing.assert_allclose(result.positions[:, 2], result.positions[:, 3], atol=1e-12)
    assert result.table["largest balance residual [J]"] < 1e-10
    if drawn > 1.0:  # it hangs still from the first frame on
        np.testing.assert_allclose(result.positions[0], last, atol=1e-9)
        np.testing.assert_allclose(result.rope("lower").tension[0], BELOW[2:], rtol=1e-6)


def test_what_a_limiter_cannot_be_beside_is_told() -> None:
    """Links of one length keep bounds with 1 between them, and no others."""
    for limiter, words in (
        (Limiter(min_stretch=1.05, max_stretch=1.2), "limiter.min_stretch: 1.05 - must be at most 1"),
        (Limiter(min_stretch=0.5, max_stretch=0.9), "limiter.max_stretch: 0.9 - must be at least 1"),
    ):  # fmt: skip
        with pytest.raises(SceneError, match=words):
            pair("bdf2", "soft", "rigid", limiter=limiter)
        pair("bdf2", "soft", limiter=limiter)


def test_rest_and_modes_beyond_the_bound_are_refused() -> None:
    """They know springs only. The twins: a bound that the rope does not come to, and rigid links."""
    scene = hung("bdf2", **BEND)
    far = "segment 0 of rope 'rope' at 1.126 of its length"
    with pytest.raises(SceneError, match=f"modes know springs only, and rest is beyond .* {far}"):
        rw.modes(scene)
    with pytest.raises(SceneError, match=f"rests beyond the limiter's bounds.* {far}"):
        Simulation(scene.replace(run=scene.run.replace(start="at-rest")))
    wide = scene.replace(limiter=Limiter(max_stretch=1.2))
    free = scene.replace(limiter=None)
    np.testing.assert_array_equal(rw.modes(wide).frequencies, rw.modes(free).frequencies)
    Simulation(wide.replace(run=scene.run.replace(start="at-rest")))
    rigid = hung("bdf2", EA=math.inf)
    rw.modes(rigid)
    Simulation(rigid.replace(run=scene.run.replace(start="at-rest")))


def test_check_says_what_the_limiter_does() -> None:
    """It acts at rest on the curved rope only, and has nothing to do on rigid links."""
    checked = str(rw.check(hung("bdf2", **BEND)))
    assert "acts even at rest, on 4 segments" in checked
    rigid = str(rw.check(hung("bdf2", EA=math.inf)))
    assert "the stretch limiter has nothing to do on 'rope'" in rigid
    assert "acts even at rest" not in rigid


def test_a_bound_of_no_stretch_is_told_as_the_limiters() -> None:
    """Of springs that may not stretch at all it was said that they do not."""
    line = hung("bdf2", EA=1e4).ropes[0]
    ends = [Anchor(name="a", node=0), Anchor(name="b", node=-1)]
    far = tuple(2.0 * c for c in line.shape.end)
    scene = hung("bdf2", EA=1e4).replace(
        ropes=[line.replace(shape={"kind": "straight", "end": far})], anchors=ends,
        limiter=Limiter(max_stretch=1.0),
    )  # fmt: skip
    with pytest.raises(SceneError, match="between them at the limiter's max_stretch: an implicit"):
        Simulation(scene)
