"""What a result can be made into: datasets and tables that stay small, files, films, a replay."""

from __future__ import annotations

import html
import re
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import ropewalk as rw
import runs
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.record.errors import InputError, RunError
from ropewalk.record.export import export
from ropewalk.record.result import Result
from ropewalk.scene import Plane, Straight

DIMENSIONS = {
    "nodes": {"time", "node", "axis"},
    "segments": {"time", "segment"},
    "anchors": {"time", "anchor", "axis"},
    "run": {"time"},
}


@pytest.fixture(scope="module")
def result() -> Result:
    return rw.simulate(runs.winched(duration=0.2))


@pytest.fixture(scope="module")
def opened(result: Result, tmp_path_factory: pytest.TempPathFactory) -> Result:
    folder = tmp_path_factory.mktemp("runs") / "run"
    result.save(folder)
    return rw.open(folder)


@pytest.mark.parametrize("name", DIMENSIONS)
def test_datasets_share_no_foreign_dimensions(result: Result, name: str) -> None:
    data = result.datasets[name]
    assert set(data.sizes) == DIMENSIONS[name]
    table = data.to_dataframe()
    assert len(table) == max(variable.size for variable in data.data_vars.values())
    assert all("units" in variable.attrs for variable in data.data_vars.values())


def test_every_quantity_is_in_one_of_the_datasets(result: Result) -> None:
    inside = [name for part in ("nodes", "segments", "anchors") for name in result.datasets[part]]
    columns = {"extremes", "extreme_places", "extreme_since", "extreme_until"}
    columns |= {"energy_errors", "energy_error_times"}
    whole = {"energy", "work", "jump", "momentum", "angular_momentum"} | columns
    assert set(inside) | whole >= set(result.source.names) - {
        name for name in result.datasets["run"] if name in result.source.names
    }
    run = result.datasets["run"]
    np.testing.assert_array_equal(run["total_energy"], result.energy["total"])
    np.testing.assert_array_equal(run["work_of_weight"], result.work["weight"])
    assert run["momentum_x"].attrs["units"] == "kg m/s"


def test_extremes_have_each_its_own_unit(result: Result) -> None:
    """All of them had those of all: "N, N, 1, m/s, m"."""
    run = result.datasets["run"]
    assert run["greatest_tension"].attrs["units"] == "N"
    assert run["greatest_speed"].attrs["units"] == "m/s"
    assert run["time_until_which_came_greatest_speed"].attrs["units"] == "s"
    assert run["jump_limiter"].attrs == {"units": "J", "long_name": "jump limiter"}
    assert run["time"].attrs["units"] == "s"


def test_works_of_contacts_count_from_the_start_everywhere(tmp_path: Path) -> None:
    """What was stored at the start stood in datasets and archives, and neither in tables nor in Python."""
    springs = rw.Springs(spring_constant=1e3, node_mass=0.1, segment_length=0.1)
    rope = rw.Rope(
        segments=3, diameter=0.01, made_of=springs, shape=Straight(start=(0, 0, 0.00499))
    )
    settings = rw.RunSettings(duration=0.05, time_step=1e-3, method="semi-implicit-euler")
    scene = rw.Scene(ropes=[rope], obstacles=[Plane(name="floor")], run=settings)
    result = rw.simulate(scene)
    stored = list(result.read("contact_work")[0, 0])
    assert stored[ENTRIES.index("stored")] != 0.0
    told = np.stack([result.contact_work["floor"][entry] for entry in ENTRIES], axis=1)
    assert not told[0].any()
    assert told[-1].any()
    (path,) = result.export("npz", tmp_path / "run.npz", quantities=["contact_work"], every=2)
    np.testing.assert_array_equal(np.load(path)["contact_work"][:, 0], told[::2])
    for one in (result, result.save(tmp_path / "run")):
        np.testing.assert_array_equal(one.dataset["contact_work"][:, 0], told)
        assert one.dataset["contact_work"].attrs["units"] == "J"


def test_one_table_of_everything_is_refused(result: Result, opened: Result) -> None:
    for one in (result, opened):
        with pytest.raises(InputError, match="different dimensions.*to_pandas"):
            one.dataset.to_dataframe()
        with pytest.raises(InputError):
            one.dataset[["positions", "tension"]].to_dataframe()
        segments = one.dataset[["tension", "rest_length"]].to_dataframe()
        assert len(segments) == result.tension.size


def test_a_run_folders_datasets_are_those_of_memory(result: Result, opened: Result) -> None:
    for name, data in result.datasets.items():
        other = opened.datasets[name]
        assert set(other.data_vars) == set(data.data_vars)
        for variable in data.data_vars:
            np.testing.assert_array_equal(other[variable], data[variable])


@pytest.mark.parametrize("name", DIMENSIONS)
def test_pandas_tables_are_the_exported_ones(result: Result, tmp_path: Path, name: str) -> None:
    table = result.to_pandas(name, every=3, rope="line")  # type: ignore[arg-type]
    quantities = [*result.source.names]
    quantities.remove("jump")
    files = export(result, "csv", tmp_path, quantities=quantities, every=3, rope="line")
    written = pd.read_csv(next(path for path in files if path.stem == name))
    assert list(table) == list(written)
    pd.testing.assert_frame_equal(table, written, check_dtype=False, rtol=0.0, atol=0.0)


def test_a_table_that_is_not_there(result: Result) -> None:
    with pytest.raises(InputError, match='did you mean "segments"'):
        result.to_pandas("segmets")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="nodes"):
        result.to_pandas("nodes", nodes=[99])
    free = rw.simulate(runs.hanging(duration=0.1).replace(anchors=()))
    with pytest.raises(InputError, match="this run has none; there is nodes, segments, run"):
        free.to_pandas("anchors")


def test_results_write_themselves(result: Result, tmp_path: Path) -> None:
    (file,) = result.export("npz", tmp_path / "run.npz")
    np.testing.assert_array_equal(np.load(file)["positions"], result.positions)
    film = result.movie(tmp_path / "run.gif", fps=10.0, size=(320, 200))
    assert film.read_bytes()[:6] == b"GIF89a"


def test_open_refuses_what_is_no_run(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="no-such-run"):
        rw.open(tmp_path / "no-such-run")


def test_a_replay_is_the_page_to_share_inside_a_frame(result: Result, tmp_path: Path) -> None:
    replay = result.replay(frame_rate=10.0, height=300)
    shared = result.share(tmp_path / "page.html", frame_rate=10.0).read_text("utf-8")
    assert replay.page == shared
    shown = replay._repr_html_()
    inside = re.fullmatch(r'<iframe srcdoc="([^"]*)" ([^>]*)></iframe>', shown)
    assert inside is not None
    assert html.unescape(inside[1]) == shared
    assert 'sandbox="allow-scripts"' in inside[2]  # and no way to the notebook around it
    assert 'height="300"' in inside[2]
    with pytest.raises(ValueError, match="at least 100 pixels"):
        result.replay(height=5)


def test_a_name_does_not_get_out_of_the_frame() -> None:
    name = '"></iframe><script>alert(1)</script>'
    scene = runs.hanging(duration=0.1).replace(name=name)
    shown = rw.simulate(scene).replay()._repr_html_()
    assert shown.count("<") == 2  # the frame and its end


def _pictures(shown: str) -> int:
    return len(re.findall(r"<img alt='[^']+' src='data:image/png;base64,[\w+/=]+'>", shown))


def test_checks_and_modes_draw_themselves() -> None:
    scene = rw.preset("hanging-rope").replace(name="<b>rope</b>")
    check, modes = rw.check(scene, measure=False), rw.modes(scene, count=3)
    for one in (check, modes):
        shown = one._repr_html_()
        assert _pictures(shown) == 1
        assert "&lt;b&gt;rope&lt;/b&gt;" in shown
        assert "<b>" not in shown
    assert html.escape(str(check)) in check._repr_html_()
    assert f"<td>{modes.frequencies[2]:.6g}</td>" in modes._repr_html_()


def test_a_check_of_what_has_no_rest_shape_has_no_picture() -> None:
    falling = runs.hanging(duration=0.1).replace(anchors=())
    shown = rw.check(falling, measure=False)._repr_html_()
    assert _pictures(shown) == 0
    assert "nothing holds it" in shown
