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
    assert text.count("at rest: 8 spans of one segment each, whose sag is not computed") == 14
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
    found = rw.check(scene, measure=False)
    (told,) = found.as_dict()["statics"]["spans"]
    assert (told["sag"], told["rise"], told["kind"]) == (None, None, "span")
    assert "at rest: 1 span of one segment, whose sag is not computed" in str(found)
    assert "one segment, whose sag is not computed, over 1 m" in repr(static_shape(scene))


def test_only_what_is_alike_is_gathered() -> None:
    said = ["rope 'a': short", "all: short", "rope 'b': short", "rope 'c': slack", "rope 'd' falls"]
    assert gathered(said, "abcd", named=()) == [
        "2 ropes ('a', 'b'), each: short", "all: short", "rope 'c': slack", "rope 'd' falls",
    ]  # fmt: skip
    assert gathered(["rope 'z': short"], "ab") == ["rope 'z': short"]
    assert gathered(["the same", "the same"], "a") == ["the same"]


def test_ropes_that_break_are_all_named_and_in_json_all_others_too() -> None:
    said = [f"rope {name!r}: {what}" for what in ("breaks", "slack") for name in "abcde"]
    every = "5 ropes ('a', 'b', 'c', 'd', 'e'), each"
    assert gathered(said, "abcde") == [f"{every}: breaks", f"{every}: slack"]
    short = "5 ropes ('a', 'b', 'c' and 2 more), each"
    assert gathered(said, "abcde", named=said[:5]) == [f"{every}: breaks", f"{short}: slack"]

    ropes = [
        rw.Rope(
            name=name, segments=2, length=1.0, loads=[{"node": -1, "mass": 80.0}],
            made_of=rw.Material(EA=1e5, mass_per_length=0.05, breaking_load=500.0),
            shape={"kind": "straight", "start": (x, 0, 0), "end": (x, 0, -1)},
        )
        for x, name in enumerate("abcde")
    ]  # fmt: skip
    scene = rw.Scene(ropes=ropes, anchors=[{"rope": name, "node": 0} for name in "abcde"])
    found = rw.check(scene, measure=False)
    assert any(text.startswith(f"{every}: at rest it carries 1.5") for text in found.warnings)
    net = rw.check("net", measure=False)
    assert "'y5'" in " ".join(net.as_dict()["warnings"])
    assert "'y5'" not in " ".join(net.warnings)
