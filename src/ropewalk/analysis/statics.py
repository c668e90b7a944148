"""The rest shape of a whole scene: every rope hung between its anchors at their initial places.

Between two held nodes the exact equilibrium of the masses and springs (`span.hang`); beyond the
outermost ones a tail that hangs straight down. Weight and elasticity only: no ground, no air, no
limiter, and a segment that would have to push counts as slack.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.analysis.span import hang
from ropewalk.build import Model, build
from ropewalk.scene import Scene

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class RestSpan:
    """One stretch of a rope at rest: between two held nodes, or a tail beyond the last one."""

    rope: str
    kind: str  # "span" or "tail"
    first: int  # node of the rope at which it begins
    last: int
    distance: float  # between its ends at rest [m]
    length: float  # unstretched [m]
    sag: float  # largest drop below the straight line between its ends, along gravity [m]
    lowest: float  # height of its lowest node above its first one [m], 0 or negative
    horizontal: float  # H, the constant horizontal tension [N]
    largest_tension: float  # [N]

    def __str__(self) -> str:
        where = f"nodes {self.first} to {self.last} of rope {self.rope!r}"
        if self.kind == "tail":
            return f"{where} hang free, {self.distance:.4g} m long"
        return f"{where} sag {self.sag:.4g} m over {self.distance:.4g} m"


@dataclass(frozen=True)
class Statics:
    """Rest shape of a scene."""

    positions: Floats  # (n, 3) [m]
    tension: Floats  # (s,) [N], elastic; negative where two held nodes press a segment
    reactions: Floats  # (anchors, 3) force of each anchor on the rope [N]; 0 once released
    slack: NDArray[np.bool_]  # (s,) segments without tension
    stretch: Floats  # (s,) length over rest length [1]; 1 where the rest length is 0
    spans: tuple[RestSpan, ...]
    unheld: tuple[str, ...]  # ropes that nothing holds: they have no rest shape

    @property
    def largest_tension(self) -> float:
        """Largest tension of any segment [N]; 0 where no rope is held."""
        return float(self.tension.max(initial=0.0))

    @property
    def sag(self) -> tuple[float, ...]:
        """Sag of every span between two held nodes [m]."""
        return tuple(span.sag for span in self.spans if span.kind == "span")

    def __repr__(self) -> str:
        spans = "; ".join(str(span) for span in self.spans) or "nothing is held"
        return f"Statics: {spans}; largest tension {self.largest_tension:.4g} N."


@dataclass
class _Frame:
    """Axes of gravity and the arrays that are being filled."""

    up: Floats
    weight: float  # size of gravity [m/s^2]
    x: Floats  # (n, 3)
    tension: Floats
    force: Floats  # (s, 3) force of segment j on node j [N]
    slack: NDArray[np.bool_]


def static_shape(source: Scene | Model) -> Statics:
    """Return the rest shape of a scene or a built model.

    Raises ArithmeticError when a shape does not close (not met in 20000 random chains).
    """
    model = source if isinstance(source, Model) else build(source)
    state, gravity = model.state, model.system.gravity
    weight = float(np.linalg.norm(gravity))
    s = state.stiffness.size
    frame = _Frame(
        up=-gravity / weight if weight > 0.0 else np.array([0.0, 0.0, 1.0]),
        weight=weight,
        x=np.ascontiguousarray(state.x.T),
        tension=np.zeros(s),
        force=np.zeros((s, 3)),
        slack=np.zeros(s, dtype=bool),
    )
    held = set(state.anchor_node[state.held == 1].tolist())
    spans: list[RestSpan] = []
    unheld: list[str] = []
    for rope in model.layout.ropes:
        nodes = sorted(node for node in held if rope.start <= node <= rope.end)
        if not nodes:
            unheld.append(rope.name)
            continue
        if nodes[0] > rope.start:
            spans.append(_tail(model, frame, rope, nodes[0], rope.start))
        for first, last in itertools.pairwise(nodes):
            spans.append(_span(model, frame, rope, first, last))
        if nodes[-1] < rope.end:
            spans.append(_tail(model, frame, rope, nodes[-1], rope.end))
    return Statics(
        positions=frame.x,
        tension=frame.tension,
        reactions=_reactions(model, frame),
        slack=frame.slack,
        stretch=_stretch(model, frame, unheld),
        spans=tuple(spans),
        unheld=tuple(unheld),
    )


def _span(model: Model, frame: _Frame, rope: Any, first: int, last: int) -> RestSpan:
    state, segments = model.state, slice(first, last)
    ends = frame.x[last] - frame.x[first]
    rise = float(ends @ frame.up)
    level = ends - rise * frame.up
    across = float(np.linalg.norm(level))
    direction = level / across if across > 0.0 else np.zeros(3)
    stiffness, length = state.stiffness[segments], state.rest_length[segments]
    weights = state.mass[first + 1 : last] * frame.weight
    hung = hang(weights, stiffness, length, across, rise)
    steps = hung.along[:, None] * direction + hung.upward[:, None] * frame.up
    start, end = frame.x[first].copy(), frame.x[last].copy()
    frame.x[first + 1 : last] = start + np.cumsum(steps, axis=0)[:-1]
    tension = hung.tension
    force = hung.horizontal * direction + hung.vertical[:, None] * frame.up
    if last - first == 1 and tension[0] < 0.0 and model.system.slack_floor[first] == 0.0:
        tension, force = np.zeros(1), np.zeros((1, 3))
    frame.tension[segments], frame.force[segments] = tension, force
    frame.slack[segments] = np.abs(tension) <= 1e-12 * float(np.abs(tension).max(initial=0.0))
    heights = (frame.x[first : last + 1] - start) @ frame.up
    chord = _chord(hung.along, across, rise)
    return RestSpan(
        rope=rope.name,
        kind="span",
        first=first - rope.start,
        last=last - rope.start,
        distance=float(np.linalg.norm(end - start)),
        length=float(length.sum()),
        sag=float((chord - heights).max()),
        lowest=float(heights.min()),
        horizontal=float(hung.horizontal),
        largest_tension=float(tension.max()),
    )


def _chord(along: Floats, across: float, rise: float) -> Floats:
    """Height of the straight line between the ends above each node; the lower end if plumb."""
    if across == 0.0:
        return np.full(along.size + 1, min(rise, 0.0))
    passed = np.concatenate([[0.0], np.cumsum(along)])
    return np.asarray(passed * (rise / across))


def _tail(model: Model, frame: _Frame, rope: Any, held: int, tip: int) -> RestSpan:
    """Hang what lies beyond a held node straight down; without weight it stays as it starts."""
    state = model.state
    step = 1 if tip > held else -1
    nodes = np.arange(held + step, tip + step, step)
    segments = nodes - 1 if step > 0 else nodes
    carried = np.cumsum(state.mass[nodes][::-1])[::-1] * frame.weight
    size = state.rest_length[segments] + carried / state.stiffness[segments]
    start = frame.x[held].copy()
    if frame.weight > 0.0:
        frame.x[nodes] = start - np.cumsum(size)[:, None] * frame.up
        frame.tension[segments] = carried
        frame.force[segments] = (-step) * carried[:, None] * frame.up
    else:
        frame.slack[segments] = True
    distance = float(np.linalg.norm(frame.x[tip] - start))
    return RestSpan(
        rope=rope.name,
        kind="tail",
        first=held - rope.start,
        last=tip - rope.start,
        distance=distance,
        length=float(state.rest_length[segments].sum()),
        sag=0.0,
        lowest=-distance if frame.weight > 0.0 else 0.0,
        horizontal=0.0,
        largest_tension=float(carried[0]),
    )


def _reactions(model: Model, frame: _Frame) -> Floats:
    """Force of each anchor: what its segments and the weight of its own node leave open."""
    state = model.state
    reactions = np.zeros((state.held.size, 3))
    for row, node in enumerate(state.anchor_node):
        if state.held[row] != 1:
            continue
        force = state.mass[node] * model.system.gravity
        if node < frame.force.shape[0]:
            force = force + frame.force[node]
        if node > 0:
            force = force - frame.force[node - 1]
        reactions[row] = -force
    return reactions


def _stretch(model: Model, frame: _Frame, unheld: list[str]) -> Floats:
    rest = model.state.rest_length
    size: Floats = np.linalg.norm(np.diff(frame.x, axis=0), axis=1)
    stretch: Floats = np.divide(size, rest, out=np.ones_like(size), where=rest > 0.0)
    for name in unheld:
        rope = model.layout.span(name)
        stretch[rope.first : rope.last] = 1.0
    return stretch


def catenary(length: float, across: float, rise: float = 0.0) -> tuple[float, float, float]:
    """Return the inextensible catenary between two points: a, drop and first end's tension.

    Args:
        length: of the cord [m], more than the distance of its ends.
        across: horizontal distance of the ends [m].
        rise: how much higher the second end is [m].

    Returns:
        a = H/w [m], the depth of the lowest point below the first end [m], and the tension over
        the weight per length at the first end [m]; from sqrt(L^2 - Y^2) = 2 a sinh(X / 2a),
        x0 = X/2 - a atanh(Y/L) (Irvine 1981, sec. 1.2). Raises ValueError for a taut cord.
    """
    if not length > math.hypot(across, rise) or not across > 0.0:
        raise ValueError("the cord must be longer than the distance of its ends, and these apart")
    target = math.sqrt(length**2 - rise**2)
    low, high = across / 1400.0, across
    while 2.0 * high * math.sinh(across / (2.0 * high)) > target:
        high *= 2.0
    for _ in range(200):
        a = 0.5 * (low + high)
        if 2.0 * a * math.sinh(across / (2.0 * a)) > target:
            low = a
        else:
            high = a
    lowest = across / 2.0 - a * math.atanh(rise / length)
    depth = a * (math.cosh(lowest / a) - 1.0) if 0.0 < lowest < across else max(-rise, 0.0)
    return a, depth, a * math.cosh(lowest / a)
