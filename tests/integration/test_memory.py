"""The memory of a run does not grow with its duration."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

CHILD = """
import json, re, sys
import runs
from ropewalk import run
scene = runs.hanging(segments=999, frame_rate=500.0, duration=float(sys.argv[2]))
result = run(scene, sys.argv[1])
# not getrusage: its peak comes over from the process that was forked
status = open("/proc/self/status").read()
peak = int(re.search(r"VmHWM:\\s+(\\d+) kB", status).group(1)) / 1024.0
print(json.dumps({"frames": result.frames, "nodes": result.nodes, "peak": peak}))
"""


def peak_of(folder: Path, duration: float) -> dict[str, float]:
    """Run 1000 nodes for a duration [s] in a process of its own; return its peak memory [MB]."""
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    done = subprocess.run(
        [sys.executable, "-c", CHILD, str(folder), str(duration)],
        capture_output=True,
        text=True,
        check=True,
        env=env,
    )
    found: dict[str, float] = json.loads(done.stdout)
    return found


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="reads its peak memory from /proc")
def test_a_run_needs_no_more_memory_when_it_is_longer(tmp_path: Path) -> None:
    """The program takes its share (it grows with the kernels there are), blocks of frames theirs."""
    short = peak_of(tmp_path / "short", 0.4)
    half = peak_of(tmp_path / "half", 20.0)
    long = peak_of(tmp_path / "long", 40.0)
    assert (long["nodes"], long["frames"]) == (1000, 20001)
    stored = sum(path.stat().st_size for path in (tmp_path / "long").rglob("*") if path.is_file())
    more = stored / 1e6 / 2.0  # what the second half of the run has written [MB]
    assert more > 150.0
    assert long["peak"] < half["peak"] + 0.03 * more
    # two blocks of frames of 24 MB, one of them waits to be written
    assert long["peak"] < short["peak"] + 80.0
