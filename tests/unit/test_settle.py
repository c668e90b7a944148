"""What has no rest shape is refused with what is missing; what the result of one frame can do."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.check import check
from ropewalk.lowering import build
from ropewalk.record.extremes import extremes
from ropewalk.record.rest import first
from ropewalk.record.resume import resume_run
from ropewalk.scene import Air, Anchor, Ground, Material, Rope, Scene, Springs, Straight
from ropewalk.statics import static_shape
from ropewalk.statics.newton import Found
from ropewalk.statics.rest import Balance, _complaint

STUFF = Springs(spring_constant=1000.0, node_mass=0.01, segment_length=0.05)


def scene(end: float | None = 0.4, held: tuple[int, ...] = (0, -1), **more: object) -> Scene:
    release = more.pop("release_time", None)
    shape = Straight(end=None if end is None else (end, 0.0, 0.0))
    rope = Rope(name="cord", segments=10, made_of=STUFF, shape=shape)
    anchors = tuple(Anchor(node=node, release_time=release) for node in held)
    return Scene(ropes=(rope,), anchors=anchors, **more)


def rod(**more: object) -> Scene:
    """The same cord, stiff in bending."""
    plain = scene(**more)
    stiff = Material(EA=50.0, mass_per_length=0.2, EI=0.01)
    return plain.replace(ropes=(plain.ropes[0].replace(made_of=stiff, length=0.5),))


def afloat(weight: float, **more: object) -> Scene:
    """The same cord in water, of this weight there [N/m]."""
    plain = scene(**more)
    cord = plain.ropes[0].replace(
        made_of=Material(EA=50.0, mass_per_length=0.2), length=0.5, submerged_weight=weight
    )
    return plain.replace(ropes=(cord,))


WIND = Air(node_drag=0.1, wind=(1.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (scene(held=()), "no anchor holds it, and there is no ground: it falls"),
        (scene(release_time=0.0), "all its anchors have let go at time 0"),
        (scene(held=(), gravity=(0, 0, 0)), "nothing acts on it: it is at rest wherever it is"),
        (scene(held=(), air=WIND, ground=Ground(height=-1.0)), "the wind carries it away"),
        (scene(gravity=(0, 0, 0)), "slack between its anchors, and has there no shape of its own"),
        (scene(held=(0,), gravity=(0, 0, 0)), "the part beyond its last anchor has no shape"),
        (rod(held=()), "no anchor holds it, and there is no ground: it falls"),
        (rod(held=(), gravity=(0, 0, 0)), "nothing acts on it: it is at rest wherever it is"),
        (afloat(0.0), "there is neither weight (buoyancy carries it all) nor wind, so every shape"),
        (afloat(0.0, held=(0,)), "the part beyond its last anchor has no shape of its own"),
        (afloat(0.0, held=()), "its weight and buoyancy cancel: it is at rest wherever it is"),
        (afloat(-2.0, held=()), "no anchor holds it: it rises; hold a node"),
        (afloat(-2.0, held=(), ground=Ground(height=-1.0)), "no anchor holds it: it rises"),
    ],
)
def test_what_is_missing_is_said(source: Scene, words: str) -> None:
    with pytest.raises(rw.SceneError) as caught:
        rw.equilibrium(source)
    assert str(caught.value).startswith('rope[0]: "cord" - ')
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_what_is_enough_is_not_refused() -> None:
    rw.equilibrium(scene(held=(), ground=Ground(height=-1.0)))
    rw.equilibrium(scene(end=0.6, gravity=(0, 0, 0)))
    rw.equilibrium(scene(held=(0,), gravity=(0, 0, 0), air=WIND))
    rw.equilibrium(scene(release_time=1.0))  # held at time zero
    rw.equilibrium(afloat(1e-3))
    rw.equilibrium(afloat(0.0, end=0.6))
    sinker = afloat(0.0, held=(0,))
    rw.equilibrium(
        sinker.replace(ropes=[sinker.ropes[0].replace(loads=[rw.Load(node=-1, mass=1.0)])])
    )


def _of(
    name: str, length: float, start: tuple[int, ...], end: tuple[int, ...], **more: object
) -> Rope:
    made_of = Material(EA=1e5, mass_per_length=0.5)
    shape = {"kind": "slack", "start": start, "end": end}
    return Rope(
        name=name,
        length=length,
        diameter=0.02,
        made_of=made_of,
        shape=shape,
        **{"segments": 4} | more,
    )


def _tied(*ropes: Rope) -> Scene:
    """Ropes one after the other, each tied to the next, and held at both ends."""
    names = [rope.name for rope in ropes]
    return Scene(
        ropes=ropes,
        anchors=[Anchor(rope=names[0], node=0), Anchor(rope=names[-1], node=-1)],
        joints=[
            {"points": [{"rope": a, "node": -1}, {"rope": b, "node": 0}]}
            for a, b in itertools.pairwise(names)
        ],
    )


AFLOAT = {"submerged_weight": 0.0}
POLY = _of("poly", 6.0, (0, 0, 0), (5, 0, -2), **AFLOAT)
MORE = _of("more", 2.0, (5, 0, -2), (6, 0, -2), **AFLOAT)
HEAVY = _of("chain", 8.0, (5, 0, -2), (10, 0, -4)).replace(**{"made_of.mass_per_length": 3.0})


def _ridden(mass: float) -> Scene:
    """A line that buoyancy carries, and a bob of this mass on a slide along it."""
    bob = Rope(
        name="bob", segments=1, length=0.5, made_of=Material(EA=1e5, mass_per_length=0.1),
        shape=Straight(start=(2.5, 0, -1), direction=(0, 0, -1)), submerged_weight=0.0,
        loads=[rw.Load(node=-1, mass=mass)] if mass else [],
    )  # fmt: skip
    line = _of("poly", 6.0, (0, 0, 0), (5, 0, 0), segments=24, **AFLOAT)
    ends = [Anchor(rope="poly", node=node) for node in (0, -1)]
    return Scene(ropes=[line, bob], anchors=ends, slides=[{"rope": "bob", "on": "poly", "at": 3.0}])


@pytest.mark.parametrize("between", [(), (MORE,)])
def test_what_a_heavy_rope_stretches_needs_no_weight(between: tuple[Rope, ...]) -> None:
    """It was refused, and `check` said "0 N" and "rise 1.884 m over 15.63 m" of the first one."""
    chain = HEAVY.replace(shape={"kind": "slack", "start": (6, 0, -2), "end": (10, 0, -4)})
    tied = _tied(POLY, *between, chain if between else HEAVY)
    rest = rw.equilibrium(tied)
    pull = rest.tension[0, :4]
    assert pull == pytest.approx(pull[0])
    assert np.linalg.norm(rest.positions[0, 4]) == pytest.approx(6.0 * (1.0 + pull[0] / 1e5))
    assert rest.reactions[0, :, 2].sum() == pytest.approx(24.0 * 9.81)
    said = check(tied, measure=False).ropes[0].largest_tension
    assert said == pytest.approx(pull[0])
    if not between:
        assert said == pytest.approx(129.91, abs=0.01)


def test_what_slides_along_a_rope_stretches_it() -> None:
    """It was refused; it hangs in two straight lines from the load, as an ellipse has it."""
    rest = rw.equilibrium(_ridden(20.0))
    half = 20.0 * 9.81 / 2.0
    steep = math.sqrt(3.0**2 - 2.5**2) / 3.0
    # it bends over three nodes where the slide is, not in a point
    assert rest.tension[0, :9] == pytest.approx(half / steep, rel=0.03)


@pytest.mark.parametrize(
    "slack",
    [
        _tied(POLY, MORE),
        _ridden(0.0),
        _tied(POLY, HEAVY).replace(anchors=[Anchor(rope="poly", node=n) for n in (0, -1)]),
        _tied(POLY, HEAVY).replace(anchors=[Anchor(rope="chain", node=-1)]),
    ],
    ids=["nothing is heavy", "the bob floats, too", "both ends are held", "a free tail"],
)
def test_what_nothing_stretches_is_still_refused(slack: Scene) -> None:
    with pytest.raises(rw.SceneError, match=r"no shape of its own: .*buoyancy carries it all"):
        rw.equilibrium(slack)


def _beside() -> Scene:
    """Two ropes that float from anchors to one joint with a chain, one of which is too long."""
    ropes = [POLY.replace(length=5.5), _of("longer", 9.0, (0, 1, 0), (5, 0, -2), **AFLOAT), HEAVY]
    ends = [
        Anchor(rope=name, node=node) for name, node in (("poly", 0), ("longer", 0), ("chain", -1))
    ]
    joint = [("poly", -1), ("longer", -1), ("chain", 0)]
    points = [{"rope": name, "node": node} for name, node in joint]
    return Scene(ropes=ropes, anchors=ends, joints=[{"points": points}])


def _held_in_the_middle(load: float | None) -> Scene:
    """Two spans of a line that floats, one of which bears a weight of 20 kg, on a slide or as a load."""
    course = [(10 * i / 24, 0, -(np.sin(np.pi * i / 12) ** 2)) for i in range(25)]
    found = _ridden(20.0 if load is None else 0.0)
    loads = [] if load is None else [rw.Load(node=6, mass=load)]
    line = found.ropes[0].replace(
        length=12.0, shape={"kind": "points", "points": course}, loads=loads
    )
    held = [Anchor(rope="poly", node=node) for node in (0, 12, -1)]
    ropes = [line, *(found.ropes[1:] if load is None else [])]
    return found.replace(ropes=ropes, anchors=held, slides=found.slides if load is None else [])


@pytest.mark.parametrize(
    ("slack", "named"),
    [
        (_beside(), "longer"),
        (_held_in_the_middle(None), "poly"),
        (_held_in_the_middle(20.0), "poly"),
    ],
    ids=["a longer one beside", "a slide on the other span", "a load on the other span"],
)
def test_what_stays_slack_beside_what_is_stretched_is_refused(slack: Scene, named: str) -> None:
    """ "sag 3.284 m over 5.598 m" was invented of the longer one, by how it was drawn."""
    with pytest.raises(
        rw.SceneError, match=r"no shape of its own: .*buoyancy carries it all"
    ) as told:
        rw.equilibrium(slack)
    number = next(i for i, rope in enumerate(slack.ropes) if rope.name == named)
    assert str(told.value).startswith(
        f'rope[{number}]: "{named}" - it is slack between its anchors'
    )
    assert "\n" not in str(told.value)


def test_check_tells_no_sag_of_what_may_have_any() -> None:
    """Of what carries nothing and weighs nothing; what it is tied to has its own."""
    statics = check(_beside(), measure=False).statics
    assert {span.rope for span in statics.spans} == {"poly", "chain"}
    statics = check(_held_in_the_middle(20.0), measure=False).statics
    assert [(span.first, span.last) for span in statics.spans] == [(0, 12)]
    assert static_shape(afloat(0.0), strict=False).spans == ()
    assert len(static_shape(afloat(0.0, end=0.6), strict=False).spans) == 1  # it is taut


@pytest.mark.parametrize(("tied", "rests"), [(_beside(), False), (_tied(POLY, HEAVY), True)])
def test_check_advises_no_start_at_rest_where_that_is_refused(tied: Scene, rests: bool) -> None:
    (said,) = (text for text in check(tied, measure=False).warnings if "starts it pressed" in text)
    assert said.endswith('take run.start = "at-rest"' if rests else "; more segments make it less")


def test_check_tells_nothing_of_a_tag_line_that_floats() -> None:
    """Its tied node sank with the rope, the others stayed as drawn: 3 m were to "hang free, 5.964 m long"."""
    level = Straight(start=(0, 0, 0), end=(10, 0, 0))
    chain = _of("chain", 12.0, (0, 0, 0), (10, 0, 0), segments=8).replace(shape=level)
    up = Straight(start=(5, 0, 0), direction=(0, 0, 1))
    tag = _of("tag", 3.0, (5, 0, 0), (6, 0, 0), **AFLOAT).replace(shape=up)
    joint = {"points": [{"rope": "chain", "node": 4}, {"rope": "tag", "node": 0}]}
    ends = [Anchor(rope="chain", node=node) for node in (0, -1)]
    tied = Scene(ropes=[chain, tag], anchors=ends, joints=[joint])
    found = check(tied, measure=False)
    assert [span.rope for span in found.statics.spans] == ["chain", "chain"]
    assert "hang free" not in str(found)
    assert any("'tag': 4 of 4 segments carry no tension" in text for text in found.warnings)


@pytest.mark.parametrize(
    ("weight", "said"),
    [(2.0, "holds it; it falls"), (0.0, "holds it"), (-2.0, "holds it; it rises")],
)
def test_check_says_where_ropes_go_that_nothing_holds(weight: float, said: str) -> None:
    """Of all it was said that they fall."""
    told = check(afloat(weight, held=()), measure=False).warnings
    assert any(text.endswith(f"rope 'cord': nothing {said}") for text in told)


def test_a_rod_needs_no_weight_to_have_a_shape() -> None:
    """Held anywhere and without gravity it is straight, as long as it is made: what is refused of a cord.
    Between ends nearer than its length it has a shape, too, which is not straight.
    """
    found = rw.equilibrium(rod(end=None, held=(0,), gravity=(0, 0, 0))).positions[0]
    np.testing.assert_allclose(found, np.outer(np.arange(11), (0.05, 0.0, 0.0)), atol=1e-12)
    pressed = rw.equilibrium(rod(end=0.499, gravity=(0, 0, 0)))
    assert pressed.tension[0].max() < 0.0


def test_a_chain_that_does_not_close_is_said_by_check(monkeypatch: pytest.MonkeyPatch) -> None:
    """`check` and `equilibrium` name the rope and its anchors, never a traceback."""

    def hang(*_: object) -> None:
        raise ArithmeticError("the rest shape did not close: 1 m are left open")

    assert check(scene(), measure=False)
    monkeypatch.setattr("ropewalk.statics.hung.hang", hang)
    for ask in (lambda one: check(one, measure=False), rw.equilibrium):
        with pytest.raises(rw.SceneError) as caught:
            ask(scene())
        said = "rope[0].length: 0.5 - the rest shape did not close: 1 m are left open (from anchor"
        assert str(caught.value).startswith(said)
        assert str(caught.value).endswith("'anchor0' to anchor 'anchor1')")


def test_rigid_links_that_do_not_reach() -> None:
    model = build(scene(end=0.6))
    model.state.stiffness[...] = math.inf
    with pytest.raises(rw.SceneError, match="must be more than the distance of the ends") as caught:
        static_shape(model)
    assert str(caught.value).startswith("rope[0].length: 0.5 - ")
    assert "anchor 'anchor0' to anchor 'anchor1'" in str(caught.value)


def test_a_failure_names_node_residual_and_remedy() -> None:
    model = build(scene())
    balance = Balance(model)
    found = Found(model.state.x, np.zeros(10), 1.0, 1e-9, 2000)
    text = _complaint(model, balance, found)
    assert "no shape of rest was found in 2000 steps" in text
    assert "of rope 'cord' 0.0981 N are left" in text
    assert "Give the scene a shape nearer to rest" in text


def test_the_result_of_one_frame(tmp_path: Path) -> None:
    result = rw.equilibrium(scene())
    assert result.frames == 1
    assert result.status == "at rest"
    assert result.residual < 1e-12
    assert repr(result).startswith("Equilibrium of 'scene': rope 'cord' with 10 segments, largest")
    assert not result.velocities.any()
    table = result.table
    assert table["largest tension at"] == "segment 0 of rope 'cord'"
    assert table["largest force left [N]"] == result.residual
    saved = result.save(tmp_path / "rest")
    assert saved.residual == result.residual
    np.testing.assert_array_equal(saved.positions, result.positions)
    np.testing.assert_array_equal(saved.reactions, result.reactions)
    assert saved.table["lowest point [m]"] == table["lowest point [m]"]
    with pytest.raises(rw.RunError, match="holds an equilibrium, not a run"):
        resume_run(tmp_path / "rest")
    assert math.isnan(rw.simulate(scene(run=rw.RunSettings(duration=0.1))).residual)


def test_energies_of_an_equilibrium_are_those_of_a_frame() -> None:
    # A run that starts at the rest shape records the same energies, tension and reactions.
    found = rw.equilibrium(scene())
    model = build(scene())
    model.state.x[...] = found.positions[0].T
    first = rw.Simulation(model).recording().recording
    np.testing.assert_allclose(found.energy["gravity"], first.energy[:, 1], rtol=1e-12)
    np.testing.assert_allclose(found.energy["elastic"], first.energy[:, 2], rtol=1e-9)
    np.testing.assert_allclose(found.tension, first.tension, rtol=1e-9)
    np.testing.assert_allclose(found.reactions, first.reaction, atol=1e-12)


@pytest.mark.parametrize("EA", [1e6, math.inf])
@pytest.mark.parametrize("tension_only", [True, False])
def test_the_largest_tension_at_rest_is_that_of_its_segments(EA: float, tension_only: bool) -> None:
    """Of rigid links it was 0 N, or none: those of the state, which nobody had solved for."""
    rope = Rope(
        segments=4,
        length=2.0,
        made_of=Material(EA=EA, mass_per_length=0.1, tension_only=tension_only),
        shape={"kind": "straight", "start": (0, 0, 0), "end": (0, 0, -2.0)},
        loads=[{"node": -1, "mass": 20.0}],
    )
    hung = Scene(ropes=[rope], anchors=[Anchor(node=0)], gravity=(0, 0, -9.81))
    assert ("strain 0 %" in str(check(hung, measure=False))) is math.isinf(EA)
    result = rw.equilibrium(hung)
    weights = 9.81 * (20.0 + 0.025 + 0.05 * np.arange(3, -1, -1))
    assert result.tension[0] == pytest.approx(weights, rel=1e-9)
    assert result.table["largest tension [N]"] == pytest.approx(weights[0], rel=1e-9)
    assert result.table["largest tension at"] == "segment 0 of rope 'rope'"
    found = extremes(result)
    assert found["greatest tension"].value == result.tension.max()
    assert found["least tension"].value == result.tension.min()


def test_of_places_that_are_even_by_symmetry_the_first_is_told() -> None:
    """R4's largest tension is in segments 0, 19, 20 and 39; rounding chose the 19th, or another."""
    table = rw.equilibrium("r4").table
    assert table["largest tension at"] == "segment 0 of rope 'rope'"
    assert table["largest stretch at"] == "segment 0 of rope 'rope'"
    assert table["lowest point at"] == "node 10 of rope 'rope'"
    assert first(np.array([-np.inf, 3.0, 3.0 + 1e-12, 2.0]), 3.0) == 1
    assert first(np.array([3.0, 3.0 + 1e-6]), 3.0) == 1
