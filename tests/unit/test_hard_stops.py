"""Tables say where the largest forces are what a bound or a rigid link takes to stop a load in a step."""

from __future__ import annotations

import math

import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Limiter, Material, Rope, RunSettings, Scene, Winch

ABOUT, MEAN = "about hard stops", "about the largest anchor force"
TENSION, FORCE = "largest tension [N]", "largest anchor force [N]"


def caught(
    method: str,
    *,
    winch: bool = False,
    step: float | str = 1 / 240,
    start: float = 3.0,
    EA: float = 2e3,
) -> rw.Result:
    """20 kg on 3 m of rope, from `start` [m] below the anchor; it runs into its length at some 1.4 m/s."""
    made_of = Material(
        EA=EA, mass_per_length=0.1, axial_damping=20.0 if math.inf > EA else 0.0, tension_only=True
    )
    rope = Rope(
        segments=10,
        length=3.0,
        made_of=made_of,
        shape={"kind": "straight", "start": (0, 0, 0), "end": (0, 0, -start)},
        loads=[{"node": -1, "mass": 20.0}],
    )
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0)],
            winches=[Winch(end="start", speed=-0.4, start=0.8, on_drum=1.0)] if winch else [],
            limiter=Limiter(max_stretch=1.05) if math.inf > EA else None,
            run=RunSettings(method=method, time_step=step, duration=0.7),
        )
    )


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3", "bdf2", "semi-implicit-euler"])
def test_a_bound_that_stops_a_load_is_told(method: str) -> None:
    """Also beside a winch that stands still: there the tension of the step was that after it, 199 N."""
    step = 1e-4 if method == "semi-implicit-euler" else 1 / 240
    plain, wound = (caught(method, winch=one, step=step).table for one in (False, True))
    assert plain[TENSION] > 15.0 * 199.0
    assert wound[TENSION] == pytest.approx(plain[TENSION], rel=1e-6)
    for table in (plain, wound):
        assert table[TENSION] == pytest.approx(table[FORCE], rel=1e-3)
        assert table[ABOUT].startswith("a bound of the limiter gives nothing")
    shorter = caught(method, winch=True, step=0.25 * step).table  # as it says
    assert shorter[TENSION] > 2.0 * wound[TENSION]
    assert ABOUT not in caught(method, winch=True, step=step, start=3.15).table  # it hangs there


def test_an_adaptive_step_that_stops_a_load_gives_the_anchor_alone_what_it_takes() -> None:
    table = caught("adaptive", step="auto").table
    assert table[FORCE] > 10.0 * table[TENSION]
    assert ABOUT in table


@pytest.mark.parametrize("method", ["implicit-euler", "esdirk3", "bdf2"])
def test_rigid_links_that_stop_a_load_are_told(method: str) -> None:
    """With `bdf2` the tension is half as much again as what the anchor takes, and no mean of it."""
    tables = [
        caught(method, start=2.9, EA=math.inf, step=step).table for step in (1 / 240, 1 / 960)
    ]
    assert tables[1][FORCE] > 2.0 * tables[0][FORCE]
    for table in tables:
        assert table[ABOUT].startswith("a rigid link gives nothing")
        assert MEAN not in table
    assert ABOUT not in caught(method, start=3.0, EA=math.inf).table  # it hangs there
