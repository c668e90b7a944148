"""Equilibria on bodies that move, shake, turn or spin freely from the start: at rest they stand still.

What anchors, bodies and weight do to the ropes adds up to nothing, and nothing rubs; tables, figures and
exports have the same contacts, those of equilibria that were saved, too.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.export import export
from ropewalk.record.folder import change_provenance
from ropewalk.record.result import Result
from ropewalk.record.stood import STAND
from ropewalk.record.summary import summary
from ropewalk.scene import (
    Box,
    Cylinder,
    Material,
    Orbit,
    Polyline,
    Shake,
    Spin,
    Table,
    Velocity,
)
from verification.setups import g

R = 0.2
FREE = {"free": True, "inertia": 0.01}
BODIES: dict[str, dict[str, Any]] = {
    "down": {"motion": Velocity(velocity=(0, 0, -1.0))},
    "up": {"motion": Velocity(velocity=(0, 0, 1.0))},
    "sideways, fast": {"motion": Velocity(velocity=(500.0, 0, 0))},
    "along its axis": {"motion": Velocity(velocity=(0, 1.0, 0))},
    "shakes": {"motion": Shake(axis=(0, 0, 1), amplitude=0.01, frequency=5.0)},
    "goes round": {"motion": Orbit(center=(0, 0, -1.0), axis=(0, 1, 0), frequency=1.0)},
    "by a table": {
        "motion": Table(times=(-1.0, 1.0), positions=((-1.0, 0, -0.25), (1.0, 0, -0.25)))
    },
    "spins": {"spin": Spin(rate=20.0)},
    "spins fast": {"spin": Spin(rate=2000.0)},
    "turns by a table": {"spin": Spin(times=(-1.0, 1.0), angles=(-20.0, 20.0))},
    "free": {"spin": Spin(**FREE)},
    "free, let go at a rate": {"spin": Spin(**FREE, rate=20.0)},
    "free, moves at a rate": {
        "spin": Spin(**FREE, rate=20.0),
        "motion": Velocity(velocity=(0, 0, 1.0)),
    },
}


def drum(**more: Any) -> Cylinder:
    return Cylinder(
        name="body", start=(0, -0.5, -0.25), end=(0, 0.5, -0.25), radius=R, friction=0.3, **more
    )


def block(**more: Any) -> Box:
    """A box, whose surface sweeps as it turns about the y axis."""
    return Box(
        name="body", center=(0, 0, -0.25), half_sizes=(0.2, 0.5, 0.2), edge_radius=0.05, axis=(0, 1, 0),
        friction=0.3, **more,
    )  # fmt: skip


def over(body: Cylinder | Box) -> rw.Scene:
    """A slack rope over a body, its ends held on both sides below the top."""
    rope = rw.Rope(
        name="r", segments=80, length=2.43, diameter=0.02,
        made_of=Material(EA=2e4, mass_per_length=0.2, axial_damping=5.0),
        shape=Polyline(points=[(-1, 0, -0.6), (-0.25, 0, 0), (0.25, 0, 0), (1, 0, -0.6)]),
    )  # fmt: skip
    run = {"method": "implicit-euler", "duration": 0.5, "time_step": 1 / 240}
    anchors = [rw.Anchor(node=0), rw.Anchor(node=-1)]
    return rw.Scene(ropes=[rope], anchors=anchors, obstacles=[body], run=run)


@cache
def on_what_stands() -> Result:
    return rw.equilibrium(over(drum()))


def check_balance(result: Result) -> None:
    """Check that the ropes are in balance, and that nothing rubs over a surface."""
    weight = -g * sum(rope.total_mass for rope in result.scene.ropes)
    held, borne = result.reactions[0].sum(axis=0), result.contact_force[0].sum(axis=0)
    size = np.abs(weight)
    assert held + borne + [0, 0, weight] == pytest.approx(np.zeros(3), abs=1e-8 * size)
    assert borne[2] > 0.5 * size
    (wrap,) = result.to_pandas("wraps").to_dict("records")
    assert wrap["friction power [W]"] == 0.0
    contacts = result.to_pandas("contacts")
    assert (contacts["slip speed [m/s]"] == 0.0).all()
    assert (contacts["friction power [W]"] == 0.0).all()
    assert set(contacts["mode"]) == {"sticks"}
    of_nodes = contacts[["fx [N]", "fy [N]", "fz [N]"]].to_numpy().sum(axis=0)
    assert of_nodes == pytest.approx(borne, abs=1e-8 * size)


@pytest.mark.parametrize("name", BODIES)
def test_a_body_that_moves_bears_what_one_that_stands_does(name: str) -> None:
    result, still = rw.equilibrium(over(drum(**BODIES[name]))), on_what_stands()
    check_balance(result)
    assert np.array_equal(result.contact_force, still.contact_force)
    assert np.array_equal(result.reactions, still.reactions)
    assert result.to_pandas("wraps").equals(still.to_pandas("wraps"))
    assert not np.any(result.velocities)


@pytest.mark.parametrize("name", ["up", "spins", "turns by a table", "goes round"])
def test_a_body_whose_surface_sweeps_stands_still_too(name: str) -> None:
    check_balance(rw.equilibrium(over(block(**BODIES[name]))))


def test_a_run_that_starts_at_rest_has_the_speed_of_its_bodies() -> None:
    """Only an equilibrium has them stand: the first frame of a run is struck by what moves."""
    moving = over(drum(**BODIES["spins"]))
    run = rw.simulate(moving.replace(run={"start": "at-rest", "duration": 0.02}))
    assert run.to_pandas("contacts")["slip speed [m/s]"].iloc[0] == pytest.approx(20.0 * R, rel=0.1)


@pytest.mark.parametrize("name", ["down", "spins", "free, let go at a rate"])
def test_what_was_saved_has_the_same_contacts(name: str, tmp_path: Path) -> None:
    result = rw.equilibrium(over(drum(**BODIES[name])))
    result.save(tmp_path / "rest")
    again = rw.open(tmp_path / "rest")
    check_balance(again)
    for table in ("contacts", "wraps"):
        assert again.to_pandas(table).equals(result.to_pandas(table))


@pytest.mark.parametrize("name", ["down", "spins", "free", ""])
def test_what_an_older_version_saved_is_told_of(name: str, tmp_path: Path) -> None:
    """It had no mark, and forces of bodies that move; of one that stands they are right."""
    result = rw.equilibrium(over(drum(**BODIES.get(name, {}))))
    result.save(tmp_path / "rest")
    assert "about the obstacles" not in summary(rw.open(tmp_path / "rest"))
    statics = dict(result.facts.provenance["statics"])
    del statics[STAND]
    change_provenance(tmp_path / "rest", statics=statics)
    told = str(summary(rw.open(tmp_path / "rest")).get("about the obstacles", ""))
    assert ("in which 'body' did not stand" in told) == bool(name)
    assert ("compute it anew, rw.equilibrium(result.scene)" in told) == bool(name)


@pytest.mark.parametrize("name", ["sideways, fast", "spins fast"])
def test_what_is_too_fast_for_a_step_has_tables_and_figures_at_rest(name: str) -> None:
    """No step is taken, and none is judged again to read the contacts."""
    scene = over(drum(**BODIES[name]))
    with pytest.raises(rw.SceneError):
        rw.simulate(scene)
    result = rw.equilibrium(scene)
    check_balance(result)
    result.plot.contact()


def test_exports_of_an_equilibrium_have_what_bodies_bear(tmp_path: Path) -> None:
    written = []
    for name, more in (("still", {}), ("down", BODIES["down"])):
        result = rw.equilibrium(over(drum(**more)))
        for kind in ("csv", "vtk"):
            export(result, kind, tmp_path / name / kind)
        files = sorted(
            path for path in (tmp_path / name).rglob("*") if path.suffix in (".csv", ".vtp")
        )
        written.append({path.relative_to(tmp_path / name): path.read_bytes() for path in files})
    assert written[0]
    assert written[0] == written[1]
