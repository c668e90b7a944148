"""Newton's equations of a chain with the segments' tensions as unknowns of their own; solved in O(n).

Unknowns are the displacement z of every node and the change T' of every segment's tension:
    node i      L z_(i-1) + A z_i + U z_(i+1) - t_i T'_i + t_(i-1) T'_(i-1) = f_i
    segment j   d_j t_j . (z_(j+1) - z_j) - e_j T'_j = -g_j
with t the unit vectors, e the compliance 1/k, g the misfit of the length and d = 0 for a segment that carries
nothing. Where forces along the segments follow the nodes' motion, the nodes have t_j lean_j . (z_(j+1) - z_j)
besides. A, L, U hold inertia, geometric stiffness, friction and all other laws, but no spring constant: no
number in the elimination grows with k, and k = inf (e = 0) is a rigid link.

The matrix is given in two parts: inertia of the nodes and across I + (along - across) t t^T of the segments,
which most ropes need only, and a band of blocks for all else. `sweep` solves the first kind from both ends at
once, `leaning_sweep` that with `lean` and the blocks on the band's diagonal, `band_sweep` any without `lean`;
where joints tie nodes, `network` does.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.band import Band, make_band
from ropewalk.core.network import Network, no_network


class Saddle(NamedTuple):
    """Equations, solution and factors; rows of (3, n) arrays are components."""

    band: Band  # what inertia, across and along do not hold
    free: Floats  # (n,) 1 for free nodes, 0 for held ones
    inertia: Floats  # (n,) on the diagonal, positive for held nodes, too [N/m]
    across: Floats  # (s,) [N/m]
    along: Floats  # (s,) [N/m]
    direction: Floats  # (3, s) unit vectors of the segments
    carries: Floats  # (s,) 1 for segments whose tension follows from their length, else 0
    compliance: Floats  # (s,) [m/N]
    force: Floats  # (3, n) right side of the nodes, f [N]
    misfit: Floats  # (s,) g [m]
    lean: Floats  # (3, s), see `leaning` [N/m]
    moved: Floats  # (3, n) solution z [m]
    pulled: Floats  # (s,) solution T' [N]
    factor: Floats  # (n, 16) what the way back needs
    far_factor: Floats  # (n, 12) the same of second off-diagonals; (0, 12) without them
    network: Network  # of nodes that joints tie; an empty one without joints


def make_saddle(nodes: int, second: bool = False, marks: int = 0) -> Saddle:
    """Return equations of zeros; `second` and `marks` are those of the band, see `make_band`."""
    n, s = nodes, nodes - 1
    shapes = (n, n, s, s, (3, s), s, s, (3, n), s, (3, s), (3, n), s, (n, 16), (n * second, 12))
    arrays = [np.zeros(shape) for shape in shapes]
    return Saddle._make((make_band(n, second, marks), *arrays, no_network()))
