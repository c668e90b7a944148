"""What every initial shape gives the engine."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ropewalk.scene.base import Model

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats


class ShapeModel(Model):
    """An initial shape: its `kind`, its fields, an initial `velocity`, and the places of the nodes."""

    @abstractmethod
    def places(
        self, segments: int, length: float, segment_length: float, up: Sequence[float]
    ) -> Floats:
        """Return the initial place of every node of a rope [m], (segments + 1, 3).

        From its unstretched length and a segment's [m], and the unit vector upward.
        """
