"""What a sweep varies: paths of the scene, with names, units and the values or spreads given for them."""

from __future__ import annotations

import json
import math
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.record.quantities import BY_NAME
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.scene.overrides import Places
from ropewalk.scene.toml_text import as_value
from ropewalk.scene.units import WrongUnit, in_unit
from ropewalk.sweeps.derived import DERIVED

_PATH = re.compile(r"\w+(\[\w+\])?(\.\w+(\[\w+\])?)+|\w+\[\w+\]")
FLOAT, INT, TEXT = "float", "int", "text"
#: Names of a sweep's own variables and of dimensions, which no parameter may take.
RESERVED = {
    *(
        "run",
        "status",
        "notes",
        "reason",
        "broke_at",
        "done",
        "time",
        "node",
        "segment",
        "axis",
        "anchor",
    ),
    *("form", "law", "cause", "rope", "obstacle", "pulley", "wrap", "parameter", "quantile"),
    *("method", "tolerance", "drop"),  # words of xarray's `sel`
    *BY_NAME,  # what can be kept has these names
    *DERIVED,
}


@dataclass(frozen=True)
class Parameter:
    """One thing that a sweep varies.

    `values` are those of a grid or of given runs; `spread` is a frozen distribution, or (low, high).
    """

    path: str
    name: str  # of its dimension or coordinate
    unit: str
    long_name: str
    kind: str  # FLOAT, INT or TEXT: anything else, written as in TOML
    values: tuple[Any, ...] | None = None
    spread: Any = None

    @property
    def attributes(self) -> dict[str, str]:
        """What its coordinate says about itself."""
        about = {"path": self.path, "long_name": self.long_name}
        return about | ({"units": self.unit} if self.unit else {})

    def described(self) -> dict[str, Any]:
        """All of it but the values, as plain data."""
        return {
            "path": self.path,
            "name": self.name,
            "unit": self.unit,
            "long_name": self.long_name,
            "kind": self.kind,
            "spread": spread_in_words(self.spread) if self.spread is not None else None,
        }


def spread_in_words(spread: Any) -> str:
    """Return a distribution or a range as text: `norm(100000.0, 5000.0)`, `9.5 to 10.5`.

    With both ends where it has any: of scipy's `uniform` the second number is a width.
    """
    if isinstance(spread, tuple):
        return f"{spread[0]:.12g} to {spread[1]:.12g}"
    if isinstance(spread, _Inverse):
        return repr(spread.distribution)
    words = [f"{value!r}" for value in getattr(spread, "args", ())]
    words += [f"{name}={value!r}" for name, value in getattr(spread, "kwds", {}).items()]
    name = getattr(getattr(spread, "dist", None), "name", type(spread).__name__)
    low, high = spread.support() if hasattr(spread, "support") else (-np.inf, np.inf)
    ends = f": {low:.12g} to {high:.12g}" if np.isfinite([low, high]).all() else ""
    return f"{name}({', '.join(words)}){ends}"


@dataclass(frozen=True)
class _Inverse:
    """A distribution of scipy's newer kind, whose inverse has another name."""

    distribution: Any

    def ppf(self, share: Any) -> Any:
        """Return the values below which these shares lie."""
        return self.distribution.icdf(share)


def make_parameters(scene: Scene, vary: Any) -> tuple[Parameter, ...]:
    """Return the parameters that `vary` describes.

    Args:
        scene: that is varied.
        vary: mapping from paths (those of `--set`) to a list of values, a frozen distribution of
            scipy.stats, or a range (low, high); or a pandas DataFrame or an xarray Dataset of one
            dimension with a column per path: the runs themselves.

    Raises SceneError with every path and value that cannot be used.
    """
    given = _columns(vary)
    if not given:
        raise SceneError([Fault("vary", NO_VALUE, "is empty: name at least one path to vary")])
    places = Places(scene, given)
    _refuse_overlaps(places)
    faults: list[Fault] = []
    names = short_names(list(given))
    made = []
    for number, (path, what) in enumerate(given.items()):
        field, whole = places.field(number)
        extra = field.json_schema_extra
        unit = str(extra.get("unit", "")) if isinstance(extra, Mapping) else ""
        description = (field.description or whole).partition(":")[0].partition(";")[0]
        try:
            values, spread = _values_or_spread(path, without_units(path, what, unit))
            if values is not None and field.annotation is not str:
                values = _numbers_in_texts(values)
            kind = _kind(path, values, spread, field.annotation is int)
            if kind == INT and isinstance(spread, tuple):
                spread = _whole_range(path, *spread)
            if values is not None:
                values = tuple(as_kind(value, kind) for value in values)
        except SceneError as error:
            faults += error.faults
            continue
        about = {"unit": unit, "long_name": f"{description} ({path})", "kind": kind}
        made.append(Parameter(path, names[number], values=values, spread=spread, **about))
    if faults:
        raise SceneError(faults)
    return tuple(made)


def _columns(vary: Any) -> dict[str, Any]:
    """Return what is given for each path."""
    vary = as_table(vary)
    if hasattr(vary, "data_vars"):  # an xarray Dataset, perhaps the coordinates of another sweep
        used = used_columns(vary)
        _refuse_a_grid(used)
        return {str(v.attrs.get("path", k)): np.atleast_1d(v.values) for k, v in used.items()}
    if hasattr(vary, "columns") and hasattr(vary, "iloc"):  # a pandas DataFrame
        return {str(name): vary[name].to_numpy() for name in vary.columns}
    if not isinstance(vary, Mapping):
        rule = "must be a mapping from paths to values, a DataFrame, or a Dataset"
        raise SceneError([Fault("vary", type(vary).__name__, rule)])
    return {str(path): what for path, what in vary.items()}


def as_table(vary: Any) -> Any:
    """Return a DataArray as the Dataset of one column that it is, anything else as it came."""
    if hasattr(vary, "data_vars") or not (hasattr(vary, "dims") and hasattr(vary, "coords")):
        return vary
    name = vary.attrs.get("path", vary.name)
    if name is None:
        rule = 'is a column without a path: name it by one, such as array.rename("rope.made_of.EA")'
        raise SceneError([Fault("vary", "a DataArray", rule)])
    return vary.rename(name).to_dataset()


def used_columns(vary: Any) -> dict[Any, Any]:
    """Return the columns of a Dataset that are parameters: those with a path or named by one, or else all."""
    columns = {name: vary[name] for name in (*vary.data_vars, *vary.coords)}
    with_path = {
        k: v
        for k, v in columns.items()
        if "path" in v.attrs or (k in vary.data_vars and is_path_like(k))
    }
    return with_path or {str(name): vary[name] for name in vary.data_vars}


def is_path_like(name: Any) -> bool:
    """Tell whether a name can only be meant as a path of the scene: of several steps."""
    return _PATH.fullmatch(str(name)) is not None


def _refuse_a_grid(used: Mapping[Any, Any]) -> None:
    """Refuse parameters along dimensions of their own: paired, they would give a few of the grid's runs."""
    along = {dim for column in used.values() for dim in column.dims}
    if len(along) > 1:
        names = ", ".join(sorted(map(str, along)))
        rule = (
            f"has parameters along {names}; the runs need one dimension. Give a grid as a mapping from "
            "paths to lists, or stack it"
        )
        raise SceneError([Fault("vary", "a Dataset", rule)])


def gives_runs(vary: Any) -> bool:
    """Tell whether `vary` holds the runs themselves."""
    vary = as_table(vary)
    return hasattr(vary, "data_vars") or (hasattr(vary, "columns") and hasattr(vary, "iloc"))


def _refuse_overlaps(places: Places) -> None:
    """Refuse two paths that write to one place: the later one would win, unseen."""
    faults = []
    for number, path in enumerate(places.paths):
        for earlier in range(number):
            if places.overlap(number, earlier):
                rule = f"changes what {places.paths[earlier]} changes too; keep one of them"
                faults.append(Fault(path, NO_VALUE, rule))
    if faults:
        raise SceneError(faults)


def without_units(path: str, what: Any, unit: str) -> Any:
    """Return a range or values with texts such as "12 mm" as numbers of `unit`; anything else as it is."""
    if hasattr(what, "__array__") and np.asarray(what).dtype.kind in "OUT":  # a column of a table
        what = np.atleast_1d(np.asarray(what)).tolist()
    if not unit or not isinstance(what, list | tuple) or not any(isinstance(v, str) for v in what):
        return what
    found = [in_unit(value, unit) if isinstance(value, str) else value for value in what]
    wrong = next((one for one in found if isinstance(one, WrongUnit)), None)
    if wrong is not None:
        raise SceneError([Fault(path, wrong.given, wrong.rule)])
    found = [as_value(one) if isinstance(one, str) else one for one in found]  # a bare number
    if any(isinstance(one, str) for one in found):  # a word among them, such as "auto"
        return what
    return tuple(found) if isinstance(what, tuple) else found


def _values_or_spread(path: str, what: Any) -> tuple[tuple[Any, ...] | None, Any]:
    if hasattr(what, "ppf") or hasattr(what, "icdf"):
        return None, _distribution(path, what)
    if isinstance(what, tuple):
        numbers = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in what)
        if len(what) != 2 or not numbers or not np.isfinite(what).all() or what[0] > what[1]:
            rule = "a tuple is a range (low, high) to sample from; values of a grid are a list"
            if len(what) == 2 and numbers and what[0] > what[1]:
                rule = f"a range begins with its low end: {what[1]:.12g}..{what[0]:.12g}"
            raise SceneError([Fault(path, list(what), rule)])
        return None, (what[0], what[1])
    if hasattr(what, "__array__"):  # numpy, pandas, xarray
        what = np.atleast_1d(np.asarray(what)).tolist()
    if isinstance(what, (str, bytes)) or not isinstance(what, Iterable):
        rule = (
            "must be a list of values, a range (low, high), or a frozen scipy.stats distribution; "
            "a value that stays the same belongs into the scene"
        )
        raise SceneError([Fault(path, what, rule)])
    values = tuple(item.item() if isinstance(item, np.generic) else item for item in what)
    if not values:
        raise SceneError([Fault(path, [], "has no values; give at least one")])
    return values, None


def _distribution(path: str, what: Any) -> Any:
    """Return a distribution with the inverse `ppf`. Raises SceneError for one that cannot be drawn from."""
    if isinstance(what, type) or hasattr(what, "freeze"):
        name = what.__name__ if isinstance(what, type) else what.name
        rule = (
            f"is the distribution {name} without its parameters; give them, as in "
            "scipy.stats.norm(1e5, 5e3) or scipy.stats.Normal(mu=1e5, sigma=5e3)"
        )
        raise SceneError([Fault(path, NO_VALUE, rule)])
    found = what if hasattr(what, "ppf") else _Inverse(what)
    middle = np.asarray(found.ppf(0.5))
    if middle.shape != () or not np.isfinite(middle):
        rule = (
            "is no distribution of one number: its parameters must be single numbers, in the range that "
            "scipy.stats allows (a scale, such as a standard deviation, must be positive)"
        )
        raise SceneError([Fault(path, NO_VALUE, rule)])
    return found


def _whole_range(path: str, low: float, high: float) -> tuple[int, int]:
    """Return the least and the largest whole number of a range. Raises SceneError where it has none."""
    least, largest = math.ceil(low), math.floor(high)
    if least > largest:
        beside = f"{math.floor(low)} and {math.ceil(high)} are next to it"
        rule = f"has no whole number, which is needed there; {beside}"
        raise SceneError([Fault(path, [low, high], rule)])
    return least, largest


def _numbers_in_texts(values: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return "1e4" as the number that it is, as of a column that was read from a text file."""
    found = tuple(as_value(v) if isinstance(v, str) else v for v in values)
    if any(isinstance(v, bool) or not isinstance(v, (int, float)) for v in found):
        return values
    return found


def _kind(path: str, values: Sequence[Any] | None, spread: Any, whole: bool) -> str:
    if values is None:
        return INT if whole else FLOAT
    if all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in values):
        if whole and all(float(value).is_integer() for value in values):
            return INT
        if whole and (broken := [v for v in values if not float(v).is_integer()]):
            raise SceneError([Fault(path, v, "must be a whole number") for v in broken])
        return FLOAT
    if all(isinstance(value, (str, int, float, list, tuple, bool)) for value in values):
        return TEXT
    rule = "must be numbers, texts, true or false, or vectors [x, y, z]"
    raise SceneError([Fault(path, list(values)[:3], rule)])


def as_kind(value: Any, kind: str) -> Any:
    """Return a value as its column holds it."""
    if kind == FLOAT:
        return float(value)
    if kind == INT:
        return int(value)
    if isinstance(value, str):
        return value
    return json.dumps(value)  # TOML reads numbers, vectors and true as JSON writes them


def short_names(paths: Sequence[str]) -> list[str]:
    """Return a name for every path: its last keys, as few as tell it from the others."""
    parts = [re.sub(r"\[(\d+)\]", r"_\1", path).replace("-", "_").split(".") for path in paths]
    names = [_last(keys, 1) for keys in parts]
    for count in range(2, max(map(len, parts)) + 1):
        often = Counter(names)
        again = [often[name] > 1 or name in RESERVED for name in names]
        if not any(again):
            break
        names = [
            _last(k, count) if more else name
            for k, more, name in zip(parts, again, names, strict=True)
        ]
    return [f"run_{name}" if name in RESERVED else name for name in names]


def _last(keys: Sequence[str], count: int) -> str:
    return "_".join(keys[-count:])
