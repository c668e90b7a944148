"""A copy of the package with one more law, from a file outside of it, and what it does there."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import ropewalk

HERE, PACKAGE = Path(__file__).parent, Path(ropewalk.__file__).parent
LIST = "laws/registry.py"
_IMPORT = "from ropewalk.laws.node_law import NodeLaw\n"


@dataclass(frozen=True)
class Sample:
    """A law that a copy of the package may have beside its own.

    Attributes:
        name: that of its file in the copy, and in capitals that of the law.
        law: its file in this folder.
        script: of this folder, what runs with it and prints what it found.
        entry: what stands in the registry, and what is to stand there.
    """

    name: str
    law: str
    script: str
    entry: tuple[str, str]

    @property
    def text(self) -> str:
        """The text of its file."""
        return (HERE / self.law).read_text(encoding="utf-8")

    def copied(self, folder: Path, text: str | None = None) -> Path:
        """Copy the package's sources with the law, or with another text of it; return where they lie."""
        target = folder / "ropewalk"
        ignored = shutil.ignore_patterns("__pycache__", "page", "*.js")
        shutil.copytree(PACKAGE, target, ignore=ignored)
        (target / "laws" / f"{self.name}.py").write_text(text or self.text, encoding="utf-8")
        listed = (target / LIST).read_text(encoding="utf-8")
        assert listed.count(_IMPORT) == 1
        assert listed.count(self.entry[0]) == 1
        more = f"{_IMPORT}from ropewalk.laws.{self.name} import {self.name.upper()}\n"
        listed = listed.replace(_IMPORT, more).replace(*self.entry)
        (target / LIST).write_text(listed, encoding="utf-8")
        return folder

    def wrong(self, folder: Path) -> Path:
        """Copy the package with a tangent of 0.8 of what it should be."""
        wrong_law = self.text.replace("TRUE_SHARE = 1.0", "TRUE_SHARE = 0.8")
        assert wrong_law != self.text
        return self.copied(folder, wrong_law)

    def run(self, folder: Path, what: str, *, compiled: bool = False) -> Any:
        """Return what the script prints with the package of a folder."""
        more = {"PYTHONPATH": str(folder), "NUMBA_DISABLE_JIT": "0" if compiled else "1"}
        more["ROPEWALK_CACHE_DIR"] = str(folder / "cache")
        found = subprocess.run(
            [sys.executable, "-W", "ignore", HERE / self.script, what],
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
