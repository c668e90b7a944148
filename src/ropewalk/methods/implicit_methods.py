"""The implicit methods, one entry each, in the order of `names`."""

from __future__ import annotations

from typing import get_args

from ropewalk.methods.names import Implicit, of_name
from ropewalk.methods.tableaus import (
    BDF_2,
    ESDIRK3,
    IMPLICIT_EULER,
    IMPLICIT_MIDPOINT,
    SDIRK2,
    ImplicitMethod,
    generalized_alpha,
)

_MADE = (
    ImplicitMethod(
        "implicit-euler",
        1,
        IMPLICIT_EULER,
        "Implicit Euler; damps a lot.",
        holds_links=True,
    ),
    ImplicitMethod(
        "implicit-midpoint",
        2,
        IMPLICIT_MIDPOINT,
        "Implicit midpoint; symplectic without friction, keeps stiff modes ringing.",
    ),
    ImplicitMethod(
        "bdf2",
        2,
        BDF_2,
        "BDF2, one solve; damps fast modes, true tensions.",
        holds_links=True,
    ),
    ImplicitMethod(
        "sdirk2",
        2,
        SDIRK2,
        "Alexander's SDIRK2, L-stable; for moderate stiffness, see ADR 0011.",
    ),
    ImplicitMethod(
        "esdirk3",
        3,
        ESDIRK3,
        "Kennedy and Carpenter's ESDIRK3, L-stable, accurate.",
        holds_links=True,
    ),
    ImplicitMethod(
        "generalized-alpha",
        2,
        generalized_alpha(),
        "Generalized-alpha, one solve; damps fast modes as its spectral radius says.",
    ),
    ImplicitMethod(
        "adaptive",
        3,
        ESDIRK3,
        "ESDIRK3 in steps as long as the tolerance allows, cut at events.",
        holds_links=True,
        fixed=False,
    ),
)

IMPLICIT = tuple(of_name(name, _MADE) for name in get_args(Implicit))
