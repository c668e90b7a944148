"""A live session of ropes that do not stretch."""

from __future__ import annotations

import json
import math

from live.drive import do, refused
from ropewalk.live import describe
from ropewalk.live.breaks import explain
from ropewalk.live.meter import measure
from ropewalk.live.pictures import picture
from ropewalk.live.session import Session
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Slack


def rigid() -> Session:
    rope = Rope(
        segments=20,
        length=10.0,
        made_of=Material(EA=math.inf, mass_per_length=0.2),
        shape=Slack(start=(0, 0, 0), end=(8, 0, 0)),
    )
    anchors = [Anchor(name="left", node=0), Anchor(name="right", node=-1)]
    settings = RunSettings(duration=5.0, time_step=1 / 60, method="bdf2")
    return Session(Scene(ropes=rope, anchors=anchors, run=settings))


def test_what_a_page_is_told_is_json() -> None:
    """No number is infinite; the meter is green; the links' constants cannot be set."""
    session = rigid()
    session.advance(10)
    told = {one["name"]: one for one in describe.parameters(session)["parameters"]}
    json.dumps([*told.values(), describe.layout(session)], allow_nan=False)
    meter = measure(session.main.simulation.model)
    json.dumps(meter, allow_nan=False)
    assert meter["zone"] == "green"
    for name in ("EA", "spring_constant", "length", "segments", "tension_only"):
        assert not told[name]["enabled"]
        assert "rigid links" in refused(session, "set", name=name, value=20)
    assert told["mass"]["enabled"]
    scalars = picture(session.main, None).scalars
    assert scalars["tension_max"] > 1.0
    assert scalars["strain_max"] == 0.0
    assert scalars["elastic"] == 0.0


def test_methods_that_cannot_are_refused_and_others_go_on() -> None:
    session = rigid()
    session.advance(10)
    assert "cannot hold the lengths" in refused(session, "set", name="method", value="verlet")
    do(session, "set", name="method", value="esdirk3")
    do(session, "set", name="mass", value=5.0)
    assert session.advance(10) == 0


def test_an_anchor_dragged_out_of_reach_breaks_and_goes_back() -> None:
    session = rigid()
    session.advance(10)
    do(session, "move", anchor="right", velocity=[2.0, 0.0, 0.0])
    assert session.advance(120) != 0
    told = explain(session)
    json.dumps(told, allow_nan=False)
    assert "'left' and 'right' are" in told["text"]
    do(session, "remedy", remedy="back")
    assert session.broken is None
