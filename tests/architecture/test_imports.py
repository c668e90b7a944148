"""What importing loads, each in a fresh interpreter, and the layers between the packages."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import get_args

import pytest

from ropewalk.scene import Obstacle

ROOT = Path(__file__).resolve().parents[2]
HEAVY = {"matplotlib", "xarray", "zarr", "scipy", "pandas", "pyarrow", "PIL", "vtk"}


def loaded_by(statement: str) -> set[str]:
    """Return the top-level modules in memory after `statement` in a fresh interpreter."""
    report = "import json, sys; print(json.dumps(sorted({m.split('.')[0] for m in sys.modules})))"
    done = subprocess.run(
        [sys.executable, "-c", f"{statement}\n{report}"],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    return set(json.loads(done.stdout.splitlines()[-1]))


def test_import_ropewalk_is_light() -> None:
    loaded = loaded_by("import ropewalk")
    assert "ropewalk" in loaded
    assert loaded & (HEAVY | {"click", "rich"}) == set()


def test_the_names_of_the_package_load_nothing_heavy() -> None:
    loaded = loaded_by("from ropewalk import Anchor, Rope, Scene, Simulation, Springs, simulate")
    own = loaded - loaded_by("import numba")  # numba loads scipy itself where there is one
    assert own & HEAVY == set()


def test_the_command_line_loads_nothing_heavy_at_start() -> None:
    assert loaded_by("import ropewalk.cli") & (HEAVY | {"numba"}) == set()


def test_the_probe_sees_what_is_loaded() -> None:
    assert "xarray" in loaded_by("import ropewalk, xarray")


def test_every_public_name_is_there() -> None:
    import ropewalk

    assert set(ropewalk.__all__) <= set(dir(ropewalk))
    for name in ropewalk.__all__:
        assert getattr(ropewalk, name) is not None


def test_an_unknown_name_is_an_attribute_error() -> None:
    import ropewalk

    with pytest.raises(AttributeError, match="no_such_name"):
        ropewalk.no_such_name  # noqa: B018 - the access is the test


def test_a_name_of_a_scene_that_is_looked_for_here_is_told_where_it_is() -> None:
    import ropewalk

    with pytest.raises(
        AttributeError, match=r"the command 'settle' does is ropewalk\.equilibrium$"
    ):
        ropewalk.settle  # noqa: B018
    with pytest.raises(AttributeError, match=r"it is ropewalk\.scene\.Straight$"):
        ropewalk.Straight  # noqa: B018 - the access is the test
    with pytest.raises(AttributeError, match=r"'Cylindre'$"):
        ropewalk.Cylindre  # noqa: B018 - the access is the test
    words = r"it is one of Plane, Sphere, .* Sdf, all in ropewalk\.scene$"
    with pytest.raises(AttributeError, match=words):
        ropewalk.Obstacle  # noqa: B018 - the access is the test


def test_all_that_a_scene_is_made_of_stands_in_the_package() -> None:
    """Every kind of obstacle and what it takes, beside ropes, materials, anchors and loads."""
    import ropewalk as rw

    kinds = {kind.__name__ for kind in get_args(get_args(Obstacle)[0])}
    assert kinds | {"Spin", "Pair", "RopePair", "Contact", "Rope", "Anchor"} <= set(rw.__all__)
    drum = rw.Cylinder(start=(0, 0, 0), end=(0, 1, 0), radius=0.1, spin=rw.Spin(rate=1.0))
    floor = rw.Plane(pair=[rw.Pair(rope="rope", friction=0.1)])
    contact = rw.Contact(pair=[rw.RopePair(rope="rope", other="rope", friction=0.2)])
    springs = rw.Springs(spring_constant=1e3, node_mass=0.05, segment_length=0.1)
    rope = rw.Rope(segments=4, made_of=springs, diameter=0.01)
    scene = rw.Scene(ropes=[rope], obstacles=[drum, floor], contact=contact)
    assert rw.loads(rw.dumps(scene)) == scene


def test_layers() -> None:
    done = subprocess.run(
        [str(Path(sys.executable).with_name("lint-imports")), "--no-logo", "--no-cache"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
