"""Rest of ropes that lie on each other: against closed forms, runs, other starts; twins that must fail."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.core.status import OK
from ropewalk.laws.couplings import FINE
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    Contact,
    Force,
    Load,
    Material,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.statics import NoRest, Statics, checked_shape
from ropewalk.statics.balance import Balance
from ropewalk.vibration.linear import linearise

g = 9.81
WIDE = 0.01  # m
STUFF = Material(EA=1e4, mass_per_length=0.1, axial_damping=5.0)
RUN = RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60, duration=1.0)


def crossed(friction: float, aside: float = 0.0, bow: float = 0.0) -> Scene:
    """A slack rope laid over a taut one, `aside` [m] of its middle, drawn with a `bow` [m] to one side."""
    common: dict[str, Any] = {"segments": 21, "diameter": WIDE, "made_of": STUFF}
    lower = Straight(start=(-0.5005, 0, 0), end=(0.5005, 0, 0))
    height = 1.01 * WIDE
    middle = (aside + bow, 0.0, height)
    upper = Polyline(points=[(aside, -0.5005, height), middle, (aside, 0.5005, height)])
    ropes = [
        Rope(name="a", length=1.0, shape=lower, **common),
        Rope(name="b", length=1.05, shape=upper, **common),
    ]
    anchors = [Anchor(rope=rope, node=node) for rope in "ab" for node in (0, -1)]
    return Scene(ropes=ropes, anchors=anchors, contact=Contact(friction=friction), run=RUN)


def stays(scene: Scene, frames: int = 60) -> float:
    """How far a node moves from rest in so many frames [m]."""
    simulation = Simulation(scene.replace(run=scene.run.replace(start="at-rest")))
    before, most = simulation.positions.copy(), 0.0
    for _ in range(frames):
        assert simulation.advance_frames(1).status == OK
        most = max(most, float(np.abs(simulation.positions - before).max()))
    return most


def test_two_strings_press_by_the_closed_form() -> None:
    """Strings that hold each other w off their straight lines, their middle segments level: F = 2 T w / l.

    w has the contact's own give in it.
    """
    half, over, EA, give, flat = 0.5, 0.03, 2e3, 1e-6, 0.998 / 21
    stuff = Material(EA=EA, mass_per_length=0.01, axial_damping=1.0)
    common: dict[str, Any] = {
        "segments": 21,
        "length": 0.998,
        "diameter": WIDE,
        "made_of": stuff,
    }
    top, low = 0.5 * WIDE, -0.5 * WIDE
    lower = [(x, 0, z) for x, z in ((-half, over), (-0.02, low), (0.02, low), (half, over))]
    upper = [(0, y, z) for y, z in ((-half, -over), (-0.02, top), (0.02, top), (half, -over))]
    scene = Scene(
        ropes=[
            Rope(name="a", shape=Polyline(points=lower), **common),
            Rope(name="b", shape=Polyline(points=upper), **common),
        ],
        anchors=[Anchor(rope=rope, node=node) for rope in "ab" for node in (0, -1)],
        contact=Contact(friction=0.0, compliance=give),
        gravity=(0, 0, 0),
        run=RUN,
    )
    found = checked_shape(scene)
    force, stretch = 0.0, 1.0
    for _ in range(200):
        w = over + 0.5 * (WIDE - give * force)
        level = EA * (stretch - 1.0)  # tension of the middle segments
        length = math.hypot(half - 0.5 * flat * stretch, w)
        pull = EA * (length / (0.5 * (0.998 - flat)) - 1.0)
        force = 2.0 * pull * w / length
        stretch = 1.0 + pull * (half - 0.5 * flat * stretch) / length / EA
    assert level == pytest.approx(pull, rel=3e-3)
    assert give * force < 0.02 * WIDE  # within the skin, where the compliance is the given one
    (touch,) = found.touches
    assert touch.force == pytest.approx(force, rel=1e-6)
    assert ", the sum of" not in str(touch)
    assert found.positions[10, 2] == pytest.approx(over - w, abs=1e-9)
    assert found.residual < 1e-9


def test_contact_is_a_force_and_its_opposite() -> None:
    """The same ropes without contact, with the force that was found on both, hang in the same places."""
    scene = crossed(0.0, 0.013)
    found = checked_shape(scene)
    memory = found.memory.contact
    assert memory.tally[0] == 1
    pair, grip = memory.pair[0], memory.grip[0]
    assert pair.tolist() == [10, 32]
    force = grip[11] * grip[:3]
    forces: dict[str, list[Force]] = {"a": [], "b": []}
    for sign, rope, segment, at in (("+", "a", 10, grip[3]), ("-", "b", 10, grip[4])):
        for node, share in ((segment, 1.0 - at), (segment + 1, at)):
            part = share * force if sign == "+" else -share * force
            forces[rope].append(Force(node=node, force=tuple(map(float, part))))
    apart = scene.replace(contact=None)
    pushed = [rope.replace(forces=forces[rope.name]) for rope in scene.ropes]
    twin = checked_shape(apart.replace(ropes=pushed))
    assert np.abs(twin.positions - found.positions).max() < 1e-9
    assert np.abs(checked_shape(apart).positions - found.positions).max() > 1e-3


def test_without_friction_rest_is_the_same_from_other_starts() -> None:
    first = checked_shape(crossed(0.0, 0.013))
    for bow in (0.1, -0.04):
        other = checked_shape(crossed(0.0, 0.013, bow))
        assert np.abs(other.positions - first.positions).max() < 1e-7, bow
    held = checked_shape(crossed(0.3, 0.013, 0.1))  # the twin: with friction it is not
    assert np.abs(held.positions - first.positions).max() > 1e-3
    assert held.by_friction
    assert not first.by_friction


def test_a_long_damped_run_ends_there() -> None:
    """A frictionless contact of a run holds planes to a hundredth of a radian, and so nearly there.

    It presses ropes up that statics leaves in their skins: 2 % of the diameter.
    """
    scene = crossed(0.0, 0.013)
    rest = checked_shape(scene)
    simulation = Simulation(scene)
    simulation.step(30.0)
    off = np.abs(simulation.positions - rest.positions)
    drawn = np.abs(build(scene).state.x.T - rest.positions).max()
    assert drawn > 0.05
    assert off[:, 2].max() < 0.02 * scene.ropes[0].diameter
    assert off.max() < 0.03 * drawn


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_what_is_at_rest_stays(friction: float) -> None:
    assert stays(crossed(friction, 0.013)) < 1e-9


def hung(low: float, high: float, friction: float = 0.3) -> Scene:
    """A free rope over one between two anchors, that hangs down so far on both sides [m]."""
    turn, bow = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 13), 0.5 * 0.01 + 0.0091
    over = [(0.0, bow * math.sin(a), bow * math.cos(a)) for a in turn]
    points = np.array([(0.0, -bow, -low), *over, (0.0, bow, -high)])
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    stuff = Material(EA=1e3, mass_per_length=0.1, axial_damping=5.0)
    common: dict[str, Any] = {"diameter": WIDE, "made_of": stuff}
    lower = Straight(start=(-0.5, 0, 0), end=(0.5, 0, 0))
    upper = Polyline(points=[tuple(point) for point in points.tolist()])
    return Scene(
        ropes=[
            Rope(name="a", segments=3, length=1.0, shape=lower, **common),
            Rope(name="b", segments=42, length=length, shape=upper, **common),
        ],
        anchors=[Anchor(rope="a", node=0), Anchor(rope="a", node=-1)],
        contact=Contact(friction=friction),
        run=RUN,
    )


@pytest.mark.slow
def test_a_rope_over_another_holds_within_the_capstans_bounds() -> None:
    """exp(0.3 pi) is 2.57: 1.8 to one holds, with its margin; 4 to one slides off, as does all without."""
    scene = hung(0.18, 0.10)
    found = checked_shape(scene)
    weight = g * build(scene).state.mass[4:].sum()
    assert sum(touch.force for touch in found.touches) > 0.9 * weight
    assert found.reactions[:, 2].sum() == pytest.approx(g * build(scene).state.mass.sum(), rel=1e-9)
    strand = max((touch.other for touch in found.touches), key=lambda one: one.angle)
    assert strand.rope == "b"
    assert strand.least < strand.after < strand.most
    assert strand.most / strand.before == pytest.approx(math.exp(0.3 * strand.angle), rel=1e-9)
    assert all(0.0 < touch.use <= 1.0 + 1e-9 for touch in found.touches)
    assert "friction holds" in str(found.touches[0])
    whole = max(found.touches, key=lambda touch: touch.contacts)
    assert whole.contacts > 1  # so the sum of what presses is more than the weight that it bears
    assert f" N, the sum of {whole.contacts} contacts;" in str(whole)
    assert stays(scene) < 1e-7
    for slides in (hung(0.24, 0.06), hung(0.18, 0.10, 0.0)):
        with pytest.raises(NoRest, match="slide or fall on and on"):
            checked_shape(slides)


def test_only_what_turns_towards_the_other_rope_holds() -> None:
    """A strand that friction holds in a bow turns in the plane of both ropes, too: that carries nothing.

    With T beside it and the weight W of its two nodes, R = W + 2 T sin(angle / 2).
    """
    (touch,) = checked_shape(crossed(0.6, bow=0.12)).touches
    assert touch.use == pytest.approx(1.0, rel=1e-6)  # drawn as far aside as friction holds
    strand, weight = touch.other, 2 * 0.1 * 1.05 / 21 * g
    assert strand.before == pytest.approx(strand.after, rel=1e-6)
    turn = 2.0 * math.asin((touch.force - weight) / (2.0 * strand.before))
    assert strand.angle == pytest.approx(turn, rel=1e-3)  # 0.6; in all it turns by 0.75
    # all of friction goes across it: nothing is left along it
    assert strand.most / strand.before == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("bow", [0.06, 0.09])
def test_what_friction_carries_across_a_strand_it_lacks_along_it(bow: float) -> None:
    """With S = 2 T sin(b / 2) across, b the turn within the plane, sqrt((mu N)^2 - S^2) is left along it.

    exp(mu theta) was said whatever it carries across: a factor of 1.4 where nothing is left.
    """
    mu, found = 0.6, checked_shape(crossed(0.6, bow=bow))
    (touch,) = found.touches
    strand = touch.other
    ways = np.diff(found.positions[22:], axis=0)[strand.first - 1 : strand.first + 2 : 2]
    into, out = (way / np.linalg.norm(way) for way in ways)
    across = 0.5 * abs(into[0] - out[0]) * (strand.before + strand.after)
    assert touch.use == pytest.approx(across / (mu * touch.force), rel=0.1)
    left = strand.angle * math.sqrt(mu**2 - (across / touch.force) ** 2)
    assert strand.most / strand.before == pytest.approx(math.exp(left), rel=0.02)
    assert strand.before / strand.least == pytest.approx(math.exp(left), rel=0.02)


def test_what_weight_turns_holds_no_more() -> None:
    """A heavy line sags where a thread lies over it: 24 times the friction of what presses was said."""
    line = Rope(
        name="line",
        segments=21,
        length=0.998,
        diameter=WIDE,
        made_of=Material(EA=1e5, mass_per_length=2.0, axial_damping=20.0),
        shape=Straight(start=(-0.5, 0, 0), end=(0.5, 0, 0)),
    )
    turn = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 8)
    over = [(0.0, 0.0101 * math.sin(a), 0.0101 * math.cos(a)) for a in turn]
    points = [(0.0, -0.0101, -0.3), *over, (0.0, 0.0101, -0.3)]
    thread = Rope(
        name="thread",
        segments=120,
        length=float(np.linalg.norm(np.diff(np.array(points), axis=0), axis=1).sum()),
        diameter=WIDE,
        made_of=Material(EA=1e3, mass_per_length=1e-4, axial_damping=20.0),
        shape=Polyline(points=points),
        loads=[Load(node=node, mass=0.002) for node in (0, -1)],
    )
    anchors = [Anchor(rope="line", node=node) for node in (0, -1)]
    scene = Scene(ropes=[line, thread], anchors=anchors, contact=Contact(friction=0.3), run=RUN)
    (touch,) = checked_shape(scene).touches
    strand = touch.strand
    assert strand.rope == "line"
    assert strand.angle * strand.before > 10.0 * touch.force
    for room in (strand.most - strand.before, strand.before - strand.least):
        assert 0.0 < room < 1.001 * 0.3 * touch.force


def test_check_tells_how_far_ropes_turn_round_ropes_that_a_run_begins_with() -> None:
    """As `settle` does: it told of wraps on obstacles alone, and that this rest was not looked for."""
    scene = crossed(0.6, bow=0.06)
    (touch,) = checked_shape(scene).touches
    found = rw.check(scene.replace(run=RUN.replace(start="at-rest")), measure=False)
    assert f"at rest: {touch}" in found.lines()
    turn = math.degrees(touch.other.angle)
    assert f"turns by {turn:.3g} degrees, where friction holds" in str(touch)
    assert found.as_dict()["statics"]["touches"][0]["other"]["angle"] == touch.other.angle  # type: ignore[index]
    assert not any("not looked for" in warning for warning in found.warnings)
    drawn = rw.check(scene, measure=False)
    assert drawn.as_dict()["statics"]["touches"] == []  # type: ignore[index]
    assert any("not looked for" in warning for warning in drawn.warnings)


def knotted(mass: float = 1.0) -> Scene:
    """An overhand knot in a rope that hangs from an anchor, with a load [kg] at its end."""
    rope = rw.preset("overhand").ropes[0]
    return Scene(
        ropes=[rope.replace(loads=[Load(node=-1, mass=mass)])],
        anchors=[Anchor(node=0)],
        contact=Contact(friction=0.2),
        run=RUN.replace(time_step=1 / 240),
    )


def test_a_knot_comes_to_rest_under_a_load() -> None:
    scene = knotted()
    found = checked_shape(scene)
    assert found.residual < 1e-8
    assert found.tension[-1] == pytest.approx(g * (1.0 + 0.08 * 0.01 * 0.5), rel=1e-3)
    assert sum(touch.force for touch in found.touches) > 20.0
    assert found.positions[-1, 2] > -0.65  # it is still a knot: 0.7 m of rope reach less far
    # where a contact lies at a node its points are found anew, and the knot shifts by 0.15 % of a diameter
    ways = [stays(scene, 12), *(stays(knotted(mass), 12) for mass in (0.9, 1.1))]
    assert max(ways) < 2e-5
    assert np.median(ways) < 1e-9


def bent(scene: Scene) -> tuple[Balance, Statics]:
    """The equations of rest of a scene, with what contacts carry there."""
    model, found = build(scene), checked_shape(scene)
    balance = Balance(model)
    arrays.assign(balance.state.memory, found.memory)
    return balance, found


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_modes_have_the_tangents_of_contacts(friction: float) -> None:
    """Against differences of the forces; what has no friction is free along the surface."""
    scene = crossed(friction, 0.013)
    balance, found = bent(scene)
    x = np.ascontiguousarray(found.positions.T)
    model = build(scene)
    arrays.assign(model.state.memory, found.memory)
    linear = linearise(model, x, np.zeros_like(found.elastic_tension))
    random = np.random.default_rng(3)
    for _ in range(3):
        way = random.normal(size=x.shape)
        way[:, ~balance.free] = 0.0
        way *= 1e-8 / np.abs(way).max()
        ends = [_others(balance, x + sign * way) for sign in (1.0, -1.0)]
        change = -0.5 * (ends[0] - ends[1])[:, balance.free].T.ravel()
        said = linear.other @ way[:, balance.free].T.ravel()
        assert np.abs(change - said).max() < 1e-5 * np.abs(said).max()


def _others(balance: Balance, x: Floats) -> Floats:
    kept = balance.kept()
    found = balance.others(x)
    balance.restore(kept)
    return found


def test_a_stuck_crossing_rings_higher_than_a_free_one() -> None:
    free, stuck = (rw.modes(crossed(mu, 0.013), count=6) for mu in (0.0, 0.3))
    assert free.frequencies[0] > 0.1
    assert stuck.frequencies[0] > 1.2 * free.frequencies[0]
    start = rw.modes(crossed(0.3, 0.013), "start", count=2)
    assert start.count == 2


def test_a_way_on_which_ropes_pass_is_not_taken() -> None:
    """Creeping looks at the way of its steps, too: from above to below is refused, a small way is not."""
    balance = Balance(build(crossed(0.0)))
    x = balance.state.x.copy()
    through = x.copy()
    through[2, 22:] -= 0.1
    assert balance.coupled.meets(x, through) != FINE
    balance = Balance(build(crossed(0.0)))
    near = x.copy()
    near[2, 22:] += 1e-3
    assert balance.coupled.meets(x, near) == FINE
