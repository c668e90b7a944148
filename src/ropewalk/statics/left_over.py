"""What forces are left at rest, rope by rope: rounding of a stiff one says nothing of a light one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.scene.bound_ropes import bound_ropes


def left_over(model: Model, left: Floats, free: NDArray[np.bool_]) -> Floats:
    """Return the largest force that is left on a free node of every segment's rope, or of one bound to it.

    Args:
        model: what is at rest.
        left: on every node (3, n) [N].
        free: (n,) which nodes are free.

    Returns:
        Of every segment (s,) [N]; 0 between two ropes.
    """
    size = np.where(free, np.abs(left).max(axis=0), 0.0)
    found = np.zeros(size.size - 1)
    for group in bound_ropes(model.scene):
        spans = [model.layout.ropes[i] for i in group]
        most = max(float(size[span.first : span.last + 1].max()) for span in spans)
        for span in spans:
            found[span.first : span.last] = most
    return found
