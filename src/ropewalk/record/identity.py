"""What decides the bits of a run: the sources of the engine, numpy, numba, and the scene.

Comments, docstrings and layout do not count: the hash of a source is one of its syntax tree.
"""

from __future__ import annotations

import ast
import hashlib
import json
import warnings
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from ropewalk.core.cache import PACKAGE, cache_root
from ropewalk.record.errors import RunError
from ropewalk.record.files import write

FOLDERS = (
    "core",
    "laws",
    "methods",
    "motions",
    "theory",
    "scene",
    "library",
    "knots",
    "words",
    "lowering",
    "statics",
    "vibration",
    "engine",
    "hands",
    "simulation",
)
#: ... and what puts a state back, and decides who goes on after a break.
FILES = ("record/checkpoint.py", "record/resume.py", "record/run.py", "record/simulate.py")
REMEMBERED = (
    "sources.json"  # hashes of syntax trees by those of their files; parsing takes a second
)
MOST_REMEMBERED = 2000


def sources() -> list[Path]:
    """Return the files that decide what a run computes."""
    found = [path for folder in FOLDERS for path in sorted((PACKAGE / folder).rglob("*.py"))]
    return found + [PACKAGE / name for name in FILES]


@cache
def source_hash() -> str:
    """Return a hash of all sources that decide what a run computes."""
    remembered = _remembered()
    digest, found = hashlib.sha256(), {}
    for path in sources():
        data = path.read_bytes()
        key = _short(data)
        found[key] = remembered.get(key) or meaning(data)
        digest.update(f"{path.relative_to(PACKAGE).as_posix()} {found[key]}\n".encode())
    if not found.keys() <= remembered.keys():
        _remember({**(remembered if len(remembered) < MOST_REMEMBERED else {}), **found})
    return digest.hexdigest()[:16]


def meaning(source: bytes) -> str:
    """Return a hash of what Python makes of a source: the same in every version of Python."""
    return _short(repr(_told(ast.parse(source))).encode())


def _told(node: Any) -> Any:
    if isinstance(node, list):
        return [_told(item) for item in node if not _is_text(item)]
    if not isinstance(node, ast.AST):
        return node
    fields = [(name, value) for name, value in ast.iter_fields(node) if value not in (None, [])]
    return type(node).__name__, [(name, _told(value)) for name, value in fields]


def _is_text(node: Any) -> bool:
    """Whether it is a statement that is nothing but a text: a docstring."""
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def _short(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:16]


def _remembered() -> dict[str, str]:
    try:
        found = json.loads((cache_root() / REMEMBERED).read_bytes())
        said, known = found["hash"], found["known"]
    except (OSError, ValueError, RecursionError, KeyError, TypeError):
        return {}
    return known if said == _short(json.dumps(known).encode()) else {}


def _remember(known: dict[str, str]) -> None:
    value = {"hash": _short(json.dumps(known).encode()), "known": known}
    with suppress(OSError):  # where nothing can be kept, the sources are parsed each time
        cache_root().mkdir(parents=True, exist_ok=True)
        write(cache_root() / REMEMBERED, json.dumps(value).encode())


def check_same(folder: Path, made_with: dict[str, Any], force: bool) -> None:
    """Check `source_hash` and the versions of numpy and numba that a run was made with.

    Where they are others it may not go on to the same bits: a warning with `force`, else a RunError.
    """
    import numba
    import numpy as np

    here = {"numpy": np.__version__, "numba": numba.__version__}
    others = [
        f"{name} {made_with.get(name)} (here: {version})"
        for name, version in here.items()
        if made_with.get(name) != version
    ]
    if made_with.get("source_hash") != source_hash():
        others.append("other sources of ropewalk")
    if not others:
        return
    begun = f"begun with {' and '.join(others)}"
    if not force:
        rule = (
            f"was {begun}, so it would not go on to the same bits; resume it with what it was begun "
            "with, or force it"
        )
        raise RunError(folder, rule)
    warnings.warn(f"{folder}: {begun}; it may not go on to the same bits", stacklevel=3)
