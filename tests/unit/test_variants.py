"""Two variants of every method's kernels: plain, and with the rare laws; both give the same bits."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from numba import typeof

from golden.states import laws, rope, scene
from ropewalk.core import cache
from ropewalk.core.arrays import flatten
from ropewalk.core.jit import kernel, part
from ropewalk.lowering import Model, build
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation

PLAIN = {"stretch", "springs", "slack", "rigid", "shaken", "released", "load", "two"}


class Box(NamedTuple):
    """A value, and what is None by its type or a number."""

    value: float
    rare: int | None


@part
def is_rare(box):
    return box.rare is not None and box.rare == 1


@part
def raised(box):
    return box.value + box.rare  # numba knows no sum with None


@kernel
def raise_rare(box, count):
    """Add what is rare, as often as is said."""
    total = 0.0
    for _ in range(count):
        if not is_rare(box):
            total += box.value
        else:
            total += raised(box)
    return total


def forced(model: Model, rare: int | None) -> Simulation:
    """Return a simulation by the kernels of one variant, whatever the scene asks for."""
    return Simulation(replace(model, system=model.system._replace(rare=rare)))


def bits(simulation: Simulation) -> dict[str, bytes]:
    """Return all that has evolved after six frames."""
    simulation.advance_frames(6)
    return {name: np.asarray(one).tobytes() for name, one in flatten(simulation.arrays).items()}


def test_what_a_type_rules_out_is_not_compiled() -> None:
    assert raise_rare(Box(2.0, None), 3) == 6.0
    assert raise_rare(Box(2.0, 1), 3) == 9.0
    assert raise_rare(Box(2.0, 0), 3) == 6.0


@pytest.mark.parametrize("law", laws())
def test_a_scene_takes_the_plain_variant_unless_a_rare_law_acts(law: str) -> None:
    rare = build(scene(law, "verlet")).system.rare
    assert rare is None if law in PLAIN else rare == 1


@pytest.mark.parametrize(
    "more",
    [
        {"joints": [{"points": [{"rope": "rope", "node": 8}, {"rope": "other", "node": 0}]}]},
        {"obstacles": [{"kind": "sphere", "center": (0, 0, -9), "radius": 1.0}]},
    ],
    ids=lambda more: next(iter(more)),
)
def test_joints_and_obstacles_take_the_full_variant(more: dict[str, Any]) -> None:
    other = rope(shape={"kind": "straight", "start": (1.7, 0, 1.2), "end": (3, 0, 1)})
    ropes, run = [rope(), other.replace(name="other")], {"method": "esdirk3"}
    parts: dict[str, Any] = {"ropes": ropes, "anchors": [{"rope": "rope", "node": 0}], "run": run}
    assert build(Scene(**parts)).system.rare is None
    assert build(Scene(**parts | more)).system.rare == 1


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet", "implicit-euler", "adaptive"])
def test_both_variants_give_the_same_bits(method: str) -> None:
    model = build(scene("shaken", method))
    assert bits(forced(model, None)) == bits(forced(model, 1))


def test_the_plain_variant_knows_no_rare_law() -> None:
    """The twin: with the ground left out the same scene goes another way."""
    model = build(scene("ground", "semi-implicit-euler"))
    assert model.system.rare == 1
    assert bits(forced(model, None)) != bits(forced(model, 1))


def test_machine_code_is_told_by_its_variant(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Machine code of one variant is none of the other."""
    function = METHODS["verlet"].advance
    monkeypatch.setattr(cache, "cache_folder", lambda: tmp_path)
    monkeypatch.setattr(type(function), "signatures", property(lambda _: []))
    file = cache.KernelCache(function.py_func)._cache_file
    for rare in (None, 1):
        assert not cache.is_compiled(function, rare)
        system = build(scene("stretch", "verlet")).system._replace(rare=rare)
        file.save(((typeof(system), typeof(1.0)), "code"), b"")
        assert cache.is_compiled(function, rare)
