"""What an energy error is a share of: the energy that is turned over where an error can arise.

The largest change of a form of energy grows without end with what has nothing to do with the error: a piece
that has fallen off falls freely, a rope without anchors flies, one is carried a long way by its anchors. Such
an energy would hide any error. So a piece's energy counts as it is seen by who goes along: with the
centre of mass of a piece that nothing holds, with the anchors of one that they move. Of the two accounts, at
rest and going along, the smaller one counts; the latter where all anchors go on at one velocity. What
surfaces in touch take counts from when they take it, without what their motors give where that is less.
Pieces in air, and those that a winch feeds, count as seen at rest. Of anchors that accelerate see
`seen_along`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.hands.drum import PARTED
from ropewalk.laws.acting import section_of
from ropewalk.laws.parting import NAME as PARTING
from ropewalk.laws.registry import NODE_LAWS
from ropewalk.lowering.masses import line, masses
from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import energy_of_rounding, shorter_steps, weight_times_length
from ropewalk.record.body_energies import turning_of
from ropewalk.record.quantities import has_rope, rest_length_at_start
from ropewalk.record.seen_along import seen_along
from ropewalk.scene.motions import Fixed, Velocity
from ropewalk.words.percents import percent

if TYPE_CHECKING:
    from ropewalk.lowering import Layout
    from ropewalk.record.result import Result
    from ropewalk.scene import Scene

Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
_TOUCHING = tuple(law.name for law in NODE_LAWS if law.touch is not None)
_VALUES = 1_000_000  # numbers of one quantity looked at together
_LEAST = 1e-9  # [1] of the energy turned over as seen at rest: less is rounding
_TOLD = 1.0  # [%] of the energy turned over: of a larger share it is told what it is a share of
_LITTLE = 1e-4  # [1] of the energy of motion: less turned over is hardly any
SUDDEN = 0.005  # [1] of the energy turned over in all, within a frame: less is no hit that matters
_ALL = 0.2  # [1] of what moved and stretched: so much within a frame is a hit
_ABOUT = 4  # frames about a hit
_STILL = 1e-10  # [1] of the energies, or of weight times length: where less is turned over, nothing moves
# [1] of that: what surfaces are booked to take where nothing moves, from rounding of velocities, step by step
_BOOKS = 1e4


class Carried(NamedTuple):
    """The energy of pieces as wholes [J], (frames,) each: that of a mass that goes with what carries each."""

    kinetic: Floats
    gravity: Floats
    loose: Floats  # both, of pieces in free fall: it does not change but by an error


def share_turned(result: Result) -> float:
    """Return the largest energy error before a break, of the energy turned over [%]; NaN without either.

    Pieces that fall freely (without air and surfaces) have an account of their own, with their own error and
    turn-over; the larger share is told.
    """
    good = result.good_frames
    least, most = result.energy_errors[:good].T
    if not np.isfinite(least).any():
        return math.nan
    if along := seen_along(result):
        return _ratio(np.abs(along.error).max(), along.turned) if along.turned else math.nan
    forms = {name: part[:good] for name, part in result.energy.items() if name != "total"}
    works = {name: part[:good] for name, part in result.work.items()}
    if bodies := turning_of(result):
        forms |= {"turning": bodies.kinetic[:good], "weight": bodies.weight[:good]}
    touched = np.minimum(surfaces(works), surfaces(_without_motors(result, works)))
    turned, shares = largest_change(forms.values()), [0.0]
    rounding = _STILL * max(_largest(forms.values()), weight_times_length(result.scene))
    turned = 0.0 if turned <= rounding else turned
    touched = np.where(touched > (rounding if turned > 0.0 else _BOOKS * rounding), touched, 0.0)
    if carried := _carried(result, good):
        own = forms | {
            "kinetic": forms["kinetic"] - carried.kinetic,
            "gravity": forms["gravity"] - carried.gravity,
        }
        fall = np.ptp(forms["gravity"]), np.ptp(carried.loose)
        shares.append(_ratio(fall[1], max(float(fall[0]), turned)))
        least_turned = math.inf if goes_evenly(result.scene) else turned
        turned = max(min(least_turned, largest_change(own.values())), _LEAST * turned)
        before = np.concatenate((carried.loose[:1], carried.loose[:-1]))
        least = np.minimum(least - np.minimum(before, carried.loose), 0.0)
        most = np.maximum(most - np.maximum(before, carried.loose), 0.0)
    error = np.fmax(np.abs(least), np.abs(most))
    whole = np.maximum(touched, turned)
    sound = np.isfinite(error) & (whole > 0.0)
    shares += [100.0 * float((error[sound] / whole[sound]).max())] if sound.any() else []
    return max(shares) if turned > 0.0 or touched[-1] > 0.0 else math.nan


def own_errors(result: Result) -> Floats:
    """Return the least and greatest energy error before a break as who goes along sees it [J], (frames, 2).

    0 where nothing moves beside who goes along with accelerated anchors.
    """
    if along := seen_along(result):
        return np.column_stack((along.error, along.error)) * bool(along.turned)
    return result.energy_errors[: result.good_frames]


def steady_note(result: Result, worst: float, share: float) -> str:
    """Say what the largest error [J] is a share of [%] where hardly any energy of motion changes; else ""."""
    if not share > _TOLD:
        return ""
    moving, turned = own_kinetic(result), 100.0 * worst / share
    whole = float(moving[np.isfinite(moving)].max(initial=0.0))
    if not turned < _LITTLE * whole:
        return ""
    return (
        f"the share is large as hardly any energy is turned over, {turned:.3g} J: of the {whole:.4g} J of "
        f"motion the error is {percent(100.0 * worst / whole)}"
    )


def sudden_note(result: Result, share: float) -> str:
    """Say where much of what moved was lost or made up within a frame, small in the whole run; else "".

    `share` is the largest error, of the energy turned over [%]. What a hit or a jerk takes is small beside
    what a long run turns over, and is all that there was: forces then are as wrong as in a run that ends.
    """
    plan, good = result.plan, result.good_frames
    implicit = plan.method in METHODS and METHODS[plan.method].implicit
    live = result.facts.provenance.get("live")
    if good < 2 or not implicit or not share > 0.0 or live:  # explicit energies swing with the step
        return ""
    errors = own_errors(result)
    error = errors[:, 0] if seen_along(result) else result.energy_error[:good]
    bounds = np.column_stack((errors, error))
    bounds[1:] = np.nan_to_num(bounds[1:])
    before = np.nan_to_num(error[:-1])
    jumps = np.maximum(bounds[1:].max(axis=1), before) - np.minimum(bounds[1:].min(axis=1), before)
    frame = int(np.argmax(jumps)) + 1
    jump, worst = float(jumps[frame - 1]), float(np.nanmax(np.abs(errors)))
    about = slice(max(frame - _ABOUT, 0), frame + _ABOUT)  # what begins to fall has little at first
    there = float((own_kinetic(result)[about] + result.energy["elastic"][:good][about]).max())
    rounding = _STILL * max(_largest(result.energy.values()), weight_times_length(result.scene))
    if not jump > max(rounding, energy_of_rounding(result.scene)):
        return ""
    if not (jump > SUDDEN * 100.0 * worst / share and jump > _ALL * (jump + there)):
        return ""
    steps = f"steps of {1e3 * plan.dt:.3g} ms" if plan.tolerance is None else "tolerance"
    return (
        f"{jump:.3g} J of it came within one frame, before t = {result.time[frame]:.6g} s, beside "
        f"{there:.3g} J of motion and stretch about then: a hit or a jerk that {plan.method}'s {steps} do "
        f"not resolve. Forces then may be far too low; take {shorter_steps(plan)}"
    )


def own_kinetic(result: Result) -> Floats:
    """Return the kinetic energy before a break as who goes along sees it [J], (frames,).

    That of bodies whose weight turns them is in it, as their error is in that of the energy.
    """
    good = result.good_frames
    kinetic: Floats = result.energy["kinetic"][:good]
    if bodies := turning_of(result):
        kinetic = kinetic + bodies.kinetic[:good]
    carried = _carried(result, good)
    return kinetic - carried.kinetic if carried else kinetic


def stands(scene: Scene) -> bool:
    """Tell whether all anchors hold what they hold where it is, all the time."""
    return all(isinstance(one.motion, Fixed) and one.release_time is None for one in scene.anchors)


def goes_evenly(scene: Scene) -> bool:
    """Tell whether all anchors go at one velocity, all the time: seen from them all is as if they stood."""
    motions = [one.motion for one in scene.anchors if one.release_time is None]
    if len(motions) < len(scene.anchors) or any(section_of(law, scene) for law in NODE_LAWS):
        return False
    first = motions[0] if motions else Fixed()
    even = isinstance(first, Velocity) and first.start == 0.0 and math.isinf(first.stop)
    return even and all(motion == first for motion in motions)


def nothing_is_loose(result: Result) -> bool:
    """Tell whether anchors hold a node of every rope all the time, and all rope hangs together.

    Where it does so otherwise, by joints or beside a drum, it is not told.
    """
    scene, layout = result.scene, result.layout
    if scene.winches or any(one.release_time is not None for one in scene.anchors):
        return False
    if result.ends or any(event["event"] == PARTED for event in result.events):
        return False
    return len({layout.rope_of(node)[0] for node in layout.anchor_nodes}) == len(layout.ropes)


def _ratio(part: float, whole: float) -> float:
    return 100.0 * float(part) / whole if whole > 0.0 else 0.0


def largest_change(forms: Iterable[Floats]) -> float:
    """Return the largest change of any of these energies [J], (frames,) each, over all finite frames; or 0.

    Where a motor works against the friction of a surface nothing else changes than its work: see `surfaces`.
    Works of other laws are not counted: a false ledger of friction or of the limiter is large itself, and
    would hide its error.
    """
    finite = [part[np.isfinite(part)] for part in forms]
    return max((float(np.ptp(part)) for part in finite if part.size), default=0.0)


def _largest(forms: Iterable[Floats]) -> float:
    """Return the largest size of any of these energies [J], or 0."""
    finite = [part[np.isfinite(part)] for part in forms]
    return max((float(np.abs(part).max()) for part in finite if part.size), default=0.0)


def surfaces(work: Mapping[str, Floats]) -> Floats:
    """Return the largest change so far of what surfaces in touch have put in or taken [J], (frames,)."""
    most: Floats = np.zeros(len(next(iter(work.values()))))
    for name in _TOUCHING:
        part = np.nan_to_num(work.get(name, most))
        np.maximum(most, np.maximum.accumulate(part) - np.minimum.accumulate(part), out=most)
    return most


def _without_motors(result: Result, work: Mapping[str, Floats]) -> dict[str, Floats]:
    """Return the works without what the motors of obstacles gave: a lift gives more and more on its way."""
    motors = [np.nan_to_num(part["motor"]) for part in result.contact_work.values()]
    if not motors or "obstacle" not in work:
        return dict(work)
    given = np.sum(motors, axis=0)[: len(work["obstacle"])]
    return dict(work) | {"obstacle": work["obstacle"] - given}


def _carried(result: Result, good: int) -> Carried | None:
    """Return what pieces have as wholes; None where anchors that stand still hold all, all the time."""
    scene, layout = result.scene, result.layout
    live, held = _topology(result, 0)
    fed = np.zeros(layout.nodes, dtype=bool)
    for span in (layout.span(winch.rope) for winch in scene.winches):
        fed[span.first : span.last + 1] = True
    still = stands(scene) and not scene.parts
    if still and not (loose(pieces(scene, layout, live), held) & ~fed).any():
        return None
    mass = masses(layout, tuple(line(rope) for rope in scene.ropes))[0]
    found = Carried(np.zeros(good), np.zeros(good), np.zeros(good))
    free, lands = _falls_freely(result, good), _lands(result, good)
    wild = np.zeros(layout.nodes, dtype=bool) if free else loose(pieces(scene, layout, live), held)
    wild |= fed
    for span in (layout.span(name) for end in result.ends for name in end.ropes):
        wild[span.first : span.last + 1] = True  # a rope that broke has no velocity any more
    for first, last in _epochs(result, good, lands):
        live, held = _topology(result, first)
        labels = pieces(scene, layout, live)
        off = loose(labels, held)
        weight = np.where(off, mass, held) * ~(off & wild) * ~fed
        falls = off & (free and first < lands) & ~wild
        _go_along(result, (first, last), labels, weight, mass, found, falls)
    return found


def _falls_freely(result: Result, good: int) -> bool:
    """Tell whether weight and surfaces are all that acts on a piece that nothing holds."""
    scene = result.scene
    others = (law for law in NODE_LAWS if law.name != PARTING and law.name not in _TOUCHING)
    acts = any(section_of(law, scene) for law in others)
    return not acts and scene.limiter is None and not np.any(result.work["applied"][:good])


def _lands(result: Result, good: int) -> int:
    """Return the first frame by which a surface has done anything, past all where none has."""
    works = [np.nan_to_num(result.work[name][:good]) for name in _TOUCHING if name in result.work]
    done = [np.flatnonzero(work != work[0]) for work in works]
    return min((int(rows[0]) for rows in done if rows.size), default=good)


def _topology(result: Result, frame: int) -> tuple[Bools, Bools]:
    """Return where there is rope, (s,), and which nodes anchors hold, (n,), at a frame."""
    lengths = [rope.segment_length for rope in result.scene.ropes]
    if "rest_length" in result.source.names:
        rest = result.read("rest_length", frame, frame + 1)[0]
    else:
        rest = rest_length_at_start(result.layout, lengths)
    held, time = np.zeros(result.nodes, dtype=bool), float(result.time[frame])
    for anchor, node in zip(result.scene.anchors, result.layout.anchor_nodes, strict=True):
        held[node] |= anchor.release_time is None or time <= anchor.release_time
    return has_rope(result.layout, rest, lengths), held


def pieces(scene: Scene, layout: Layout, live: Bools) -> Ints:
    """Return a number for every node, (n,), the same for all of a piece; joints and slides tie pieces."""
    labels: Ints = np.concatenate(([0], np.cumsum(~live)))
    groups = [[layout.node(tie.node, tie.rope) for tie in one.points] for one in scene.joints]
    groups += [[layout.node(one.node, one.rope), layout.node(0, one.on)] for one in scene.slides]
    for first, *others in groups:
        for other in others:
            labels[labels == labels[other]] = labels[first]
    return np.unique(labels, return_inverse=True)[1]


def loose(labels: Ints, held: Bools) -> Bools:
    """Tell which nodes are of pieces that no anchor holds, (n,)."""
    free: Bools = (np.bincount(labels, weights=held) == 0.0)[labels]
    return free


def _epochs(result: Result, good: int, lands: int) -> Iterator[tuple[int, int]]:
    """Go through the ranges of frames between which ropes part, anchors let go or surfaces begin to act."""
    times = [one.release_time for one in result.scene.anchors if one.release_time is not None]
    starts = {0, lands, *np.searchsorted(result.time[:good], times, side="right")}
    step = max(1, _VALUES // result.nodes)
    for start in range(0, good if result.scene.parts else 0, step):
        there = result.read("rest_length", max(start - 1, 0), min(start + step, good)) > 0.0
        starts |= set(np.flatnonzero((there[1:] != there[:-1]).any(axis=1)) + max(start, 1))
    bounds = sorted({int(start) for start in starts if start < good} | {good})
    yield from pairwise(bounds)


def _go_along(
    result: Result,
    frames: tuple[int, int],
    labels: Ints,
    weight: Floats,
    mass: Floats,
    found: Carried,
    falls: Bools,
) -> None:
    """Write what pieces have as wholes at some frames, between which nothing parts or is let go.

    `weight` (n,): whose mean goes along with a piece; all 0: nobody does.
    """
    order = np.argsort(labels, kind="stable")
    starts = np.flatnonzero(np.diff(labels[order], prepend=-1))

    def summed(values: Floats) -> Floats:
        """Return the sums over pieces, (..., pieces, 3), of (..., n, 3)."""
        sums: Floats = np.add.reduceat(values[..., order, :], starts, axis=-2)
        return sums

    total = np.bincount(labels, weights=weight)
    part = (weight / np.where(total > 0.0, total, 1.0)[labels])[:, None]
    masses_of, of_loose = np.bincount(labels, weights=mass), falls[order][starts]
    gravity, start = np.asarray(result.scene.gravity), max(frames[0] - 1, 0)

    def height(first: int, last: int) -> Floats:
        """Return the energy of weight of what goes along [J], (frames, pieces)."""
        places: Floats = summed(result.read("positions", first, last) * part) @ -gravity
        return masses_of * places

    def moving(first: int, last: int) -> Floats:
        """Return the kinetic energy of what goes along [J], (frames, pieces)."""
        velocity = np.nan_to_num(result.read("velocities", first, last))
        along, momentum = summed(velocity * part), summed(velocity * mass[:, None])
        energy: Floats = (along * momentum).sum(axis=2) - 0.5 * masses_of * (along**2).sum(axis=2)
        return energy

    low, base = (
        height(start, start + 1),
        found.gravity[start],
    )  # what is new falls since the frame before
    begin = height(frames[0], frames[0] + 1) + moving(frames[0], frames[0] + 1)
    fallen, step = found.loose[start], max(1, _VALUES // (3 * result.nodes))
    for first in range(*frames, step):
        last = min(first + step, frames[1])
        high, quick = height(first, last), moving(first, last)
        found.kinetic[first:last] = quick.sum(axis=1)
        found.gravity[first:last] = base + (high - low).sum(axis=1)
        found.loose[first:last] = fallen + (quick + high - begin)[:, of_loose].sum(axis=1)
