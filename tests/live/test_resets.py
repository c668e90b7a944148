"""Resets that look for rest: beside the broadcast, said at once, and refused with what may be changed."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from live.drive import do, r4, refused, slack_rope
from live.test_slices import Told, broadcasting, send, tick_until
from patience import PATIENCE
from ropewalk.live import opening
from ropewalk.live.anew import Anew
from ropewalk.live.keeper import Keeper
from ropewalk.live.relive import relive
from ropewalk.live.session import Session
from ropewalk.live.track import Track
from ropewalk.scene.presets import preset
from ropewalk.statics import checked_shape


@pytest.fixture
def told() -> Told:
    return Told()


@pytest.fixture
def searched(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Searches for rest wait for `gate`; `begun` counts them."""

    class Searched:
        gate, begun = threading.Event(), 0

    tracks, made = Anew.tracks, Searched()

    def slowly(self: Anew) -> list[Track]:
        made.begun += 1
        made.gate.wait(PATIENCE)
        return tracks(self)

    monkeypatch.setattr(Anew, "tracks", slowly)
    yield made
    made.gate.set()


def resting() -> Session:
    """Return a session of a rope that begins at rest."""
    return Session(slack_rope().replace(**{"run.start": "at-rest"}))


def mass(session: Session) -> float:
    return float(session.scene.ropes[0].own_mass)


def test_what_goes_on_while_rest_is_looked_for(told: Told, searched: Any) -> None:
    """All pages stood still for up to nine seconds, without a word."""
    broadcast = broadcasting(told, resting(), playing=True)
    send(broadcast, told, "step", id=9)
    send(broadcast, told, "reset", id=1)
    broadcast.tick()
    assert "Looking for the ropes' rest" in told.of("status")[-1]["waits"]
    count = broadcast.count
    tick_until(broadcast, lambda: broadcast.count > count)
    send(broadcast, told, "grab", node=9, target=[1.0, 1.0, 1.0], id=2)  # its own hands
    send(broadcast, told, "kick", client=2, node=9, velocity=[0, 0, 1], id=3)  # another page
    send(broadcast, told, "set", name="mass", value=3.0, id=4)  # waits for its time zero
    send(broadcast, told, "pause", id=5)
    tick_until(broadcast, lambda: told.answer(5))
    assert [told.answer(number)["type"] for number in (2, 3)] == ["done"] * 2
    assert not broadcast.playing
    assert told.answer(1) is told.answer(4) is None
    searched.gate.set()
    tick_until(broadcast, lambda: told.answer(4))
    assert told.answer(1)["type"] == "done"
    assert broadcast.session.time == 0.0
    assert not broadcast.playing
    assert mass(broadcast.session) == pytest.approx(3.0)
    assert told.of("status")[-1]["waits"] == ""


def test_a_reset_begins_with_what_was_changed_while_rest_was_looked_for(
    told: Told, searched: Any
) -> None:
    broadcast = broadcasting(told, resting())
    send(broadcast, told, "reset", id=1)
    send(broadcast, told, "set", client=2, name="mass", value=4.0, id=2)
    tick_until(broadcast, lambda: told.answer(2))
    searched.gate.set()
    tick_until(broadcast, lambda: told.answer(1))
    assert searched.begun == 2
    assert mass(broadcast.session) == pytest.approx(4.0)
    twin = resting()
    do(twin, "set", name="mass", value=4.0)
    do(twin, "reset")
    here, there = broadcast.session.main.simulation, twin.main.simulation
    assert np.array_equal(here.positions, there.positions)


def test_who_resets_while_rest_is_looked_for_has_that_reset(told: Told, searched: Any) -> None:
    broadcast = broadcasting(told, resting())
    for client in (1, 2, 3):
        send(broadcast, told, "reset", client=client, id=client)
    broadcast.tick()
    searched.gate.set()
    tick_until(broadcast, lambda: told.answer(1))
    assert [told.answer(client)["type"] for client in (1, 2, 3)] == ["done"] * 3
    assert searched.begun == 1


def test_a_reset_joins_one_on_its_way_and_replaces_no_scene(told: Told, searched: Any) -> None:
    """The scene that another page waited for was refused, and rest looked for a second time."""
    broadcast = broadcasting(told, resting())
    send(broadcast, told, "reset", client=1, id=1)
    broadcast.tick()
    send(broadcast, told, "scene", client=1, preset="n40", id=2)
    broadcast.tick()
    send(broadcast, told, "reset", client=2, id=3)
    broadcast.tick()
    searched.gate.set()
    tick_until(broadcast, lambda: all(told.answer(number) for number in (1, 2, 3)))
    assert [told.answer(number)["type"] for number in (1, 2, 3)] == ["done"] * 3
    assert searched.begun == 1
    assert broadcast.session.preset == "n40"


def test_resets_that_cannot_join_wait_for_their_turn(told: Told, searched: Any) -> None:
    """One that gives back all constants waits for one that does not; others are done with it."""
    session = resting()
    whole = mass(session)
    do(session, "set", name="mass", value=4.0)
    broadcast = broadcasting(told, session)
    for client, original in enumerate((False, True, True)):
        send(broadcast, told, "reset", client=client, all=original, id=client)
        broadcast.tick()
    searched.gate.set()
    tick_until(broadcast, lambda: told.answer(2))
    assert [told.answer(client)["type"] for client in range(3)] == ["done"] * 3
    assert searched.begun == 2
    assert mass(broadcast.session) == pytest.approx(whole)


def test_a_reset_that_a_scene_takes_the_place_of_is_told_so(
    told: Told, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was told of a "scene" that it had not asked for, and not what to do."""
    gate, made = threading.Event(), opening.opened

    def slowly(*args: Any) -> Session:
        gate.wait(PATIENCE)
        return made(*args)

    monkeypatch.setattr(opening, "opened", slowly)
    broadcast = broadcasting(told, resting())
    send(broadcast, told, "scene", client=1, preset="n40", id=1)
    broadcast.tick()
    for client in (2, 3):
        send(broadcast, told, "reset", client=client, id=client)
    broadcast.tick()
    send(broadcast, told, "scene", client=4, preset="r4", id=4)
    broadcast.tick()
    for client in (2, 3):
        answer = told.answer(client)
        assert (answer["faults"][0]["path"], answer["faults"][0]["value"]) == ("type", "reset")
        assert "once that scene is there, reset it" in answer["text"]
    gate.set()
    tick_until(broadcast, lambda: told.answer(1) and told.answer(4))
    assert [told.answer(number)["type"] for number in (1, 4)] == ["done"] * 2
    assert broadcast.session.preset == "r4"


def test_a_reset_behind_a_scene_is_of_that_scene(told: Told, searched: Any) -> None:
    """Rest was looked for in the scene before it, too."""
    broadcast = broadcasting(told, resting())
    searched.gate.set()
    send(broadcast, told, "scene", client=1, preset="n40", id=1)
    send(broadcast, told, "reset", client=2, id=2)
    tick_until(broadcast, lambda: told.answer(1) and told.answer(2))
    assert [told.answer(number)["type"] for number in (1, 2)] == ["done"] * 2
    assert searched.begun == 1
    assert broadcast.session.preset == "n40"


def test_a_reset_that_looks_for_nothing_is_done_at_once(told: Told) -> None:
    broadcast = broadcasting(told, r4())
    send(broadcast, told, "reset", id=1)
    broadcast.tick()
    assert told.answer(1)["type"] == "done"


def test_a_session_that_was_reset_beside_replays_to_the_same_bits(
    told: Told, tmp_path: Path
) -> None:
    session = resting()
    keeper = Keeper(session, tmp_path / "run")
    broadcast = broadcasting(told, session)
    for number, command in enumerate(
        [
            {"kind": "kick", "node": 9, "velocity": [0, 0, 1]},
            {"kind": "step", "count": 77},
            {"kind": "set", "name": "mass", "value": 3.0},
            {"kind": "reset"},
            {"kind": "kick", "node": 4, "velocity": [0, 1, 0]},
            {"kind": "step", "count": 333},
        ]
    ):
        send(broadcast, told, **command, id=number)
        tick_until(broadcast, lambda number=number: told.answer(number))
    keeper.close()
    again = relive(tmp_path / "run").main.simulation
    assert again.time == session.time > 0.0
    assert again.positions.tobytes() == session.main.simulation.positions.tobytes()


def test_where_no_rest_is_found_it_is_said_what_to_change(told: Told) -> None:
    """Held to be the scene's fault, it was to have another compliance, or an anchor."""
    session = Session(preset("suspension-cable"), "suspension-cable")
    do(session, "set", name="gravity", value=[0, 0, 0])
    said = refused(session, "reset")
    assert "no rest is found with Gravity (0, 0, 0) m/s^2 in place of the scene's own" in said
    assert "Give back what was changed" in said
    assert "neither gravity nor wind" in said  # why
    do(session, "reset", all=True)
    said = refused(session, "scene", address="scene=suspension-cable&gravity=[0,0,0]")
    assert "no rest is found with Gravity (0, 0, 0)" in said
    assert "Leave that out of the link" in said
    broadcast = broadcasting(told, session)
    send(broadcast, told, "scene", address="scene=suspension-cable&gravity=[0,0,0]", id=1)
    tick_until(broadcast, lambda: told.answer(1))
    assert told.answer(1)["text"].startswith("No rest is found with Gravity (0, 0, 0)")


@pytest.mark.parametrize(
    ("link", "changed"),
    [("scene=suspension-cable&mass=2000", True), ("scene=suspension-cable", False)],
)
def test_a_link_s_rest_is_looked_for_once(
    link: str, changed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """That of the scene's own constants was looked for first, and thrown away: it may take ten seconds."""
    shapes = []

    def counted(model: Any) -> Any:
        shapes.append(model.scene.run.start)
        return checked_shape(model)

    monkeypatch.setattr("ropewalk.engine.start.checked_shape", counted)
    session = r4()
    do(session, "scene", address=link)
    assert shapes == ["at-rest"]
    assert session.loaded.run.start == "at-rest"
    assert bool(session.changes) == changed
    again = Session(preset("suspension-cable"), "suspension-cable")
    if changed:
        do(again, "set", name="mass", value=2000.0)
        do(again, "reset")
    assert session.loaded == again.loaded
    assert session.changes == again.changes
    one, other = session.main.simulation, again.main.simulation
    assert one.scene == other.scene
    assert one.positions.tobytes() == other.positions.tobytes()


def test_a_scene_that_has_no_rest_says_why_in_its_own_words() -> None:
    scene = preset("suspension-cable").replace(gravity=(0.0, 0.0, 0.0))
    said = refused(r4(), "scene", toml=_toml(scene))
    assert "in place of the scene's own" not in said


def _toml(scene: Any) -> str:
    from ropewalk.scene import dumps

    return dumps(scene)


@pytest.mark.parametrize("playing", [True, False])
def test_a_scene_plays_if_the_one_before_did(told: Told, *, playing: bool) -> None:
    """A page that was paused played as soon as another scene was chosen; a reset left it paused."""
    broadcast = broadcasting(told, r4(), playing=playing)
    send(broadcast, told, "scene", preset="n40", id=1)
    tick_until(broadcast, lambda: told.answer(1))
    assert broadcast.playing is playing


def test_a_scene_plays_after_one_that_broke(told: Told) -> None:
    broadcast = broadcasting(told, r4(), playing=True)
    send(broadcast, told, "set", name="spring_constant", value=1e6)
    tick_until(broadcast, lambda: told.of("broken"))
    assert not broadcast.playing
    send(broadcast, told, "scene", preset="n40", id=1)
    tick_until(broadcast, lambda: told.answer(1))
    assert broadcast.playing
