"""A breaking load is that of a rope without a knot, and tables and checks of a knotted one say so."""

from __future__ import annotations

import ropewalk as rw
from ropewalk.analysis.check import check
from ropewalk.record.margins import doubt_words, margin_of
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


def test_a_check_says_nothing_of_a_shape_of_rest_that_settle_does_not_find() -> None:
    """Without weight all are. The twin: a loop that may be drawn taut."""
    for name in ("overhand", "reef"):
        text = str(check(rw.preset(name)))
        assert "every shape is at rest" in text
        assert "settle" not in text
    assert "settle` looks for it" in str(check(rw.preset("bowline")))
