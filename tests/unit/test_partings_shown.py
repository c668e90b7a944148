"""What a rope that parted looks like outside: in figures and VTK files there is no rope across the gap."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.collections import LineCollection

import ropewalk as rw
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import Recorder, record_run
from ropewalk.sweeps.derived import DERIVED
from verification.test_parting import pulled, string

SEGMENTS = 8
PULLED = pulled(segments=SEGMENTS, axial_damping=0.5)


@pytest.fixture(scope="module")
def result() -> Result:
    made = rw.simulate(PULLED)
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


class Killed(BaseException):
    """Stands for the end of the process."""


@pytest.mark.parametrize("scene", [PULLED, string("adaptive", load=10.0)], ids=["pulled", "at 0 s"])
def test_a_killed_run_tells_of_no_parting_beyond_its_frames(
    scene: rw.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All was simulated and logged, and nothing committed but the first frame: it told of a parting that no
    frame has. Resumed it parts once, as the twin that was never killed. One that is overloaded from the start
    parts with `adaptive` after the frame of that very time: its log was called damaged.
    """
    folder, result = tmp_path / "run", rw.simulate(scene)
    (parting,) = result.partings
    assert parting.time == 0.0 or scene is PULLED

    def killed(recorder: Recorder, status: str) -> None:
        raise Killed

    with monkeypatch.context() as patch:
        patch.setattr(Recorder, "commit", killed)
        with pytest.raises(Killed):
            record_run(scene, folder, commit_seconds=1e9)
    assert '"rope parted"' in (folder / "events.jsonl").read_text()
    early = rw.open(folder)
    assert (early.frames, early.status) == (1, "interrupted")
    assert early.partings == ()
    assert [event["event"] for event in early.events] == ["started"]
    assert early.table["segments parted"] == 0
    whole = resume_run(folder)
    assert whole.partings == result.partings
    gone = (result.rest_length == 0.0).sum(axis=1)
    np.testing.assert_array_equal(DERIVED["segments_parted"].of(result), gone)
    assert sum(event["event"] == "rope parted" for event in whole.events) == 1
