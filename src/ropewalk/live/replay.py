"""A recorded run as a broadcast: says what there is and hands out frames; each page plays them by itself."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.audience import Audience, Nobody
from ropewalk.live.commands import Command
from ropewalk.live.describe import anchor_list, force_list, load_list, rope_list, view_box
from ropewalk.live.frame import BROKEN, END, HEADER, SCALARS, Clockwork, encode
from ropewalk.live.gaps import Parted, located, told
from ropewalk.live.inbox import Reply
from ropewalk.live.keeper import parts
from ropewalk.live.messages import error_message
from ropewalk.live.parameters import refusal
from ropewalk.live.recorded import Recorded, followed
from ropewalk.live.solids import joint_list, obstacle_list
from ropewalk.record.result import Result
from ropewalk.scene import Scene


class ReplayBroadcast:
    """A run, or the parts of a live session one after another, as a broadcast."""

    mode = "replay"
    can: tuple[str, ...] = ()  # a page needs nobody to play, pause or seek
    address = ""

    def __init__(self, run: Path | Result, *, playing: bool = True) -> None:
        """Take a result, or open a run folder. Raises RunError."""
        results = [run] if isinstance(run, Result) else [Result.open(one) for one in parts(run)]
        self.parts = followed(results)
        self.first = np.cumsum([0, *(part.frames for part in self.parts)])
        self.times = _timeline(self.parts)
        self.duration = float(self.times[-1])
        last = self.parts[-1]
        self.single = last.frames - last.result.frames  # steps past a break, at the end
        self.sound = int(self.first[-2]) + last.good  # frames before it
        self.broke_at = float(self.times[self.sound - 1])
        self.playing = playing  # whether pages begin to play when they open
        self.audience: Audience = Nobody()

    @property
    def scene(self) -> Scene:
        """The scene that was run."""
        return self.parts[0].result.scene

    def submit(self, item: Any, client: int, reply: Reply) -> None:
        """Do something in the broadcast at once; refuse a command (from any thread)."""
        if not isinstance(item, Command):
            item(self)
            return
        rule = "cannot be done in a replay, which every page plays by itself"
        reply(error_message(item.type, item.id, refusal("type", item.type, rule)))

    def join(self, tell: Reply) -> None:
        """Tell a new page what there is to play."""
        tell({"type": "replay", "playing": self.playing, **self.header()})

    def leave(self, client: int) -> None:
        """Nothing is held in a replay."""

    def close(self) -> None:
        """Nothing runs beside a replay."""

    def tick(self) -> None:
        """Nothing goes on here."""

    def header(self) -> dict[str, Any]:
        """Return how long the run is, and what its parts are."""
        return {
            "duration": self.duration,
            "single": self.single,
            "parts": [self.facts(number) for number in range(len(self.parts))],
        }

    def facts(self, part: int) -> dict[str, Any]:
        """Return how many frames a part has, those before a break among them, and how it was stepped."""
        first, end = int(self.first[part]), int(self.first[part + 1])
        plan = self.parts[part].result.plan
        good = min(self.sound, end) - first
        return {"frames": end - first, "good": good, "method": plan.method, "dt": plan.dt}

    def _part(self, index: int) -> int:
        return int(np.searchsorted(self.first, index, side="right")) - 1

    def frames_between(self, first: int, count: int, every: int) -> Iterator[bytes]:
        """Yield frames, each with what was seen since the one `every` frames before it (from any thread)."""
        parts: dict[int, Recorded] = {}  # readers of its own
        for index in range(first, min(first + count * every, len(self.times)), every):
            number = self._part(index)
            if number not in parts:
                parts = {number: self.parts[number].again()}
            yield self._frame(parts[number], number, index, index - every)

    def _frame(self, part: Recorded, number: int, index: int, after: int) -> bytes:
        """Return a frame that shows, too, what was seen since frame `after`."""
        first = int(self.first[number])
        picture = part.picture(index - first, after - first)
        flags = END * (index == len(self.times) - 1) + BROKEN * (index >= self.sound)
        when = float(self.times[index])
        return encode(Clockwork(number + 1, index, flags, when, index, 0.0, 0.0, 0.0), [picture])

    def layout(self, part: int) -> dict[str, Any]:
        """Return the `layout` message of a part."""
        result = self.parts[part].result
        places, end = self.parts[part].shape.places(HEADER.size)
        scene, spans = result.scene, result.layout.ropes
        center, radius = view_box(result.read("positions", 0, 1)[0], scene)
        where = {result.layout.node(one.segment, one.rope): one for one in result.partings}
        later = float(self.times[self.first[part]] - result.time[0])
        return {
            "type": "layout",
            "layout": part + 1,
            "later": later,
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
                    "anchors": self._anchors(part, later),
                    "loads": load_list(scene, result.layout),
                    "forces": force_list(scene, result.layout),
                    "joints": joint_list(scene, result.layout),
                    **told(self._parted(part), where, later),
                    "surfaces": list(result.layout.surfaces),
                    "offsets": places._asdict(),
                }
            ],
        }

    def _anchors(self, part: int, later: float) -> list[dict[str, Any]]:
        """Return the anchors of a part that begins so much later, with when they let go [s]."""
        one = self.parts[part]
        lets_go = [None if until is None else until + later for until in one.until]
        anchors = anchor_list(one.result.scene, one.result.layout)
        return [a | {"until": until} for a, until in zip(anchors, lets_go, strict=True)]

    def _parted(self, part: int) -> list[Parted]:
        """Return what has parted in a part and before it, at the times of that part."""
        found = []
        now = float(self.times[self.first[part]] - self.parts[part].result.time[0])
        for before in range(part + 1):
            result = self.parts[before].result
            shift = float(self.times[self.first[before]] - result.time[0]) - now
            for one in result.partings:
                frame = min(int(np.searchsorted(result.time, one.time)), result.good_frames - 1)
                rest = result.read("rest_length", frame)[0]
                there = result.layout.span(one.rope)
                later = one._replace(time=one.time + shift)
                found.append(located(later, result.scene, there, rest))
        return found

    def _break(self, part: int) -> dict[str, Any] | None:
        """When the last part broke and why, where frames past that are shown."""
        if part != len(self.parts) - 1 or self.sound == len(self.times):
            return None
        return {"time": self.broke_at, "text": self.parts[part].result.diagnosis}


def _timeline(parts: list[Recorded]) -> Floats:
    """Return the time of every frame [s], counted from the first one on, over all parts."""
    times, start, end = [], 0.0, np.inf
    for part in parts:
        start += max(float(part.time[0]) - end, 0.0)  # it began between two frames
        times.append(part.time - part.time[0] + start)
        start, end = float(times[-1][-1]), float(part.time[-1])
    return np.concatenate(times)
