"""What a rope bears at rest: its largest tension, or the force of the anchor beside it where that is more."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.end_weight import anchor_beside, is_end_weight

if TYPE_CHECKING:
    from ropewalk.lowering import Layout
    from ropewalk.scene import Scene


class Borne(NamedTuple):
    """The largest tension of a rope at rest, and the force of the anchor beside its segment."""

    tension: float  # [N]
    anchor: int | None  # row of the anchor beside it; None: there is none, or more than it is there
    force: float  # of that anchor [N]; 0 where there is none
    by_weight: bool  # whether half a segment's weight alone makes it more than the tension
    counts: bool  # whether it is the rope that bears it

    @property
    def most(self) -> float:
        """What a utilisation is reckoned by [N]."""
        return max(self.tension, self.force) if self.counts else self.tension


def borne_at(
    model: tuple[Scene, Layout], segment: int, tension: float, reactions: Floats, at: Floats
) -> Borne:
    """Return what is borne at the segment of a rope's largest `tension` [N], at rest.

    `reactions` (a, 3) are the forces of all anchors [N], `at` (n, 3) the places of all nodes [m]. Wind and
    bending act on the anchor's node as well as weight, and the rope bears that, too; NeHe's ground pushes on
    anchors themselves.
    """
    scene, layout = model
    row = anchor_beside(scene, layout, segment)
    if row is None:
        return Borne(tension, None, 0.0, False, False)
    force = float(np.linalg.norm(reactions[row]))
    by_weight = is_end_weight(model, row, segment, (tension, force), at, least=0.0)
    return Borne(tension, row, force, by_weight, by_weight or scene.ground is None)
