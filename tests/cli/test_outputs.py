"""What is made of runs: figures, movies, comparisons, tables, the demo, the report."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from cli.test_bad_input import refused, tree
from ropewalk import Result
from ropewalk.cli import main
from ropewalk.cli.commands.export import FORMATS
from ropewalk.plots import PLOTS
from ropewalk.record import export as exporting


@pytest.fixture
def run(ropewalk: Any, scene: Path) -> Path:
    """A run folder, in the present folder."""
    assert ropewalk("run", scene, "-o", "a").exit_code == 0
    return Path("a")


def test_plot_draws_what_is_asked_for(ropewalk: Any, run: Path) -> None:
    done = ropewalk(
        "plot", run, "shape", "height", "--node", "-1", "--node", "rope:3", "--time", 0.2
    )
    assert done.exit_code == 0, done.output
    assert done.stdout.splitlines() == ["a/figures/shape.png", "a/figures/height.png"]
    for path in done.stdout.splitlines():
        assert min(Image.open(path).size) > 200
    done = ropewalk("plot", run, "energy", "-o", "figures", "--format", "svg,pdf")
    assert tree(Path("figures")) == ["energy.pdf", "energy.svg"]
    assert ropewalk("plot", run, "phase", "-o", "one/phase.svg").exit_code == 0
    assert Path("one/phase.svg").read_text().startswith("<?xml")


def test_plot_draws_everything_without_a_kind(ropewalk: Any, run: Path) -> None:
    assert ropewalk("plot", run).exit_code == 0
    there = [kind for kind in PLOTS if kind not in ("contact", "sticking")]  # nothing touches
    assert tree(run / "figures") == sorted(f"{kind}.png" for kind in there)
    assert ropewalk("plot", run, "shape").exit_code == 0  # again, in the run's own folder


def test_the_help_of_plot_names_every_figure() -> None:
    page = main.commands["plot"].help or ""
    for kind in PLOTS:
        assert f"\n      {kind} " in page


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("shpe",), 'KIND: "shpe" - there is no such figure; did you mean "shape"?'),
        (("--format", "bmp"), '--format: "bmp" - must be one or more of png, svg, pdf'),
        (("height", "--node", "7"), "--node 7: rope 'rope' has the nodes 0 to 6, not 7"),
        (("height", "--node", "x"), "--node x: must be a node's number, or ROPE:NODE"),
        (("height", "--node", "rpe:1"), "--node rpe:1: there is no rope 'rpe'; there is rope"),
        (("shape", "--time", "9"), "9"),
        (("film", "--time", "nan"), "--time nan: must be from 0 to 0.5 s"),
        (("energy", "--node", "1"), "--node: energy takes none; leave it out"),
        (("shape", "energy", "-o", "x.png"), "x.png: is one file, and these are 2 figures"),
        (("shape", "-o", "scene.toml/x.png"), "scene.toml is a file, not a folder"),
        (("shape", "-o", "there.png"), "there.png: exists already"),
    ],
)
def test_plots_that_cannot_be_drawn(
    ropewalk: Any, run: Path, arguments: tuple[str, ...], said: str
) -> None:
    Path("there.png").write_text("mine")
    before = tree(Path.cwd())
    refused(ropewalk("plot", run, *arguments), said)
    assert tree(Path.cwd()) == before
    assert Path("there.png").read_text() == "mine"


def test_movie(ropewalk: Any, run: Path) -> None:
    done = ropewalk("movie", run, "--fps", "10")
    assert done.stdout == "a/movie.gif\n"
    assert getattr(Image.open("a/movie.gif"), "n_frames", 0) >= 4
    refused(ropewalk("movie", run, "-o", "a.avi"), "a.avi: must end in .gif or .mp4")
    refused(ropewalk("movie", run, "--speed", "0"), "--speed: 0.0 - must be positive")
    refused(ropewalk("movie", run, "--speed", "nan"), "--speed: nan - must be positive")
    refused(ropewalk("movie", run, "-o", "scene.toml"), "scene.toml: must end in")
    Path("b.gif").write_text("mine")
    refused(ropewalk("movie", run, "-o", "b.gif"), "b.gif: exists already")


def test_an_mp4_without_ffmpeg(ropewalk: Any, run: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.which", lambda *_: None)
    refused(ropewalk("movie", run, "-o", "b.mp4"), "b.mp4: an MP4 needs the program ffmpeg", ".gif")
    assert not Path("b.mp4").exists()


def test_export_to_every_format(ropewalk: Any, run: Path) -> None:
    assert FORMATS == exporting.FORMATS
    made = {name: ropewalk("export", run, "--to", name).stdout.splitlines() for name in FORMATS}
    assert made["npz"] == ["a/run.npz"]
    assert made["vtk"] == ["a/vtk/rope.pvd"]
    assert "a/csv/nodes.csv" in made["csv"]
    assert len(made["parquet"]) == len(made["csv"]) == 4
    for paths in made.values():
        assert all(Path(path).stat().st_size > 0 for path in paths)


def test_export_takes_what_is_asked_for(ropewalk: Any, run: Path) -> None:
    flags = ("--quantity", "positions", "--node", "-1", "--every", "10", "-o", "end.csv")
    assert ropewalk("export", run, "--to", "csv", *flags).exit_code == 0
    with open("end.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    result = Result.open(run)
    assert [int(row["node"]) for row in rows] == [6] * 4
    assert np.array_equal([float(row["z [m]"]) for row in rows], result.positions[::10, -1, 2])
    wide = ("--quantity", "tension", "--time", "0.25", "--wide", "-o", "w.csv")
    assert ropewalk("export", run, "--to", "csv", *wide).exit_code == 0
    assert len(Path("w.csv").read_text().splitlines()) == 2


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "--to"),
        (("--to", "xls"), "xls"),
        (("--to", "csv", "--quantity", "pos"), "--quantity pos: no such quantity"),
        (("--to", "csv", "--node", "9"), "--node 9: rope 'rope' has the nodes 0 to 6, not 9"),
        (("--to", "csv", "--node", "x"), "--node x: must be a node's number"),
        (("--to", "csv", "--node", "other:1"), "--node other: no such rope"),
        (("--to", "csv", "--time", "9"), "--time 9.0: must be from 0 to 0.5 s"),
        (("--to", "csv", "--time", "nan"), "--time nan: must be"),
        (("--to", "csv", "--every", "0"), "--every 0: must be at least 1"),
        (("--to", "csv", "-o", "scene.toml/x"), "scene.toml"),
        (("--to", "csv", "-o", "x.csv"), "x.csv: holds one table"),
        (("--to", "npz", "-o", "a"), "a: is a folder; npz makes one file: name it, as a/run.npz"),
        (
            ("--to", "npz", "-o", "there.npz"),
            "there.npz: exists; choose another name, or give --over",
        ),
    ],
)
def test_exports_that_cannot_be_made(
    ropewalk: Any, run: Path, arguments: tuple[str, ...], said: str
) -> None:
    Path("there.npz").write_text("mine")
    before = tree(Path.cwd())
    refused(ropewalk("export", run, *arguments), said)
    assert tree(Path.cwd()) == before


@pytest.mark.parametrize(
    "arguments",
    [
        ("run", "scene.toml", "-o", "b/c/run"),
        ("settle", "scene.toml", "-o", "b/c/rest"),
        ("modes", "scene.toml", "-o", "b/c/modes.svg"),
        ("new", "r4", "-o", "b/c/scene.toml"),
        ("schema", "-o", "b/c/schema.json"),
        ("plot", "a", "shape", "-o", "b/c/shape.svg"),
        ("movie", "a", "--fps", "4", "-o", "b/c/movie.gif"),
        ("share", "a", "-o", "b/c/page.html"),
        ("export", "a", "--to", "csv", "-o", "b/c/tables"),
        ("export", "a", "--to", "npz", "-o", "b/c/run.npz"),
        ("export", "a", "--to", "vtk", "-o", "b/c/vtk"),
        ("compare", "a", "a", "-o", "b/c/compare.svg"),
    ],
    ids=" ".join,
)
def test_missing_folders_are_made(ropewalk: Any, run: Path, arguments: tuple[str, ...]) -> None:
    done = ropewalk(*arguments)
    assert done.exit_code == 0, done.output
    assert Path(arguments[-1]).exists()


def test_compare_run_folders_and_scenes(ropewalk: Any, run: Path, scene: Path) -> None:
    done = ropewalk("compare", run, scene, "--method", "rk4", "-o", "c.svg")
    assert done.exit_code == 0, done.output
    for text in ("semi-implicit-euler", "rk4", "run.method", "largest distance", "figure: c.svg"):
        assert text in done.stdout
    assert Path("c.svg").read_text().startswith("<?xml")
    found = json.loads(ropewalk("compare", run, run, "--json").stdout)
    assert found["figure"] == "compare-a-a.png"
    assert found["runs"][1]["largest distance [m]"] == 0.0
    assert ropewalk("compare", run, run).stdout.endswith("figure: compare-a-a-2.png\n")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("a",), "a: is one run; name two or more"),
        (("a", "b"), "b: no such file, and no preset of that name"),
        (("a", "a", "-o", "x.gif"), "x.gif: must end in .png, .svg or .pdf"),
        (("a", "a", "--time", "9"), "--time: "),
        (("a", "."), "is no run folder"),
        (("a", "scene.toml", "--method", "rk5"), 'run.method: "rk5"'),
    ],
)
def test_comparisons_that_cannot_be_made(
    ropewalk: Any, run: Path, arguments: tuple[str, ...], said: str
) -> None:
    before = tree(Path.cwd())
    refused(ropewalk("compare", *arguments), said)
    assert tree(Path.cwd()) == before


def test_the_demo(ropewalk: Any) -> None:
    done = ropewalk("demo")
    assert done.exit_code == 0, done.output
    for text in (
        "largest tension",
        "106.62 N",
        "runs/demo-1/figures",
        "nodes.csv",
        "ropewalk run r4",
    ):
        assert text in done.stdout
    assert len(list(Path("runs/demo-1/figures").glob("*.png"))) == 5
    assert Result.open(Path("runs/demo-1")).status == "finished"
    assert "runs/demo-2" in ropewalk("demo").stdout
    refused(ropewalk("demo", "-o", "runs/demo-1"), "holds a run already")


def test_reports_that_cannot_be_written(ropewalk: Any, scene: Path) -> None:
    refused(ropewalk("report", "-o", "scene.toml/report"), "scene.toml is a file, not a folder")
    refused(ropewalk("report", "-o", "."), "is not empty; take another folder")
    assert tree(Path.cwd()) == ["scene.toml"]


@pytest.mark.parametrize(
    "flags", [("--set", "rope.segments=3"), ("--method", "rk4"), ("--duration", "1")]
)
def test_compare_refuses_changes_of_what_is_not_run(
    ropewalk: Any, run: Path, flags: tuple[str, str]
) -> None:
    done = ropewalk("compare", run, run, *flags)
    refused(done, "--set and its like change scenes that are run; these are all runs already")


def test_compare_keeps_what_it_runs_when_asked(ropewalk: Any, run: Path, scene: Path) -> None:
    """With -o and a folder: a run folder for each scene, and the figure; nothing for a run that is
    there. A second call is refused before anything is run, or replaces with --overwrite.
    """
    arguments = ("compare", run, scene, "r1", "--duration", "0.1", "-o", "study")
    done = ropewalk(*arguments, "--json")
    assert done.exit_code == 0, done.output
    found = json.loads(done.stdout)
    assert found["folders"] == ["a", "study/scene", "study/r1"]
    assert found["figure"] == "study/compare.png"
    assert {path.name for path in Path("study").iterdir()} == {"scene", "r1", "compare.png"}
    assert Result.open("study/r1").status == "finished"
    assert Result.open("study/scene").time[-1] == pytest.approx(0.1)
    before = tree(Path.cwd())
    refused(ropewalk(*arguments), "study/compare.png: exists already")
    Path("study/compare.png").unlink()
    refused(ropewalk(*arguments), "study/scene: holds a run already")
    assert ropewalk(*arguments, "--overwrite").exit_code == 0
    assert set(tree(Path.cwd())) == set(before)


def test_compare_keeps_scenes_whose_names_are_alike_apart(
    ropewalk: Any, scene: Path, tmp_path: Path
) -> None:
    """With --overwrite the second one went into the folder of the first, and was compared with itself."""
    (tmp_path / "in").mkdir()
    text = scene.read_text().replace("duration = 0.5", "duration = 0.02")
    for name, k in (("a b.toml", 500.0), ("a-b.toml", 400.0), ("in/a-b.toml", 300.0)):
        (tmp_path / name).write_text(text.replace("500.0", f"{k}"))
    names = ("a b.toml", "a-b.toml", "in/a-b.toml")
    for _ in range(2):
        done = ropewalk("compare", *names, "-o", "study", "--overwrite", "--json")
        assert done.exit_code == 0, done.output
        folders = json.loads(done.stdout)["folders"]
        assert folders == ["study/a-b", "study/a-b-2", "study/in-a-b"]
        made = [Result.open(folder).scene.ropes[0].made_of for folder in folders]
        assert [one.spring_constant for one in made] == [500.0, 400.0, 300.0]
