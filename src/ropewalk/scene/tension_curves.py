"""Curves of tension against strain, for ropes that no single EA describes.

Each is a `CurveModel`, of which `pieces` is all that the engine asks. The union at the end names them all.
"""

from __future__ import annotations

from abc import abstractmethod
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, TypeAdapter, ValidationError, ValidationInfo, model_validator

from ropewalk.scene.base import Many, Model, Number, Text, positive, refuse
from ropewalk.scene.csv_columns import folder_of
from ropewalk.scene.faults import MISSING, NO_VALUE, Fault
from ropewalk.scene.limits import HUGE
from ropewalk.theory.curve import at_strain, at_tension, is_straight, pieces_of, slope_range
from ropewalk.words.safe_side import rounded_down, within

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

_MOST_POINTS = 1000
_LARGEST_STRAIN = 20.0  # [1] rubber bears some 7
_LEAST_STRAIN = 1e-12  # [1] of a point: below, slopes are no numbers
_RATIO = 1e4  # [1] largest slope between two points over the least
_PARTS = 64  # into which a formula is cut; slopes at their ends are the formula's own

_Values = Many[Annotated[Number, Field(ge=-HUGE, le=HUGE, allow_inf_nan=False)]]


def _up_to(description: str = "Strain up to which it goes; beyond, it goes on straight") -> Any:
    return positive(description, "1", le=_LARGEST_STRAIN)


class CurveModel(Model):
    """A rising curve of tension against strain."""

    kind: str

    @abstractmethod
    def make_pieces(self) -> Floats:
        """Return the curve as quadratic pieces, see `theory.curve`, (p, 5)."""

    @property
    def pieces(self) -> Floats:
        """The curve as quadratic pieces, (p, 5): strain [1], tension, slope, bend [N], energy [J/m]."""
        return _made(self)

    @property
    def slopes(self) -> tuple[float, float, float]:
        """Slope at rest, least and largest slope [N]."""
        if is_straight(self.pieces):
            strain, tension = self.end
            return (tension / strain,) * 3
        return (float(self.pieces[0, 2]), *slope_range(self.pieces))

    @property
    def end(self) -> tuple[float, float]:
        """Strain [1] and tension [N] at its last point, beyond which it goes on straight."""
        return float(self.pieces[-1, 0]), float(self.pieces[-1, 1])

    def tension_at(self, strain: Any) -> Any:
        """Return the tension [N] at strains [1], of the same shape; without regard to `tension_only`."""
        return at_strain(self.pieces, strain)[0]

    def strain_at(self, tension: Any) -> Any:
        """Return the strain [1] at tensions [N], of the same shape."""
        return at_tension(self.pieces, tension)[0]

    def _formula(self, strain: float, tension: Any, slope: Any) -> Floats:
        """Return the pieces of a formula up to a strain, by its tensions and slopes there [N]."""
        at = np.linspace(0.0, strain, _PARTS + 1)
        return pieces_of(at, np.concatenate([[0.0], tension(at)[1:]]), slope(at))


@lru_cache(maxsize=256)
def _made(curve: CurveModel) -> Floats:
    pieces = curve.make_pieces()
    pieces.flags.writeable = False
    return pieces


class TableCurve(CurveModel):
    """Points of strain and tension, joined by a smooth curve that rises everywhere.

    The point 0, 0 may be left out. A CSV file with columns strain, tension is read at once; the scene no
    longer needs it.
    """

    kind: Literal["table"] = "table"
    file: Text | None = Field(
        default=None, description="CSV file with columns strain, tension (read at load)"
    )
    strain: _Values = Field(
        default=(),
        description="Rising strains: stretch over length",
        json_schema_extra={"unit": "1"},
    )
    tension: _Values = Field(
        default=(), description="Rising tension at each strain", json_schema_extra={"unit": "N"}
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any, info: ValidationInfo) -> Any:
        from ropewalk.scene.csv_columns import read_columns

        if not isinstance(data, dict) or not isinstance(data.get("file"), str):
            return data
        if "strain" in data or "tension" in data:
            refuse([Fault("file", NO_VALUE, "give either file or strain and tension")])
        strain, tension = read_columns(
            folder_of(info), data["file"], {"strain": "1", "tension": "N"}
        )
        rest = {key: value for key, value in data.items() if key != "file"}
        return rest | {"strain": strain, "tension": tension}

    @model_validator(mode="after")
    def _check(self) -> TableCurve:
        refuse(self._faults())
        return self

    def _faults(self) -> list[Fault]:
        e, T = self.strain, self.tension
        if not e or not T:
            return [
                Fault("tension" if e else "strain", MISSING, "give strain and tension, or file")
            ]
        if len(e) != len(T):
            rule = f"must have {len(e)} numbers, one for each strain"
            return [Fault("tension", f"{len(T)} numbers", rule)]
        if len(e) > _MOST_POINTS:
            return [Fault("strain", f"{len(e)} numbers", f"must be at most {_MOST_POINTS}")]
        if e[0] < 0.0:
            rule = (
                "must not be negative: a compressed rope goes on with the slope at 0, or is slack"
            )
            return [Fault("strain[0]", e[0], rule)]
        if e[0] == 0.0 and T[0] != 0.0:
            return [
                Fault("tension[0]", T[0], "must be 0 at strain 0: there the rope has its length")
            ]
        start = 1 if e[0] == 0.0 else 0
        if len(e) == start:
            return [Fault("strain", e, "must have a point beyond 0")]
        if e[start] < _LEAST_STRAIN:
            return [Fault(f"strain[{start}]", e[start], f"must be at least {_LEAST_STRAIN:g}")]
        if e[-1] > _LARGEST_STRAIN:
            rule = f'must be at most {_LARGEST_STRAIN:g}; 10 % are 0.1, or "10 %"'
            return [Fault(f"strain[{len(e) - 1}]", e[-1], rule)]
        faults = []
        for name, values in (("strain", e), ("tension", T)):
            last = 0.0
            for i in range(start, len(e)):
                if not values[i] > last:
                    rule = f"must be greater than the one before it ({last:g})"
                    faults.append(Fault(f"{name}[{i}]", values[i], rule))
                last = values[i]
        return faults or _ratio_fault("tension", *self._points())

    def _points(self) -> tuple[Floats, Floats]:
        """Return strains and tensions, from 0."""
        e, T = np.array(self.strain), np.array(self.tension)
        if e[0] > 0.0:
            e, T = np.concatenate([[0.0], e]), np.concatenate([[0.0], T])
        return e, T

    def make_pieces(self) -> Floats:
        """See `CurveModel.make_pieces`."""
        return pieces_of(*self._points())


def _ratio_fault(name: str, strain: Floats, tension: Floats) -> list[Fault]:
    """A fault where a curve is next to level, or next to upright."""
    secant = np.diff(tension) / np.diff(strain)
    if secant.max() <= _RATIO * secant.min():
        return []
    worst = int(secant.argmin())
    given = f"{secant[worst]:.3g} N per strain from {strain[worst]:g} to {strain[worst + 1]:g}"
    rule = (
        f"must rise everywhere by at least 1/{_RATIO:g} of its steepest part, {secant.max():.3g} N"
    )
    return [Fault(name, given, rule)]


class PolynomialCurve(CurveModel):
    """T = a1 e + a2 e^2 + a3 e^3 + ... of the strain e, which must rise up to the largest strain."""

    kind: Literal["polynomial"] = "polynomial"
    coefficients: _Values = Field(
        description="a1, a2, a3, ...; a1 is the slope at rest", json_schema_extra={"unit": "N"}
    )
    largest_strain: Number = _up_to()

    @model_validator(mode="after")
    def _check(self) -> PolynomialCurve:
        if not 1 <= len(self.coefficients) <= 12:
            rule = "must have 1 to 12 numbers"
            refuse([Fault("coefficients", f"{len(self.coefficients)} numbers", rule)])
        rising = np.polynomial.Polynomial([0.0, *self.coefficients]).deriv()
        ends = [0.0, self.largest_strain]
        turns = rising.deriv().roots() if rising.degree() > 0 else np.zeros(0)
        turns = turns[(np.abs(np.imag(turns)) < 1e-9) & (np.real(turns) > 0.0)].real
        at = np.array(ends + [float(e) for e in turns if e < self.largest_strain])
        slope = rising(at)
        if not slope.min() * _RATIO >= slope.max() or not slope.min() > 0.0:
            given = f"slope {slope.min():.4g} N at strain {at[slope.argmin()]:.4g}"
            rule = f"must rise everywhere by at least 1/{_RATIO:g} of its steepest part, "
            rule += f"{slope.max():.4g} N; take a smaller largest_strain, or a table"
            refuse([Fault("coefficients", given, rule)])
        least, largest = slope_range(self.make_pieces())
        if not least * _RATIO >= largest or not least > 0.0:
            given = f"slope {least:.4g} N in one of the {_PARTS} parts that it is cut into"
            rule = f"must rise everywhere by at least 1/{_RATIO:g} of its steepest part, "
            rule += f"{largest:.4g} N; take a smaller largest_strain, or a table"
            refuse([Fault("coefficients", given, rule)])
        return self

    def make_pieces(self) -> Floats:
        """See `CurveModel.make_pieces`."""
        law = np.polynomial.Polynomial([0.0, *self.coefficients])
        return self._formula(self.largest_strain, law, law.deriv())


class NeoHookeanCurve(CurveModel):
    """Rubber: T = EA/3 (s - 1/s^2), s = 1 + strain; softer the farther it is drawn.

    The incompressible neo-Hookean solid in tension (Treloar, The Physics of Rubber Elasticity, ch. 4).
    """

    kind: Literal["neo-hookean"] = "neo-hookean"
    EA: Number = positive("Slope at rest", "N")
    largest_strain: Number = _up_to()

    def make_pieces(self) -> Floats:
        """See `CurveModel.make_pieces`."""
        third = self.EA / 3.0
        return self._formula(
            self.largest_strain,
            lambda e: third * ((1.0 + e) - (1.0 + e) ** -2),
            lambda e: third * (1.0 + 2.0 * (1.0 + e) ** -3),
        )


class ExponentialCurve(CurveModel):
    """T = EA/b (exp(b e) - 1): stiffer the farther it is drawn, as crimped fibres and tendons are.

    Source: Fung, Am. J. Physiol. 213 (1967) 1532: the slope grows with the tension, dT/de = EA + b T.
    """

    kind: Literal["exponential"] = "exponential"
    EA: Number = positive("Slope at rest", "N")
    growth: Number = positive("b, by which the slope grows with the tension", "1")
    largest_strain: Number = _up_to()

    @model_validator(mode="after")
    def _check(self) -> ExponentialCurve:
        if not within(0.0, self.growth * self.largest_strain, np.log(_RATIO)):
            most = rounded_down(np.log(_RATIO) / self.growth, 4)
            rule = f"must be at most {most} with this growth: the slope there is {_RATIO:g} EA"
            refuse([Fault("largest_strain", self.largest_strain, rule)])
        return self

    def make_pieces(self) -> Floats:
        """See `CurveModel.make_pieces`."""
        b = self.growth
        return self._formula(
            self.largest_strain,
            lambda e: self.EA / b * np.expm1(b * e),
            lambda e: self.EA * np.exp(b * e),
        )


#: The JSON Schema of pairs of strain and tension, which stand for a table of them.
PAIRS_SCHEMA = {
    "type": "array",
    "items": {
        "type": "array",
        "prefixItems": [{"type": "number", "unit": unit} for unit in ("1", "N")],
        "minItems": 2,
        "maxItems": 2,
    },
}
Curve = Annotated[
    TableCurve | PolynomialCurve | NeoHookeanCurve | ExponentialCurve, Field(discriminator="kind")
]


def with_curve(data: Any, info: ValidationInfo) -> Any:
    """Give a material's mapping the EA that its curve has; a list of pairs stands for a table."""
    if not isinstance(data, dict) or data.get("curve") is None:
        return data
    curve, context = data["curve"], info.context
    if isinstance(curve, (list, tuple)):
        if not all(isinstance(pair, (list, tuple)) and len(pair) == 2 for pair in curve):
            rule = "must be a list of pairs [strain, tension], or a table with a kind"
            refuse([Fault("curve", NO_VALUE, rule)])
        strain, tension = ([pair[k] for pair in curve] for k in (0, 1))
        curve = {"kind": "table", "strain": strain, "tension": tension}
    try:
        made: CurveModel = TypeAdapter(Curve).validate_python(curve, context=context)
    except ValidationError:
        return {"EA": 1.0} | data | {"curve": curve}  # its own faults are told by the field
    return {"EA": made.slopes[2]} | data | {"curve": made}


def curve_fault(EA: float, curve: CurveModel) -> list[Fault]:
    """A fault where a material has a curve and another EA."""
    largest = curve.slopes[2]
    if abs(EA - largest) <= 1e-9 * largest:
        return []
    rule = f"leave it out with a curve: it is then its largest slope, {largest:.6g} N"
    return [Fault("EA", EA, rule)]
