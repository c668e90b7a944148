"""No picture misses a peak: frames show the greatest and least of every step since the one before."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from live.drive import do
from ropewalk.live import describe
from ropewalk.live.broadcast import Broadcast
from ropewalk.live.frame import HEADER, SCALARS, Ranges, Shape, combined
from ropewalk.live.hub import Mailbox
from ropewalk.live.keeper import Keeper
from ropewalk.live.packed_run import record
from ropewalk.live.packing import Packed, unpack
from ropewalk.live.pictures import combiner
from ropewalk.live.program import ProgramBroadcast
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.seen import Seen
from ropewalk.live.session import Session
from ropewalk.record.result import Result
from ropewalk.scene import Anchor, Kick, Load, Material, Rope, RunSettings, Scene, Straight
from ropewalk.simulation import Simulation

DT = 1e-4
FRAME = 167  # steps, about 1/60 s; the catch is over in 70 of them


def catch(rate: float = 60.0) -> Scene:
    """10 kg at 3 m/s, caught by a stiff rope: the force comes and goes between two frames."""
    rope = Rope(
        segments=8,
        length=2.0,
        made_of=Material(EA=1e6, mass_per_length=0.5, axial_damping=20.0),
        shape=Straight(start=(0, 0, 2), end=(0, 0, 0)),
        loads=[Load(node=-1, mass=10.0)],
        kicks=[Kick(node=-1, velocity=(0, 0, -3))],
    )
    run = RunSettings(
        duration=0.2,
        frame_rate=rate,
        time_step=DT,
        steps="exact",
        method="semi-implicit-euler",
    )
    return Scene(ropes=[rope], anchors=[Anchor(name="top", node=0)], run=run)


class Kept:
    """An audience that keeps its frames."""

    size = 1

    def __init__(self) -> None:
        self.frames: list[bytes] = []

    def show(self, number: int, frame: bytes, combine: object = None) -> None:
        """Keep a frame."""
        self.frames.append(frame)

    def tell(self, message: dict[str, object]) -> None:
        """Hear nothing."""


def broadcasting(session: Session) -> tuple[Broadcast, Kept]:
    broadcast = Broadcast(session, playing=False)
    broadcast.audience = kept = Kept()
    return broadcast, kept


def read(frame: bytes, layout: dict, variant: int = 0) -> tuple[dict[str, float], Seen]:  # type: ignore[type-arg]
    """Return scalars and what was seen, of one variant."""
    about = layout["variants"][variant]
    spot, n = about["offsets"], about["nodes"]
    row = np.frombuffer(frame, "<f4", len(SCALARS), spot["scalars"]).astype(float)
    scalars = dict(zip(SCALARS, row, strict=True))
    ranges = Ranges(*(scalars[name] for name in Ranges._fields))
    found = {}
    for name in Seen._fields[:-1]:
        low, high = ranges.of(name)
        raw = np.frombuffer(frame, "<u2", n, spot[name]).astype(float)
        found[name] = (low + raw * (high - low) / 65535)[: n - 1 if "tension" in name else n]
    force = np.frombuffer(frame, "<f4", len(about["anchors"]), spot["greatest_force"])
    return scalars, Seen(**found, greatest_force=force.astype(float))


class Every:
    """The same run, looked at after every step."""

    def __init__(self, scene: Scene) -> None:
        self.simulation = Simulation(scene)
        self.rows = [self._row()]

    def _row(self) -> Seen:
        recording = self.simulation.recording().recording
        speed = np.linalg.norm(self.simulation.velocities, axis=1)
        heights = self.simulation.positions[:, 2].copy()
        return Seen.instant(recording.tension[0], speed, heights, recording.reaction[0])

    def interval(self, steps: int) -> Seen:
        """Take steps; return what was seen on the way, both ends included."""
        found = self._row()
        for _ in range(steps):
            assert self.simulation.advance_steps(1) == 0
            found = found.joined(self._row())
        return found


def close(found: Seen, true: Seen, scalars: dict[str, float]) -> None:
    """Assert that a frame says what was seen, to the digits that it has."""
    pull = scalars["tension_high"] - scalars["tension_low"]
    room = (pull, pull, scalars["speed_high"], *(scalars["high"] - scalars["low"],) * 2)
    for name, mine, width in zip(Seen._fields, found, (*room, 1.0), strict=True):
        there = getattr(true, name)
        if name == "greatest_force":
            assert mine == pytest.approx(there, rel=1e-6)
        else:
            assert np.abs(mine - there).max() <= width * (0.5 / 65535 + 1e-6) + 1e-6, name
    assert scalars["tension_max"] == pytest.approx(max(0.0, true.greatest_tension.max()), rel=1e-6)
    assert scalars["speed_high"] == pytest.approx(true.greatest_speed.max(), rel=1e-6)
    assert scalars["high"] == pytest.approx(true.greatest_height.max(), rel=1e-6)
    assert scalars["low"] == pytest.approx(true.least_height.min(), rel=1e-6, abs=1e-6)


def test_frames_have_what_every_step_has_however_they_are_cut() -> None:
    """Pieces of other lengths, slow motion, a tweak in between: the same as a look at every step."""
    broadcast, kept = broadcasting(session := Session(catch()))
    layout, every = describe.layout(session), Every(catch())
    broadcast.show()
    close(read(kept.frames[0], layout)[1], every.rows[0], read(kept.frames[0], layout)[0])
    instants = []
    for pieces in ((1, 100, 66), (3,), (1, 1, 1), (160, 4, 170, 30), (2, 70)):
        for piece in pieces:
            session.advance(piece)
        if pieces == (3,):
            do(session, "set", name="diameter", value=0.02)  # nothing that changes the motion
        broadcast.show()
        scalars, found = read(kept.frames[-1], layout)
        close(found, every.interval(sum(pieces)), scalars)
        instants.append(float(session.main.simulation.recording().recording.tension[0].max()))
        if pieces[0] == 1 and len(pieces) == 3 and pieces[1] == 100:
            assert scalars["tension_max"] > 5.0 * instants[0]  # the twin: a sampled graph misses it


def test_a_change_of_constants_keeps_what_was_seen() -> None:
    broadcast, kept = broadcasting(session := Session(catch()))
    layout, every = describe.layout(session), Every(catch())
    broadcast.show()
    session.advance(FRAME)
    peak = every.interval(FRAME).greatest_tension.max()
    do(session, "set", name="spring_friction", value=30.0)
    session.advance(1)
    broadcast.show()
    assert read(kept.frames[-1], layout)[0]["tension_max"] == pytest.approx(peak, rel=1e-6)
    session.advance(1)
    broadcast.show()
    assert read(kept.frames[-1], layout)[0]["tension_max"] < 0.5 * peak  # and begins again


def test_a_reset_forgets_and_a_hand_and_copies_are_seen() -> None:
    broadcast, kept = broadcasting(session := Session(catch()))
    broadcast.show()
    first = read(kept.frames[-1], describe.layout(session))[0]["tension_max"]
    do(session, "compare", variants=[{"label": "soft", "changes": {"mass": 1.2}}])
    layout = describe.layout(session)
    for track in session.tracks:
        assert track.shown.kept is None
    do(session, "grab", node=5, target=[0.5, 0.0, 1.0])
    session.advance(FRAME)
    firsts = [track.shown.kept for track in session.tracks]
    broadcast.show()
    for variant, one in enumerate(firsts):
        assert one is not None
        scalars, _ = read(kept.frames[-1], layout, variant)
        assert scalars["tension_max"] == pytest.approx(one.tension_high.max(), rel=1e-6)
        assert scalars["tension_max"] > 1000.0
    session.advance(20)
    do(session, "reset")
    broadcast.show()
    assert read(kept.frames[-1], layout)[0]["tension_max"] == first  # as at the start


def test_steps_that_are_undone_are_not_seen() -> None:
    session = Session(catch())
    session.advance(10)
    before = session.main.shown.kept
    do(session, "set", name="EA", value=1e9)
    do(session, "grab", node=5, target=[0.5, 0.0, 1.0])  # so that it moves in many calls
    kept = session.main.shown.kept
    while session.broken is None:
        kept = session.main.shown.kept
        session.advance(FRAME)
    assert before is not None
    assert session.main.shown.kept is kept


def test_what_a_page_did_not_get_is_in_its_next_frame() -> None:
    broadcast, kept = broadcasting(session := Session(catch()))
    layout, every = describe.layout(session), Every(catch())
    broadcast.show()
    box = Mailbox(1)
    for number in range(1, 4):  # so many are on the way
        box.put_frame(number, kept.frames[0])
        box._sent.append(number)
        box._frame = None
    total = every.rows[0]
    for number, steps in enumerate((100, 67, 40, 3), start=4):
        session.advance(steps)
        broadcast.show()
        box.put_frame(number, kept.frames[-1], combiner(session.tracks))
        total = total.joined(every.interval(steps))
    assert box._frame is not None
    scalars, found = read(box._frame[1], layout)
    assert scalars["tension_max"] == pytest.approx(total.greatest_tension.max(), rel=1e-6)
    assert HEADER.unpack_from(box._frame[1])[4] == session.time
    pull = scalars["tension_high"] - scalars["tension_low"]
    assert np.abs(found.greatest_tension - total.greatest_tension).max() < pull * 4 / 65535
    assert np.abs(found.least_height - total.least_height).max() < 1e-4
    assert found.greatest_force == pytest.approx(total.greatest_force, rel=1e-6)
    other = bytearray(kept.frames[-1])
    other[4] ^= 1  # of another layout: as it is
    assert combined([Shape(9, 1)], bytes(other), kept.frames[-1]) == kept.frames[-1]


def test_a_program_that_takes_several_steps_misses_none() -> None:
    simulation, every = Simulation(catch()), Every(catch())
    broadcast = ProgramBroadcast(simulation)
    broadcast.audience = kept = Kept()
    simulation.step(100 * DT)
    simulation.step(60 * DT)
    broadcast.tick()
    simulation.advance_frames(2)
    peak = every.interval(160).greatest_tension.max()
    scalars, _ = read(kept.frames[-1], describe.layout(broadcast.session))
    assert scalars["tension_max"] == pytest.approx(peak, rel=1e-6)
    broadcast.tick()
    later = every.interval(2 * simulation.plan.steps_per_frame).greatest_tension.max()
    scalars, _ = read(kept.frames[-1], describe.layout(broadcast.session))
    assert scalars["tension_max"] == pytest.approx(later, rel=1e-6)


def test_replays_show_what_the_frames_passed_over_have() -> None:
    result = rw.simulate(catch(1000.0))
    broadcast = ReplayBroadcast(result, playing=False)
    layout = broadcast.layout(0)

    def told(frame: int, since: int) -> dict[str, float]:
        (shown,) = broadcast.frames_between(frame, 1, frame - since)
        return read(shown, layout)[0]

    scalars = told(17, since=0)
    peak = float(result.greatest_tension[:18].max())
    assert scalars["tension_max"] == pytest.approx(peak, rel=1e-6)
    assert peak > 5.0 * float(result.tension[17].max())
    assert told(17, since=16)["tension_max"] < 0.5 * peak  # a jump passes over nothing
    coarse = [read(one, layout)[0]["tension_max"] for one in broadcast.frames_between(0, 12, 17)]
    assert max(coarse) == pytest.approx(float(result.greatest_tension.max()), rel=1e-6)


def test_a_run_without_extremes_is_replayed_by_its_frames() -> None:
    scene = catch(1000.0)
    result = rw.simulate(scene.replace(run=scene.run.replace(extremes=False)))
    broadcast = ReplayBroadcast(result, playing=False)
    layout = broadcast.layout(0)
    scalars, found = read(next(broadcast.frames_between(17, 1, 17)), layout)
    assert scalars["tension_max"] == pytest.approx(float(result.tension[1:18].max()), rel=1e-6)
    assert found.greatest_force == pytest.approx(
        np.linalg.norm(result.reactions[1:18], axis=2).max(axis=0), rel=1e-6
    )


def test_a_kept_session_records_every_step_however_it_was_cut(tmp_path: Path) -> None:
    """A call of the kernels knows its own steps only; frames of a session are made of many calls."""
    session = Session(catch())
    keeper = Keeper(session, tmp_path / "run")
    for piece in (1, 100, 66, 5, 162, 167):
        session.advance(piece)
    keeper.close()
    found, twin = Result.open(tmp_path / "run"), Session(catch())
    assert found.has_extremes
    true = Simulation(twin.loaded).advance_frames(found.frames - 1).recording
    assert found.frames >= 3
    assert np.array_equal(found.read("greatest_tension", 1), true.tension_high)
    assert np.array_equal(found.read("least_height", 1), true.lowest)
    assert found.read("extremes", 1)[:, :7] == pytest.approx(true.extremes[:, :7], rel=1e-12)
    assert (found.read("extreme_since", 1)[:, 0] <= true.extreme_since[:, 0] + 1e-12).all()
    assert (found.read("extreme_until", 1)[:, 0] >= true.extreme_until[:, 0] - 1e-12).all()
    assert found.energy_errors[1:] == pytest.approx(true.error_range, rel=1e-9, abs=1e-12)
    assert found.read("energy_error_times", 1) == pytest.approx(true.error_times, abs=1e-12)


def test_a_shared_page_has_the_peaks() -> None:
    result = rw.simulate(catch(1000.0))
    made = record_streams(result)
    over = made["tension"] + made["greatest_tension"]
    true = float(result.greatest_tension.max())
    assert over.max() == pytest.approx(true, rel=1e-3)
    assert made["tension"].max() < 0.9 * true  # the twin
    assert made["scalars"][:, SCALARS.index("tension_max")].max() == pytest.approx(true, rel=1e-4)


def test_a_peak_more_than_a_thousand_frames_before_the_next_that_is_shown_is_kept() -> None:
    """`share --fps 0.5` of 1301 frames had 10.3 N for 84.8 N, and so had a replay at a high speed."""
    made_of = rw.Material(EA=1e3, mass_per_length=0.1, tension_only=True, axial_damping=60.0)
    rope = rw.Rope(
        segments=1, length=1.0, made_of=made_of, loads=[{"node": -1, "mass": 1.0}],
        shape={"kind": "straight", "start": (0, 0, 0), "end": (0, 0, -0.9)},
    )  # fmt: skip
    run = {"duration": 1.3, "frame_rate": 1000, "method": "semi-implicit-euler", "time_step": 5e-4}
    result = rw.simulate(rw.Scene(ropes=[rope], anchors=[{"node": 0}], run=run))
    true = float(result.greatest_tension.max())
    assert true > 5.0 * float(result.greatest_tension[300:].max())
    made = record_streams(result, 0.5)
    assert made["scalars"].shape[0] == 2
    assert made["scalars"][:, SCALARS.index("tension_max")].max() == pytest.approx(true, rel=1e-4)
    broadcast = ReplayBroadcast(result, playing=False)
    (shown,) = broadcast.frames_between(1300, 1, 1300)
    assert read(shown, broadcast.layout(0))[0]["tension_max"] == pytest.approx(true, rel=1e-6)


def test_a_shared_page_says_no_more_frames_a_second_than_were_asked_for() -> None:
    """`--fps 60` of a run at 1 kHz said 60.8: the last frame is taken, however soon it comes."""
    result = rw.simulate(catch(1000.0))
    assert " at 60 frames per second" in record(result, 60.0).header["about"]
    assert " at 1000 frames per second" in record(result, 1e4).header["about"]


def test_parts_without_a_frame_are_left_out_of_a_shared_page(tmp_path: Path) -> None:
    """A session of many short parts, of which the page takes not every one."""
    session = Session(catch())
    keeper = Keeper(session, tmp_path / "run")
    session.advance(3 * FRAME)
    for segment in (5, 3):
        do(session, "cut", segment=segment)
    session.advance(FRAME)
    keeper.close()
    assert record(tmp_path / "run", 10.0).frames >= 2


def test_a_light_rope_beside_a_heavy_one_has_its_own_steps_in_a_shared_page() -> None:
    """With one step for all, 2.5 N beside 10 kN, a thread's 0.1 N and its anchor's force were zero."""
    made_of = [rw.Material(EA=1e3 * m, mass_per_length=m, axial_damping=m) for m in (0.01, 1e3)]
    shape = {"kind": "straight", "start": (0, 0, 0), "direction": (0, 0, -1)}
    ropes = [
        rw.Rope(name=name, segments=2, length=1.0, made_of=stuff, shape=shape)
        for name, stuff in zip("ab", made_of, strict=True)
    ]
    run = {"duration": 0.1, "method": "implicit-euler", "time_step": 1 / 60}
    anchors = [{"rope": name, "node": 0} for name in "ab"]
    result = rw.simulate(rw.Scene(ropes=ropes, anchors=anchors, run=run))
    made, true = record_streams(result), result.rope("a").tension
    assert np.abs(made["tension"][:, :2] - true).max() < 3e-3 * true.max()
    pull = np.linalg.norm(result.read("reactions")[:, 0], axis=1)
    assert made["force"][:, 2] == pytest.approx(pull, abs=3e-3 * pull.max())


def record_streams(result: Result, rate: float = 60.0) -> dict[str, np.ndarray]:
    """Return the streams of a shared page as its script unpacks them."""
    made = record(result, rate)
    [part] = made.header["parts"]
    at, found = made.header["times"]["bytes"], {}
    for one in part["streams"]:
        data = made.data[at : at + one["bytes"]]
        at += one["bytes"]
        head = {key: one[key] for key in ("name", "columns", "low", "step", "order", "planes")}
        found[one["name"]] = unpack(Packed(**head, data=data, error=0.0), part["frames"])
    return found
