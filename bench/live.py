"""The live view's server, without a browser: its share of a core, and from a drag to the frame."""

from __future__ import annotations

import json
import os
import statistics
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bench.row import Row
from ropewalk import Anchor, Rope, RunSettings, Scene, Springs, save
from ropewalk.scene import Slack

SECONDS = 8.0
DRAGS = 30
WARM_UP = 2.0  # [s]
_HEADER = struct.Struct("<IIIIddfffI")


def ropes(count: int, nodes: int, steps: int = 9) -> Scene:
    """Return sagging ropes of the report's springs beside each other, every end held.

    Its time step of 2 ms makes 9 `steps` a frame at 60 Hz.
    """
    springs = Springs(spring_constant=1e4, node_mass=0.05, spring_friction=0.05, segment_length=1.0)
    names = [f"rope{i}" for i in range(count)]
    length = float(nodes - 1)
    return Scene(
        ropes=[
            Rope(
                name=name,
                segments=nodes - 1,
                made_of=springs,
                shape=Slack(
                    start=(0.0, 0.1 * length * i, 0.0), end=(0.8 * length, 0.1 * length * i, 0.0)
                ),
            )
            for i, name in enumerate(names)
        ],
        anchors=[
            Anchor(name=f"{name}-{end}", rope=name, node=node)
            for name in names
            for end, node in (("a", 0), ("b", -1))
        ],
        run=RunSettings(time_step=1.0 / 60.0 / steps),
    )


def live_server() -> list[Row]:
    """One page looks on at 60 frames per second."""
    rows = []
    for count, steps, target in ((1, 9, ""), (10, 9, "< 20"), (10, 57, "")):
        share, fps, realtime, waits = _watch(ropes(count, 100, steps))
        name = f"live view, {count} x 100 nodes, {steps} steps a frame"
        rows += [
            Row(f"{name}: server", 100.0 * share, "% of a core", target),
            Row(f"{name}: frames", fps, "1/s", "60"),
            Row(f"{name}: real time", realtime, "x", "1"),
            Row(f"{name}: drag to frame, median", 1e3 * statistics.median(waits), "ms", "< 35"),
            Row(f"{name}: drag to frame, 90 %", 1e3 * sorted(waits)[-len(waits) // 10], "ms", ""),
        ]
    return rows


def _watch(scene: Scene) -> tuple[float, float, float, list[float]]:
    """Return the server's share of a core, frames per second, real-time factor, waits [s]."""
    from websockets.sync.client import connect

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        save(scene, path)
        words = ["view", str(path), "--no-browser", "--no-save", "--port", "0"]
        process = subprocess.Popen(
            [sys.executable, "-m", "ropewalk", *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        try:
            assert process.stdout is not None
            address = process.stdout.readline().strip().replace("http:", "ws:") + "socket"
            with connect(address, max_size=None, open_timeout=600.0) as page:
                _look_on(page, WARM_UP)
                before, begun = _cpu_seconds(process.pid), time.monotonic()
                frames, realtime = _look_on(page, SECONDS)
                spent = time.monotonic() - begun
                share = (_cpu_seconds(process.pid) - before) / spent
                waits = [_drag(page, number) for number in range(1, DRAGS + 1)]
            return share, frames / spent, realtime, waits
        finally:
            process.terminate()
            process.wait(20)


def _cpu_seconds(process: int) -> float:
    """Return the computing time of a process [s] (Linux)."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _look_on(page: object, seconds: float) -> tuple[int, float]:
    """Acknowledge every frame for so long; return their number and the last real-time factor."""
    end, frames, realtime = time.monotonic() + seconds, 0, 0.0
    while time.monotonic() < end:
        head = _next(page)[0]
        if head is not None:
            frames, realtime = frames + 1, head[6]
    return frames, realtime


def _next(page: object) -> tuple[tuple[float, ...] | None, dict[str, object]]:
    message = page.recv(10.0)  # type: ignore[attr-defined]
    if isinstance(message, str):
        return None, json.loads(message)
    head = _HEADER.unpack_from(message)
    page.send(json.dumps({"type": "ack", "frame": head[2]}))  # type: ignore[attr-defined]
    return head, {}


def _drag(page: object, number: int) -> float:
    """Return the time from a drag to the first frame that shows it [s]."""
    _look_on(page, 0.1 + 0.0137 * (number % 7))  # not always at the same moment of a frame
    begun, first = time.monotonic(), None
    command = {"type": "drag", "anchor": "rope0-a", "target": [0.0, 0.02 * number, 0.0]}
    page.send(json.dumps(command | {"id": number}))  # type: ignore[attr-defined]
    while True:
        head, message = _next(page)
        if message.get("id") == number:
            first = message["frame"]
        if head is not None and first is not None and head[2] >= first:
            return time.monotonic() - begun
