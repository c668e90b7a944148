"""Springs without a rest length are rope like any other: tables, arrays and exports hold them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import ropewalk as rw
import runs
from ropewalk import plots
from ropewalk.cli import main
from ropewalk.cli.results_table import results_rows
from ropewalk.record.result import Result
from ropewalk.scene import Sphere, Straight


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


@pytest.fixture(scope="module")
def drawn_out() -> rw.Scene:
    """Four springs of 100 N/m between nodes of 0.1 kg, drawn to 0.5 m each, above a ball."""
    springs = rw.Springs(
        spring_constant=100.0, node_mass=0.1, segment_length=0.0, spring_friction=0.5
    )
    shape = Straight(start=(0, 0, 0), end=(2, 0, 0))
    rope = rw.Rope(segments=4, made_of=springs, shape=shape, diameter=0.01)
    settings = rw.RunSettings(duration=0.1, time_step=2e-3, method="semi-implicit-euler")
    return rw.Scene(
        ropes=[rope],
        anchors=[rw.Anchor(node=0), rw.Anchor(node=-1)],
        obstacles=[Sphere(center=(1, 0, -0.1), radius=0.08)],
        run=settings,
    )


def test_waves_run_along_it_as_fast_as_sideways(drawn_out: rw.Scene) -> None:
    """They stood at 0 m/s: a segment's rest length is no way that a wave goes."""
    (rope,) = rw.check(drawn_out.replace(obstacles=[]), measure=False).ropes
    assert rope.longitudinal == pytest.approx((0.5 * np.sqrt(100.0 / 0.1),) * 2, rel=1e-3)
    assert rope.transverse == pytest.approx(rope.longitudinal, rel=1e-9)


def test_figures_lay_its_segments_side_by_side(drawn_out: rw.Scene) -> None:
    """All points lay at 0 m, and an axis of 1 m had the segments."""
    result = rw.simulate(drawn_out)
    tension, forces, contact = (
        draw(result).axes for draw in (plots.tension, plots.forces, plots.contact)
    )
    assert tension[0].images[0].get_extent()[2:] == [0.0, 4.0]
    assert tension[0].get_ylabel() == "along the rope [segments]"
    profile = plots.tension(result, times=[0.1]).axes[1]
    for axes in (profile, forces[1], contact[1]):
        assert axes.get_xlabel() == "along the rope [segments]"
        assert list(axes.lines[0].get_xdata()) == [0.5, 1.5, 2.5, 3.5]
    assert list(contact[0].lines[0].get_xdata()) == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert forces[1].get_xlim() == profile.get_xlim() == (0.0, 4.0)


def test_what_lies_on_a_drum_is_no_rope() -> None:
    winched = rw.simulate(runs.winched(duration=0.3))
    on_drum = winched.rest_length == 0.0
    assert on_drum.any()
    assert not winched.live[on_drum].any()


def test_its_stretch_is_its_length_to_a_verdict() -> None:
    """Drawn to a centimetre and let fall on an end, it turns over more than it has at first: it "broke"."""
    springs = rw.Springs(spring_constant=100.0, node_mass=0.1, segment_length=0.0)
    shape = Straight(end=(0.01, 0, 0))
    scene = rw.Scene(
        ropes=[rw.Rope(segments=5, made_of=springs, shape=shape)],
        anchors=[rw.Anchor(node=0)],
        run=rw.RunSettings(duration=0.5, method="semi-implicit-euler"),
    )
    result = rw.simulate(scene)
    assert result.status == "finished"
    assert result.positions[:, -1, 2].min() < -0.1  # far more than a centimetre
    assert result.table["largest energy error, share of the energy turned over [%]"] < 20.0


def test_it_touches_rope_in_implicit_steps() -> None:
    """No Newton step was short enough for a segment of no length: "found no solution of step 1"."""
    springs = rw.Springs(
        spring_constant=200.0, node_mass=0.05, segment_length=0.0, spring_friction=0.2
    )
    lines = {"a": ((-0.2, 0, 0), (0.2, 0, 0)), "b": ((0, -0.2, 0.011), (0, 0.2, 0.011))}
    ropes = [
        rw.Rope(
            name=name,
            segments=4,
            made_of=springs,
            diameter=0.01,
            shape=Straight(start=start, end=end),
        )
        for name, (start, end) in lines.items()
    ]
    scene = rw.Scene(
        ropes=ropes,
        contact=rw.Contact(),
        anchors=[rw.Anchor(rope="a", node=node) for node in (0, -1)],
        run=rw.RunSettings(method="esdirk3", time_step=1e-3, duration=0.1, frame_rate=100.0),
    )
    result = rw.simulate(scene)
    assert result.status == "finished"
    assert result.work["contact"].min() < 0.0  # they have met
