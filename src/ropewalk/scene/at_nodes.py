"""What a rope has at single nodes: loads, kicks, constant forces."""

from __future__ import annotations

from ropewalk.scene.base import Model, Number, Vector, Whole, node_number, positive, vector


class Load(Model):
    """Extra mass at one node; several loads at one node add up."""

    node: Whole = node_number()
    mass: Number = positive("Extra mass", "kg")


class Kick(Model):
    """Initial velocity of one node, in place of the shape's."""

    node: Whole = node_number()
    velocity: Vector = vector("Initial velocity of the node", "m/s")


class Force(Model):
    """Constant force at one node; several forces at one node add up."""

    node: Whole = node_number()
    force: Vector = vector("Force on the node, constant in size and direction", "N")
