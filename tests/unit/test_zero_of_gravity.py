"""Gravity's energy has one zero, the scene's own shape, in arrays, tables, figures and files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.plots.energies import energy_curves
from ropewalk.record.turnover import largest_change
from ropewalk.scene import Anchor, Rope, RunSettings, Scene, Straight


def high(**run: object) -> Scene:
    """A rope a kilometre above the origin, drawn level, let go at one end."""
    rope = Rope(
        segments=10,
        length=2.0,
        made_of=rw.Material(EA=2000.0, mass_per_length=0.2, axial_damping=5.0),
        shape=Straight(start=(0, 0, 1000.0), direction=(1, 0, 0)),
    )
    settings = RunSettings(**({"duration": 0.4, "method": "semi-implicit-euler"} | run))
    return Scene(run=settings, ropes=(rope,), anchors=(Anchor(node=0),))


def test_arrays_table_figure_and_store_count_from_the_scenes_shape(tmp_path: Path) -> None:
    result = rw.run(high(), tmp_path / "run")
    fallen = (result.positions[..., 2] - 1000.0) * np.array([0.02, *[0.04] * 9, 0.02]) * 9.81
    gravity = result.energy["gravity"]
    assert gravity[0] == 0.0
    np.testing.assert_allclose(gravity, fallen.sum(axis=1), atol=1e-9)
    assert gravity[-1] < -0.5
    curves = energy_curves(result)
    np.testing.assert_array_equal(curves["gravity"], gravity)
    np.testing.assert_allclose(curves["total"], result.energy["total"], atol=1e-12)
    assert result.table["final total energy [J]"] == pytest.approx(curves["total"][-1], abs=1e-12)
    assert "scene's own shape" in result.table["final total energy at"]
    stored = result.dataset["energy"]
    np.testing.assert_array_equal(stored.sel(form="gravity"), gravity)
    assert "scene's own shape" in stored.attrs["long_name"]
    np.testing.assert_array_equal(rw.simulate(high()).energy["gravity"], gravity)


def test_a_run_from_rest_starts_with_what_settling_frees() -> None:
    rest, run = rw.equilibrium(high()), rw.simulate(high(start="at-rest", duration=0.1))
    # From level to hanging: the middle falls by half the length, and the stretch.
    assert rest.energy["gravity"][0] == pytest.approx(-0.4 * 9.81 * 1.0, rel=2e-3)
    np.testing.assert_allclose(run.energy["gravity"][0], rest.energy["gravity"][0], rtol=1e-12)


def test_the_energy_error_is_told_as_a_share() -> None:
    result = rw.simulate(high())
    key = "largest energy error, share of the energy turned over [%]"
    turned = max(np.ptp(result.energy[form]) for form in ("kinetic", "gravity", "elastic"))
    forms = [part for name, part in result.energy.items() if name != "total"]
    assert largest_change(forms) == turned
    largest = result.table["largest energy error [J]"]  # of every step
    assert largest >= np.abs(result.energy_error).max()
    share = 100.0 * largest / turned
    assert result.table[key] == pytest.approx(share, rel=1e-12)
    assert 0.0 < share < 5.0
