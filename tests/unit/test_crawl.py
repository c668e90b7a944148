"""Steps to a tolerance that crawl say so, once."""

from __future__ import annotations

import warnings

import pytest

from ropewalk.engine.crawl import MANY, Crawl, CrawlWarning
from ropewalk.scene import (
    Anchor,
    Contact,
    Ground,
    Material,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Straight,
)
from ropewalk.simulation import Simulation


def dropped(tolerance: float) -> Simulation:
    """5 m of cord without friction, dropped from the horizontal: its segments go slack and taut for ever."""
    stuff = Material(EA=1e4, mass_per_length=0.1, tension_only=True)
    shape = Straight(start=(0, 0, 0), end=(5, 0, 0))
    cord = Rope(segments=50, length=5.0, made_of=stuff, shape=shape)
    run = RunSettings(method="adaptive", tolerance=tolerance, duration=3.0)
    return Simulation(Scene(ropes=[cord], anchors=[Anchor(node=0)], run=run))


def go_on(simulation: Simulation, end: float) -> None:
    """Advance to a time [s], or until it crawls."""
    while simulation.time < end and not simulation._engine.crawl.told:
        simulation.advance_frames(1)


def note(crawl: Crawl, *tries: tuple[int, float]) -> None:
    for one in tries:
        crawl.note(*one)


def test_a_rope_that_crawls_is_told() -> None:
    """At 0.1 um it comes to 1.7 s in 44 000 tries; the twin, at the default, to 3 s in 500, silently."""
    simulation = dropped(1e-7)
    said = "segments go slack and taut. Take a larger tolerance"
    with pytest.warns(CrawlWarning, match=said):
        go_on(simulation, 2.0)
    assert 1.0 < simulation.time < 2.0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        calm = dropped(1e-5)
        go_on(calm, 2.99)
    assert calm.time == pytest.approx(3.0)


def test_it_is_told_once_and_of_crawling_only() -> None:
    crawl = Crawl(1e-8)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        crawl.note(MANY, 1.0)  # 0.2 ms a try
        crawl.note(MANY - 1, 1.001)
    with pytest.warns(CrawlWarning, match="t = 1.002 s: steps of 0.4 us") as told:
        note(crawl, (1, 1.002), (MANY, 1.003))
    assert len(told) == 1
    assert "slack" not in str(told[0].message)


def test_all_that_ends_steps_is_named() -> None:
    """Slack segments alone were, where it may be the ground, an obstacle or another rope."""
    plain = dropped(1e-5).scene
    scene = plain.replace(
        ropes=[plain.ropes[0].replace(diameter=0.01)],
        ground=Ground(),
        obstacles=[Sphere(center=(0, 0, -9), radius=1.0)],
        contact=Contact(),
    )
    said = Simulation(scene)._engine.crawl._text(1.0, 1e-6)
    where = (
        "Steps end where segments go slack and taut, where nodes reach and leave the ground, where "
        "nodes reach and leave the obstacles, and where ropes strike each other. Take a larger"
    )
    assert where in said
    assert "Steps end" not in Crawl(1e-8)._text(1.0, 1e-6)


def test_going_back_counts_anew() -> None:
    crawl = Crawl(1e-8, ["segments go slack and taut"])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        crawl.note(MANY, 5.0)
        crawl.note(MANY - 1, 1.0)
        crawl.note(2, 1.001)
