"""A page in the browser, driven and looked at through its hook `window.ropewalk`; nothing sleeps."""

from __future__ import annotations

import io
import json
import time
from typing import Any

import numpy as np
from PIL import Image

from patience import PATIENCE

FLAGS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--no-first-run",
    "--host-resolver-rules=MAP rebound.test 127.0.0.1",  # as DNS rebinding does
]
_HARMLESS = ("WebSocket connection to", "GL Driver Message", "net::ERR_")
# Notices go by themselves after some seconds: what they said is kept.
_HEAR = """() => {
  window.heard = [];
  new MutationObserver((changes) => {
    for (const { addedNodes } of changes)
      for (const { firstChild } of addedNodes) window.heard.push(firstChild.textContent);
  }).observe(document.querySelector(".notices"), { childList: true });
}"""
_TELL = """(command) => {
  const { session } = window.ropewalk;
  return session.ask(command).then(
    ({ frame }) => frame,
    (fault) => { session.emit("error", fault); return -1; },
  );
}"""


class Window:
    """One page."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.faults: list[str] = []
        page.set_default_timeout(PATIENCE * 1000.0)
        page.on("pageerror", lambda error: self.faults.append(str(error)))
        page.on("console", self._heard)

    def _heard(self, message: Any) -> None:
        if message.type == "error" and not any(one in message.text for one in _HARMLESS):
            self.faults.append(message.text)

    def ask(self, expression: str) -> Any:
        """Evaluate with `r`, the hook."""
        return self.page.evaluate(f"() => {{ const r = window.ropewalk; return {expression}; }}")

    def until(self, expression: str, seconds: float = PATIENCE) -> Any:
        """Wait until an expression of `r` holds; return it. The page allows no `eval`, so it is asked."""
        # what is not there yet (a frame of a new layout, its time NaN) is not yet true; here NaN would be
        body = f"try {{ return (r && ({expression})) || null; }} catch {{ return null; }}"
        script = f"() => {{ const r = window.ropewalk; {body} }}"
        end = time.monotonic() + seconds
        while not (found := self.page.evaluate(script)):
            if time.monotonic() > end:
                raise AssertionError(f"waited in vain for {expression}\n{self.situation()}")
            self.page.wait_for_timeout(25)
        return found

    def situation(self) -> str:
        """Say what the page is at, for messages of failure."""
        said = self.ask(
            "[...document.querySelectorAll('.notice, .banner')].map((e) => e.innerText)"
        )
        return f"state {self.ask('r.state')}, time {self.ask('r.time')} s, {said}, {self.faults}"

    def ready(self) -> Window:
        """Wait for the first picture."""
        self.until("r.frames > 0 && r.drawn > 0 && r.state !== 'waiting'")
        self.page.evaluate(_HEAR)
        return self

    def tell(self, **command: Any) -> bool:
        """Send a command as the page does; tell whether it was done, once the page has the frame with it."""
        frame = self.page.evaluate(_TELL, command)
        self.until(f"r.frame >= {frame}")
        return bool(frame >= 0)

    def caught_up(self) -> None:
        """Wait for the frame with all that was told the server so far: answers and states come before it."""
        on = self.ask("r.app.controls.hearing.sound.on")
        if self.ask("r.session.connection === 'open' && r.session.can('listen')"):
            self.tell(type="listen", on=on)  # changes nothing

    def heard(self, text: str) -> None:
        """Wait until a notice has said a text, though it may be gone; then forget what was said."""
        self.until(f"window.heard.some((one) => one.includes({json.dumps(text)}))")
        self.page.evaluate("() => { window.heard.length = 0; }")

    def node(self, node: int, variant: int = 0) -> np.ndarray:
        """Where a node is [m]."""
        return np.array(self.ask(f"r.nodeAt({node}, {variant})"))

    def screen(self, node: int | str) -> tuple[float, float]:
        """Where a node, or the one that an expression of `r` names, is in the window [CSS pixels]."""
        place = self.ask(f"r.screenOf({node})")
        return place["x"], place["y"]

    def drag(self, start: tuple[float, float], by: tuple[float, float]) -> None:
        """Press, move; the button stays down."""
        mouse = self.page.mouse
        mouse.move(*start)
        mouse.down()
        for part in (0.3, 0.6, 1.0):
            mouse.move(start[0] + part * by[0], start[1] + part * by[1])

    def take(self, node: int, by: tuple[float, float]) -> tuple[float, float]:
        """Drag a node that may move, and return where it was taken hold of: while the scene plays the
        rope or the camera may go on before the button is down, and who missed presses again."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            start = self.screen(node)
            self.drag(start, by)
            if self.ask("r.viewport.marks.held.size") > 0:
                return start
            self.page.mouse.up()
        raise AssertionError(f"no hand on node {node}\n{self.situation()}")

    def settled(self, *, anew: bool = True) -> None:
        """Wait until what is drawn is the newest frame, unmoving. `anew`: one that is made for that, in
        which no time has passed, so that no peak is seen."""
        if anew:
            self.caught_up()
        still = self.page.evaluate(
            """() => new Promise((done) => {
                let [last, same, frames] = [-1, 0, 0];
                const look = () => {
                  const r = window.ropewalk;
                  const moves = r.viewport.flight || r.viewport.renderer.rough || r.app.labels?.later;
                  same = r.drawn === last && !moves ? same + 1 : 0;
                  last = r.drawn;
                  if (same > 8 || ++frames > 1200) done(same > 8);
                  else requestAnimationFrame(look);
                };
                look();
            })"""
        )
        assert still, f"the picture never rests\n{self.situation()}"

    def picture(self) -> np.ndarray:
        """Return what the window shows, (height, width, 3)."""
        return np.asarray(Image.open(io.BytesIO(self.page.screenshot())).convert("RGB")).astype(int)

    def painted(self) -> bool:
        """Tell whether the canvas is painted: at its upper edge there is sky or floor."""
        box = self.page.locator("#view").bounding_box()
        ratio = self.page.evaluate("() => devicePixelRatio")
        row, first, last = (
            round(ratio * one)
            for one in (
                box["y"] + 3,
                box["x"] + 0.3 * box["width"],
                box["x"] + 0.7 * box["width"],
            )
        )
        inks = "['background', 'horizon', 'ground'].map((name) => [...r.viewport.theme[name]])"
        papers = 255.0 * np.array(self.ask(inks))  # where the camera looks down there is floor
        seen = self.picture()[row, first:last]
        away = np.abs(seen[:, None] - papers[None]).max(axis=2)
        return bool(away.min() < 12)

    def press(self, *keys: str) -> None:
        """Press keys, one after another."""
        for key in keys:
            self.page.keyboard.press(key)

    def click(self, selector: str) -> None:
        """Click an element."""
        self.page.locator(selector).click()

    def at_rope(self, nodes: range, down: int = 0) -> float:
        """Return which part of these nodes has, within 3 pixels, a colour of the rope's map.

        `down`: look so many pixels below.
        """
        picture = self.picture()
        back = self.ask("r.viewport.theme.background").copy()
        paper = np.array(back) * 255.0 if max(back) <= 1.0 else np.array(back)
        ratio = self.page.evaluate("() => devicePixelRatio")
        found = 0
        for node in nodes:
            x, y = (round(ratio * value) for value in self.screen(node))
            row = y + down
            around = picture[row - 3 : row + 4, x - 3 : x + 4].reshape(-1, 3)
            spread = around.max(axis=1) - around.min(axis=1)  # paper and grid are nearly grey
            far = np.abs(around - paper[:3]).sum(axis=1)
            found += bool(((spread > 60) & (far > 150)).any())
        return found / len(nodes)
