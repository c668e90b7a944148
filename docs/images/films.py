"""Make the films of contact in the docs: python docs/images/films.py [NAME...]"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from knots import draw
from PIL import Image

import ropewalk as rw
from ropewalk.plots.gif import GifWriter, make_palette

HERE, FPS = Path(__file__).parent, 15


def pile() -> None:
    """A cord is fed onto a floor; seen from near, the hand comes into the picture."""
    window = (-0.12, 0.12, -0.012, 0.19)
    found = rw.simulate("pile")
    found.movie(HERE / "pile.gif", fps=FPS, size=(480, 400), plane="xz", window=window)


def stairs() -> None:
    """A rope runs down stairs."""
    window = (-1.2, 1.1, -0.05, 0.75)
    rw.simulate("stairs").movie(HERE / "stairs.gif", fps=FPS, size=(600, 330), window=window)


def overhand() -> None:
    """An overhand knot is drawn tight, four times as slowly as it is."""
    window = (-0.14, 0.14, -0.045, 0.045)
    found = rw.simulate("overhand")
    found.movie(HERE / "overhand.gif", fps=FPS, size=(560, 310), speed=0.25, window=window)


def hitch() -> None:
    """A clove hitch draws tight on its post, five times as slowly as it does, seen askew."""
    scene, found = rw.preset("clove-hitch"), rw.simulate("clove-hitch")
    held = float(np.linalg.norm(scene.ropes[0].forces[0].force))  # [N]
    figure, axes = plt.subplots(figsize=(4.8, 3.6), dpi=100, layout="constrained")
    times = np.arange(0.0, 0.8, 0.2 / FPS)
    frames = [int(np.abs(found.time - time).argmin()) for time in times]
    pictures = []
    for frame in (frames[0], *frames):  # the first one finds the room
        axes.clear()
        head = f"t = {found.time[frame]:.2f} s, slowed 5 times: {{:.0f}} N drawn, {held:.0f} N held"
        axes.set_title(head.format(found.tension[frame, 0]), fontsize=10, loc="left")
        draw(axes, "clove-hitch", scene, found.positions[frame].T, caps="round")
        figure.canvas.draw()
        pictures.append(Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3]))
    pixels = np.concatenate([np.asarray(one).reshape(-1, 3) for one in pictures[1:]])
    shades, often = np.unique(pixels, axis=0, return_counts=True)
    most = shades[np.argsort(-often)[:64]].tolist()
    palette = make_palette([(red, green, blue) for red, green, blue in most])
    writer = GifWriter(HERE / "hitch.gif", pictures[0].size, FPS, palette)
    for picture in (*pictures[1:], *20 * pictures[-1:]):  # it stays a while
        writer.add(picture)
    writer.close()


FILMS = {"pile": pile, "stairs": stairs, "overhand": overhand, "hitch": hitch}

if __name__ == "__main__":
    for name in sys.argv[1:] or FILMS:
        FILMS[name]()
