"""The progress bar: every part of it can be read, on narrow terminals, too."""

from __future__ import annotations

import io
import re

import numpy as np
import pytest
from rich.console import Console

from ropewalk.cli import console, progress
from ropewalk.scene.presets import preset
from ropewalk.simulation import Simulation


def drawn(monkeypatch: pytest.MonkeyPatch, width: int) -> str:
    """Return the last line of a run's bar on a terminal of so many columns, after half of 20 frames."""
    screen = io.StringIO()
    made = Console(file=screen, width=width, force_terminal=True, no_color=True, highlight=False)
    monkeypatch.setattr(console, "console", lambda *, stderr: made)
    monkeypatch.setattr(progress, "terminal", lambda: True)
    scene = preset("r4").replace(name="A rope with a name that is a little long")
    simulation = Simulation(scene)
    with progress.RunProgress(scene) as bar:
        for done in (5, 10):
            bar(done, 20, simulation.advance_frames(5))
    lines = [line for line in re.split(r"[\r\n]", screen.getvalue()) if "%" in line]
    return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", lines[-1])


@pytest.mark.parametrize("width", [60, 80, 100, 120, 200])
def test_it_can_be_read(monkeypatch: pytest.MonkeyPatch, width: int) -> None:
    line = drawn(monkeypatch, width)
    assert len(line) <= width
    assert line.startswith("A rope with a nam")
    bar = re.search("([━╸╺]+ *) 50 % ", line)  # without colours the rest of it is blank
    assert bar is not None
    assert len(bar[1]) >= 12
    end = 20 * preset("r4").run.frame_interval
    assert f"/{end:.4g} s" in line
    assert ("real time" in line) == (width >= 70)
    assert ("energy" in line) == (width >= 110)
    assert re.search(r"(\d+:\d\d|-:--)$", line.rstrip())  # time left
    assert line.count("…") <= 1  # only the name is cut


def test_facts_are_short_for_long_runs() -> None:
    facts = progress.facts_of(123456.789, 1e6, 1234.5, np.nan, 80)
    assert len(facts) <= 40
