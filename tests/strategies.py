"""Random valid scenes for property tests: small enough to simulate in a moment."""

from __future__ import annotations

import math
from collections.abc import Sequence

from hypothesis import strategies as st

from ropewalk.methods.registry import METHODS
from ropewalk.scene import (
    Air,
    Anchor,
    Clamp,
    Fixed,
    Ground,
    Hand,
    Hanging,
    Kick,
    Limiter,
    Load,
    Material,
    Orbit,
    Points,
    Polyline,
    Rope,
    RunSettings,
    Scene,
    Shake,
    Slack,
    Springs,
    Straight,
    Table,
    Velocity,
    Winch,
)

ALL_METHODS = (*METHODS, "auto")
LINKED = tuple(name for name, method in METHODS.items() if method.holds_links)


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Floats of any length between two bounds."""
    return st.floats(low, high, allow_nan=False, allow_infinity=False, allow_subnormal=False)


def powers(low: float, high: float) -> st.SearchStrategy[float]:
    """Floats of any order of magnitude between two powers of ten."""
    return numbers(low, high).map(lambda exponent: 10.0**exponent)


def vectors(size: float) -> st.SearchStrategy[tuple[float, float, float]]:
    """Any three components of at most a size."""
    return st.tuples(*[numbers(-size, size)] * 3)


def axes() -> st.SearchStrategy[tuple[float, float, float]]:
    """Directions that are not zero."""
    return vectors(2.0).filter(lambda axis: math.hypot(*axis) > 0.1)


def gravities() -> st.SearchStrategy[tuple[float, float, float]]:
    """Gravity of any size in the y-z plane, so that x is always across it; often the usual ones."""
    usual = st.sampled_from([(0.0, 0.0, -9.81), (0.0, -9.81, 0.0), (0.0, 0.0, 0.0)])
    return usual | st.tuples(st.just(0.0), numbers(-12.0, 12.0), numbers(-12.0, 12.0))


def names() -> st.SearchStrategy[str]:
    """Names as ropes and anchors may have them."""
    return st.from_regex(r"\A[A-Za-zöß][A-Za-z0-9ö_-]{0,8}\Z")


def stiffnesses(method: str) -> st.SearchStrategy[float]:
    """Stiffnesses that a method can run: up to stiff ones, or rigid links, where it solves for forces."""
    soft = numbers(10.0, 1e4)
    if method == "auto" or METHODS[method].implicit:
        soft |= powers(1.0, 12.0)
    return soft | st.just(math.inf) if method in (*LINKED, "auto") else soft


def springs(method: str) -> st.SearchStrategy[Springs]:
    """Springs between those of the seeds and much softer ones, or stiff ones for a method that can."""
    return st.builds(
        Springs,
        spring_constant=stiffnesses(method),
        node_mass=numbers(0.01, 1.0),
        spring_friction=st.just(0.0) | numbers(0.0, 1.0),
        segment_length=numbers(0.05, 1.0),
        friction=st.sampled_from(["vector", "axial"]),
        tension_only=st.booleans(),
    )


@st.composite
def materials(draw: st.DrawFn, method: str) -> Material:
    """Materials from rubber bands to cords, or steel and rods for a method that can."""
    EI = draw(st.just(0.0) | powers(-6.0, 0.0))
    bent = {}
    if EI > 0.0:
        damping = draw(st.just(0.0) | powers(-4.0, -1.0)) * EI
        axis = draw(st.sampled_from([(0.0, 0.0, 0.0), (0.0, 0.2, 0.1)]))
        bent = {"bending_damping": damping, "curvature": axis}
    return Material(
        EA=draw(stiffnesses(method)),
        mass_per_length=draw(numbers(0.01, 1.0)),
        axial_damping=draw(st.just(0.0) | numbers(0.0, 5.0)),
        EI=EI,
        friction=draw(st.sampled_from(["vector", "axial"])),
        tension_only=draw(st.booleans()),
        **bent,
    )


def shapes(segments: int, length: float) -> st.SearchStrategy[object]:
    """Shapes that fit a rope of so many segments and such a length."""
    velocity = st.just((0.0, 0.0, 0.0)) | vectors(3.0)
    start = vectors(3.0)

    def reach(low: float, high: float) -> st.SearchStrategy[tuple[float, float, float]]:
        part = numbers(-0.3 * length, 0.3 * length)
        return st.tuples(numbers(low * length, high * length), part, part)

    def add(a: tuple[float, ...], b: tuple[float, ...]) -> tuple[float, ...]:
        return tuple(p + q for p, q in zip(a, b, strict=True))

    rising = st.lists(numbers(0.2, 1.0), min_size=segments, max_size=segments)
    corners = st.lists(reach(0.1, 0.5), min_size=1, max_size=3)

    def run_on(first: tuple[float, ...], steps: list[tuple[float, ...]]) -> list[tuple[float, ...]]:
        points = [first]
        for step in steps:
            points.append(add(points[-1], step))
        return points

    straight = st.builds(Straight, start=start, velocity=velocity)
    directed = st.builds(Straight, start=start, direction=axes(), velocity=velocity)
    spanned = st.builds(
        lambda a, b, v: Straight(start=a, end=add(a, b), velocity=v),
        start,
        reach(0.5, 1.2),
        velocity,
    )
    slack = st.builds(
        lambda a, b, v: Slack(start=a, end=add(a, b), velocity=v), start, reach(0.2, 0.85), velocity
    )
    polyline = st.builds(
        lambda a, steps, v: Polyline(points=run_on(a, steps), velocity=v), start, corners, velocity
    )
    points = st.builds(
        lambda a, steps, v: Points(
            points=run_on(a, [(s * length / segments, 0.0, 0.0) for s in steps]), velocity=v
        ),
        start,
        rising,
        velocity,
    )
    hanging = st.builds(Hanging, start=start, velocity=velocity)
    return st.one_of(straight, directed, spanned, slack, polyline, points, hanging)


@st.composite
def ropes(draw: st.DrawFn, method: str, name: str = "rope", max_segments: int = 8) -> Rope:
    """A rope of springs or a material with loads and kicks, for a method."""
    segments = draw(st.integers(1, max_segments))
    made_of = draw(springs(method) | materials(method))
    length = draw(numbers(0.3, 4.0))
    own = segments * made_of.segment_length if isinstance(made_of, Springs) else length
    node = st.integers(-segments - 1, segments)
    kicks = st.lists(
        st.builds(Kick, node=node, velocity=vectors(5.0)),
        max_size=2,
        unique_by=lambda kick: kick.node % (segments + 1),
    )
    return Rope(
        name=name,
        segments=segments,
        made_of=made_of,
        length=None if isinstance(made_of, Springs) else length,
        diameter=draw(numbers(0.001, 0.05)),
        shape=draw(shapes(segments, own)),
        loads=draw(st.lists(st.builds(Load, node=node, mass=numbers(0.01, 5.0)), max_size=2)),
        kicks=draw(kicks),
    )


def motions() -> st.SearchStrategy[object]:
    """Every kind of motion."""
    velocity = st.builds(
        lambda v, a, b: Velocity(velocity=v, start=a, stop=a + b),
        vectors(3.0),
        numbers(0.0, 1.0),
        numbers(0.01, 2.0) | st.just(math.inf),
    )
    rows = st.lists(st.tuples(numbers(0.05, 1.0), vectors(1.0)), min_size=2, max_size=5)

    def table(rows: list[tuple[float, tuple[float, ...]]], interpolation: str) -> Table:
        times = [sum(step for step, _ in rows[: i + 1]) for i in range(len(rows))]
        return Table(
            times=times, positions=[place for _, place in rows], interpolation=interpolation
        )

    return st.one_of(
        st.builds(Fixed),
        velocity,
        st.builds(table, rows, st.sampled_from(["linear", "cubic"])),
        st.builds(
            Shake,
            axis=axes(),
            amplitude=numbers(0.001, 0.5),
            frequency=numbers(0.1, 10.0),
            phase=numbers(-3.0, 3.0),
        ),
        st.builds(
            Orbit, center=vectors(2.0), axis=axes(), frequency=numbers(0.1, 5.0).map(lambda f: -f)
        ),
        st.builds(Hand),
    )


def clamps() -> st.SearchStrategy[Clamp]:
    """Directions held, or turned for a while."""
    return st.builds(
        Clamp,
        direction=axes(),
        turn_axis=axes(),
        turn_rate=st.just(0.0) | numbers(-10.0, 10.0),
        stop=numbers(0.01, 0.2) | st.just(math.inf),
    )


@st.composite
def anchors(draw: st.DrawFn, rope: Rope, max_anchors: int = 3) -> list[Anchor]:
    """Anchors at different nodes of a rope, named after it."""
    nodes = draw(st.lists(st.integers(0, rope.segments), max_size=max_anchors, unique=True))
    return [
        Anchor(
            name=f"{rope.name}-{node}",
            rope=rope.name,
            node=draw(st.sampled_from([node, node - rope.nodes])),
            motion=draw(motions()),
            clamp=draw(st.none() | clamps()) if rope.bending_stiffness > 0.0 else None,
            release_time=draw(st.none() | numbers(0.0, 1.0)),
            above_ground=draw(st.booleans()),
        )
        for node in nodes
    ]


@st.composite
def winches(draw: st.DrawFn, rope: Rope, held: list[Anchor]) -> list[Winch]:
    """Winches at ends of a rope that are held."""
    ends = {"start": 0, "end": rope.segments}
    nodes = {anchor.node % rope.nodes for anchor in held}
    length = rope.length_unstretched
    free = st.none()
    return [
        Winch(
            rope=rope.name,
            end=end,
            speed=draw(numbers(-0.5, 0.5)),
            start=draw(numbers(0.0, 0.2)),
            stop=draw(numbers(0.3, 1.0) | st.just(math.inf)),
            min_length=draw(free | numbers(0.5, 0.9).map(lambda part: part * length)),
            max_length=draw(free | numbers(1.1, 2.0).map(lambda part: part * length)),
        )
        for end, node in ends.items()
        if node in nodes and draw(st.booleans())
    ]


def run_settings(methods: Sequence[str]) -> st.SearchStrategy[RunSettings]:
    """Short runs by every method and rule; steps up to a frame's for methods that allow them."""
    return st.builds(
        RunSettings,
        duration=numbers(0.02, 0.2),
        frame_rate=numbers(20.0, 120.0),
        time_step=st.just("auto") | numbers(1e-4, 5e-3) | numbers(5e-3, 5e-2),
        auto_fraction=numbers(0.1, 0.95),
        steps=st.sampled_from(["divide", "exact", "nehe"]),
        method=st.sampled_from(methods),
        tolerance=powers(-6.0, -3.0),
        spectral_radius=numbers(0.0, 1.0),
    )


@st.composite
def scenes(
    draw: st.DrawFn,
    methods: Sequence[str] = ALL_METHODS,
    max_ropes: int = 2,
    max_segments: int = 8,
) -> Scene:
    """A valid scene that one of the methods can run: ropes of springs and materials, loads, kicks, anchors
    that move, clamps, winches, air, ground, a limiter.

    Never obstacles, contact, joints, slides, forces, curves of tension, relaxation or ropes that part:
    `verification.feature_pairs` has these; nor `ring`.
    """
    settings = draw(run_settings(methods))
    explicit = settings.method == "auto" or not METHODS[settings.method].implicit
    rope_names = draw(st.lists(names(), min_size=1, max_size=max_ropes, unique=True))
    made = [draw(ropes(settings.method, name, max_segments)) for name in rope_names]
    rigid = any(rope.rigid for rope in made)
    held = {rope.name: draw(anchors(rope)) for rope in made}
    line = st.text(st.characters(codec="utf-8", exclude_characters="\r"), max_size=30)
    return Scene(
        name=draw(line.filter(len)),
        description=draw(line),
        gravity=draw(gravities()),
        run=settings,
        ropes=made,
        anchors=[anchor for group in held.values() for anchor in group],
        air=draw(
            st.none()
            | st.builds(
                Air,
                node_drag=numbers(0.0, 0.1),
                node_drag_quadratic=numbers(0.0, 0.1),
                density=numbers(0.0, 2.0),
                normal_coefficient=numbers(0.0, 2.0),
                tangential_coefficient=numbers(0.0, 0.1),
                wind=vectors(5.0),
            )
        ),
        ground=draw(
            st.none()
            | st.builds(
                Ground,
                height=numbers(-5.0, 0.0),
                repulsion=numbers(1.0, 1e3),
                friction=numbers(0.0, 1.0),
                absorption=numbers(0.0, 2.0),
            )
        ),
        limiter=draw(
            st.none()
            | st.builds(
                Limiter,
                min_stretch=numbers(0.0, 1.0),
                max_stretch=numbers(1.0, 1.5),
                passes=st.integers(1, 4),
            )
            if (explicit or settings.method in LINKED) and not rigid
            else st.none()
        ),
        winches=[
            winch
            for rope in made
            if not rope.rigid and not any(getattr(rope.made_of, "curvature", ()))
            for winch in draw(winches(rope, held[rope.name]))
        ],
    )
