"""The live view's page in headless Chromium without a GPU: frames, script time, drags, start, memory.

`draw calls skipped` shows the script's own cost, `software drawing` what such a machine shows.
"""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from bench.live import ropes
from bench.row import Row
from ropewalk import Scene, save

WARM_UP, SECONDS = 4.0, 6.0
DRAGS = 30
MINUTES = 10
FLAGS = ["--no-sandbox", "--no-first-run"]
WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]  # WebGL without a GPU
NO_GPU = ["--disable-gpu"]  # as a machine without WebGL draws its pages
SKIP_DRAWS = """
for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced"])
  WebGL2RenderingContext.prototype[name] = () => {};
"""
# The clock runs from the pointer event's own time stamp to the end of the first picture that shows node 0
# half a pixel away; its anchor moves by the hand alone.
# When the first picture was there; asked by a clock that two processes share, and of the page itself, since
# a browser that is asked all the time is a slow one.
WATCH_START = """
const look = () => {
  if ((window.ropewalk?.drawn ?? 0) > 0) window.started = performance.timeOrigin + performance.now();
  else requestAnimationFrame(look);
};
requestAnimationFrame(look);
"""
WATCH_DRAGS = """() => {
  const { stage } = window.ropewalk;
  const drags = (window.drags = { armed: false, since: null, from: null, waits: [] });
  const place = () => stage.screenOf(0);
  addEventListener("pointerrawupdate", (event) => {
    if (!drags.armed) return;
    Object.assign(drags, { armed: false, since: event.timeStamp, from: place() });
  }, true);
  stage.afterDraw.push(() => {
    if (drags.since === null) return;
    const now = place();
    if (Math.hypot(now.x - drags.from.x, now.y - drags.from.y) < 0.5) return;
    drags.waits.push(performance.now() - drags.since);
    drags.since = null;
  });
}"""


def page() -> list[Row]:
    """Ten ropes of 100 and of 1000 nodes, drawn three ways; drags; from the command to a picture."""
    rows = []
    targets = {
        ("draw calls skipped", 100): (">= 45", ""),
        ("software drawing", 100): (">= 25", ""),
        ("Canvas 2D", 100): (">= 50", ""),
        ("draw calls skipped", 1000): ("", "<= 2.5"),
    }
    for way in ("draw calls skipped", "software drawing", "Canvas 2D"):
        with chromium(NO_GPU if way == "Canvas 2D" else WEBGL) as browser:
            with shown(browser, ropes(1, 20), way):
                pass  # warm: a browser's first page with WebGL waits a second for its own drawing process
            for nodes in (100, 1000):
                with shown(browser, ropes(10, nodes), way) as (window, _, start):
                    frames, script = _frames(window)
                    name = f"page, 10 x {nodes}, {way}"
                    of_frames, of_script = targets.get((way, nodes), ("", ""))
                    rows.append(Row(f"{name}: frames", frames, "1/s", of_frames))
                    rows.append(Row(f"{name}: script", script, "ms/frame", of_script))
                    if nodes == 100:
                        waits = _drags(window)
                        wait = statistics.median(waits)
                        rows.append(Row(f"{name}: drag to picture, median", wait, "ms", "<= 35"))
                        rows.append(Row(f"{name}: command to picture", start, "s", "< 3"))
    return rows


def page_memory() -> list[Row]:
    """Ten minutes of play: growth of page and server after the first minute."""
    canvas = "Canvas 2D"
    with chromium(NO_GPU) as browser, shown(browser, ropes(10, 100), canvas) as (window, server, _):
        time.sleep(60.0)
        before = _heap(window), _resident(server)
        time.sleep(60.0 * (MINUTES - 1))
        after = _heap(window), _resident(server)
    return [
        Row(f"{what}, growth in {MINUTES - 1} min", (new - old) / 1e6, "MB", "0")
        for what, old, new in zip(("page's heap", "server's memory"), before, after, strict=True)
    ]


@contextmanager
def chromium(flags: list[str]) -> Iterator[Any]:
    """Start the browser with flags for how it draws."""
    from playwright.sync_api import sync_playwright

    program = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=FLAGS + flags)
        yield browser
        browser.close()


@contextmanager
def shown(browser: Any, scene: Scene, way: str) -> Iterator[tuple[Any, int, float]]:
    """Serve a scene and open it; give the page, the server's process, and the time that took [s]."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        save(scene, path)
        words = ["view", str(path), "--no-browser", "--no-save", "--port", "0"]
        context = browser.new_context(viewport={"width": 900, "height": 600})
        window = context.new_page()  # as the user's browser, which is open already
        if way == "draw calls skipped":
            window.add_init_script(SKIP_DRAWS)
        window.add_init_script(WATCH_START)
        begun = time.time()
        process = subprocess.Popen(
            [sys.executable, "-m", "ropewalk", *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip()
            canvas = "?renderer=canvas" if way == "Canvas 2D" else ""
            window.goto(address + canvas, wait_until="commit")
            while not (started := window.evaluate("() => window.started ?? 0")):
                time.sleep(0.2)
            yield window, process.pid, started / 1e3 - begun
        finally:
            context.close()
            process.terminate()
            process.wait(20)


def _frames(window: Any) -> tuple[float, float]:
    """Return pictures per second, and the script's time for each [ms]."""
    client = window.context.new_cdp_session(window)
    client.send("Performance.enable")
    time.sleep(WARM_UP)

    def look() -> tuple[float, float, float]:
        metrics = {
            one["name"]: one["value"] for one in client.send("Performance.getMetrics")["metrics"]
        }
        drawn = window.evaluate("() => window.ropewalk.drawn")
        return metrics["Timestamp"], metrics["ScriptDuration"], drawn

    begin = look()
    time.sleep(SECONDS)
    seconds, script, drawn = (b - a for a, b in zip(begin, look(), strict=True))
    return drawn / seconds, 1e3 * script / max(drawn, 1)


def _drags(window: Any) -> list[float]:
    """Drag the first anchor about; return the waits [ms]."""
    window.evaluate(WATCH_DRAGS)
    place = window.evaluate("() => window.ropewalk.screenOf(0)")
    window.mouse.move(place["x"], place["y"])
    window.mouse.down()
    for number in range(DRAGS):
        time.sleep(0.25 + 0.0037 * (number % 5))  # at any moment of a frame
        window.evaluate("() => { window.drags.armed = true; }")
        window.mouse.move(place["x"] + 20 * (number % 2) + 5, place["y"] - 10 * (number % 3))
    time.sleep(0.5)
    window.mouse.up()
    waits: list[float] = window.evaluate("() => window.drags.waits")
    if len(waits) < DRAGS // 2:  # a slow picture may show two moves at once
        raise RuntimeError(f"only {len(waits)} of {DRAGS} drags were seen to move the rope")
    return waits


def _heap(window: Any) -> float:
    """Return the page's heap after a collection [bytes]."""
    client = window.context.new_cdp_session(window)
    client.send("HeapProfiler.collectGarbage")
    used: float = client.send("Runtime.getHeapUsage")["usedSize"]
    return used


def _resident(process: int) -> float:
    """Return a process's resident memory [bytes] (Linux)."""
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * float(os.sysconf("SC_PAGE_SIZE"))
