"""Bending at rest against closed forms: cantilevers, elastica, buckling, frequencies, rings.

The discrete rod is a chain of hinges with half a cell at a clamp, second order in segment length. Numbers
x.y are those of the reference solutions in `docs/theory/closed-forms.md`. Strains P / EA are below 1e-5 here.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from ropewalk.laws.clamps import start_clamps
from ropewalk.scene import Anchor, Rope
from verification.rods import Rod, clamped, order, rod
from verification.setups import off

PINNED = (Anchor(node=0), Anchor(node=-1))


def tip_under_load(segments: int, load: float, cell: float = 1.0, **more: float) -> np.ndarray:
    """Place of a cantilever's tip under a dead load along z [m], (3,); `cell` 1/2 is half a cell."""
    rope = Rod(rod(segments, **more))
    rope.system.bending.clamp_stiffness[...] *= cell
    rope.load[2, -1] = load
    return rope.settle()[-1]


def test_small_deflection_of_a_cantilever() -> None:
    """w = P L^3 / 3 EI (Euler-Bernoulli; Timoshenko, Strength of Materials I). The chain of hinges with a
    half cell at the clamp has w (1 + 1 / 2 n^2): hinge i at x_i turns by P (L - x_i) l_i / EI, summed.
    Twin: a whole cell at the clamp, first order (0.15 / n at n = 10 already).
    """
    load = 1e-3
    exact = load / 3.0
    for n in (10, 20, 40):
        error = tip_under_load(n, load)[2] / exact - 1.0
        # slope^2 effects: (P / 2)^2 ~ 2.5e-7
        assert error == pytest.approx(0.5 / n**2, abs=1e-6)
    whole = [tip_under_load(n, load, cell=0.5)[2] / exact - 1.0 for n in (20, 40)]
    assert order(whole) == pytest.approx(1.0, abs=0.1)
    assert whole[1] > 0.03


def bisshopp_drucker(load: float) -> tuple[float, float]:
    """Deflection and shortening of a cantilever's tip over its length, P L^2 / EI = `load` (5.3)."""

    def miss(angle: float) -> float:
        m = 0.5 * (1.0 + math.sin(angle))
        start = math.asin(1.0 / math.sqrt(2.0 * m))
        return float(ellipk(m) - ellipkinc(start, m)) - math.sqrt(load)

    angle = brentq(miss, 1e-9, 0.5 * math.pi - 1e-12, xtol=1e-15)
    m = 0.5 * (1.0 + math.sin(angle))
    start = math.asin(1.0 / math.sqrt(2.0 * m))
    down = 1.0 - 2.0 * float(ellipe(m) - ellipeinc(start, m)) / math.sqrt(load)
    return down, 1.0 - math.sqrt(2.0 * math.sin(angle) / load)


def test_large_deflection_of_a_cantilever() -> None:
    """Bisshopp & Drucker 1945, Q. Appl. Math. 3:272, by elliptic integrals (5.3); second order.
    Twin: linear theory has P L^3 / 3 EI = 1.67 L.
    """
    load = 5.0
    down, short = bisshopp_drucker(load)
    assert (down, short) == pytest.approx((0.7137915236, 0.3876283607), abs=1e-9)
    errors = []
    for n in (20, 40, 80):
        tip = tip_under_load(n, load, EA=1e6)
        errors.append(math.hypot(tip[2] - down, 1.0 - tip[0] - short))
    assert errors[-1] < 1e-4
    assert order(errors) == pytest.approx(2.0, abs=0.15)
    assert abs(load / 3.0 - down) > 0.9


def test_a_cantilever_bent_by_its_own_weight() -> None:
    """Romero et al. 2021, ACM TOG 40(4):66: y/x of the tip by Gamma = w L^3 / EI (5.5); second order.
    Twin: a whole cell at the clamp is first order.
    """

    def ratio(n: int, weight: float, cell: float = 1.0) -> float:
        rope = Rod(rod(n, gravity=(0.0, 0.0, -weight), EA=1e7))
        rope.system.bending.clamp_stiffness[...] *= cell
        x, _, z = rope.settle()[-1]
        return float(-z / x)

    errors = [ratio(n, 1.0) - 0.1245617664 for n in (20, 40)]
    assert abs(errors[-1]) < 1e-4
    assert order(errors) == pytest.approx(2.0, abs=0.1)
    assert ratio(50, 10.0) == pytest.approx(1.06680232, abs=1e-3)
    whole = [ratio(n, 1.0, 0.5) - 0.1245617664 for n in (20, 40)]
    assert order(whole) == pytest.approx(1.0, abs=0.1)


def critical_load(n: int, anchors: list[Anchor], softer: float = 1.0) -> float:
    """P L^2 / EI at which the straight compressed rod's least stiffness is zero."""
    EA = 1e7
    rope = Rod(rod(n, EA=EA, anchors=anchors))
    rope.state.bending_stiffness[...] *= softer

    def least(load: float) -> float:
        rope.state.x[0] = np.linspace(0.0, 1.0 - load / EA, n + 1)
        return float(np.linalg.eigvalsh(rope.stiffness())[0])

    return float(brentq(least, 0.5, 60.0, xtol=1e-9))


def test_euler_s_loads() -> None:
    """pi^2, pi^2 / 4 and 4 pi^2 EI / L^2 (Euler 1744; 5.1). Hinges have exactly 4 n^2 sin^2(pi / 2n) pinned
    and 4 n^2 sin^2(pi / 4n) clamped at one end (Hencky 1920). Twin: half of EI has half the load.
    """
    for n in (10, 20):
        hinges = 4.0 * n**2 * math.sin(0.5 * math.pi / n) ** 2
        assert critical_load(n, list(PINNED)) == pytest.approx(hinges, rel=3e-6)
        column = 4.0 * n**2 * math.sin(0.25 * math.pi / n) ** 2
        assert critical_load(n, [clamped()]) == pytest.approx(column, rel=3e-6)
    errors = [critical_load(n, list(PINNED)) - math.pi**2 for n in (10, 20)]
    assert order(errors) == pytest.approx(2.0, abs=0.05)
    both = [clamped(), clamped(-1)]
    errors = [critical_load(n, both) - 4.0 * math.pi**2 for n in (20, 40)]
    assert order(errors) == pytest.approx(2.0, abs=0.05)
    assert critical_load(10, list(PINNED), 0.5) == pytest.approx(0.5 * math.pi**2, rel=0.01)


# cos b cosh b = -1 clamped-free, cos b cosh b = 1 clamped-clamped; b = pi j pinned
BETAS = {
    "clamped-free": (1.8751040687, 4.6940911330, 7.8547574382),
    "clamped-clamped": (4.7300407449, 7.8532046241, 10.9956078380),
    "pinned": (math.pi, 2.0 * math.pi, 3.0 * math.pi),
}
ENDS = {
    "clamped-free": [clamped()],
    "clamped-clamped": [clamped(), clamped(-1)],
    "pinned": list(PINNED),
}


@pytest.mark.parametrize("ends", ENDS)
def test_natural_frequencies_of_beams(ends: str) -> None:
    """w = b^2 sqrt(EI / mu L^4) (Timoshenko, Vibration Problems in Engineering), in both planes; second
    order. Twin: the frequencies of a string go with j, not j^2.
    """
    expected = np.array(BETAS[ends]) ** 2
    errors = []
    for n in (20, 40):
        found = Rod(rod(n, EA=1e7, anchors=ENDS[ends])).frequencies()[:6]
        assert off(found[::2], found[1::2]) < 1e-3 * found[0]
        errors.append(np.abs(found[::2] / expected - 1.0))
    assert errors[-1].max() < 0.01
    for mode in range(3):
        if errors[-1][mode] > 1e-5:
            assert order([e[mode] for e in errors]) == pytest.approx(2.0, abs=0.1)
    assert expected[1] / expected[0] > 2.7


def test_natural_curvature_closes_a_ring() -> None:
    """A rope of length 2 pi / curvature is a regular polygon at rest, right-handed about its axis, from any
    start, without energy. Twin: half the curvature makes half a circle.
    """
    for share, gap in ((1.0, 0.0), (0.5, 2.0 / math.pi)):
        n = 16
        rope = Rod(rod(n, EA=1e4, anchors=[Anchor(node=0)], curvature=(0, share * 2 * math.pi, 0)))
        rope.state.x[2] = 0.1 * np.sin(np.arange(n + 1.0))
        x = rope.settle()
        e = np.diff(x, axis=0) * n
        turns = np.cross(e[:-1], e[1:])
        assert off(turns, [0.0, math.sin(2.0 * math.pi * share / n), 0.0]) < 1e-8
        assert np.linalg.norm(x[-1] - x[0]) == pytest.approx(gap, abs=2e-3 if gap else 1e-9)


def test_reaction_and_moment_of_a_clamp() -> None:
    """Balance of forces and of moments about the clamp: R + P = 0, M + x_tip x P = 0. Twin: the moment of a
    whole segment's lever too many.
    """
    n, load = 12, 2.0
    rope = Rod(rod(n, EA=1e4))
    rope.load[2, -1] = load
    tip = rope.settle()[-1]
    start_clamps(rope.system, rope.state)
    moment = rope.state.moment[0, :3]
    torque = np.cross(tip, [0.0, 0.0, load])
    assert off(moment, -torque) < 1e-8
    assert off(moment, -torque * (1.0 + 1.0 / n)) > 0.05


def test_a_clamp_in_the_middle_holds_both_sides() -> None:
    """Two cantilevers of half the length: w = P (L/2)^3 / 3 EI (1 + 1 / 2 n^2) at either end. Twin: a
    plain anchor lets the rod turn.
    """
    n, load = 20, 1e-3
    rope = Rod(rod(n, anchors=[clamped(n // 2)]))
    rope.load[2, 0] = rope.load[2, -1] = load
    x = rope.settle()
    expected = load * 0.125 / 3.0 * (1.0 + 0.5 / (n // 2) ** 2)
    assert off(x[[0, -1], 2], expected) < 1e-5 * expected
    free = Rod(rod(n, anchors=[Anchor(node=n // 2), Anchor(node=0)]))
    free.load[2, -1] = load
    assert abs(free.settle()[-1, 2] - expected) > 0.5 * expected


def test_the_rope_stays_the_same_rope() -> None:
    """Bends times segments: B = EI / l. Twin: one B for all n, as springs would have it."""
    rope = rod(10).ropes[0]
    finer = Rope(segments=20, length=1.0, made_of=rope.made_of)
    assert finer.bending_stiffness == rope.bending_stiffness == 1.0
    coarse, fine = (Rod(rod(n)).state.bending_stiffness[2] for n in (10, 20))
    assert fine == pytest.approx(2.0 * coarse, rel=1e-14)
    assert tip_under_load(20, 1e-3)[2] == pytest.approx(tip_under_load(10, 1e-3)[2], rel=5e-3)
