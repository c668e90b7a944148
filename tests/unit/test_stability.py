"""Stability of scenes: the report's numbers, and runs from both sides of the bound."""

from __future__ import annotations

import dataclasses
import json
import math

import numpy as np
import pytest

from ropewalk.analysis.check import check
from ropewalk.analysis.linear_theory import sideways_share
from ropewalk.analysis.stability import Stability, stability
from ropewalk.live.meter import measure
from ropewalk.lowering import build
from ropewalk.lowering.choice import accurate_step
from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Air,
    Anchor,
    Ground,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Springs,
    Straight,
    Winch,
)
from ropewalk.scene.presets import preset
from ropewalk.simulation import Broken, Simulation
from ropewalk.words.safe_side import longest_step, rounded_down, rounded_up


def report(
    k: float = 10000.0,
    dt: float | str = 0.002,
    c: float = 0.05,
    section: int = 20,
    method: str = "semi-implicit-euler",
    friction: str = "vector",
    duration: float = 10.0,
    gravity: float = 9.81,
    anchors: tuple[Anchor, ...] | None = None,
    **more: object,
) -> Scene:
    """The report's three-anchor scene."""
    rope = Rope(
        segments=2 * section,
        made_of=Springs(
            spring_constant=k,
            node_mass=0.05,
            spring_friction=c,
            segment_length=1.0,
            friction=friction,
        ),
        shape=Straight(start=(0, 0, 0)),
    )
    return Scene(
        gravity=(0, -gravity, 0),
        run=RunSettings(duration=duration, time_step=dt, steps="exact", method=method),
        ropes=(rope,),
        anchors=anchors or tuple(Anchor(node=node) for node in (0, section, 2 * section)),
        **more,
    )


def mu(n: int) -> float:
    return 4.0 * math.sin(n * math.pi / (2 * (n + 1))) ** 2


@pytest.mark.parametrize(
    ("k", "dt", "meter", "stable"),
    [
        (10000.0, 0.002, 3.216, True),
        (10000.0, 1 / 60, 222.4, False),
        (200.0, 1 / 60, 4.578, False),
        (180.0, 1 / 60, 4.133, False),
        (100.0, 1 / 60, 2.356, True),
    ],
)
def test_the_reports_observations(k: float, dt: float, meter: float, stable: bool) -> None:
    found = stability(report(k, dt))
    assert found.meter == pytest.approx(meter * mu(19) / 4.0, rel=2e-4)
    assert found.stable is stable
    assert found.breaks is not stable
    assert found.largest_spring_constant == pytest.approx(
        4 / mu(19) * 0.05 / dt**2 - 2 * 0.05 / dt, rel=1e-6
    )
    assert found.highest_frequency == pytest.approx(math.sqrt(k * mu(19) / 0.05), rel=1e-12)
    assert ("will break" in found.verdict) is not stable
    assert bool(found.remedies) is not stable


def test_bounds_of_all_methods_at_once() -> None:
    found = stability(report(section=200))
    table = {"euler": 0.005, "heun": 0.296, "semi-implicit-euler": 2.231, "rk4": 3.168}
    for name, limit in table.items():
        assert 1e3 * found.largest_step[name] == pytest.approx(limit, rel=2e-3)
    assert set(found.largest_step) == set(METHODS)
    assert found.margin == pytest.approx(found.bound / 0.002 - 1.0)
    assert 0.1 < found.margin < 0.13


def test_growth_of_the_shortest_rope_that_breaks() -> None:
    # k 200 at 60 Hz is stable with up to 4 springs per section and unstable from 5 on.
    assert stability(report(200.0, 1 / 60, section=4)).stable
    assert stability(report(200.0, 1 / 60, section=5)).breaks


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet", "rk4", "heun", "euler"])
def test_runs_break_above_the_bound_and_not_below(method: str) -> None:
    # A straight chain without weight: the theory is exact. 1e-6 m of disturbance, 5000 steps.
    bound = stability(report(300.0, 0.001, c=1.2, section=5, method=method)).bound
    assert bound > 0.0
    left = []
    for factor in (0.99, 1.01):
        dt = factor * bound
        model = build(report(300.0, dt, c=1.2, section=5, method=method, gravity=0.0))
        start = model.state.x.copy()
        model.state.x[:, 1:5] += 1e-6 * np.random.default_rng(0).normal(size=(3, 4))
        simulation = Simulation(model)
        try:
            simulation.step(5000 * dt)
            left.append(float(np.abs(simulation.positions.T - start).max()))
        except Broken:
            left.append(math.inf)
    assert left[0] < 1e-5
    assert left[1] > 1e-3


def test_ground_lowers_the_bound_and_is_named() -> None:
    ground = Ground(height=-1.0, repulsion=5000.0, friction=0.2, absorption=2.0)
    found = stability(report(ground=ground))
    assert found.case.startswith("pressed")
    m, dt = 0.05, found.bound
    a = (10000.0 * mu(19) + 5000.0) * dt * dt / m
    b = (0.05 * mu(19) + 2.0) * dt / m
    assert a + 2 * b == pytest.approx(4.0, rel=1e-9)
    assert found.bound < stability(report()).bound
    assert set(found.cases) == {"in the air", "pressed to the ground", "sliding on the ground"}


def test_a_stable_step_that_contact_asks_for_says_so() -> None:
    """It was said where a run breaks only; a hard contact took 100 000 steps a second without a word."""
    made_of = {"kind": "material", "EA": 100.0, "mass_per_length": 0.1}
    rope = {"segments": 4, "length": 0.4, "diameter": 0.01, "made_of": made_of}
    ball = {"kind": "sphere", "center": [0, 0, -1], "radius": 0.5, "compliance": 1e-7}
    run = {"method": "semi-implicit-euler", "duration": 0.1, "time_step": 1e-6}
    there = Scene.model_validate({"rope": [rope], "obstacle": [ball], "run": run})
    found = stability(build(there))
    assert f"{longest_step(found.bound)} where it is pressed to obstacles, margin" in found.verdict
    both = dataclasses.replace(
        found, case="pressed to ropes, pressed to obstacles, with all rope paid out"
    )
    said = "where it is pressed to ropes and to obstacles, with all rope paid out, margin"
    assert said in both.verdict
    alone = stability(build(there.replace(obstacles=[])))
    assert alone.bound > 10.0 * stability(build(there)).bound
    assert "pressed" not in alone.verdict


def test_where_contact_breaks_a_run_is_said_once() -> None:
    scene = preset("pile").replace(**{"run.method": "verlet", "run.time_step": 1e-3})
    broken = check(scene, measure=False).warnings[0]
    assert broken.count("pressed to") == 1
    assert "where it is pressed to" in broken


def test_a_released_anchor_counts_as_free() -> None:
    def found(release: float | None) -> Stability:
        middle = Anchor(node=2, release_time=release)
        return stability(report(section=2, anchors=(Anchor(node=0), middle, Anchor(node=4))))

    held, free = found(None), found(1.0)
    assert held.highest_frequency == pytest.approx(math.sqrt(2e5 * mu(1)), rel=1e-9)
    assert free.highest_frequency == pytest.approx(math.sqrt(2e5 * mu(3)), rel=1e-9)


def test_material_does_not_depend_on_its_segments_but_the_bound_does() -> None:
    def scene(segments: int) -> Scene:
        rope = Rope(
            segments=segments,
            made_of=Material(EA=1e4, mass_per_length=0.05),
            length=10.0,
            shape=Straight(start=(0, 0, 0)),
        )
        run = RunSettings(time_step=1e-4)
        return Scene(run=run, ropes=(rope,), anchors=(Anchor(node=0), Anchor(node=-1)))

    coarse, fine = stability(scene(20)), stability(scene(40))
    # CFL: dt = l / c, c = sqrt(EA / mu), but for the finite chain.
    for found, n in ((coarse, 20), (fine, 40)):
        expected = 10.0 / n / math.sqrt(1e4 / 0.05) * 2.0 / math.sqrt(mu(n - 1))
        assert found.bound == pytest.approx(expected, rel=1e-9)
    factor = coarse.largest_spring_factor
    assert coarse.largest_axial_stiffness == pytest.approx(1e4 * factor)
    assert coarse.largest_spring_constant is None


@pytest.mark.parametrize(
    "more",
    [
        {"EA": 1e4, "relaxing_EA": 5e4, "relaxation_time": 0.1},
        {"curve": {"kind": "polynomial", "coefficients": [1e4, 1e5], "largest_strain": 0.3}},
    ],
)
def test_no_EA_is_advised_where_it_is_not_all_of_the_stiffness(more: dict[str, object]) -> None:
    """EA <= 608 N was advised beside a relaxing_EA of 50 kN, and of a curve, which has its own EA."""
    made_of = Material.model_validate({"kind": "material", "mass_per_length": 0.05, **more})
    rope = Rope(segments=20, made_of=made_of, length=10.0, shape=Straight(start=(0, 0, 0)))
    run = RunSettings(time_step=2e-3, method="semi-implicit-euler", duration=1.0)
    model = build(Scene(run=run, ropes=(rope,), anchors=(Anchor(node=0),)))
    found, shown = stability(model), measure(model)
    assert not found.stable
    assert found.largest_spring_factor < 1.0
    assert shown["largest_axial_stiffness"] is None
    assert shown["largest_spring_constant"] is None
    assert found.largest_axial_stiffness is None
    assert not any(remedy.startswith("EA") for remedy in found.remedies)


def test_a_winch_takes_its_shortest_segment() -> None:
    still = stability(report(section=10))
    turning = stability(report(section=10, winches=(Winch(end="start", speed=-0.5),)))
    assert "winch" in turning.case
    assert turning.bound < 0.85 * still.bound


def test_a_rope_on_a_drum_falls_as_far_as_one_that_is_out() -> None:
    """Only what was out at the start counted: where drag decides the bound was up to twice as long."""

    def hanging(out: float, **drum: float) -> Scene:
        made_of = Material(EA=200.0, mass_per_length=0.02)
        rope = Rope(
            segments=round(4.0 * out),
            length=out,
            diameter=0.02,
            made_of=made_of,
            shape=Straight(end=(0, 0, -out)),
        )
        return Scene(
            ropes=[rope],
            anchors=[Anchor(node=0)],
            air=Air(density=1000.0, normal_coefficient=1.2),
            winches=[Winch(end="start", speed=0.5, **drum)],
            run={"duration": 6.0, "method": "verlet", "time_step": 1e-5},
        )

    drops = hanging(1.0, on_drum=2.0), hanging(1.0, on_drum=9.0, max_length=3.0)
    out, short = (stability(hanging(length, on_drum=0.0)).bound for length in (3.0, 1.0))
    assert out < 0.8 * short
    for drop in drops:
        assert stability(drop).bound == pytest.approx(out, rel=0.03)

    def accurate(drum: float) -> float:
        model = build(hanging(5.0, on_drum=drum))
        return accurate_step("rk4", model.scene, model.system, model.state)

    assert accurate(2.0) == accurate(200.0)  # for what is out


def test_weak_growth_is_told_from_breaking() -> None:
    # Heun without sideways friction: formally unstable, y^4/8 per step.
    slow = stability(report(100.0, 1e-4, c=0.0, method="heun", duration=1.0))
    assert slow.bound == 0.0
    assert not slow.stable
    assert not slow.breaks
    y = slow.highest_frequency * 1e-4
    assert math.log(slow.growth_per_step) == pytest.approx(y**4 / 8, rel=1e-2)
    assert any("heun has no stable step" in note and "y^4/8" in note for note in slow.notes)
    fast = stability(report(10000.0, 0.001, c=0.0, method="heun", duration=10.0))
    assert fast.breaks
    axial = stability(report(100.0, 1e-4, c=0.5, friction="axial", method="euler"))
    assert axial.bound == 0.0
    assert any("sideways" in note for note in axial.notes)
    assert "verlet" in " ".join(axial.remedies)


def test_node_of_the_worst_mode_follows_the_light_part() -> None:
    scene = report(section=10)
    rope = scene.ropes[0]
    heavy = tuple(Load(node=node, mass=0.5) for node in range(1, 20) if node not in (14, 15, 16))
    made = scene.model_copy(update={"ropes": (rope.model_copy(update={"loads": heavy}),)})
    found = stability(made)
    assert found.rope == "rope"
    assert found.node in (14, 15, 16)


def test_quadratic_drag_counts_at_the_speed_of_a_fall() -> None:
    air = Air(node_drag_quadratic=0.1)
    assert stability(report(air=air)).bound < stability(report()).bound
    far = stability(report(section=80, air=air)).bound  # falls faster
    assert far < stability(report(section=20, air=air)).bound


def test_sideways_share_is_the_swing_or_the_limiters() -> None:
    soft = build(report(50.0))
    assert 0.1 < sideways_share(soft) <= 1.0
    limited = build(report(50.0, limiter=Limiter(min_stretch=0.9, max_stretch=1.05)))
    assert sideways_share(limited) == pytest.approx(1.0 - 1.0 / 1.05)


def test_text_and_json() -> None:
    found = stability(report(200.0, 1 / 60))
    assert repr(found).startswith("Stability: will break at 16.67 ms")
    text = json.dumps(found.as_dict(), allow_nan=False)
    assert json.loads(text)["largest_step"]["rk4"] == pytest.approx(found.largest_step["rk4"])
    remedies = dict(part.split(" <= ") for part in found.remedies if "<=" in part)
    assert float(remedies["time_step"].split()[0]) < found.bound
    assert float(remedies["spring_constant"].split()[0]) == 175.0
    # Each remedy really is one.
    assert stability(report(200.0, float(remedies["time_step"].split()[0]))).stable
    assert stability(report(175.0, 1 / 60)).stable
    assert stability(report(200.0, 1 / 60, method="rk4")).stable


def test_rounding_never_goes_up() -> None:
    rng = np.random.default_rng(4)
    for value in 10.0 ** rng.uniform(-9, 9, 500):
        shown = float(rounded_down(value))
        assert shown <= value * (1 + 1e-9)
        assert shown > 0.989 * value
        assert float(rounded_down(value, 4)) <= value * (1 + 1e-9)
        above = float(rounded_up(value, 4))
        assert value * (1 - 1e-9) <= above < 1.0011 * value
    assert rounded_down(8074.3) == "8070"
    assert (rounded_down(1.58453, 4), rounded_up(1.5841, 4)) == ("1.584", "1.585")


@pytest.mark.parametrize("constant", [171.0, 173.0, 176.0, 178.0, 179.0])
def test_the_largest_step_that_is_told_is_stable(constant: float) -> None:
    """To the nearest it was told as one that breaks, for half of all scenes: 1.585 ms of 1.58453."""
    found = check(report(constant, 0.001), measure=False)
    told = found.stability.verdict.partition("euler ")[2].partition(" ms")[0]
    assert 0.999 * found.stability.bound < 1e-3 * float(told) <= found.stability.bound
    listed = [line.split() for line in found.lines(all_methods=True) if line.startswith("  ")]
    steps = {words[0]: words[1] for words in listed if words[-1] == "ms"}
    assert len(steps) > 3
    for method, text in steps.items():
        assert 1e-3 * float(text) <= found.stability.largest_step[method]


def test_no_limit_is_said_so() -> None:
    rope = Rope(
        segments=1,
        made_of=Springs(spring_constant=1.0, node_mass=1.0, segment_length=1.0),
        shape=Straight(start=(0, 0, 0)),
    )
    held = (Anchor(node=0), Anchor(node=1))
    found = stability(Scene(run=RunSettings(time_step=0.01), ropes=(rope,), anchors=held))
    assert isinstance(found, Stability)
    assert found.bound == math.inf
    assert found.stable
    assert "no limit" in found.verdict
    assert found.as_dict()["margin"] is None


def test_the_implicit_method_that_is_recommended_to_a_limiter_can_work_with_it() -> None:
    scene = preset("h2")
    scene = scene.replace(run=scene.run.replace(time_step=0.5, method="semi-implicit-euler"))
    assert "bdf2" in " ".join(stability(scene).remedies)
    build(scene.replace(run=scene.run.replace(method="bdf2")))
    with pytest.raises(SceneError, match="stretch limiter"):  # the twin
        build(scene.replace(run=scene.run.replace(method="sdirk2")))


@pytest.mark.parametrize("weak", [5e-324, 1e-308, 1e-200])
def test_rods_of_next_to_no_stiffness(weak: float) -> None:
    """The factor on them up to the bound is no number: the largest EI must be told without one."""
    settings = RunSettings(duration=1.0, time_step=1e-3)

    def largest(EI: float) -> float | None:
        made_of = Material(EA=1e3, EI=EI, mass_per_length=0.1)
        rope = Rope(segments=10, length=5.0, made_of=made_of)
        scene = Scene(ropes=rope, anchors=[Anchor(node=0)], run=settings)
        return stability(build(scene)).largest_bending_stiffness

    assert largest(weak) == pytest.approx(largest(1e-6), rel=1e-3)


def test_only_what_is_asked_for_is_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A verdict on one method asks for no other bound, no rest shape, no largest stiffness."""
    from ropewalk.analysis import linear_theory
    from ropewalk.lowering.steps import Cases

    asked: list[str] = []
    real = Cases.largest
    monkeypatch.setattr(
        Cases, "largest", lambda self, method: asked.append(method) or real(self, method)
    )
    for name in ("static_shape", "largest_stiffness_factor", "growth_per_step", "worst_mode"):
        real_one = getattr(linear_theory, name)

        def seen(*args: object, name: str = name, real_one: object = real_one, **more: object):
            asked.append(name)
            return real_one(*args, **more)

        monkeypatch.setattr(linear_theory, name, seen)
    made = build(preset("r4"))
    asked.clear()
    found = stability(made)
    assert found.stable
    assert found.verdict
    assert found.margin > 0.0
    assert asked == [made.plan.method]
    assert found.largest_step["rk4"] > 0.0
    assert found.growth_per_step <= 1.0
    assert found.node >= 0
    assert {"rk4", "growth_per_step", "worst_mode"} <= set(asked)  # the twin
    assert "euler" not in asked
    assert dict(found.largest_step).keys() >= {"euler", "bdf2"}
