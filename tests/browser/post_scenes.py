"""Random ropes over posts for tests of the lab: taut, so that what rounding leaves does not grow."""

from __future__ import annotations

from typing import Any

import numpy as np

import ropewalk as rw
from ropewalk.scene.toml_text import loads

_TEXT = """
schema_version = 1
name = "over a post"
gravity = [0.0, 0.0, -9.81]

[run]
duration = 1.0

[[rope]]
name = "rope"
segments = {segments}
length = {length!r}
diameter = {diameter!r}
made_of = {{kind = "material", EA = 3000.0, mass_per_length = 0.1, axial_damping = 0.1}}
shape = {{kind = "points", points = {points}}}

[[rope.load]]
node = -1
mass = {load!r}

[[rope.load]]
node = 4
mass = 0.01

[[rope.kick]]
node = {kicked}
velocity = {kick}

[[anchor]]
node = 0
motion = {{kind = "velocity", velocity = [0.0, 0.0, {speed!r}], start = 0.0023, stop = 0.0307}}

[[obstacle]]
kind = "{kind}"
{ends}
radius = {radius!r}
friction = {friction!r}
"""
_MORE = """
[[obstacle]]
kind = "sphere"
center = {ball}
radius = 0.07
friction = 0.5

[[obstacle]]
kind = "plane"
point = {floor}
normal = [-0.5, 0.0, 1.0]
compliance = 1e-5
"""


def over_a_post(seed: int, **changes: Any) -> rw.Scene:
    """Return a rope that lies round a cylinder or a capsule, by half a turn and more.

    Of every second seed its load hangs by a ball and over a tilted plane. `changes` of the drawn numbers.
    """
    rng = np.random.default_rng(seed)
    radius, diameter = rng.uniform(0.08, 0.12), rng.choice([0.008, 0.012])
    load, friction = rng.uniform(1.5, 4.0), rng.uniform(0.1, 0.5)
    r, angle = radius + 0.5 * diameter, np.pi * rng.uniform(1.0, 1.2)
    left, right, stretched = 0.2, 0.3, 0.025 * (1.0 + load * 9.81 / 3000.0)
    segments = round((left + r * angle + right) / stretched)
    left = segments * stretched - r * angle - right
    s = np.arange(segments + 1) * stretched
    a = np.clip((s - left) / r, 0.0, angle)
    before, after = np.maximum(left - s, 0.0), np.maximum(s - left - r * angle, 0.0)
    tip = (
        0.5 * np.pi - 0.5 * angle
    )  # where it comes to the post, so that the load hangs as the hand holds
    x = -r * np.cos(a + tip) + after * np.sin(angle + tip) - before * np.sin(tip)
    z = r * np.sin(a + tip) + after * np.cos(angle + tip) - before * np.cos(tip)
    points = np.round(np.stack([x, 0.002 * np.arange(segments + 1), z], axis=1), 6)
    whole = {
        "segments": int(segments),
        "length": 0.025 * segments,
        "diameter": float(diameter),
        "points": points.tolist(),
        "load": float(load),
        "kicked": int(rng.integers(segments // 3, 2 * segments // 3)),
        "kick": np.round(rng.normal(0.0, 0.02, 3), 4).tolist(),
        "speed": float(rng.choice([-1.0, 1.0]) * rng.uniform(0.2, 0.5)),
        "kind": "capsule" if seed % 3 == 0 else "cylinder",
        "ends": "from = [0.0, -0.3, 0.0]\nto = [0.0, 0.4, 0.0]",
        "radius": float(radius),
        "friction": float(friction),
    } | changes
    more = ""
    if seed % 2:
        end = points[-1].tolist()
        ball = [float(x.max()) + 0.0705 + 0.5 * float(diameter), end[1], end[2] + 0.15]
        more = _MORE.format(ball=ball, floor=[end[0], 0.0, end[2] - 0.5 * float(diameter) * 1.2])
    return loads(_TEXT.format(**whole) + more, "over a post")
