"""An open trefoil in an elastic rope, held by its ends: the pull against the radius of its loop.

Where the loop's radius R is large beside that of the rope, r, the loop is a circle that stores pi EI / R,
and ends that go out by 2 pi dR take that from it: T = EI / (2 R^2). In the braid where its strands cross
the moment EI / R passes from one strand to the other, over a length of sqrt(r R). That takes a force of
contact N = sigma EI / R^2 sqrt(R / r) in all, against which the strands slide by 2 pi dR:
    T R^2 / EI = 1/2 +- sigma mu sqrt(R / r),   sigma = 0.492.
sigma is the force in the least bent braid (`verification.braid`), whose contacts are an interval in its
middle and one point to each side.
Source: Audoly, Clauvelin & Neukirch 2007, Phys. Rev. Lett. 99:164301; Jawed, Dieleman, Audoly & Reis 2015,
Phys. Rev. Lett. 115:118302. Derived anew here.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ropewalk import knots
from ropewalk.core.arrays import Floats
from ropewalk.scene import Air, Anchor, Contact, Material, Points, Rope, RunSettings, Scene, Table
from ropewalk.simulation import Simulation
from ropewalk.simulation.rope_contacts import rope_contacts

SIGMA = 0.492
EI, RADIUS = 1e-3, 0.05  # [N m^2], [m]
STEP = 1.0 / 240.0  # [s]
WAY, SPEED, REST = 0.03, 0.01, 1.0  # of each end [m], [m/s], and before that [s]


class Pulled(NamedTuple):
    """Means over the last two thirds of a pull and of letting go again."""

    tighter: float  # T R^2 / EI [1], R = pi EI / U from the energy U of its bending
    looser: float
    slender: float  # R / r [1]

    @property
    def mean(self) -> float:
        """Of both ways."""
        return 0.5 * (self.tighter + self.looser)

    @property
    def half(self) -> float:
        """Half their difference: what friction takes."""
        return 0.5 * (self.tighter - self.looser)

    def law(self, friction: float) -> float:
        """Half the difference by the law."""
        return SIGMA * friction * math.sqrt(self.slender)


class Shape(NamedTuple):
    """Where the contacts of a braid press, in the mean over the last two thirds of a pull."""

    slender: float  # R / r [1]
    force: float  # of all of them, over EI / R^2 sqrt(R / r)
    share: float  # of it in both outer points [1]
    outer: float  # how far they are from the middle, over sqrt(r R)
    inner: float  # the root mean square of that of the others, over sqrt(r R)


def trefoil(
    friction: float,
    diameter: float,
    one: float = 0.002,
    touch: bool = True,
    compliance: float = 1e-4,
) -> Scene:
    """One whose ends rest, are drawn out and come back; segments [m], no weight, no twist."""
    tied = knots.knot("overhand", RADIUS / 2.9)
    count = math.ceil((tied.length + 0.6) / one)
    x = tied.points(segments=count, length=count * one)
    rope = Rope(
        segments=count,
        length=count * one,
        diameter=diameter,
        # without bending friction, which has no direction where the rope is straight
        made_of=Material(EA=1e4, EI=EI, mass_per_length=0.01, axial_damping=0.05),
        shape=Points(points=x.tolist()),
    )
    go = WAY / SPEED
    times, ways = [0.0, REST, REST + go, REST + 2.0 * go], [0.0, 0.0, WAY, 0.0]
    anchors = [
        Anchor(
            node=node,
            motion=Table(
                times=times,
                positions=[(x[node] + [side * way, 0.0, 0.0]).tolist() for way in ways],
            ),
        )
        for node, side in ((0, -1.0), (-1, 1.0))
    ]
    return Scene(
        gravity=(0, 0, 0),
        ropes=[rope],
        anchors=anchors,
        contact=Contact(friction=friction, compliance=compliance) if touch else None,
        air=Air(node_drag=0.1 * one),
        run=RunSettings(method="implicit-euler", time_step=STEP, frame_rate=240),
    )


def loop_radius(x: Floats) -> float:
    """The radius [m] of the circle that is as much bent as the whole rope is; x is (3, n)."""
    steps = np.diff(x, axis=1)
    one = np.linalg.norm(steps, axis=0)
    along = steps / one
    turn = np.arccos(np.clip((along[:, 1:] * along[:, :-1]).sum(0), -1.0, 1.0))
    return float(math.pi / (0.5 * (turn**2).sum() / one.mean()))


def pulled(friction: float, diameter: float, one: float = 0.002, touch: bool = True) -> Pulled:
    """Pull on it and let go, slowly."""
    simulation = Simulation(trefoil(friction, diameter, one, touch))
    simulation.step(REST)
    means, sizes = [], []
    for _ in range(2):
        found = []
        for _ in range(round(60.0 * WAY / SPEED)):
            simulation.step(1.0 / 60.0)
            radius = loop_radius(simulation.arrays.x)
            pull = float(simulation.arrays.tension[:3].mean())
            found.append((pull * radius**2 / EI, radius))
        last = np.array(found[len(found) // 3 :])
        means.append(float(last[:, 0].mean()))
        sizes.append(float(last[:, 1].mean()))
    return Pulled(means[0], means[1], float(np.mean(sizes)) / (0.5 * diameter))


def shape(friction: float, diameter: float, one: float = 0.002) -> Shape:
    """Pull on it, slowly. Contacts are hard: strands are 2 % of a radius apart where they do not touch."""
    simulation = Simulation(trefoil(friction, diameter, one, compliance=1e-6))
    simulation.step(REST)
    found, sizes = [], []
    frames = round(60.0 * WAY / SPEED)
    for frame in range(frames):
        simulation.step(1.0 / 60.0)
        if frame < frames // 3:
            continue
        table = rope_contacts(simulation.arrays)
        assert table is not None
        rows = table[0][~np.isnan(table[0][:, 0])]
        radius, push = loop_radius(simulation.arrays.x), rows[:, 4]
        # both strands go through the braid the same way: a contact's place is the mean of its arc lengths
        z = 0.5 * one * (rows[:, :2] + rows[:, 2:4]).sum(axis=1)
        z -= (z * push).sum() / push.sum()
        thin = radius / (0.5 * diameter)
        parts = (np.abs(z) * math.sqrt(thin) / radius, push * radius**2 / EI / math.sqrt(thin))
        found.append(np.stack(parts, axis=1))
        sizes.append(thin)
    z, push = np.vstack(found).T
    far = z > 2.0
    inner = math.sqrt((z[~far] ** 2 * push[~far]).sum() / push[~far].sum())
    outer, force = float((z[far] * push[far]).sum() / push[far].sum()), float(push.sum())
    share = float(push[far].sum()) / force
    return Shape(float(np.mean(sizes)), force / len(found), share, outer, inner)
