"""Scenes with tens of thousands of faults: told of in seconds, the first two hundred by name."""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

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


@contextmanager
def no_collections() -> Iterator[None]:
    """No garbage is collected: in a process that has run many tests one collection takes half a second."""
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


def least_time(work: Callable[[], object]) -> float:
    """The least processor time of three calls [s]: what disturbs a call only ever adds to it."""
    times = []
    for _ in range(3):
        with no_collections():
            begun = time.process_time()
            work()
            times.append(time.process_time() - begun)
    return min(times)


def faults(text: str) -> list[str]:
    with pytest.raises(SceneError) as caught:
        loads(text)
    return [str(fault) for fault in caught.value.faults]


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
    few, many = scene(kind, 2_000), scene(kind, 8_000)
    for text in (few, many):
        told = faults(text)
        assert len(told) == 201
        assert "more faults, not told here" in told[-1]
    short = least_time(lambda: faults(few))
    # four times as many: not sixteen times as long
    assert least_time(lambda: faults(many)) < 10.0 * short


BETWEEN = """
[contact]
[[contact.pair]]
rope = "none"
other = "b"
friction = 0.1
[[anchor]]
rope = "a"
node = 41
[[obstacle]]
kind = "sphere"
name = "ball"
center = [0, 0, -9]
radius = 1
[[obstacle]]
kind = "sphere"
name = "ball"
center = [0, 0, -19]
radius = 1
[[slide]]
rope = "b"
on = "nowhere"
"""


def test_faults_between_parts_are_told_at_once() -> None:
    """Those of anchors hid those of obstacles, these those of contact, and so on."""
    ropes = ROPE.format(name="a") + ROPE.format(name="b")
    wrong = {
        "anchor[0].node": "41",
        "obstacle[1].name": "is the name of obstacle[0] already",
        "rope[0].diameter": "is needed where ropes touch",
        "rope[1].diameter": "is needed where ropes touch",
        "contact.pair[0].rope": '"none" - is no rope',
        "slide[0].on": '"nowhere" - is no rope',
    }
    for more in (
        "",
        "[limiter]\nmin_stretch = -1\n",
    ):  # faulty in itself: others are told all the same
        lines = {line.partition(": ")[0]: line for line in faults(ropes + BETWEEN + more)}
        assert set(lines) == {*wrong, *(["limiter.min_stretch"] if more else [])}
        for path, words in wrong.items():
            assert words in lines[path]
    broken = ROPE.format(name="a") + ROPE.format(name="b").replace("segments = 3", "segments = 0")
    paths = [line.partition(": ")[0] for line in faults(broken + BETWEEN)]
    # what names the ropes is not told of as long as one of them cannot be read
    assert paths == ["rope[1].segments", "anchor[0].node", "obstacle[1].name", "rope[0].diameter"]


def test_parts_that_are_faulty_in_themselves_hide_no_others() -> None:
    ropes = ROPE.format(name="a") + ROPE.format(name="b")
    text = ropes + BETWEEN.replace("radius = 1", "radius = -1", 1).replace('"b"\non', '"b"\nto')
    paths = [line.partition(": ")[0] for line in faults(text)]
    assert {"obstacle[0].radius", "slide[0].to", "rope[0].diameter"} <= set(paths)


def test_winches_and_anchors_on_many_ropes_are_checked_in_linear_time() -> None:
    def text(count: int) -> str:
        ropes = "".join(ROPE.format(name=f"r{i}") for i in range(count))
        held = "".join(f'[[anchor]]\nrope = "r{i}"\nnode = 0\n' for i in range(count))
        wound = "".join(
            f'[[winch]]\nrope = "r{i}"\nend = "start"\nspeed = 0.1\n' for i in range(count)
        )
        return ropes + held + wound.replace("start", "end", 1)

    def refused(text: str) -> None:
        with pytest.raises(SceneError, match="needs an anchor at node -1 of 'r0'"):
            loads(text)

    few, many = text(300), text(1200)
    assert least_time(lambda: refused(many)) < 10.0 * least_time(lambda: refused(few))


def test_a_name_among_very_many_is_not_answered_with_all_of_them() -> None:
    many = [f"r{i:05}" for i in range(40_000)]
    assert len(nearest("quite another", many)) < 400
    assert nearest("quite another", many).endswith("and 39970 more")
    assert nearest("r00001x", many) == 'did you mean "r00001"?'
    assert nearest("x", []) == "there is none"
