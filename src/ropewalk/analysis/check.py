"""What can be said of a scene before it is run: stability, statics, waves, cost, likely slips."""

from __future__ import annotations

import html
import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ropewalk.analysis.apart import Torn, jerks, torn_apart
from ropewalk.analysis.bending_notes import bending_warnings
from ropewalk.analysis.cost import run_time, seconds_per_step, touches
from ropewalk.analysis.facet_notes import facet_warnings
from ropewalk.analysis.gathered import gathered
from ropewalk.analysis.json_values import plain
from ropewalk.analysis.knot_notes import knot_warnings
from ropewalk.analysis.near_starts import near_start_warnings
from ropewalk.analysis.obstacle_notes import obstacle_warnings
from ropewalk.analysis.pair_starts import pair_start_warnings
from ropewalk.analysis.plan_notes import plan_notes
from ropewalk.analysis.rebound_notes import rebound_warnings
from ropewalk.analysis.release_notes import release_warnings
from ropewalk.analysis.rest_notes import (
    limiter_warnings,
    may_say_nothing,
    rest_warnings,
    unheld_warnings,
)
from ropewalk.analysis.room_notes import room_warnings
from ropewalk.analysis.rope_check import RopeCheck, rope_check
from ropewalk.analysis.slide_notes import slide_warnings
from ropewalk.analysis.stability import Stability, milliseconds, stability
from ropewalk.analysis.strains import (
    breaking_warnings,
    overlong_at_start,
    parting_warnings,
    pressed_at_start,
    strain_warnings,
)
from ropewalk.analysis.swing_notes import swing_warnings
from ropewalk.analysis.unit_slips import unit_slips
from ropewalk.display import cells
from ropewalk.engine.start import started_with_rest
from ropewalk.lowering import Model, build
from ropewalk.record.rest import as_result
from ropewalk.scene import Scene
from ropewalk.statics import Statics, static_shape
from ropewalk.words.annotations import unquoted
from ropewalk.words.counts import counted
from ropewalk.words.safe_side import longest_step, rounded_down

__all__ = ["Check", "RopeCheck", "check", "milliseconds"]

_SMALL_MARGIN = 0.1
_ROUNDING = 1e-9
_AFFORDABLE = 20_000  # nodes up to which the highest frequency at rest is computed


@unquoted
@dataclass(frozen=True)
class Check:
    """Everything that `ropewalk check` says."""

    name: str
    stability: Stability
    statics: Statics
    ropes: tuple[RopeCheck, ...]
    frames: int
    steps_per_frame: int
    steps: int
    duration: float  # simulated [s]
    seconds: float  # estimated run time [s], without recording
    seconds_measured: bool  # whether steps were timed, or the cost taken from a table
    seconds_known: bool  # whether the table knows: not of ropes in contact
    run_time: str  # the estimate in words
    warnings: tuple[str, ...]
    highest_at_rest: float | None = None  # frequency about the shape of rest [rad/s]
    tolerance: float | None = None  # [m] of steps of varying length
    model: Model | None = field(default=None, repr=False, compare=False)  # what was checked
    why: str = ""  # why the method was chosen, where it was not given
    in_full: tuple[str, ...] = ()  # the warnings with the names of all ropes that they are of
    torn: tuple[Torn, ...] = ()  # ropes that their anchors pull apart, with any method
    overlong: bool = False  # whether a segment counts as broken where it starts

    @property
    def ok(self) -> bool:
        """Whether the run is not expected to break."""
        return not (self.stability.breaks or self.torn or self.overlong)

    @property
    def _rests(self) -> bool:
        """Whether what is said of rest is of a shape that is at rest, or one near to it."""
        return all(rope.rests for rope in self.ropes)

    @property
    def pace(self) -> str:
        """Frames and steps in words."""
        frames = counted(self.frames, "frame")
        if self.tolerance is not None:
            return f"{frames}, steps to a tolerance of {1e3 * self.tolerance:.4g} mm"
        each, steps = (counted(n, "step") for n in (self.steps_per_frame, self.steps))
        return f"{frames} of {each}, {steps} of {milliseconds(self.stability.step)}"

    def as_dict(self) -> dict[str, object]:
        """Plain values for JSON; None stands for what is not finite."""
        statics, rests = self.statics, self._rests
        found = {
            "name": self.name,
            "ok": self.ok,
            "stability": self.stability.as_dict(),
            "statics": {
                "largest_tension": statics.largest_tension if rests else None,
                "slack_segments": int(statics.slack.sum()) if rests else None,
                "spans": [span.as_dict() for span in statics.spans] if rests else [],
                "wraps": [wrap.as_dict() for wrap in statics.wraps] if rests else [],
                "touches": [touch.as_dict() for touch in statics.touches] if rests else [],
                "pulleys": [body.as_dict() for body in statics.pulleys] if rests else [],
                "unheld": statics.unheld,
                "nodes_on_ground": int(statics.grounded.sum()) if rests else None,
                "residual": statics.residual if rests else None,
            },
            "ropes": [rope.as_dict() for rope in self.ropes],
            "frames": self.frames,
            "steps_per_frame": self.steps_per_frame,
            "steps": self.steps,
            "duration": self.duration,
            "estimated_seconds": self.seconds if self.seconds_known else None,
            "estimate_measured": self.seconds_measured,
            "warnings": self.in_full,
            "highest_frequency_at_rest": self.highest_at_rest,
            "tolerance": self.tolerance,
            "why": self.why or None,
        }
        return {key: plain(value) for key, value in found.items()}

    def lines(self, *, all_methods: bool = False) -> list[str]:
        """Text, one fact a line: the ropes at rest, how long the run takes, then the step.

        With `all_methods` also what the step may be in other methods, what decides it, and the waves.
        """
        text = [self.name]
        for rope in self.ropes:
            text += rope.lines()
            spans = [span for span in self.statics.spans if span.rope == rope.name and rope.rests]
            text += [f"  at rest: {span.words}" for span in spans if not span.single]
            if single := sum(span.single for span in spans):
                each = "" if single == 1 else " each"
                text.append(
                    f"  at rest: {counted(single, 'span')} of one segment{each}, whose sag is not computed"
                )
            wraps = [wrap for wrap in self.statics.wraps if wrap.rope == rope.name and rope.rests]
            text += [f"  at rest: {wrap.words}" for wrap in wraps]
        text += [f"at rest: {touch}" for touch in self.statics.touches if self._rests]
        if self.statics.grounded.any() and self._rests:
            text.append(f"at rest {_count(self.statics.grounded, 'node')} on the ground")
        text.append(f"the run: {self.duration:.6g} s {self.run_time}; {self.pace}")
        text.append(f"the step: {self.stability.verdict}")
        text += [self.why] if self.why else []
        if all_methods:
            text += self._of_the_step() + [rope.waves() for rope in self.ropes]
        notes = [*self.stability.notes, *(self.stability.notes_on_others if all_methods else ())]
        text += [f"note: {note}" for note in notes]
        text += [f"warning: {warning}" for warning in self.warnings]
        return text

    def _of_the_step(self) -> list[str]:
        """The bound of every method, and what decides it."""
        s = self.stability
        text = ["largest stable steps:"]
        text += [f"  {name:<20} {longest_step(step)}" for name, step in s.largest_step.items()]
        if math.isinf(s.highest_frequency):
            text.append("highest frequency: none bounds it, rigid links do not stretch")
        else:
            text.append(f"highest frequency {s.highest_frequency:.6g} rad/s, decided {s.case}")
        if self.highest_at_rest is not None:
            bound = "" if math.isinf(s.highest_frequency) else "bound for any shape; "
            text[-1] += f" ({bound}{self.highest_at_rest:.6g} rad/s about the rest shape)"
        if s.method == "semi-implicit-euler":
            text.append(f"stability meter a + 2b = {s.meter:.4g} of 4")
        if s.largest_spring_constant is not None:
            text.append(
                f"largest spring constant {rounded_down(s.largest_spring_constant, 6)} N/m at this step"
            )
        elif s.largest_axial_stiffness is not None:
            text.append(f"largest EA {rounded_down(s.largest_axial_stiffness, 6)} N at this step")
        elif not math.isinf(s.highest_frequency):
            text.append(
                f"all springs could be {rounded_down(s.largest_spring_factor, 4)} times as stiff"
            )
        if s.largest_bending_stiffness is not None:
            text.append(
                f"largest EI {rounded_down(s.largest_bending_stiffness, 6)} N m^2 at this step"
            )
        return text

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def _repr_html_(self) -> str:
        shown = ""
        if self.model is not None and self.statics.solved and not self.statics.unheld:
            rest = as_result(self.model, self.statics, 0.0)
            shown = cells.picture(cells.png(rest.plot.forces), "the ropes at rest")
        said = f"<pre>{html.escape(str(self))}</pre>"
        return cells.paragraph(repr(self)) + shown + said

    def __repr__(self) -> str:
        told = counted(len(self.warnings), "warning")
        return f"Check of {self.name!r}: {self.stability.verdict}; {told}."


def check(source: Scene | Model, *, measure: bool = True) -> Check:
    """Check a scene or a built model.

    Args:
        source: the scene.
        measure: time a few steps for the estimate of the run time; else take it from a table.

    Raises SceneError when the scene cannot be planned.
    """
    model, rest = started_with_rest(source if isinstance(source, Model) else build(source))
    statics = rest or static_shape(model, strict=False)
    found = stability(model, statics)
    ropes = tuple(rope_check(model, statics, name.name) for name in model.layout.ropes)
    torn, overlong = tuple(torn_apart(model)), overlong_at_start(model)
    said, names = _warnings(model, found, statics, ropes), [rope.name for rope in ropes]
    grave = (*parting_warnings(model.scene, ropes), *breaking_warnings(ropes))
    first = (*map(str, torn), *overlong, *jerks(model))
    cost, measured = seconds_per_step(model, measure)
    plan = model.plan
    return Check(
        name=model.scene.name,
        stability=found,
        statics=statics,
        ropes=ropes,
        frames=plan.frames,
        steps_per_frame=plan.steps_per_frame,
        steps=plan.steps,
        duration=plan.duration,
        seconds=cost * plan.steps,
        seconds_measured=measured,
        seconds_known=measured or not touches(model),
        run_time=run_time(model, cost * plan.steps, measured),
        warnings=(*first, *gathered(said, names, named=grave)),
        in_full=(*first, *gathered(said, names)),
        highest_at_rest=_highest_at_rest(model, statics) if measure else None,
        tolerance=plan.tolerance,
        why=plan.why,
        model=model,
        torn=torn,
        overlong=bool(overlong),
    )


def _highest_at_rest(model: Model, statics: Statics) -> float | None:
    """Return the highest frequency about the rest shape [rad/s]; None where it is not cheap to know."""
    if not statics.spans or not statics.solved or model.layout.nodes > _AFFORDABLE:
        return None
    from ropewalk.vibration import highest_frequency

    found = highest_frequency(model, statics.positions.T.copy(), statics.elastic_tension)
    return None if found == math.inf else found  # of rigid links


def _warnings(
    model: Model, found: Stability, statics: Statics, ropes: tuple[RopeCheck, ...]
) -> list[str]:
    warnings = _stability_warnings(found)
    for rope in ropes:
        if rope.short:
            warnings.append(
                f"rope {rope.name!r}: {rope.short} of {rope.segments} segments "
                f"{'starts shorter than its' if rope.short == 1 else 'start shorter than their'} rest length"
            )
        if rope.slack and (statics.solved or not may_say_nothing(model)):
            warnings.append(
                f"rope {rope.name!r}: {rope.slack} of {rope.segments} segments "
                f"{'carries' if rope.slack == 1 else 'carry'} no tension at rest"
            )
    warnings += unheld_warnings(model, statics)
    warnings += parting_warnings(model.scene, ropes)
    warnings += strain_warnings(model, statics, ropes) + breaking_warnings(ropes)
    warnings += pressed_at_start(model, statics, ropes)
    warnings += limiter_warnings(model, statics) + rest_warnings(model, statics)
    warnings += bending_warnings(model) + obstacle_warnings(model, statics)
    warnings += facet_warnings(model, statics) + near_start_warnings(model)
    warnings += pair_start_warnings(model) + rebound_warnings(model, statics)
    warnings += slide_warnings(model) + knot_warnings(model)
    warnings += swing_warnings(model) + release_warnings(model) + room_warnings(model)
    return warnings + plan_notes(model) + unit_slips(model)


def _stability_warnings(found: Stability) -> list[str]:
    remedies = "; ".join(found.remedies)
    told = found.where_pressed or found.case in found.verdict
    where = f"rope {found.rope!r}, node {found.node}{'' if told else f', {found.case}'}"
    if found.breaks:
        return [f"the run {found.verdict}, first at {where}. Change to: {remedies}"]
    if not found.stable:
        return [f"the run {found.verdict}. Change to: {remedies}"]
    if found.uncovered:
        return [
            f"no bound holds for {found.method} here: {found.uncovered}. Take method = auto, or look at the "
            "energy error"
        ]
    if found.margin < _SMALL_MARGIN:
        lower = rounded_down(found.bound / (1.0 + _SMALL_MARGIN))
        return [
            f"the largest stable step is only {100 * found.margin:.2g} % longer; "
            f"time_step <= {lower} s leaves 10 %"
        ]
    return []


def _count(which: NDArray[np.bool_], noun: str) -> str:
    number = int(which.sum())
    return f"{counted(number, noun)} {'lies' if number == 1 else 'lie'}"
