"""A graph tells no more than it was told: between frames that are far apart its line is broken."""

from __future__ import annotations

import pytest

from browser.window import Window

pytestmark = pytest.mark.browser

GAPS = "r.app.graphs.panels.get('energies').plot.uplot.series[1]._paths.gaps.length"
SAMPLES = "r.app.graphs.panels.get('energies').plot.uplot.data[0].length"


def test_a_line_is_broken_where_frames_are_far_apart(window: Window) -> None:
    window.press("g")
    frame = window.ask("r.session.status.steps_per_frame")
    for k in range(1, 4):
        assert window.tell(type="step", count=frame)
        window.until(f"r.session.frame.steps === {k * frame}")
    window.settled()
    assert window.until(SAMPLES) >= 4  # a slow computer shows parts of frames
    assert window.ask(GAPS) == 0  # the twin: frame after frame
    window.ask("void (r.app.graphs.take = () => {})")  # a page that is busy elsewhere
    assert window.tell(type="step", count=60 * frame)
    window.until(f"r.session.frame.steps === {63 * frame}")
    window.ask("void delete r.app.graphs.take")
    assert window.tell(type="step", count=frame)
    window.until(f"r.session.frame.steps === {64 * frame}")
    window.settled()
    assert window.ask(GAPS) == 1
