"""The pictures of presets in the menu: there for all, told apart, and what the physics gives."""

from __future__ import annotations

import re
from itertools import combinations, pairwise

import numpy as np
import pytest

from ropewalk.live.preset_pictures import shipped, svg
from ropewalk.live.shape_picture import HEIGHT, WIDTH, draw, shot
from ropewalk.live.thumbnails.telling import TELLING, picture
from ropewalk.scene import Anchor, Rope, Scene, Springs, Straight
from ropewalk.scene.presets import names, preset
from ropewalk.simulation import Simulation

_CELL = 4  # of the coarse raster [px]


def _lines(text: str) -> list[tuple[float, np.ndarray]]:
    """Opacity and points of every line in a picture."""
    found = []
    for opacity, body in re.findall(r'<g opacity="([\d.]+)">(.*?)</g>', text):
        for points in re.findall(r'points="([^"]+)"', body):
            pairs = [[float(value) for value in pair.split(",")] for pair in points.split()]
            found.append((float(opacity), np.array(pairs)))
        dots = re.findall(r'c?x="(-?[\d.]+)" c?y="(-?[\d.]+)"', body)
        found += [(float(opacity), np.array([dot, dot], dtype=float)) for dot in dots]
    return found


def _ink(text: str) -> np.ndarray:
    """How much a picture darkens the cells of a coarse raster, 0 to 1."""
    raster = np.zeros((HEIGHT // _CELL + 1, WIDTH // _CELL + 1))
    for opacity, points in _lines(text):
        for a, b in pairwise(points):
            along = a + np.linspace(0.0, 1.0, 40)[:, None] * (b - a)
            inside = ((along >= 0) & (along < [WIDTH, HEIGHT])).all(axis=1)
            column, row = (along[inside] // _CELL).astype(int).T
            raster[row, column] = np.maximum(raster[row, column], opacity)
    return raster


def _apart(one: str, other: str) -> float:
    """Which part of the ink of two pictures is not in common, 0 to 1."""
    a, b = _ink(one), _ink(other)
    return float(np.abs(a - b).sum() / np.maximum(a, b).sum())


def test_every_preset_has_a_small_picture() -> None:
    assert set(TELLING) == set(names())
    for name in names():
        text = svg(name, None)
        assert text is not None
        assert text.startswith("<svg ")
        assert len(text) < 10_000
        assert _ink(text).sum() > 2


def test_pictures_are_told_apart() -> None:
    pictures = {name: shipped(name) for name in names()}
    alike = {pair: _apart(*map(pictures.get, pair)) for pair in combinations(pictures, 2)}
    assert min(alike.values()) > 0.4, min(alike.items(), key=lambda item: item[1])
    # The twin: at time zero two of the report's scenes are the same picture.
    start = [
        draw([shot(Simulation(preset(name), ledger=False))], preset(name)) for name in ("r4", "r8")
    ]
    assert _apart(*start) == 0.0


@pytest.mark.parametrize("name", ["r2", "r4", "r6", "skipping-rope"])
def test_pictures_are_what_the_physics_gives(name: str) -> None:
    again, there = _lines(picture(name)), _lines(shipped(name))
    assert [len(points) for _, points in again] == [len(points) for _, points in there]
    for (_, a), (_, b) in zip(again, there, strict=True):
        assert np.abs(a - b).max() < 0.5


def test_the_program_s_own_scene_is_drawn_at_time_zero() -> None:
    rope = Rope(
        name="rope",
        made_of=Springs(spring_constant=10.0, node_mass=1.0, segment_length=1.0),
        segments=4,
        shape=Straight(start=(0.0, 0.0, 0.0), direction=(1.0, 0.0, 0.0)),
    )
    scene = Scene(name="a <b> & c", ropes=[rope], anchors=[Anchor(node=0)])

    class Broadcast:
        class session:  # noqa: N801
            start = (scene, None)

    text = svg("start", Broadcast)
    assert text is not None
    assert "<title>a &lt;b&gt; &amp; c</title>" in text
    (_, line), *_ = _lines(text)
    assert np.ptp(line[:, 1]) == 0.0
    assert np.ptp(line[:, 0]) > 100.0
