"""Ropes of rigid links: what they need to be run, and a start in which every link has its length."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats, Ints, State
from ropewalk.core.elimination import points_of
from ropewalk.laws.links import solve_links
from ropewalk.lowering import Model
from ropewalk.lowering.layout import Layout
from ropewalk.methods.registry import METHODS
from ropewalk.scene import SceneError
from ropewalk.scene.faults import Fault
from ropewalk.theory.borrowed import load_scipy

TAUT = 1e-9  # a span this close to its rope's length leaves no room [1]
_OFF = 0.05  # a start this much too long or short is a mistake, not a curve cut into chords [1]
_ITERATIONS = 50
_EXACT = 1e-13  # length error of the start that rounding may leave [1]
_LITTLE = 1e-12  # [1] added to the pivots of links that joints couple, over the largest
_EPSILON = float(np.finfo(np.float64).eps)


class Reach(NamedTuple):
    """A rope of rigid links between two neighbouring held nodes."""

    rope: str
    anchors: tuple[str, str]
    distance: float  # [m]
    length: float  # at most [m]
    stretches: bool = False  # as far as a limiter allows

    def __str__(self) -> str:
        first, last = self.anchors
        at_most = " at the limiter's max_stretch" if self.stretches else ", which does not stretch"
        return (
            f"anchors {first!r} and {last!r} are {self.distance:.6g} m apart, with {self.length:.6g} m "
            f"of rope {self.rope!r} between them{at_most}"
        )


def has_links(state: State) -> bool:
    """Tell whether any segment is a rigid link."""
    return bool(np.isinf(state.stiffness).any())


def reaches(layout: Layout, state: State, x: Floats, longest: float = math.inf) -> Iterator[Reach]:
    """Yield every part of a rope between two held nodes that cannot reach as far as it likes.

    At places `x` (3, n) [m]; of rigid links, or of any segments that stretch to `longest` [1] at most.
    """
    rows = {int(node): row for row, node in enumerate(state.anchor_node) if state.held[row]}
    for span in layout.ropes:
        nodes = sorted(node for node in rows if span.start <= node <= span.end)
        for a, b in itertools.pairwise(nodes):
            rigid = bool(np.isinf(state.stiffness[a]))
            most = 1.0 if rigid else longest
            if most < math.inf:
                names = layout.anchor_names[rows[a]], layout.anchor_names[rows[b]]
                distance = float(np.linalg.norm(x[:, b] - x[:, a]))
                length = most * float(state.rest_length[a:b].sum())
                yield Reach(span.name, names, distance, length, not rigid)


def with_links(model: Model) -> Model:
    """Return the model with its rigid links at their lengths; itself where it has none.

    Places and velocities are changed as little as the lengths demand, in the metric of the masses: what
    an impact would do to the velocities. Raises SceneError for a method that cannot hold lengths, for
    anchors farther apart than the rope reaches, and for a shape that does not have the rope's length.
    """
    if not has_links(model.state):
        return model
    _refuse_method(model)
    model = replace(model, state=arrays.copy(model.state))
    _refuse_spans(model)
    _refuse_shapes(model)
    _fit_links(model)
    fit_velocities(model)
    return model


def _number(model: Model, rope: str) -> int:
    return model.scene.rope_index(rope)


def _refuse_method(model: Model) -> None:
    if METHODS[model.plan.method].holds_links:
        return
    names = [rope.name for rope in model.scene.ropes if rope.rigid]
    able = ", ".join(name for name, method in METHODS.items() if method.holds_links)
    rule = f"cannot hold the lengths of rigid links (rope {names[0]!r}); methods that can: {able}"
    raise SceneError([Fault("run.method", model.plan.method, rule)])


def _refuse_spans(model: Model) -> None:
    faults = []
    for reach in reaches(model.layout, model.state, model.state.x):
        if reach.distance < (1.0 - TAUT) * reach.length:
            continue
        short = reach.distance > (1.0 + TAUT) * reach.length
        why = (
            "there is no such shape" if short else "taut like that, nothing determines its tension"
        )
        rule = f"{reach}: {why}; give it more length or a finite stiffness"
        faults.append(Fault(f"rope[{_number(model, reach.rope)}]", reach.rope, rule))
    if faults:
        raise SceneError(faults)


def _gaps(state: State, one_way: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Return unit vectors (3, s) and what each rigid link is too long [m], (s,); 0 for slack ones."""
    d = np.diff(state.x, axis=1)
    r = np.sqrt((d * d).sum(axis=0))
    gap = np.where(np.isinf(state.stiffness), r - state.rest_length, 0.0)
    gap[one_way & (gap < 0.0)] = 0.0
    return d / np.maximum(r, 1e-300), gap


def _refuse_shapes(model: Model) -> None:
    state, faults = model.state, []
    _, gap = _gaps(state, model.system.slack_floor == 0.0)
    for number, (rope, span) in enumerate(zip(model.scene.ropes, model.layout.ropes, strict=True)):
        if rope.shape.kind == "slack":
            continue
        own, length = float(gap[span.start : span.end].sum()), rope.length_unstretched
        if abs(own) > _OFF * length:
            rule = (
                f"is {length + own:.6g} m long, but the rope is {length:.6g} m and does not stretch; "
                'take kind "slack" or "hanging", or points a segment apart'
            )
            faults.append(Fault(f"rope[{number}].shape", rope.shape.kind, rule))
    if faults:
        raise SceneError(faults)


def _equations(inverse_mass: Floats, t: Floats, active: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Return diagonal and off-diagonal (s,) of what impulses along the links do to their lengths."""
    both = inverse_mass[:-1] + inverse_mass[1:]
    diagonal = np.where(active & (both > 0.0), both, 1.0)
    upper = np.zeros_like(diagonal)
    turn = (t[:, :-1] * t[:, 1:]).sum(axis=0)
    upper[:-1] = np.where(active[:-1] & active[1:], -inverse_mass[1:-1] * turn, 0.0)
    return diagonal, upper


def _shift(state: State, number: Ints | None, t: Floats, impulse: Floats) -> Floats:
    """Return what impulses along the links do to the nodes, (3, n); `number` as in `impulses`."""
    pull = t * impulse
    moved = np.zeros((3, state.inverse_mass.size))
    moved[:, :-1] += pull
    moved[:, 1:] -= pull
    if number is None:
        return moved * state.inverse_mass
    over = _over_mass(state, number)
    together = np.stack([np.bincount(number, row) for row in moved])
    found: Floats = (together * over)[:, number]
    return found


def _over_mass(state: State, number: Ints) -> Floats:
    """Return one over the mass of the points, (m,); 0 for held ones."""
    mass = np.bincount(number, state.mass)
    held = np.bincount(number, state.inverse_mass == 0.0) > 0.0
    found: Floats = np.divide(1.0, mass, out=np.zeros_like(mass), where=~held)
    return found


def _impulses(
    state: State, number: Ints | None, t: Floats, active: NDArray[np.bool_], gap: Floats
) -> Floats:
    """Return the impulses along the active links that take up the gaps, (s,).

    Nodes that joints tie have the same `number` (n,), or it is None: then links are coupled to the next ones
    only.
    """
    if number is None:
        diagonal, upper = _equations(state.inverse_mass, t, active)
        found = gap.copy()
        solve_links(diagonal, upper, found)
        return found
    load_scipy()
    from scipy import sparse
    from scipy.sparse.linalg import splu

    over, s = _over_mass(state, number), gap.size
    ends, rows = np.concatenate((number[:-1], number[1:])), np.tile(np.arange(s), 2)
    signed = np.concatenate((-t * active, t * active), axis=1)
    columns = (3 * ends + np.arange(3)[:, None]).ravel()
    shape = (s, 3 * over.size)
    pull = sparse.csr_array((signed.ravel(), (np.tile(rows, 3), columns)), shape=shape)
    matrix = (
        pull @ sparse.dia_array((np.repeat(over, 3)[None], [0]), shape=(shape[1],) * 2) @ pull.T
    )
    pivots = matrix.diagonal()
    little = _LITTLE * pivots.max(initial=0.0)  # of links that say the same as others
    more = sparse.dia_array((np.where(pivots > little, little, 1.0)[None], [0]), shape=(s, s))
    factors = splu(sparse.csc_array(matrix + more))
    return np.asarray(factors.solve(np.where(active, gap, 0.0)))


def fit_lengths(
    state: State,
    gaps: Callable[[], tuple[Floats, Floats, NDArray[np.bool_]]],
    number: Ints | None = None,
) -> int | None:
    """Move the nodes until no segment has a gap; return the worst one, None when all fit.

    `gaps` returns unit vectors (3, s), what each segment is too long [m] and which lengths count, (s,).
    Nodes that joints tie have the same `number`, (n,).
    Newton's method: Ryckaert, Ciccotti & Berendsen 1977, J. Comput. Phys. 23:327.
    """
    exact = _EXACT * state.rest_length + 8.0 * _EPSILON * np.abs(state.x).max(initial=0.0)
    for _ in range(_ITERATIONS):
        t, gap, counts = gaps()
        if (np.abs(gap) <= exact).all():
            return None
        with np.errstate(invalid="ignore", over="ignore"):
            step = _shift(state, number, t, _impulses(state, number, t, counts, gap))
        if not np.isfinite(step).all():
            break
        state.x[...] += step
    return int(np.nanargmax(np.abs(gaps()[1])))


def points(model: Model) -> Ints | None:
    """Return the number of every node's point, (n,); None where nothing is tied."""
    joints = model.system.joints
    if not joints.member.size:
        return None
    return points_of(joints, model.state.tied, model.layout.nodes)


def _fit_links(model: Model) -> None:
    one_way = model.system.slack_floor == 0.0

    def gaps() -> tuple[Floats, Floats, NDArray[np.bool_]]:
        t, gap = _gaps(model.state, one_way)
        return t, gap, gap != 0.0

    worst = fit_lengths(model.state, gaps, points(model))
    if worst is None:
        return
    rope, _ = model.layout.rope_of(worst)
    rule = (
        "cannot be bent so that every link has its length; draw it less straight, "
        'or take kind "slack" or "hanging"'
    )
    number = _number(model, rope)
    raise SceneError([Fault(f"rope[{number}].shape", model.scene.ropes[number].shape.kind, rule)])


def fit_velocities(model: Model) -> None:
    """Take out of the velocities what would change a length: a plastic impact (Moreau 1988)."""
    state, one_way = model.state, model.system.slack_floor == 0.0
    d = np.diff(state.x, axis=1)
    r = np.sqrt((d * d).sum(axis=0))
    t = d / np.maximum(r, 1e-300)
    rate = (np.diff(state.v, axis=1) * t).sum(axis=0)
    active = np.isinf(state.stiffness) & (~one_way | (r >= (1.0 - TAUT) * state.rest_length))
    if not rate[active].any():
        return
    for _ in range(active.size + 1):  # the last without any that is let go of
        impulse = _impulses(state, points(model), t, active, np.where(active, rate, 0.0))
        pushing = active & one_way & (impulse < 0.0)
        if not pushing.any():
            break
        active &= ~pushing
    state.v[...] += _shift(state, points(model), t, impulse)
