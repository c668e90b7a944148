"""The equations of rest: no force left on any free node, every segment as long as its tension makes it.

Unknowns are the places x of the nodes and the tensions T of the segments; with the tension on its own,
Newton's method does not mind how stiff the segments are, up to rigid links (1/k = 0), and a slack
tension-only segment is the equation T = 0:

    f_i + T_i t_i - T_(i-1) t_(i-1) = 0        r_j - L_j - T_j/k_j = 0

f the forces of all other laws, weight included. One Newton step solves

    | S + lambda M    B^T  | | dx |   |  f     |
    |   B           -1/k   | | T  | = | L - r  |

S the other laws' stiffness plus T/r (I - t t^T) of the present tension, B the derivative of the lengths,
lambda M the mass over a squared time: a step of implicit Euler from rest, which keeps the step small
where the equations are far from linear. Ordered node by node the matrix is banded.
Source: Magisano, Leonetti and Garcea, Comput. Methods Appl. Mech. Eng. 313 (2017) 986, for the tension as
an unknown; Kelley and Keyes, SIAM J. Numer. Anal. 35 (1998) 508, for continuation in pseudo-time.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import BENDING, Floats
from ropewalk.core.band_lu import solve_band
from ropewalk.laws.acting import at_rest
from ropewalk.laws.clamps import start_clamps
from ropewalk.laws.contact import remember_contacts
from ropewalk.laws.node_law import Rest
from ropewalk.laws.obstacle_places import depths
from ropewalk.laws.others import other_forces, other_stiffness
from ropewalk.laws.pulls import pulls_of_laws
from ropewalk.laws.slides.table import Slides
from ropewalk.laws.tangent import law_band
from ropewalk.lowering import Model, Span
from ropewalk.lowering.elastic_tables import put_tension, put_under_tension
from ropewalk.statics.coupled import Couplings, Entries
from ropewalk.statics.standing import standing
from ropewalk.statics.tied import points, solve_tied, together

_TINY = 1e-300
_CLOSED = 1e-9  # error that counts as at rest [1]
_ROUNDING = 1e-13  # ... or this share of the largest tension [1]
_MOST = 1e-6  # what rounding may leave, over the unit of force, which is raised to that where need be [1]
_YIELD = 1e-9  # compliance of rigid links within a Newton step, in the model's units [1]


class Balance:
    """The equations of rest of one model, in units of its own weight and segments."""

    def __init__(self, model: Model) -> None:
        self.system = standing(model.system, model.state.memory)
        self.state = state = arrays.copy(model.state)
        state.v[...] = 0.0
        self.nodes = state.mass.size
        self.live = (state.stiffness > 0.0) & (state.mass[:-1] > 0.0) & (state.mass[1:] > 0.0)
        self.free = (state.inverse_mass > 0.0) & (state.mass > 0.0)
        self.soft = np.where(self.live, 1.0 / np.where(self.live, state.stiffness, 1.0), 0.0)
        self.rest = state.rest_length
        self.one_way = model.system.slack_floor == 0.0
        self._zero = np.zeros_like(state.x)
        self.bends = bool(model.system.flags[BENDING])
        if self.bends:
            start_clamps(self.system, state)
            state.clamp_spin[...] = 0.0
        # Under weight alone no kernel is needed, and none is compiled.
        self._weight = np.outer(model.system.gravity, state.mass)
        self.rests = at_rest(model.system)
        self.coupled = Couplings(self.system, state)
        self._plain = not (
            self.rests or self.bends or state.forces.applied.any() or self.coupled.acts
        )
        self._band = law_band(self.nodes, self.bends)
        self.drag = 0.0  # [N/m], see `others`
        self.origin = self._zero
        self.goes_on = (
            False  # whether ropes slid or fell so far on obstacles that they will not rest
        )
        self.slid = 0.0  # [m] how far they went and were not at rest yet
        self.patient = True  # whether they had the time of settling for it
        self.pressed: Any = None  # what its tension presses too deep, see `pressing`
        self.speared = ""  # which segment lies through an obstacle, in words
        self.number = points(model)  # (n,), where joints tie nodes
        self._set_scales()

    def leave_out(self, rope: Span) -> None:
        """Leave a rope where it is, without tension."""
        self.free[rope.first : rope.last + 1] = False
        self.live[rope.first : rope.last] = False

    def _set_scales(self) -> None:
        """Set the units of force [N], length [m] and time [1/s^2] in which residuals are judged."""
        state = self.state
        load = np.linalg.norm(self.others(state.x) - self.contact_force(), axis=0)
        if self.coupled.acts:  # drawn a little into each other, ropes press by any force
            load = np.linalg.norm(self._weight + state.forces.applied, axis=0)
        pull = self.elastic(state.x)
        stretched = float(np.abs(pull[np.isfinite(pull)]).max(initial=0.0))
        lengths = self.rest[self.live]
        size = np.linalg.norm(np.diff(state.x, axis=1), axis=0)[self.live]
        self.length = float(max(lengths.mean(), 1e-3 * size.mean())) if lengths.size else 1.0
        weight = np.linalg.norm(self.system.gravity) * state.mass
        self.force = float(max(weight.mean(), load.mean() if np.isfinite(load).all() else 0.0))
        if self.force == 0.0:
            self.force = stretched or 1.0
        # What rounding leaves where a straight rope bends is no measure of its forces.
        self.force = max(self.force, self._rounding(state.x, stretched) / _MOST)
        masses = state.mass[state.mass > 0.0]
        # Rigid links give a little within one Newton step, or a straight row of them has no solution.
        least = _YIELD * self.length / self.force
        self.yielding = np.where(self.live & (self.soft == 0.0), least, 0.0)
        self.rate = self.force / (float(masses.mean()) * self.length)  # 1/s^2

    def allowed(self, x: Floats, tension: Floats) -> float:
        """Return the error that counts as at rest [1]: more where rounding of forces or places shows."""
        pull = float(np.abs(tension[self.live]).max(initial=0.0))
        return max(_CLOSED, self._rounding(x, pull) / self.force) + self._of_contacts(x)

    def _of_contacts(self, x: Floats) -> float:
        """Return the error that rounding the places makes of the forces of contacts [1]."""
        table = self.system.node.obstacle
        size = max(float(np.abs(x).max(initial=0.0)), float(np.abs(table.center).max(initial=0.0)))
        stiff = float(table.stiffness.max(initial=0.0))
        found = 4.0 * float(np.finfo(float).eps) * size * stiff
        if self.coupled.acts:
            found = max(found, self.coupled.rounding(x))
        return found / self.force

    def _rounding(self, x: Floats, pull: float) -> float:
        """Return the force that rounding of forces and places leaves under a largest tension [N]."""
        size = float(np.abs(x).max(initial=0.0))
        turned = 16.0 * float(np.finfo(float).eps) * size / self.length * pull
        if self.bends:
            size = float(np.ptp(x, axis=1).max())
            pull += size * float(self.state.bending_stiffness.max()) / self.length**2
        return max(_ROUNDING * pull, turned)

    # -- the laws ------------------------------------------------------------------------

    def others(self, x: Floats) -> Floats:
        """Return the forces of all laws but the springs' at rest [N], (3, n).

        With them a drag that holds every node back at its `origin`: a step of motion without inertia.
        """
        if self._plain:
            return self._weight.copy()
        total = np.zeros_like(x)
        other_forces(self.system, self.state, x, self._zero, self.state.forces, total)
        if self.drag > 0.0:
            total -= self.drag * (x - self.origin)
        return total

    def contact_force(self) -> Floats:
        """Return the force of all obstacles at the places last asked for [N], (3, n)."""
        force: Floats = self.state.forces.node.obstacle[:3]
        return force

    def carried(self, x: Floats, tension: Floats) -> Floats:
        """Return what segments carry at places `x` (3, n) [m] with these springs' tensions [N], (s,)."""
        total = tension.copy()
        if Rest.PULLS in self.rests:
            pulls_of_laws(self.system, self.state, x, self._zero, total)
        return total

    def clearance(self, x: Floats) -> float:
        """Return the distance from places (3, n) [m] to the nearest obstacle [m]; negative inside."""
        return -float(depths(self.system.node.obstacle, x)[:, self.free].max(initial=-np.inf))

    def stiffness(self) -> Floats:
        """Return how stiff contacts are at every node [N/m], (n,)."""
        stiff = self.system.node.obstacle.stiffness.max(axis=0, initial=0.0)
        if not self.coupled.acts:
            return np.asarray(stiff)
        stiff = np.maximum(stiff, self.coupled.stiffness())
        return np.asarray(np.maximum(stiff, 1e-3 * float(stiff.max(initial=0.0))))

    def kept(self) -> Any:
        """Return a copy of what contacts carry; `restore` puts it back."""
        return arrays.copy(self.state.memory.obstacle), *self.coupled.kept()

    def restore(self, kept: Any) -> None:
        """Let contacts carry again what they did."""
        arrays.assign(self.state.memory.obstacle, kept[0])
        self.coupled.restore(kept[1:])

    def remember(self, x: Floats, *, at_last: bool = False) -> None:
        """Let contacts keep what they carry at places `x` (3, n) [m], as at the end of a step."""
        table, memory = self.system.node.obstacle, self.state.memory.obstacle
        if table.kind.size:
            remember_contacts(x, self._zero, table, memory, np.zeros(2), self.state.stiffness)
        if self.coupled.acts:
            self.coupled.remember(x, at_last=at_last)

    def put_slides(self, table: Slides) -> None:
        """Let slides be of such a table."""
        self.system = self.system._replace(node=self.system.node._replace(slide=table))
        self.coupled.system, self.coupled.slide = self.system, table

    def elastic(self, x: Floats) -> Floats:
        """Return the tension that Hooke's law gives [N], (s,); infinite or NaN for rigid links."""
        _, r = self.directions(x)
        with np.errstate(invalid="ignore", divide="ignore"):
            pull = np.where(self.live, (r - self.rest) / self.soft, 0.0)
        put_tension(self.system, self.state, r - self.rest, pull)
        pull[~self.live] = 0.0
        return np.where(self.one_way, np.maximum(pull, 0.0), pull)

    def given(self, tension: Floats) -> tuple[Floats, Floats]:
        """Return the stretch under tensions [m] and its slope, the compliance [m/N], (s,) each."""
        stretch, soft = tension * self.soft, self.soft
        if self.system.elastic.time.size:
            soft = soft.copy()
            put_under_tension(self.system, self.state, tension, stretch, soft)
        return stretch, soft

    def directions(self, x: Floats) -> tuple[Floats, Floats]:
        """Return the segments' unit vectors (3, s) and lengths [m] (s,)."""
        d = np.diff(x, axis=1)
        r = np.sqrt((d * d).sum(axis=0))
        return d / np.maximum(r, _TINY), r

    def imbalance(self, x: Floats, tension: Floats) -> Floats:
        """Return the force that is left on every node [N], (3, n), anchors left out.

        On one that is tied that on all nodes of its joint.
        """
        t, _ = self.directions(x)
        left = self.others(x)
        left[:, :-1] += tension * t
        left[:, 1:] -= tension * t
        return left if self.number is None else together(self.number, left)

    # -- Newton's equations ----------------------------------------------------------------

    def taut(self, x: Floats, tension: Floats) -> np.ndarray:
        """Return which segments obey Hooke's law rather than T = 0, (s,)."""
        return self._taut(self._too_long(x, tension), tension)

    def _taut(self, stretch: Floats, tension: Floats) -> np.ndarray:
        """Return the same of segments that are too long by a stretch [m], (s,)."""
        wants = tension + self.force / self.length * stretch > 0.0
        return np.asarray(self.live & (wants | ~self.one_way))

    def _too_long(self, x: Floats, tension: Floats) -> Floats:
        """Return by how much segments are longer than Hooke's law has them [m], (s,)."""
        _, r = self.directions(x)
        found: Floats = r - self.rest - self.given(tension)[0]
        return found

    def gap(self, x: Floats, tension: Floats) -> Floats:
        """Return how much too long every segment is for its tension [m], (s,); 0 for slack ones."""
        stretch = self._too_long(x, tension)
        slack = np.where(self.live, np.abs(tension), 0.0) / self.force
        return np.where(self._taut(stretch, tension), stretch, slack)

    def error(self, x: Floats, tension: Floats) -> float:
        """Return the largest residual, in the model's own units of force and length [1]."""
        return self.worst(self.imbalance(x, tension), self.gap(x, tension))

    def worst(self, left: Floats, gap: Floats) -> float:
        """Return the larger of forces that are left [N], (3, n), and gaps [m], (s,), in these units [1]."""
        force = np.abs(left[:, self.free]).max(initial=0.0) / self.force
        return float(max(force, np.abs(gap).max(initial=0.0) / self.length))

    def step(
        self, x: Floats, tension: Floats, inertia: float, exact: bool
    ) -> tuple[Floats, Floats, float]:
        """Return the change of the places [m], (3, n), the new tensions [N] and the least pivot.

        Args:
            x: places [m], (3, n).
            tension: [N], (s,).
            inertia: lambda [1/s^2].
            exact: keep the geometric stiffness of compressed segments, which may be negative.
        """
        n, unit = self.nodes, self.force / self.length
        t, r = self.directions(x)
        taut = self.taut(x, tension)
        if not self._plain:
            other_stiffness(self.system, self.state, x, self._zero, self._band)
        reach = 10 if len(self._band.upper2) else 6
        matrix = np.zeros((4 * n, 3 * reach + 1))
        self._put_blocks(matrix, reach, tension, t, r, inertia, exact)
        right = np.zeros((n, 4))
        right[:, :3] = self.others(x).T / unit
        column = np.zeros(n)
        given, soft = self.given(tension)
        beyond = given - soft * tension  # 0 of a straight line
        column[:-1] = np.where(taut, self.rest - r - self.yielding * tension + beyond, 0.0)
        right[:, 3] = column
        for k in range(3):
            row = matrix[3::4]
            row[:-1, reach + k - 3] = np.where(taut, -t[k], 0.0)
            row[:-1, reach + k + 1] = np.where(taut, t[k], 0.0)
            live = np.where(self.live, t[k], 0.0)
            matrix[k::4][:-1, reach + 3 - k] = -live
            matrix[4 + k :: 4, reach - 1 - k] = live
        matrix[3::4, reach] = 1.0
        matrix[3::4, reach][:-1] = np.where(taut, -unit * (soft + self.yielding), 1.0)
        held = np.flatnonzero(~self.free)
        for k in range(3):
            matrix[4 * held + k] = 0.0
            matrix[4 * held + k, reach] = 1.0
        right[held, :3] = 0.0
        found = right.reshape(-1)  # a view: `right` is the solution
        if self.coupled.acts:
            more = self.coupled.entries(x)
            if more is None:
                return np.zeros_like(x), tension, 0.0
            tied = np.arange(n) if self.number is None else self.number
            pivot = solve_tied(matrix, found, reach, tied, self._of_free(more, unit))
        elif self.number is None:
            pivot = solve_band(matrix, found, reach, reach)
        else:
            pivot = solve_tied(matrix, found, reach, self.number)
        return np.ascontiguousarray(right[:, :3].T), right[:-1, 3] * unit, float(pivot)

    def _of_free(self, entries: Entries, unit: float) -> Entries:
        """Return what couples free nodes, by places in Newton's equations, over `unit` [N/m]."""
        rows, columns, values = entries
        free = self.free[rows // 3]
        rows, columns = rows[free], columns[free]
        return rows + rows // 3, columns + columns // 3, values[free] / unit

    def _put_blocks(
        self,
        matrix: Floats,
        reach: int,
        tension: Floats,
        t: Floats,
        r: Floats,
        inertia: float,
        exact: bool,
    ) -> None:
        """Write the blocks between nodes, over the unit of stiffness."""
        band, unit, n = self._band, self.force / self.length, self.nodes
        across = np.where(self.live, tension / np.maximum(r, 1e-9 * self.length), 0.0)
        if not exact:
            across = np.maximum(across, 0.0)
        for k in range(3):
            for m in range(3):
                at, away = 3 * k + m, reach + m - k
                diagonal, upper, lower = (
                    blocks[:, at].copy() for blocks in (band.diagonal, band.upper1, band.lower1)
                )
                share = across * ((1.0 if k == m else 0.0) - t[k] * t[m])
                diagonal[:-1] += share
                diagonal[1:] += share
                if k == m:
                    diagonal += inertia * self.state.mass + self.drag
                matrix[k::4, away] = diagonal / unit
                matrix[k::4, away + 4][: n - 1] = (upper[:-1] - share) / unit
                matrix[4 + k :: 4, away - 4] = (lower[:-1] - share) / unit
                if len(band.upper2):
                    matrix[k::4, away + 8][: n - 2] = band.upper2[: n - 2, at] / unit
                    matrix[8 + k :: 4, away - 8] = band.lower2[: n - 2, at] / unit
