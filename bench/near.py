"""How the cost of finding which segments may touch grows, for ropes that lie about equally close."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import cycle, pairwise

import numpy as np

import ropewalk as rw
from bench.clock import take_turns
from bench.row import Row
from ropewalk.laws.pairs.search import list_near
from ropewalk.lowering import Model, build
from ropewalk.scene import Contact, Points, Rope

SIZES = (1000, 2000, 4000, 8000, 16000)
PIECE, DIAMETER = 0.01, 0.004  # [m]
EACH, CELL, ROW = (
    16,
    0.15,
    0.03,
)  # segments of a short rope, room of each, from row to row of a long one [m]
MOVES = 6  # sets of places that take turns, each some tenths of a millimetre from the others


def scattered(count: int, along: int) -> list[np.ndarray]:
    """Return short bent ropes, turned at random, one each in equal cells along 2 or 3 axes, (17, 3) [m]."""
    rng, ropes = np.random.default_rng(0), count // EACH
    side = math.ceil(ropes ** (1.0 / along))
    found = []
    for cell in rng.permutation(side**along)[
        :ropes
    ]:  # numbered at random: beside each other by chance only
        angle = rng.uniform(0.0, 2.0 * math.pi) + rng.choice([-0.2, 0.2]) * np.arange(EACH)
        steps = PIECE * np.stack([np.cos(angle), np.sin(angle), np.zeros(EACH)], axis=1)
        if along == 3:
            steps = steps @ np.linalg.qr(rng.normal(size=(3, 3)))[0]
        x = np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])
        at = np.zeros(3)
        at[:along] = CELL * np.array(np.unravel_index(cell, (side,) * along))
        found.append(x - 0.5 * (x.min(axis=0) + x.max(axis=0)) + at)
    return found


def in_bights(count: int) -> list[np.ndarray]:
    """Return one rope that lies in rows, to and fro in half circles, as many as they are long, [m]."""
    pieces, turn = round(math.sqrt(count * ROW / PIECE)), round(0.5 * math.pi * ROW / PIECE)
    x, row = list[tuple[float, float, float]](), 0
    while len(x) <= count:
        sign = 1.0 if row % 2 == 0 else -1.0
        x += [(sign * PIECE * (k - 0.5 * pieces), ROW * row, 0.0) for k in range(pieces)]
        for k in range(turn):
            angle = math.pi * (k / turn - 0.5)
            out = sign * (0.5 * PIECE * pieces + 0.5 * ROW * math.cos(angle))
            x.append((out, ROW * (row + 0.5 * (1.0 + math.sin(angle))), 0.0))
        row += 1
    return [np.array(x[: count + 1])]


def model_of(places: list[np.ndarray]) -> Model:
    """Return the tables of ropes that touch each other, drawn through these places."""
    made_of = rw.Material(EA=1e3, mass_per_length=0.02)
    ropes = [
        Rope(
            name=f"rope{k}",
            segments=len(x) - 1,
            length=float(np.linalg.norm(np.diff(x, axis=0), axis=1).sum()),
            diameter=DIAMETER,
            made_of=made_of,
            shape=Points(points=x.tolist()),
        )
        for k, x in enumerate(places)
    ]
    run = rw.RunSettings(method="implicit-euler", time_step=1.0 / 60.0)
    return build(rw.Scene(ropes=ropes, contact=Contact(), run=run))


def search(model: Model) -> Callable[[], None]:
    """Return a function that lists the pairs of places that differ from those of the call before."""
    rng, state = np.random.default_rng(0), model.state
    moved = [state.x + 2e-4 * rng.normal(size=state.x.shape) for _ in range(MOVES + 1)]
    ways = cycle(pairwise(moved))
    table, memory = model.system.node.contact, state.memory.contact

    def look() -> None:
        before, after = next(ways)
        assert list_near(before, after, table, memory, state.tied)

    return look


def growth(costs: dict[int, float]) -> float:
    """Return the exponent with which costs grow, by least squares."""
    sizes = np.log(list(costs))
    return float(np.polyfit(sizes, np.log(list(costs.values())), 1)[0])


def finding_pairs() -> list[Row]:
    """Which of 1000 to 16000 segments may touch, of ropes that lie about: what it takes, how it grows."""
    rows = []
    for how, lie in (
        ("short ropes on a floor", lambda n: scattered(n, 2)),
        ("short ropes in a room", lambda n: scattered(n, 3)),
        ("a rope in bights", in_bights),
    ):
        models = {n: model_of(lie(n)) for n in SIZES}
        timing = take_turns({str(n): search(models[n]) for n in SIZES})
        costs = {n: timing.best(str(n)) for n in SIZES}
        sizes = {n: float(sum(a.nbytes for a in models[n].state.memory.contact)) for n in SIZES}
        for n in (SIZES[0], SIZES[-1]):
            each = 1e9 * costs[n] / n
            rows.append(Row(f"finding pairs, {how}, {n} segments", each, "ns/segment", ""))
            rows.append(
                Row(f"memory of contacts, {how}, {n} segments", sizes[n] / n, "B/segment", "")
            )
        rows.append(Row(f"finding pairs, {how}, growth", growth(costs), "1", "<= 1.15"))
        rows.append(Row(f"memory of contacts, {how}, growth", growth(sizes), "1", "<= 1.15"))
    return rows
