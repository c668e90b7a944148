"""Broken runs: the steps past the break are kept apart, drawn as such, and counted nowhere."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D
from PIL import Image, ImageSequence

import ropewalk as rw
import runs
from ropewalk import plots
from ropewalk.cli import main
from ropewalk.cli.results_table import results_rows
from ropewalk.plots.torn import BROKEN
from ropewalk.record.result import Result
from ropewalk.scene import Velocity, dumps


@pytest.fixture(scope="module")
def broken() -> Result:
    return rw.simulate(runs.breaking(), on_failure="return")


@pytest.fixture(scope="module")
def into_it() -> Result:
    return rw.simulate(runs.breaking(), on_failure="return", keep_going=True)


def zigzag(positions: np.ndarray) -> float:
    """Correlation of the changes of neighbouring segments from their mean: -1 in a zigzag."""
    lengths = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    rough = np.diff(lengths)
    return float(np.corrcoef(rough[:-1], rough[1:])[0, 1])


def test_single_steps_past_the_last_good_frame_are_kept_apart(broken: Result) -> None:
    assert broken.status == "broke"
    beyond = broken.beyond
    assert beyond is not None
    assert beyond.time[0] == pytest.approx(broken.time[-1] + broken.plan.dt, rel=1e-12)
    np.testing.assert_allclose(np.diff(beyond.time), broken.plan.dt, rtol=1e-9)
    assert np.isfinite(beyond.positions).all()
    assert zigzag(beyond.positions[0]) < -0.5
    assert broken.frames == broken.good_frames == len(broken.positions)
    simulation = rw.Simulation(runs.breaking())
    for _ in range(broken.frames - 1):
        simulation.step()
    np.testing.assert_array_equal(simulation.positions, broken.positions[-1])
    simulation.advance_steps(1)
    np.testing.assert_array_equal(simulation.positions, beyond.positions[0])


def test_a_sound_run_has_nothing_beyond() -> None:
    result = rw.simulate(runs.hanging(duration=0.2))
    assert result.beyond is None
    assert result.good_frames == result.frames


@pytest.mark.parametrize("kind", ["shape", "film"])
def test_figures_draw_the_break_in_orange_and_say_so(broken: Result, kind: str) -> None:
    orange = to_hex(BROKEN)

    def lines(result: Result) -> int:
        figure = getattr(plots, kind)(result)
        drawn = [line for axes in figure.axes for line in axes.lines]
        return sum(
            to_hex(line.get_color()) == orange and len(line.get_xdata()) == 11 for line in drawn
        )

    assert lines(broken) in (1, 2)
    assert lines(rw.simulate(runs.hanging(duration=0.2))) == 0


def orange_lines(axes: Axes) -> list[Line2D]:
    return [line for line in axes.lines if to_hex(line.get_color()) == to_hex(BROKEN)]


def test_the_height_figure_draws_single_steps_past_the_break(broken: Result) -> None:
    assert broken.beyond is not None
    figure = plots.height(broken)
    past = [line for line in orange_lines(figure.axes[1]) if line.get_marker() == "."]
    assert past
    for line in past:
        assert line.get_xdata()[0] == broken.time[-1]
        assert line.get_xdata()[1] == broken.beyond.time[0]
        assert line.get_xdata()[-1] <= line.axes.get_xlim()[1]
    assert len(plots.height(rw.simulate(runs.hanging(duration=0.2))).axes) == 1


def test_the_tension_figure_draws_the_zigzag_past_the_break(broken: Result) -> None:
    assert broken.beyond is not None
    assert broken.beyond.tension is not None
    assert broken.beyond.tension.shape == (len(broken.beyond.time), 10)
    [line, *_] = orange_lines(plots.tension(broken).axes[1])
    drawn = np.asarray(line.get_ydata())
    np.testing.assert_array_equal(drawn, broken.beyond.tension[0])
    assert (np.diff(np.sign(np.diff(drawn))) != 0).sum() >= 6
    assert not any(
        orange_lines(axes) for axes in plots.tension(rw.simulate(runs.hanging(duration=0.2))).axes
    )


def test_all_panels_of_the_tension_figure_are_in_one_unit() -> None:
    """R6 breaks from 321 N to 53 kN in one step: the same number is as high in both panels."""
    result = rw.simulate("r6", on_failure="return")
    figure = plots.tension(result, times=[0.05])
    labels = [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel().endswith("N]")]
    assert len(labels) == 3  # profiles, break, colour bar
    assert {label[label.index("[") :] for label in labels} == {"[N]"}


def test_a_movie_ends_in_the_break_in_orange(broken: Result, tmp_path: Path) -> None:
    def pictures(result: Result) -> list[np.ndarray]:
        path = plots.movie(result, tmp_path / "it.gif", fps=10, size=(480, 300))
        with Image.open(path) as film:
            return [np.asarray(one.convert("RGB"), int) for one in ImageSequence.Iterator(film)]

    def orange(picture: np.ndarray) -> int:
        inside = picture[:, :380]  # without the colour bar
        return int((np.abs(inside - [213, 94, 0]).max(axis=2) < 12).sum())

    shown = pictures(broken)
    assert orange(shown[0]) == 0
    assert orange(shown[-1]) > 100
    seen = [number for number, one in enumerate(shown) if orange(one)]
    assert len(seen) > 0
    assert seen == list(range(seen[0], len(shown)))
    sound = pictures(rw.simulate(runs.hanging(duration=0.2)))
    assert not any(map(orange, sound))


def test_the_folder_keeps_it_and_tells_of_damage(broken: Result, tmp_path: Path) -> None:
    ran = rw.run(runs.breaking(), tmp_path / "run", on_failure="return")
    saved = broken.save(tmp_path / "saved")
    for result in (ran, saved):
        assert result.beyond is not None
        assert broken.beyond is not None
        np.testing.assert_array_equal(result.beyond.positions, broken.beyond.positions)
        np.testing.assert_array_equal(result.beyond.tension, broken.beyond.tension)
    path = tmp_path / "run" / "beyond.npz"
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)
    with pytest.raises(rw.RunError, match="beyond.npz"):
        _ = rw.Result.open(tmp_path / "run").beyond


def test_a_run_recorded_into_its_break_tells_of_the_frames_before(
    broken: Result, into_it: Result
) -> None:
    assert into_it.frames > into_it.good_frames == broken.frames
    for name in ("largest tension [N]", "final kinetic energy [J]", "largest energy error [J]"):
        assert into_it.table[name] == broken.table[name]
    assert into_it.table["frames before the break"] == broken.frames
    for result in (broken, into_it):
        assert "the burst grows" in result.table["about these numbers"]
    sound = rw.simulate(runs.breaking().replace(**{"run.time_step": "auto", "run.duration": 0.1}))
    assert "about these numbers" not in sound.table
    for name, value, _ in results_rows(into_it.table):
        assert "e+" not in value, name
        assert "nan" not in value, name


def test_the_message_says_how_to_see_more(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(dumps(runs.breaking()))
    run = tmp_path / "run"
    done = CliRunner().invoke(main, ["run", str(tmp_path / "scene.toml"), "-o", str(run)])
    assert done.exit_code == 3
    assert f"ropewalk plot {run} shape film" in done.stderr
    assert "--keep-going" in done.stderr
    drawn = CliRunner().invoke(main, ["plot", str(run), "shape", "film"])
    assert drawn.exit_code == 0, drawn.output
    with pytest.raises(rw.BrokenRun, match="plot.shape"):
        rw.simulate(runs.breaking())


def test_a_soft_rope_that_hangs_at_many_times_its_length_is_whole() -> None:
    """At rest the top segment is stretched twenty times; nothing broke, and every frame counts."""
    soft = rw.Springs(
        spring_constant=10.0, node_mass=0.05, segment_length=0.05, spring_friction=0.5
    )
    scene = rw.Scene(
        ropes=[rw.Rope(segments=20, made_of=soft)],
        anchors=[rw.Anchor(node=0)],
        run=rw.RunSettings(duration=2.0, method="semi-implicit-euler"),
    )
    result = rw.simulate(scene)
    longest = np.linalg.norm(np.diff(result.positions, axis=1), axis=2).max()
    assert longest > 10 * 0.05
    assert result.status == "finished"
    assert result.good_frames == result.frames


def test_frames_of_a_soft_rope_are_sound_up_to_its_break() -> None:
    """It hangs at twenty times its length until it is torn; all frames beyond ten times counted as broken."""
    soft = rw.Springs(spring_constant=2.0, node_mass=0.05, segment_length=0.05, spring_friction=0.5)
    pulled = Velocity(velocity=(0.0, 0.0, -40.0))
    scene = rw.Scene(
        ropes=[rw.Rope(segments=4, made_of=soft)],
        anchors=[rw.Anchor(node=0), rw.Anchor(node=-1, motion=pulled)],
        run=rw.RunSettings(duration=2.0, method="semi-implicit-euler", time_step=1e-3),
    )
    result = rw.simulate(scene, on_failure="return")
    assert result.status == "broke"
    longest = np.linalg.norm(np.diff(result.positions, axis=1), axis=2).max()
    assert longest > 20 * 0.05
    assert result.good_frames == result.frames
    assert result.broke_at == result.time[-1]


def test_a_request_to_stop_leaves_the_frames_before_a_break_whole() -> None:
    """Asked once the break was found: the state still comes to the last frame that is returned."""
    plain, asked = rw.Simulation(runs.breaking()), rw.Simulation(runs.breaking())
    whole = plain.advance_frames(plain.plan.frames)
    went_back: list[float] = []
    asked.slices.most = 1  # a slice a step, so that it would be heard at once
    asked.slices.note = lambda steps, seconds: None  # type: ignore[method-assign]
    restore = asked.restore
    asked.restore = lambda state: (went_back.append(asked.time), restore(state))  # type: ignore
    asked.slices.asked = lambda: bool(went_back)
    again = asked.advance_frames(plain.plan.frames)
    assert went_back
    assert again.frames == whole.frames > 1
    assert asked.time == plain.time
    np.testing.assert_array_equal(asked.positions, plain.positions)
