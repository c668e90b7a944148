"""Pydantic's errors as plain sentences with TOML paths."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from pydantic import ValidationError

from ropewalk.scene.faults import MISSING, NO_VALUE, Fault, join
from ropewalk.scene.limits import MOST_TOLD, TINY
from ropewalk.scene.paths import (
    ModelType,
    Place,
    all_sections,
    by_tag,
    keys,
    kind_of,
    place,
    siblings,
    tag,
)
from ropewalk.words.nearest import nearest


def faults_of(model: ModelType, error: ValidationError) -> list[Fault]:
    """The faults that pydantic found in a model, in the order of the fields; of very many the first."""
    faults: list[Fault] = []
    items = error.errors(include_url=False)
    for item in items[:MOST_TOLD]:
        faults += _faults(model, item)
    if len(items) > MOST_TOLD:
        faults.append(
            Fault("", NO_VALUE, f"and {len(items) - MOST_TOLD} more faults, not told here")
        )
    meant = {_meant(fault) for fault in faults}
    return [fault for fault in faults if fault.value is not MISSING or fault.path not in meant]


def _meant(fault: Fault) -> str | None:
    """The path that an unknown key was meant for: no need to say that it is missing too."""
    found = re.search(r'^unknown key.*did you mean "(.*)"', fault.rule)
    return join(fault.path.rpartition(".")[0], found[1]) if found else None


def _faults(model: ModelType, item: Mapping[str, Any]) -> Sequence[Fault]:
    kind, value, context = item["type"], item["input"], item.get("ctx") or {}
    where = place(model, item["loc"])
    if kind == "unit":
        return [Fault(where.path, context["given"], context["rule"])]
    if kind == "faults":
        return [fault.below(where.path) for fault in context["faults"]]
    if kind == "missing":
        return [Fault(where.path, MISSING, _needed(where))]
    if kind == "extra_forbidden":
        return [Fault(where.path, NO_VALUE, _unknown(where, str(item["loc"][-1])))]
    if kind in ("union_tag_invalid", "union_tag_not_found"):
        return [_wrong_kind(where, value)]
    if kind in ("too_short", "too_long", "missing_positional_only_argument"):
        least = context.get("min_length", 0)
        if isinstance(value, (list, tuple)) and len(value) >= least and kind == "too_short":
            return []  # what was wrong with its items has a sentence of its own
        return [Fault(where.path, value, _length(context, where, value))]
    if isinstance(value, float) and not math.isfinite(value):
        kind = "finite_number"  # whatever bound it broke first
    rule = _RULES.get(kind)
    if rule is None:
        return [Fault(where.path, value, str(item["msg"]))]
    return [Fault(where.path, value, rule(context, where, value))]


def _needed(where: Place) -> str:
    """What a missing key is for."""
    field = where.field
    if field is None or not field.description:
        return "is needed"
    text = field.description
    return (
        f"is needed: {text[0].lower() + text[1:] if not text[:2].isupper() else text}{_unit(where)}"
    )


def _unit(where: Place) -> str:
    extra = where.field.json_schema_extra if where.field is not None else None
    unit = extra.get("unit") if isinstance(extra, Mapping) else None
    return f" ({unit})" if unit not in (None, "1") else ""


def _unknown(where: Place, key: str) -> str:
    """What to say of an unknown key: the nearest known one, or the section it belongs to."""
    owner = where.owner
    if key in keys(owner) or key in owner.model_fields:
        return "is given already, by its name in Python; leave out one of the two"
    if meant := _MEANT.get((tag(owner) or "", key)):
        return f'unknown key of {tag(owner)!r}; did you mean "{meant}"?'
    others = [repr(tag(one)) for one in siblings(owner) if key in keys(one)]
    if others:
        have = "has" if len(others) == 1 else "have"
        return f"unknown key of {tag(owner)!r}; only {', '.join(others)} {have} it"
    if key in _NOT_BUILT:
        return _NOT_BUILT[key]
    homes = [join(path, key) for path, model in all_sections() if key in keys(model)]
    home = next((path for path in homes if path.count(".") <= 1), None)
    if home is not None and key != "kind":
        rule = f'unknown key here; it belongs to "{home}"'
        if "[" in where.path:  # no key of the top that came behind a header: there is more to tell
            rule += f"; this one has {', '.join(keys(owner))}"
        return rule
    kind = tag(owner)
    of = f" of {kind!r}" if kind else ""
    return f"unknown key{of}; {nearest(key, list(keys(owner)))}"


def _finite(context: Mapping[str, Any], where: Place, value: Any) -> str:
    """What to say of a number that is none, or infinite where it may not be."""
    if where.field is not None and where.field.default == math.inf and math.isnan(value):
        return f"must be a number{_unit(where)}, or inf for never"
    if where.path.rpartition(".")[2] == "friction" and value == math.inf:
        return "must be a finite number; what never slips has a large one, such as 10"
    return f"must be a finite number{_unit(where)}"


def _wrong_kind(where: Place, value: Any) -> Fault:
    models = kind_of(where.field).models if where.field is not None else ()
    tags = [name for name in map(tag, models) if name]
    path = join(where.path, "kind")
    given = value.get("kind", MISSING) if isinstance(value, Mapping) else MISSING
    rule = "must be one of " + ", ".join(f'"{name}"' for name in tags)
    if isinstance(given, str) and by_tag(models, given) is None:
        close = nearest(given, tags)
        rule += f"; {close}" if close.startswith("did") else ""
    return Fault(path, given, rule)


def _length(context: Mapping[str, Any], where: Place, value: Any) -> str:
    least, most = context.get("min_length"), context.get("max_length")
    if re.search(r"\bfaces\[\d+\]$", where.path) and isinstance(value, (list, tuple)):
        more = "; cut what has more corners into triangles" if len(value) > 3 else ""
        return f"must have three vertices, and has {len(value)}{more}"
    return f"must have at least {least}" if most is None else f"must have at most {most}"


def _at_least(context: Mapping[str, Any], _: Place, value: Any) -> str:
    bound = context["ge"]
    if bound == TINY and value <= 0:
        return "must be greater than 0"
    return f"must be at least {bound:g}"


def _one_of(context: Mapping[str, Any], where: Place, value: Any) -> str:
    allowed = re.findall(r"'([^']*)'", str(context.get("expected", "")))
    rule = "must be one of " + ", ".join(f'"{name}"' for name in allowed)
    close = nearest(value, allowed) if isinstance(value, str) else ""
    return f"{rule}; {close}" if close.startswith("did") else rule


def _header(where: Place) -> str:
    """How the header of a table names a place: without the numbers of list items."""
    return re.sub(r"\[\d+\]", "", where.path)


def _table(_: Mapping[str, Any], where: Place, value: Any) -> str:
    if isinstance(value, (list, tuple)):
        header = _header(where)
        return f"must be one table: write [{header}], not [[{header}]]"
    return "must be a table of keys and values"


def _list(_: Mapping[str, Any], where: Place, value: Any) -> str:
    field = where.field
    if field is not None and kind_of(field).models:
        header = _header(where)
        return f"must be a list of tables: write [[{header}]], not [{header}]"
    return f"must be a list{_unit(where)}"


#: Keys that a scene might have, and has not: why, and what comes nearest.
_NOT_BUILT = {
    "restitution": "there is none here, but of obstacles, and of ropes on ropes in [contact]: a [ground] "
    "throws back by its spring, the less the larger its damping_ratio; leave it out",
}
#: What other parts call what a part has by another name.
_MEANT = {
    ("knot", "axis"): "normal",
    ("knot", "direction"): "along",
    ("knot", "position"): "center",
    ("knot", "radius"): "post_radius",
}
_Rule = Callable[[Mapping[str, Any], Place, Any], str]
_RULES: dict[str, _Rule] = {
    "float_type": lambda c, w, v: f"must be a number{_unit(w)}",
    "int_type": lambda c, w, v: "must be a whole number",
    "bool_type": lambda c, w, v: "must be true or false",
    "string_type": lambda c, w, v: 'must be text in quotes, such as "rope"',
    "finite_number": _finite,
    "greater_than": lambda c, w, v: f"must be greater than {c['gt']:g}",
    "greater_than_equal": _at_least,
    "less_than": lambda c, w, v: f"must be less than {c['lt']:g}",
    "less_than_equal": lambda c, w, v: f"must be at most {c['le']:g}",
    "literal_error": _one_of,
    "model_type": _table,
    "model_attributes_type": _table,
    "dict_type": _table,
    "tuple_type": _list,
    "vector": lambda c, w, v: f"must be a list of three numbers, [x, y, z]{_unit(w)}",
    "string_too_short": lambda c, w, v: "must not be empty",
    "string_too_long": lambda c, w, v: f"must be at most {c['max_length']} characters",
    "string_pattern_mismatch": lambda c, w, v: (
        "must start with a letter and have only letters, digits, _ and -"
    ),
}
