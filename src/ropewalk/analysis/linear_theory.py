"""The parts of a scene's linear theory, each found when it is first asked for.

With a million nodes some take seconds; who asks for a verdict needs few of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ropewalk.lowering import Model
from ropewalk.lowering.bounce import bounce_growth
from ropewalk.lowering.choice import bounds_stretch
from ropewalk.lowering.steps import Cases
from ropewalk.methods.bound import (
    Chain,
    growth_per_step,
    highest_frequency,
    largest_stiffness_factor,
    meter,
    worst_mode,
)
from ropewalk.methods.registry import METHODS
from ropewalk.methods.stability_function import NEED_DAMPING, STABILITY
from ropewalk.scene import Scene, Springs
from ropewalk.statics import Statics, static_shape

# A swinging rope carries up to about three times its weight at rest.
_SWING = 3.0
_SOFTEST = 60.0  # [1] logarithm of how much softer springs are looked at
_WEAK = 1e-100  # [N/m] or [N m]: far below all that is a spring


class LargestSteps(Mapping[str, float]):
    """Largest stable step by method [s], each found when it is first asked for."""

    def __init__(self, model: Model, cases: Cases) -> None:
        self._model, self._cases = model, cases
        self._found: dict[str, dict[str, float]] = {}

    def by_case(self, method: str) -> dict[str, float]:
        """Return the largest stable step of a method in every case [s]."""
        if method not in self._found:
            self._found[method] = self._cases.largest(method)
        return self._found[method]

    def __getitem__(self, method: str) -> float:
        if method not in METHODS:
            raise KeyError(method)
        if not bounds_stretch(self._model.scene, method):
            return 0.0
        return min(self.by_case(method).values())

    def __iter__(self) -> Iterator[str]:
        return iter(METHODS)

    def __len__(self) -> int:
        return len(METHODS)


class Largest(NamedTuple):
    """How stiff the springs could be at a step."""

    factor: float  # on all springs [1]
    spring_constant: float | None  # [N/m], where all are alike
    axial_stiffness: float | None  # [N], where all ropes are of one material


class Theory:
    """The parts of linear theory that take long with many nodes, each found when it is first asked for."""

    def __init__(
        self, model: Model, cases: Cases, steps: LargestSteps, statics: Statics | None
    ) -> None:
        self._model, self._cases, self._steps, self._statics = model, cases, steps, statics
        self._method, self._dt = model.plan.method, model.plan.dt
        own = steps.by_case(self._method)
        self._bound = min(own.values())
        self._linear = min(cases.chains, key=lambda name: own[name])
        self.all_chains = list(cases.chains.values())

    @cached_property
    def highest_frequency(self) -> float:
        return max(highest_frequency(chain) for chain in self.all_chains)

    @cached_property
    def share(self) -> float:
        return sideways_share(self._model, self._statics)

    @cached_property
    def growth_per_step(self) -> float:
        method, dt = self._method, self._dt
        worst = self._cases.chains[self._linear]
        if dt <= self._steps.by_case(method)[self._linear]:
            growth = growth_per_step(method, worst, dt, self.share)
        else:
            growth = max(
                growth_per_step(method, chain, dt, self.share) for chain in self.all_chains
            )
        if dt > self._bound:
            bounces = self._cases.bounces.values()
            growth = max([growth, *(bounce_growth(method, bounce, dt) for bounce in bounces)])
            if self._cases.decays(method):
                growth = max(growth, self._relaxing_growth)
        return growth

    @property
    def _relaxing_growth(self) -> float:
        """The factor per step by which the fastest mode of ropes that relax grows [1].

        That of x'' = -w^2 ((1 - s) x + q), q' = s x' - q / T, s the share of the stiffness that relaxes: the
        largest of |R(h l)| over the eigenvalues l, R the method's stability function.
        """
        w, found = self.highest_frequency, 1.0
        for rope in self._model.scene.ropes:
            solid = rope.made_of
            if isinstance(solid, Springs) or solid.relaxing_EA is None:
                continue
            s, time = (
                solid.relaxing_EA / (solid.EA + solid.relaxing_EA),
                solid.relaxation_time or 0.0,
            )
            rates = np.linalg.eigvals(
                [[0.0, w, 0.0], [-w * (1.0 - s), 0.0, -w], [0.0, s * w, -1.0 / time]]
            )
            found = max(found, float(np.abs(STABILITY[self._method](self._dt * rates)).max()))
        return found

    @cached_property
    def meter(self) -> float:
        friction = 4.0 if self._method == "verlet" else 2.0
        return max(meter(chain, self._dt, friction) for chain in self.all_chains)

    @cached_property
    def largest(self) -> Largest:
        factor, unit = stiffest(self._cases, self._method, self._dt)
        constant, material = _uniform(self._model.scene)
        return Largest(
            factor * unit,
            None if constant is None else factor * (unit * constant),
            None if material is None else factor * (unit * material),
        )

    @cached_property
    def largest_bending_stiffness(self) -> float | None:
        return _largest_bending(self._model.scene, self._cases.chains, self._method, self._dt)

    @cached_property
    def place(self) -> tuple[str, int]:
        own = self._steps.by_case(self._method)[self._linear]
        shape = worst_mode(self._cases.chains[self._linear], min(self._dt, own) or self._dt)
        return self._model.layout.rope_of(int(np.argmax(np.abs(shape))))

    @cached_property
    def notes_on_others(self) -> tuple[str, ...]:
        others = [name for name in NEED_DAMPING if name != self._method]
        return tuple(
            f"{name} has no stable step: {why_none(self.all_chains)}"
            for name in others
            if self._steps[name] == 0.0
        )


class RigidTheory(NamedTuple):
    """The same of rigid links: no frequency bounds anything."""

    place: tuple[str, int]
    highest_frequency: float = math.inf
    growth_per_step: float = 1.0
    meter: float = math.inf
    largest: Largest = Largest(math.inf, None, None)
    largest_bending_stiffness: float | None = None
    notes_on_others: tuple[str, ...] = ()


def sideways_share(model: Model, statics: Statics | None = None) -> float:
    """Return the share of a spring's stiffness that acts across it in this scene, 1 - L/r [1].

    The larger of its initial and three times its static share (a swing triples the tension),
    held to what a limiter allows; 1 where a spring has no rest length.
    """
    state, rest = model.state, model.state.rest_length
    alive = state.stiffness > 0.0
    if np.any(rest[alive] == 0.0) or not alive.any():
        return 1.0
    statics = statics or static_shape(model, strict=False)
    size = np.linalg.norm(np.diff(state.x, axis=1), axis=0)
    stretch = max(float((size[alive] / rest[alive]).max()), 1.0)
    resting = max(float(statics.stretch[alive].max()), 1.0)
    share = max(1.0 - 1.0 / stretch, min(_SWING * (1.0 - 1.0 / resting), 1.0))
    if model.system.limiter.active:
        share = min(share, max(1.0 - 1.0 / max(model.system.limiter.longest, 1.0), 0.0))
    return share


def _uniform(scene: Scene) -> tuple[float | None, float | None]:
    """Return the spring constant [N/m] or the EA [N] that all ropes share, if they do.

    Of an EA only where it is all of the stiffness: neither beside a `relaxing_EA` nor with a curve.
    """
    constants = {
        rope.made_of.spring_constant for rope in scene.ropes if isinstance(rope.made_of, Springs)
    }
    materials = {rope.made_of.EA for rope in scene.ropes if not isinstance(rope.made_of, Springs)}
    if any(rope.curved or rope.relaxes for rope in scene.ropes):
        return None, None
    if len(constants) + len(materials) != 1:
        return None, None
    return (constants.pop(), None) if constants else (None, materials.pop())


def _largest_bending(scene: Scene, cases: dict[str, Chain], method: str, dt: float) -> float | None:
    """Return the largest EI [N m^2] that all ropes, of one EI now, could have at `dt`; 0: none."""
    shared = {rope.bending_stiffness for rope in scene.ropes}
    if len(shared) != 1 or 0.0 in shared:
        return None
    swapped = [  # the factor is on what stands in the springs' place
        chain._replace(stiffness=np.asarray(chain.bending), bending=chain.stiffness)
        for chain in cases.values()
    ]
    factor, unit = largest_factor(method, swapped, dt)
    return factor * (unit * shared.pop())


def largest_factor(method: str, chains: list[Chain], dt: float) -> tuple[float, float]:
    """Return the largest factor on all springs stable at dt [1], as a number and its unit.

    The unit is 1 but for springs so weak or so stiff that the factor itself may be no number.
    """
    top = max(float(np.max(chain.stiffness, initial=0.0)) for chain in chains)
    unit = 1.0
    if math.isfinite(top) and top > 0.0 and not _WEAK < top < 1.0 / _WEAK:
        unit = 2.0 ** min(-math.frexp(top)[1], 1023)
    scaled = (chain._replace(stiffness=chain.stiffness * unit) for chain in chains)
    return min(largest_stiffness_factor(method, chain, dt) for chain in scaled), unit


def stiffest(cases: Cases, method: str, dt: float) -> tuple[float, float]:
    """Return the largest factor on all springs at which dt is stable in every case, see `largest_factor`."""
    own = cases.decays(method)
    if own and own <= dt:
        return 0.0, 1.0
    factor, unit = largest_factor(
        method, list(cases.chains.values()), 1.0 / (1.0 / dt - 1.0 / own) if own else dt
    )
    if cases.bounces_hold(method, dt, factor * unit):
        return factor, unit
    low, high = -_SOFTEST, math.log(min(factor * unit, math.exp(_SOFTEST)))
    for _ in range(60):
        middle = 0.5 * (low + high)
        if cases.bounces_hold(method, dt, math.exp(middle)):
            low = middle
        else:
            high = middle
    return math.exp(low), 1.0


def why_none(chains: list[Chain]) -> str:
    axial = any(np.any(chain.damping_axial) for chain in chains)
    if axial:
        return "axial friction does not damp sideways motion"
    return "nothing damps some of the motion"
