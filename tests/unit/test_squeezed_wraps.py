"""Wraps on which another obstacle presses from another side."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk import plots
from ropewalk.plots.contact_forces import coils, pressing
from ropewalk.record.contacts import each_frame
from ropewalk.record.result import Result
from ropewalk.scene import Anchor, Cylinder, Load, Material, Plane, Rope, Scene, Sphere, Velocity
from ropewalk.statics import static_shape
from ropewalk.statics.wraps import Wrap, sliding_words

D, R = 0.01, 0.05  # of the rope and the drum [m]
LEG = 12


def over_a_drum(*others: object, masses: tuple[float, float] = (2.0, 2.0)) -> Scene:
    """A rope half round a drum, a load at each end."""
    r, count = R + 0.5 * D, 24
    step = math.pi * r / count
    arc = [(-r * math.cos(k * step / r), r * math.sin(k * step / r)) for k in range(count + 1)]
    down = [k * step for k in range(1, LEG + 1)]
    points = [(-r, -z) for z in reversed(down)] + arc + [(r, -z) for z in down]
    chords = np.linalg.norm(np.diff(np.array(points), axis=0), axis=1)
    rope = Rope(
        segments=len(points) - 1,
        length=float(chords.sum()),
        diameter=D,
        made_of=Material(EA=1e5, mass_per_length=0.05, axial_damping=50.0),
        shape={"kind": "points", "points": [(x, 0.0, z) for x, z in points]},
        loads=[Load(node=0, mass=masses[0]), Load(node=-1, mass=masses[1])],
    )
    drum = Cylinder(name="drum", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=R, friction=0.3)
    run = {"method": "implicit-euler", "time_step": 0.005, "duration": 1.5, "frame_rate": 20.0}
    return Scene(ropes=[rope], obstacles=[drum, *others], run=run)


def keeper(gap: float, by: float = 0.0, lean: float = 0.0) -> Cylinder:
    """A bar above the drum that leaves a gap [m] and comes down `by` [m] in a second, aside by an angle."""
    away = R + gap + 0.02
    x, z = away * math.sin(lean), away * math.cos(lean)
    down = (
        {"motion": Velocity(velocity=(-by * x / away, 0, -by * z / away), stop=1.0)} if by else {}
    )
    ends = {"start": (x, -0.1, z), "end": (x, 0.1, z)}
    return Cylinder(name="keeper", radius=0.02, friction=0.3, **down, **ends)


@pytest.fixture(scope="module")
def kept() -> Result:
    """A keeper that comes down to a gap of 9.6 mm."""
    return rw.simulate(over_a_drum(keeper(0.012, by=0.0024)))


def test_a_figure_shows_what_two_obstacles_press_at_one_node(kept: Result) -> None:
    """7.3 kN each: it showed the size of their sum, 2.6 N, in scenes without contact of ropes."""
    last = kept.frames - 1
    ((_, contacts),) = each_frame(kept, [last])
    both = [contacts.push[contacts.obstacle == o].max() for o in (0, 1)]
    assert min(both) > 1e3
    assert pressing(kept, last).max() == pytest.approx(sum(both), rel=1e-3)
    figure = plots.contact(kept)
    assert figure.axes[0].lines[0].get_ydata().max() == pytest.approx(sum(both), rel=1e-3)
    assert len(figure.axes[0].lines) == 2  # dotted: the sum
    notes = " ".join(" ".join(text.get_text().split()) for text in figure.texts)
    assert "tension ratio 1; keeper presses on it, too: where it slips is not known" in notes
    assert "slips at 2." not in notes
    assert [line for line in figure.axes[1].lines if line.get_label() == "_held"] == []


def test_no_ratio_at_slip_where_a_keeper_presses(kept: Result) -> None:
    """It was that of the drum alone, 2.505, though 150 N more on one side moved nothing."""
    table = kept.to_pandas("wraps")
    table = table.set_index(["time [s]", "obstacle"])["ratio at slip [1]"]
    assert table[0.0, "drum"] == pytest.approx(math.exp(0.3 * math.pi), rel=0.01)
    assert table.loc[kept.time[-1]].isna().to_dict() == {"drum": True, "keeper": True}


@pytest.mark.parametrize(("lean", "gap", "presses"), [(0.4, 0.0096, True), (0.4, 0.0112, False)])
def test_a_keeper_that_leans_or_is_clear(lean: float, gap: float, presses: bool) -> None:
    result = rw.simulate(over_a_drum(keeper(0.012, by=0.012 - gap, lean=lean)))
    (coil,) = (one for one in coils(result, result.frames - 1) if one.obstacle == "drum")
    assert coil.pressed == (("keeper",) if presses else ())
    assert (coil.held is None) is presses


@pytest.mark.parametrize("turns", [True, False])
def test_steep_sides_of_a_groove_are_told_as_before(turns: bool) -> None:
    """They face each other, and what holds over them together is known: of balls over which a rope is bent.

    In a groove from which it is bent away its load presses it, and without that it has no friction.
    """
    wide, apex, fall = 0.052, 0.0195 if turns else 0.0182, 0.07 if turns else -0.0318
    places = [("left", -wide), ("right", wide)]
    if turns:
        sides = [Sphere(name=n, center=(0, y, 0), radius=R, friction=0.2) for n, y in places]
    else:
        sides = [
            Cylinder(name=n, start=(-0.3, y, 0), end=(0.3, y, 0), radius=R, friction=0.2)
            for n, y in places
        ]
    points = [(-0.2, 0.0, apex - fall), (0.0, 0.0, apex), (0.2, 0.0, apex - fall)]
    rope = Rope(
        segments=20,
        length=(0.99 if turns else 1.0) * 2.0 * math.hypot(0.2, fall),
        diameter=D,
        made_of=Material(EA=1e5, mass_per_length=0.05, axial_damping=50.0),
        shape={"kind": "polyline", "points": points},
        loads=[Load(node=10, mass=2.0)],
    )
    run = {"method": "implicit-euler", "time_step": 0.005, "duration": 1.0, "frame_rate": 20.0}
    anchors = [Anchor(node=0), Anchor(node=-1)]
    result = rw.simulate(Scene(ropes=[rope], obstacles=sides, anchors=anchors, run=run))
    ((_, contacts),) = each_frame(result, [result.frames - 1])
    rows = np.flatnonzero(contacts.obstacle == 0)
    first = np.flatnonzero(contacts.node == contacts.node[rows[0]])
    assert contacts.normal[first[0]] @ contacts.normal[first[1]] < -0.5
    assert (contacts.turn[first] > 0.0).tolist() == [turns, turns]
    assert contacts.pressed_by(rows) == []
    table = result.to_pandas("wraps")
    assert table["ratio at slip [1]"].notna().all()


def test_words_of_no_rest_tell_of_drums_only_where_a_rope_turns() -> None:
    """Of a plain ramp "and round a drum by a factor" was told."""
    slope = 0.3
    along = np.array([math.cos(slope), 0.0, math.sin(slope)])
    up = np.array([-math.sin(slope), 0.0, math.cos(slope)])
    start, end = 0.006 * up, 0.006 * up + 0.4 * along
    rope = Rope(
        segments=20,
        length=0.4,
        diameter=D,
        made_of=Material(EA=1e5, mass_per_length=0.08, axial_damping=10.0),
        shape={"kind": "straight", "start": start.tolist(), "end": end.tolist()},
    )
    ramp = Plane(name="ramp", normal=up.tolist(), friction=0.2)
    run = {"method": "implicit-euler", "time_step": 0.0025, "duration": 1.0, "frame_rate": 50.0}
    with pytest.raises(rw.NoRest) as said:
        static_shape(Scene(ropes=[rope], obstacles=[ramp], run=run))
    words = str(said.value)
    assert "it holds on slopes of up to atan(friction) = 11.31 degrees" in words
    assert "drum" not in words
    turns = Wrap(
        rope="rope",
        obstacle="drum",
        first=3,
        last=9,
        force=1.0,
        angle=0.5,
        before=1.0,
        after=2.0,
        least=math.nan,
        most=math.nan,
        backward=False,
        use=1.0,
        friction=0.2,
        slope=0.5,
    )
    assert "and round a drum by a factor of up to exp(friction angle)" in sliding_words((turns,))
