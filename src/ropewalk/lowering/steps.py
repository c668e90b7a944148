"""The largest stable step of a model: by linear theory for ropes about their length, and beyond.

Linear theory (`methods.bound`) has a case for every place a rope may be in, and covers all shapes in which no
segment is pressed below half its length. Beyond it, for explicit methods:

* segments that go slack and taut gain energy from the steps themselves (`lowering.bounce`);
* two-way springs that something can press below half their length, as it can where speeds come near to that
  of waves along the rope, are not what the theorem speaks of. Methods that neither lose nor gain energy
  cannot turn such springs over without making some up; `rk4` loses more;
* a stretch limiter acts after the step, moves nodes and has no bound at all.

`uncovered` says the last two in words. `method = "auto"` leaves out what they concern; where such a method is
asked for, an automatic step is `BEYOND` of what it would be.
"""

from __future__ import annotations

import math
from hashlib import blake2b
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import State, System
from ropewalk.laws.acting import acting
from ropewalk.laws.winch import MERGE
from ropewalk.lowering.apart import recoil_of_releases
from ropewalk.lowering.bounce import Bounce, bounce_of, largest_bounce_step
from ropewalk.lowering.chains import (
    FREE,
    driven_speed,
    fastest,
    free_chains,
    recoil,
    with_cases,
)
from ropewalk.lowering.elastic_tables import softest
from ropewalk.methods.bound import Chain, largest_step
from ropewalk.methods.registry import METHODS
from ropewalk.methods.stability_function import STABILITY
from ropewalk.motions.rows import fastest_turn

#: Methods that keep the energy of springs, and have no friction of their own.
KEEPING = ("semi-implicit-euler", "verlet")
#: Speed over that of waves along the rope [1] from which an impact may press segments below half.
_MACH = 0.5
_FREE = 1e3  # [1] springs this slow do not change the motion
BEYOND = 0.5

_known: dict[bytes, float] = {}  # largest steps [s]: runs of a sweep often have the same chains
_MOST_KNOWN = 4096


def _largest_step(method: str, chain: Chain) -> float:
    """Return `largest_step`, which depends on nothing but these, and is kept by what they are."""
    digest = blake2b(f"{method} {chain.sideways}".encode(), digest_size=20)
    for values in chain:
        array = np.asarray(values)
        digest.update(f"{array.shape} {array.dtype}".encode())
        digest.update(array.tobytes())
    key = digest.digest()
    if key not in _known:
        if len(_known) >= _MOST_KNOWN:
            _known.clear()
        _known[key] = largest_step(method, chain)
    return _known[key]


class Cases(NamedTuple):
    """Where a rope may be, each with its own largest step."""

    chains: dict[str, Chain]
    bounces: dict[str, Bounce]
    duration: float  # [s]
    relaxation: float  # least relaxation time of a rope [s], inf: none relaxes

    def largest(self, method: str) -> dict[str, float]:
        """Return the largest stable step of a method in every case [s].

        Where relaxation is among the unknowns of a method, as a rate next to the frequencies, both count.
        """
        found = {name: _largest_step(method, chain) for name, chain in self.chains.items()}
        if own := self.decays(method):
            found = {name: 1.0 / (1.0 / h + 1.0 / own) if h else h for name, h in found.items()}
        for name, bounce in self.bounces.items():
            found[name] = largest_bounce_step(method, bounce, self.duration)
        return found

    def decays(self, method: str) -> float:
        """Return the largest step of a method that relaxation alone allows [s].

        0: it is of no matter, as in all but the explicit Runge-Kutta methods, which take it as a rate.
        """
        if method in STABILITY and math.isfinite(self.relaxation):
            return STABILITY[method].longest_decay * self.relaxation
        return 0.0

    def bounces_hold(self, method: str, dt: float, factor: float) -> bool:
        """Tell whether segments that go slack gain little in steps of dt [s], springs so much stiffer [1]."""
        root = math.sqrt(factor)
        return factor == 0.0 or all(
            dt <= largest_bounce_step(method, Bounce(own * root, ratio / root), self.duration)
            for own, ratio in self.bounces.values()
        )


def step_cases(system: System, state: State, duration: float, until: float = math.inf) -> Cases:
    """Return the cases of a run of so many seconds; 0 s leaves out what adds up over a run.

    What moves by itself counts before the time `until` [s], here and below.
    """
    free = free_chains(system, state, fastest(system, state, until))
    one_way = system.slack_floor == 0.0
    bounces = {}
    if one_way.any() and duration > 0.0:
        for name, chain in free.items():  # what nodes touch does not change segments
            if (bounce := bounce_of(chain, one_way)) is not None:
                where = "" if name == FREE else f", {name}"
                bounces[f"where segments go slack and taut{where}"] = bounce
    relaxation = float(system.elastic.time.min(initial=math.inf))
    if math.isfinite(
        relaxation
    ):  # what comes off drums changes a segment as fast as it does its length
        winches = system.winches
        paid = np.maximum(winches.speed, 0.0) / (MERGE * winches.segment)
        relaxation = 1.0 / (1.0 / relaxation + float(paid.max(initial=0.0)))
    return Cases(with_cases(system, free), bounces, duration, relaxation)


def predicted_step(
    system: System, state: State, method: str, duration: float = 0.0, until: float = math.inf
) -> float:
    """Return the largest stable step of `method` in a run of `duration` [s], over all cases [s].

    Rigid links have no frequency: methods that hold them have no largest step, and no other is run.
    """
    if np.isinf(state.stiffness).any():
        return math.inf
    return min(step_cases(system, state, duration, until).largest(method).values())


def is_pressed(system: System, state: State, duration: float, until: float = math.inf) -> bool:
    """Tell whether a two-way spring may be pressed below half its length: one that is hit too fast.

    Two nodes that meet at the speed u press the segment between them by u / omega, omega its own frequency.
    Where nothing takes energy, what shakes or goes round adds up to twice its speed in every half cycle of
    `duration` [s]: that is what a mass on a spring gains whose own frequency is met.
    """
    two_way = (system.slack_floor != 0.0) & (state.stiffness > 0.0) & np.isfinite(state.stiffness)
    inverse = state.inverse_mass[:-1] + state.inverse_mass[1:]
    two_way &= (inverse > 0.0) & (state.rest_length > 0.0)
    if not two_way.any():
        return False
    soft = softest(system.elastic, state.stiffness)
    waves = state.rest_length[two_way] * np.sqrt(soft[two_way] * inverse[two_way])
    ratio = max(_impact(system, state, until), _pumped(system, state, duration, until)) / waves
    return bool(((ratio > _MACH) & (ratio < _FREE)).any())


def _impact(system: System, state: State, until: float) -> float:
    """Return the largest speed at which nodes may meet [m/s]: nothing brakes what flies as one."""
    alive = state.mass > 0.0
    v = state.v[:, alive]
    apart = 2.0 * float(np.linalg.norm(v - v.mean(axis=1, keepdims=True), axis=0).max())
    stops = len(state.held) > 0 or acting(system)
    back = max(recoil(state), recoil_of_releases(system, state))
    return max(apart, back, fastest(system, state, until) if stops else 0.0)


def _pumped(system: System, state: State, duration: float, until: float) -> float:
    """Return the largest speed that shaking can give within a run to a rope without any friction [m/s]."""
    rubs = state.damping_vector.any() or state.damping_axial.any() or acting(system)
    if rubs or math.isfinite(float(system.elastic.time.min(initial=math.inf))):
        return 0.0
    half_cycles = fastest_turn(system.anchors) * duration / math.pi
    return driven_speed(system, until) * 2.0 * half_cycles if half_cycles > 0.0 else 0.0


def uncovered(
    system: System, state: State, method: str, duration: float = 0.0, until: float = math.inf
) -> str:
    """Return why no bound holds for a method in a run of `duration` [s], or "" where one does.

    0 s leaves out what adds up over a run.
    """
    if METHODS[method].implicit:
        return ""
    if system.limiter.active:
        return (
            "a stretch limiter acts after the steps of explicit methods, moves nodes and may give energy; "
            "implicit methods solve for it"
        )
    if method in KEEPING and is_pressed(system, state, duration, until):
        return (
            "something moves so fast, or shakes a rope without friction for so long, that it may press "
            "springs below half their length, where the bound does not reach; rk4 loses energy there rather "
            "than making it up"
        )
    return ""
