"""Run a scene into memory."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from ropewalk.block import Block
from ropewalk.build import Model
from ropewalk.core.status import BREAK_STRETCH, OK
from ropewalk.record.facts import BROKE, FINISHED, Facts, provenance
from ropewalk.record.quantities import recorded
from ropewalk.record.result import Result
from ropewalk.record.source import Memory
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation

#: Called after every block with the frames done, frames planned and the block.
Progress = Callable[[int, int, Block], None]
#: Says why a run broke, from a simulation that stands at its last good frame.
Explain = Callable[[Simulation], str]


def no_explanation(simulation: Simulation) -> str:
    """Say when a run broke."""
    return f"Broke after t = {simulation.time:.6g} s."


def first_broken(block: Block, simulation: Simulation) -> int | None:
    """Return the first broken frame of a block that was recorded with `keep_going`, or None.

    The test is the kernels' own: a length that is not finite or more than BREAK_STRETCH times the
    unstretched one.
    """
    state = simulation.arrays
    rest = block.recording.rest_length if block.recording.rest_length.size else state.rest_length
    with np.errstate(invalid="ignore", over="ignore"):
        lengths = np.sqrt((np.diff(block.recording.x, axis=2) ** 2).sum(axis=1))
        long = (rest > 0.0) & (lengths > BREAK_STRETCH * rest)
    broken = (long | ~np.isfinite(lengths)).any(axis=1)
    return int(np.argmax(broken)) if broken.any() else None


class Breaks:
    """Watches the blocks of a run and has the first break explained."""

    def __init__(
        self, simulation: Simulation, keep_going: bool, explain: Explain, diagnosis: str = ""
    ) -> None:
        self._simulation, self._keep_going, self._explain = simulation, keep_going, explain
        self._before = simulation.state if keep_going else None
        self.diagnosis = diagnosis  # of a break before a resumed part

    def watch(self, block: Block) -> None:
        """Look at one more block; `diagnosis` is set when the run broke in it."""
        if block.status != OK:
            self.diagnosis = self._explain(self._simulation)
        elif self._keep_going and not self.diagnosis:
            if first_broken(block, self._simulation) is not None:
                self.diagnosis = self._explain(self._replayed(block.frames))
            self._before = self._simulation.state

    def _replayed(self, frames: int) -> Simulation:
        """Return a second simulation that stands at the last good frame."""
        again = Simulation(self._simulation.model)
        assert self._before is not None
        again.restore(self._before)
        again.advance_frames(frames)
        return again


def simulate_in_memory(
    scene: Scene | Model,
    *,
    keep_going: bool = False,
    progress: Progress | None = None,
    ledger: bool = True,
    explain: Explain = no_explanation,
) -> Result:
    """Run a scene to its end or its break and return what it recorded, the initial frame included.

    Raises SceneError when the scene cannot be planned, MemoryError when the frames do not fit.
    """
    simulation = Simulation(scene, ledger=ledger)
    breaks = Breaks(simulation, keep_going, explain)
    plan = simulation.plan
    simulation.advance_frames(0)  # compiles, where it is not done yet, outside the clock
    begun = time.perf_counter()
    blocks = [simulation.recording()]
    done = 0
    for block in simulation.frames(keep_going=keep_going):
        breaks.watch(block)
        blocks.append(block)
        done += block.frames
        if progress is not None:
            progress(done, plan.frames, block)
    facts = Facts(
        plan,
        ledger,
        keep_going,
        BROKE if breaks.diagnosis else FINISHED,
        breaks.diagnosis,
        time.perf_counter() - begun,
        provenance(plan, ledger, keep_going),
    )
    with_lengths = bool(simulation.scene.winches)
    names = tuple(q.name for q in recorded(simulation.layout, with_lengths))
    return Result(simulation.scene, simulation.layout, Memory(blocks, names), facts)
