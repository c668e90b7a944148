"""Every number that the lessons for a class promise: the simulator's, the closed form's, and the page's."""

from __future__ import annotations

import functools
import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq
from scipy.special import ellipk, jn_zeros

import ropewalk as rw
from ropewalk.lessons import NAMES, lesson_scene, lesson_text
from ropewalk.live.lab import METHODS, lab_scene

G = 9.81
TEACH = Path(__file__).parents[2] / "docs" / "teach"


@functools.cache
def run_of(name: str, duration: float, **changes: float) -> rw.Result:
    scene = lesson_scene(name)
    run = scene.run.replace(duration=duration)
    return rw.simulate(scene.replace(run=run, **changes))


def promised(page: str, *words: str) -> None:
    """The lesson's page has these words."""
    text = (TEACH / f"{page}.md").read_text("utf-8")
    for word in words:
        assert word in text, word


def crest(result: rw.Result, node: int, axis: int, until: float) -> float:
    """When a node's place has its first crest [s], by a parabola through the highest frames."""
    z = result.positions[result.time <= until, node, axis]
    i = int(np.argmax(z))
    a, b, c = z[i - 1 : i + 2]
    return float(result.time[i] + (result.time[1]) * 0.5 * (a - c) / (a - 2 * b + c))


def period(result: rw.Result) -> float:
    x: NDArray[np.float64] = result.positions[:, -1, 0]
    t = result.time
    up = np.flatnonzero((x[:-1] < 0.0) & (x[1:] >= 0.0))
    times = t[up] - x[up] * (t[up + 1] - t[up]) / (x[up + 1] - x[up])
    return float(np.diff(times).mean())


@pytest.mark.parametrize("name", NAMES)
def test_a_lesson_runs_in_the_lab_at_a_step_that_holds(name: str) -> None:
    made = lab_scene(lesson_scene(name))
    assert made["method"] == lesson_scene(name).run.method in METHODS
    largest = rw.check(lesson_scene(name), measure=False).stability.largest_step[made["method"]]
    assert made["step"] < 0.7 * largest
    assert lesson_text(name).startswith("# Lesson ")


@pytest.mark.parametrize(
    ("h", "words"),
    [(0.01, ("1025", "2050")), (0.005, ("4100", "8201")), (0.0025, ("16 401", "32 803"))],
)
def test_half_the_step_is_four_times_the_stiffness(h: float, words: tuple[str, str]) -> None:
    promised("steps", *(f"| {word} N/m" for word in words))
    scene = lesson_scene("step-by-step")
    for method, longer, word in zip(("verlet", "rk4"), (1.0, math.sqrt(2.0)), words, strict=True):
        k = 0.1 * (longer / (h * math.cos(math.pi / 20))) ** 2
        assert round(k) == int(word.replace(" ", ""))
        stiff = scene.replace(**{"rope.made_of.spring_constant": k})
        bound = rw.check(stiff, measure=False).stability.largest_step
        assert bound[method] == pytest.approx(h, rel=1e-3)
        assert bound["semi-implicit-euler"] == pytest.approx(h / longer, rel=1e-3)


def test_it_breaks_just_above_and_not_just_below() -> None:
    scene = lesson_scene("step-by-step")
    run = scene.run.replace(duration=5.0)
    for k, breaks in ((0.97 * 4100.0, False), (1.03 * 4100.0, True)):
        stiff = scene.replace(run=run, **{"rope.made_of.spring_constant": k})
        if breaks:
            with pytest.raises(rw.Broken):
                rw.simulate(stiff)
        else:
            assert rw.simulate(stiff).time[-1] == 5.0


def test_runge_kutta_breaks_a_tenth_above_its_limit() -> None:
    """Energy comes out of nothing; a test of the lab compares the steps at which both stop."""
    promised("steps", "a tenth above it, the rope thrashes", "the lab stops it for that")
    scene = lesson_scene("step-by-step")
    run = scene.run.replace(duration=10.0, method="rk4")
    stiff = [
        scene.replace(run=run, **{"rope.made_of.spring_constant": f * 8201.0}) for f in (0.97, 1.1)
    ]
    assert rw.simulate(stiff[0]).time[-1] == 10.0
    with pytest.raises(rw.Broken, match="energy grows"):
        rw.simulate(stiff[1])


@pytest.mark.parametrize(
    ("name", "degrees", "words"),
    [
        ("pendulum", 10.0, ("2.010 s", "0.546 m/s", "10.1 N", "0.149 J")),
        ("far-swing", 60.0, ("2.153 s", "3.13 m/s", "19.6 N", "4.91 J")),
    ],
)
def test_the_pendulum(name: str, degrees: float, words: tuple[str, ...]) -> None:
    promised("pendulum", *words)
    told = [float(word.split()[0]) for word in words]
    a = math.radians(degrees)
    exact = [
        4.0 * math.sqrt(1.0 / G) * ellipk(math.sin(a / 2.0) ** 2),
        math.sqrt(2.0 * G * (1.0 - math.cos(a))),
        G * (3.0 - 2.0 * math.cos(a)),
        G * (1.0 - math.cos(a)),
    ]
    result = run_of(name, 10.5)
    speed = np.linalg.norm(result.velocities[:, -1], axis=1).max()
    found = [period(result), speed, result.tension.max(), 0.5 * speed**2]
    assert told == pytest.approx(exact, rel=2e-3)
    assert found == pytest.approx(exact, rel=2e-3)


def test_the_rope_without_a_bob() -> None:
    promised("pendulum", "1.67 s", "0.69 m", "1.64 s")
    exact = 4.0 * math.pi * math.sqrt(1.0 / G) / jn_zeros(0, 1)[0]
    found = period(run_of("swinging-rope", 10.5))
    assert found == pytest.approx(exact, rel=2e-3)  # it is stretched by its weight
    assert round(exact, 2) == 1.67
    assert round(G * (exact / (2.0 * math.pi)) ** 2, 2) == 0.69
    assert round(2.0 * math.pi * math.sqrt(2.0 / 3.0 / G), 2) == 1.64


def test_on_the_moon_all_swing_slower() -> None:
    """By the same factor, the swing of any size and the rope; on Earth they would fail."""
    longer = math.sqrt(G / 1.62)
    told = {"pendulum": 4.95, "far-swing": 5.30, "swinging-rope": 4.11}
    promised("pendulum", "2.46", "4.95, 5.30 and 4.11 s")
    assert round(longer, 2) == 2.46
    for name, seconds in told.items():
        found = period(run_of(name, 25.0, gravity=(0.0, 0.0, -1.62)))
        assert found == pytest.approx(longer * period(run_of(name, 10.5)), rel=2e-3)
        assert found == pytest.approx(seconds, abs=0.006)


def test_a_pulse_on_a_string() -> None:
    promised("waves", "takes 0.20 s: 20 m/s", "0.10 s", "4.04 m", "10.1 cm")
    for factor in (1.0, 4.0):
        result = run_of("pulse", 0.7, **{"rope.made_of.EA": 4000.0 * factor})
        took = crest(result, 80, 2, 0.35) - crest(result, 40, 2, 0.2 / math.sqrt(factor))
        exact = 4.04 / math.sqrt(40.0 * factor / (0.1 / 1.01))
        assert took == pytest.approx(exact, rel=0.02)
        assert round(exact, 2) == {1.0: 0.20, 4.0: 0.10}[factor]
    back = run_of("pulse", 0.7).positions[:, 60, 2]
    assert back.min() < -0.02  # upside down
    assert back.max() == pytest.approx(0.03, rel=0.1)  # half as high as the bump of 6 cm


def test_a_pulse_climbs_ever_faster() -> None:
    promised("waves", r"= 0.74\ \mathrm{s}", "2.5 to 7.5 m")
    result = run_of("climbing-pulse", 1.3)
    took = crest(result, 25, 0, 1.3) - crest(result, 75, 0, 0.5)
    promised("waves", "the lab: 0.75 s")
    assert round(took, 2) == 0.75
    exact = 2.0 * (math.sqrt(7.5 / G) - math.sqrt(2.5 / G))
    assert round(exact, 2) == 0.74
    assert took == pytest.approx(exact, rel=0.03)
    half = (crest(result, 50, 0, 0.9) - crest(result, 75, 0, 0.5)) / took
    assert half > 0.55  # the lower half of the way takes longer


def test_the_chain_is_a_catenary() -> None:
    promised("catenary", "2.66 m below", "1.99 m", "2.05 m", "3.38", "4.9 N", "16.6 N", "29.6 N")
    promised("catenary", "29.1 N at node 0", "5.5 cm deeper")
    a = brentq(lambda a: a * math.sinh(4.0 / a) - 5.0, 1.0, 10.0)
    weight = 0.5 * G
    sag = a * (math.cosh(4.0 / a) - 1.0)
    quarter = a * (math.cosh(4.0 / a) - math.cosh(2.0 / a))
    assert (round(a, 2), round(weight, 1)) == (3.38, 4.9)
    assert (round(weight * a, 1), round(weight * (a + sag), 1)) == (16.6, 29.6)
    assert (round(0.75 * sag, 2), round(quarter, 2)) == (1.99, 2.05)
    assert round(100.0 * (quarter - 0.75 * sag), 1) == 5.5
    result = run_of("chain-at-rest", 10.0)
    last = result.positions[-1]
    assert -last[:, 2].min() == pytest.approx(sag, abs=0.006)
    assert round(-last[:, 2].min(), 2) == 2.66
    assert -np.interp(2.0, last[:, 0], last[:, 2]) == pytest.approx(quarter, abs=0.006)
    tension = result.tension[-1]
    assert tension[0] == pytest.approx(29.1, abs=0.05)
    at_nodes = 0.5 * (tension[3:20] + tension[4:21])
    slope = np.polyfit(last[4:21, 2], at_nodes, 1)[0]
    assert slope == pytest.approx(weight, rel=0.01)


def test_on_the_moon_the_chain_is_the_same() -> None:
    moon = run_of("chain-at-rest", 20.0, gravity=(0.0, 0.0, -1.62)).positions[-1]
    earth = run_of("chain-at-rest", 10.0).positions[-1]
    assert 1e-4 < np.abs(moon - earth).max() < 0.01


@pytest.mark.parametrize(("name", "node", "mode"), [("tone", 25, 1), ("overtone", 12, 2)])
def test_friction_takes_half_in_equal_times(name: str, node: int, mode: int) -> None:
    promised("friction", "10.0, 5.0, 2.5 and 1.25 cm", "0.50 s", "every 2.0 s", "1.0 s")
    rate = 3.5 / 0.02 * (1.0 - math.cos(mode * math.pi / 50))
    assert round(math.log(2.0) / rate, 2) == {1: 2.01, 2: 0.50}[mode]
    z = run_of(name, 6.2).positions[:, node, 2]
    inner = np.flatnonzero((z[1:-1] > z[:-2]) & (z[1:-1] >= z[2:])) + 1
    crests, times = z[inner], run_of(name, 6.2).time[inner]
    fitted = -np.polyfit(times[:4], np.log(crests[:4]), 1)[0]
    assert fitted == pytest.approx(rate, rel=0.02)
    if mode == 1:
        assert [round(100.0 * z, 1) for z in (0.1, *crests[1:4:2])] == [10.0, 5.0, 2.5]
        assert round(100.0 * crests[5], 2) == 1.25


def test_the_guitar_string_has_its_pitch() -> None:
    """By the crests of a node, 202 Hz to half a per cent; a chain of 30 is 0.05 % below the string."""
    promised("friction", "202 Hz")
    result = run_of("guitar-string", 0.1)
    bridge = result.positions[:, 6, 2]  # where it was plucked
    x = bridge - bridge.mean()
    spectrum = np.abs(np.fft.rfft(x * np.hanning(len(x)), 16 * len(x)))
    pull = 94600.0 * (0.65 / 30 - 0.021258)
    exact = math.sqrt(pull / (1.218e-5 / (0.65 / 30))) / (2.0 * 0.65)
    assert round(exact) == 202
    found = spectrum.argmax() / (16 * len(x) * (result.time[1] - result.time[0]))
    assert found == pytest.approx(exact, rel=0.005)


@pytest.mark.parametrize(
    ("name", "half_turns", "words", "from_time"),
    [
        ("post", 1, ("2.57", "76 N"), 3.0),
        ("post-hauled", 1, ("2.57", "504 N"), 5.0),
        ("three-half-turns", 3, ("16.9", "11.6 N"), 5.0),
    ],
)
def test_a_rope_slips_round_a_post(
    name: str, half_turns: int, words: tuple[str, str], from_time: float
) -> None:
    """exp(mu theta) times the load, or as much less; the hand's own tension, less its rope's weight."""
    promised("friction", *words)
    ratio, load = math.exp(0.3 * math.pi * half_turns), 20.0 * G
    assert round(ratio, 2 if half_turns == 1 else 1) == float(words[0])
    pull = load * ratio if name == "post-hauled" else load / ratio
    assert f"{pull:.3g} N" == words[1] or f"{pull:.2g} N" == words[1]
    tension = run_of(name, 8.0)
    late = tension.time > from_time
    hand = tension.tension[late, 0] + 0.1 * G * -tension.positions[late, 0, 2]
    assert hand.mean() == pytest.approx(pull, rel=0.03)
    between = hand / tension.tension[late, -1]
    assert np.maximum(between, 1.0 / between) == pytest.approx(ratio, rel=0.03)
    before = run_of(name, 8.0).time < 1.0
    assert np.ptp(tension.positions[before, -1, 2]) < 0.002  # it sticks first


def test_the_capstan_is_arithmetic() -> None:
    promised(
        "friction", "6.6 times", "43 times", "286 times", "| 1.60 | 122 N |", "| 6.59 | 30 N |"
    )
    turned = {mu: math.exp(mu * math.pi) for mu in (0.15, 0.6)}
    assert [round(one, 2) for one in turned.values()] == [1.60, 6.59]
    assert [round(20.0 * G / one) for one in turned.values()] == [122, 30]
    corner = 0.3 * math.tan(math.pi / 24.0)  # two chords of a polygon, with the arc's friction
    promised("friction", "2.58 times", "2.57")
    assert round(((1.0 + corner) / (1.0 - corner)) ** 12, 2) == 2.58
    assert [round(math.exp(0.3 * 2.0 * math.pi * n), n == 1) for n in (1, 2, 3)] == [6.6, 43, 286]
