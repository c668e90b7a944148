"""Constant forces and weights in water are named and drawn on figures."""

from __future__ import annotations

import matplotlib.pyplot as plt

import ropewalk as rw
from live.drive import slack_rope
from ropewalk.plots.given import given_notes
from ropewalk.scene import Force


def texts(figure: plt.Figure) -> list[str]:
    """Return all that is written in a figure."""
    axes = [text.get_text() for one in figure.axes for text in one.texts]
    return axes + [text.get_text() for text in figure.texts]


def test_a_figure_of_the_shape_shows_what_the_scene_gives() -> None:
    plain = slack_rope(6)
    plain = plain.replace(run=plain.run.replace(duration=0.05))
    forces = [Force(node=3, force=(0.0, 30.0, -40.0)), Force(node=1, force=(0.0, 0.0, 0.0))]
    rope = plain.ropes[0].replace(forces=forces, submerged_weight=-1.5)
    said = texts(rw.simulate(plain.replace(ropes=[rope])).plot.shape())
    assert "50 N" in said
    assert any("Weight in water: -1.5 N/m." in one for one in said)
    assert any("Arrows: constant forces at nodes." in one for one in said)
    assert "50 N" not in texts(rw.simulate(plain).plot.shape())
    assert given_notes(plain) == []
