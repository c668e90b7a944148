"""Where ropes at rest lie on obstacles, what friction carries there, and what it could."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.obstacle import Obstacles
from ropewalk.laws.polygon import tilted
from ropewalk.lowering import Model, Span
from ropewalk.lowering.coarse_turns import FINE, CoarseTurn, coarse_turn
from ropewalk.lowering.touching import SLIPS, Contacts, contacts_at, stretches
from ropewalk.statics.grooves import as_of_one, beside
from ropewalk.statics.standing import standing_obstacles
from ropewalk.words.prefixes import prefixed

MANY = (
    "with friction there are many shapes of rest; this is the one to which the drawn shape creeps, without "
    "speed. How a rope comes there decides what it carries, within what friction holds"
)
_JAMS = 1e-9  # share of the pull that moves the rope on, below which it jams [1]
_ROUNDING = 1e-6  # of a tension [1]
_NOTHING = 0.05  # [%] of what friction can carry that is not told
_TRIES, _CLOSE = 40, 1e-6  # for the share of friction that is taken, and how well [1]
_AGAIN = 20  # times that a coefficient is found by the way a contact then carries
_LEVEL = 1e-3  # [rad] a rope that turns by less lies straight


@dataclass(frozen=True)
class Wrap:
    """One stretch of a rope on one obstacle."""

    rope: str
    obstacle: str
    first: int  # node of the rope
    last: int
    force: float  # sum of the normal forces [N]
    angle: float  # by which the rope turns there towards the obstacle [rad]
    before: float  # tension of the segment before the first node [N]; 0 at the rope's end
    after: float  # ... after the last node
    # Least and largest tension that friction holds after it with the one before as it is [N], or before it
    # where the rope ends there; inf where it jams, NaN where nothing pulls or something else holds it.
    least: float
    most: float
    backward: bool  # whether they are of the tension before
    # Largest |R_t| / (mu R_n) of its contacts [1]; 1: at the limit; 0 without friction. Nodes on several
    # bodies count as on one, see `grooves`, here and in all that is told of friction.
    use: float
    friction: float  # coefficient of both [1]
    taken: float = (
        0.0  # sum of |R_t| over that of mu R_n [1]: the ends of what lies may slip by themselves
    )
    # How much of what friction has along the rope it takes [1], NaN where the interval is: without weight
    # ln(ratio) / ln(ratio at slip), as pages tell of runs; of a tail that lies, its pull over the most.
    share: float = math.nan
    coarse: CoarseTurn = FINE  # how far the ratio of tensions errs
    beside: tuple[str, ...] = ()  # other obstacles on which some of its nodes lie

    @property
    def nodes(self) -> int:
        """How many nodes it has."""
        return self.last - self.first + 1

    @property
    def where(self) -> str:
        """Which nodes lie, in words."""
        if self.nodes == 1:
            return f"node {self.first} lies"
        return f"nodes {self.first} to {self.last} lie"

    @property
    def words(self) -> str:
        """Where it lies, without the rope's name."""
        one = self.nodes == 1
        said = f"{self.where} on {self.obstacle!r}"
        if self.angle > _LEVEL:
            said += f" and turn{'s' if one else ''} by {math.degrees(self.angle):.4g} degrees"
        if not math.isnan(self.most):
            said += (
                f", {prefixed(self.before, 'N', 4)} before and {prefixed(self.after, 'N', 4)} after"
            )
        if self.friction == 0.0:
            return said
        if math.isnan(self.most):
            return said + self._taken
        end = "before" if self.backward else "after"
        most = "any tension" if math.isinf(self.most) else prefixed(self.most, "N", 4)
        also = f" with that of {self._others}" if self.beside else ""
        return f"{said}; friction{also} holds {prefixed(self.least, 'N', 4)} to {most} {end}"

    @property
    def _others(self) -> str:
        """The other obstacles on which it lies, in words."""
        return " and ".join(map(repr, self.beside))

    @property
    def _taken(self) -> str:
        """How much of what friction can carry it carries, in words; "" where that is nothing."""
        if 100.0 * self.use < _NOTHING:
            return ""
        one, said = f"{100.0 * self.use:.3g} %", "; "
        if self.beside:  # not what wedges it across, which does not hold it along
            said += f"along {self.obstacle!r} and {self._others} "
        if self.nodes == 1:
            return f"{said}its contact takes {one} of what friction can carry"
        said += f"its contacts take {100.0 * self.taken:.3g} % of what friction can carry together"
        return f"{said}, single ones up to {one}"

    def __str__(self) -> str:
        return f"rope {self.rope!r}: {self.words}"

    def as_dict(self) -> dict[str, Any]:
        """Plain values."""
        return vars(self) | {"coarse": self.coarse._asdict()}


def coarse_words(lie: tuple[Wrap, ...]) -> list[str]:
    """Return a sentence for every stretch that turns with friction on so few nodes that tensions err."""
    return [
        f"rope {wrap.rope!r}: {wrap.where} on {wrap.obstacle!r} and turn{'s' if wrap.nodes == 1 else ''} by "
        f"{math.degrees(wrap.angle):.3g} degrees on so few nodes that the ratio of tensions which friction "
        f"holds there may err {wrap.coarse.most}, as nodes happen to lie; {wrap.coarse.remedy}"
        for wrap in lie
        if wrap.coarse.is_told
    ]


def going_on_words(lie: tuple[Wrap, ...]) -> str:
    """Return why ropes that touch this at last did not come to rest."""
    if not lie:
        return (
            "there is no rest: the ropes fall past all obstacles. Hold a node with an anchor or, where they "
            "slid off one, give it more friction"
        )
    said = ("there is no rest: the ropes slide or fall on and on", sliding_words(lie))
    return ". ".join(filter(None, said))


def on_the_way_words(lie: tuple[Wrap, ...], way: float, *, patient: bool) -> str:
    """Return what is known of ropes that went so far [m], and were on their way yet when time was up.

    A look that was not `patient` took a fifth of the steps that settling takes.
    """
    found = f"no shape of rest was found: after {way:.3g} m the ropes still slide or fall"
    longer = "" if patient else "`ropewalk settle` looks longer"
    return ". ".join(filter(None, (found, longer, sliding_words(lie))))


def sliding_words(lie: tuple[Wrap, ...]) -> str:
    """Return where friction carries all it can, and what to change; "" where it nowhere does."""
    full = [wrap for wrap in lie if wrap.use >= SLIPS or wrap.friction == 0.0]
    if not full:
        return ""
    own = {(wrap.obstacle, wrap.friction) for wrap in full}
    several = {name for name, _ in own if sum(other == name for other, _ in own) > 1}
    rubs = {
        f"{wrap.obstacle!r} ("
        + (f"rope {wrap.rope!r}, " if wrap.obstacle in several else "")
        + f"friction {wrap.friction:g})"
        for wrap in full
    }
    names = ", ".join(sorted(rubs))
    remedy = "Give more friction, more turns, or an anchor"
    if _shared(full):  # as in a groove, whose sides hold on steeper slopes than one plane would
        return f"On {names} friction carries all it can. {remedy}"
    slope = min(math.degrees(math.atan(wrap.friction)) for wrap in full)
    which = " with the least of them" if len(rubs) > 1 else ""
    return (
        f"On {names} friction carries all it can: it holds on slopes of up to atan(friction) = "
        f"{slope:.4g} degrees{which}, and round a drum by a factor of up to exp(friction angle) of the "
        f"tensions. {remedy}"
    )


def _shared(lie: list[Wrap]) -> bool:
    """Tell whether some nodes lie on several bodies."""
    return any(
        one.rope == other.rope
        and one.obstacle != other.obstacle
        and max(one.first, other.first) <= min(one.last, other.last)
        for one, other in itertools.combinations(lie, 2)
    )


def wraps(
    model: Model, positions: Floats, tension: Floats, force: Floats, others: Floats
) -> tuple[tuple[Wrap, ...], Contacts]:
    """Return where ropes lie on obstacles, rope by rope, and the contacts.

    Args:
        model: the scene.
        positions: (n, 3) [m].
        tension: (s,) [N].
        force: of all obstacles on the nodes [N], (3, n).
        others: of all else but the segments' tension [N], (3, n).
    """
    x, state = np.ascontiguousarray(positions.T), model.state
    table = model.system.node.obstacle
    if not len(table.kind):
        return (), contacts_at(table, x, np.zeros_like(x), np.zeros_like(x), state.stiffness)
    table = standing_obstacles(table, state.memory.obstacle)
    contacts = contacts_at(table, x, np.zeros_like(x), force, state.stiffness)
    of_one, found = as_of_one(contacts, force), []
    for rope in model.layout.ropes:
        for o in range(len(table.kind)):
            own = (contacts.node >= rope.start) & (contacts.node <= rope.end)
            runs = stretches(contacts, np.flatnonzero(own & (contacts.obstacle == o)))
            found += [
                _wrap(model, table, x, tension, others, contacts, of_one, rope, rows)
                for rows in runs
            ]
    return tuple(sorted(found, key=lambda wrap: (wrap.rope, wrap.first))), contacts


def _wrap(
    model: Model,
    table: Obstacles,
    x: Floats,
    tension: Floats,
    others: Floats,
    contacts: Contacts,
    of_one: Contacts,
    rope: Span,
    rows: Ints,
) -> Wrap:
    first, last = int(contacts.node[rows[0]]), int(contacts.node[rows[-1]])
    before = float(tension[first - 1]) if first > rope.start else 0.0
    after = float(tension[last]) if last < rope.end else 0.0
    held = np.isin(model.state.anchor_node[model.state.held == 1], np.arange(first, last + 1))
    least, most, back, share = math.nan, math.nan, False, math.nan
    if not held.any():
        least, most, back = _allowed(x, tension, others, of_one, rows, rope)
    pull = before if back else after
    if not (1.0 - _ROUNDING) * least <= pull <= (1.0 + _ROUNDING) * most:
        least = most = math.nan  # not by this contact alone: another body, or a press
    else:
        share = _share(pull, lambda s: _allowed(x, tension, others, of_one.using(s), rows, rope))
    body, made = (
        model.scene.obstacles[int(contacts.obstacle[rows[0]])],
        model.scene.rope_named(rope.name),
    )
    friction = body.friction_with(made)
    return Wrap(
        rope=rope.name,
        obstacle=body.name,
        first=first - rope.start,
        last=last - rope.start,
        force=float(contacts.push[rows].sum()),
        angle=float(contacts.turn[rows].sum()),
        before=before,
        after=after,
        least=least,
        most=most,
        backward=back,
        use=float(of_one.use[rows].max()),
        friction=friction,
        taken=_taken(of_one, rows),
        share=share,
        coarse=coarse_turn(table, contacts, rows, x, friction, made.segment_length),
        beside=tuple(model.scene.obstacles[o].name for o in beside(contacts, rows)),
    )


def _taken(contacts: Contacts, rows: Ints) -> float:
    """Return which share [1] of what friction can carry these contacts do together; 0 without any."""
    most = float((contacts.friction[rows] * contacts.push[rows]).sum())
    return float(np.linalg.norm(contacts.rub[rows], axis=1).sum()) / most if most > 0.0 else 0.0


def _share(pull: float, allowed: Callable[[float], tuple[float, float, bool]]) -> float:
    """Return the least share of friction with which `allowed` holds a pull [N], by false position."""
    least, most, _ = allowed(0.0)
    if least <= pull <= most:
        return 0.0
    more = pull > most

    def lacks(share: float) -> float:
        least, most, _ = allowed(share)
        return pull - most if more else least - pull

    low, high = 0.0, 1.0
    short, over = (pull - most if more else least - pull), lacks(1.0)
    for _ in range(_TRIES):
        if not over < 0.0 or high - low < _CLOSE:
            break
        inside = math.isfinite(over)
        share = low + (high - low) * (short / (short - over) if inside else 0.5)
        if (left := lacks(share)) > 0.0:
            low, short, over = share, left, 0.5 * over
        else:
            high, over, short = share, left, 0.5 * short
        if abs(left) < _CLOSE * pull:
            return share
    return high


def _allowed(
    x: Floats, tension: Floats, others: Floats, contacts: Contacts, rows: Ints, rope: Span
) -> tuple[float, float, bool]:
    """Return the least and the largest tension after a stretch that friction holds [N], see `Wrap`.

    Node by node from the tension before it, in the shape as it is, with all of friction that what the rope
    needs across leaves along it, one way or the other (`_held`). Round a drum without weight it is
    exp(-mu theta) and exp(mu theta) times the tension before. Where the rope ends there it is taken from
    that end, without tension, back.

    A rope that turns by a towards the surface and by b within it presses with T a and needs T b across, so
    that dT = T sqrt((mu a)^2 - b^2) is left along it: on a sphere of radius R, along a circle R sin(beta) off
    its centre, exp(theta sqrt(mu^2 - tan^2 beta)) in all.
    Source: Maddocks & Keller 1987, Ropes in equilibrium, SIAM J. Appl. Math. 47:1185.
    """
    row_of = {int(contacts.node[row]): row for row in rows}
    nodes = np.arange(min(row_of), max(row_of) + 1)
    step = 1 if nodes[-1] < rope.end else -1
    nodes, far = nodes[::step], rope.end if step > 0 else rope.start
    given = int(nodes[0]) - (step > 0)
    start = float(tension[given]) if rope.start <= given < rope.end else 0.0
    ends = []
    for more in (False, True):
        pull = start
        for i in nodes:
            if i == far:  # all of the rope lies there
                return math.nan, math.nan, False
            into = (
                _unit(x[:, i] - x[:, i - step])
                if rope.start <= i - step <= rope.end
                else np.zeros(3)
            )
            out = _unit(x[:, i + step] - x[:, i])
            row = row_of.get(int(i))
            mu = float(contacts.cone[row]) if row is not None else 0.0
            off = float(contacts.off[row]) * step if row is not None else 0.0
            n = contacts.normal[row] if row is not None else _unit(into - out)
            pull = _held_off(pull * into - others[:, i], into + out, out, n, mu, off, more=more)
            if math.isinf(pull):
                break
        ends.append(pull)
    return min(ends), max(ends), step < 0


def _held_off(
    given: Floats, along: Floats, out: Floats, n: Floats, mu: float, off: float, *, more: bool
) -> float:
    """Return what `_held` does of a contact that is `off` the middle of its turn [rad], see `laws.polygon`.

    Its coefficient hangs on how far what it carries is `along` the rope.
    """
    if off == 0.0:
        return _held(given, out, n, mu, more=more)
    way, c = _unit(along - n * (n @ along)), 1.0 if more else -1.0
    for _ in range(_AGAIN):
        pull = _held(given, out, n, tilted(mu, off, c), more=more)
        if math.isinf(pull):
            break
        rub = given - pull * out
        before, c = c, -float(way @ _unit(rub - n * (n @ rub)))
        if abs(c - before) < _ROUNDING:
            break
    return pull


def _held(given: Floats, out: Floats, n: Floats, mu: float, *, more: bool) -> float:
    """Return the largest tension T of the segment along `out` that a contact holds [N], or the least.

    With c the `given` force, R = c - T out has to be within the cone of friction about the normal `n`,
        |c_t - T o_t|^2 = mu^2 (c_n - T o_n)^2
    at its edge: what R carries across the rope it lacks along it. inf where the node jams; where no tension
    would do, the one that comes nearest.
    """
    down, deep = float(given @ n), float(out @ n)
    across, over = given - down * n, out - deep * n
    a = float(over @ over) - (mu * deep) ** 2
    b = float(across @ over) - mu**2 * down * deep
    c = float(across @ across) - (mu * down) ** 2
    root = math.sqrt(max(b * b - a * c, 0.0))
    if not a > _JAMS:
        return math.inf if more or not b > 0.0 else max(c / (b + root), 0.0)
    return max((b + root if more else b - root) / a, 0.0)


def _unit(direction: Floats) -> Floats:
    size = float(np.linalg.norm(direction))
    found: Floats = direction / size if size > 0.0 else direction
    return found
