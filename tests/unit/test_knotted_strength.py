"""A breaking load is that of a rope without a knot, and tables and checks of a knotted one say so."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.analysis.check import check
from ropewalk.record.margins import doubt_words, margin_of
from ropewalk.record.note_kinds import kinds
from ropewalk.scene.knotted import knot_doubt

TOLD = (
    "without the knot, which leaves a rope some 45 to 75 % of its strength: with the least of it "
)


def test_a_knot_takes_its_part_of_the_breaking_load() -> None:
    """The twins: a rope that is straight, and turns on a bollard."""
    straight = rw.Rope(segments=4, made_of="semistatic-10.5", length=1.0)
    scene = rw.preset("overhand")
    rope = scene.ropes[0].model_copy(update={"made_of": straight.made_of})
    scene = scene.model_copy(update={"ropes": (rope,)})
    words = doubt_words(scene, margin_of(scene, {rope.name: 0.0893}))
    assert words.endswith(f"{TOLD}19.9 %, safety factor 5.03")
    run = {"duration": 0.1, "method": "implicit-euler", "time_step": 1 / 240}
    table = rw.simulate(scene.model_copy(update={"run": rw.RunSettings(**run)})).table
    assert TOLD in table["about the largest utilisation of the breaking load"]
    assert knot_doubt(straight, 0.0893) == ""
    assert knot_doubt(rw.preset("bollard").ropes[0], 0.0893) == ""


def beside_a_knot(plain: float, tied: float) -> rw.Scene:
    """A straight rope and one in an overhand knot, each with a load, of these breaking loads [N]."""
    stuff = {"EA": 1e6, "mass_per_length": 0.1}
    loads = [{"node": -1, "mass": 10.0}]
    straight = {"kind": "straight", "start": (0, 5, 0), "direction": (0, 0, -1)}
    shapes = {"plain": (straight, plain), "tied": ({"kind": "knot", "knot": "overhand"}, tied)}
    ropes = [
        rw.Rope(
            name=name, segments=40, length=3.5, diameter=0.06, shape=shape, loads=loads,
            made_of=rw.Material(**stuff, breaking_load=load),
        )
        for name, (shape, load) in shapes.items()
    ]  # fmt: skip
    run = rw.RunSettings(duration=0.1, frame_rate=50.0, method="implicit-euler", time_step=1 / 240)
    anchors = [{"rope": name, "node": 0} for name in shapes]
    return rw.Scene(ropes=ropes, anchors=anchors, run=run)


def test_a_knotted_rope_that_is_not_the_nearest_may_be_with_its_knot() -> None:
    """Of 65 % in a plain rope and 61 % in a tied one nothing was said; the knot makes 136 % of those."""
    run = rw.simulate(beside_a_knot(1e4, 1e4))
    pull = [float(run.rope(name).greatest_tension.max()) for name in ("plain", "tied")]
    nearer = rw.simulate(beside_a_knot(pull[0] / 0.65, pull[1] / 0.61))
    assert nearer.table["largest utilisation of the breaking load [%]"] == pytest.approx(65.0)
    words = nearer.table["about the largest utilisation of the breaking load"]
    assert words.startswith("rope 'tied' may come nearer: its breaking load is told without the ")
    assert words.endswith(f"{TOLD}136 %, safety factor 0.737")
    assert "knot" in kinds(nearer)
    figure = " ".join(text.get_text() for text in nearer.plot.tension().texts)
    assert words in " ".join(figure.split())
    # The twin: a tied rope that with the least of its strength is not as near as the plain one.
    far = rw.simulate(beside_a_knot(pull[0] / 0.65, pull[1] / 0.29))
    assert "about the largest utilisation of the breaking load" not in far.table
    assert "knot" not in kinds(far)


def test_a_check_says_nothing_of_a_shape_of_rest_that_settle_does_not_find() -> None:
    """Without weight all are. The twin: a loop that may be drawn taut."""
    for name in ("overhand", "reef"):
        text = str(check(rw.preset(name)))
        assert "every shape is at rest" in text
        assert "settle" not in text
    assert "settle` looks for it" in str(check(rw.preset("bowline")))
