"""What a sweep refuses before anything runs, and in which words."""

from __future__ import annotations

from pathlib import Path

import pytest

import ropewalk as rw
from ropewalk.record.errors import InputError, RunError
from sweeps.scenes import EA, rigid, swing


def test_what_two_values_make_wrong_is_told_among_many_corners() -> None:
    """A start and an end farther apart than the rope is long; the other four make it 144 corners."""
    ends = {
        "rope.shape.start": [[0.0, 0.0, 0.0], [-3.0, 0.0, 0.0], [0.1, 0.0, 0.0]],
        "rope.shape.end": [[8.0, 0.0, 1.0], [11.0, 0.0, 0.0], [8.1, 0.0, 1.0]],
    }
    more = {f"gravity[{k}]": [-9.8 * (k == 2), -9.7 + 9.8 * (k != 2)] for k in range(3)}
    mass = {"rope.made_of.mass_per_length": [0.05, 0.06]}
    with pytest.raises(rw.SceneError, match="14 m"):
        rw.sweep(rigid(), {**ends, **more, **mass}, keep="tension.max", on="here")


@pytest.mark.parametrize(
    ("vary", "more", "words"),
    [
        ({"rope.made_of.mass": [1.0]}, {}, "mass_per_length"),
        ({"gravity[3]": [1.0]}, {}, "must be from 0 to 2"),
        ({EA: [1.0, -1.0]}, {}, "must be greater than 0"),
        ({EA: []}, {}, "has no values"),
        ({EA: 5.0}, {}, "must be a list of values"),
        ({EA: (1.0, 2.0)}, {}, "say how many samples"),
        ({EA: (2.0, 1.0)}, {"samples": 4}, "begins with its low end: 1..2"),
        ({EA: (1.0, 2.0, 3.0)}, {"samples": 4}, "a tuple is a range"),
        ({}, {}, "name at least one path"),
        ({"gravity": [[0, 0, -1]], "gravity[2]": [-1.0]}, {}, "changes what gravity changes too"),
        ({EA: [1.0]}, {"design": "sobel"}, 'did you mean "sobol"'),
        ({EA: (1.0, 2.0)}, {"samples": 0}, "whole number from 1"),
        ({EA: [1.0]}, {"keep": "tention.max"}, 'did you mean "tension"'),
        ({EA: [1.0]}, {"keep": "tension.maximum"}, "no reducer"),
        ({EA: [1.0]}, {"keep": "positions[9]"}, "no frame 9"),
        ({EA: [1.0]}, {"keep": "reactions[-1, bottom]"}, "there is top"),
        ({EA: [1.0]}, {"keep": ["tension[-1, 1]", "tension[last_1]"]}, "which tension[-1, 1] has"),
        ({EA: [1.0]}, {"keep": []}, "is empty"),
        ({"rope.segments": [4, 0]}, {}, "must be at least 1"),
        ({"rope.segments": [4.5]}, {}, "whole number"),
        ([1, 2], {}, "must be a mapping"),
    ],
)
def test_what_cannot_be_is_told_before_anything_runs(
    vary: object, more: dict[str, object], words: str
) -> None:
    with pytest.raises(rw.SceneError) as caught:
        rw.sweep(swing(0.1), vary, on="here", **more)
    assert words in str(caught.value)


def test_every_faulty_corner_is_told_at_once() -> None:
    with pytest.raises(rw.SceneError) as caught:
        rw.sweep(swing(), {EA: [-1.0, 1.0], "rope.length": [-2.0, 2.0]}, on="here")
    assert len(caught.value.faults) == 2


def test_faults_of_values_and_of_corners_are_told_together() -> None:
    """A number of segments that no rope has, and two ends that are only together too far apart."""
    vary = {
        "rope.segments": [0, 5],
        "rope.shape.start": [[0.0, 0.0, 0.0], [-3.0, 0.0, 0.0]],
        "rope.shape.end": [[8.0, 0.0, 1.0], [11.0, 0.0, 0.0]],
    }
    with pytest.raises(rw.SceneError) as caught:
        rw.sweep(rigid(), vary, on="here")
    told = [str(fault) for fault in caught.value.faults]
    assert sum("must be at least 1" in one for one in told) == 1
    far = [one for one in told if "shorter than the 14" in one]
    assert any("(with rope.segments=5" in one for one in far), told


def test_a_folder_with_something_in_it_is_refused(tmp_path: Path) -> None:
    rw.sweep(swing(0.02), {EA: [1e3]}, store=tmp_path / "s", on="here")
    with pytest.raises(RunError, match="resume it, take another folder, or overwrite"):
        rw.sweep(swing(0.02), {EA: [1e3]}, store=tmp_path / "s", on="here")
    rw.sweep(swing(0.02), {EA: [2e3]}, store=tmp_path / "s", on="here", overwrite=True)
    assert list(rw.sweep.open(tmp_path / "s").EA) == [2e3]
    other = tmp_path / "other"
    other.mkdir()
    (other / "letter.txt").write_text("dear")
    with pytest.raises(RunError, match="something else than a sweep"):
        rw.sweep(swing(0.02), {EA: [1e3]}, store=other, on="here", overwrite=True)
    with pytest.raises(RunError, match="no such sweep"):
        rw.sweep.open(tmp_path / "nothing")


def test_too_much_for_memory_is_refused() -> None:
    with pytest.raises(InputError, match="store="):
        rw.sweep(swing(10.0), {EA: (1e3, 2e3)}, samples=65536, keep="positions", on="here")
