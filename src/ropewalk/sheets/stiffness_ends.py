"""The same scene with the guessed stiffnesses of its ropes at the ends of their ranges."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from ropewalk.api import equilibrium, simulate
from ropewalk.lowering import build
from ropewalk.methods.registry import METHODS
from ropewalk.record.extremes import extremes, margin
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.guess import STIFF, guesses_of, worst_of
from ropewalk.scene.knotted import both_doubt, least_worst
from ropewalk.sheets.content import Item, Section, Table, Text
from ropewalk.sheets.trust import PARTED, Variant, rest_numbers, row_of, run_numbers, tried
from ropewalk.words.prefixes import prefixed
from ropewalk.words.safe_side import outwards, percent_up, safety_factor

if TYPE_CHECKING:
    from ropewalk.record.result import Result

TITLE = "Guessed stiffness"
SEE = f"both ends of it are computed under {TITLE}"
_ENDS = ("least", "greatest")
_NAMED = 6  # that are told one by one
_TOLD = ("largest tension", "largest force on an anchor")
_USED = "largest utilisation"
_WORST = "with the least of a guessed breaking load"
_BOTH = "with that and the least that a knot leaves"


class Ends(NamedTuple):
    """What a sheet tells of the ends of guessed stiffnesses."""

    section: Section
    summary: tuple[Item, ...]  # for where a job is decided


def at_ends(scene: Scene) -> tuple[Scene | None, Scene | None] | None:
    """Return the scene with all guessed stiffnesses at their least, and at their greatest.

    Lengths stay. None where none is a guess; None in place of a scene that cannot be.
    """
    if not any(set(STIFF) & set(guesses_of(rope.made_of)) for rope in scene.ropes):
        return None
    found: list[Scene | None] = []
    for end in ("low", "high"):
        try:
            found.append(scene.replace(ropes=[_at(rope, end) for rope in scene.ropes]))
        except SceneError:
            found.append(None)
    return found[0], found[1]


def _at(rope: Any, end: str) -> Any:
    marks = guesses_of(rope.made_of)
    ends = {name: getattr(marks[name], end) for name in STIFF if name in marks}
    return rope.replace(made_of=rope.made_of.replace(**ends)) if ends else rope


def stiffness_ends(
    scene: Scene, rest: Result | None, run: Result | None, progress: Callable[[str], None]
) -> Ends | None:
    """Return tensions, sag and anchor forces at both ends of guessed stiffnesses; None without any."""
    scenes = at_ends(scene)
    if scenes is None:
        return None
    items: list[Item] = [Text(_which(scene))]
    told: list[str] = []
    rows: list[tuple[str, ...]] = []
    for title, result in (("at rest", rest), ("in the run", run)):
        if result is None:
            continue
        variants = []
        for end, one in zip(_ENDS, scenes, strict=True):
            progress(f"{title} with the {end} of a guessed stiffness")
            variants.append(_variant(f"{end} stiffness", one, result))
        base = rest_numbers(scene) if result.status == "at rest" else run_numbers(result)
        items += [
            Text(f"{title.capitalize()}, {v.title}: {v.why_not}.", warning=v.failed)
            for v in variants
            if v.why_not
        ]
        rows += [
            (f"{name}, {title}", *row[1:]) for name in base if (row := row_of(name, base, variants))
        ]
        used = _used(result)
        rows += _rows(title, used, variants)
        told += _spans(title, base | used, variants)
    items.append(Table(("", "this sheet", *(f"{end} stiffness" for end in _ENDS)), rows))
    summary = Text(f"{_guess(scene)}: {'; '.join(told)}.", warning=True)
    return Ends(Section(TITLE, tuple(items)), (summary,) if told else ())


def _variant(title: str, scene: Scene | None, result: Result) -> Variant:
    """Return the numbers of a scene at an end, computed as the result was."""
    if scene is None:
        return Variant(title, why_not="the scene cannot be made with it", failed=True)
    if result.status == "at rest":
        return tried(title, _rest_numbers, scene)
    return tried(title, lambda made: _numbers(_stepped_as(made, result)), scene)


def _stepped_as(scene: Scene, result: Result) -> Scene:
    """Return the scene with the method of a result, in steps that are as long, or shorter to be stable.

    "auto" of a method that is called by name goes as far as that is stable, which is not accurate enough.
    """
    plan = result.plan
    run = scene.run.replace(method=plan.method)
    if plan.tolerance is not None:
        return scene.replace(run=run)
    step = plan.dt
    if run.time_step == "auto":
        step = min(step, build(scene.replace(run=run)).plan.dt)
    elif not METHODS[plan.method].implicit:
        step /= _faster(result.scene, scene)
    return scene.replace(run=run.replace(time_step=step))


def _numbers(scene: Scene) -> dict[str, float]:
    result = simulate(scene)
    return {**run_numbers(result), PARTED: float(len(result.partings)), **_used(result)}


def _rest_numbers(scene: Scene) -> dict[str, float]:
    return {**rest_numbers(scene), **_used(equilibrium(scene))}


def _used(result: Result) -> dict[str, float]:
    """Return the largest utilisation [1], that with the least of guessed breaking loads, and of knots too.

    NaN where no breaking load is known, alike where none is a guess; the last NaN where no rope has both.
    """
    near = margin(result, extremes(result))
    if near is None:
        return dict.fromkeys((_USED, _WORST, _BOTH), math.nan)
    worst = worst_of(result.scene.rope_named(near.guessed).made_of, near.at_most)
    doubted = result.scene.rope_named(near.doubted)
    both = least_worst(doubted, near.as_given) if both_doubt(doubted, near.as_given) else math.nan
    return {_USED: near.utilisation, _WORST: worst, _BOTH: both}


def _rows(title: str, used: dict[str, float], variants: list[Variant]) -> list[tuple[str, ...]]:
    """Return the rows of utilisations: as breaking loads are given and, of guesses, with the least."""
    found = []
    for name, words in ((_USED, _USED), (_WORST, f"{_USED} {_WORST}"), (_BOTH, f"{_USED} {_BOTH}")):
        if math.isnan(used[name]) or (name != _USED and used[name] == used[_USED]):
            continue
        each = (used[name], *(v.numbers.get(name, math.nan) for v in variants))
        cells = ("" if math.isnan(one) else _percent(one) for one in each)
        found.append((f"{words}, {title}", *cells))
    return found


def _percent(used: float) -> str:
    return f"{percent_up(100.0 * used, 3)}{_factor(used)}"


def _factor(used: float) -> str:
    return f" (safety factor {safety_factor(used)})" if used > 0.0 else ""


def _faster(old: Scene, new: Scene) -> float:
    """Return how many times as fast waves are at most: so much shorter is an explicit step; at least 1."""
    stiffness = [[rope.segment_stiffness for rope in scene.ropes] for scene in (old, new)]
    return math.sqrt(max(1.0, *(b / a for a, b in zip(*stiffness, strict=True))))


def _spans(title: str, base: dict[str, float], variants: list[Variant]) -> list[str]:
    """Return from where to where forces and sag go with a guessed stiffness, in words.

    And what these leave out: an end that has no numbers, and ropes that part at one, which bear no more.
    """
    ran = [variant.numbers for variant in variants if not variant.why_not]
    found = []
    for name in (*_TOLD, "largest sag"):
        values = [numbers[name] for numbers in (base, *ran) if name in numbers]
        if ran and values and not any(map(math.isnan, values)):
            unit = "m" if name == "largest sag" else "N"
            ends = outwards(min(values), max(values))
            low, high = (prefixed(value, unit, 4) for value in ends)
            found.append(f"{name} {low}" + (f" to {high}" if high != low else ""))
    used, worst, both = (
        max((one[name] for one in (base, *ran) if not math.isnan(one[name])), default=math.nan)
        for name in (_USED, _WORST, _BOTH)
    )
    if ran and not math.isnan(used):
        found.append(f"{_USED} up to {percent_up(100.0 * used, 3)}{_factor(used)}")
    if ran and worst > used:
        found.append(f"{_WORST} up to {percent_up(100.0 * worst, 3)}{_factor(worst)}")
    if ran and both > used:
        found.append(f"{_BOTH} up to {percent_up(100.0 * both, 3)}{_factor(both)}")
    found += [f"of the {v.title} nothing, for it FAILED" for v in variants if v.why_not]
    found += [
        f"with the {v.title} a rope PARTS" for v in variants if v.numbers.get(PARTED, 0.0) > 0.0
    ]
    return [f"{title}, {', '.join(found)}"] if found else []


def _guess(scene: Scene) -> str:
    """Say whose stiffness is a guess."""
    names = [rope.name for rope in scene.ropes if set(STIFF) & set(guesses_of(rope.made_of))]
    which = ", ".join(map(repr, names[:_NAMED])) + (" and others" if len(names) > _NAMED else "")
    return f"The stiffness of {which} is a guess; over its range"


def _which(scene: Scene) -> str:
    """Say what was computed again, and how."""
    found = []
    for rope in scene.ropes:
        marks = guesses_of(rope.made_of)
        found += [
            f"{name} of {rope.name!r} {marks[name].span}".replace("_", " ")
            for name in STIFF
            if name in marks
        ]
    more = f"; and {len(found) - _NAMED} more" if len(found) > _NAMED else ""
    together = ", all of them at their least, then all at their greatest" if len(found) > 1 else ""
    return (
        f"Guessed: {'; '.join(found[:_NAMED])}{more}. Computed once more with both ends of that{together}; "
        "unstretched lengths stay as they are. What lies between the ends may exceed both."
    )
