"""What the energy that implicit steps lost until the largest tension may be of it.

A peak is where motion has become stretch: of a weight that a slack rope catches, T^2 / 2k is what it had.
Steps that lose a part of that on the way, as implicit Euler's do, make a peak that is too low, with nothing
else to be seen.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering.masses import line, masses
from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import SLACK, energy_of_rounding
from ropewalk.record.body_energies import turning_of
from ropewalk.record.extremes import Extreme
from ropewalk.record.facts import FINISHED
from ropewalk.record.joined_ropes import joined_ropes
from ropewalk.record.tension_notes import FASTER, Sizes, tensions, wave_time
from ropewalk.record.turnover import goes_evenly, own_errors, own_kinetic
from ropewalk.theory.curve import at_strain, at_tension
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.lowering import Plan
    from ropewalk.record.result import Result
    from ropewalk.scene import Rope

#: Times that of a wave through a segment: of 275 random runs of so long steps 47 lacked more than was told.
_BLURS = 30.0
_TOLD = 2.0  # [%] of the energy then: 1 % of the force, but up to 12.5 % of motions in step
#: A blow: frames in which a peak has come from less than a half of it. Steps that lose so much of the energy
#: [%] in one blur it: of 30 random runs of which that was all there was to see, 18 lacked a tenth and more.
_BLOW, _BEGUN, _IN_BLOW = 3, 0.5, 0.35
#: What was lost in a quarter of a swing of all on its rope, of the stretch then and of all the energy [1].
#: Of 111 forces of random runs a tenth too low, unsaid, 48 lost more, and 17 of 1838 right ones.
_UNSTRETCHED, _OF_ALL = 0.05, 4e-4
_MORE = 2.0  # times what was lost of the whole energy: less is told of that


#: Of 294 such forces 273 lacked no more than is told, most far less: no least is told.
_STRETCH = "stretch"


class _Energies(NamedTuple):
    """What was lost until a peak, and what its ropes had about it [J]."""

    lost: float
    there: float
    what: str = "motion and stretch"
    when: str = "until then"


def peak_energy_note(
    result: Result, peak: Extreme, sizes: Sizes | None = None, *, pressed: bool = False
) -> str:
    """Say by how much the largest tension may be too low for the energy that was lost until then; else "".

    What was lost since the run began, L, of all ropes, beside the energy of motion and stretch about it, E,
    of those that hang together with its own, see `_energy_of`. Forces go by the root of the energy. Where L
    would have come into the peak, it would be larger by sqrt(1 + L / E) if the two have nothing to do with
    each other, and by 1 + sqrt(L / E) if they swing in step. It is no bound: what was lost elsewhere has
    nothing to do with the peak, and what segments or steps blur besides is not in it. Of a swing that cannot
    become stretch by the peak much more may be lacking than that: `_unstretched`. Energies of explicit
    methods swing with the step, and say nothing of a peak. `sizes`: of another force than a tension, of a
    rope with the segment `peak.place`; `pressed`: of all that presses a body, which is no stretch.
    """
    plan = result.plan
    if result.status != FINISHED or not result.facts.ledger or result.facts.provenance.get("live"):
        return ""
    if plan.method not in METHODS or not METHODS[plan.method].implicit or not peak.value > 0.0:
        return ""
    frame = min(int(np.searchsorted(result.time, peak.until)), result.frames - 1)
    errors = own_errors(result)[: frame + 1]
    errors = errors[np.isfinite(errors).all(axis=1)]
    lost = float(errors.max() - errors[-1].min()) if errors.size else 0.0
    about = slice(max(frame - 1, 0), frame + 1)
    rope = result.scene.rope_named(result.layout.rope_of(peak.place)[0])
    joined = joined_ropes(result.scene, result.layout, {rope.name})
    moving, taut, alone = _energy_of(result, joined, about)
    there = float((moving + taut).max())
    slack = SLACK * rope.segment_stiffness * rope.segment_length
    if not lost > energy_of_rounding(result.scene) or (peak.value < slack and not rope.rigid):
        return ""
    if not there > 0.0 or (sizes and peak.value**2 > 2.0 * rope.segment_stiffness * there):
        return ""  # what is pressed as it is drawn moves and stretches next to nothing
    energies, doubt = _Energies(lost, there), _blurred(plan, rope)
    recent = (
        None if pressed else _unstretched(result, rope, joined, errors, energies, float(taut.max()))
    )
    if recent:
        energies = recent
    elif not 100.0 * lost > _TOLD * (there + lost):
        blow = _lost_in_blow(errors, frame, peak.value, sizes or tensions(result, peak.place))
        follows = plan.tolerance is not None or not plan.dt > FASTER * wave_time(rope)
        if follows or not 100.0 * blow > _IN_BLOW * (there + lost):
            return ""
        doubt = (
            f", and it may be too low by far more: {blow:.3g} J of it were lost in the blow itself, "
            f"which steps of {1e3 * plan.dt:.3g} ms blur"
        )
    return _words(result, energies, joined, alone=alone, doubt=doubt)


def _words(result: Result, of: _Energies, joined: set[str], *, alone: bool, doubt: str) -> str:
    """Return what is told of these energies; `alone`: they are of the ropes joined, and of no others."""
    lost, there, compare = of.lost, of.there, f"a run of {_finer(result)}"
    head = f"{result.plan.method} lost {lost:.3g} J {of.when}"
    if len(joined) < len(result.scene.ropes):
        own = "this rope" if len(joined) == 1 else "this rope and those joined to it"
        all_ropes = "all ropes, as their shares are not recorded,"
        return (
            f"{head}, in all ropes together; {own if alone else all_ropes} had {there:.3g} J of {of.what} "
            f"about then. If {own} lost energy, the peak may be too low; what other ropes lost has "
            f"nothing to do with it. Compare the peak with {compare}"
        )
    apart = 1.0 - 1.0 / math.sqrt(1.0 + lost / there)
    in_step = 1.0 - 1.0 / (1.0 + math.sqrt(lost / there))
    bodies = " and bodies" if turning_of(result) else ""
    if of.what == _STRETCH:
        return (
            f"{head}, beside {there:.3g} J of stretch of all ropes: if that would have been stretch, too, it "
            f"may be too low by up to some {percent(100.0 * in_step)}, a guess and no bound{doubt}; compare "
            f"it with {compare}"
        )
    return (
        f"{head}, beside {there:.3g} J of {of.what} of all ropes{bodies}: if that belongs in it, it "
        f"is too low by some {percent(100.0 * apart)} to {percent(100.0 * in_step)} (in step with it), a "
        f"guess and no bound{doubt}; compare it with {compare}"
    )


def _unstretched(
    result: Result, rope: Rope, joined: set[str], errors: Floats, whole: _Energies, taut: float
) -> _Energies | None:
    """Return what was lost shortly before a peak beside the stretch there; None where it lacks no more by it.

    Most of what swings goes on swinging: of that only weight and turning pull. What may have become stretch
    is what was lost within a quarter of a swing of all that hangs together, as one mass, on the peak's rope.
    """
    if rope.rigid or not taut > 0.0:
        return None
    ropes = [one for one in result.scene.ropes if one.name in joined]
    mass = sum(one.own_mass + sum(load.mass for load in one.loads) for one in ropes)
    quarter = 0.5 * math.pi * math.sqrt(mass * rope.segments / rope.segment_stiffness)
    time = result.time[: len(errors)]
    first = max(int(np.searchsorted(time, time[-1] - quarter, side="right")) - 1, 0)
    lost = float(errors[first:].max() - errors[-1].min())
    if not (lost > _UNSTRETCHED * (taut + lost) and lost > _OF_ALL * (whole.there + lost)):
        return None
    if not lost * whole.there > _MORE * whole.lost * taut:
        return None
    return _Energies(lost, taut, _STRETCH, f"in the {1e3 * quarter:.3g} ms before")


def _lost_in_blow(errors: Floats, frame: int, peak: float, sizes: Sizes) -> float:
    """Return what was lost since a peak was below a half of it [J]; 0 where that is longer ago than a blow.

    `errors` are those of finite frames until the peak's.
    """
    first = max(frame - _BLOW, 0)
    below = np.flatnonzero(sizes(first, frame) < _BEGUN * peak)
    if not below.size:
        return 0.0
    since = errors[min(first + int(below[-1]), len(errors) - 1) :]
    return float(since.max() - since[-1].min())


def _blurred(plan: Plan, rope: Rope) -> str:
    """Say that a peak may lack more where steps blur its rope's waves: what these would make is not lost."""
    through = wave_time(rope)
    if plan.tolerance is not None or not 0.0 < _BLURS * through < plan.dt:
        return ""
    return (
        f", and it may be too low by far more: a wave takes {1e3 * through:.3g} ms through a segment, and "
        f"what steps of {1e3 * plan.dt:.3g} ms blur of such waves is not in it"
    )


def _energy_of(result: Result, joined: set[str], about: slice) -> tuple[Floats, Floats, bool]:
    """Return the energies of motion and of stretch of ropes that hang together in frames [J], (frames,) each.

    What frames do not tell of them is what all have less what the others have. Where they do not tell that,
    either, as of two winches, it is of all ropes: then the third value is False.
    """
    forms = [own_kinetic(result)[about], result.energy["elastic"][about]]
    others = {rope.name for rope in result.scene.ropes} - joined
    if not others:
        return forms[0], forms[1], True
    whole = [result.energy["kinetic"][about], forms[1]]
    told, rest = _told(result, joined, about, along=True), _told(result, others, about)
    own = [
        np.where(np.isnan(one), every - other, one)
        for one, every, other in zip(told, whole, rest, strict=True)
    ]
    return np.fmin(forms[0], own[0]), np.fmin(forms[1], own[1]), not np.isnan(own).any()


def _told(
    result: Result, names: set[str], about: slice, *, along: bool = False
) -> tuple[Floats, Floats]:
    """Return the energies of motion and of stretch of some ropes in frames [J], (frames,) each.

    NaN where frames do not tell: of what winches wind, and of stretch that relaxes. `along`: the motion as
    seen by who goes with their anchors, or with their middle, where that is less or anchors go evenly.
    """
    layout, frames = result.layout, about.stop - about.start
    taut, weight = np.zeros(frames), np.zeros(layout.nodes)
    wound = {winch.rope for winch in result.scene.winches}
    mass = masses(layout, tuple(line(rope) for rope in result.scene.ropes))[0]
    v = np.nan_to_num(result.read("velocities", about.start, about.stop))
    name = "elastic_tension" if result.has_total_tension else "tension"
    pull = np.nan_to_num(result.read(name, about.start, about.stop))
    for rope, span in zip(result.scene.ropes, layout.ropes, strict=True):
        if rope.name not in names:
            continue
        if rope.name in wound:
            return np.full(frames, math.nan), np.full(frames, math.nan)
        nodes = slice(span.first, span.last + 1)
        weight[nodes] = mass[nodes]
        taut += _stretch(rope, pull[:, span.first : span.last]).sum(axis=1)
    moving = 0.5 * (v**2).sum(axis=2) @ weight
    if along:
        holds = [
            node
            for one, node in zip(result.scene.anchors, layout.anchor_nodes, strict=True)
            if weight[node] > 0.0 and one.release_time is None
        ]
        way = v[:, holds].mean(axis=1) if holds else np.average(v, axis=1, weights=weight)
        beside = 0.5 * ((v - way[:, None]) ** 2).sum(axis=2) @ weight
        moving = beside if goes_evenly(result.scene) else np.fmin(moving, beside)
    return moving, taut


def _stretch(rope: Rope, pull: Floats) -> Floats:
    """Return what segments store at elastic tensions [N], of any shape [J]; NaN of a rope that relaxes."""
    if rope.rigid:
        return np.zeros_like(pull)
    if getattr(rope.made_of, "relaxing_EA", None):
        return np.full_like(pull, math.nan)
    if curve := getattr(rope.made_of, "curve", None):
        strain, _ = at_tension(curve.pieces, pull)
        return rope.segment_length * at_strain(curve.pieces, strain)[2]
    return pull**2 / (2.0 * rope.segment_stiffness)


def _finer(result: Result) -> str:
    plan = result.plan
    if plan.tolerance is not None:
        return f"tolerance = {0.1 * plan.tolerance:.3g}"
    return f"time_step = {0.25 * plan.dt:.3g} s"
