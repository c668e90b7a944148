"""Where things lie along their ropes: by unstretched arc length, or by segments where these have none."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.plots.sight import Floats

if TYPE_CHECKING:
    from ropewalk.record.result import Result

IN_SEGMENTS = "along the rope [segments]"


def has_length(result: Result, rope: str) -> bool:
    """Tell whether a rope has an unstretched length; springs may have none."""
    return result.scene.rope_named(rope).segment_length > 0.0


def node_arcs(result: Result, frame: int, rope: str) -> Floats:
    """Return where the nodes of a rope lie along it at a frame, (n,): arc length [m], or segments [1].

    What a winch has paid out counts where it is at that frame.
    """
    lengths = laid_lengths(result, rope)[frame]
    if not has_length(result, rope):
        lengths = np.ones(len(lengths))
    found: Floats = np.concatenate([[0.0], np.cumsum(lengths)])
    return found


def laid_lengths(result: Result, rope: str) -> Floats:
    """Return the unstretched lengths of the segments of a rope [m], (f, s): 0 on a drum.

    What has parted keeps the length that it had, so that what lies behind it stays in its place.
    """
    partings = [one for one in result.partings if one.rope == rope]
    lengths = result.rope(rope).rest_length
    if partings:
        lengths = np.array(lengths)
    for one in partings:
        segment = result.layout.span(rope).spare_start + one.segment
        gone = int(np.searchsorted(result.time, one.time))
        had = float(lengths[gone - 1, segment]) if gone else 0.0
        lengths[gone:, segment] = had or result.scene.rope_named(rope).segment_length
    return lengths


def segment_arcs(result: Result, frame: int, rope: str) -> Floats:
    """Return where the middles of the segments of a rope lie along it, (s,), as `node_arcs`."""
    arcs = node_arcs(result, frame, rope)
    return 0.5 * (arcs[:-1] + arcs[1:])


def arc_label(result: Result, ropes: Iterable[str]) -> str:
    """Return what an axis along these ropes is called."""
    kinds = {has_length(result, rope) for rope in ropes}
    if len(kinds) > 1:
        return "along the rope [m or segments]"
    return "unstretched arc length [m]" if kinds == {True} else IN_SEGMENTS
