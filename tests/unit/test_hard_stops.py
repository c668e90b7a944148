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
        EA=EA,
        mass_per_length=0.1,
        axial_damping=20.0 if math.isfinite(EA) else 0.0,
        tension_only=True,
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
            limiter=Limiter(max_stretch=1.05) if math.isfinite(EA) else None,
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


def beside(EA: float, **more: object) -> rw.Result:
    """5 kg that fall half a metre into 2 m of rope, beside a rope that hangs 1 m off."""
    falling = Rope(
        name="falling",
        segments=8,
        length=2.0,
        made_of=Material(EA=3e5, mass_per_length=0.05, axial_damping=50.0, tension_only=True),
        shape={"kind": "straight", "start": (0, 0, 0), "end": (0, 0, -1.5)},
        loads=[{"node": -1, "mass": 5.0}],
    )
    hanging = Rope(
        name="hanging",
        segments=4,
        length=1.0,
        made_of=Material(EA=EA, mass_per_length=0.05, tension_only=True),
        shape={"kind": "straight", "start": (1, 0, 0), "end": (1, 0, -1.0)},
    )
    anchors = [Anchor(rope="falling", node=0), Anchor(rope="hanging", node=0, **more)]
    run = RunSettings(method="esdirk3", time_step=1 / 960, duration=0.5)
    limiter = Limiter(max_stretch=2.0) if math.isfinite(EA) else None
    ropes = [falling, hanging]
    return rw.simulate(Scene(ropes=ropes, anchors=anchors, limiter=limiter, run=run))


@pytest.mark.parametrize("EA", [3e5, math.inf])
def test_a_jerk_of_a_rope_that_gives_is_none(EA: float) -> None:
    """Beside a limiter that nothing has reached, and beside a rope of rigid links that hangs."""
    table = beside(EA).table
    assert table[TENSION] > 20.0 * 5.0 * 9.81
    assert ABOUT not in table


def test_a_string_that_is_let_go_of_had_no_hard_stop() -> None:
    """Its largest tension is its weight; there is no frame two before the first."""
    hung = caught("esdirk3", start=3.0, EA=math.inf).scene
    gone = hung.model_copy(update={"anchors": (hung.anchors[0].replace(release_time=0.02),)})
    assert ABOUT not in rw.simulate(gone).table
