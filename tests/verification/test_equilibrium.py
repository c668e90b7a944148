"""Equilibria against closed forms, against other scenes, and against forces taken from places alone."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.optimize import brentq

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.scene import Air, Ground, Load, Points, Rope, Straight
from ropewalk.statics import NoRest, static_shape
from ropewalk.statics.balance import Balance
from ropewalk.statics.newton import settle

G = 9.81
UP = np.array([0.0, 1.0, 0.0])


def springs(k: float, m: float, length: float, **more: object) -> rw.Springs:
    return rw.Springs(spring_constant=k, node_mass=m, segment_length=length, **more)


def chain(
    segments: int,
    stuff: rw.Springs | rw.Material,
    end: tuple[float, float, float] | None = None,
    held: tuple[int, ...] = (0, -1),
    shape: object = None,
    length: float | None = None,
    loads: tuple[Load, ...] = (),
    **scene: object,
) -> rw.Scene:
    rope = Rope(
        segments=segments,
        made_of=stuff,
        shape=shape or Straight(start=(0, 0, 0), end=end),
        length=length,
        loads=loads,
    )
    anchors = tuple(rw.Anchor(node=node) for node in held)
    return rw.Scene(**({"gravity": (0, -G, 0)} | scene), ropes=(rope,), anchors=anchors)


def imbalance(scene: rw.Scene, positions: np.ndarray, ground: bool = False) -> np.ndarray:
    """Force on every node from weight, springs and ground, written down again here [N]."""
    state = build(scene).state
    d = np.diff(positions, axis=0)
    r = np.linalg.norm(d, axis=1)
    pull = state.stiffness * (r - state.rest_length)
    if scene.ropes[0].made_of.tension_only:
        pull = np.maximum(pull, 0.0)
    net = state.mass[:, None] * np.array(scene.gravity)
    net[:-1] += (pull / r)[:, None] * d
    net[1:] -= (pull / r)[:, None] * d
    if ground:
        depth = scene.ground.height - positions @ UP
        net += scene.ground.repulsion * np.maximum(depth, 0.0)[:, None] * UP
    return net


# -- chains ------------------------------------------------------------------------------

# Closed forms 2.2: (across, rise, segments, k, m, L).
CHAINS = {
    "slack": (0.8, 0.0, 20, 1000.0, 0.01, 0.05),
    "uneven": (0.6, 0.5, 20, 1000.0, 0.01, 0.05),
    "span": (1.0, 0.0, 20, 1000.0, 0.01, 0.05),
    "stretched": (1.02, 0.0, 20, 1000.0, 0.01, 0.05),
    "NeHe": (3.95, 0.0, 79, 1e4, 0.05, 0.05),
    "report": (20.0, 0.0, 20, 1e4, 0.05, 1.0),
}


def newton(scene: rw.Scene, inertia: float = 1.0) -> np.ndarray:
    """Places of the nodes by Newton's method alone, from the scene's own shape."""
    model = build(scene)
    balance = Balance(model)
    start = np.maximum(balance.elastic(model.state.x), 0.0)
    found = settle(balance, model.state.x.copy(), start, inertia)
    assert found.at_rest
    return found.x.T


@pytest.mark.parametrize("name", CHAINS)
def test_newton_comes_to_the_exact_chain(name: str) -> None:
    # The closed form is the exact discrete solution: 1e-10 relative, from a straight line.
    across, rise, segments, k, m, length = CHAINS[name]
    exact = rw.lumped_chain(np.full(segments - 1, m * G), k, length, across, rise)
    scene = chain(segments, springs(k, m, length), end=(across, rise, 0.0))
    found = newton(scene)
    size = segments * length
    np.testing.assert_allclose(found[:, :2], exact.positions, atol=1e-10 * size)
    result = rw.equilibrium(scene)
    np.testing.assert_allclose(result.positions[0, :, :2], exact.positions, atol=1e-12 * size)
    np.testing.assert_allclose(result.tension[0], exact.tension, rtol=1e-10)
    left = imbalance(scene, result.positions[0])
    assert np.abs(left[1:-1]).max() < 1e-14 * k * size * 20  # k times the rounding of the places
    np.testing.assert_allclose(result.reactions[0], -left[[0, -1]], atol=1e-14 * k * size * 20)
    moved = result.positions[0].copy()
    moved[segments // 2] += 1e-6 * size
    assert np.abs(imbalance(scene, moved)[1:-1]).max() > 1e-7 * k * size


def test_the_taut_section_of_the_report() -> None:
    # Seed systems: N springs over N metres; 20 springs at k 10000: 0.7181 m, H 34.094 N.
    result = rw.equilibrium(chain(20, springs(1e4, 0.05, 1.0), end=(20.0, 0.0, 0.0)))
    assert result.status == "at rest"
    assert -result.positions[0, 10, 1] == pytest.approx(0.7181, abs=0.51e-4)
    assert -result.reactions[0, 0, 0] == pytest.approx(34.094, abs=0.51e-3)
    assert result.residual < 1e-12
    softer = rw.equilibrium(chain(20, springs(9.9e3, 0.05, 1.0), end=(20.0, 0.0, 0.0)))
    assert abs(softer.positions[0, 10, 1] + 0.7181) > 1e-3


def test_a_material_converges_to_the_elastic_catenary_at_second_order() -> None:
    # Irvine 1981: L 1, w 1.962, EA 50, ends 0.6 apart and 0.5 up (closed forms 2.4).
    exact = rw.elastic_catenary(1.0, 0.6, 0.5, 0.2 * G, 50.0)
    errors, pulls = [], []
    for n in (20, 40, 80):
        stuff = rw.Material(EA=50.0, mass_per_length=0.2)
        result = rw.equilibrium(chain(n, stuff, end=(0.6, 0.5, 0.0), length=1.0))
        places = exact.position(np.linspace(0.0, 1.0, n + 1))
        errors.append(np.abs(result.positions[0, :, :2] - places).max())
        pulls.append(abs(result.reactions[0, -1, 0] - exact.horizontal))
    for values in (errors, pulls):
        orders = [math.log2(a / b) for a, b in itertools.pairwise(values)]
        np.testing.assert_allclose(orders, 2.0, atol=0.05)
    assert errors[-1] < 1e-4


@pytest.mark.parametrize("EA", [1e-2, 1.0, 1e3, 1e6, 1e9, 1e12])
def test_any_stiffness_from_any_shape(EA: float) -> None:
    # A tangle to begin with; the closed form for any stiffness. Its places are compared, with the
    # rounding that a stiffness leaves in the tension as the only tolerance.
    rng = np.random.default_rng(1)
    points = np.cumsum(rng.normal(size=(31, 3)), axis=0) * 0.1
    points[-1] = points[0] + np.array([0.7, 0.1, 0.0])
    stuff = rw.Material(EA=EA, mass_per_length=0.2)
    scene = chain(30, stuff, shape=Points(points=points.tolist()), length=1.0)
    exact = rw.lumped_chain(np.full(29, 0.2 * G / 30), EA * 30, 1.0 / 30, 0.7, 0.1)
    found = newton(scene) - points[0]
    scale = max(1.0, np.abs(exact.positions).max())
    np.testing.assert_allclose(found[:, :2], exact.positions, atol=1e-9 * scale)
    np.testing.assert_allclose(found[:, 2], 0.0, atol=1e-9 * scale)


def test_rigid_links() -> None:
    # Closed forms 2.2 E: 20 rigid links of 0.05 m, 0.8 m apart: lowest -0.2657915666, H 0.663109127.
    model = build(chain(20, springs(1000.0, 0.01, 0.05), end=(0.8, 0.0, 0.0)))
    model.state.stiffness[...] = math.inf
    found = static_shape(model)
    assert found.positions[:, 1].min() == pytest.approx(-0.2657915666, abs=1e-10)
    assert found.spans[0].horizontal == pytest.approx(0.663109127, rel=1e-9)
    lengths = np.linalg.norm(np.diff(found.positions, axis=0), axis=1)
    np.testing.assert_allclose(lengths, 0.05, rtol=1e-12)
    # Newton alone, from the straight line that is too short for its links.
    balance = Balance(model)
    balance.soft = np.full(20, 1e-6)
    first = settle(balance, model.state.x.copy(), np.zeros(20), 1.0)
    balance.soft = np.zeros(20)
    again = settle(balance, first.x, first.tension)
    assert again.at_rest
    np.testing.assert_allclose(again.x.T, found.positions, atol=1e-10)


def test_three_anchors_a_load_and_a_free_end_meet_their_weight() -> None:
    scene = chain(
        30,
        springs(800.0, 0.05, 0.1),
        end=(2.5, 0.4, 0.3),
        held=(3, 12, 24),
        loads=(Load(node=7, mass=2.0), Load(node=-1, mass=0.3)),
    )
    result = rw.equilibrium(scene)
    left = imbalance(scene, result.positions[0])
    free = np.delete(left, [3, 12, 24], axis=0)
    assert np.abs(free).max() < 1e-9
    weight = build(scene).state.mass.sum() * G
    np.testing.assert_allclose(result.reactions[0].sum(axis=0), [0.0, weight, 0.0], atol=1e-9)
    # The load is where the polygon has its largest kink.
    turns = np.diff(np.diff(result.positions[0, 3:13], axis=0), axis=0)
    assert np.argmax(np.linalg.norm(turns, axis=1)) == 7 - 4


# -- ground, wind ---------------------------------------------------------------------------


def test_a_linear_wind_is_a_tilted_gravity() -> None:
    # Linear drag c w on every node of equal mass is a gravity tilted by c w/m, exactly.
    wind, drag, mass = np.array([3.0, 0.0, -2.0]), 0.02, 0.05
    stuff = springs(500.0, mass, 0.1)
    blown = chain(20, stuff, end=(1.5, 0.3, 0.0), air=Air(node_drag=drag, wind=tuple(wind)))
    tilted = chain(
        20, stuff, end=(1.5, 0.3, 0.0), gravity=tuple(np.array([0, -G, 0]) + drag / mass * wind)
    )
    found, exact = rw.equilibrium(blown), rw.equilibrium(tilted)
    np.testing.assert_allclose(found.positions, exact.positions, atol=1e-10)
    np.testing.assert_allclose(found.tension, exact.tension, rtol=1e-9)
    calm = rw.equilibrium(chain(20, stuff, end=(1.5, 0.3, 0.0)))
    assert np.abs(calm.positions - exact.positions).max() > 0.01


def test_a_rope_in_a_stream_streams() -> None:
    # Quadratic drag along the line: far from the held end the rope lies at the angle at which the
    # weight's part across it is the drag's: mu g cos(a) = rho d Cn/2 U^2 sin(a)^2 (towing theory,
    # e.g. Pode 1951); drag along it does not turn it.
    U, rho, d, Cn, mu = 12.0, 1.2, 0.03, 1.2, 0.2
    air = Air(density=rho, normal_coefficient=Cn, tangential_coefficient=0.0, wind=(U, 0, 0))
    rope = Rope(
        segments=40,
        made_of=rw.Material(EA=1e7, mass_per_length=mu),
        length=10.0,
        diameter=d,
        shape=Straight(start=(0, 0, 0), direction=(1, -1, 0)),
    )
    scene = rw.Scene(gravity=(0, -G, 0), ropes=(rope,), anchors=(rw.Anchor(node=0),), air=air)
    result = rw.equilibrium(scene)
    steps = np.diff(result.positions[0], axis=0)
    angle = np.arctan2(-steps[:, 1], steps[:, 0])
    push = 0.5 * rho * d * Cn * U * U
    expected = brentq(lambda a: mu * G * math.cos(a) - push * math.sin(a) ** 2, 0.01, 1.57)
    np.testing.assert_allclose(angle, expected, atol=1e-6)  # a free end: straight all along
    half = scene.replace(air=air.replace(wind=(U / 2, 0, 0)))
    assert np.diff(rw.equilibrium(half).positions[0], axis=0)[0, 1] < steps[0, 1] * 1.2


def touchdown(length: float, across: float, height: float) -> float:
    """a = H/w of an inextensible rope between two points above a ground on which it rests.

    Each arm has the arc sqrt(h^2 + 2 a h) and the width a acosh(1 + h/a).
    """

    def excess(a: float) -> float:
        arm, width = math.sqrt(height**2 + 2 * a * height), a * math.acosh(1 + height / a)
        return 2 * width + (length - 2 * arm) - across

    return brentq(excess, 1e-6, 1e3)


def test_a_rope_that_lies_on_the_ground_between_its_ends() -> None:
    # A stiff ground and a stiff rope against the inextensible one on a hard ground.
    a = touchdown(10.0, 8.6, 1.0)
    pulls = []
    for n in (100, 200):
        stuff = rw.Material(EA=1e7, mass_per_length=0.3)
        ground = Ground(height=-1.0, repulsion=1e6)
        scene = chain(n, stuff, end=(8.6, 0.0, 0.0), length=10.0, ground=ground)
        result = rw.equilibrium(scene)
        assert np.abs(imbalance(scene, result.positions[0], ground=True)[1:-1]).max() < 1e-4
        pulls.append(abs(-result.reactions[0, 0, 0] / (0.3 * G * a) - 1.0))
        on_it = result.positions[0, :, 1] < -1.0
        arm = math.sqrt(1.0 + 2 * a)
        assert on_it.sum() * 10.0 / n == pytest.approx(10.0 - 2 * arm, abs=0.2)
        weight = 3.0 * G - result.reactions[0, :, 1].sum()
        depth = -1.0 - result.positions[0, on_it, 1]
        assert weight == pytest.approx(1e6 * depth.sum(), rel=1e-3)
    # The touchdown falls on some place within a segment: an error of about l/arm times one half.
    assert max(pulls) < 0.01
    assert abs(touchdown(10.2, 8.6, 1.0) / a - 1.0) > 0.1


def test_a_rope_dropped_on_the_ground_lies_there() -> None:
    ground = Ground(height=0.0, repulsion=200.0)
    stuff = springs(1000.0, 0.05, 0.1)
    shape = Straight(start=(0, 1, 0), end=(0.9, 1.3, 0.2))
    result = rw.equilibrium(chain(10, stuff, shape=shape, held=(), ground=ground))
    np.testing.assert_allclose(result.positions[0, :, 1], -0.05 * G / 200.0, atol=1e-10)
    lengths = np.linalg.norm(np.diff(result.positions[0], axis=0), axis=1)
    np.testing.assert_allclose(lengths, 0.1, atol=1e-10)


def test_a_free_end_reaches_the_ground() -> None:
    # What hangs free carries itself; the anchor holds as many nodes as hang, the ground the others.
    result = rw.equilibrium("n40")
    on_ground = result.positions[0, :, 1] < -1.5
    hanging = int((~on_ground).sum())
    depth = -1.5 - result.positions[0, on_ground, 1]
    assert result.reactions[0, 0, 1] + 100.0 * depth.sum() == pytest.approx(80 * 0.05 * G, rel=1e-9)
    assert result.reactions[0, 0, 1] == pytest.approx(hanging * 0.05 * G, rel=1e-6)
    assert abs(result.reactions[0, 0, 0]) < 1e-9


# -- slack, pressed ---------------------------------------------------------------------------


def test_pressed_and_slack_segments() -> None:
    # One spring of 0.05 m between anchors 0.04 m apart pushes with k 0.01; tension-only it is slack.
    pushed = rw.equilibrium(chain(1, springs(1000.0, 0.01, 0.05), end=(0.04, 0.0, 0.0)))
    assert pushed.tension[0, 0] == pytest.approx(-10.0, rel=1e-12)
    one_way = springs(1000.0, 0.01, 0.05, tension_only=True)
    assert rw.equilibrium(chain(1, one_way, end=(0.04, 0.0, 0.0))).tension[0, 0] == 0.0
    # A chain stood on its end is a solution, too, but falls: the one found hangs.
    up = chain(10, springs(1e4, 0.01, 0.05), held=(0,), shape=Straight(direction=(0, 1, 0)))
    hung = rw.equilibrium(up)
    assert hung.positions[0, -1, 1] < -0.5
    assert hung.tension.min() > 0.0


def test_random_scenes_come_to_rest() -> None:
    # 60 scenes with everything; the residual is asked for in units of a node's weight, or rounding of
    # the largest tension.
    rng = np.random.default_rng(21)
    for trial in range(60):
        n, size, mu = int(rng.integers(2, 50)), 10 ** rng.uniform(-1, 2), 10 ** rng.uniform(-2, 1)
        weight = mu * size * G / n
        end = rng.normal(size=3) * size * rng.uniform(0.05, 0.6)
        stuff = rw.Material(
            EA=10 ** rng.uniform(0, 9) * weight, mass_per_length=mu, tension_only=bool(trial % 2)
        )
        ground = Ground(height=float(rng.normal() * size / 3), repulsion=100 * weight / size * n)
        scene = chain(
            n,
            stuff,
            end=tuple(end),
            length=size,
            held=((0,), (0, -1), (0, n // 2, -1))[trial % 3 if n > 3 else 0],
            air=Air(density=1.2, wind=(3.0, 0.0, -2.0)) if trial % 4 == 1 else None,
            ground=ground if trial % 5 == 2 else None,
        )
        result = rw.equilibrium(scene)
        assert result.residual <= 1e-8 * weight + 1e-12 * result.tension.max(), trial


def test_no_shape_found_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    model = build(chain(20, springs(1000.0, 0.01, 0.05), end=(1.2, 0.0, 0.0)))
    model.state.stiffness[...] = math.inf
    model.state.stiffness[3] = 1e3  # one spring between rigid links: it reaches, and is at rest
    assert static_shape(model).stretch[3] > 4.0
    model.state.stiffness[3] = math.inf
    with pytest.raises(rw.SceneError, match="must be more than the distance of the ends"):
        static_shape(model)
    monkeypatch.setattr("ropewalk.statics.newton.STEPS", 0)
    blown = chain(
        20, springs(1000.0, 0.01, 0.05), end=(0.8, 0.0, 0.0), air=Air(node_drag=0.1, wind=(5, 0, 0))
    )
    with pytest.raises(NoRest, match="no shape of rest was found in 0 steps"):
        static_shape(blown)


# -- bending -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("gamma", "aspect"), [(0.1, 0.01249955366), (1.0, 0.1245617664), (10.0, 1.06680232)]
)
def test_the_cantilever_test(gamma: float, aspect: float) -> None:
    # Closed forms 5.5 (Romero et al. 2021): y/x of the tip of a clamped rod under its own weight,
    # Gamma = w L^3/EI; second order in the segment.
    errors = []
    for n in (80, 160):  # below 80 the error in x and y still partly cancel
        stuff = rw.Material(EA=1e7, EI=0.1 * G / gamma, mass_per_length=0.1)
        rope = Rope(segments=n, length=1.0, made_of=stuff)
        clamped = rw.Anchor(node=0, clamp=rw.Clamp(direction=(1, 0, 0)))
        found = rw.equilibrium(rw.Scene(ropes=(rope,), anchors=(clamped,)))
        tip = found.positions[0, -1]
        errors.append(abs(-tip[2] / tip[0] / aspect - 1.0))
        # The clamp carries the whole weight, and its moment about the clamped end.
        np.testing.assert_allclose(found.reactions[0, 0], [0, 0, 0.1 * G], atol=1e-9)
    assert errors[1] < 5e-5
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)


@pytest.mark.parametrize(("segments", "EI"), [(10, 1e-3), (10, 1.0), (100, 1.0)])
def test_a_taut_beam_without_weight(segments: int, EI: float) -> None:
    # Rounding of its bends is all the force there is on a node: no measure of what is at rest.
    # w_n^2 = (T k^2 + EI k^4) / mu, k = n pi / L (Rayleigh, Theory of Sound, 189).
    EA, pull, mu = 1e6, 30.0, 0.5
    stuff = rw.Material(EA=EA, EI=EI, mass_per_length=mu)
    taut = chain(segments, stuff, end=(1 + pull / EA, 0, 0), length=1.0, gravity=(0, 0, 0))
    found = rw.equilibrium(taut)
    np.testing.assert_allclose(found.tension[0], pull, rtol=1e-6)
    np.testing.assert_allclose(found.reactions[0, 1], [pull, 0, 0], rtol=1e-6, atol=1e-9)
    k = math.pi * np.arange(1, 4)
    rates = 2 * math.pi * rw.modes(taut, count=6).frequencies[::2]
    np.testing.assert_allclose(
        rates, np.sqrt((pull * k**2 + EI * k**4) / mu), rtol=8.0 / segments**2
    )
