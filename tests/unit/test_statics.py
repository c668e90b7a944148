"""Rest shapes against closed forms and against the forces, with twins that must fail."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.analysis.check import check
from ropewalk.lowering import build
from ropewalk.scene import (
    Air,
    Anchor,
    Ground,
    Load,
    Material,
    Rope,
    Scene,
    Slack,
    Springs,
    Straight,
)
from ropewalk.statics import RestSpan, Statics, rest, static_shape

G = 9.81


def scene(
    segments: int,
    k: float = 1000.0,
    m: float = 0.01,
    length: float = 0.05,
    start: tuple[float, float, float] = (0.0, 0.0, 0.0),
    end: tuple[float, float, float] | None = None,
    held: tuple[int, ...] = (0, -1),
    gravity: tuple[float, float, float] = (0.0, -G, 0.0),
    loads: tuple[Load, ...] = (),
    tension_only: bool = False,
) -> Scene:
    return Scene(
        gravity=gravity,
        ropes=(
            Rope(
                segments=segments,
                made_of=Springs(
                    spring_constant=k,
                    node_mass=m,
                    segment_length=length,
                    tension_only=tension_only,
                ),
                shape=Straight(start=start, end=end),
                loads=loads,
            ),
        ),
        anchors=tuple(Anchor(node=node) for node in held),
    )


def imbalance(source: Scene, found: Statics) -> float:
    """Largest force left over on any node [N], from the positions alone, anchors included."""
    model = build(source)
    state = model.state
    d = np.diff(found.positions, axis=0)
    r = np.linalg.norm(d, axis=1)
    pull = state.stiffness * (r - state.rest_length)
    pull[found.slack] = 0.0
    along = pull[:, None] * np.divide(d, r[:, None], out=np.zeros_like(d), where=r[:, None] > 0)
    net = state.mass[:, None] * model.system.gravity
    net[:-1] += along
    net[1:] -= along
    for node, force in zip(state.anchor_node, found.reactions, strict=True):
        net[node] += force
    return float(np.abs(net).max())


# Closed forms 2.2: (across, rise, segments, k, m, L) -> lowest node, H.
CASES = {
    "A": (0.8, 0.0, 20, 1000.0, 0.01, 0.05, -0.2783790277, 0.6296854707),
    "B": (0.6, 0.5, 20, 1000.0, 0.01, 0.05, -0.1129124727, 0.3675850581),
    "C": (1.0, 0.0, 20, 1000.0, 0.01, 0.05, -0.1246830154, 1.930593694),
    "D": (1.02, 0.0, 20, 1000.0, 0.01, 0.05, -0.1051722351, 2.348075301),
    "E": (0.8, 0.0, 20, 1e13, 0.01, 0.05, -0.2657915666, 0.663109127),
    "F": (3.95, 0.0, 79, 1e4, 0.05, 0.05, -0.6235371441, 29.8135164),
}


@pytest.mark.parametrize("name", CASES)
def test_pinned_chains(name: str) -> None:
    across, rise, segments, k, m, length, lowest, pull = CASES[name]
    source = scene(segments, k, m, length, end=(across, rise, 0.0))
    found = static_shape(source)
    assert found.spans[0].lowest == pytest.approx(lowest, abs=1e-10)
    assert found.spans[0].horizontal == pytest.approx(pull, rel=1e-9)
    np.testing.assert_allclose(np.abs(found.reactions[:, 0]), pull, rtol=1e-9)
    if k < 1e12:  # rigid links: k times the rounding of the positions
        assert imbalance(source, found) < 1e-10
    wrong = static_shape(scene(segments, k, 1.001 * m, length, end=(across, rise, 0.0)))
    assert abs(wrong.spans[0].horizontal - pull) > 1e-5 * pull


@pytest.mark.parametrize(
    ("n", "k", "sag", "pull"),
    [
        (10, 100.0, 1.3503, 4.446),
        (10, 200.0, 1.0639, 5.686),
        (10, 1e4, 0.2856, 21.449),
        (20, 100.0, 3.4350, 6.910),
        (20, 200.0, 2.6937, 8.911),
        (20, 1e4, 0.7181, 34.094),
        (30, 100.0, 5.9572, 8.886),
        (30, 200.0, 4.6523, 11.538),
        (30, 1e4, 1.2330, 44.654),
        (40, 100.0, 8.8247, 10.585),
        (40, 200.0, 6.8656, 13.826),
        (40, 1e4, 1.8099, 54.057),
    ],
)
def test_taut_sections_of_the_report(n: int, k: float, sag: float, pull: float) -> None:
    found = static_shape(scene(n, k, 0.05, 1.0, end=(float(n), 0.0, 0.0)))
    assert found.sag[0] == pytest.approx(sag, abs=0.51e-4)
    assert found.spans[0].horizontal == pytest.approx(pull, abs=0.51e-3)


@pytest.mark.parametrize(
    ("d", "soft", "middle", "stiff"),
    [
        (19.0, 4.1307, 3.5759, 2.7458),
        (15.0, 6.4006, 6.1556, 5.9004),
        (10.0, 8.2979, 8.1412, 7.9859),
        (5.0, 9.5858, 9.4551, 9.3269),
        (11.0, None, None, 7.645),
    ],
)
def test_slack_loops(d: float, soft: float | None, middle: float | None, stiff: float) -> None:
    for k, sag in ((100.0, soft), (200.0, middle), (1e4, stiff)):
        if sag is not None:
            found = static_shape(scene(20, k, 0.05, 1.0, end=(d, 0.0, 0.0)))
            assert found.sag[0] == pytest.approx(sag, abs=0.51e-4 if sag != 7.645 else 0.51e-3)


def test_hanging_chain() -> None:
    # Closed forms 2.1: extension of spring i from the top (N - i + 1) m g / k; tip at 1.020601.
    found = static_shape(scene(20, held=(0,)))
    i = np.arange(1, 21)
    np.testing.assert_allclose(found.tension, (20 - i + 1) * 0.01 * G, rtol=1e-13)
    np.testing.assert_allclose(found.positions[:, 0], 0.0, atol=0.0)
    assert found.positions[-1, 1] == pytest.approx(-1.020601, rel=1e-12)
    assert found.largest_tension == pytest.approx(1.962, rel=1e-12)
    assert found.spans[0].kind == "tail"
    assert found.sag == ()
    # With half a mass at the tip the total is the rod's, w L^2 / 2 EA: 1.01962.
    rod = Rope(
        segments=20,
        made_of=Material(EA=50.0, mass_per_length=0.2),
        length=1.0,
        shape=Straight(start=(0, 0, 0)),
    )
    half = static_shape(Scene(gravity=(0, -G, 0), ropes=(rod,), anchors=(Anchor(node=0),)))
    assert half.positions[-1, 1] == pytest.approx(-1.01962, rel=1e-12)
    # Held at its other end it hangs the other way round.
    turned = static_shape(scene(20, held=(-1,)))
    np.testing.assert_allclose(turned.tension, found.tension[::-1], rtol=1e-13)
    assert turned.reactions[0] == pytest.approx([0.0, 21 * 0.01 * G, 0.0])


def test_three_anchors_loads_and_tail_balance_in_any_direction_of_gravity() -> None:
    rng = np.random.default_rng(5)
    for _ in range(10):
        axis = rng.normal(size=3)
        source = scene(
            30,
            k=800.0,
            m=0.05,
            length=0.1,
            start=tuple(rng.normal(size=3)),
            end=tuple(rng.normal(size=3)),
            held=(3, 12, 24),
            gravity=tuple(G * axis / np.linalg.norm(axis)),
            loads=(Load(node=7, mass=2.0), Load(node=-1, mass=0.3)),
        )
        found = static_shape(source)
        assert [span.kind for span in found.spans] == ["tail", "span", "span", "tail"]
        assert imbalance(source, found) < 1e-9
        moved = found.positions.copy()
        moved[8] += 1e-5
        twin = Statics(moved, *[getattr(found, f) for f in list(found.__dataclass_fields__)[1:]])
        assert imbalance(source, twin) > 1e-4
        weight = build(source).state.mass.sum() * np.array(source.gravity)
        np.testing.assert_allclose(found.reactions.sum(axis=0), -weight, atol=1e-9)


def test_positions_do_not_depend_on_the_initial_shape() -> None:
    straight = static_shape(scene(12, end=(0.4, 0.0, 0.0)))
    bent = scene(12, end=(0.4, 0.0, 0.0))
    points = build(bent).state.x.T.copy()
    points[1:-1] += np.random.default_rng(0).normal(size=(11, 3)) * 0.1
    model = build(bent)
    model.state.x[...] = points.T
    np.testing.assert_allclose(static_shape(model).positions, straight.positions, atol=1e-15)


@pytest.mark.parametrize("rise", [-0.6, -0.05, 1e-3, 0.3, 0.9999, 1.3])
@pytest.mark.parametrize("segments", [19, 20])
def test_ends_on_one_vertical(rise: float, segments: int) -> None:
    source = scene(segments, length=1.0 / segments, end=(0.0, rise, 0.0), tension_only=True)
    found = static_shape(source)
    assert imbalance(source, found) < 1e-11
    assert found.spans[0].horizontal == 0.0
    np.testing.assert_allclose(found.positions[:, 0], 0.0, atol=1e-15)
    near = static_shape(
        scene(segments, length=1.0 / segments, end=(1e-7, rise, 0.0), tension_only=True)
    )
    np.testing.assert_allclose(near.positions, found.positions, atol=2e-6)


def test_a_slack_segment_between_two_plumb_lines_is_named() -> None:
    found = static_shape(scene(19, end=(0.01, 0.0, 0.0), tension_only=True))
    assert found.slack.sum() == 1
    assert found.slack[9]
    assert not static_shape(scene(20, end=(0.4, 0.0, 0.0))).slack.any()


def test_without_gravity() -> None:
    pulled = static_shape(scene(10, end=(0.6, 0.0, 0.0), gravity=(0, 0, 0)))
    np.testing.assert_allclose(pulled.tension, 1000.0 * 0.1 / 10, rtol=1e-12)
    loose = static_shape(scene(10, end=(0.4, 0.0, 0.0), gravity=(0, 0, 0)))
    assert loose.slack.all()
    assert loose.largest_tension == 0.0
    tail = static_shape(scene(10, held=(0,), gravity=(0, 0, 0)))
    assert tail.slack.all()
    np.testing.assert_allclose(tail.positions[:, 0], 0.05 * np.arange(11), atol=1e-15)


def test_one_segment_between_two_anchors_may_push() -> None:
    found = static_shape(scene(1, end=(0.04, 0.0, 0.0)))
    assert found.tension[0] == pytest.approx(-10.0)
    assert found.reactions[0] == pytest.approx([10.0, 0.01 * G, 0.0])
    assert static_shape(scene(1, end=(0.04, 0.0, 0.0), tension_only=True)).tension[0] == 0.0


def test_a_rope_that_nothing_holds_has_no_rest_shape() -> None:
    found = static_shape(scene(5, held=()))
    assert found.unheld == ("rope",)
    assert found.spans == ()
    assert found.largest_tension == 0.0


def test_elastic_catenary_of_irvine_is_the_limit_of_the_material() -> None:
    # Closed forms 2.4: L 1, w 1.962, EA 50, X 0.8: H 0.6300720579; error as 1/N^2.
    errors = []
    for n in (20, 40):
        rope = Rope(
            segments=n,
            made_of=Material(EA=50.0, mass_per_length=0.2),
            length=1.0,
            shape=Straight(start=(0, 0, 0), end=(0.8, 0, 0)),
        )
        held = (Anchor(node=0), Anchor(node=-1))
        found = static_shape(Scene(gravity=(0, -G, 0), ropes=(rope,), anchors=held))
        errors.append(abs(found.spans[0].horizontal - 0.6300720579))
    assert errors[0] < 1e-3
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.05)


def test_large_ropes_take_the_closed_form(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is right up to rounding; what is not right up to rounding is solved as ever."""
    made_of = Material(EA=1e5, mass_per_length=0.1)
    shape = Slack(start=(0, 0, 0), end=(8, 0, 1))
    rope = Rope(segments=400, length=10.0, made_of=made_of, shape=shape)
    scene = Scene(ropes=rope, anchors=[Anchor(node=0), Anchor(node=-1)])
    solved = static_shape(scene)
    real = rest.hung
    monkeypatch.setattr(rest, "_LARGE", 100)
    taken = static_shape(scene)
    assert taken.solved
    assert taken.steps == 0
    np.testing.assert_allclose(taken.positions, solved.positions, atol=1e-9)
    np.testing.assert_allclose(taken.tension, solved.tension, rtol=1e-9)

    def off(model: object) -> tuple[np.ndarray, np.ndarray]:
        x, tension = real(model)
        return x, tension * (1.0 + 1e-6)

    monkeypatch.setattr(rest, "hung", off)
    found = static_shape(scene)
    assert found.steps > 0
    np.testing.assert_allclose(found.tension, solved.tension, rtol=1e-9)


@pytest.mark.parametrize("segments", [5_000, 200_000])
def test_what_rounding_leaves_of_many_segments_counts_as_rest(segments: int) -> None:
    """Newton's method went on for all its 2000 steps, and found no rest: minutes in `check`.

    The closing of the chain is spread; what rounding of places makes of the tensions' directions stays.
    """
    rope = Rope(
        segments=segments,
        length=100.0,
        made_of=Material(EA=1e4, mass_per_length=0.1),
        shape=Slack(end=(80, 0, 0)),
    )
    found = static_shape(Scene(ropes=rope, anchors=[Anchor(node=0), Anchor(node=-1)]))
    assert found.solved
    assert found.steps < 20
    coarse = rope.replace(segments=500)
    few = static_shape(Scene(ropes=coarse, anchors=[Anchor(node=0), Anchor(node=-1)]))
    assert found.sag[0] == pytest.approx(few.sag[0], rel=1e-4)
    # The last segment alone bore what all additions round off: 80 times as much.
    size = np.linalg.norm(np.diff(found.positions, axis=0), axis=1)
    assert found.gap < 1e-15 * 100.0
    assert np.ptp(size) < 0.01 * size.mean()


def test_a_check_does_not_look_for_the_rest_of_very_many_nodes_on_the_ground(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(rest, "_LARGE", 100)
    rope = Rope(
        segments=200,
        length=10.0,
        made_of=Material(EA=1e4, mass_per_length=0.1),
        shape=Slack(end=(8, 0, 0)),
    )
    held = [Anchor(node=0), Anchor(node=-1)]
    on_ground = Scene(ropes=rope, anchors=held, ground=Ground(height=-1.0, repulsion=100.0))
    assert static_shape(on_ground).steps > 0
    found = check(on_ground, measure=False)
    assert not found.statics.solved
    assert "the shape of rest was not looked for" in str(found)
    assert "weight alone" not in str(check(Scene(ropes=rope, anchors=held), measure=False))


@pytest.mark.parametrize("wind", [0.0, 1.0])
def test_a_sag_is_told_from_the_ends_where_the_line_between_them_is_nearly_upright(
    wind: float,
) -> None:
    """What lies beside ends one above the other: the line, drawn on sideways, would come from far off.

    In still air the lowest node is a quarter of a metre below the lower end, up to a segment of 75 mm.
    """
    wire = Material(EA=1e4, mass_per_length=0.1)
    rope = Rope(segments=20, length=1.5, made_of=wire, shape=Slack(end=(0.01, 0.0, -1.0)))
    held = [Anchor(node=0), Anchor(node=-1)]
    air = Air(node_drag=0.1, wind=(wind, 0.0, 0.0))
    (span,) = static_shape(Scene(ropes=rope, anchors=held, air=air)).spans
    assert 0.0 <= span.rise < 1.0
    assert 0.0 < span.sag < 1.25
    if not wind:
        assert span.sag > 1.25 - 0.075


@pytest.mark.parametrize("offset", [0.0, 1e-10, 1e-7])
@pytest.mark.parametrize("height", [5.0, -5.0])
def test_a_plumb_span_sags_below_its_lower_end_and_rises_above_its_higher_one(
    offset: float, height: float
) -> None:
    """It was told to rise by its whole height; a loop that hangs 1.5 m low rose 2 m."""
    wire = Material(EA=1e6, mass_per_length=0.1)

    def span_of(length: float, gravity: float) -> RestSpan:
        drawn = Straight(end=(offset, 0.0, height))
        rope = Rope(segments=80, length=length, made_of=wire, shape=drawn)
        held = [Anchor(node=0), Anchor(node=-1)]
        source = Scene(ropes=[rope], anchors=held, gravity=(0.0, 0.0, gravity))
        (span,) = static_shape(source).spans
        return span

    for gravity in (-G, G):
        taut = span_of(5.0, gravity)
        assert max(taut.sag, taut.rise) < 1e-4
        loop = span_of(8.0, gravity)  # 1.5 m beyond the end, down or up
        assert loop.sag == pytest.approx(1.5, abs=0.11)
        assert loop.rise < 1e-4


def test_a_tail_on_the_ground_does_not_hang_free() -> None:
    """2 m of 6 hang, and 4 lie: it was told to hang free, 4.473 m long, which its ends are apart."""
    wire = Material(EA=1e6, mass_per_length=0.1)
    rope = Rope(segments=12, length=6.0, made_of=wire, shape=Straight(end=(6.0, 0.0, 0.0)))
    low = Scene(ropes=[rope], anchors=[Anchor(node=0)], ground=Ground(height=-2.0, repulsion=1e4))
    (lies,) = static_shape(low).spans
    assert lies.words.startswith("nodes 0 to 12 hang or lie, 6 m of rope, its tip 4.")
    assert "hang free" not in str(lies)
    (hangs,) = static_shape(low.replace(ground=None)).spans
    assert hangs.words == "nodes 0 to 12 hang free, 6 m long"
