"""Ropes that stretch too much at rest, or carry more than they can."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.library import LibraryRope
from ropewalk.lowering import Model
from ropewalk.scene import Material, Rope, Scene, Springs
from ropewalk.scene.curve_words import curve_words, end_words
from ropewalk.scene.from_library import entry as rope_of
from ropewalk.scene.from_library import origin
from ropewalk.scene.straight_words import straight_words
from ropewalk.statics import Statics
from ropewalk.statics.refusal import has_one_shape
from ropewalk.words.percents import percent
from ropewalk.words.prefixes import prefixed
from ropewalk.words.safe_side import percent_up, times_up

if TYPE_CHECKING:
    from ropewalk.analysis.rope_check import RopeCheck

_NOTHING = 1e-9  # [1] strain: a shape that is shorter by less is so by rounding
_NEAR_PARTING = 0.9  # [1] of the breaking load
_STRAINED = 0.1  # [1] strain at rest that few ropes bear
#: [1] by families that stretch more: climbing ropes hang by a tenth under 80 kg, rubber doubles its length
_CLIMBING = 0.15
_BEAR = {"dynamic climbing rope": _CLIMBING, "rubber": 1.0}


def strain_words(strain: float) -> str:
    """Return a strain in per cent; what rounding leaves of a rope that does not stretch is none."""
    return percent(100.0 * strain if abs(strain) > 1e-12 else 0.0, 3)


def strain_warnings(model: Model, statics: Statics, ropes: tuple[RopeCheck, ...]) -> list[str]:
    """Return warnings of ropes that stretch at rest as no rope does: kN as N, or weak springs."""
    if model.system.limiter.active or not statics.solved:
        return []
    found = []
    for i, rope in enumerate(ropes):
        made_of = model.scene.ropes[i].made_of
        if rope.largest_strain is None:
            continue
        if not isinstance(made_of, Springs) and made_of.curve is not None:
            if rope.largest_strain > made_of.curve.end[0]:
                share = strain_words(rope.largest_strain)
                found.append(
                    f"rope {rope.name!r}: at rest it is stretched by {share}, beyond "
                    f"its curve's last point, {end_words(made_of.curve)}, where it goes on straight"
                )
            continue
        if bent := straight_words(made_of, rope.largest_strain):
            share = strain_words(rope.largest_strain)
            found.append(f"rope {rope.name!r}: at rest it is stretched by {share}, {bent}")
            continue
        entry = _of_library(made_of)
        # What relaxes is a climbing rope from its label.
        known = _STRAINED if getattr(made_of, "relaxing_EA", None) is None else _CLIMBING
        if rope.largest_strain <= (known if entry is None else _borne(entry, rope)):
            continue
        if isinstance(made_of, Springs):
            what = f"spring_constant of {made_of.spring_constant:g} N/m"
            slip = "kN/m typed as N/m, or springs that are weak for what they carry?"
        else:
            what, slip = (
                f"EA of {made_of.EA:g} N",
                "a load too large for this rope, or another rope meant?"
                if entry is not None
                else "kN typed as N, or a rope too soft for its load?",
            )
        found.append(
            f"rope {rope.name!r}: at rest it is stretched by {strain_words(rope.largest_strain)}, under "
            f"{prefixed(rope.largest_tension, 'N')} by its {what}: {slip}"
        )
    return found


def _of_library(made_of: Springs | Material) -> LibraryRope | None:
    """Return the rope of the library that a material has its EA from; None for another EA."""
    about = origin(made_of) or {}
    return rope_of(about["library"])[0] if "EA" in about.get("numbers", {}) else None


def _borne(entry: LibraryRope, rope: RopeCheck) -> float:
    """Return the strain [1] that a rope of the library bears at rest.

    Where its breaking load is a guess that the scene does not have, no utilisation tells of too much.
    """
    bears, load = _BEAR.get(entry.family, _STRAINED), entry.numbers.get("breaking_load")
    if rope.utilisation is not None or load is None or load.low is None:
        return bears
    EA = rope.largest_tension / rope.largest_strain if rope.largest_strain else math.inf
    return min(bears, load.low / EA)


def softer_words(made_of: Springs | Material) -> str:
    """Return of a rope of the library whose EA is that of a fall which has that of rest; "" of others."""
    entry = _of_library(made_of)
    if entry is None or "EA_static" not in entry.numbers or isinstance(made_of, Springs):
        return ""
    if made_of.library.partition(":")[2]:  # it was asked for another use
        return ""
    return f"its EA is that of a fall, at rest it stretches more: {entry.name}:static has that"


def words_of_curve(rope: Rope) -> str:
    """Return what a rope's curve is, in words; "" where it has none."""
    made_of = rope.made_of
    if isinstance(made_of, Springs) or made_of.curve is None:
        return ""
    return curve_words(made_of.curve)


def overlong_at_start(model: Model) -> list[str]:
    """Return a sentence for each rope with segments that count as broken in the shape that it starts from."""
    found, state, most = [], model.state, model.system.break_stretch
    for rope, span in zip(model.scene.ropes, model.layout.ropes, strict=True):
        points, rest = (
            state.x[:, span.first : span.last + 1],  # with those on a drum
            state.rest_length[span.first : span.last],
        )
        size = np.linalg.norm(np.diff(points, axis=1), axis=0)
        long = (rest > 0.0) & (state.stiffness[span.first : span.last] > 0.0) & (size > most * rest)
        if long.any():
            worst = float((size[long] / rest[long]).max())
            found.append(
                f"rope {rope.name!r}: {int(long.sum())} of {rope.segments} segments "
                f"{'starts' if long.sum() == 1 else 'start'} at up to "
                f"{worst:.3g} times their rest length: the run breaks at once, as one beyond {most:.4g} "
                "times counts as broken. Look at the shape's ends and the rope's length"
            )
    return found


def pressed_at_start(model: Model, statics: Statics, ropes: tuple[RopeCheck, ...]) -> list[str]:
    """Return a sentence for each rope whose shape presses it at the start by more than it carries at rest.

    Nodes of a slack shape lie at equal arcs, so that chords are a little shorter than the rope between.
    """
    found: list[str] = []
    if not statics.solved or model.scene.run.start == "at-rest":
        return found
    state = model.state
    for span, rope in zip(model.layout.ropes, ropes, strict=True):
        part = slice(span.start, span.end)
        size = np.linalg.norm(np.diff(state.x[:, span.start : span.end + 1], axis=1), axis=0)
        k = state.stiffness[part]
        pushes = np.isfinite(k) & (model.system.slack_floor[part] < 0.0)
        stuff = model.scene.ropes[[one.name for one in model.scene.ropes].index(span.name)].made_of
        if not isinstance(stuff, Springs):
            slope = stuff.EA if stuff.curve is None else stuff.curve.slopes[0]
            if stuff.curve is not None or stuff.relaxing_EA is not None:
                k = k * (slope / (stuff.EA + (stuff.relaxing_EA or 0.0)))
        pressed = np.where(pushes, k, 0.0)
        most = float((pressed * (state.rest_length[part] - size)).max(initial=0.0))
        least = _NOTHING * float((pressed * state.rest_length[part]).max(initial=0.0))
        if rope.short or not most > max(rope.largest_tension, least):
            continue
        remedy = "more segments make it less"
        if has_one_shape(model, statics.positions, statics.tension, statics.left):
            remedy = 'take run.start = "at-rest"'
        found.append(
            f"rope {rope.name!r}: its shape starts it pressed, by up to {prefixed(most, 'N')}, where it "
            f"carries {prefixed(rope.largest_tension, 'N')} at rest: chords of a curve are shorter than the "
            f"rope between. Waves of that size run at first, and largest tensions may be theirs; {remedy}"
        )
    return found


def parting_warnings(scene: Scene, ropes: tuple[RopeCheck, ...]) -> list[str]:
    """Return warnings of ropes that part at rest, or nearly, by the least of guesses and knots."""
    when = "as it starts" if scene.run.start == "at-rest" else "by the time it is at rest"
    found = []
    for rope in ropes:
        worst = rope.utilisation if rope.worst is None else rope.worst
        if not rope.parts or rope.utilisation is None or worst is None or worst <= _NEAR_PARTING:
            continue
        then, as_given = (
            (when, rope.parts_at_rest)
            if worst > 1.0
            else ("with little more", rope.utilisation > _NEAR_PARTING)
        )
        then = f"it {'parts' if as_given else 'may part'} {then}"
        doubt = f"; {rope.doubt}" if rope.doubt else ""
        share = f"{percent_up(100.0 * rope.utilisation, 4)} of the breaking load"
        found.append(f"rope {rope.name!r}: carries {share} at rest; {then}{doubt}")
    return found


def breaking_warnings(ropes: tuple[RopeCheck, ...]) -> list[str]:
    """Return warnings of ropes that carry more than their breaking load at rest, or may, and cannot part."""
    return [
        f"rope {rope.name!r}: at rest it carries {'at least ' if rope.at_least else ''}"
        f"{times_up(rope.utilisation)} times its breaking load; "
        f"in the run it does not part{f'; {rope.doubt}' if rope.doubt else ''}"
        for rope in ropes
        if rope.utilisation is not None and rope.worst is not None
        if rope.worst > 1.0 and not rope.parts
    ]
