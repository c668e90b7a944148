"""Long ropes cut into tiles of nodes and steps give the same bits as one sweep over all nodes per step."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from ropewalk.core.arrays import flatten
from ropewalk.lowering import build
from ropewalk.methods.tiles import DEPTH, TILE
from ropewalk.scene import Air, Anchor, Ground, Material, Rope, RunSettings, Scene, Shake
from ropewalk.simulation import Simulation

FRAMES = 3


def long_scene(segments: int, laws: str, ropes: int = 1) -> Scene:
    """Ropes in wind above the ground; anchors where tiles meet, some moving, some released."""
    material = Material(
        EA=400.0,
        mass_per_length=0.1,
        axial_damping=0.02,
        friction="vector" if laws == "plain" else "axial",
        tension_only=laws == "all",
    )
    rope = Rope(
        name="rope0",
        segments=segments,
        length=0.1 * segments,
        made_of=material,
        shape={"kind": "straight", "start": (0, 0, 0), "end": (0.1003 * segments, 0, 0)},
        kicks=[{"node": TILE - 2, "velocity": (0.3, 2.0, 1.0)}],
    )
    nodes = [0, TILE - 1, TILE, TILE + 1, 2 * TILE - DEPTH, segments]
    motions = [{}, {"motion": Shake(axis=(0, 1, 0), amplitude=0.02, frequency=9.0)}]
    motions += [{"release_time": 0.03}, {"motion": {"kind": "velocity", "velocity": (0, 0, 1)}}]
    more = {}
    if laws == "all":
        more["air"] = Air(node_drag=0.01, density=1.2, wind=(1, 3, 0))
        more["ground"] = Ground(height=-0.001)
    return Scene(
        ropes=[rope.replace(name=f"rope{i}") for i in range(ropes)],
        anchors=[
            Anchor(name=f"a{i}-{node}", rope=f"rope{i}", node=node, **motions[(i + k) % 4])
            for i in range(ropes)
            for k, node in reversed(list(enumerate(nodes)))
            if node <= segments
        ],
        run=RunSettings(
            duration=1.0,
            frame_rate=25.0,
            time_step=0.04 / (DEPTH + 9),
            method="semi-implicit-euler",
        ),
        **more,
    )


def run(scene: Scene, *, tiles: bool, ledger: bool) -> tuple[Simulation, np.ndarray]:
    model = build(scene)
    if not tiles:
        model = replace(model, system=model.system._replace(rare=1))
    simulation = Simulation(model, ledger=ledger)
    if not tiles:
        simulation._engine._extras = 1  # as with winches and limiter: one tile
    if "air" in scene.model_fields_set:
        simulation.apply_force(TILE + 2, (0.0, 0.5, 0.2), scene.ropes[-1].name)
    return simulation, simulation.advance_frames(FRAMES).recording.x


@pytest.mark.parametrize("laws", ["plain", "all"])
@pytest.mark.parametrize("ledger", [True, False])
@pytest.mark.parametrize(
    ("segments", "ropes"),
    [(2 * TILE - 2, 1), (2 * TILE - 1, 1), (2 * TILE, 1), (3 * TILE + 7, 1), (TILE + 99, 3)],
)
def test_tiles_change_no_bit(segments: int, ropes: int, ledger: bool, laws: str) -> None:
    """Every array of the state: positions, forces, work, reactions, anchors.

    The acceleration is another method's; with plain forces it is not written at all.
    The twin: one bit in one node of the start is seen.
    """
    scene = long_scene(segments, laws, ropes)
    tiled, frames = run(scene, tiles=True, ledger=ledger)
    whole, expected = run(scene, tiles=False, ledger=ledger)
    assert tiled.plan.steps_per_frame == DEPTH + 9
    assert np.array_equal(frames, expected)
    found, wanted = flatten(tiled.arrays), flatten(whole.arrays)
    kept = [
        name for name in found if not name.startswith("peaks.")
    ]  # tiles keep lengths, not tensions
    assert [name for name in kept if not np.array_equal(found[name], wanted[name])] == []
    assert not np.array_equal(frames[0], frames[-1])

    other = Simulation(scene, ledger=ledger)
    middle = segments // 2 + 5
    other.arrays.x[0, middle] = np.nextafter(other.arrays.x[0, middle], np.inf)
    assert not np.array_equal(other.advance_frames(FRAMES).recording.x, frames)


@pytest.mark.parametrize("laws", ["plain", "axial"])
def test_one_sum_of_forces_changes_no_bit(laws: str) -> None:
    """Without a ledger the forces of a plain rope's segment are added up first; see `spring_forces`.

    Positions, velocities and reactions. The twin: without friction they are others.
    """
    scene = long_scene(2 * TILE, laws)
    summed, frames = run(scene, tiles=True, ledger=False)
    apart, expected = run(scene, tiles=True, ledger=True)
    assert np.array_equal(frames, expected)
    assert np.array_equal(summed.arrays.v, apart.arrays.v)
    assert np.array_equal(summed.arrays.reaction, apart.arrays.reaction)

    rope = scene.ropes[0]
    slick = scene.replace(ropes=[rope.replace(made_of=rope.made_of.replace(axial_damping=0.0))])
    assert not np.array_equal(run(slick, tiles=True, ledger=False)[1], frames)
