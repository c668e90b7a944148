"""Ropes that touch each other: friction against closed forms, momentum, energy, and that nothing passes.

Whether ropes have passed through each other is told by the linking number of closed curves made of them
(`topology`), which knows nothing of contacts.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from ropewalk.core.arrays import Floats, flatten
from ropewalk.laws.pairs.table import FAULT
from ropewalk.lowering import build
from ropewalk.methods.verdict import energy_now
from ropewalk.scene import (
    Anchor,
    Contact,
    Joint,
    Limiter,
    Material,
    Points,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Straight,
    Tie,
)
from ropewalk.simulation import Broken, Simulation
from verification.topology import linking_number

g = 9.81
MU = 0.3
FAR = 100.0  # [m]


def rails(
    degrees: float,
    method: str,
    *,
    segments: int = 1,
    friction: float = MU,
    speed: float = 0.0,
    **more: Any,
) -> tuple[Scene, Floats]:
    """A bar of one segment across two rails that cannot move, and the direction down them, (3,)."""
    slope = math.radians(degrees)
    down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
    up = np.array([math.sin(slope), 0.0, math.cos(slope)])
    ropes, anchors = [], []
    for k, y in enumerate((-0.1, 0.1)):
        places = np.linspace(-0.5, 2.5, segments + 1)
        ends = [tuple(np.array([0.0, y, 0.0]) + s * down) for s in places]
        stuff = Material(EA=1e5, mass_per_length=0.1)
        shape = Points(points=ends)
        ropes.append(
            Rope(
                name=f"rail{k}",
                segments=segments,
                length=3.0,
                diameter=0.01,
                made_of=stuff,
                shape=shape,
            )
        )
        anchors += [Anchor(rope=f"rail{k}", node=node) for node in range(segments + 1)]
    ends = [tuple(np.array([0.0, y, 0.0]) + 0.00999 * up) for y in (-0.15, 0.15)]
    stuff = Material(EA=1e3, mass_per_length=0.1)
    shape = Straight(start=ends[0], end=ends[1], velocity=tuple(speed * down))
    ropes.append(
        Rope(name="bar", segments=1, length=0.3, diameter=0.01, made_of=stuff, shape=shape)
    )
    run = RunSettings(**({"method": method, "time_step": 1.0 / 60.0, "frame_rate": 60.0} | more))
    return Scene(ropes=ropes, anchors=anchors, contact=Contact(friction=friction), run=run), down


def slid(scene: Scene, down: Floats, frames: int) -> tuple[Floats, Floats]:
    """Times [s] and how far the bar has come down [m]."""
    simulation, times, ways = Simulation(scene), [], []
    for _ in range(frames):
        simulation.step(1.0 / 60.0)
        times.append(simulation.time)
        ways.append(float(simulation.arrays.x[:, -2:].mean(axis=1) @ down))
    return np.array(times), np.array(ways)


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3", "bdf2"])
def test_a_bar_on_rails_sticks_below_the_angle_of_friction_and_slides_beyond(method: str) -> None:
    """a = g (sin - mu cos); below, nothing creeps. atan 0.3 = 16.70 degrees."""
    for degrees in (10.0, 16.5):
        _, ways = slid(*rails(degrees, method), 40)
        assert abs(ways[-1] - ways[20]) < 1e-6 / 3.0  # a third of a second; 1e-3 mm in four
    for degrees in (16.9, 25.0):
        slope = math.radians(degrees)
        times, ways = slid(*rails(degrees, method), 30)
        found = 2.0 * np.polyfit(times[15:], ways[15:], 2)[0]
        assert found == pytest.approx(g * (math.sin(slope) - MU * math.cos(slope)), rel=1e-3)


@pytest.mark.parametrize(("method", "rate"), [("implicit-euler", 60.0), ("esdirk3", 240.0)])
def test_nodes_of_what_lies_below_neither_throw_nor_hold(method: str, rate: float) -> None:
    """The rails have nodes every 3 cm and are 1 cm thick. Without friction the bar keeps its speed over them,
    with it a = g (sin - mu cos).
    """
    run = {"segments": 100, "time_step": 1.0 / rate}
    scene, down = rails(0.0, method, friction=0.0, speed=1.0, **run)
    simulation = Simulation(scene)
    for _ in range(24):
        simulation.step(1.0 / 60.0)
        assert float(simulation.arrays.v[:, -2:].mean(axis=1) @ down) == pytest.approx(
            1.0, abs=1e-3
        )
    slope = math.radians(25.0)
    times, ways = slid(*rails(25.0, method, **run), 30)
    found = 2.0 * np.polyfit(times[15:], ways[15:], 2)[0]
    assert found == pytest.approx(g * (math.sin(slope) - MU * math.cos(slope)), rel=1e-2)


@pytest.mark.parametrize("speed", [5.0, 20.0])
def test_an_explicit_method_makes_up_no_energy_at_its_automatic_step(speed: float) -> None:
    """However hard ropes hit: the bound of the step knows how stiff a contact gets that is pressed deep."""
    run = {"method": "semi-implicit-euler", "time_step": "auto", "frame_rate": 480.0}
    simulation = Simulation(thrown(speed, **run))
    first = energy_now(simulation.system, simulation.arrays)
    frames = math.ceil(480.0 * 0.12 / speed)
    most = 0.0
    for _ in range(frames):
        simulation.step(1.0 / 480.0)
        most = max(most, energy_now(simulation.system, simulation.arrays) - first)
    assert most < 0.01 * 0.5 * 0.1 * speed**2


def test_a_joint_is_not_cut_where_ropes_touch() -> None:
    """Its nodes lie inside each other and would burst apart: the sentence says so."""
    scene = thrown(1.0)
    more = scene.ropes[0].replace(
        name="c", shape=Straight(start=(0.5, 0, 0), end=(1.5, 0, 0)), segments=6
    )
    tied = Joint(name="knot", points=[Tie(rope="a", node=-1), Tie(rope="c", node=0)])
    simulation = Simulation(scene.replace(ropes=[*scene.ropes, more], joints=[tied]))
    with pytest.raises(SceneError, match="touch each other"):
        simulation.cut_joint("knot")


def test_an_explicit_method_finds_the_same() -> None:
    """The same law as a penalty with memory, at the predicted step."""
    more = {"time_step": "auto"}
    _, ways = slid(*rails(16.5, "semi-implicit-euler", **more), 18)
    assert abs(ways[-1] - ways[12]) < 1e-7
    times, ways = slid(*rails(25.0, "semi-implicit-euler", **more), 12)
    slope = math.radians(25.0)
    found = 2.0 * np.polyfit(times[3:], ways[3:], 2)[0]
    assert found == pytest.approx(g * (math.sin(slope) - MU * math.cos(slope)), rel=1e-2)


STUFF = {"EA": 1e4, "mass_per_length": 0.1, "axial_damping": 2.0}


def thrown(
    speed: float, *, touch: bool = True, shift: float = 0.0, turn: float = 0.0, **more: Any
) -> Scene:
    """A rope between two anchors, and one that is thrown at it from 0.1 m above, turned by `turn` [rad]."""
    c, s = math.cos(turn), math.sin(turn)
    over = Straight(
        start=(shift + 0.5 * s, -0.5 * c, 0.1),
        end=(shift - 0.5 * s, 0.5 * c, 0.1),
        velocity=(0.0, 0.0, -speed),
    )
    common: dict[str, Any] = {"segments": 6, "length": 1.0, "diameter": 0.01}
    ropes = [
        Rope(
            name="a",
            made_of=Material(**STUFF),
            shape=Straight(start=(-0.5, 0, 0), end=(0.5, 0, 0)),
            **common,
        ),
        Rope(name="b", made_of=Material(**STUFF), shape=over, **common),
    ]
    run = {"method": "implicit-euler", "time_step": 1.0 / 60.0, "frame_rate": 60.0} | more
    return Scene(
        ropes=ropes,
        anchors=[Anchor(rope="a", node=0), Anchor(rope="a", node=-1)],
        contact=Contact(friction=MU) if touch else None,
        run=RunSettings(**run),
    )


def linked(x: Floats) -> int:
    """How often the upper rope, closed above, goes round the lower one, closed below; (3, n)."""
    a, b = x[:, :7].T, x[:, 7:].T
    below = [[FAR, 0, a[-1, 2]], [FAR, 0, -FAR], [-FAR, 0, -FAR], [-FAR, 0, a[0, 2]]]
    above = [[b[-1, 0], FAR, b[-1, 2]], [0, FAR, FAR], [0, -FAR, FAR], [b[0, 0], -FAR, b[0, 2]]]
    found = linking_number(np.vstack([a, below]), np.vstack([b, above]))
    assert found == pytest.approx(round(found), abs=1e-6)
    return round(found)


@pytest.mark.parametrize(
    ("speed", "more"),
    [
        (1.0, {}),
        (5.0, {}),
        (20.0, {}),
        (50.0, {}),
        (20.0, {"shift": 0.03}),
        (20.0, {"turn": 0.7}),
        (50.0, {"shift": 0.05, "turn": 0.4}),
    ],
)
def test_a_rope_thrown_at_another_does_not_pass(speed: float, more: dict[str, float]) -> None:
    """Node on node, aside and askew, at up to 50 m/s in steps of 1/60 s: linked as before, each frame.

    Until a free end has swung through below, which is no passing but changes the number, too.
    """
    simulation = Simulation(thrown(speed, **more))
    before = linked(simulation.arrays.x)
    for frame in range(12):
        simulation.step(1.0 / 60.0)
        ends = simulation.arrays.x[1, [7, -1]]
        if not ends[0] < 0.0 < ends[1]:
            assert frame / 60.0 * speed > 0.5  # long after they met
            break
        assert linked(simulation.arrays.x) == before
        assert simulation.arrays.memory.contact.tally[FAULT] == 0


def test_beside_a_stretch_limiter_it_does_not_pass_either() -> None:
    """The line is at its bound when it stops what was thrown at it."""
    simulation = Simulation(thrown(20.0).replace(limiter=Limiter(max_stretch=1.001)))
    before = linked(simulation.arrays.x)
    for _ in range(2):
        simulation.step(1.0 / 60.0)
        assert linked(simulation.arrays.x) == before
    assert simulation.arrays.forces.limiter.any()


def test_the_twin_without_contact_passes() -> None:
    """Else the test above would show nothing."""
    simulation = Simulation(thrown(20.0, touch=False))
    before = linked(simulation.arrays.x)
    simulation.step(6.0 / 60.0)
    assert linked(simulation.arrays.x) != before


def test_an_explicit_step_that_passes_is_told() -> None:
    """A rope at 50 m/s in steps of 1 ms, five diameters each."""
    scene = thrown(50.0, method="semi-implicit-euler", time_step=1e-3)
    simulation = Simulation(scene)
    with pytest.raises(
        Broken,
        match=r"came nearer to each other in a step .* take implicit-euler, a time_step below",
    ):
        simulation.step(0.1)


def colliding(method: str, step: float | str, speed: float = 1.0, **contact: float) -> Scene:
    """Two free ropes that fly at each other, without weight, for 0.01 s until they meet."""
    ropes = []
    for k, (name, sign) in enumerate((("a", 1.0), ("b", -1.0))):
        side = (0.1, 0.0) if k == 0 else (0.0, 0.1)
        z = -(0.005 + 0.01 * speed) * sign
        shape = Straight(
            start=(-side[0], -side[1] + 0.013, z),
            end=(side[0], side[1] + 0.013, z),
            velocity=(0.1 * speed * k, 0.0, speed * sign),
        )
        stuff = Material(**STUFF)
        ropes.append(
            Rope(name=name, segments=3, length=0.2, diameter=0.01, made_of=stuff, shape=shape)
        )
    run = RunSettings(method=method, time_step=step, frame_rate=60.0)
    return Scene(gravity=(0, 0, 0), ropes=ropes, contact=Contact(friction=MU, **contact), run=run)


@pytest.mark.parametrize(
    ("method", "step"), [("implicit-euler", 1 / 240), ("semi-implicit-euler", "auto")]
)
def test_ropes_that_collide_keep_their_momentum_and_make_no_energy(method: str, step: Any) -> None:
    """Momentum to rounding; the energy, that of pressed contacts included, only falls."""
    simulation = Simulation(colliding(method, step))
    state, system = simulation.arrays, simulation.system
    before = (state.mass * state.v).sum(axis=1)
    size = float((state.mass * np.abs(state.v)).sum())
    energies = [energy_now(system, state)]
    for _ in range(5):
        simulation.step(1.0 / 60.0)
        state = simulation.arrays
        energies.append(energy_now(system, state))
        now = (state.mass * state.v).sum(axis=1)
        assert np.abs(now - before).max() < 1e-12 * size
    assert energies[-1] < 0.9 * energies[0]  # the impact takes
    slack = 1e-9 if method == "implicit-euler" else 1e-2
    assert (np.diff(energies) < slack * energies[0]).all()


def test_implicit_and_explicit_agree() -> None:
    """One law: with short steps both end at the same places and speeds."""
    ends = []
    for method, step in (("implicit-euler", 1 / 30720), ("semi-implicit-euler", 1 / 30720)):
        simulation = Simulation(colliding(method, step, speed=0.2, compliance=1e-3))
        simulation.step(2.0 / 60.0)
        ends.append((simulation.arrays.x.copy(), simulation.arrays.v.copy()))
    flown = 0.2 * 2.0 / 60.0  # [m] without the other
    assert np.abs(ends[0][0] - ends[1][0]).max() < 0.01 * flown
    assert np.abs(ends[0][1] - ends[1][1]).max() < 0.05 * 0.2
    assert abs(ends[0][1][2, 1]) < 0.5 * 0.2  # they have met


def draped() -> Scene:
    """A free rope over one between two anchors, its halves hanging."""
    stuff = Material(EA=1e3, mass_per_length=0.1, axial_damping=5.0)
    turn, bow = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 13), 0.014
    over = [(0.0, bow * math.sin(a), bow * math.cos(a)) for a in turn]
    points = np.array([(0.0, -bow, -0.2), *over, (0.0, bow, -0.2)])
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    lower = Straight(start=(-0.5, 0, 0), end=(0.5, 0, 0))
    upper = Polyline(points=[tuple(point) for point in points.tolist()])
    common: dict[str, Any] = {"diameter": 0.01, "made_of": stuff}
    return Scene(
        ropes=[
            Rope(name="a", segments=3, length=1.0, shape=lower, **common),
            Rope(name="b", segments=28, length=length, shape=upper, **common),
        ],
        anchors=[Anchor(rope="a", node=0), Anchor(rope="a", node=-1)],
        contact=Contact(friction=MU),
        run=RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60, duration=5.0),
    )


def test_a_draped_rope_hangs_still_with_its_weight_on_the_other() -> None:
    """At rest contacts carry the free rope's weight; where it lies it creeps by less than 1e-3 mm in 4 s.

    Its ends still swing by some hundredths of a millimetre.
    """
    simulation = Simulation(draped())
    simulation.step(6.0)
    first = simulation.arrays.x.copy()
    simulation.step(4.0)
    state, lies = simulation.arrays, [0, 1, 2, 3, 17, 18, 19]
    assert np.abs(state.x - first)[:, lies].max() < 1e-6
    assert np.abs(state.x - first).max() < 1e-3
    weight = g * state.mass[4:].sum()
    carried = state.forces.node.contact
    assert carried[2, 4:].sum() == pytest.approx(weight, rel=1e-5)
    assert carried[2, :4].sum() == pytest.approx(-weight, rel=1e-5)
    assert np.abs(carried[:2, 4:].sum(axis=1)).max() < 1e-4 * weight


def test_a_run_goes_on_to_the_same_bits_from_a_snapshot() -> None:
    """Contacts are part of the state."""
    simulation = Simulation(thrown(5.0))
    simulation.step(3.0 / 60.0)
    snapshot = simulation.state
    simulation.step(3.0 / 60.0)
    end = flatten(simulation.arrays)
    again = Simulation(thrown(5.0))
    again.restore(snapshot)
    again.step(3.0 / 60.0)
    for name, values in flatten(again.arrays).items():
        if name.startswith(("x", "v", "memory.contact.pair", "memory.contact.grip")):
            assert values.tobytes() == end[name].tobytes(), name


def test_what_cannot_touch_is_refused_in_words() -> None:
    """Diameters, methods, ropes inside each other."""
    scene = thrown(1.0)
    bare = scene.ropes[0].model_copy()
    bare = Rope(
        name="a", segments=6, length=1.0, made_of=Material(**STUFF), shape=scene.ropes[0].shape
    )
    with pytest.raises(
        SceneError, match=r"rope\[0\].diameter: missing - is needed where ropes touch"
    ):
        scene.replace(ropes=(bare, scene.ropes[1]))
    for method in ("implicit-midpoint", "generalized-alpha"):
        with pytest.raises(SceneError, match=r"run.method: .* cannot work with ropes that touch"):
            build(scene.replace(run=RunSettings(method=method)))
    through = Straight(start=(0, -0.5, 0.004), end=(0, 0.5, 0.004))
    crossed = scene.ropes[1].replace(shape=through)
    with pytest.raises(SceneError, match=r"mm inside segment 2 of rope 'a'"):
        build(scene.replace(ropes=(scene.ropes[0], crossed)))
    with pytest.raises(SceneError, match=r"friction: -0.1 - must be at least 0"):
        Contact(friction=-0.1)
