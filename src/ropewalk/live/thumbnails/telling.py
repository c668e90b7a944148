"""What the picture of each preset shows: the times of its shapes, and how they are drawn."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ropewalk.live.shape_picture import Manner, Shot, draw, shot
from ropewalk.scene.presets import preset
from ropewalk.simulation import Broken, Simulation


class Telling(NamedTuple):
    """Moments of a preset that tell it from the others."""

    times: tuple[float, ...]  # of the shapes [s]
    manner: Manner = Manner()
    magnify: float = 1.0  # of the ways from time zero


def _every(start: float, stop: float, count: int) -> tuple[float, ...]:
    return tuple(float(time) for time in np.linspace(start, stop, count))


TELLING = {
    "r1": Telling(_every(0.0, 0.0285, 20), Manner(apart=(0.13, 0.0)), magnify=4000.0),
    "r2": Telling(_every(0.0, 2.1, 7)),
    "r3": Telling(_every(0.0, 0.9, 6)),
    "r4": Telling(_every(0.5, 3.5, 5)),
    "r5": Telling((6.0,), Manner(oblique=0.7)),
    "r6": Telling((0.0, 3 / 60, 4 / 60, 5 / 60), Manner(apart=(0.0, 3.5), room=0.3, nodes=True)),
    "r7": Telling((0.0, 0.5, 1.1), Manner(room=0.3)),
    "r8": Telling(_every(0.0, 1.5, 4)),
    "r9": Telling(_every(3.5, 6.0, 12)),
    "n39-constant-velocity": Telling(_every(0.0, 6.0, 7)),
    "n39-gravity": Telling(_every(0.0, 4.0, 15)),
    "n39-spring": Telling(_every(0.0, 4.44, 11), Manner(apart=(0.0, 1.0))),
    "n40": Telling(_every(0.0, 2.0, 6)),
    "h1": Telling(_every(0.0, 2.0, 9), Manner(apart=(1.0, 0.0))),
    "h2": Telling(_every(0.0, 2.8, 9)),
    "h3": Telling(_every(0.0, 10.0, 6), Manner(apart=(5.0, 0.0))),
    "climbing-fall": Telling(_every(0.0, 0.3, 7), Manner(apart=(0.5, 0.0))),
    "crane-snap": Telling((0.0, 0.3, 0.6, 1.5), Manner(apart=(4.0, 0.0))),
    "guyed-mast": Telling((0.0,), Manner(oblique=0.5)),
    "highline": Telling(_every(0.0, 1.75, 6)),
    "hoist-stop": Telling(_every(0.0, 0.6, 4), Manner(apart=(5.0, 0.0), nodes=True)),
    "net": Telling((0.25,), Manner(oblique=0.6)),
    "power-line-in-wind": Telling(_every(0.0, 4.0, 5), Manner(oblique=2.0)),
    "rescue-lower": Telling(_every(0.0, 6.0, 9), Manner(apart=(1.2, 0.6))),
    "suspension-cable": Telling((0.0,), Manner(nodes=True)),
    "capstan": Telling((0.0,), Manner(oblique=0.6)),
    "edge": Telling(_every(0.0, 1.0, 5)),
    "stairs": Telling((1.12, 1.6, 1.82)),
    "bollard": Telling((0.0,), Manner(oblique=0.5)),
    "pulley": Telling((0.0, 0.5, 1.0)),
    "clove-hitch": Telling((0.0,), Manner(oblique=0.8)),
    "figure-eight": Telling((0.0,), Manner(oblique=0.9)),
    "reef": Telling((0.0,), Manner(oblique=0.9)),
    "granny": Telling((1.2,), Manner(oblique=0.9)),
    "bowline": Telling((0.0,), Manner(oblique=0.9)),
    "two-half-hitches": Telling((0.0,), Manner(oblique=0.6)),
    "prusik": Telling((0.0,), Manner(oblique=0.6)),
    "munter": Telling((0.0,), Manner(oblique=0.6)),
    "three-leg-sling": Telling((0.0, 0.5, 1.0), Manner(oblique=0.4)),
    "tow": Telling(_every(0.0, 1.2, 5), Manner(apart=(0.0, 0.7))),
    "zip-line": Telling(_every(0.0, 1.3, 4), Manner(apart=(0.0, 4.0))),
    "zip-line-ride": Telling(_every(0.0, 20.0, 5), Manner(apart=(0.0, 9.0))),
    "falling-chain": Telling(_every(0.5, 1.0, 6), Manner(apart=(0.45, 0.0))),
    "fishing-rod": Telling(_every(1.0, 1.6, 8)),
    "overhand": Telling((0.0,), Manner(oblique=0.9)),
    "crossing": Telling((0.0, 0.15, 0.25, 0.35), Manner(oblique=0.6)),
    "pile": Telling((2.2,), Manner(oblique=0.6)),
    "hanging-rope": Telling((1.0,)),
    "skipping-rope": Telling(_every(2.0, 2.45, 7)),
    "wave-on-a-string": Telling((0.9,), magnify=20.0),
    "whip": Telling((0.0, 0.1, 0.2, 0.24, 0.27, 0.3), Manner(apart=(0.0, 0.2))),
    "wire-arch": Telling(_every(0.0, 2.5, 6)),
}


def picture(name: str) -> str:
    """Run a preset and return its picture, SVG."""
    return draw(shots(name), preset(name), TELLING[name].manner)


def shots(name: str) -> list[Shot]:
    """Run a preset; return its shapes at the times that are told, or up to its break."""
    telling = TELLING[name]
    simulation = Simulation(preset(name), ledger=False)
    origin = simulation.positions.copy() if telling.magnify != 1.0 else None
    found = []
    for time in telling.times:
        broken = False
        if time > simulation.time:
            try:
                simulation.step(time - simulation.time)
            except Broken:
                broken = True
        if np.isfinite(simulation.positions).all():
            found.append(shot(simulation, origin, telling.magnify))
        if broken:
            break
    return found
