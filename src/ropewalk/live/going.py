"""How a broadcast goes, for its pages: the `status` message, and the head of its frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ropewalk.live.frame import BROKEN, GRABBED, PLAYING, SLOW, Clockwork

if TYPE_CHECKING:
    from ropewalk.live.broadcast import Broadcast


def status(broadcast: Broadcast) -> dict[str, Any]:
    """Return the `status` message."""
    session, pace, playing = broadcast.session, broadcast.pace, broadcast.playing
    plan = session.main.simulation.plan
    slow = playing and pace.slow
    nodes = session.main.simulation.layout.nodes
    return {
        "type": "status",
        "playing": playing,
        "speed": session.speed,
        "realtime": pace.realtime if playing else 0.0,
        "slow": slow,
        "text": pace.words(nodes, plan.dt) if slow else broadcast.text,
        "waits": broadcast.waits,
        "time": session.time,
        "step": session.count,
        "dt": plan.dt,
        "steps_per_frame": plan.steps_per_frame,
        "method": plan.method,
        "broken": session.broken is not None,
        "clients": broadcast.audience.size,
        "address": broadcast.address,
        "undo": session.undo.word,
        "duration": broadcast.duration,
    }


def head(broadcast: Broadcast) -> Clockwork:
    """Return what a frame begins with."""
    session, pace, playing = broadcast.session, broadcast.pace, broadcast.playing
    flags = PLAYING * playing + BROKEN * (session.broken is not None)
    flags += SLOW * (playing and pace.slow)
    flags += GRABBED * bool(session.main.hands.grabs)
    realtime = pace.realtime if playing else 0.0
    numbers = broadcast.layout_number, broadcast.frame_number
    return Clockwork(
        *numbers, flags, session.time, session.count, realtime, session.speed, pace.load
    )
