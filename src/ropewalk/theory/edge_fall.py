"""A mass that falls into a rope that runs over an edge: the rig of EN 892, with a rope that relaxes.

The rope comes from the fixed point, a length a of it, turns over the edge and goes on to the mass, a length
b of it:
    m x'' = m g - T_b,   T = EA e (1 + s e^2) + EA1 (e - q),   q' = (e - q) / tau   on each side,
    e_a = a / (a - u) - 1,   e_b = (b + x) / (b + u) - 1,   T_b <= r T_a,   T_a <= r T_b,
    r = exp(mu beta)
u is what has passed the edge [m of unstretched rope]: it changes only as much as keeps the two tensions
within r of each other, the capstan's law. The rope's own mass is left out, and what passes takes on the arm
of the side it comes to. From the moment when the rope is straight until it is slack, by the classical method
of Runge and Kutta.
Source: Findley, Lai & Onaran, Creep and Relaxation of Nonlinear Viscoelastic Materials, ch. 5; for ropes over
karabiners Pavier, Sports Engineering 1 (1998) 79.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from ropewalk.theory.given import need
from ropewalk.theory.solid_fall import find_arm, root_of

_FALL_FACTOR, _LENGTH, _BEHIND = 1.77, 2.8, 0.3  # of EN 892 [1], [m], [m]
_STEPS, _QUICK = (
    400,
    200,
)  # of a catch by the rope at rest, and by one that has had no time to relax
_CATCHES = 6.0  # after which a rope is not waited for
_ROUNDS = 60
_NEWTON, _CLOSE, _SHIFT = 25, 1e-6, 1e-3
_SOONEST = 0.02  # relaxation time that is looked for, over some two catches [1]


@dataclass(frozen=True)
class EdgeFall:
    """What a fall over an edge does."""

    anchor_force: float  # largest force on the fixed point [N]
    mass_force: float  # largest force on the mass, the tension beyond the edge [N]
    stretch: float  # largest way of the mass over the rope's length [1]
    passed: float  # rope that has passed the edge by then [m of unstretched rope]
    time_of_force: float  # of that on the mass, after the rope is straight [s]
    time_of_stretch: float  # [s]
    returned: float  # kinetic energy when it is slack, over the work of the weight to the lowest point [1]

    def __repr__(self) -> str:
        return (
            f"EdgeFall: {self.anchor_force:.4g} N on the fixed point, {self.mass_force:.4g} N on the mass, "
            f"stretched by {100 * self.stretch:.3g} %."
        )


@dataclass(frozen=True)
class _Rig:
    """The rope and the rig; lengths of the strands a and b [m]."""

    EA: float
    arm: float
    time: float
    stiffening: float
    ratio: float
    a: float
    b: float

    def tension(self, strain: float, damper: float) -> float:
        return self.EA * strain * (1.0 + self.stiffening * strain * strain) + self.arm * (
            strain - damper
        )

    def strains(self, x: float, passed: float) -> tuple[float, float]:
        return passed / (self.a - passed), (x - passed) / (self.b + passed)

    def tensions(self, x: float, passed: float, qa: float, qb: float) -> tuple[float, float]:
        ea, eb = self.strains(x, passed)
        return self.tension(ea, qa), self.tension(eb, qb)

    def slid(self, x: float, passed: float, qa: float, qb: float) -> float:
        """Return what has passed once neither side pulls more than r times the other."""
        ta, tb = self.tensions(x, passed, qa, qb)
        if tb > self.ratio * ta:
            one, other = 1.0, self.ratio
        elif ta > self.ratio * tb:
            one, other = self.ratio, 1.0
        else:
            return passed

        def pull(u: float) -> float:
            ta, tb = self.tensions(x, u, qa, qb)
            return one * tb - other * ta

        return _falling_root(pull, passed, 1e-3 * self.a, -0.9 * self.b, 0.9 * self.a)


def _falling_root(
    pull: Callable[[float], float], start: float, step: float, least: float, most: float
) -> float:
    """Return where a falling function is zero, near `start`."""
    value = pull(start)
    way = step if value > 0.0 else -step
    low = high = start
    for _ in range(_ROUNDS):
        other = min(max(start + way, least), most)
        if (pull(other) > 0.0) != (value > 0.0) or other in (least, most):
            break
        way *= 2.0
    low, high = min(start, other), max(start, other)
    at_low, at_high = pull(low), pull(high)
    side = 0
    for _ in range(_ROUNDS):
        if at_low == at_high or high - low < 1e-13:
            break
        middle = (low * at_high - high * at_low) / (at_high - at_low)
        found = pull(middle)
        if abs(found) < 1e-9 * (abs(at_low) + abs(at_high)):
            return middle
        if found > 0.0:
            low, at_low = middle, found
            at_high = 0.5 * at_high if side == 1 else at_high
            side = 1
        else:
            high, at_high = middle, found
            at_low = 0.5 * at_low if side == -1 else at_low
            side = -1
    return 0.5 * (low + high)


def edge_fall(
    EA: float,
    relaxing_EA: float,
    relaxation_time: float,
    mass: float,
    *,
    edge_friction: float,
    stiffening: float = 0.0,
    behind: float = _BEHIND,
    factor: float = _FALL_FACTOR,
    length: float = _LENGTH,
    gravity: float = 9.81,
) -> EdgeFall:
    """Return what a mass does that falls into a rope that relaxes and runs over an edge.

    Args:
        EA: axial stiffness of the rope at rest, at strain 0 [N].
        relaxing_EA: that of the arm beside it [N].
        relaxation_time: of the arm [s].
        mass: that falls [kg].
        edge_friction: coefficient of friction times the angle of the turn, mu beta [1]; 0 for none.
        stiffening: s of the tension at rest EA e (1 + s e^2) [1].
        behind: rope between the fixed point and the edge [m], part of `length`.
        factor: height of the free fall over the length of the rope [1].
        length: of the rope [m].
        gravity: [m/s^2].

    Raises ValueError for numbers that are not positive (edge_friction and stiffening: negative), and for an
    edge that is not between the ends.

    Source: the module's; Pavier, Sports Engineering 1 (1998) 79.
    """
    for name, value, unit in (
        ("EA", EA, "N"),
        ("relaxing_EA", relaxing_EA, "N"),
        ("relaxation_time", relaxation_time, "s"),
        ("mass", mass, "kg"),
        ("factor", factor, "1"),
        ("length", length, "m"),
        ("gravity", gravity, "m/s^2"),
        ("behind", behind, "m"),
    ):
        need(name, value, unit)
    for name, value in (("edge_friction", edge_friction), ("stiffening", stiffening)):
        if not 0.0 <= value < math.inf:
            raise ValueError(f"{name}: {value:g} - must be 0 or greater")
    if not behind < length:
        raise ValueError(f"behind: {behind:g} - must be below the rope's length, {length:g} m")
    rig = _Rig(
        EA,
        relaxing_EA,
        relaxation_time,
        stiffening,
        math.exp(edge_friction),
        behind,
        length - behind,
    )
    return _fallen(rig, mass, factor, gravity)


def _fallen(rig: _Rig, mass: float, factor: float, gravity: float) -> EdgeFall:
    """Return what a fall does, step by step."""
    length = rig.a + rig.b
    speed = math.sqrt(2.0 * gravity * factor * length)
    catch = math.sqrt(mass * length / rig.EA) * math.pi
    x, v, qa, qb, passed = 0.0, speed, 0.0, 0.0, 0.0
    quick = catch * math.sqrt(rig.EA / (rig.EA + rig.arm))  # while the arm has had no time to relax
    dt = min(catch / _STEPS, quick / _QUICK, 0.5 * rig.time)

    def rates(x: float, v: float, qa: float, qb: float) -> tuple[float, float, float, float]:
        u = rig.slid(x, passed, qa, qb)
        ea, eb = rig.strains(x, u)
        pull = rig.tension(eb, qb)
        return v, gravity - pull / mass, (ea - qa) / rig.time, (eb - qb) / rig.time

    anchor, hard, far, back = (0.0, 0.0), (0.0, 0.0), (0.0, 0.0, 0.0), 0.0
    for step in range(1, int(_CATCHES * catch / dt)):
        k1 = rates(x, v, qa, qb)
        k2 = rates(*(y + 0.5 * dt * k for y, k in zip((x, v, qa, qb), k1, strict=True)))
        k3 = rates(*(y + 0.5 * dt * k for y, k in zip((x, v, qa, qb), k2, strict=True)))
        k4 = rates(*(y + dt * k for y, k in zip((x, v, qa, qb), k3, strict=True)))
        x, v, qa, qb = (
            y + dt / 6.0 * (p + 2.0 * q + 2.0 * r + s)
            for y, p, q, r, s in zip((x, v, qa, qb), k1, k2, k3, k4, strict=True)
        )
        passed = rig.slid(x, passed, qa, qb)
        ta, tb = rig.tensions(x, passed, qa, qb)
        t = step * dt
        anchor, hard = max(anchor, (ta, t)), max(hard, (tb, t))
        far = max(far, (x, t, passed))
        if v < 0.0 and tb <= 0.0:
            back = 0.5 * v * v / (gravity * (factor * length + far[0]))
            break
    return EdgeFall(anchor[0], hard[0], far[0] / length, far[2], hard[1], far[1], back)


def solid_from_edge_fall(
    force: float,
    stretch: float,
    EA: float,
    mass: float,
    *,
    edge_friction: float,
    measured: str = "mass",
    stiffening: float = 0.0,
    behind: float = _BEHIND,
    factor: float = _FALL_FACTOR,
    length: float = _LENGTH,
    gravity: float = 9.81,
) -> tuple[float, float]:
    """Return the arm's EA [N] and relaxation time [s] with which a fall over an edge has force and stretch.

    Args:
        force: largest [N], on the mass or on the fixed point, see `measured`.
        stretch: largest way of the mass over the rope's length [1].
        EA: axial stiffness of the rope at rest, at strain 0 [N].
        mass: that falls [kg].
        edge_friction: mu beta [1], as for `edge_fall`.
        measured: "mass" or "anchor", where the force is: behind the edge it is up to exp(mu beta) less.
        stiffening: as for `edge_fall` [1].
        behind: rope between the fixed point and the edge [m].
        factor: height of the free fall over the length of the rope [1].
        length: of the rope [m].
        gravity: [m/s^2].

    Raises ValueError for numbers that are not positive, for another `measured`, and for a force that no arm
    gives, with those that are possible.

    Source: as `edge_fall`.
    """
    for name, value, unit in (("force", force, "N"), ("stretch", stretch, "1")):
        need(name, value, unit)
    if measured not in ("mass", "anchor"):
        raise ValueError(f"measured: {measured!r} - must be 'mass' or 'anchor'")

    def fall(arm: float, time: float) -> EdgeFall:
        return edge_fall(
            EA, arm, time, mass, edge_friction=edge_friction, stiffening=stiffening, behind=behind,
            factor=factor, length=length, gravity=gravity,
        )  # fmt: skip

    def found(arm: float, time: float) -> tuple[float, float]:
        made = fall(arm, time)
        pull = made.mass_force if measured == "mass" else made.anchor_force
        return math.log(pull / force), math.log(made.stretch / stretch)

    whole = mass * gravity * (factor + stretch)
    catch = math.sqrt(length * mass * stretch**2 / whole)
    try:
        solved = _solved(found, 2.5 * EA, 2.0 * catch)
    except (OverflowError, ValueError):  # a search that went astray
        solved = None
    if solved is None:
        raise ValueError(_impossible(force, stretch, fall, measured, whole, EA, catch))
    return solved


def harder_by(
    force: float,
    EA: float,
    relaxing_EA: float,
    relaxation_time: float,
    mass: float,
    *,
    edge_friction: float = 0.0,
    measured: str = "mass",
    stiffening: float = 0.0,
    **rig: float,
) -> float:
    """Return by how much [1] EA and its arm must both be greater for a fall to have this force.

    For a later fall of a series, of which only the force is known: that the whole rope has grown harder by
    one factor, and relaxes as before, is an assumption.

    Args:
        force: largest in that fall [N], measured as for `solid_from_edge_fall`.
        EA: axial stiffness of the new rope at rest [N].
        relaxing_EA: that of its arm [N].
        relaxation_time: of the arm [s].
        mass: that falls [kg].
        edge_friction: mu beta [1], as for `edge_fall`.
        measured: "mass" or "anchor".
        stiffening: as for `edge_fall` [1].
        rig: behind, factor, length, gravity of `edge_fall`.

    Raises ValueError for numbers that are not positive, for another `measured`, and for a force that no
    factor of 0.2 to 5 gives.

    Source: as `edge_fall`.
    """
    need("force", force, "N")
    if measured not in ("mass", "anchor"):
        raise ValueError(f"measured: {measured!r} - must be 'mass' or 'anchor'")

    def off(size: float) -> float:
        k = math.exp(size)
        found = edge_fall(
            k * EA, k * relaxing_EA, relaxation_time, mass, edge_friction=edge_friction,
            stiffening=stiffening, **rig,
        )  # fmt: skip
        pull = found.mass_force if measured == "mass" else found.anchor_force
        return math.log(pull / force)

    low, high = math.log(0.2), math.log(5.0)
    if not off(low) < 0.0 < off(high):
        raise ValueError(
            f"force: {force:g} - no fall of this rope has it, were it five times as hard or as soft"
        )
    return math.exp(root_of(off, low, high))


def _solved(
    found: Callable[[float, float], tuple[float, float]], arm: float, time: float
) -> tuple[float, float] | None:
    """Return the arm and the time at which both numbers are zero, by Newton's method; or None."""
    at = [math.log(arm), math.log(time)]
    for _ in range(_NEWTON):
        f = found(math.exp(at[0]), math.exp(at[1]))
        if max(map(abs, f)) < _CLOSE:
            return math.exp(at[0]), math.exp(at[1])
        g = found(math.exp(at[0] + _SHIFT), math.exp(at[1]))
        h = found(math.exp(at[0]), math.exp(at[1] + _SHIFT))
        a, c = ((g[k] - f[k]) / _SHIFT for k in range(2))
        b, d = ((h[k] - f[k]) / _SHIFT for k in range(2))
        det = a * d - b * c
        if det == 0.0 or not math.isfinite(det):
            return None
        way = (d * f[0] - b * f[1]) / det, (a * f[1] - c * f[0]) / det
        share = min(1.0, 0.7 / max(abs(way[0]), abs(way[1]), 1e-9))
        at = [at[k] - share * way[k] for k in range(2)]
        if not (_SOONEST * time < math.exp(at[1]) < time / _SOONEST and abs(at[0]) < 30.0):
            return None
    return None


def _stretch_of(fall: Callable[[float, float], EdgeFall], time: float, arm: float) -> float:
    return fall(arm, time).stretch


def _impossible(
    force: float,
    stretch: float,
    fall: Callable[[float, float], EdgeFall],
    measured: str,
    whole: float,
    EA: float,
    catch: float,
) -> str:
    """Say which forces are possible with this stretch; by a few relaxation times."""
    forces = []
    for time in (100.0 * catch, 3.0 * catch, catch, 0.3 * catch):
        try:
            stretch_of = partial(_stretch_of, fall, time)
            arm = find_arm(stretch_of, stretch, 1e-6 * EA, 1e2 * whole / stretch)
        except (OverflowError, ValueError):
            continue
        made = fall(arm, time)
        if abs(made.stretch / stretch - 1.0) < 1e-3:
            forces.append(made.mass_force if measured == "mass" else made.anchor_force)
    where = "on the mass" if measured == "mass" else "on the anchor, behind the edge"
    if not forces:
        return f"stretch: {100 * stretch:.3g} % - no rope that relaxes and has this EA at rest stretches so"
    return (
        f"force: {force:g} - must be from about {min(forces):.3g} to {max(forces):.3g} N {where}: a rope "
        "that relaxes and has this EA, stretch and edge has no other"
    )
