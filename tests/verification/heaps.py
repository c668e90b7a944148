"""Random heaps: piles that are fed onto a floor, and tangles; what they come to, judged without contacts.

    cd tests; PYTHONPATH=../src:. python -m verification.heaps --seeds 100 --out heaps.csv

runs so many of each, half of them with bending, and says how many steps found no solution, what passed
through what, how much energy there was and how they creep at rest. With --feeds it makes the table of
`docs/how-to/pile.md` instead.
"""

from __future__ import annotations

import argparse
import csv
import time
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from statistics import median

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws import contact_frame
from ropewalk.laws.pairs.distance import nearest
from ropewalk.laws.pairs.table import CONTACTS, FAULT, NEAR, PUSH
from ropewalk.methods.verdict import energy_now
from ropewalk.scene import (
    Air,
    Anchor,
    Contact,
    Material,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Velocity,
)
from ropewalk.simulation import Broken, Simulation
from verification.tangles import kind_of, tangle
from verification.topology import crossings, determinant

STEP = 1.0 / 60.0  # [s]
FAR = 10.0  # [m]
REST = 10.0  # [s] after the last of it was fed
TOP = 0.1  # [m] where the hand stops


def pile(seed: int, bends: bool) -> Scene:
    """A rope whose lower end is held on the floor, and that a hand lowers onto it.

    So it is a closed curve, by way of what lies above the hand and below the floor: that it stays unknotted
    tells that no end went round.
    """
    rng = np.random.default_rng([seed, 2026])
    segments = int(rng.integers(60, 121))
    diameter = float(rng.uniform(0.004, 0.008))
    one = float(rng.uniform(1.5, 2.5)) * diameter
    length, speed = segments * one, float(rng.uniform(0.2, 0.8))
    along = np.linspace(0.0, 1.0, segments + 1)
    sway = rng.normal(size=(2, 3)) * 0.02 * length
    x = np.zeros((segments + 1, 3))
    for axis in range(2):  # not quite upright: it would stand on its end
        x[:, axis] = sum(sway[axis, k - 1] * np.sin(k * np.pi * along) / k for k in (1, 2, 3))
    x[:, 2] = 0.5 * diameter + along * length
    x = hung(x, one, 0.5 * diameter)
    stuff = {"EA": float(10.0 ** rng.uniform(2, 5)), "mass_per_length": 800.0 * diameter**2}
    if bends:
        stuff["EI"] = float(10.0 ** rng.uniform(-6, -4))
    rope = Rope(
        segments=segments,
        length=length,
        diameter=diameter,
        made_of=Material(axial_damping=0.1, **stuff),
        shape=Points(points=x.tolist()),
    )
    return lowered(rope, x, speed, float(rng.choice([0.0, 0.1, 0.3, 0.6])))


def hung(x: Floats, one: float, foot: float) -> Floats:
    """Make every segment as long as it should be [m], from the top down, its end so high; (n, 3)."""
    x = x.copy()
    for i in range(len(x) - 1, 0, -1):
        step = x[i - 1] - x[i]
        x[i - 1] = x[i] + one * step / np.linalg.norm(step)
    x[:, 2] += foot - x[0, 2]
    return x


def lowered(rope: Rope, x: Floats, speed: float, friction: float) -> Scene:
    """The rope onto a floor, its lower end held, by a hand that goes down to TOP; then it rests."""
    fed = (x[-1, 2] - TOP) / speed
    hand = Anchor(node=-1, motion=Velocity(velocity=(0.0, 0.0, -speed), stop=fed))
    return Scene(
        ropes=[rope],
        anchors=[Anchor(node=0), hand],
        obstacles=[Plane(friction=0.4)],
        contact=Contact(friction=friction),
        air=Air(node_drag=0.1 * rope.own_mass / rope.segments),
        run=RunSettings(
            method="implicit-euler", time_step=STEP, frame_rate=1.0 / STEP, duration=fed + REST
        ),
    )


def knot_of_pile(x: Floats) -> int:
    """The determinant of such a rope, closed by way of above the hand and below the floor; x is (3, n)."""
    low, top = x[:, 0], x[:, -1]
    far = [[*top[:2], FAR], [FAR, 0, FAR], [FAR, 0, -FAR], [*low[:2], -FAR]]
    closed = np.vstack([x.T, far])
    turns = np.linspace(0.1, 2.0, 8)
    return determinant(closed, min(turns, key=lambda turn: len(crossings([closed], turn)[0])))


def passes(before: Floats, after: Floats, links: Ints) -> int:
    """How many pairs of segments go through each other if all nodes go straight; places (3, n).

    Two segments meet only in a plane: where the volume that their four ends span has a root, and their lines
    cross within both. An even number of roots is a way in and out again. `links` (m, 2) are the nodes of
    each segment.
    """
    i, j = np.triu_indices(len(links), 1)
    ends = np.stack([links[i, 0], links[i, 1], links[j, 0], links[j, 1]])
    apart = ~np.any(ends[:2, None] == ends[None, 2:], axis=(0, 1))
    # their middles are no farther apart than both are long, and have gone
    middle, way = before[:, links].mean(2), np.abs(after - before).max()
    size = np.linalg.norm(np.diff(before[:, links], axis=2)[..., 0], axis=0).max()
    close = np.linalg.norm(middle[:, i] - middle[:, j], axis=0) < 1.1 * size + 4.0 * way
    ends = ends[:, apart & close]
    a, b, c, d = before[:, ends].transpose(1, 0, 2)
    p, q, r, s = after[:, ends].transpose(1, 0, 2)

    def volume(share: Floats | float) -> Floats:
        e, f, g = (y + share * (z - y) for y, z in ((b - a, q - p), (d - c, s - r), (c - a, r - p)))
        return np.asarray(np.einsum("kn,kn->n", np.cross(e, f, axis=0), g))

    found, at = 0, np.linspace(0.0, 1.0, 4)
    values = np.array([volume(share) for share in at])
    for k in np.flatnonzero(values[0] * values[-1] < 0.0):
        for root in np.roots(np.polyfit(at, values[:, k], 3)):
            if abs(root.imag) < 1e-9 and 0.0 <= root.real <= 1.0:
                now = before[:, ends[:, k]] + root.real * (after - before)[:, ends[:, k]]
                edges = np.stack([now[:, 1] - now[:, 0], now[:, 2] - now[:, 3]], axis=1)
                places = np.linalg.lstsq(edges, now[:, 2] - now[:, 0], rcond=None)[0]
                found += bool(np.all((places > 0.0) & (places < 1.0)))
    return found


@dataclass
class Heap:
    """What a heap came to: all of a run, and the last second of it as rest."""

    kind: str
    seed: int
    bends: bool
    steps: int = 0
    unsolved: int = 0  # the step at which no solution was found, 0: none
    passed: int = 0  # pairs of segments that went through each other
    changed: int = 0  # looks at which it was not the knot or link it was
    energy: float = 0.0  # most [1] of what was there at the start
    deepest: float = 0.0  # [1] overlap over the diameter, at any step
    rest: float = 0.0  # the same at the end
    contacts: int = 0  # most
    creep: float = 0.0  # [mm/s] of the fastest node over the last second
    middle: float = 0.0  # [mm/s] of the median one
    lying: float = 0.0  # [mm/s] of the fastest one that does not hang from the hand
    cost: float = 0.0  # [ms] processor time of a step
    dearest: float = 0.0  # [ms] of the dearest step
    busy: float = 0.0  # [ms] of one with 75 contacts and more
    still: float = 0.0  # [ms] of one of the last second


def deepest(simulation: Simulation) -> tuple[float, int]:
    """The largest overlap of two segments over their diameter, and how many touch."""
    table, state = simulation.system.node.contact, simulation.arrays
    memory, most, touching = state.memory.contact, 0.0, 0
    for i, j in memory.near[: memory.tally[NEAR]]:
        size = table.radius[i] + table.radius[j]
        depth = 1.0 - nearest(state.x, state.x, 0.0, int(i), int(j))[2] / size
        most, touching = max(most, depth), touching + (depth > 0.0)
    return most, touching


def hanging(simulation: Simulation) -> int:
    """How many nodes next to the hand, the last of a pile, touch nothing: they swing, and do not creep."""
    state = simulation.arrays
    memory, pushed = state.memory.contact, state.memory.obstacle.grip[:, contact_frame.PUSH]
    touched = (pushed > 0.0).any(axis=0)
    for row in range(memory.tally[CONTACTS]):
        if memory.grip[row, PUSH] > 0.0:
            for segment in memory.pair[row]:
                touched[segment : segment + 2] = True
    return int(np.argmax(touched[::-1])) if touched.any() else len(touched)


def links_of(scene: Scene) -> Ints:
    """The nodes of every segment, (m, 2); a loop's last one ends where its first one begins."""
    links, at = [], 0
    for rope in scene.ropes:
        nodes = list(range(at, at + rope.nodes))
        links += list(
            zip(nodes[:-1], [*nodes[1:-1], at if scene.joints else nodes[-1]], strict=True)
        )
        at += rope.nodes
    return np.array(links)


def run(kind: str, seed: int, bends: bool, seconds: float = 7.0) -> Heap:
    """Let a random heap fall, to rest; a tangle for so long [s]."""
    if kind == "pile":
        return watch(pile(seed, bends), Heap(kind, seed, bends))
    return watch(tangle(seed, 1 + seed % 3, bends), Heap(kind, seed, bends), seconds)


def watch(scene: Scene, made: Heap, duration: float | None = None) -> Heap:
    """Step through a scene, so long [s] or as it says, and note what it comes to."""
    simulation, links = Simulation(scene), links_of(scene)

    def what(x: Floats) -> object:
        return kind_of(scene, x) if scene.joints else knot_of_pile(x)

    state = simulation.arrays
    first, start = what(state.x), energy_now(simulation.system, state)
    frames = round((duration or scene.run.duration) / STEP)
    costs: list[tuple[float, int]] = []
    lay = state.x
    for frame in range(frames):
        before, begun = state.x.copy(), time.process_time()
        if frame == frames - 60:
            lay = before
        try:
            simulation.step(STEP)
        except Broken:
            made.unsolved = frame + 1
            break
        spent = 1e3 * (time.process_time() - begun)
        state = simulation.arrays
        made.passed += passes(before, state.x, links)
        made.rest, touching = deepest(simulation)
        costs.append((spent, touching))
        made.deepest = max(made.deepest, made.rest)
        made.unsolved += int(state.memory.contact.tally[FAULT] != 0)
        made.energy = max(made.energy, energy_now(simulation.system, state) / start)
        if frame % 20 == 19 or frame == frames - 1:
            made.changed += what(state.x) != first
    reckon(made, costs[3:])  # the first ones compile
    ways = 1e3 * np.linalg.norm(state.x - lay, axis=0)
    made.creep, made.middle = float(ways.max()), float(np.median(ways))
    lies = len(ways) - (0 if scene.joints else hanging(simulation))
    made.lying = float(ways[:lies].max(initial=0.0))
    return made


def reckon(made: Heap, costs: list[tuple[float, int]]) -> None:
    """Note what steps cost [ms], by the contacts that they had."""
    spent, contacts = np.array(costs).reshape(-1, 2).T
    made.steps, made.cost = len(spent), float(spent.mean()) if len(spent) else 0.0
    made.dearest, made.contacts = float(spent.max(initial=0.0)), int(contacts.max(initial=0.0))
    made.still = float(spent[-60:].mean()) if len(spent) else 0.0
    busy = spent[contacts >= 75]
    made.busy = float(busy.mean()) if len(busy) else 0.0


#: Segments, EA [N], EI [N m^2], speed [m/s] of the piles in the docs' table.
FEEDS = (
    (200, 1e3, 0.0, 0.2),
    (200, 1e3, 0.0, 0.4),
    (200, 1e3, 0.0, 0.8),
    (200, 1e2, 0.0, 0.4),
    (200, 1e4, 0.0, 0.4),
    (200, 1e5, 0.0, 0.4),
    (200, 1e6, 0.0, 0.4),
    (200, 1e3, 1e-5, 0.4),
    (400, 1e3, 0.0, 0.4),
)


def fed(segments: int, stiffness: float, bending: float, speed: float) -> Scene:
    """A cord of 5 mm, segments of 7.5 mm, its lower end held, fed onto a floor."""
    one, diameter = 0.0075, 0.005
    along = np.arange(segments + 1) * one
    x = np.zeros((segments + 1, 3))
    x[:, 0] = 0.005 * np.sin(7.0 * along)
    x[:, 1] = 0.005 * np.sin(5.0 * along + 1.0)
    x[:, 2] = along
    x = hung(x, one, 0.5 * diameter)
    rope = Rope(
        segments=segments,
        length=segments * one,
        diameter=diameter,
        made_of=Material(EA=stiffness, EI=bending, mass_per_length=0.02, axial_damping=0.05),
        shape=Points(points=x.tolist()),
    )
    return lowered(rope, x, speed, 0.3)


def feeds() -> None:
    """Print the table of the docs, as Markdown."""
    head = "segments, EA [N], EI [N m²], fed at [m/s], most contacts, ms a step, from 75 contacts on, dearest"
    head += (
        ", at rest, deepest, at rest, fastest lying; median node at rest [mm/s], unsolved, passed"
    )
    print("| " + head.replace(", ", " | ").replace(";", ",") + " |")
    print("|---" * 14 + "|")
    for segments, stiffness, bending, speed in FEEDS:
        made = watch(fed(segments, stiffness, bending, speed), Heap("fed", 0, bending > 0.0))
        print(
            f"| {segments} | {stiffness:g} | {bending:g} | {speed:g} | {made.contacts} | {made.cost:.1f} "
            f"| {made.busy:.1f} | {made.dearest:.0f} | {made.still:.2f} | {100 * made.deepest:.1f} % "
            f"| {100 * made.rest:.2f} % | {made.lying:.1g}, {made.middle:.1g} | {made.unsolved} "
            f"| {made.passed + made.changed} |",
            flush=True,
        )


def main() -> None:
    """Run them, a line each, and say what they came to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=100, help="of piles, and of tangles")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--tangles", action="store_true", help="no piles")
    parser.add_argument("--seconds", type=float, default=7.0, help="of each tangle")
    parser.add_argument("--out", type=Path, default=Path("heaps.csv"))
    parser.add_argument("--feeds", action="store_true", help="only the table of piles in the docs")
    given = parser.parse_args()
    if given.feeds:
        feeds()
        return
    kinds, heaps = ("pile", "tangle")[given.tangles :], list[Heap]()
    with given.out.open("w", newline="") as file:
        lines = csv.DictWriter(file, [field.name for field in fields(Heap)])
        lines.writeheader()
        for seed in range(given.first, given.first + given.seeds):
            for kind in kinds:
                heaps.append(run(kind, seed, seed % 2 == 1, given.seconds))
                lines.writerow(asdict(heaps[-1]))
                file.flush()
    for kind in kinds:
        of = [heap for heap in heaps if heap.kind == kind]
        whole = [heap for heap in of if not heap.unsolved]
        print(
            f"{len(of)} {kind}s: {len(of) - len(whole)} with an unsolved step, "
            f"{sum(h.passed > 0 for h in of)} in which something passed, "
            f"{sum(h.changed > 0 for h in of)} that changed their knots; "
            f"energy at most {max(h.energy for h in of):.3f} of the first, "
            f"deepest {100 * max(h.deepest for h in of):.1f} %, "
            f"at rest {100 * max(h.rest for h in of):.1f} %, "
            f"at most {max(h.contacts for h in of)} touch; "
            f"creep {max(h.creep for h in whole):.2g} mm/s, median of the fastest "
            f"{median(h.creep for h in whole):.2g}, of what does not hang "
            f"{max(h.lying for h in whole):.2g} and {median(h.lying for h in whole):.2g}, "
            f"of the median nodes {median(h.middle for h in whole):.2g}; "
            f"{sum(h.cost for h in of) / len(of):.1f} ms a step, dearest {max(h.dearest for h in of):.0f} ms"
        )


if __name__ == "__main__":
    main()
