"""One batch of runs: plain data in, plain arrays out, the same wherever and whenever it is made."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ropewalk.api import explain
from ropewalk.core.arrays import Floats
from ropewalk.engine.spare import Spare
from ropewalk.lowering import Model
from ropewalk.record.facts import AT_REST, FINISHED
from ropewalk.record.note_kinds import BETWEEN, kinds
from ropewalk.record.rest import rest_result
from ropewalk.record.result import Result
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Scene, SceneError, dumps, loads
from ropewalk.simulation import Simulation
from ropewalk.statics import NoRest
from ropewalk.sweeps.identity import sweep_hash
from ropewalk.sweeps.keep import Kept, parse
from ropewalk.sweeps.parameters import Parameter
from ropewalk.sweeps.workshop import Workshop

REFUSED, NO_REST, FAILED = "refused", "no rest", "failed"
GOOD = (FINISHED, AT_REST)
RUN, REST = "run", "rest"


@dataclass(frozen=True)
class Recipe:
    """All that a run of a sweep needs but its values; plain data."""

    scene: str  # TOML
    paths: tuple[str, ...]
    kinds: tuple[str, ...]
    keep: tuple[str, ...]
    sizes: tuple[tuple[int, ...], ...]  # of what is kept, largest of all runs
    what: str = RUN  # or REST: the equilibrium, without a run
    source: str = ""  # hash of the sources that make the bits

    def plain(self) -> dict[str, Any]:
        """Return it as plain lists, numbers and texts."""
        return {
            "scene": self.scene,
            "paths": list(self.paths),
            "kinds": list(self.kinds),
            "keep": list(self.keep),
            "sizes": [list(size) for size in self.sizes],
            "what": self.what,
            "source": self.source,
        }

    @classmethod
    def of(cls, plain: Mapping[str, Any]) -> Recipe:
        """Return what `plain` gave."""
        return cls(
            scene=plain["scene"],
            paths=tuple(plain["paths"]),
            kinds=tuple(plain["kinds"]),
            keep=tuple(plain["keep"]),
            sizes=tuple(tuple(size) for size in plain["sizes"]),
            what=plain["what"],
            source=plain["source"],
        )


def make_recipe(
    scene: Scene, parameters: Sequence[Parameter], variables: Sequence[Any], what: str
) -> Recipe:
    """Return the recipe of a sweep; `variables` are what is kept (`plan.Variable`)."""
    return Recipe(
        scene=dumps(scene),
        paths=tuple(p.path for p in parameters),
        kinds=tuple(p.kind for p in parameters),
        keep=tuple(v.text for v in variables),
        sizes=tuple(v.sizes for v in variables),
        what=what,
        source=sweep_hash(),
    )


@dataclass
class Batch:
    """What a batch of runs led to, one row per run."""

    status: list[str] = field(default_factory=list)
    reason: list[str] = field(default_factory=list)
    broke_at: list[float] = field(default_factory=list)  # [s]; NaN for a good run
    kept: dict[str, Floats] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)  # kinds of what a run's table warns of

    @property
    def broken(self) -> int:
        """Number of broken runs."""
        return sum(status not in GOOD for status in self.status)

    def append(self, more: Batch) -> None:
        """Take the runs of another batch, after those that are here."""
        self.status += more.status
        self.reason += more.reason
        self.broke_at += more.broke_at
        self.notes += more.notes
        for name, array in more.kept.items():
            here = self.kept.get(name)
            self.kept[name] = array if here is None else np.concatenate([here, array])

    def arrays(self) -> dict[str, Any]:
        """Return the columns by name: lists of texts, arrays of numbers; `status` is the last one."""
        notes = self.notes or [""] * len(self.status)
        texts = {"reason": self.reason, "notes": notes, "status": self.status}
        return self.kept | {"broke_at": np.array(self.broke_at)} | texts


class Batcher:
    """Makes runs of one recipe."""

    def __init__(self, recipe: Recipe) -> None:
        self.recipe = recipe
        self.keep: tuple[Kept, ...] = tuple(parse(text) for text in recipe.keep)
        self._workshop = Workshop(
            loads(recipe.scene), recipe.paths, recipe.kinds, stepped=recipe.what != REST
        )
        self._spare = Spare()

    def make(self, rows: Sequence[Sequence[Any]]) -> Batch:
        """Make the runs of these values; a run that breaks is a row like others, its values NaN."""
        batch = Batch()
        sizes = zip(self.keep, self.recipe.sizes, strict=True)
        batch.kept = {kept.name: np.full((len(rows), *size), math.nan) for kept, size in sizes}
        for number, row in enumerate(rows):
            status, why, broke_at = self._one(number, row, batch.kept)
            good = status in GOOD
            batch.status.append(status)
            batch.reason.append("" if good else why)
            batch.notes.append(why if good else "")
            batch.broke_at.append(broke_at)
        return batch

    def _one(
        self, number: int, row: Sequence[Any], out: Mapping[str, Floats]
    ) -> tuple[str, str, float]:
        """Make one run, write what is kept of it; return status, why it broke, and when [s].

        Of one that ended well what there is to note of it, in place of a reason.
        """
        try:
            result = self.run(row)
            if result.status in GOOD:
                for kept in self.keep:
                    value, _ = kept.of(result)
                    _put(out[kept.name][number, ...], value, kept)
                return result.status, BETWEEN.join(kinds(result)), math.nan
            return result.status, result.diagnosis, result.broke_at
        except SceneError as error:
            return REFUSED, str(error), math.nan
        except NoRest as error:
            return NO_REST, str(error), math.nan
        except MemoryError:
            raise
        except Exception as error:  # the sweep goes on; the run tells
            for kept in self.keep:
                out[kept.name][number, ...] = math.nan
            return FAILED, f"{type(error).__name__}: {error}", math.nan

    def run(self, row: Sequence[Any]) -> Result:
        """Make the run (or the equilibrium) of these values. Raises SceneError, NoRest."""
        return result_of(self._workshop.model(row), self.recipe.what, self._spare)

    def compile(self, row: Sequence[Any]) -> None:
        """Have the kernels compiled that the run of these values calls. Raises SceneError, NoRest."""
        model = self._workshop.model(row)
        if self.recipe.what == REST:
            rest_result(model)
        else:
            with np.errstate(all="ignore"):
                Simulation(model).advance_steps(1)

    def scene(self, row: Sequence[Any]) -> Scene:
        """Return the scene of these values. Raises SceneError."""
        return self._workshop.scene(row)


def result_of(model: Model, what: str, spare: Spare | None = None) -> Result:
    """Return the run of a model, or its equilibrium; `spare` has arrays that it may work in."""
    if what == REST:
        return rest_result(model)
    with np.errstate(all="ignore"):
        return simulate_in_memory(model, explain=explain, spare=spare)


def _put(out: Floats, value: Floats, kept: Kept) -> None:
    """Write a run's value where it belongs; what a shorter run lacks stays NaN."""
    if any(have > room for have, room in zip(value.shape, out.shape, strict=True)):
        shape = " x ".join(map(str, value.shape))
        raise ValueError(f"{kept.text} is {shape} here, larger than in the runs tried beforehand")
    out[tuple(slice(0, size) for size in value.shape)] = value
