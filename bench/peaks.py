"""What a look at every step costs: the same kernel with and without the extremes, in turns."""

from __future__ import annotations

from collections.abc import Callable

from bench.clock import take_turns
from bench.row import Row
from ropewalk import Anchor, Material, Rope, RunSettings, Scene, Simulation
from ropewalk.methods.recording import make_recording

SEGMENTS = 100
FRICTION = {"": {}, ", axial friction": {"axial_damping": 10.0}}
STEPS = {"semi-implicit-euler": 900, "verlet": 900, "esdirk3": 20}


def stepper(method: str, friction: dict[str, float], *, extremes: bool) -> Callable[[], None]:
    """Return a function that takes steps of one frame of a rope held at both ends, without a ledger."""
    made_of = Material(EA=1e4, mass_per_length=0.1, **friction)
    step = 1.0 / 60.0 if method == "esdirk3" else 1e-5
    run = RunSettings(
        method=method, time_step=step, frame_rate=60.0, duration=60.0, extremes=extremes
    )
    ends = [Anchor(node=0), Anchor(node=-1)]
    rope = Rope(segments=SEGMENTS, length=5.0, made_of=made_of)
    simulation = Simulation(Scene(ropes=[rope], anchors=ends, run=run), ledger=False)
    nothing = make_recording(simulation.arrays, 0, False)
    return lambda: simulation._advance(STEPS[method], 1, nothing)  # type: ignore[func-returns-value]


def extremes() -> list[Row]:
    """The greatest and least of every step, 100 segments without a ledger, against the step without."""
    rows = []
    for method in STEPS:
        for name, friction in FRICTION.items():
            runs = {
                how: stepper(method, friction, extremes=how == "with")
                for how in ("with", "without")
            }
            timing = take_turns(runs, rounds=200)
            more = 100.0 * (timing.ratio("with", "without") - 1.0)
            rows.append(Row(f"extremes of every step, {method}{name}", more, "%", "<= 5"))
    return rows
