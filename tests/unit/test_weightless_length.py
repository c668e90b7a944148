"""Springs without a rest length are rope like any other: tables, arrays and exports hold them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import ropewalk as rw
import runs
from ropewalk.cli import main
from ropewalk.cli.results_table import results_rows
from ropewalk.record.result import Result


@pytest.fixture(scope="module")
def swing() -> Result:
    """NeHe's third demo: 1 kg on 2 N/m without a rest length, let go at 10 m."""
    return rw.simulate("n39-spring")


def test_the_largest_tension_is_that_of_the_spring(swing: Result) -> None:
    assert swing.table["largest tension [N]"] == pytest.approx(2.0 * 10.0, rel=0.01)
    assert swing.live.all()
    np.testing.assert_array_equal(swing.rope().live, True)


def test_no_stretch_is_told_where_nothing_has_a_length(swing: Result) -> None:
    assert np.isnan(swing.table["largest stretch [1]"])
    assert swing.table["largest stretch at"] == ""
    rows = results_rows(swing.table)
    assert "largest stretch" not in [name for name, _, _ in rows]
    assert not [row for row in rows if "inf" in row[1] or "nan" in row[1]]
    assert "nan" not in swing._repr_html_()
    chain = rw.simulate(runs.hanging(duration=0.1))
    assert "largest stretch" in [name for name, _, _ in results_rows(chain.table)]


def test_the_command_line_prints_it(tmp_path: Path) -> None:
    done = CliRunner().invoke(main, ["run", "n39-spring", "-o", str(tmp_path / "run")])
    assert "largest tension" in done.stdout
    assert "inf" not in done.stdout
    assert "nan" not in done.stdout


def test_vtk_holds_its_segment(swing: Result, tmp_path: Path) -> None:
    swing.save(tmp_path / "run")
    done = CliRunner().invoke(
        main, ["export", str(tmp_path / "run"), "--to", "vtk", "-o", str(tmp_path / "vtk")]
    )
    assert done.exit_code == 0, done.output
    frame = next((tmp_path / "vtk").rglob("*.vtp")).read_text()
    assert 'NumberOfLines="1"' in frame


def test_what_lies_on_a_drum_is_no_rope() -> None:
    winched = rw.simulate(runs.winched(duration=0.3))
    on_drum = winched.rest_length == 0.0
    assert on_drum.any()
    assert not winched.live[on_drum].any()
