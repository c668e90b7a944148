"""Whether a scene's time step is stable, by what margin, and what decides it.

Linear theory for any shape of the ropes: see `methods.bound` for the derivation and its sources.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from ropewalk.analysis.json_values import plain
from ropewalk.build import Model, build
from ropewalk.build.bounce import bounce_growth
from ropewalk.build.chains import chains
from ropewalk.build.links import has_links
from ropewalk.build.plan import bounds_stretch
from ropewalk.build.steps import step_cases, uncovered
from ropewalk.methods.bound import (
    Chain,
    growth_per_step,
    highest_frequency,
    largest_step,
    largest_stiffness_factor,
    meter,
    worst_mode,
)
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene, Springs
from ropewalk.statics import Statics, static_shape
from ropewalk.unsolved import CALMER, RINGING

# Of the implicit methods, the one to recommend: true tensions, one solve, and from any start (ADR 0011).
STIFF = "bdf2"
# Weak growth that multiplies a motion by less than this over the whole run does not break it.
_HARMLESS = 10.0
_RESOLVED = 2.0  # [1] frequency times step up to which a mode is followed, if roughly
# A swinging rope carries up to about three times its weight at rest.
_SWING = 3.0
_WEAK = 1e-100  # [N/m] or [N m]: far below all that is a spring
_SLACK = "where segments go slack"


@dataclass(frozen=True)
class Stability:
    """What linear theory says about a run."""

    method: str
    step: float  # dt [s]
    steps: int  # of the whole run
    largest_step: dict[str, float]  # by method [s]; 0: every step grows, inf: no limit
    highest_frequency: float  # [rad/s]
    growth_per_step: float  # of the worst mode at `step` [1]
    meter: float  # worst a + 2 b at `step`; semi-implicit Euler is stable below 4 (Verlet: a + 4 b)
    largest_spring_factor: float  # on all springs, at `step` and `method` [1]
    largest_spring_constant: float | None  # [N/m], where all springs are alike
    largest_axial_stiffness: float | None  # [N], where all ropes are of one material
    largest_bending_stiffness: float | None  # [N m^2], where all ropes have one EI, not 0
    case: str  # where the bound comes from, e.g. "in the air"
    cases: dict[str, float]  # largest step of `method` by case [s]
    rope: str  # where the fastest mode is largest ...
    node: int  # ... its node in that rope
    notes: tuple[str, ...] = field(default=())
    tolerance: float | None = (
        None  # [m], where the method chooses its steps and `step` is the frame
    )
    uncovered: str = ""  # why no bound holds for this method in this scene, where none does

    @property
    def bound(self) -> float:
        """Largest stable step of the chosen method [s]."""
        return self.largest_step[self.method]

    @property
    def stable(self) -> bool:
        """Whether nothing grows at the chosen step."""
        return self.step <= self.bound

    @property
    def rings(self) -> bool:
        """Whether the method keeps modes that the step does not resolve: stable by linear theory only."""
        return self.method in RINGING and self.step * self.highest_frequency > _RESOLVED

    @property
    def margin(self) -> float:
        """Largest stable step over the chosen one, less 1; negative when unstable [1]."""
        return self.bound / self.step - 1.0

    @property
    def growth_over_run(self) -> float:
        """Factor by which the worst mode grows during the whole run [1]; inf beyond 1e300."""
        exponent = self.steps * math.log(self.growth_per_step) if self.growth_per_step > 0 else 0.0
        return math.exp(exponent) if exponent < 690.0 else math.inf

    @property
    def breaks(self) -> bool:
        """Whether the run is expected to break: unstable, and not just by a slow drift."""
        return not self.stable and self.growth_over_run > _HARMLESS

    @property
    def remedies(self) -> tuple[str, ...]:
        """What to change, and to what value, for a stable run; empty when it is stable."""
        if self.stable:
            return ()
        found = []
        if self.bound > 0.0:
            found.append(f"time_step <= {rounded_down(self.bound)} s")
        softer = self.largest_spring_factor < 1.0
        if softer and self.largest_spring_constant:
            found.append(f"spring_constant <= {rounded_down(self.largest_spring_constant)} N/m")
        elif softer and self.largest_axial_stiffness:
            found.append(f"EA <= {rounded_down(self.largest_axial_stiffness)} N")
        if self.largest_bending_stiffness:
            found.append(f"EI <= {rounded_down(self.largest_bending_stiffness)} N m^2")
        better = [
            name
            for name, step in self.largest_step.items()
            if step >= self.step and (name == STIFF or not METHODS[name].implicit)
        ]
        if better:
            found.append(f"method = {' or '.join(better)}")
        elif self.bound == 0.0:
            name = max(self.largest_step, key=lambda known: self.largest_step[known])
            step = rounded_down(self.largest_step[name])
            found.append(f"method = {name} with time_step <= {step} s")
        return tuple(found)

    @property
    def verdict(self) -> str:
        """One sentence."""
        bound = f"largest stable step of {self.method} {milliseconds(self.bound)}"
        if self.tolerance is not None:
            tolerance = f"{1e3 * self.tolerance:.4g} mm"
            return f"stable at any step; {self.method} chooses steps to a tolerance of {tolerance}"
        at = f"{milliseconds(self.step)} a step"
        if self.stable and self.uncovered:
            return f"no bound holds for {self.method} here: {self.uncovered}"
        if self.stable:
            margin = f"margin {100 * self.margin:.3g} %"
            if math.isinf(self.margin):
                margin = "no limit" + (", for small motions only" if self.rings else "")
            return f"stable at {at} ({bound}, {margin})"
        if self.breaks and self.case.startswith(_SLACK):
            return f"may break at {at} {self.case}: up to x{self.growth_per_step:.4g} per step ({bound})"
        if self.breaks:
            return f"will break at {at}: x{self.growth_per_step:.4g} per step ({bound})"
        return f"grows slowly at {at}: x{self.growth_over_run:.3g} over the run ({bound})"

    def as_dict(self) -> dict[str, object]:
        """Plain values for JSON; None stands for what is not finite."""
        names = (
            "method step steps largest_step highest_frequency stable breaks margin "
            "growth_per_step meter largest_spring_factor largest_spring_constant "
            "largest_axial_stiffness largest_bending_stiffness case cases rope node uncovered"
        )
        return {name: plain(getattr(self, name)) for name in names.split()} | {
            "notes": list(self.notes)
        }

    def __repr__(self) -> str:
        return f"Stability: {self.verdict}."


def rounded_down(value: float) -> str:
    """Return a positive number with three digits, never above it."""
    if not math.isfinite(value) or value <= 0.0:
        return f"{value:g}"
    unit = 10.0 ** (math.floor(math.log10(value)) - 2)
    return f"{float(f'{math.floor(value / unit * (1.0 + 1e-12)) * unit:.3g}'):.10g}"


def milliseconds(seconds: float) -> str:
    """Return a time step in words."""
    if math.isinf(seconds):
        return "unlimited"
    return "0" if seconds == 0.0 else f"{1e3 * seconds:.4g} ms"


def stability(source: Scene | Model, statics: Statics | None = None) -> Stability:
    """Return the stability of a scene or a built model at its own step and method.

    Quadratic drag is linearised at `build.chains.fastest`. `statics`, when it is already
    known, saves solving for the tension that makes sideways motion stiff.
    """
    model = source if isinstance(source, Model) else build(source)
    if has_links(model.state):
        return _rigid(model)
    plan, method, dt = model.plan, model.plan.method, model.plan.dt
    all_cases = step_cases(model.system, model.state, plan.duration)
    cases, steps = all_cases.chains, {known: all_cases.largest(known) for known in METHODS}
    own = steps[method]
    case = min(own, key=lambda name: own[name])
    linear = min(cases, key=lambda name: own[name])
    share = sideways_share(model, statics)
    growth = max(growth_per_step(method, chain, dt, share) for chain in cases.values())
    if dt <= own[linear]:
        growth = growth_per_step(method, cases[linear], dt, share)
    if dt > own[case]:
        bounces = all_cases.bounces.values()
        growth = max([growth, *(bounce_growth(method, bounce, dt) for bounce in bounces)])
    friction = 4.0 if method == "verlet" else 2.0
    factor, unit = largest_factor(method, list(cases.values()), dt)
    shape = worst_mode(cases[linear], min(dt, own[linear]) or dt)
    rope, node = model.layout.rope_of(int(np.argmax(np.abs(shape))))
    constant, material = _uniform(model.scene)
    largest = {known: min(found.values()) for known, found in steps.items()}
    if model.scene.limiter is not None:
        largest |= {name: 0.0 for name in METHODS if not bounds_stretch(name)}
    return Stability(
        method=method,
        step=dt,
        steps=plan.steps,
        largest_step=largest,
        highest_frequency=max(highest_frequency(chain) for chain in cases.values()),
        growth_per_step=growth,
        meter=max(meter(chain, dt, friction) for chain in cases.values()),
        largest_spring_factor=factor * unit,
        largest_spring_constant=None if constant is None else factor * (unit * constant),
        largest_axial_stiffness=None if material is None else factor * (unit * material),
        largest_bending_stiffness=_largest_bending(model.scene, cases, method, dt),
        case=case,
        cases=own,
        rope=rope,
        node=node,
        notes=_notes(model, cases, largest, share),
        tolerance=plan.tolerance,
        uncovered=uncovered(model.system, model.state, method),
    )


def _rigid(model: Model) -> Stability:
    """Return what there is to say of rigid links: no frequency, so no bound for the methods that hold."""
    rigid = [rope.name for rope in model.scene.ropes if rope.rigid]
    bounds = {name: math.inf if method.holds_links else 0.0 for name, method in METHODS.items()}
    able = ", ".join(name for name, bound in bounds.items() if bound > 0.0)
    note = f"rope {rigid[0]!r} does not stretch: its links need one of the methods {able}"
    return Stability(
        method=model.plan.method,
        step=model.plan.dt,
        steps=model.plan.steps,
        largest_step=bounds,
        highest_frequency=math.inf,
        growth_per_step=1.0,
        meter=math.inf,
        largest_spring_factor=math.inf,
        largest_spring_constant=None,
        largest_axial_stiffness=None,
        largest_bending_stiffness=None,
        case="of rigid links",
        cases={"of rigid links": bounds[model.plan.method]},
        rope=rigid[0],
        node=0,
        notes=(note,),
    )


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
    """Return the spring constant [N/m] or the EA [N] that all ropes share, if they do."""
    constants = {
        rope.made_of.spring_constant for rope in scene.ropes if isinstance(rope.made_of, Springs)
    }
    materials = {rope.made_of.EA for rope in scene.ropes if not isinstance(rope.made_of, Springs)}
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


def _notes(
    model: Model, cases: dict[str, Chain], largest: dict[str, float], share: float
) -> tuple[str, ...]:
    """Say in words what a bound of 0 means, and what still air would do."""
    notes = []
    method, dt = model.plan.method, model.plan.dt
    highest = max(highest_frequency(chain) for chain in cases.values())
    if method in RINGING and dt * highest > _RESOLVED:
        notes.append(
            f"{method} has no limit for small motions only: segments that go slack and taut may feed the "
            f"modes that this step does not resolve until the run breaks; then take {CALMER}, or a "
            "shorter step"
        )
    for name in ("euler", "heun"):
        if largest[name] > 0.0:
            continue
        axial = any(np.any(chain.damping_axial) for chain in cases.values())
        why = "nothing damps some of the motion"
        if axial:
            why = "axial friction does not damp sideways motion"
        words = f"{name} has no stable step: {why}"
        if name == method:
            rate = "y^2/2" if name == "euler" else "y^4/8"
            words += f"; it grows by {rate} per step, y = frequency [rad/s] x step [s]"
        notes.append(words)
    if model.scene.limiter is not None:
        unfit = [name for name in METHODS if not bounds_stretch(name)]
        notes.append(f"{', '.join(unfit)} cannot work with a stretch limiter")
    air = model.system.air
    if largest[method] >= dt and air.quadratic:
        still = chains(model.system, model.state, 0.0)
        if min(largest_step(method, chain) for chain in still.values()) < dt:
            growth = max(growth_per_step(method, chain, dt, share) for chain in still.values())
            rate_per_second = math.log(growth) / dt
            notes.append(
                f"at rest, where quadratic drag vanishes, motion grows by {rate_per_second:.2g} /s "
                "until the drag holds it"
            )
    return tuple(notes)
