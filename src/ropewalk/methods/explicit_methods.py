"""The explicit Runge-Kutta methods, one entry each: their stages each use the stage before.

Another one is the `METHOD` of a file of its own in this folder, called as the method, with underscores.
"""

from __future__ import annotations

from typing import NamedTuple, get_args

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.names import Explicit, of_name

OWN_KERNELS = ("semi-implicit-euler", "verlet")  # explicit methods that are no Runge-Kutta methods
_MOST_STAGES = 4  # `bound` looks for the largest step of no more


class ExplicitMethod(NamedTuple):
    """What the registry, the stability of a step and its cost need to know of one."""

    name: str
    order: int
    table: Floats  # nodes c (row 0) and weights b (row 1), (2, s)
    summary: str  # a sentence for those who choose


def stages(c: list[float], b: list[float]) -> Floats:
    """Return the table of a method, (2, s): stage s is at c_s times the slope of the stage before.

    Raises ValueError where nodes and weights are not as many, for more than 4 stages, or where c_1 is not 0.
    """
    if len(c) != len(b) or not 0 < len(c) <= _MOST_STAGES or c[0] != 0.0:
        raise ValueError(f"no table of 1 to {_MOST_STAGES} stages that begin at 0: {c}, {b}")
    return np.array([c, b])


_MADE = (
    ExplicitMethod(
        "euler",
        1,
        stages([0.0], [1.0]),
        "Explicit Euler; gains energy, for comparison only.",
    ),
    ExplicitMethod(
        "heun",
        2,
        stages([0.0, 1.0], [0.5, 0.5]),
        "Improved Euler, Habrador's; weakly unstable without friction.",
    ),
    ExplicitMethod(
        "rk4",
        4,
        stages([0.0, 0.5, 0.5, 1.0], [1 / 6, 1 / 3, 1 / 3, 1 / 6]),
        "Classical Runge-Kutta; the most accurate per step.",
    ),
)

RUNGE_KUTTA = tuple(of_name(name, _MADE) for name in get_args(Explicit) if name not in OWN_KERNELS)
