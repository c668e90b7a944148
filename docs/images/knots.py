"""Draw the picture of all knots in the docs: python docs/images/knots.py

Each as it is tied, and drawn tight by all ends, the half hitches most by their tail; ropes as thick as they
are, nearer strands over farther ones.
"""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from scipy.interpolate import CubicSpline

from ropewalk import knots
from ropewalk.scene import Air, Anchor, Contact, Knot, Material, Rope, RunSettings, Scene, Velocity
from ropewalk.simulation import Simulation

HERE = Path(__file__).parent
D, POST, RING = 0.01, 0.02, 0.1  # [m]
TIGHT, LONGEST = 30.0, 4.0  # [N], [s]
ROPES, WOOD = (("#1f77b4", "#0b3350"), ("#e08a1e", "#6b3d00")), ("#d9d4cc", "#8a8277")
REACH = 0.115  # [m] of a picture to each side


def scene(name: str) -> Scene:
    """The knot with all its ends going out."""
    sizes = {} if name in knots.KNOTS else {"post_radius": POST}
    if name == "munter":
        sizes["ring_radius"] = RING
    ropes, anchors = [], []
    stuff = Material(EA=1e4, mass_per_length=0.08, axial_damping=2.0)
    for k in range(2 if name in ("reef", "granny") else 1):
        shape = Knot(knot=name, rope=k + 1, **sizes)
        count = math.ceil((shape.tied(D).length + 0.3) / D)
        rope = Rope(
            name=f"rope{k}",
            segments=count,
            length=count * D,
            diameter=D,
            made_of=stuff,
            shape=shape,
        )
        ropes.append(rope)
        x = shape.places(count, count * D, D, (0, 0, 1), D)
        for node, before in ((0, 1), (-1, -2)):
            out = 0.1 * (x[node] - x[before]) / D
            if name == "two-half-hitches":
                # by its tail, and towards the post, which slides both hitches together
                out = out + np.array([0.1, 0.0, 0.0]) if node == -1 else 0.3 * out
            anchors.append(
                Anchor(rope=rope.name, node=node, motion=Velocity(velocity=out.tolist()))
            )
    posts = [] if name in knots.KNOTS else [shape.post(0.3, friction=0.3, compliance=1e-5)]
    return Scene(
        gravity=(0, 0, 0),
        ropes=ropes,
        anchors=anchors,
        obstacles=posts,
        contact=Contact(friction=0.3),
        air=Air(node_drag=0.02),
        run=RunSettings(method="implicit-euler", time_step=1 / 240, frame_rate=60),
    )


def seen(name: str) -> np.ndarray:
    """Right, up and towards the eye, (3, 3), one a row: knots from above, hitches askew."""
    to = np.array([0.1, -0.25, 1.0] if name in knots.KNOTS else [-0.25, -1.0, 0.45])
    if name == "munter":  # the ring from its open side
        to = np.array([0.7, -1.0, 0.45])
    up = np.array([0.0, 1.0, 0.0] if name in knots.KNOTS else [0.0, 0.0, 1.0])
    to /= np.linalg.norm(to)
    right = np.cross(up, to)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(to, right), to])


def draw(axes: Axes, name: str, model: Scene, x: np.ndarray, caps: str = "butt") -> None:
    """Draw ropes and post at places (3, n), from far to near; round caps have no teeth in sharp bends."""
    lines, at = [], 0
    for rope, colours in zip(model.ropes, ROPES, strict=False):
        place = np.arange(rope.nodes)
        smooth = CubicSpline(place, x[:, at : at + rope.nodes].T)
        lines.append((smooth(np.linspace(0, rope.segments, 5 * rope.segments + 1)), D, colours))
        at += rope.nodes
    if name in knots.HITCHES:
        angle = np.linspace(0.0, 2.0 * math.pi, 241)
        straight = np.linspace([0, 0, -0.15], [0, 0, 0.15], 121)
        ring = RING * np.stack((0.0 * angle, 1.0 - np.cos(angle), np.sin(angle)), axis=1)
        lines.append((ring if name == "munter" else straight, 2.0 * POST, WOOD))
    view = seen(name)
    middle = -0.08 if name == "two-half-hitches" else 0.0
    axes.set(
        xlim=(middle - REACH, middle + REACH), ylim=(-0.8 * REACH, 0.8 * REACH), aspect="equal"
    )
    axes.set_axis_off()
    box = axes.get_window_extent()
    points = 72.0 / axes.figure.dpi * box.width / (2.0 * REACH)  # of line width per metre
    pieces = []
    for places, width, (face, edge) in lines:
        flat = places @ view.T
        for a, b in pairwise(flat):
            reach = 0.4 * (b - a)  # so that no gaps show between pieces
            near = 0.5 * (a + b)[2]
            pieces.append((near, [a[:2], b[:2]], width * points, edge))
            inner = (1.0 - 0.22 * D / width) * width * points
            pieces.append((near + 0.3 * D, [(a - reach)[:2], (b + reach)[:2]], inner, face))
    pieces.sort(key=lambda piece: piece[0])
    axes.add_collection(
        LineCollection(
            [p[1] for p in pieces],
            linewidths=[p[2] for p in pieces],
            colors=[p[3] for p in pieces],
            capstyle=caps,
        )
    )


def main() -> None:
    """Tie, draw tight, draw."""
    names = knots.names()
    figure, grid = plt.subplots(5, 4, figsize=(8.8, 9.4), dpi=90, layout="constrained")
    figure.canvas.draw()
    for k, name in enumerate(names):
        model = scene(name)
        simulation = Simulation(model)
        left, right = grid[k % 5][2 * (k // 5) : 2 * (k // 5) + 2]
        left.set_title(name, loc="left", fontsize=9)
        draw(left, name, model, np.array(simulation.arrays.x))
        while simulation.time < LONGEST:
            simulation.step(1.0 / 60.0)
            tension = simulation.arrays.tension
            if min(tension[:3].mean(), tension[-3:].mean()) > TIGHT:
                break
        print(name, f"{simulation.time:.2f} s, {tension[:3].mean():.0f} N", flush=True)
        draw(right, name, model, np.array(simulation.arrays.x))
    figure.savefig(HERE / "knots.png", pil_kwargs={"optimize": True})


if __name__ == "__main__":
    main()
