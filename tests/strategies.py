"""Random valid scenes for property tests: small enough to simulate in a moment."""

from __future__ import annotations

import math

from hypothesis import strategies as st

from ropewalk.scene import (
    Air,
    Anchor,
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

METHODS = ("euler", "semi-implicit-euler", "verlet", "heun", "rk4")


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Floats of any length between two bounds."""
    return st.floats(low, high, allow_nan=False, allow_infinity=False, allow_subnormal=False)


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


def springs() -> st.SearchStrategy[Springs]:
    """Springs between those of the seeds and much softer ones."""
    return st.builds(
        Springs,
        spring_constant=numbers(10.0, 1e4),
        node_mass=numbers(0.01, 1.0),
        spring_friction=st.just(0.0) | numbers(0.0, 1.0),
        segment_length=numbers(0.05, 1.0),
        friction=st.sampled_from(["vector", "axial"]),
        tension_only=st.booleans(),
    )


def materials() -> st.SearchStrategy[Material]:
    """Materials from rubber bands to cords."""
    return st.builds(
        Material,
        EA=numbers(10.0, 1e4),
        mass_per_length=numbers(0.01, 1.0),
        axial_damping=st.just(0.0) | numbers(0.0, 5.0),
        friction=st.sampled_from(["vector", "axial"]),
        tension_only=st.booleans(),
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
def ropes(draw: st.DrawFn, name: str = "rope", max_segments: int = 8) -> Rope:
    """A rope of springs or a material with loads and kicks."""
    segments = draw(st.integers(1, max_segments))
    made_of = draw(springs() | materials())
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


def run_settings() -> st.SearchStrategy[RunSettings]:
    """Short runs by every method and rule."""
    return st.builds(
        RunSettings,
        duration=numbers(0.02, 0.2),
        frame_rate=numbers(20.0, 120.0),
        time_step=st.just("auto") | numbers(1e-4, 5e-3),
        auto_fraction=numbers(0.1, 0.95),
        steps=st.sampled_from(["divide", "exact", "nehe"]),
        method=st.sampled_from(METHODS),
    )


@st.composite
def scenes(draw: st.DrawFn, max_ropes: int = 2, max_segments: int = 8) -> Scene:
    """A valid scene with anything in it that a scene can have."""
    rope_names = draw(st.lists(names(), min_size=1, max_size=max_ropes, unique=True))
    made = [draw(ropes(name, max_segments)) for name in rope_names]
    held = {rope.name: draw(anchors(rope)) for rope in made}
    line = st.text(st.characters(codec="utf-8", exclude_characters="\r"), max_size=30)
    return Scene(
        name=draw(line.filter(len)),
        description=draw(line),
        gravity=draw(gravities()),
        run=draw(run_settings()),
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
        ),
        winches=[winch for rope in made for winch in draw(winches(rope, held[rope.name]))],
    )
