"""One rope of a result."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Span
from ropewalk.record.ends import End
from ropewalk.record.margins import breaking_load
from ropewalk.words.annotations import unquoted

if TYPE_CHECKING:
    from ropewalk.record.result import Result


@unquoted
class RopeView:
    """One rope's share of a result, views where it can be.

    With a winch that pays out, the rope has spare nodes, which lie on the drum at the drum's place until
    they are needed: `numbers` counts them below 0 (drum at the start) or beyond the scene's last node.
    """

    def __init__(self, result: Result, span: Span) -> None:
        self._result, self.span = result, span
        self._nodes = slice(span.first, span.last + 1)
        self._segments = slice(span.first, span.last)

    @property
    def name(self) -> str:
        """The rope's name."""
        return self.span.name

    @property
    def end(self) -> End | None:
        """When and why this rope broke; None when it did not. See `Result.ends`."""
        return next((end for end in self._result.ends if self.name in end.ropes), None)

    @property
    def numbers(self) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
        """The nodes' numbers as the scene counts them, (nodes,)."""
        return np.arange(self.span.nodes) - self.span.spare_start

    @property
    def time(self) -> Floats:
        """Time [s], (frames,)."""
        return self._result.time

    @property
    def positions(self) -> Floats:
        """Positions [m], (frames, nodes, 3)."""
        return self._result.positions[:, self._nodes]

    @property
    def velocities(self) -> Floats:
        """Velocities [m/s], (frames, nodes, 3)."""
        return self._result.velocities[:, self._nodes]

    @property
    def tension(self) -> Floats:
        """What the rope carries along each segment [N], (frames, segments); 0 on the drum.

        See `Result.tension`.
        """
        return self._result.tension[:, self._segments]

    @property
    def utilisation(self) -> Floats:
        """Tension over the breaking load [1], (frames, segments); NaN where that is not known."""
        load = breaking_load(self._result.scene.rope_named(self.name))
        return self.tension / (np.nan if load is None else load)

    @property
    def elastic_tension(self) -> Floats:
        """The springs' share of the tension [N], (frames, segments); 0 on the drum."""
        return self._result.elastic_tension[:, self._segments]

    @property
    def greatest_tension(self) -> Floats:
        """Greatest tension of all steps since the frame before [N], (frames, segments)."""
        return self._result.greatest_tension[:, self._segments]

    @property
    def least_tension(self) -> Floats:
        """Least tension of all steps since the frame before [N], (frames, segments)."""
        return self._result.least_tension[:, self._segments]

    @property
    def rest_length(self) -> Floats:
        """Unstretched length of the segments [m], (frames, segments); 0 on the drum."""
        return self._result.rest_length[:, self._segments]

    @property
    def live(self) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
        """Whether a segment is off the drum, and has not parted, (frames, segments)."""
        return self._result.live[:, self._segments]

    @property
    def arc_length(self) -> Floats:
        """Unstretched length from the rope's first node to each segment's middle [m], (segments,).

        At the first frame; segments that are still on the drum lie at the drum's end.
        """
        lengths = np.asarray(self.rest_length[0])
        return np.asarray(np.cumsum(lengths) - 0.5 * lengths)

    @property
    def stretch(self) -> Floats:
        """Length over unstretched length [1], (frames, segments); 1 on the drum, and once parted.

        Not finite where a frame recorded into a break is not; NaN where the rope broke and others went on.
        """
        rest = self.rest_length
        with np.errstate(invalid="ignore", over="ignore"):
            lengths = np.linalg.norm(np.diff(self.positions, axis=1), axis=2)
            ratio: Floats = np.divide(lengths, rest, out=np.ones_like(lengths), where=rest > 0.0)
        if self.end is not None and not self._result.facts.keep_going:
            ratio[self.end.frames :] = np.nan
        return ratio

    def __repr__(self) -> str:
        return f"Rope {self.name!r} of {self._result.scene.name!r}: {self.span.nodes} nodes."
