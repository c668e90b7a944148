"""A step that is taken and taken back: whoever waits for the next one does not wait for the compiler."""

from __future__ import annotations

from ropewalk.methods.recording import make_recording
from ropewalk.simulation.simulation import Simulation


def warm_up(simulation: Simulation) -> None:
    """Have what a step calls compiled, or read from disk. Nothing of the simulation changes."""
    before, goals = simulation.state, dict(simulation._goals)
    said = simulation.failure, simulation.reason, simulation.falls
    try:
        simulation._advance(1, 1, make_recording(simulation.arrays, 0, False))
    finally:
        simulation.restore(before)
        simulation._goals.update(goals)
        simulation.failure, simulation.reason, simulation.falls = said
