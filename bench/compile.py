"""Processor time from an empty cache of kernels to the first step, in processes of their own.

One run of each: another program on the same processor makes it longer by up to a half, never shorter.
Python's own byte code is there, as after an installation.
"""

from __future__ import annotations

import atexit
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from functools import cache
from statistics import mean

from bench.row import Row

LAWS = (
    "air",
    "ground",
)  # of nodes, that no other law names: without another one no step is compiled

SCENE = """
import sys
import ropewalk as rw
from ropewalk.laws import registry
method, full, without = sys.argv[1:]
if without:
    registry.NODE_LAWS = tuple(law for law in registry.NODE_LAWS if law.name != without)
    names = [law.name for law in registry.NODE_LAWS]
    registry.NodeTables = registry.namedtuple("NodeTables", names)
    registry.NodeArrays = registry.namedtuple("NodeArrays", names)
step = "auto"
if full == "all":
    from ropewalk.scene import Air, Anchor, Clamp, Contact, Ground, Joint, Load, Material, Plane, Rope, Scene
    from ropewalk.scene import Shake, Slack, Slide, Straight, Tie
    stuff = Material(EA=2000.0, EI=0.02, mass_per_length=0.2, axial_damping=0.2, breaking_load=50.0,
                     parts=True)
    def rope(name, segments, shape, **more):
        length = 0.1 * segments
        own = {"made_of": stuff, "shape": shape} | more
        return Rope(name=name, segments=segments, length=length, diameter=0.01, **own)
    line = rope("line", 10, Slack(start=(0, 0, 0), end=(0.9, 0, 0)))
    hung = rope("hung", 3, Straight(start=(0.9, 0, 0), direction=(0, 0, -1)))
    hook = rope("hook", 2, Straight(start=(0, 0, 0), direction=(0, 0, -1)), loads=[Load(node=-1, mass=0.2)])
    scene = Scene(
        ropes=[line, hung, hook],
        anchors=[Anchor(name="a", rope="line", node=0, clamp=Clamp(direction=(1, 0, 0))),
                 Anchor(name="b", rope="line", node=9,
                        motion=Shake(axis=(0, 0, 1), amplitude=0.02, frequency=3.0))],
        joints=[Joint(name="knot", points=[Tie(rope="line", node=-1), Tie(rope="hung", node=0)])],
        slides=[Slide(rope="hook", at=0.62, friction=0.1, brake=0.05)],
        obstacles=[Plane(point=(0, 0.006, 0), normal=(0, -1, 0), friction=0.3)],
        contact=Contact(friction=0.2), air=Air(node_drag=0.05), ground=Ground(height=-0.18),
    )
    step = 5e-3 if method not in ("semi-implicit-euler", "adaptive") else "auto"
else:
    scene = rw.preset("r4")
scene = scene.replace(run=scene.run.replace(method=method, time_step=step))
if full != "plain" and full != "all":
    scene = scene.replace(limiter={"max_stretch": 1.5})
if full == "air":
    scene = scene.replace(air={"node_drag": 0.05})
if full == "ground":
    scene = scene.replace(ground={"height": -9.0})
rw.Simulation(scene).advance_frames(1)
"""


@cache
def _own_byte_code() -> dict[str, str]:
    """Return settings of Python with which a run finds the byte code of all that it imports."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    own = {"PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
    command = [sys.executable, "-c", "import ropewalk; ropewalk.Simulation"]
    subprocess.run(command, check=True, env=os.environ | own)
    return own


def seconds(method: str, laws: str = "plain", *, without: str = "") -> float:
    """Return the processor time of a run for one frame [s]. Without one law of nodes where one is named.

    `laws`: "plain" for preset r4; "full" for the variant that can have them all, of which it has a limiter;
    "air" and "ground" for that with such a law besides; "all" for ropes that have bending, clamps, joints, a
    slide, an obstacle, contact, air, ground, strength.
    """
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-c", SCENE, method, laws, without]
        own = _own_byte_code() | {"ROPEWALK_CACHE_DIR": folder}
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, env=os.environ | own)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def compile() -> list[Row]:  # noqa: A001 - the name of the case
    """Every kind of method, plain and with all laws, and what a law of nodes adds."""
    rows = []
    targets = {"semi-implicit-euler": ("<= 15", "<= 30")}
    for method in ("semi-implicit-euler", "implicit-euler", "esdirk3", "bdf2", "adaptive"):
        plain, full = targets.get(method, ("<= 45", "<= 45"))
        rows += [
            Row(f"first step of {method}, empty cache", seconds(method), "s", plain),
            Row(f"the same with a rarer law, {method}", seconds(method, "full"), "s", full),
            Row(f"the same with nine rarer laws, {method}", seconds(method, "all"), "s", full),
        ]
    whole = rows[1].value
    without = [seconds("semi-implicit-euler", "full", without=name) for name in LAWS]
    acting = [seconds("semi-implicit-euler", name) for name in LAWS]
    rows += [
        Row("a law of nodes adds, mean of air and ground", whole - mean(without), "s", "<= 3"),
        Row("a law of nodes that acts adds, mean of both", mean(acting) - whole, "s", "<= 3"),
    ]
    return rows
