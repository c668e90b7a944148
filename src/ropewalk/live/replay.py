"""Replaying a recorded run to the page: the same frames and messages as a live session sends."""

from __future__ import annotations

import queue
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.audience import Audience, Combine, Nobody
from ropewalk.live.broadcast import STATUS_SECONDS
from ropewalk.live.commands import Command, Seek, Speed, Step
from ropewalk.live.describe import anchor_list, force_list, load_list, rope_list, view_box
from ropewalk.live.frame import (
    BROKEN,
    END,
    HEADER,
    PLAYING,
    SCALARS,
    Clockwork,
    combined,
    encode,
)
from ropewalk.live.gaps import Parted, located, told
from ropewalk.live.inbox import Reply
from ropewalk.live.keeper import parts
from ropewalk.live.messages import error_message
from ropewalk.live.parameters import refusal
from ropewalk.live.recorded import Recorded
from ropewalk.live.solids import joint_list, obstacle_list
from ropewalk.record.result import Result
from ropewalk.scene import Scene, SceneError

STEP_SHOWN = 0.1  # [s] that a step past a break is seen


class ReplayBroadcast:
    """A run, or the parts of a live session one after another, as a stage."""

    mode = "replay"

    def __init__(self, run: Path | Result, *, playing: bool = True) -> None:
        """Take a result, or open a run folder. Raises RunError."""
        results = [run] if isinstance(run, Result) else [Result.open(one) for one in parts(run)]
        self.parts = [Recorded(result) for result in results]
        for part in self.parts[:-1]:
            part.past = None  # it was gone on from
        self.first = np.cumsum([0, *(part.frames for part in self.parts)])
        self.times = _timeline(self.parts)
        self.duration = float(self.times[-1])
        last = self.parts[-1]
        self.single = last.frames - last.result.frames  # steps past a break, at the end
        self.sound = int(self.first[-2]) + last.good  # frames before it
        self.broke_at = float(self.times[self.sound - 1])
        self.playing, self.speed, self.time = playing, 1.0, 0.0
        self.audience: Audience = Nobody()
        self.waiting: queue.SimpleQueue[tuple[Any, int, Reply]] = queue.SimpleQueue()
        self.frame_number, self._shown, self._layout = 0, -1, -1
        self._last, self._last_status = time.perf_counter(), 0.0
        self._jumped = False  # what lies between is not passed over
        self._told: tuple[bool, float] | None = None

    can = ("play", "pause", "step", "speed", "seek", "reset")
    address = ""

    @property
    def scene(self) -> Scene:
        """The scene that was run."""
        return self.parts[0].result.scene

    @property
    def index(self) -> int:
        """The frame to show now."""
        return int(np.searchsorted(self.times, self.time + 1e-9, side="right")) - 1

    def submit(self, item: Any, client: int, reply: Reply) -> None:
        """Put a command, or something to be done on the stage, in the queue (from any thread)."""
        self.waiting.put((item, client, reply))

    def join(self, tell: Reply) -> None:
        """Tell a new page everything."""
        tell(self._layout_message(self._part(self.index)))
        tell({"type": "parameters", "parameters": []})
        tell({"type": "presets", "presets": []})
        tell(self.status())
        self._shown = -1

    def leave(self, client: int) -> None:
        """Nothing is held in a replay."""

    def close(self) -> None:
        """Nothing runs beside a replay."""

    def tick(self) -> None:
        """Carry out what waits, go on by the time that has passed, show a frame."""
        self._handle()
        now = time.perf_counter()
        elapsed, self._last = min(now - self._last, 0.25), now
        if self.playing:
            self.time = self._later(elapsed * self.speed)
            self.playing = self.time < self.duration
        told = (self.playing, self.speed)
        if told != self._told or (self.playing and now - self._last_status > STATUS_SECONDS):
            self._told, self._last_status = told, now
            self.audience.tell(self.status())
        if self.index != self._shown and self.audience.size > 0:
            self._show()

    def _later(self, passed: float) -> float:
        """Return the time in the run when so much has passed [s]; steps past a break go by slowly."""
        if self.single == 0 or self.time + passed < self.broke_at:
            return min(self.time + passed, self.duration)
        if self.time < self.broke_at:
            return self.broke_at
        slowly = (self.duration - self.broke_at) / max(self.single * STEP_SHOWN, 1e-9)
        return min(self.time + passed * min(slowly, 1.0), self.duration)

    def _handle(self) -> None:
        while not self.waiting.empty():
            item, _, reply = self.waiting.get_nowait()
            if not isinstance(item, Command):
                item(self)
                continue
            try:
                self._act(item)
            except SceneError as error:
                reply(error_message(item.type, item.id, error))
                continue
            if item.id is not None:
                made = {"id": item.id, "command": item.type, "step": self.index}
                reply({"type": "done", **made, "frame": self.frame_number + 1})

    def _act(self, command: Command) -> None:
        if isinstance(command, Seek):
            if not 0.0 <= command.time <= self.duration * (1.0 + 1e-9):
                rule = f"must be from 0 to {self.duration:g} s"
                raise refusal("time", command.time, rule)
            self.time, self._jumped = command.time, True
        elif isinstance(command, Speed):
            self.speed = command.value
        elif isinstance(command, Step):
            frame = min(self.index + command.count, len(self.times) - 1)
            self.time, self.playing = float(self.times[frame]), False
        elif command.type == "play":
            self.time = 0.0 if self.time >= self.duration else self.time
            self.playing = True
        elif command.type == "pause":
            self.playing = False
        elif command.type == "reset":
            self.time = 0.0
        else:
            rule = "cannot be done in a replay; there is " + ", ".join(self.can)
            raise refusal("type", command.type, rule)

    def _part(self, index: int) -> int:
        return int(np.searchsorted(self.first, index, side="right")) - 1

    def _show(self) -> None:
        before, index = self._shown, self.index
        part = self._part(index)
        on = not self._jumped and self._part(before) == part and 0 <= before < index
        self._shown, self._jumped = index, False
        if part != self._layout:
            self._layout = part
            self.audience.tell(self._layout_message(part))
        self.frame_number += 1
        frame = self._frame(index, self.frame_number, before if on else None)
        self.audience.show(self.frame_number, frame, self._combiner(part))

    def _combiner(self, part: int) -> Combine:
        return partial(combined, [self.parts[part].shape])

    def _frame(self, index: int, number: int, after: int | None = None) -> bytes:
        """Return a frame that shows, too, what was seen since frame `after`."""
        part = self._part(index)
        first = int(self.first[part])
        picture = self.parts[part].picture(index - first, None if after is None else after - first)
        flags = PLAYING * self.playing + END * (index == len(self.times) - 1)
        flags += BROKEN * (index >= self.sound)
        when = float(self.times[index])
        realtime = self.speed if self.playing else 0.0
        head = Clockwork(part + 1, number, flags, when, index, realtime, self.speed, 0.0)
        return encode(head, [picture])

    def frames_between(self, first: int, count: int, every: int) -> Iterator[bytes]:
        """Yield frames one after another, for a page that wants many at once."""
        last = min(first + count * every, len(self.times))
        reader = ReplayBroadcast.__new__(
            ReplayBroadcast
        )  # a reader of its own: this is another thread
        reader.__dict__ = {**self.__dict__, "parts": [Recorded(one.result) for one in self.parts]}
        for index in range(first, last, every):
            yield reader._frame(index, index, index - every)

    def status(self) -> dict[str, Any]:
        """Return the `status` message."""
        plan = self.parts[self._part(self.index)].result.plan
        return {
            "type": "status",
            "playing": self.playing,
            "speed": self.speed,
            "realtime": self.speed if self.playing else 0.0,
            "slow": False,
            "text": "",
            "time": self.time,
            "step": self.index,
            "dt": plan.dt,
            "steps_per_frame": plan.steps_per_frame,
            "method": plan.method,
            "broken": False,
            "clients": self.audience.size,
            "address": "",
            "duration": self.duration,
        }

    def _layout_message(self, part: int) -> dict[str, Any]:
        self._layout = part
        result = self.parts[part].result
        places, end = self.parts[part].shape.places(HEADER.size)
        scene, spans = result.scene, result.layout.ropes
        center, radius = view_box(result.read("positions", 0, 1)[0], scene)
        where = {result.layout.node(one.segment, one.rope): one for one in result.partings}
        later = float(self.times[self.first[part]] - result.time[0])
        return {
            "type": "layout",
            "layout": part + 1,
            "bytes": end,
            "scene": {"name": scene.name, "description": scene.description, "preset": None},
            "up": list(scene.up),
            "gravity": list(scene.gravity),
            "ground": None if scene.ground is None else {"height": scene.ground.height},
            "view": {"center": center, "radius": radius},
            "broke": self._break(part),
            "obstacles": obstacle_list(scene, result.layout),
            "scalars": list(SCALARS),
            "variants": [
                {
                    "label": "",
                    "method": result.plan.method,
                    "changes": {},
                    "nodes": result.nodes,
                    "ropes": rope_list(scene, spans, {}),
                    "anchors": anchor_list(scene, result.layout),
                    "loads": load_list(scene, result.layout),
                    "forces": force_list(scene, result.layout),
                    "joints": joint_list(scene, result.layout),
                    **told(self._parted(part), where, later),
                    "offsets": places._asdict(),
                }
            ],
        }

    def _parted(self, part: int) -> list[Parted]:
        """Return what has parted in a part and before it, at the times of that part."""
        found = []
        now = float(self.times[self.first[part]] - self.parts[part].result.time[0])
        for before in range(part + 1):
            result = self.parts[before].result
            shift = float(self.times[self.first[before]] - result.time[0]) - now
            found += [
                located(one._replace(time=one.time + shift), result.scene)
                for one in result.partings
            ]
        return found

    def _break(self, part: int) -> dict[str, Any] | None:
        """When the last part broke and why, where frames past that are shown."""
        if part != len(self.parts) - 1 or self.sound == len(self.times):
            return None
        return {"time": self.broke_at, "text": self.parts[part].result.diagnosis}


def _timeline(parts: list[Recorded]) -> Floats:
    """Return the time of every frame [s], counted from the first one on, over all parts."""
    times, start = [], 0.0
    for part in parts:
        own = part.time - part.time[0]
        times.append(own + start)
        start = float(times[-1][-1])
    return np.concatenate(times)


def serve_run(
    run: Path | Result,
    *,
    playing: bool = True,
    host: str = "127.0.0.1",
    port: int | None = None,
    page: Path | None = None,
) -> Any:
    """Return a server, ready to start, that replays a run. Raises RunError, OSError."""
    from ropewalk.live.serve import ViewServer

    stage = ReplayBroadcast(run, playing=playing)
    server = ViewServer(host=host, port=port, page=page)
    folder = run if isinstance(run, Path) else None
    server.show(stage, title=stage.scene.name, folder=folder)
    return server
