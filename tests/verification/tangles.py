"""Random tangles: closed loops of rope that lie among each other, and fall in a heap on a floor."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.scene import Contact, Joint, Material, Plane, Points, Rope, RunSettings, Scene, Tie
from verification.topology import determinant, linking_number

SEGMENTS = 36


def loop(rng: np.random.Generator, waves: int = 3) -> Floats:
    """A smooth closed curve about the origin, some 0.2 m across, (SEGMENTS + 1, 3); its ends meet."""
    t = np.linspace(0.0, 2.0 * np.pi, 40 * SEGMENTS + 1)
    curve = np.zeros((len(t), 3))
    for k in range(1, waves + 1):
        a, b = rng.normal(size=(2, 3)) / k**1.5
        curve += np.outer(np.cos(k * t), a) + np.outer(np.sin(k * t), b)
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    at = np.linspace(0.0, arc[-1], SEGMENTS + 1)
    points = np.stack([np.interp(at, arc, curve[:, k]) for k in range(3)], axis=1)
    return points * 0.8 / arc[-1]


def apart(curves: list[Floats], beside: int) -> float:
    """The least distance of their segments [m], but for those so many places beside each other."""
    share, least = np.linspace(0.0, 1.0, 9), np.inf
    dots = [(c[:-1, None] + share[:, None] * np.diff(c, axis=0)[:, None]) for c in curves]
    for a, one in enumerate(dots):
        for b, other in enumerate(dots[a:], a):
            far = np.linalg.norm(one[:, None, :, None] - other[None, :, None], axis=-1).min((2, 3))
            if a == b:
                i = np.arange(SEGMENTS)
                gap = np.abs(i[:, None] - i[None])
                far[np.minimum(gap, SEGMENTS - gap) <= beside] = np.inf
            least = min(least, float(far.min()))
    return least


def tangle(seed: int, loops: int, bends: bool) -> Scene:
    """Loops through and about each other, as thick as they can be, 3 cm above a floor."""
    rng = np.random.default_rng(seed)
    while True:
        curves = [loop(rng) + 0.03 * rng.normal(size=3) for _ in range(loops)]
        diameter = min(0.9 * apart(curves, 1), 0.012)
        if diameter > 0.006:
            break
    low = min(c[:, 2].min() for c in curves)
    ropes, joints = [], []
    for k, curve in enumerate(curves):
        points = curve + np.array([0.0, 0.0, 0.03 + 0.5 * diameter - low])
        points[-1] = points[0]
        stuff = {"EA": float(10.0 ** rng.uniform(2, 4)), "mass_per_length": 0.05}
        if bends:
            stuff["EI"] = float(10.0 ** rng.uniform(-5, -4))
        length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
        ropes.append(
            Rope(
                name=f"loop{k}",
                segments=SEGMENTS,
                length=length,
                diameter=diameter,
                made_of=Material(axial_damping=0.2, **stuff),
                shape=Points(points=points.tolist()),
            )
        )
        ends = [Tie(rope=f"loop{k}", node=0), Tie(rope=f"loop{k}", node=-1)]
        joints.append(Joint(name=f"splice{k}", points=ends))
    return Scene(
        ropes=ropes,
        joints=joints,
        obstacles=[Plane(friction=0.3)],
        contact=Contact(friction=float(rng.choice([0.0, 0.2, 0.6]))),
        run=RunSettings(method="implicit-euler", time_step=1 / 60, frame_rate=60),
    )


def closed(scene: Scene, x: Floats) -> list[Floats]:
    """The loops at places (3, n) of all nodes, (SEGMENTS, 3) each."""
    count = SEGMENTS + 1
    return [x[:, k * count : (k + 1) * count - 1].T for k in range(len(scene.ropes))]


def kind_of(scene: Scene, x: Floats) -> list[int]:
    """How the loops are knotted and linked: determinants, then linking numbers of all pairs."""
    curves = closed(scene, x)
    found = [determinant(curve) for curve in curves]
    for a, one in enumerate(curves):
        for other in curves[a + 1 :]:
            exact = linking_number(one, other)
            assert abs(exact - round(exact)) < 1e-6
            found.append(round(exact))
    return found
