"""The ranges of a fit: what they may be, and their values as shares from 0 to 1."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.scene import Scene, SceneError
from ropewalk.scene.base import unit_of
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.scene.overrides import Places
from ropewalk.sweeps.parameters import without_units

_LOGARITHMIC = 20.0  # ends this far apart are searched by factors


@dataclass(frozen=True)
class Scale:
    """A parameter's range as 0 to 1, by factors where it is wide."""

    low: float
    high: float

    @property
    def logarithmic(self) -> bool:
        """Whether equal steps are equal factors."""
        return self.low > 0.0 and self.high / self.low >= _LOGARITHMIC

    def value(self, share: Any) -> Any:
        """Return the value at a share of the range."""
        if self.logarithmic:
            return self.low * (self.high / self.low) ** np.asarray(share)
        return self.low + np.asarray(share) * (self.high - self.low)

    def share(self, value: float) -> float:
        """Return the share of the range at a value."""
        if self.logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


def make_scales(scene: Scene, ranges: Mapping[str, Any]) -> dict[str, Scale]:
    """Return the ranges by path. Raises SceneError for those in which no scene can be found."""
    if not ranges:
        raise SceneError([Fault("ranges", NO_VALUE, "is empty: name at least one path to fit")])
    faults: list[Fault] = []
    made = {}
    for path, pair in ranges.items():
        try:
            low, high = (
                float(value) for value in without_units(path, pair, unit_of_path(scene, path))
            )
        except SceneError as error:
            faults += error.faults
            continue
        except (TypeError, ValueError):
            faults.append(Fault(path, str(pair), "must be a range (low, high)"))
            continue
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            faults.append(Fault(path, [low, high], "must be a range (low, high), low below high"))
            continue
        made[path] = Scale(low, high)
    if not faults:
        for path, scale in made.items():
            faults += _refused(scene, path, scale)
    if faults:
        raise SceneError(faults)
    return made


def unit_of_path(scene: Scene, path: str) -> str:
    """Return the unit of what a path leads to, "" of what has none. Raises SceneError of a wrong path."""
    return unit_of(Places(scene, [path]).field(0)[0]) or ""


def _refused(scene: Scene, path: str, scale: Scale) -> list[Fault]:
    """Return what the scene has against every value of this range, whatever the others are.

    An end alone may be refused: a fit can still end between the two.
    """
    places = Places(scene, [path])
    field, place = places.field(0)
    if field.annotation is int:
        rule = (
            "is a whole number, which a fit cannot vary by small steps; try its values by a sweep"
        )
        return [Fault(path, [scale.low, scale.high], rule)]
    found: list[Fault] = []
    for share in (0.5, 0.0, 1.0):
        try:
            places.scene([float(scale.value(share))])
        except SceneError as error:
            own = [fault for fault in error.faults if fault.path.startswith(place)]
            if not own:  # it only does not go together with the others as they are now
                return []
            found = found or own
        else:
            return []
    return found
