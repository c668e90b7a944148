"""The lab keeps its proportions in a window that changes, though its time stands."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from ropewalk.lessons import lesson_scene
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


@pytest.mark.browser
@pytest.mark.parametrize(("size", "whole"), [((1440, 900), True), ((1280, 720), False)])
def test_all_that_is_read_of_a_post_is_in_sight(
    tmp_path: Path, open_window: Any, size: tuple[int, int], whole: bool
) -> None:
    """The last readings lay below the end of the panel; where it is lower, only what is set does."""
    path = write_lab(tmp_path / "post.html", [lesson_scene("post")])
    page = open_window(path.as_uri(), viewport={"width": size[0], "height": size[1]}).page
    page.evaluate("window.ropewalkLab.lab.advance(50); window.ropewalkLab.lab.draw()")
    last = page.locator("#numbers dd").last.bounding_box()
    assert page.locator("#numbers dt").last.inner_text() == "taken by the post"
    assert last["y"] + last["height"] < size[1] - 20
    over = page.evaluate(
        "(({scrollHeight: a, clientHeight: b}) => a - b)(document.querySelector('aside'))"
    )
    assert (over <= 0) == whole
    page.locator("#sound").scroll_into_view_if_needed()  # and it scrolls
    box = page.locator("#sound").bounding_box()
    assert box["y"] + box["height"] < size[1]
