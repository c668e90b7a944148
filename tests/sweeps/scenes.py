"""Small scenes that many runs are made of."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import ropewalk as rw
from ropewalk.scene import apply_overrides

SCENE = """\
name = "swing"
[run]
duration = {duration}
time_step = 0.001
frame_rate = 50.0
method = "semi-implicit-euler"
[[rope]]
segments = 4
length = 2.0
[rope.made_of]
kind = "material"
EA = 2000.0
mass_per_length = 0.1
axial_damping = 2.0
[rope.shape]
kind = "straight"
start = [0.0, 0.0, 0.0]
end = [2.0, 0.0, 0.0]
[[anchor]]
name = "top"
node = 0
"""
EA = "rope.made_of.EA"
DOWN = "gravity[2]"
#: With the step of the scene the last one is unstable.
STIFF = [1000.0, 2000.0, 4.0e6]
#: A sweep of given runs, the last of which breaks.
RUNS = 24
TABLE = pd.DataFrame(
    {EA: [2000.0] * (RUNS - 1) + [4.0e6], "rope.length": np.linspace(1.9, 2.1, RUNS)}
)


def swing(duration: float = 0.1) -> rw.Scene:
    """A pendulum of four segments."""
    return rw.loads(SCENE.format(duration=duration))


def store_bytes(folder: Path) -> dict[str, bytes]:
    """Every file of a sweep's store by name."""
    store = folder / "data.zarr"
    files = sorted(path for path in store.rglob("*") if path.is_file())
    return {path.relative_to(store).as_posix(): path.read_bytes() for path in files}


def alone(scene: rw.Scene, **values: Any) -> rw.Result:
    """A run of its own, with values by path."""
    from ropewalk.scene import apply_overrides

    made = apply_overrides(scene, [f"{path}={value!r}" for path, value in values.items()])
    return rw.simulate(made, on_failure="return")


def same(one: Any, other: Any) -> bool:
    """Whether two arrays have the same bits, NaN like NaN."""
    return np.array_equal(one, other, equal_nan=np.asarray(one).dtype.kind == "f")


def rigid() -> rw.Scene:
    """A hanging rope of rigid links, which a span longer than it refuses."""
    more = ["rope.made_of.EA=inf", "run.method=bdf2", "run.duration=0.02"]
    return apply_overrides(rw.preset("hanging-rope"), more)


def make(folder: Path, **options: Any) -> None:
    """Begin the sweep, or go on with it."""
    if (folder / "sweep.json").exists():
        rw.sweep.resume(folder, **({"on": "here"} | options))
        return
    rw.sweep(swing(0.04), TABLE, store=folder, batch=2, **({"on": "here"} | options))


@contextmanager
def of_format(version: int) -> Iterator[None]:
    """Have sweeps made in an older format, but for what of it is not in the plan alone."""
    from ropewalk.sweeps import many

    made = many.SweepPlan
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(many, "SweepPlan", lambda **about: made(**about, format=version))
        yield


def flip(path: Path) -> None:
    """Change one bit in the middle of a file."""
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)
