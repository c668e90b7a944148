"""A coefficient of restitution of ropes on ropes: what `adaptive` throws back, against closed forms.

Two links that touch where c_a are the shares of their ends are one body there, of 1 / sum(c_a^2 / m_a); their
points part with e of the speed at which they came closer.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.distance import nearest
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    Contact,
    Joint,
    Kick,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Straight,
    Tie,
)
from ropewalk.simulation import Simulation
from verification.setups import DOWN, NO_GRAVITY

D, LENGTH, LINK, SPEED, GAP = 0.01, 0.2, 0.01, 1.0, 0.004  # m, m, kg, m/s, m
DEEP = 2e-4  # [m] how deep they go, 100 tolerances
SHARES = (0.1, 0.3, 0.5, 0.8, 1.0)
X, Y, Z = np.eye(3)


def link(
    name: str,
    middle: Floats,
    along: Floats,
    velocity: Floats,
    mass: float = LINK,
    load: float = 0.0,
) -> Rope:
    """A rope of one segment, with a load at its last node."""
    half = 0.5 * LENGTH * along / np.linalg.norm(along)
    return Rope(
        name=name, segments=1, length=LENGTH, diameter=D,
        made_of=Material(EA=1e4, mass_per_length=mass / LENGTH),
        shape=Straight(
            start=tuple(middle - half), end=tuple(middle + half), velocity=tuple(velocity)
        ),
        loads=[Load(node=-1, mass=load)] if load else [],
    )  # fmt: skip


def thrown(
    share: float, ropes: list[Rope], mass: float, held: bool = False, **more: object
) -> Scene:
    """Ropes that meet as one body of a mass, until just after it, without weight."""
    deep = float(more.pop("deep", DEEP))  # type: ignore[arg-type]
    time = GAP / SPEED + 8.0 * deep / SPEED + 1e-3
    run = RunSettings(
        method="adaptive", tolerance=0.01 * deep, duration=time, frame_rate=20.0 / time
    )
    soft: dict[str, Any] = {"compliance": (deep / SPEED) ** 2 / mass, "restitution": share}
    contact = Contact(**{"friction": 0.0} | soft | more)
    anchors = [Anchor(rope=ropes[0].name, node=node) for node in (0, 1) if held]
    return Scene(ropes=ropes, anchors=anchors, contact=contact, gravity=NO_GRAVITY, run=run)


def crossed(
    share: float, s: float = 0.5, t: float = 0.5, along: Floats = Z, slides: float = 0.0,
    held: bool = False, load: float = 0.0, heavy: float = LINK, **more: object,
) -> tuple[Scene, float, Floats]:  # fmt: skip
    """A link that comes down on another, its point t on the other's s; the mass they meet as; all nodes'."""
    ends = np.array([0.5 * LINK, 0.5 * LINK, 0.5 * heavy, 0.5 * heavy + load])
    ease = np.array([1.0 - s, s, 1.0 - t, t]) ** 2 / ends
    mass = 1.0 / (ease[2:].sum() if held else ease.sum())
    other = (GAP + D) * Y + (0.5 - t) * LENGTH * along / np.linalg.norm(along)
    ropes = [
        link("lies", (0.5 - s) * LENGTH * X, X, 0.0 * X),
        link("comes", other - slides * GAP / SPEED * X, along, slides * X - SPEED * Y, heavy, load),
    ]
    return thrown(share, ropes, mass, held, **more), mass, ends


@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize("share", SHARES)
def test_links_part_with_their_share(share: float, held: bool) -> None:
    """In their middles, both free or one held, and however far off they begin."""
    for more in (0.0, 0.0003, 0.0011):
        scene, _, _ = crossed(share, held=held)
        shape = scene.ropes[1].shape
        ends = [tuple(np.array(end) + more * Y) for end in (shape.start, shape.end)]
        far = scene.ropes[1].replace(shape=shape.replace(start=ends[0], end=ends[1]))
        run = scene.run.replace(duration=scene.run.duration + more / SPEED)
        last = rw.simulate(scene.replace(ropes=[scene.ropes[0], far], run=run)).velocities[-1]
        parts = last[2:, 1].mean() - last[:2, 1].mean()
        assert parts / SPEED == pytest.approx(share, abs=2e-3)
        if not held:
            assert last[:, 1].mean() == pytest.approx(-0.5 * SPEED, rel=1e-12)


PLACES = [
    {"s": 0.2, "t": 0.5},
    {"s": 0.1, "t": 0.8},
    {"s": 0.9, "t": 0.95},
    {"s": 0.5, "t": 1.0, "slides": 0.5},
    {"s": 0.3, "t": 0.6, "along": X + Z},
    {"s": 0.3, "t": 0.6, "along": 3.0 * X + Z},
    {"s": 0.3, "t": 0.6, "load": 0.1},
    {"s": 0.3, "t": 0.6, "heavy": 0.5},
]


@pytest.mark.parametrize("share", [0.1, 0.5, 1.0])
@pytest.mark.parametrize("held", [False, True])
@pytest.mark.parametrize("place", PLACES)
def test_what_hits_off_its_middle_gets_a_rigid_bodys_impulse(
    place: dict[str, Any], held: bool, share: float
) -> None:
    """(1 + e) m u of the mass as which the points move; momenta stay, and the energy that it takes goes."""
    scene, mass, ends = crossed(share, held=held, **place)
    result = rw.simulate(scene)
    x, v = result.positions, result.velocities
    gained = ends @ (v[-1] - v[0])
    came = 0.5 * (ends[2:, None] * v[0, 2:] ** 2).sum()
    left = 0.5 * (ends[:, None] * v[-1] ** 2).sum()
    got = ends[2:] @ (v[-1] - v[0])[2:]
    assert got[1] == pytest.approx((1.0 + share) * mass * SPEED, rel=2e-3)
    assert (came - left) / came == pytest.approx(
        0.5 * mass * SPEED**2 * (1.0 - share**2) / came, abs=3e-3
    )
    if not held:
        turned = [np.cross(x[k], ends[:, None] * v[k]).sum(axis=0) for k in (0, -1)]
        assert np.abs(gained).max() < 1e-12 * ends.sum() * SPEED
        off = 1e-4 if "slides" in place else 2e-6  # normals lag behind by a step
        assert turned[1] == pytest.approx(turned[0], abs=off * LENGTH * LINK * SPEED)


@pytest.mark.parametrize("share", [0.3, 1.0])
@pytest.mark.parametrize("place", [{}, {"s": 0.3, "t": 0.6}])
def test_what_slides_as_it_hits_loses_by_coulombs_law(place: dict[str, Any], share: float) -> None:
    """The impulse along is mu times that across, (1 + e) m u."""
    scene, mass, ends = crossed(share, slides=1.0, friction=0.2, **place)
    v = rw.simulate(scene).velocities
    got = ends[2:] @ (v[-1] - v[0])[2:]
    across = (1.0 + share) * mass * SPEED
    assert got[1] == pytest.approx(across, rel=3e-3)
    assert got[0] == pytest.approx(-0.2 * across, rel=3e-3)


@pytest.mark.parametrize("share", [0.3, 1.0])
@pytest.mark.parametrize("rise", [0.004, 0.02])
def test_what_is_near_at_one_end_and_hits_with_the_other_counts(rise: float, share: float) -> None:
    """A link on a hinge 0.5 mm beside another, which it strikes with its far end.

    Left with 0.34 and 0.40 for 0.3 where the points were those from before, or no step ended at that hit.
    """
    long, near, mass = 0.18, D + 5e-4, 0.5 * LINK
    far = (math.sqrt(long**2 - rise**2) - 0.08, near + rise, 0.0)
    lies = link("lies", 0.0 * X, X, 0.0 * X)
    swings = Rope(
        name="swings", segments=1, length=long, diameter=D,
        made_of=Material(EA=1e6, mass_per_length=LINK / long),
        shape=Straight(start=(-0.08, near, 0), end=far),
        kicks=[Kick(node=1, velocity=(0, -SPEED, 0))],
    )  # fmt: skip
    scene = thrown(share, [lies, swings], mass, held=True, deep=3e-4)
    anchors = [*scene.anchors, Anchor(rope="swings", node=0)]
    run = scene.run.replace(duration=scene.run.duration + rise / SPEED)
    result = rw.simulate(scene.replace(anchors=anchors, run=run))
    arm = result.rope("swings").positions[:, 1] - (-0.08, near, 0.0)
    turns = np.cross(arm, result.rope("swings").velocities[:, 1])[:, 2]
    before = turns[(turns < 0.0) & (arm[:, 1] > 0.0)][-1]  # its far end was the higher one still
    assert turns[-1] / -before == pytest.approx(share, abs=1.5e-3)


@pytest.mark.parametrize("share", [0.3, 0.8])
def test_what_a_joint_ties_counts(share: float) -> None:
    """A link that comes down beside a knot, on the lighter of two links in it."""
    heavy, s = 0.03, 0.2
    away = -0.5 * LENGTH * (0.5 * X + math.sqrt(0.75) * Z)
    ropes = [
        link("lies", 0.5 * LENGTH * X, X, 0.0 * X),
        link("tied", away, -away, 0.0 * X, mass=heavy),
        link("comes", s * LENGTH * X + (GAP + D) * Y + 0.25 * LENGTH * Z, Z, -SPEED * Y),
    ]
    knot = 0.5 * (LINK + heavy)
    ease = (1.0 - s) ** 2 / knot + (s**2 + 0.75**2 + 0.25**2) / (0.5 * LINK)
    tie = Joint(points=[Tie(rope="lies", node=0), Tie(rope="tied", node=1)])
    v = rw.simulate(thrown(share, ropes, 1.0 / ease).replace(joints=[tie])).velocities
    got = 0.5 * LINK * (v[-1] - v[0])[-2:, 1].sum()
    assert got == pytest.approx((1.0 + share) * SPEED / ease, rel=2e-3)


@pytest.mark.parametrize("deep", [30, 1000])
@pytest.mark.parametrize(
    "place", [{}, {"s": 0.2, "t": 0.6, "held": True}, {"s": 0.1, "t": 0.9}], ids=str
)
def test_thirty_tolerances_are_deep_enough(place: dict[str, Any], deep: int) -> None:
    """To 0.002; to 0.005 where no step ended as they parted."""
    for share in (0.2, 0.4, 0.6, 0.8, 0.9, 1.0):
        scene, mass, _ = crossed(share, **place)
        v = rw.simulate(scene.replace(**{"run.tolerance": DEEP / deep})).velocities
        got = 0.5 * LINK * (v[-1] - v[0])[2:, 1].sum()
        assert got / (mass * SPEED) - 1.0 == pytest.approx(share, abs=1.8e-3)


@pytest.mark.parametrize("share", [0.5, 0.8, 1.0])
def test_bounces_on_a_held_link_are_as_high_as_its_square_says(share: float) -> None:
    """Less a share of g deep / u^2: what falls is braked from before it touches on."""
    fall = 0.1
    scene, _, _ = crossed(share, held=True)
    fast = math.sqrt(2.0 * 9.81 * fall)
    drops = link("comes", (fall + D) * Y, Z, 0.0 * Y)
    run = RunSettings(method="adaptive", tolerance=1e-6, duration=0.9, frame_rate=1000.0)
    contact = Contact(friction=0.0, compliance=(DEEP / fast) ** 2 / LINK, restitution=share)
    ropes = [scene.ropes[0], drops]
    result = rw.simulate(scene.replace(ropes=ropes, run=run, contact=contact, gravity=DOWN))
    gap, rise = result.positions[:, 2, 1] - D, result.velocities[:, 2, 1]
    peaks = gap[:-1][(rise[:-1] > 0.0) & (rise[1:] <= 0.0)]
    assert len(peaks) >= 2
    for bounce, peak in enumerate(peaks[:3], start=1):
        assert peak / fall == pytest.approx(share ** (2 * bounce), rel=0.03)
    assert result.table["largest balance residual [J]"] < 1e-14


def test_what_loses_nothing_goes_to_and_fro() -> None:
    """Between two held links, sixty hits: a thousandth of its speed is lost in each, as steps have it."""
    lies, comes = crossed(1.0)[0].ropes
    above = link("above", 0.05 * Y, X, 0.0 * X)
    scene = thrown(1.0, [lies, comes, above], LINK)
    anchors = [Anchor(rope=name, node=node) for name in ("lies", "above") for node in (0, 1)]
    run = scene.run.replace(duration=2.0, frame_rate=100.0)
    result = rw.simulate(scene.replace(anchors=anchors, run=run))
    speeds = result.rope("comes").velocities[:, :, 1]
    hits = int((np.diff(np.sign(speeds[:, 0])) != 0.0).sum())
    assert hits > 50
    assert 1.0 - abs(speeds[-1].mean()) / SPEED < 2e-3 * hits
    flying = np.abs(np.abs(speeds[:, 0]) - SPEED) < 0.2 * SPEED
    assert np.abs(speeds[flying]).max() < 1.0005 * SPEED


@pytest.mark.parametrize("share", SHARES)
def test_the_contact_takes_what_they_lose(share: float) -> None:
    scene, mass, _ = crossed(share)
    result = rw.simulate(scene)
    books = result.contact_work["ropes on ropes"]
    taken = -float(books["normal"][-1] + books["method"][-1])
    struck = 0.5 * mass * SPEED**2
    assert taken == pytest.approx((1.0 - share**2) * struck, abs=4e-3 * struck)
    assert float(books["friction"][-1]) == 0.0
    assert result.table["largest balance residual [J]"] < 1e-15


def test_none_is_what_was() -> None:
    """With e = 0 a contact is that of one that says nothing, to the bit, and all but inelastic."""
    scene, _, _ = crossed(0.0)
    silent = scene.replace(
        contact=Contact(friction=0.0, compliance=scene.contact and scene.contact.compliance)
    )
    runs = [
        Simulation(one).advance_frames(20).recording.v for one in (silent, scene, crossed(1e-3)[0])
    ]
    assert np.array_equal(runs[0], runs[1])
    assert not np.array_equal(runs[0], runs[2])
    last = runs[0][-1, 1]
    assert abs(last[2:].mean() - last[:2].mean()) < 0.05 * SPEED


def tossed(seed: int) -> Scene:
    """Three ropes of one to three segments that fly at each other, at random."""
    rng = np.random.default_rng(seed)
    ropes: list[Rope] = []
    while len(ropes) < 3:
        many = int(rng.integers(1, 4))
        along, middle = rng.normal(size=3), rng.uniform(-0.06, 0.06, 3)
        half = 0.05 * many * along / np.linalg.norm(along)
        ends = np.array([middle - half, middle + half])
        if any(
            nearest(x := np.concatenate([ends, one]).T, x, 0.0, 0, 2)[2] < 1.05 * D
            for one in ([rope.shape.start, rope.shape.end] for rope in ropes)
        ):
            continue
        speed = -middle / 0.06 * rng.uniform(1.0, 4.0) + rng.normal(size=3)
        ropes.append(
            Rope(
                name=f"rope-{len(ropes)}", segments=many, length=0.1 * many, diameter=D,
                made_of=Material(
                    EA=1e4, mass_per_length=0.05 * rng.uniform(0.5, 2.0), axial_damping=0.1
                ),
                shape=Straight(start=tuple(ends[0]), end=tuple(ends[1]), velocity=tuple(speed)),
            )
        )  # fmt: skip
    contact = Contact(
        friction=(0.0, 0.3)[seed // 4 % 2],
        compliance=5e-6,
        restitution=(1.0, 0.8, 0.5, 0.1)[seed % 4],
    )
    run = RunSettings(method="adaptive", tolerance=1e-5, duration=0.05, frame_rate=2000.0)
    return Scene(ropes=ropes, contact=contact, gravity=NO_GRAVITY, run=run)


@pytest.mark.parametrize("first", [0, 8, 16])
def test_no_throw_gains_energy_or_passes(first: int) -> None:
    """More than before by 1e-4 at most (e = 1, no friction), and none is pressed by 7 % of the diameter."""
    for seed in range(first, first + 8):
        simulation = Simulation(tossed(seed))
        film = simulation.advance_frames(100).recording
        mass, rope = simulation.arrays.mass, simulation.system.node.contact.rope
        kinetic = 0.5 * (mass * (film.v**2).sum(axis=1)).sum(axis=1)
        momentum = (mass * film.v).sum(axis=2)
        assert kinetic.max() < (1.0 + 5e-4) * kinetic[0]
        assert np.abs(momentum - momentum[0]).max() < 1e-13 * np.abs(momentum[0]).max() + 1e-15
        segments = np.flatnonzero(rope >= 0)
        for i in segments:
            for j in segments[rope[segments] > rope[i]]:
                assert min(nearest(x, x, 0.0, i, j)[2] for x in film.x[::5]) > 0.93 * D


def refused(scene: Scene) -> str:
    with pytest.raises(SceneError) as told:
        build(scene)
    return str(told.value)


@pytest.mark.parametrize("method", ["auto", "esdirk3", "implicit-euler", "verlet", "rk4"])
def test_steps_of_a_fixed_length_are_refused_by_name(method: str) -> None:
    run = RunSettings(method=method, duration=0.1)
    text = refused(crossed(0.5)[0].replace(run=run))
    assert 'contact.restitution: 0.5 - asks for run.method = "adaptive"' in text
    assert f'it is "{method}"' in text
    build(crossed(0.0)[0].replace(run=run))  # the twin


def test_a_contact_that_hardens_is_refused_with_one_that_does() -> None:
    """The compliance that is told is taken, and goes no deeper than is told."""
    text = refused(crossed(0.5)[0].replace(**{"contact.compliance": None}))
    assert "contact.restitution: 0.5 - asks for a compliance (m/N): by default a contact" in text
    told = float(text.split("else; with ")[1].split(" ")[0])
    assert "that meet at 2 m/s as one of 0.005 kg go 0.3 mm into each other" in text  # both move
    scene = crossed(0.5)[0].replace(**{"contact.compliance": told})
    last = rw.simulate(scene).velocities[-1, :, 1]
    assert (last[2:] - last[:2]).mean() / SPEED == pytest.approx(0.5, abs=5e-3)


@pytest.mark.parametrize(
    ("value", "rule"), [(-0.1, "at least 0"), (1.01, "at most 1"), (math.nan, "finite number")]
)
def test_a_faulty_share_is_refused(value: float, rule: str) -> None:
    with pytest.raises(SceneError, match=rule) as told:
        crossed(value)
    assert "restitution" in str(told.value)


def notes(scene: Scene, words: str) -> list[str]:
    return [note for note in rw.check(scene, measure=False).warnings if words in note]


def test_check_says_where_they_go_too_little_deep_or_too_deep() -> None:
    scene = crossed(0.5)[0]
    (shallow,) = notes(scene.replace(**{"run.tolerance": 1e-5}), "are pressed by")
    assert "contact: segments that meet at 1 m/s, to be reckoned with" in shallow
    assert "are pressed by 0.141 mm, 14 tolerances, and its restitution is right from 30" in shallow
    assert "run.tolerance of at most 4.7e-06 m, or a compliance of at least 3.6e-05" in shallow
    (far,) = notes(scene.replace(**{"contact.compliance": 1e-3}), "are pressed by")
    assert "that meet at 2 m/s" in far  # the other may come as well
    assert "4.47 mm, and contacts of ropes are linear to 0.6 mm" in far
    assert "take a compliance of at most 1.8e-05 m/N" in far
    assert not notes(scene, "are pressed by")
    assert not notes(crossed(0.0)[0].replace(**{"contact.compliance": 1e-3}), "are pressed by")


def test_check_reckons_with_a_held_rope_as_one_that_stands() -> None:
    """Beside one it told 6.32 mm, as if what moves met it with the speed of two: less would do."""
    soft = {"contact.compliance": 1e-3}

    def told(heavy: float, *, held: bool) -> str:
        scene = crossed(0.5, heavy=heavy)[0].replace(**soft)
        if held:
            anchors = [Anchor(rope="held", node=node) for node in (0, 1)]
            ropes = [*scene.ropes, link("held", 5.0 * X, X, 0.0 * X)]
            scene = scene.replace(ropes=ropes, anchors=anchors)
        return notes(scene, "are pressed by")[0]

    assert "meet at 2 m/s, to be reckoned with, are pressed by 4.47 mm" in told(LINK, held=True)
    assert told(LINK, held=True) == told(LINK, held=False)
    assert "meet at 2 m/s, to be reckoned with, are pressed by 6.03 mm" in told(0.1, held=False)
    assert "meet at 1 m/s, to be reckoned with, are pressed by 10 mm" in told(0.1, held=True)


def test_check_says_that_ropes_of_many_segments_keep_something_else() -> None:
    scene = crossed(0.5)[0]
    many = [scene.ropes[0], scene.ropes[1].replace(segments=4)]
    (note,) = notes(scene.replace(ropes=many), "restitution")
    assert note.startswith("contact: its restitution is that of two segments on their own")
    assert "beside them in rope 'comes' pull meanwhile" in note
    assert not notes(scene, "restitution")
    assert not notes(crossed(0.0)[0].replace(ropes=many), "restitution")


def test_the_lab_refuses_it_by_name() -> None:
    from ropewalk.live.lab import lab_scene

    with pytest.raises(SceneError, match=r"contact.restitution: 0.5 - asks for run.method"):
        lab_scene(crossed(0.5)[0])
