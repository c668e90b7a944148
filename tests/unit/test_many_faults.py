"""Scenes with tens of thousands of faults: told of in seconds, the first two hundred by name."""

from __future__ import annotations

import time

import pytest

from ropewalk.scene import SceneError, loads
from ropewalk.words.nearest import nearest

ROPE = """
[[rope]]
segments = 3
name = "{name}"
[rope.made_of]
kind = "springs"
spring_constant = 10.0
node_mass = 0.1
segment_length = 1.0
"""


def faults(text: str) -> tuple[int, str, float]:
    """Number of faults that are told, the last one, and the processor time it took [s]."""
    begun = time.process_time()
    with pytest.raises(SceneError) as caught:
        loads(text)
    return len(caught.value.faults), str(caught.value.faults[-1]), time.process_time() - begun


def scene(kind: str, count: int) -> str:
    rope = ROPE.format(name="rope")
    some = {
        "unknown keys": rope + "".join(f"k{i} = 1\n" for i in range(count)),
        "dotted keys": rope + "".join(f"a{i}.b = 1\n" for i in range(count)),
        "bad nodes": rope + "".join(f"[[anchor]]\nnode = {i + 9}\n" for i in range(count)),
        "no such ropes": rope
        + "".join(f'[[anchor]]\nrope = "r{i}"\nnode = 0\n' for i in range(count)),
        "names twice": rope * count,
    }
    return some[kind]


@pytest.mark.parametrize(
    "kind", ["unknown keys", "dotted keys", "bad nodes", "no such ropes", "names twice"]
)
def test_what_is_told_is_bounded_and_the_time_linear(kind: str) -> None:
    some, last, short = faults(scene(kind, 2_000))
    more, _, long = faults(scene(kind, 8_000))
    assert some == more == 201
    assert "more faults, not told here" in last
    assert long < 10.0 * max(short, 0.05)  # four times as many: not sixteen times as long


def test_winches_and_anchors_on_many_ropes_are_checked_in_linear_time() -> None:
    def text(count: int) -> str:
        ropes = "".join(ROPE.format(name=f"r{i}") for i in range(count))
        held = "".join(f'[[anchor]]\nrope = "r{i}"\nnode = 0\n' for i in range(count))
        wound = "".join(
            f'[[winch]]\nrope = "r{i}"\nend = "start"\nspeed = 0.1\n' for i in range(count)
        )
        return ropes + held + wound.replace("start", "end", 1)

    def spent(count: int) -> float:
        begun = time.process_time()
        with pytest.raises(SceneError, match="needs an anchor at node -1 of 'r0'"):
            loads(text(count))
        return time.process_time() - begun

    spent(10)
    short, long = spent(300), spent(1200)
    assert long < 8.0 * max(short, 0.05)


def test_a_name_among_very_many_is_not_answered_with_all_of_them() -> None:
    many = [f"r{i:05}" for i in range(40_000)]
    assert len(nearest("quite another", many)) < 400
    assert nearest("quite another", many).endswith("and 39970 more")
    assert nearest("r00001x", many) == 'did you mean "r00001"?'
    assert nearest("x", []) == "there is none"
