"""What a faulty scene gets: every fault at once, each as one plain sentence."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass

_LONGEST_VALUE = 60


class _NoValue:
    """Marks a fault that has no value to show (a missing file, a syntax error)."""

    def __repr__(self) -> str:
        return "no value"

    def __reduce__(self) -> str:
        return "NO_VALUE"


class _Missing(_NoValue):
    """Marks a fault about a key that should be there and is not."""

    def __repr__(self) -> str:
        return "missing"

    def __reduce__(self) -> str:
        return "MISSING"


#: The rule that a vector of no length breaks where a direction is asked for.
NO_DIRECTION = (
    "must not be zero: give a vector of any length that points that way, such as [0, 0, 1]"
)
NO_VALUE = _NoValue()
MISSING = _Missing()


@dataclass(frozen=True)
class Fault:
    """One thing wrong with a scene.

    Attributes:
        path: where, as written in TOML: ``rope[0].segments``; empty for the whole file.
        value: what stands there (``MISSING`` for an absent key, ``NO_VALUE`` for none to show).
        rule: what is allowed, in words.
    """

    path: str
    value: object
    rule: str

    def __str__(self) -> str:
        if isinstance(self.value, _NoValue) and not isinstance(self.value, _Missing):
            return f"{self.path}: {self.rule}" if self.path else self.rule
        shown = show(self.value)
        return f"{self.path}: {shown} - {self.rule}" if self.path else f"{shown} - {self.rule}"

    def below(self, prefix: str) -> Fault:
        """The same fault, its path seen from further up: ``segments`` -> ``rope[0].segments``."""
        return Fault(join(prefix, self.path), self.value, self.rule)


class SceneError(ValueError):
    """A scene that cannot be used.

    Attributes:
        faults: all that is wrong, in the order of the scene.
        source: the file (or other origin) of the scene, or None when it was made in Python.
    """

    def __init__(self, faults: Iterable[Fault], source: str | None = None) -> None:
        self.faults: list[Fault] = list(faults)
        self.source = source
        super().__init__(self._text())

    def _text(self) -> str:
        prefix = f"{self.source}: " if self.source else ""
        return "\n".join(prefix + str(fault) for fault in self.faults)

    def __reduce__(self) -> tuple[type, tuple[list[Fault], str | None]]:
        return type(self), (self.faults, self.source)


@contextmanager
def found_in(source: str | None) -> Iterator[None]:
    """Give a file's name to what is found wrong with its scene only when that is built."""
    try:
        yield
    except SceneError as error:
        if source is not None and error.source is None:
            raise SceneError(error.faults, source) from None
        raise


class SceneFileError(SceneError):
    """A scene file that cannot be read, written or parsed at all."""


def join(prefix: str, path: str) -> str:
    """Put two TOML paths together: ``rope[0]`` and ``segments`` give ``rope[0].segments``."""
    if not prefix or not path:
        return prefix or path
    return prefix + path if path.startswith("[") else f"{prefix}.{path}"


def show(value: object) -> str:
    """A value as TOML would write it, shortened to one line."""
    text = _toml_like(value)
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 3] + "..."


def _toml_like(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        body = value[: 2 * _LONGEST_VALUE].encode("unicode_escape").decode("ascii")
        body = body if not value.isprintable() else value[: 2 * _LONGEST_VALUE]
        return '"' + body.replace('"', '\\"') + '"'
    if isinstance(value, int):
        return str(value) if abs(value) < 10**_LONGEST_VALUE else "a whole number of many digits"
    if isinstance(value, float):
        return repr(float(value)) if math.isfinite(value) else str(value)  # not np.float64(1.0)
    if isinstance(value, (list, tuple)):
        items = [_toml_like(item) for item in value[:20]]
        return "[" + ", ".join(items) + (", ..." if len(value) > 20 else "") + "]"
    if isinstance(value, Mapping):
        pairs = (f"{key} = {_toml_like(item)}" for key, item in list(value.items())[:8])
        return "{" + ", ".join(pairs) + "}"
    return repr(value)
