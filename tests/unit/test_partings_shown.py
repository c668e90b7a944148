"""What a rope that parted looks like outside: in figures and VTK files there is no rope across the gap."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.collections import LineCollection

import ropewalk as rw
from ropewalk.record.result import Result
from verification.test_parting import pulled

SEGMENTS = 8


@pytest.fixture(scope="module")
def result() -> Result:
    made = rw.simulate(pulled(segments=SEGMENTS, axial_damping=0.5))
    assert len(made.partings) == 1
    assert made.time[0] < made.partings[0].time < made.time[-1]
    return made


def test_figures_leave_it_out(result: Result) -> None:
    gone = result.partings[0].segment
    whole = rw.simulate(pulled(segments=SEGMENTS, axial_damping=0.5, parts=False))
    for one, drawn in ((result, SEGMENTS - 1), (whole, SEGMENTS)):
        axes = one.plot.forces().axes[0]
        (ropes,) = (made for made in axes.collections if isinstance(made, LineCollection))
        assert len(ropes.get_segments()) == drawn
    found = []
    for line in result.plot.shape().axes[0].lines:
        x = np.asarray(line.get_xdata(), dtype=float)
        if x.size == SEGMENTS + 2 and np.isnan(x).any():
            found += list(np.flatnonzero(np.isnan(x)))
    assert set(found) == {gone + 1}  # one place more than nodes: the gap


def test_vtk_has_no_cell_for_it(result: Result, tmp_path: Path) -> None:
    result.export("vtk", tmp_path / "vtk")
    cells = {}
    for path in (tmp_path / "vtk" / "frames").iterdir():
        (count,) = re.findall(r'NumberOfLines="(\d+)"', path.read_text(errors="ignore"))
        cells[path.name] = int(count)
    parted = result.time > result.partings[0].time
    counts = [cells[name] for name in sorted(cells)]
    assert counts == [SEGMENTS - int(one) for one in parted]
