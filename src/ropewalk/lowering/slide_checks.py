"""Nodes that slide along ropes: they begin on them; and what cannot be done with them."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import State
from ropewalk.laws.slides.rail import nearest_place, point_at
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault

#: Why nothing looks for a rest of ropes that slide along each other.
NO_REST = (
    "the rest of what slides along a rope is not looked for here: let the run settle, with some friction; "
    "for a load at rest along one span there is `ropewalk line --load`"
)
_NEAR = 1.0  # [1] a node that is drawn farther off, over the length of a segment, is somewhere else
_SECOND = 0.01  # [1] the same of a second node of one rope, which alone is moved


def refuse_rest(scene: Scene) -> None:
    """Raise SceneError where something slides and a rest is asked for."""
    if scene.slides and scene.run.start == "at-rest":
        raise SceneError([Fault("run.start", "at-rest", NO_REST)])


def refuse_slides(scene: Scene, what: str) -> None:
    """Raise SceneError for `what` cannot be done while something slides."""
    if scene.slides:
        raise SceneError([Fault("slide", NO_VALUE, f"{what}; leave out the slides")])


def put_on_ropes(scene: Scene, layout: Layout, state: State) -> None:
    """Move what slides onto its rope, its own rope with it.

    Raises SceneError where it is drawn too far from there.
    """
    faults, moved = [], set[str]()
    for i, slide in enumerate(scene.slides):
        node, span, line = layout.node(slide.node, slide.rope), layout.span(slide.rope), slide.on
        first, last = layout.span(line).start, layout.span(line).end
        length, x = scene.rope_named(line).segment_length, state.x
        if slide.at is None:
            away = np.square(x[:, first : last + 1] - x[:, [node]]).sum(axis=0)
            u = nearest_place(x, node, first, last, float(np.argmin(away)))
        else:
            u = min(slide.at / length, float(last - first))
        way = np.array(point_at(x, first, last, u)) - x[:, node]
        far = float(np.linalg.norm(way))
        again = slide.rope in moved
        allowed = _SECOND * scene.rope_named(slide.rope).segment_length if again else _NEAR * length
        if (again or slide.at is None) and far > allowed:
            rule = f"lies {far:.4g} m off rope {line!r} at the start: draw it there" + (
                ", as another slide has its rope's place" if again else ", or give `at`"
            )
            faults.append(Fault(f"slide[{i}].node", f"node {slide.node} of {slide.rope}", rule))
            continue
        if again:
            x[:, node] += way
        else:
            x[:, span.first : span.last + 1] += way[:, None]
        moved.add(slide.rope)
    if faults:
        raise SceneError(faults)
