"""A broadcast for a simulation that the user's own program steps."""

from __future__ import annotations

from ropewalk.live.broadcast import Broadcast
from ropewalk.live.pictures import combiner
from ropewalk.live.session import Session
from ropewalk.simulation import Simulation

LONGEST = 0.1  # [s] of simulated time that a force of a hand is held at most


class ProgramBroadcast(Broadcast):
    """Shows a simulation whenever it is told to, and lets hands pull it in between.

    The simulation stays the user's: nothing that would put another in its place is possible.
    """

    mode = "program"

    def __init__(self, simulation: Simulation) -> None:
        super().__init__(Session.of(simulation))
        self._time = simulation.time
        self.latest = (0, b"")  # number and bytes of the newest frame
        self.show()

    @property
    def can(self) -> list[str]:
        """The types of commands that are accepted."""
        return ["move", "drag", "drop", "obstacle", "grab", "let_go", "kick"]

    def tick(self) -> None:
        """Carry out what waits, bring the hands up to date, show a frame."""
        self.handle()
        main = self.session.main
        now = main.simulation.time
        if main.hands.active:
            interval = min(max(now - self._time, main.dt), LONGEST)
            main.hands.update(main.simulation, interval, 1.0)
        if now != self._time:
            self.pace.note(now)
        self._time = now
        self.session.look()
        self.refresh()
        found = self.meter.take()
        if found is not None:
            self.audience.tell(found)
        self.tell_status_now_and_then()
        self.show()

    def show(self) -> None:
        """Make a frame, show it, and keep it for pages that come after the program's last one."""
        self._dirty = False
        self.frame_number += 1
        self.latest = (self.frame_number, self.frame())
        self.audience.show(*self.latest, combiner(self.session.tracks))
        self._begin_intervals()
        if self.audience.size > 0:
            self.meter.begin()
