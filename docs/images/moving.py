"""Make the moving picture of the documentation's first page: python docs/images/moving.py"""

from __future__ import annotations

from pathlib import Path

import ropewalk as rw
from ropewalk.scene import Slack

line = rw.Material(EA=9810.0, mass_per_length=0.063, axial_damping=20.0)  # N, kg/m, N s
rope = rw.Rope(segments=48, length=12.0, made_of=line, shape=Slack(end=(8.0, 0.0, 1.0)))
ends = [rw.Anchor(node=0), rw.Anchor(node=-1, release_time=0.5)]  # let go after half a second
run = {"duration": 4.0, "start": "at-rest"}
scene = rw.Scene(name="let go", ropes=[rope], anchors=ends, run=run)
rw.simulate(scene).movie(
    Path(__file__).with_name("moving.gif"), fps=12.5, size=(480, 360), speed=1.0
)
