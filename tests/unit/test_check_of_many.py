"""A check of many ropes, or of short ones, says what is alike once."""

from __future__ import annotations

import ropewalk as rw
from ropewalk.analysis.gathered import gathered
from ropewalk.statics import static_shape


def test_a_net_is_told_in_few_lines() -> None:
    """It had 112 lines of "sag 0 m" and 22 warnings, 14 and 8 of them alike."""
    found = rw.check("net", measure=False)
    text = str(found)
    assert "sag 0 m" not in text
    assert text.count("at rest: 8 spans of one segment each, without sag") == 14
    assert [one.partition(":")[0] for one in found.warnings] == [
        "14 ropes ('x1', 'x2', 'x3' and 11 more), each",
        "8 ropes ('x1', 'x2', 'x6' and 5 more), each",
    ]


def test_a_rope_of_one_segment_has_no_sag() -> None:
    rope = rw.Rope(
        segments=1, length=1.0, made_of=rw.Material(EA=1e4, mass_per_length=0.1),
        shape={"kind": "straight", "start": (0, 0, 0), "end": (1, 0, 0)},
    )  # fmt: skip
    scene = rw.Scene(ropes=[rope], anchors=[{"node": 0}, {"node": -1}])
    assert "at rest: 1 span of one segment, without sag" in str(rw.check(scene, measure=False))
    assert "one segment without sag over 1 m" in repr(static_shape(scene))


def test_only_what_is_alike_is_gathered() -> None:
    said = ["rope 'a': short", "all: short", "rope 'b': short", "rope 'c': slack", "rope 'd' falls"]
    assert gathered(said, "abcd") == [
        "2 ropes ('a', 'b'), each: short", "all: short", "rope 'c': slack", "rope 'd' falls",
    ]  # fmt: skip
    assert gathered(["rope 'z': short"], "ab") == ["rope 'z': short"]
    assert gathered(["the same", "the same"], "a") == ["the same"]
