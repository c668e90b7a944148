"""A model linearised about a shape: M u'' + C u' + K u = 0 over its free nodes.

The matrices are the exact tangents of all laws. The springs are kept apart, as lengths and tensions,

    K u = S u + B^T T,        B u = T/k,

S the tangent of the other laws plus the geometric stiffness T/r (I - t t^T), so that K^-1 is accurate for
the slow modes of ropes of any stiffness, rigid links (1/k = 0) included.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import BENDING, Floats, Ints
from ropewalk.core.band import Band, triplets
from ropewalk.laws.others import other_stiffness
from ropewalk.laws.tangent import assemble_tangent, law_band
from ropewalk.lowering import Model
from ropewalk.lowering.elastic_tables import put_under_tension
from ropewalk.statics.coupled import Couplings, Entries
from ropewalk.statics.tied import points
from ropewalk.theory.borrowed import load_scipy

_SYMMETRIC = 1e-12  # of the largest entry: what a difference from the transpose may be [1]


@dataclass(frozen=True)
class Linear:
    """Matrices over the free unknowns, three for each free node, as scipy.sparse matrices.

    Nodes that joints tie to each other are one.
    """

    nodes: Ints  # (f,) indices of the free nodes, the first one of a joint
    follows: (
        Ints  # (n,) for every node the index in `nodes` of the one it moves with, -1: it is held
    )
    mass: Floats  # (3 f,) [kg]
    other: Any  # S [N/m], (3 f, 3 f)
    friction: Any  # C [N s/m], (3 f, 3 f)
    lengths: Any  # B [1], (s', 3 f), of the s' segments that carry
    soft: Floats  # (s',) 1/k [m/N]

    @cached_property
    def stiffness(self) -> Any:
        """K [N/m]; infinite with rigid links."""
        from scipy.sparse import diags_array

        with np.errstate(divide="ignore"):
            return (
                self.other + self.lengths.T @ diags_array(1.0 / self.soft) @ self.lengths
            ).tocsc()

    @property
    def rigid(self) -> bool:
        """Whether some segments are rigid links."""
        return bool((self.soft == 0.0).any())

    @property
    def loose(self) -> bool:
        """Whether nothing brings any node back."""
        return bool(self.nodes.size) and not self.soft.size and not self.other.count_nonzero()

    @property
    def has_friction(self) -> bool:
        """Whether anything is damped."""
        return bool(self.friction.count_nonzero())

    @cached_property
    def symmetric(self) -> bool:
        """Whether S is symmetric; the drag of a wind along a line is not."""
        size = abs(self.other).max() if self.other.nnz else 0.0
        return bool(abs(self.other - self.other.T).max() <= _SYMMETRIC * size) if size else True

    def saddle(self, shift: float = 0.0) -> Any:
        """Return the matrix of S + shift^2 M + shift C with B and -1/k; sparse, (3 f + s', ...)."""
        from scipy.sparse import block_array, diags_array

        matrix = self.other + shift * self.friction + diags_array(shift**2 * self.mass)
        below = self.lengths
        return block_array([[matrix, below.T], [below, diags_array(-self.soft)]]).tocsc()


def linearise(model: Model, x: Floats, tension: Floats, *, springs_only: bool = False) -> Linear:
    """Linearise a model about places `x` (3, n) [m] with tensions (s,) [N], all velocities zero.

    With `springs_only` all other laws and friction are left out, and no kernel is needed.
    """
    load_scipy()
    state, n = model.state, model.state.mass.size
    number = points(model)
    lead = np.arange(n) if number is None else np.unique(number, return_index=True)[1][number]
    nodes = np.flatnonzero((state.inverse_mass > 0.0) & (state.mass > 0.0) & (lead == np.arange(n)))
    place = np.full(n, -1)
    place[nodes] = np.arange(nodes.size)
    follows = place[lead]
    unknown = (3 * nodes[:, None] + np.arange(3)).ravel()
    spread = None if number is None else _spread(follows, nodes.size)

    def over_free(matrix: Any) -> Any:
        """The same over the free unknowns."""
        if spread is None:
            return matrix[unknown][:, unknown].tocsc()
        return (spread.T @ matrix @ spread).tocsc()

    still = np.zeros_like(x)
    friction, other = _bands(model, x, still) if not springs_only else _nothing(n)
    coupled = Couplings(model.system, arrays.copy(model.state))
    if coupled.acts and not springs_only:
        stiff, rubs = (_from_entries(part, n) for part in coupled.small_motions(x))
        other, friction = other + stiff, friction + rubs
    d = np.diff(x, axis=1)
    r = np.sqrt((d * d).sum(axis=0))
    t = d / np.maximum(r, 1e-300)
    one_way = model.system.slack_floor == 0.0
    taut = (state.stiffness > 0.0) & ~(one_way & (tension <= 0.0)) & (r > 0.0)
    across = np.where(taut, tension / np.maximum(r, 1e-300), 0.0)
    other = other + _geometric(n, t, across)
    segments = np.flatnonzero(taut)
    free = follows >= 0
    pulls = _lengths(n, t, segments)
    soft = np.divide(1.0, state.stiffness, out=np.zeros_like(r), where=state.stiffness > 0.0)
    put_under_tension(model.system, state, tension, np.empty_like(r), soft)
    return Linear(
        nodes=nodes,
        follows=follows,
        mass=np.repeat(np.bincount(follows[free], state.mass[free], nodes.size), 3),
        other=over_free(other),
        friction=over_free(friction),
        lengths=(pulls[:, unknown] if spread is None else pulls @ spread).tocsr(),
        soft=soft[segments],
    )


def _spread(follows: Ints, count: int) -> Any:
    """Return what takes the free unknowns to the places of all nodes, (3 n, 3 count), of ones."""
    from scipy.sparse import coo_array

    nodes = np.flatnonzero(follows >= 0)
    rows = (3 * nodes[:, None] + np.arange(3)).ravel()
    columns = (3 * follows[nodes][:, None] + np.arange(3)).ravel()
    shape = (3 * follows.size, 3 * count)
    return coo_array((np.ones(rows.size), (rows, columns)), shape=shape).tocsr()


def _bands(model: Model, x: Floats, still: Floats) -> tuple[Any, Any]:
    """Return C, and K of all laws but the springs', over all nodes."""
    system, n = model.system, x.shape[1]
    state = arrays.copy(model.state)
    state.stiffness[np.isinf(state.stiffness)] = 1.0  # it is multiplied by zero
    far = bool(system.flags[BENDING])
    band = law_band(n, far)
    assemble_tangent(system, state, x, still, 0.0, 1.0, band)
    friction = _sparse(band, n)
    other_stiffness(system, state, x, still, band)
    return friction, _sparse(band, n)


def _from_entries(entries: Entries, n: int) -> Any:
    from scipy.sparse import coo_array

    rows, columns, values = entries
    return coo_array((values, (rows, columns)), shape=(3 * n, 3 * n)).tocsr()


def _nothing(n: int) -> tuple[Any, Any]:
    from scipy.sparse import csr_array

    return csr_array((3 * n, 3 * n)), csr_array((3 * n, 3 * n))


def _sparse(band: Band, n: int) -> Any:
    from scipy.sparse import coo_array

    rows, columns, values = triplets(band)
    return coo_array((values, (rows, columns)), shape=(3 * n, 3 * n)).tocsr()


def _geometric(n: int, t: Floats, across: Floats) -> Any:
    """Return the geometric stiffness of all segments, (3 n, 3 n)."""
    from scipy.sparse import coo_array

    segment = np.arange(across.size)
    blocks = across[:, None, None] * (np.eye(3) - np.einsum("ks,ms->skm", t, t))
    rows, columns, values = [], [], []
    for a in (0, 1):
        for b in (0, 1):
            place = np.broadcast_to(3 * (segment + a)[:, None, None], blocks.shape)
            beside = np.broadcast_to(3 * (segment + b)[:, None, None], blocks.shape)
            rows.append((place + np.arange(3)[:, None]).ravel())
            columns.append((beside + np.arange(3)).ravel())
            values.append((blocks if a == b else -blocks).ravel())
    entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
    return coo_array(entries, shape=(3 * n, 3 * n)).tocsr()


def _lengths(n: int, t: Floats, segments: Ints) -> Any:
    """Return the derivative of the segments' lengths by the places, (s', 3 n)."""
    from scipy.sparse import coo_array

    count = segments.size
    row = np.repeat(np.arange(count), 6)
    column = 3 * segments[:, None] + np.arange(6)
    value = np.concatenate([-t[:, segments], t[:, segments]]).T
    return coo_array((value.ravel(), (row, column.ravel())), shape=(count, 3 * n)).tocsr()
