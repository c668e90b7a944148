"""What each command does to a session. All raise SceneError when it cannot be done."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live import edits, ties
from ropewalk.live.anew import LEAVE_OUT, Anew, begun_with
from ropewalk.live.bodies import lead
from ropewalk.live.carry import can_part
from ropewalk.live.changes import label_of
from ropewalk.live.commands import (
    Back,
    Compare,
    Cut,
    Drag,
    Drop,
    Grab,
    Kick,
    Knot,
    LetGo,
    Load,
    Move,
    Obstacle,
    Pin,
    Remedy,
    Reset,
    SceneCommand,
    Set,
    Speed,
    Tie,
    Undo,
    Unpin,
    Untie,
    Vector,
)
from ropewalk.live.counterparts import counterpart, segment_of
from ropewalk.live.hands import FASTEST, MOST_GRABS, Target
from ropewalk.live.hands import Grab as Grabbed
from ropewalk.live.parameters import named, refusal
from ropewalk.live.remedies import calm_moment, implicit_method, suggested_step
from ropewalk.live.sources import Read, Start, from_toml, scene_of
from ropewalk.live.track import Track
from ropewalk.live.wound_ropes import is_wound
from ropewalk.lowering import Layout
from ropewalk.scene import Scene

if TYPE_CHECKING:
    from ropewalk.live.session import Session


def speed(session: Session, command: Speed, client: int) -> str:
    session.speed = command.value
    return ""


def reset(session: Session, command: Reset, client: int) -> str:
    return begin_anew(session, command, Anew.of(session, original=command.all).tracks())


def begin_anew(session: Session, command: Reset, made: list[Track]) -> str:
    """Take variants at time zero in place of the present ones."""
    made[0].count = session.count
    session.tracks = made
    if command.all:
        session.changes = {}
    session.broken = None
    session.remember(clear=True)
    session.changed()
    return ""


def set_(session: Session, command: Set, client: int) -> str:
    if command.variant is not None and command.variant >= len(session.tracks):
        rule = f"must be from 0 to {len(session.tracks) - 1}"
        raise refusal("variant", command.variant, rule)
    session.set(command.name, command.value, command.rope, command.variant)
    return ""


def move(session: Session, command: Move, client: int) -> str:
    for track in session.tracks:
        handle = _anchor(track, command.anchor, required=track is session.main)
        if handle is not None:
            track.hands.still(track.simulation, command.anchor)
            handle.velocity = command.velocity
            if any(command.velocity):
                track.hands.movers[command.anchor] = client
    return ""


def drag(session: Session, command: Drag, client: int) -> str:
    for track in session.tracks:
        if _anchor(track, command.anchor, required=track is session.main) is not None:
            track.hands.targets[command.anchor] = Target(
                np.array(command.target), client, command.pace
            )
            track.hands.fresh = True
    return ""


def drop(session: Session, command: Drop, client: int) -> str:
    for track in session.tracks:
        if command.anchor in track.simulation.anchors:
            track.hands.still(track.simulation, command.anchor)
    return ""


def obstacle(session: Session, command: Obstacle, client: int) -> str:
    there = session.main.simulation.obstacles
    if command.obstacle not in there:
        rule = f"no such obstacle; there is {', '.join(there) or 'none'}"
        raise refusal("obstacle", command.obstacle, rule)
    target = None if command.target is None else np.array(command.target)
    for track in session.tracks:
        handle = track.simulation.obstacles.get(command.obstacle)
        if handle is not None:
            lead(handle, target, command.angle, command.pace)
    return ""


def grab(session: Session, command: Grab, client: int) -> str:
    main = session.main
    edits.at_node(main.simulation.layout, command.node)
    name = main.holder(command.node)
    if name is not None:
        raise refusal("node", command.node, f"is held by anchor {name!r}; drag that")
    here = [one for one in main.hands.grabs if (one.node, one.owner) == (command.node, client)]
    if not here and len(main.hands.grabs) >= MOST_GRABS:
        raise refusal("node", command.node, f"{MOST_GRABS} nodes are grabbed already")
    for track in session.tracks:
        node = counterpart(main.simulation, track.simulation, command.node)
        if node is not None and track.holder(node) is None:
            track.hands.grab(
                Grabbed(
                    node,
                    np.array(command.target),
                    client,
                    allowed=command.limit,
                    pace=command.pace,
                )
            )
    return ""


def let_go(session: Session, command: LetGo, client: int) -> str:
    for track in session.tracks:
        node = command.node
        if node is not None:
            node = counterpart(session.main.simulation, track.simulation, node)
        if command.node is None or node is not None:
            held = any((one.node, one.owner) == (node, client) for one in track.hands.grabs)
            track.hands.let_go(track.simulation, client, node)
            if node is not None and held and command.velocity is not None:
                track.throw(node, _no_faster(command.velocity))
        if command.node is None:
            track.hands.stop(track.simulation, client)
    return ""


def _no_faster(velocity: Vector) -> Floats:
    """A hand's velocity [m/s], at most what hands may have."""
    size = float(np.linalg.norm(velocity))
    return np.array(velocity) * min(1.0, FASTEST / max(size, 1e-9))


def pin(session: Session, command: Pin, client: int) -> str:
    name = session.main.holder(command.node)
    if name is not None:
        raise refusal("node", command.node, f"is held by anchor {name!r} already")
    name = edits.free_name([track.scene for track in session.tracks], "pin")
    return _on_node(session, command.node, partial(edits.pin, name=name), free=True)


def unpin(session: Session, command: Unpin, client: int) -> str:
    name = command.anchor
    if name is None:
        if command.node is None:
            raise refusal("anchor", None, "give an anchor's name or a node")
        edits.at_node(session.main.simulation.layout, command.node)
        name = session.main.holder(command.node)
        if name is None:
            raise refusal("node", command.node, "is held by no anchor")
    for track in session.tracks:
        if track is session.main or name in track.simulation.anchors:
            track.restructure(lambda scene, layout: edits.drop_anchor(scene, layout, name))
    return _structured(session)


def cut(session: Session, command: Cut, client: int) -> str:
    main = session.main.simulation
    middles = [segment_of(main, track.simulation, command.segment) for track in session.tracks]
    note = ""
    for track, segment in zip(session.tracks, middles, strict=True):
        if segment is not None and (track is session.main or _cuttable(track, segment)):
            done = track.restructure(partial(_cut, segment=segment))
            note = note or done
    _structured(session)
    return note


def untie(session: Session, command: Untie, client: int) -> str:
    for track in session.tracks:
        if track is session.main or command.joint in [one.name for one in track.scene.joints]:
            track.restructure(partial(edits.untie, name=command.joint))
    return _structured(session)


def tie(session: Session, command: Tie, client: int) -> str:
    main, note = session.main.simulation, ""
    for node in (command.node, command.other):
        edits.at_node(main.layout, node)
    for track in session.tracks:
        pair = [counterpart(main, track.simulation, i) for i in (command.node, command.other)]
        if pair[0] is not None and pair[1] is not None:
            said = ties.begin(track, (pair[0], pair[1]), client)
            note = note or said
    _structured(session)
    return note


def knot(session: Session, command: Knot, client: int) -> str:
    notes = [
        ties.end(track, pull)
        for track in session.tracks
        for pull in track.hands.over(track.simulation)
    ]
    _structured(session)
    return "; ".join(dict.fromkeys(filter(None, notes)))


def load(session: Session, command: Load, client: int) -> str:
    return _on_node(session, command.node, partial(edits.load, mass=command.mass))


def kick(session: Session, command: Kick, client: int) -> str:
    for track in session.tracks:
        node = counterpart(session.main.simulation, track.simulation, command.node)
        if track is session.main:
            track.kick(command.node, np.array(command.velocity))
        elif node is not None and track.holder(node) is None:
            track.kick(node, np.array(command.velocity))
    return ""


def scene(session: Session, command: SceneCommand, client: int) -> str:
    session.adopt(opened(type(session), command, session.start))
    return ""


def opened(
    kind: type[Session], command: SceneCommand, start: Start, read: Read = from_toml
) -> Session:
    """Return a session of the scene that a command asks for, at time zero. Raises SceneError."""
    made, preset, settings = scene_of(command, start, read)
    session = begun_with(kind, made, preset) if settings else kind(made, preset)
    for name, rope, value in settings:
        session.set(name, value, rope, None)
    if settings:
        anew = Anew.of(session, original=False, remedy=LEAVE_OUT)
        begin_anew(session, Reset(type="reset"), anew.tracks())
    return session


def compare(session: Session, command: Compare, client: int) -> str:
    made = [session.main]
    for number, variant in enumerate(command.variants, start=1):
        changes = {
            name: named(name).checked(_auto(name, value, session))
            for name, value in variant.changes.items()
        }
        label = variant.label or label_of(changes) or f"variant {number}"
        made.append(session.main.clone(label, changes))
        made[-1].given = bool(variant.label)
    session.tracks = made
    session.broken = None
    session.undo.clear()
    session.remember(clear=True)
    session.changed()
    return ""


def back(session: Session, command: Back, client: int) -> str:
    moments = session.history.newest_first()
    if command.seconds is None:
        found = calm_moment(session)
    else:
        latest = session.time - command.seconds
        found = next((one for one in moments if one.time <= latest), moments[-1])
    session.go_back(found)
    session.broken = None
    return ""


def undo(session: Session, command: Undo, client: int) -> str:
    if not session.undo_last():
        raise refusal("", None, "there is nothing to undo")
    return ""


def remedy(session: Session, command: Remedy, client: int) -> str:
    if session.broken is None:
        raise refusal("remedy", command.remedy, "nothing is broken")
    changes = dict(session.changes)
    variant = session.broken.variant or None
    track = session.tracks[session.broken.variant]
    value: Any = None
    if command.remedy == "step":
        value = suggested_step(track.simulation)
    elif command.remedy == "implicit":
        value = implicit_method(track.simulation)
    wanted, layout = session.main.scene, session.main.simulation.layout
    if command.remedy != "on" or _was_so(session, layout):  # nothing to go back to after a cut
        session.go_back(calm_moment(session, layout=layout))
    session.broken = None
    if command.remedy == "back":
        return ""
    _take_constants(session, wanted, changes)
    if command.remedy == "on":
        return ""
    session.set("time_step" if command.remedy == "step" else "method", value, None, variant)
    return ""


def _was_so(session: Session, layout: Layout) -> bool:
    """Whether the history reaches back to ropes like the present ones."""
    moments = session.history.newest_first()
    return any(one.tracks[0].simulation.layout == layout for one in moments)


def _take_constants(session: Session, wanted: Any, changes: dict[Any, Any]) -> None:
    """Give the first variant the constants that it broke with, where its ropes are still the same."""
    track = session.main
    layout = edits.layout_of(wanted)
    if layout == track.simulation.layout and wanted != track.scene:
        track.edit(edits.Edit(wanted, edits.same_nodes(layout)))
        session.changes = changes


def _auto(name: str, value: Any, session: Session) -> Any:
    from ropewalk.live.track import automatic_step

    return automatic_step(session.scene) if (name, value) == ("time_step", "auto") else value


def _anchor(track: Track, name: str, *, required: bool) -> Any:
    handle = track.simulation.anchors.get(name)
    if handle is None and required:
        there = ", ".join(track.simulation.anchors) or "none"
        raise refusal("anchor", name, f"no such anchor; there is {there}")
    if handle is not None and not handle.holds:
        if required:
            raise refusal("anchor", name, "has let go of its node and moves nothing")
        return None
    return handle


def _cuttable(track: Track, segment: int) -> bool:
    """Tell whether there is something to cut in a variant: not where its wound rope has parted, or is in."""
    wound = is_wound(track.scene, track.simulation.layout.rope_of(segment)[0])
    return not wound or can_part(track.simulation, segment)


def _cut(scene: Scene, layout: Layout, segment: int) -> edits.Edit:
    return edits.cut(scene, layout, segment)


def _on_node(
    session: Session, node: int, make: Callable[..., edits.Edit], *, free: bool = False
) -> str:
    """Make an edit of a node in all variants that have it; with `free`, where no anchor holds it."""
    main, note = session.main.simulation, ""
    nodes = [counterpart(main, track.simulation, node) for track in session.tracks]
    edits.at_node(main.layout, node)
    for track, here in zip(session.tracks, nodes, strict=True):
        if here is not None and not (free and track.holder(here) is not None):
            note = track.restructure(partial(make, index=here)) or note
    _structured(session)
    return note


def _structured(session: Session) -> str:
    session.changed()
    return ""


ACTIONS: dict[str, Callable[[Session, Any, int], str]] = {
    "speed": speed, "reset": reset, "set": set_, "move": move, "drag": drag, "drop": drop,
    "obstacle": obstacle, "grab": grab, "let_go": let_go, "pin": pin, "unpin": unpin, "cut": cut,
    "load": load, "untie": untie, "tie": tie, "knot": knot, "kick": kick, "scene": scene, "compare": compare,
    "back": back, "undo": undo, "remedy": remedy,
}  # fmt: skip
