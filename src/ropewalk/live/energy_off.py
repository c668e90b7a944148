"""How far the energy of a session is off, of what has changed most: its step is too long for the motion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats

if TYPE_CHECKING:
    from ropewalk.live.track import Track
    from ropewalk.methods.recording import Recording

_ROUNDING = 1e-4  # [1] of the largest energy there is: below that nothing is off


class Balance(NamedTuple):
    """What a session has turned over since its begin or last reset, and how far it was off."""

    # Kinetic, gravity and elastic energy, and what friction of surfaces has taken [J]: all but the elastic
    # one from 0. Other works do not count: a false ledger of them is large itself.
    low: tuple[float, ...]
    high: tuple[float, ...]
    error: float = 0.0  # the largest since what is computed was changed last [J]
    last: float = 0.0  # the energy error now [J]
    base: float = 0.0  # ... and as it was then

    @classmethod
    def begun(cls, elastic: float) -> Balance:
        """Return that of a begin with so much elastic energy [J]."""
        return cls((0.0, 0.0, elastic, 0.0), (0.0, 0.0, elastic, 0.0))

    def again(self) -> Balance:
        """Count the error from now on: another step has been chosen, or another scene."""
        return self._replace(error=0.0, base=self.last)

    def later(self, forms: tuple[float, ...], error: float) -> Balance:
        """Return it with energies of a later time [J]; those that are not finite tell nothing."""
        known = [
            now if math.isfinite(now) else low for now, low in zip(forms, self.low, strict=True)
        ]
        last = error if math.isfinite(error) else self.last
        return Balance(
            tuple(map(min, self.low, known)),
            tuple(map(max, self.high, known)),
            max(self.error, abs(last - self.base)),
            last,
            self.base,
        )

    @property
    def scalars(self) -> dict[str, float]:
        """The largest error, 0 where it is rounding, and the largest change of one energy [J]."""
        turned = max(high - low for low, high in zip(self.low, self.high, strict=True))
        told = self.error > _ROUNDING * max(map(abs, (*self.low, *self.high)))
        return {"energy_off": self.error if told else 0.0, "energy_turned": turned}


def weigh(track: Track, now: Recording) -> None:
    """Take note of a track's energies, from what is recorded of the present frame."""
    if not track.simulation.ledger:
        return
    energy, rubbed = now.energy[0], track.rubbed.until(track.simulation, now.books[0])
    forms = (
        float(energy[0]),
        float(energy[1]) - track.first_gravity,
        float(energy[2:].sum()),
        float(np.abs(rubbed).sum()),
    )
    track.balance = track.balance.later(forms, track.books(now)[2])


def frame_by_frame(begin: Balance, forms: Floats, errors: Floats) -> list[Balance]:
    """Return it for every frame of a part that begins so, of energies (frames, 4), errors (frames,) [J]."""
    found = []
    for row, error in zip(forms, errors, strict=True):
        begin = begin.later(tuple(map(float, row)), float(error))
        found.append(begin)
    return found
