"""What frames tell of contacts: ropes on ropes, wraps, friction's work; live, replayed and packed alike."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from live.drive import do
from ropewalk.live import recorded_touch, touch
from ropewalk.live.broadcast import Broadcast
from ropewalk.live.packed_run import record
from ropewalk.live.packed_touch import in_places, touch_streams
from ropewalk.live.packing import unpack
from ropewalk.live.pictures import Compared, picture, pictures
from ropewalk.live.recorded import Recorded, followed
from ropewalk.live.session import Session
from ropewalk.live.touch import MOST_PAIRS, MOST_WRAPS, PAIR, WRAP, pair_rows
from ropewalk.record.result import Result
from ropewalk.scene import Scene, loads
from ropewalk.scene.presets import preset


def over_a_drum(more: str = "") -> Scene:
    """A rope of 0.7 N/m that slides over a drum, one end heavier by 4 N, and lies on a floor by its other."""
    return loads(f"""
name = "Over a drum"
[run]
duration = 0.2
frame_rate = 50.0
time_step = 0.002
method = "implicit-euler"
[[rope]]
name = "line"
segments = 40
length = 1.2
diameter = 0.02
made_of = {{ kind = "material", EA = 2e3, mass_per_length = 0.07, axial_damping = 5.0 }}
shape = {{ kind = "polyline", points = [
  [-0.16, 0, -0.36], [-0.16, 0, 0.07], [-0.08, 0, 0.17], [0.08, 0, 0.17], [0.16, 0, 0.07],
  [0.16, 0, -0.36]] }}
[[rope.load]]
node = 0
mass = 0.2
[[rope.load]]
node = -1
mass = 0.6
[[obstacle]]
name = "drum"
kind = "cylinder"
from = [0, -0.2, 0]
to = [0, 0.2, 0]
radius = 0.15
friction = 0.2
[[obstacle]]
name = "floor"
kind = "plane"
point = [0.0, 0.0, -0.42]
{more}
""")


@pytest.fixture(scope="module")
def run() -> Result:
    return rw.simulate(over_a_drum())


@pytest.fixture(scope="module")
def crossing() -> Result:
    scene = preset("crossing")
    return rw.simulate(scene.replace(run=scene.run.replace(duration=0.4)))


def there(rows: np.ndarray) -> np.ndarray:
    """Return the rows that are in use."""
    return rows[rows[:, 0] >= 0.0]


def table(result: Result, frame: int) -> dict[str, Any]:
    """Return the row of the run's own table of wraps for the drum at a frame."""
    every = result.to_pandas("wraps")
    here = every[(every["time [s]"] == result.time[frame]) & (every["obstacle"] == "drum")]
    (row,) = here.to_dict("records")
    return {str(name): value for name, value in row.items()}


def test_a_replay_tells_wraps_as_the_run_s_table_does(run: Result) -> None:
    recorded = Recorded(run)
    for frame in (5, 7, run.frames - 1):  # the last was told as up to 0.1 s before it
        told = recorded.picture(frame).touch
        assert told.scalars["wrap_age"] == 0.0
        assert told.scalars["wraps"] == 1.0
        [[rope, obstacle, first, last, angle, before, after, grip]] = there(told.wraps)
        known = table(run, frame)
        assert (rope, obstacle) == (0, 0)
        assert (first, last) == (known["first node"], known["last node"])
        assert angle == pytest.approx(known["angle [rad]"])
        assert angle > 1.5
        assert before == pytest.approx(known["tension before [N]"])
        assert after == pytest.approx(known["tension after [N]"])
        assert math.exp(grip) == pytest.approx(known["ratio at slip [1]"])
        ratio = max(before, after) / min(before, after)
        assert ratio == pytest.approx(known["ratio [1]"])


def test_of_long_ropes_wraps_are_told_now_and_then_and_at_last(
    run: Result, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorded_touch, "_FEW", run.nodes - 1)
    monkeypatch.setattr(recorded_touch, "_PER_NODE", 0.06 / run.nodes)
    recorded, last = Recorded(run), run.frames - 1
    assert recorded.touched.every == 3  # 0.06 s at 50 frames a second
    ages = {n: recorded.picture(n).touch.scalars["wrap_age"] for n in (3, 5, 6, last)}
    assert last % 3
    assert ages == pytest.approx({3: 0.0, 5: 0.04, 6: 0.0, last: 0.0})
    late = there(recorded.picture(5).touch.wraps)
    assert late == pytest.approx(there(recorded.picture(3).touch.wraps))


def test_a_live_session_tells_them_as_a_replay_does(run: Result) -> None:
    session = Session(over_a_drum())
    session.advance(100)
    [live] = pictures(session.tracks, Compared())
    told = Recorded(run).picture(10).touch
    assert live.touch.room == told.room
    assert there(live.touch.wraps) == pytest.approx(there(told.wraps), rel=1e-6)
    assert live.touch.force == pytest.approx(told.force, rel=1e-6, abs=1e-9)
    assert live.touch.rubbed == pytest.approx(told.rubbed, rel=1e-6, abs=1e-12)
    assert live.touch.rubbed[0] < -1e-3  # it has slid


def test_a_floor_has_no_wraps() -> None:
    scene = over_a_drum()
    only = scene.replace(obstacles=[scene.obstacles[1]])
    room = pictures(Session(only).tracks, Compared())[0].touch.room
    assert (room.forces, room.wraps, room.surfaces) == (True, 0, 1)
    assert pictures(Session(scene).tracks, Compared())[0].touch.room.wraps == MOST_WRAPS


def test_while_it_plays_wraps_are_found_now_and_then(monkeypatch: pytest.MonkeyPatch) -> None:
    session, compared = Session(over_a_drum()), Compared()
    session.advance(40)
    clock = [100.0]
    monkeypatch.setattr(touch.time, "perf_counter", lambda: clock[0])

    def age(*, playing: bool) -> float:
        return pictures(session.tracks, compared, playing=playing)[0].touch.scalars["wrap_age"]

    assert age(playing=True) == 0.0
    session.advance(20)
    clock[0] += 0.05
    assert age(playing=True) == pytest.approx(0.04)
    clock[0] += 0.06
    assert age(playing=True) == 0.0
    session.advance(1)
    assert age(playing=True) == pytest.approx(0.002)
    assert age(playing=False) == 0.0  # what stands is told as it stands


def test_contacts_of_ropes_are_all_the_force_that_ropes_have_from_ropes() -> None:
    """Put on the nodes of both segments they add up to the force that the run has of every node."""
    scene = preset("overhand")
    tight = rw.simulate(scene.replace(run=scene.run.replace(duration=0.5)))
    recorded, seen = Recorded(tight), 0
    assert recorded.shape.touch.forces is False  # there is no obstacle, and no room for its forces
    for frame in range(tight.frames):
        told = recorded.picture(frame).touch
        rows, found = there(told.pairs), np.zeros((tight.nodes + 1, 3))
        for first, second, *force in rows:
            for at, sign in ((first, 1.0), (second, -1.0)):
                node, share = int(at), at - int(at)
                found[node] += (1.0 - share) * sign * np.array(force)
                found[node + 1] += share * sign * np.array(force)
        assert told.scalars["rope_contacts"] == len(rows)
        size = np.linalg.norm(rows[:, 2:], axis=1).sum()
        assert told.scalars["rope_contact_force"] == pytest.approx(size)
        known = np.linalg.norm(tight.contact_force[frame])
        if known > 10.0:  # of friction's damper, which is not in the one, nothing is left
            seen += 1
            assert np.linalg.norm(found[:-1] - tight.contact_force[frame]) < 0.01 * known
    assert seen > 3


def test_of_many_contacts_of_ropes_the_strongest_are_told_with_how_many_there_are() -> None:
    generator = np.random.default_rng(3)
    kept = np.full((500, 8), np.nan)
    kept[:300, 0], kept[:300, 1] = np.arange(300), np.arange(300) + 400
    kept[:300, 2:8] = generator.uniform(size=(300, 6))
    rows, told = pair_rows(kept, MOST_PAIRS)
    assert rows.shape == (MOST_PAIRS, PAIR)
    size = np.linalg.norm(kept[:300, 5:8], axis=1)
    assert told == {"rope_contacts": 300.0, "rope_contact_force": pytest.approx(size.sum())}
    strongest = np.sort(np.argsort(-size)[:MOST_PAIRS])
    assert np.array_equal(np.floor(rows[:, 0]), strongest)
    few, _ = pair_rows(kept[299:], 4)
    assert list(few[:, 0] >= 0.0) == [True, False, False, False]


def test_frames_have_the_parts_where_the_layout_says() -> None:
    scene = preset("pile")
    broadcast = Broadcast(Session(scene), playing=False)
    broadcast.session.advance(300)
    broadcast.refresh()
    data = broadcast.frame()
    [about] = broadcast._sent["layout"]["variants"]
    spot = about["offsets"]
    order = ["contact", "rope_contacts", "wraps", "friction_work", "grabs"]
    places = [spot[name] for name in order]
    assert about["surfaces"] == ["floor", "ropes on ropes"]
    sizes = [12 * 81, 4 * PAIR * MOST_PAIRS, 0, 8]
    assert np.diff(places).tolist() == sizes
    [shown] = pictures(broadcast.session.tracks, Compared())
    pairs = np.frombuffer(data, "<f4", PAIR * MOST_PAIRS, spot["rope_contacts"])
    assert pairs == pytest.approx(shown.touch.pairs.ravel(), rel=1e-5, abs=1e-6)
    assert there(shown.touch.pairs).size
    force = np.frombuffer(data, "<f4", 3 * 81, spot["contact"]).reshape(81, 3)
    block = broadcast.session.main.simulation.recording()
    assert force == pytest.approx(block.obstacles[0].T, rel=1e-5, abs=1e-9)


def test_friction_s_work_goes_on_over_an_edit_and_begins_anew_at_a_reset(tmp_path: Path) -> None:
    session = Session(over_a_drum())
    session.advance(80)
    before = picture(session.main).touch.rubbed[0]
    assert before < -1e-3
    do(session, "set", name="mass", value=0.05)
    assert picture(session.main).touch.rubbed[0] == pytest.approx(before, rel=1e-9)
    session.advance(20)
    assert picture(session.main).touch.rubbed[0] < before
    do(session, "reset")
    assert picture(session.main).touch.rubbed[0] == 0.0


def test_a_part_of_a_recorded_session_goes_on_from_the_one_before(run: Result) -> None:
    class Later(Recorded):
        """The same run, as if it went on from the end of the other."""

        @property
        def time(self) -> np.ndarray:
            return np.asarray(run.time) + run.time[-1]

    first, second = Recorded(run), Later(run)
    end = first.touched.works_until(run.frames - 1).rubbed
    assert end[0] < -1e-3
    second.follow(first)
    assert second.touched.works_until(0).rubbed == pytest.approx(end)
    assert second.again().picture(0).touch.rubbed == pytest.approx(end)
    assert followed([run])[0].touched.works_until(0).rubbed[0] == 0.0


def test_a_run_without_a_ledger_knows_no_work_of_friction() -> None:
    result = rw.simulate(over_a_drum(), ledger=False)
    assert np.isnan(Recorded(result).picture(3).touch.rubbed).all()


def test_a_contact_keeps_its_place_in_a_packed_run() -> None:
    def frame(*rows: tuple[float, ...]) -> np.ndarray:
        found = np.full((4, PAIR), -1.0)
        for row, values in zip(found, rows, strict=False):
            row[:] = values
        return found

    one, other, third = (3.2, 9.1, 0, 0, 1.0), (4.5, 8.0, 0, 2.0, 0), (5.5, 7.0, 3.0, 0, 0)
    frames = [frame(one, other), frame(other, third), frame(third), frame()]
    found = in_places(frames)
    assert found.shape == (4, 2, PAIR)
    assert found[0] == pytest.approx(np.array([one, other]))
    assert found[1] == pytest.approx(np.array([third, other]))
    assert found[2, 0] == pytest.approx(third)
    assert found[2, 1] == pytest.approx([4.5, 8.0, 0, 0, 0])  # an empty place, without force
    assert not found[3, :, 2:].any()


def test_contacts_at_the_end_of_a_segment_and_the_start_of_the_next_are_two() -> None:
    """Share 1 of segment 5 and share 0 of segment 6 are one place on the rope: 6.0."""
    rows = np.array([[6.0, 30.5, 0, 0, 1.0], [6.0, 30.5, 0, 0, 2.0], [8.5, 30.2, 0, 0, 4.0]])
    found = in_places([rows, rows[[0, 2]], rows])
    assert found.shape == (3, 3, PAIR)
    assert found[0] == pytest.approx(rows)
    assert found[1, :, 4].tolist() == [1.0, 0.0, 4.0]
    assert found[2] == pytest.approx(rows)


def test_where_nothing_touches_a_packed_run_has_no_force() -> None:
    """Half a step of force, drawn to its own scale, would be a long arrow."""
    generator = np.random.default_rng(5)
    frames = []
    for count in (0, 3, 1, 0, 2):
        pairs, force = np.full((4, PAIR), -1.0), np.zeros((6, 3))
        pairs[:count, :2] = 10.0 * np.arange(count)[:, None] + [3.3, 50.7]
        pairs[:count, 2:] = generator.normal(size=(count, 3))
        force[:count] = generator.normal(size=(count, 3))
        frames.append(touch.NOTHING._replace(force=force, pairs=pairs))
    streams = {one.name: one for one in touch_streams(frames, np.zeros(6, int))}
    for name, columns in (("rope_contacts", PAIR), ("contact", 3)):
        found = unpack(streams[name], len(frames)).reshape(len(frames), -1, columns)[:, :, -3:]
        assert (found != 0.0).any(axis=2).sum(axis=1).tolist() == [0, 3, 1, 0, 2]


def test_weak_contacts_of_a_packed_run_are_true_beside_strong_ones_of_another_time() -> None:
    """Arrows are drawn to the strongest of their frame, and the legend says how much that is."""
    frames = []
    for newtons in (1.1, 1000.0):
        pairs, force = np.full((1, PAIR), -1.0), np.zeros((2, 3))
        pairs[0], force[1, 2] = (3.3, 50.7, 0.0, newtons, 0.0), newtons
        frames.append(touch.NOTHING._replace(force=force, pairs=pairs))
    streams = {one.name: one for one in touch_streams(frames, np.zeros(2, int))}
    for name in ("rope_contacts", "contact"):
        weak = unpack(streams[name], 2)[0, -3:]
        assert np.linalg.norm(weak) == pytest.approx(1.1, rel=0.12)  # half a 4000th of 1000 N


def test_weak_contacts_of_a_packed_run_are_true_beside_strong_ones_of_another_rope() -> None:
    """A twine of 0.01 N beside a hawser of 1 kN had none: all ropes had one step."""
    pairs, force = np.full((2, PAIR), -1.0), np.zeros((4, 3))
    for row, newtons in enumerate((0.01, 1000.0)):
        pairs[row], force[2 * row + 1, 2] = (3.3 + row, 50.7, 0.0, newtons, 0.0), newtons
    frames = [touch.NOTHING._replace(force=sign * force, pairs=pairs) for sign in (0.0, 1.0)]
    streams = {one.name: one for one in touch_streams(frames, np.array([0, 0, 1, 1]))}
    assert unpack(streams["contact"], 2)[1, 5] == pytest.approx(0.01, rel=0.1)
    assert unpack(streams["rope_contacts"], 2)[1, 3] == pytest.approx(0.01, rel=0.1)


def test_tensions_of_weak_wraps_of_a_packed_run_are_true_beside_strong_ones() -> None:
    """A rope with a gram over a drum beside one with a ton had 0 N on both sides of it."""
    wraps = np.full((2, WRAP), -1.0)
    wraps[0], wraps[1] = (0, 0, 3, 8, 3.1, 9800.0, 9790.0, 0.2), (1, 0, 3, 8, 3.1, 0.98, 0.97, 0.2)
    frames = [touch.NOTHING._replace(wraps=wraps, rubbed=np.zeros(0))] * 2
    streams = {one.name: one for one in touch_streams(frames, np.zeros(2, int))}
    found = unpack(streams["wraps"], 2).reshape(2, 2, WRAP)
    assert found[:, 1, 5:7] == pytest.approx(wraps[1:, 5:7].repeat(2, axis=0), rel=1e-3)


def test_friction_s_work_of_each_surface_is_packed_to_its_own_range() -> None:
    works = [[0.0, 0.0, 0.0], [-3.0, -1e-4, 0.0], [-50.0, -3e-4, 0.0]]
    frames = [touch.NOTHING._replace(rubbed=np.array(one)) for one in works]
    [stream] = touch_streams(frames, np.zeros(0, int))
    assert unpack(stream, 3) == pytest.approx(np.array(works), rel=1e-3, abs=0.0)


def test_packed_numbers_are_true(run: Result, crossing: Result) -> None:
    for result in (run, crossing):
        recorded = Recorded(result)
        touches = [recorded.picture(frame).touch for frame in range(result.frames)]
        streams = {one.name: one for one in touch_streams(touches, np.zeros(result.nodes, int))}
        rows = len(touches)
        work = unpack(streams["friction_work"], rows)
        known = np.array([one.rubbed for one in touches])
        assert np.abs(work - known).max() < 1e-4 * max(np.ptp(known), 1e-12)
        if "wraps" in streams:
            wraps = unpack(streams["wraps"], rows).reshape(rows, -1, WRAP)
            true = np.array([one.wraps for one in touches])[:, : wraps.shape[1]]
            assert np.array_equal(wraps[:, :, :4], true[:, :, :4])
            assert np.abs(wraps[:, :, 4:] - true[:, :, 4:]).max() < 1e-3
        if "rope_contacts" in streams:
            pairs = unpack(streams["rope_contacts"], rows).reshape(rows, -1, PAIR)
            assert _total(pairs) == pytest.approx(
                [_total(one.pairs[None])[0] for one in touches], abs=0.1
            )


def _total(pairs: np.ndarray) -> list[float]:
    """Return the force of all contacts of a frame [N]."""
    return [float(np.linalg.norm(one[one[:, 0] >= 0.0, 2:], axis=1).sum()) for one in pairs]


def test_a_shared_run_has_them(run: Result) -> None:
    header = record(run).header
    [part] = header["parts"]
    names = [stream["name"] for stream in part["streams"]]
    assert {"contact", "wraps", "friction_work"} <= set(names)
    assert "rope_contacts" not in names


def test_old_runs_show_one_force_of_all_that_is_touched(
    crossing: Result, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = [name for name in crossing.source.names if name != "rope_contacts"]
    monkeypatch.setattr(type(crossing.source), "names", names, raising=False)
    told = Recorded(crossing).picture(crossing.frames - 1).touch
    assert told.room.pairs == 0
    assert told.force == pytest.approx(crossing.contact_force[-1])


def test_wraps_beyond_the_room_are_counted() -> None:
    """Fourteen pegs in a row: twelve are told, those that carry most."""
    found = [
        touch.Lying(0, number, np.zeros(0, int), number, number, 0.5, 1.0 + number, 0.0, 2.0)
        for number in range(14)
    ]
    rows, count = touch.wrap_rows(found, MOST_WRAPS)
    assert count == 14.0
    assert rows[:, 1].tolist() == list(range(2, 14))
    straight = found[0]._replace(angle=0.0)
    assert touch.wrap_rows([straight], MOST_WRAPS)[1] == 0.0
