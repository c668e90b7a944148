"""Random valid scenes in which ropes meet things: bodies, each other, themselves, joints, slides.

Ropes begin apart from all that they may touch, and are thrown at it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from hypothesis import strategies as st

from ropewalk.scene import (
    Air,
    Anchor,
    Box,
    Capsule,
    Contact,
    Cylinder,
    Force,
    Joint,
    Load,
    Material,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Slide,
    Sphere,
    Spin,
    TableCurve,
    Tie,
    Torus,
    Velocity,
)
from strategies import axes, numbers, powers, vectors

THICK = 0.02  # [m]
NEAR, ACROSS = 0.28, 0.2  # [m] how far below the ropes the middles of bodies lie, and to the side
IMPLICIT = ("implicit-euler", "sdirk2", "esdirk3", "generalized-alpha", "bdf2")
EXPLICIT = ("semi-implicit-euler", "verlet", "rk4")


def unit(axis: tuple[float, float, float]) -> np.ndarray:
    """Return it at length 1, (3,)."""
    return np.array(axis) / math.hypot(*axis)


@st.composite
def stuffs(draw: st.DrawFn, rigid: bool) -> Material:
    """Materials with any of the laws along a rope; `rigid`: rigid links may be drawn."""
    EA = draw(powers(2.0, 5.0) | (st.just(math.inf) if rigid else st.nothing()))
    more: dict[str, object] = {}
    kind = draw(
        st.sampled_from(["plain", "plain", "curve", "relaxation", "bending", "one way", "parts"])
    )
    if kind == "bending":
        more |= {"EI": draw(powers(-5.0, -2.0)), "bending_damping": draw(powers(-6.0, -4.0))}
    if math.inf > EA:
        more["axial_damping"] = draw(st.just(0.0) | powers(-2.0, 1.0))
        if kind == "curve":
            more["curve"] = TableCurve(strain=(0.01, 0.05, 0.2), tension=(1.0, 20.0, 200.0))
        elif kind == "relaxation":
            more |= {"relaxing_EA": 0.5 * EA, "relaxation_time": draw(powers(-3.0, 0.0))}
        elif kind == "one way":
            more["tension_only"] = True
        elif kind == "parts":
            more |= {"parts": True, "breaking_load": draw(powers(0.0, 3.0))}
    if "curve" not in more:
        more["EA"] = EA
    return Material(mass_per_length=draw(powers(-2.0, 0.0)), **more)


@st.composite
def thrown(draw: st.DrawFn, name: str, height: float, rigid: bool) -> Rope:
    """A bent rope about a height above the origin, thrown."""
    segments = draw(st.integers(1, 8))
    piece = draw(numbers(0.03, 0.15))
    steps = [unit(draw(axes()))]
    for _ in range(segments - 1):  # no sharp folds
        steps.append(unit(tuple(steps[-1] + 0.6 * unit(draw(axes())))))
    places = np.cumsum([np.zeros(3), *(piece * np.array(steps))], axis=0)
    places += (0.0, 0.0, height - places[:, 2].min())
    aside = numbers(-2.0, 2.0)
    speed = draw(st.tuples(aside, aside, numbers(-15.0, -0.5)))
    return Rope(
        name=name,
        segments=segments,
        length=piece * segments,
        diameter=THICK,
        made_of=draw(stuffs(rigid)),
        friction=draw(st.just(0.0) | numbers(0.0, 1.0)),
        shape=Points(points=places.tolist(), velocity=speed),
        loads=draw(
            st.lists(
                st.builds(Load, node=st.integers(0, segments), mass=powers(-2.0, 0.5)), max_size=1
            )
        ),
        forces=draw(
            st.lists(
                st.builds(Force, node=st.integers(0, segments), force=vectors(5.0)), max_size=1
            )
        ),
    )


def spins() -> st.SearchStrategy[Spin | None]:
    """None, a speed, or free to turn."""
    free = st.builds(
        lambda inertia, bearing: Spin(free=True, inertia=inertia, bearing=bearing),
        powers(-5.0, -2.0),
        st.just(0.0) | powers(-4.0, -1.0),
    )
    return st.none() | st.builds(Spin, rate=numbers(-20.0, 20.0)) | free


@st.composite
def bodies(draw: st.DrawFn, name: str) -> object:
    """A body below the origin, one of every kind but half-pipes and grids."""
    x, y = draw(numbers(-ACROSS, ACROSS)), draw(numbers(-ACROSS, ACROSS))
    middle, radius = np.array([x, y, -NEAR - draw(numbers(0.0, 0.1))]), draw(numbers(0.08, 0.25))
    along = unit(draw(axes()))
    half = draw(numbers(0.1, 0.6)) * along
    slow = (
        st.none()
        | st.builds(Shake, axis=axes(), amplitude=numbers(0.001, 0.03), frequency=numbers(0.5, 5.0))
        | st.builds(Velocity, velocity=vectors(0.3))
    )
    own = {
        "name": name,
        "friction": draw(st.just(0.0) | numbers(0.0, 1.2)),
        "motion": draw(slow) or Velocity(velocity=(0, 0, 0)),
    }
    kind = draw(st.sampled_from(["plane", "sphere", "cylinder", "capsule", "box", "torus"]))
    if kind == "plane":
        normal = unit((0.5 * along[0], 0.5 * along[1], 1.0))
        return Plane(point=(0.0, 0.0, -NEAR - 0.5), normal=tuple(normal), **own)
    if kind == "sphere":
        return Sphere(center=tuple(middle), radius=radius, spin=draw(spins()), **own)
    if kind == "torus":
        return Torus(
            center=tuple(middle),
            radius=radius,
            bar_radius=0.2 * radius,
            axis=tuple(along),
            spin=draw(spins()),
            **own,
        )
    if kind == "box":
        return Box(
            center=tuple(middle),
            half_sizes=(radius, 0.5 * radius, 0.3 * radius),
            edge_radius=0.1 * radius,
            rotation=draw(vectors(3.0)),
            **own,
        )
    ends = {"start": tuple(middle - half), "end": tuple(middle + half), "radius": 0.5 * radius}
    made = Cylinder if kind == "cylinder" else Capsule
    return made(**ends, spin=draw(spins()), **own)


@st.composite
def touching(
    draw: st.DrawFn, methods: Sequence[str] = (*IMPLICIT, *EXPLICIT), contact: bool = True
) -> Scene:
    """A scene of one or two ropes that are thrown at one or two bodies, or each other."""
    method = draw(st.sampled_from(methods))
    implicit = method in (*IMPLICIT, "adaptive")
    two = draw(st.booleans())
    made = [draw(thrown("one", 0.1, implicit))]
    if two:
        other = draw(thrown("two", 1.5, implicit))
        made.append(other)
    joints, slides = [], []
    if two:
        ways = ["free", "free", "joint", *(["slide"] if made[0].segments > 1 else [])]
        how = draw(st.sampled_from(ways))
        first = np.array(made[0].shape.points)
        if how == "joint":
            node = draw(st.integers(0, made[0].segments))
            hung = np.array(made[1].shape.points)
            moved = (hung - hung[0] + first[node]).tolist()
            made[1] = made[1].replace(
                shape=made[1].shape.replace(points=moved, velocity=made[0].shape.velocity)
            )
            joints = [
                Joint(name="knot", points=[Tie(rope="one", node=node), Tie(rope="two", node=0)])
            ]
        elif how == "slide":
            at = draw(numbers(0.1, 0.9)) * made[0].length
            piece = made[0].segment_length
            j, part = divmod(at / piece, 1.0)
            place = first[int(j)] + part * (first[int(j) + 1] - first[int(j)])
            hung = np.array(made[1].shape.points)
            moved = (hung - hung[0] + place).tolist()
            made[1] = made[1].replace(
                shape=made[1].shape.replace(points=moved, velocity=made[0].shape.velocity)
            )
            slides = [
                Slide(
                    rope="two",
                    at=at,
                    friction=draw(numbers(0.0, 0.5)),
                    brake=draw(st.just(0.0) | powers(-2, 0)),
                )
            ]
    anchors = []
    if draw(st.booleans()):
        shake = st.builds(
            Shake, axis=axes(), amplitude=numbers(0.01, 0.1), frequency=numbers(0.5, 4.0)
        )
        still = st.just(Velocity(velocity=(0, 0, 0)))
        anchors = [
            Anchor(
                rope="one",
                node=draw(st.sampled_from([0, -1])),
                motion=draw(still | shake),
                release_time=draw(st.none() | numbers(0.05, 0.3)),
            )
        ]
    number = draw(st.integers(0 if contact else 1, 2))
    return Scene(
        ropes=made,
        anchors=anchors,
        joints=joints,
        slides=slides,
        obstacles=[draw(bodies(f"body{i}")) for i in range(number)],
        contact=Contact(friction=draw(numbers(0.0, 0.8)))
        if contact and draw(st.booleans())
        else None,
        air=draw(st.none() | st.just(Air(density=1.2))),
        run=RunSettings(
            method=method,
            duration=draw(numbers(0.1, 0.6)),
            frame_rate=60.0,
            time_step=draw(st.sampled_from([1 / 60, 1 / 240, 1 / 1000]))
            if implicit and method != "adaptive"
            else "auto",
        ),
    )
