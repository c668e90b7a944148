"""Which rope and node an index of the arrays belongs to, and the other way round."""

from __future__ import annotations

import pytest

from ropewalk.lowering.layout import Layout, make_layout
from ropewalk.scene import Anchor, Material, Rope, Scene, Straight, Winch


def laid_out() -> Layout:
    """Three ropes of 2, 5 and 3 segments, the second on a drum at its start."""
    ropes = [
        Rope(
            name=name,
            segments=segments,
            length=1.0,
            made_of=Material(EA=1e3, mass_per_length=0.1),
            shape=Straight(start=(0, k, 0), end=(1, k, 0)),
        )
        for k, (name, segments) in enumerate((("a", 2), ("b", 5), ("c", 3)))
    ]
    anchors = [Anchor(name="hold", rope="b", node=0)]
    winch = Winch(name="drum", rope="b", end="start", speed=0.5, on_drum=0.6)
    return make_layout(Scene(ropes=ropes, anchors=anchors, winches=[winch]))


def test_every_index_belongs_to_the_rope_whose_span_holds_it() -> None:
    layout = laid_out()
    seen = 0
    for span in layout.ropes:
        assert layout.span(span.name) is span
        for index in range(span.first, span.last + 1):
            assert layout.rope_of(index) == (span.name, index - span.start)
            seen += 1
    assert seen == layout.nodes
    assert layout.rope_of(layout.span("b").first) == ("b", -layout.span("b").spare_start)
    assert layout.span("b").spare_start > 0


def test_what_is_not_there_is_named() -> None:
    layout = laid_out()
    for wrong in ("left", 1.5, None):
        with pytest.raises(IndexError, match=rf"has the nodes 0 to \d+, not {wrong!r}"):
            layout.node(wrong, layout.ropes[0].name)  # type: ignore[arg-type]
    with pytest.raises(IndexError, match=f"there are {layout.nodes} nodes"):
        layout.rope_of(layout.nodes)
    with pytest.raises(KeyError, match="not 'd'"):
        layout.span("d")
    with pytest.raises(KeyError, match="name one of the ropes a, b, c"):
        layout.span()
