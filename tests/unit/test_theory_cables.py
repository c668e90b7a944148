"""Catenary, elastic catenary and parabola against the differential equation, tables and limits."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from scipy.integrate import solve_bvp, solve_ivp

import ropewalk as rw
from ropewalk.rigging.lines import _bisected
from ropewalk.theory import Cable, catenary, elastic_catenary, parabola

# length, across, rise, weight, EA
CASES = [
    (1.0, 0.8, 0.0, 1.962, 50.0),  # slack
    (1.0, 0.6, 0.5, 1.962, 50.0),  # uneven ends
    (1.0, 0.6, -0.5, 1.962, 50.0),
    (1.0, 1.02, 0.0, 1.962, 50.0),  # stretched
    (1.0, 1.3, 0.9, 1.962, 50.0),  # no lowest point between the ends
    (10.0, 0.01, 1.0, 3.0, 1e4),  # nearly plumb
    (10.0, 9.999, 0.3, 3.0, 1e7),  # nearly taut and stiff
]


def integrate(cable: Cable) -> np.ndarray:
    """The far end, by integrating dr/ds = (1 + T/EA) t from the first support's force."""

    def slope(s: float, _: np.ndarray) -> list[float]:
        across, up = cable.horizontal, cable.weight * s - cable.vertical
        pull = math.hypot(across, up)
        return [across / pull + across / cable.EA, up / pull + up / cable.EA]

    found = solve_ivp(slope, (0.0, cable.length), [0.0, 0.0], rtol=1e-12, atol=1e-13, max_step=0.05)
    return np.asarray(found.y[:, -1])


@pytest.mark.parametrize("case", CASES)
def test_the_shape_solves_the_differential_equation(case: tuple[float, ...]) -> None:
    # H and V come from the closed form; the ends must be met by the integration. Tolerance: the
    # integrator's, 1e-12 per step over some hundred steps.
    length, across, rise, weight, EA = case
    cable = elastic_catenary(*case)
    np.testing.assert_allclose(integrate(cable), [across, rise], atol=2e-10 * length)
    np.testing.assert_allclose(cable.position(length), [across, rise], atol=1e-12 * length)
    wrong = Cable(length, across, rise, weight, EA, 1.001 * cable.horizontal, cable.vertical)
    assert np.abs(integrate(wrong) - [across, rise]).max() > 1e-8


@pytest.mark.parametrize("case", [CASES[0], CASES[1], CASES[3]])
def test_the_shape_is_that_of_the_boundary_value_problem(case: tuple[float, ...]) -> None:
    # Nothing of the closed form goes in: T and angle as unknown fields, with both ends given.
    length, across, rise, weight, EA = case

    def equations(s: np.ndarray, y: np.ndarray) -> np.ndarray:
        x, z, H, V = y
        pull = np.hypot(H, V)
        stretch = 1.0 / pull + 1.0 / EA
        return np.stack([H * stretch, V * stretch, np.zeros_like(x), np.full_like(z, weight)])

    def ends(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.array([a[0], a[1], b[0] - across, b[1] - rise])

    s = np.linspace(0.0, length, 201)
    guess = np.stack([across * s, rise * s, np.ones_like(s), weight * (s - 0.5)])
    solved = solve_bvp(equations, ends, s, guess, tol=1e-9, max_nodes=20000)
    assert solved.success
    cable = elastic_catenary(*case)
    np.testing.assert_allclose(cable.position(s), solved.sol(s)[:2].T, atol=1e-8)
    np.testing.assert_allclose(cable.tension(s), np.hypot(*solved.sol(s)[2:]), rtol=1e-6)


@pytest.mark.parametrize(
    ("across", "rise", "H", "V", "middle"),
    [
        (0.8, 0.0, 0.6300720579, 0.981, (0.4, -0.2780142628)),
        (0.6, 0.5, 0.3679126504, 0.4582213792, (0.4152543995, 0.02663170466)),
        (1.0, 0.0, 1.931952414, 0.981, (0.5, -0.1245770505)),
        (1.02, 0.0, 2.349455997, 0.981, (0.51, -0.1050991988)),
    ],
)
def test_elastic_catenary_of_the_table(
    across: float, rise: float, H: float, V: float, middle: tuple[float, float]
) -> None:
    # Closed forms 2.4: L0 1, w 1.962, EA 50.
    cable = elastic_catenary(1.0, across, rise, 1.962, 50.0)
    assert cable.horizontal == pytest.approx(H, rel=1e-9)
    assert cable.vertical == pytest.approx(V, rel=1e-9)
    np.testing.assert_allclose(cable.position(0.5), middle, atol=1e-9)
    np.testing.assert_allclose(np.add(cable.start_force, cable.end_force), [0.0, 1.962], atol=1e-14)


@pytest.mark.parametrize(
    ("length", "across", "rise", "a", "depth", "tension"),
    [
        (1.0, 0.8, 0.0, 0.3382018791, 0.2654375091, 0.6036393882),
        (1.0, 0.6, 0.5, 0.1950992456, 0.1033090155, 0.2984082611),
        (10.0, 8.0, 2.0, 3.555186541, 1.622676437, 5.177862978),
    ],
)
def test_catenary_of_the_table(
    length: float, across: float, rise: float, a: float, depth: float, tension: float
) -> None:
    # Closed forms 2.3, and y = a cosh((x - x0)/a) itself.
    cable = catenary(length, across, rise)
    assert cable.horizontal == pytest.approx(a, rel=1e-9)
    assert -cable.lowest[2] == pytest.approx(depth, rel=1e-9)
    assert float(cable.tension(0.0)) == pytest.approx(tension, rel=1e-9)
    x, z = cable.position(np.linspace(0.0, length, 50)).T
    x0 = across / 2 - a * math.atanh(rise / length)
    np.testing.assert_allclose(z, a * (np.cosh((x - x0) / a) - math.cosh(x0 / a)), atol=2e-9)
    assert cable.stretched_length == length


def test_a_stiff_elastic_catenary_is_the_inextensible_one() -> None:
    # The difference is first order in 1/EA.
    rigid = catenary(1.0, 0.6, 0.5, 1.962)
    gaps = [
        np.abs(elastic_catenary(1.0, 0.6, 0.5, 1.962, EA).position(0.4) - rigid.position(0.4)).max()
        for EA in (1e5, 1e6)
    ]
    assert gaps[0] / gaps[1] == pytest.approx(10.0, rel=1e-3)
    assert gaps[1] < 2e-6
    assert elastic_catenary(1.0, 0.6, 0.5, 1.962) == rigid


@pytest.mark.parametrize("excess", [1e-12, 1e-9, 1e-6, 1e-3])
def test_a_nearly_taut_catenary(excess: float) -> None:
    # Arc length of a shallow cable: L - D = w^2 D^3/(24 H^2), relative error of order excess.
    cable = catenary(1.0 + excess, 1.0)
    slack = (1.0 + excess) - 1.0
    assert cable.horizontal == pytest.approx(math.sqrt(1.0 / (24.0 * slack)), rel=excess + 1e-12)
    assert cable.sag == pytest.approx(0.125 / cable.horizontal, rel=2 * excess + 1e-12)


def test_a_very_slack_catenary_is_two_plumb_lines() -> None:
    for across in (1e-3, 1e-6, 1e-9):
        cable = catenary(1.0, across, 0.2, 2.0)
        plumb = catenary(1.0, 0.0, 0.2, 2.0)
        assert plumb.vertical == pytest.approx(0.8)  # 0.4 m at 2 N/m
        s = np.linspace(0.0, 1.0, 11)
        np.testing.assert_allclose(cable.position(s), plumb.position(s), atol=across * 20)
    assert plumb.sag == pytest.approx(0.4)
    assert plumb.horizontal == 0.0


@pytest.mark.parametrize(
    ("rise", "vertical"),
    [
        # depth = (V - wL/2) L/EA + (|V| - |V - wL|)/w = -rise, by hand for L 1, w 2, EA 10
        (0.0, 1.0),
        (-1.5, 5.0 + 1.0),  # all of it hangs down: 0.1 (V - 1) + 1 = 1.5
        (1.5, -5.0 + 1.0),
        (-0.55, 1.0 + 0.55 / 1.1),  # 0.1 (V - 1) + (V - 1) = 0.55
    ],
)
def test_an_elastic_cable_whose_ends_are_on_one_vertical(rise: float, vertical: float) -> None:
    cable = elastic_catenary(1.0, 0.0, rise, 2.0, 10.0)
    assert cable.vertical == pytest.approx(vertical, rel=1e-14)
    np.testing.assert_allclose(cable.position(1.0), [0.0, rise], atol=1e-15)
    near = elastic_catenary(1.0, 1e-7, rise, 2.0, 10.0)
    assert near.vertical == pytest.approx(vertical, rel=1e-5)


def test_hanging_free_is_the_pulled_cable_without_pull() -> None:
    # Closed forms 2.1: a rod hung from its end is w L^2/2EA longer; then the lower end's force is 0.
    stretched = 1.0 + 1.962 / (2 * 50.0)
    cable = elastic_catenary(1.0, 0.0, -stretched, 1.962, 50.0)
    assert cable.vertical == pytest.approx(1.962, rel=1e-12)
    assert cable.end_force == pytest.approx((0.0, 0.0), abs=1e-12)
    assert cable.stretched_length == pytest.approx(stretched, rel=1e-12)


def test_stretched_length_and_sag_against_sampling() -> None:
    for case in CASES:
        cable = elastic_catenary(*case)
        s = np.linspace(0.0, cable.length, 200_001)
        points = cable.position(s)
        path = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        assert cable.stretched_length == pytest.approx(path, rel=1e-7)
        drop = points[:, 0] * case[2] / case[1] - points[:, 1]
        assert cable.sag == pytest.approx(drop.max(), rel=1e-6)


def test_a_weightless_cable_is_straight() -> None:
    cable = elastic_catenary(1.0, 0.9, 1.2, 0.0, 10.0)
    assert cable.tension(0.3) == pytest.approx(5.0)  # 10 N times the strain 1.5 - 1
    np.testing.assert_allclose(cable.position([0.0, 0.5, 1.0]), [[0, 0], [0.45, 0.6], [0.9, 1.2]])
    assert cable.end_force == pytest.approx((3.0, 4.0))
    assert cable.start_force == pytest.approx((-3.0, -4.0))
    assert cable.sag == 0.0
    assert cable.stretched_length == pytest.approx(1.5)


@pytest.mark.parametrize("rise", [0.0, 3.0])
def test_the_parabola_is_the_shallow_limit(rise: float) -> None:
    # Its error is of the order (sag/D)^2: 16 times as little sag, 256 times as little error.
    errors = []
    for weight in (3.2, 0.2):
        exact = elastic_catenary(10.0, math.sqrt(100.0 - rise**2), rise, weight, 1e4)
        shallow = parabola(10.0, exact.across, rise, weight, 1e4)
        errors.append(abs(shallow.horizontal / exact.horizontal - 1.0))
        assert shallow.sag == pytest.approx(exact.sag, rel=0.01)
        place = exact.position(5.0)
        assert shallow.height(place[0]) == pytest.approx(place[1], abs=0.02 * exact.sag)
        assert shallow.tension(0.0) == pytest.approx(exact.tension(0.0), rel=0.01)
    sags = (elastic_catenary(10.0, 10.0, 0.0, w, 1e4).sag for w in (3.2, 0.2))
    ratio = (next(sags) / next(sags)) ** 2
    assert errors[1] < errors[0] / ratio * 1.5


def test_the_parabola_of_a_cable_of_its_span_is_the_cube_root_law() -> None:
    # Closed forms 2.5: d/L = (3 w L/64 EA)^(1/3) where the ends are one length apart.
    found = parabola(2.0, 2.0, 0.0, 0.3, 500.0)
    assert found.sag / 2.0 == pytest.approx((3 * 0.6 / (64 * 500.0)) ** (1 / 3), rel=1e-12)
    # d/L of the elastic catenary itself, closed forms 2.5's table, is within 0.5 % below 1e-3.
    exact = elastic_catenary(1.0, 1.0, 0.0, 1e-3, 1.0)
    assert exact.sag == pytest.approx(0.03610644482, rel=5e-3)


def test_random_cables_close() -> None:
    rng = np.random.default_rng(3)
    for _ in range(300):
        length, weight = 10 ** rng.uniform(-2, 4), 10 ** rng.uniform(-4, 4)
        EA = 10 ** rng.uniform(-3, 12) * weight * length
        across = length * 10 ** rng.uniform(-8, 0.6)
        rise = length * rng.normal() * 10 ** rng.uniform(-3, 0.3)
        cable = elastic_catenary(length, across, rise, weight, EA)
        size = length + across + abs(rise)
        np.testing.assert_allclose(cable.position(length), [across, rise], atol=1e-12 * size)
        assert cable.horizontal > 0.0


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: catenary(1.0, 1.0), "length: 1 m - must be more than the distance of the ends"),
        (lambda: catenary(1.0, 0.8, 0.7), "an inextensible cable is not stretched"),
        (lambda: elastic_catenary(0.9, 1.0), "must be more than the distance"),
        (lambda: parabola(1.0, 1.0), "must be more than the distance"),
        (lambda: parabola(1.0, 0.0, 0.5), "across: 0.0 - must be a positive number"),
        (lambda: elastic_catenary(1.0, 0.5, 0.0, 0.0, 9.0), "nothing gives it a shape"),
        (lambda: elastic_catenary(1.0, 0.5, 0.0, 1.0, -9.0), "EA: -9.0 - must be a positive"),
        (lambda: catenary(-1.0, 0.5), "length: -1.0 - must be a positive number of m"),
        (lambda: catenary(1.0, -0.5), "across: -0.5 - must be a number of m, not negative"),
        (lambda: catenary(1.0, 0.5, math.nan), "rise: nan - must be a finite number"),
        (lambda: catenary(1.0, 0.5, weight=0.0), "weight: 0.0 - must be a positive number"),
    ],
)
def test_impossible_cables_are_refused(call, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()


@pytest.mark.parametrize(("way", "unit"), [("sag", "m"), ("pretension", "N"), ("length", "m")])
def test_bounds_of_a_line_that_are_told_are_those_of_one(way: str, unit: str) -> None:
    """ "From 0.0005567 m to 992.8 m" was rounded to the nearest, and both were refused."""
    told = list[str]()
    for value in (1e-9, 1e12 / 2.0):
        with pytest.raises(rw.SceneError) as refused:
            rw.line(100.123, 3.0, "wire-7x19-12", **{way: value})  # type: ignore[arg-type]
        number = rf"([\d.e+-]+ [kM]?{unit})"
        pair = re.findall(
            rf"from {number} to {number}|at (?:least|most) {number}", str(refused.value)
        )
        told += [bound for bound in pair[0] if bound]
    assert len(set(told)) == 2
    for bound in told:
        assert rw.line(100.123, 3.0, "wire-7x19-12", **{way: bound}).length > 0.0  # type: ignore[arg-type]


def test_the_least_length_that_is_told_is_possible_to_the_last_bit() -> None:
    """Of 5.7 m / 1.9 = 3.0000000000000004 m "at least 3 m" was told, and 3 m refused with the same words."""
    assert 5.7 / 1.9 > 3.0
    assert rw.line(5.7, 0.0, "wire-7x19-12", length=3.0).length == 3.0
    with pytest.raises(rw.SceneError, match="must be at least 3 m"):
        rw.line(5.7, 0.0, "wire-7x19-12", length=2.9999999)
    assert _bisected(0.3, lambda size: size, 0.1 + 0.2, 1.0) == pytest.approx(0.3)
    assert _bisected(0.299999, lambda size: size, 0.1 + 0.2, 1.0) == (0.1 + 0.2, 1.0)
