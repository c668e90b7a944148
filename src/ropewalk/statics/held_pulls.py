"""Which tensions friction holds along a stretch of rope on a surface, and what share of it that takes."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.polygon import tilted
from ropewalk.lowering import Span
from ropewalk.lowering.touching import Contacts

_JAMS = 1e-9  # share of the pull that moves the rope on, below which it jams [1]
_ROUNDING = 1e-6  # of a tension [1]
_TRIES, _CLOSE = 40, 1e-6  # for the share of friction that is taken, and how well [1]
_AGAIN = 20  # times that a coefficient is found by the way a contact then carries


def share_of(pull: float, holds: Callable[[float], tuple[float, float, bool]]) -> float:
    """Return the least share of friction with which a pull is held [N], see `holds`, by false position."""
    least, most, _ = holds(0.0)
    if least <= pull <= most:
        return 0.0
    more = pull > most

    def lacks(share: float) -> float:
        least, most, _ = holds(share)
        return pull - most if more else least - pull

    low, high = 0.0, 1.0
    short, over = (pull - most if more else least - pull), lacks(1.0)
    for _ in range(_TRIES):
        if not over < 0.0 or high - low < _CLOSE:
            break
        inside = math.isfinite(over)
        share = low + (high - low) * (short / (short - over) if inside else 0.5)
        if (left := lacks(share)) > 0.0:
            low, short, over = share, left, 0.5 * over
        else:
            high, over, short = share, left, 0.5 * short
        if abs(left) < _CLOSE * pull:
            return share
    return high


def allowed(
    x: Floats, tension: Floats, others: Floats, contacts: Contacts, rows: Ints, rope: Span
) -> tuple[float, float, bool]:
    """Return the least and the largest tension after a stretch that friction holds [N], see `Wrap`.

    Node by node from the tension before it, in the shape as it is, with all of friction that what the rope
    needs across leaves along it, one way or the other (`_held`). Round a drum without weight it is
    exp(-mu theta) and exp(mu theta) times the tension before. Where the rope ends there it is taken from
    that end, without tension, back.

    A rope that turns by a towards the surface and by b within it presses with T a and needs T b across, so
    that dT = T sqrt((mu a)^2 - b^2) is left along it: on a sphere of radius R, along a circle R sin(beta) off
    its centre, exp(theta sqrt(mu^2 - tan^2 beta)) in all.
    Source: Maddocks & Keller 1987, Ropes in equilibrium, SIAM J. Appl. Math. 47:1185.
    """
    row_of = {int(contacts.node[row]): row for row in rows}
    nodes = np.arange(min(row_of), max(row_of) + 1)
    step = 1 if nodes[-1] < rope.end else -1
    nodes, far = nodes[::step], rope.end if step > 0 else rope.start
    given = int(nodes[0]) - (step > 0)
    start = float(tension[given]) if rope.start <= given < rope.end else 0.0
    ends = []
    for more in (False, True):
        pull = start
        for i in nodes:
            if i == far:  # all of the rope lies there
                return math.nan, math.nan, False
            into = (
                _unit(x[:, i] - x[:, i - step])
                if rope.start <= i - step <= rope.end
                else np.zeros(3)
            )
            out = _unit(x[:, i + step] - x[:, i])
            row = row_of.get(int(i))
            mu = float(contacts.cone[row]) if row is not None else 0.0
            off = float(contacts.off[row]) * step if row is not None else 0.0
            n = contacts.normal[row] if row is not None else _unit(into - out)
            pull = _held_off(pull * into - others[:, i], into + out, out, n, mu, off, more=more)
            if math.isinf(pull):
                break
        ends.append(pull)
    return min(ends), max(ends), step < 0


def _held_off(
    given: Floats, along: Floats, out: Floats, n: Floats, mu: float, off: float, *, more: bool
) -> float:
    """Return what `_held` does of a contact that is `off` the middle of its turn [rad], see `laws.polygon`.

    Its coefficient hangs on how far what it carries is `along` the rope.
    """
    if off == 0.0:
        return _held(given, out, n, mu, more=more)
    way, c = _unit(along - n * (n @ along)), 1.0 if more else -1.0
    for _ in range(_AGAIN):
        pull = _held(given, out, n, tilted(mu, off, c), more=more)
        if math.isinf(pull):
            break
        rub = given - pull * out
        before, c = c, -float(way @ _unit(rub - n * (n @ rub)))
        if abs(c - before) < _ROUNDING:
            break
    return pull


def _held(given: Floats, out: Floats, n: Floats, mu: float, *, more: bool) -> float:
    """Return the largest tension T of the segment along `out` that a contact holds [N], or the least.

    With c the `given` force, R = c - T out has to be within the cone of friction about the normal `n`,
        |c_t - T o_t|^2 = mu^2 (c_n - T o_n)^2
    at its edge: what R carries across the rope it lacks along it. inf where the node jams; where no tension
    would do, the one that comes nearest.
    """
    down, deep = float(given @ n), float(out @ n)
    across, over = given - down * n, out - deep * n
    a = float(over @ over) - (mu * deep) ** 2
    b = float(across @ over) - mu**2 * down * deep
    c = float(across @ across) - (mu * down) ** 2
    root = math.sqrt(max(b * b - a * c, 0.0))
    if not a > _JAMS:
        return math.inf if more or not b > 0.0 else max(c / (b + root), 0.0)
    return max((b + root if more else b - root) / a, 0.0)


def _unit(direction: Floats) -> Floats:
    size = float(np.linalg.norm(direction))
    found: Floats = direction / size if size > 0.0 else direction
    return found
