"""The force at the first anchor between pictures, for pages that play it as sound."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.live.audience import Audience

if TYPE_CHECKING:
    from ropewalk.live.track import Track

RATE = 4000.0  # forces a second of simulated time at most: each of them is a call of the kernels
MOST = 4000  # forces that wait for a picture at most


class Ear:
    """Listens to a track while any page wants to hear it."""

    def __init__(self) -> None:
        self._pages: set[int] = set()
        self._forces: list[float] = []

    def listen(self, page: int, on: bool) -> None:
        """Begin or end to listen for a page."""
        (self._pages.add if on else self._pages.discard)(page)
        self._forces.clear()

    def attend(self, track: Track) -> None:
        """Listen to this track from now on, or to nothing where no page does."""
        track.ear = self if self._pages else None

    def steps(self, dt: float) -> int:
        """Return how many steps of `dt` [s] there are from one force to the next."""
        return max(1, round(1.0 / (RATE * dt)))

    def hear(self, track: Track) -> None:
        """Note the force of the first anchor that holds, along up: what a string's bridge feels [N]."""
        state = track.simulation.arrays
        held = np.flatnonzero(state.held)
        if len(held) and len(self._forces) < MOST:
            self._forces.append(float(state.reaction[held[0]] @ np.array(track.scene.up)))

    def tell(self, audience: Audience, dt: float, speed: float) -> None:
        """Tell the pages what was heard since the last time; slow motion sounds lower, as a tape does."""
        if self._forces:
            found: dict[str, Any] = {"type": "sound", "seconds": self.steps(dt) * dt / speed}
            audience.tell(found | {"forces": [round(force, 6) for force in self._forces]})
            self._forces = []
