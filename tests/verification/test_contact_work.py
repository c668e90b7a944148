"""The books of what ropes touch: motor, pressing and friction of every surface apart.

Friction only takes, pressing only takes, a motor gives torque times angle, and the entries of all surfaces
add up to the works of the laws.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import (
    Anchor,
    Box,
    Cylinder,
    Material,
    Obstacle,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Sphere,
    Spin,
    Velocity,
)
from verification.test_capstan import capstan
from verification.test_energy_of_contacts import crossing
from verification.test_touch import MU, g, incline

ENTRIES = {"motor", "normal", "friction", "stored", "method"}


def thrown(seed: int, method: str = "implicit-euler") -> Scene:
    """A wavy rope thrown at a floor, a ball that moves and a drum that turns."""
    rng = np.random.default_rng(seed)
    along = np.linspace(0.0, 0.6, 9)
    wave = 0.03 * np.sin(9.0 * along + rng.uniform(0.0, 6.0))
    places = np.stack([along - 0.3, 0.02 * rng.normal(size=9), 0.32 + wave], axis=1)
    rope = Rope(
        segments=8,
        length=float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum()),
        diameter=0.01,
        made_of=Material(EA=2e3, mass_per_length=0.1, axial_damping=1.0),
        shape=Points(
            points=[tuple(map(float, p)) for p in places], velocity=tuple(rng.normal(size=3))
        ),
    )
    ball = {"kind": "velocity", "velocity": tuple(0.2 * rng.normal(size=3))}
    bodies: list[Obstacle] = [
        Plane(name="floor", friction=float(rng.uniform(0.0, 0.8))),
        Sphere(name="ball", center=(0.1, 0, 0.16), radius=0.1, friction=0.4, motion=ball),
        Cylinder(
            name="drum",
            start=(-0.15, -0.5, 0.16),
            end=(-0.15, 0.5, 0.16),
            radius=0.08,
            friction=float(rng.uniform(0.1, 1.0)),
            spin=Spin(rate=float(rng.uniform(-9.0, 9.0))),
        ),
    ]
    run = RunSettings(method=method, time_step=1 / 240, frame_rate=240, duration=0.3)
    return Scene(ropes=[rope], obstacles=bodies, run=run)


def left(result: rw.Result) -> float:
    """The largest difference between the laws' works and all entries [J]."""
    every = [part for entries in result.contact_work.values() for part in entries.values()]
    laws = [result.work[name] for name in ("obstacle", "contact") if name in result.work]
    return float(np.abs(sum(every) - sum(laws)).max())


@pytest.mark.parametrize("seed", range(4))
def test_friction_and_pressing_only_take(seed: int) -> None:
    """In no frame does either entry rise, but for pressing on round bodies, where a step takes a chord for
    an arc; a twin: what is stored is given back.
    """
    result = rw.simulate(thrown(seed))
    assert set(result.contact_work) == {"floor", "ball", "drum"}
    taken = 0.0
    for name, entries in result.contact_work.items():
        assert set(entries) == ENTRIES
        scale = max(float(np.abs(part).max()) for part in entries.values())
        assert np.diff(entries["friction"]).max() <= 1e-12 * scale, name
        assert np.diff(entries["normal"]).max() <= (1e-12 if name == "floor" else 1e-3) * scale, (
            name
        )
        taken -= float(entries["friction"][-1] + entries["normal"][-1])
    assert taken > 0.01 * np.ptp(result.energy["kinetic"])
    stored = sum(entries["stored"] for entries in result.contact_work.values())
    assert np.diff(stored).max() > 0.0
    assert left(result) < 1e-13


@pytest.mark.parametrize("method", ["esdirk3", "bdf2", "semi-implicit-euler", "rk4", "adaptive"])
def test_entries_add_up_in_every_kind_of_method(method: str) -> None:
    """To rounding; and in what a method's order makes of it, friction and pressing take."""
    scene = thrown(0, method)
    step = (
        "auto" if method == "adaptive" else {"esdirk3": 1 / 240, "bdf2": 1 / 240}.get(method, 2e-4)
    )
    result = rw.simulate(scene.replace(run=scene.run.replace(time_step=step)))
    assert result.status == "finished"
    assert left(result) < 1e-12
    for entries in result.contact_work.values():
        for name in ("friction", "normal"):
            assert np.diff(entries[name]).max() < 0.02 * max(-entries[name][-1], 1e-3), name


@pytest.mark.parametrize("rate", [2.0, -5.0])
def test_a_drums_motor_gives_torque_times_angle(rate: float) -> None:
    """Under a rope with one end pinned, which slips: the chord of a step is shorter than its arc by a^2/6.

    From 0.1 s on: the drum starts at once, and what is struck is solved for in parts of a step.
    """
    scene = capstan(180, MU, 1.0, method="implicit-euler", pinned=True, duration=0.4)
    scene = scene.replace(obstacles=[scene.obstacles[0].replace(spin=Spin(rate=rate))])
    result = rw.simulate(scene)
    x, f = result.positions, result.contact_force
    torque = (x[..., 2] * f[..., 0] - x[..., 0] * f[..., 2]).sum(axis=1)  # of the drum, about +y
    expected = torque[7:] * rate / 60.0
    motor = np.diff(next(iter(result.contact_work.values()))["motor"][6:])
    assert motor == pytest.approx(expected * (1.0 - (rate / 60.0) ** 2 / 6.0), rel=1e-4)
    assert expected.min() > 0.02


@pytest.mark.parametrize("friction", [0.0, 0.1])
def test_a_round_bar_as_a_box_gives_what_a_cylinder_does(friction: float) -> None:
    """Torque times angle: its surface moves, that of a cylinder slides along itself, under a rope that hangs.

    A chord of the surface's way, which ends below it, would cost N R w^2 h / 2, 0.4 W of 2 W here.
    """
    scene = capstan(180, friction, 1.0, pinned=True, duration=0.3, time_step=1 / 240)
    spin, round_bar = Spin(rate=10.0), scene.obstacles[0]
    box = Box(
        center=(0, 0, 0),
        half_sizes=(0.05, 0.5, 0.05),
        edge_radius=0.05,
        axis=(0, 1, 0),
        friction=friction,
        compliance=round_bar.compliance,
        spin=spin,
    )
    drum, bar = (
        rw.simulate(scene.replace(obstacles=[body])) for body in (round_bar.replace(spin=spin), box)
    )
    powers = []
    for result in (drum, bar):
        (entries,) = result.contact_work.values()
        powers.append(float(np.ptp(entries["motor"][6:]) / (result.time[-1] - result.time[6])))
        assert left(result) < 1e-12
    wrap = drum.wrap(drum.scene.obstacles[0].name)
    torque = float(np.abs(wrap.before - wrap.after)[6:].mean()) * 0.055
    assert powers == pytest.approx([10.0 * torque] * 2, rel=2e-3, abs=1e-6)


def test_a_table_that_is_pushed_gives_force_times_way() -> None:
    """Under a rope held at one end: mu m g v t, all of which friction takes."""
    scene, _ = incline(0.0, "implicit-euler", duration=0.5)
    table = Plane(name="table", friction=MU, motion=Velocity(velocity=(0.3, 0.0, 0.0)))
    result = rw.simulate(scene.replace(obstacles=[table], anchors=[Anchor(node=0)]))
    pushed = float((result.contact_force[1:, :, 0].sum(axis=1) * 0.3 / 60.0).sum())
    entries = result.contact_work["table"]
    assert float(entries["motor"][-1]) == pytest.approx(pushed, rel=1e-9)
    slid = MU * 0.03 * g * (6.0 - 0.5) / 6.0  # the anchor has half a segment's weight
    assert float(np.diff(entries["friction"])[-1]) == pytest.approx(-slid * 0.3 / 60.0, rel=1e-2)


@pytest.mark.parametrize(("method", "within"), [("implicit-euler", 0.06), ("esdirk3", 0.006)])
def test_friction_takes_what_a_sliding_rope_had(method: str, within: float) -> None:
    """m v^2 / 2, to the order of the method; without friction nothing at all."""
    scene, _ = incline(0.0, method, speed=1.0, duration=0.5)
    entries = next(iter(rw.simulate(scene).contact_work.values()))
    assert float(entries["friction"][-1]) == pytest.approx(-0.015, rel=within)
    assert not entries["motor"].any()
    smooth = scene.replace(obstacles=[scene.obstacles[0].replace(friction=0.0)])
    assert not next(iter(rw.simulate(smooth).contact_work.values()))["friction"].any()


def test_ropes_that_move_by_themselves_share_a_surface() -> None:
    """Two ropes on one plane are two islands: its entries are the sums of those of each alone."""
    scene, _ = incline(25.0, "implicit-euler", duration=0.2)
    there = scene.ropes[0].replace(name="other", made_of=Material(EA=1e3, mass_per_length=0.3))
    apart = [rw.simulate(scene.replace(ropes=[rope])) for rope in (scene.ropes[0], there)]
    both = rw.simulate(scene.replace(ropes=[scene.ropes[0].replace(name="one"), there]))
    for name, whole in next(iter(both.contact_work.values())).items():
        alone = sum(next(iter(part.contact_work.values()))[name] for part in apart)
        assert np.abs(whole - alone).max() <= 1e-12, name


def test_ropes_on_ropes_have_entries_of_their_own() -> None:
    """Friction only takes, and they add up; a clap makes nothing of 1 % of what it takes.

    What lies still is pressed up: the motor's, 1e-3 of what the others take, at most.
    """
    scene = crossing()
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=0.5)))
    entries = result.contact_work["ropes on ropes"]
    assert left(result) < 1e-13
    assert np.diff(entries["friction"]).max() <= 1e-15
    assert float(entries["friction"][-1]) < 0.0
    assert np.diff(entries["normal"]).max() < -0.01 * float(entries["normal"][-1])
    assert (
        0.0
        < np.ptp(entries["motor"])
        < -1e-3 * float((entries["friction"] + entries["normal"])[-1])
    )


def test_they_are_in_table_dataset_and_file(tmp_path: Path) -> None:
    scene = thrown(1)
    folder = tmp_path / "run"
    result = rw.run(scene.replace(run=scene.run.replace(duration=0.2)), folder)
    header = "friction of drum [J]"
    kept = rw.open(folder)
    expected = result.contact_work["drum"]["friction"]
    assert np.array_equal(kept.contact_work["drum"]["friction"], expected)
    assert np.array_equal(kept.to_pandas("run")[header], expected)
    assert np.array_equal(kept.datasets["run"]["friction_of_drum"], expected)
    data = kept.dataset["contact_work"]
    assert data.dims == ("time", "surface", "entry")
    assert list(data["surface"].values) == ["floor", "ball", "drum"]
    blind = rw.simulate(scene.replace(run=scene.run.replace(duration=0.1)), ledger=False)
    assert np.isnan(blind.contact_work["drum"]["friction"]).all()
    assert np.isnan(blind.read("contact_work")).all()
    assert math.isclose(float(data.sel(surface="drum", entry="friction")[-1]), expected[-1])
