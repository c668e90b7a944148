"""Ropes side by side that are interrupted or asked to stop stand where they stood, or at a whole frame."""

from __future__ import annotations

from threading import Condition, Event, Thread
from time import sleep
from typing import Any
from unittest import mock

import pytest

from patience import PATIENCE
from property.test_abreast import ropes_of
from property.test_abreast_runs import compiled, numbers, told
from ropewalk.engine import abreast, islands
from ropewalk.engine.abreast import go_abreast
from ropewalk.engine.gate import Gate
from ropewalk.engine.islands import Islands
from ropewalk.engine.slices import Slices
from ropewalk.lowering import build
from ropewalk.methods.recording import make_recording
from ropewalk.simulation import Simulation


@compiled
@pytest.mark.parametrize("calls", [0, 1])
def test_ctrl_c_leaves_all_ropes_where_they_stood(calls: int) -> None:
    """After the call of the first crew, and after that of the second."""
    scene = ropes_of(17, 12, 4, "sdirk2")
    simulation, twin = Simulation(scene), Simulation(scene)
    expected = [told(twin.advance_frames(2)), told(twin.advance_frames(3)), numbers(twin)]
    found = [told(simulation.advance_frames(2))]
    stood, true, left = numbers(simulation), abreast._call, iter(range(calls))

    def call(*args: Any) -> Any:
        done = true(*args)
        if next(left, None) is None:
            raise KeyboardInterrupt
        return done

    with mock.patch.object(abreast, "_call", call), pytest.raises(KeyboardInterrupt):
        simulation.step()
    assert numbers(simulation) == stood
    found += [told(simulation.advance_frames(3)), numbers(simulation)]
    assert found == expected


@compiled
@pytest.mark.parametrize("asks", range(1, 9))
def test_one_that_is_asked_to_stop_stands_at_a_whole_frame(asks: int) -> None:
    """Frames of many steps, each cut several times, in crews and in the calls for all of them."""
    scene = ropes_of(18, 12, 3, "sdirk2", steps=3)
    run = scene.run.model_copy(update={"time_step": 1.0 / 60.0 / 40, "frame_rate": 60.0})
    simulation, twin = Simulation(scene.replace(run=run)), Simulation(scene.replace(run=run))
    slow = {"span": 1e-9}  # every call is of as few steps as may be
    simulation.slices, left = Slices(10**9, 1.0, **slow), [asks]
    engine = simulation._engine
    assert isinstance(engine, Islands)
    for mate in engine._crews.mates:
        mate.engine.make_slices = lambda ropes=1: Slices(10**6, 1.0, span=0.05)  # type: ignore[method-assign]

    def ask() -> bool:
        left[0] -= 1
        return left[0] == 0  # once: whoever is asked again hears no

    simulation.slices.asked = ask
    found = told(simulation.advance_frames(2))
    assert simulation.clock[2] % 40 == 0
    twin.advance_frames(simulation.clock[2] // 40)
    assert numbers(simulation) == numbers(twin)
    assert found[1] == simulation.clock[2] // 40


def test_a_call_that_stops_in_a_frames_last_cut_is_taken_back() -> None:
    """Twin: one that does not stop leaves the state alone."""
    model = build(ropes_of(19, 2, 3, "sdirk2"))
    nothing = make_recording(model.state, 0, False)
    for stops in (None, 1, 2, 3):
        slices, backs, calls = Slices(1, 1.0, span=1e-9), [], [0]
        slices.most, slices.asked = 2, lambda: False

        def call(steps: int, frames: int, *_: Any, stops: Any = stops, calls: Any = calls) -> Any:
            calls[0] += 1
            paused = calls[0] == stops
            return 0, 0 if paused else frames, 0 if paused else steps

        with mock.patch.object(slices, "note"):
            status, good = slices._cut_frame(
                call, lambda b=backs: lambda: b.append(1), 6, nothing, True
            )
        assert (status, good, backs, calls[0]) == (
            0,
            *((1, [], 3) if stops is None else (0, [1], stops)),
        )


@compiled
def test_ctrl_c_as_threads_begin_leaves_no_rope_on_its_way() -> None:
    """It comes when a thread runs that nobody has been told of, and that then moves ropes."""
    scene = ropes_of(20, 40, 4, "sdirk2")
    simulation, twin = Simulation(scene), Simulation(scene)
    expected = [told(twin.advance_frames(1)), told(twin.advance_frames(3)), numbers(twin)]
    found = [told(simulation.advance_frames(1))]
    stood, true, begun, moved = numbers(simulation), Thread.start, Event(), Event()

    def start(self: Thread) -> None:
        true(self)
        assert begun.wait(PATIENCE)
        raise KeyboardInterrupt

    def go_slowly(*args: Any) -> Any:
        begun.set()
        sleep(0.2)  # so that the exception is there before a rope moves
        done = go_abreast(*args)
        moved.set()
        return done

    with (
        mock.patch.multiple(islands, threads=2, LONG=-1.0, go_abreast=go_slowly),
        mock.patch.object(Thread, "start", start),
        pytest.raises(KeyboardInterrupt),
    ):
        simulation.advance_frames(3)
    assert moved.wait(PATIENCE)
    assert numbers(simulation) == stood
    found += [told(simulation.advance_frames(3)), numbers(simulation)]
    assert found == expected


def test_a_gate_that_closes_waits_for_all_that_runs_and_lets_nothing_begin() -> None:
    gate, on, ends = Gate(), Event(), []

    def work() -> str:
        on.set()
        sleep(0.05)
        ends.append("work")
        return "done"

    thread = Thread(target=gate.run, args=(work,))
    thread.start()
    assert on.wait(PATIENCE)
    presses = iter((KeyboardInterrupt(), None))

    def wait_for(ready: Any) -> bool:
        came = next(presses, None)
        if came is not None:
            raise came
        return Condition.wait_for(gate._changed, ready)

    with mock.patch.object(gate._changed, "wait_for", wait_for), pytest.raises(KeyboardInterrupt):
        gate.close()
    assert ends == ["work"]
    assert gate.run(work) is None
    assert ends == ["work"]
    thread.join()
