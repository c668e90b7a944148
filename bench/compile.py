"""Processor time from an empty cache of kernels to the first step, in processes of their own.

One run of each: another program on the same processor makes it longer by up to a half, never shorter.
Python's own byte code is there, as after an installation.
"""

from __future__ import annotations

import atexit
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from functools import cache

from bench.row import Row

# Laws of nodes that no other file names: without another one the program does not start.
LAWS = ("air", "ground", "slide")

SCENE = """
import sys
import ropewalk as rw
from ropewalk.laws import registry
method, full, without = sys.argv[1], sys.argv[2] == "full", sys.argv[3]
if without:
    registry.NODE_LAWS = tuple(law for law in registry.NODE_LAWS if law.name != without)
    names = [law.name for law in registry.NODE_LAWS]
    registry.NodeTables = registry.namedtuple("NodeTables", names)
    registry.NodeArrays = registry.namedtuple("NodeArrays", names)
scene = rw.preset("r4")
scene = scene.replace(run=scene.run.replace(method=method, time_step="auto"))
if full:
    scene = scene.replace(limiter={"max_stretch": 1.5})
rw.Simulation(scene).advance_frames(1)
"""


@cache
def _own_byte_code() -> dict[str, str]:
    """Return settings of Python with which a run finds the byte code of all that it imports."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    own = {"PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
    command = [sys.executable, "-c", "import ropewalk; ropewalk.Simulation"]
    subprocess.run(command, check=True, env=os.environ | own)
    return own


def seconds(method: str, *, full: bool = False, without: str = "") -> float:
    """Return the processor time of a run of preset r4 for one frame [s], with all laws where `full`.

    Without one law of nodes where one is named.
    """
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-c", SCENE, method, "full" if full else "plain", without]
        own = _own_byte_code() | {"ROPEWALK_CACHE_DIR": folder}
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, env=os.environ | own)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def compile() -> list[Row]:  # noqa: A001 - the name of the case
    """Every kind of method, plain and with all laws, and what a law of nodes adds."""
    rows = []
    targets = {"semi-implicit-euler": ("<= 15", "<= 30")}
    for method in ("semi-implicit-euler", "implicit-euler", "esdirk3", "bdf2", "adaptive"):
        plain, full = targets.get(method, ("<= 45", "<= 45"))
        rows += [
            Row(f"first step of {method}, empty cache", seconds(method), "s", plain),
            Row(f"the same with every law, {method}", seconds(method, full=True), "s", full),
        ]
    whole = rows[1].value
    fewer = [seconds("semi-implicit-euler", full=True, without=name) for name in LAWS]
    rows.append(
        Row(
            "a law of nodes adds, mean of air, ground, slide",
            whole - sum(fewer) / len(fewer),
            "s",
            "<= 3",
        )
    )
    return rows
