"""Why a live session broke: the steps before the break are taken again and looked at.

That may take long, so a question is asked in the broadcast's thread and answered by any thread, with a
simulation of its own.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.analysis.diagnosis import Diagnosis, diagnose, parted_segments, retrace
from ropewalk.analysis.stability import stability
from ropewalk.core.arrays import Floats
from ropewalk.live.meter import measure
from ropewalk.live.remedies import as_messages, holds_without_friction
from ropewalk.live.saved import Saved
from ropewalk.live.session import Break, Session
from ropewalk.live.track import Track
from ropewalk.record.beyond import cut, look_beyond
from ropewalk.simulation import Simulation, Snapshot

_HISTORY = 400  # steps to look at
_STEPS_SENT, _MOST_SENT = 8, 6000  # steps past the break, and nodes of them all, told to the page
_MOST_WORK = 3_000_000  # steps times nodes taken again
# Of the meter at the break.
_CAUSE = ("stable", "bound", "meter", "meter_limit", "meter_name", "spring_factor")


@dataclass(frozen=True)
class Question:
    """All that the answer needs of a session that broke; none of it changes any more."""

    broken: Break
    changed: bool  # whether constants were changed since
    simulation: Simulation  # that broke; only its model, layout and plan are looked at
    now: Simulation  # with the constants as they are now
    here: Snapshot
    start: Saved | None  # a moment before the break shows
    time: float
    step: int  # of the session
    steps: int  # of the variant
    failure: str
    reason: str

    @classmethod
    def of(cls, session: Session) -> Question:
        """Ask about a session that is broken."""
        assert session.broken is not None
        track = session.tracks[session.broken.variant]
        simulation = session.broken.simulation or track.simulation
        return cls(
            session.broken,
            session.revision != session.broken.revision,
            simulation,
            track.simulation,
            simulation.state,
            _start(session, track, simulation),
            simulation.time,
            session.count,
            track.count,
            simulation.failure,
            simulation.reason,
        )

    def at_once(self) -> dict[str, Any]:
        """Return the message as far as it is known without looking."""
        index = self.simulation.layout.ropes[0].start
        rope, node = self.simulation.layout.rope_of(index)
        return {
            "type": "broken",
            "variant": self.broken.variant,
            "time": self.time,
            "step": self.step,
            "rope": rope,
            "node": node,
            "index": index,
            "text": f"Broke after t = {self.time:.6g} s. The steps before it are being looked at.",
            "sign": "",
            "cause": None,
            "remedies": as_messages(None, self.changed),
            "past": [],
        }

    def remedies(self) -> list[dict[str, Any]]:
        """Return the ways out."""
        return as_messages(self.now, self.changed)

    def answer(self) -> dict[str, Any]:
        """Return the message about the break."""
        found = self._diagnosis()
        return self.at_once() | {
            "rope": found.rope,
            "node": found.node,
            "index": self.simulation.layout.node(found.node, found.rope),
            "text": self.failure or found.text,
            "sign": "" if self.failure else found.sign,
            "cause": self._cause(),
            "remedies": self.remedies(),
            "past": self._past(),
        }

    def _cause(self) -> dict[str, Any]:
        """Return what the meter says of the step that broke; the page's own may be of before a change."""
        model = self.simulation.model
        found = measure(model)
        rubs = not found["stable"] and holds_without_friction(model)
        return {name: found[name] for name in _CAUSE} | {"rubs": rubs}

    def _past(self) -> list[dict[str, Any]]:
        """Return the first steps from the last good state into the break, as far as they can be drawn.

        None where the rope does not break from there by itself (a hand did it), or is too large to send.
        """
        again = Simulation(self.simulation.model)
        again.restore(self.here)
        before = again.positions.copy()
        if self.failure or 2 * len(before) > _MOST_SENT:
            return []
        found = look_beyond(again)
        if found is None:
            return []
        shown = cut(found, before)
        if len(shown.time) == len(found.time):
            return []
        most = min(_STEPS_SENT, _MOST_SENT // len(before))
        steps = zip(shown.time[-most:], shown.positions[-most:], strict=True)
        return [{"time": float(t), "positions": x.round(5).tolist()} for t, x in steps]

    def _diagnosis(self) -> Diagnosis:
        model, layout = self.simulation.model, self.simulation.layout
        positions = self._from_history()
        if positions is None:
            again = Simulation(model)
            again.restore(self.here)
            positions = retrace(again, max(self.broken.chunk, 1) + 1)
        theory, when = stability(model), (self.time, self.steps)
        parted = parted_segments(self.simulation)
        return diagnose(theory, layout, positions, *when, self.reason, parted)

    def _from_history(self) -> Floats | None:
        """Return the steps from an earlier moment up to the break, or None when they end otherwise.

        Hands that moved in between are not followed, so the break may not come again; then there is no
        telling from these steps.
        """
        start = self.start
        if start is None or start.snapshot.dt != self.here.dt:
            return None
        steps = self.steps - start.steps + self.broken.chunk + 2  # one more than it breaks in
        if steps * self.simulation.layout.nodes > _MOST_WORK:
            return None
        again = Simulation(self.simulation.model)
        again.restore(start.snapshot)
        positions = retrace(again, steps, keep=_HISTORY)
        last = positions[-1]
        span = float(np.ptp(positions[0], axis=0).max()) + 1.0
        wild = not np.isfinite(last).all() or float(np.abs(last).max()) > 1e3 * span
        return positions if wild or len(positions) < steps else None


def explain(session: Session) -> dict[str, Any]:
    """Return the message about the break of a session; the session stays as it is."""
    return Question.of(session).answer()


def _start(session: Session, track: Track, simulation: Simulation) -> Saved | None:
    """The newest moment of the simulation that broke which lies well before the break, else its oldest."""
    known = [
        one
        for moment in session.history.newest_first()
        for one in moment.tracks
        if one.simulation is simulation
    ]
    if track.begun.simulation is simulation:
        known.append(track.begun)
    early = [one for one in known if track.count - one.steps >= _HISTORY // 4]
    return early[0] if early else (known[-1] if known else None)
