"""No edit in the live view waits for the compiler: it calls what the start of the session has called."""

from __future__ import annotations

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
print(sorted({event.data["dispatcher"].py_func.__name__ for _, event in made.buffer}))
"""


@pytest.mark.skipif(PLAIN, reason="nothing is compiled")
@pytest.mark.parametrize("edit", ['"cut", segment=12', '"unpin", node=20'])
def test_an_edit_compiles_nothing(edit: str) -> None:
    """The first cut of every process froze the view for 20 to 50 s: its kernel was kept nowhere."""
    program = [sys.executable, "-c", PROGRAM.replace("EDIT", edit)]
    tests = Path(__file__).resolve().parents[1]
    done = subprocess.run(program, stdout=subprocess.PIPE, text=True, check=True, cwd=tests)
    assert done.stdout.strip() == "[]"
