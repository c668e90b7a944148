"""What a slow computer says on an upright phone, clear of what ropes hang from."""

from __future__ import annotations

import pytest

from browser.test_pictures import PHONE, TOO_SLOW, Open, Serve
from browser.window import Window
from ropewalk.live.session import Session
from ropewalk.scene.presets import preset

pytestmark = pytest.mark.browser


def box(window: Window, selector: str) -> dict[str, float]:
    """Return where something is on the page [CSS pixels]."""
    found = window.page.locator(selector).bounding_box()
    assert found is not None, selector
    return dict(found)


def test_on_an_upright_phone_it_covers_no_drum_and_no_card(open_window: Open, serve: Serve) -> None:
    """It lay over the drum of a crane, whose rope is framed up to the tools."""
    window = open_window(serve(Session(preset("crane-snap"))).address, **PHONE).ready()
    window.page.evaluate(TOO_SLOW)
    window.settled()
    note = box(window, "#slow")
    for i in range(21):
        place = window.screen(i)
        across = note["x"] - 12 < place[0] < note["x"] + note["width"] + 12
        assert not (across and note["y"] - 12 < place[1] < note["y"] + note["height"] + 12), i
    scene, legend = box(window, "#scene"), box(window, ".legend")
    assert note["x"] >= legend["x"] + legend["width"]
    assert note["x"] + note["width"] <= scene["x"] + scene["width"]
    assert note["y"] + note["height"] <= scene["y"] + scene["height"]
