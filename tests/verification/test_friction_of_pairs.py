"""The larger of two coefficients of friction holds, and what is said of a pair holds instead."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from live.drive import do
from ropewalk.live import edits
from ropewalk.live.session import Session
from ropewalk.lowering.layout import make_layout
from ropewalk.plots.contact_forces import coils
from ropewalk.scene import Contact, Points, RunSettings, SceneError, Straight
from ropewalk.sheets.frictions import friction_on
from ropewalk.statics import static_shape

g = 9.81  # [m/s^2], as scenes have it
SLOPE = math.radians(20.0)
DOWN = np.array([math.cos(SLOPE), 0.0, -math.sin(SLOPE)])
UP = np.array([math.sin(SLOPE), 0.0, math.cos(SLOPE)])


def material() -> rw.Material:
    return rw.Material(EA=1e4, mass_per_length=0.1)


def lying(name: str, aside: float, **more: float) -> rw.Rope:
    """A straight rope of 0.3 m that lies down the slope."""
    points = [tuple(s * DOWN + [0.0, aside, 0.0]) for s in np.linspace(0.0, 0.3, 4)]
    shape = Points(points=points)
    return rw.Rope(name=name, segments=3, length=0.3, made_of=material(), shape=shape, **more)


def on_a_slope(method: str) -> rw.Scene:
    """Four ropes on one plane whose own coefficient is 0.1."""
    plane = {
        "kind": "plane",
        "normal": UP.tolist(),
        "friction": 0.1,
        "pair": [{"rope": "greased", "friction": 0.0}, {"rope": "tarred", "friction": 0.9}],
    }
    ropes = [
        lying("plain", 0.0),
        lying("rough", 1.0, friction=0.5),
        lying("smooth", 2.0, friction=0.05),
        lying("greased", 3.0, friction=0.5),
        lying("tarred", 4.0),
    ]
    run = RunSettings(duration=0.5, frame_rate=60.0, time_step=1.0 / 60.0, method=method)
    return rw.Scene(ropes=ropes, obstacles=[plane], run=run)


def accelerations(result: rw.Result) -> dict[str, float]:
    """How fast every rope gets faster down the slope in the last 0.25 s [m/s^2]."""
    late = result.time >= 0.25
    found = {}
    for span in result.layout.ropes:
        along = (result.velocities[late, span.start : span.end + 1] @ DOWN).mean(axis=1)
        found[span.name] = float(np.polyfit(result.time[late], along, 1)[0])
    return found


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3"])
def test_ropes_on_one_slope_slide_as_rough_as_each_is(method: str) -> None:
    """a = g (sin - mu cos), mu = 0.1 of the plane, 0 of the pair; 0.5 and 0.9 hold at 20 degrees."""
    found = accelerations(rw.simulate(on_a_slope(method)))
    slides = {name: g * (math.sin(SLOPE) - mu * math.cos(SLOPE)) for name, mu in
              {"plain": 0.1, "smooth": 0.1, "greased": 0.0}.items()}  # fmt: skip
    for name, expected in slides.items():
        assert found[name] == pytest.approx(expected, rel=1e-3), name
    for name in ("rough", "tarred"):
        assert abs(found[name]) < 1e-6, name


def bars(*pairs: dict[str, object]) -> rw.Scene:
    """Two bars across two rails that cannot move; 0.1 of ropes on each other, and 0.5 of one bar's own."""
    ropes, anchors = [], []
    for k, y in enumerate((-0.1, 0.1)):
        points = [tuple(np.array([0.0, y, 0.0]) + s * DOWN) for s in (-0.5, 2.5)]
        shape = Points(points=points)
        ropes.append(rw.Rope(name=f"rail{k}", segments=1, length=3.0, diameter=0.01,
                             made_of=material(), shape=shape))  # fmt: skip
        anchors += [rw.Anchor(rope=f"rail{k}", node=node) for node in (0, 1)]
    for name, along, own in (("plain", 0.0, 0.0), ("rough", 0.6, 0.5)):
        ends = [tuple(np.array([0.0, y, 0.0]) + along * DOWN + 0.00999 * UP) for y in (-0.15, 0.15)]
        shape = Straight(start=ends[0], end=ends[1])
        ropes.append(rw.Rope(name=name, segments=1, length=0.3, diameter=0.01, friction=own,
                             made_of=material(), shape=shape))  # fmt: skip
    run = RunSettings(duration=0.5, frame_rate=60.0, time_step=1.0 / 60.0, method="esdirk3")
    contact = Contact(friction=0.1, pairs=pairs)
    return rw.Scene(ropes=ropes, anchors=anchors, contact=contact, run=run)


def test_bars_on_rails_slide_as_rough_as_each_is() -> None:
    found = accelerations(rw.simulate(bars()))
    expected = g * (math.sin(SLOPE) - 0.1 * math.cos(SLOPE))
    assert found["plain"] == pytest.approx(expected, rel=2e-3)
    assert abs(found["rough"]) < 1e-5


def test_what_is_said_of_a_pair_of_ropes_holds_instead() -> None:
    swapped = [
        {"rope": rail, "other": bar, "friction": mu}
        for rail in ("rail0", "rail1")
        for bar, mu in (("plain", 0.9), ("rough", 0.0))
    ]
    result = rw.simulate(bars(*swapped))
    found = accelerations(result)
    assert abs(found["plain"]) < 1e-5
    assert found["rough"] == pytest.approx(g * math.sin(SLOPE), rel=2e-3)


def test_tables_of_contacts_tell_of_what_friction_can_carry_by_pair() -> None:
    """What is used is the friction over mu R_n; what slides uses all, and without friction there is none."""
    result = rw.simulate(on_a_slope("implicit-euler"))
    table = result.to_pandas("contacts")
    last = table[table["time [s]"] == table["time [s]"].max()].groupby("rope")
    used, rubs = last["friction used [1]"], last["friction force [N]"]
    for name, mu in (("rough", 0.5), ("tarred", 0.9), ("plain", 0.1), ("smooth", 0.1)):
        could = mu * last["normal force [N]"].get_group(name)
        found = rubs.get_group(name) / could
        assert used.get_group(name).to_numpy() == pytest.approx(found.to_numpy(), rel=1e-9)
    assert used.get_group("plain").min() > 0.999
    weight = 0.3 * 0.1 * g
    assert rubs.get_group("rough").sum() == pytest.approx(weight * math.sin(SLOPE), rel=1e-4)
    assert rubs.get_group("greased").max() == 0.0


def test_pieces_of_a_cut_rope_are_as_rough_as_it_was() -> None:
    """On an obstacle, on other ropes, and on each other."""
    session = Session(on_a_slope("esdirk3"))
    assert do(session, "cut", segment=13) == ""  # the middle one of "greased"
    pieces = [rope for rope in session.scene.ropes if rope.name.startswith("greased")]
    assert len(pieces) == 2
    assert [session.scene.obstacles[0].friction_with(rope) for rope in pieces] == [0.0, 0.0]
    own = {"rope": "plain", "other": "plain", "friction": 0.7}
    scene = bars({"rope": "rail0", "other": "plain", "friction": 0.3}, own)
    long = scene.ropes[2].replace(segments=3)
    scene = scene.replace(ropes=[*scene.ropes[:2], long, scene.ropes[3]])
    made = edits.cut(scene, make_layout(scene), 5).scene
    assert made.contact is not None
    place = {rope.name: number for number, rope in enumerate(made.ropes)}
    table = made.contact.frictions(made.ropes)
    first, second = place["plain-1"], place["plain-2"]
    assert table[first, place["rail0"]] == table[second, place["rail0"]] == 0.3
    assert table[first, second] == table[first, first] == 0.7
    assert table[first, place["rough"]] == 0.5


def test_scenes_keep_pairs() -> None:
    scene = on_a_slope("esdirk3")
    assert rw.loads(rw.dumps(scene)) == scene
    other = bars({"rope": "plain", "other": "rough", "friction": 0.3})
    assert rw.loads(rw.dumps(other)) == other


@pytest.mark.parametrize(
    ("obstacle", "contact", "told"),
    [
        ([{"rope": "twin", "friction": 0.1}], [], "obstacle[0].pair[0].rope: \"twin\""),
        ([{"rope": "main", "friction": -0.1}], [], "obstacle[0].pair[0].friction: -0.1"),
        ([{"rope": "main", "friction": 0.1}] * 2, [], "is told by obstacle[0].pair[0] already"),
        ([], [{"rope": "main", "other": "twin", "friction": 0.1}], "contact.pair[0].other: \"twin\""),
    ],
)  # fmt: skip
def test_pairs_that_mean_nothing_are_refused(
    obstacle: list[object], contact: list[object], told: str
) -> None:
    parts = {
        "rope": [{"name": "main", "segments": 3, "length": 1.0, "diameter": 0.01,
                  "made_of": {"kind": "material", "EA": 1e3, "mass_per_length": 0.1}}],
        "obstacle": [{"kind": "plane", "pair": obstacle}],
        "contact": {"pair": contact},
    }  # fmt: skip
    with pytest.raises(SceneError) as raised:
        rw.Scene.model_validate(parts)
    assert told in str(raised.value)


def test_wraps_figures_and_sheets_tell_the_coefficient_of_the_pair() -> None:
    """A bar of 0.1 under ropes of 0.1 and 0.3, and one whose pair has 0.5."""
    own = {"length": 1.0, "diameter": 0.01, "made_of": rw.Material(EA=1e4, mass_per_length=0.1)}
    angles, reach = np.linspace(0.0, math.pi, 9), 0.055
    ropes = []
    for k, (name, mu) in enumerate((("smooth", 0.0), ("rough", 0.3), ("tarred", 0.3))):
        over = np.stack([reach * np.cos(angles), 0.0 * angles, reach * np.sin(angles)], axis=1)
        chord = float(np.linalg.norm(over[1] - over[0]))
        down = np.array([0.0, 0.0, -chord])
        places = [*(over[0] + i * down for i in (4, 3, 2, 1)), *over,
                  *(over[-1] + i * down for i in (1, 2, 3, 4))]  # fmt: skip
        aside = np.array([0.0, 0.1 * k, 0.0])
        points = [tuple(map(float, place + aside)) for place in places]
        length = chord * (len(points) - 1)
        rope = {**own, "name": name, "segments": len(points) - 1, "length": length}
        ropes.append(rw.Rope(**rope, friction=mu, shape=Points(points=points)))
    bar = {"kind": "cylinder", "name": "bar", "from": [0, -1, 0], "to": [0, 1, 0], "radius": 0.05,
           "friction": 0.1, "pair": [{"rope": "tarred", "friction": 0.5}]}  # fmt: skip
    run = RunSettings(duration=0.1, frame_rate=60.0, time_step=1.0 / 240.0, method="implicit-euler")
    scene = rw.Scene(ropes=ropes, obstacles=[bar], run=run)
    result = rw.simulate(scene)
    expected = {"smooth": 0.1, "rough": 0.3, "tarred": 0.5}
    assert {one.rope: one.friction for one in coils(result, result.frames - 1)} == expected
    table = result.to_pandas("wraps")
    for _, row in table.iterrows():
        angle = row[next(name for name in table if name.startswith("angle"))]
        slips = row[next(name for name in table if "at slip" in name)]
        assert slips == pytest.approx(math.exp(expected[row["rope"]] * angle), rel=1e-9)
    assert set(table["rope"]) == set(expected)
    rested = static_shape(rw.Simulation(scene).model, strict=False)
    assert {one.rope: one.friction for one in rested.wraps} == expected
    words = friction_on(scene.obstacles[0], scene.ropes)
    assert words == (
        "coefficients of friction of 0.1 (rope 'smooth'), 0.3 (rope 'rough') and 0.5 (rope 'tarred')"
    )


def test_contacts_of_ropes_tell_what_friction_can_carry_by_pair() -> None:
    result = rw.simulate(bars())
    table = result.to_pandas("rope_contacts")
    last = table[table["time [s]"] == table["time [s]"].max()]
    for name, mu in (("plain", 0.1), ("rough", 0.5)):
        rows = last[(last["rope"] == name) | (last["other rope"] == name)]
        assert len(rows) == 2
        found = rows["friction force [N]"] / (mu * rows["normal force [N]"])
        assert rows["friction used [1]"].to_numpy() == pytest.approx(found.to_numpy(), rel=1e-9)
    assert {round(mu, 9) for mu in np.unique(bars().contact.frictions(bars().ropes))} == {0.1, 0.5}
