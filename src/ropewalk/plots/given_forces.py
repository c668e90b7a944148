"""What a scene gives besides the ropes: constant forces at nodes and weights in water, in pictures."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import FancyArrowPatch
from matplotlib.text import Text

from ropewalk.core.arrays import Ints
from ropewalk.plots.canvas import Backdrop, Box
from ropewalk.plots.sight import Floats, shown_positions, spread
from ropewalk.scene import Scene
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.record.result import Result

GIVEN = "#b5460f"  # the colour of constant forces
_LONGEST = 0.12  # of the box's larger side, of the largest force's arrow
_MOST = 100  # arrows in one drawing
_WRITTEN = 12  # with more of them the sizes would hide each other


def given_notes(scene: Scene, *, gone: Collection[str] = (), arrows: bool = True) -> list[str]:
    """Return a sentence for each rope that lies in water, and one on the `arrows` of forces.

    Those of ropes that are `gone` are not drawn.
    """
    several = len(scene.ropes) > 1
    found = []
    for rope in scene.ropes:
        if rope.submerged_weight is not None:
            of = f"of {rope.name!r} " if several else ""
            found.append(f"Weight {of}in water: {rope.submerged_weight:.4g} N/m.")
    return found + (arrows_note(scene, written=True, gone=gone) if arrows else [])


def arrows_note(*scenes: Scene, written: bool = False, gone: Collection[str] = ()) -> list[str]:
    """Return a sentence on the arrows of forces; on their size, too, where it is not `written` at them."""
    sizes = [
        [np.linalg.norm(f.force) for r in scene.ropes if r.name not in gone for f in r.forces]
        for scene in scenes
    ]
    largest, most = float(max(map(max, filter(None, sizes)), default=0.0)), max(map(len, sizes))
    if largest == 0.0:
        return []
    about = f"the {_MOST} largest" if most > _MOST else "constant"
    about += " of the constant forces at nodes" if most > _MOST else " forces at nodes"
    if most > _WRITTEN or not written:
        about += f", the longest {prefixed(largest, 'N')}"
    return [f"Brown arrows: {about}."]


def arrow_scale(seen: Backdrop, *results: Result, largest: float = 0.0) -> float:
    """Return a good length of arrows per force [m/N] where forces of `largest` [N] are drawn, too."""
    size = max(largest, *(float(_forces(result)[2].max(initial=0.0)) for result in results))
    return _LONGEST * max(seen.box.width, seen.box.height) / size if size > 0.0 else 0.0


def with_room(
    result: Result, seen: Backdrop, frames: Sequence[int] | None = None, *, sizes: bool = True
) -> Backdrop:
    """Return a backdrop whose box holds the arrows of constant forces, too, with their `sizes`.

    At the good ones of `frames`, by default of all.
    """
    nodes = _forces(result)[0]
    if not nodes.size:
        return seen
    frames = spread(seen.good, 400) if frames is None else [f for f in frames if f < seen.good]
    points = [shown_positions(result, frame)[nodes] for frame in frames]
    starts = seen.view.project(np.concatenate([np.empty((0, 3)), *points]))
    for _ in range(3):  # in a larger box arrows are longer
        ways = _ways(result, seen, arrow_scale(seen, result))
        tips = (starts.reshape(-1, len(nodes), 2) + ways).reshape(-1, 2)
        seen = replace(seen, box=roomy(seen.box, tips, sizes=sizes))
    return seen


def roomy(box: Box, tips: Floats, *, sizes: bool = True) -> Box:
    """Widen a box so that the tips of arrows (m, 2) [m], and `sizes` written at them, lie inside."""
    tips = tips[np.isfinite(tips).all(axis=1)]
    if not len(tips):
        return box
    across, up = (0.15, 0.08) if sizes else (0.02, 0.02)
    text, line = across * box.width, up * (box.high - box.low)
    return replace(
        box,
        left=min(box.left, float(tips[:, 0].min()) - text),
        right=max(box.right, float(tips[:, 0].max()) + text),
        low=min(box.low, float(tips[:, 1].min()) - line),
        high=max(box.high, float(tips[:, 1].max()) + line),
    )


def _ways(result: Result, seen: Backdrop, scale: float) -> Floats:
    """Return the arrows of forces in the drawing, (m, 2) [m], at a length per force [m/N]."""
    shrink = np.array([1.0, 1.0 / seen.box.magnified])
    ways: Floats = scale * seen.view.project(_forces(result)[1]) * shrink
    return ways


def _forces(result: Result) -> tuple[Ints, Floats, Floats]:
    """Return nodes (m,), forces (m, 3) and sizes (m,) of the largest constant forces at nodes [N]."""
    nodes, forces = [], []
    for span, rope in zip(result.layout.ropes, result.scene.ropes, strict=True):
        nodes += [span.start + rope.node_index(one.node) for one in rope.forces]
        forces += [one.force for one in rope.forces]
    vectors = np.array(forces, dtype=np.float64).reshape(-1, 3)
    sizes = np.linalg.norm(vectors, axis=1)
    order = np.argsort(-sizes, kind="stable")[:_MOST]
    order = order[sizes[order] > 0.0]
    return np.array(nodes, dtype=np.int64)[order], vectors[order], sizes[order]


class GivenForces:
    """The arrows of a scene's constant forces in one drawing, to be moved from frame to frame."""

    def __init__(
        self, axes: Axes, result: Result, seen: Backdrop, *, scale: float = 0.0, sizes: bool = True
    ) -> None:
        """Make the arrows, each with its size where `sizes` are wanted and there are few.

        `scale` is their length per force [m/N]; by default the largest one has a good length.
        """
        self._seen = seen
        self._nodes, _, newtons = _forces(result)
        self._ways = _ways(result, seen, scale or arrow_scale(seen, result))
        self._arrows = [_arrow() for _ in self._nodes]
        for arrow in self._arrows:
            axes.add_artist(arrow)
            arrow.set_clip_on(False)
        few = sizes and len(newtons) <= _WRITTEN
        self._texts = [
            _size_text(axes, float(size), left=bool(way[0] < 0.0))
            for size, way in (zip(newtons, self._ways, strict=True) if few else ())
        ]

    @property
    def artists(self) -> tuple[Artist, ...]:
        """All that is drawn."""
        return (*self._arrows, *self._texts)

    def move(self, points: Floats) -> Floats:
        """Put the arrows at the nodes among `points` (n, 2) [m] of the drawing; return their tips (m, 2)."""
        starts = points[self._nodes]
        tips: Floats = starts + self._ways
        for arrow, start, tip in zip(self._arrows, starts, tips, strict=True):
            arrow.set_positions(tuple(start), tuple(tip))
            arrow.set_visible(bool(np.isfinite(tip).all()))  # NaN: of a rope that broke before
        for text, tip in zip(self._texts, tips, strict=False):
            text.set_position(tuple(tip))
            text.set_visible(bool(np.isfinite(tip).all()))
        return tips


def _arrow() -> FancyArrowPatch:
    return FancyArrowPatch(
        (0.0, 0.0),
        (0.0, 0.0),
        arrowstyle="-|>",
        mutation_scale=10.0,
        color=GIVEN,
        linewidth=1.3,
        shrinkA=0.0,
        shrinkB=0.0,
        zorder=4.5,
    )


def _size_text(axes: Axes, size: float, *, left: bool) -> Text:
    """Make the text of an arrow's size [N], at the `left` of its tip or at the right."""
    side = "right" if left else "left"
    return axes.text(0, 0, prefixed(size, "N"), ha=side, va="bottom", color=GIVEN, fontsize=8)


def draw_forces(
    axes: Axes,
    result: Result,
    seen: Backdrop,
    frame: int,
    *,
    scale: float = 0.0,
    sizes: bool = True,
) -> Floats:
    """Draw the constant forces at their nodes at a frame; see `GivenForces`. Return the tips (m, 2) [m]."""
    arrows = GivenForces(axes, result, seen, scale=scale, sizes=sizes)
    return arrows.move(seen.view.project(shown_positions(result, frame)))
