"""Python's own tools see the package: mypy finds a user's mistakes, editors complete names."""

from __future__ import annotations

import inspect
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import jedi
import pytest

import ropewalk as rw
from ropewalk import plots
from ropewalk.record.drawing import Plots
from ropewalk.vibration.drawing import ModePlots

ROOT = Path(__file__).resolve().parents[2]
# A user's script; a line with a mistake ends with words of the message that mypy must give there.
SCRIPT = '''
from typing import TYPE_CHECKING, assert_type

import numpy as np

import ropewalk as rw
from ropewalk.scene import Slack

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

line = rw.Material(EA=9810.0, mass_per_length=0.063, axial_damping=20.0)
rope = rw.Rope(segments=48, length=12.0, made_of=line, shape=Slack(end=(8.0, 0.0, 1.0)))
scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0), rw.Anchor(node=-1)])
result = rw.simulate(scene)
sim = rw.Simulation(scene)
assert_type(result, rw.Result)
assert_type(rw.open("runs/first"), rw.Result)
assert_type(rw.preset("r4").replace(name="other"), rw.Scene)
assert_type(rw.modes(scene, "start"), rw.Modes)
assert_type(result.frames, int)
assert_type(rw.check(scene).seconds, float)
result.tension + np.ones(3)
figure: "Figure" = result.plot.shape(times=[0.0, 1.0])
table: "pd.DataFrame" = result.to_pandas("segments")
data: "xr.Dataset" = result.datasets["nodes"]
sim.anchors["left"].velocity = (0.0, 1.0, 0.0)
sim.step(1 / 60)
drum = rw.Cylinder(start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05, spin=rw.Spin(rate=2.0))
assert_type(drum, rw.Cylinder)
rw.Scene(ropes=[rope], obstacles=[drum, rw.Plane()], contact=rw.Contact(friction=0.3))
assert_type(rw.rope("dynamic-single-9.8").cut(12.0, segments=48), rw.Rope)
assert_type(rw.rope("wire-7x19-6").material(guesses=True), rw.Material)
assert_type(rw.Material.from_fall("8.8 kN", "32 %", 0.061), rw.Material)
assert_type(rw.line("300 m", 0.0, "wire-7x19-12", sag="2 %").rolling("80 kg"), rw.Rolling)

rw.Material(EA=1e4)  # Missing named argument "mass_per_length"
rw.Springs(spring_constant=1e4, node_mas=0.1, segment_length=0.1)  # Unexpected keyword argument "node_mas"
rw.Anchor(node="first")  # incompatible type "str"; expected "int"
rw.Load(mass=1.0)  # Missing named argument "node"
rw.Rope(segments=3, made_of=line, lenght=3.0)  # Unexpected keyword argument "lenght"
rw.simulate(scene, keep_goin=True)  # Unexpected keyword argument "keep_goin"
rw.simulate(17)  # incompatible type "int"
rw.run(scene)  # Missing positional argument "folder"
rw.chek(scene)  # Module has no attribute "chek"
rw.modes(scene, about="rest")  # incompatible type "Literal['rest']"
result.tensions  # "Result" has no attribute "tensions"
result.energy["total"].summ()  # has no attribute "summ"
result.plot.shap()  # "Plots" has no attribute "shap"
result.plot.shape(times="all")  # incompatible type "str"
result.to_pandas("segment")  # incompatible type "Literal['segment']"
result.view(prot=80)  # Unexpected keyword argument "prot"
text: str = result.frames  # expression has type "int"
scene.gravity = (0.0, 0.0, 0.0)  # read-only
sim.stepp()  # "Simulation" has no attribute "stepp"
sim.anchors["left"].velocty  # "AnchorHandle" has no attribute "velocty"
rw.rope("x").material(use="wet")  # incompatible type "Literal['wet']"
rw.line(300.0, 0.0, "x", sagg=2.0)  # Unexpected keyword argument "sagg"
rw.modes(scene).plot.mode_shape()  # "ModePlots" has no attribute "mode_shape"
'''  # fmt: skip


@pytest.mark.slow
def test_mypy_finds_a_users_mistakes_and_no_others(tmp_path: Path) -> None:
    path = tmp_path / "script.py"
    path.write_text(SCRIPT)
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--no-error-summary", str(path)],
        cwd=ROOT,  # with this project's settings, whose cache `make lint` has filled
        capture_output=True,
        text=True,
        check=False,
    )
    found: dict[int, str] = {}
    for line in done.stdout.splitlines():
        if seen := re.search(r"script\.py:(\d+): error: (.*)", line):
            found[int(seen[1])] = found.get(int(seen[1]), "") + seen[2]
    wanted = {
        number: line.partition("  # ")[2]
        for number, line in enumerate(SCRIPT.splitlines(), start=1)
        if "  # " in line
    }
    assert set(found) == set(wanted), done.stdout + done.stderr
    for number, words in wanted.items():
        assert words in found[number]


def completions(source: str) -> set[str]:
    """Return the names that an editor offers at the end of a source."""
    project = jedi.Project(ROOT, added_sys_path=[str(ROOT / "src")])
    code = "import ropewalk as rw\n" + textwrap.dedent(source)
    return {found.name for found in jedi.Script(code, project=project).complete()}


@pytest.mark.parametrize(
    ("source", "names"),
    [
        ("rw.", set(rw.__all__) | {"open"}),
        ("rw.simulate('r4').", {"tension", "positions", "plot", "to_pandas", "replay", "energy"}),
        ("rw.open('x').plot.", set(plots.PLOTS)),
        ("sim = rw.Simulation(rw.preset('r4'))\nsim.", {"step", "anchors", "positions", "restore"}),
        ("rw.modes('r4').plot.", {"mode_shapes"}),
        (
            "rw.rope('dynamic-single').",
            {"EA", "EA_static", "numbers", "material", "cut", "guesses"},
        ),
        ("rw.line(9.0, 0.0, 'x', sag=1.0).", {"sag", "tensions", "rolling", "scene"}),
        ("rw.check('r4').", {"warnings", "stability", "seconds", "ok"}),
        ("rw.preset('r4').", {"ropes", "anchors", "replace", "gravity"}),
    ],
)
def test_editors_complete(source: str, names: set[str]) -> None:
    assert names - completions(source) == set()


def test_nothing_is_completed_where_nothing_is_known() -> None:
    assert completions("rw.no_such_name.") == set()


def _static_names() -> dict[str, str]:
    """Return the names that type checkers see, and the modules they are from."""
    text = (ROOT / "src/ropewalk/__init__.py").read_text(encoding="utf-8")
    found = re.findall(r"^    from ropewalk\.(\S+) import (\w+) as (\w+)", text, re.MULTILINE)
    assert all(name == shown for _, name, shown in found)
    return {name: home for home, name, _ in found}


def test_type_checkers_and_the_program_see_the_same_names() -> None:
    assert _static_names() == rw._HOMES  # type: ignore[attr-defined]
    assert set(dir(rw)) == {*rw._HOMES, "__version__"}  # type: ignore[attr-defined]


def test_a_star_import_leaves_pythons_open_alone() -> None:
    names: dict[str, object] = {}
    exec("from ropewalk import *", names)
    assert "simulate" in names
    assert "open" not in names
    assert rw.open is not open


@pytest.mark.parametrize("name", sorted(plots.PLOTS))
def test_figures_of_a_result_have_the_signatures_of_the_drawing_functions(name: str) -> None:
    assert _rest(getattr(Plots, name)) == _rest(plots.PLOTS[name].draw)
    assert set(plots.PLOTS) == set(dir(Plots(None)))  # type: ignore[arg-type]


def test_movies_and_modes_have_the_signatures_of_the_drawing_functions() -> None:
    assert _rest(rw.Result.movie) == _rest(plots.movie)
    assert _rest(ModePlots.mode_shapes) == _rest(plots.mode_shapes)


def _rest(function: object) -> list[inspect.Parameter]:
    """Return a function's parameters but the first."""
    return list(inspect.signature(function).parameters.values())[1:]  # type: ignore[arg-type]
