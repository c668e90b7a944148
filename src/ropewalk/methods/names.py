"""The names of all methods, a line each: what the scene knows of them before any kernel is loaded.

An implicit method that `implicit_methods` does not make is the `METHOD` of a file of its own in this folder,
called as the method, with underscores.
"""

from __future__ import annotations

from typing import Literal

Explicit = Literal["euler", "semi-implicit-euler", "verlet", "heun", "rk4"]
Implicit = Literal[
    "implicit-euler",
    "implicit-midpoint",
    "bdf2",
    "sdirk2",
    "esdirk3",
    "generalized-alpha",
    "adaptive",
]
Method = Literal[Explicit, Implicit, "auto"]
