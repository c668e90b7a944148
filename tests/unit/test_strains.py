"""Ropes that stretch more than ropes do, and shapes that start them broken or pressed."""

from __future__ import annotations

import pytest

from report_rope import scene, warnings
from ropewalk.analysis.check import check
from ropewalk.api import simulate
from ropewalk.rigging import Line, line
from ropewalk.rigging.slips import strain_slip
from ropewalk.scene import (
    Anchor,
    Load,
    Material,
    Points,
    Rope,
    Scene,
    Slack,
    Springs,
    Straight,
)


def test_a_strain_that_no_rope_bears_is_warned_of() -> None:
    """12 m of 0.1 kg/m with EA in kN typed as N: 80 N carry it level, so 20 N stretch it by far."""
    for EA, strained in ((20.0, True), (2e4, False)):
        made = scene(
            made_of=Material(EA=EA, mass_per_length=0.1), length=12.0, gravity=(0, 0, -9.81)
        )
        found = check(made, measure=False)
        said = [text for text in found.warnings if "at rest it is stretched by" in text]
        assert bool(said) is strained
        rope = found.ropes[0]
        assert rope.largest_strain == pytest.approx(rope.largest_tension / EA, rel=1e-6)
        if strained:
            assert f"by {100 * rope.largest_strain:.3g} %" in said[0]
            assert "EA of 20 N: kN typed as N" in said[0]
    assert "kN/m typed as N/m" in warnings(spring_constant=20.0)


def test_a_shape_that_starts_broken_is_told() -> None:
    """4 segments of 0.1 m laid over 8 m. The twin: over 3 m, 7.5 times their length."""
    made_of = Springs(spring_constant=100.0, node_mass=0.1, segment_length=0.1)
    long, short = (
        Scene(
            ropes=[Rope(segments=4, made_of=made_of, shape=Straight(end=(reach, 0.0, 0.0)))],
            anchors=[Anchor(node=0)],
            gravity=(0.0, 0.0, 0.0),
            run={"duration": 0.5},
        )
        for reach in (8.0, 3.0)
    )
    found = check(long)
    assert not found.ok
    text = "4 of 4 segments start at up to 20 times their rest length: the run breaks at once"
    assert any(text in warning for warning in found.warnings)
    points = [(float(x), 0.0, 0.0) for x in (0, 1, 2, 3, 33)]
    one = Rope(
        length=4.0,
        segments=4,
        made_of=Material(EA=1e4, mass_per_length=0.1),
        shape=Points(points=points),
    )
    told = check(Scene(ropes=[one], anchors=[Anchor(node=0)]), measure=False).warnings
    assert any("1 of 4 segments starts at up to" in warning for warning in told)
    assert simulate(long, on_failure="return").status == "broke"
    assert check(short).ok
    assert simulate(short, on_failure="return").status == "finished"


def test_a_shape_that_starts_pressed_is_told() -> None:
    """Chords of a hanging rope of EA 1 MN are 0.09 % short: 899 N, where it carries 2.9 N at rest.

    The twins: a start at rest, a rope that cannot push, and one that is soft.
    """

    def told(EA: float = 1e6, tension_only: bool = False, start: str = "shape") -> list[str]:
        line = Material(EA=EA, mass_per_length=0.1, axial_damping=10.0, tension_only=tension_only)
        rope = Rope(segments=20, length=5.0, made_of=line, shape=Slack(end=(4.0, 0.0, 0.0)))
        hung = Scene(ropes=[rope], anchors=[Anchor(node=0), Anchor(node=-1)], run={"start": start})
        return [text for text in check(hung, measure=False).warnings if "starts it pressed" in text]

    (text,) = told()
    small = Material(EA=0.05, mass_per_length=1e-10)
    thread = Rope(segments=20, length=5e-3, made_of=small, shape=Slack(end=(4e-3, 0.0, 0.0)))
    ends = [Anchor(node=0), Anchor(node=-1)]
    (of_silk,) = [
        one
        for one in check(Scene(ropes=[thread], anchors=ends), measure=False).warnings
        if "pressed" in one
    ]
    assert "by up to 4.49" in of_silk  # it was not told of less than a millinewton
    assert "by up to 898.7 N, where it carries 2.859 N at rest" in text
    assert told(start="at-rest") == []
    assert told(tension_only=True) == []
    assert told(EA=1e3) == []


@pytest.mark.parametrize(
    ("name", "strain", "told"),
    [
        ("dynamic-single-9.8:static", 0.14, False),  # as under a climber and his bag
        ("dynamic-single-9.8:static", 0.16, True),
        ("polyester-braid-12", 0.14, True),  # it breaks at 17 %
        ("polyester-braid-12", 0.09, False),
        ("bungee-8", 0.6, False),
        ("locked-coil-30", 0.02, True),  # its breaking load is a guess, and not in the scene
        ("locked-coil-30", 0.004, False),
    ],
)
def test_ropes_of_the_library_bear_what_their_kind_bears(
    name: str, strain: float, told: bool
) -> None:
    """All were let pass up to 15 %, as only climbing ropes stretch; rubber was not at more."""
    made_of = Rope(segments=1, length=1.0, made_of=name).made_of
    assert isinstance(made_of, Material)
    rope = Rope(
        segments=4, length=2.0, made_of=made_of, shape=Straight(direction=(0, 0, -1)),
        loads=[Load(node=-1, mass=strain * made_of.EA / 9.81)],
    )  # fmt: skip
    hung = Scene(ropes=[rope], anchors=[Anchor(node=0)], gravity=(0, 0, -9.81))
    found = check(hung, measure=False).warnings
    assert any("at rest it is stretched by" in text for text in found) is told


def test_a_climbing_rope_from_its_own_label_may_hang_by_a_tenth() -> None:
    """A label of 7.2 % at rest, and a climber with a bag: it was asked for kN typed as N."""
    label = Material.from_fall("8.6 kN", "33 %", "52 g/m", static_elongation="7.2 %")
    for made_of, told in (
        (label, False),
        (label.replace(relaxing_EA=None, relaxation_time=None), True),
    ):
        rope = Rope(
            segments=4, length=10.0, made_of=made_of, shape=Straight(direction=(0, 0, -1)),
            loads=[Load(node=-1, mass=110.0)],
        )  # fmt: skip
        hung = Scene(ropes=[rope], anchors=[Anchor(node=0)], gravity=(0, 0, -9.81))
        found = check(hung, measure=False)
        assert 0.1 < found.ropes[0].largest_strain < 0.12
        assert any("kN typed as N" in text for text in found.warnings) is told


def _hung(made_of: Material, strain: float, duration: float = 0.05) -> Scene:
    """A metre that hangs by its own stretch under a load."""
    rope = Rope(
        segments=4, length=1.0, made_of=made_of, shape=Straight(direction=(0, 0, -1)),
        loads=[Load(node=-1, mass=strain * made_of.EA / 9.81)],
    )  # fmt: skip
    run = {"duration": duration, "start": "at-rest"}
    return Scene(ropes=[rope], anchors=[Anchor(node=0)], gravity=(0, 0, -9.81), run=run)


@pytest.mark.parametrize(
    ("name", "right", "beyond", "words"),
    [
        ("bungee-8", 0.6, 1.5, "its cover holds it: true forces are larger"),
        ("rubber-cord-8", 0.9, 4.5, "it stiffens: true forces may be larger"),
        ("spider-dragline", 0.01, 0.06, "it yields: true forces are smaller"),
    ],
)
def test_a_library_rope_beyond_its_straight_line_is_told(
    name: str, right: float, beyond: float, words: str
) -> None:
    """A bungee at two and a half times its length had 780 N in the table, and not a word was said."""
    made_of = Rope(segments=1, length=1.0, made_of=name).made_of
    assert isinstance(made_of, Material)
    for strain, told in ((right, False), (beyond, True)):
        scene = _hung(made_of, strain)
        found = check(scene, measure=False).warnings
        assert any(words in text for text in found) is told
        about = simulate(scene).table.get("about the largest stretch", "")
        assert (words in about and f"EA of {name}" in about) is told
        tension = strain * made_of.EA
        assert any(words in text for text in strain_slip(_pulled(made_of), tension)) is told
    # The EA of a measurement of one's own is not the library's: of that nothing is known.
    own = made_of.replace(EA=1.5 * made_of.EA)
    assert not any(words in text for text in check(_hung(own, beyond), measure=False).warnings)


def _pulled(made_of: Material) -> Line:
    """A line of which only the material matters here."""
    return line(1.0, 0.0, made_of, length=1.001)
