"""Scene -> System (constant) and State (what evolves)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ropewalk.core.arrays import (
    Floats,
    Forces,
    Ints,
    Limiter,
    State,
    System,
    Work,
)
from ropewalk.core.peaks import no_peaks
from ropewalk.core.status import BREAK_STRETCH
from ropewalk.laws.acting import section_of
from ropewalk.laws.anchors import anchor_places
from ropewalk.laws.registry import NODE_LAWS, NodeArrays, NodeTables
from ropewalk.lowering.bending_tables import add_bending, no_bending
from ropewalk.lowering.dampers import masses_to_stop, suited
from ropewalk.lowering.elastic_tables import elastic_tables, remembers, said_by, softest
from ropewalk.lowering.going_alike import going_alike
from ropewalk.lowering.joint_tables import join, joint_tables
from ropewalk.lowering.layout import Layout, Span
from ropewalk.lowering.limiter_order import Order, limiter_order
from ropewalk.lowering.masses import line, line_density, masses, passing
from ropewalk.lowering.motion_rows import anchor_tables
from ropewalk.lowering.pieces import Pieces
from ropewalk.lowering.remembered import with_memory
from ropewalk.lowering.slide_checks import put_on_ropes
from ropewalk.lowering.variant import rare_of
from ropewalk.lowering.winch_tables import winch_tables, winches_of
from ropewalk.methods.kinks import kink_times
from ropewalk.scene import Limiter as LimiterInScene
from ropewalk.scene import Rope, Scene, Springs
from ropewalk.scene.bound_ropes import bound_ropes
from ropewalk.scene.joint import tied_ropes
from ropewalk.scene.obstacles import is_free


def make_tables(
    scene: Scene, layout: Layout, keep: Pieces, *, drawn: bool = True
) -> tuple[System, State]:
    """Return the constant tables and the state at time zero; `keep` has their pieces.

    With `drawn` off places are to come: nothing is said of joints whose nodes lie apart.
    """
    state = _ropes(scene, layout, keep)
    if drawn:
        put_on_ropes(scene, layout, state)
        join(scene, layout, state)
    system = _system(scene, layout, state, keep)
    if remembers(system.elastic):
        state = state._replace(inner=np.zeros((4, layout.segments)))
    system, state = add_bending(scene, layout, system, state, keep)
    turns = tuple(
        law.kinks(table)
        for law, table in zip(NODE_LAWS, system.node, strict=True)
        if law.kinks is not None
    )
    kinks = keep("kinks", kink_times, system.anchors, system.bending, *turns)
    system = system._replace(kinks=kinks)
    _hold(system, state, keep)
    return system, with_memory(system, state)


def _applied(layout: Layout, ropes: tuple[Rope | None, ...], gravity: float, up: Any) -> Floats:
    """Return the constant forces on all nodes [N], (3, n): those given, and the water's lift.

    `gravity` is its size [m/s^2].
    """
    applied = np.zeros((3, layout.nodes))
    for rope, span in zip(ropes, layout.ropes, strict=True):
        if rope is not None:
            _add_forces(rope, gravity, up, applied[:, span.start : span.end + 1])
    return applied


def _add_forces(rope: Rope, gravity: float, up: Any, applied: Floats) -> None:
    """Add a rope's forces [N], (3, nodes); gravity's size [m/s^2]."""
    for force in rope.forces:
        applied[:, rope.node_index(force.node)] += force.force
    if rope.submerged_weight is None:
        return
    share = np.full(rope.nodes, rope.segment_length)
    share[[0, -1]] *= 0.5
    weight = line_density(rope) * share
    if isinstance(rope.made_of, Springs):
        weight = np.full(rope.nodes, rope.made_of.node_mass)
        share[:] = rope.length_unstretched / rope.nodes
    applied += np.outer(up, weight * gravity - rope.submerged_weight * share)


def _form(rope: Rope) -> tuple[Any, ...]:
    """Return all that the places of a rope's nodes follow from."""
    thick = rope.diameter if rope.shape.of_diameter else 0.0
    return rope.shape, rope.segments, rope.length_unstretched, rope.segment_length, thick


def _places(layout: Layout, forms: tuple[tuple[Any, ...], ...], up: Any) -> Floats:
    """Return the places of all nodes [m], (3, n); rope on a drum waits where the drum is."""
    x = np.zeros((3, layout.nodes))
    for (shape, segments, length, one, thick), span in zip(forms, layout.ropes, strict=True):
        x[:, span.start : span.end + 1] = shape.places(segments, length, one, up, thick).T
        x[:, span.first : span.start] = x[:, span.start, None]
        x[:, span.end + 1 : span.last + 1] = x[:, span.end, None]
    return x


def _velocities(layout: Layout, ropes: tuple[tuple[Any, ...], ...]) -> Floats:
    """Return the velocities of all nodes [m/s], (3, n), from those of the ropes and their kicks."""
    v = np.zeros((3, layout.nodes))
    for (whole, kicks), span in zip(ropes, layout.ropes, strict=True):
        v[:, span.start : span.end + 1] = np.array(whole)[:, None]
        for kick in kicks:
            v[:, span.start + kick.node % (span.end - span.start + 1)] = kick.velocity
    return v


def _along(layout: Layout, values: tuple[float, ...]) -> Floats:
    """Return a number per segment, (s,): the same all along a rope, 0 between ropes and on drums."""
    out = np.zeros(layout.segments)
    for value, span in zip(values, layout.ropes, strict=True):
        out[span.start : span.end] = value
    return out


def _rubs(rope: Rope, form: str) -> float:
    """Return the friction of a rope's segments where it is of that form [N s/m]."""
    if rope.made_of.friction != form or (form != "vector" and rope.rigid):
        return 0.0  # no length changes, nothing rubs along it
    return rope.segment_friction


def _ropes(scene: Scene, layout: Layout, keep: Pieces) -> State:
    n, s = layout.nodes, layout.segments
    a, w = len(scene.anchors), len(scene.winches)
    k = len(layout.surfaces) if scene.obstacles else 0
    ropes, up = scene.ropes, scene.up
    forms = tuple(map(_form, ropes))
    x = keep("places", _places, layout, forms, up).copy()
    kicked = tuple((rope.shape.velocity, rope.kicks) for rope in ropes)
    v = keep("velocities", _velocities, layout, kicked).copy()
    mass, inverse = keep("masses", masses, layout, tuple(map(line, ropes)))
    pushed = tuple(r if r.forces or r.submerged_weight is not None else None for r in ropes)
    upward = (math.hypot(*scene.gravity), up) if any(pushed) else (0.0, ())
    applied = keep("applied", _applied, layout, pushed, *upward)
    lengths = keep("lengths", _along, layout, tuple(rope.segment_length for rope in ropes))
    stiffness = keep("stiffness", _along, layout, tuple(rope.segment_stiffness for rope in ropes))
    vector = keep("vector", _along, layout, tuple(_rubs(rope, "vector") for rope in ropes))
    axial = keep("axial", _along, layout, tuple(_rubs(rope, "axial") for rope in ropes))
    exits = [_exit(layout.span(winch.rope), winch.end) for winch in scene.winches]
    return State(
        x=x,
        v=v,
        acceleration=np.zeros((3, n)),
        mass=mass,
        inverse_mass=inverse.copy(),  # held nodes get 0
        tension=np.zeros(s),
        limited=np.zeros(s if scene.limiter else 0),
        drift=np.zeros((3, n)),
        past=np.zeros(6),
        rest_length=lengths,
        stiffness=stiffness,
        damping_vector=vector,
        damping_axial=axial,
        held=np.ones(a, np.int64),
        anchor_node=np.array(layout.anchor_nodes, dtype=np.int64),
        anchor_x=np.zeros((a, 3)),
        anchor_v=np.zeros((a, 3)),
        reaction=np.zeros((a, 3)),
        winch_exit=np.array(exits, dtype=np.int64),
        winch_rate=np.zeros(w),
        winch_debt=np.zeros(w),
        winch_paid=np.zeros(w),
        bending_stiffness=np.zeros(0),
        bending_damping=np.zeros(0),
        clamp_direction=np.zeros((0, 3)),
        clamp_spin=np.zeros((0, 3)),
        moment=np.zeros((0, 6)),
        tied=np.ones(len(scene.joints), np.int64),
        joint_force=np.zeros((sum(len(joint.points) for joint in scene.joints), 3)),
        now=np.zeros(2),
        jolt=np.zeros(1),
        memory=NodeArrays(*(np.zeros(0) for _ in NODE_LAWS)),
        forces=_no_forces(n, applied, scene.limiter is not None),
        work=_no_work(s, n, a),
        inner=np.zeros((4, 0)),
        most=np.zeros(a + 1),
        balance=np.zeros(5),
        peaks=no_peaks(s, n, a, k) if scene.run.extremes else no_peaks(0, 0, 0),
    )


def _no_forces(n: int, applied: Floats, limited: bool) -> Forces:
    """Return the forces of n nodes before any is evaluated; `applied` (3, n) are those given."""
    of_segments, none = (3, n + 1), (3, 0)
    return Forces(
        elastic=np.zeros(of_segments),
        friction=np.zeros(of_segments),
        node=NodeArrays(*(np.zeros((3, n)) for _ in NODE_LAWS)),
        applied=applied,
        bending=np.zeros(none),
        limiter=np.zeros(of_segments if limited else none),
    )


def _no_work(s: int, n: int, a: int) -> Work:
    """Return the works of s segments, n nodes and a anchors before the first step."""
    return Work(
        elastic=np.zeros(s),
        friction=np.zeros(s),
        weight=np.zeros(n),
        node=NodeArrays(*(np.zeros(n) for _ in NODE_LAWS)),
        applied=np.zeros(n),
        anchors=np.zeros(a),
        limiter=np.zeros(2),
        winch=np.zeros(2),
        bending=np.zeros(0),
        clamps=np.zeros(0),
    )


def _exit(span: Span, end: str) -> int:
    return span.start if end == "start" else span.end


def _system(scene: Scene, layout: Layout, state: State, keep: Pieces) -> System:
    ropes, applied = scene.ropes, state.forces.applied
    one_way = tuple(rope.made_of.tension_only for rope in ropes)
    floor = keep("slack floor", _slack_floor, layout, one_way)
    origins = state.x[:, state.anchor_node].T.copy()
    elastic = keep("elastic", elastic_tables, layout, said_by(ropes))
    stretch = state.mass, applied, softest(elastic, state.stiffness), state.rest_length
    limiter, tables = scene.limiter, _node_tables(scene, layout, state.mass, keep)
    joints = keep("joints", joint_tables, scene.joints, layout)
    alike = keep("alike", going_alike, scene.anchors, scene.joints, scene.slides, layout)
    order = keep("limiter order", limiter_order, layout, joints) if limiter is not None else None
    return System(
        gravity=np.array(scene.gravity, dtype=np.float64),
        flags=keep("flags", _flags, applied, state.damping_axial, floor),
        break_stretch=keep("break stretch", _break_stretch, scene.gravity, *stretch),
        slack_floor=floor,
        up=keep("up", np.array, scene.up),
        node=tables,
        acts=np.array(
            [law.acts(table) for law, table in zip(NODE_LAWS, tables, strict=True)], np.int64
        ),
        limiter=keep("limiter", _limiter, limiter, order),
        anchors=keep("anchors", anchor_tables, scene.anchors, origins, state.anchor_node, alike),
        winches=winch_tables(scene, layout)
        if scene.winches
        else keep("no winches", winches_of, ()),
        bending=no_bending(),
        joints=joints,
        elastic=elastic,
        kinks=np.zeros(0),
        rare=rare_of(scene),
    )


def _node_tables(scene: Scene, layout: Layout, mass: Floats, keep: Pieces) -> Any:
    """Return the tables of the laws of nodes, each made from its section of the scene."""
    thick = tuple(rope.diameter for rope in scene.ropes)
    inputs: dict[str, Any] = {"layout": layout, "diameters": thick}
    inputs |= {
        "gravity": math.hypot(*scene.gravity),
        "up": scene.up,
        "ropes": (),
        "whole": (),
        "masses": (),
        "joints": (),
        "slides": (),
        "winches": (),
        "bound": (),
        "inert": (),
    }
    each = zip(scene.ropes, layout.ropes, strict=True)
    inputs["parts"] = tuple((rope.strength, passing(rope, span)) for rope, span in each)
    if scene.obstacles or scene.slides or scene.contact is not None:  # what only they ask for
        inputs |= {"ropes": scene.ropes, "whole": tied_masses(scene)}
        inputs |= {"joints": scene.joints, "slides": scene.slides, "winches": scene.winches}
    if any(body.restitution > 0.0 for body in scene.obstacles):
        inputs["masses"] = masses_to_stop(scene, layout, mass)
    if scene.contact is not None:
        wheels = any(map(is_free, scene.obstacles))  # ropes on one pull on each other
        bound = [range(len(thick))] if wheels else bound_ropes(scene)
        inputs["bound"] = tuple(map(tuple, bound))  # as pieces compare them
        inputs["inert"] = mass
    tables = NodeTables(
        *(
            keep(law.name, law.lower, section_of(law, scene), *(inputs[n] for n in law.inputs))
            for law in NODE_LAWS
        )
    )
    if not (scene.obstacles and scene.joints):
        return tables
    damping = suited(tables.obstacle, scene, layout, mass)
    return tables._replace(obstacle=tables.obstacle._replace(damping=damping))


def tied_masses(scene: Scene) -> tuple[float, ...]:
    """Return for every rope the mass of all that joints tie together with it, itself included [kg]."""
    found = [rope.total_mass for rope in scene.ropes]
    for group in tied_ropes(scene.ropes, scene.joints):
        whole = sum(scene.ropes[i].total_mass for i in group)
        for i in group:
            found[i] = whole
    return tuple(found)


def _slack_floor(layout: Layout, one_way: tuple[bool, ...]) -> Floats:
    floor = np.full(layout.segments, -math.inf)
    for tension_only, span in zip(one_way, layout.ropes, strict=True):
        if tension_only:
            floor[span.first : span.last] = 0.0
    return floor


def _flags(applied: Floats, axial: Floats, floor: Floats) -> Ints:
    return np.array([applied.any(), axial.any(), (floor == 0.0).any(), 0], dtype=np.int64)


def _break_stretch(
    gravity: Any, mass: Floats, applied: Floats, stiffness: Floats, rest_length: Floats
) -> float:
    """The stretch that tells a broken simulation from a soft rope under all its weight [1]."""
    weight = math.hypot(*gravity) * float(mass.sum())
    weight += float(np.linalg.norm(applied, axis=0).sum())
    softest = stiffness * rest_length
    softest = softest[(softest > 0.0) & np.isfinite(softest)]
    return BREAK_STRETCH + (3.0 * weight / float(softest.min()) if len(softest) else 0.0)


def _limiter(limiter: LimiterInScene | None, order: Order | None) -> Limiter:
    if limiter is None or order is None:
        none = np.zeros(0, np.int64)
        return Limiter(0, 0.0, math.inf, 0, none, np.zeros(0), none, np.zeros((2, 0), np.int64))
    return Limiter(1, limiter.min_stretch, limiter.max_stretch, limiter.passes, *order)


def _hold(system: System, state: State, keep: Pieces) -> None:
    """Put the held nodes where their anchors are at time zero, with the anchors' velocities."""
    nodes = state.anchor_node
    if not len(nodes):
        return
    state.anchor_x[:] = state.x[:, nodes].T
    # what the kernel reads of system and state
    stops = tuple(
        table for law, table in zip(NODE_LAWS, system.node, strict=True) if law.hold_up is not None
    )
    read = system.anchors, stops, state.anchor_x.copy()
    points, speeds = keep("starts", lambda *_: _starts(system, state), *read)
    held = system.anchors.release > 0.0
    state.held[:] = held
    state.anchor_x[held], state.anchor_v[held] = points[held], speeds[held]
    nodes = nodes[held]
    state.x[:, nodes], state.v[:, nodes] = points[held].T, speeds[held].T
    state.inverse_mass[nodes] = 0.0
    joints = system.joints
    for row in np.flatnonzero(held & (joints.of_anchor >= 0)):
        j, node = joints.of_anchor[row], state.anchor_node[row]
        others = joints.member[joints.first[j] : joints.first[j + 1]]
        state.x[:, others], state.v[:, others] = state.x[:, [node]], state.v[:, [node]]
        state.inverse_mass[others] = 0.0


def _starts(system: System, state: State) -> tuple[Floats, Floats]:
    """Return where the anchors are at time zero [m] and their velocities [m/s], (a, 3) each."""
    points, speeds = np.zeros_like(state.anchor_x), np.zeros_like(state.anchor_x)
    for row in range(len(points)):
        anchor_places(system, state, row, np.zeros(1), points[row], speeds[row], np.zeros((1, 3)))
    return points, speeds
