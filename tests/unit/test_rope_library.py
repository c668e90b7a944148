"""The rope library: whole, sourced, plausible, and what a scene makes of a name."""

from __future__ import annotations

import math
import re
from typing import Any

import jsonschema
import pytest

import ropewalk as rw
from ropewalk.library import families, names, rope, search, sources
from ropewalk.library.catalogue import _SOURCES, _table, faults
from ropewalk.library.entry import UNITS
from ropewalk.scene import Material, SceneError, apply_overrides, dumps, loads, schema
from ropewalk.scene.from_library import origin, origin_words
from ropewalk.scene.overrides import Places

FROM = "library"  # the key of a material that names a rope
FILES = ("climbing", "low_stretch", "fibre", "wire", "chain", "lines", "conductors")
BY_KEY = "rope.made_of." + FROM
#: Bounds by family: density and modulus on the nominal round section, and breaking stress.
#: [kg/m^3], [GPa], [MPa]
STEEL = ((4000, 8000), (25, 215), (450, 2700))
NYLON = ((700, 1150), (0.2, 6), (120, 450))
PLAUSIBLE = {
    "dynamic climbing rope": ((750, 900), (0.2, 0.6), (180, 330)),
    "semi-static rope": ((700, 1000), (0.3, 1.5), (250, 400)),
    "accessory cord": NYLON,
    "arborist rope": NYLON,
    "nylon rope": NYLON,
    "tow rope": NYLON,
    "polyester rope": ((750, 1100), (1, 8), (150, 450)),
    "polypropylene rope": ((450, 650), (0.5, 2), (90, 200)),
    "natural fibre rope": ((750, 1100), (0.2, 1.5), (30, 110)),
    "HMPE rope": ((550, 980), (30, 60), (600, 1000)),
    "aramid rope": ((900, 1200), (25, 60), (700, 1200)),
    "LCP rope": ((900, 1250), (25, 60), (700, 1200)),
    "webbing": ((700, 1150), (0.5, 6), (250, 500)),
    "steel wire rope": STEEL,
    "steel strand": STEEL,
    "locked coil rope": STEEL,
    "chain": ((25000, 29000), (70, 120), (1000, 2000)),
    "music string": ((1000, 8000), (3, 215), (250, 2700)),
    "fishing line": ((550, 1850), (1, 60), (450, 1300)),
    "space tether": ((550, 980), (30, 60), (700, 1300)),
    "cord and string": ((750, 1100), (0.2, 1), (30, 110)),
    "rubber": ((900, 1100), (0.001, 0.02), (15, 40)),
    "natural fibre": ((1200, 1400), (2, 15), (150, 2000)),
    "overhead conductor": ((2000, 3600), (40, 80), (120, 300)),
    "power cable": ((1200, 2500), (15, 30), (20, 40)),
}
#: Waves along a rope run at most as fast as in its fibre, sqrt(E / rho): HMPE 11 600 m/s, steel 5200 m/s.
FASTEST = {
    "HMPE rope": 11600,
    "fishing line": 11600,
    "space tether": 11600,
    "aramid rope": 8600,
    "LCP rope": 8900,
}


def test_there_are_enough_and_every_family_of_them() -> None:
    assert len(names()) >= 60
    assert set(families()) == set(PLAUSIBLE)
    assert len(set(names())) == len(names())


@pytest.mark.parametrize("name", FILES)
def test_every_number_has_quality_source_and_a_range_where_it_is_guessed(name: str) -> None:
    assert faults(_table(f"{name}.toml")) == []


def test_faults_are_found() -> None:
    right = {"value": 1.0, "quality": "maker", "source": "A1"}
    table = {
        "rope": {
            "x": {
                "EA": {"value": 1.0, "quality": "guess", "source": "R"},
                "EI": right | {"source": "Z9"},
                "diameter": right | {"quality": "fine"},
                "mass_per_length": right | {"source": ""},
                "colour": 3,
            },
            "y": {"EA": {"value": 9.0, "low": 1.0, "high": 2.0, "quality": "guess", "source": "R"}},
        }
    }
    assert len(faults(table)) == 6


def test_no_source_is_idle_and_none_is_missing() -> None:
    used = {
        tag
        for name in names()
        for group in (rope(name).numbers, rope(name).label)
        for number in group.values()
        for tag in number.source.split()
    }
    assert used == set(sources())
    assert set(_table(_SOURCES)) == set(sources())


@pytest.mark.parametrize("name", names())
def test_an_entry_is_plausible(name: str) -> None:
    one = rope(name)
    density, modulus, stress = PLAUSIBLE[one.family]
    assert density[0] <= one.density <= density[1]
    assert modulus[0] <= one.modulus / 1e9 <= modulus[1]
    assert one.wave_speed <= FASTEST.get(one.family, 5250)
    assert one.breaking_stress is not None
    assert stress[0] <= one.breaking_stress / 1e6 <= stress[1]
    of_some = {"EA_static", "relaxing_EA", "relaxation_time", "straight_to"}
    assert {*UNITS} - {*one.numbers} <= of_some  # all others, guessed or not
    for number in (*one.numbers.values(), *one.label.values()):
        assert math.isfinite(number.value)
        if number.low is not None and number.high is not None:
            assert number.low <= number.value <= number.high
    EI, solid = one.numbers["EI"], one.EA * one.diameter**2 / 16
    assert EI.value <= 1.01 * solid or one.family == "power cable"  # no stiffer than a solid rod


@pytest.mark.parametrize("name", [name for name in names() if rope(name).label])
def test_a_label_s_fall_is_in_its_stiffness_and_damping(name: str) -> None:
    from ropewalk.theory import rope_fall

    one = rope(name)
    fall = rope_fall(one.EA, one.axial_damping or 0.0, one.label["falling_mass"].value)
    assert fall.force == pytest.approx(one.label["impact_force"].value, rel=1e-3)
    if "dynamic_elongation" in one.label:
        assert fall.stretch == pytest.approx(one.label["dynamic_elongation"].value, rel=1e-3)


@pytest.mark.parametrize("name", [n for n in names() if rope(n).relaxing_EA])
def test_a_label_is_in_the_rope_that_relaxes(name: str) -> None:
    """Force and stretch of the fall, and the elongation at rest."""
    from ropewalk.theory import rope_at_rest, solid_fall

    made, label = rope(name).material(use="relaxing"), rope(name).label
    assert made.relaxing_EA is not None
    assert made.relaxation_time is not None
    fall = solid_fall(made.EA, made.relaxing_EA, made.relaxation_time, 80.0)
    assert fall.force == pytest.approx(label["impact_force"].value, rel=1e-3)
    assert fall.stretch == pytest.approx(label["dynamic_elongation"].value, rel=1e-3)
    at_rest = rope_at_rest(label["static_elongation"].value, 80.0 * 9.81)
    assert at_rest == pytest.approx(made.EA, rel=5e-4)
    assert made.axial_damping == 0.0


def test_search_and_an_unknown_name() -> None:
    assert [one.name for one in search("9.8 edelrid")] == ["dynamic-single-9.8"]
    assert search("no such thing") == []
    with pytest.raises(rw.UnknownRope, match='did you mean "wire-7x19-10"'):
        rope("wire7x19-10")


def test_what_a_material_takes() -> None:
    single = rw.rope("dynamic-single-9.8")
    made = single.material()
    assert (made.EA, made.mass_per_length) == (single.EA, single.mass_per_length)
    assert made.axial_damping == single.axial_damping
    assert (made.EI, made.breaking_load) == (0.0, None)  # guesses
    full = single.material(guesses=True, bending=True)
    assert (full.EI, full.breaking_load) == (single.EI, single.breaking_load)
    still = single.material(use="static")
    assert (still.EA, still.axial_damping) == (single.EA_static, 0.0)
    with pytest.raises(ValueError, match="not known how wire-7x19-10 relaxes"):
        rw.rope("wire-7x19-10").material(use="relaxing")
    with pytest.raises(ValueError, match="only a guess"):
        single.material(bending=True)
    with pytest.raises(ValueError, match="one EA only"):
        rw.rope("wire-7x19-10").material(use="static")
    with pytest.raises(ValueError, match="must be"):
        single.material(use="wet")  # type: ignore[arg-type]
    piece = single.cut(12.0, 48)
    assert (piece.diameter, piece.length, piece.made_of) == (0.0098, 12.0, made)


TEXT = """
[[rope]]
segments = 10
length = 5.0
made_of = "dynamic-single-9.8"
[[anchor]]
node = 0
"""


def test_a_scene_names_a_rope_and_keeps_its_numbers() -> None:
    scene = loads(TEXT)
    single = rope("dynamic-single-9.8")
    assert scene.ropes[0].made_of == single.material()
    assert scene.ropes[0].diameter == single.diameter
    text = dumps(scene)
    assert loads(text) == scene
    # A later library with other numbers changes nothing of a scene that is whole.
    other = re.sub(r"EA = .*", "EA = 12345.0", text)
    assert loads(other).ropes[0].made_of.EA == 12345.0
    assert "changed here: EA" in origin_words(loads(other).ropes[0].made_of)
    assert "changed" not in origin_words(scene.ropes[0].made_of)


def test_a_table_takes_what_it_leaves_out_and_the_schema_knows() -> None:
    import tomllib

    table = 'made_of = { library = "wire-7x19-6", axial_damping = 200.0 }'
    for given in (TEXT, TEXT.replace('made_of = "dynamic-single-9.8"', table)):
        jsonschema.validate(tomllib.loads(given), schema())
    made = loads(TEXT.replace('made_of = "dynamic-single-9.8"', table)).ropes[0].made_of
    assert made.EA == rope("wire-7x19-6").EA
    assert made.axial_damping == 200.0
    assert origin_words(made) == "wire-7x19-6 of the library; changed here: axial_damping"
    assert origin(rw.Material(EA=1.0, mass_per_length=1.0)) is None
    gone = rw.Material(EA=1.0, mass_per_length=1.0, library="sold-out")
    assert "this library has not" in origin_words(gone)


def test_overrides_take_numbers_diameter_and_origin_together() -> None:
    scene = apply_overrides(loads(TEXT), ["rope.made_of=wire-7x19-10"])
    wire = rope("wire-7x19-10")
    assert scene.ropes[0].made_of == wire.material()
    assert scene.ropes[0].diameter == wire.diameter
    for given in (f"{BY_KEY}=wire-7x19-10", 'rope.made_of={library="wire-7x19-10"}'):
        by_key = apply_overrides(loads(TEXT), [given])
        assert by_key.ropes[0].made_of == wire.material()
        assert by_key.ropes[0].diameter == wire.diameter


def test_another_library_of_a_material_takes_the_old_numbers_away() -> None:
    """They stood under the new name: 25 kN for the EA of a rope of 1177 kN."""
    old, new = (Material(library=name) for name in ("dynamic-single", "hmpe-12strand-6"))
    assert old.replace(library=new.library) == new
    assert old.replace(EA=5e4, library=new.library) == new.replace(EA=5e4)
    assert old.replace(library="").EA == old.EA
    scene = loads(TEXT)
    assert scene.ropes[0].replace(made_of=new).diameter == scene.ropes[0].diameter


@pytest.mark.parametrize("made_of", ["wire-7x19-10", rope("wire-7x19-10")])
def test_another_rope_brings_its_diameter_in_python_too(made_of: Any) -> None:
    scene, wire = loads(TEXT), rope("wire-7x19-10")
    assert scene.ropes[0].replace(made_of=made_of).diameter == wire.diameter
    assert scene.ropes[0].replace(made_of=made_of, diameter=0.5).diameter == 0.5
    assert scene.ropes[0].replace(segments=9).diameter == rope("dynamic-single-9.8").diameter
    assert scene.replace(**{"rope.made_of": made_of}).ropes[0].diameter == wire.diameter


@pytest.mark.parametrize("key", ["rope[0].made_of", BY_KEY])
@pytest.mark.parametrize("order", [1, -1])
def test_what_is_changed_beside_another_rope_holds_in_any_order(key: str, order: int) -> None:
    """The rope's numbers took the place of what stood before them."""
    given = ["rope.diameter=20 mm", "rope.made_of.axial_damping=500", f"{key}=wire-7x19-10"]
    changed = apply_overrides(loads(TEXT), given[::order]).ropes[0]
    wire = rope("wire-7x19-10").material()
    assert changed.made_of == wire.replace(axial_damping=500.0)
    assert changed.diameter == 0.020
    pairs = dict([("rope.made_of.axial_damping", 500.0), (key, "wire-7x19-10")][::order])
    made = Places(loads(TEXT), pairs) if key.endswith("library") else None
    if made is not None:
        assert made.scene(list(pairs.values())).ropes[0].made_of == changed.made_of
    other = rw.Rope(segments=3, made_of="human-hair", length=1.0)
    whole = loads(TEXT).replace(**{"ropes": [other], "anchors": [], key: "wire-7x19-10"})
    assert whole.ropes[0].made_of == wire  # a list set whole stays before what is changed in it


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ('made_of = "dynamic-singel"', 'rope[0].made_of: "dynamic-singel" - no such rope in the library'),
        ('made_of = "wire-7x19-10:static"', "has one EA only"),
        ('made_of = { library = "zzzz" }', "rope[0].made_of.library"),
    ],
)  # fmt: skip
def test_what_is_not_there_is_refused(given: str, words: str) -> None:
    with pytest.raises(SceneError, match=re.escape(words)):
        loads(TEXT.replace('made_of = "dynamic-single-9.8"', given))


def test_a_run_folder_says_where_the_numbers_are_from(tmp_path) -> None:  # type: ignore[no-untyped-def]
    scene = loads(TEXT + "[run]\nduration = 0.02\n").replace(**{"rope.made_of.axial_damping": 1.0})
    done = rw.open(rw.run(scene, tmp_path / "run").folder)
    about = done.facts.provenance["ropes_of_the_library"]["rope"]
    assert about["library"] == "dynamic-single-9.8"
    assert about["numbers"]["EA"]["source"] == "A1"
    assert about["changed"] == ["axial_damping"]


def test_what_no_source_gives_of_falls_is_said_with_the_rope() -> None:
    (falls,) = rope("dynamic-single-9.8").doubts
    assert "first fall" in falls
    assert "friction no source gives" in falls
    for name in ("dynamic-half-8", "dynamic-twin-7.7"):
        assert rope(name).doubts[0] == falls
        assert "No label of a half or a twin rope" in rope(name).doubts[1]
    assert rope("wire-7x19-12").doubts == ()
    assert rope("semistatic-10.5").doubts == ()


def test_a_climbing_rope_that_hangs_by_its_label_is_no_slip() -> None:
    """80 kg stretch it by a tenth, as they should. The twins: 160 kg, and the same EA typed by hand."""

    def said(scene: rw.Scene) -> list[str]:
        warnings = rw.check(scene, measure=False).warnings
        return [text for text in warnings if "at rest it is stretched by" in text]

    fall = rw.preset("climbing-fall")
    assert said(fall) == []
    assert "a load too large for this rope" in said(fall.replace(**{"rope.load.mass": 160.0}))[0]
    own = rw.Material(EA=fall.ropes[0].made_of.EA, mass_per_length=0.061)
    assert "kN typed as N" in said(fall.replace(**{"rope.made_of": own}))[0]


def test_sources_are_plain_text() -> None:
    """One had backticks, which consoles and sheets print as they are."""
    assert not any("`" in text for text in sources().values())


@pytest.mark.parametrize("name", [one for one in names() if one.startswith("semistatic")])
def test_a_semi_static_rope_is_as_long_under_50_and_150_kg_as_its_note_says(name: str) -> None:
    """3 and 5 % are of the length under 50 kg; EA was that of the unloaded one, 1.5 and 2.5 % too large."""
    size = (rope(name).diameter / 0.0105) ** 2  # the loads go with the section
    at_50, at_150 = (9.81 * mass * size for mass in (50.0, 150.0))
    number = rope(name).numbers["EA"]
    for EA, longer in ((number.value, 0.03), (number.low, 0.05)):
        assert (at_150 - at_50) / (EA + at_50) == pytest.approx(longer, rel=2e-3)


def test_averages_and_yielding_are_told_where_numbers_are_used() -> None:
    """They stood in notes: an average took the place of a breaking load, and hair stretched to 6 %."""
    assert rope("arborist-rigging-12.7").material().breaking_load is None
    line = rw.line(20.0, 0.0, "arborist-rigging-12.7", sag="2 %")
    assert "guessed 46.26 kN, at least 39.1 kN" in str(line)
    hair = rw.Rope(
        segments=1, length=0.1, made_of="human-hair", shape={"kind": "straight", "direction": (0, 0, -1)},
        loads=[rw.Load(node=-1, mass=0.03)],
    )  # fmt: skip
    told = rw.check(rw.Scene(ropes=[hair], anchors=[rw.Anchor(node=0)]), measure=False).warnings
    assert any("beyond what the EA of human-hair is right for (2 %" in text for text in told)
