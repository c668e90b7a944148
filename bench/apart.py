"""What ropes that may touch cost while nothing is near them: the same scene without contact beside."""

from __future__ import annotations

import ropewalk as rw
from bench.clock import take_turns
from bench.implicit import Swing
from bench.row import Row
from ropewalk.scene import Contact, Plane, Straight

SIZES = ((1, 100), (50, 20))  # ropes, and segments of each
PIECE, THICK, APART = 0.02, 0.01, 0.1  # [m]
FRAME, SHORT = 1.0 / 60.0, 1e-5  # [s]
FILM = 64  # frames
METHODS = {
    "implicit-euler": (FRAME, 12),
    "sdirk2": (FRAME, 12),
    "esdirk3": (FRAME, 12),
    "semi-implicit-euler": (SHORT, 600),
}
FAR = Plane(point=(0.0, 0.0, -1e3))  # out of reach


def swinging(ropes: int, segments: int, EI: float, method: str) -> rw.Scene:
    """Return ropes side by side that are held at one end and swing down."""
    bends = {"EI": EI} if EI else {}
    made_of = rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=0.2, **bends)
    made = [
        rw.Rope(
            name=f"rope{k}",
            segments=segments,
            length=segments * PIECE,
            diameter=THICK,
            made_of=made_of,
            shape=Straight(start=(0.0, APART * k, 0.0), direction=(1.0, 0.0, -0.5)),
        )
        for k in range(ropes)
    ]
    step, steps = METHODS[method]
    run = rw.RunSettings(method=method, time_step=step, duration=step * steps)
    ends = [rw.Anchor(name=rope.name, rope=rope.name, node=0) for rope in made]
    return rw.Scene(ropes=made, anchors=ends, run=run)


class Film:
    """So many frames of a scene from its start, as a run takes them: Python and what is recorded with it."""

    def __init__(self, scene: rw.Scene, frames: int) -> None:
        self.simulation, self.frames = rw.Simulation(scene, ledger=False), frames
        self.start = self.simulation.state
        self.run()  # by now calls have as many frames as they will

    def restore(self) -> None:
        """Go back to the start."""
        self.simulation.restore(self.start)

    def run(self) -> None:
        """Take the frames."""
        self.simulation.advance_frames(self.frames)


def films(method: str, ropes: int, segments: int) -> Row:
    """Frames of a scene with `contact` over those without, in the air."""
    scene, frames = (
        swinging(ropes, segments, 0.0, method),
        FILM if METHODS[method][0] == FRAME else 6,
    )
    run = scene.run.replace(duration=frames / 60.0, frame_rate=60.0)
    scene = scene.replace(run=run)
    both = {"without": Film(scene, frames), "with": Film(scene.replace(contact=Contact()), frames)}
    runs = {name: one.run for name, one in both.items()}
    timing = take_turns(runs, rounds=8, before={name: one.restore for name, one in both.items()})
    said = f"frames, contact, nothing near / without, air: {method}, {ropes} x {segments}"
    return Row(said, timing.ratio("with", "without"), "1", "")


def nothing_near() -> list[Row]:
    """A step with `contact` over one without, in the air and above a floor out of reach; frames of many."""
    rows = []
    for method, (_, steps) in METHODS.items():
        for ropes, segments in SIZES:
            rows.append(films(method, ropes, segments))
            for EI, how in ((0.0, ""), (1e-4, ", bending")):
                scene = swinging(ropes, segments, EI, method)
                floor = scene.replace(obstacles=[FAR])
                swings = {
                    "air": Swing(scene, steps),
                    "air, contact": Swing(scene.replace(contact=Contact()), steps),
                    "floor": Swing(floor, steps),
                    "floor, contact": Swing(floor.replace(contact=Contact()), steps),
                }
                runs = {name: one.run for name, one in swings.items()}
                before = {name: one.restore for name, one in swings.items()}
                timing = take_turns(runs, rounds=12, before=before)
                for place, target in (("air", "<= 1.25" if ropes == 1 else ""), ("floor", "")):
                    said = f"contact, nothing near / without, {place}: {method}, {ropes} x {segments}{how}"
                    target = "" if method == "semi-implicit-euler" else target
                    rows.append(Row(said, timing.ratio(f"{place}, contact", place), "1", target))
    return rows
