"""What `test_added_segment_law` runs in a copy of the package that has the sample law; prints its numbers."""

from __future__ import annotations

from functools import partial
from typing import Any

import sample_scenes as base

from ropewalk.analysis.check import check
from ropewalk.scene import Anchor, Material, Rope, Scene, Winch
from ropewalk.scene.base import Many, Model, Number, listed, quantity


class Fibre(Model):
    """The section of the sample law."""

    cubic: Number = quantity("a", "N/m^3", default=900.0)
    arm: Number = quantity("b", "N/m", default=20.0)
    time: Number = quantity("tau", "s", default=0.03)
    reach: Number = quantity("No segment is stretched by more", "m", default=0.2)


class Fibred(Rope):
    """A rope with that section."""

    fibre: Fibre | None = Fibre()


class Sample(Scene):
    """A scene of such ropes."""

    ropes: Many[Fibred] = listed("Ropes", "rope", "ropes", default=())


rope = partial(base.rope, Fibred)
one_segment = partial(base.one_segment, Fibred)


def scene(method: str, dt: float, time: float = 0.1, **more: Any) -> Sample:
    """A scene of that rope."""
    return Sample(**({"ropes": [rope()], "run": base.settings(method, dt, time)} | more))


def moved(method: str, dt: float, **more: Any) -> dict[str, Any]:
    """Run one; return its numbers."""
    return base.moved(scene(method, dt, **more), "fibre")


def newton() -> list[float]:
    """Orders of convergence of Newton's method of a taut rope with a stiff law."""
    soft = Material(EA=200.0, mass_per_length=0.2)
    taut = base.taut(Fibred, soft, 1.02, fibre=Fibre(cubic=4e5, arm=800.0))
    return base.orders(scene("implicit-euler", 0.05, 0.5, **taut))


def pulled(method: str) -> dict[str, Any]:
    """A segment that is drawn out for 0.1 s."""
    return moved(method, 1e-3, ropes=[one_segment()], anchors=base.pulled_ends())


def bound() -> dict[str, Any]:
    """The largest step with a stiff arm that hardly gives, and the speeds just below and above it."""
    kick = [{"node": 2, "velocity": (0.01, 0, 0)}]
    stiff: dict[str, Any] = {"ropes": [rope(fibre=Fibre(cubic=0.0, arm=5e3, time=1e3), kicks=kick)]}
    stiff |= {"gravity": (0, 0, 0)}
    most = float(check(scene("verlet", 1e-4, **stiff)).stability.largest_step["verlet"])
    speeds = base.beside(most, 60, lambda dt, time: scene("verlet", dt, time, **stiff), "v")
    return {"most": most, "speeds": speeds}


def everything() -> dict[str, Any]:
    """All of it."""
    top, drum = [Anchor(name="top", node=0)], [Anchor(name="drum", node=0)]
    wind = [Winch(rope="rope", end="start", speed=0.1)]
    return {
        "methods": base.every_method(moved),
        "elastic": moved("rk4", 1e-3, ropes=[rope(fibre=Fibre(arm=0.0))]),
        "without": moved("rk4", 1e-3, ropes=[rope(fibre=None)]),
        "two": moved("esdirk3", 1e-3, ropes=[rope(), rope("other", 1.0, fibre=None)]),
        "alone": moved("esdirk3", 1e-3),
        "pulled": {
            method: pulled(method) for method in ("verlet", "rk4", "implicit-euler", "adaptive")
        },
        "newton": newton(),
        "hanging": base.hanging(scene("esdirk3", 1e-3, ropes=[one_segment()], anchors=top)),
        "bound": bound(),
        "refused": base.said_of(scene("verlet", 1e-3, anchors=drum, winches=wind)),
    }


if __name__ == "__main__":
    base.tell(newton, lambda method: moved(method, 1e-3, time=0.02), everything)
