"""Which islands have come within reach of each other, and where contacts of parts are in the whole."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from ropewalk.engine import meeting_boxes as reach
from ropewalk.engine.contact_rows import Rows, differ, joined_rows, rows_among, rows_of, write_rows
from ropewalk.engine.join import begin_boxes
from ropewalk.laws.pairs.search import note_ropes
from ropewalk.laws.pairs.swept import FROM, LOW, TO, place_boxes, runs_of, sweep
from ropewalk.laws.pairs.table import BRAKE, CONTACTS, REACH
from ropewalk.lowering import build
from ropewalk.scene import Contact, Material, Rope, Scene, Straight
from ropewalk.simulation import Simulation


@pytest.mark.parametrize(("most", "run"), [(7, 16), (1 << 20, 16), (1 << 20, 3)])
def test_boxes_that_overlap_are_found(most: int, run: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Against all pairs, one by one; an empty box meets none."""
    monkeypatch.setattr(reach, "CANDIDATES", most)
    monkeypatch.setattr(reach, "RUN", run)
    random, seen = np.random.default_rng(4), 0
    for _ in range(20):
        low = random.uniform(0.0, 3.0, (60, 3))
        boxes = np.hstack([low, low + random.uniform(0.0, 0.7, (60, 3))])
        boxes[7] = [np.inf] * 3 + [-np.inf] * 3
        owners = np.sort(random.integers(0, 30, 60))
        expected = {
            (int(owners[i]), int(owners[j]))
            for i, j in itertools.combinations(range(60), 2)
            if owners[i] != owners[j]
            and (boxes[i, :3] <= boxes[j, 3:]).all()
            and (boxes[j, :3] <= boxes[i, 3:]).all()
        }
        seen += len(expected)
        assert reach.meeting(boxes, owners) == expected
    assert seen > 100
    assert reach.meeting(np.zeros((0, 6)), np.zeros(0, np.int64)) == set()


def test_boxes_without_end_meet_all_others() -> None:
    """Of what has burst, in silence; the sums of their corners are no numbers."""
    boxes = np.array([[0.0] * 3 + [1.0] * 3, [-np.inf] * 3 + [np.inf] * 3, [5.0] * 3 + [6.0] * 3])
    with np.errstate(all="raise"):
        assert reach.meeting(boxes, np.arange(3)) == {(0, 1), (1, 2)}


def test_all_that_meets_through_others_is_one() -> None:
    groups = [(0, 3), (1,), (2,), (4,), (5,)]
    assert reach.joined(groups, {(0, 2), (2, 4)}) == [(0, 2, 3, 5), (1,), (4,)]
    assert reach.joined(groups, set()) == sorted(groups)


def test_no_run_of_segments_is_of_two_ropes(monkeypatch: pytest.MonkeyPatch) -> None:
    rope = np.array([0] * 20 + [-1] + [1] * 3 + [-1] + [2] * 16)
    assert runs_of(rope)[:, FROM].tolist() == np.flatnonzero(rope >= 0).tolist()
    monkeypatch.setattr("ropewalk.laws.pairs.swept.RUN", 16)
    runs = runs_of(rope)[:, FROM : TO + 1]
    assert runs.tolist() == [[0, 15], [16, 19], [21, 23], [25, 40]]
    assert runs_of(np.zeros(0, np.int64)).shape == (0, 8)
    assert (runs_of(rope)[:, LOW] == np.inf).all()


def test_rows_of_parts_are_those_of_the_whole() -> None:
    """There and back, of parts whose ropes are no neighbours. The twin: another grip is told."""
    stuff = Material(EA=1e4, mass_per_length=0.1)
    at = [(0.0, 0.0), (5.0, 0.0), (0.0, 0.02), (5.0, 0.02)]
    ropes = [
        Rope(name=f"r{k}", segments=3, length=0.6, diameter=0.02, made_of=stuff,
             shape=Straight(start=(x, y, 0.0)))
        for k, (x, y) in enumerate(at)
    ]  # fmt: skip
    run = {"method": "sdirk2", "time_step": 0.01}
    model = build(Scene(ropes=ropes, contact=Contact(), run=run))
    memory, table = model.state.memory.contact, model.system.node.contact
    rows = rows_of(memory)
    assert len(rows.pair) > 3
    part = build(Scene(ropes=ropes[::2], contact=Contact(), run=run))
    parts, segments = [], []
    for numbers in ([0, 2], [1, 3]):
        there = np.full(part.state.stiffness.size, -1)
        own = np.full(model.state.stiffness.size, -1)
        for k, number in enumerate(numbers):
            span, here = model.layout.ropes[number], part.layout.ropes[k]
            there[here.first : here.last] = np.arange(span.first, span.last)
            own[span.first : span.last] = np.arange(here.first, here.last)
        kept = build(part.scene).state.memory.contact
        write_rows(rows_among(rows, own), part.system.node.contact, kept, part.state.stiffness)
        parts.append(kept)
        segments.append(there)
    again = joined_rows(parts, segments)
    assert not differ(again._replace(books=rows.books), rows)
    write_rows(again, table, memory, model.state.stiffness)
    parts[0].grip[0, BRAKE] += 1.0
    assert differ(joined_rows(parts, segments), again)


def test_more_rows_than_there_is_room_for_are_a_fault() -> None:
    rope = Rope(name="r", segments=3, length=0.6, diameter=0.02, shape=Straight(start=(0, 0, 0)),
                made_of=Material(EA=1e4, mass_per_length=0.1))  # fmt: skip
    model = build(
        Scene(ropes=[rope], contact=Contact(), run={"method": "sdirk2", "time_step": 0.01})
    )
    memory, table = model.state.memory.contact, model.system.node.contact
    room = len(memory.pair)
    rows = Rows(
        np.zeros((room + 1, 2), np.int64),
        np.zeros((room + 1, memory.grip.shape[1])),
        np.zeros((0, 2), np.int64),
        np.zeros(10, np.int64),
        np.zeros(4),
    )
    write_rows(rows, table, memory, model.state.stiffness)
    assert memory.tally[CONTACTS] == room
    assert memory.tally[5] != 0


def test_boxes_begin_where_ropes_are(monkeypatch: pytest.MonkeyPatch) -> None:
    """And reach to where they come from; what has parted is left out, and what is no number told on."""
    monkeypatch.setattr("ropewalk.laws.pairs.swept.RUN", 16)
    random = np.random.default_rng(7)
    rope = np.array([0] * 20 + [-1] + [1] * 3)
    x, y = random.normal(size=(2, 3, 25))
    radius = np.where(rope < 0, 0.0, random.uniform(0.01, 0.3, 24))
    there = np.where(rope < 0, 0.0, 5.0)
    there[17] = there[21] = 0.0
    lost = y.copy()
    lost[1, 3] = np.nan
    for end in (x, y, lost):
        swept = runs_of(rope)
        place_boxes(x, end, there, radius, swept, np.zeros((6, 25)))
        for box in swept:
            low, high = np.full(3, np.inf), np.full(3, -np.inf)
            for j in range(int(box[FROM]), int(box[TO]) + 1):
                if there[j] > 0.0:
                    places = np.stack([x[:, j], x[:, j + 1], end[:, j], end[:, j + 1]])
                    low = np.minimum(low, places.min(axis=0) - REACH * radius[j])
                    high = np.maximum(high, places.max(axis=0) + REACH * radius[j])
            assert np.array_equal(box[:FROM], np.concatenate([low, high]), equal_nan=True)
    assert np.isnan(swept[0, [1, 4]]).all()
    assert np.isfinite(swept[1:]).all()


def test_what_has_parted_has_been_where_it_was() -> None:
    """Boxes follow the nodes' ways, and hold those of a segment until it parted, but none of later ones."""
    rope = Rope(name="r", segments=3, length=0.6, diameter=0.02, shape=Straight(start=(0, 0, 0)),
                made_of=Material(EA=1e4, mass_per_length=0.1))  # fmt: skip
    scene = Scene(ropes=[rope], contact=Contact(), run={"method": "sdirk2", "time_step": 0.01})
    engine = Simulation(scene)._engine
    table, memory, x = engine.system.node.contact, engine.state.memory.contact, engine.state.x
    begin_boxes(engine)
    first, up, far = (x + np.array([[0.0], [y], [z]]) for y, z in ((0, 0), (0.5, 0), (0, 9.0)))
    stiffness = engine.state.stiffness.copy()
    sweep(first, up, memory)
    stiffness[1] = 0.0
    note_ropes(table, memory, stiffness)
    sweep(up, far, memory)
    boxes, owners = reach.been([engine])
    assert not owners.any()
    for j, ways in enumerate(((first, up, far), (first, up), (first, up, far))):
        places = np.hstack([way[:, j : j + 2] for way in ways])
        low, high = places.min(axis=1) - 0.011, places.max(axis=1) + 0.011
        assert np.allclose(boxes[j], np.concatenate([low, high]), rtol=0.0, atol=1e-12), j
    both = reach.been([engine, engine])
    assert np.array_equal(both[0], np.concatenate([boxes, boxes]))
    assert both[1].tolist() == [0, 0, 0, 1, 1, 1]
