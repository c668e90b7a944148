"""Small scenes for tests of runs, and comparisons of run folders."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ropewalk.scene import Scene, loads

HANGING = """
name = "hanging"
[run]
duration = {duration}
frame_rate = {frame_rate}
time_step = {time_step}
[[rope]]
segments = {segments}
[rope.made_of]
kind = "springs"
spring_constant = {spring_constant}
node_mass = 0.05
spring_friction = 0.05
segment_length = 1.0
[[anchor]]
name = "left"
node = 0
[anchor.motion]
kind = "shake"
axis = [0.0, 0.0, 1.0]
amplitude = 0.2
frequency = 1.0
[[anchor]]
name = "right"
node = -1
release_time = 0.5
[air]
node_drag = 0.02
"""

TWO_ROPES_AND_A_WINCH = """
name = "two ropes, a winch"
[run]
duration = {duration}
method = "semi-implicit-euler"
time_step = 0.0005
[[rope]]
name = "line"
segments = 8
length = 4.0
[rope.made_of]
kind = "material"
EA = 20000.0
mass_per_length = 0.3
axial_damping = 50.0
[rope.shape]
kind = "hanging"
start = [0.0, 0.0, 0.0]
[[rope]]
name = "free"
segments = 5
[rope.made_of]
kind = "springs"
spring_constant = 1000.0
node_mass = 0.1
segment_length = 0.5
[rope.shape]
kind = "straight"
start = [0.0, 5.0, 0.0]
[[anchor]]
name = "drum"
rope = "line"
node = 0
[[winch]]
rope = "line"
end = "start"
speed = {speed}
start = 0.2
stop = 1.8
"""


def hanging(**changes: Any) -> Scene:
    """A chain on a shaken anchor, let go at the other end."""
    values = {
        "duration": 2.0,
        "frame_rate": 60.0,
        "time_step": 0.002,
        "segments": 10,
        "spring_constant": 10000.0,
    }
    return loads(HANGING.format(**(values | changes)))


def winched(speed: float = 0.5, duration: float = 2.0) -> Scene:
    """Two ropes, one of them on a winch."""
    return loads(TWO_ROPES_AND_A_WINCH.format(speed=speed, duration=duration))


def breaking(**changes: Any) -> Scene:
    """A chain whose step is too long."""
    return hanging(**({"time_step": 1.0 / 60.0, "spring_constant": 300.0} | changes))


def data_bytes(folder: Path) -> dict[str, bytes]:
    """Every file of a run's store by name."""
    store = folder / "data.zarr"
    return {
        path.relative_to(store).as_posix(): path.read_bytes()
        for path in sorted(store.rglob("*"))
        if path.is_file()
    }
