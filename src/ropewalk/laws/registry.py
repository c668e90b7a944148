"""All laws: the one list of them."""

from __future__ import annotations

from collections import namedtuple
from typing import Any

from ropewalk.laws.air import AIR
from ropewalk.laws.curved import CURVE
from ropewalk.laws.elastic_law import ElasticLaw
from ropewalk.laws.ground import GROUND
from ropewalk.laws.node_law import NodeLaw
from ropewalk.laws.obstacle import OBSTACLE
from ropewalk.laws.pairs.law import CONTACT
from ropewalk.laws.parting import PARTING
from ropewalk.laws.relaxing import SOLID
from ropewalk.laws.slides.sliding import SLIDE

#: Laws of segments that act beside the spring's, see `segment_law`.
SEGMENT_LAWS: tuple[NodeLaw, ...] = ()

#: Forces are summed and works recorded in this order.
NODE_LAWS: tuple[NodeLaw, ...] = (AIR, GROUND, OBSTACLE, CONTACT, PARTING, SLIDE, *SEGMENT_LAWS)

#: Laws of a segment's tension where it is not Hooke's, see `elastic_law`.
ELASTIC_LAWS: tuple[ElasticLaw, ...] = (CURVE, SOLID)

NAMES = tuple(law.name for law in NODE_LAWS)
_named: Any = namedtuple  # mypy wants the names in letters
NodeTables: Any = _named("NodeTables", NAMES, module=__name__)  # of `System.node`
NodeArrays: Any = _named("NodeArrays", NAMES, module=__name__)  # of forces, works and memories
ElasticTables: Any = _named(
    "ElasticTables", tuple(law.name for law in ELASTIC_LAWS), module=__name__
)  # of `System.elastic.table`
