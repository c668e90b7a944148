"""What a check says before a run, and the slips of units it sees, each with a twin it lets pass."""

from __future__ import annotations

import json
import math

import pytest

from ropewalk.analysis.check import check
from ropewalk.analysis.cost import seconds_per_step
from ropewalk.analysis.unit_slips import unit_slips
from ropewalk.api import preset, simulate
from ropewalk.library import names
from ropewalk.library import rope as library_rope
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    Contact,
    Ground,
    Limiter,
    Load,
    Material,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Springs,
    Straight,
)
from ropewalk.simulation import Simulation


def scene(**changes: object) -> Scene:
    """The report's rope between two anchors; `changes` to springs, rope, run or scene by name."""
    springs: dict[str, object] = {
        "spring_constant": 1e4,
        "node_mass": 0.05,
        "spring_friction": 0.05,
        "segment_length": 1.0,
    }
    rope: dict[str, object] = {"segments": 20, "shape": Straight(start=(0, 0, 0))}
    run: dict[str, object] = {"time_step": 0.002}
    whole: dict[str, object] = {
        "gravity": (0, -9.81, 0),
        "anchors": (Anchor(node=0), Anchor(node=-1)),
    }
    for key, value in changes.items():
        for part in (springs, rope, run):
            fields = {id(springs): Springs, id(rope): Rope, id(run): RunSettings}[id(part)]
            if key in fields.model_fields:
                part[key] = value
                break
        else:
            whole[key] = value
    rope.setdefault("made_of", Springs(**springs))
    return Scene(
        run=RunSettings(**({"method": "semi-implicit-euler"} | run)), ropes=(Rope(**rope),), **whole
    )


def warnings(**changes: object) -> str:
    return "\n".join(check(scene(**changes), measure=False).warnings)


def test_numbers_of_the_report() -> None:
    found = check(scene(), measure=False)
    assert found.ok
    assert found.steps_per_frame == 9
    assert found.steps == 600 * 9
    assert found.statics.sag[0] == pytest.approx(0.7181, abs=1e-4)
    rope = found.ropes[0]
    assert rope.longitudinal == pytest.approx([math.sqrt(1e4 / 0.05)] * 2)
    # Sideways: between sqrt(H/mu) in the middle and sqrt(T/mu) at the ends (stretch 0.3 %).
    low, high = rope.transverse or (0.0, 0.0)
    assert low == pytest.approx(math.sqrt(34.094 / 0.05), rel=3e-3)
    assert high == pytest.approx(math.sqrt(found.statics.largest_tension / 0.05), rel=3e-3)
    assert low < high
    assert found.warnings == ()
    text = "\n".join(found.lines())
    for word in ("semi-implicit-euler", "2.23", "9 steps", "sag 0.7181 m", "strain 0.3"):
        assert word in text
    assert "rad/s" not in text
    assert "rad/s" in "\n".join(found.lines(all_methods=True))
    again = json.loads(json.dumps(found.as_dict(), allow_nan=False))
    assert again["stability"]["stable"] is True
    assert again["statics"]["spans"][0]["sag"] == pytest.approx(0.7181, abs=1e-4)


def test_a_predicted_break_is_warned_of_with_values() -> None:
    text = warnings(spring_constant=200.0, time_step=1 / 60)
    assert "will break" in text
    assert "spring_constant <= 175 N/m" in text
    assert "time_step <= 0.0156 s" in text
    assert "break" not in warnings(spring_constant=170.0, time_step=1 / 60)


def test_a_small_margin_is_warned_of() -> None:
    assert "below the largest stable step" in warnings(time_step=0.0022, steps="exact")
    assert "below the largest" not in warnings(time_step=0.0020, steps="exact")


def test_a_limiter_that_always_acts() -> None:
    # Habrador's rope: 1 + 2.2 * 9.81 / 40 = 1.54 at the top against 1.1.
    habrador = {
        "spring_constant": 40.0,
        "node_mass": 0.2,
        "segments": 6,
        "loads": (Load(node=-1, mass=1.0),),
        "anchors": (Anchor(node=0),),
        "time_step": 0.02,
    }
    text = warnings(limiter=Limiter(min_stretch=0.9, max_stretch=1.1), **habrador)
    assert "acts even at rest, on 6 segments" in text
    assert "1.54" in text
    assert "acts even" not in warnings(
        limiter=Limiter(min_stretch=0.9, max_stretch=1.6), **habrador
    )
    assert "springs that are weak" in warnings(**habrador)


def test_slack_short_and_unheld() -> None:
    short = warnings(shape=Straight(start=(0, 0, 0), end=(18, 0, 0)))
    assert "20 of 20 segments start shorter" in short
    assert "shorter" not in warnings(shape=Straight(start=(0, 0, 0), end=(20, 0, 0)))
    loose = {"gravity": (0, 0, 0), "shape": Straight(start=(0, 0, 0), end=(18, 0, 0))}
    assert "carry no tension" in warnings(**loose)
    assert "nothing holds it; it falls" in warnings(anchors=())
    assert "nothing holds" not in warnings()


def test_ground_above_the_rest_shape() -> None:
    """The sag of 0.718 m is held up by a ground at 0.5 m, and left alone by one at 1 m."""
    near, far = (check(scene(ground=Ground(height=-h))) for h in (0.5, 1.0))
    assert near.statics.grounded.sum() > 5
    assert near.statics.sag[0] < 0.6
    assert "nodes lie on the ground" in "\n".join(near.lines())
    assert far.statics.sag[0] == pytest.approx(0.718, abs=1e-3)
    assert "lie on the ground" not in "\n".join(far.lines())
    assert near.statics.solved
    assert "no shape of rest" not in warnings(ground=Ground(height=-0.5))


def test_run_time_is_measured_when_the_kernel_is_there() -> None:
    made = scene(segments=200)
    Simulation(made).step()  # compiles
    found = check(made)
    assert found.seconds_measured
    per_segment = found.seconds / found.steps / 200
    assert 1e-10 < per_segment < 1e-6
    assert not check(made, measure=False).seconds_measured


def test_what_is_not_measured_is_a_range_and_of_contact_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Nineteen presets took 0.44 to 1.5 times the table's time; one with ropes in contact fourteen times."""
    plain = check(preset("r4"), measure=False)
    low, high = (
        plain.run_time.removeprefix("in some ").removesuffix(" (not measured)").split(" to ")
    )
    assert float(high.split()[0]) == pytest.approx(9.0 * float(low.split()[0]), rel=0.1)
    assert plain.as_dict()["estimated_seconds"] == plain.seconds
    for name in ("pulley", "stairs"):
        found = check(preset(name), measure=False)
        assert "in a time that is not known" in str(found)
        assert not found.seconds_known
        assert found.as_dict()["estimated_seconds"] is None
    monkeypatch.setattr("ropewalk.analysis.check.seconds_per_step", lambda *_: (1e-3, True))
    assert "in about 240 ms, at the pace of its first steps;" in str(check(preset("pulley")))
    assert "pace" not in check(preset("r4")).run_time


def material(**changes: object) -> Rope:
    fields = {"EA": 2e4, "mass_per_length": 0.06, "breaking_load": None}
    rope = {"segments": 10, "length": 10.0, "shape": Straight(start=(0, 0, 0))}
    for key, value in changes.items():
        (fields if key in fields else rope)[key] = value
    return Rope(**({"made_of": Material(**fields)} | rope))


def slips(**changes: object) -> str:
    return "\n".join(unit_slips(build(scene(**changes))))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"gravity": (0, -9810.0, 0)}, "mm/s^2"),
        ({"gravity": (0, -32.17, 0)}, "ft/s^2"),
        ({"gravity": (0, 9.81, 0)}, "sign lost"),
        ({"gravity": (0, 0, 9.81)}, "points to +z"),
        ({"node_mass": 50.0}, "grams for kilograms"),
        ({"spring_constant": 1e10}, "faster than in any fibre"),
        ({"spring_constant": 0.01}, "slower than in rubber"),
        ({"time_step": 2.0, "duration": 100.0, "frame_rate": 0.5}, "milliseconds for seconds"),
        ({"segment_length": 50.0}, "lengths in millimetres"),
        ({"shape": Straight(start=(0, 0, 0), end=(20000.0, 0, 0))}, "places in millimetres"),
        ({"shape": Straight(start=(0, 0, 0), end=(0.02, 0, 0))}, "rope lengths in millimetres"),
        ({"shape": Polyline(points=((0, 0, 0), (9e3, 0, 0), (9e3, 9e3, 0)))}, "millimetres"),
        ({"loads": (Load(node=3, mass=80000.0),)}, "grams for kilograms"),
        ({"diameter": 12.0}, "not a rope's"),
    ],
)
def test_slips_of_units(changes: dict[str, object], words: str) -> None:
    assert words in slips(**changes)


def test_strains_in_per_cent_are_a_slip() -> None:
    for strain, warned in ((10.0, True), (5.0, False)):  # rubber bears some 7
        curve = [(0.5 * strain, 500.0), (strain, 900.0)]
        one = Rope(segments=4, length=2.0, made_of=Material(curve=curve, mass_per_length=0.06))
        found = "\n".join(unit_slips(build(scene().model_copy(update={"ropes": (one,)}))))
        assert ("per cent for shares?" in found) is warned


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"EA": 40.0, "mass_per_length": 0.2}, "kN for N"),
        ({"EA": 40.0, "diameter": 0.01, "mass_per_length": 1e-3}, ""),
        ({"EA": 2e11}, "Young's modulus"),
        ({"mass_per_length": 6000.0}, "grams for kilograms"),
        ({"mass_per_length": 60.0, "diameter": 0.01}, "density"),
        ({"EA": 0.05, "diameter": 0.01}, "that of no material"),
        ({"diameter": 10.0}, "not a rope's"),
        (
            {"breaking_load": 20.0},
            "bears 34 m of this rope, of 0.06 kg/m; kN for N, or g/m for kg/m?",
        ),
        ({"breaking_load": 20e3, "mass_per_length": 60.0}, "kN for N, or g/m for kg/m?"),
        ({"breaking_load": 4e5}, "where no rope breaks; kN for N in one of them?"),
        ({"breaking_load": 20e3, "EA": 1e3}, "where no rope breaks"),
        ({"breaking_load": 20e3}, ""),
        ({"breaking_load": 900.0, "EA": 75.0, "mass_per_length": 0.047}, ""),  # rubber
        ({"length": 30e3}, "30000 m of rope; lengths in millimetres?"),
        (
            {"length": 0.03, "diameter": 0.012, "EA": 5e6, "mass_per_length": 0.5},
            "is not a rope's shape",
        ),
    ],
)
def test_slips_of_a_material(changes: dict[str, object], words: str) -> None:
    made = scene().model_copy(update={"ropes": (material(**changes),)})
    found = "\n".join(unit_slips(build(made)))
    if words:
        assert words in found
    else:
        assert found == ""


@pytest.mark.parametrize("name", ["tow", "zip-line", "highline", "crane-snap", "climbing-fall"])
def test_rigging_presets_look_like_no_slip(name: str) -> None:
    assert unit_slips(build(preset(name))) == []


def test_a_rider_s_density_is_that_of_his_loads_too() -> None:
    """His diameter is to the air; grams for kilograms is still seen where nothing slides."""
    ride = preset("zip-line-ride")
    assert unit_slips(build(ride)) == []
    light = ride.replace(**{"rope[1].load[1].mass": 0.03, "rope[1].load[2].mass": 0.03})
    light = light.replace(**{"rope[1].load[0].mass": 0.03})
    assert "density" in "\n".join(unit_slips(build(light)))


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"gravity": (0, 0, -9.81)},
        {"gravity": (0, -1.62, 0)},
        {"gravity": (0, 0, 0)},
        {"spring_constant": 100.0},
        {"spring_constant": 10.0, "node_mass": 0.001},
        {"loads": (Load(node=3, mass=80.0),)},
        {"segment_length": 0.05, "segments": 79},
        {"diameter": 0.012},
    ],
)
def test_ordinary_scenes_pass(changes: dict[str, object]) -> None:
    assert slips(**changes) == ""


@pytest.mark.parametrize(
    ("diameter", "EA", "line"),
    [
        (0.0105, 25e3, 0.068),  # climbing rope
        (0.02, 26e6, 1.7),  # steel cable
        (0.0003, 1.5e2, 8e-5),  # fishing line
        (0.1, 800e6, 200.0),  # mooring chain
        (0.008, 30.0, 0.05),  # rubber
    ],
)
def test_real_ropes_pass(diameter: float, EA: float, line: float) -> None:
    rope = material(diameter=diameter, EA=EA, mass_per_length=line)
    made = scene().model_copy(update={"ropes": (rope,)})
    assert unit_slips(build(made)) == []


def test_no_rope_of_the_library_looks_like_a_slip() -> None:
    """Whole, with its guesses: from a spider's thread to a mooring chain."""
    for name in names():
        one = library_rope(name)
        made_of = one.material(guesses=True)
        piece = Rope(
            segments=4, length=500.0 * one.diameter, diameter=one.diameter, made_of=made_of,
            shape=Straight(start=(0, 0, 0)),
        )  # fmt: skip
        assert unit_slips(build(scene().model_copy(update={"ropes": (piece,)}))) == [], name


def test_durations_that_are_no_whole_frames() -> None:
    """Said with the time at which the run ends; the twin is a whole number of frames."""
    said = warnings(duration=1.01, frame_rate=50.0, time_step=0.002)
    assert "run.duration: 1.01 s is no whole number of frames; the run ends at 1 s" in said
    assert "after 50 frames of 0.02 s" in said
    assert "run.duration" not in warnings(duration=1.02, frame_rate=50.0, time_step=0.002)
    # exact steps: 8 steps of 2 ms are a frame of 16 ms, and 63 of these are 1.008 s
    assert "the run ends at 1.008 s" in warnings(duration=1.005, time_step=0.002, steps="exact")
    assert "after 1 frame of 0.02 s" in warnings(duration=1e-3, frame_rate=50.0)


def test_the_warning_of_a_break_says_so_once() -> None:
    said = warnings(time_step=1.0 / 60.0)
    assert said.count("will break") == 1
    assert "first at rope 'rope', node" in said


def test_the_highest_frequency_at_rest_is_below_the_bound_for_any_shape() -> None:
    """Exact for the nearly straight rope of the report: 2 sqrt(k/m) sin(19 pi/40), closed forms 1.1."""
    found = check(scene())
    assert found.highest_at_rest is not None
    exact = 2.0 * math.sqrt(1e4 / 0.05) * math.sin(19 * math.pi / 40)
    assert found.highest_at_rest == pytest.approx(exact, rel=1e-3)
    assert found.highest_at_rest <= found.stability.highest_frequency
    slack = check(scene(shape=Straight(start=(0, 0, 0), end=(8, 0, 0))))
    assert slack.highest_at_rest < 0.999 * slack.stability.highest_frequency
    assert "rad/s about the rest shape" in "\n".join(found.lines(all_methods=True))
    assert check(scene(), measure=False).highest_at_rest is None


def test_a_strain_that_no_rope_bears_is_warned_of() -> None:
    """12 m of 0.1 kg/m with EA in kN typed as N: 80 N carry it level, so 20 N stretch it by far."""
    for EA, strained in ((20.0, True), (2e4, False)):
        made = scene(
            made_of=Material(EA=EA, mass_per_length=0.1), length=12.0, gravity=(0, 0, -9.81)
        )
        found = check(made, measure=False)
        said = [text for text in found.warnings if "at rest it is stretched by" in text]
        assert bool(said) is strained
        rope = found.ropes[0]
        assert rope.largest_strain == pytest.approx(rope.largest_tension / EA, rel=1e-6)
        if strained:
            assert f"by {100 * rope.largest_strain:.3g} %" in said[0]
            assert "EA of 20 N: kN typed as N" in said[0]
    assert "kN/m typed as N/m" in warnings(spring_constant=20.0)


def test_a_shape_that_starts_broken_is_told() -> None:
    """4 segments of 0.1 m laid over 8 m. The twin: over 3 m, 7.5 times their length."""
    made_of = Springs(spring_constant=100.0, node_mass=0.1, segment_length=0.1)
    long, short = (
        Scene(
            ropes=[Rope(segments=4, made_of=made_of, shape=Straight(end=(reach, 0.0, 0.0)))],
            anchors=[Anchor(node=0)],
            gravity=(0.0, 0.0, 0.0),
            run={"duration": 0.5},
        )
        for reach in (8.0, 3.0)
    )
    found = check(long)
    assert not found.ok
    text = "4 of 4 segments start at up to 20 times their rest length: the run breaks at once"
    assert any(text in warning for warning in found.warnings)
    assert simulate(long, on_failure="return").status == "broke"
    assert check(short).ok
    assert simulate(short, on_failure="return").status == "finished"


def test_a_release_inside_a_step_is_told_where_steps_are_not_cut() -> None:
    """By semi-implicit Euler, and where it is late by more than 1 ms."""

    def said(method: str, step: float, time: float) -> str:
        ends = [Anchor(node=0), Anchor(node=-1, name="far", release_time=time)]
        run = {"method": method, "time_step": step, "duration": 1.0}
        return " ".join(check(Scene(ropes=[material()], anchors=ends, run=run)).warnings)

    text = "'far': release_time = 0.501 s lies inside a step of 16.67 ms; it lets go at 0.516667 s"
    assert text in said("semi-implicit-euler", 1.0 / 60.0, 0.501)
    assert "release_time" not in said("semi-implicit-euler", 1.0 / 60.0, 0.5)
    assert "release_time" not in said("semi-implicit-euler", 0.001, 0.5005)
    for method in ("esdirk3", "adaptive"):
        assert "release_time" not in said(method, 1.0 / 60.0, 0.501)


def test_of_very_many_nodes_no_steps_are_run_for_the_estimate(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two implicit steps of 100 000 nodes took 18 s, of a million minutes."""

    def refuse(self: Simulation, duration: float) -> None:
        raise AssertionError("a step was run")

    monkeypatch.setattr(Simulation, "step", refuse)
    monkeypatch.setattr("ropewalk.analysis.cost.is_compiled", lambda *_: True)
    made_of = Material(EA=1e7, mass_per_length=0.1)
    rope = Rope(segments=20_000, length=1000.0, made_of=made_of, shape=Slack(end=(900.0, 0, 0)))
    ends = [Anchor(node=0), Anchor(node=-1)]
    seconds, measured = seconds_per_step(build(Scene(ropes=[rope], anchors=ends)))
    assert not measured
    assert seconds > 0.0
    assert "(not measured)" in str(check(scene(), measure=False))
    with pytest.raises(AssertionError, match="a step was run"):  # the twin
        seconds_per_step(build(Scene(ropes=[rope.replace(segments=20)], anchors=ends)))


def test_a_shape_that_starts_pressed_is_told() -> None:
    """Chords of a hanging rope of EA 1 MN are 0.09 % short: 899 N, where it carries 2.9 N at rest.

    The twins: a start at rest, a rope that cannot push, and one that is soft.
    """

    def told(EA: float = 1e6, tension_only: bool = False, start: str = "shape") -> list[str]:
        line = Material(EA=EA, mass_per_length=0.1, axial_damping=10.0, tension_only=tension_only)
        rope = Rope(segments=20, length=5.0, made_of=line, shape=Slack(end=(4.0, 0.0, 0.0)))
        hung = Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)], run={"start": start})
        return [text for text in check(hung, measure=False).warnings if "starts it pressed" in text]

    (text,) = told()
    assert "by up to 898.7 N, where it carries 2.859 N at rest" in text
    assert told(start="at-rest") == []
    assert told(tension_only=True) == []
    assert told(EA=1e3) == []


def test_nothing_is_said_of_rest_where_ropes_touch_each_other() -> None:
    """It once said 0 N and 0 % of the breaking load; without contact it says what they are."""
    made_of = Material(EA=1e4, mass_per_length=0.1, breaking_load=1e3)
    rope = Rope(segments=5, length=1.0, diameter=0.01, made_of=made_of, shape=Straight())
    anchors = (Anchor(node=0), Anchor(node=-1))
    run = RunSettings(method="implicit-euler", time_step=0.01)
    apart = check(Scene(run=run, ropes=(rope,), anchors=anchors), measure=False)
    found = check(Scene(run=run, ropes=(rope,), anchors=anchors, contact=Contact()), measure=False)
    assert "at rest: largest tension" in "\n".join(apart.lines())
    assert "at rest:" not in "\n".join(found.lines())
    assert any("is not looked for" in warning for warning in found.warnings)
    told = json.loads(json.dumps(found.as_dict()))
    assert (told["statics"]["largest_tension"], told["statics"]["spans"]) == (None, [])
    assert (told["ropes"][0]["largest_tension"], told["ropes"][0]["utilisation"]) == (None, None)
