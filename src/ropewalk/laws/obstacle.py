"""Obstacles as a law of nodes: bodies that nodes touch, with Coulomb friction. See `contact`.

By default a contact is as stiff as lets it be solved for at frame rates: 1/0.15 times what a chain shows to a
force at one of its nodes in a step of 1/60 s, whatever the run's own steps are,
    sqrt(k0^2 + 4 k k0),   k0 = m / (1/60 s)^2,   k that of the segments,
but no more than the whole rope's inertia in that time, nor than its segments are (those lighter than that
step allows for, than k0). Round bodies are stiffer where more hangs on a rope than that holds: a tension of
all its weight, loads and given forces turns by h/R at each node and presses it in by FIRM of its diameter.
The damper is that of a node on its own, in rigid ropes see `striking`. What is pressed in past the skin
meets as much as the segments' own stiffness, see `hardening`: what pulls a line taut is not known before.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.core.jit import part
from ropewalk.core.ranges import ALL
from ropewalk.laws.contact import (
    contact_energy,
    contact_forces,
    contact_given,
    contact_rounding,
    quickest_impact,
    remember_contacts,
)
from ropewalk.laws.contact_books import BOOKS, WAYS, book_contacts
from ropewalk.laws.contact_frame import DAMP, GRIPS, PUSH, STIFF, TOUCHES
from ropewalk.laws.contact_tangent import contact_tangent
from ropewalk.laws.hardening import stiffnesses
from ropewalk.laws.held_nodes import follow_held
from ropewalk.laws.node_law import NodeLaw, Rest, always
from ropewalk.laws.obstacle_places import depths
from ropewalk.laws.obstacle_pose import all_stand
from ropewalk.laws.obstacle_rows import (
    KINDS,
    axle_of,
    half_thickness,
    place_of,
    radius_round,
    size_rows,
    spin_of,
    sweeps,
    turning_of,
    wheel_columns,
    wherever,
)
from ropewalk.laws.obstacle_way import find_pass, find_sweep, gone, meet
from ropewalk.laws.rebound import rebounds
from ropewalk.laws.striking import firmness, striking
from ropewalk.laws.touch_events import contact_events
from ropewalk.laws.wheel_rows import RATE, ROWS, WIDTH
from ropewalk.motions.rows import Motions, jumps, motion_rows

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ropewalk.lowering.layout import Layout
    from ropewalk.methods.bound import Chain
    from ropewalk.scene import Rope
    from ropewalk.scene.obstacles import Obstacle

FRAME = 1.0 / 60.0  # [s]
FIRM = 0.005  # [1] depth over the diameter, see above
SHARP = 2.0  # [1] what a node presses with, over the tension, where the rope turns back
SHARE = 0.15  # [1] compliance of a contact over the rope's own at a node
DAMPING = 1.0  # [1] damping ratio of a node on its own: it does not bounce


class Obstacles(NamedTuple):
    """Obstacles, one row each; k of them."""

    kind: Ints  # (k,)
    center: Floats  # (k, 3) at time zero a point of the plane, or the middle [m]
    axis: Floats  # (k, 3) unit vector; the normal of a plane
    axle: Floats  # (k, 3) unit vector about which it turns: of what is round its axis
    hub: Floats  # (k, 3) at time zero a point of the axle [m]: of most the middle
    # (k,) whether turning moves the surface, as it is not round about the axle, or its weight's lever
    sweeps: Ints
    # (k, 4 or more) radius, half length; of a ring that of the circle and of the bar; of a box without its
    # edges half sizes, then the edges' radius [m], then the direction of its first edge [1], its third being
    # along the axis; of a half-pipe its radius [m], then the direction to which it is open, across the axis
    # [1]; a mesh as `triangles` has it
    size: Floats
    thin: Floats  # (k,) least half thickness of the solid [m], inf without another side
    friction: Floats  # (k, n) coefficients, as the nodes' ropes have them [1]
    spin: Floats  # (k, 3) [rad/s], start and stop [s]
    motion: Motions  # of `center`
    turns: Motions  # x is the angle about the axis [rad], besides that of `spin`
    stiffness: Floats  # (k, n) of a contact, across and along [N/m]
    damping: Floats  # (k, n) [N s/m]
    ratio: Floats  # (k,) damping across over damping along [1], less than 1 where nodes are thrown back
    thickness: Floats  # (n,) from the rope's middle to its surface [m]
    hard: Floats  # (k, n) what is added to the stiffness where one is pressed deep [N/m], see `hardening`
    firmness: Floats  # (n,) damping ratio of one pressed deep, for the node as it strikes [1]
    diameter: Floats  # (n,) of the rope, whether the distance counts from its surface or not [m]
    # Those that turn freely, wheels, have a row of their own; w of them.
    wheel: Ints  # (k,) that row, -1: it does not
    inertia: Floats  # (w,) about the axis [kg m^2]
    bearing: Floats  # (w,) torque of the bearing's friction [N m]
    viscous: Floats  # (w,) the same per rate [N m s]
    rate: Floats  # (w,) at time zero [rad/s]
    # (w, 2) torque of the body's weight about its axis as it starts, and a quarter of a turn on [N m]
    weight: Floats


class Memory(NamedTuple):
    """What contacts remember of the last accepted step."""

    # (k, GRIPS, n) force of the friction spring [N], coefficient of friction, R_n [N], the spring's stiffness
    # [N/m], the damper [N s/m], the rate of the coefficient [1/s] and how long it lasts [s]
    grip: Floats
    place: Floats  # (3, n) [m]
    given: Floats  # (n,) what moving surfaces have given to nodes so far, where any did [J]
    books: Floats  # (k, BOOKS, n) see `contact_books`
    slip: Floats  # (k, WAYS, n) ways over each obstacle in the last step [m], see `contact_books`
    way: Floats  # (3, n) in the last step [m]
    load: Floats  # (k, 3) of the ropes on each obstacle as the last step ended [N], NaN before the first
    wheel: Floats  # (w, WIDTH) see `wheel_rows`
    ties: Floats  # (w, ROWS, n) working space of wheels
    # (n,) which obstacle a node would have gone through in a step, from 1 on; from -1 down the segment after
    through: Ints
    fault: Ints  # (n,) the same of a step that was taken
    held: Ints  # (n,) 1: something holds the node, no obstacle touches it; see `held_nodes`
    # (1,) end of the step in hand [s] where velocities are ways from its begin over the time; see
    # `obstacle_lead`
    until: Floats


def lower(
    obstacles: Sequence[Obstacle] | None,
    layout: Layout,
    ropes: Sequence[Rope],
    whole: Sequence[float],
    gravity: float,
    up: Sequence[float] = (0.0, 0.0, 1.0),
    masses: Floats | Sequence[float] = (),
) -> Obstacles:
    """Return the table of a scene's obstacles; `whole` is a rope's mass with all it is tied to [kg].

    `gravity` is its size [m/s^2], `up` the way against it, `masses` what each contact stops [kg], (n,).
    """
    bodies = tuple(obstacles or ())
    places = [place_of(body) for body in bodies]
    count, n = len(bodies), layout.nodes
    own, mass, struck, thickness, most = np.zeros((5, n))
    diameter, firmly = np.ones(n), np.ones(n)
    firm, friction = np.zeros((2, count, n))
    for rope, span, all_mass in zip(ropes, layout.ropes, whole, strict=True) if bodies else ():
        nodes = slice(span.first, span.last + 1)  # those still on a drum, too
        stiff, weight = node_stiffness(rope, all_mass)
        own[nodes], mass[nodes] = stiff, weight
        here = slice(span.start, span.end + 1)
        own[here], mass[here] = _loaded(rope, stiff, weight, all_mass)
        struck[nodes], struck[here] = weight, striking(rope, mass[here])
        firmly[nodes] = firmness(rope, struck[nodes], all_mass)
        most[nodes], most[here] = _most(rope, weight), [_most(rope, one) for one in mass[here]]
        thickness[nodes], diameter[nodes] = radius_of(rope), rope.diameter
        for row, body in enumerate(bodies):
            firm[row, nodes] = _firm(rope, gravity * all_mass, radius_round(body), weight)
            friction[row, nodes] = body.friction_with(rope)
    stiffness, hard = stiffnesses(bodies, own, firm, most)
    ratio, hit = rebounds(bodies, struck, np.asarray(masses) if len(masses) else mass)
    centers, hubs, motion = wherever(bodies, places)
    wheels = wheel_columns(bodies, -gravity * np.array(up, dtype=np.float64))
    levers = [w >= 0 and wheels["weight"][w].any() for w in wheels["wheel"]]
    return Obstacles(
        kind=np.array([KINDS[body.kind] for body in bodies], dtype=np.int64),
        center=centers,
        axis=np.array([place[1] for place in places], dtype=np.float64).reshape(count, 3),
        axle=np.array([axle_of(body) for body in bodies], dtype=np.float64).reshape(count, 3),
        hub=hubs,
        sweeps=np.array([*map(sweeps, bodies)], dtype=bool).astype(np.int64)
        | np.array(levers, dtype=bool),
        size=size_rows([place[2] for place in places]),
        thin=np.array([half_thickness(body) for body in bodies], dtype=np.float64),
        friction=friction,
        spin=np.array([spin_of(body) for body in bodies], dtype=np.float64).reshape(count, 3),
        motion=motion,
        turns=motion_rows([turning_of(body) for body in bodies], np.zeros((count, 3))),
        stiffness=stiffness,
        damping=2.0 * DAMPING * np.sqrt(stiffness * hit),
        ratio=ratio,
        thickness=thickness,
        hard=hard,
        firmness=firmly,
        diameter=diameter,
        **wheels,
    )


def radius_of(rope: Rope) -> float:
    """Return half a rope's diameter where one is given [m], else 0."""
    return 0.5 * rope.diameter if "diameter" in rope.model_fields_set else 0.0


def node_stiffness(rope: Rope, whole: float, mass: float | None = None) -> tuple[float, float]:
    """Return the stiffness of a contact [N/m] and the mass [kg] of an inner node, or one of `mass`.

    `whole` is the mass of the rope and all that joints tie to it [kg].
    """
    own = rope.own_mass / max(rope.nodes, 1) if mass is None else mass
    inert, whole = own / FRAME**2, whole / FRAME**2
    k = rope.segment_stiffness
    shown = math.sqrt(inert**2 + 4.0 * k * inert) if math.isfinite(k) else whole
    return min(min(shown, whole) / SHARE, _most(rope, own)), own


def _firm(rope: Rope, weight: float, radius: float, mass: float) -> float:
    """Return how stiff contacts of nodes of `mass` [kg] with a body of `radius` [m] must be [N/m].

    `weight` is that of all that hangs on the rope [N]. 0: as stiff as the rope asks for, on flat bodies and
    those without a radius.
    """
    if not radius > 0.0:
        return 0.0
    pull = weight + sum(math.hypot(*one.force) for one in rope.forces)
    turn = min(rope.segment_length / (radius + 0.5 * rope.diameter), SHARP)
    return min(pull * turn / (FIRM * rope.diameter), _most(rope, mass))


def _most(rope: Rope, mass: float) -> float:
    """Return the stiffness of a contact that steps for the rope allow for as well [N/m]."""
    return max(rope.segment_stiffness, mass / FRAME**2)


def _loaded(rope: Rope, stiffness: float, mass: float, whole: float) -> tuple[Floats, Floats]:
    """Return stiffness and mass of all nodes, those with loads on them stiffer, (nodes,) each."""
    masses, found = np.full(rope.nodes, mass), np.full(rope.nodes, stiffness)
    for load in rope.loads:
        masses[rope.node_index(load.node)] += load.mass
    for node in {rope.node_index(load.node) for load in rope.loads}:
        found[node] = node_stiffness(rope, whole, float(masses[node]))[0]
    return found, masses


def acts(obstacles: Obstacles) -> bool:
    """Tell whether there is any obstacle."""
    return len(obstacles.kind) > 0


def memory(obstacles: Obstacles, x: Floats, stiffness: Floats, held: Ints) -> Memory:
    """Return what is remembered at the start, for nodes at places (3, n) [m]: no force; `held` as there."""
    count, n, wheels = len(obstacles.kind), x.shape[1], len(obstacles.inertia)
    passes = np.zeros((2, n if count else 0), np.int64)
    own = np.zeros((wheels, WIDTH)), np.zeros((wheels, ROWS, n)), passes[0], passes[1].copy()
    last = (held.copy() if count else passes[0].copy()), np.zeros(min(count, 1))
    grip, books, slip = (np.zeros((count, rows, n)) for rows in (GRIPS, BOOKS, WAYS))
    load = np.full((count, 3), np.nan)
    grip[:, STIFF], grip[:, DAMP] = obstacles.stiffness, obstacles.damping
    if count == 0:
        none = np.zeros((3, 0))
        return Memory(grip, none, np.zeros(0), books, slip, none.copy(), load, *own, *last)
    found = Memory(grip, x.copy(), np.zeros(n), books, slip, np.zeros_like(x), load, *own, *last)
    found.wheel[:, RATE] = obstacles.rate
    remember_contacts(x, np.zeros_like(x), obstacles, found, np.zeros(2), stiffness)
    grip[:, PUSH] *= grip[:, PUSH] > TOUCHES * obstacles.diameter * obstacles.stiffness
    load[:] = np.nan  # what a shape presses as it is drawn is no load
    return found


def kinks(obstacles: Obstacles) -> Floats:
    """Return the times at which the velocity or the turning of an obstacle jumps [s]."""
    spin = obstacles.spin[:, 1:].ravel()
    return np.concatenate([spin, jumps(obstacles.motion), jumps(obstacles.turns)])


@part
def force(obstacles, state, x, v, force, lo, hi):
    """Write the force of all obstacles on every node [N], (3, n)."""
    contact_forces(x, v, obstacles, state.memory.obstacle, state.now, force, lo, hi)


@part
def tangent(obstacles, state, x, v, weight_x, weight_v, marks, band):
    """Add the derivatives of the force."""
    contact_tangent(x, v, obstacles, state.memory.obstacle, state.now, weight_x, weight_v, band)


@part
def remember(obstacles, state):
    """Keep what contacts carry at the state; return how many have closed."""
    memory, inert, now = state.memory.obstacle, state.inverse_mass, state.now
    place, fault = memory.place, memory.fault
    find_pass(place, state.x, inert, obstacles, memory.grip, memory.wheel, fault, now)
    find_sweep(place, state.x, inert, state.stiffness, obstacles, memory.wheel, fault, now)
    closed = remember_contacts(state.x, state.v, obstacles, memory, now, state.stiffness)
    follow_held(state.x, obstacles, memory, inert, now)  # last: the body's way so far is no slip
    return closed


@part
def wound(obstacles, state, winches):
    """Let go what drums hold from now on, and touch what has come off."""
    follow_held(state.x, obstacles, state.memory.obstacle, state.inverse_mass, state.now)


@part
def book(obstacles, state, force, middle, dt):
    """Book what a step's mean forces have done."""
    book_contacts(state.memory.obstacle, force, middle, dt)


@part
def hits(obstacles, state, force, dt, x, v):
    """Return how quickly a surface stops nodes in a step [1/s], see `contact.quickest_impact`."""
    return quickest_impact(state, force, dt, obstacles, state.memory.obstacle)


@part
def crossings(obstacles, before, after, dt, tolerance):
    """Return where a step is to end [s], inf: where it does, and how many nodes stopped, met or left it."""
    return contact_events(obstacles, before, after, dt, tolerance)


@part
def touch(obstacles, state, force):
    """Write the force of all obstacles at the state itself [N], (3, n)."""
    memory, now = state.memory.obstacle, state.now
    contact_forces(state.x, state.v, obstacles, memory, now, force, 0, ALL)


@part
def rounding(obstacles, state, x):
    """Return what rounding of the places does to the force [N]."""
    return contact_rounding(x, obstacles)


@part
def energy(obstacles, state, x):
    """Return what the surfaces have stored [J]."""
    return contact_energy(x, obstacles, state.memory.obstacle, state.now)


@part
def given(obstacles, state, x):
    """Return what moving and turning obstacles have given so far [J]."""
    return contact_given(state.memory.obstacle)


def at_rest(obstacles: Obstacles) -> Rest:
    """They bear what lies on them."""
    return Rest.BEARS


def touched(obstacles: Obstacles, x: Floats) -> Any:
    """Return which nodes are below the surface of an obstacle where it starts, (n,)."""
    return (depths(obstacles, x) > 0.0).any(axis=0)


def channels(obstacles: Obstacles) -> int:
    """Return how many rows the forces have, with what presses and what rubs of every obstacle."""
    return 3 + 6 * len(obstacles.kind)


def cases(obstacles: Obstacles, chain: Chain) -> dict[str, Chain]:
    """Return a chain all of whose nodes are pressed to the stiffest obstacle, or to three, as in a corner."""
    most, k, c = min(len(obstacles.kind), 3), obstacles.stiffness, obstacles.damping
    stiff = k + obstacles.hard
    damped = c * np.maximum(1.0, obstacles.firmness * np.sqrt(stiff / k))
    return {
        "pressed to obstacles": chain._replace(
            node_stiffness=chain.node_stiffness + most * stiff.max(axis=0),
            node_damping=chain.node_damping + most * damped.max(axis=0),
        )
    }


OBSTACLE = NodeLaw(
    name="obstacle",
    section="obstacles",
    lower=lower,
    inputs=("layout", "ropes", "whole", "gravity", "up", "masses"),
    acts=acts,
    force=force,
    tangent=tangent,
    is_local=always,
    memory=memory,
    remember=remember,
    book=book,
    channels=channels,
    hits=hits,
    crossings=crossings,
    touch=touch,
    rounding=rounding,
    kinks=kinks,
    energy=energy,
    given=given,
    still=all_stand,
    at_rest=at_rest,
    bears=touched,
    cases=cases,
    meet=meet,
    fault=gone,
    wound=wound,
)
