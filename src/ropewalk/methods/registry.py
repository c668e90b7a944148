"""The methods of time integration by name: what users choose from and tables are made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats
from ropewalk.methods import characteristic, runge_kutta, semi_implicit_euler, verlet


class Method(NamedTuple):
    """One method: its order, cost and what it does to one mode of vibration."""

    name: str
    order: int
    evaluations: int  # force evaluations per step
    advance: Any  # the kernel
    tableau: tuple[Floats, ...]  # Runge-Kutta coefficients, the kernel's last argument, if any
    characteristic: Callable[[ArrayLike, ArrayLike], Floats]
    summary: str


METHODS = {
    method.name: method
    for method in (
        Method(
            "euler",
            1,
            1,
            runge_kutta.advance,
            (runge_kutta.EULER,),
            characteristic.euler,
            "Explicit Euler; gains energy, for comparison only.",
        ),
        Method(
            "semi-implicit-euler",
            1,
            1,
            semi_implicit_euler.advance,
            (),
            characteristic.semi_implicit_euler,
            "Velocity first, then position with it; symplectic without friction.",
        ),
        Method(
            "verlet",
            2,
            1,
            verlet.advance,
            (),
            characteristic.verlet,
            "Velocity Verlet; symplectic without friction.",
        ),
        Method(
            "heun",
            2,
            2,
            runge_kutta.advance,
            (runge_kutta.HEUN,),
            characteristic.heun,
            "Improved Euler, Habrador's; weakly unstable without friction.",
        ),
        Method(
            "rk4",
            4,
            4,
            runge_kutta.advance,
            (runge_kutta.RK4,),
            characteristic.rk4,
            "Classical Runge-Kutta; the most accurate per step.",
        ),
    )
}
