"""The two balances of a run.

Every law's work is booked at the velocity of mid-step, v + h a / 2, for which the change of the kinetic
energy is the sum of all works, whatever the method: what is left of that balance is round-off. The sum
of the energies also holds the potential energies, whose changes a method meets only up to its order:
what is left of this one is the method's error.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.recording import CONSERVATIVE

_WITH_JUMPS = ("limiter", "winch", "clamps")


def energy_error(energy: Mapping[str, Floats], work: Mapping[str, Floats], ledger: bool) -> Floats:
    """Return total - total[0] - works of all laws without a potential [J], (frames,).

    NaN where frames recorded into a break are no longer finite.
    """
    total = energy["total"]
    if not ledger:
        return np.full(total.shape, np.nan)
    others = [w for name, w in work.items() if name not in CONSERVATIVE]
    with np.errstate(invalid="ignore", over="ignore"):
        done = sum(others, np.zeros(total.shape))
        error: Floats = total - total[0] - (done - done[0])
    return error


def turned_over(energy: Mapping[str, Floats]) -> float:
    """Return the largest change of any one form of energy [J]: what an energy error is a share of.

    Frames whose numbers are not finite are left out; 0 where nothing changes.
    """
    forms = [np.asarray(part) for name, part in energy.items() if name != "total"]
    finite = [part[np.isfinite(part)] for part in forms]
    return max((float(np.ptp(part)) for part in finite if part.size), default=0.0)


def balance_residual(
    energy: Mapping[str, Floats], work: Mapping[str, Floats], jump: Floats, ledger: bool
) -> Floats:
    """Return the change of the kinetic energy minus all works [J], (frames,).

    Limiter and winch change positions and masses too; only what they put into the kinetic energy
    (`jump`, (frames, 2)) counts here. Turning a clamp puts its work into the energy of bending.
    NaN where frames recorded into a break are no longer finite.
    """
    kinetic = energy["kinetic"]
    if not ledger:
        return np.full(kinetic.shape, np.nan)
    others = [w for name, w in work.items() if name not in _WITH_JUMPS]
    with np.errstate(invalid="ignore", over="ignore"):
        done = sum(others, jump.sum(axis=1))
        residual: Floats = kinetic - kinetic[0] - (done - done[0])
    return residual
