"""Winches as live objects: read how much rope is out, turn them by hand."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ropewalk.core.arrays import State, System, Winches
from ropewalk.laws.slides.table import room_of
from ropewalk.laws.winch import SPLIT, WINCH_SHARE
from ropewalk.lowering.joint_tables import tied_with
from ropewalk.words.annotations import unquoted
from ropewalk.words.safe_side import rounded_down, within

if TYPE_CHECKING:
    from ropewalk.simulation import Simulation

# Why a winch stands although it is told to turn.
EMPTY, LONGEST, SHORTEST = "empty drum", "max_length", "min_length"
LAST, HELD_NODE, RELEASED = "last segment", "held node", "released"
LOADED = "load"  # on the next node
PARTED, SLIDES = "rope parted", "room for a slide"
_ROUNDING = 1e-9  # [1] of a segment


@unquoted
class WinchHandle:
    """One winch of a running simulation."""

    __slots__ = ("_row", "_simulation")  # so that a slip of a name is refused

    def __init__(self, simulation: Simulation, row: int) -> None:
        self._simulation = simulation
        self._row = row

    @property
    def speed(self) -> float:
        """Rope per second that it is told to wind [m/s], + pays out; set it to turn from now on.

        What is set replaces the scene's speed and interval; the scene's lengths still limit it.
        Raises ValueError for what is no finite number, for a speed that would wind more than a fifth
        of a segment in a step (`adaptive` takes shorter steps), and for a winch whose drum was let go.
        """
        winches, row = self._winches, self._row
        turns = winches.start[row] <= self._simulation.time < winches.stop[row]
        return float(winches.speed[row]) if turns else 0.0

    @speed.setter
    def speed(self, value: float) -> None:
        speed = _finite(value)
        if not self._state.held[self._winches.anchor[self._row]]:
            raise ValueError("speed: the anchor of the drum has let go; the winch turns no more")
        plan = self._simulation.plan
        most = WINCH_SHARE * float(self._winches.segment[self._row]) / plan.dt
        if plan.tolerance is None and not within(0.0, abs(speed), most):
            raise ValueError(
                f"speed: {speed:g} - must be at most {rounded_down(most, 4)} m/s, a fifth of a segment a step"
            )
        self._simulation.turn_by_hand(self._row, speed)

    @property
    def length(self) -> float:
        """Unstretched length of its rope that is off the drums [m]."""
        return length_out(self._winches, self._state, self._row)

    @property
    def paid_out(self) -> float:
        """Rope it has paid out since the start, less what it has reeled in [m]."""
        return float(self._state.winch_paid[self._row])

    @property
    def on_drum(self) -> float:
        """Rope that is on the drum [m]."""
        return float(self._winches.drum[self._row]) - self.paid_out

    @property
    def limits(self) -> tuple[float, float]:
        """Least and largest unstretched length of the rope [m]; there it stops."""
        return float(self._winches.shortest[self._row]), float(self._winches.longest[self._row])

    @property
    def tension(self) -> float:
        """What the segment next to the drum carries [N], friction included; see `Result.tension`."""
        j = _working(self._winches, self._state, self._row)
        return float(self._simulation.recording().recording.tension[0, j])

    @property
    def stopped_by(self) -> str:
        """What keeps it from turning as it is told; empty when nothing does.

        "empty drum", "max_length", "min_length", "last segment" (half a segment is left outside),
        "held node" (an anchor holds the next node), "load" (one is on the next node), "released" (the drum
        was let go), "rope parted", or "room for a slide" (something slides along the rope, which needs what
        is left).
        """
        return why_stopped(self._simulation.system, self._state, self._row, self.speed)

    @property
    def _winches(self) -> Winches:
        return self._simulation.system.winches

    @property
    def _state(self) -> State:
        return self._simulation.arrays

    def __repr__(self) -> str:
        name, stopped = self._simulation.scene.winches[self._row].name, self.stopped_by
        doing = f"stopped ({stopped})" if stopped else f"turning at {self.speed:.4g} m/s"
        return f"<Winch {name!r}: {self.length:.6g} m out, {self.on_drum:.4g} m in, {doing}>"


def why_stopped(system: System, state: State, row: int, speed: float) -> str:
    """Return what keeps a winch from turning at `speed` [m/s]; empty when nothing does."""
    if speed == 0.0:
        return ""
    if not state.held[system.winches.anchor[row]]:
        return RELEASED
    if math.isfinite(parted_at(system.winches, state, row)):
        return PARTED
    return limit_reached(system, state, row, speed)


def limit_reached(system: System, state: State, row: int, speed: float) -> str:
    """Return which limit keeps a held winch from turning at `speed` [m/s]; empty when none does."""
    winches = system.winches
    little = _ROUNDING * float(winches.segment[row])
    drum, out = int(state.winch_exit[row]), length_out(winches, state, row)
    working = float(state.rest_length[_working(winches, state, row)])
    if speed > 0.0:
        no_node = drum == winches.first[row] and working >= SPLIT * winches.segment[row] - little
        if no_node or winches.drum[row] - state.winch_paid[row] <= little:
            return EMPTY
        return LONGEST if out >= winches.longest[row] - little else ""
    if out <= winches.shortest[row] + little:
        if winches.shortest[row] == 0.5 * winches.segment[row]:
            return LAST
        return SLIDES if _keeps_room(system, row) else SHORTEST
    outer = drum + int(winches.step[row])
    held = state.inverse_mass[outer] == 0.0 or len(tied_with(system.joints, state.tied, outer)) > 1
    if working > 0.5 * winches.segment[row] + little:
        return ""
    return HELD_NODE if held else LOADED if outer == winches.load[row] else ""


def _keeps_room(system: System, row: int) -> bool:
    """Tell whether a winch stops where it does for something that slides along its rope."""
    drums = system.node.slide.winch
    mine = drums[(drums == row).any(axis=1)]
    room = room_of(int((mine >= 0).sum(axis=1).max(initial=0))) * system.winches.segment[row]
    return len(mine) > 0 and bool(system.winches.shortest[row] == room)


def parted_at(winches: Winches, state: State, row: int) -> float:
    """Return when a winch's rope parted first [s]; inf where it is whole. Its length is then not known."""
    low, high = sorted((int(winches.first[row]), int(winches.last[row])))
    return float(state.memory.parting.time[low:high].min(initial=math.inf))


def length_out(winches: Winches, state: State, row: int) -> float:
    """Return the unstretched length of a winch's rope off all its drums [m], debts included."""
    low, high = sorted((int(winches.first[row]), int(winches.last[row])))
    same_rope = (low <= state.winch_exit) & (state.winch_exit <= high)
    return float(state.rest_length[low:high].sum() + state.winch_debt[same_rope].sum())


def _working(winches: Winches, state: State, row: int) -> int:
    """Return the segment next to the drum."""
    drum = int(state.winch_exit[row])
    return drum if winches.step[row] > 0 else drum - 1


def _finite(value: float) -> float:
    try:
        speed = float(value)
    except (TypeError, ValueError):
        speed = math.nan
    if not math.isfinite(speed):
        raise ValueError(f"speed: {value!r} - must be a finite number [m/s]")
    return speed
