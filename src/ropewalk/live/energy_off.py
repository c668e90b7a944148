"""How far the energy of a session is off, of what has changed most: its step is too long for the motion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.live.carried_pieces import Carried, Standing, touched_anything
from ropewalk.methods.recording import bends

if TYPE_CHECKING:
    from ropewalk.live.track import Track
    from ropewalk.lowering import Plan
    from ropewalk.methods.recording import Recording

_ROUNDING = 1e-4  # [1] of the largest energy there is: below that nothing is off
_LEAST = 1e-9  # [1] of the energy turned over as seen at rest: less is rounding


class Now(NamedTuple):
    """Energies at one time [J]."""

    kinetic: float
    gravity: float  # from that of the begin
    elastic: float
    taken: float = 0.0  # by friction of surfaces
    carried: Carried = Carried()  # what of kinetic energy and gravity pieces have as wholes

    @property
    def forms(self) -> tuple[float, ...]:
        """Kinetic energy, gravity and elastic energy, then the first two as who goes along sees them."""
        own = (self.kinetic - self.carried.kinetic, self.gravity - self.carried.gravity)
        return (self.kinetic, self.gravity, self.elastic, *own)


class Balance(NamedTuple):
    """What a session has turned over since its step was chosen, and how far it was off since then.

    Counted from the begin, a fall long ago would hide what a step errs in small motions.

    As the table of a run counts it, see `record.turnover`: of the energies as seen at rest and by who goes
    along with pieces the smaller account counts, and what friction of surfaces had taken when the error came.
    Other works do not count: a false ledger of them is large itself.
    """

    low: tuple[float, ...]  # of the forms [J], all but the elastic one from 0
    high: tuple[float, ...]
    error: float = 0.0  # the largest since the step was chosen, without that of what falls [J]
    last: float = 0.0  # ... now
    base: float = 0.0  # ... and as it was then
    taken: float = 0.0  # the most that friction has taken [J]
    when: float = 0.0  # ... when the error was largest
    fallen: float = 0.0  # the largest error of what falls freely since the step was chosen [J]
    began: float = 0.0  # ... and what was counted of it then
    carried: Carried = Carried()
    now: tuple[float, ...] = ()  # forms as last seen [J]
    took: float = 0.0  # what friction had taken when the step was chosen [J]

    @classmethod
    def begun(cls, elastic: float) -> Balance:
        """Return that of a begin with so much elastic energy [J]."""
        begin = Now(0.0, 0.0, elastic).forms
        return cls(begin, begin, now=begin)

    def again(self) -> Balance:
        """Count from now on: another step has been chosen. What moves now is turned over."""
        kinetic, gravity, elastic, own_kinetic, own_gravity = self.now
        return self._replace(
            low=(0.0, gravity, elastic, min(0.0, own_kinetic), own_gravity),
            high=(kinetic, gravity, elastic, max(0.0, own_kinetic), own_gravity),
            error=0.0,
            base=self.last,
            when=self.taken,
            took=self.taken,
            fallen=0.0,
            began=self.carried.fallen,
        )

    def later(self, now: Now, error: float) -> Balance:
        """Return it with energies and error of a later time [J]; those that are not finite tell nothing."""
        forms = zip(now.forms, self.low, strict=True)
        known = [value if math.isfinite(value) else low for value, low in forms]
        whole = math.isfinite(error) and math.isfinite(now.carried.fallen)
        carried = now.carried if whole else self.carried
        last = error - carried.fallen if whole else self.last
        off, taken = abs(last - self.base), self.taken
        if math.isfinite(now.taken):
            taken = max(taken, now.taken)
        return Balance(
            tuple(map(min, self.low, known)),
            tuple(map(max, self.high, known)),
            max(self.error, off),
            last,
            self.base,
            taken,
            taken if off > self.error else self.when,
            max(self.fallen, abs(carried.fallen - self.began)),
            self.began,
            carried,
            tuple(known),
            self.took,
        )

    @property
    def scalars(self) -> dict[str, float]:
        """The largest error, 0 where it is rounding, and what it is to be divided by [J]."""
        kinetic, gravity, elastic, *own = (
            high - low for low, high in zip(self.low, self.high, strict=True)
        )
        rest = max(kinetic, gravity, elastic)
        turned = max(self.when - self.took, min(rest, max(elastic, *own)), _LEAST * rest)
        error = self.error
        if self.fallen * turned > error * rest:  # what falls has an account of its own
            error, turned = self.fallen, rest
        told = error > _ROUNDING * max(map(abs, (*self.low, *self.high, self.taken)))
        return {"energy_off": error if told else 0.0, "energy_turned": turned}


def weigh(track: Track, now: Recording) -> None:
    """Take note of a track's energies, from what is recorded of the present frame."""
    simulation, layout = track.simulation, track.simulation.layout
    if not simulation.ledger:
        return
    energy, state, held = now.energy[0], simulation.arrays, np.zeros(layout.nodes)
    held[state.anchor_node[state.held == 1]] = 1.0
    touched = touched_anything(now.work[0], bends(state), layout.more)
    standing = Standing(
        track.scene, layout, state.rest_length, held, state.mass, track.edited, touched
    )
    forms = Now(
        float(energy[0]),
        float(energy[1]) - track.first_gravity,
        float(energy[2:].sum()),
        track.rubbed.taken(simulation, now.books[0]),
        track.balance.carried.later(standing, state.x.T, state.v.T),
    )
    track.balance = track.balance.later(forms, track.books(now)[2])


def step_of(plan: Plan) -> tuple[str, float, float | None]:
    """Return what an energy error hangs on that is chosen: method, step [s] and tolerance [m]."""
    return plan.method, plan.dt, plan.tolerance
