"""What every initial shape gives the engine."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import TYPE_CHECKING, ClassVar

from ropewalk.scene.base import Model

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats


class ShapeModel(Model):
    """An initial shape: its `kind`, its fields, an initial `velocity`, and the places of the nodes."""

    #: Whether where the nodes are depends on how thick the rope is.
    of_diameter: ClassVar[bool] = False

    @abstractmethod
    def places(
        self,
        segments: int,
        length: float,
        segment_length: float,
        up: Sequence[float],
        diameter: float,
    ) -> Floats:
        """Return the initial place of every node of a rope [m], (segments + 1, 3).

        From its unstretched length and a segment's [m], the unit vector upward, and its diameter [m]
        (0 where it is not `of_diameter`).
        """
