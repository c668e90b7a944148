"""Curves of tension against strain: their pieces, the scene that has them, and what is said of bad ones."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import Chebyshev, Polynomial

import ropewalk as rw
from ropewalk.analysis.strains import words_of_curve
from ropewalk.live import pictures
from ropewalk.live.lab import lab_scene
from ropewalk.lowering import build
from ropewalk.scene import (
    Anchor,
    ExponentialCurve,
    Material,
    NeoHookeanCurve,
    PolynomialCurve,
    Rope,
    Scene,
    SceneError,
    TableCurve,
    schema,
)
from ropewalk.scene.tension_curves import CurveModel
from ropewalk.theory.curve import at_strain, at_tension, pieces_of

LINE = 0.1  # kg/m


def material(curve: Any, **more: Any) -> Material:
    return Material(**({"curve": curve, "mass_per_length": LINE} | more))


def scene(made_of: Material) -> Scene:
    return Scene(ropes=[Rope(segments=4, length=2.0, made_of=made_of)], anchors=[Anchor(node=0)])


def said(**fields: Any) -> str:
    with pytest.raises(SceneError) as error:
        Material(**({"mass_per_length": LINE} | fields))
    return str(error.value)


tables = st.lists(
    st.tuples(st.floats(-2.0, 0.0), st.floats(-2.0, 1.5)), min_size=1, max_size=8
).map(lambda steps: np.cumsum(10.0 ** np.array([(0.0, 0.0), *steps]), axis=0) - 1.0)


@given(tables)
def test_any_rising_table_makes_a_smooth_rising_curve_that_can_be_inverted(points: Any) -> None:
    strain, tension = points.T
    pieces = pieces_of(strain, tension)
    secant = np.diff(tension) / np.diff(strain)
    assert pieces[:, 2].min() >= 0.499 * secant.min()
    assert pieces[:, 2].max() <= 2.001 * secant.max()
    np.testing.assert_allclose(at_strain(pieces, strain)[0], tension, rtol=1e-9, atol=1e-9)
    at = np.linspace(-0.1, 1.3 * strain[-1], 200)
    T, slope, _ = at_strain(pieces, at)
    assert np.all(np.diff(T) > 0.0)
    back, same = at_tension(pieces, T)
    np.testing.assert_allclose(back, at, rtol=1e-8, atol=1e-9)
    np.testing.assert_allclose(same, slope, rtol=1e-6)
    below, above = (at_strain(pieces, pieces[1:, 0] + h) for h in (-1e-12, 1e-12))
    np.testing.assert_allclose(below[1], above[1], rtol=1e-6, atol=1e-6 * secant.max())


@pytest.mark.parametrize("shape", [(), (6,), (2, 3), (3, 2), (1, 2, 3)])
def test_curves_are_looked_up_in_arrays_of_any_shape(shape: tuple[int, ...]) -> None:
    pieces = material([(0.05, 500.0), (0.1, 800.0), (0.4, 9000.0)]).curve.pieces  # type: ignore[union-attr]
    at = np.linspace(-0.02, 0.45, math.prod(shape)).reshape(shape)
    found = (*at_strain(pieces, at), *at_tension(pieces, 1e4 * at))
    for i in np.ndindex(shape):
        one = (*at_strain(pieces, at[i]), *at_tension(pieces, 1e4 * at[i]))
        assert [many[i] for many in found] == list(one)


def test_tension_is_the_derivative_of_the_energy() -> None:
    pieces = material([(0.05, 500.0), (0.1, 800.0), (0.4, 9000.0)]).curve.pieces  # type: ignore[union-attr]
    at, h = np.linspace(-0.05, 0.5, 111), 1e-5
    (_, _, ahead), (_, _, behind) = at_strain(pieces, at + h), at_strain(pieces, at - h)
    T, slope, _ = at_strain(pieces, at)
    np.testing.assert_allclose((ahead - behind) / (2.0 * h), T, atol=1e-3)
    (more, _, _), (less, _, _) = at_strain(pieces, at + h), at_strain(pieces, at - h)
    np.testing.assert_allclose((more - less) / (2.0 * h), slope, atol=1.0)


@pytest.mark.parametrize(
    ("curve", "law", "order"),
    [
        (NeoHookeanCurve(EA=30.0, largest_strain=4.0), lambda s: 10.0 * (s - s**-2), 1e-4),
        (
            ExponentialCurve(EA=1e4, growth=12.0, largest_strain=0.3),
            lambda s: 1e4 / 12.0 * np.expm1(12.0 * (s - 1.0)),
            1e-6,
        ),
        (
            PolynomialCurve(coefficients=(1e4, 0.0, 5e4), largest_strain=0.5),
            lambda s: 1e4 * (s - 1.0) + 5e4 * (s - 1.0) ** 3,
            1e-6,
        ),
    ],
)  # fmt: skip
def test_named_laws_are_their_formulas(curve: CurveModel, law: Any, order: float) -> None:
    end, T = curve.end
    at = np.linspace(0.0, end, 1001)
    np.testing.assert_allclose(curve.tension_at(at), law(1.0 + at), atol=order * T)
    slope = (curve.tension_at(1.1 * end) - T) / (0.1 * end)  # beyond, straight
    assert slope == pytest.approx((law(1.0 + end) - law(1.0 + end - 1e-6)) / 1e-6, rel=1e-3)


def test_points_of_a_quadratic_give_that_quadratic() -> None:
    at = np.linspace(0.0, 0.4, 5)
    table = TableCurve(strain=at.tolist(), tension=(1e4 * at + 2e4 * at**2).tolist())
    fine = np.linspace(0.0, 0.4, 77)
    np.testing.assert_allclose(table.tension_at(fine), 1e4 * fine + 2e4 * fine**2, atol=1e-9)


def test_a_straight_curve_is_EA() -> None:
    """The engine then knows of no curve, so that all bits are those of EA; a bent one it does know."""
    straight = material([(0.1, 1000.0), (0.2, 2000.0), (0.4, 4000.0)])
    assert straight.EA == 1e4
    system = build(scene(straight)).system
    assert system.elastic.time.size == 0
    assert build(scene(material([(0.1, 1000.0), (0.2, 2100.0)]))).system.elastic.time.size > 0


def test_EA_is_the_largest_slope_and_is_left_out_of_files() -> None:
    made_of = material({"kind": "polynomial", "coefficients": [1e4, 2e4], "largest_strain": 0.4})
    assert pytest.approx(2.6e4, rel=1e-12) == made_of.EA
    again = made_of.replace(curve=ExponentialCurve(EA=5e3, growth=3.0, largest_strain=0.2))
    assert pytest.approx(5e3 * np.exp(0.6)) == again.EA
    text = rw.dumps(scene(made_of))
    assert "EA" not in text
    assert rw.loads(text) == scene(made_of)
    assert "26 kN" in words_of_curve(scene(made_of).ropes[0])


def test_units_pairs_and_files(tmp_path: Path) -> None:
    plain = TableCurve(strain=(0.0, 0.1, 0.2), tension=(0.0, 1000.0, 3000.0))
    pairs = [[0, 0], ["10 %", "1 kN"], [0.2, "3 kN"]]
    assert material(pairs).curve == plain
    (tmp_path / "pull.csv").write_text("strain [1], tension [N]\n0, 0\n0.1, 1000\n0.2, 3000\n")
    text = """
[[rope]]
segments = 4
length = "2 m"
made_of = {kind = "material", mass_per_length = "100 g/m", curve = {kind = "table", file = "pull.csv"}}
"""
    found = rw.loads(text, folder=tmp_path).ropes[0].made_of
    assert isinstance(found, Material)
    assert found.curve == plain


def test_units_in_a_header_are_taken(tmp_path: Path) -> None:
    """A column of per cent and one of kN, as a pull test is written down."""
    plain = TableCurve(strain=(0.0, 0.1, 0.2), tension=(0.0, 1000.0, 3000.0))
    (tmp_path / "pull.csv").write_text("tension (kN);strain [%]\n0;0\n1;10\n3;20\n")
    context = {"folder": str(tmp_path)}
    found = TableCurve.model_validate({"file": "pull.csv"}, context=context)
    assert found.strain == pytest.approx(plain.strain, rel=1e-15)
    assert found.tension == pytest.approx(plain.tension, rel=1e-15)
    for header, words in (
        ("strain [%], tension [kg]", 'column tension: "kg" - is of another kind: a quantity in N'),
        (
            "strain [Prozent], tension [N]",
            'column strain: "Prozent" - has a unit that is not known',
        ),
    ):
        (tmp_path / "bad.csv").write_text(f"{header}\n0, 0\n10, 1000\n")
        with pytest.raises(SceneError) as error:
            rw.loads(
                """
[[rope]]
segments = 4
length = 2.0
made_of = {kind = "material", mass_per_length = 0.1, curve = {kind = "table", file = "bad.csv"}}
""",
                folder=tmp_path,
            )
        assert words in str(error.value)


def test_a_rope_of_the_library_may_have_a_curve_of_its_own() -> None:
    found = material([(0.2, 1000.0), (0.4, 3000.0)], library="dynamic-single-9.8")
    assert found.curve.slopes[2] == found.EA  # type: ignore[union-attr]
    filled = Material(library="dynamic-single-9.8", curve=[(0.2, 1000.0), (0.4, 3000.0)])
    assert filled.mass_per_length < 0.1
    assert filled.EA == found.EA


def wavy() -> dict[str, Any]:
    """A polynomial whose slope, 1 + a little and the Chebyshev polynomial T11, waves between parts."""
    slope = Chebyshev([1.0003] + [0.0] * 10 + [1.0], domain=[0.0, 1.0])
    law = 1e3 * slope.convert(kind=Polynomial, domain=[-1, 1], window=[-1, 1]).integ()
    return {"kind": "polynomial", "coefficients": list(law.coef[1:]), "largest_strain": 1.0}


WAVY = wavy()


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"curve": [(0.2, 900.0), (0.1, 1000.0)]}, "curve.strain[1]: 0.1 - must be greater"),
        ({"curve": [(0.1, 900.0), (0.2, 800.0)]}, "curve.tension[1]: 800.0 - must be greater"),
        ({"curve": [(0.1, 900.0), (0.2, 900.001)]}, "must rise everywhere by at least"),
        ({"curve": [(0.0, 5.0), (0.1, 900.0)]}, "must be 0 at strain 0"),
        ({"curve": [(-0.1, -5.0), (0.1, 900.0)]}, "must not be negative"),
        ({"curve": [(0.0, 0.0)]}, "must have a point beyond 0"),
        ({"curve": [(30.0, 900.0)]}, 'must be at most 20; 10 % are 0.1, or "10 %"'),
        ({"curve": [(0.1, "5 m")]}, "is of another kind: a quantity in N"),
        ({"curve": [1.0, 2.0]}, "must be a list of pairs [strain, tension]"),
        ({"curve": {"kind": "tabel"}}, 'did you mean "table"?'),
        ({"curve": {"kind": "table", "strain": [0.1]}}, "give strain and tension, or file"),
        ({"curve": [(0.2, 1000.0)], "EA": 4.0}, "leave it out with a curve: it is then its largest"),
        (
            {"curve": {"kind": "polynomial", "coefficients": [1e4, -3e4], "largest_strain": 0.4}},
            "take a smaller largest_strain",
        ),
        (
            {"curve": {"kind": "exponential", "EA": 1.0, "growth": 9.0, "largest_strain": 9.0}},
            "must be at most 1.023",
        ),
        ({"curve": WAVY}, "in one of the 64 parts that it is cut into"),
        ({"curve": [(1e-322, 1.0)]}, "curve.strain[0]: 1e-322 - must be at least 1e-12"),
        ({}, "EA: missing"),
    ],
)  # fmt: skip
def test_bad_curves_are_told_with_rule_and_remedy(fields: dict[str, Any], words: str) -> None:
    assert words in said(**fields)


def test_a_line_in_closed_form_refuses_a_curve() -> None:
    made_of = material([(0.1, 1000.0), (0.2, 3000.0)])
    with pytest.raises(SceneError, match="a line in closed form"):
        rw.line(10.0, 0.0, made_of, sag=0.1)


def test_the_live_view_takes_the_largest_strain_from_the_curve() -> None:
    """The twin: over the largest slope it would be told too small."""
    made_of = material([(0.1, 1000.0), (0.2, 3000.0)])
    model = build(scene(made_of))
    assert made_of.curve is not None
    pull = float(made_of.curve.tension_at(0.13))
    shown = SimpleNamespace(arrays=model.state, system=model.system)
    found = pictures._largest_strain(shown, np.full(4, pull))  # type: ignore[arg-type]
    assert found == pytest.approx(0.13, rel=1e-12)
    assert pull / made_of.EA < 0.1


def test_the_lab_refuses_a_curve() -> None:
    with pytest.raises(SceneError, match="the lab has no curves"):
        lab_scene(scene(material([(0.1, 1000.0), (0.2, 3000.0)])))


def test_the_schema_takes_a_curve_in_place_of_EA() -> None:
    ways = schema()["$defs"]["Material"]["anyOf"]
    assert {"required": ["curve", "mass_per_length"]} in ways


@pytest.mark.parametrize("strain", [0.1, 0.3, 0.57])
def test_the_largest_strain_that_is_told_is_possible(strain: float) -> None:
    """It was refused by the last bit, with the words that told it."""
    growth = np.log(1e4) / strain
    with pytest.raises(SceneError, match=f"must be at most {strain} with this growth"):
        ExponentialCurve(EA=1e3, growth=growth, largest_strain=1.0001 * strain)
    assert ExponentialCurve(EA=1e3, growth=growth, largest_strain=strain).largest_strain == strain
