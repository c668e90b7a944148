"""Utilisation and safety factor: in the tables of runs and equilibria, in check, in figures."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.margins import margin_words
from ropewalk.words.safe_side import percent_up


def hung(mass: float, breaking_load: float | None) -> rw.Scene:
    """A rope that carries a mass at its end, at rest."""
    made_of = rw.Material(EA=1e5, mass_per_length=0.1, breaking_load=breaking_load)
    rope = rw.Rope(
        segments=5,
        length=2.0,
        made_of=made_of,
        shape={"kind": "hanging"},
        loads=[rw.Load(node=-1, mass=mass)],
    )
    run = rw.RunSettings(duration=0.1, frame_rate=50.0, start="at-rest")
    return rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)


def factor(utilisation: float) -> str:
    """The safety factor, as it is told."""
    return margin_words(utilisation, "").partition("factor ")[2]


def top(mass: float) -> float:
    """Tension of the first segment [N]: all but the first node's half of a segment hangs below it."""
    return 9.81 * (mass + 0.1 * 2.0 * (1.0 - 0.5 / 5))


def test_the_tables_of_a_run_and_of_its_rest() -> None:
    scene = hung(50.0, 2000.0)
    borne = top(50.0), 9.81 * (50.0 + 0.1 * 2.0)  # by a segment, and at rest by the anchor
    for result, share in zip((rw.simulate(scene), rw.equilibrium(scene)), borne, strict=True):
        share /= 2000.0
        table = result.table
        assert table["largest utilisation of the breaking load [%]"] == pytest.approx(100 * share)
        assert table["least safety factor [1]"] == pytest.approx(1.0 / share)
        assert "segment 0" in table["largest utilisation of the breaking load at"]
        segment = top(50.0) / 2000.0
        assert result.rope("rope").utilisation[0, 0] == pytest.approx(segment)


def test_nothing_is_said_where_no_breaking_load_is_known() -> None:
    scene = hung(50.0, None)
    result = rw.simulate(scene)
    assert not any("utilisation" in name or "safety" in name for name in result.table)
    assert np.isnan(result.rope("rope").utilisation).all()
    assert "breaking" not in str(rw.check(scene, measure=False))
    texts = [text.get_text() for text in result.plot.tension().texts]
    assert not any("breaking" in text for text in texts)


def test_the_rope_that_is_nearest_to_breaking_counts_not_the_one_with_the_largest_tension() -> None:
    strong, weak = hung(50.0, 1e5).ropes[0], hung(10.0, 200.0).ropes[0]
    ropes = [
        strong.replace(name="strong"),
        weak.replace(name="weak", shape={"kind": "hanging", "start": [1, 0, 0]}),
    ]
    anchors = [rw.Anchor(rope="strong", node=0), rw.Anchor(rope="weak", node=0)]
    table = rw.equilibrium(rw.Scene(ropes=ropes, anchors=anchors)).table
    assert "strong" in table["largest tension at"]
    assert "weak" in table["largest utilisation of the breaking load at"]
    assert table["largest utilisation of the breaking load [%]"] == pytest.approx(
        100 * 9.81 * (10.0 + 0.1 * 2.0) / 200.0
    )


def test_check_and_figures_say_it_and_warn() -> None:
    calm, torn = hung(50.0, 2000.0), hung(50.0, 400.0)
    lines = str(rw.check(calm, measure=False))
    assert "24.7 % of the breaking load, safety factor 4.06" in lines
    found = rw.check(torn, measure=False)
    assert any("1.24 times its breaking load" in warning for warning in found.warnings)
    assert not any("breaking" in warning for warning in rw.check(calm, measure=False).warnings)
    borne = 9.81 * (50.0 + 0.1 * 2.0)  # by the anchor
    assert found.as_dict()["ropes"][0]["utilisation"] == pytest.approx(borne / 400.0)  # type: ignore[index]
    result = rw.simulate(torn)
    for figure in (result.plot.tension(), result.plot.forces()):
        texts = " ".join(text.get_text() for text in figure.texts)
        assert "it would have parted" in texts


def test_the_forces_of_one_moment_do_not_hide_those_of_the_run() -> None:
    """A tow rope that is slack at the end had a safety factor of some 5; it read 58 800."""
    result = rw.simulate(rw.preset("tow"))
    least = result.table["least safety factor [1]"]
    assert 4.0 < least < 7.0
    texts = " ".join(text.get_text() for text in result.plot.forces().texts)
    assert f"safety factor {factor(1.0 / least)} since the start" in texts
    assert "% of the breaking load at this moment" in texts
    assert texts.count("safety factor") == 1


def test_the_figure_of_a_rest_counts_what_the_anchor_bears() -> None:
    """60 m of heavy rope in 5 segments: 78.48 % at the anchor, of which the figure said 70.6 %."""
    made_of = rw.Material(EA=1e6, mass_per_length=4.0, breaking_load=3000.0)
    rope = rw.Rope(segments=5, length=60.0, made_of=made_of, shape={"kind": "hanging"})
    rest = rw.equilibrium(rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)]))
    assert rest.table["least safety factor [1]"] == pytest.approx(1.0 / 0.7848)
    for figure in (rest.plot.forces(), rest.plot.tension()):
        texts = " ".join(text.get_text() for text in figure.texts)
        assert "at most 78.5 % of the breaking load, safety factor 1.27." in texts


@pytest.mark.parametrize(("segments", "parts"), [(1, False), (10, True), (200, True)])
def test_what_the_anchor_bears_counts_for_the_utilisation_at_rest(
    segments: int, parts: bool
) -> None:
    """1000 m of 1 kg/m: 9810 N at the top, whatever the segments; of ten it was 98.1 % of 9500 N."""
    made_of = rw.Material(EA=1e7, mass_per_length=1.0, breaking_load=9500.0, parts=parts)
    rope = rw.Rope(segments=segments, length=1000.0, made_of=made_of, shape={"kind": "hanging"})
    heavy = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)])
    found = rw.check(heavy, measure=False)
    assert found.ropes[0].utilisation == pytest.approx(9810.0 / 9500.0)
    said = " ".join(found.lines())
    assert "104 % of the breaking load, safety factor 0.968" in said
    if not parts:
        assert any("1.04 times its breaking load" in text for text in found.warnings)
        return
    then = {10: ("with more segments it parts", "it may part"), 200: ("; it parts", "it parts by")}
    assert then[segments][0] in said  # segments of ten carry 9320 N, and hold in the run
    assert any(then[segments][1] in text for text in found.warnings)
    table = rw.equilibrium(heavy).table
    assert table["largest utilisation of the breaking load [%]"] == pytest.approx(981.0 / 9.5)
    assert table["least safety factor [1]"] == pytest.approx(9500.0 / 9810.0)
    assert table["largest utilisation of the breaking load at"].startswith(
        "anchor 'anchor0' beside"
    )
    if segments == 10:
        told = table["about the largest tension"]
        assert "(5.3 %), 104 % of the breaking load;" in told


def test_half_a_segment_of_a_heavy_rope_is_told_where_the_anchor_bears_it() -> None:
    """400 m of wire with 100 kg: utilisation and anchor's force are apart, and less so with more segments."""
    row, bears = "about the largest tension", {}
    for segments, apart in ((4, 0.09), (20, 0.015)):
        wire = rw.Rope(
            segments=segments,
            length=400.0,
            made_of="wire-7x19-12",
            shape={"kind": "hanging"},
            loads=[{"node": -1, "mass": 100.0}],
        )
        hung = rw.Scene(ropes=[wire], anchors=[{"node": 0}], run={"duration": 0.1})
        made_of = wire.made_of
        weight = 9.81 * (100.0 + 400.0 * made_of.mass_per_length)
        rest = rw.equilibrium(hung)
        most = float(rest.table["largest tension [N]"])
        assert weight / most > 1.0 + apart
        assert rest.table[row].startswith(f"the anchor bears {weight:.6g} N, half a segment's")
        said = rw.check(hung).ropes[0]
        assert said.largest_anchor_force == pytest.approx(weight, rel=1e-6)
        assert "its anchor bears" in " ".join(said.lines())
        bears[segments] = weight / most
        run = rw.simulate(hung.replace(**{"run.start": "at-rest", "run.frame_rate": 20.0}))
        assert run.table[row].startswith(f"the anchor bears {weight:.0f}")
    assert bears[20] < bears[4]
    assert row not in rw.equilibrium(hung.replace(**{"rope.segments": 40})).table  # below 1 %
    # The twins: a light rope, and a load at the anchor itself, which explains what it bears.
    light = hung.replace(**{"rope.length": 4.0})
    assert row not in rw.equilibrium(light).table
    held = [{"node": 0, "mass": 50.0}, {"node": -1, "mass": 100.0}]
    assert row not in rw.equilibrium(hung.replace(**{"rope.loads": held})).table


@pytest.mark.parametrize("blows", [True, False])
def test_what_wind_or_bending_adds_to_an_anchor_is_no_weight(blows: bool) -> None:
    """Of 5.0 N more in the wind 1.2 are half a segment's weight, and 3.8 the wind's on the anchor's node."""
    row = "about the largest tension"
    rope = rw.Rope(
        segments=4,
        length=4.0,
        diameter=0.05,
        made_of=rw.Material(
            EA=1e6, mass_per_length=2.0, EI=0.0 if blows else 20.0, breaking_load=1000.0
        ),
        shape={"kind": "straight", "start": (0, 0, 0), "end": (3.5, 0, 0)},
    )
    wind = {"density": 1.2, "wind": (0, 60, 0), "tangential_coefficient": 0.01} if blows else None
    hung = rw.Scene(
        ropes=[rope], anchors=[{"node": 0}, {"node": -1}], air=wind, run={"duration": 0.1}
    )
    calm = hung.replace(air=None, **{"rope.made_of.EI": 0.0})
    for scene, told in ((hung, False), (calm, True)):
        assert (row in rw.equilibrium(scene).table) == told
        said = rw.check(scene, measure=False).ropes[0]
        assert (said.largest_anchor_force is not None) == told
        rest = rw.equilibrium(scene)
        borne = np.linalg.norm(rest.reactions[0], axis=1).max()
        assert said.utilisation == pytest.approx(1e-3 * borne, rel=1e-6)
        used = rest.table["largest utilisation of the breaking load [%]"]
        assert used == pytest.approx(0.1 * borne, rel=1e-6)


def test_what_wind_adds_to_an_anchor_parts_no_segment() -> None:
    """Of 243.9 N in the segments and 248.9 N at the anchor "it parts" was said for 246.4 N; it holds."""
    stuff = rw.Material(EA=1e6, mass_per_length=2.0, breaking_load=246.4, parts=True)
    rope = rw.Rope(
        segments=4, length=4.0, diameter=0.05, made_of=stuff,
        shape={"kind": "straight", "start": (0, 0, 0), "end": (3.5, 0, 0)},
    )  # fmt: skip
    wind = {"density": 1.2, "wind": (0, 60, 0), "tangential_coefficient": 0.01}
    blown = rw.Scene(ropes=[rope], anchors=[{"node": 0}, {"node": -1}], air=wind)
    tension = rw.equilibrium(blown).tension.max()
    assert tension < 246.4
    for load, parts in ((246.4, False), (0.999 * tension, True)):
        told = rw.check(blown.replace(**{"rope.made_of.breaking_load": load}), measure=False)
        found, said = told.ropes[0], " ".join(told.lines())
        assert found.parts_at_rest is parts
        assert found.utilisation * load == pytest.approx(found.anchor_bears)
        assert (f"safety factor {factor(found.utilisation)}; it parts" in said) is parts
        assert ("with more segments it parts" in said) is not parts
        assert f"its anchor bears {found.anchor_bears:.5g} N, with what else acts" in said
        when = "it parts by the time" if parts else "it may part by the time"
        assert any(when in text for text in told.warnings)


def test_a_sheet_says_what_the_anchor_bears() -> None:
    """100 kg of rope hung in 4 segments: check said 98.1 % of 1000 N, and the sheet 85.8 % and no more."""
    made_of = rw.Material(EA=1e5, mass_per_length=1.0, breaking_load=1000.0)
    rope = rw.Rope(segments=4, length=100.0, made_of=made_of, shape={"kind": "hanging"})
    run = rw.RunSettings(duration=0.02, frame_rate=50.0, start="at-rest", time_step=0.01)
    heavy = rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=run)
    job = rw.sheet(heavy, convergence=False)
    at_rest, ran = job.as_dict()["sections"]["Summary"]["tables"][0]
    assert (at_rest["utilisation"], at_rest["safety factor"]) == ("98.1 %", "1.01")
    assert ran["utilisation"] == "85.9 %"  # of a segment
    for section in ("Summary", "The run"):
        told = " ".join(job.as_dict()["sections"][section]["texts"])
        assert "the anchor bears 981 N, half a segment's weight more (14 %), 98.1 %" in told
    light = heavy.replace(**{"rope.length": 1.0, "rope.loads": [{"node": -1, "mass": 50.0}]})
    for name, section in rw.sheet(light, convergence=False).as_dict()["sections"].items():
        assert "half a segment's weight" not in " ".join(section["texts"]), name


@pytest.mark.parametrize("weight", [80.0, -80.0, 100.0])
def test_half_a_segment_in_water_is_what_water_leaves_of_it(weight: float) -> None:
    """1000 m that hang or float in water: half of the dry weight was looked for, and nothing was told."""
    stuff = rw.Material(EA=1e8, mass_per_length=10.0, breaking_load=80e3)
    chain = rw.Rope(
        segments=10, length=1000.0, diameter=0.05, made_of=stuff, submerged_weight=weight,
        shape={"kind": "straight", "start": (0, 0, 0), "direction": (0, 0, -np.sign(weight))},
    )  # fmt: skip
    hung = rw.Scene(ropes=[chain], anchors=[{"node": 0}])
    borne = 1000.0 * abs(weight)
    told = rw.equilibrium(hung).table["about the largest tension"]
    assert told.startswith(
        f"the anchor bears {borne:.6g} N, half a segment's weight more (5.3 %), "
    )
    assert f"{percent_up(borne / 800.0, 3)} of the breaking load" in told
    found = rw.check(hung, measure=False).ropes[0]
    assert found.largest_anchor_force == found.anchor_bears == pytest.approx(borne)
    assert found.utilisation == pytest.approx(borne / 80e3)
    assert f"its anchor bears {borne / 1e3:.5g} kN, half a segment's weight more" in str(
        found.lines()
    )
