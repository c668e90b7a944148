"""Ropewalk simulates ropes: true tensions, predicted stability, runs to keep and compare.

    import ropewalk as rw

    scene = rw.preset("r4")
    result = rw.simulate(scene)
    print(result)

Units are SI throughout. Heavy parts (figures, run folders) load when they are first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, get_args

if TYPE_CHECKING:  # what type checkers and editors see; `_HOMES` loads the same at run time
    from ropewalk.api import BrokenRun as BrokenRun
    from ropewalk.api import check as check
    from ropewalk.api import equilibrium as equilibrium
    from ropewalk.api import modes as modes
    from ropewalk.api import open as open  # noqa: A004
    from ropewalk.api import resume as resume
    from ropewalk.api import run as run
    from ropewalk.api import simulate as simulate
    from ropewalk.library import LibraryRope as LibraryRope
    from ropewalk.library import UnknownRope as UnknownRope
    from ropewalk.library import rope as rope
    from ropewalk.record.errors import RunError as RunError
    from ropewalk.record.result import Result as Result
    from ropewalk.rigging import Line as Line
    from ropewalk.rigging import Rolling as Rolling
    from ropewalk.rigging import line as line
    from ropewalk.scene import Air as Air
    from ropewalk.scene import Anchor as Anchor
    from ropewalk.scene import Box as Box
    from ropewalk.scene import Capsule as Capsule
    from ropewalk.scene import Clamp as Clamp
    from ropewalk.scene import Contact as Contact
    from ropewalk.scene import Cylinder as Cylinder
    from ropewalk.scene import Force as Force
    from ropewalk.scene import Ground as Ground
    from ropewalk.scene import HalfPipe as HalfPipe
    from ropewalk.scene import Joint as Joint
    from ropewalk.scene import Limiter as Limiter
    from ropewalk.scene import Load as Load
    from ropewalk.scene import Material as Material
    from ropewalk.scene import Mesh as Mesh
    from ropewalk.scene import Pair as Pair
    from ropewalk.scene import Plane as Plane
    from ropewalk.scene import Ring as Ring
    from ropewalk.scene import Rope as Rope
    from ropewalk.scene import RopePair as RopePair
    from ropewalk.scene import RunSettings as RunSettings
    from ropewalk.scene import Scene as Scene
    from ropewalk.scene import SceneError as SceneError
    from ropewalk.scene import Sdf as Sdf
    from ropewalk.scene import Slide as Slide
    from ropewalk.scene import Sphere as Sphere
    from ropewalk.scene import Spin as Spin
    from ropewalk.scene import Springs as Springs
    from ropewalk.scene import Torus as Torus
    from ropewalk.scene import Winch as Winch
    from ropewalk.scene import dumps as dumps
    from ropewalk.scene import load as load
    from ropewalk.scene import loads as loads
    from ropewalk.scene import save as save
    from ropewalk.scene.presets import preset as preset
    from ropewalk.sheets import Sheet as Sheet
    from ropewalk.sheets import sheet as sheet
    from ropewalk.simulation import Broken as Broken
    from ropewalk.simulation import Simulation as Simulation
    from ropewalk.statics import NoRest as NoRest
    from ropewalk.sweeps.public import calibrate as calibrate
    from ropewalk.sweeps.public import sweep as sweep
    from ropewalk.sweeps.uncertainty import uncertain as uncertain
    from ropewalk.theory import catenary as catenary
    from ropewalk.theory import elastic_catenary as elastic_catenary
    from ropewalk.theory import hanging_chain as hanging_chain
    from ropewalk.theory import lumped_chain as lumped_chain
    from ropewalk.theory import parabola as parabola
    from ropewalk.vibration import Modes as Modes

_HOMES = {
    "Air": "scene",
    "Anchor": "scene",
    "Clamp": "scene",
    "Contact": "scene",
    "Ground": "scene",
    "Limiter": "scene",
    "Force": "scene",
    "Joint": "scene",
    "Load": "scene",
    "Material": "scene",
    "Rope": "scene",
    "Ring": "scene",
    "RunSettings": "scene",
    "Scene": "scene",
    "SceneError": "scene",
    "Slide": "scene",
    "Springs": "scene",
    "Winch": "scene",
    "Box": "scene",
    "Capsule": "scene",
    "Cylinder": "scene",
    "HalfPipe": "scene",
    "Mesh": "scene",
    "Pair": "scene",
    "Plane": "scene",
    "RopePair": "scene",
    "Sdf": "scene",
    "Sphere": "scene",
    "Spin": "scene",
    "Torus": "scene",
    "load": "scene",
    "loads": "scene",
    "dumps": "scene",
    "save": "scene",
    "preset": "scene.presets",
    "rope": "library",
    "LibraryRope": "library",
    "UnknownRope": "library",
    "line": "rigging",
    "Line": "rigging",
    "Rolling": "rigging",
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
    "open": "api",
    "sweep": "sweeps.public",
    "calibrate": "sweeps.public",
    "uncertain": "sweeps.uncertainty",
    "sheet": "sheets",
    "Sheet": "sheets",
    "RunError": "record.errors",
    "check": "api",
    "catenary": "theory",
    "elastic_catenary": "theory",
    "parabola": "theory",
    "lumped_chain": "theory",
    "hanging_chain": "theory",
}

__version__ = "0.1.0"
# `from ropewalk import *` must not put itself in the place of Python's own `open`.
__all__ = [*sorted(set(_HOMES) - {"open"}), "__version__"]

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name not in _HOMES:
            raise AttributeError(f"module 'ropewalk' has no attribute {name!r}{_where(name)}")
        from ropewalk.words.annotations import unquoted

        return unquoted(getattr(import_module(f"ropewalk.{_HOMES[name]}"), name))


#: What commands do that have another name here.
_COMMANDS = {"settle": "equilibrium", "new": "preset", "info": "open", "ropes": "rope"}


def _where(name: str) -> str:
    """Say where a name is that is looked for here; shapes and motions are in `scene`."""
    if name in _COMMANDS:
        return f"; what the command {name!r} does is ropewalk.{_COMMANDS[name]}"
    thing = None if name.startswith("_") else getattr(import_module("ropewalk.scene"), name, None)
    if thing is None:
        return ""
    kinds = [kind.__name__ for union in get_args(thing) for kind in get_args(union)]
    if kinds:
        return f"; it is one of {', '.join(kinds)}, all in ropewalk.scene"
    return f"; it is ropewalk.scene.{name}"


def __dir__() -> list[str]:
    return sorted([*_HOMES, "__version__"])
