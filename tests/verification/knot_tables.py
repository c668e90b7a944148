"""Make the tables of knots in the docs, as Markdown.

    cd tests; PYTHONPATH=../src:. python -m verification.knot_tables bends loads brakes trefoil

Minutes. `--friction` and `--stiffness` ask for other rows.
"""

from __future__ import annotations

import argparse
import math
from typing import Literal

from ropewalk.simulation import Broken
from verification.loaded_knots import LOADED, braked, follow, loaded, ratio
from verification.test_hitches import bend
from verification.trefoil import Pulled, pulled, shape

TREFOILS = (
    (0.0, 0.002),
    (0.05, 0.004),
    (0.05, 0.002),
    (0.05, 0.001),
    (0.05, 0.0005),
    (0.1, 0.002),
    (0.15, 0.002),
)
#: friction, diameter and segments [m]
SHAPES = (
    *((0.0, 0.004, 0.002), (0.0, 0.002, 0.002), (0.0, 0.001, 0.001), (0.0, 0.0005, 0.001)),
    *((0.05, 0.002, 0.002), (0.15, 0.002, 0.002)),
)


def head(*names: str) -> None:
    """Print the head of a table."""
    print("\n| " + " | ".join(names) + " |\n" + "|---" * len(names) + "|", flush=True)


def row(*cells: object) -> None:
    """Print a row."""
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def _bent(knot: Literal["reef", "granny"], friction: float, stiffness: float) -> str:
    try:
        most, slid = bend(knot, friction, stiffness)
    except Broken:
        return "no step while drawn tight"
    way = f"{abs(most):.0f} N, {1e3 * slid:.1f} mm"
    if most < 0.0:
        return f"no step beyond {way}"
    if slid > 0.05:
        return f"slips at {way}"
    return f"holds {way}" if most > 700.0 else way  # at the end of the run


def bends(frictions: list[float], stiffnesses: list[float]) -> None:
    """Print reef against granny."""
    knots: tuple[Literal["reef", "granny"], ...] = ("reef", "granny")
    head("friction", *(f"{knot}, EI = {EI:g} N m²" for EI in stiffnesses for knot in knots))
    for mu in frictions:
        row(f"{mu:g}", *(_bent(knot, mu, EI) for EI in stiffnesses for knot in knots))


def loads(frictions: list[float], stiffnesses: list[float]) -> None:
    """Print what knots bear with a free tail."""
    passed = 0
    for stiffness in stiffnesses:
        print(f"\nEI = {stiffness:g} N m²")
        head("friction", *LOADED)
        for friction in frictions:
            cells = []
            for knot in LOADED:
                try:
                    borne = follow(loaded(knot, friction, stiffness))
                except Broken:
                    cells.append("no step while drawn tight")
                    continue
                passed += borne.passed
                cells.append(str(borne))
            row(f"{friction:g}", *cells)
    print(f"\n{passed} pairs of segments went through each other")


def brakes(frictions: list[float], _: list[float]) -> None:
    """Print the ratio of tensions of a Munter on a ring and of turns about a bollard."""
    passed = 0
    head("friction", "munter on a ring", "two turns", "e^(4 pi mu)")
    for friction in frictions:
        cells = []
        for knot, force, sizes in (("munter", 10.0, {"ring_radius": 0.1}), ("bollard", 1.0, {})):
            try:
                found, through = ratio(braked(knot, friction, force, **sizes))
            except Broken:
                cells.append("no step")
                continue
            passed += through
            cells.append(f"{found:.3g}")
        row(f"{friction:g}", *cells, f"{math.exp(4 * math.pi * friction):.3g}")
    print(f"\n{passed} pairs of segments went through each other")


def trefoil(_: list[float], __: list[float]) -> None:
    """Print the pull of open trefoils against the law, and where their strands press."""
    head(
        "friction", "R / r", "T R²/EI, tightening", "loosening", "mean", "half", "law", "half / law"
    )
    for friction, diameter in TREFOILS:
        found: Pulled = pulled(friction, diameter)
        law = found.law(friction)
        row(
            f"{friction:g}",
            f"{found.slender:.0f}",
            *(f"{value:.3f}" for value in (found.tighter, found.looser, found.mean, found.half)),
            f"{law:.3f}",
            f"{found.half / law:.2f}" if law else "",
        )
    head("friction", "R / r", "force", "outer points: share", "their place", "others: rms place")
    for friction, diameter, one in SHAPES:
        braid = shape(friction, diameter, one)
        row(
            f"{friction:g}",
            f"{braid.slender:.0f}",
            *(f"{value:.3f}" for value in braid[1:]),
        )


def main() -> None:
    """Print those that are asked for."""
    tables = {"bends": bends, "loads": loads, "brakes": brakes, "trefoil": trefoil}
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("table", nargs="+", choices=tables)
    parser.add_argument("--friction", type=float, nargs="*", default=[0.0, 0.1, 0.2, 0.3, 0.4, 0.6])
    parser.add_argument("--stiffness", type=float, nargs="*", default=[0.0, 1e-3])
    given = parser.parse_args()
    for table in given.table:
        tables[table](given.friction, given.stiffness)


if __name__ == "__main__":
    main()
