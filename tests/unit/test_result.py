"""Results in memory: shapes, names, balances, ropes, words."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import ropewalk as rw
import runs
from ropewalk import plots
from ropewalk.api import BrokenRun
from ropewalk.core.status import OK
from ropewalk.record.errors import RunError
from ropewalk.record.result import Result


@pytest.fixture(scope="module")
def result() -> Result:
    return rw.simulate(runs.hanging())


@pytest.fixture(scope="module")
def winched() -> Result:
    return rw.simulate(runs.winched())


def test_the_first_frame_is_the_initial_state(result: Result) -> None:
    assert result.frames == result.plan.frames + 1 == 121
    assert result.time[0] == 0.0
    np.testing.assert_array_equal(result.positions[0, :, 0], np.arange(11.0))
    np.testing.assert_array_equal(result.velocities[0, 1:], 0.0)
    assert result.velocities[0, 0, 2] == pytest.approx(0.2 * 2.0 * np.pi)  # the shaken anchor
    assert result.time[-1] == pytest.approx(2.0, rel=1e-12)


def test_shapes(result: Result) -> None:
    f, n, a = 121, 11, 2
    assert result.positions.shape == result.velocities.shape == (f, n, 3)
    assert result.tension.shape == result.rest_length.shape == result.live.shape == (f, n - 1)
    assert result.reactions.shape == (f, a, 3)
    assert result.momentum.shape == result.angular_momentum.shape == (f, 3)
    assert set(result.energy) == {"kinetic", "gravity", "elastic", "total"}
    assert {"friction", "weight", "anchor:left", "anchor:right"} <= set(result.work)


def test_frames_equal_a_stepwise_simulation(result: Result) -> None:
    simulation = rw.Simulation(runs.hanging())
    for frame in range(1, 20):
        simulation.step()
        np.testing.assert_array_equal(result.positions[frame], simulation.positions)


def test_energies_follow_from_positions_and_velocities(result: Result) -> None:
    kinetic = 0.5 * 0.05 * (result.velocities**2).sum(axis=(1, 2))
    np.testing.assert_allclose(result.energy["kinetic"], kinetic, rtol=1e-12, atol=1e-15)
    gravity = 0.05 * 9.81 * (result.positions[..., 2] - result.positions[0, :, 2]).sum(axis=1)
    np.testing.assert_allclose(result.energy["gravity"], gravity, rtol=1e-9, atol=1e-12)
    lengths = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
    np.testing.assert_allclose(result.elastic_tension, 10000.0 * (lengths - 1.0), atol=1e-8)
    np.testing.assert_allclose(
        result.energy["elastic"], 5000.0 * ((lengths - 1.0) ** 2).sum(axis=1), atol=1e-9
    )
    total = result.energy["kinetic"] + result.energy["gravity"] + result.energy["elastic"]
    np.testing.assert_allclose(result.energy["total"], total, rtol=1e-14)


@pytest.mark.parametrize("name", ["result", "winched"])
def test_the_kinetic_balance_closes_to_round_off(name: str, request: pytest.FixtureRequest) -> None:
    run: Result = request.getfixturevalue(name)
    scale = max(float(np.abs(work).max()) for work in run.work.values())
    assert np.abs(run.balance_residual).max() < 1e-11 * scale


def test_the_balance_notices_a_work_left_out(result: Result) -> None:
    from ropewalk.record.balances import balance_residual

    work = dict(result.work) | {"air": np.zeros(result.frames)}
    left = balance_residual(result.energy, work, result.read("jump"), True)
    assert np.abs(left).max() > 1e-3


def test_the_energy_error_shrinks_with_the_step(result: Result) -> None:
    fine = rw.simulate(runs.hanging(time_step=0.0002))
    assert np.abs(fine.energy_error).max() < 0.2 * np.abs(result.energy_error).max()


def test_without_a_ledger_the_balances_are_not_numbers(tmp_path: Path) -> None:
    bare = rw.simulate(runs.hanging(duration=0.1), ledger=False)
    assert np.isnan(bare.energy_error).all()
    assert np.isnan(bare.balance_residual).all()
    assert "no energy ledger" in repr(bare)
    assert all(np.isnan(work).all() for work in bare.work.values())  # zeros, which were told
    assert np.isnan(bare.dataset["work"]).all()
    assert np.isnan(bare.read("work")).all()  # as in a folder; zeros were read
    rw.run(runs.hanging(duration=0.1), tmp_path / "run", ledger=False)
    with xr.open_zarr(tmp_path / "run" / "data.zarr", chunks=None) as data:
        assert np.isnan(data["work"]).all()
        assert np.isfinite(data["energy"]).all()
    labels = [line.get_label() for line in plots.energy(bare).axes[0].lines]
    assert not [label for label in labels if label.startswith("work of")]


def test_nodes_and_ropes_by_name(winched: Result) -> None:
    end = winched.node(-1, "line")
    np.testing.assert_allclose(end["height"], end["position"][:, 2])
    assert end["position"][0].tolist() == pytest.approx([0.0, 0.0, -4.0], abs=1e-3)
    assert end["height"][-1] < end["height"][0] - 0.5  # the winch pays out
    free = winched.rope("free")
    assert free.positions.shape[1] == 6
    assert free.tension.shape[1] == 5
    np.testing.assert_allclose(free.arc_length, 0.5 * np.arange(5) + 0.25)
    np.testing.assert_allclose(free.stretch, 1.0, atol=1e-9)  # falls freely
    with pytest.raises(KeyError, match="line, free"):
        winched.rope("lin")
    with pytest.raises(IndexError, match="0 to 8"):
        winched.node(9, "line")


def test_segments_without_rope_are_dead(winched: Result) -> None:
    line = winched.rope("line")
    between = winched.layout.span("line").last
    assert not winched.live[:, between].any()
    np.testing.assert_array_equal(winched.tension[~winched.live], 0.0)
    assert line.live[-1].sum() > line.live[0].sum()  # segments came off the drum
    np.testing.assert_allclose(line.rest_length[-1].sum(), 4.0 + 0.5 * 1.6, atol=1e-3)
    assert (line.stretch[~line.live] == 1.0).all()
    assert line.numbers[0] < 0
    assert winched.rope("free").live.all()


def test_the_table_names_the_extremes(result: Result) -> None:
    table = result.table
    greatest = result.greatest_tension
    frame, segment = np.unravel_index(np.argmax(greatest), greatest.shape)
    assert table["largest tension [N]"] == greatest[frame, segment] >= result.tension.max()
    place, when = table["largest tension at"].split(", ")
    assert place == f"segment {segment} of rope 'rope'"
    said = [float(word) for word in when.split() if word[0].isdigit()]
    assert result.time[frame - 1] - 1e-5 <= said[0] <= said[-1] <= result.time[frame] + 1e-5
    for name in ("largest tension", "largest stretch", "largest speed", "lowest point"):
        assert "recorded frames" not in table[f"{name} at"]
    speed = np.linalg.norm(result.velocities, axis=2)
    assert 1.0 <= table["largest speed [m/s]"] / speed.max() < 1.05
    assert table["lowest point [m]"] <= result.positions[..., 2].min()
    assert table["steps"] == 120 * 9


def test_the_table_is_the_same_in_pieces(result: Result, monkeypatch: pytest.MonkeyPatch) -> None:
    from ropewalk.record import extremes

    whole = extremes._of_frames(result)
    monkeypatch.setattr(extremes, "_VALUES", 100)
    assert str(extremes._of_frames(result)) == str(whole)  # NaN is not equal to itself


def test_repr_is_a_sentence(result: Result) -> None:
    said = repr(result)
    for part in ("'hanging'", "10 segments", "2 s", "121 frames", "semi-implicit-euler"):
        assert part in said
    assert "finished" in said
    assert said.count("\n") == 0


def test_a_broken_run_raises_with_its_result() -> None:
    with pytest.raises(BrokenRun) as raised:
        rw.simulate(runs.breaking())
    result = raised.value.result
    assert isinstance(raised.value, rw.Broken)
    assert result.status == "broke"
    assert result.diagnosis == raised.value.diagnosis
    assert str(raised.value).startswith(result.diagnosis)
    assert 1 < result.frames < 121
    assert np.isfinite(result.positions).all()
    assert str(result.diagnosis) in repr(result)


def test_a_broken_run_can_go_on() -> None:
    short = rw.simulate(runs.breaking(), on_failure="return")
    long = rw.simulate(runs.breaking(), on_failure="return", keep_going=True)
    assert long.frames == 121
    assert long.status == "broke"
    assert long.diagnosis == short.diagnosis
    np.testing.assert_array_equal(long.positions[: short.frames], short.positions)
    lengths = np.linalg.norm(np.diff(long.positions[short.frames :], axis=1), axis=2)
    assert not lengths.max() < 10.0  # absurd, or not a number
    assert np.isfinite(long.table["largest tension [N]"])


def test_wrong_requests_are_refused() -> None:
    with pytest.raises(rw.SceneError, match="no-such-preset"):
        rw.simulate("no-such-preset")
    with pytest.raises(ValueError, match="on_failure"):
        rw.simulate(runs.hanging(), on_failure="ignore")  # type: ignore[arg-type]


def test_progress_counts_frames() -> None:
    seen: list[tuple[int, int]] = []
    rw.simulate(runs.hanging(), progress=lambda done, planned, _: seen.append((done, planned)))
    assert seen[-1] == (120, 120)


def test_the_dataset_has_names_and_units(winched: Result) -> None:
    data = winched.dataset
    assert data.positions.dims == ("time", "node", "axis")
    assert data.tension.attrs["units"] == "N"
    assert data.time.attrs["units"] == "s"
    assert all("long_name" in data[name].attrs for name in data.variables)
    line = data.positions.isel(node=(data.node_rope == "line") & (data.node_number == 8))
    np.testing.assert_array_equal(line[:, 0], winched.node(8, "line")["position"])
    np.testing.assert_array_equal(data.work.sel(law="weight"), winched.work["weight"])


def test_a_result_loads_no_figures_and_no_stores() -> None:
    code = (
        "import sys, runs, ropewalk as rw\n"
        "r = rw.simulate(runs.hanging(duration=0.1)); repr(r); r.table\n"
        "print(sorted({'matplotlib', 'xarray', 'zarr', 'pandas', 'pyarrow'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
    )
    assert done.stdout.strip() == "[]"


def test_numbers_of_a_broken_run_come_without_numpys_warnings() -> None:
    """Recorded on into its break a run has infinite and NaN numbers; what is made of them says NaN, and
    the table keeps to finite ones. The twin: before the break all is finite.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made = rw.preset("r6")
        result = rw.simulate(
            made.replace(run=made.run.replace(duration=3.0)), keep_going=True, on_failure="return"
        )
        assert np.isnan(result.energy_error[-1])
        assert np.isnan(result.balance_residual[-1])
        assert not np.isfinite(result.rope().stretch[-1]).all()
        assert np.isfinite(result.table["largest tension [N]"])
        assert "broke" in repr(result)
        assert result.node(3)["height"].shape == (result.frames,)
    assert np.isfinite(result.energy_error[:3]).all()


def test_the_energy_error_that_a_result_shows_is_the_largest(result: Result) -> None:
    """Of every step, not that of the last frame, which may be small by chance."""
    largest, last = result.table["largest energy error [J]"], abs(result.energy_error[-1])
    assert largest > last
    assert f"energy error at most {largest:.3g} J" in repr(result)
    without = rw.simulate(runs.hanging(duration=0.1), ledger=False)
    assert "no energy ledger" in repr(without)


def test_completion_of_a_simulation_shows_what_users_have() -> None:
    """Each of it is there and has a meaning; what recorders and pages use besides is not shown."""
    simulation = rw.Simulation(runs.hanging())
    shown = dir(simulation)
    assert {"step", "frames", "positions", "anchors", "tension", "apply_force", "view"} <= set(
        shown
    )
    assert not any(name.startswith("_") for name in shown)
    assert all(hasattr(simulation, name) for name in shown)
    assert {"arrays", "system", "take_in_hand", "watchers", "slices"} & set(shown) == set()


def test_no_frame_is_nearest_to_no_time(result: Result) -> None:
    assert result.frame_at(-1.0) == 0
    assert result.frame_at(9.0) == result.frames - 1
    with pytest.raises(ValueError, match="must be a number of seconds"):
        result.frame_at(float("nan"))


def test_numbers_of_another_run_are_refused_where_it_has_replaced_the_one_that_was_opened(
    tmp_path: Path,
) -> None:
    one, other = (runs.hanging(duration=0.05, segments=2, spring_constant=k) for k in (1e3, 50.0))
    rw.run(one, tmp_path / "run")
    opened, data = rw.open(tmp_path / "run"), rw.open(tmp_path / "run").dataset
    early = opened.positions
    rw.run(other, tmp_path / "run", overwrite=True)
    assert opened.positions is early  # what was read stays
    for late in (
        lambda: opened.tension,
        lambda: opened.beyond,
        lambda: data["positions"].values,
        lambda: opened.dataset,
    ):
        with pytest.raises(RunError, match="run: holds another run by now; open it again"):
            late()
    again = rw.open(tmp_path / "run")
    assert again.beyond is None
    assert again.dataset["tension"].values.tolist() == again.tension.tolist()


@pytest.mark.parametrize("count", [-3, 1.5, True, "2"])
def test_what_is_no_count_of_steps_or_frames_is_refused(count: Any) -> None:
    """-3 steps turned the clock back, and 1.5 were one."""
    simulation = rw.Simulation(runs.hanging(duration=0.05, segments=2))
    for name, advance in (
        ("steps", simulation.advance_steps),
        ("frames", simulation.advance_frames),
        ("frames", lambda count: next(simulation.frames(count))),
    ):
        rule = f"{name}: {count!r} - must be a whole number from 0 on"
        with pytest.raises(ValueError, match=re.escape(rule)):
            advance(count)
    assert simulation.advance_steps(0) == OK  # it divided by zero
    assert simulation.time == 0.0
    assert list(simulation.frames(0)) == []
    simulation.advance_steps(np.int64(2))
    assert simulation.time == pytest.approx(2.0 * simulation.plan.dt)
