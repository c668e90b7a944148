"""Rest on obstacles: where a rope comes to that creeps, without inertia, from its drawn shape.

With Coulomb friction there are many shapes of rest, and which one is reached depends on the way. The way
taken here is named: a drag D, the same for every node and so large that inertia does not count,

    f(x) - D (x - x0) = 0,

in steps from x0 to x of implicit Euler, f with the law of contact of `laws.contact` and its memory, which is
written after every step as a run does. D falls as the rope slows down; at last the equations of rest are
solved without it, by contacts that hold with the force that they have kept. Without friction nothing is
remembered, and the way does not matter where there is but one rest.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.couplings import AGAIN, FINE
from ropewalk.statics.balance import Balance
from ropewalk.statics.newton import Found
from ropewalk.statics.rolling import roll
from ropewalk.statics.searching import POLISH, search

_STEPS, _MORE = 600, 3000  # of creeping; the same of ropes that touch each other or slide
_INNER = 40  # Newton steps for one of them
# Leaps out of minima in one search: of 7000 that ended well on the way none took more than 11.
_LEAPS = 12
_EVERY = 5  # steps between two looks for rest without drag
_CLEAR = 0.5  # of the thinnest body: how far a node may go in one step, so that it passes none [1]
_NEAR = 0.05  # of a segment: the longest way of a step after which rest may be near [1]
_SLOW = 100.0  # drag under which it may be, in the model's units [1]
_LEAST, _MOST = 1e-9, 1e9  # of the drag, in the model's units and over the stiffest contact [1]
_FAR = 3.0  # of the ropes' length and all distances: on a longer way nothing comes to rest [1]
_REFUSED = 60  # steps in which something would go through something: then it will [1]
_AWAY = 3.0  # of a segment: on the way for so long, and not to rest, is to slide or fall [1]
_TURNS = 60  # rounds in which the planes of contacts of ropes turn with them
_ROUNDS = 10  # in which the coefficients of friction follow the turns of the rope at its nodes


@dataclass(frozen=True)
class Crept:
    """What creeping came to."""

    found: Found
    goes_on: bool  # it slid or fell so far that it will not come to rest
    slid: float = 0.0  # [m] how far it went where it was still on its way when time was up, else 0


def creep(
    balance: Balance,
    x: Floats,
    thinnest: float,
    patience: int,
    see: Callable[[Floats], None],
    passes: Callable[[Floats, Floats], bool],
) -> Crept:
    """Return where ropes come to rest from places `x` (3, n) [m].

    Args:
        balance: the equations; its state keeps what the contacts carry.
        x: places to begin with.
        thinnest: least radius of what may be met [m], inf for planes.
        patience: Newton steps after which to give up.
        see: is shown the places after every step.
        passes: tells whether a way from places to others goes through something.
    """
    pull = balance.elastic(x)
    tension = np.where(np.isfinite(pull), np.maximum(pull, 0.0), 0.0)
    unit = balance.force / balance.length
    drag = stiffest = max(unit, float(balance.stiffness().max()))
    longest, reach = _FAR * _size(balance, x), _CLEAR * thinnest  # farther where all is far away
    begun = roll(balance, Found(x, tension, math.inf, 0.0, 0), see)
    x, tension, spent = begun.x, begun.tension, begun.steps
    way, share, refused = 0.0, 0.1, 0
    used_up = False
    for count in range(_MORE if balance.coupled.acts else _STEPS):
        step = _dragged(balance, x, tension, drag)
        spent += step.steps
        moved = _largest(balance, step.x - x)
        clear = step.at_rest and moved <= _allowed(balance, x, reach)
        through = clear and passes(x, step.x)
        if through or not clear:
            drag, share, refused = 4.0 * drag, 0.5, refused + through
            over = spent > patience or refused > _REFUSED
            if over or drag > _MOST * stiffest or balance.coupled.fails:
                break
            continue
        x, tension, way = step.x, step.tension, way + moved
        balance.remember(x)
        see(x)
        if way > longest or spent > patience:
            break
        if moved < _NEAR * balance.length and drag < _SLOW * unit and count % _EVERY == 0:
            last = _at_last(balance, x, tension, min(reach, balance.length), passes)
            spent += last.steps
            if last.at_rest:
                return Crept(last._replace(steps=spent), goes_on=False)
        drag, share = max(share * drag, _LEAST * unit), max(0.1, 0.7 * share)
    else:  # slides in steps as short as what is thin asks for
        used_up = not refused and _largest(balance, x - begun.x) > _AWAY * balance.length
    error, allowed = balance.error(x, tension), balance.allowed(x, tension)
    still = way if used_up or (spent > patience and way > _AWAY * balance.length) else 0.0
    return Crept(Found(x, tension, error, allowed, spent), goes_on=way > longest, slid=still)


def _dragged(balance: Balance, x: Floats, tension: Floats, drag: float) -> Found:
    """Return the end of one step from places `x` under a drag [N/m]."""
    balance.drag, balance.origin = drag, x
    found = _met(balance, x, search(balance, x, tension, _INNER, _LEAPS, polish=0), polish=0)
    balance.drag = 0.0
    return found


def _met(balance: Balance, x: Floats, found: Found, polish: int = POLISH) -> Found:
    """Return the end of a step from places `x` that ropes find without passing through each other."""
    steps = found.steps
    while found.at_rest and (met := balance.coupled.meets(x, found.x)) != FINE:
        if met != AGAIN:
            return found._replace(error=math.inf, steps=steps)
        found = search(balance, found.x, found.tension, _INNER, _LEAPS, polish)
        steps += found.steps
    return found._replace(steps=steps)


def _allowed(balance: Balance, x: Floats, reach: float) -> float:
    """Return how far a node may go in one step from places `x` [m]."""
    return min(max(reach, _CLEAR * balance.clearance(x)), balance.coupled.longest())


def _at_last(
    balance: Balance,
    x: Floats,
    tension: Floats,
    reach: float,
    passes: Callable[[Floats, Floats], bool],
) -> Found:
    """Return the rest near `x` without drag, by contacts that hold with what they carry."""
    kept = balance.kept()
    reach = min(reach, balance.coupled.longest())
    found = _met(balance, x, search(balance, x, tension, 3 * _INNER, _LEAPS))
    steps = found.steps
    for _ in range(_ROUNDS):
        near = found.at_rest and _largest(balance, found.x - x) <= reach
        if not near or passes(x, found.x):
            break
        balance.remember(found.x, at_last=True)
        if balance.error(found.x, found.tension) <= found.allowed:
            return _exactly(balance, found._replace(steps=steps), reach)
        found = _met(balance, found.x, search(balance, found.x, found.tension, _INNER, _LEAPS))
        steps += found.steps
    balance.restore(kept)
    return found._replace(error=math.inf, steps=steps)


def _exactly(balance: Balance, found: Found, reach: float) -> Found:
    """Return a rest whose contacts of ropes have the planes that ropes have there, if that is near.

    As it is found they are right to some hundredths, which without friction would hold on a slope as steep.
    """
    if not balance.coupled.touch:
        return found
    kept, start, last = balance.kept(), found, found
    for _ in range(_TURNS):
        balance.coupled.straighten(last.x)
        if balance.error(last.x, last.tension) <= last.allowed:
            return last
        after = _met(balance, last.x, search(balance, last.x, last.tension, _INNER, _LEAPS))
        last = after._replace(steps=last.steps + after.steps)
        if not last.at_rest or not _largest(balance, last.x - start.x) <= reach:
            break
        balance.remember(last.x, at_last=True)
    balance.restore(kept)
    return start._replace(steps=last.steps)


def _size(balance: Balance, x: Floats) -> float:
    """Return the ropes' length and the size of all there is [m]."""
    table = balance.system.node.obstacle
    places = np.concatenate([x, table.center.T], axis=1)
    return float(balance.rest[balance.live].sum() + np.linalg.norm(np.ptp(places, axis=1)))


def _largest(balance: Balance, moved: Floats) -> float:
    """Return the longest way of a free node [m]."""
    return float(np.sqrt((moved * moved).sum(axis=0))[balance.free].max(initial=0.0))
