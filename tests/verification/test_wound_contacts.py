"""Ropes that touch each other while winches take their nodes in and let them out."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.laws.pairs.search import are_neighbours
from ropewalk.laws.pairs.table import CONTACTS, LEVER, PUSH, apart
from ropewalk.laws.pairs.wound import come_off, go_on, sort_rows
from ropewalk.record.result import Result
from ropewalk.scene import (
    Anchor,
    Contact,
    Load,
    Material,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Velocity,
    Winch,
)
from unit.test_pairs import pressed_tangle, tangle

THICK = 0.02  # [m]


def hauled(speed: float, *, winch: bool, friction: float = 0.2, drum: float = 0.6) -> Result:
    """Half a kilogram on a rope over another one, drawn by a winch, or by an anchor that moves off."""
    points = [(-drum, 0, THICK), (-0.03, 0, 1.05 * THICK), (0.03, 0, 1.05 * THICK), (0.04, 0, -0.6)]
    length = float(sum(np.linalg.norm(np.diff(np.array(points), axis=0), axis=1)))
    rope = Rope(
        name="line",
        segments=round(length / 0.0125),
        length=length,
        diameter=THICK,
        made_of=Material(EA=5e3, mass_per_length=0.1, axial_damping=2.0),
        shape=Polyline(points=points),
        loads=[Load(node=-1, mass=0.5)],
    )
    bar = Rope(
        name="bar",
        segments=8,
        length=0.6,
        diameter=THICK,
        made_of=Material(EA=1e6, mass_per_length=0.2, axial_damping=20.0),
        shape=Straight(start=(0, -0.3, 0), direction=(0, 1, 0)),
    )
    motion = Velocity(velocity=(0.0 if winch else -abs(speed), 0, 0), start=0.5)
    anchors = [
        Anchor(name="hand", rope="line", node=0, motion=motion),
        *(Anchor(name=f"bar{node}", rope="bar", node=node) for node in (0, -1)),
    ]
    wound = [Winch(rope="line", end="start", speed=speed, start=0.5)] if winch else []
    run = RunSettings(method="implicit-euler", duration=2.5, frame_rate=60.0, time_step=0.002)
    return rw.simulate(
        Scene(
            ropes=[rope, bar],
            anchors=anchors,
            winches=wound,
            contact=Contact(friction=friction),
            run=run,
        )
    )


def pulls(result: Result) -> tuple[float, float]:
    """Mean force of the hand along its line, and of the bar's ends upwards, while the rope runs [N]."""
    running = result.time > 1.0
    names = [anchor.name for anchor in result.scene.anchors]
    force = result.reactions[running].mean(axis=0)
    up = sum(force[names.index(name), 2] for name in ("bar0", "bar-1"))
    return float(-force[names.index("hand"), 0]), float(up)


def test_a_winch_hauls_over_a_rope_what_a_hand_does() -> None:
    """The pull of a winch's drum and what the bar bears are those of an anchor that moves off at its speed;
    the twin without friction pulls less. The load comes up by what was wound in, and the ledger closes.
    """
    wound, drawn = hauled(-0.2, winch=True), hauled(-0.2, winch=False)
    smooth = hauled(-0.2, winch=True, friction=0.0)
    (pull, borne), (by_hand, more) = pulls(wound), pulls(drawn)
    assert pull == pytest.approx(by_hand, rel=0.01)
    longer = 0.2 * 1.25  # [m] of line, on the average, between the bar and a hand that moves off
    assert borne == pytest.approx(more - 0.5 * longer * 0.1 * 9.81, rel=0.01)
    assert pulls(smooth)[0] < 0.85 * pulls(wound)[0]
    rise = wound.rope("line").positions[-1, -1, 2] - wound.rope("line").positions[29, -1, 2]
    assert rise == pytest.approx(0.4, abs=0.01)
    rubbed = drawn.work["contact"][-1]  # nodes that go on to a drum leave contacts as much to do
    assert wound.work["contact"][-1] == pytest.approx(rubbed, rel=0.02)
    for result in (wound, drawn):
        scale = max(float(np.abs(values).max()) for values in result.energy.values())
        assert result.table["largest balance residual [J]"] < 1e-12 * scale


@pytest.mark.parametrize("speed", [-0.2, 0.2])
def test_nothing_passes_where_nodes_come_and_go_beside_a_contact(speed: float) -> None:
    """The drum stands two segments from the bar, so that contacts lie on the segment that comes and goes:
    the line stays on top of the bar, pressed by less than a tenth of a diameter in every frame.
    """
    result = hauled(speed, winch=True, drum=0.055)
    assert result.status == "finished"
    line, bar = result.rope("line").positions, result.rope("bar").positions
    for frame in range(1, result.frames):
        middle = bar[frame, 4]
        over = line[frame][np.abs(line[frame][:, 0] - middle[0]) < THICK / 3]
        assert over[:, 2].max() - middle[2] > 0.85 * THICK, frame
    assert result.table["largest balance residual [J]"] < 1e-10
    assert result.work["contact"].max() < 1e-4  # what the drawn shape is pressed by at first


def seen(x: Floats, memory: object, rows: list[int]) -> Floats:
    """The vectors between the surfaces of some contacts, (c, 3) [m]."""
    return np.array([apart(x, memory.grip, row, *memory.pair[row]) for row in rows])  # type: ignore[attr-defined]


@pytest.mark.parametrize("side", [1, -1])
def test_a_node_that_comes_off_leaves_contacts_where_they_are(side: int) -> None:
    """Each of a segment in two parts is at the same point of one of them, seen along its surface, too."""
    moved = 0
    for seed in range(40):
        _, state = tangle(seed)
        memory, x = state.memory.contact, state.x
        memory.grip[:, LEVER : LEVER + 6] = np.random.default_rng(seed).normal(size=(1, 6))
        for old in range(1, x.shape[1] - 2):
            kept = memory.pair.copy(), memory.grip.copy()
            drum, outer = (old, old + 1) if side > 0 else (old + 1, old)
            new, inner = old - side, drum - side
            rows = [
                row
                for row in range(int(memory.tally[CONTACTS]))
                if old in memory.pair[row] and not {new, new - side} & set(memory.pair[row])
            ]
            if rows and 0 <= inner < x.shape[1]:
                before, after = seen(x, memory, rows), x.copy()
                after[:, inner] = x[:, drum]
                after[:, drum] = 0.6 * x[:, drum] + 0.4 * x[:, outer]
                come_off(memory, new, old, side, 0.4)
                np.testing.assert_allclose(seen(after, memory, rows), before, atol=1e-15)
                moved += sum(new in memory.pair[row] for row in rows)
            memory.pair[...], memory.grip[...] = kept
    assert moved > 3  # of some the part at the drum has them


@pytest.mark.parametrize("side", [1, -1])
def test_a_node_that_goes_on_hands_its_contacts_to_the_next_segment(side: int) -> None:
    """On a straight line they stay where they are; two of a pair become one with both forces."""
    system, state = pressed_tangle()
    memory, table, x = state.memory.contact, system.node.contact, state.x
    last, rope = memory.tally[CONTACTS], table.rope
    row = next(
        row
        for row, (i, j) in enumerate(memory.pair[:last])
        if rope[i + side] == rope[i]
        and not are_neighbours(table, state.memory.contact, state.tied, i + side, j)
    )
    gone, other = (int(one) for one in memory.pair[row])
    kept = gone + side
    drum, middle, far = (gone, gone + 1, gone + 2) if side > 0 else (gone + 1, gone, gone - 1)
    x[:, middle] = 0.3 * x[:, drum] + 0.7 * x[:, far]
    memory.place[...] = x
    memory.tally[CONTACTS] = 2
    for k, segment in enumerate(sorted((gone, kept))):
        memory.pair[k] = segment, other
        memory.grip[k] = memory.grip[row]
        memory.grip[k, PUSH] = 1.0 + k
    first = [k for k in range(2) if memory.pair[k, 0] == gone]
    before, push = seen(x, memory, first), memory.grip[:2, PUSH].sum()
    after = x.copy()
    after[:, middle] = x[:, drum]
    go_on(after, table, memory, state.tied, gone, kept, side)
    assert (memory.pair[:2, 0] == kept).all()
    np.testing.assert_allclose(seen(after, memory, first), before, atol=1e-15)
    sort_rows(memory)
    assert memory.tally[CONTACTS] == 1
    assert memory.grip[0, PUSH] == pytest.approx(push)
