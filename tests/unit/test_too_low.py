"""Rows of forces that steps or frames do not show say so, each on its own, whatever comes after."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.extremes import extremes
from ropewalk.record.landings import landings_of
from ropewalk.record.note_kinds import kinds
from ropewalk.record.peak_energy import _told
from ropewalk.record.too_low import anchor_too_low
from ropewalk.scene import (
    Anchor,
    Cylinder,
    Hanging,
    Load,
    Material,
    Plane,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Straight,
    Velocity,
)

FLOOR, HAND = "about the largest force on an obstacle", "about the largest anchor force"
ENERGY, PULL = "about the energy", "about the largest tension"


def pile(**run: Any) -> rw.Result:
    """The preset in which a cord's end comes down at 0.3 m/s, and no more of it unless asked for."""
    return rw.simulate(rw.preset("pile").replace(**{"run.duration": 0.1} | run))


def test_what_a_landing_gives_at_least_is_told_of_floor_and_hand() -> None:
    """Steps of 4 ms had 0.41 and 0.17 N. The twin: steps and frames that show it, and more than was told."""
    coarse = pile().table
    least = {
        row: float(re.findall(r"too low: it was ([\d.]+) N at least", coarse[row])[0])
        for row in (FLOOR, HAND)
    }
    assert "1.47 N where nothing gives" in coarse[FLOOR]
    assert "may be far too low" in coarse[PULL]
    fine = pile(**{"run.time_step": 1 / 7680, "run.frame_rate": 7680}).table
    force = {
        FLOOR: fine["largest force on an obstacle [N]"],
        HAND: fine["largest anchor force [N]"],
    }
    for row, told in least.items():
        assert coarse[row.removeprefix("about the ") + " [N]"] < 0.9 * told < 0.9 * force[row]
        assert "too low: it was" not in fine.get(row, "")


def test_frames_that_are_too_far_apart_for_a_hit_say_so() -> None:
    """Steps show 4 N of it, frames 0.17 N, where these alone are kept. The twin: steps are kept, too."""
    table = pile(**{"run.time_step": 1 / 3840, "run.extremes": False}).table
    assert "between two frames there may be far more" in table[FLOOR]
    assert table["largest force on an obstacle [N]"] < 0.5
    every = pile(**{"run.time_step": 1 / 3840}).table
    assert every["largest anchor force [N]"] > 4.0
    assert every["largest force on an obstacle [N]"] > 1.47
    assert "between two frames" not in every.get(FLOOR, "")


def test_a_landing_of_a_rope_that_cannot_push_is_none() -> None:
    """No wave of compression runs up it. The twin: the same cord, which pushes."""
    assert landings_of(pile())
    cord = rw.Material(EA=1e3, mass_per_length=0.025, axial_damping=0.05, tension_only=True)
    scene = rw.preset("pile").replace(**{"run.duration": 0.1, "rope.made_of": cord})
    slack = rw.simulate(scene)
    assert not landings_of(slack)


@pytest.mark.parametrize(("time", "bears"), [(0.01, False), (0.09, True)])
def test_a_hand_that_has_let_go_bears_nothing_of_a_landing(time: float, bears: bool) -> None:
    """The end lands after 0.029 s. The twin lets go later."""
    hand = rw.preset("pile").anchors[0].model_copy(update={"release_time": time})
    table = pile(anchors=(hand,)).table
    assert ("too low: it was" in table.get(HAND, "")) == bears
    assert "too low: it was" in table[FLOOR]


def test_a_harder_landing_of_a_free_rope_does_not_hide_that_of_a_held_one() -> None:
    result = pile()
    (held,), found = landings_of(result), extremes(result)
    free = held._replace(force=10.0 * held.force, held=0.0)
    force, tension = found["greatest anchor force"], found["greatest tension"]
    assert anchor_too_low(result, force, tension, (held, free))[0] == "landing not shown"


def test_ends_of_many_ropes_are_read_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The force of all nodes was read for every end."""
    reads = []
    read = rw.Result.read
    monkeypatch.setattr(rw.Result, "read", lambda *args: reads.append(args[1]) or read(*args))
    for count in (1, 6):
        made_of = Material(EA=1e4, mass_per_length=0.1)
        ropes = tuple(
            Rope(
                name=f"r{k}",
                segments=2,
                length=0.1,
                diameter=0.01,
                made_of=made_of,
                shape=Straight(start=(0, 0.1 * k, 0.05), direction=(1, 0, 0)),
            )
            for k in range(count)
        )
        run = RunSettings(duration=0.2, method="implicit-euler", time_step=0.01)
        scene = Scene(ropes=ropes, obstacles=(Plane(name="floor"),), run=run)
        result = rw.simulate(scene)
        reads.clear()
        landings_of(result)
        assert 0 < len(reads) <= 4  # with the times


def test_what_a_shape_presses_at_first_is_what_was_there_before() -> None:
    """1.32 N as drawn, 0.98 N a frame later: that was told as a jerk from nothing."""
    rope = Rope(
        segments=10,
        length=1.0,
        diameter=0.01,
        made_of=Material(EA=1e5, mass_per_length=0.1),
        shape=Straight(start=(0, 0, 0.00495), direction=(1, 0, 0)),
    )
    run = RunSettings(duration=0.008, frame_rate=250, method="implicit-euler", time_step=0.002)
    table = rw.simulate(Scene(ropes=(rope,), obstacles=(Plane(name="floor"),), run=run)).table
    assert table["largest force on an obstacle [N]"] > 0.9
    assert FLOOR not in table


def beside(gap: float) -> rw.Result:
    """A rope that lies on a floor, and one that an anchor pulls at then, above it or on it, too."""
    made_of = Material(EA=1e5, mass_per_length=0.1)
    shapes = (Straight(start=(0, y, z), direction=(1, 0, 0)) for y, z in ((0, 0.004963), (1, gap)))
    ropes = tuple(
        Rope(name=name, segments=10, length=1.0, diameter=0.01, made_of=made_of, shape=shape)
        for name, shape in zip(("lies", "pulled"), shapes, strict=True)
    )
    pull = Velocity(velocity=(0.5, 0, 0), start=0.004, stop=0.008)
    anchors = (Anchor(rope="pulled", node=0), Anchor(rope="pulled", node=-1, motion=pull))
    run = RunSettings(duration=0.02, frame_rate=250, method="implicit-euler", time_step=0.002)
    scene = Scene(ropes=ropes, anchors=anchors, obstacles=(Plane(name="floor"),), run=run)
    return rw.simulate(scene)


@pytest.mark.parametrize(("gap", "there"), [(1.0, False), (0.004963, True)])
def test_a_peak_of_a_rope_that_does_not_press_says_nothing_of_an_obstacle(
    gap: float, there: bool
) -> None:
    table = beside(gap).table
    assert PULL in table
    assert ("see the largest tension" in table.get(FLOOR, "")) == there


def test_a_peak_of_another_time_says_nothing_of_a_force() -> None:
    """The jerk of 0.18 s was told of a force of another time. The twin: of the same, as on the stairs."""
    table = rw.simulate(rw.preset("stairs").replace(**{"run.duration": 0.5})).table
    assert "a jerk" in table[PULL]
    assert "see the largest tension, of about the same time" in table[FLOOR]
    result = beside(1.0)
    force, tension = (
        extremes(result)[one] for one in ("greatest anchor force", "greatest tension")
    )
    assert anchor_too_low(result, force._replace(until=tension.until), tension, ())[1]
    assert not anchor_too_low(result, force._replace(until=0.0), tension, ())[1]


def test_rounding_is_no_hit_and_no_jerk() -> None:
    """Of 3e-22 J, 1e-15 N and 9e-8 N, a strain of 2e-11, where nothing moves. The twins are above."""
    still = {"gravity": (0, 0, 0), "run.duration": 0.5}
    table = rw.simulate(rw.preset("stairs").replace(**still)).table
    assert not {ENERGY, PULL, FLOOR} & set(table)


def test_a_hit_that_a_long_run_makes_small_is_told_all_the_same() -> None:
    """4.5 % of all that it turns over, and 80 % of what there was then."""
    table = rw.simulate(rw.preset("pile")).table
    assert table["largest energy error, share of the energy turned over [%]"] < 5.0
    assert "J of it came within one frame, before t = 0.0333333 s" in table[ENERGY]


@pytest.mark.parametrize("name", ["r3", "r8", "wave-on-a-string"])
def test_smooth_runs_tell_no_hit(name: str) -> None:
    scene = rw.preset(name)
    for method in (scene.run.method, "implicit-euler"):
        run = {"run.duration": min(scene.run.duration, 1.0), "run.method": method}
        table = rw.simulate(scene.replace(**run)).table
        assert "came within one frame" not in table.get(ENERGY, "")
        assert ("see the largest tension" in table.get(HAND, "")) <= (PULL in table)


def test_a_peak_that_lost_energy_does_not_hide_the_weight_at_an_end() -> None:
    made_of = Material(EA=1e3, mass_per_length=0.5)
    shape = Straight(start=(0, 0, 0), direction=(0, 0, -1))
    rope = Rope(segments=5, length=3.0, diameter=0.01, made_of=made_of, shape=shape)
    run = RunSettings(duration=0.5, method="implicit-euler", time_step=0.02)
    result = rw.simulate(Scene(ropes=(rope,), anchors=(Anchor(node=0),), run=run))
    assert "half a segment's weight more" in result.table[PULL]
    assert "J until then" in result.table[PULL]
    assert {"peak may be too low", "end weight"} <= set(kinds(result))


@pytest.mark.parametrize("joined", [False, True])
def test_what_another_rope_lost_is_no_share_of_a_peak(joined: bool) -> None:
    """A rope that is drawn a centimetre had 335 N, as it should: 19 to 42 % too low, for one that swung."""
    made_of = Material(EA=1e5, mass_per_length=0.1)
    shapes = {
        "swings": Straight(start=(0, 0, 0), direction=(1, 0, 0)),
        "held": Straight(start=(0, 0 if joined else 5, 0), direction=(0, 0, -1)),
    }
    ropes = tuple(
        Rope(name=name, segments=10, length=3.0, diameter=0.01, made_of=made_of, shape=shape)
        for name, shape in shapes.items()
    )
    draw = Velocity(velocity=(0, 0, -0.01), start=1.0, stop=2.0)
    anchors = (Anchor(rope="held", node=0), Anchor(rope="held", node=-1, motion=draw))
    points = tuple({"rope": name, "node": 0} for name in shapes)
    more: dict[str, Any] = (
        {"joints": ({"points": points},)}
        if joined
        else {"anchors": (*anchors, Anchor(rope="swings", node=0))}
    )
    run = RunSettings(duration=2.0, method="implicit-euler", time_step=0.01)
    table = rw.simulate(Scene(**{"ropes": ropes, "anchors": anchors, "run": run} | more)).table
    assert ("what other ropes lost" in table[PULL]) != joined
    assert ("if that belongs in it" in table[PULL]) == joined


def hung(name: str, y: float, **made_of: Any) -> Rope:
    """A rope that hangs down, drawn at its length."""
    stuff = Material(mass_per_length=0.5, **made_of)
    shape = Straight(start=(0, y, 0), direction=(0, 0, -1))
    return Rope(name=name, segments=5, length=3.0, made_of=stuff, shape=shape)


def dropping(*others: Rope, **more: Any) -> Scene:
    """A soft rope that drops into its own stretch, held at its top as all others are."""
    ropes = (hung("drops", 0, EA=1e3), *others)
    held = tuple(Anchor(rope=rope.name, node=0) for rope in ropes)
    taut = tuple(Anchor(rope=rope.name, node=-1) for rope in ropes if rope.name == "soft")
    run = RunSettings(duration=0.5, method="implicit-euler", time_step=0.02)
    return Scene(**{"ropes": ropes, "anchors": held + taut, "run": run} | more)


#: 1 kJ in a rope that lies stretched.
SOFT = Rope(
    name="soft", segments=2, length=100.0, made_of=Material(EA=5.0, mass_per_length=1e-3),
    shape=Straight(start=(0, 5, 0), end=(300, 5, 0)),
)  # fmt: skip
STEEL = hung("steel", 10, EA=1e5)
PAYS = {"rope": "steel", "end": "start", "speed": 0.1}
STILL = {"rope": "drops", "end": "start", "speed": 1e-9}
RUBBER = {"kind": "neo-hookean", "EA": 1e5, "largest_strain": 1.0}


@pytest.mark.parametrize(
    ("others", "more"),
    [
        ((SOFT,), {}),
        ((SOFT, STEEL), {"winches": [PAYS]}),  # of which the frames do not tell the masses
        ((SOFT,), {"winches": [STILL]}),  # of all less that of the others
        ((SOFT, hung("rubber", 10, curve=RUBBER)), {"winches": [STILL]}),
        ((SOFT, hung("creeps", 10, EA=1e5, relaxing_EA=1e5, relaxation_time=0.1)), {}),
    ],
)
def test_what_another_rope_has_does_not_hide_a_loss(
    others: tuple[Rope, ...], more: dict[str, Any]
) -> None:
    """A soft rope that lies stretched beside it, nowhere joined, silenced what was told of the first."""
    told = [rw.simulate(scene).table for scene in (dropping(), dropping(*others, **more))]
    assert "rope 'drops'" in told[1]["largest tension at"]
    assert told[1]["largest tension [N]"] == pytest.approx(told[0]["largest tension [N]"])
    assert "of motion and stretch of all ropes" in told[0][PULL]
    assert "this rope had" in told[1][PULL]
    about = [re.findall(r"([\d.]+) J of motion", table[PULL])[0] for table in told]
    assert float(about[1]) == pytest.approx(float(about[0]), rel=0.02)


def test_energy_of_ropes_that_frames_do_not_tell_apart_is_told_as_that_of_all() -> None:
    """It was told as that of this rope and what is joined to it."""
    table = rw.simulate(dropping(STEEL, winches=[STILL, PAYS])).table
    assert "all ropes, as their shares are not recorded, had" in table[PULL]
    assert "If this rope lost energy" in table[PULL]


@pytest.mark.parametrize("made_of", [{"EA": 1e3}, {"curve": RUBBER | {"EA": 1e3}}])
@pytest.mark.parametrize("method", ["implicit-euler", "generalized-alpha"])
def test_energies_told_of_single_ropes_are_those_of_the_ledger(
    made_of: dict[str, Any], method: str
) -> None:
    scene = dropping(hung("other", 10, **made_of)).replace(**{"run.method": method})
    result = rw.simulate(scene)
    parts = [_told(result, {name}, slice(0, result.frames)) for name in ("drops", "other")]
    for form, told in zip(("kinetic", "elastic"), np.sum(parts, axis=0), strict=True):
        assert float(told.max()) > 0.1
        assert told == pytest.approx(result.energy[form], rel=1e-9, abs=1e-9)


def two_ropes(step: float) -> rw.Result:
    """A rope that holds half a ton at rest, and a weak one that a slack load of 5 kg jerks."""
    stuff = {"EA": 2e4, "mass_per_length": 0.06, "axial_damping": 20.0}
    strong = Rope(
        name="strong",
        segments=2,
        length=1.0,
        made_of=Material(**stuff | {"EA": 1e6}, breaking_load=1e5),
        shape=Hanging(start=(3, 0, 0)),
        loads=[{"node": -1, "mass": 500.0}],
    )
    weak = Rope(
        name="weak",
        segments=10,
        length=2.0,
        made_of=Material(**stuff, breaking_load=2e3),
        shape=Slack(end=(0.3, 0, 1.0)),
        loads=[{"node": -1, "mass": 5.0}],
    )
    anchors = [Anchor(rope=name, node=0) for name in ("strong", "weak")]
    run = RunSettings(duration=1.5, method="implicit-euler", time_step=step)
    return rw.simulate(Scene(ropes=[strong, weak], anchors=anchors, run=run))


def test_a_safety_factor_of_another_rope_has_its_own_note() -> None:
    """The largest tension is the strong rope's, and right; nothing told that the weak one's was not."""
    result, fine = two_ropes(1 / 60), two_ropes(1 / 3840)
    use, factor = "about the largest utilisation of the breaking load", "least safety factor [1]"
    assert result.table["largest tension at"].startswith("segment 0 of rope 'strong'")
    assert "rope 'weak'" in result.table[f"{use.removeprefix('about the ')} at"]
    assert result.table[factor] > 1.1 * fine.table[factor]
    assert result.table[use].startswith("of a tension of ")
    assert "too low" in result.table[use]
    assert "peak may be too low" in kinds(result) or "peak may be wrong" in kinds(result)


def test_a_safety_factor_of_the_largest_tension_says_to_see_there() -> None:
    """Its row had nothing beside it. The twin: a run whose peak is right."""
    use, pull = "about the largest utilisation of the breaking load", "about the largest tension"
    scene = two_ropes(1 / 60).scene
    alone = scene.replace(ropes=scene.ropes[1:], anchors=scene.anchors[1:])
    table = rw.simulate(alone).table
    assert "too low" in table[pull]
    assert table[use].startswith("see the largest tension")
    fine = rw.simulate(alone.replace(**{"run.method": "esdirk3", "run.time_step": 1 / 15360}))
    assert use not in fine.table


def test_a_rope_at_rest_over_a_post_is_counted_for_nothing() -> None:
    """Sweeps counted a peak that may be too low wherever a rope pressed as its tension was largest."""
    turn = [math.pi * (1.0 - k / 24.0) for k in range(25)]
    over = [(0.112 * math.cos(a), 0.0, 0.112 * math.sin(a)) for a in turn]
    rope = Rope(
        segments=30,
        length=2.35,
        diameter=0.02,
        made_of=Material(EA=1e4, mass_per_length=0.05, axial_damping=20.0),
        shape=Polyline(points=[(-0.111, 0, -1.0), *over, (0.111, 0, -1.0)]),
        loads=[Load(node=0, mass=1.0), Load(node=-1, mass=1.0)],
    )
    post = Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=0.1, friction=0.3)
    run = RunSettings(duration=0.1, method="esdirk3", time_step=1 / 960, start="at-rest")
    result = rw.simulate(Scene(ropes=rope, obstacles=(post,), run=run))
    assert result.table["largest force on an obstacle [N]"] > 20.0
    assert kinds(result) == ()
