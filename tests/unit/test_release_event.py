"""The event of a release tells when the anchor let go: steps are cut there, but for one method."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Straight


@pytest.mark.parametrize(
    ("method", "release", "let_go"),
    [
        ("esdirk3", 0.101, 0.101),
        ("esdirk3", 0.1, 0.1),
        ("verlet", 0.1005, 0.1005),
        ("semi-implicit-euler", 0.1005, None),
        ("adaptive", 0.101, 0.101),
    ],
)
def test_the_event_has_the_time_at_which_the_anchor_let_go(
    method: str, release: float, let_go: float | None
) -> None:
    cord = Material(EA=2000.0, mass_per_length=0.05, axial_damping=1.0)
    rope = Rope(segments=5, length=1.0, made_of=cord, shape=Straight(end=(1.0, 0.0, 0.0)))
    ends = [Anchor(node=0), Anchor(node=-1, name="end", release_time=release)]
    run = RunSettings(method=method, time_step=1.0 / 60.0 if method == "esdirk3" else "auto")
    result = rw.simulate(Scene(ropes=[rope], anchors=ends, run=run.replace(duration=0.2)))
    (event,) = (one for one in result.events if one["event"] == "released")
    if let_go is None:
        dt = result.plan.dt
        let_go = float(np.ceil(release / dt - 1e-6)) * dt
        assert let_go > release
    assert event["time"] == pytest.approx(let_go, rel=1e-12)
    still = np.linalg.norm(result.velocities[:, -1], axis=1) == 0.0
    first = int(np.flatnonzero(~still)[0])  # the first frame in which it has moved
    assert result.time[first - 1] <= event["time"] + 1e-9 < result.time[first] + 1e-6
