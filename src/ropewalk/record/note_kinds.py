"""What a run's table warns of, by short kinds: a sweep counts them over its runs.

Table and sweep take the notes from the same functions. A sweep makes many short runs, so that what cannot be
is ruled out by less than the look itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.hands.drum import EMPTY, PARTED
from ropewalk.lowering.long_segments import long_about
from ropewalk.lowering.swings import too_few
from ropewalk.methods.recording import ENERGIES
from ropewalk.methods.registry import METHODS
from ropewalk.record.balances import (
    MOST,
    TURNED,
    energy_note,
    is_damped,
    lost_note,
    weight_times_length,
)
from ropewalk.record.deep_note import deep_note
from ropewalk.record.event_log import RAN_OFF
from ropewalk.record.extremes import UTILISATION, Extreme, extremes, margin
from ropewalk.record.facts import AT_REST
from ropewalk.record.happenings import STOPPED
from ropewalk.record.hard_stops import hard_note
from ropewalk.record.landings import Landing, landings_of
from ropewalk.record.limiter_at_rest import rests_beyond
from ropewalk.record.limiter_note import limiter_note
from ropewalk.record.margins import both_words, guess_doubt, knot_words
from ropewalk.record.moment_notes import moment_note
from ropewalk.record.pressed_rows import pressed_kinds
from ropewalk.record.quantities import has_rope, rest_length_at_start
from ropewalk.record.seen_along import accelerated_alike
from ropewalk.record.speed_note import speed_note
from ropewalk.record.sudden_anchors import started_note
from ropewalk.record.tension_notes import anchor_bears, anchor_note, curve_note, push_note
from ropewalk.record.too_low import anchor_too_low, margin_too_low, tension_too_low
from ropewalk.record.turnover import (
    SUDDEN,
    nothing_is_loose,
    own_errors,
    share_turned,
    stands,
    steady_note,
    sudden_note,
)
from ropewalk.words.counts import counted
from ropewalk.words.pushes import largest_push

if TYPE_CHECKING:
    from ropewalk.record.result import Result

#: Kinds of notes in the order in which they are told, each with what it says of so many runs.
KINDS = {
    "parted": "parted: their largest tension is where they parted",
    "above breaking load": "got above the breaking load, where a rope would have parted",
    "peak may be wrong": "may have a peak that is wrong by a fifth and more: a jerk or ringing waves in too "
    "long steps",
    "peak may be too low": "may have a peak that is too low: the steps lost energy until then",
    "speed may be too low": "may have a largest speed that is too low: a whip or a wave of a step or two",
    "landing not shown": "have an end that lands and gives an obstacle or an anchor more than is shown",
    "force between frames": "have a force on an obstacle that comes within a frame: it may be far more",
    "hard stop": "have a peak of what nothing that gives has stopped: momentum over a step",
    "energy not kept": "have an energy that their steps have not kept: do not trust forces and places",
    "limiter gives energy": "have a limiter that puts energy in: do not trust forces and velocities",
    "rest beyond limiter": "rest beyond their limiter, which rest is without: spans carry more with it",
    "guess": "hang on a guessed number of the material",
    "knot": "come or may come nearest in a rope whose breaking load is told without its knot",
    "clamp moment too low": "have a clamp's moment that is too low for the length of the segments",
    "mean anchor force": "have an anchor's force, the mean over a step, less than the tension beside it",
    "sudden anchor": "have an anchor that starts or stops at once: its largest force is of its own node",
    "end weight": "have an anchor that bears half a segment's weight more than the largest tension",
    "beyond curve": "are stretched to where the curve or the EA of the rope is not its own any more",
    "long segments": "have segments long about an obstacle (see check): ropes may pass between nodes",
    "few steps a swing": "shake an anchor or an obstacle in too few steps a swing (see check)",
    "inside obstacle": "have a node whose middle was inside an obstacle, where no rope can be",
    "push": "have segments that push, which a rope does not",
    "slide ran off": "lost a slide at the end of a rope that had parted",
    "empty drum": "had a winch stop with its drum empty",
}  # fmt: skip
HARD = "hard stops"
BEYOND_LIMITER = "rest beyond limiter"
_ELASTIC = ENERGIES.index("elastic")  # those from it on are the same whoever goes along
BETWEEN = "; "  # kinds of one run
#: Kind and text of a note.
Note = tuple[str, str]


def kinds_in(text: str) -> list[str]:
    """Return the kinds that a text of one run's notes holds."""
    return [kind for kind in text.split(BETWEEN) if kind]


def noted(counts: Mapping[str, int] | None, of: int) -> list[tuple[str, str]]:
    """Return every kind that was counted among so many runs, with a sentence without its full stop."""
    runs = f"of {counted(of, 'run')}"
    kinds = [(kind, words) for kind, words in KINDS.items() if counts and counts.get(kind)]
    return [(kind, f"{(counts or {})[kind]} {runs} {words}") for kind, words in kinds]


def notes_of_extremes(
    result: Result, found: dict[str, Extreme], landings: Sequence[Landing]
) -> dict[str, Note]:
    """Return what there is to say of extremes, by their names, and HARD; `landings` are its ropes' ends'."""
    most, least = found["greatest tension"], found["least tension"]
    force, hard = found["greatest anchor force"], hard_note(result, found)
    notes = {
        "greatest tension": _both(
            tension_too_low(result, most), ("end weight", anchor_bears(result, most))
        ),
        "least tension": ("push", push_note(result, least, most.value)),
        "greatest stretch": ("beyond curve", curve_note(result, found["greatest stretch"])),
        "greatest speed": ("speed may be too low", speed_note(result, found["greatest speed"])),
        "greatest anchor force": ("", "")
        if hard
        else _both(
            anchor_too_low(result, force, most, landings),
            ("mean anchor force", anchor_note(result, force, most)),
            ("sudden anchor", started_note(result, force)),
        ),
        "greatest clamp moment": _of_moment(result, found),
        UTILISATION: margin_too_low(result, found[UTILISATION], most)
        if UTILISATION in found
        else ("", ""),
        HARD: ("hard stop", hard),
    }
    return {name: note for name, note in notes.items() if note[1]}


def _both(*notes: Note) -> Note:
    """Return these notes as one, of several kinds."""
    told = [note for note in notes if note[1]]
    return BETWEEN.join(kind for kind, _ in told), BETWEEN.join(text for _, text in told)


def _of_moment(result: Result, found: dict[str, Extreme]) -> Note:
    return "clamp moment too low", moment_note(result, found["greatest clamp moment"])


def notes_at_rest(result: Result, found: dict[str, Extreme]) -> dict[str, Note]:
    """Return what there is to say of the extremes of an equilibrium, by their names."""
    peak, least = found["greatest tension"], found["least tension"]
    pushes = largest_push(result.tension[0], result.residual)
    notes = {
        "greatest tension": ("end weight", anchor_bears(result, peak)),
        "least tension": ("push", push_note(result, least, peak.value) if pushes else ""),
        "greatest stretch": ("beyond curve", curve_note(result, found["greatest stretch"])),
        "greatest clamp moment": _of_moment(result, found),
    }
    return {name: note for name, note in notes.items() if note[1]}


def kinds(result: Result) -> tuple[str, ...]:
    """Return the kinds of all that a sound run's table warns of, but for what takes long to look for.

    And of what `check` warns of before a run that no table has: segments that are long about an obstacle, and
    swings in few steps.
    That is what is said of contacts that brake early, of wraps and of slides: `reach_note`, `coarse_note` and
    `moving_rows` take up to half as long as the run itself, or more. Of forces on several obstacles few
    frames are looked at, unless an end lands: `pressed_kinds`.
    """
    there = set(_kinds(result))
    return tuple(kind for kind in KINDS if kind in there)


def _kinds(result: Result) -> Iterator[str]:
    found = extremes(result)
    at_rest = result.status == AT_REST
    if at_rest:
        found = less_rounding(result, found)
        notes = notes_at_rest(result, found)
        if rests_beyond(result, found):
            yield BEYOND_LIMITER
    else:
        landings = landings_of(result)
        notes = notes_of_extremes(result, found, landings)
        for told in pressed_kinds(result, found["greatest tension"], landings):
            yield from kinds_in(told)
    for kind, _ in notes.values():
        yield from kinds_in(kind)
    near = margin(result, found) if UTILISATION in found else None
    if _long_segments(result):
        yield "long segments"
    events = () if at_rest else tuple(_of_events(result))
    yield from events
    if near is not None:
        if near.utilisation > 1.0 and "parted" not in events:
            yield "above breaking load"
        both = both_words(result.scene, near)
        if both or guess_doubt(result.scene, near):
            yield "guess"
        if both or knot_words(result.scene, near):
            yield "knot"
    if not at_rest:
        if not _keeps_energy(result) and _of_energy(result):
            yield "energy not kept"
        if limiter_note(result):
            yield "limiter gives energy"
        if _few_steps(result):
            yield "few steps a swing"
        if deep_note(result):
            yield "inside obstacle"


def _long_segments(result: Result) -> bool:
    """Tell whether segments may pass an obstacle between two nodes."""
    scene, layout = result.scene, result.layout
    if not scene.obstacles:
        return False
    lengths = [rope.segment_length for rope in scene.ropes]
    rest = rest_length_at_start(layout, lengths)
    if "rest_length" in result.source.names:
        rest = result.read("rest_length", 0, 1)[0]
    drawn = np.diff(result.read("positions", 0, 1)[0], axis=0)
    there = drawn[has_rope(layout, rest, lengths)].T
    return any(long_about(scene, body, there) is not None for body in scene.obstacles)


def _few_steps(result: Result) -> bool:
    """Tell whether something swings in too few steps."""
    plan = result.plan
    step = plan.dt if plan.longest is None else plan.longest
    return any(too_few(result.scene, plan.method, step, plan.duration))


def less_rounding(result: Result, found: dict[str, Extreme]) -> dict[str, Extreme]:
    """Return the extremes of an equilibrium, with none for a largest tension that is rounding."""
    peak = found["greatest tension"]
    if abs(peak.value) <= result.residual:
        return found | {"greatest tension": peak._replace(value=0.0)}
    return found


def _of_events(result: Result) -> Iterator[str]:
    for event in result.events:
        if event["event"] == PARTED:
            yield "parted"
        elif event["event"] == RAN_OFF:
            yield "slide ran off"
        elif event["event"] == STOPPED and event["by"] == EMPTY:
            yield "empty drum"


# -- the energy ----------------------------------------------------------------------------


def _of_energy(result: Result) -> str:
    """Return what the table says of the energy, but what a large share is of: no sweep has the share."""
    if lost := lost_note(result):
        return lost
    errors, share = own_errors(result), share_turned(result)
    worst = float(np.abs(errors[np.isfinite(errors)]).max(initial=0.0))
    if steady_note(result, worst, share):
        return ""
    return energy_note(result, errors.ravel(), share) or sudden_note(result, share)


def _keeps_energy(result: Result) -> bool:
    """Tell, by little work, that nothing is to be said of the energy; False: it has to be looked at.

    Where nothing is loose no error of a free fall counts, and what changes of the elastic energy is turned
    over whoever looks on; where anchors stand still, so is all else.
    """
    if not result.facts.ledger:
        return True
    errors, forms, works = result.energy_errors, result.read("energy"), result.read("work")
    if not all(math.isfinite(np.add.reduce(part, None)) for part in (errors, forms, works)):
        return False
    scene = result.scene
    worst = max(float(np.maximum.reduce(errors, None)), -float(np.minimum.reduce(errors, None)))
    scale = weight_times_length(scene)
    if worst > MOST * scale and not (METHODS[result.plan.method].implicit or is_damped(scene)):
        return False
    if not nothing_is_loose(result) or accelerated_alike(result):
        return False
    counts = forms if stands(scene) and not scene.parts else forms[:, _ELASTIC:]
    turned: float = max((np.maximum.reduce(counts) - np.minimum.reduce(counts)).tolist())
    implicit = METHODS[result.plan.method].implicit
    return worst <= (0.5 * SUDDEN if implicit else 0.01 * TURNED) * turned
