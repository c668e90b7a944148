"""What a sweep is, before it has any results: recipe, design, what is kept, how it is cut in batches."""

from __future__ import annotations

import math
import uuid
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ropewalk.sweeps.batch import Recipe
from ropewalk.sweeps.keep import Kept, parse

FORMAT = 4
#: Formats that can be read: 1 had chunks of values as small as a batch, and no copies of them; 2 had no
#: checksum and no copy of what was asked, and marks that plain xarray took for data; 3 had no notes.
READS = (1, 2, 3, FORMAT)
_PIECE = 65536  # runs whose values lie in one chunk, about


@dataclass(frozen=True)
class Variable:
    """One thing kept, with its dimensions as the answer has them."""

    name: str
    text: str
    dims: tuple[str, ...]
    sizes: tuple[int, ...]
    unit: str
    long_name: str

    @property
    def numbers(self) -> int:
        """Numbers per run."""
        return math.prod(self.sizes)

    @property
    def attributes(self) -> dict[str, str]:
        """What the variable says about itself."""
        return {"units": self.unit, "long_name": self.long_name, "keep": self.text}


@dataclass(frozen=True)
class SweepPlan:
    """A sweep that can be begun, or gone on with; plain data."""

    title: str
    recipe: Recipe
    parameters: tuple[dict[str, Any], ...]  # `Parameter.described`
    design: str
    shape: tuple[int, ...]  # of the grid; (runs,) else
    runs: int
    batch: int  # runs
    variables: tuple[Variable, ...]
    coordinates: Mapping[str, dict[str, Any]]  # by dimension: values, attributes
    provenance: Mapping[str, Any]
    seed: int | None = None
    labels: tuple[dict[str, Any], ...] = ()  # `Label.described`
    id: str = field(default_factory=lambda: uuid.uuid4().hex)
    format: int = FORMAT

    @property
    def piece(self) -> int:
        """Runs whose values lie in one chunk: whole batches."""
        if self.format == 1:
            return self.batch
        return self.batch * min(max(1, _PIECE // self.batch), self.batches)

    @property
    def has_notes(self) -> bool:
        """Whether it is kept what the table of each run warns of."""
        return self.format > 3

    @property
    def pieces(self) -> int:
        """Number of chunks that the values of a parameter lie in."""
        return -(-self.runs // self.piece)

    @property
    def batches(self) -> int:
        """Number of batches."""
        return -(-self.runs // self.batch)

    def rows(self, number: int) -> range:
        """Return the numbers of the runs of a batch."""
        return range(number * self.batch, min((number + 1) * self.batch, self.runs))

    @property
    def columns(self) -> list[str]:
        """Names of what was given for the runs: parameters, then labels."""
        return [about["name"] for about in (*self.parameters, *self.labels)]

    @property
    def run_bytes(self) -> int:
        """What is kept of one run [bytes], texts left out."""
        return 8 * (1 + len(self.columns) + sum(v.numbers for v in self.variables))

    @property
    def keep(self) -> tuple[Kept, ...]:
        """What is kept."""
        return tuple(parse(text) for text in self.recipe.keep)

    def plain(self) -> dict[str, Any]:
        """Return it as plain data for JSON."""
        return {
            "format": self.format,
            "id": self.id,
            "title": self.title,
            "recipe": self.recipe.plain(),
            "parameters": list(self.parameters),
            "labels": list(self.labels),
            "design": self.design,
            "seed": self.seed,
            "shape": list(self.shape),
            "runs": self.runs,
            "batch": self.batch,
            "variables": [
                vars(v) | {"dims": list(v.dims), "sizes": list(v.sizes)} for v in self.variables
            ],
            "coordinates": dict(self.coordinates),
            "provenance": dict(self.provenance),
        }

    @classmethod
    def of(cls, plain: Mapping[str, Any]) -> SweepPlan:
        """Return what `plain` gave. Raises KeyError, TypeError for something else."""
        return cls(
            title=plain["title"],
            recipe=Recipe.of(plain["recipe"]),
            parameters=tuple(plain["parameters"]),
            labels=tuple(plain.get("labels", ())),
            design=plain["design"],
            shape=tuple(plain["shape"]),
            runs=int(plain["runs"]),
            batch=int(plain["batch"]),
            variables=tuple(
                Variable(**(v | {"dims": tuple(v["dims"]), "sizes": tuple(v["sizes"])}))
                for v in plain["variables"]
            ),
            coordinates=plain["coordinates"],
            provenance=plain["provenance"],
            seed=plain["seed"],
            id=plain["id"],
            format=int(plain["format"]),
        )


def rows_of(columns: list[np.ndarray[Any, Any]]) -> list[list[Any]]:
    """Return columns of values as rows of plain Python values."""
    return [list(row) for row in zip(*(column.tolist() for column in columns), strict=True)]
