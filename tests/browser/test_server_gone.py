"""What a page offers once its server has ended: nothing that needs it, and one word about that."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from browser.window import Window
from live.drive import slack_rope
from ropewalk.live.serve import ViewServer
from ropewalk.live.session import Session

pytestmark = pytest.mark.browser

Open, Serve = Callable[..., Window], Callable[..., ViewServer]
GONE = "r.session.connection === 'ended'"
TOUCHING = """(() => {
  const [banner, ...bars] = ["#banner", ...document.querySelectorAll(".toolbar")].map((one) =>
    (one.getBoundingClientRect ? one : document.querySelector(one)).getBoundingClientRect());
  return bars.some((bar) => banner.top < bar.bottom && banner.bottom > bar.top &&
    banner.left < bar.right && banner.right > bar.left);
})()"""


@pytest.mark.parametrize("size", [(844, 390), (390, 844)])
def test_what_needs_the_server_is_not_offered(
    open_window: Open, serve: Serve, size: tuple[int, int]
) -> None:
    """Play was bright, Keep had links and files, every key brought a word, and the banner lay on tools."""
    server = serve(Session(slack_rope(20)))
    viewport = dict(zip(("width", "height"), size, strict=True))
    window = open_window(server.address, viewport=viewport).ready()
    play, keep = window.page.locator("#play"), window.page.locator("#open-keep")
    assert play.is_enabled()
    keep.click()
    assert window.page.locator("#keep-link").is_visible()  # the twin
    assert window.page.locator("#keep-scene-toml").is_visible()
    window.press("Escape")
    server.stop()
    window.until(GONE)
    assert window.page.locator("#banner").is_visible()
    assert not window.ask(TOUCHING)
    assert play.is_disabled()
    window.ask("document.activeElement.blur()")  # else a space presses the button of the menu
    for key in (" ", "r", " "):
        window.press(key)
    window.settled()
    assert window.page.locator(".notice").all_inner_texts() == []
    keep.click()
    assert window.page.locator("#keep-png").is_visible()
    for name in ("link", "scene-toml", "save"):
        assert window.page.locator(f"#keep-{name}").count() == 0
