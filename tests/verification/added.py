"""A copy of the package with one more law, from a file outside of it, and what it does there."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import ropewalk

HERE, PACKAGE = Path(__file__).parent, Path(ropewalk.__file__).parent
LIST = "laws/registry.py"
_IMPORT = "from ropewalk.laws.node_law import NodeLaw\n"


def copy_with(folder: Path, law: str, name: str, entry: tuple[str, str]) -> Path:
    """Copy the package's sources with a law beside its own, and return where they lie.

    Args:
        folder: where to.
        law: the text of its file.
        name: that of the file, and in capitals that of the law.
        entry: what stands in the registry, and what is to stand there.
    """
    target = folder / "ropewalk"
    shutil.copytree(PACKAGE, target, ignore=shutil.ignore_patterns("__pycache__", "page", "*.js"))
    (target / "laws" / f"{name}.py").write_text(law, encoding="utf-8")
    text = (target / LIST).read_text(encoding="utf-8")
    assert text.count(_IMPORT) == 1
    assert text.count(entry[0]) == 1
    text = text.replace(
        _IMPORT, f"{_IMPORT}from ropewalk.laws.{name} import {name.upper()}\n"
    ).replace(*entry)
    (target / LIST).write_text(text, encoding="utf-8")
    return folder


def run(folder: Path, script: str, what: str, *, compiled: bool = False) -> Any:
    """Return what a script of this folder prints with the package of a folder."""
    more = {"PYTHONPATH": str(folder), "NUMBA_DISABLE_JIT": "0" if compiled else "1"}
    more["ROPEWALK_CACHE_DIR"] = str(folder / "cache")
    found = subprocess.run(
        [sys.executable, "-W", "ignore", HERE / script, what],
        env=os.environ | more,
        capture_output=True,
        text=True,
        check=False,
    )
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


def touched(package: Path) -> tuple[list[str], dict[str, int]]:
    """Return the files that a copy has besides, and in how many lines others differ."""
    new, lines = [], {}
    for path in package.glob("ropewalk/**/*.py"):
        name = path.relative_to(package / "ropewalk")
        if not (PACKAGE / name).exists():
            new.append(str(name))
        elif (mine := path.read_text()) != (theirs := (PACKAGE / name).read_text()):
            lines[str(name)] = len(set(mine.splitlines()) - set(theirs.splitlines()))
    return new, lines
