"""What friction carries across a rope it lacks along it: ropes on a sphere off its great circle.

T2/T1 = exp(theta sqrt(mu^2 - tan^2 beta)) along the circle R sin(beta) off the centre, from
dT = T sqrt((mu a)^2 - b^2) with a the turn towards the surface and b that within it (`statics.wraps`).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Cylinder, Load, Material, Points, Rope, Scene, Sphere
from ropewalk.statics import NoRest, static_shape
from ropewalk.statics.wraps import Wrap

MU, BALL, HALF = 0.3, 0.1, 0.005  # friction, radius of the ball, half of the rope's diameter [m]


def over_a_ball(beta: float, ratio: float = 1.0, nodes: int = 40) -> Scene:
    """Return a light rope with weights over a ball, in the plane R sin(beta) off its centre; `beta` [rad]."""
    outer = BALL + HALF
    aside, around = outer * math.sin(beta), outer * math.cos(beta)
    step = math.pi * around / nodes
    legs = [k * step for k in range(int(0.3 / step), 0, -1)]
    arc = [math.pi - math.pi * k / nodes for k in range(nodes + 1)]
    points = [(aside, -around, -leg) for leg in legs]
    points += [(aside, around * math.cos(a), around * math.sin(a)) for a in arc]
    points += [(aside, around, -leg) for leg in reversed(legs)]
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    rope = Rope(
        segments=len(points) - 1,
        length=length * 0.9995,
        diameter=2.0 * HALF,
        made_of=Material(EA=2e4, mass_per_length=1e-3),
        shape=Points(points=points),
        loads=[Load(node=0, mass=1.0), Load(node=-1, mass=ratio)],
    )
    ball = Sphere(name="ball", center=(0, 0, 0), radius=BALL, friction=MU)
    return Scene(ropes=[rope], obstacles=[ball], run={"method": "implicit-euler", "duration": 0.1})


def holds(beta: float) -> float:
    """Return T2/T1 at which a rope without weight slips along the circle over the top of the ball [1]."""
    return math.exp(math.pi * math.cos(beta) * math.sqrt(MU**2 - math.tan(beta) ** 2))


def wrap_of(scene: Scene) -> Wrap:
    (wrap,) = static_shape(scene).wraps
    return wrap


@pytest.mark.parametrize("degrees", [0.0, 8.0, 14.0, 16.2])
def test_what_holds_a_rope_across_does_not_hold_it_along(degrees: float) -> None:
    """At 16.2 of the 16.7 degrees of atan(mu) 3.97 to 24.29 N were said to hold beside 9.82 N."""
    beta = math.radians(degrees)
    scene = over_a_ball(beta, nodes=80)
    wrap, most = wrap_of(scene), holds(beta)
    assert wrap.angle == pytest.approx(math.pi * math.cos(beta), rel=1e-3)
    assert wrap.most / wrap.before == pytest.approx(most, rel=0.02)
    assert wrap.before / wrap.least == pytest.approx(most, rel=0.02)
    assert wrap.share == pytest.approx(
        0.0, abs=1e-3
    )  # both pull alike: nothing along it is asked for
    told = rw.equilibrium(scene).to_pandas("wraps").iloc[0]
    assert told["ratio at slip [1]"] == pytest.approx(most, rel=0.02)


def test_beyond_what_is_left_along_it_there_is_no_rest() -> None:
    """At 14 degrees 1.66 is left of exp(mu theta) = 2.5: 1.55 rests, 1.8 slides off."""
    beta = math.radians(14.0)
    assert 1.6 < holds(beta) < 1.7
    taken = math.log(1.55) / math.log(holds(beta))
    assert wrap_of(over_a_ball(beta, ratio=1.55)).share == pytest.approx(taken, rel=0.02)
    with pytest.raises(NoRest):
        static_shape(over_a_ball(beta, ratio=1.8))


def aslant(degrees: float, **more: Any) -> Scene:
    """Return a light rope over a cylinder whose axle is `degrees` off square to it: it lies along a helix."""
    slant, outer, nodes = math.radians(degrees), 0.055, 40
    turn = np.linspace(math.pi, 0.0, nodes + 1)
    rise = outer * math.tan(slant)  # along the axle y, over the angle [m]
    arc = [(outer * math.cos(a), rise * (math.pi / 2.0 - a), outer * math.sin(a)) for a in turn]
    step = np.subtract(arc[-1], arc[-2])
    way = np.array([0.0, math.sin(slant), -math.cos(slant)]) * np.linalg.norm(step)
    legs = [
        (np.array([-1, -1, 1]) * (np.array(arc[-1]) + k * way)).tolist() for k in range(30, 0, -1)
    ]
    tail = [(np.array(arc[-1]) + k * way).tolist() for k in range(1, 31)]
    points = [*legs, *arc, *tail]
    pull = (0.0, 9.81 * math.tan(slant), 0.0)
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    rope = Rope(
        segments=len(points) - 1,
        length=length * 0.9995,
        diameter=0.01,
        made_of=Material(EA=2e4, mass_per_length=1e-3),
        shape=Points(points=points),
        loads=[Load(node=0, mass=1.0), Load(node=-1, mass=1.0)],
        forces=[
            {"node": 0, "force": tuple(-part for part in pull)},
            {"node": -1, "force": pull},
        ],
    )
    bar = Cylinder(name="bar", start=(0, -1, 0), end=(0, 1, 0), radius=0.05, friction=MU)
    return Scene(ropes=[rope], obstacles=[bar], run={"method": "implicit-euler"}, **more)


def test_a_helix_round_a_bar_needs_nothing_across() -> None:
    """It is the shortest way there: all of friction holds along it, exp(mu theta), theta = pi cos(slant)."""
    wrap = wrap_of(aslant(20.0))
    assert wrap.angle == pytest.approx(math.pi * math.cos(math.radians(20.0)), rel=5e-3)
    assert wrap.most / wrap.before == pytest.approx(math.exp(MU * wrap.angle), rel=5e-3)
    told = rw.equilibrium(aslant(20.0)).to_pandas("wraps").iloc[0]
    assert told["ratio at slip [1]"] == pytest.approx(math.exp(MU * wrap.angle), rel=5e-3)
