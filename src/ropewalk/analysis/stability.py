"""Whether a scene's time step is stable, by what margin, and what decides it.

Linear theory for any shape of the ropes: see `methods.bound` for the derivation and its sources.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from ropewalk.analysis.json_values import plain
from ropewalk.analysis.linear_theory import (
    LargestSteps,
    RigidTheory,
    Theory,
    why_none,
)
from ropewalk.engine.unsolved import CALMER, RINGING
from ropewalk.lowering import Model, build
from ropewalk.lowering.chains import calms_with_speed, chains
from ropewalk.lowering.choice import bounds_stretch
from ropewalk.lowering.link_lengths import has_links
from ropewalk.lowering.steps import step_cases, uncovered
from ropewalk.methods.bound import (
    growth_per_step,
    largest_step,
)
from ropewalk.methods.registry import METHODS
from ropewalk.methods.stability_function import NEED_DAMPING, STABILITY
from ropewalk.scene import Scene
from ropewalk.statics import Statics
from ropewalk.words.percents import percent
from ropewalk.words.safe_side import longest_step, rounded_down

# Of the implicit methods, the one to recommend: true tensions, one solve, and from any start (ADR 0011).
STIFF = "bdf2"
# Weak growth that multiplies a motion by less than this over the whole run does not break it.
_HARMLESS = 10.0
_SLIGHT = 1.001  # [1] growth per step that says little on its own
_RESOLVED = 2.0  # [1] frequency times step up to which a mode is followed, if roughly
_SLACK = "where segments go slack"
_PRESSED = "pressed to "  # obstacles, ropes or the ground: what touches asks for the step


@dataclass(frozen=True)
class Stability:
    """What linear theory says about a run."""

    method: str
    step: float  # dt [s]
    steps: int  # of the whole run
    largest_step: Mapping[str, float]  # by method [s]; 0: every step grows, inf: no limit
    case: str  # where the bound comes from, e.g. "in the air"
    cases: dict[str, float]  # largest step of `method` by case [s]
    notes: tuple[str, ...]
    theory: Theory | RigidTheory = field(repr=False, compare=False)
    tolerance: float | None = (
        None  # [m], where the method chooses its steps and `step` is the frame
    )
    uncovered: str = ""  # why no bound holds for this method in this scene, where none does

    @property
    def highest_frequency(self) -> float:
        """Highest angular frequency of any case, undamped [rad/s]."""
        return self.theory.highest_frequency

    @property
    def growth_per_step(self) -> float:
        """Factor of the worst mode at `step` [1]."""
        return self.theory.growth_per_step

    @property
    def meter(self) -> float:
        """Worst a + 2 b at `step`; semi-implicit Euler is stable below 4 (Verlet: a + 4 b)."""
        return self.theory.meter

    @property
    def largest_spring_factor(self) -> float:
        """Largest factor on all springs, at `step` and `method` [1]."""
        return self.theory.largest.factor

    @property
    def largest_spring_constant(self) -> float | None:
        """Largest spring constant [N/m], where all springs are alike."""
        return self.theory.largest.spring_constant

    @property
    def largest_axial_stiffness(self) -> float | None:
        """Largest EA [N], where all ropes are of one material."""
        return self.theory.largest.axial_stiffness

    @property
    def largest_bending_stiffness(self) -> float | None:
        """Largest EI [N m^2], where all ropes have one EI, not 0."""
        return self.theory.largest_bending_stiffness

    @property
    def rope(self) -> str:
        """The rope where the fastest mode is largest."""
        return self.theory.place[0]

    @property
    def node(self) -> int:
        """The node of `rope` where the fastest mode is largest."""
        return self.theory.place[1]

    @property
    def notes_on_others(self) -> tuple[str, ...]:
        """What the bounds of the methods that were not chosen mean."""
        return self.theory.notes_on_others

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
    def where_pressed(self) -> str:
        """Where what is touched asks for the step, in words; "" where it does not."""
        parts = self.case.split(", ")
        on = [part.removeprefix(_PRESSED) for part in parts if part.startswith(_PRESSED)]
        beside = [part for part in parts if not part.startswith(_PRESSED)]
        return ", ".join([f"where it is {_PRESSED}{' and to '.join(on)}", *beside]) if on else ""

    @property
    def verdict(self) -> str:
        """One sentence."""
        cause = f" {self.where_pressed}" if self.where_pressed else ""
        bound = f"largest stable step of {self.method} {longest_step(self.bound)}{cause}"
        if self.tolerance is not None:
            tolerance = f"{1e3 * self.tolerance:.4g} mm"
            return f"stable at any step; {self.method} chooses steps to a tolerance of {tolerance}"
        at = f"{milliseconds(self.step)} a step"
        if self.stable and self.uncovered:
            return f"no bound holds for {self.method} here: {self.uncovered}"
        if self.stable:
            if math.isinf(self.margin):
                small = ", for small motions only" if self.rings else ""
                return f"stable at {at} ({self.method} has no limit{small})"
            return f"stable at {at} ({bound}, margin {percent(100 * self.margin, 3)})"
        if self.breaks and self.case.startswith(_SLACK):
            grows = f"x{self.growth_per_step:.4g} per step"
            if self.growth_per_step < _SLIGHT:
                grows = f"x{self.growth_over_run:.3g} over the run"
            return f"may break at {at} {self.case}: up to {grows} ({bound})"
        if self.breaks:
            return f"will break at {at}: x{self.growth_per_step:.4g} per step ({bound})"
        if self.growth_over_run <= 1.0:
            return f"not known to be stable at {at} ({bound})"
        return f"grows slowly at {at}: x{self.growth_over_run:.3g} over the run ({bound})"

    def as_dict(self) -> dict[str, object]:
        """Plain values for JSON; None stands for what is not finite."""
        names = (
            "method step steps largest_step highest_frequency stable breaks margin "
            "growth_per_step meter largest_spring_factor largest_spring_constant "
            "largest_axial_stiffness largest_bending_stiffness case cases rope node uncovered"
        )
        found = {name: getattr(self, name) for name in names.split()}
        found["largest_step"] = dict(self.largest_step)
        return {name: plain(value) for name, value in found.items()} | {
            "notes": [*self.notes, *self.notes_on_others]
        }

    def __repr__(self) -> str:
        return f"Stability: {self.verdict}."


def milliseconds(seconds: float) -> str:
    """Return a time step in words."""
    if math.isinf(seconds):
        return "unlimited"
    return "0" if seconds == 0.0 else f"{1e3 * seconds:.4g} ms"


def stability(source: Scene | Model, statics: Statics | None = None) -> Stability:
    """Return the stability of a scene or a built model at its own step and method.

    Quadratic drag is linearised at `lowering.chains.fastest`. `statics`, when it is already
    known, saves solving for the tension that makes sideways motion stiff.
    """
    model = source if isinstance(source, Model) else build(source)
    if has_links(model.state):
        return _rigid(model)
    plan, method = model.plan, model.plan.method
    until = model.scene.run.duration
    cases = step_cases(model.system, model.state, plan.duration, until)
    steps = LargestSteps(model, cases)
    own = steps.by_case(method)
    theory = Theory(model, cases, steps, statics)
    return Stability(
        method=method,
        step=plan.dt,
        steps=plan.steps,
        largest_step=steps,
        case=min(own, key=lambda name: own[name]),
        cases=own,
        notes=_notes(model, theory, steps),
        theory=theory,
        tolerance=plan.tolerance,
        uncovered=uncovered(model.system, model.state, method, plan.duration, until),
    )


def _rigid(model: Model) -> Stability:
    """Return what there is to say of rigid links: no frequency, so no bound for the methods that hold."""
    rigid = [rope.name for rope in model.scene.ropes if rope.rigid]
    bounds = {name: math.inf if method.holds_links else 0.0 for name, method in METHODS.items()}
    able = ", ".join(name for name, bound in bounds.items() if bound > 0.0)
    notes = [f"rope {rigid[0]!r} does not stretch: its links need one of the methods {able}"]
    if model.scene.limiter is not None:
        notes.append(f"the stretch limiter has nothing to do on {', '.join(map(repr, rigid))}")
    return Stability(
        method=model.plan.method,
        step=model.plan.dt,
        steps=model.plan.steps,
        largest_step=bounds,
        case="of rigid links",
        cases={"of rigid links": bounds[model.plan.method]},
        notes=tuple(notes),
        theory=RigidTheory((rigid[0], 0)),
    )


def _notes(model: Model, theory: Theory, largest: LargestSteps) -> tuple[str, ...]:
    """Say in words what a bound of 0 means, and what still air would do."""
    notes = []
    method, dt = model.plan.method, model.plan.dt
    if method in RINGING and dt * theory.highest_frequency > _RESOLVED:
        notes.append(
            f"{method} has no limit for small motions only: segments that go slack and taut may feed the "
            f"modes that this step does not resolve until the run breaks; then take {CALMER}, or a "
            "shorter step"
        )
    if method in NEED_DAMPING and largest[method] == 0.0:
        factor, power = STABILITY[method].undamped_gain
        rate = f"y^{power}/{1.0 / factor:g}"
        why = why_none(theory.all_chains)
        notes.append(
            f"{method} has no stable step: {why}; it grows by {rate} per step, "
            "y = frequency [rad/s] x step [s]"
        )
    if model.scene.limiter is not None:
        unfit = [name for name in METHODS if not bounds_stretch(model.scene, name)]
        beside = " on ropes that joints tie" if model.scene.joints else ""
        notes.append(f"{', '.join(unfit)} cannot work with a stretch limiter{beside}")
    if largest[method] >= dt and calms_with_speed(model.system, model.state):
        still = chains(model.system, model.state, 0.0)
        if min(largest_step(method, chain) for chain in still.values()) < dt:
            growth = max(
                growth_per_step(method, chain, dt, theory.share) for chain in still.values()
            )
            rate_per_second = math.log(growth) / dt
            notes.append(
                f"at rest, where quadratic drag vanishes, motion grows by {rate_per_second:.2g} /s "
                "until the drag holds it"
            )
    return tuple(notes)
