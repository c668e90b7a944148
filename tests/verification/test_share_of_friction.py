"""How much of its friction a rope at rest takes: the least share of it that would hold the rope.

Of a rope without weight on a drum that is ln(ratio of tensions) / (mu angle).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.statics import static_shape
from verification.test_rest_on_obstacles import drum, table, weighted


@pytest.mark.parametrize("ratio", [1.0, 1.2, 1.5, 2.0, 1.0 / 1.5])
def test_the_share_of_friction_is_that_of_logarithms(ratio: float) -> None:
    """As pages tell it of runs; a half of what held 2.566 to 1 was told where 1.283 pulled, which is 26 %."""
    (wrap,) = static_shape(weighted(ratio, drum(0.3))).wraps
    assert wrap.share == pytest.approx(abs(math.log(ratio)) / (0.3 * math.pi), abs=0.003)


def needed(hangs: float, edge: float) -> float:
    """Return the friction that holds a rope of 1 m of which so much hangs over a rounded edge [1].

    dT = (mu (T + w R cos a) - w R sin a) da from the table on, for w = 1.
    """

    def holds(mu: float) -> float:
        pull, count = mu * (1.0 - hangs - 0.5 * math.pi * edge), 1000
        for a in (np.arange(count) + 0.5) * 0.5 * math.pi / count:
            rate = mu * (pull + edge * math.cos(a)) - edge * math.sin(a)
            pull += rate * 0.5 * math.pi / count
        return pull

    tried = np.linspace(0.0, 0.4, 401)
    return float(np.interp(hangs, [holds(mu) for mu in tried], tried))


@pytest.mark.parametrize("hangs", [0.1, 0.2])
def test_the_share_of_friction_is_that_which_would_do(hangs: float) -> None:
    """The end of a tail that lies pulls nothing, so that no logarithm is known: 14 and 58 % for 47 and 78."""
    (wrap,) = static_shape(table(hangs)).wraps
    assert min(wrap.before, wrap.after) == 0.0
    assert wrap.share == pytest.approx(needed(hangs, 0.05) / 0.3, rel=0.03)
