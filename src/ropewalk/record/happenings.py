"""What happens to a scene while it runs: anchors let go, winches stop, ropes part, slides run off them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.hands.drum import EMPTY, PARTED, RELEASED, limit_reached, parted_at
from ropewalk.methods.registry import METHODS
from ropewalk.record.event_log import RAN_OFF, Event
from ropewalk.simulation import Simulation

STOPPED, LET_GO = "winch stopped", "released"
Bools = np.ndarray[Any, np.dtype[np.bool_]]
PLANNED = "stop time"


class Watch:
    """Looks at a simulation now and then and tells what has happened since the last look.

    Times are the scene's where it gives them; where steps are not cut there an anchor lets go at the begin of
    the next one. A winch at a limit has stopped where its speed brings it to what it has wound: exact as long
    as it turned at one speed since the last look.
    """

    def __init__(self, simulation: Simulation, *, resumed: bool = False) -> None:
        """Begin at the present state; what has happened before it is told unless `resumed`."""
        self._simulation = simulation
        self._held: Ints = np.ones_like(simulation.arrays.held)
        self._told: set[tuple[int, str]] = set()
        self._ended: set[str] = set()
        self._whole: Bools = np.ones(simulation.arrays.memory.parting.time.size, dtype=bool)
        self._slid: Bools = np.ones(len(simulation.scene.slides), dtype=bool)
        self._time, self._paid = simulation.time, simulation.arrays.winch_paid.copy()
        if resumed:
            self.look()

    def leave(self, ropes: Iterable[str]) -> None:
        """Tell no more of some ropes, which broke."""
        self._ended |= set(ropes)

    def look(self) -> list[Event]:
        """Return what has happened, in order of time: `event`, `time` [s], and whom it concerns."""
        found = [*self._releases(), *self._stops(), *self._partings(), *self._slides()]
        state = self._simulation.arrays
        self._time, self._paid = self._simulation.time, state.winch_paid.copy()
        return sorted(found, key=lambda event: float(event["time"]))

    def _releases(self) -> list[Event]:
        simulation, held = self._simulation, self._simulation.arrays.held
        gone = np.flatnonzero((self._held == 1) & (held == 0))
        self._held = held.copy()
        release: Floats = simulation.system.anchors.release
        names = simulation.layout.anchor_names
        return [
            {"event": LET_GO, "time": self._let_go(float(release[row])), "anchor": names[row]}
            for row in gone
        ]

    def _let_go(self, release: float) -> float:
        """Return when an anchor with this release time [s] let go: then, or at the begin of the next step."""
        start, dt, _ = self._simulation.clock
        if METHODS[self._simulation.plan.method].cuts or release < start:
            return release
        return max(release, start + math.ceil((release - start) / dt - 1e-6) * dt)

    def _stops(self) -> list[Event]:
        simulation, found = self._simulation, []
        for row, winch in enumerate(simulation.scene.winches):
            why, time = self._stop_of(row)
            if why and winch.rope not in self._ended and (row, why) not in self._told:
                self._told.add((row, why))
                event: Event = {"event": STOPPED, "time": time, "winch": winch.name, "by": why}
                if why == EMPTY and winch.on_drum is None:
                    event["drum"] = "sized by the run's duration; on_drum gives it a length"
                found.append(event)
        return found

    def _partings(self) -> list[Event]:
        """Tell which segments have parted, at the end of which step, and at what tension [N]."""
        simulation, parted = self._simulation, self._simulation.arrays.memory.parting
        whole = np.isinf(parted.time)
        gone = np.flatnonzero(self._whole & ~whole)
        self._whole = whole
        found = []
        for j in gone:
            rope, segment = simulation.layout.rope_of(int(j))
            time, tension = float(parted.time[j]), float(parted.tension[j])
            where = {"rope": rope, "segment": segment, "tension": tension}
            if rope not in self._ended:
                found.append({"event": PARTED, "time": time, **where})
        return found

    def _slides(self) -> list[Event]:
        """Tell what has run off a rope that parted, at the end of which step."""
        simulation = self._simulation
        if not self._slid.size:
            return []
        off = simulation.arrays.memory.slide.off
        on = np.isinf(off)
        gone = np.flatnonzero(self._slid & ~on)
        self._slid = on
        slides = [simulation.scene.slides[int(row)] for row in gone]
        return [
            {"event": RAN_OFF, "time": float(off[row]), "slide": slide.name, "rope": slide.on}
            for row, slide in zip(gone, slides, strict=True)
            if not {slide.rope, slide.on} & self._ended
        ]

    def _stop_of(self, row: int) -> tuple[str, float]:
        """Return what a winch was stopped by and when [s]."""
        simulation = self._simulation
        winches, state, now = simulation.system.winches, simulation.arrays, simulation.time
        speed = float(winches.speed[row])
        if speed == 0.0 or now < winches.start[row]:
            return "", now
        stop, anchor = float(winches.stop[row]), winches.anchor[row]
        release = float(simulation.system.anchors.release[anchor])
        let_go = state.held[anchor] == 0 and release < stop
        parted = parted_at(winches, state, row)
        if parted < min(stop, release if let_go else math.inf):
            stood = any(known == row for known, _ in self._told)
            return ("", now) if stood else (PARTED, max(parted, float(winches.start[row])))
        why = limit_reached(simulation.system, state, row, speed) if math.isinf(parted) else ""
        if why:
            began = max(self._time, float(winches.start[row]))
            time = began + (float(state.winch_paid[row]) - float(self._paid[row])) / speed
            return why, min(max(time, self._time), now) if math.isfinite(time) else now
        if let_go:
            return RELEASED, self._let_go(release)
        return (PLANNED, stop) if now >= stop else ("", now)
