"""Ropewalk simulates ropes: true tensions, predicted stability, runs to keep and compare.

    import ropewalk as rw

    scene = rw.preset("r4")
    result = rw.simulate(scene)
    print(result)

Units are SI throughout. Heavy parts (figures, run folders) load when they are first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOMES = {
    "Air": "scene",
    "Anchor": "scene",
    "Clamp": "scene",
    "Ground": "scene",
    "Limiter": "scene",
    "Load": "scene",
    "Material": "scene",
    "Rope": "scene",
    "Ring": "scene",
    "RunSettings": "scene",
    "Scene": "scene",
    "SceneError": "scene",
    "Springs": "scene",
    "Winch": "scene",
    "load": "scene",
    "loads": "scene",
    "dumps": "scene",
    "save": "scene",
    "preset": "scene.presets",
    "Simulation": "simulation",
    "Broken": "simulation",
    "BrokenRun": "api",
    "Result": "record.result",
    "simulate": "api",
    "equilibrium": "api",
    "modes": "api",
    "Modes": "vibration",
    "NoRest": "statics",
    "run": "api",
    "resume": "api",
    "RunError": "record.errors",
    "check": "api",
    "catenary": "theory",
    "elastic_catenary": "theory",
    "parabola": "theory",
    "lumped_chain": "theory",
    "hanging_chain": "theory",
}

__version__ = "0.1.0"
__all__ = [*sorted(_HOMES), "__version__"]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'ropewalk' has no attribute {name!r}")
    return getattr(import_module(f"ropewalk.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return __all__
