"""The lab keeps its proportions in a window that changes, though its time stands."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from ropewalk.live.lab import write_lab

STRETCHED = """() => [...document.querySelectorAll("canvas")]
  .filter((one) => one.width !== one.clientWidth || one.height !== one.clientHeight)
  .map(({ id }) => id)"""


@pytest.mark.browser
def test_a_paused_lab_is_drawn_anew_when_it_is_turned(tmp_path: Path, open_window: Any) -> None:
    path = write_lab(tmp_path / "lab.html")
    window = open_window(path.as_uri(), viewport={"width": 390, "height": 844})
    box = "[document.querySelector('#rope').clientWidth, document.querySelector('#rope').clientHeight]"
    upright = window.ask(box)
    window.page.set_viewport_size({"width": 844, "height": 390})
    window.page.evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => "
        "requestAnimationFrame(() => setTimeout(done))))"
    )
    assert window.ask(box) != upright  # the twin: it is of another shape now
    assert window.page.evaluate(STRETCHED) == []
