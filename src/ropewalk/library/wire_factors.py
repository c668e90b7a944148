"""Steel wire rope from its construction and diameter.

    mass per length W d^2 (kg per 100 m, d in mm),   breaking load K d^2 R (N, d in mm, R in N/mm^2)
    EA = 100 d^2 / G (lbf, d in inches, G the stretch factor in % per lbf/in^2)

Sources: factors W and K of EN 12385-4 (tag F1 of the library), stretch factors of new rope (F2), and for
fibre cores coefficients of the kind that mooring programs have (D3). Of 7x19 W and K are those of one maker's
galvanised rope of grade 2070 (F3).

Of the strand 1x19 the stretch factors give EA, and with their metal area W; K is a guess: the area times what
is left of the wires' strength in the strand, 0.85 (0.80 to 0.92). Stainless strand is 10 % softer, and the
one breaking load that was read (F8) is 761 MPa d^2, the lower end with wires of 1570 N/mm^2. Of locked coil
rope no readable source was found: fill 0.85 (0.81 to 0.88), 83 kN/m^3, 160 GPa (150 to 170) on the metal, and
K, that with wires of 1570 N/mm^2 gives the 953 MPa d^2 that are recalled, are guesses.
"""

from __future__ import annotations

import re
from typing import NamedTuple


class WireFactors(NamedTuple):
    """Factors of a construction: `W` [kg/100 m/mm^2], `K` [1], `EA` over the diameter squared [Pa].

    A range is that of a factor that is a guess, None where it has a source; `guess` says that more than K is.
    `grade` is the strength of wires R [N/mm^2] where none is given.
    """

    W: float
    K: float
    EA: float
    K_range: tuple[float, float] | None = None
    W_range: tuple[float, float] | None = None
    EA_range: tuple[float, float] | None = None
    guess: str = ""
    grade: float = 1770.0


LOCKED_COIL = (
    "mass (within 5 %), EA (within 11 %) and breaking load (within 12 %) of locked coil rope are guesses, "
    "without a source"
)
WIRE = {
    "1x19": WireFactors(0.46857, 0.507, 98.8e9, (0.477, 0.549), grade=1570.0),
    "6x7 FC": WireFactors(0.345, 0.332, 36.7e9),
    "7x7": WireFactors(0.384, 0.388, 64.4e9),
    "7x19": WireFactors(0.3807, 0.331, 49.2e9),
    "6x19 FC": WireFactors(0.359, 0.330, 36.7e9),
    "6x19 IWRC": WireFactors(0.400, 0.356, 50.7e9),
    "6x36 FC": WireFactors(0.367, 0.330, 36.7e9),
    "6x36 IWRC": WireFactors(0.409, 0.356, 47.9e9),
    "locked coil": WireFactors(
        0.565, 0.605, 106.8e9, (0.54, 0.67), (0.54, 0.587), (95e9, 117e9), LOCKED_COIL, 1570.0
    ),
}


def wire_factors(construction: str) -> WireFactors:
    """Return the factors of a construction such as "6x36 IWRC"; case, space and dashes do not matter.

    Raises ValueError with those that are known.
    """

    def bare(text: str) -> str:
        return re.sub(r"[\s_-]", "", text).lower().replace("×", "x")

    found = {bare(name): factors for name, factors in WIRE.items()}.get(bare(str(construction)))
    if found is None:
        raise ValueError(
            f"construction: {construction!r} - must be one of {', '.join(WIRE)}; others stand in the library "
            "by their diameters: ropewalk ropes --family steel"
        )
    return found
