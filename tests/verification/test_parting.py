"""Ropes that part: when, where, with what energy, and what becomes of the ends."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.analysis.strains import breaking_warnings, parting_warnings
from ropewalk.cli.commands.run import _tell_of_partings
from ropewalk.laws.pairs.table import CONTACTS, NEAR
from ropewalk.methods.registry import METHODS
from ropewalk.record.parted import Parting
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Kick, SceneError, Straight
from verification.feature_pairs import scene_of

K, M, G, SPEED, LOAD = 4000.0, 2.0, 9.81, 1.0, 80.0  # N/m, kg, m/s^2, m/s, N
OMEGA = math.sqrt(K / M)


def string(method: str = "semi-implicit-euler", load: float = LOAD, **more: Any) -> rw.Scene:
    """A mass at rest on a string whose upper end is pulled up at 1 m/s, from where it hangs."""
    about = {"parts": True, "breaking_load": load} | more
    made_of = rw.Springs(spring_constant=K, node_mass=M, segment_length=1.0, **about)
    down = (0.0, 0.0, -1.0 - M * G / K)
    rope = rw.Rope(segments=1, made_of=made_of, shape=Straight(start=(0, 0, 0), end=down))
    pull = {"kind": "velocity", "velocity": (0.0, 0.0, SPEED)}
    step = "auto" if method == "adaptive" else 2e-4
    run = rw.RunSettings(method=method, time_step=step, duration=0.1, frame_rate=50.0)
    return rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0, motion=pull)], run=run)


def time_of_parting() -> float:
    """When T = m g + v sqrt(k m) sin(w t) comes to the load [s]."""
    return math.asin((LOAD - M * G) / (SPEED * math.sqrt(K * M))) / OMEGA


@pytest.mark.parametrize("method", METHODS)
def test_a_string_parts_when_it_should_and_its_mass_falls_freely(method: str) -> None:
    result = rw.simulate(string(method))
    assert result.status == "finished"
    (parting,) = result.partings
    assert (parting.rope, parting.segment) == ("rope", 0)
    when, off = time_of_parting(), 4e-4 + 2.0 * (METHODS[method].order == 1) * 2e-4
    assert abs(parting.time - when) < off
    # At the end of a step: it may carry what the tension grows by in that step.
    assert LOAD < parting.tension < LOAD + 1.5 * SPEED * math.sqrt(K * M) * OMEGA * 2e-4
    up = SPEED * (1.0 - math.cos(OMEGA * when))
    height = -1.0 - M * G / K + SPEED * (when - math.sin(OMEGA * when) / OMEGA)
    fell = result.time[-1] - when
    assert result.positions[-1, 1, 2] == pytest.approx(
        height + up * fell - 0.5 * G * fell**2, abs=1e-3
    )
    assert result.velocities[-1, 1, 2] == pytest.approx(up - G * fell, abs=2e-2)
    assert result.velocities[-1, 1, 2] == pytest.approx(
        result.velocities[-2, 1, 2] - G * 0.02, abs=1e-12
    )


@pytest.mark.parametrize("method", METHODS)
def test_what_the_segment_had_stored_is_booked_as_lost(method: str) -> None:
    result = rw.simulate(string(method))
    (parting,) = result.partings
    stored = parting.tension**2 / (2.0 * K)
    assert result.work["parting"][-1] == pytest.approx(-stored, rel=1e-9)
    assert result.work["parting"][result.time < parting.time].max(initial=0.0) == 0.0
    assert result.energy["elastic"][-1] == 0.0
    assert np.abs(result.balance_residual).max() < 1e-9
    assert abs(result.energy_error[-1]) < 0.05 * stored
    after = result.time > parting.time
    assert not result.tension[after].any()
    assert not result.live[after].any()
    assert result.live[~after].all()
    assert not result.rest_length[after].any()


def hung(load: float, mass: float = 5.0) -> rw.Scene:
    """A rope with a mass at its end, at rest."""
    made_of = rw.Material(
        EA=1e4, mass_per_length=0.1, breaking_load=load, parts=True, axial_damping=5.0
    )
    rope = rw.Rope(
        segments=6,
        length=1.2,
        made_of=made_of,
        shape={"kind": "hanging"},
        loads=[rw.Load(node=-1, mass=mass)],
    )
    run = rw.RunSettings(
        method="implicit-euler", time_step=1e-3, duration=0.1, frame_rate=100.0, start="at-rest"
    )
    return rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)


TOP = 9.81 * (5.0 + 0.12 * (1.0 - 0.5 / 6))  # [N] all but the first node's half of a segment


def test_a_load_just_below_never_parts_it_and_one_just_above_does_at_once() -> None:
    calm = rw.simulate(hung(TOP * (1.0 + 1e-6)))
    assert calm.partings == ()
    assert calm.live.all()
    assert calm.table["segments parted"] == 0
    assert math.isnan(calm.table["first parting [s]"])
    torn = rw.simulate(hung(TOP * (1.0 - 1e-6)))
    assert [(one.segment, one.time) for one in torn.partings] == [(0, 1e-3)]
    assert torn.table["segments parted"] == 1
    notes = " ".join(text.get_text() for text in torn.plot.tension().texts)
    assert "; it parted" in notes
    assert "would have parted" not in notes
    assert "segment 0 of 'rope' at 50.13 N at t = 0.001 s" in torn.table["segments parted at"]


def test_the_check_says_whether_a_line_is_near_its_load_at_rest() -> None:
    def told(load: float) -> str:
        return " ".join(rw.check(hung(load)).warnings)

    assert "breaking load at rest; it parts as it starts" in told(0.99 * TOP)
    assert "does not part" not in told(0.99 * TOP)
    assert "would have parted" not in str(rw.check(hung(0.99 * TOP)))
    assert "breaking load at rest; it parts with little more" in told(1.05 * TOP)
    assert "breaking load" not in told(2.0 * TOP)
    scene = hung(0.99 * TOP)
    drawn = scene.replace(run=scene.run.replace(start="shape"))
    assert "it parts by the time it is at rest" in " ".join(rw.check(drawn).warnings)


@pytest.mark.parametrize(
    ("utilisation", "worst", "then"),
    [
        (0.95, None, "it parts with little more"),
        (0.7, 0.95, "it may part with little more"),
        (0.7, 1.2, "it may part as it starts"),
        (1.1, 1.8, "it parts as it starts"),
        (0.7, 0.85, ""),
    ],
)
def test_of_a_guessed_breaking_load_the_least_counts(
    utilisation: float, worst: float | None, then: str
) -> None:
    """A rope that cannot part was warned of, and one that can was not."""
    scene = hung(100.0)
    rope = replace(
        rw.check(scene).ropes[0],
        utilisation=utilisation,
        worst=worst,
        parts_at_rest=utilisation > 1.0,
    )
    found = parting_warnings(scene, (rope,))
    assert [text.partition("at rest; ")[2] for text in found] == ([then] if then else [])


def test_what_a_rope_carries_over_its_breaking_load_is_rounded_up() -> None:
    """It read 100 % of the breaking load and 1 times it, and that it parts."""
    scene = hung(100.0)
    rope = replace(rw.check(scene).ropes[0], utilisation=1.00004, worst=None, parts_at_rest=True)
    assert "carries 100.1 % of the breaking load" in parting_warnings(scene, (rope,))[0]
    holds = replace(rope, worst=1.00004, parts=False)
    assert "carries 1.01 times its breaking load" in breaking_warnings((holds,))[0]


def test_both_ends_fly_apart_with_equal_and_opposite_momentum() -> None:
    made_of = rw.Material(EA=500.0, mass_per_length=0.3, breaking_load=20.0, parts=True)
    rope = rw.Rope(
        segments=3,
        length=0.9,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), end=(0.9, 0, 0)),
        kicks=[Kick(node=1, velocity=(-2, 0, 0)), Kick(node=2, velocity=(2, 0, 0))],
    )
    run = rw.RunSettings(method="semi-implicit-euler", time_step=1e-4, duration=0.1, frame_rate=200)
    result = rw.simulate(rw.Scene(ropes=[rope], gravity=(0, 0, 0), run=run))
    assert [one.segment for one in result.partings] == [1]
    mass = np.array([0.5, 1.0, 1.0, 0.5]) * 0.3 * 0.3
    along = result.velocities[:, :, 0] * mass
    left, right = along[:, :2].sum(axis=1), along[:, 2:].sum(axis=1)
    after = result.time > result.partings[0].time
    assert np.abs(left + right).max() < 1e-14
    assert np.ptp(left[after]) < 1e-14
    assert abs(left[-1]) > 0.05


def pulled(
    method: str = "semi-implicit-euler", parts: bool = True, segments: int = 40, **more: Any
) -> rw.Scene:
    """A straight rope of strings that only pull, one end of which is drawn away slowly."""
    about = {"breaking_load": 100.0, "parts": parts, "tension_only": True} | more
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, **about)
    rope = rw.Rope(
        name="one",
        segments=segments,
        length=1.0,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), end=(1, 0, 0)),
    )
    pull = {"kind": "velocity", "velocity": (0.5, 0.0, 0.0)}
    ends = [rw.Anchor(name="a", rope="one", node=0)]
    ends += [rw.Anchor(name="b", rope="one", node=-1, motion=pull)]
    step = "auto" if method == "adaptive" else 5e-5
    run = rw.RunSettings(method=method, time_step=step, duration=0.12, frame_rate=100.0)
    return rw.Scene(ropes=[rope], anchors=ends, gravity=(0, 0, 0), run=run)


def test_a_rope_parts_at_one_place_and_does_not_fall_to_dust() -> None:
    """All of it carries nearly the same; the others hear of it before they part. Each half comes to lie."""
    result = rw.simulate(pulled(axial_damping=0.5))
    (parting,) = result.partings
    assert parting.tension == pytest.approx(100.0, rel=0.02)
    whole = result.live[-1]
    assert whole.sum() == 39
    assert not whole[parting.segment]
    assert np.abs(result.tension[-1]).max() < 60.0


def drawn(
    made_of: rw.Material, segments: int, speed: float, duration: float, **rope: Any
) -> rw.Scene:
    """A rope a hair below its breaking load all along, drawn out evenly."""
    end = 1.0 + 0.9995 * 20.0 / made_of.EA
    if made_of.curve is not None:
        end = 1.0 + float(made_of.curve.strain_at(0.9995 * 20.0))
    line = rw.Rope(
        segments=segments,
        length=1.0,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), end=(end, 0, 0)),
        kicks=[Kick(node=i, velocity=(speed * i / segments, 0, 0)) for i in range(1, segments)],
        **rope,
    )
    pull = {"kind": "velocity", "velocity": (speed, 0.0, 0.0)}
    run = rw.RunSettings(method="semi-implicit-euler", duration=duration, frame_rate=250.0)
    ends = [rw.Anchor(node=0), rw.Anchor(node=-1, motion=pull)]
    return rw.Scene(ropes=[line], anchors=ends, gravity=(0, 0, 0), run=run)


SOFTENING = {"kind": "table", "strain": [0.05, 0.5, 1.0], "tension": [15.0, 19.0, 22.0]}
RUBBER = {"kind": "neo-hookean", "EA": 30.0, "largest_strain": 5.0}


@pytest.mark.parametrize("about", [{"EA": 30.0}, {"curve": SOFTENING}, {"curve": RUBBER}])
def test_a_rope_drawn_evenly_parts_once_whatever_its_curve(about: dict[str, Any]) -> None:
    """News runs slower where a curve softens; until it has come to the end nothing else parts."""
    stuff = {"mass_per_length": 0.01, "axial_damping": 0.003, "breaking_load": 20.0}
    made_of = rw.Material(parts=True, tension_only=True, **stuff, **about)
    result = rw.simulate(drawn(made_of, 60, 2.0, 0.02))
    assert len(result.partings) == 1


def test_loads_along_a_rope_slow_the_news_of_its_parting() -> None:
    stuff = {"mass_per_length": 0.01, "axial_damping": 0.02, "breaking_load": 20.0}
    made_of = rw.Material(EA=3000.0, parts=True, tension_only=True, **stuff)
    beads = [rw.Load(node=i, mass=0.02) for i in range(30)]
    result = rw.simulate(drawn(made_of, 30, 0.1, 0.02, loads=beads))
    assert len(result.partings) == 1


@pytest.mark.parametrize("method", ["semi-implicit-euler", "implicit-euler", "adaptive"])
def test_a_rope_that_does_not_part_has_the_bits_of_one_that_cannot(method: str) -> None:
    one = rw.simulate(pulled(method, segments=6, breaking_load=1e6))
    other = rw.simulate(pulled(method, parts=False, segments=6))
    assert np.array_equal(one.positions, other.positions)
    assert np.array_equal(one.velocities, other.velocities)


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet", "implicit-euler", "adaptive"])
def test_a_rope_beside_one_that_parts_keeps_its_bits(method: str) -> None:
    scene = pulled(method, segments=6)
    calm = scene.ropes[0].replace(
        name="two",
        made_of=scene.ropes[0].made_of.replace(breaking_load=None, parts=False, axial_damping=1.0),
        shape=Straight(start=(0, 1, 0), end=(1, 1, 0)),
        kicks=[Kick(node=3, velocity=(1, 2, 0))],
    )
    alone = rw.simulate(scene.replace(ropes=[calm], anchors=[]))
    both = rw.simulate(scene.replace(ropes=[*scene.ropes, calm]))
    assert both.partings
    assert {one.rope for one in both.partings} == {"one"}
    there = both.rope("two")
    assert np.array_equal(there.positions, alone.positions)
    assert both.work["parting"][-1] < 0.0


@pytest.mark.parametrize("method", ["semi-implicit-euler", "bdf2", "adaptive"])
def test_a_run_cut_off_after_the_parting_goes_on_to_the_same_bits(
    method: str, tmp_path: Path
) -> None:
    scene = pulled(method, segments=6, axial_damping=0.5)
    whole = simulate_in_memory(scene)
    simulation = rw.Simulation(scene)
    simulation.advance_frames(2)
    assert np.isfinite(simulation.arrays.memory.parting.time).any()
    snapshot = simulation.state
    other = rw.Simulation(scene)
    other.restore(snapshot)
    block = other.advance_frames(1)
    assert np.array_equal(block.recording.x[-1].T, whole.positions[3])
    told = rw.run(scene, tmp_path / "run")
    assert told.partings == whole.partings == rw.open(tmp_path / "run").partings


@pytest.mark.parametrize("more", [{}, {"min_length": 0.85}, {"stop": 0.0799}])
def test_a_winch_stops_where_its_rope_has_parted(more: dict[str, float]) -> None:
    made_of = rw.Material(
        EA=1e4, mass_per_length=0.1, axial_damping=2.0, breaking_load=60.0, parts=True
    )
    rope = rw.Rope(
        name="one",
        segments=5,
        length=1.0,
        made_of=made_of,
        shape=Straight(start=(0, 0, 0), end=(1, 0, 0)),
    )
    ends = [rw.Anchor(name="drum", node=0), rw.Anchor(name="end", node=-1)]
    run = rw.RunSettings(
        method="semi-implicit-euler", time_step=1e-4, duration=0.08, frame_rate=100.0
    )
    winch = rw.Winch(rope="one", end="start", speed=-0.2, **more)
    scene = rw.Scene(ropes=[rope], anchors=ends, gravity=(0, 0, 0), winches=[winch], run=run)
    result = rw.simulate(scene)
    (parting,) = result.partings
    assert parting.segment > 0  # the one at the drum is the winch's
    (stopped,) = (one for one in result.events if one["event"] == "winch stopped")
    assert (stopped["by"], stopped["time"]) == ("rope parted", parting.time)
    after = result.time > parting.time
    assert np.ptp(result.rest_length[after].sum(axis=1)) == 0.0
    assert np.ptp(result.rest_length[~after].sum(axis=1)) > 0.0


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"breaking_load": None}, "needs a load at which it parts: give breaking_load"),
        ({"breaking_load": -1.0}, "breaking_load"),
        ({"parts": "maybe"}, "parts"),
    ],
)
def test_bad_input_is_refused_by_name(changes: dict[str, Any], words: str) -> None:
    with pytest.raises(SceneError, match=words):
        string(**changes)


def test_springs_of_no_length_do_not_part() -> None:
    made_of = rw.Springs(
        spring_constant=1.0, node_mass=1.0, segment_length=0.0, parts=True, breaking_load=1.0
    )
    with pytest.raises(SceneError, match="needs springs of a length"):
        rw.Rope(segments=2, made_of=made_of)


def test_no_more_than_three_partings_are_told_one_by_one(
    capsys: pytest.CaptureFixture[str],
) -> None:
    _tell_of_partings(tuple(Parting(0.1, "one", segment, 5.0) for segment in range(40)))
    told = capsys.readouterr().err
    assert told.count("a rope parted: segment") == 3
    assert "and 37 more segments parted" in told


def test_what_has_parted_is_not_touched() -> None:
    """Segments that part go from the contacts of ropes; their neighbours stay."""
    simulation = rw.Simulation(scene_of("implicit-euler", "contact", "parting", implicit=True))
    table, memory = simulation.system.node.contact, simulation.arrays.memory.contact
    whole = memory.rope.copy()
    assert (whole == table.rope).all()
    simulation.advance_steps(20)
    memory = simulation.arrays.memory.contact
    parted = (simulation.arrays.stiffness == 0.0) & (table.rope >= 0)
    assert parted.any()
    assert not parted.all()
    assert ((memory.rope < 0) == (parted | (whole < 0))).all()
    assert not parted[memory.pair[: memory.tally[CONTACTS]]].any()
    assert not parted[memory.near[: memory.tally[NEAR]]].any()
