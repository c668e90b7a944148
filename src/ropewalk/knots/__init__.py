"""Knots as curves: by name, for a rope of a diameter, loose enough to be tightened.

    from ropewalk import knots

    tied = knots.knot("reef", 0.01)
    tied.points(segments=120, length=1.0)  # nodes of the first rope

In a scene a knot is a rope's shape, `ropewalk.scene.Knot`.
"""

from ropewalk.knots.tying import HITCHES, KNOTS, Tied, knot, names

__all__ = ["HITCHES", "KNOTS", "Tied", "knot", "names"]
