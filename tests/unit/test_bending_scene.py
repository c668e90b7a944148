"""Bending in scenes: what is refused, what is warned of, what goes through TOML."""

from __future__ import annotations

from typing import Any

import pytest

from ropewalk.analysis.bending_notes import bending_warnings
from ropewalk.analysis.unit_slips import unit_slips
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    Clamp,
    Material,
    Points,
    Rope,
    Scene,
    SceneError,
    Springs,
    Winch,
    dumps,
    loads,
)


def rope(EI: float = 0.5, **more: Any) -> Rope:
    segments = more.pop("segments", 10)
    place = {key: more.pop(key) for key in ("shape", "diameter") if key in more}
    made_of = Material(EA=1e5, mass_per_length=0.1, EI=EI, **more)
    return Rope(segments=segments, length=1.0, made_of=made_of, **place)


def test_a_clamp_goes_through_toml() -> None:
    clamp = Clamp(direction=(1, 0, 0.5), turn_axis=(0, 2, 0), turn_rate=1.5, start=0.5, stop=2.0)
    scene = Scene(
        ropes=rope(curvature=(0, 1.0, 0), bending_damping=0.01), anchors=Anchor(node=0, clamp=clamp)
    )
    again = loads(dumps(scene))
    assert again == scene
    assert "[anchor.clamp]" in dumps(scene)
    assert str(again.anchors[0]).endswith("fixed, clamped.")


@pytest.mark.parametrize(
    ("make", "fault"),
    [
        (lambda: Clamp(direction=(0, 0, 0)), "direction: [0.0, 0.0, 0.0] - must not be zero"),
        (lambda: Clamp(direction=(1, 0, 0), turn_axis=(0, 0, 0)), "turn_axis: .* must not be zero"),
        (lambda: Clamp(direction=(1, 0, 0), start=2, stop=1), "stop: 1.0 - must be later"),
        (lambda: rope(EI=-1.0), "EI: -1.0 - must be at least 0"),
        (lambda: rope(EI=0.0, bending_damping=1.0), "bending_damping: 1.0 - needs a bending stiff"),
        (lambda: rope(EI=0.0, curvature=(0, 1, 0)), "curvature: .* needs a bending stiffness"),
        (lambda: rope(curvature=(0, 30, 0)), "curvature: .* turns by 3 rad .* 30 segments or more"),
        (
            lambda: Scene(
                ropes=rope(0.0), anchors=Anchor(node=0, clamp=Clamp(direction=(1, 0, 0)))
            ),
            r"anchor\[0\].clamp.*needs a material with bending stiffness \(EI\)",
        ),
        (
            lambda: Scene(
                ropes=Rope(
                    segments=2,
                    made_of=Springs(spring_constant=1.0, node_mass=1.0, segment_length=1.0),
                ),
                anchors=Anchor(node=0, clamp=Clamp(direction=(1, 0, 0))),
            ),
            r"anchor\[0\].clamp.*bending stiffness",
        ),
        (
            lambda: Scene(
                ropes=rope(curvature=(0.0, 2.0, 0.0)),
                anchors=Anchor(node=0),
                winches=Winch(end="start", speed=1.0),
            ),
            r"winch\[0\].rope.* is curved by itself \(curvature\), with which a winch cannot wind it",
        ),
    ],
)
def test_what_cannot_be_is_refused_by_name(make: Any, fault: str) -> None:
    with pytest.raises(SceneError, match=fault.replace("[0.0, 0.0, 0.0]", r"\[0.*\]")):
        make()


def test_a_curled_rope_out_of_its_plane_is_warned_of() -> None:
    level = {"gravity": (0, 0, -9.81)}
    assert bending_warnings(build(Scene(ropes=rope(curvature=(0, 1, 0)), **level))) == []
    (said,) = bending_warnings(build(Scene(ropes=rope(curvature=(0, 1, 1)), **level)))
    assert "gravity leaves" in said
    bent = Points(points=[(0.1 * i, 0.01 * i * i, 0.0) for i in range(11)])
    (said,) = bending_warnings(build(Scene(ropes=rope(curvature=(0, 1, 0), shape=bent), **level)))
    assert "its shape leaves" in said
    assert bending_warnings(build(Scene(ropes=rope(0.0), **level))) == []


def test_sharp_bends_and_slips_of_units_are_warned_of() -> None:
    corner = Points(points=[(min(0.1 * i, 0.5), 0.0, max(0.1 * i - 0.5, 0.0)) for i in range(11)])
    (said,) = bending_warnings(build(Scene(ropes=rope(shape=corner))))
    assert "bent by 90 degrees at node 5" in said
    # a solid round rod has EI = EA d^2 / 16: 0.625 N m^2 here
    assert unit_slips(build(Scene(ropes=rope(0.62, diameter=0.01)))) == []
    (said,) = unit_slips(build(Scene(ropes=rope(620.0, diameter=0.01))))
    assert "N mm^2 for N m^2?" in said
    assert "0.625 N m^2" in said


def test_segments_far_shorter_than_the_rod_is_thick_are_warned_of() -> None:
    """A round rod is 4 sqrt(EI / EA) thick: 0.566 m at 2000 N m^2; five segments are 0.5 m."""
    (said,) = bending_warnings(build(Scene(ropes=rope(2000.0))))
    assert "a round rod 0.566 m thick, in segments of 0.1 m" in said
    assert "take 1 segment at most" in said
    assert bending_warnings(build(Scene(ropes=rope(1500.0)))) == []
