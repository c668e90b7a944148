"""Natural modes against closed forms, against friction's exact decay, and against runs."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk import theory
from ropewalk.lowering import build
from ropewalk.scene import Air, Load, Points, Rope, Slack, Straight
from ropewalk.vibration import modes

G = 9.81


def scene(
    segments: int,
    held: tuple[int, ...] = (0, -1),
    gravity: tuple[float, float, float] = (0.0, -G, 0.0),
    end: tuple[float, float, float] | None = None,
    k: float = 1000.0,
    m: float = 0.01,
    length: float = 0.05,
    c: float = 0.0,
    friction: str = "vector",
    **more: object,
) -> rw.Scene:
    stuff = rw.Springs(
        spring_constant=k, node_mass=m, segment_length=length, spring_friction=c, friction=friction
    )
    shape = more.pop("shape", Straight(end=end))
    rope = Rope(segments=segments, made_of=stuff, shape=shape, loads=more.pop("loads", ()))
    anchors = tuple(rw.Anchor(node=node) for node in held)
    return rw.Scene(gravity=gravity, ropes=(rope,), anchors=anchors, **more)


def rates(found: rw.Modes) -> np.ndarray:
    """Angular frequencies [rad/s]."""
    return 2.0 * math.pi * found.frequencies


# -- without friction ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("segments", "held", "ends"), [(21, (0, -1), "fixed-fixed"), (20, (0,), "fixed-free")]
)
def test_straight_chains(segments: int, held: tuple[int, ...], ends: str) -> None:
    # Closed forms 1.1, exact: 1e-10 relative for all twenty. At rest length nothing holds sideways.
    found = rw.modes(scene(segments, held, gravity=(0, 0, 0)), about="start", count=60)
    along = [i for i, motion in enumerate(found.motions) if motion.name == "along"]
    np.testing.assert_allclose(
        rates(found)[along], theory.chain_frequencies(20, 1000.0, 0.01, ends), rtol=1e-10
    )
    assert [found.motions[i].half_waves for i in along][:3] == [1, 2, 3]
    assert (np.delete(found.frequencies, along) < 1e-5).all()  # rounding of the rest lengths
    wrong = theory.chain_frequencies(20, 1000.0, 0.0101, ends)
    assert np.abs(rates(found)[along] / wrong - 1.0).min() > 1e-3


def test_taut_string() -> None:
    # Closed forms 3.1: 50 segments stretched to 1 m at 50 N: 157.0537954 rad/s, every mode twice,
    # and w_n = 2 sqrt(T/(m l)) sin(n pi/100).
    L0 = 1.0 / 1.01
    stuff = rw.Material(EA=5000.0, mass_per_length=0.02 / L0)
    rope = Rope(segments=50, length=L0, made_of=stuff, shape=Straight(end=(1, 0, 0)))
    held = (rw.Anchor(node=0), rw.Anchor(node=-1))
    found = rw.modes(rw.Scene(gravity=(0, 0, 0), ropes=(rope,), anchors=held), count=12)
    n = np.repeat(np.arange(1, 7), 2)
    exact = 2.0 * np.sqrt(50.0 / (0.02 / 50 * 0.02)) * np.sin(n * np.pi / 100)
    np.testing.assert_allclose(rates(found), exact, rtol=1e-10)
    assert rates(found)[0] == pytest.approx(157.0537954, rel=1e-9)
    assert {motion.name for motion in found.motions[:2]} == {"in plane", "out of plane"}
    shape = found.shapes[0, :, 1:].real
    sine = np.sin(np.pi * np.arange(51) / 50)
    np.testing.assert_allclose(np.abs(shape).max(axis=1), sine, atol=1e-9)


@pytest.mark.parametrize("masses", [1, 5, 20])
def test_hanging_rigid_links(masses: int) -> None:
    # Closed forms 3.3: zeros of the Laguerre polynomial, exact, in two planes.
    model = build(scene(masses, (0,), length=1.0 / masses))
    model.state.stiffness[...] = math.inf
    found = modes(model, count=2 * masses)
    exact = theory.rigid_chain_frequencies(masses, 1.0 / masses)
    np.testing.assert_allclose(rates(found), np.repeat(exact, 2), rtol=1e-10)
    assert {motion.name for motion in found.motions} == {"sideways"}


@pytest.mark.parametrize("EA", [1e9, 1e12, 1e15, math.inf])
def test_a_sagging_rope_of_any_stiffness(EA: float) -> None:
    # Twenty rigid links, 10 m on 8 m, are the limit: what stretch shifts is of the order of
    # mu g L / EA < 1e-7. All that swing are compared: 2 (n - 1) - 2 in plane or out of it, and slow.
    def sagging(EA: float, sag: float = 8.0) -> rw.Scene:
        stuff = rw.Material(EA=EA, mass_per_length=0.2)
        rope = Rope(segments=20, length=10.0, made_of=stuff, shape=Slack(end=(sag, 0, 0)))
        held = (rw.Anchor(node=0), rw.Anchor(node=-1))
        return rw.Scene(ropes=(rope,), anchors=held, run=rw.RunSettings(method="bdf2"))

    found, rigid = rw.modes(sagging(EA), count=30), rw.modes(sagging(math.inf), count=30)
    np.testing.assert_allclose(found.frequencies, rigid.frequencies, rtol=1e-6)
    assert rigid.frequencies[0] > 0.3
    assert rw.modes(sagging(EA, 8.1)).frequencies[0] > 1.001 * rigid.frequencies[0]
    if math.isinf(EA):
        # As drawn, on chords of the continuous curve, the links' tensions are nearly those at rest.
        drawn = rw.modes(sagging(EA), about="start", count=10).frequencies
        np.testing.assert_allclose(drawn, rigid.frequencies[:10], rtol=2e-3)
        assert (drawn > 0.0).all()


def test_hanging_rope_converges_to_the_bessel_zeros() -> None:
    # Closed forms 3.3 and 3.4; half a mass at the free end: second order. EA 1e9: shifts of 1e-9.
    errors, loaded = [], []
    for n in (50, 100):
        stuff = rw.Material(EA=1e9, mass_per_length=0.1)
        rope = Rope(segments=n, length=1.0, made_of=stuff)
        hung = rw.Scene(gravity=(0, -G, 0), ropes=(rope,), anchors=(rw.Anchor(node=0),))
        found = rates(rw.modes(hung, count=6))[::2]
        errors.append(np.abs(found / theory.hanging_frequencies(1.0, G, 3) - 1.0))
        heavy = hung.replace(ropes=(rope.replace(loads=(Load(node=-1, mass=0.2),)),))
        found = rates(rw.modes(heavy, count=4))[::2]
        loaded.append(np.abs(found / theory.hanging_frequencies(1.0, G, 2, end_mass=2.0) - 1.0))
    np.testing.assert_allclose(errors[0] / errors[1], 4.0, rtol=0.05)
    np.testing.assert_allclose(loaded[0] / loaded[1], 4.0, rtol=0.05)
    assert errors[1][0] < 1e-4


def test_sagging_cable_of_irvine_and_caughey() -> None:
    # Shallow cable, sag/span 1/40, lambda^2 about 8: first symmetric mode, in plane, well above the
    # string's; error of the theory of the order of 8 (sag/span)^2 = 0.5 %.
    w, X, EA, mu, L0 = 0.2 * G, 20.0, 4e4, 0.2, 19.9357
    cable = rw.elastic_catenary(L0, X, 0.0, w, EA)
    parameter = theory.cable_parameter(L0, X, cable.horizontal, w, EA)
    expected = theory.cable_frequencies(X, cable.horizontal, mu, parameter, 2)
    stuff = rw.Material(EA=EA, mass_per_length=mu)
    rope = Rope(segments=100, length=L0, made_of=stuff, shape=Straight(end=(X, 0, 0)))
    held = (rw.Anchor(node=0), rw.Anchor(node=-1))
    found = rw.modes(rw.Scene(ropes=(rope,), anchors=held), count=6)
    byname: dict[str, list[float]] = {"in plane": [], "out of plane": []}
    for rate, motion in zip(rates(found), found.motions, strict=True):
        byname[motion.name].append(rate)
    symmetric, antisymmetric = expected["symmetric"][0], expected["antisymmetric"][0]
    in_plane = sorted([symmetric, antisymmetric])
    np.testing.assert_allclose(byname["in plane"][:2], in_plane, rtol=5e-3)
    np.testing.assert_allclose(byname["out of plane"][:2], expected["across"], rtol=5e-3)
    assert symmetric > 1.2 * expected["across"][0]  # a string's would be equal


def test_large_and_small_models_agree() -> None:
    # Above 900 unknowns a subspace is iterated; the chain is exact.
    found = rw.modes(scene(401, gravity=(0, 0, 0), end=(21.0, 0, 0), m=0.001), count=20)
    n = np.repeat(np.arange(1, 11), 2)
    pull, stretched = 1000.0 * (21.0 / 401 - 0.05), 21.0 / 401
    exact = 2.0 * math.sqrt(pull / (0.001 * stretched)) * np.sin(n * np.pi / 802)
    sideways = [i for i, motion in enumerate(found.motions) if motion.name != "along"]
    np.testing.assert_allclose(rates(found)[sideways], exact[: len(sideways)], rtol=1e-9)
    assert len(sideways) == 18
    along = np.delete(rates(found), sideways)
    np.testing.assert_allclose(along, theory.chain_frequencies(400, 1000.0, 0.001)[:2], rtol=1e-9)


# -- with friction ----------------------------------------------------------------------


@pytest.mark.parametrize("c", [0.5, 5.0, 20.0])
def test_vector_friction_damps_every_mode_of_a_chain(c: float) -> None:
    # Seed systems 3.4: rate c mu_j/2m, frequency sqrt(k mu/m - rate^2), exact; overdamped ones creep
    # at rate -+ sqrt(rate^2 - k mu/m).
    found = rw.modes(scene(21, gravity=(0, 0, 0), c=c), about="start", count=120)
    mu = theory.chain_factors(20)
    roots = [np.roots([0.01, c * factor, 1000.0 * factor]) for factor in mu]
    for pair in roots:
        for root in pair[pair.imag >= 0.0]:
            gap = np.abs(found.eigenvalues - root).min()
            assert gap < 1e-8 * abs(root), root
    assert found.eigenvalues.real.max() < 1e-3  # nothing grows; a double zero is rounded


def test_decay_of_the_report() -> None:
    # Seed systems: between two pins 20 m apart, N 20, c 0.05: out of plane exactly 2 m/(c mu_j):
    # 81, 20 and 9 s, for the tension along the nearly straight rope is nearly even.
    found = rw.modes(scene(20, end=(20.0, 0, 0), k=1e4, m=0.05, length=1.0, c=0.05), count=12)
    out = [i for i, motion in enumerate(found.motions) if motion.name == "out of plane"][:3]
    exact = theory.chain_decay_times(19, 0.05, 0.05)[:3]
    np.testing.assert_allclose(1.0 / found.decay_rates[out], exact, rtol=2e-3)


def test_axial_friction_leaves_sideways_motion_of_a_straight_rope_alone() -> None:
    # Closed forms 3.6: zeta_j = c w_j/2k along, none sideways.
    found = rw.modes(
        scene(10, gravity=(0, 0, 0), end=(0.6, 0, 0), c=0.5, friction="axial"), count=60
    )
    for value, motion in zip(found.eigenvalues, found.motions, strict=True):
        if motion.name == "along":
            assert -value.real / abs(value) == pytest.approx(0.5 * abs(value) / 2000.0, rel=1e-8)
        else:
            assert value.real == 0.0


def test_linear_air_drag_damps_all_alike() -> None:
    # Closed forms 3.7: every mode decays at b/2m, at sqrt(w^2 - (b/2m)^2).
    still = rw.modes(scene(10, end=(0.4, 0, 0)), count=8)
    found = rw.modes(scene(10, end=(0.4, 0, 0), air=Air(node_drag=0.01)), count=8)
    np.testing.assert_allclose(found.decay_rates, 0.5, rtol=1e-9)
    np.testing.assert_allclose(rates(found), np.sqrt(rates(still) ** 2 - 0.25), rtol=1e-9)


def test_large_damped_models() -> None:
    # Above 400 unknowns they come from a Krylov space; the chain is exact.
    found = rw.modes(scene(201, gravity=(0, 0, 0), end=(11.0, 0, 0), c=0.02), count=8)
    mu = theory.chain_factors(200)[:4]
    pull, stretched = 1000.0 * (11.0 / 201 - 0.05), 11.0 / 201
    rate = 0.02 * mu / (2 * 0.01)
    exact = np.sqrt(pull / stretched * mu / 0.01 - rate**2)
    sideways = [i for i, motion in enumerate(found.motions) if motion.name != "along"]
    assert len(sideways) >= 6
    exact, rate = (np.repeat(values, 2)[: len(sideways)] for values in (exact, rate))
    np.testing.assert_allclose(rates(found)[sideways], exact, rtol=1e-8)
    np.testing.assert_allclose(found.decay_rates[sideways], rate, rtol=1e-7)


@pytest.mark.slow
def test_strong_friction_makes_short_waves_creep_alike() -> None:
    # Sideways every wave of a taut chain has two roots of m l^2 + c mu l + T mu/r. The slow ones are
    # all near -T/(c r), the shortest wave's the nearest, each twice: they crowd within 1e-10.
    n, c, m, k = 301, 2000.0, 0.01, 1000.0
    found = rw.modes(scene(n, gravity=(0, 0, 0), end=(18.06, 0, 0), c=c, m=m, k=k), count=20)
    stretched = 18.06 / n
    mu = np.sort(theory.chain_factors(n - 1))[::-1][:10]
    push = k * (stretched - 0.05) / stretched
    slow = 2.0 * push * mu / (c * mu + np.sqrt((c * mu) ** 2 - 4.0 * m * push * mu))
    np.testing.assert_allclose(found.decay_rates, np.repeat(slow, 2), rtol=1e-12)
    assert (found.frequencies == 0.0).all()


@pytest.mark.parametrize(
    ("friction", "c", "drag"),
    [
        ("axial", 0.05, 0.0),
        ("axial", 5.0, 0.0),
        ("vector", 0.02, 0.0),
        ("vector", 2.0, 0.0),
        ("axial", 0.0, 1e-3),
        ("axial", 0.05, 0.05),
    ],
)
def test_large_damped_models_agree_with_dense_ones(
    friction: str, c: float, drag: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    # 297 unknowns both ways: sagging, damped ratios from 1e-6 to far above 1, all modes.
    sagging = scene(
        100, c=c, friction=friction, shape=Slack(end=(4.0, 0, 0)), air=Air(node_drag=drag)
    )
    dense = rw.modes(sagging, count=20)
    monkeypatch.setattr("ropewalk.vibration.solve._DENSE_DAMPED", 0)
    found = rw.modes(sagging, count=20)
    np.testing.assert_allclose(found.eigenvalues, dense.eigenvalues, rtol=1e-9)
    same = [a.name == b.name for a, b in zip(found.motions, dense.motions, strict=True)]
    assert all(same)


def test_equal_ropes_have_all_their_modes() -> None:
    # Six taut ropes of 30 segments beside each other: every frequency twelve times, more often than
    # the vectors that a Krylov space begins with.
    stuff = rw.Springs(
        spring_constant=1000.0, node_mass=0.01, segment_length=0.05, spring_friction=0.01
    )
    ropes = tuple(
        Rope(
            name=f"r{i}",
            segments=30,
            made_of=stuff,
            shape=Straight(start=(0, 0, i), end=(1.8, 0, i)),
        )
        for i in range(6)
    )
    anchors = tuple(rw.Anchor(rope=rope.name, node=node) for rope in ropes for node in (0, -1))
    found = rw.modes(rw.Scene(gravity=(0, 0, 0), ropes=ropes, anchors=anchors), count=24)
    mu = theory.chain_factors(29)[:2]
    push = 1000.0 * (0.06 - 0.05) / 0.06
    rate = 0.01 * mu / (2 * 0.01)
    exact = -rate + 1j * np.sqrt(push * mu / 0.01 - rate**2)
    np.testing.assert_allclose(found.eigenvalues, np.repeat(exact, 12), rtol=1e-9)


def test_finely_cut_rods_with_friction_have_modes() -> None:
    # Pinned rod under tension, w_n^2 = (n pi/L)^2 (T + EI (n pi/L)^2)/mu: second order in the segment.
    stuff = rw.Material(EA=1e5, mass_per_length=0.1, EI=1.0, axial_damping=10.0)
    rope = Rope(segments=400, length=10.0, made_of=stuff, shape=Straight(end=(10.2, 0, 0)))
    held = (rw.Anchor(node=0), rw.Anchor(node=-1))
    found = rw.modes(rw.Scene(gravity=(0, 0, 0), ropes=(rope,), anchors=held), count=8)
    n = np.repeat(np.arange(1, 5), 2)
    wave, mass = n * np.pi / 10.2, 0.1 * 10.0 / 10.2
    exact = wave * np.sqrt((2000.0 + 1.0 * wave**2) / mass)
    np.testing.assert_allclose(rates(found), exact, rtol=1e-3)
    assert (found.decay_rates >= 0.0).all()


def test_unstable_shapes_grow() -> None:
    # A pendulum of one rigid-like link stood on its end: grows at sqrt(g/l), nearly.
    up = scene(
        1, (0,), k=1e7, length=1.0, shape=Points(points=[(0, 0, 0), (0, 1.0 - 0.01 * G / 1e7, 0)])
    )
    found = rw.modes(up, about="start", count=3)
    assert found.frequencies[0] == 0.0
    assert found.decay_rates[0] == pytest.approx(-math.sqrt(G), rel=1e-4)


# -- against runs -----------------------------------------------------------------------------


@pytest.mark.parametrize("mode", [1, 2, 3])
def test_a_run_that_rings_has_the_frequency(mode: int) -> None:
    # Ring at 1e-4 of the wave speed. Semi-implicit Euler turns w into (2/dt) asin(w dt/2) (closed
    # forms 1.4). Measured by the mode's own coordinate, whose zero crossings are interpolated; the
    # amplitude's own shift is second order in 1e-4 of the sag.
    base = scene(12, end=(0.5, 0.1, 0), c=0.0)
    found = rw.modes(base, count=mode)
    w = rates(found)[-1]
    shape, state = found.shapes[-1].real, build(base).state
    dt, periods = 2e-4, 12
    run = rw.RunSettings(
        start="at-rest",
        method="semi-implicit-euler",
        ring=rw.Ring(mode=mode, speed=1e-5),
        time_step=dt,
        steps="exact",
        frame_rate=1.0 / (10 * dt),
        duration=periods * 2 * math.pi / w,
    )
    result = rw.simulate(base.replace(run=run))
    rest = rw.equilibrium(base).positions[0]
    part = ((result.positions - rest) * shape * state.mass[:, None]).sum(axis=(1, 2))
    up = np.flatnonzero((part[:-1] < 0.0) & (part[1:] >= 0.0))
    exact_times = result.time[up] + 10 * dt * part[up] / (part[up] - part[up + 1])
    measured = 2.0 * math.pi * (len(up) - 1) / (exact_times[-1] - exact_times[0])
    shifted = 2.0 / dt * math.asin(0.5 * w * dt)
    assert measured == pytest.approx(shifted, rel=2e-5)
    # The other modes stay silent: the motion is the mode's.
    speed = np.linalg.norm(result.velocities, axis=2).max()
    assert speed == pytest.approx(1e-5, rel=0.1)


def test_a_run_at_rest_stays_there() -> None:
    base = scene(20, end=(0.8, 0, 0), c=0.01)
    still = rw.simulate(base.replace(run=rw.RunSettings(start="at-rest", duration=0.5)))
    assert np.abs(still.velocities).max() < 1e-9
    np.testing.assert_allclose(still.positions[-1], rw.equilibrium(base).positions[0], atol=1e-9)
    drawn = rw.simulate(base.replace(run=rw.RunSettings(duration=0.5)))
    assert np.abs(drawn.velocities).max() > 0.1
