"""The report's claims: verdicts, and the measured numbers against closed forms written out here.

Every claim has a twin: the same function with other physics must lose its verdict. Values marked
"reference" were found by an independent program.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import pytest

from ropewalk.report import Outcome, Verdict, claim, runs
from ropewalk.report import claims_friction as friction
from ropewalk.report import claims_model as model
from ropewalk.report import claims_rates as rates
from ropewalk.report import claims_shape as shape
from ropewalk.report import claims_steps as steps
from ropewalk.report.runs import changed, record

K, M, C, G, DT = 10000.0, 0.05, 0.05, 9.81, 0.002


@cache
def outcome(name: str) -> Outcome:
    return claim(name).run()


def measured(name: str, label: str) -> float:
    found = [n.measured for n in outcome(name).numbers if n.label == label]
    assert found, [n.label for n in outcome(name).numbers]
    return found[0]


SLOW = {"C5", "C8", "C10", "C17"}
VERDICTS = {f"C{i}": Verdict.CONFIRMED for i in range(1, 19)} | {
    "C6": Verdict.IN_PART,
    "C15": Verdict.IN_PART,
}


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.slow) if name in SLOW else name for name in VERDICTS],
)
def test_verdict(name: str) -> None:
    found = outcome(name)
    assert found.sound, [n for n in found.numbers if not n.agrees]
    assert found.verdict is VERDICTS[name]


def test_c1_one_spring() -> None:
    # cos(w dt) = 1 - k dt^2 / (2 m) = 0.6 without friction, which moves it by b/4 = 0.05 %.
    undamped = math.acos(1.0 - K * DT**2 / (2.0 * M)) / DT
    assert undamped == pytest.approx(463.65, abs=0.005)
    assert measured("C1", "frequency of the run") == pytest.approx(undamped, rel=1e-3)
    assert measured("C1", "swing left after a step") == pytest.approx(
        math.sqrt(1.0 - C * DT / M), rel=1e-7
    )
    assert measured("C1", "stretch at rest") == pytest.approx(1e6 * M * G / K, rel=1e-4)


def test_c2_hanging() -> None:
    # m g n (n + 1) / (2 k), n = 20; settled to exp(-25 s / 0.85 s).
    assert measured("C2", "longer by, 10 kN/m") == pytest.approx(10.3005, rel=1e-6)
    assert measured("C2", "longer by, 100 N/m") == pytest.approx(1.03005, rel=1e-6)


def test_c3_first_step_is_exact() -> None:
    assert measured("C3", "least acceleration") == pytest.approx(-G, rel=1e-14)
    assert measured("C3", "sideways") == 0.0


@pytest.mark.slow
def test_c5_decay_times() -> None:
    # 2 m / (c mu_j), mu_j = 4 sin^2(j pi / 40); 2 %: the pull along the rope is not even.
    for j in (1, 2, 3):
        expected = 2.0 * M / (C * 4.0 * math.sin(j * math.pi / 40.0) ** 2)
        assert measured("C5", f"decay time of wave {j}") == pytest.approx(expected, rel=0.02)


def test_c6_free_pair() -> None:
    # (1 - 2 c dt / m)^(1 s / dt) for dt = 1/540 s, to the order of the turning in a step.
    expected = (1.0 - 2.0 * C / (540.0 * M)) ** 540
    assert measured("C6", "turning left") == pytest.approx(expected, rel=1e-3)


@pytest.mark.slow
def test_c8_largest_steps() -> None:
    # Long chain: (-2 c + sqrt(4 c^2 + 4 k m)) / (2 k) = 2.231 ms; 19 free masses allow 0.3 % more.
    long = 1e3 * (-2.0 * C + math.sqrt(4.0 * C**2 + 4.0 * K * M)) / (2.0 * K)
    assert long == pytest.approx(2.231, abs=5e-4)
    assert measured("C8", "largest step, semi-implicit Euler") == pytest.approx(long, rel=4e-3)
    ends = 4.0 * math.sin(19.0 * math.pi / 40.0) ** 2  # mu of 19 free masses
    exact = 1e3 * (-C * ends + math.sqrt((C * ends) ** 2 + 4.0 * K * M * ends)) / (K * ends)
    assert outcome("C8").theory.startswith(
        f"The bounds are {exact:.4f} ms, from k μ dt² / m + 2 c μ dt / m < 4 of 19 free masses"
    )
    assert measured("C8", "largest step, Euler") == pytest.approx(1e3 * C / K, rel=2e-3)


@pytest.mark.slow
def test_c10_stretches() -> None:
    for k, reference in ((10000, 1.008), (200, 1.131), (100, 1.223), (50, 1.376)):
        strain = measured("C10", f"largest strain at {k} N/m")
        assert 1.0 + strain / 100.0 == pytest.approx(reference, abs=1.5e-3)


def test_c11_sag() -> None:
    assert measured("C11", "sag") == pytest.approx(0.7181, abs=5e-5)  # reference
    assert measured("C11", "horizontal pull") == pytest.approx(34.094, abs=5e-4)  # reference


def test_c12_exponent() -> None:
    # The shallow law's -1/3; the strain of deeper loops moves it by about the strain, 1 %.
    assert measured("C12", "exponent of the sag") == pytest.approx(-1.0 / 3.0, abs=0.01)
    assert measured("C12", "sag at 100 N/m") == pytest.approx(3.4350, abs=5e-5)  # reference


def test_c13_wave_speed() -> None:
    # 10 springs of 1 m at sqrt(H / (m / L)) with H = 34.09 N, 26.1 m/s; the pulse spreads by 5 %.
    assert measured("C13", "time from node to node") == pytest.approx(383.0, rel=0.05)


def test_c14_steps() -> None:
    assert measured("C14", "steps that it stands") == 4


def test_c15_shortest_rope_that_breaks() -> None:
    # k_max = 4 m f^2 / mu_max - 2 c f with mu_max = 4 sin^2((N - 1) pi / (2 N)): 192.7 at N = 5.
    def limit(springs: int) -> float:
        top = 4.0 * math.sin((springs - 1) * math.pi / (2.0 * springs)) ** 2
        return 4.0 * M * 3600.0 / top - 2.0 * C * 60.0

    assert limit(5) < 200.0 < limit(4)
    assert measured("C15", "fewest springs a section that break") == 5


def test_c16_stretch() -> None:
    assert measured("C16", "largest strain") == pytest.approx(22.3, abs=0.2)  # reference


@pytest.mark.slow
@pytest.mark.parametrize("rate", rates.RATES)
def test_c17_largest_spring(rate: float) -> None:
    long = M * rate**2 - 2.0 * C * rate
    top = 4.0 * math.sin(19 * math.pi / 40.0) ** 2
    chain = 4.0 * M * rate**2 / top - 2.0 * C * rate
    found = measured("C17", f"largest k at {rate:g} Hz")
    assert found == pytest.approx(chain, rel=1e-3)
    assert long < found < 1.01 * long


def test_c18_same_bits() -> None:
    assert measured("C18", "largest difference") == 0.0


# -- twins: with other physics the verdict is lost ------------------------------------------------

TWINS: dict[str, Callable[[], Outcome]] = {
    "C1 without friction": lambda: model.one_spring(
        changed("r1", "rope.made_of.spring_friction=0")
    ),
    "C1 with another spring": lambda: model.one_spring(
        changed("r1", "rope.made_of.spring_constant=9990")
    ),
    "C2 not settled": lambda: model.two_springs(friction=C),
    "C3 with another gravity": lambda: model.only_gravity(
        changed("r4", "gravity=[0.0, -9.8, 0.0]")
    ),
    "C3 with wind": lambda: model.only_gravity(
        changed("r4", "air.node_drag=0.01", "air.wind=[1.0, 0.0, 0.0]")
    ),
    "C4 with friction": lambda: friction.never_rests(changed("r3", "duration=120")),
    "C7 with the order turned": lambda: friction.smaller_friction((0.2, 0.05)),
    "C10 without stiff springs": lambda: shape.bounce((100.0, 90.0)),
    "C11 with a soft spring": lambda: shape.shallow_loop(9000.0),
    "C13 without a move": lambda: shape.waves(
        changed("r4", "anchor.left.motion.kind=fixed", "rope.shape.kind=slack",
                "rope.shape.end=[39.9, 0.0, 0.0]", "duration=120")
    ),
    "C14 with small steps": lambda: steps.breaks_at_once(changed("r6", "time_step=0.002")),
    "C14 with soft springs": lambda: steps.breaks_at_once(
        changed("r6", "rope.made_of.spring_constant=100")
    ),
    "C15 below the limit": lambda: rates.breaks_after_swings(150.0),
    "C16 above the limit": lambda: rates.stable_but_bouncy(
        changed("r8", "rope.made_of.spring_constant=185")
    ),
}  # fmt: skip


def loses(name: str, twin: Outcome) -> bool:
    """Whether an outcome is worse than the claim's own: theory missed, or a lower verdict."""
    order = [Verdict.REFUTED, Verdict.IN_PART, Verdict.CONFIRMED]
    return not twin.sound or order.index(twin.verdict) < order.index(VERDICTS[name])


# Other physics for every run of a claim: the module's `record`, with a scene changed behind its back.
BROKEN = {
    "C5": (friction, ("rope.made_of.friction=axial",)),
    "C6": (friction, ("air.node_drag=0.05",)),
    "C7": (friction, ("rope.made_of.spring_friction=0.05",)),
    "C8": (runs, ("rope.made_of.spring_friction=0.1",)),
    "C9": (rates, ()),
    "C12": (shape, ("rope.made_of.spring_constant=10000",)),
    "C13": (shape, ("rope.made_of.spring_constant=20000", "time_step=0.001")),
    "C17": (runs, ("rope.made_of.spring_friction=0.1",)),
    "C18": (rates, ("steps=divide",)),
}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n in SLOW else n for n in BROKEN]
)
def test_other_physics_loses_the_verdict(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module, changes = BROKEN[name]
    monkeypatch.setattr(
        module, "record", lambda scene, **options: record(changed(scene, *changes), **options)
    )
    if name == "C9":
        monkeypatch.setattr(
            steps, "changed", lambda scene, *more: changed(scene, "time_step=0.003", *more)
        )
    assert loses(name, claim(name).run())


@pytest.mark.parametrize("name", TWINS)
def test_a_twin_loses_the_verdict(name: str) -> None:
    assert loses(name.split()[0], TWINS[name]())
