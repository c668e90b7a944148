"""Arrays of a run that is over, for the state of the next one of the same shapes."""

from __future__ import annotations

from ropewalk.core.arrays import Floats, State, assign, flatten, pooled


class Spare:
    """Keeps the arrays of one state: those who run ropes one after another need not make them anew.

    A state in them has the bits of one in arrays of its own. It lasts until the next one is filled in.
    """

    def __init__(self) -> None:
        self._shapes: list[tuple[int, ...]] = []
        self._room: tuple[State, Floats] | None = None

    def filled(self, state: State) -> tuple[State, Floats]:
        """Return what `pooled` does, in the arrays that are here where their shapes are those needed."""
        shapes = [part.shape for part in flatten(state).values()]
        if self._room is None or shapes != self._shapes:
            self._shapes, self._room = shapes, pooled(state)
            return self._room
        here, pool = self._room
        here = here._replace(peaks=state.peaks)  # what the steps are looked at for lies elsewhere
        assign(here, state)
        return here, pool
