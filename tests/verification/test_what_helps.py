"""What is told to do where contacts end a run: something that the method at hand has, and that helps."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.engine.broken import off_rope
from ropewalk.engine.too_near import fault_of, finer, refused_pair
from ropewalk.laws.pairs.table import CROWDED, FAULT, FULL, PASSED, REFUSED
from ropewalk.laws.slides.sliding import FAULT as SLIDES_FAULT
from ropewalk.laws.slides.sliding import LOST
from ropewalk.lowering import Model, build
from ropewalk.lowering.contact_checks import can_touch
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Contact, Kick, Material, Points, Rope, RunSettings, Scene, Sphere

ABLE = [name for name in METHODS if can_touch(name)]
EXPLICIT = [name for name in ABLE if not METHODS[name].implicit]


def model_of(method: str, *, time_step: float | str = "auto", thrown: bool = False) -> Model:
    points = [(0.01 * i, 0.0, 0.0) for i in range(9)]
    rope = Rope(
        segments=8,
        length=0.08,
        diameter=0.01,
        made_of=Material(EA=1e3, mass_per_length=0.1, axial_damping=0.1),
        shape=Points(points=points),
        kicks=[Kick(node=1, velocity=(0, 1, 0))] if thrown else [],
    )
    run = RunSettings(method=method, time_step=time_step, tolerance=2e-5)
    ball = Sphere(center=(0, 0, -1), radius=0.1)
    return build(Scene(ropes=[rope], obstacles=[ball], contact=Contact(), run=run))


def with_fault(model: Model, what: str) -> str:
    """What is said of a state of a model after something went wrong with its contacts."""
    memory, rest = model.state.memory, (model.state, model.layout, model.scene, model.plan)
    if what in ("through", "fault"):
        getattr(memory.obstacle, what)[2] = 1
    elif what == "refused":
        memory.contact.tally[REFUSED] = 1
    else:
        memory.contact.tally[FAULT] = {"passed": PASSED, "full": FULL, "crowded": CROWDED}[what]
    return refused_pair(*rest) if what in ("through", "refused") else fault_of(*rest)


@pytest.mark.parametrize(
    ("method", "time_step"),
    [(name, 1e-3) for name in ABLE]
    + [(name, "auto") for name in ABLE if name not in ("euler", "heun")],
)
@pytest.mark.parametrize("what", ["through", "fault", "refused", "passed", "full", "crowded"])
def test_every_method_is_told_what_it_has(what: str, method: str, time_step: float | str) -> None:
    """A step by its number, also where it was automatic; `adaptive` its tolerance, and its longest step.

    It was told to take a shorter time_step, which is not its step; and implicit-euler to take implicit-euler.
    """
    model = model_of(method, time_step=time_step)
    said = with_fault(model, what)
    assert said
    steps = what not in ("full", "crowded")
    if method == "adaptive":
        assert ("a tolerance below 0.02 mm" in said) is steps
        assert ("a shorter longest step (a time_step)" in said) is steps
        assert "time_step below" not in said
    else:
        assert (f"a time_step below {1e3 * model.plan.dt:.3g} ms" in said) is steps
        assert "tolerance" not in said
    assert ("implicit-euler" in said) is (what in ("fault", "passed") and method in EXPLICIT)
    assert "slower" not in said  # nothing moves


@pytest.mark.parametrize("what", ["through", "fault", "refused", "passed"])
def test_a_slower_start_is_named_where_something_is_thrown(what: str) -> None:
    for method in ABLE:
        assert "a slower start" in with_fault(model_of(method, time_step=1e-3, thrown=True), what)


def test_a_tenth_of_the_longest_step_is_proposed() -> None:
    """To `adaptive`, which takes its own; a method of given steps is told of these."""
    plan = model_of("adaptive").plan
    assert finer(plan, 2.2e-4)[1] == "a shorter longest step (a time_step of 0.02 ms or less)"
    fixed = model_of("sdirk2", time_step=1e-3).plan
    assert finer(fixed, 2.2e-4) == finer(fixed) == (f"a time_step below {1e3 * fixed.dt:.3g} ms",)


def off_its_line(method: str) -> str:
    """What is said of a node that was pulled off the rope that it slides along."""
    line = Rope(
        name="line", segments=4, length=1.0, made_of=Material(EA=1e3, mass_per_length=0.1),
        shape=Points(points=[(0.25 * i, 0, 0) for i in range(5)]),
    )  # fmt: skip
    rider = Rope(
        name="rider", segments=1, length=0.1, made_of=Material(EA=1e3, mass_per_length=0.1),
        shape=Points(points=[(0.5, 0, 0), (0.5, 0, -0.1)]),
    )  # fmt: skip
    model = build(
        Scene(
            ropes=[line, rider],
            anchors=[rw.Anchor(rope="line", node=node) for node in (0, -1)],
            slides=[rw.Slide(rope="rider", node=0, on="line")],
            run=RunSettings(method=method, time_step=1e-3),
        )
    )
    assert off_rope(model.state, model.layout, model.system, model.plan) == ""
    model.state.memory.slide.tally[SLIDES_FAULT] = LOST
    return off_rope(model.state, model.layout, model.system, model.plan)


def test_what_is_pulled_off_its_line_is_told_of_the_method_too() -> None:
    assert "take a time_step below 0.98 ms, or a stiffer slide" in off_its_line("sdirk2")
    assert "take a tolerance below 0.01 mm, a shorter longest step" in off_its_line("adaptive")


def test_adaptive_says_so_at_the_end_of_a_run() -> None:
    """A ball at 1 km/s into a rope; `adaptive` names a tenth of the longest step that it took."""
    points = [(0.1 * i - 0.5, 0.0, 0.5) for i in range(11)]
    rope = Rope(
        segments=10, length=1.0, made_of=Material(EA=1e3, mass_per_length=0.1), diameter=0.01,
        shape=Points(points=points),
    )  # fmt: skip
    motion = {"kind": "velocity", "velocity": (0.0, 0.0, 1000.0)}
    ball = Sphere(center=(0.0, 0.0, 0.0), radius=0.2, motion=motion)
    run = RunSettings(method="adaptive", duration=0.1, frame_rate=60.0)
    with pytest.raises(rw.BrokenRun) as caught:
        rw.simulate(Scene(ropes=[rope], obstacles=[ball], run=run))
    said = str(caught.value)
    assert "Try a tolerance below 0.01 mm, a shorter longest step (a time_step of 0.00" in said
    assert "a slower obstacle" in said
    assert "a shorter time_step" not in said
