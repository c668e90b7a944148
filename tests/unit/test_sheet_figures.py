"""Figures of a sheet say what its tables say."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.drawing import Plots


def test_anchor_forces_have_the_sign_of_the_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables had the forces of the ropes on the anchors, the figure the opposite without a word."""
    drawn = []
    draw = Plots.reactions
    monkeypatch.setattr(
        Plots, "reactions", lambda self, **how: drawn.append(draw(self, **how)) or drawn[0]
    )
    rope = rw.Rope(
        segments=4, length=1.0, made_of=rw.Material(EA=1e4, mass_per_length=0.1),
        shape={"kind": "straight", "start": (0, 0, 0), "end": (0, 0, -1)},
        loads=[rw.Load(node=-1, mass=1.0)],
    )  # fmt: skip
    scene = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run={"duration": 0.2})
    made = rw.sheet(scene, convergence=False)
    assert "down" in " ".join(made.section("The run").items[-2].rows[0])
    (axes,) = drawn[0].axes
    (curve,) = [one for one in axes.lines if one.get_label() == "z"]
    assert np.max(curve.get_ydata()[1:]) < 0.0  # it pulls the anchor down
    assert drawn[0]._supxlabel.get_text() == "Forces of the ropes on the anchors."
