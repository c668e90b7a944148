"""Long calls of the kernels are cut by the clock, so that Ctrl-C is heard; no bit changes by it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from ropewalk.core.arrays import flatten
from ropewalk.core.status import OK
from ropewalk.engine.slices import GROWTH, SLICE, Edges, Slices
from ropewalk.methods.recording import Recording
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation
from runs import hanging


def test_slices_grow_and_shrink_with_what_a_step_costs() -> None:
    """A slice aims at SLICE seconds, grows by at most GROWTH, and is never less than a step."""
    slices = Slices(100, 60.0)

    def spend(steps: int, seconds: float) -> int:
        slices.note(steps, seconds)
        return slices.most

    assert spend(100, 1.0) == int(100 * SLICE)
    assert spend(10, 1e-9) == int(GROWTH * 10)
    assert spend(1, 60.0) == 1  # compiled on the way
    assert spend(1, 1e-6) == int(GROWTH)
    assert spend(0, 60.0) == int(GROWTH)  # nothing was done, nothing learned


@pytest.mark.parametrize(("frames", "most", "calls"), [(60, 29, [20, 20, 20]), (7, 4, [4, 3])])
def test_calls_of_a_block_are_about_as_long(frames: int, most: int, calls: list[int]) -> None:
    """No short call is left over: its steps cost more, and the next block would be cut by that."""
    seen: list[int] = []

    def call(
        steps: int, count: int, out: Recording, stop: bool, edges: Edges
    ) -> tuple[int, int, int]:
        seen.append(count)
        return OK, count, 0

    out = Recording(*(np.zeros((frames, 0)) for _ in Recording._fields))
    slices = Slices(1, 1.0)
    slices.most = most * 2 + 1
    assert slices.run(call, lambda: lambda: None, 2, frames, out, True) == (OK, frames)
    assert seen == calls


class Counted(Slices):
    """Slices of a fixed length, which count the calls."""

    def __init__(self, most: int, method: str) -> None:
        super().__init__(1, 1.0, method != "adaptive")
        self.most = most
        self.calls: list[int] = []

    def note(self, steps: int, seconds: float) -> None:
        self.calls.append(steps)


def scene(method: str) -> Scene:
    """A shaken rope whose end is let go, 50 steps a frame or as many as the tolerance takes."""
    made = hanging(duration=0.2, frame_rate=20, time_step=0.001, segments=4, spring_constant=100.0)
    return (
        made.replace(run=made.run.replace(method=method, time_step="auto", tolerance=1e-5))
        if (method == "adaptive")
        else made.replace(run=made.run.replace(method=method))
    )


METHODS = {"semi-implicit-euler": 7, "esdirk3": 7, "adaptive": 2}  # and steps in a slice


def frames(simulation: Simulation) -> np.ndarray:
    """The places of all frames in one block."""
    return simulation.advance_frames(4).recording.x


@pytest.mark.parametrize("method", METHODS)
def test_slices_change_no_bit(method: str) -> None:
    """Calls of seven steps end inside frames; places and the whole state are those of whole frames."""
    whole, cut = Simulation(scene(method)), Simulation(scene(method))
    whole.slices = Counted(10**9, method)
    cut.slices = slices = Counted(METHODS[method], method)
    assert np.array_equal(frames(whole), frames(cut))
    for name, array in flatten(whole.arrays).items():
        assert np.array_equal(array, flatten(cut.arrays)[name], equal_nan=True), name
    assert whole.time == cut.time
    assert len(whole.slices.calls) == 1
    assert len(slices.calls) > 8
    assert max(slices.calls) < 20  # a try that fails is tried again in the same call


def answers(count: int) -> Iterator[bool]:
    """No, so many times; then yes."""
    yield from [False] * count
    while True:
        yield True


@pytest.mark.parametrize("method", METHODS)
def test_a_request_stops_inside_a_frame(method: str) -> None:
    """What was begun of a frame is dropped; the run goes on from there to the same bits."""
    whole, stopped = Simulation(scene(method)), Simulation(scene(method))
    expected = frames(whole)
    stopped.slices = Counted(METHODS[method], method)
    asked = answers(8)
    stopped.slices.asked = lambda: next(asked)
    block = stopped.advance_frames(4)
    assert block.status == 0
    assert 0 < block.frames < 4
    assert stopped.time == pytest.approx(0.05 * block.frames, abs=1e-12)
    assert np.array_equal(block.recording.x, expected[: block.frames])
    stopped.slices.asked = None
    rest = stopped.advance_frames(4 - block.frames)
    assert np.array_equal(rest.recording.x, expected[block.frames :])


@pytest.mark.parametrize("method", METHODS)
def test_an_interrupt_is_heard_inside_a_frame(method: str) -> None:
    """Between two slices Python runs: a handler may raise. Then state and time still belong together."""

    class Struck(Counted):
        def note(self, steps: int, seconds: float) -> None:
            super().note(steps, seconds)
            if len(self.calls) == 3:
                raise KeyboardInterrupt

    simulation, plain = Simulation(scene(method)), Simulation(scene(method))
    simulation.slices, plain.slices = Struck(METHODS[method], method), Counted(10**9, method)
    with pytest.raises(KeyboardInterrupt):
        simulation.step()
    if method == "adaptive":  # part of its walk is done, and nothing shown
        assert simulation.time == 0.0
    else:
        assert simulation.time == pytest.approx(0.021, abs=1e-12)
        plain.advance_steps(21)
    assert np.array_equal(simulation.positions, plain.positions)
    simulation.slices = Counted(10**9, method)
    simulation.step(0.05)
