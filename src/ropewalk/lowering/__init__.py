"""From what the user described to what the kernels need."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from ropewalk.core.arrays import State, System
from ropewalk.lowering.contact_checks import refuse_contact
from ropewalk.lowering.layout import Layout, Span, make_layout
from ropewalk.lowering.obstacle_checks import refuse_fast, refuse_obstacles
from ropewalk.lowering.pieces import Pieces
from ropewalk.lowering.plan import Plan, make_plan
from ropewalk.lowering.release_checks import refuse_releases
from ropewalk.lowering.segment_checks import refuse_segments
from ropewalk.lowering.swings import refuse_unseen
from ropewalk.lowering.system import make_tables
from ropewalk.scene import Scene

__all__ = ["Layout", "Model", "Pieces", "Plan", "Span", "build", "with_all_laws"]


@dataclass(frozen=True)
class Model:
    """A scene, built: constant tables, state at time zero, layout and plan."""

    scene: Scene
    system: System
    state: State
    layout: Layout
    plan: Plan
    gravity_zero: (
        float  # gravity's potential in the scene's own shape [J], from where it is counted
    )
    started: bool = (
        False  # whether `state` is that in which the run starts; see `ropewalk.engine.start`
    )


def build(
    scene: Scene,
    pieces: Pieces | None = None,
    *,
    drawn: bool = True,
    endless: bool = False,
    stepped: bool = True,
) -> Model:
    """Build a scene. Raises SceneError when it cannot be planned, TypeError for what is no scene.

    `pieces` of earlier builds save those that are the same again; the model has the same bits. With `drawn`
    off the ropes get other places than their shapes say, so that joints need not fit those. An `endless`
    simulation goes on after the run's duration: steps suit what moves then, too. With `stepped` off no steps
    are taken, as for a shape of rest: they may be too long for what moves, and anchors never let go.
    """
    if not isinstance(scene, Scene):
        raise TypeError(f"{scene!r} is no scene; rw.preset(name) and rw.load(path) give one")
    keep = Pieces() if pieces is None else pieces
    keep.made.clear()
    layout = keep("layout", _itself, make_layout(scene))
    system, state = make_tables(scene, layout, keep, drawn=drawn)
    refuse_obstacles(scene, system, state, layout, drawn=drawn)
    refuse_contact(scene, system, state, layout, drawn=drawn)
    refuse_segments(scene)
    until = math.inf if endless else scene.run.duration
    plan = make_plan(scene, system, state, until, stepped=stepped)
    if stepped:
        step = plan.dt if plan.longest is None else plan.longest
        refuse_fast(scene, system, step, until)
        refuse_unseen(scene, step, until)
    if stepped and drawn:
        refuse_releases(scene, system, state, until)
    zero = -float(system.gravity @ (state.x * state.mass).sum(axis=1))
    return Model(scene, system, state, layout, plan, zero)


def _itself(layout: Layout) -> Layout:
    """An equal layout is the same one from then on."""
    return layout


def with_all_laws(model: Model) -> Model:
    """Return the model for the full variant of its kernels: laws may be added while it runs."""
    return replace(model, system=model.system._replace(rare=1))
