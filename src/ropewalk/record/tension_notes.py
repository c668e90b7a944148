"""Sentences about a run's largest and least tension and its anchors' forces: peaks, pushes, means."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import SLACK
from ropewalk.record.end_weight import weight_note
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.scene import Rope
from ropewalk.scene.curve_words import end_words
from ropewalk.scene.straight_words import straight_words
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.lowering import Plan
    from ropewalk.record.result import Result

JERK = 0.5  # [1] a tension that was less than this part of its peak one frame before it
RESOLVED = 10.0  # [1] steps in which a wave goes through one segment: fewer blur a jerk
BLURRED = (
    10.0  # [1] of that time: of a jerk so long a step leaves but a part, 24 times less of a landing
)
#: [1] of a peak: with less beside it, in frames that are steps, or hold some, it lasts a step or two.
SHORT, SHORT_WITHIN = 0.8, 0.6
STEADY = 0.95  # [1] of a peak one frame before: it came slowly
FASTER = 2.0  # times that of a wave through a segment: steps that follow nothing of it
_ROUNDING = 1e-6  # [1] of the largest tension: a smaller push is none
_LESS = 0.002  # [1] of the largest tension: an anchor's force that is less by so much is told


#: What a peak is one of, in frames from one on to another [N].
Sizes = Callable[[int, int], Floats]


def tensions(result: Result, segment: int) -> Sizes:
    """Return the tensions of a segment."""
    return lambda first, last: result.read("tension", first, last)[:, segment]


def reactions(result: Result, anchor: int) -> Sizes:
    """Return the sizes of an anchor's force."""
    return lambda first, last: np.linalg.norm(
        result.read("reactions", first, last)[:, anchor], axis=1
    )


def tension_note(result: Result, peak: Extreme) -> str:
    """Say how good the largest tension can be where a jerk makes it in steps too long for it; else "".

    A jerk holds waves as short as a segment. A step that is not much shorter than the time sqrt(m / k) that
    these take through a segment (mass m, stiffness k) cannot follow them, stable or not: with the report's
    own r4 methods of one step differ by a fifth, and half the step changes the peak as much. Steps of
    `adaptive` follow what happens, and rigid links have no such wave: of these it says nothing.
    """
    plan = result.plan
    if result.status != FINISHED or plan.method not in METHODS or plan.tolerance is not None:
        return ""
    if not peak.value > 0.0 or not math.isfinite(peak.value):
        return ""
    rope = _rope_at(result, peak)
    through = wave_time(rope)
    frame = int(np.searchsorted(result.time, peak.until))
    if not 0 < frame < result.frames or not 0.0 < through < RESOLVED * plan.dt:
        return ""
    if peak.value < SLACK * rope.segment_stiffness * rope.segment_length:
        return ""
    before, _ = _beside(result, peak, frame, tensions(result, peak.place))
    if not before < JERK * peak.value:
        return ""
    share = percent(100.0 * max(before, 0.0) / peak.value)
    times = f"a wave takes {1e3 * through:.3g} ms through a segment, a step {1e3 * plan.dt:.3g} ms"
    if plan.dt > BLURRED * through:
        return (
            f"a jerk, from {share} of it one frame before: {times}, so that the peak may be far too low, "
            f"or too high; compare it with runs of shorter steps, down to time_step = {through:.3g} s"
        )
    return (
        f"a jerk, from {share} of it one frame before: {times}, so that the peak may be wrong by a fifth and "
        f"more; compare it with a run of time_step = {0.5 * plan.dt:.3g} s"
    )


def _beside(result: Result, peak: Extreme, frame: int, sizes: Sizes) -> tuple[float, float]:
    """Return what there is of a peak [N] in the frame before it and in the first one after it."""
    last = min(frame + (peak.until >= result.time[frame]), result.frames - 1)
    there = sizes(frame - 1, last + 1)
    return float(there[0]), float(there[-1])


def short_lived(plan: Plan, before: float, after: float) -> bool:
    """Tell whether a peak lasts a step or two, of the shares of it in the frames beside it [1]."""
    return before <= STEADY and min(before, after) < (
        SHORT if plan.steps_per_frame == 1 else SHORT_WITHIN
    )


def short_note(result: Result, peak: Extreme, sizes: Sizes | None = None) -> str:
    """Say that the largest tension lasts a step or two, and may be too low; else "".

    Of steps of one length that follow no wave through a segment. What came slowly is no such peak, however
    soon it ends: a rope that is let go. `sizes`: of another force, of a rope with the segment `peak.place`.
    """
    plan = result.plan
    if result.status != FINISHED or plan.method not in METHODS or plan.tolerance is not None:
        return ""
    frame = int(np.searchsorted(result.time, peak.until))
    if not peak.value > 0.0 or not 0 < frame < result.frames:
        return ""
    rope = _rope_at(result, peak)
    if rope.rigid or not plan.dt > FASTER * wave_time(rope):
        return ""
    if peak.value < SLACK * rope.segment_stiffness * rope.segment_length:
        return ""
    sizes = sizes or tensions(result, peak.place)
    shares = [there / peak.value for there in _beside(result, peak, frame, sizes)]
    if not short_lived(plan, *shares):
        return ""
    before, after = (percent(100.0 * max(share, 0.0)) for share in shares)
    return (
        f"a peak of a step or two of {1e3 * plan.dt:.3g} ms, from {before} of it one frame before to {after} "
        "in the one after: steps do not resolve it, and it may be too low by a tenth and more; compare it "
        f"with a run of time_step = {0.25 * plan.dt:.3g} s"
    )


def push_note(result: Result, least: Extreme, largest: float) -> str:
    """Say what pushes where the least tension is negative; `largest` is the largest [N]. Else ""."""
    if not least.value < -_ROUNDING * abs(largest):
        return ""
    rope = _rope_at(result, least)
    if rope.made_of.tension_only:
        return (
            "negative: the push of the friction along a taut rope that shortens fast; the rope itself, its "
            "elastic tension, never pushes"
        )
    if rope.bending_stiffness > 0.0:
        return "negative: a push along a rope that is stiff in bending"
    if rope.rigid:
        return "negative: rigid links push, too, which a rope does not"
    rubs = " and its friction" if rope.segment_friction > 0.0 else ""
    return (
        f"negative: a segment that is shortened pushes, its spring{rubs}, which a rope does not; "
        "tension_only = true lets it go slack"
    )


def anchor_note(result: Result, force: Extreme, tension: Extreme) -> str:
    """Say so where the segment at a rope's end bore more than the largest force of the anchor there; else "".

    What an anchor gives in a step is known from what the momentum lacks, so its force is the mean over the
    step, while the tension is that of the step's end. An anchor below its rope bears half a segment's weight
    less than the segment there; one that moves, or whose node is a joint, has a load or touches something,
    bears another force.
    """
    if result.status != FINISHED or not force.value > 0.0 or not tension.value > 0.0:
        return ""
    node = result.layout.anchor_nodes[force.place]
    ends = [(span.first, span.first) for span in result.layout.ropes]
    ends += [(span.last, span.last - 1) for span in result.layout.ropes]
    moved = result.scene.anchors[force.place].motion.kind != "fixed"
    borne = node in result.layout.tied_nodes or is_pressed(result, node, force.until)
    if (node, tension.place) not in ends or borne or moved:
        return ""
    rope, (_, number) = _rope_at(result, tension), result.layout.rope_of(node)
    given = [one.node for one in rope.loads] + [one.node for one in rope.forces]
    if number in [one % rope.nodes for one in given]:
        return ""
    weight = rope.own_mass / rope.segments * math.hypot(*result.scene.gravity)
    less = tension.value - force.value
    if not less > max(weight, _LESS * tension.value):
        return ""
    return (
        f"the mean over a step; at the end of one the segment it holds bore {tension.value:.6g} N, "
        f"{percent(100.0 * less / force.value)} more: shorter steps bring the two together"
    )


def anchor_bears(result: Result, peak: Extreme) -> str:
    """Return what the anchor beside the largest tension bears where that is more by the rope's weight."""
    pressed = any(is_pressed(result, node, peak.until) for node in (peak.place, peak.place + 1))
    return weight_note(result, peak, pressed)


def is_pressed(result: Result, node: int, time: float) -> bool:
    """Return whether anything touches a node in the frames about a time [s]."""
    if "contact_force" not in result.source.names:
        return result.layout.touches
    frame = int(np.searchsorted(result.time, time))
    return bool(result.read("contact_force", max(frame - 1, 0), frame + 1)[:, node].any())


def curve_note(result: Result, longest: Extreme) -> str:
    """Say so where the largest stretch lies beyond a rope's curve, or where its EA is right; else ""."""
    if not math.isfinite(longest.value) or longest.place < 0:
        return ""
    made_of = _rope_at(result, longest).made_of
    if made_of.kind == "springs":
        return ""
    if made_of.curve is None:
        return straight_words(made_of, longest.value - 1.0)
    if longest.value - 1.0 <= made_of.curve.end[0] * (1.0 + 1e-9):
        return ""
    return f"beyond its curve's last point, {end_words(made_of.curve)}, where it goes on straight"


def wave_time(rope: Rope) -> float:
    """Return the time that a wave along a rope takes through one segment [s]; 0 for rigid links."""
    if rope.rigid:
        return 0.0
    mass = rope.own_mass / (rope.nodes if rope.made_of.kind == "springs" else rope.segments)
    return math.sqrt(mass / rope.segment_stiffness)


def _rope_at(result: Result, extreme: Extreme) -> Rope:
    name, _ = result.layout.rope_of(extreme.place)
    return next(rope for rope in result.scene.ropes if rope.name == name)
