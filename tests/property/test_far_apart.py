"""Ropes that may touch and do not move by many frames at once, and nothing passes unseen."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.status import BROKEN
from ropewalk.engine.engine import Engine
from ropewalk.engine.islands import Islands
from ropewalk.engine.slices import Slices
from ropewalk.laws.pairs.table import CONTACTS
from ropewalk.scene import Contact, Plane, Straight, Velocity
from ropewalk.simulation.block import Block, join
from ropewalk.simulation.far_apart import FarApart

FRAMES, RATE = 48, 240.0
STEPS = {
    "implicit-euler": {"time_step": 1.0 / 240.0},
    "sdirk2": {"time_step": 1.0 / 480.0},
    "semi-implicit-euler": {"time_step": 2e-5},
    "adaptive": {"tolerance": 1e-5},
}


def two(method: str, gap: float, **more: Any) -> rw.Scene:
    """Return a held rope, and one across it that begins `gap` above [m]."""
    made_of = rw.Material(EA=2e3, mass_per_length=0.05, axial_damping=0.1)
    shapes = {
        "held": Straight(start=(-0.2, 0.0, 0.0), end=(0.2, 0.0, 0.0)),
        "flung": Straight(start=(0.0, -0.1, gap), end=(0.0, 0.1, gap)),
    }
    ropes = [
        rw.Rope(
            name=name,
            segments=10,
            length=float(np.linalg.norm(np.subtract(shape.end, shape.start))),
            diameter=0.01,
            made_of=made_of,
            shape=shape,
        )
        for name, shape in shapes.items()
    ]
    ends = [rw.Anchor(name=name, rope="held", node=node) for name, node in (("a", 0), ("b", -1))]
    run = rw.RunSettings(method=method, frame_rate=RATE, duration=FRAMES / RATE, **STEPS[method])
    return rw.Scene(ropes=ropes, anchors=ends, contact=Contact(), run=run, **more)


def flung(scene: rw.Scene, speed: float) -> rw.Simulation:
    """Return a simulation in which the upper rope comes down at `speed` [m/s]."""
    simulation = rw.Simulation(scene)
    simulation.velocities[11:] = (0.0, 0.0, -speed)
    return simulation


def same(a: Block, b: Block) -> None:
    """Two blocks have the same bits, in all that they hold."""
    assert a.status == b.status
    for name, one, other in zip(a.recording._fields, a.recording, b.recording, strict=True):
        assert one.tobytes() == other.tobytes(), name
    for one, other in ((a.time, b.time), (a.pairs, b.pairs), (a.obstacles, b.obstacles)):
        assert (one is None) == (other is None)
        assert one is None or np.ascontiguousarray(one).tobytes() == other.tobytes()


def rows(simulation: rw.Simulation) -> int:
    """Return how many contacts there are now."""
    engines = getattr(simulation._engine, "engines", [simulation._engine])
    return sum(int(engine.state.memory.contact.tally[CONTACTS]) for engine in engines)


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many frames the calls had."""
    found = list[int]()
    for kind in (Engine, Islands):
        call = kind.call

        def counted(self: Any, now: Any, frames: int, *rest: Any, call: Any = call) -> Any:
            found.append(frames)
            return call(self, now, frames, *rest)

        monkeypatch.setattr(kind, "call", counted)
    return found


@pytest.mark.parametrize(
    ("method", "speed", "gap", "floor"),
    [
        ("implicit-euler", 0.5, 0.05, False),
        ("implicit-euler", 50.0, 0.5, False),
        ("implicit-euler", 50.0, 0.52, True),
        ("sdirk2", 50.0, 0.53, False),
        ("semi-implicit-euler", 50.0, 0.51, False),
        ("semi-implicit-euler", 1.0, 0.06, True),
        ("adaptive", 5.0, 0.1, False),
    ],
)
def test_what_meets_among_many_frames_meets_as_frame_by_frame(
    calls: list[int], method: str, speed: float, gap: float, floor: bool
) -> None:
    """Thrown at 50 m/s a rope is at the other for part of a frame only: all that is recorded is the same."""
    scene = two(method, gap, obstacles=[Plane(point=(0.0, 0.0, -0.3))] if floor else [])
    one, other = flung(scene, speed), flung(scene, speed)
    single, touched = list[Block](), 0
    for _ in range(FRAMES):
        single.append(one.advance_frames(1))
        touched += rows(one) > 0
    calls.clear()
    same(other.advance_frames(FRAMES), join(single))
    assert touched, "they touch at the end of some frame"
    assert touched < FRAMES
    assert one.state.state.x.tobytes() == other.state.state.x.tobytes()


@pytest.mark.parametrize("method", ["verlet", "implicit-euler"])
def test_what_breaks_among_many_frames_is_told_as_broken(method: str) -> None:
    """A cord that is drawn out without end; no frame of the last call was good, and all seemed well."""
    cord = rw.Rope(
        segments=6,
        length=1.0,
        diameter=0.01,
        made_of=rw.Material(EA=200.0, mass_per_length=0.1, axial_damping=1.0),
        shape=Straight(start=(0.0, 0.0, 0.0), end=(1.0, 0.0, 0.0)),
    )
    hand = rw.Anchor(name="hand", node=-1, motion=Velocity(velocity=(4.0, 0.0, 0.0)))
    scene = rw.Scene(
        ropes=[cord],
        anchors=[rw.Anchor(name="wall", node=0), hand],
        gravity=(0.0, 0.0, 0.0),
        contact=Contact(),
        run=rw.RunSettings(method=method, duration=3.0),
    )
    simulation = rw.Simulation(scene)
    block = simulation.advance_frames(170)
    assert 100 < block.frames < 170
    assert simulation.reason
    assert block.status == BROKEN


@pytest.mark.parametrize("method", ["implicit-euler", "semi-implicit-euler"])
def test_what_has_nothing_near_moves_in_few_calls(calls: list[int], method: str) -> None:
    """As many frames as are asked for, from some on; the same bits as frame by frame, and by steps."""
    alone, whole, stepped = (flung(two(method, 0.1), -1.0) for _ in range(3))
    single = join([alone.advance_frames(1) for _ in range(FRAMES)])
    for _ in range(FRAMES):
        stepped.step()
    calls.clear()
    many = whole.advance_frames(FRAMES)
    assert len(calls) < 0.25 * FRAMES
    assert max(calls) > 8
    same(many, single)
    assert stepped.arrays.x.tobytes() == whole.arrays.x.tobytes()


@pytest.mark.parametrize("ropes", [1, 2])
@pytest.mark.parametrize("cut", [False, True])
def test_one_rope_that_touches_itself_within_a_call_is_taken_back(
    calls: list[int], ropes: int, cut: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its two ends are flung at each other, touch, and come apart again; alone and beside another.

    Cut: calls of the kernel have two steps each, and end where anything touches.
    """
    if cut:
        monkeypatch.setattr(Slices, "note", lambda self, *_: setattr(self, "most", 2))
    made_of = rw.Material(EA=2e3, mass_per_length=0.05, axial_damping=0.05)
    x = 0.06 * np.cos(np.linspace(0.3, 2.0 * np.pi - 0.3, 25))
    y = 0.06 * np.sin(np.linspace(0.3, 2.0 * np.pi - 0.3, 25))
    points = np.stack([x, y, np.zeros(25)], axis=1)
    made = [
        rw.Rope(
            name=f"rope{k}",
            segments=24,
            length=float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()),
            diameter=0.01,
            made_of=made_of,
            shape=rw.scene.Points(points=(points + np.array([0.0, 0.0, k])).tolist()),
        )
        for k in range(ropes)
    ]
    run = rw.RunSettings(
        method="implicit-euler",
        time_step=1.0 / (960.0 if cut else 240.0),
        frame_rate=RATE,
        duration=FRAMES / RATE,
    )
    scene = rw.Scene(ropes=made, contact=Contact(), gravity=(0.0, 0.0, 0.0), run=run)
    one, other = rw.Simulation(scene), rw.Simulation(scene)
    for simulation in (one, other):
        simulation.velocities[0] = (0.0, -3.0, 0.0)
        simulation.velocities[24] = (0.0, 3.0, 0.0)
    single, touched = list[Block](), list[bool]()
    for _ in range(FRAMES):
        single.append(one.advance_frames(1))
        touched.append(rows(one) > 0)
    calls.clear()
    same(other.advance_frames(FRAMES), join(single))
    assert any(touched)
    assert not touched[0]
    assert cut or not touched[-1]
    assert max(calls) > 1


def test_what_touched_last_is_forgotten_where_nothing_touches() -> None:
    """Explicit steps leave out the force of contacts while there is none: what stands there is not added."""
    scene = two("semi-implicit-euler", 0.1)
    clean, stale = (rw.Simulation(scene, ledger=False) for _ in range(2))
    for simulation in (clean, stale):
        simulation.step()
    for engine in (*stale._engine.engines, stale._engine):
        engine.state.forces.node.contact[...] = 7.0
    clean.step()
    stale.step()
    assert rows(stale) == 0
    assert clean.arrays.reaction.tobytes() == stale.arrays.reaction.tobytes()
    assert not any(one.state.forces.node.contact.any() for one in stale._engine.engines)


@pytest.mark.parametrize("longest", [1, 4, 16])
def test_what_is_taken_back_again_and_again_costs_little(longest: int) -> None:
    """Where anything is near in all calls of more frames than so many: an eighth more, but for the first."""
    far = FarApart(rw.Simulation(two("implicit-euler", 0.1))._engine)
    done, lost, most = 0, 0, 0
    while done < 5000:
        count = far._frames(64)
        stands = count <= longest
        if count > 1:
            far._note(count, stands)
        most = max(most, count if stands else 0)
        done, lost = done + (count if stands else 1), lost + (0 if stands else count)
    assert most == longest
    assert 0 < lost < done / 8 + 64
