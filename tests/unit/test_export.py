"""Tables, archives and VTK of results, read back by other programs."""

from __future__ import annotations

import os
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import ropewalk as rw
import runs
from ropewalk.record.errors import InputError, RunError
from ropewalk.record.export import export
from ropewalk.record.quantities import joined
from ropewalk.record.result import Result


@pytest.fixture(scope="module")
def result() -> Result:
    return rw.simulate(runs.winched())


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("runs") / "run"
    rw.run(runs.winched(), path)
    return path


def test_long_tables(result: Result, tmp_path: Path) -> None:
    files = export(result, "csv", tmp_path)
    assert [path.name for path in files] == ["nodes.csv", "segments.csv", "anchors.csv", "run.csv"]
    nodes = pd.read_csv(files[0])
    assert list(nodes)[:6] == ["time [s]", "rope", "node", "x [m]", "y [m]", "z [m]"]
    heights = ["least height [m]", "greatest height [m]"]
    assert list(nodes)[6:] == ["vx [m/s]", "vy [m/s]", "vz [m/s]", "greatest speed [m/s]", *heights]
    end = nodes[(nodes["rope"] == "line") & (nodes["node"] == 8)]
    series = result.node(8, "line")
    np.testing.assert_array_equal(end["time [s]"], result.time)
    np.testing.assert_array_equal(end[["x [m]", "y [m]", "z [m]"]], series["position"])
    np.testing.assert_array_equal(end[["vx [m/s]", "vy [m/s]", "vz [m/s]"]], series["velocity"])
    segments = pd.read_csv(files[1])
    free = segments[segments["rope"] == "free"]["tension [N]"].to_numpy()
    np.testing.assert_array_equal(free, result.rope("free").tension.ravel())
    anchors = pd.read_csv(files[2])
    np.testing.assert_array_equal(anchors[["fx [N]", "fy [N]", "fz [N]"]], result.reactions[:, 0])
    run = pd.read_csv(files[3])
    np.testing.assert_array_equal(run["total energy [J]"], result.energy["total"])
    np.testing.assert_array_equal(run["work of anchor:drum [J]"], result.work["anchor:drum"])
    np.testing.assert_array_equal(run["energy error [J]"], result.energy_error)


def test_a_wide_table_of_some_nodes_and_times(result: Result, tmp_path: Path) -> None:
    out = tmp_path / "table.csv"
    export(
        result, "csv", out, quantities=["positions"], nodes=[0, -1], times=[1.0, 0.5],
        rope="free", layout="wide",
    )  # fmt: skip
    table = pd.read_csv(out)
    assert list(table) == ["time [s]"] + [
        f"{axis} free[{node}] [m]" for node in (0, 5) for axis in "xyz"
    ]
    frames = [result.frame_at(0.5), result.frame_at(1.0)]
    np.testing.assert_array_equal(table["time [s]"], result.time[frames])
    np.testing.assert_array_equal(table["z free[5] [m]"], result.node(-1, "free")["height"][frames])


def test_a_zero_has_no_minus_in_text(result: Result, tmp_path: Path) -> None:
    """Forces across the plane of a rope are -0.0; all other numbers keep every bit."""
    result.reactions[result.reactions == 0.0] *= -1.0
    (path,) = export(result, "csv", tmp_path, quantities=["reactions"])
    rows = np.array([line.split(",")[2:] for line in path.read_text().splitlines()[1:]])
    reactions = result.reactions.reshape(-1, 3)
    assert np.signbit(reactions[reactions == 0.0]).any()
    assert "-0.0" not in rows
    numbers = rows.astype(float)
    assert numbers[reactions != 0.0].tobytes() == reactions[reactions != 0.0].tobytes()


@pytest.mark.parametrize("layout", ["long", "wide"])
def test_parquet_equals_csv(result: Result, tmp_path: Path, layout: str) -> None:
    tables = export(result, "csv", tmp_path, layout=layout, every=7)
    columns = export(result, "parquet", tmp_path, layout=layout, every=7)
    for one, other in zip(tables, columns, strict=True):
        left, right = pd.read_csv(one), pd.read_parquet(other)
        assert list(left) == list(right)
        for name in left:
            assert left[name].tolist() == right[name].tolist()


def test_npz_has_the_arrays(result: Result, tmp_path: Path) -> None:
    everything = ("positions", "velocities", "tension", "rest_length", "energy", "work")
    (path,) = export(
        result, "npz", tmp_path / "all", quantities=(*everything, "reactions", "momentum")
    )
    assert path.name == "all.npz"
    with np.load(path, allow_pickle=False) as archive:
        ropes = np.flatnonzero(archive["segment_rope"] == "free")
        for name in ("time", "positions", "velocities", "energy", "work", "reactions", "momentum"):
            np.testing.assert_array_equal(archive[name], result.read(name))
        np.testing.assert_array_equal(archive["tension"][:, ropes], result.rope("free").tension)
        assert archive["law"].tolist()[-1] == "anchor:drum"
        assert archive["node_number"][archive["node_rope"] == "free"].tolist() == list(range(6))


def test_pieces_do_not_change_the_files(
    result: Result, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for to in ("csv", "npz"):
        (tmp_path / to).mkdir()
        whole = export(result, to, tmp_path / to / "whole")
        monkeypatch.setattr("ropewalk.record.selection._VALUES", 200)
        pieces = export(Result.open(folder), to, tmp_path / to / "pieces")
        monkeypatch.undo()
        for one, other in zip(whole, pieces, strict=True):
            if to == "csv":
                assert one.read_bytes() == other.read_bytes()
                continue
            with np.load(one) as left, np.load(other) as right:
                assert left.files == right.files
                for name in left.files:
                    np.testing.assert_array_equal(left[name], right[name])


def test_vtk_is_read_by_vtk(result: Result, tmp_path: Path) -> None:
    io = pytest.importorskip("vtkmodules.vtkIOXML")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    (index,) = export(result, "vtk", tmp_path / "vtk", every=40)
    sets = ET.parse(index).getroot().findall("./Collection/DataSet")
    assert [float(item.attrib["timestep"]) for item in sets] == result.time[::40].tolist()
    for frame, item in zip(range(0, result.frames, 40), sets, strict=True):
        reader = io.vtkXMLPolyDataReader()
        reader.SetFileName(str(index.parent / item.attrib["file"]))
        reader.Update()
        data = reader.GetOutput()
        points = vtk_to_numpy(data.GetPoints().GetData())
        np.testing.assert_array_equal(points, result.positions[frame])
        live = result.live[frame]
        lines = vtk_to_numpy(data.GetLines().GetConnectivityArray()).reshape(-1, 2)
        np.testing.assert_array_equal(lines[:, 0], np.flatnonzero(live))
        np.testing.assert_array_equal(lines[:, 1], lines[:, 0] + 1)
        tension = vtk_to_numpy(data.GetCellData().GetArray("tension"))
        np.testing.assert_array_equal(tension, result.tension[frame][live])
        velocity = vtk_to_numpy(data.GetPointData().GetArray("velocity"))
        np.testing.assert_array_equal(velocity, result.velocities[frame])
        speed = vtk_to_numpy(data.GetPointData().GetArray("speed"))
        np.testing.assert_allclose(speed, np.linalg.norm(velocity, axis=1), rtol=1e-14)


def test_a_second_vtk_export_leaves_no_old_frames(result: Result, tmp_path: Path) -> None:
    export(result, "vtk", tmp_path / "vtk")
    with pytest.raises(RunError, match="overwrite"):
        export(result, "vtk", tmp_path / "vtk", every=60)
    export(result, "vtk", tmp_path / "vtk", every=60, overwrite=True)
    names = sorted(path.name for path in (tmp_path / "vtk" / "frames").iterdir())
    assert names == ["frame_000000.vtp", "frame_000060.vtp", "frame_000120.vtp"]
    (tmp_path / "vtk" / "frames" / "mine.txt").write_text("keep")
    with pytest.raises(RunError, match="other files"):
        export(result, "vtk", tmp_path / "vtk", overwrite=True)
    assert (tmp_path / "vtk" / "frames" / "mine.txt").read_text() == "keep"


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"to": "exel"}, "no such format"),
        ({"to": "parquett"}, 'did you mean "parquet"'),
        ({"quantities": ["tensoin"]}, 'did you mean "tension"'),
        ({"quantities": []}, "name one or more"),
        ({"nodes": [9]}, "has the nodes 0 to"),
        ({"nodes": []}, "name one or more nodes"),
        ({"rope": "lin"}, 'did you mean "line"'),
        ({"times": [99.0]}, "must be from 0 to 2 s"),
        ({"times": [float("nan")]}, "must be from 0 to 2 s"),
        ({"times": [1.0], "every": 2}, "cannot be combined"),
        ({"every": 0}, "at least 1"),
        ({"layout": "tall"}, "known: long, wide"),
        ({"out": "one.csv"}, "holds one table"),
    ],
)
def test_wrong_requests(
    result: Result, tmp_path: Path, changes: dict[str, object], said: str
) -> None:
    request = {"to": "csv", "out": "out"} | changes
    request["out"] = tmp_path / str(request["out"])
    with pytest.raises(InputError) as raised:
        export(result, **request)  # type: ignore[arg-type]
    assert said in str(raised.value)
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_replaced_unasked(result: Result, tmp_path: Path) -> None:
    (tmp_path / "run.csv").write_text("mine")
    with pytest.raises(RunError, match=r"run\.csv: exists"):
        export(result, "csv", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["run.csv"]
    export(result, "csv", tmp_path, overwrite=True)
    assert (tmp_path / "run.csv").read_text() != "mine"


def test_tables_of_a_former_export_do_not_stay(result: Result, tmp_path: Path) -> None:
    """`slides.csv` of a run that was there before lay beside the new nodes.csv, and was taken for its own."""
    saved = result.save(tmp_path / "run")
    own, far = tmp_path / "run" / "csv", tmp_path / "far"
    for folder in (own, far):
        folder.mkdir()
        for name in ("slides.csv", "slides.parquet", "notes.csv"):
            (folder / name).write_text("a\n")
            os.utime(folder / name, (1.0, 1.0))
        export(saved, "csv", folder, quantities=["positions"], overwrite=True)
        export(saved, "csv", folder, quantities=["tension"], overwrite=True)
    left = ["nodes.csv", "notes.csv", "segments.csv", "slides.parquet"]
    assert sorted(path.name for path in own.iterdir()) == left
    assert (far / "slides.csv").read_text() == "a\n"  # which may be anybody's


def test_a_rope_has_its_own_anchors_and_ties(tmp_path: Path) -> None:
    """`rope="a"` had the anchors and joints of all ropes."""
    shape = {"kind": "straight", "start": (0, 0, 0), "end": (1, 0, 0)}
    ropes = [
        rw.Rope(
            name=name, segments=2, length=1.0, shape=shape,
            made_of=rw.Material(EA=100.0, mass_per_length=0.1),
        )
        for name in "ab"
    ]  # fmt: skip
    scene = rw.Scene(
        ropes=ropes,
        anchors=[{"name": f"hold-{name}", "rope": name, "node": 0} for name in "ba"],
        joints=[{"points": [{"rope": "b", "node": 2}, {"rope": "a", "node": 2}]}],
        run={"duration": 0.02, "frame_rate": 50, "method": "semi-implicit-euler"},
    )
    result = rw.simulate(scene)
    anchors, joints = (result.to_pandas(name, rope="a") for name in ("anchors", "joints"))
    assert set(anchors["anchor"]) == {"hold-a"}
    np.testing.assert_array_equal(anchors["fz [N]"], result.reactions[:, 1, 2])
    assert set(joints["tie"]) == {"joint0:a[2]"}
    np.testing.assert_array_equal(joints["fz [N]"], result.joint_forces[:, 1, 2])
    (file,) = export(result, "npz", tmp_path / "a", rope="a")
    found = np.load(file)
    assert list(found["anchor"]) == ["hold-a"]
    np.testing.assert_array_equal(found["reactions"], result.reactions[:, [1]])
    np.testing.assert_array_equal(found["joint_forces"], result.joint_forces[:, [1]])
    assert set(result.to_pandas("anchors")["anchor"]) == {"hold-a", "hold-b"}


def test_a_full_disk_leaves_no_half_table(
    result: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from ropewalk.record.tables import Table

    def pieces(self: Table) -> object:
        yield [np.zeros(3)] * len(self.headers)
        raise OSError(28, "No space left on device")

    def broken(*args: object) -> list[Table]:
        table = Table("run", ["time [s]"], lambda: pieces(table))  # type: ignore[arg-type,return-value]
        return [table]

    monkeypatch.setattr("ropewalk.record.export.tables", broken)
    for to in ("csv", "parquet"):
        with pytest.raises(RunError, match="no space left on the disk"):
            export(result, to, tmp_path)
        assert list(tmp_path.iterdir()) == []


def test_parquet_without_pyarrow_says_what_to_install(
    result: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(RunError, match="pip install pandas pyarrow"):
        export(result, "parquet", tmp_path)
    assert list(tmp_path.iterdir()) == []


_WHEN = ("extreme_places", "extreme_since", "extreme_until", "energy_error_times")


@pytest.mark.parametrize("chosen", [{"every": 7}, {"every": 40}, {"times": [0.3, 1.9]}])
@pytest.mark.parametrize("values", [500_000, 200])
def test_greatest_and_least_are_since_the_row_before(
    result: Result,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    chosen: dict[str, object],
    values: int,
) -> None:
    """Frame by frame, by hand. Other quantities are those of the row's own frame."""
    monkeypatch.setattr("ropewalk.record.selection._VALUES", values)
    monkeypatch.setattr("ropewalk.record.skipped._VALUES", values)
    names = ("greatest_tension", "least_height", "tension", "extremes", "energy_errors", *_WHEN)
    (path,) = export(result, "npz", tmp_path / "all", quantities=names, **chosen)  # type: ignore
    frames = [0, *range(7, result.frames, 7)] if chosen == {"every": 7} else None
    if "times" in chosen:
        frames = [result.frame_at(0.3), result.frame_at(1.9)]
    frames = frames or [0, *range(40, result.frames, 40)]
    with np.load(path) as found:
        assert len(found["time"]) == len(frames)
        own = joined(result.layout)
        np.testing.assert_array_equal(found["tension"], result.tension[frames][:, own])
        first = 0
        for row, frame in enumerate(frames):
            here = slice(first, frame + 1)
            high = result.read("greatest_tension")[here].max(axis=0)[own]
            np.testing.assert_array_equal(found["greatest_tension"][row], high)
            low = result.read("least_height")[here].min(axis=0)
            np.testing.assert_array_equal(found["least_height"][row], low)
            best = first + int(np.argmax(result.read("extremes")[here, 0]))
            lowest = first + int(np.argmin(result.read("extremes")[here, 5]))
            for name in ("extremes", *_WHEN[:3]):
                assert found[name][row, 0] == result.read(name)[best, 0]
                assert found[name][row, 5] == result.read(name)[lowest, 5]
            least = first + int(np.argmin(result.read("energy_errors")[here, 0]))
            for name in ("energy_errors", _WHEN[3]):
                np.testing.assert_equal(found[name][row, 0], result.read(name)[least, 0])
            first = frame + 1


def test_no_table_loses_a_peak_between_its_rows(result: Result) -> None:
    """The twin: the frames of the rows alone miss it."""
    every = result.frames - 1
    header = "greatest tension [N]"
    whole = result.table["largest tension [N]"]
    assert result.to_pandas("segments", every=every)[header].max() == whole
    assert result.to_pandas("run", every=every)[header].max() == whole
    assert result.read("greatest_tension")[::every].max() < whole
    plain = result.to_pandas("run")
    assert plain[header].tolist() == result.read("extremes")[:, 0].tolist()


@pytest.mark.parametrize("to", ["csv", "parquet"])
def test_pieces_without_a_contact_change_no_table(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, to: str
) -> None:
    """A rope that falls onto the floor: no row before, and columns of no rows have no types."""
    falling = rw.Rope(
        segments=2, length=0.2, diameter=0.01,
        made_of=rw.Material(EA=1e3, mass_per_length=0.1, axial_damping=1.0),
        shape={"kind": "straight", "start": [0, 0, 0.1], "end": [0.2, 0, 0.1]},
    )  # fmt: skip
    run = {"duration": 0.25, "frame_rate": 40.0, "method": "semi-implicit-euler"}
    scene = rw.Scene(ropes=[falling], obstacles=[{"kind": "plane", "name": "floor"}], run=run)
    fall = rw.simulate(scene)
    whole = fall.to_pandas("contacts")
    monkeypatch.setattr("ropewalk.record.selection._VALUES", 1)
    pieces = fall.to_pandas("contacts")
    assert 0 < len(pieces) < 3 * fall.frames
    pd.testing.assert_frame_equal(pieces, whole)
    assert pieces["node"].dtype.kind == fall.datasets["contacts"]["node"].dtype.kind == "i"
    read = pd.read_csv if to == "csv" else pd.read_parquet
    for times, rows in ((None, len(whole)), ([0.0, 0.05], 0)):
        out = tmp_path / str(rows)
        files = export(fall, to, out, times=times)
        (contacts,) = [path for path in files if path.stem == "contacts"]
        assert len(read(contacts)) == rows
