"""Frames as bytes, mailboxes, the pace of play: what the wire and the clock promise."""

from __future__ import annotations

import asyncio
import json

import numpy as np
import pytest

from live.drive import do, r4, slack_rope
from patience import PATIENCE
from ropewalk.live import describe, pace
from ropewalk.live.broadcast import Broadcast
from ropewalk.live.commands import parse
from ropewalk.live.frame import HEADER, SCALARS
from ropewalk.live.hub import UNACKNOWLEDGED, Hub, Mailbox
from ropewalk.live.session import Session
from ropewalk.scene import Force


def parts(broadcast: Broadcast, variant: int = 0) -> dict[str, np.ndarray]:
    """Take a frame apart as the layout message says."""
    data, layout = broadcast.frame(), describe.layout(broadcast.session)
    about = layout["variants"][variant]
    n, spot = about["nodes"], about["offsets"]
    assert len(data) == layout["bytes"]
    return {
        "scalars": np.frombuffer(data, "<f4", len(layout["scalars"]), spot["scalars"]),
        "positions": np.frombuffer(data, "<f4", 3 * n, spot["positions"]).reshape(n, 3),
        "tension": np.frombuffer(data, "<u2", n, spot["tension"]),
        "speed": np.frombuffer(data, "<u2", n, spot["speed"]),
        "anchors": np.frombuffer(data, "<f4", 10 * len(about["anchors"]), spot["anchors"]).reshape(
            -1, 10
        ),
        "grabs": np.frombuffer(data, "<f4", 64, spot["grabs"]).reshape(8, 8),
    }


@pytest.fixture
def broadcast() -> Broadcast:
    session = r4()
    session.advance(900)
    return Broadcast(session, playing=False)


def test_a_frame_holds_what_the_simulation_has(broadcast: Broadcast) -> None:
    do(broadcast.session, "grab", node=7, target=[7.0, 2.0, 0.0])
    broadcast.session.advance(5)
    simulation, found = broadcast.session.main.simulation, parts(broadcast)
    scalars = dict(zip(SCALARS, found["scalars"], strict=True))
    assert np.array_equal(found["positions"], simulation.positions.astype("f4"))
    low, high = scalars["tension_low"], scalars["tension_high"]
    tension = low + found["tension"][:40] / 65535.0 * (high - low)
    true = simulation.recording().recording.tension[0]
    # half a step of 16 bits, and the rounding of single precision
    assert np.abs(tension - true).max() <= (high - low) * (0.5 / 65535 + 3e-7)
    speed = found["speed"] / 65535.0 * scalars["speed_high"]
    true = np.linalg.norm(simulation.velocities, axis=1)
    assert np.abs(speed - true).max() <= scalars["speed_high"] * (0.5 / 65535 + 3e-7)
    assert scalars["tension_max"] == pytest.approx(high)
    assert scalars["time"] == pytest.approx(simulation.time)
    for row, handle in enumerate(simulation.anchors.values()):
        assert found["anchors"][row, :3] == pytest.approx(handle.position, abs=1e-6)
        assert found["anchors"][row, 6:9] == pytest.approx(handle.reaction, rel=1e-5, abs=1e-4)
        assert found["anchors"][row, 9] == 1.0
    assert list(found["grabs"][:, 0]) == [7.0] + [-1.0] * 7
    assert found["grabs"][0, 1:4] == pytest.approx([7.0, 2.0, 0.0])
    assert found["grabs"][0, 4:7] == pytest.approx(broadcast.session.main.hands.grabs[0].force)


def test_the_header_says_when_and_how(broadcast: Broadcast) -> None:
    head = HEADER.unpack_from(broadcast.frame())
    assert head[0] == int.from_bytes(b"RWPF", "little")
    assert head[1] == broadcast.layout_number
    assert head[3] == 0
    assert head[4] == broadcast.session.time
    assert head[5] == 900.0


def test_the_layout_tells_what_the_scene_gives() -> None:
    scene = slack_rope(20)
    rope = scene.ropes[0].replace(forces=[Force(node=-1, force=(0, 30, -40))], submerged_weight=-2)
    [made] = describe.layout(Session(scene.replace(ropes=[rope])))["variants"]
    assert made["forces"] == [{"index": 20, "force": [0.0, 30.0, -40.0]}]
    assert made["ropes"][0]["submerged_weight"] == -2.0
    [plain] = describe.layout(Session(scene))["variants"]
    assert plain["forces"] == []
    assert plain["ropes"][0]["submerged_weight"] is None


def test_every_variant_has_its_place(broadcast: Broadcast) -> None:
    do(broadcast.session, "compare", variants=[{"changes": {"segments": 60, "time_step": 2e-4}}])
    broadcast.session.advance(200)
    broadcast.refresh()
    first, second = parts(broadcast, 0), parts(broadcast, 1)
    assert len(second["positions"]) == 61
    other = broadcast.session.tracks[1].simulation
    assert np.array_equal(second["positions"], other.positions.astype("f4"))
    scalars = dict(zip(SCALARS, second["scalars"], strict=True))
    assert 0.0 < scalars["difference"] <= scalars["difference_max"] < 1.0
    assert dict(zip(SCALARS, first["scalars"], strict=True))["difference"] == 0.0


def test_a_new_layout_is_counted_only_when_frames_change(broadcast: Broadcast) -> None:
    before = broadcast.layout_number
    do(broadcast.session, "set", name="mass", value=3.0)
    broadcast.refresh()
    assert broadcast.layout_number == before
    do(broadcast.session, "pin", node=10)
    broadcast.refresh()
    assert broadcast.layout_number == before + 1


def test_the_energies_of_a_frame_balance() -> None:
    session = Session(slack_rope(20))
    broadcast = Broadcast(session, playing=False)
    for kind, keys in (
        ("set", {"name": "mass", "value": 4.0}),
        ("kick", {"node": 5, "velocity": [0.0, 2.0, 1.0]}),
        ("set", {"name": "gravity", "value": [0.0, 1.0, -5.0]}),
        ("cut", {"segment": 12}),
    ):
        session.advance(500)
        do(session, kind, **keys)
    session.advance(500)
    found = dict(zip(SCALARS, parts(broadcast)["scalars"], strict=True))
    now = found["kinetic"] + found["gravity"] + found["elastic"]
    first = session.main.first_energy - session.main.first_gravity
    assert now - first == pytest.approx(
        found["put_in"] - found["lost"] + found["energy_error"], abs=1e-3
    )
    assert abs(found["energy_error"]) < 0.02 * abs(found["put_in"])


def test_gravity_is_counted_from_the_start() -> None:
    scene = slack_rope(20)
    shape = scene.ropes[0].shape.replace(start=(0.0, 0.0, 5000.0), end=(8.0, 0.0, 5000.0))
    session = Session(scene.replace(ropes=[scene.ropes[0].replace(shape=shape)]))
    broadcast = Broadcast(session, playing=False)
    at = SCALARS.index("gravity")
    assert parts(broadcast)["scalars"][at] == 0.0  # on a mountain, too
    heights = session.main.simulation.positions[:, 2].copy()
    session.advance(3000)
    fallen = session.main.simulation.positions[:, 2] - heights
    expected = 9.81 * float(session.main.simulation.arrays.mass @ fallen)
    assert parts(broadcast)["scalars"][at] == pytest.approx(expected, rel=1e-3)


def test_of_many_alike_only_the_last_is_carried_out(broadcast: Broadcast) -> None:
    answers: list[dict[str, object]] = []
    for number, value in enumerate((2.0, 2.5, 3.0)):
        command = parse({"type": "set", "name": "mass", "value": value, "id": number})
        broadcast.submit(command, 1, answers.append)
    broadcast.submit(
        parse({"type": "set", "name": "length", "value": 41, "id": 9}), 1, answers.append
    )
    seen: list[str] = []
    broadcast.session.on_command = lambda count, client, command: seen.append(command.type)
    broadcast.handle()
    assert seen == ["set", "set"]
    assert [answer["id"] for answer in answers] == [0, 1, 2, 9]
    assert broadcast.session.scene.ropes[0].own_mass == pytest.approx(3.0)


def test_a_mailbox_keeps_the_newest_and_waits_for_the_page() -> None:
    async def talk() -> None:
        box, got = Mailbox(1), []
        for number in range(1, 8):
            box.put_frame(number, bytes([number]))
            if box.on_the_way < UNACKNOWLEDGED:
                got.append((await box.take())[1])
        assert got == [b"\x01", b"\x02", b"\x03"]
        waiting = asyncio.create_task(box.take())
        await asyncio.sleep(0.01)
        assert not waiting.done()
        box.acknowledge(2)  # and with it the first
        assert (await waiting)[1] == b"\x07"
        assert box.on_the_way == 2
        box.put_text("status", "old")
        box.put_text("status", "new")
        box.put_text("done", "a")
        box.put_text("done", "b")
        assert (await box.take())[0] == ["new", "a", "b"]

    asyncio.run(talk())


def test_a_page_that_was_told_nothing_yet_is_told_of_the_end() -> None:
    async def talk() -> None:
        hub = Hub()
        hub.attach(asyncio.get_running_loop())
        early = hub.enter()
        hub.tell({"type": "status", "speed": 1.0})
        hub.tell({"type": "bye", "text": "The server has ended.", "folder": None})
        texts, frame = await asyncio.wait_for(early.take(), PATIENCE)
        assert [json.loads(text)["type"] for text in texts] == ["bye"]
        assert frame is None

    asyncio.run(talk())


class Clock:
    """A clock that goes as it is told."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def run(
    monkeypatch: pytest.MonkeyPatch, cost: float, speed: float, seconds: float = 2.0
) -> tuple[float, pace.Pace]:
    """Play for so long with steps of 1 ms that cost so much; return simulated seconds."""
    clock = Clock()
    monkeypatch.setattr(pace.time, "perf_counter", clock)
    kept, simulated = pace.Pace(), 0.0
    while clock.now < 100.0 + seconds:
        begun = clock.now
        steps = kept.steps(1e-3, speed)
        kept.begin()
        clock.now += steps * cost
        kept.end(steps, steps)
        simulated += steps * 1e-3
        kept.note(simulated)
        clock.now = max(clock.now, begun + pace.TICK)
    return simulated, kept


@pytest.mark.parametrize("speed", [0.01, 0.5, 1.0, 4.0])
def test_play_is_as_fast_as_asked(monkeypatch: pytest.MonkeyPatch, speed: float) -> None:
    simulated, kept = run(monkeypatch, 1e-5, speed)
    assert simulated == pytest.approx(2.0 * speed, abs=0.02 * speed + 2e-3)
    assert not kept.slow
    assert kept.realtime == pytest.approx(speed, rel=0.1, abs=3e-3)


def test_what_is_too_slow_goes_slower_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    simulated, kept = run(monkeypatch, 2.5e-3, 1.0)  # a step takes 2.5 times what it stands for
    assert simulated == pytest.approx(0.85 * 2.0 / 2.5, rel=0.15)
    assert kept.slow
    assert kept.realtime == pytest.approx(0.85 / 2.5, rel=0.2)


def test_steps_of_a_fifth_of_a_second_are_too_slow_and_say_so(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With so few of them in half a second nothing was said, and hands took it for real time."""
    _, kept = run(monkeypatch, 0.2, 1.0, 10.0)
    assert kept.slow
    assert kept.realtime == pytest.approx(1e-3 / 0.2, rel=0.2)


def test_hands_do_not_hide_how_slow_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """A drag came with every picture, and with it the pace began anew: nobody knew that it was slow."""
    clock = Clock()
    monkeypatch.setattr(pace.time, "perf_counter", clock)
    broadcast = Broadcast(Session(slack_rope()))

    def steps(_: Session, count: int, seconds: float) -> int:
        clock.now += 0.05
        return 1

    monkeypatch.setattr("ropewalk.live.broadcast.advance_within", steps)
    for picture in range(40):
        drag = {"type": "drag", "anchor": "right", "target": [8.0, 0.0, 0.01 * picture]}
        broadcast.submit(parse(drag), 1, lambda _: None)
        clock.now += 1e-3
        broadcast.tick()
    assert broadcast.pace.slow
    assert broadcast.status()["slow"]


def test_a_pause_of_the_computer_is_no_jump(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    monkeypatch.setattr(pace.time, "perf_counter", clock)
    kept = pace.Pace()
    clock.now += 10.0
    assert kept.steps(1e-3, 1.0) * 1e-3 <= pace.LONGEST
