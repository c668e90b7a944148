"""Where a result's numbers come from: memory, or a run folder (see `store`)."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.quantities import BY_NAME, WORKS, raw
from ropewalk.simulation.block import Block


class Source(Protocol):
    """Recorded quantities by name, by ranges of frames."""

    @property
    def frames(self) -> int:
        """Number of frames, the initial one included."""
        ...

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the recorded quantities, `time` not among them."""
        ...

    @property
    def chunk(self) -> int:
        """Frames that are best read together."""
        ...

    def read(self, name: str, start: int = 0, stop: int | None = None) -> Floats:
        """Return a quantity (or `time`) of some frames, with the dimensions of its Quantity."""
        ...

    def refuse_another(self) -> None:
        """Raise RunError where the numbers on disk are of another run by now."""
        ...


class Memory:
    """Blocks of frames in memory, each quantity joined when it is first asked for."""

    def __init__(self, blocks: list[Block], names: tuple[str, ...], ledger: bool = True) -> None:
        """Take blocks of a run; works without a `ledger` are NaN, as in a run folder."""
        self._unknown = () if ledger else WORKS
        self._names = names
        self._parts = {name: [raw(block, BY_NAME[name]) for block in blocks] for name in names}
        self._parts["time"] = [block.time for block in blocks]
        self._frames = sum(block.frames for block in blocks)

    @property
    def frames(self) -> int:
        """Number of frames."""
        return self._frames

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities."""
        return self._names

    @property
    def chunk(self) -> int:
        """Frames that are best read together."""
        return self._frames

    def read(self, name: str, start: int = 0, stop: int | None = None) -> Floats:
        """Return a quantity of some frames, a view."""
        parts = self._parts[name]
        if len(parts) > 1:
            parts[:] = [np.concatenate(parts)]
        array = parts[0] if name not in self._unknown else np.full_like(parts[0], np.nan)
        if name != "time" and BY_NAME[name].swapped:
            array = array.transpose(0, 2, 1)
        return array[start:stop]

    def refuse_another(self) -> None:
        """Do nothing: what is in memory stays."""


__all__ = ["Memory", "Source"]
