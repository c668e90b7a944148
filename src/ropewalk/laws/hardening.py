"""Contacts that get stiffer the deeper they are pressed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.jit import small

if TYPE_CHECKING:
    from ropewalk.scene.obstacles import Obstacle

RIGID = 1e3  # [1] how much stiffer contacts get whose rope has no stiffness to go by
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

    k e in its skin, and twice as deep with k + `hard` for a slope. Negative where it is off, but for energy.
    """
    k, hard, skin = obstacles.stiffness[o, i], obstacles.hard[o, i], SKIN * obstacles.diameter[i]
    if hard == 0.0 or depth <= skin:
        return k * depth, k, 0.5 * k * depth * max(depth, 0.0)
    force, slope, energy = k * skin, k, 0.5 * k * skin * skin
    force, slope, energy = beyond(min(depth - skin, skin), hard / skin, force, slope, energy)
    return beyond(depth - 2.0 * skin, 0.0, force, slope, energy)


@small
def along_surface(obstacles, o, i, depth):
    """Return stiffness [N/m] and damping [N s/m] of the springs along a surface where one is pressed so deep.

    The stiffness is force over depth, the damping no less than `firmness` of what is critical with that.
    """
    k, c = obstacles.stiffness[o, i], obstacles.damping[o, i]
    if obstacles.hard[o, i] == 0.0 or depth <= SKIN * obstacles.diameter[i]:
        return k, c
    stiff = squeezed(obstacles, o, i, depth)[0] / depth
    return stiff, c * max(1.0, obstacles.firmness[i] * math.sqrt(stiff / k))


def depth_under(obstacles: Any, force: float) -> Floats:
    """Return how deep a force [N] presses every node into every obstacle [m], (k, n); see `squeezed`."""
    k, hard, skin = obstacles.stiffness, obstacles.hard, SKIN * obstacles.diameter
    beyond_skin = np.maximum(force - k * skin, 0.0)
    share = hard / np.maximum(skin, np.finfo(float).tiny)
    curved = 2.0 * beyond_skin / (k + np.sqrt(k * k + 2.0 * share * beyond_skin))
    whole = (k + 0.5 * hard) * skin
    straight = skin + (beyond_skin - whole) / (k + hard)
    found: Floats = np.minimum(force / k, skin) + np.where(curved <= skin, curved, straight)
    return np.where(hard > 0.0, found, force / k)


def stored_under(obstacles: Any, depth: Floats) -> Floats:
    """Return what nodes store that are pressed so deep into obstacles [J], (k, n); see `squeezed`."""
    k, hard, skin = obstacles.stiffness, obstacles.hard, SKIN * obstacles.diameter
    soft = np.where(hard > 0.0, np.clip(depth, 0.0, skin), np.maximum(depth, 0.0))
    curved = np.where(hard > 0.0, np.clip(depth - skin, 0.0, skin), 0.0)
    straight = np.where(hard > 0.0, np.maximum(depth - 2.0 * skin, 0.0), 0.0)
    rate = hard / skin
    found: Floats = 0.5 * k * soft * soft
    found += (k * skin + (0.5 * k + rate * curved / 6.0) * curved) * curved
    return found + (k * skin + (k + 0.5 * hard) * skin + 0.5 * (k + hard) * straight) * straight


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
