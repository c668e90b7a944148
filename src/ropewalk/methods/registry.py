"""The methods of time integration by name: what users choose from and tables are made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats, State, System
from ropewalk.methods import (
    adaptive,
    characteristic,
    implicit,
    runge_kutta,
    semi_implicit_euler,
    tableaus,
    verlet,
)
from ropewalk.methods.explicit_methods import RUNGE_KUTTA, ExplicitMethod
from ropewalk.methods.implicit_methods import IMPLICIT
from ropewalk.methods.names import Explicit, Implicit
from ropewalk.methods.scratch import make_scratch

NO_TABLEAU = np.zeros((2, 0))
STAGE_COST = 60.0  # a stage to solve costs as much as so many force evaluations


class Method(NamedTuple):
    """One method: its order, cost and what it does to one mode of vibration."""

    name: str
    order: int
    evaluations: int  # force evaluations per step
    advance: Any  # the kernel
    tableau: Any  # coefficients that the kernel takes
    characteristic: Callable[[ArrayLike, ArrayLike], Floats]
    summary: str
    implicit: bool = False
    holds_links: bool = False  # whether lengths and tensions of rigid links are right
    fixed: bool = True  # steps of one length, as planned
    cuts: bool = True  # steps at kinks and releases

    @property
    def cost(self) -> float:
        """Cost of a step, in force evaluations with their update."""
        return self.evaluations * (STAGE_COST if self.implicit else 1.0)

    def coefficients(self, spectral_radius: float, rigid: bool = False) -> Any:
        """Return what the kernel takes; `spectral_radius` [1] is that of generalized-alpha.

        With `rigid` for a system with rigid links, or segments that a limiter can make rigid.
        """
        if rigid and self.name == "bdf2":
            return tableaus.BDF_2_LINKS
        if self.name == "generalized-alpha":
            return tableaus.generalized_alpha(spectral_radius)
        return self.tableau

    def make_scratch(self, system: System, state: State) -> Any:
        """Return working arrays that fit `state`."""
        if self.implicit:
            return implicit.make_implicit_scratch(system, state, self.tableau)
        return make_scratch(state)


def _explicit(one: ExplicitMethod) -> Method:
    """Return an explicit Runge-Kutta method; each of its stages evaluates the forces once."""
    return Method(
        one.name,
        one.order,
        one.table.shape[1],
        runge_kutta.advance,
        one.table,
        characteristic.CHARACTERISTIC[one.name],
        one.summary,
    )


def _implicit(one: tableaus.ImplicitMethod) -> Method:
    """Return an implicit method; its evaluations are the stages to solve, some four each."""
    tableau = one.tableau
    solved = 1 if tableau.kind != tableaus.DIRK else int(np.count_nonzero(np.diag(tableau.A)))
    return Method(
        one.name,
        one.order,
        solved,
        implicit.advance if one.fixed else adaptive.advance,
        tableau,
        characteristic.CHARACTERISTIC[one.name],
        one.summary,
        implicit=True,
        holds_links=one.holds_links,
        fixed=one.fixed,
    )


_OWN = (
    Method(
        "semi-implicit-euler",
        1,
        1,
        semi_implicit_euler.advance,
        NO_TABLEAU,
        characteristic.semi_implicit_euler,
        "Velocity first, then position with it; symplectic without friction.",
        cuts=False,
    ),
    Method(
        "verlet",
        2,
        1,
        verlet.advance,
        NO_TABLEAU,
        characteristic.verlet,
        "Velocity Verlet; symplectic without friction.",
    ),
)
_MADE = {
    made.name: made for made in (*_OWN, *map(_explicit, RUNGE_KUTTA), *map(_implicit, IMPLICIT))
}
METHODS = {name: _MADE[name] for name in (*get_args(Explicit), *get_args(Implicit))}
