"""The stiffness at rest of a rope whose static elongation a data sheet gives.

The rope hangs under a preload, a length is marked on it, and the load is raised: the elongation e is what the
marked length gains, as a share of itself. With T(x) = EA x (1 + s x^2) of the unloaded rope's strain x:
    T(x1) = preload,   T(x2) = load,   (1 + x2) / (1 + x1) = 1 + e,
and for s = 0:  EA = (load - preload) / e - preload.
Source: for climbing ropes, 5 and 80 kg: Mammut, ropes catalogue, "what is tested", p. 32.
"""

from __future__ import annotations

import math

from ropewalk.theory.given import need
from ropewalk.theory.solid_fall import root_of
from ropewalk.words.safe_side import rounded_down

PRELOAD_SHARE = 5.0 / 80.0  # of the load, in the test of climbing ropes [1]
_LONGEST = math.log(1e3)  # strain that is looked at [1]


def rope_at_rest(
    elongation: float,
    load: float,
    *,
    preload: float | None = None,
    stiffening: float = 0.0,
) -> float:
    """Return the EA at strain 0 [N] of the rope that has this static elongation.

    Args:
        elongation: of the length marked under the preload, under the load [1].
        load: [N].
        preload: under which the length is marked [N]; 5/80 of the load by default, as for climbing ropes.
        stiffening: s of a tension EA x (1 + s x^2) [1].

    Raises ValueError for numbers that are not positive (stiffening, preload: negative), for a preload that
    reaches the load, and for an elongation that only a rope without stiffness would have.

    Source: the module's.
    """
    need("elongation", elongation, "1")
    need("load", load, "N")
    first = PRELOAD_SHARE * load if preload is None else preload
    if not 0.0 <= first < load:
        raise ValueError(f"preload: {first:g} - must be from 0 to below the load, {load:g} N")
    if not 0.0 <= stiffening < math.inf:
        raise ValueError(f"stiffening: {stiffening:g} - must be 0 or greater")
    least = (load - first) / elongation - first
    if not least > 0.0:
        most = (load - first) / first
        raise ValueError(f"elongation: {elongation:g} - must be below {rounded_down(most, 4)}")

    def under(strain: float) -> float:
        """Load over EA [1]."""
        return strain * (1.0 + stiffening * strain * strain)

    def too_soft(size: float) -> float:
        """How much more than the preload was on the rope when it was marked [1], if it ends so."""
        end = math.exp(size)
        start = (1.0 + end) / (1.0 + elongation) - 1.0
        return under(start) / under(end) - first / load

    if stiffening == 0.0:
        return least
    low = high = math.log(
        load / least
    )  # a rope that stiffens is longer at both ends than the straight line
    while too_soft(high) < 0.0:
        high += 0.2
        if high > _LONGEST:
            raise ValueError(f"elongation: {elongation:g} - no rope that stiffens so has it")
    return load / under(math.exp(root_of(too_soft, low, high)))
