"""Strings, rigid links that only pull: what gets one taut is stopped along it, and loses that energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Kick, Load, Material, Points, Rope, RunSettings, Scene

ABLE = tuple(name for name, method in METHODS.items() if method.holds_links)
STEPS = (1 / 240, 1 / 960)
g = 9.81


def film(points: list[tuple[float, float, float]], method: str, **more: object) -> rw.Result:
    """A massless-as-can-be string of links of 1 m from `points` [m], with loads; at rest but for kicks."""
    EA, step = more.pop("EA", math.inf), more.pop("step", 1 / 240)
    made_of = Material(EA=EA, mass_per_length=1e-6, tension_only=True)
    count = len(points) - 1
    rope = Rope(
        segments=count,
        length=float(count),
        made_of=made_of,
        shape=Points(points=points),
        loads=more.pop("loads"),
        kicks=more.pop("kicks", []),
    )
    steps = {"tolerance": 1e-5} if method == "adaptive" else {"time_step": step}
    run = RunSettings(method=method, duration=more.pop("duration", 0.5), frame_rate=240.0, **steps)
    return rw.simulate(Scene(ropes=[rope], run=run, **more))


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("method", ABLE)
def test_a_load_that_falls_into_its_string_stays_there(method: str, step: float) -> None:
    """2 kg, 10 cm: it bounced with `esdirk3`, at 0.86 of its speed in steps of 1 ms. The twin: a spring."""
    start = {"points": [(0.0, 0.0, 0.0), (0.0, -0.9, 0.0)], "loads": [Load(node=1, mass=2.0)]}
    more = {"anchors": [Anchor(node=0)], "gravity": (0.0, -g, 0.0), "method": method, "step": step}
    caught = film(**start, **more)
    down = int(np.argmax(caught.positions[:, 1, 1] < -1.0 + 1e-9))
    assert math.sqrt(0.2 / g) == pytest.approx(caught.time[down], abs=1.5 / 240)
    assert caught.positions[down:, 1, 1].max() < -1.0 + 1e-9
    lost = 2.0 * g * 0.1
    assert caught.work["friction"][-1] == pytest.approx(-lost, rel=0.1)
    assert caught.table["largest energy error [J]"] < 0.1 * lost
    assert caught.tension[-1, 0] == pytest.approx(2.0 * g, rel=1e-5)
    sprung = film(**start, **more, EA=1e4)
    assert sprung.positions[down + 2 :, 1, 1].max() > -0.98


@pytest.mark.parametrize("method", ABLE)
def test_two_loads_go_on_together(method: str) -> None:
    """2 kg at 3 m/s away from 1 kg: both at 2 m/s, and half the reduced mass times 9 is lost."""
    result = film(
        [(0.0, 0.0, 0.0), (0.8, 0.0, 0.0)],
        method,
        loads=[Load(node=0, mass=1.0), Load(node=1, mass=2.0)],
        kicks=[Kick(node=1, velocity=(3.0, 0.0, 0.0))],
        gravity=(0.0, 0.0, 0.0),
        step=1 / 960,
    )
    assert result.velocities[-1, :, 0] == pytest.approx([2.0, 2.0], rel=1e-4)
    assert result.work["friction"][-1] == pytest.approx(-0.5 * (2.0 / 3.0) * 9.0, rel=0.02)
    assert np.linalg.norm(result.momentum[-1] - result.momentum[0]) < 1e-6


@pytest.mark.parametrize("method", ABLE)
def test_what_goes_across_the_string_goes_on(method: str) -> None:
    """A load thrown past its anchor at 4 m/s, 0.6 m off: where it is 1 m away 0.8 of that is along the
    string and lost, and it goes round at 0.6 of it."""
    result = film(
        [(0.0, 0.0, 0.0), (0.0, 0.6, 0.0)],
        method,
        loads=[Load(node=1, mass=2.0)],
        kicks=[Kick(node=1, velocity=(4.0, 0.0, 0.0))],
        anchors=[Anchor(node=0)],
        gravity=(0.0, 0.0, 0.0),
        step=1 / 1920,
    )
    away = np.linalg.norm(result.positions[:, 1], axis=1)
    speed = np.linalg.norm(result.velocities[:, 1], axis=1)
    assert away.max() < 1.0 + 1e-9
    assert away[-1] == pytest.approx(1.0, rel=1e-6)
    assert speed[-1] == pytest.approx(2.4, rel=0.01)
    assert result.work["friction"][-1] == pytest.approx(-0.5 * 2.0 * 3.2**2, rel=0.02)


@pytest.mark.parametrize(("method", "most"), [("esdirk3", 0.1), ("adaptive", 0.05)])
def test_a_chain_of_strings_that_is_thrown_about_accounts_for_its_energy(
    method: str, most: float
) -> None:
    """Twenty of them, dropped from a bow: a fourth of the energy turned over was in no law's work."""
    chain = Rope(
        segments=20,
        length=3.0,
        made_of=Material(EA=math.inf, mass_per_length=0.1, tension_only=True),
        shape={"kind": "slack", "start": (0, 0, 0), "end": (1.0, 0, 0.5)},
    )
    run = RunSettings(duration=3.0, method=method, time_step="auto", frame_rate=60.0)
    if method != "adaptive":
        run = run.replace(time_step=1 / 240)
    result = rw.simulate(
        Scene(ropes=[chain], anchors=[Anchor(node=0)], gravity=(0, 0, -g), run=run)
    )
    share = result.table["largest energy error, share of the energy turned over [%]"]
    assert share < 100.0 * most
    assert result.work["friction"][-1] < -0.1 * np.ptp(result.energy["gravity"])
    lengths = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
    assert lengths.max() < 0.15 * (1.0 + 1e-9)


@pytest.mark.parametrize("method", ["esdirk3", "bdf2", "adaptive"])
def test_strings_that_are_never_slack_move_as_rods(method: str) -> None:
    """20 kg on ten of them, struck sideways: what a step leaves of rates of length is no impact."""

    def struck(tension_only: bool) -> rw.Result:
        rope = Rope(
            segments=10,
            length=1.0,
            made_of=Material(EA=math.inf, mass_per_length=0.05, tension_only=tension_only),
            shape={"kind": "straight", "start": (0, 0, 0), "end": (0, 0, -1.0)},
            loads=[{"node": -1, "mass": 20.0}],
            kicks=[Kick(node=5, velocity=(0.5, 0.0, 0.0))],
        )
        steps = {} if method == "adaptive" else {"time_step": 1 / 960}
        run = RunSettings(duration=0.5, method=method, **steps)
        return rw.simulate(
            Scene(ropes=[rope], anchors=[Anchor(node=0)], gravity=(0, 0, -g), run=run)
        )

    strings, rods = struck(True), struck(False)
    assert strings.tension.min() > 150.0
    assert not strings.work["friction"].any()
    near = 1e-4 if method == "adaptive" else 1e-9
    assert np.abs(strings.positions - rods.positions).max() < near


@pytest.mark.parametrize(("method", "speed"), [("esdirk3", 20.0), ("bdf2", 12.0), ("bdf2", 4.0)])
def test_what_turns_after_an_impact_keeps_its_energy(method: str, speed: float) -> None:
    """Two loads thrown across the line between them: taut, they turn by up to 0.1 rad a step. Every step
    was taken in halves of implicit Euler from then on, and half of the energy went."""
    result = film(
        [(0.0, 0.0, 0.0), (0.8, 0.0, 0.0)],
        method,
        loads=[Load(node=0, mass=1.0), Load(node=1, mass=1.0)],
        kicks=[
            Kick(node=0, velocity=(0.0, -speed, 0.0)),
            Kick(node=1, velocity=(0.0, speed, 0.0)),
        ],
        gravity=(0.0, 0.0, 0.0),
        duration=1.0,
    )
    kinetic = result.energy["kinetic"]
    taut = int(np.argmin(kinetic > 0.9 * kinetic[0])) + 2
    ideal = 0.64 * speed**2  # what is across the string as it gets taut
    assert kinetic[taut] == pytest.approx(ideal, rel=0.15)
    assert kinetic[-1] > 0.98 * kinetic[taut]
    assert np.diff(result.work["friction"]).max() < 1e-9 * kinetic[0]
    assert result.table["largest energy error [J]"] < 0.02 * kinetic[0]


def test_an_inward_kick_of_a_string_of_one_link_stays() -> None:
    """It was taken away, as if a rod were struck along it."""
    straight = [(0.0, 0.0, 0.0), (0.0, -1.0, 0.0)]
    kick = [Kick(node=1, velocity=(0.0, 2.0, 0.0))]
    more = {"loads": [Load(node=1, mass=2.0)], "kicks": kick, "anchors": [Anchor(node=0)]}
    assert film(straight, "esdirk3", **more).velocities[0, 1, 1] == 2.0
