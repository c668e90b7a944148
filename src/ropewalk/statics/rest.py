"""The shape in which a scene is at rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core import arrays
from ropewalk.core.arrays import Floats
from ropewalk.laws.acting import borne
from ropewalk.laws.node_law import Rest
from ropewalk.lowering import Model, build
from ropewalk.lowering.touching import Contacts
from ropewalk.scene import Scene
from ropewalk.scene.obstacles import thinnest
from ropewalk.statics.balance import Balance
from ropewalk.statics.balanced import tipping, turned_to_rest
from ropewalk.statics.creep import creep
from ropewalk.statics.hung import hung
from ropewalk.statics.left_over import left_over
from ropewalk.statics.newton import Found, settle
from ropewalk.statics.pressing import Watch, speared_words
from ropewalk.statics.pulleys import Pulley, pulleys
from ropewalk.statics.refusal import (
    refuse_impossible,
    refuse_loose,
    undetermined_ropes,
    unheld_ropes,
    unloaded,
    unseen_words,
)
from ropewalk.statics.rope_presses import presses_of_ropes
from ropewalk.statics.spans import RestSpan, rest_spans
from ropewalk.statics.tied import tied_nodes
from ropewalk.statics.touches import Seat, Touch, seats, touches
from ropewalk.statics.wraps import Wrap, going_on_words, on_the_way_words, sliding_words, wraps
from ropewalk.words.annotations import unquoted
from ropewalk.words.prefixes import prefixed
from ropewalk.words.pushes import largest_push, pull_told

_SOFT = 1e-6  # compliance of rigid links on the way to their shape, in the model's units [1]
_PUSHED = 1e-7  # of the unit of force: what counts as compression [1]
_LARGE = 100_000  # nodes from which on the closed form is not polished
# Newton steps on obstacles, when asked for and for a check: 15 000 take a rope from a table to a floor.
_PATIENCE, _CHECKED = 18_000, 2500
_GOES_ON = "there is no rest: the ropes slide or fall on and on. Give more friction, or an anchor"
_CROWDED = (
    "no shape of rest was found: ropes touch in more places than there is room for, or come through each "
    "other; draw them farther apart, or take fewer segments"
)
_FOLD = -0.99  # cosine of the turn from which on a node counts as folded, 172 degrees [1]
_OPENING = 0.6  # of a segment: the push aside that opens a fold [1]
_NUDGE = 1e-3  # of a segment: the push aside that tells whether a compressed shape is stable [1]


class NoRest(ArithmeticError):  # noqa: N818 - it is what happened, not a mistake
    """No shape of rest was found."""


@unquoted
@dataclass(frozen=True)
class Statics:
    """The rest shape of a scene, as the masses and segments have it: the exact discrete solution."""

    positions: Floats  # (n, 3) [m]
    tension: Floats  # (s,) [N]; negative where a segment is pressed
    elastic_tension: Floats  # (s,) its spring's share [N]
    reactions: Floats  # (anchors, 3) force of each anchor on the rope [N]; 0 once released
    slack: NDArray[np.bool_]  # (s,) segments without tension
    stretch: Floats  # (s,) length over rest length [1]; 1 where the rest length is 0
    grounded: NDArray[np.bool_]  # (n,) nodes on the ground
    spans: tuple[RestSpan, ...]
    unheld: tuple[str, ...]  # ropes that no anchor holds
    residual: float  # largest force that is left on a free node [N]
    left: Floats  # (s,) the same of the segment's rope and those bound to it [N], see `left_over`
    gap: float  # largest difference between a segment's length and that of its tension [m]
    steps: int  # Newton steps; 0 where the closed form is exact already
    solved: bool  # whether it is at rest, to rounding
    wraps: tuple[Wrap, ...] = ()  # where ropes lie on obstacles
    contacts: Contacts | None = None  # of single nodes
    touches: tuple[Touch, ...] = ()  # where ropes lie on each other
    seats: tuple[Seat, ...] = ()  # where slides are
    pulleys: tuple[Pulley, ...] = ()  # held still, and what turns them
    trouble: str = ""  # why ropes that touch obstacles or each other are not at rest
    memory: Any = None  # what laws of nodes carry, as `State.memory`; None where nothing does

    @property
    def searched(self) -> bool:
        """Whether rest was looked for: not by a check of very many nodes under more than their weight."""
        return self.solved or self.steps > 0 or len(self.positions) <= _LARGE

    @property
    def largest_tension(self) -> float:
        """Largest tension of any segment [N]; 0 where no rope is held, or where it is rounding."""
        left = self.residual if self.solved else 0.0
        return pull_told(float(self.tension.max(initial=0.0)), left)

    @property
    def largest_push(self) -> float:
        """Largest push of any segment [N]; 0 where none is pressed."""
        return largest_push(self.tension, self.residual)

    @property
    def by_friction(self) -> bool:
        """Whether friction holds ropes where they touch or slide, so that there are many shapes of rest."""
        rubs = [wrap.friction for wrap in self.wraps] + [touch.friction for touch in self.touches]
        return any(most > 0.0 for most in (*rubs, *(seat.most for seat in self.seats)))

    @property
    def sag(self) -> tuple[float, ...]:
        """Sag of every span between two held nodes [m]."""
        return tuple(span.sag for span in self.spans if span.kind == "span")

    def __repr__(self) -> str:
        places = self.spans or self.wraps
        spans = "; ".join(map(str, places)) or "nothing is held"
        push = f", largest push {prefixed(self.largest_push, 'N')}" if self.largest_push else ""
        return f"Statics: {spans}; largest tension {prefixed(self.largest_tension, 'N')}{push}."


def static_shape(source: Scene | Model, *, strict: bool = True) -> Statics:
    """Return the rest shape of a scene or a built model, all anchors at their initial places.

    With `strict` off what Newton's method came to is returned even when it is not at rest, and more
    than 100000 nodes on which more than their weight acts hang as without that; look at `solved`. Ropes that
    touch each other or slide are then left where they are.

    Ropes that nothing gives a shape (not held, or slack without weight) are left where they are,
    without tension; `checked_shape` refuses them. The stretch limiter takes no part.

    Raises SceneError for rigid links that do not reach, NoRest when Newton's method finds no shape.
    """
    model = source if isinstance(source, Model) else build(source, stepped=False)
    if strict:
        model = turned_to_rest(model, _looked_at)
    balance = Balance(model)
    unseen = balance.coupled.acts and not strict
    left = [rope.name for rope in model.layout.ropes] if unseen else undetermined_ropes(model)
    for name in left:
        balance.leave_out(model.layout.span(name))
    found = _find(model, balance, patient=strict)
    if strict and not found.at_rest:
        raise NoRest(_complaint(model, balance, found))
    rest = _statics(model, balance, found, left, unseen=unseen)
    tips = tipping(model, _looked_at) if strict else frozenset()
    bodies = tuple(replace(body, tips=w in tips) for w, body in enumerate(rest.pulleys))
    return replace(rest, pulleys=bodies) if tips else rest


def _looked_at(model: Model) -> tuple[Floats, tuple[Pulley, ...]] | None:
    """Return the places of ropes at rest (3, n) [m] with bodies as they are turned, and what turns those."""
    balance = Balance(model)
    for name in undetermined_ropes(model):
        balance.leave_out(model.layout.span(name))
    found = _find(model, balance, patient=True)
    if not found.at_rest:
        return None
    return found.x, pulleys(model, balance.state.memory, found.x)


def checked_shape(source: Scene | Model) -> Statics:
    """Return the rest shape as `static_shape`, but refuse a scene that has none or many.

    Raises SceneError with what is missing, and what `static_shape` raises.
    """
    model = source if isinstance(source, Model) else build(source, stepped=False)
    refuse_impossible(model)
    found = static_shape(model)
    refuse_loose(model, found.positions, found.tension, found.left)
    return found


def _find(model: Model, balance: Balance, *, patient: bool) -> Found:
    """Solve from the hung shape, or from the scene's own where other laws decide."""
    if balance.coupled.acts and not patient:
        return _evaluated(balance, model.state.x.copy(), np.zeros(model.state.x.shape[1] - 1))
    if model.scene.obstacles or balance.coupled.acts:
        return _find_by_creeping(model, balance, patient=patient)
    x, tension = hung(model)
    if balance.number is not None:
        x = _tied_start(model, x)
    own = (
        balance.number is not None
        or _grounded(model, x).any()
        or Rest.HOLDS in balance.rests
        or balance.bends
    )
    if x.shape[1] > _LARGE:
        hangs = _evaluated(balance, x, tension)
        if hangs.at_rest and not own:
            return _stable(model, balance, hangs)
        if not patient:
            return hangs
    if not own:
        found = settle(balance, x, tension)
        if found.at_rest:
            return _stable(model, balance, found)
    starts = [model.state.x.copy(), x] if own else [x, model.state.x.copy()]
    best = None
    for start in starts:
        found = _soft_first(balance, start)
        if found.at_rest:
            return _stable(model, balance, found)
        best = found if best is None or found.error < best.error else best
    assert best is not None
    return best


def _find_by_creeping(model: Model, balance: Balance, *, patient: bool) -> Found:
    """Let the ropes creep from the scene's own shape, rigid links with a little stretch at first."""
    x = model.state.x.copy()
    if x.shape[1] > _LARGE and not patient:
        return _evaluated(balance, x, np.zeros(x.shape[1] - 1))
    thick = float(model.system.node.obstacle.thickness.max())
    least = min(map(thinnest, model.scene.obstacles), default=math.inf) + thick
    watch, balance.patient = Watch(model, balance), patient
    patience = _PATIENCE if patient else _CHECKED
    crept = creep(balance, x, least, patience, watch.see, watch.passes)
    balance.goes_on, balance.slid = crept.goes_on, crept.slid
    balance.patient = patient or crept.found.steps <= patience  # else settling takes as many steps
    if watch.across is not None and not (crept.found.at_rest or crept.goes_on or crept.slid):
        balance.speared = watch.across.words(model)
        return crept.found._replace(error=np.inf)
    balance.pressed = watch.at_last(crept.found.x)
    if crept.found.at_rest and balance.pressed is None:
        balance.speared = speared_words(model, balance, crept.found.x)
    wrong = balance.pressed is not None or balance.speared
    return crept.found._replace(error=np.inf) if wrong else crept.found


def _tied_start(model: Model, x: Floats) -> Floats:
    """Return the places (3, n) with ropes that are tied where the scene has them: they do not hang alone."""
    for rope in model.layout.ropes:
        if tied_nodes(model, rope):
            x[:, rope.first : rope.last + 1] = model.state.x[:, rope.first : rope.last + 1]
    return x


def _evaluated(balance: Balance, x: Floats, tension: Floats) -> Found:
    """Return a shape with what is wrong with it.

    Newton's steps would take minutes to shuffle about the rounding of the places of so many nodes.
    """
    error = balance.error(x, tension)
    return Found(x, tension, error, balance.allowed(x, tension), 0)


def _soft_first(balance: Balance, x: Floats) -> Found:
    """Solve with rigid links that stretch a little, then as they are."""
    rigid = balance.live & (balance.soft == 0.0)
    soft = balance.soft
    least = _SOFT * balance.length / balance.force
    balance.soft = np.where(rigid, least, soft)
    tension = np.maximum(balance.elastic(x), 0.0)
    found = settle(balance, x, tension, 1.0)
    if rigid.any():
        balance.soft = soft
        found = settle(balance, found.x, found.tension)
    return found


def _stable(model: Model, balance: Balance, found: Found) -> Found:
    """Push a compressed or folded shape aside: an unstable one then finds its way to a stable one."""
    folds = _folds(balance, found.x)
    if not folds.any() and not (found.tension[balance.live] < -_PUSHED * balance.force).any():
        return found
    noise = np.random.default_rng(0).normal(size=found.x.shape)  # the same for every call
    size = np.full(balance.nodes, _NUDGE * balance.length)
    for rope in model.layout.ropes:
        if folds[rope.first : rope.last + 1].any():
            size[rope.first : rope.last + 1] = (
                _OPENING * balance.rest[rope.first : rope.last].mean()
            )
    push = size * noise
    if balance.number is not None:  # what is tied is pushed as one
        push = push[:, np.unique(balance.number, return_index=True)[1]][:, balance.number]
    again = settle(
        balance,
        found.x + np.where(balance.free, push, 0.0),
        np.maximum(found.tension, 0.0),
        1.0,
    )
    return again if again.at_rest else found


def _folds(balance: Balance, x: Floats) -> NDArray[np.bool_]:
    """Return at which nodes (n,) a rope with bending stiffness is folded back in a shape x (3, n) [m].

    There is no side to which it would open by itself, and near it the equations lead back to the fold.
    """
    folds = np.zeros(balance.nodes, dtype=bool)
    if balance.bends:
        t, _ = balance.directions(x)
        stiff = balance.state.bending_stiffness[1:-1] > 0.0
        turns = (t[:, :-1] * t[:, 1:]).sum(axis=0) < _FOLD
        folds[1:-1] = stiff & turns & balance.live[:-1] & balance.live[1:]
    return folds


def _grounded(model: Model, x: Floats) -> NDArray[np.bool_]:
    """Return which nodes lie on the ground, (n,); what lies on obstacles is told by `wraps`."""
    found = borne(model.system, x) & (model.state.mass > 0.0)
    if model.scene.obstacles and model.scene.ground is None:
        found[:] = False
    return np.asarray(found)


def _statics(
    model: Model, balance: Balance, found: Found, left_out: Sequence[str], *, unseen: bool
) -> Statics:
    unheld, x, tension = unheld_ropes(model), found.x, found.tension
    left = balance.imbalance(x, tension)
    _, size = balance.directions(x)
    rest = model.state.rest_length
    stretch = np.divide(size, rest, out=np.ones_like(size), where=rest > 0.0)
    carried = balance.carried(x, tension)
    over = left_over(model, left, balance.free)
    slack = (model.state.stiffness > 0.0) & unloaded(carried, over)
    for name in left_out:  # they stay as drawn
        span = model.layout.span(name)
        stretch[span.first : span.last] = 1.0
    for name in unheld:
        span = model.layout.span(name)
        slack[span.first : span.last] = False
    reactions = np.zeros((model.state.held.size, 3))
    for row, node in enumerate(model.state.anchor_node):
        if model.state.held[row] == 1:
            reactions[row] = 0.0 - left[:, node]
    positions = np.ascontiguousarray(x.T)
    lie, contacts = _lie(model, balance, x, tension)
    obstacles, held = bool(model.scene.obstacles), balance.state.memory
    spans = rest_spans(model, positions, carried, over)
    return Statics(
        positions=positions,
        tension=carried,
        elastic_tension=tension,
        reactions=reactions,
        slack=slack,
        stretch=stretch,
        grounded=_grounded(model, x),
        spans=tuple(span for span in spans if span.rope not in left_out),
        unheld=unheld,
        residual=float(over.max(initial=0.0)),
        left=over,
        gap=float(np.abs(balance.gap(x, tension)).max(initial=0.0)),
        steps=found.steps,
        solved=found.at_rest and not unseen,
        wraps=lie,
        contacts=contacts,
        touches=() if unseen else touches(model, held, x, tension),
        seats=() if unseen else seats(model, held, x, tension),
        pulleys=pulleys(model, held, x),
        trouble=unseen_words(model) if unseen else _trouble(model, balance, found),
        memory=arrays.copy(held) if obstacles or balance.coupled.acts else None,
    )


def _lie(
    model: Model, balance: Balance, x: Floats, tension: Floats
) -> tuple[tuple[Wrap, ...], Contacts]:
    """Return where ropes lie on obstacles at places (3, n) [m], and the contacts."""
    others, force = balance.others(x), balance.contact_force()
    ropes = presses_of_ropes(model, balance.state.memory)
    return wraps(model, np.ascontiguousarray(x.T), tension, force, others - force, ropes)


def _trouble(model: Model, balance: Balance, found: Found) -> str:
    """Return why a scene with obstacles is not at rest; "" where it is."""
    return _complaint(model, balance, found) if model.scene.obstacles and not found.at_rest else ""


def _complaint(model: Model, balance: Balance, found: Found) -> str:
    left = np.where(balance.free, balance.imbalance(found.x, found.tension), 0.0)
    node = int(np.argmax(np.abs(left).max(axis=0)))
    rope, number = model.layout.rope_of(node)
    gap = np.abs(balance.gap(found.x, found.tension)).max(initial=0.0)
    remedy = "Give the scene a shape nearer to rest, or softer ropes"
    if balance.coupled.fails:
        return _CROWDED
    if model.scene.obstacles or balance.coupled.acts:
        if balance.pressed is not None:
            return str(balance.pressed.words(model))
        if balance.speared:
            return balance.speared
        lie, _ = _lie(model, balance, found.x, found.tension)
        if balance.goes_on:
            return going_on_words(lie) if model.scene.obstacles else _GOES_ON
        if balance.slid > 0.0:
            return on_the_way_words(lie, balance.slid, patient=balance.patient)
        remedy = sliding_words(lie) or remedy
    return (
        f"no shape of rest was found in {found.steps} steps: at node {number} of rope {rope!r} "
        f"{np.abs(left[:, node]).max():.3g} N are left, and segments are {gap:.3g} m off their length. "
        f"{remedy}"
    )
