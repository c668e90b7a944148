"""No edit in the live view waits for the compiler: it calls what the start of the session has called."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from ropewalk.core.jit import PLAIN

# In a process of its own, as other tests may have had it compiled here; the start of a session may compile.
PROGRAM = """
from live.drive import do, r4
from numba.core.event import install_recorder

session = r4()
session.advance(40)
with install_recorder("numba:compile") as made:
    do(session, EDIT)
    session.advance(40)
print(*{event.data["dispatcher"].py_func.__name__ for _, event in made.buffer})
"""


# It copies the addresses in one named tuple: 40 ms for each kind of tuple, on disk from then on.
COPIES = "_kept"


@pytest.mark.skipif(PLAIN, reason="nothing is compiled")
@pytest.mark.parametrize("edit", ['"cut", segment=12', '"unpin", node=20'])
def test_an_edit_compiles_nothing(edit: str, tmp_path: Path) -> None:
    """The first cut of every process froze the view for 20 to 50 s: its kernel was kept nowhere."""
    assert compiled_by(edit, tmp_path) <= {COPIES}
    assert compiled_by(edit, tmp_path) == set()


def compiled_by(edit: str, cache: Path) -> set[str]:
    """Return the kernels that an edit has compiled in a process of its own, with a cache of its own."""
    program = [sys.executable, "-c", PROGRAM.replace("EDIT", edit)]
    tests = Path(__file__).resolve().parents[1]
    at = dict(os.environ, ROPEWALK_CACHE_DIR=str(cache))
    done = subprocess.run(program, stdout=subprocess.PIPE, text=True, check=True, cwd=tests, env=at)
    return set(done.stdout.split())
