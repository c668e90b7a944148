"""Random ropes, loads and ways of which `working_scenes` makes scenes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ropewalk.scene import Load, Material, Rope, Shake
from verification.random_scenes import Random, _between, _chance

g = 9.81
Parts = dict[str, Any]


def material_of(random: Random, low: float = 1e3, high: float = 1e6) -> dict[str, Any]:
    """A material with a retardation time of 0.3 to 20 ms, now and then none."""
    EA = _between(random, low, high)
    time = 0.0 if _chance(random, 0.1) else _between(random, 3e-4, 2e-2)
    return {
        "EA": EA,
        "mass_per_length": float(np.clip(EA * 10.0 ** random.uniform(-6.5, -5.3), 0.01, 2.0)),
        "axial_damping": time * EA,
        "breaking_load": EA * _between(random, 0.05, 0.5),
        "tension_only": _chance(random, 0.3),
    }


def mass_of(random: Random, stuff: dict[str, Any], low: float = 5e-4, high: float = 0.03) -> float:
    """A load that stretches its rope at rest by so much [kg]."""
    return float(np.clip(_between(random, low, high) * stuff["EA"] / g, 0.05, 3000.0))


def rope_of(
    random: Random,
    name: str,
    stuff: dict[str, Any],
    length: float | None,
    shape: Any,
    *,
    segments: int | None = None,
    mass: float = 0.0,
    **more: Any,
) -> Rope:
    return Rope(
        name=name,
        segments=segments or int(random.integers(10, 41)),
        length=length,
        diameter=_between(random, 0.006, 0.02),
        made_of=Material(**stuff),
        shape=shape,
        loads=[Load(node=-1, mass=mass)] if mass else [],
        **more,
    )


def way_of(random: Random, down: float = 0.0) -> np.ndarray:
    way: np.ndarray = random.normal(size=3) + np.array([0.0, 0.0, -down])
    return way / np.linalg.norm(way)


def place_of(place: Any) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in place)
    return x, y, z


def shake_of(random: Random, size: float) -> Shake:
    return Shake(
        axis=place_of(way_of(random)),
        amplitude=_between(random, 0.003, 0.05) * size,
        frequency=_between(random, 0.5, 10.0),
    )
