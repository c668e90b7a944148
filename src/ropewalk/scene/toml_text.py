"""Scenes as TOML: reading, writing, the JSON Schema."""

from __future__ import annotations

import math
import re
import tomllib
from contextlib import suppress
from pathlib import Path
from typing import Any

from ropewalk.scene.faults import NO_VALUE, Fault, SceneError, SceneFileError
from ropewalk.scene.scene import Scene
from ropewalk.scene.units import TEXT_SCHEMA

#: A list of three numbers, which tomli_w writes on five lines. Texts hold no line breaks there.
_NUMBERS = re.compile(r"\[\n((?:\s*[-+.\w]+,\n){3})\s*\]")
#: Numbers that TOML has not, and people type.
_SHORT_NUMBER = re.compile(r"[+-]?(?:\d+\.|\.\d+)(?:[eE][+-]?\d+)?")
#: No scene is larger; a file that is, is something else.
NO_FILE = "no such file"
_LARGEST_FILE = 500_000_000


def load(path: str | Path) -> Scene:
    """Read a scene file from a ``path``; file names in it are relative to its folder.

    Raises:
        SceneFileError: when it cannot be read or is no TOML (with line and column).
        SceneError: with every fault of the scene.
    """
    path = Path(path)
    return _scene(_read(path), str(path), path.parent)


def loads(text: str, source: str | None = None, *, folder: str | Path = ".") -> Scene:
    """Read a scene from TOML text.

    Args:
        text: the TOML.
        source: what errors call the text, such as a file name.
        folder: what file names in the text are relative to.

    Raises:
        SceneFileError: when it is no TOML (with line and column).
        SceneError: with every fault of the scene.
    """
    return _scene(text, source, Path(folder))


def dumps(scene: Scene) -> str:
    """The scene as TOML; ``loads(dumps(scene)) == scene``, bit for bit in every number."""
    import tomli_w

    return _NUMBERS.sub(_one_line, tomli_w.dumps(scene.table()))


def save(scene: Scene, path: str | Path) -> None:
    """Write the scene as a TOML file at a ``path``, in place of one that is there.

    Raises:
        SceneFileError: when the file cannot be written.
    """
    path = Path(path)
    text = dumps(scene)
    partial = path.with_name(path.name + ".partial")
    try:
        partial.write_text(text, encoding="utf-8", newline="\n")
        partial.replace(path)
    except OSError as error:
        with suppress(OSError):
            partial.unlink()
        reason = f"cannot be written: {error.strerror or error}"
        raise SceneFileError([Fault("", NO_VALUE, reason)], str(path)) from None


def _one_line(found: re.Match[str]) -> str:
    return "[" + ", ".join(found[1].replace(",", " ").split()) + "]"


def schema() -> dict[str, Any]:
    """The JSON Schema of the scene format (draft 2020-12), for editors and other tools."""
    made = Scene.model_json_schema(by_alias=True)
    finite: dict[str, Any] = _without_infinity(made)
    whole: dict[str, Any] = _as_read(finite, None)
    whole["$defs"]["Quantity"] = TEXT_SCHEMA
    return {"$schema": "https://json-schema.org/draft/2020-12/schema"} | whole


def _without_infinity(node: Any) -> Any:
    """Drop infinite defaults, bounds and null branches, which neither JSON nor TOML can write."""
    if isinstance(node, list):
        return [_without_infinity(item) for item in node if item != {"type": "null"}]
    if not isinstance(node, dict):
        return node
    kept = {
        key: _without_infinity(value)
        for key, value in node.items()
        if not (isinstance(value, float) and math.isinf(value))
        and not (key == "default" and value is None)
    }
    if len(kept.get("anyOf", ())) == 1:
        kept |= kept.pop("anyOf")[0]
    return kept


#: Names of bounds that pydantic leaves as they are in parts of lists, and what they are in a schema.
_BOUNDS = {
    "ge": ("minimum", max),
    "gt": ("exclusiveMinimum", max),
    "le": ("maximum", min),
    "lt": ("exclusiveMaximum", min),
}
_OF_NUMBERS = ("type", "minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum")


def _as_read(node: Any, unit: str | None) -> Any:
    """Give numbers with a unit the texts that stand for them, and bounds of parts of lists their names."""
    if isinstance(node, list):
        return [_as_read(item, unit) for item in node]
    if not isinstance(node, dict):
        return node
    own = node.get("unit")
    unit = own if isinstance(own, str) else unit
    made = {key: _as_read(value, unit) for key, value in node.items()}
    kind = made.get("type")
    if kind in ("number", "integer"):
        for name, (bound, stricter) in _BOUNDS.items():
            if name in made:
                value = made.pop(name)
                made[bound] = stricter(value, made.get(bound, value))
    if kind == "array":
        for name in ("min", "max"):
            if f"{name}Length" in made:
                made[f"{name}Items"] = made.pop(f"{name}Length")
    if kind != "number" or unit is None:
        return made
    number = {key: made.pop(key) for key in _OF_NUMBERS if key in made}
    return made | {"anyOf": [number, {"$ref": "#/$defs/Quantity"}]}


def _read(path: Path) -> str:
    try:
        if path.stat().st_size > _LARGEST_FILE:
            raise _unreadable(path, "is too large for a scene file (500 MB at most)")
        return path.read_bytes().decode("utf-8-sig")
    except FileNotFoundError:
        raise _unreadable(path, NO_FILE) from None
    except IsADirectoryError:
        raise _unreadable(path, "is a folder, not a scene file") from None
    except PermissionError:
        raise _unreadable(path, "no permission to read it") from None
    except UnicodeDecodeError:
        raise _unreadable(path, "is not a text file (a scene is TOML in UTF-8)") from None
    except (OSError, ValueError) as error:
        raise _unreadable(path, f"cannot be read: {error}") from None


def _unreadable(path: Path, reason: str) -> SceneFileError:
    return SceneFileError([Fault("", NO_VALUE, reason)], str(path))


def _scene(text: str, source: str | None, folder: Path) -> Scene:
    try:
        table = tomllib.loads(text)
    except (
        ValueError,
        RecursionError,
    ) as error:  # ValueError: also of numbers with too many digits
        raise SceneFileError([_syntax(text, error)], source) from None
    if not table:
        raise SceneFileError([Fault("", NO_VALUE, "is empty: a scene needs a [[rope]]")], source)
    try:
        return Scene.model_validate(table, context={"folder": str(folder)})
    except SceneError as error:
        raise SceneError(error.faults, source) from None


_WORDS = {  # of tomllib, in words that say what to do
    "Cannot overwrite a value": "this is there already; a list of tables has double brackets, as "
    "[[anchor]]",
    "Illegal character '\\n'": "a text must end on its own line; a quotation mark is missing",
}


def _in_words(message: str) -> str:
    return _WORDS.get(message, message)


def _is_short_number(lines: list[str], column: int) -> bool:
    """Whether a number such as .5 or 5. begins, or goes on, at a column of the first line."""
    line = lines[0] if lines else ""
    before, rest = line[:column][-1:], line[column:]
    if before.isdigit():
        return re.match(r"\.(?!\d)", rest) is not None
    return re.match(r"[+-]?\.\d", rest) is not None


def _syntax(text: str, error: Exception) -> Fault:
    """A TOML syntax error as a fault whose path is the line and column."""
    if "\0" in text:
        return Fault("", NO_VALUE, "is not a text file (a scene is TOML)")
    if isinstance(error, RecursionError):
        return Fault("", NO_VALUE, "TOML: lists or tables nest too deep to be read")
    message = str(error)
    found = re.search(r" \(at line (\d+), column (\d+)\)$", message)
    if found:
        place = f"line {found[1]}, column {found[2]}"
        words = _in_words(message[: found.start()])
        if _is_short_number(text.splitlines()[int(found[1]) - 1 :], int(found[2]) - 1):
            words = "a number has a digit before its point and one after it, such as 0.5 or 5.0"
        return Fault(place, NO_VALUE, f"TOML: {words}")
    if not isinstance(error, tomllib.TOMLDecodeError):
        long = re.search(r"\d[\d_]{4000,}", text)
        line = text.count("\n", 0, long.start()) + 1 if long else 1
        return Fault(f"line {line}", NO_VALUE, "has a number of more digits than can be read")
    lines = text.splitlines() or [""]
    place = f"line {len(lines)}, column {len(lines[-1]) + 1}"
    return Fault(
        place, NO_VALUE, f"TOML: {message.removesuffix(' (at end of document)')} (at the end)"
    )


def as_value(text: str) -> Any:
    """The value that a text stands for: TOML where it is, or a number such as .5, else the text itself."""
    if _SHORT_NUMBER.fullmatch(text):
        return float(text)
    try:
        table = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):  # ValueError: also of numbers with too many digits
        return text
    return table["value"] if len(table) == 1 else text
