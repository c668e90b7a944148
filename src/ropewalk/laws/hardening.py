"""Contacts that get stiffer the deeper they are pressed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import small
from ropewalk.laws.obstacle_rows import radius_round

if TYPE_CHECKING:
    from ropewalk.scene.obstacles import Obstacle

RIGID = 1e3  # [1] how much stiffer contacts get whose rope has no stiffness to go by
RISE = 4.0  # [1] by how much of itself the slope of contacts grows for every skin beyond two
SURE = 3.0  # [1] slope at two skins over what would hold a known load in one: twice, and some for stretch
SKIN = 0.005  # [1] depth over the diameter from which contacts with obstacles get stiffer


@small
def beyond(depth, rate, force, slope, energy):
    """Return force, slope and energy after so much more depth [m], if any, with a slope that grows so."""
    e = max(depth, 0.0)
    more = (slope + 0.5 * rate * e) * e
    stored = (force + (0.5 * slope + rate * e / 6.0) * e) * e
    return force + more, slope + rate * e, energy + stored


@small
def squeezed(obstacles, o, i, depth):
    """Return force [N], its slope [N/m] and energy [J] of node i pressed by `depth` [m] into an obstacle.

    k e in its skin, twice as deep with k + `hard` + `held` for a slope, which grows by `rise` a metre from
    there on. Negative where it is off, but for energy.
    """
    k, skin, rise = obstacles.stiffness[o, i], SKIN * obstacles.diameter[i], obstacles.rise[o, i]
    hard = obstacles.hard[o, i] + obstacles.held[o, i]
    if (hard == 0.0 and rise == 0.0) or depth <= skin:
        return k * depth, k, 0.5 * k * depth * max(depth, 0.0)
    force, slope, energy = k * skin, k, 0.5 * k * skin * skin
    force, slope, energy = beyond(min(depth - skin, skin), hard / skin, force, slope, energy)
    return beyond(depth - 2.0 * skin, rise, force, slope, energy)


@small
def along_surface(obstacles, o, i, depth):
    """Return stiffness [N/m] and damping [N s/m] of the springs along a surface where one is pressed so deep.

    The stiffness is force over depth, the damping no less than `firmness` of what is critical with that.
    """
    k, c = obstacles.stiffness[o, i], obstacles.damping[o, i]
    hard = obstacles.hard[o, i] + obstacles.held[o, i]
    if (hard == 0.0 and obstacles.rise[o, i] == 0.0) or depth <= SKIN * obstacles.diameter[i]:
        return k, c
    stiff = squeezed(obstacles, o, i, depth)[0] / depth
    return stiff, c * max(1.0, obstacles.firmness[i] * math.sqrt(stiff / k))


def depth_under(obstacles: Any, force: float) -> Floats:
    """Return how deep a force [N] presses every node into every obstacle [m], (k, n); see `squeezed`."""
    k, hard, skin = obstacles.stiffness, obstacles.hard + obstacles.held, SKIN * obstacles.diameter
    beyond_skin = np.maximum(force - k * skin, 0.0)
    curved = _under(beyond_skin, k, hard / np.maximum(skin, np.finfo(float).tiny))
    whole = (k + 0.5 * hard) * skin
    steeper = skin + _under(np.maximum(beyond_skin - whole, 0.0), k + hard, obstacles.rise)
    found: Floats = np.minimum(force / k, skin) + np.where(curved <= skin, curved, steeper)
    return np.where(hardens(obstacles), found, force / k)


def _under(force: Floats, slope: Floats, rate: Floats) -> Floats:
    """Return how much deeper so much more force presses where the slope grows so; see `beyond`."""
    found: Floats = 2.0 * force / (slope + np.sqrt(slope * slope + 2.0 * rate * force))
    return found


def stored_under(obstacles: Any, depth: Floats) -> Floats:
    """Return what nodes store that are pressed so deep into obstacles [J], (k, n); see `squeezed`."""
    k, hard, skin = obstacles.stiffness, obstacles.hard + obstacles.held, SKIN * obstacles.diameter
    firm, rise = hardens(obstacles), obstacles.rise
    soft = np.where(firm, np.clip(depth, 0.0, skin), np.maximum(depth, 0.0))
    curved = np.where(firm, np.clip(depth - skin, 0.0, skin), 0.0)
    steeper = np.where(firm, np.maximum(depth - 2.0 * skin, 0.0), 0.0)
    rate = hard / skin
    found: Floats = 0.5 * k * soft * soft
    found += (k * skin + (0.5 * k + rate * curved / 6.0) * curved) * curved
    whole = k * skin + (k + 0.5 * hard) * skin
    return found + (whole + (0.5 * (k + hard) + rise * steeper / 6.0) * steeper) * steeper


def hardens(obstacles: Any) -> NDArray[np.bool_]:
    """Tell which contacts get stiffer where they are pressed deep, (k, n): those of no given compliance."""
    found: NDArray[np.bool_] = (obstacles.hard > 0.0) | (obstacles.held > 0.0)
    return found | (obstacles.rise > 0.0)


def stiffnesses(
    bodies: Sequence[Obstacle], own: Floats, firm: Floats, most: Floats
) -> tuple[Floats, Floats]:
    """Return how stiff contacts are [N/m], and by how much more where they are pressed deep, (k, n) each."""
    stiffness, hard = np.maximum(own, firm), np.zeros_like(firm)
    for row, body in enumerate(bodies):
        if body.compliance is None:
            finite = np.where(np.isfinite(most), most, RIGID * stiffness[row])
            hard[row] = np.maximum(finite - stiffness[row], 0.0)
        else:
            stiffness[row] = 1.0 / body.compliance
    return stiffness, hard


def firmer(
    bodies: Sequence[Obstacle],
    springs: tuple[Floats, Floats],
    wished: Floats,
    most: Floats,
    skin: Floats,
) -> dict[str, Any]:
    """Return what steps that take any stiffness add: `held` [N/m] and `rise` [N/m^2], (k, n) each.

    `wished` is the stiffness with which known loads would stay in the `skin` [N/m], (k, n): where `springs`,
    see `stiffnesses`, have less, SURE times that is reached at two skins, so that they press no deeper. Links
    that nothing stretches are as hard as can be already. `most` and `skin` are (n,) [N/m], [m].
    """
    stiffness, hard = springs
    held = np.where(wished > stiffness, np.maximum(SURE * wished - stiffness - hard, 0.0), 0.0)
    rise = np.where(np.isfinite(most), RISE * (stiffness + hard + held) / skin, 0.0)
    given = np.array([body.compliance is not None for body in bodies], dtype=bool)
    held[given] = rise[given] = 0.0
    flat = [radius_round(body) == np.inf for body in bodies]
    rise[flat] = 0.0  # what turns a rope presses it in
    return {"held": held, "rise": rise}
