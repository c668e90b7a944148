"""Nothing holds the broadcast: steps in slices; scenes, large edits and the reasons of breaks beside it."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from live.drive import do, r4, slack_rope
from patience import PATIENCE
from ropewalk.core.status import OK
from ropewalk.live import breaks, describe, opening, stepper
from ropewalk.live.broadcast import Broadcast
from ropewalk.live.commands import parse
from ropewalk.live.inbox import MOST_WAITING, Inbox, Item
from ropewalk.live.keeper import Keeper
from ropewalk.live.relive import relive
from ropewalk.live.session import Session
from ropewalk.live.toil import MANY, takes_long
from ropewalk.scene import RunSettings, Scene


class Told:
    """An audience, and pages' replies."""

    size = 1

    def __init__(self) -> None:
        self.messages: list[dict[str, Any]] = []

    def show(self, number: int, frame: bytes, combine: object = None) -> None:
        """Take a frame."""

    def tell(self, message: dict[str, Any]) -> None:
        """Take a message."""
        self.messages.append(message)

    def of(self, kind: str) -> list[dict[str, Any]]:
        """Return the messages of a kind."""
        return [one for one in self.messages if one["type"] == kind]

    def answer(self, number: int) -> dict[str, Any] | None:
        """Return the answer to a command."""
        return next((one for one in self.messages if one.get("id") == number), None)


@pytest.fixture
def told() -> Told:
    return Told()


@pytest.fixture
def gate() -> Iterator[threading.Event]:
    """Something that other threads wait for; open at the end, so that none is left."""
    made = threading.Event()
    yield made
    made.set()


def broadcasting(told: Told, session: Session, *, playing: bool = False) -> Broadcast:
    """Return a broadcast that an audience sees."""
    broadcast = Broadcast(session, playing=playing)
    broadcast.audience = told
    return broadcast


def send(broadcast: Broadcast, told: Told, kind: str, client: int = 1, **keys: Any) -> None:
    """Send a command."""
    broadcast.submit(parse({"type": kind, **keys}), client, told.tell)


def tick_until(broadcast: Broadcast, ready: Callable[[], Any]) -> None:
    """Tick until something is there."""
    end = time.monotonic() + PATIENCE
    while not ready():
        assert time.monotonic() < end, "waited in vain"
        broadcast.tick()
        time.sleep(0.002)


class Costly:
    """A session whose steps take time on a clock of their own."""

    def __init__(self, cost: float) -> None:
        self.cost, self.now, self.count = cost, 50.0, 0

    def advance(self, count: int) -> int:
        """Take steps."""
        self.count += count
        self.now += count * self.cost
        return OK


@pytest.mark.parametrize("cost", [1e-6, 1e-4, 3e-3, 0.2])
def test_steps_are_taken_while_there_is_time(monkeypatch: pytest.MonkeyPatch, cost: float) -> None:
    session: Any = Costly(cost)
    monkeypatch.setattr(stepper.time, "perf_counter", lambda: session.now)
    done = stepper.advance_within(session, 10_000, 0.014)
    assert done == session.count
    assert session.now - 50.0 <= 0.014 + cost  # a single step is not divided
    assert done == 10_000 or session.now - 50.0 >= 0.9 * 0.014
    assert stepper.advance_within(session, 3, 1e9) == 3


def test_many_steps_of_a_large_scene_come_in_slices(told: Told) -> None:
    scene = slack_rope(20_000).replace(run=RunSettings(duration=1.0, time_step=1e-8))
    broadcast = broadcasting(told, Session(scene))
    send(broadcast, told, "step", count=10_000, id=1)
    broadcast.tick()
    first = broadcast.count
    assert 0 < first < 10_000
    assert told.answer(1) is None
    broadcast.tick()
    assert first < broadcast.count < 10_000
    send(broadcast, told, "step", count=9_999, id=2)
    broadcast.tick()
    assert "that are still being taken" in told.answer(2)["text"]
    send(broadcast, told, "pause", id=3)
    broadcast.tick()
    assert told.answer(1)["type"] == told.answer(3)["type"] == "done"
    count = broadcast.count
    broadcast.tick()
    assert broadcast.count == count


def test_steps_in_slices_are_the_same_steps(told: Told) -> None:
    broadcast = broadcasting(told, Session(slack_rope(40)))
    send(broadcast, told, "step", count=1000, id=1)
    send(broadcast, told, "step", count=234, id=2)
    tick_until(broadcast, lambda: told.answer(2))
    twin = Session(slack_rope(40))
    twin.advance(1234)
    assert broadcast.count == 1234
    here, there = broadcast.session.main.simulation, twin.main.simulation
    assert here.positions.tobytes() == there.positions.tobytes()


def test_a_scene_is_opened_while_the_present_one_plays(
    told: Told, gate: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    def read(text: str) -> Scene:
        gate.wait(PATIENCE)
        return slack_rope(12)

    monkeypatch.setattr(opening, "read_apart", read)
    broadcast = broadcasting(told, r4(), playing=True)
    send(broadcast, told, "scene", toml="x", id=1)
    send(broadcast, told, "set", name="mass", value=3.0, id=2)  # for the new scene: it waits
    send(broadcast, told, "set", client=2, name="mass", value=4.0, id=3)
    tick_until(broadcast, lambda: told.answer(3))
    count = broadcast.count
    tick_until(broadcast, lambda: broadcast.count > count)
    assert told.answer(1) is told.answer(2) is None
    send(broadcast, told, "scene", client=3, preset="r4", id=4)
    send(broadcast, told, "scene", client=3, preset="n40", id=5)
    tick_until(broadcast, lambda: told.answer(4))
    assert "Another scene has been asked for since" in told.answer(4)["text"]
    gate.set()
    tick_until(broadcast, lambda: told.answer(2) and told.answer(5))
    kinds = [told.answer(number)["type"] for number in (1, 2, 3, 5)]
    assert kinds == ["done"] * 4
    assert broadcast.session.preset == "n40"


def test_a_scene_that_is_none_changes_nothing(told: Told) -> None:
    broadcast = broadcasting(told, r4())
    before = broadcast.session.main.simulation
    send(broadcast, told, "scene", toml="rope = 3", id=1)
    tick_until(broadcast, lambda: told.answer(1))
    assert told.answer(1)["type"] == "error"
    assert broadcast.session.main.simulation is before
    send(broadcast, told, "scene", address="scene=r4&mass=2.5", id=2)
    tick_until(broadcast, lambda: told.answer(2))
    assert broadcast.address == "scene=r4&mass=2.5"
    assert broadcast.session.scene.ropes[0].own_mass == pytest.approx(2.5)


def test_what_a_large_scene_takes_long_for_is_done_beside_the_stage(
    told: Told, gate: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    broadcast = broadcasting(told, Session(slack_rope(MANY)), playing=True)
    assert not takes_long(parse({"type": "set", "name": "mass", "value": 1}), r4())
    assert takes_long(parse({"type": "set", "name": "method", "value": "rk4"}), r4())
    apply = broadcast.session.apply

    def slowly(*args: Any) -> str:
        gate.wait(PATIENCE)
        return apply(*args)

    monkeypatch.setattr(broadcast.session, "apply", slowly)
    send(broadcast, told, "set", name="mass", value=3.0, id=1)
    send(broadcast, told, "kick", node=9, velocity=[0, 0, 1], id=2)
    for _ in range(5):
        broadcast.tick()  # comes back
    assert told.messages == []
    gate.set()
    tick_until(broadcast, lambda: told.answer(2))
    assert broadcast.session.scene.ropes[0].own_mass == pytest.approx(3.0)
    shown = told.of("parameters")[-1]["parameters"]
    assert next(one["value"] for one in shown if one["name"] == "mass") == pytest.approx(3.0)


def test_a_break_is_told_at_once_and_explained_when_it_is_understood(
    told: Told, gate: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer = breaks.Question.answer

    def slowly(self: breaks.Question) -> dict[str, Any]:
        gate.wait(PATIENCE)
        return answer(self)

    monkeypatch.setattr(breaks.Question, "answer", slowly)
    broadcast = broadcasting(told, r4(), playing=True)
    send(broadcast, told, "set", name="spring_constant", value=1e6)
    tick_until(broadcast, lambda: told.of("broken"))
    (first,) = told.of("broken")
    assert "being looked at" in first["text"]
    assert [one["id"] for one in first["remedies"]] == ["back", "step", "implicit"]
    gate.set()
    tick_until(broadcast, lambda: len(told.of("broken")) > 1)
    assert "above the largest stable one" in told.of("broken")[-1]["text"]


def test_a_break_stays_while_constants_are_changed(told: Told) -> None:
    broadcast = broadcasting(told, r4(), playing=True)
    send(broadcast, told, "set", name="spring_constant", value=1e6)
    # a slow computer says first that it looks for the reason
    tick_until(broadcast, lambda: told.of("broken") and told.of("broken")[-1]["cause"])
    said = told.of("broken")[-1]["text"]
    send(broadcast, told, "set", name="spring_constant", value=1.1e6, id=1)
    tick_until(broadcast, lambda: told.of("broken")[-1]["remedies"][-1]["id"] == "on")
    assert told.of("broken")[-1]["text"] == said
    assert told.of("status")[-1]["broken"]
    assert not broadcast.playing
    send(broadcast, told, "set", name="spring_constant", value=1e4)
    tick_until(broadcast, lambda: told.of("broken")[-1]["remedies"][0]["id"] == "on")
    count = broadcast.count
    send(broadcast, told, "remedy", remedy="on", id=2)
    tick_until(broadcast, lambda: broadcast.count > count + 20)
    assert broadcast.playing
    assert not told.of("status")[-1]["broken"]


def test_a_break_that_was_gone_on_from_is_played_again(tmp_path: Any) -> None:
    session = r4()
    keeper = Keeper(session, tmp_path / "run")
    session.advance(500)
    do(session, "set", name="spring_constant", value=1e6)
    session.advance(500)
    assert session.broken is not None
    do(session, "set", name="spring_constant", value=1e4)
    do(session, "cut", segment=3)
    assert session.broken is not None
    assert session.advance(5) != OK
    do(session, "remedy", remedy="on")
    session.advance(100)
    keeper.close()
    again = relive(tmp_path / "run").main.simulation
    assert again.positions.tobytes() == session.main.simulation.positions.tobytes()


def test_only_so_many_commands_wait(told: Told) -> None:
    inbox = Inbox(lambda command, reply: None)
    for number in range(MOST_WAITING + 3):
        inbox.put(Item(parse({"type": "play", "id": number}), 1, told.tell))
    for number in range(50):
        drag = {"type": "drag", "anchor": "left", "target": [number, 0, 0]}
        inbox.put(Item(parse(drag), 2, told.tell))
    inbox.gather()
    assert len(told.of("error")) == 4
    assert "commands wait already" in told.messages[0]["text"]
    assert inbox.take({1: ()}) is None  # of the drags, one was left, and that was refused, too
    assert inbox.take({}).what.id == 0


def test_a_page_that_comes_is_told_of_the_presets_without_reading_them(
    monkeypatch: pytest.MonkeyPatch, told: Told
) -> None:
    """They take 50 ms of a tick; they were read when the broadcast was made."""
    broadcast = Broadcast(Session(slack_rope(20)), playing=False)
    monkeypatch.setattr(describe, "preset", None)
    broadcast.join(told.tell)
    [message] = told.of("presets")
    assert len(message["presets"]) > 20
