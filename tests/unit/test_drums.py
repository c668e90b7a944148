"""Places of ropes on drums are told as what they are, not by numbers below zero."""

from __future__ import annotations

import math
from typing import Any, Literal

import pytest

import ropewalk as rw
from ropewalk.record.drums import rope_place
from ropewalk.record.extremes import extremes
from ropewalk.scene import Anchor, Load, Material, Rope, RunSettings, Scene, Straight, Winch
from sweeps.test_keep import hung


def hoist(speed: float, end: Literal["start", "end"], *, parts: bool = False) -> rw.Result:
    """A load of 5 kg on 2 m of cord in half metres that hangs from its winch, for 1.1 s."""
    at = 0 if end == "start" else -1
    down = Straight(start=(0, 0, 0), direction=(0, 0, -1 if end == "start" else 1))
    weak: dict[str, Any] = {"parts": True, "breaking_load": 20.0} if parts else {}
    rope = Rope(
        segments=4,
        length=2.0,
        made_of=Material(EA=1e5, mass_per_length=0.1, axial_damping=50.0, **weak),
        shape=down,
        loads=[Load(node=-1 - at, mass=5.0)],
    )
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=at)],
            winches=[Winch(end=end, speed=speed)],
            run=RunSettings(duration=1.1, method="rk4", frame_rate=100.0),
        ),
        on_failure="return",
    )


@pytest.mark.parametrize("end", ["start", "end"])
def test_what_is_paid_out_what_lies_on_the_drum_and_what_leaves_it(
    end: Literal["start", "end"],
) -> None:
    result = hoist(1.0, end)
    span = result.layout.span("rope")
    assert (span.spare_start if end == "start" else span.spare_end) >= 3

    def told(noun: str, out: int, time: float) -> str:
        """Of so many segments or nodes from the rope's own end at the drum, further in."""
        if end == "start":
            return rope_place(result, noun, span.start - out, time)
        return rope_place(result, noun, span.end + out - (noun == "segment"), time)

    number = {"start": (-1, 0), "end": (4, 4)}[end]
    assert told("segment", 1, 1.1) == f"segment {number[0]} of rope 'rope', paid out from the drum"
    assert told("segment", 1, 0.0) == "on the drum of rope 'rope'"
    assert told("segment", 0, 1.1) == f"segment {0 if end == 'start' else 3} of rope 'rope'"
    assert told("node", 0, 1.1) == f"node {number[1]} of rope 'rope'"
    last = 3 if told("node", 2, 1.1).startswith("node") else 2
    assert told("node", last, 1.1) == "at the drum of rope 'rope'"
    assert told("node", last + 1, 1.1) == "on the drum of rope 'rope'"


def test_no_extreme_of_a_winch_has_a_number_below_zero_alone() -> None:
    """The highest point of `hoist-stop` was "node -2"; the largest tension of `rescue-lower` "segment -4"."""
    assert rw.simulate("hoist-stop").table["highest point at"].startswith("on the drum of rope")
    table = rw.simulate("rescue-lower").table
    below = [str(table[key]) for key in table if key.endswith(" at") and " -" in str(table[key])]
    assert below
    assert all("paid out from the drum" in place for place in below)


def test_what_is_reeled_in_lies_on_the_drum() -> None:
    """Nodes that had numbers of the rope; the twin at the beginning."""
    result = hoist(-1.0, "start")
    assert rope_place(result, "node", 0, 0.0) == "node 0 of rope 'rope'"
    assert rope_place(result, "node", 0, 1.1) == "on the drum of rope 'rope'"
    assert rope_place(result, "segment", 3, 1.1) == "segment 3 of rope 'rope'"


@pytest.mark.parametrize("frame_rate", [2.0, 100.0])
def test_what_is_reeled_in_before_the_next_frame_was_no_drum_where_it_pulled(
    frame_rate: float,
) -> None:
    """At 2 frames a second the largest tension was told "on the drum", where nothing pulls."""
    result = hung(frame_rate, -0.8, 10)
    peak = extremes(result)["greatest tension"]
    assert not result.live[-1, peak.place]
    told = str(result.table["largest tension at"])
    assert told.startswith(f"segment {peak.place} of rope 'rope', t = ")
    assert (
        rope_place(result, "segment", peak.place, result.time[-1]) == "on the drum of rope 'rope'"
    )


def test_what_parted_beside_the_drum_is_off_it() -> None:
    result = hoist(1.0, "start", parts=True)
    (parted, *_) = result.partings
    index = result.layout.span("rope").start + parted.segment
    assert "on the drum" not in rope_place(result, "segment", index, math.inf)
