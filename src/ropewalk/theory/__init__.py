"""Closed forms: shapes of hanging cables and chains, frequencies of strings, cables and chains.

Each with formula, source and units; none of it knows of scenes. Angular frequencies are in rad/s.
"""

from __future__ import annotations

from ropewalk.theory.cable import Cable
from ropewalk.theory.cable_modes import (
    cable_frequencies,
    cable_parameter,
    hanging_frequencies,
    rigid_chain_frequencies,
    string_frequencies,
)
from ropewalk.theory.catenary import catenary
from ropewalk.theory.chain import Hung, hanging_chain, lumped_chain
from ropewalk.theory.chain_modes import (
    chain_decay_times,
    chain_factors,
    chain_frequencies,
    chain_shape,
)
from ropewalk.theory.edge_fall import EdgeFall, edge_fall, harder_by, solid_from_edge_fall
from ropewalk.theory.elastic_catenary import elastic_catenary
from ropewalk.theory.fall import Fall, rope_fall, rope_from_fall
from ropewalk.theory.parabola import Parabola, parabola
from ropewalk.theory.solid_fall import SolidFall, solid_fall, solid_from_fall
from ropewalk.theory.static_elongation import rope_at_rest

__all__ = [
    "Cable",
    "EdgeFall",
    "Fall",
    "Hung",
    "Parabola",
    "SolidFall",
    "cable_frequencies",
    "cable_parameter",
    "catenary",
    "chain_decay_times",
    "chain_factors",
    "chain_frequencies",
    "chain_shape",
    "edge_fall",
    "elastic_catenary",
    "hanging_chain",
    "hanging_frequencies",
    "harder_by",
    "lumped_chain",
    "parabola",
    "rigid_chain_frequencies",
    "rope_at_rest",
    "rope_fall",
    "rope_from_fall",
    "solid_fall",
    "solid_from_edge_fall",
    "solid_from_fall",
    "string_frequencies",
]
