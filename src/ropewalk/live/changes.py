"""What was changed since a scene was loaded: the constants to set, in an order in which none undoes another.

What was asked for in turn will not do: of a rope in 80 segments the spring constant was set, then it was cut
into 40 again, which halves it. So what is kept is what leads from the scene as it was loaded to the one as it
is, whatever way it went.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from ropewalk.live.parameters import CHOICE, LONGEST_BASE, METHOD, PARAMETERS, Parameter, refusal
from ropewalk.scene import Scene, SceneError
from ropewalk.words.prefixes import prefixed

Key = tuple[str, str | None]  # parameter, rope; None: all ropes
_FIRST = ("segments", "length")  # others change with them
_OF_A_PIECE = ("mass", "length", "segments")  # which half a rope has half of
LONGEST_LABEL = 80  # letters
_SAME = 1e-9  # relative; nearer numbers are one


def changes_between(loaded: Scene, scene: Scene, asked: Mapping[Key, Any]) -> dict[Key, Any]:
    """Return the constants to set in the scene as loaded, so that it has those of the present one.

    `asked` is what was asked for: of the method's numbers only these are looked at. Where ropes are no more
    those that were loaded, it is what was asked for.
    """
    if [rope.name for rope in loaded.ropes] != [rope.name for rope in scene.ropes]:
        return dict(asked)
    made, found = loaded, dict[Key, Any]()
    try:
        for parameter in _in_order({name for name, _ in asked}):
            for rope, value in _apart(parameter, made, scene):
                key = (parameter.name, rope)
                found[key] = asked[key] if key in asked and same(asked[key], value) else value
                made = parameter.apply(made, found[key], rope)
    except SceneError:  # the way there is barred: some are only possible together
        return dict(asked)
    return found


def _in_order(asked: set[str]) -> list[Parameter]:
    """Return the parameters to compare: what others change with, what was asked for, all else."""
    order = [*_FIRST, *(name for name in PARAMETERS if name in asked), *PARAMETERS]
    found = [PARAMETERS[name] for name in dict.fromkeys(order)]
    return [one for one in found if one.group != METHOD or one.name in asked]


def _apart(parameter: Parameter, made: Scene, scene: Scene) -> Iterator[tuple[str | None, Any]]:
    """Yield the ropes, None for all, on which two scenes differ in a parameter, with the second's value."""
    if not parameter.per_rope:
        now = parameter.get(scene, 0)
        if not same(parameter.get(made, 0), now):
            yield None, now
        return
    values = [parameter.get(scene, i) for i in range(len(scene.ropes))]
    apart = [i for i, now in enumerate(values) if not same(parameter.get(made, i), now)]
    if apart and all(same(one, values[0]) for one in values):
        yield None, values[0]
        return
    for i in apart:
        yield scene.ropes[i].name, values[i]


def same(one: Any, other: Any) -> bool:
    """Tell whether two values of a parameter are the same but for rounding."""
    if isinstance(one, (tuple, list)) and isinstance(other, (tuple, list)):
        return len(one) == len(other) and all(map(same, one, other))
    numbers = (int, float)
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, numbers) and isinstance(other, numbers):
        return math.isclose(one, other, rel_tol=_SAME, abs_tol=0.0)
    return bool(one == other)


def label_of(changes: Mapping[str, Any], of_ropes: Mapping[tuple[str, str], Any] = {}) -> str:
    """Return what a variant differs in, in words, as "Mass 3 kg"; "" for nothing.

    `of_ropes` by parameter and rope: "Mass of line 3 kg".
    """
    told = [_told(PARAMETERS[name], value) for name, value in changes.items()]
    told += [_told(PARAMETERS[name], value, rope) for (name, rope), value in of_ropes.items()]
    return ", ".join(told)[:LONGEST_LABEL]


def _told(parameter: Parameter, value: Any, rope: str = "") -> str:
    what = f"{parameter.label} of {rope}" if rope else parameter.label
    if parameter.kind == CHOICE:
        return f"{what} {value}" if rope else str(value)
    if isinstance(value, bool):
        return f"{what} {'yes' if value else 'no'}"
    unit = "" if parameter.unit == "1" else parameter.unit
    if isinstance(value, (list, tuple)):
        return f"{what} ({', '.join(map(_plain, value))}) {unit}".rstrip()
    if isinstance(value, (int, float)):
        bare = not unit or unit.startswith("kg")  # k is in it already
        return f"{what} {f'{_plain(value)} {unit}' if bare else prefixed(value, unit)}".rstrip()
    return f"{what} {value}"


def _plain(value: float) -> str:
    """Return a number of four figures, whole ones of all, without a prefix or an exponent to read."""
    return str(value) if isinstance(value, int) else f"{float(f'{value:.4g}'):.10g}"


def origin(loaded: Scene, rope: str) -> int | None:
    """Return the index of the rope as loaded that a rope is, or is a piece of; None where there is none."""
    names = [one.name for one in loaded.ropes]
    if rope in names:
        return names.index(rope)
    found = [name for name in names if rope.startswith(f"{name[:LONGEST_BASE]}-")]
    return names.index(max(found, key=len)) if found else None


def loaded_value(parameter: Parameter, loaded: Scene, rope: str) -> Any:
    """Return the value of a rope in the scene as loaded.

    Raises SceneError for what a piece of a cut rope has of its own.
    """
    index = origin(loaded, rope)
    if index is None or (parameter.name in _OF_A_PIECE and loaded.ropes[index].name != rope):
        rule = f"a piece of a cut rope has no {parameter.label.lower()} of the scene's"
        raise refusal("rope", rope, rule)
    return parameter.get(loaded, index)
