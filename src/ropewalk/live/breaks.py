"""Why a live session broke: the steps before the break are taken again and looked at."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.analysis.diagnosis import Diagnosis, diagnose, retrace
from ropewalk.analysis.stability import stability
from ropewalk.core.arrays import Floats
from ropewalk.live.remedies import as_messages
from ropewalk.live.session import Session
from ropewalk.live.track import Saved, Track
from ropewalk.simulation import Simulation

_HISTORY = 400  # steps to look at
_MOST_WORK = 3_000_000  # steps times nodes taken again


def explain(session: Session) -> dict[str, Any]:
    """Return the message about the break of a session; the session stays as it is."""
    assert session.broken is not None
    track = session.tracks[session.broken.variant]
    here, failure = track.simulation.state, track.simulation.failure
    try:
        found = _diagnosis(session, track)
    finally:
        track.simulation.restore(here)
    index = track.simulation.layout.node(found.node, found.rope)
    return {
        "type": "broken",
        "variant": session.broken.variant,
        "time": track.simulation.time,
        "step": session.count,
        "rope": found.rope,
        "node": found.node,
        "index": index,
        "text": failure or found.text,
        "sign": "" if failure else found.sign,
        "remedies": as_messages(session),
    }


def _diagnosis(session: Session, track: Track) -> Diagnosis:
    assert session.broken is not None
    simulation = track.simulation
    here = simulation.state
    positions = _from_history(session, track)
    if positions is None:
        simulation.restore(here)
        positions = retrace(simulation, max(session.broken.chunk, 1) + 1)
    simulation.restore(here)
    theory = stability(simulation.model)
    return diagnose(theory, simulation.layout, positions, simulation.time, track.count)


def _from_history(session: Session, track: Track) -> Floats | None:
    """Return the steps from an earlier moment up to the break, or None when they end otherwise.

    Hands that moved in between are not followed, so the break may not come again; then there is no
    telling from these steps.
    """
    assert session.broken is not None
    simulation: Simulation = track.simulation
    start = _start(session, track)
    if start is None or start.snapshot.dt != track.dt:
        return None
    steps = track.count - start.steps + session.broken.chunk + 2  # one more than it breaks in
    if steps * simulation.layout.nodes > _MOST_WORK:
        return None
    simulation.restore(start.snapshot)
    positions = retrace(simulation, steps, keep=_HISTORY)
    last = positions[-1]
    span = float(np.ptp(positions[0], axis=0).max()) + 1.0
    wild = not np.isfinite(last).all() or float(np.abs(last).max()) > 1e3 * span
    return positions if wild or len(positions) < steps else None


def _start(session: Session, track: Track) -> Saved | None:
    """The newest moment of the simulation that broke which lies well before the break, else its oldest."""
    known = [
        one
        for moment in session.history.newest_first()
        for one in moment.tracks
        if one.simulation is track.simulation
    ]
    if track.begun.simulation is track.simulation:
        known.append(track.begun)
    early = [one for one in known if track.count - one.steps >= _HISTORY // 4]
    return early[0] if early else (known[-1] if known else None)
