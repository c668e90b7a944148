"""What explicit steps make of a segment that goes slack and taut again.

A segment that hits its end and flies off again gets back, in exact time, the energy that it brought. In steps
it goes taut somewhere within a step and slack somewhere within another, and the energy comes back multiplied
by a number that depends on these two places. For symplectic methods its logarithm is zero on average, so that
its mean is above one: over many such bounces energy grows, at any step, by about y^4 / 180 per bounce (y =
frequency times step), if no friction takes it. Here a bounce is computed for places spread evenly over the
step. A step counts as stable when even a segment that bounces without a pause for the whole run, at the
highest frequency of the slack ones, gains less than `TENFOLD` times its energy.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.bound import Chain, highest_frequency
from ropewalk.methods.explicit_methods import RUNGE_KUTTA
from ropewalk.methods.registry import METHODS

TENFOLD = 10.0  # [1] of energy
_PLACES = 32
_LOWEST, _HIGHEST = 0.08, 3.0  # frequency times step
_GRID = np.geomspace(_LOWEST, _HIGHEST, 40)
_SLOWER = np.array([1.0, 0.85, 0.7, 0.5])  # modes below the highest, over it
_MOST_STEPS = 120  # a bounce takes pi / y of them and friction a little more
_STEPWISE = 1e-9  # [1] a gain this small is rounding

Step = Callable[[Floats, Floats, Floats, Floats, Floats], tuple[Floats, Floats, Floats]]


class Bounce(NamedTuple):
    """The fastest segment that may go slack."""

    frequency: float  # [rad/s] of the chain of these segments while all are taut
    ratio: float  # [1] damping ratio at that frequency, the least of all


def bounce_of(chain: Chain, one_way: Floats) -> Bounce | None:
    """Return the bounce of a chain whose segments marked in `one_way` (s,) do not push, or None."""
    stiffness = np.where(one_way, chain.stiffness, 0.0)
    frequency = highest_frequency(chain._replace(stiffness=stiffness, bending=0.0))
    if not 0.0 < frequency < math.inf:
        return None  # of links that nothing stretches explicit methods take none
    live = stiffness > 0.0
    friction = (chain.damping_vector + chain.damping_axial)[live]
    return Bounce(frequency, float((0.5 * frequency * friction / stiffness[live]).min()))


def largest_bounce_step(method: str, bounce: Bounce, duration: float) -> float:
    """Return the largest step [s] in which bounces all through `duration` [s] gain little; inf: any.

    0 where no step is short enough.
    """
    if METHODS[method].implicit or duration <= 0.0:
        return math.inf
    number = duration * bounce.frequency / (2.0 * math.pi)
    allowed = math.log(TENFOLD) / number
    gains = _gains(method, bounce.ratio)
    good = gains <= allowed
    if good.all():
        return math.inf
    first = int(np.argmin(good))
    if first > 0:
        return float(_GRID[first - 1]) / bounce.frequency
    if method in ("semi-implicit-euler", "verlet"):  # as y^4
        return float(_LOWEST * (allowed / float(gains[0])) ** 0.25 / bounce.frequency)
    return 0.0


def bounce_growth(method: str, bounce: Bounce, dt: float) -> float:
    """Return the factor per step by which the speed of such a segment grows [1]; 1: it does not."""
    if METHODS[method].implicit:
        return 1.0
    y = dt * bounce.frequency
    gain = float(np.interp(y, _GRID, _gains(method, bounce.ratio)))
    return math.exp(0.5 * max(gain, 0.0) * y / (2.0 * math.pi))


@lru_cache(maxsize=256)
def _gains(method: str, ratio: float) -> Floats:
    """Return the logarithm of a bounce's mean gain of energy on the grid, (y,), modes below included.

    A slower mode has less friction, but bounces less often.
    """
    y = np.repeat(_GRID[:, None] * _SLOWER, _PLACES, axis=1).ravel()
    slower = np.tile(np.repeat(_SLOWER, _PLACES), _GRID.size)
    back = _returned(_STEPS[method], y, ratio * slower)
    shape = _GRID.size, _SLOWER.size, _PLACES
    mean = np.log(np.maximum(back.reshape(shape).mean(axis=2), 1e-300))
    mean[np.abs(mean) < _STEPWISE] = 0.0
    return np.asarray((mean * _SLOWER).max(axis=1))


def _returned(step: Step, y: Floats, ratio: Floats) -> Floats:
    """Return the energy after a bounce over that before it, for steps y and damping ratios, (m,)."""
    place = np.tile((np.arange(_PLACES) + 0.5) / _PLACES, y.size // _PLACES)
    x, v, kept = -place * y, np.ones_like(y), np.zeros_like(y)
    energy, away = np.ones_like(y), np.zeros(y.shape, dtype=bool)
    for _ in range(_MOST_STEPS):
        # Where friction makes the taut spring itself unstable it overflows: the linear bounds are below that.
        with np.errstate(over="ignore", invalid="ignore"):
            x, v, kept = step(x, v, kept, y, ratio)
        gone = ~away & (x < 0.0) & (v < 0.0) & (kept == 0.0)
        energy[gone] = v[gone] ** 2
        away |= gone
        if away.all():
            break
    energy[~away] = 0.0  # so much friction that it creeps
    return energy


def _pull(x: Floats, v: Floats, ratio: Floats) -> Floats:
    """Return the acceleration of a mass on a spring of frequency 1 that pulls, but does not push."""
    return np.asarray(np.where(x > 0.0, -x - 2.0 * ratio * v, 0.0))


def _semi_implicit_euler(
    x: Floats, v: Floats, kept: Floats, y: Floats, ratio: Floats
) -> tuple[Floats, Floats, Floats]:
    v = v + y * _pull(x, v, ratio)
    return x + y * v, v, kept


def _verlet(
    x: Floats, v: Floats, kept: Floats, y: Floats, ratio: Floats
) -> tuple[Floats, Floats, Floats]:
    x = x + y * v + 0.5 * y * y * kept
    after = _pull(x, v + y * kept, ratio)
    return x, v + 0.5 * y * (kept + after), after


def _runge_kutta(table: Floats) -> Step:
    def step(
        x: Floats, v: Floats, kept: Floats, y: Floats, ratio: Floats
    ) -> tuple[Floats, Floats, Floats]:
        speed, pull = v, _pull(x, v, ratio)
        dx, dv = table[1, 0] * speed, table[1, 0] * pull
        for node, weight in table[:, 1:].T:
            place, speed = x + y * node * speed, v + y * node * pull
            pull = _pull(place, speed, ratio)
            dx, dv = dx + weight * speed, dv + weight * pull
        return x + y * dx, v + y * dv, kept

    return step


_STEPS: dict[str, Step] = {
    "semi-implicit-euler": _semi_implicit_euler,
    "verlet": _verlet,
    **{method.name: _runge_kutta(method.table) for method in RUNGE_KUTTA},
}
